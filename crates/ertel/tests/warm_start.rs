//! Solutions that start from the solution of another case are those that start from the dry contact.

use crate::common::text::{LINE, read, with};
use ertel::case::{Case, Study};
use ertel::engine::NoObserver;
use ertel::output::curve_table;
use ertel::run;
use ertel::solution::{Estimate, Solution};
use ertel::study::journal::Record;
use ertel::study::plan::Plan;
use ertel::study::solve_curve;
use ertel::sweep::{SweepParams, finished_points, sweep_part};

/// A line contact under 50 kN/m.
fn roller() -> String {
    with(LINE, &[["20 kN/m", "50 kN/m"]])
}

fn case(lines: &str) -> Case {
    read(roller() + lines)
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
    let solved = solve_curve(curve, &mut NoObserver);
    assert_eq!(solved.points.len(), curve.points.len());
    for (i, (point, asked)) in solved.points.iter().zip(&curve.points).enumerate() {
        let warm = point.outcome.solution().expect("solved");
        assert_eq!(warm.stats.warm, i > 0, "point {i}");
        let cold = run::solve(&asked.case, &mut NoObserver).unwrap();
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
    let solved = solve_curve(case.curve.as_ref().unwrap(), &mut NoObserver);
    let warm = |i: usize| solved.points[i].outcome.solution().unwrap().stats.warm;
    assert!(!warm(0) && !warm(1));
}

/// Lubricant and bodies come in at another temperature in each point, which the viscosity follows.
#[test]
fn temperatures_with_heat() {
    let oil = "mu_0 = \"40 mPa.s\", beta = \"0.04 1/K\", reference_temperature = \"40 degC\"";
    let roller = roller().replace("mu_0 = \"40 mPa.s\"", oil);
    let lines = "thermal_conductivity = \"0.14 W/(m.K)\"\nheat_capacity = \"2000 J/(kg.K)\"\n\
         [thermal]\nprofiles = []\n\
         [curve]\nquantity = \"lubricant.temperature\"\nvalues = [\"40 degC\", \"50 degC\"]\n";
    agrees_in(&read(format!("{roller}{lines}")));
}

/// A curve and the study of one axis with the same values: with the same chain of starts equal to the last digit, iterations
/// included; with the tree of a study within the error bars of both.
#[test]
fn a_curve_is_the_study_of_one_axis() {
    let range = "from = \"0.5 m/s\"\nto = \"1.5 m/s\"\npoints = 4\nspacing = \"log\"\n";
    let key = "\"motion.entrainment_speed\"";
    let case = case(&format!("[curve]\nquantity = {key}\n{range}"));
    let curve = case.curve.as_ref().unwrap();
    let solved = solve_curve(curve, &mut NoObserver);
    let table = curve_table(&solved);
    let rows: Vec<Vec<&str>> = table.lines().map(|l| l.split(',').collect()).collect();
    let n_points = curve.points.len();
    assert_eq!(rows.len(), 1 + n_points);

    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("study.toml");
    let study = format!("case = \"base.toml\"\n[[axis]]\nkey = {key}\n{range}");
    std::fs::write(folder.path().join("base.toml"), roller()).unwrap();
    std::fs::write(&file, study).unwrap();
    let study = Study::read(&file).unwrap();
    let run = |plan: &Plan, name: &str| -> Vec<Record> {
        let target = folder.path().join(name);
        let params = SweepParams {
            jobs: Some(1),
            ..SweepParams::default()
        };
        let part = (plan, 0..n_points);
        sweep_part(&study, part, &target, &params, &NoObserver).unwrap();
        let finished = finished_points(&study, &target).unwrap();
        finished.into_iter().map(Option::unwrap).collect()
    };

    for (row, record) in rows[1..].iter().zip(run(&Plan::chain(n_points), "chain")) {
        let mut n_equal = 0;
        for (title, value) in rows[0].iter().zip(row) {
            if let Some(field) = record.field(title) {
                assert_eq!(field, *value, "{title}");
                n_equal += 1;
            }
        }
        assert!(n_equal > 50, "{n_equal} columns");
        assert_eq!(record.field("entrainment_speed_m_per_s").unwrap(), row[1]);
    }
    let tree = Plan::new(&study);
    assert_ne!(tree.order, Plan::chain(n_points).order);
    for (point, record) in solved.points.iter().zip(run(&tree, "tree")) {
        let number = |name: &str| -> f64 { record.field(name).unwrap().parse().unwrap() };
        let [film, _] = films(point.outcome.solution().unwrap());
        let bars = film.error.unwrap() + number("film_central_error_m");
        let off = (film.value - number("film_central_m")).abs();
        assert!(off <= bars, "{off:e} m off, bars {bars:e} m");
        assert!(bars < 0.01 * film.value);
    }
}
