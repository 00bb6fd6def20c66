//! `comparison.json`: the comparison for programs.

use serde_json::{Map, Value, json};

use crate::case::study::AxisValue;
use crate::compare::{ComparedRow, Comparison, Measurand, Outcome};
use crate::output::FORMAT_VERSION;
use crate::run::NUMERICS;

/// Value of the key `format` that identifies comparison results.
pub const COMPARISON_FORMAT: &str = "ertel-comparison";

/// The JSON document in SI units.
pub fn comparison_json(comparison: &Comparison) -> Value {
    let statistics = comparison.figures().map(|figure| {
        let value = serde_json::to_value(comparison.statistics(figure)).unwrap_or_default();
        (figure.name().to_owned(), value)
    });
    let rows: Vec<Value> = comparison.rows.iter().map(|r| row(comparison, r)).collect();
    json!({
        "format": COMPARISON_FORMAT,
        "format_version": FORMAT_VERSION,
        "ertel_version": env!("CARGO_PKG_VERSION"),
        "numerics_version": NUMERICS,
        "title": comparison.title,
        "columns": comparison.columns,
        "n_rows": comparison.rows.len(),
        "n_points": comparison.n_points,
        "n_unsolved": comparison.n_unsolved(),
        "notes": comparison.notes,
        "statistics": statistics.collect::<Map<_, _>>(),
        "rows": rows,
    })
}

fn row(comparison: &Comparison, row: &ComparedRow) -> Value {
    let values = comparison
        .columns
        .iter()
        .zip(&row.values)
        .map(|(title, value)| {
            let value = match value {
                AxisValue::Number(number, _) => json!(number),
                AxisValue::Text(text) => json!(text),
            };
            (title.clone(), value)
        });
    let (converged, unresolved, reason) = match &row.outcome {
        Outcome::Solved { unresolved } => (true, unresolved.as_str(), None),
        Outcome::Failed(reason) => (false, "", Some(reason.as_str())),
        Outcome::Open => (false, "", Some("not begun")),
    };
    let figures = Measurand::ALL.into_iter().filter_map(|figure| {
        let compared = row.figures[figure as usize]?;
        let value = json!({
            "measured": compared.measured.value,
            "measured_uncertainty": compared.measured.uncertainty,
            "computed": compared.computed.map(|c| c.value),
            "computed_error": compared.computed.and_then(|c| c.error),
            "difference": compared.difference(),
            "within": compared.is_within(),
        });
        Some((figure.name().to_owned(), value))
    });
    json!({
        "line": row.line,
        "point": row.point + 1,
        "values": values.collect::<Map<_, _>>(),
        "converged": converged,
        "unresolved": unresolved,
        "reason": reason,
        "figures": figures.collect::<Map<_, _>>(),
    })
}
