//! Implausible values: almost always the unit is wrong.

use ertel_input::tree::Value;
use ertel_input::{Document, Input, Usual, usual_of};
use ertel_quantity::Dimension;

use super::Case;
use crate::warning::{Warning, WarningKind};
use crate::words::digits;

/// Factor beyond the usual range from which a value is questioned.
const FAR: f64 = 10.0;

/// Questions about inputs of the document itself; the database and other files have separate checks.
pub(super) fn warnings(inputs: &[Input], document: &Document) -> Vec<Warning> {
    (inputs.iter().filter(|input| input.written))
        .filter_map(|input| warning(input, document))
        .collect()
}

fn warning(input: &Input, document: &Document) -> Option<Warning> {
    let row = usual_of(&input.key, input.dimension).filter(|row| row.is_questioned)?;
    let written = match document.tree().entry(&input.key).map(|e| &e.node.value) {
        Some(Value::Str(text)) => text.clone(),
        _ => shown(input.value / row.factor, row.unit),
    };
    let (excess, text) = question(row, &input.key, &written, input.value)?;
    Some(Warning::beyond(WarningKind::UnusualInput, excess, text))
}

/// Factor of a value (SI) beyond its usual range, and the question about it, if the factor is large.
fn question(row: &Usual, what: &str, written: &str, value: f64) -> Option<(f64, String)> {
    let own = value.abs() / row.factor;
    let [low, high] = row.range;
    // Zero is deliberate.
    let excess = (own / high).max(low / own);
    if own == 0.0 || excess <= FAR {
        return None;
    }
    let meant = [1e-3, 1e3, 1e-6, 1e6, 1e-9, 1e9].map(|scale| scale * own);
    let meant = (meant.into_iter()).find(|v| (low..=high).contains(v));
    let question = match meant {
        Some(meant) => format!("is {} meant?", shown(meant.copysign(value), row.unit)),
        None => "is the unit right?".to_owned(),
    };
    let text = format!(
        "{what} = {written} is far from the usual range, {} to {}: {question}",
        digits(low, 4),
        shown(high, row.unit),
    );
    Some((excess, text))
}

/// Questions about lubricant and bodies at ambient pressure, wherever they are given: in a table, in own data. Values typed in the
/// case are already in `asked`.
pub(super) fn of_data(case: &Case, asked: &[Warning]) -> Vec<Warning> {
    let is_asked = |head: &str| asked.iter().any(|w| w.text.starts_with(head));
    let mut questions = Vec::new();
    let kelvin = case.lubricant.temperature;
    let at = format!("{} degC", digits(kelvin - 273.15, 4));
    if !is_asked("lubricant.") {
        let lubricant = &case.lubricant;
        let heat_capacity = lubricant.heat_capacity.as_ref();
        let properties = [
            (
                "viscosity",
                ("mu_0", Dimension::VISCOSITY),
                Some(lubricant.ambient_viscosity()),
            ),
            (
                "density",
                ("rho_0", Dimension::DENSITY),
                Some(lubricant.ambient_density()),
            ),
            (
                "thermal conductivity",
                (
                    "lubricant.thermal_conductivity",
                    Dimension::THERMAL_CONDUCTIVITY,
                ),
                lubricant.ambient_conductivity(),
            ),
            (
                "heat capacity",
                ("heat_capacity", Dimension::SPECIFIC_HEAT),
                heat_capacity.map(|law| law.heat_capacity(0.0, kelvin)),
            ),
        ];
        questions.extend(properties.into_iter().filter_map(|(name, key, value)| {
            let what = format!("the lubricant's {name} at ambient pressure and {at}");
            question_of(&what, key, value?)
        }));
    }
    for body in [&case.body_1, &case.body_2] {
        let has_source = ertel_rheology::database::solid_names().contains(&body.name.as_str());
        if has_source || is_asked("bodies.") {
            continue;
        }
        let conductivity = body.thermal_conductivity.as_ref();
        let heat_capacity = body.heat_capacity.as_ref();
        let properties = [
            (
                "Young's modulus",
                ("youngs_modulus", Dimension::PRESSURE),
                Some(body.elasticity.youngs_modulus),
            ),
            (
                "density",
                ("body_1.density", Dimension::DENSITY),
                body.density,
            ),
            (
                "thermal conductivity",
                ("thermal_conductivity", Dimension::THERMAL_CONDUCTIVITY),
                conductivity.map(|law| law.conductivity(0.0, kelvin)),
            ),
            (
                "heat capacity",
                ("heat_capacity", Dimension::SPECIFIC_HEAT),
                heat_capacity.map(|law| law.heat_capacity(0.0, kelvin)),
            ),
        ];
        questions.extend(properties.into_iter().filter_map(|(name, key, value)| {
            question_of(&format!("{name} of {} at {at}", body.name), key, value?)
        }));
    }
    questions.dedup_by(|a, b| a.text == b.text);
    let warning = |q: Question| Warning::beyond(WarningKind::UnusualInput, q.excess, q.text);
    questions.into_iter().map(warning).collect()
}

/// A question about a value that is not typed in a case.
pub(crate) struct Question {
    /// Factor of the value beyond its usual range.
    pub excess: f64,
    /// The question.
    pub text: String,
}

