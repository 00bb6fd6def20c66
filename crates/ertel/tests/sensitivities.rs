//! Derivatives by inputs: against differences of whole solves, sums that dimensions fix, and differences of finite elements.

use std::collections::BTreeMap;
use std::path::Path;

use crate::common::solved;
use crate::common::text::read;
use ertel::case::Case;
use ertel::engine::NoObserver;
use ertel::params::{Method, SensitivityDemand};
use ertel::run::solve_from;
use ertel::solution::{Figure, SensitivityMethod};

/// A circle with heat by finite volumes against differences of whole solves on grids four times as fine, all inputs at once with separate weights. The edges are given: those that follow from
/// the film would move with the inputs, and rolling friction with them.
#[test]
fn heated_circle() {
    let path = Path::new("../../cases/glycerol-thermal.toml");
    let text = std::fs::read_to_string(path).unwrap();
    let tight = text.replacen("[thermal]", "[thermal]\ntolerance = 1e-5", 1);
    let tail = "\n[mesh]\ntarget_error = 0.05\ninlet = -15.0\noutlet = 15.0\nside = 10.0\n[output]\nsensitivities = true\n[solver]\nmethod = \"finite-volumes\"\n";
    let base = read(format!("{tight}{tail}"));
    let solve = |case: &Case| solve_from(case, None, &mut NoObserver).unwrap().0;
    let solution = solve(&base);
    assert_eq!(solution.stats.method, Method::FiniteVolumes);
    let found = solution.sensitivities.as_ref().unwrap();
    assert_eq!(found.by, SensitivityMethod::LinearSolves);
    assert!(found.inputs.len() > 20, "{}", found.inputs.len());
    for figure in [
        Figure::PressureCentral,
        Figure::TractionCoefficientBody1,
        Figure::FrictionPower,
    ] {
        let is_given = found.figures.iter().any(|own| own.figure == figure);
        assert!(is_given, "{}", figure.name());
    }
    // So narrow that the minimum stays at its node.
    let step = 1e-3;
    let weight = |i: usize| 2.0 * ((i + 1) as f64 * 0.618_034).fract() - 1.0;
    let at = |step: f64| {
        let inputs = found.inputs.iter().enumerate();
        let values: BTreeMap<String, f64> = inputs
            .map(|(i, input)| (input.key.clone(), input.value * (1.0 + step * weight(i))))
            .collect();
        let mut there = base.with_values(values).unwrap();
        there.output.sensitivities = SensitivityDemand::Off;
        solve(&there)
    };
    let sides = [at(-step), at(step)];
    for figure in &found.figures {
        let [below, above] =
            (sides.each_ref()).map(|s| s.measured.figures.value(figure.figure).unwrap());
        let difference = (above - below) / (2.0 * step);
        let terms = (found.inputs.iter().zip(&figure.derivatives)).enumerate();
        let terms: Vec<f64> = terms
            .map(|(i, (input, by))| weight(i) * by * input.value)
            .collect();
        let sum: f64 = terms.iter().sum();
        let size = terms.iter().fold(0.0_f64, |m, term| m.max(term.abs()));
        let error = (sum - difference).abs() / size;
        println!("{} {sum} {difference} {error:.1e}", figure.figure.name());
        // Seen: 0.13 %, of the derivatives on grids of four times the cells.
        assert!(error < 3e-3, "{}: {error}", figure.figure.name());
    }
}

