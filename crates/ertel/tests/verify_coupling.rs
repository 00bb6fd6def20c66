//! Film and heat in turn: what is left of the error where their coupling stops.

mod common;

use ertel::contact::ContactKind;
use ertel::run::problem;
use ertel::solve::sequence::{Problem, StageSolution, solve_stages};
use ertel::solve::{Observer, Silent};

/// Keeps the changes of the rounds of the last coupling.
#[derive(Default)]
struct Rounds(Vec<f64>);

impl Observer for Rounds {
    fn round(&mut self, round: usize, change: f64, _: f64) {
        if round == 1 {
            self.0.clear();
        }
        self.0.push(change);
    }
}

fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
    (a.iter().zip(b)).fold(0.0, |m, (a, b)| m.max((a - b).abs()))
}

/// Against the same equations solved to a ten-thousandth of the tolerance, temperature rise, pressure and film are within the
/// tolerance; the coupling says so by c q/(1 − q) of its last changes, and goes on for no more than a round beyond.
#[test]
fn the_error_left_is_within_the_tolerance() {
    for (speed, slide) in [(0.8, 0.4), (2.0, 0.5)] {
        let mut case = common::heated(common::case(ContactKind::Line, 8e4));
        case.motion.entrainment_speed = speed;
        case.motion.slide_to_roll_ratio = slide;
        case.mesh.target_error = None;
        case.solver.error_estimate = false;
        let to = |tolerance: f64, observer: &mut dyn Observer| -> (Problem, StageSolution) {
            let mut case = case.clone();
            case.thermal.as_mut().unwrap().tolerance = tolerance;
            let problem = problem(&case);
            let (solution, _) = solve_stages(&problem, observer).expect("a solution");
            (problem, solution)
        };
        let mut rounds = Rounds::default();
        let tolerance = 1e-3;
        let (problem, found) = to(tolerance, &mut rounds);
        let (_, exact) = to(1e-7, &mut Silent);
        let inlet = problem.heat.as_ref().unwrap().heat.inlet_temperature;
        let (a, b) = (&found.state, &exact.state);
        let rise = (b.temperature.iter()).fold(0.0_f64, |m, t| m.max(t - inlet));
        let errors = [
            largest_difference(&a.temperature, &b.temperature) / rise,
            largest_difference(&a.pressure, &b.pressure),
            (a.rigid_separation - b.rigid_separation).abs(),
        ];
        println!(
            "{speed} {slide}: rise {rise:.1} K, rounds {:?}, errors {errors:?}",
            rounds.0
        );
        assert!(
            rise > 1.0 && errors.iter().all(|e| *e < tolerance),
            "{errors:?}"
        );
        let left = |last: &[f64]| {
            let q = last[1] / last[0];
            last[1].max(last[1] * q / (1.0 - q))
        };
        let mut ends = rounds.0.windows(2).map(left).rev();
        assert!(ends.next().is_some_and(|e| e < tolerance), "{:?}", rounds.0);
        assert!(ends.next().is_none_or(|e| e >= tolerance), "{:?}", rounds.0);
    }
}