/// Questions a property of a lubricant at ambient pressure (SI), named by `what`, like one typed in a case.
pub(crate) fn question_of_state(what: &str, value: f64, dimension: Dimension) -> Option<Question> {
    let key = match dimension {
        Dimension::VISCOSITY => "mu_0",
        Dimension::DENSITY => "rho_0",
        _ => return None,
    };
    question_of(what, (key, dimension), value)
}

/// Questions a value (SI) like that of a key.
fn question_of(what: &str, (key, dimension): (&str, Dimension), value: f64) -> Option<Question> {
    let row = usual_of(key, dimension).filter(|row| row.is_questioned)?;
    let written = shown(value / row.factor, row.unit);
    let (excess, text) = question(row, what, &written, value)?;
    Some(Question { excess, text })
}

fn shown(value: f64, unit: &str) -> String {
    format!("{} {unit}", digits(value, 4))
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::super::Case;
    use crate::contains::contains;
    use crate::warning::WarningKind;

    const CASE: &str = include_str!("../../../ertel-cli/tests/good/quick.toml");

    fn questions(from: &str, to: &str) -> Vec<String> {
        let text = CASE.replace(from, to);
        assert_ne!(text, CASE);
        let case = Case::from_text("case.toml", &text, Path::new("")).unwrap();
        let unusual = case
            .warnings
            .into_iter()
            .filter(|w| w.kind == WarningKind::UnusualInput);
        unusual.map(|w| w.text).collect()
    }

    /// Common errors of units: m for mm, a power of ten in addition to its prefix, Pa.s for mPa.s.
    #[test]
    fn slips_of_units_are_asked_about() {
        for (from, to, words) in [
            (
                "\"10 mm\"\nload = \"20 kN/m\"",
                "\"16 m\"\nload = \"30000 kN/m\"",
                "contact.radius = 16 m is far from the usual range, 0.5 to 1000 mm: is 16 mm meant?",
            ),
            (
                "20 1/GPa",
                "22e-9 1/GPa",
                "lubricant.viscosity.alpha = 22e-9 1/GPa is far from the usual range, 0.5 to 60 1/GPa: is 22 1/GPa meant?",
            ),
            (
                "40 mPa.s",
                "40 Pa.s",
                "lubricant.viscosity.mu_0 = 40 Pa.s is far from the usual range, 0.3 to 3000 mPa.s: is 40 mPa.s meant?",
            ),
            (
                "870 kg/m^3",
                "0.87 kg/m^3",
                "lubricant.density.rho_0 = 0.87 kg/m^3 is far from the usual range, 500 to 3000 kg/m^3: is 870 kg/m^3 meant?",
            ),
            (
                "\"1 m/s\"",
                "\"1 um/s\"",
                "motion.entrainment_speed = 1 um/s is far from the usual range, 0.0001 to 50 m/s: is 0.001 m/s meant?",
            ),
        ] {
            let questions = questions(from, to);
            let alone: Vec<&String> = questions
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
            assert_eq!(questions(from, to), Vec::<String>::new(), "{to}");
        }
    }

    /// A table in Pa.s for mPa.s is asked about as a typed value is.
    #[test]
    fn data_in_a_table_are_asked_about() {
        let folder = tempfile::tempdir().unwrap();
        let questions = |unit: &str| {
            let table = format!(
                "p [MPa];T [degC];viscosity [{unit}]\n0;20;112.052\n100;20;1203.02\n0;40;40\n100;40;309.726\n"
            );
            std::fs::write(folder.path().join("oil.csv"), table).unwrap();
            let (head, tail) = CASE.split_once("viscosity = {").unwrap();
            let (_, tail) = tail.split_once('}').unwrap();
            let text = format!("{head}viscosity = {{ law = \"table\", file = \"oil.csv\" }}{tail}");
            let case = Case::from_text("case.toml", &text, folder.path()).unwrap();
            let unusual =
                (case.warnings.into_iter()).filter(|w| w.kind == WarningKind::UnusualInput);
            unusual.map(|w| w.text).collect::<Vec<_>>()
        };
        assert_eq!(questions("mPa.s"), Vec::<String>::new());
        let [text] = &questions("Pa.s")[..] else {
            panic!()
        };
        contains(text, "viscosity at ambient pressure and 40 degC");
        contains(text, "is 40 mPa.s meant?");
    }

    /// A solid in a separate file, with its density in the wrong unit.
    #[test]
    fn own_bodies_are_asked_about() {
        let folder = tempfile::tempdir().unwrap();
        let questions = |density: &str| {
            let solid = format!(
                "title = \"Mine\"\nsource = \"me\"\nyoungs_modulus = \"210 GPa\"\npoissons_ratio = 0.3\ndensity = \"{density}\"\n"
            );
            std::fs::write(folder.path().join("mine.toml"), solid).unwrap();
            let text = CASE.replace("body_2 = \"steel\"", "body_2 = \"mine.toml\"");
            let case = Case::from_text("case.toml", &text, folder.path()).unwrap();
            let unusual =
                (case.warnings.into_iter()).filter(|w| w.kind == WarningKind::UnusualInput);
            unusual.map(|w| w.text).collect::<Vec<_>>()
        };
        assert_eq!(questions("7850 kg/m^3"), Vec::<String>::new());
        let [text] = &questions("7.85 kg/m^3")[..] else {
            panic!()
        };
        contains(text, "density of");
        contains(text, "is 7850 kg/m^3 meant?");
    }
}
