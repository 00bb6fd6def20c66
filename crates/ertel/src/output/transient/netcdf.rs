//! `result.nc` of a transient case: figures at all instants, fields at the output times.

use super::super::netcdf::classic::{Attribute, Dataset, Values, Variable};
use super::super::netcdf::text;
use super::conditions::CONDITIONS;
use super::table::{AMPLITUDE_RATIO, figures};
use crate::case::CaseEcho;
use crate::run::transient::{InstantSolution, TransientSolution};
use crate::solution::Field;

/// The file. Dimensions: `time`, all instants, with conditions, figures and their error bars; `output_time`, `y` (not for line contacts) and `x` with the fields.
pub fn transient_netcdf(case: &CaseEcho, found: &TransientSolution) -> Vec<u8> {
    let is_line = case.contact.kind.is_line();
    let fields = &found.fields;
    let mut data = Dataset {
        dimensions: vec![
            ("time", found.instants.len()),
            ("output_time", fields.times.len()),
        ],
        attributes: vec![
            ("title", text(&case.title)),
            ("kind", text(case.contact.kind.name())),
            (
                "source",
                text(&format!("ertel {}", env!("CARGO_PKG_VERSION"))),
            ),
        ],
        variables: Vec::new(),
    };
    let mut add = |name: &str, dimensions: &[usize], unit: &str, words: &str, values| {
        let unit = if unit.is_empty() { "1" } else { unit };
        let attributes = vec![
            ("units", text(unit)),
            ("long_name", text(words)),
            ("_FillValue", fill(&values)),
        ];
        data.variables.push(Variable {
            name: name.to_owned(),
            dimensions: dimensions.to_vec(),
            attributes,
            values,
        });
    };
    let over_time = |value: &dyn Fn(&InstantSolution) -> f64| {
        Values::Double(found.instants.iter().map(value).collect())
    };
    let times = over_time(&|instant| instant.time);
    add("time", &[0], "s", "time of an instant", times);
    let outputs = Values::Double(fields.times.clone());
    add("output_time", &[1], "s", "time of the fields", outputs);
    for condition in &CONDITIONS {
        let values = over_time(&|instant| (condition.value)(instant).unwrap_or(f64::NAN));
        let (name, unit) = (condition.name, condition.unit(is_line));
        add(name, &[0], unit, condition.words, values);
    }
    for figure in figures(found) {
        let (name, unit) = (figure.name(), figure.unit(is_line));
        let values = over_time(&|instant| {
            let value = instant.measured.figures.value(figure);
            value.unwrap_or(f64::NAN)
        });
        add(name, &[0], unit, figure.words(), values);
        let errors = over_time(&|instant| {
            let bar = instant.measured.bars.get(figure);
            bar.map_or(f64::NAN, |bar| bar.value)
        });
        let words = format!("error bar of the {}", figure.words());
        add(&format!("{name}_error"), &[0], unit, &words, errors);
    }
    if !found.amplitude_ratios.is_empty() {
        let ratios = found.amplitude_ratios.iter();
        let values = Values::Double(ratios.map(|ratio| ratio.unwrap_or(f64::NAN)).collect());
        add("amplitude_ratio", &[0], "", AMPLITUDE_RATIO, values);
    }
    let mut axes = vec![("x", "position along the motion", &fields.x)];
    if !fields.is_line() {
        axes.insert(0, ("y", "position across the motion", &fields.y));
    }
    let mut dimensions = vec![1];
    let mut names = Vec::new();
    for (name, words, values) in axes {
        let dimension = 2 + names.len();
        add(
            name,
            &[dimension],
            "m",
            words,
            Values::Double(values.clone()),
        );
        names.push((name, values.len()));
        dimensions.push(dimension);
    }
    for (field, values) in [
        (Field::Pressure, &fields.pressure),
        (Field::FilmThickness, &fields.film),
    ] {
        let values = Values::Single(values.concat());
        add(
            field.name(),
            &dimensions,
            field.unit(),
            field.words(),
            values,
        );
    }
    data.dimensions.extend(names);
    data.to_bytes()
}

/// Fill value for missing numbers, in the type of the values.
fn fill(values: &Values) -> Attribute {
    match values {
        Values::Double(_) => Attribute::Number(f64::NAN),
        Values::Single(_) => Attribute::Single(f32::NAN),
    }
}
