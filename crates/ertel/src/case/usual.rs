//! Values far from those of such contacts: almost always a unit was mistaken.

use ertel_rheology::input::tree::Value;
use ertel_rheology::input::{Document, Input};
use ertel_rheology::quantity::Dimension;

use crate::output::digits;
use crate::warning::{Warning, WarningKind};

/// How far beyond the usual range a value is doubted, as a factor.
const FAR: f64 = 10.0;

/// What is usual for some keys.
struct Usual {
    /// Ends of the key paths, after a dot or the start.
    keys: &'static [&'static str],
    dimension: Dimension,
    /// From, to, in the unit.
    range: [f64; 2],
    unit: &'static str,
    /// SI per unit.
    factor: f64,
}

const fn usual(
    keys: &'static [&'static str],
    dimension: Dimension,
    range: [f64; 2],
    unit: &'static str,
    factor: f64,
) -> Usual {
    Usual {
        keys,
        dimension,
        range,
        unit,
        factor,
    }
}

/// Contacts from miniature bearings to rolling mills, and the liquids and solids in them.
const USUAL: &[Usual] = &[
    usual(
        &[
            "contact.radius",
            "contact.radius_x",
            "ball_radius",
            "ball_diameter",
            "roller_diameter",
            "base_radius",
        ],
        Dimension::LENGTH,
        [0.5, 1000.0],
        "mm",
        1e-3,
    ),
    // Crowns and grooves are flat.
    usual(
        &["radius_x", "radius_y"],
        Dimension::LENGTH,
        [0.5, 50_000.0],
        "mm",
        1e-3,
    ),
    usual(
        &[
            "contact.length",
            "roller_length",
            "face_width",
            "machine.width",
            "pitch_diameter",
        ],
        Dimension::LENGTH,
        [0.5, 2000.0],
        "mm",
        1e-3,
    ),
    usual(
        &["module", "normal_module"],
        Dimension::LENGTH,
        [0.2, 50.0],
        "mm",
        1e-3,
    ),
    usual(
        &["roughness", "body_1_rms_height", "body_2_rms_height"],
        Dimension::LENGTH,
        [0.1, 10_000.0],
        "nm",
        1e-9,
    ),
    usual(
        &["entrainment_speed"],
        Dimension::SPEED,
        [1e-4, 50.0],
        "m/s",
        1.0,
    ),
    usual(
        &[
            "inner_ring_speed",
            "outer_ring_speed",
            "pinion_speed",
            "cam_speed",
        ],
        Dimension::ANGULAR_SPEED,
        [0.1, 50_000.0],
        "rpm",
        std::f64::consts::TAU / 60.0,
    ),
    usual(
        &["load", "ball_load", "roller_load", "design_load"],
        Dimension::FORCE,
        [0.01, 1e6],
        "N",
        1.0,
    ),
    usual(
        &["load"],
        Dimension::FORCE_PER_LENGTH,
        [0.1, 1e4],
        "kN/m",
        1e3,
    ),
    usual(
        &["pinion_torque"],
        Dimension::ENERGY,
        [0.01, 1e6],
        "N.m",
        1.0,
    ),
    usual(
        &["youngs_modulus"],
        Dimension::PRESSURE,
        [0.002, 1200.0],
        "GPa",
        1e9,
    ),
    usual(
        &["mu_0"],
        Dimension::VISCOSITY,
        [0.3, 3000.0],
        "mPa.s",
        1e-3,
    ),
    usual(
        &["alpha", "pressure_viscosity_coefficient"],
        Dimension::INVERSE_PRESSURE,
        [0.5, 60.0],
        "1/GPa",
        1e-9,
    ),
    usual(
        &["kinematic_viscosity_40", "kinematic_viscosity_100"],
        Dimension::KINEMATIC_VISCOSITY,
        [0.5, 5000.0],
        "mm^2/s",
        1e-6,
    ),
    usual(
        &["rho_0", "density_15", "density_20"],
        Dimension::DENSITY,
        [500.0, 3000.0],
        "kg/m^3",
        1.0,
    ),
    usual(
        &[
            "plane.density",
            "ball.density",
            "body_1.density",
            "body_2.density",
        ],
        Dimension::DENSITY,
        [800.0, 20_000.0],
        "kg/m^3",
        1.0,
    ),
    usual(
        &[
            "lubricant.thermal_conductivity",
            "lubricant.thermal_conductivity.k_0",
        ],
        Dimension::THERMAL_CONDUCTIVITY,
        [0.05, 1.0],
        "W/(m.K)",
        1.0,
    ),
    usual(
        &["thermal_conductivity", "thermal_conductivity.k_0"],
        Dimension::THERMAL_CONDUCTIVITY,
        [0.1, 2500.0],
        "W/(m.K)",
        1.0,
    ),
    usual(
        &["heat_capacity", "heat_capacity.c_0"],
        Dimension::SPECIFIC_HEAT,
        [100.0, 5000.0],
        "J/(kg.K)",
        1.0,
    ),
];

