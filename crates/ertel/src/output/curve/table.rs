//! `curve.csv`: one line per point.

use std::fmt::Write;

use crate::case::study::header;
use crate::files::text_field;
use crate::study::{CurveSolution, joint_titles, point_fields};

/// The table as text, in SI units.
pub fn curve_table(curve: &CurveSolution) -> String {
    // `entrainment_speed_m_per_s`, `load_N`, `slide_to_roll_ratio`.
    let quantity = &curve.quantity;
    let mut text = format!("point,{}", header(quantity.key(), quantity.dimension));
    let is_line = (curve.points.first()).is_some_and(|p| p.case.contact.kind.is_line());
    let points: Vec<_> = (curve.points.iter())
        .map(|point| point_fields(point, is_line))
        .collect();
    let titles = joint_titles(points.iter().map(|fields| {
        let titles = fields.iter().map(|(title, _)| title.as_str());
        titles.collect()
    }));
    for title in &titles {
        let _ = write!(text, ",{title}");
    }
    text.push('\n');
    for (i, (point, fields)) in curve.points.iter().zip(&points).enumerate() {
        let _ = write!(text, "{},{:e}", i + 1, point.value);
        for title in &titles {
            text.push(',');
            if let Some((_, cell)) = fields.iter().find(|(own, _)| own == title) {
                text.push_str(&text_field(&cell.to_string()));
            }
        }
        text.push('\n');
    }
    text
}