/// A circle with heat whose laws know only differences of temperatures: where bodies, lubricant and the temperatures of its laws are warmer by a kelvin, all temperatures are, and nothing else changes. By hand.
#[test]
fn heated_circle_with_warmer_laws() {
    let text = "[contact]\nkind = \"circular\"\nradius = \"10 mm\"\nload = \"20 N\"\n\
        [bodies]\nbody_1 = \"steel\"\nbody_2 = \"steel\"\n\
        [motion]\nentrainment_speed = \"1.5 m/s\"\nslide_to_roll_ratio = 0.3\n\
        [lubricant]\ntemperature = \"40 degC\"\nthermal_conductivity = \"0.14 W/(m.K)\"\nheat_capacity = \"2 kJ/(kg.K)\"\n\
        density = { law = \"dowson-higginson\", rho_0 = \"870 kg/m^3\", reference_temperature = \"40 degC\", beta = \"7e-4 1/K\" }\n\
        viscosity = { law = \"wlf\", mu_g = \"1e12 Pa.s\", t_g0 = \"-73.86 degC\", a_1 = \"188.95 K\", a_2 = \"0.719 1/GPa\", \
        b_1 = 0.2, b_2 = \"8.2 1/GPa\", c_1 = 16.09, c_2 = \"17.38 K\" }\n\
        [thermal]\n[mesh]\ntarget_error = 0.05\n[output]\nsensitivities = true\n[solver]\nmethod = \"finite-volumes\"\n";
    let (solution, _) = solve_from(&read(text), None, &mut NoObserver).unwrap();
    let found = solution.sensitivities.as_ref().unwrap();
    let keys = [
        "lubricant.temperature",
        "lubricant.viscosity.t_g0",
        "lubricant.density.reference_temperature",
    ];
    for figure in &found.figures {
        let by: Vec<f64> = (keys.iter())
            .map(|key| {
                let input = found.inputs.iter().position(|input| input.key == *key);
                figure.derivatives[input.expect("an input")]
            })
            .collect();
        let is_temperature = figure.figure.name().contains("temperature");
        let expected = if is_temperature { 1.0 } else { 0.0 };
        let largest = by.iter().fold(0.0_f64, |m, by| m.max(by.abs()));
        let error = (by.iter().sum::<f64>() - expected).abs() / largest;
        println!("{} {by:?} {error:.1e}", figure.figure.name());
        // Seen: 1.3e-3.
        assert!(error < 3e-3, "{}: {error}", figure.figure.name());
    }
}

/// Steel on steel with heat; shear in the inlet warms the oil.
const HEATED: &str = "[bodies]\nbody_1 = \"steel\"\nbody_2 = \"steel\"\n\
    [motion]\nentrainment_speed = \"3 m/s\"\nslide_to_roll_ratio = 0.3\n\
    [lubricant]\ntemperature = \"40 degC\"\nthermal_conductivity = \"0.14 W/(m.K)\"\nheat_capacity = \"2 kJ/(kg.K)\"\n\
    density = { law = \"dowson-higginson\", rho_0 = \"870 kg/m^3\", reference_temperature = \"40 degC\", beta = \"7e-4 1/K\" }\n\
    viscosity = { law = \"roelands\", mu_0 = \"40 mPa.s\", alpha = \"18 1/GPa\", beta = \"0.048 1/K\", reference_temperature = \"40 degC\" }\n\
    shear_thinning = { law = \"ree-eyring\", tau_0 = \"6 MPa\" }\n[thermal]\n[output]\nsensitivities = true\n";

/// That all inputs but a temperature without effect have derivatives, and figures these logarithmic ones by some inputs, within a distance.
fn has_exponents(text: &str, expected: &[(Figure, &str, f64, f64)]) {
    let solution = solve_from(&read(text), None, &mut NoObserver).unwrap().0;
    let found = solution.sensitivities.as_ref().unwrap();
    assert_eq!(found.by, SensitivityMethod::LinearSolves);
    let left_out = found
        .left_out
        .iter()
        .filter(|input| input.key != "lubricant.temperature");
    assert_eq!(left_out.count(), 0, "{:#?}", found.left_out);
    for (figure, key, expected, within) in expected {
        let of = found.figures.iter().find(|own| own.figure == *figure);
        let exponents = found.logarithmic(of.unwrap());
        let exponent = exponents.iter().find(|(own, _)| own == key).unwrap().1;
        println!("{} {key} {exponent} {expected}", figure.name());
        assert!(
            (exponent - expected).abs() < *within,
            "{} {key}: {exponent}, not {expected}",
            figure.name()
        );
    }
}

/// A ball in its groove, whose first grid ends with the contact area: that of a problem with more film is larger. Against differences of whole solves with inputs 1 % below and above.
#[test]
fn ball_in_its_groove() {
    let text = include_str!("../../../cases/ball-in-groove.toml");
    let expected = [
        (
            Figure::FilmCentral,
            "lubricant.viscosity.alpha",
            0.719,
            0.01,
        ),
        (
            Figure::FilmMinimum,
            "lubricant.viscosity.alpha",
            0.740,
            0.02,
        ),
        (Figure::FilmCentral, "motion.entrainment_speed", 0.712, 0.01),
        (Figure::FilmMinimum, "motion.entrainment_speed", 0.709, 0.02),
        (
            Figure::PressureCentral,
            "motion.entrainment_speed",
            -0.0078,
            0.002,
        ),
    ];
    has_exponents(
        &format!("{text}\n[mesh]\ntarget_error = 0.01\n[output]\nsensitivities = true\n"),
        &expected,
    );
}

