//! Which values of a column belong to one setting of a test rig.

use crate::case::study::AxisValue;
use crate::compare::Comparison;

/// Relative scatter of the values of one setting, and its scatter in K for temperatures.
const SCATTER: f64 = 0.03;
const SCATTER_KELVIN: f64 = 2.0;
/// Scatter of the slide-to-roll ratio within one setting.
const SCATTER_RATIO: f64 = 0.01;

/// Number of each row's setting in a column: values no farther from the next one than the scatter share a setting.
pub(super) fn settings(comparison: &Comparison, column: usize) -> Vec<usize> {
    let mut numbers = vec![0; comparison.rows.len()];
    let mut setting = 0;
    let mut former: Option<&AxisValue> = None;
    for (i, value) in sorted(comparison, column) {
        if former.is_some_and(|former| !is_same(former, value)) {
            setting += 1;
        }
        former = Some(value);
        numbers[i] = setting;
    }
    numbers
}

/// Number of neighbouring values farther apart than the scatter; large for a fine ramp.
pub(super) fn n_apart(comparison: &Comparison, column: usize) -> usize {
    let mut n = 0;
    let mut first: Option<&AxisValue> = None;
    for (_, value) in sorted(comparison, column) {
        if first.is_none_or(|first| !is_same(first, value)) {
            n += 1;
            first = Some(value);
        }
    }
    n
}

/// The values of a column in rising order, each with its row.
fn sorted(comparison: &Comparison, column: usize) -> Vec<(usize, &AxisValue)> {
    let mut values: Vec<_> = comparison
        .rows
        .iter()
        .map(|row| &row.values[column])
        .enumerate()
        .collect();
    values.sort_by(|(_, a), (_, b)| match (a.number(), b.number()) {
        (Some(a), Some(b)) => a.total_cmp(&b),
        _ => a.to_string().cmp(&b.to_string()),
    });
    values
}

/// Whether two values may belong to one setting of a rig.
fn is_same(a: &AxisValue, b: &AxisValue) -> bool {
    let (AxisValue::Number(a, dimension), AxisValue::Number(b, _)) = (a, b) else {
        return a == b;
    };
    let off = (a - b).abs();
    match dimension.si_unit().as_str() {
        "K" => off <= SCATTER_KELVIN,
        "" => off <= SCATTER_RATIO,
        _ => off <= SCATTER * a.abs().max(b.abs()),
    }
}
