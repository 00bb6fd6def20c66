//! `comparison.csv`: one line per row of the measurements.

use crate::case::study::AxisValue;
use crate::compare::{Comparison, Measurand, Outcome};
use crate::files::text_field;
use crate::study::titled;

/// The table as text, in SI units.
pub fn comparison_table(comparison: &Comparison) -> String {
    let figures: Vec<Measurand> = comparison.figures().collect();
    let mut header = vec!["line".to_owned(), "point".to_owned()];
    header.extend(comparison.columns.iter().map(|title| text_field(title)));
    for figure in &figures {
        let (name, unit) = (figure.name(), figure.unit());
        for (part, unit) in [
            ("measured", unit),
            ("measured_uncertainty", unit),
            ("computed", unit),
            ("computed_error", unit),
            ("difference", ""),
            ("within", ""),
        ] {
            header.push(titled(&format!("{name}_{part}"), unit));
        }
    }
    header.extend(["converged", "unresolved", "reason"].map(str::to_owned));
    let mut text = header.join(",") + "\n";
    for row in &comparison.rows {
        let mut cells = vec![row.line.to_string(), (row.point + 1).to_string()];
        cells.extend(row.values.iter().map(|value| match value {
            AxisValue::Number(number, _) => format!("{number:e}"),
            AxisValue::Text(text) => text_field(text),
        }));
        let number = |value: Option<f64>| value.map_or(String::new(), |v| format!("{v:e}"));
        for figure in &figures {
            let compared = row.figures[*figure as usize];
            let computed = compared.and_then(|c| c.computed);
            cells.extend([
                number(compared.map(|c| c.measured.value)),
                number(compared.and_then(|c| c.measured.uncertainty)),
                number(computed.map(|c| c.value)),
                number(computed.and_then(|c| c.error)),
                number(compared.and_then(|c| c.difference())),
                compared
                    .and_then(|c| c.is_within())
                    .map_or(String::new(), |w| w.to_string()),
            ]);
        }
        let (converged, unresolved, reason) = match &row.outcome {
            Outcome::Solved { unresolved } => ("true", unresolved.as_str(), ""),
            Outcome::Failed(reason) => ("false", "", reason.as_str()),
            Outcome::Open => ("false", "", "not begun"),
        };
        cells.push(converged.to_owned());
        cells.extend([unresolved, reason].map(text_field));
        text += &(cells.join(",") + "\n");
    }
    text
}
