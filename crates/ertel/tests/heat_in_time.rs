//! Heat in time: a steady contact stays steady, and a changed one approaches the steady contact of the new conditions.

use crate::common::text::read;
use ertel::engine::{NoObserver, Observer};
use ertel::output::transient::{profiles_table, transient_table};
use ertel::run::checkpoint::Checkpoint;
use ertel::run::solve;
use ertel::run::transient::{self, InstantObserver, InstantSolution, Reached, TransientSolution};
use ertel::solution::Figure;

/// A ball on glass, both of whose surfaces slide, by a coarse mesh.
const CASE: &str = concat!(
    include_str!("common/cases/squalane.toml"),
    "[thermal]\n[solver]\nnewtonian = true\n[mesh]\ntarget_error = \"10 %\"\nmax_unknowns = 3000\n",
    "[output]\nsensitivities = false\n"
);

fn solved(more: &str) -> TransientSolution {
    let case = read(format!("{CASE}{more}"));
    let found = transient::solve(&case, &mut NoObserver);
    assert!(found.failure.is_none(), "{:?}", found.failure);
    found
}

const FIGURES: [Figure; 7] = [
    Figure::FilmCentral,
    Figure::FilmMinimum,
    Figure::TractionCoefficient,
    Figure::HeatToBody1,
    Figure::HeatToBody2,
    Figure::TemperatureBody1Mean,
    Figure::TemperatureBody2Mean,
];

fn figures(instant: &InstantSolution) -> [f64; FIGURES.len()] {
    FIGURES.map(|figure| {
        let value = instant.measured.estimate(figure).value;
        match figure {
            // Rises over the inlet.
            Figure::TemperatureBody1Mean | Figure::TemperatureBody2Mean => value - 313.0,
            _ => value,
        }
    })
}

/// Figures agree to a share; what flows into a body to twice that of what flows into both: into the glass flows the remainder of much more, some of which it gives back behind the contact, and that of
/// a coarse grid differs between the sum in space and that over time.
fn assert_alike(found: &[f64; FIGURES.len()], expected: &[f64; FIGURES.len()], most: f64) {
    let into_both = expected[3] + expected[4];
    for (figure, (found, expected)) in FIGURES.iter().zip(found.iter().zip(expected)) {
        let size = match figure {
            Figure::HeatToBody1 | Figure::HeatToBody2 => 2.0 * into_both,
            _ => expected.abs(),
        };
        let name = figure.name();
        assert!(
            (found - expected).abs() < most * size,
            "{name}: {found} {expected}"
        );
    }
}

/// Under the conditions of the start nothing changes: the film equation and the energy of the film are those of the steady contact, and what the bodies remember is the
/// steady rise, but for heat that spreads beyond the grid. A contact that has slowed down approaches one that starts at the lower speed.
#[test]
fn steady_contacts_stay_and_changes_come_to_them() {
    let change = "[transient]\nduration = \"0.45 ms\"\ntolerance = 0.05\noutput_times = [\"0.05 ms\", \"0.45 ms\"]\nentrainment_speed = { course = \"step\", at = \"0.05 ms\", to = \"1.3 m/s\" }\n";
    let found = solved(change);
    let start = figures(&found.instants[0]);
    let before = found.instants.iter().rfind(|i| i.time < 0.0499e-3);
    let before = figures(before.unwrap());
    assert_alike(&before, &start, 1e-3);
    let end = figures(found.instants.last().unwrap());
    let slow = CASE.replace("1.47 m/s", "1.3 m/s");
    let steady = read(format!("{slow}[transient]\nduration = \"1 ns\"\n"));
    let steady = figures(&transient::solve(&steady, &mut NoObserver).instants[0]);
    // Heat of the start has not all left the glass yet.
    assert_alike(&end, &steady, 8e-3);
}

