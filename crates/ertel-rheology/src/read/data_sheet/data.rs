//! Where the numbers of a data sheet come from.

use crate::data_sheet::Estimate;
use crate::provenance::{Datum, Status};
use ertel_input::{InputError, Table};
use ertel_quantity::Dimension;

/// A number that the table gives.
pub(in crate::read) fn given(table: &Table<'_>, key: &str, value: String, unit: &str) -> Datum {
    let source = if table.path().is_empty() {
        "given".to_owned()
    } else {
        format!("given in [{}]", table.path())
    };
    datum(key, value, unit, source, Status::User, None)
}

/// A number that follows from given ones.
pub(in crate::read) fn computed(key: &str, value: String, unit: &str, source: &str) -> Datum {
    datum(key, value, unit, source.to_owned(), Status::Computed, None)
}

/// The value of an estimate, noted with its uncertainty among the inputs of `table`, and its datum among `data`: times `scale` in
/// `unit`.
pub(super) fn estimated(
    table: &Table<'_>,
    data: &mut Vec<Datum>,
    (key, estimate): (&str, &Estimate),
    dimension: Dimension,
    (scale, unit): (f64, &str),
) -> f64 {
    data.push(datum_of(key, estimate, scale, unit));
    table.estimated_quantity(key, estimate.value, dimension, estimate.uncertainty())
}

/// The datum of an estimate: times `scale` in `unit`.
pub(in crate::read) fn datum_of(key: &str, estimate: &Estimate, scale: f64, unit: &str) -> Datum {
    let percent = |share: f64| format!("{:.0} %", 100.0 * share);
    let range = if estimate.below == estimate.above {
        format!("± {}", percent(estimate.above))
    } else {
        format!(
            "-{} to +{}",
            percent(estimate.below),
            percent(estimate.above)
        )
    };
    let note = format!("estimate, {range}: {}", estimate.basis);
    let value = figures(scale * estimate.value);
    datum(
        key,
        value,
        unit,
        estimate.source.to_owned(),
        Status::Estimated,
        Some(note),
    )
}

fn datum(
    key: &str,
    value: String,
    unit: &str,
    source: String,
    status: Status,
    note: Option<String>,
) -> Datum {
    Datum {
        key: key.to_owned(),
        value,
        unit: unit.to_owned(),
        source,
        status,
        note,
    }
}

/// Four figures, without zeros at the end.
pub(in crate::read) fn figures(value: f64) -> String {
    let decimals = (3.0 - value.abs().log10().floor()).clamp(0.0, 12.0) as usize;
    let text = format!("{value:.decimals$}");
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

pub(super) const ZERO_CELSIUS: f64 = 273.15;
pub(super) const CELSIUS_40: f64 = 313.15;
pub(super) const CELSIUS_100: f64 = 373.15;

pub(super) fn twice(table: &Table<'_>, key: &str, other: &str) -> InputError {
    table.error(
        key,
        format!("`{other}` and `{key}` say the same thing: give one of them"),
    )
}
