//! The columns that a table of measurements may have.

use ertel_rheology::input::csv::{Column, CsvError, CsvTable};
use ertel_rheology::quantity::Dimension;

use super::Figure;

/// Columns that set a quantity: their names, the first being the one that messages use, key of the case, and what they measure.
pub(super) const OPERATING: [(&[&str], &str, &[Dimension]); 4] = [
    (
        &["entrainment speed", "rolling speed", "speed"],
        "motion.entrainment_speed",
        &[Dimension::SPEED],
    ),
    (
        &["slide to roll ratio", "srr"],
        "motion.slide_to_roll_ratio",
        &[Dimension::DIMENSIONLESS],
    ),
    (
        &["load"],
        "contact.load",
        &[Dimension::FORCE, Dimension::FORCE_PER_LENGTH],
    ),
    (&["temperature"], TEMPERATURE, &[Dimension::TEMPERATURE]),
];
/// Stands for the key of the temperature, which depends on the case.
pub(super) const TEMPERATURE: &str = "";

/// Columns that are measured: their names, and the name of their uncertainty.
pub(super) const MEASURED: [(&[&str], &[&str], Dimension); 3] = [
    (
        &["film central", "central film"],
        &["film central uncertainty", "central film uncertainty"],
        Dimension::LENGTH,
    ),
    (
        &["film minimum", "minimum film"],
        &["film minimum uncertainty", "minimum film uncertainty"],
        Dimension::LENGTH,
    ),
    (
        &["traction coefficient", "traction"],
        &["traction coefficient uncertainty", "traction uncertainty"],
        Dimension::DIMENSIONLESS,
    ),
];

/// A measured figure and its uncertainty.
pub(super) struct MeasuredColumns {
    pub figure: Figure,
    pub value: Column,
    pub uncertainty: Option<Uncertainty>,
}

/// A column of uncertainties.
pub(super) struct Uncertainty {
    pub column: Column,
    /// Whether it is a share of the value.
    pub is_relative: bool,
}

/// The column with one of these names and a unit of one of these dimensions.
pub(super) fn find(
    table: &CsvTable,
    names: &[&'static str],
    dimensions: &[Dimension],
    known: &[usize],
) -> Result<Option<Column>, CsvError> {
    let mut found: Option<Column> = None;
    for name in names {
        for dimension in dimensions {
            let Some(column) = table.find(name, *dimension)? else {
                continue;
            };
            if known.contains(&column.index) {
                continue;
            }
            if let Some(first) = &found {
                let problem = format!(
                    "`{}` and `{}` are names of the same column",
                    table.header().cell(first.index),
                    table.header().cell(column.index)
                );
                return Err(table.error(table.header(), column.index, problem));
            }
            found = Some(column);
        }
    }
    if found.is_some() {
        return Ok(found);
    }
    // A title that can be no other column tells what its unit lacks.
    for name in names {
        let is_bare = |title: &String| {
            let head = title.split(['[', '(']).next().unwrap_or_default();
            head.trim().replace('_', " ").eq_ignore_ascii_case(name)
        };
        let place = table.header().cells().iter().position(is_bare);
        if place.is_some_and(|index| !known.contains(&index)) {
            return table.find_with_unit(name, dimensions[0]);
        }
    }
    Ok(None)
}

/// A column of uncertainties: in the unit of the figure, or `%` of it.
pub(super) fn uncertainty(
    table: &CsvTable,
    names: &[&'static str],
    dimension: Dimension,
    known: &[usize],
) -> Result<Option<Uncertainty>, CsvError> {
    let dimensions = [dimension, Dimension::DIMENSIONLESS];
    let dimensions = match dimension == Dimension::DIMENSIONLESS {
        true => &dimensions[..1],
        false => &dimensions[..],
    };
    let Some(column) = find(table, names, dimensions, known)? else {
        return Ok(None);
    };
    let title = table.header().cell(column.index);
    let is_percent = title.contains('%');
    if dimension != Dimension::DIMENSIONLESS
        && column
            .unit
            .dimension()
            .same_exponents(Dimension::DIMENSIONLESS)
        && !is_percent
    {
        let problem = format!(
            "the column `{title}` has no unit; write `%` for a share of the value, or one of {}",
            dimension.examples()
        );
        return Err(table.error(table.header(), column.index, problem));
    }
    Ok(Some(Uncertainty {
        column,
        is_relative: is_percent,
    }))
}
