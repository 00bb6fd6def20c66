//! The columns that a table of measurements may have.

use ertel_input::Document;
use ertel_input::csv::{Column, CsvError, CsvTable};
use ertel_input::excerpt;
use ertel_quantity::Dimension;

use super::measured::temperature_key;
use super::{Measurand, N_MEASURANDS};

/// A quantity that a column sets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Operating {
    /// Mean speed of the surfaces.
    Speed,
    /// Slide-to-roll ratio.
    Sliding,
    /// Load, in line contacts per length.
    Load,
    /// Temperature of the lubricant.
    Temperature,
}

/// The quantities, with the names of their columns.
pub(super) const OPERATING: [(Operating, &str, &[Dimension]); 4] = [
    (Operating::Speed, "entrainment speed", &[Dimension::SPEED]),
    (
        Operating::Sliding,
        "slide to roll ratio",
        &[Dimension::DIMENSIONLESS],
    ),
    (
        Operating::Load,
        "load",
        &[Dimension::FORCE, Dimension::FORCE_PER_LENGTH],
    ),
    (
        Operating::Temperature,
        "temperature",
        &[Dimension::TEMPERATURE],
    ),
];

/// Columns that are measured, with the names of their uncertainties.
pub(super) const MEASURED: [(&str, &str, Dimension); N_MEASURANDS] = [
    (
        "film central",
        "film central uncertainty",
        Dimension::LENGTH,
    ),
    (
        "film minimum",
        "film minimum uncertainty",
        Dimension::LENGTH,
    ),
    (
        "traction coefficient",
        "traction coefficient uncertainty",
        Dimension::DIMENSIONLESS,
    ),
    (
        "friction torque",
        "friction torque uncertainty",
        Dimension::ENERGY,
    ),
    (
        "friction power",
        "friction power uncertainty",
        Dimension::POWER,
    ),
    (
        "mesh loss",
        "mesh loss uncertainty",
        Dimension::DIMENSIONLESS,
    ),
];

/// All of these names.
pub(super) fn names() -> Vec<&'static str> {
    let operating = OPERATING.iter().map(|(_, name, _)| *name);
    let measured = MEASURED.iter().flat_map(|(name, bar, _)| [*name, *bar]);
    operating.chain(measured).collect()
}

impl Operating {
    /// Key that a quantity has in a case.
    ///
    /// # Errors
    ///
    /// A machine whose quantity follows from other keys, which are named.
    pub(super) fn key(self, case: &Document) -> Result<&'static str, String> {
        let Some(machine) = case.tree().entry("machine") else {
            return Ok(match self {
                Operating::Speed => "motion.entrainment_speed",
                Operating::Sliding => "motion.slide_to_roll_ratio",
                Operating::Load => "contact.load",
                Operating::Temperature => temperature_key(case),
            });
        };
        let has = |key: &str| machine.node.entry(key).is_some();
        // Two speeds of surfaces are replaced: `speeds`.
        let is_disc = has("entrainment_speed") || (has("ball_speed") && has("disc_speed"));
        let (own, others): (&[&'static str], &[&str]) = match self {
            Operating::Temperature => return Ok(temperature_key(case)),
            Operating::Speed if is_disc => return Ok("machine.entrainment_speed"),
            Operating::Sliding if is_disc => return Ok("machine.slide_to_roll_ratio"),
            Operating::Speed => (
                &[],
                &[
                    "inner_ring_speed",
                    "outer_ring_speed",
                    "pinion_speed",
                    "cam_speed",
                ],
            ),
            Operating::Sliding => (&[], &[]),
            Operating::Load => (
                &["machine.load", "machine.ball_load", "machine.roller_load"],
                &["radial_load", "axial_load", "pinion_torque"],
            ),
        };
        let key = |path: &&&str| has(&path["machine.".len()..]);
        if let Some(key) = own.iter().find(key) {
            return Ok(key);
        }
        let others: Vec<String> = (others.iter().filter(|key| has(key)))
            .map(|key| format!("`machine.{key}`"))
            .collect();
        Err(match others.is_empty() {
            true => "it follows from the other keys of [machine] in this case; omit the column with --ignore".to_owned(),
            false => format!(
                "it follows from {} of the machine: title the column with that key and its unit",
                others.join(" and ")
            ),
        })
    }
}

/// A measured figure and its uncertainty.
pub(super) struct MeasuredColumns {
    pub figure: Measurand,
    pub value: Column,
    pub uncertainty: Option<Uncertainty>,
}

/// A column of uncertainties.
pub(super) struct Uncertainty {
    pub column: Column,
    /// Whether it is a share of the value.
    pub is_relative: bool,
}

/// The column of a quantity with a unit of one of these dimensions.
pub(super) fn find(
    table: &CsvTable,
    name: &'static str,
    dimensions: &[Dimension],
    known: &[usize],
) -> Result<Option<Column>, CsvError> {
    for dimension in dimensions {
        if let Some(column) = table.find_except(name, *dimension, known)? {
            return Ok(Some(column));
        }
    }
    // A title that can be no other column: the error names the missing unit.
    table.find_with_unit_except(name, dimensions[0], known)
}

/// Note on a column whose title is ambiguous.
pub(super) fn open_name(table: &CsvTable, column: &Column) -> Option<String> {
    let title = excerpt(table.header().cell(column.index));
    let what = match column.name {
        "film central" => {
            "the central film; if it is the minimum film, use `--column film_minimum=...`"
        }
        "slide to roll ratio" => {
            "the slide-to-roll ratio (u_body_2 - u_body_1)/u of the mean speed u"
        }
        name => name,
    };
    column
        .is_open
        .then(|| format!("column `{title}` is read as {what}"))
}

/// A column of uncertainties: in the unit of the figure, or `%` of it.
pub(super) fn uncertainty(
    table: &CsvTable,
    name: &'static str,
    dimension: Dimension,
    known: &[usize],
) -> Result<Option<Uncertainty>, CsvError> {
    let dimensions = [dimension, Dimension::DIMENSIONLESS];
    let dimensions = match dimension == Dimension::DIMENSIONLESS {
        true => &dimensions[..1],
        false => &dimensions[..],
    };
    let Some(column) = find(table, name, dimensions, known)? else {
        return Ok(None);
    };
    let is_percent = column.unit_text.contains('%');
    if dimension != Dimension::DIMENSIONLESS
        && column
            .unit
            .dimension()
            .same_exponents(Dimension::DIMENSIONLESS)
        && !is_percent
    {
        let problem = format!(
            "the column `{}` has no unit; write `%` for a share of the value, or one of {}",
            table.header().cell(column.index),
            dimension.examples()
        );
        return Err(table.error(table.header(), column.index, problem));
    }
    Ok(Some(Uncertainty {
        column,
        is_relative: is_percent,
    }))
}
