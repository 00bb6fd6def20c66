//! Film and heat in turn: the remaining error where their coupling stops.

use crate::common;

use crate::common::text::read;
use approx::assert_relative_eq;
use ertel::contact::ContactKind;
use ertel::engine::{NoObserver, Observer};
use ertel::reference::thermal::{ThermalReduction, thermal_loading};
use ertel::run::{problem, solve};
use ertel::solution::Role;
use ertel::solve::sequence::{Problem, StageSolution, solve_stages};

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
/// tolerance; the coupling estimates this by c q/(1 − q) of its last changes, and continues for at most one round beyond.
///
/// Theory: Film and heat together.
#[test]
fn the_remaining_error_is_within_the_tolerance() {
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
        let (_, exact) = to(1e-7, &mut NoObserver);
        let inlet = problem.heat.as_ref().unwrap().inlet_temperature;
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

/// Rolling at 30 m/s: the inlet shears hot. At the pressures of the isothermal film the first temperatures rise by 211 K, where 46 K remain in
/// the end, the next pressures change by eight p_h, and so on in turn; at a held flow film and heat settle from the isothermal film. The film
/// is reduced as the formula of Murch and Wilson has it, within a fifth, by which such formulas differ.
#[test]
fn rolling_at_high_speed_settles_from_the_isothermal_film() {
    let text = "[contact]\nkind = \"line\"\nradius = \"12.7 mm\"\nhertz_pressure = \"700 MPa\"\n\
         [bodies]\nbody_1 = \"steel\"\nbody_2 = \"steel\"\n\
         [motion]\nentrainment_speed = \"30 m/s\"\nslide_to_roll_ratio = 0\n\
         [lubricant]\ntemperature = \"40 degC\"\ndensity = { law = \"dowson-higginson\", rho_0 = \"870 kg/m^3\" }\nviscosity = { law = \"roelands\", mu_0 = \"40 mPa.s\", alpha = \"15 1/GPa\", beta = \"0.04 1/K\", reference_temperature = \"40 degC\" }\nthermal_conductivity = \"0.14 W/(m.K)\"\nheat_capacity = \"2000 J/(kg.K)\"\n\
         [mesh]\npreset = \"coarse\"\n\
         [thermal]\n";
    let case = read(text);
    let mut rounds = Rounds::default();
    let solution = solve(&case, &mut rounds).unwrap_or_else(|e| panic!("{e}"));
    let paths = solution
        .stats
        .levels
        .iter()
        .filter(|l| l.role == Role::Path);
    println!("{:?}", rounds.0);
    assert_eq!(paths.count(), 0, "continuations");
    let thermal = solution.thermal.as_ref().unwrap();
    assert!(thermal.coupling.rounds <= 18, "{}", thermal.coupling.rounds);
    let left = 1.0 - thermal.reduction.as_ref().unwrap().film_central.value;
    // L_T = μ₀βu²/k
    let loading = thermal_loading(0.04, 0.04, 30.0, 0.14);
    let formula = ThermalReduction::MurchWilson.factor(loading, 0.7 / 230.8, 0.0);
    println!("{left} {formula:?} {:?}", thermal.balance);
    assert_relative_eq!(left, formula.unwrap(), max_relative = 0.2);
    // Generated heat leaves with bodies and lubricant, also where warm lubricant flows back out of the inlet.
    assert!(thermal.balance.by_film.value > 0.1 * thermal.balance.shear.value);
    assert!(thermal.balance.error.abs() < 0.01, "{:?}", thermal.balance);
}