/// A sliding line contact with a layer of oil, which is followed by a thinner one while oil and bodies warm by 10 K, approaches the steady contact with that layer at their temperature: by finite
/// elements, which share no code of the heat in time. Films to 0.1 %, rises to 0.3 %, friction and its heat to 0.2 %.
#[test]
fn a_thinner_layer_heats_the_line_to_its_steady_temperatures() {
    let case = |layer: &str, temperature: f64, more: &str| {
        read(format!(
            "lubricant = {{ base_oil = \"mineral\", temperature = \"{temperature} K\", density = {{ law = \"dowson-higginson\", rho_0 = \"870 kg/m^3\" }}, viscosity = {{ law = \"roelands\", mu_0 = \"40 mPa.s\", alpha = \"18 1/GPa\", beta = \"0.04 1/K\", reference_temperature = \"313.15 K\" }} }}\n\
         [contact]\nkind = \"line\"\nradius = \"15 mm\"\nload = \"150 kN/m\"\n\
         [bodies]\nbody_1 = \"steel\"\nbody_2 = \"steel\"\n\
         [motion]\nentrainment_speed = \"4 m/s\"\nslide_to_roll_ratio = 0.5\n\
         [inlet]\noil_layer = \"{layer}\"\n\
         [thermal]\n\
         [output]\nsensitivities = false\n{more}\n"
        ))
    };
    let change = "[mesh]\ntarget_error = 0.1\n[transient]\nduration = \"3 ms\"\ntolerance = 0.05\n\
                  oil_layer = { course = \"step\", at = \"0.05 ms\", to = \"400 nm\" }\n\
                  temperature = { course = \"ramp\", start = \"0.05 ms\", end = \"0.15 ms\", to = \"323.15 K\" }\n";
    let found = transient::solve(&case("600 nm", 313.15, change), &mut NoObserver);
    assert!(found.failure.is_none(), "{:?}", found.failure);
    let elements = "[mesh]\ntarget_error = 0.01\n[solver]\nmethod = \"finite-elements\"\n";
    let steady = solve(&case("400 nm", 323.15, elements), &mut NoObserver).unwrap();
    let [start, end] = [found.instants.first(), found.instants.last()].map(Option::unwrap);
    // Rises are those over the oil that comes in.
    let warm = |over: f64| if over > 0.0 { over + 10.0 } else { 0.0 };
    for (figure, over, most) in [
        (Figure::FilmCentral, 0.0, 1e-3),
        (Figure::FilmMinimum, 0.0, 1e-3),
        (Figure::TractionCoefficient, 0.0, 2e-3),
        (Figure::HeatShear, 0.0, 2e-3),
        (Figure::FilmTemperatureMaximum, 313.15, 3e-3),
        // Behind the contact elements and volumes find the streams of oil on their own meshes.
        (Figure::FilmTemperatureMean, 313.15, 5e-3),
        (Figure::TemperatureBody1Mean, 313.15, 5e-3),
        (Figure::TemperatureBody2Mean, 313.15, 5e-3),
    ] {
        let [start, end] = [(start, over), (end, warm(over))]
            .map(|(i, over)| i.measured.estimate(figure).value - over);
        let expected = steady.figure(figure).unwrap().value - warm(over);
        let error = (end / expected - 1.0).abs();
        assert!(error < most, "{}: {end} {expected}", figure.name());
        // It was another contact at the start; friction, which a thinner film makes larger and a warmer one smaller, stays about the same.
        let is_film = matches!(figure, Figure::FilmCentral | Figure::FilmMinimum);
        assert!(!is_film || (start / expected - 1.0).abs() > 0.04, "{start}");
    }
}

/// Stops a run after a number of reported instants, and keeps its checkpoint.
struct Stopping {
    most: usize,
    reported: usize,
    checkpoint: Option<Vec<u8>>,
}

impl Observer for Stopping {
    fn cancelled(&self) -> bool {
        self.reported >= self.most
    }
}

impl InstantObserver for Stopping {
    fn instant(&mut self, _: &Reached) {
        self.reported += 1;
    }

    fn checkpoint(&mut self, checkpoint: Checkpoint) {
        self.checkpoint = Some(checkpoint.to_bytes());
    }
}

/// A run with heat that stopped while its speed falls resumes from the bytes of its checkpoint and gives the tables of the run without a stop, to the digit: the thermal history of film and bodies is a
/// part of them. It stops where three instants count.
#[test]
fn a_run_with_heat_that_stopped_goes_on_to_the_digit() {
    let case = read(format!(
        "{CASE}[transient]\nduration = \"20 us\"\ntolerance = 0.05\noutput_times = [\"20 us\"]\n\
         entrainment_speed = {{ course = \"ramp\", start = \"0 us\", end = \"100 us\", to = \"1.1 m/s\" }}\n"
    ));
    let tables = |found: &TransientSolution| [transient_table(found, false), profiles_table(found)];
    let whole = transient::solve(&case, &mut NoObserver);
    let n = whole.instants.len();
    let most = n / 2;
    assert!(most > 2, "{n}");
    let mut first = Stopping {
        most,
        reported: 0,
        checkpoint: None,
    };
    assert!(transient::solve(&case, &mut first).failure.is_some());
    let from = Checkpoint::from_bytes(&first.checkpoint.unwrap(), &case).unwrap();
    let rest = transient::solve_from(&case, Some(from), &mut NoObserver);
    assert!(rest.failure.is_none(), "{:?}", rest.failure);
    assert_eq!(tables(&rest), tables(&whole));
    assert_eq!(rest.info, whole.info);
}
