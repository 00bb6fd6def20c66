//! Warnings of converged results that are physically impossible; names of figures that the mesh does not resolve.

use std::sync::LazyLock;

use crate::common;
use crate::common::text::{LINE, read, with};

use crate::common::contains;
use ertel::solution::{Figure, Solution, Why};
use ertel::warning::WarningKind;

/// A Newtonian isothermal roller that slides.
static ROLLER: LazyLock<String> = LazyLock::new(|| {
    with(
        LINE,
        &[
            ["20 kN/m", "100 kN/m"],
            ["1 m/s", "2 m/s"],
            ["slide_to_roll_ratio = 0.0", "slide_to_roll_ratio = 0.05"],
            ["20 1/GPa", "22 1/GPa"],
        ],
    )
});

/// Its solution.
static SOLVED: LazyLock<Solution> = LazyLock::new(|| solved(&ROLLER));

const EYRING: &str = r#"shear_thinning = { law = "ree-eyring", tau_0 = "5 MPa" }"#;

fn solved(text: &str) -> Solution {
    common::solved(&read(text))
}

fn warning(solution: &Solution, kind: WarningKind) -> Option<&str> {
    let mut found = solution.warnings.iter().filter(|w| w.kind == kind);
    let first = found.next().map(|w| w.text.as_str());
    assert!(found.next().is_none());
    first
}

/// A Newtonian isothermal roller slides with a traction coefficient of 0.18, which no lubricant transmits; in pure rolling its stress at the
/// spike, which no grid resolves, is beyond all bounds, but not the rolling friction; Eyring's stress is not.
#[test]
fn friction_that_no_lubricant_transmits() {
    let newtonian = &*SOLVED;
    assert!(newtonian.traction.coefficient.value > 0.15);
    let words = warning(newtonian, WarningKind::Friction).unwrap();
    let coefficient = format!(
        "traction coefficient of {:.3}",
        newtonian.traction.coefficient.value
    );
    for missing in [
        coefficient.as_str(),
        "shear_thinning)",
        "[thermal]",
        "limit)",
    ] {
        assert!(words.contains(missing), "{words}");
    }
    let rolling = solved(&ROLLER.replace("0.05", "0.0"));
    let words = warning(&rolling, WarningKind::RollingStress).unwrap();
    assert!(words.contains("a shear stress of"), "{words}");
    assert_eq!(warning(&rolling, WarningKind::Friction), None);
    let thinning = solved(&format!("{}{EYRING}", *ROLLER));
    assert!(thinning.traction.coefficient.value < 0.08);
    assert_eq!(warning(&thinning, WarningKind::Friction), None);
}

/// An Eyring stress of 60 MPa is no law of an oil. Effects that the case includes are not named as neglected.
#[test]
fn a_law_without_limit_is_named() {
    let eyring = EYRING.replace("5 MPa", "60 MPa");
    let sliding = ROLLER.replace("0.05", "1.5");
    let found = solved(&format!("{sliding}{eyring}"));
    let words = warning(&found, WarningKind::Friction).unwrap();
    contains(words, "[thermal]");
    contains(words, "limit)");
    assert!(!words.contains("[lubricant] shear_thinning)"), "{words}");
}

/// Constant viscosity and 10 kN/m: Martin's film between rigid bodies, 4.9 μu R/w, is 0.1 % of the radius at 2 m/s, a tenth at
/// 200 m/s.
#[test]
fn films_that_are_not_small() {
    let film = |speed: &str| {
        let constant = r#"{ law = "constant", mu_0 = "1 Pa.s" }"#;
        let law = r#"{ law = "roelands", mu_0 = "40 mPa.s", alpha = "22 1/GPa" }"#;
        let text = ROLLER.replace("100 kN/m", "10 kN/m").replace("0.05", "0.0");
        solved(&text.replace("2 m/s", speed).replace(law, constant))
    };
    assert_eq!(warning(&film("2 m/s"), WarningKind::ThickFilm), None);
    let thick = film("200 m/s");
    let words = warning(&thick, WarningKind::ThickFilm).unwrap();
    contains(words, "of the radius, too thick for Reynolds' equation");
}

/// Slip through an oil whose viscosity grows without limit up to 1.1 GPa: friction above that of dry metal marks all figures derived from it; films stay valid.
#[test]
fn friction_beyond_physics_is_not_resolved() {
    let found = solved(
        &ROLLER
            .replace("100 kN/m", "600 kN/m")
            .replace("\"roelands\"", "\"barus\""),
    );
    let why: Vec<_> = found.unresolved.iter().map(|u| (u.figure, u.why)).collect();
    assert_eq!(why, [(Figure::TractionCoefficient, Why::BeyondPhysics)]);
    for figure in [
        Figure::TractionForce,
        Figure::TractionCoefficientBody1,
        Figure::FrictionPower,
        Figure::ShearStressMaximum,
    ] {
        assert!(!found.resolves(figure), "{figure:?}");
    }
    assert!(found.resolves(Figure::FilmMinimum) && found.resolves(Figure::PressureCentral));
    assert!(warning(&found, WarningKind::Friction).is_some());
}