/// A line with heat, whose inlet has layers that flow back, against differences of solves by finite elements with inputs 1 % below and above, under the same edges.
#[test]
fn heated_line() {
    let text = format!(
        "[contact]\nkind = \"line\"\nradius = \"10 mm\"\nload = \"100 kN/m\"\n{HEATED}[mesh]\ntarget_error = 0.01\n[solver]\nmethod = \"finite-volumes\"\n"
    );
    let expected = [
        (
            Figure::FilmCentral,
            "motion.entrainment_speed",
            0.6263,
            0.004,
        ),
        (Figure::FilmCentral, "contact.load", -0.1307, 0.001),
        (
            Figure::TractionCoefficient,
            "motion.slide_to_roll_ratio",
            0.1403,
            0.001,
        ),
        (Figure::TractionCoefficient, "contact.load", 0.565, 0.002),
        (Figure::FrictionPower, "contact.load", 1.1592, 0.004),
    ];
    has_exponents(&text, &expected);
}

/// A roller with heat whose contact ends before its ends: there temperatures do not converge on coarse grids. Against differences of whole solves with inputs 1 % below and above.
#[test]
fn heated_roller() {
    let text = format!(
        "[contact]\nkind = \"roller\"\nradius = \"10 mm\"\nload = \"1200 N\"\nlength = \"12 mm\"\n\
         profile = {{ kind = \"crown\", crown_radius = \"300 mm\" }}\n{HEATED}[mesh]\ntarget_error = 0.03\n"
    );
    let expected = [
        (
            Figure::FilmCentral,
            "motion.entrainment_speed",
            0.6437,
            0.01,
        ),
        (Figure::FilmCentral, "contact.load", -0.0944, 0.005),
        (
            Figure::FrictionPower,
            "motion.entrainment_speed",
            0.8014,
            0.02,
        ),
        (Figure::FrictionPower, "contact.load", 0.9597, 0.01),
        (
            Figure::FilmTemperatureMaximum,
            "motion.entrainment_speed",
            0.089,
            0.001,
        ),
        (
            Figure::FilmTemperatureMaximum,
            "contact.load",
            0.0305,
            0.001,
        ),
    ];
    has_exponents(&text, &expected);
}

const NEWTONIAN: &str = concat!(
    "[bodies]\nbody_1 = \"steel\"\nbody_2 = { youngs_modulus = \"400 GPa\", poissons_ratio = 0.25 }\n",
    "[motion]\nentrainment_speed = \"0.8 m/s\"\nslide_to_roll_ratio = 0.1\n",
    "[lubricant]\ntemperature = \"60 degC\"\ndensity = { law = \"dowson-higginson\", rho_0 = \"870 kg/m^3\" }\nviscosity = { law = \"roelands\", mu_0 = \"40 mPa.s\", alpha = \"18 1/GPa\" }\n",
);

/// Sums that dimensions fix. A contact twice as large, its load four times and its speed twice as large, has a film twice as thick, and the
/// same pressures and traction; one of twice the modulus, load and viscosity and half the pressure-viscosity coefficient has twice the
/// pressures, and all else the same. By hand, for any shape.
fn scales_with_size_and_stress(
    text: &str,
    by: SensitivityMethod,
    lengths: &[&str],
    tolerance: f64,
) {
    let solution = solved(&read(format!("{text}\n[output]\nsensitivities = true\n")));
    let sensitivities = solution.sensitivities.as_ref().unwrap();
    assert_eq!(sensitivities.by, by);
    for figure in &sensitivities.figures {
        let found = sensitivities.logarithmic(figure);
        let by = |key: &str| {
            let found = found.iter().find(|(k, _)| *k == key);
            found.unwrap_or_else(|| panic!("no {key}")).1
        };
        let is_film = matches!(figure.figure, Figure::FilmCentral | Figure::FilmMinimum);
        let size = lengths.iter().map(|key| by(key)).sum::<f64>()
            + 2.0 * by("contact.load")
            + by("motion.entrainment_speed");
        let largest = found.iter().fold(0.0_f64, |m, (_, by)| m.max(by.abs()));
        let expected = if is_film { 1.0 } else { 0.0 };
        println!("{} {size} {expected}", figure.figure.name());
        assert!((size - expected).abs() < tolerance * largest, "{size}");
        let stress = by("bodies.body_1.youngs_modulus")
            + by("bodies.body_2.youngs_modulus")
            + by("contact.load")
            + by("lubricant.viscosity.mu_0")
            - by("lubricant.viscosity.alpha");
        let expected = if figure.figure == Figure::PressureCentral {
            1.0
        } else {
            0.0
        };
        println!("{} {stress} {expected}", figure.figure.name());
        assert!((stress - expected).abs() < tolerance * largest, "{stress}");
    }
}

