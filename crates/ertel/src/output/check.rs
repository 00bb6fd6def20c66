//! What a check of a case tells.

use super::lines::Lines;
use super::report::write_case;
use crate::case::CaseEcho;
use crate::estimate::CaseEstimate;
use crate::words::{length, pressure};

/// The case as understood, its dry contact and its films by formula; what else there is to say of a solve is for the caller.
pub fn check_report(case: &CaseEcho, estimate: &CaseEstimate) -> String {
    let mut out = Lines::default();
    out.title(&case.title);
    write_case(&mut out, case);
    out.heading("By formulas");
    out.row("largest pressure p_h", pressure(estimate.hertz.pressure));
    out.row("half-width a", length(estimate.hertz.half_width));
    let film = &estimate.film;
    let by = |name: &str, h: f64| format!("{} ({name})", length(h));
    out.row("central film", by(film.central_formula, film.central));
    if let (Some(h), Some(name)) = (film.minimum, film.minimum_formula) {
        out.row("minimum film", by(name, h));
    }
    out.text()
}