/// An inlet edge at 1.2 half-widths starves the contact: its effect on the films exceeds any bar.
#[test]
fn unresolved_figures_are_named() {
    assert!(SOLVED.unresolved.is_empty());
    let starved = solved(&format!("{}[mesh]\ninlet = -1.2\n", *ROLLER));
    let figures: Vec<Figure> = starved.unresolved.iter().map(|u| u.figure).collect();
    assert!(figures.contains(&Figure::FilmCentral) && figures.contains(&Figure::FilmMinimum));
    assert!(warning(&starved, WarningKind::InletEdge).is_some());
    let words = warning(&starved, WarningKind::CentralFilmError).unwrap();
    contains(words, "the edges of the contact area are near");
}

/// Surfaces at 0 and 60 m/s, with skins of 60 µm that form within a cell at the far inlet edge, and at 2 m/s: heat is balanced, and nothing is reported.
#[test]
fn heat_balances_close() {
    let hot = |speed, ratio| {
        solved(&format!(
            "[contact]\nkind = \"line\"\nradius = \"20 mm\"\nhertz_pressure = \"400 MPa\"\n\
         [bodies]\nbody_1 = \"sapphire\"\nbody_2 = \"steel\"\n\
         [motion]\nentrainment_speed = \"{speed} m/s\"\nslide_to_roll_ratio = {ratio}\n\
         [lubricant]\ntemperature = \"40 degC\"\ndensity = {{ law = \"dowson-higginson\", rho_0 = \"870 kg/m^3\" }}\nviscosity = {{ law = \"roelands\", mu_0 = \"40 mPa.s\", alpha = \"20 1/GPa\", beta = \"0.04 1/K\", reference_temperature = \"40 degC\" }}\nthermal_conductivity = \"0.14 W/(m.K)\"\nheat_capacity = \"2000 J/(kg.K)\"\nshear_thinning = {{ law = \"carreau-yasuda\", g = \"5 MPa\", n = 0.45, a = 5.0, mu_2 = \"0 Pa.s\" }}\n\
         [thermal]\n"
        ))
    };
    // It was open by 2.2 % where the oil entered with a jump at the walls.
    let fast = hot(30.0, 2.0);
    assert!(fast.thermal.as_ref().unwrap().balance.error.abs() < 0.02);
    assert_eq!(warning(&fast, WarningKind::HeatBalance), None);
    let slow = hot(2.0, 0.1);
    assert!(slow.thermal.as_ref().unwrap().balance.error.abs() < 0.01);
    assert_eq!(warning(&slow, WarningKind::HeatBalance), None);
}

/// An oil of ISO VG 220 that slides fast: the estimated law thins its film by about 9 %, and says so with both films; a measured law and a thinner oil at less
/// speed do not.
#[test]
fn films_thinned_by_an_estimated_law_are_reported() {
    let oil = |vg: usize, speed: &str, law: &str| {
        let (head, _) = ROLLER.split_once("density").unwrap();
        let text =
            format!("{head}iso_vg = {vg}\n base_oil = \"mineral\"\n shear_thinning = {law}\n");
        let text = text.replace("100 kN/m", "300 kN/m").replace("2 m/s", speed);
        let text = text.replace("40 degC", "60 degC").replace("0.05", "0.4");
        solved(&format!("{text}[output]\n sensitivities = false\n"))
    };
    let thick = oil(220, "8 m/s", "{ law = \"estimate\" }");
    let reduction = thick.film_reduction.unwrap().central.value;
    assert!(reduction > 0.05, "{reduction}");
    let words = warning(&thick, WarningKind::EstimatedThinning).unwrap();
    let without = thick.summary.film_central.value / (1.0 - reduction);
    let films = format!("{:.2}", 1e6 * without);
    assert!(
        words.contains("central film") && words.contains("% thinner: ") && words.contains(&films),
        "{words} {films}"
    );
    let given = oil(220, "8 m/s", "{ law = \"ree-eyring\", tau_0 = \"5 MPa\" }");
    assert_eq!(warning(&given, WarningKind::EstimatedThinning), None);
    let thin = oil(46, "1 m/s", "{ law = \"estimate\" }");
    assert_eq!(warning(&thin, WarningKind::EstimatedThinning), None);
}