/// Questions about inputs that stand in the document itself; what the database and other files say has its own checks.
pub(super) fn warnings(inputs: &[Input], document: &Document) -> Vec<Warning> {
    (inputs.iter().filter(|input| input.written))
        .filter_map(|input| warning(input, document))
        .collect()
}

fn warning(input: &Input, document: &Document) -> Option<Warning> {
    let ends_with = |end: &&str| {
        let head = input.key.strip_suffix(*end);
        head.is_some_and(|head| head.is_empty() || head.ends_with('.'))
    };
    let mut rows = USUAL.iter().filter(|row| row.dimension == input.dimension);
    let row = rows.find(|row| row.keys.iter().any(&ends_with))?;
    let value = input.value.abs() / row.factor;
    let [low, high] = row.range;
    // Zero is said on purpose.
    let excess = (value / high).max(low / value);
    if value == 0.0 || excess <= FAR {
        return None;
    }
    let written = match document.tree().entry(&input.key).map(|e| &e.node.value) {
        Some(Value::Str(text)) => text.clone(),
        _ => shown(input.value / row.factor, row.unit),
    };
    let meant = [1e-3, 1e3, 1e-6, 1e6, 1e-9, 1e9].map(|scale| scale * value);
    let meant = (meant.into_iter()).find(|v| (low..=high).contains(v));
    let question = match meant {
        Some(meant) => format!("is {} meant?", shown(meant.copysign(input.value), row.unit)),
        None => "is the unit right?".to_owned(),
    };
    let text = format!(
        "{} = {written} is far from what is usual, {} to {}: {question}",
        input.key,
        digits(low, 4),
        shown(high, row.unit),
    );
    Some(Warning::beyond(WarningKind::UnusualInput, excess, text))
}

fn shown(value: f64, unit: &str) -> String {
    format!("{} {unit}", digits(value, 4))
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::super::Case;
    use crate::warning::WarningKind;

    const CASE: &str = include_str!("../../../ertel-cli/tests/good/quick.toml");

    fn told(from: &str, to: &str) -> Vec<String> {
        let text = CASE.replace(from, to);
        assert_ne!(text, CASE);
        let case = Case::from_text("case.toml", &text, Path::new("")).unwrap();
        let unusual = case
            .warnings
            .into_iter()
            .filter(|w| w.kind == WarningKind::UnusualInput);
        unusual.map(|w| w.text).collect()
    }

    /// Slips of units as people make them: m for mm, a power of ten beside its prefix, Pa.s for mPa.s.
    #[test]
    fn slips_of_units_are_asked_about() {
        for (from, to, words) in [
            (
                "\"10 mm\"\nload = \"20 kN/m\"",
                "\"16 m\"\nload = \"30000 kN/m\"",
                "contact.radius = 16 m is far from what is usual, 0.5 to 1000 mm: is 16 mm meant?",
            ),
            (
                "20 1/GPa",
                "22e-9 1/GPa",
                "lubricant.viscosity.alpha = 22e-9 1/GPa is far from what is usual, 0.5 to 60 1/GPa: is 22 1/GPa meant?",
            ),
            (
                "40 mPa.s",
                "40 Pa.s",
                "lubricant.viscosity.mu_0 = 40 Pa.s is far from what is usual, 0.3 to 3000 mPa.s: is 40 mPa.s meant?",
            ),
            (
                "870 kg/m^3",
                "0.87 kg/m^3",
                "lubricant.density.rho_0 = 0.87 kg/m^3 is far from what is usual, 500 to 3000 kg/m^3: is 870 kg/m^3 meant?",
            ),
            (
                "\"1 m/s\"",
                "\"1 um/s\"",
                "motion.entrainment_speed = 1 um/s is far from what is usual, 0.0001 to 50 m/s: is 0.001 m/s meant?",
            ),
        ] {
            let told = told(from, to);
            let alone: Vec<&String> = told
                .iter()
                .filter(|t| !t.starts_with("contact.load"))
                .collect();
            assert_eq!(alone, [words]);
        }
    }

    #[test]
    fn usual_and_rare_values_are_not() {
        for (from, to) in [
            ("40 mPa.s", "8 Pa.s"),
            ("40 mPa.s", "0.1 mPa.s"),
            ("20 1/GPa", "0.2 1/GPa"),
            ("\"10 mm\"", "\"0.1 mm\""),
        ] {
            assert_eq!(told(from, to), Vec::<String>::new(), "{to}");
        }
    }
}
