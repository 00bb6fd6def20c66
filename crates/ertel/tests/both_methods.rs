//! Finite elements and finite volumes share the contact, the fluid and what is read off a film, and nothing of how it is found: what agrees was found
//! twice.

use ertel::case::Case;
use ertel::cross_check::{Verdict, cross_check};
use ertel::params::{Formulation, Method};
use ertel::run::solve;
use ertel::solution::{Figure, Solution};
use ertel::solve::NoObserver;
use ertel_input::Document;

fn case(contact: &str, motion: &str, more: &str) -> Case {
    let text = format!(
        "lubricant = {{ temperature = \"40 degC\", density = {{ law = \"dowson-higginson\", rho_0 = \"870 kg/m^3\" }}, viscosity = {{ law = \
         \"roelands\", mu_0 = \"40 mPa.s\", alpha = \"22 1/GPa\" }} }}\n[contact]\n{contact}\n[bodies]\nbody_1 = \"steel\"\nbody_2 = \"steel\"\n\
         [motion]\n{motion}\n{more}\n"
    );
    let document = Document::parse("case.toml", text).unwrap();
    Case::from_document(&document, "".as_ref()).unwrap()
}

fn solved(case: &Case) -> Solution {
    solve(case, &mut NoObserver).unwrap()
}

const BALL: &str = "kind = \"circular\"\nradius = \"16 mm\"\nload = \"30 N\"";

/// A ball, a ball that slides across and spins, an ellipse at an angle, one across the motion: both films, their mean and the
/// friction of both engines differ by no more than the sum of their bars, which are narrower than 3 % of films.
#[test]
fn both_engines_agree() {
    let straight = "entrainment_speed = \"0.8 m/s\"\nslide_to_roll_ratio = 0.1";
    let spin = "entrainment_speed = \"0.8 m/s\"\nslide_to_roll_ratio = 0.05\nslide_to_roll_ratio_across = 0.1\nbody_2_spin = \"300 rad/s\"";
    let ellipse = |angle: f64| {
        format!(
            "kind = \"elliptical\"\nradius_x = \"10 mm\"\nradius_y = \"40 mm\"\nentrainment_angle = \"{angle} deg\"\nload = \"60 N\""
        )
    };
    let mesh = "[mesh]\ntarget_error = 0.01";
    for case in [
        case(BALL, straight, mesh),
        case(BALL, spin, mesh),
        case(&ellipse(35.0), straight, mesh),
        case(&ellipse(0.0), straight, mesh),
    ] {
        let own = solved(&case);
        let found = cross_check(&case, &own, &mut NoObserver).unwrap();
        for figure in [
            Figure::FilmCentral,
            Figure::FilmMinimum,
            Figure::FilmMean,
            Figure::FilmCentrelineMinimum,
            Figure::TractionCoefficientBody2,
            Figure::FrictionPower,
        ] {
            let crossed = found.figures.iter().find(|c| c.figure == figure);
            let crossed = crossed.unwrap_or_else(|| panic!("{figure:?}"));
            assert_eq!(crossed.verdict(), Verdict::Agrees, "{crossed:?}");
        }
        for film in [Figure::FilmCentral, Figure::FilmMinimum] {
            let crossed = found.figures.iter().find(|c| c.figure == film).unwrap();
            let (_, bars) = crossed.difference().unwrap();
            assert!(bars < 0.03 * crossed.own.value, "{crossed:?}");
        }
    }
}

/// The load group 9478 at 4.6 GPa, whose first grids have films far below zero: both films within their bars of those of the finite elements on 40,000 cubic
/// pressures (45.93 ± 0.01 and 9.33 nm), and of 2048 cells of an independent solver (45.93 and 9.36 nm by extrapolation).
#[test]
fn thin_film_of_a_heavy_load() {
    let heavy = BALL.replace("30 N", "1000 N");
    let motion = "entrainment_speed = \"0.1 m/s\"\nslide_to_roll_ratio = 0.0";
    let mut case = case(&heavy, motion, "[mesh]\nmax_unknowns = 60000");
    case.solver.method = Some(Method::FiniteVolumes);
    let solution = solved(&case);
    let central = solution.summary.film_central;
    let error = 45.93e-9 - central.value;
    assert!(error.abs() < central.error.unwrap(), "{central:?}");
    assert!(error.abs() < 0.015 * central.value, "{central:?}");
    let minimum = solution.summary.film_minimum;
    assert!(
        (9.34e-9 - minimum.value).abs() < minimum.error.unwrap(),
        "{minimum:?}"
    );
}

/// Pressures have one hill and, beyond its pass, the ridge: none of the other extrema that elements make, and none below zero.
#[test]
fn pressures_have_no_false_extremum() {
    let mut case = case(
        BALL,
        "entrainment_speed = \"0.8 m/s\"\nslide_to_roll_ratio = 0.0",
        "",
    );
    case.solver.method = Some(Method::FiniteVolumes);
    let solution = solved(&case);
    let line = &solution.centreline;
    assert!(line.pressure.iter().all(|p| *p >= 0.0));
    let turns = line.pressure.windows(3).filter(|w| {
        let rises = [w[1] - w[0], w[2] - w[1]];
        rises[0] * rises[1] < 0.0
    });
    // The hill, the pass and the ridge.
    assert_eq!(turns.count(), 3);
}

/// What finite elements do not solve within the iterations that they may take, is solved by finite volumes, and said to be; unless the method is given.
#[test]
fn what_elements_do_not_solve_is_left_to_volumes() {
    let motion = "entrainment_speed = \"0.8 m/s\"\nslide_to_roll_ratio = 0.0";
    let mut case = case(BALL, motion, "[mesh]\ntarget_error = 0.02");
    case.solver.max_iterations = 1;
    let solution = solved(&case);
    assert_eq!(solution.stats.method, Method::FiniteVolumes);
    let told = solution
        .warnings
        .iter()
        .filter(|w| w.contains("solved by finite volumes"));
    assert_eq!(told.count(), 1);
    case.solver.method = Some(Method::FiniteElements);
    assert!(solve(&case, &mut NoObserver).is_err());
    // Nor where the case asks for elements of its own.
    case.solver.method = None;
    case.solver.formulation = Formulation::Supg;
    assert!(solve(&case, &mut NoObserver).is_err());
}