/// Roelands' law contains a pressure constant; Barus' has none. No compressibility.
fn scalable() -> String {
    (NEWTONIAN.replace("law = \"roelands\"", "law = \"barus\""))
        .replace(
            "law = \"dowson-higginson\", rho_0 = \"870 kg/m^3\"",
            "law = \"constant\", rho_0 = \"870 kg/m^3\"",
        )
        .replace("18 1/GPa", "12 1/GPa")
}

/// By linear solves, good to a few per cent of the largest.
#[test]
fn ellipses_and_rollers_scale() {
    let ellipse = "[contact]\nkind = \"elliptical\"\nradius_x = \"16 mm\"\nradius_y = \"40 mm\"\nload = \"100 N\"\n";
    let roller = "[contact]\nkind = \"roller\"\nradius = \"10 mm\"\nload = \"200 N\"\nlength = \"2 mm\"\n\
                  profile = { kind = \"crown\", crown_radius = \"300 mm\" }\n";
    let lengths_of_roller = [
        "contact.radius",
        "contact.length",
        "contact.profile.crown_radius",
    ];
    for (contact, lengths) in [
        (ellipse, &["contact.radius_x", "contact.radius_y"][..]),
        (roller, &lengths_of_roller[..]),
    ] {
        let text = format!("{contact}{}", scalable());
        scales_with_size_and_stress(&text, SensitivityMethod::LinearSolves, lengths, 0.03);
    }
}

/// By differences of solves on the mesh of the solution, over steps of 1 %.
#[test]
fn lines_of_elements_scale() {
    let contact = "[contact]\nkind = \"line\"\nradius = \"16 mm\"\nload = \"60 kN/m\"\n";
    let own = "[solver]\nmethod = \"finite-elements\"\n";
    let text = format!("{contact}{}{own}", scalable());
    let by = SensitivityMethod::Differences;
    scales_of_line(&text, by, 3e-3);
}

/// By linear solves, with shear thinning: friction depends on small changes of steep pressures.
#[test]
fn lines_of_volumes_scale() {
    let contact = "[contact]\nkind = \"line\"\nradius = \"16 mm\"\nload = \"100 kN/m\"\n";
    let thinning = "shear_thinning = { law = \"ree-eyring\", tau_0 = \"5 MPa\" }\n";
    let text = format!("{contact}{}{thinning}", scalable());
    scales_of_line(&text, SensitivityMethod::LinearSolves, 3e-4);
}

/// As [`scales_with_size_and_stress`], of a line, whose load per length grows with its size.
fn scales_of_line(text: &str, by: SensitivityMethod, tolerance: f64) {
    let solution = solved(&read(format!("{text}\n[output]\nsensitivities = true\n")));
    let sensitivities = solution.sensitivities.as_ref().unwrap();
    assert_eq!(sensitivities.by, by);
    for figure in &sensitivities.figures {
        let found = sensitivities.logarithmic(figure);
        let of = |key: &str| found.iter().find(|(k, _)| *k == key).unwrap().1;
        let size = of("contact.radius") + of("contact.load") + of("motion.entrainment_speed");
        let is_film = matches!(figure.figure, Figure::FilmCentral | Figure::FilmMinimum);
        let is_coefficient = figure.figure == Figure::TractionCoefficient;
        println!("{} {size}", figure.figure.name());
        if is_film || is_coefficient {
            let largest = found.iter().fold(0.0_f64, |m, (_, by)| m.max(by.abs()));
            let expected = if is_film { 1.0 } else { 0.0 };
            assert!((size - expected).abs() < tolerance * largest, "{size}");
        }
    }
}
