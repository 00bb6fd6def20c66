//! Solutions that start from the solution of another case are those that start from the dry contact.

use std::path::Path;

use ertel::case::Case;
use ertel::run::Session;
use ertel::solution::{Estimate, Solution};
use ertel::solve::Silent;
use ertel::study::solve_curve;
use ertel_rheology::input::Document;

const ROLLER: &str = r#"
[contact]
kind = "line"
radius = "10 mm"
load = "50 kN/m"
[bodies]
plane = "steel"
ball = "steel"
[motion]
entrainment_speed = "1 m/s"
slide_to_roll_ratio = 0.0
[lubricant]
temperature = "40 degC"
density = { law = "dowson-higginson", rho_0 = "870 kg/m^3" }
viscosity = { law = "roelands", mu_0 = "40 mPa.s", alpha = "20 1/GPa" }
"#;

fn case(lines: &str) -> Case {
    let document = Document::parse("roller.toml", format!("{ROLLER}{lines}")).unwrap();
    Case::from_document(&document, Path::new("")).unwrap()
}

fn films(solution: &Solution) -> [Estimate; 2] {
    [solution.summary.film_central, solution.summary.film_minimum]
}

/// Each point of a curve against the same case from the dry contact, on another mesh: the difference lies
/// within both error bars. All but the first are warm.
fn agrees(lines: &str) {
    agrees_in(&case(lines));
}

fn agrees_in(case: &Case) {
    let curve = case.curve.as_ref().unwrap();
    let session = Session::default();
    let solved = solve_curve(&session, curve, &mut Silent);
    assert_eq!(solved.points.len(), curve.points.len());
    for (i, (point, asked)) in solved.points.iter().zip(&curve.points).enumerate() {
        let warm = point.outcome.solution().expect("solved");
        assert_eq!(warm.stats.warm, i > 0, "point {i}");
        let cold = session.solve(&asked.case, &mut Silent).unwrap();
        assert!(!cold.stats.warm);
        for (w, c) in films(warm).iter().zip(films(&cold)) {
            let bars = w.error.unwrap() + c.error.unwrap();
            let off = (w.value - c.value).abs();
            assert!(off <= bars, "point {i}: {off:e} m off, bars {bars:e} m");
            // Bars that say nothing would agree with anything.
            assert!(bars < 0.01 * c.value);
        }
    }
}

#[test]
fn speeds_on_a_refined_mesh() {
    agrees(
        "[curve]\nquantity = \"motion.entrainment_speed\"\nfrom = \"0.3 m/s\"\nto = \"2 m/s\"\npoints = 4\nspacing = \"log\"",
    );
}

#[test]
fn falling_loads_on_a_laid_mesh() {
    agrees(
        "[mesh]\npreset = \"normal\"\n[curve]\nquantity = \"contact.load\"\nvalues = [\"80 kN/m\", \"60 kN/m\", \"40 kN/m\"]",
    );
}

#[test]
fn temperatures() {
    // The lubricant's laws are the same at any temperature: the solution is, too, and Newton's method at its end.
    agrees("[curve]\nquantity = \"lubricant.temperature\"\nvalues = [\"40 degC\", \"60 degC\"]");
}

#[test]
fn a_start_too_far_away_is_not_taken() {
    let case = case(
        "[mesh]\npreset = \"coarse\"\n[curve]\nquantity = \"motion.entrainment_speed\"\nvalues = [\"0.01 m/s\", \"1 m/s\"]",
    );
    let solved = solve_curve(
        &Session::default(),
        case.curve.as_ref().unwrap(),
        &mut Silent,
    );
    let warm = |i: usize| solved.points[i].outcome.solution().unwrap().stats.warm;
    assert!(!warm(0) && !warm(1));
}

/// Lubricant and bodies come in at another temperature in each point, which the viscosity follows.
#[test]
fn temperatures_with_heat() {
    let oil = "mu_0 = \"40 mPa.s\", beta = \"0.04 1/K\", reference_temperature = \"40 degC\"";
    let roller = ROLLER.replace("mu_0 = \"40 mPa.s\"", oil);
    let lines = "thermal_conductivity = \"0.14 W/(m.K)\"\nheat_capacity = \"2000 J/(kg.K)\"\n\
         [thermal]\nprofiles = []\n\
         [curve]\nquantity = \"lubricant.temperature\"\nvalues = [\"40 degC\", \"50 degC\"]\n";
    let document = Document::parse("roller.toml", format!("{roller}{lines}")).unwrap();
    agrees_in(&Case::from_document(&document, Path::new("")).unwrap());
}
