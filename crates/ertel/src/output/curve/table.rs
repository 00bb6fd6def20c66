//! `curve.csv`: one line for each point.

use std::fmt::Write;

use crate::case::study::header;
use crate::files::text_field;
use crate::study::{CurveSolution, columns};

/// The table as text, SI.
pub fn curve_table(curve: &CurveSolution) -> String {
    // `entrainment_speed_m_per_s`, `load_N`, `slide_to_roll_ratio`.
    let quantity = &curve.quantity;
    let mut text = format!("point,{}", header(quantity.key(), quantity.dimension));
    let is_line = (curve.points.first()).is_some_and(|p| p.case.contact.kind.is_line());
    for column in columns() {
        for title in std::iter::once(column.title(is_line)).chain(column.error_title(is_line)) {
            let _ = write!(text, ",{title}");
        }
    }
    text.push('\n');
    for (i, point) in curve.points.iter().enumerate() {
        let _ = write!(text, "{},{:e}", i + 1, point.value);
        for (_, cell) in columns().flat_map(|column| column.fields(point, is_line)) {
            text.push(',');
            text.push_str(&text_field(&cell.to_string()));
        }
        text.push('\n');
    }
    text
}
