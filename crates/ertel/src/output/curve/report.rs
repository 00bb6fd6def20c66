//! What a user reads of a curve.

use std::fmt::Write;
use std::path::Path;

use super::super::CaseEcho;
use super::super::figure::{estimate, pressure_estimate};
use super::super::report::digits;
use crate::study::{CurveSolution, Outcome};
use crate::warning::by_kind;

/// The points as a table, failures with their reasons, warnings.
pub fn curve_report(case: &CaseEcho, curve: &CurveSolution, folder: Option<&Path>) -> String {
    let mut title: String = case.title.chars().filter(|c| !c.is_control()).collect();
    if title.trim().is_empty() {
        title = "Elastohydrodynamic contact".to_owned();
    }
    let rule = "─".repeat(title.chars().count().max(4));
    let mut text = format!("{title}\n{rule}\n\nCurve over {}\n", curve.quantity.path);
    let unit = curve.quantity.unit();
    let mut rows = vec![
        [
            curve.quantity.name,
            "central film thickness",
            "minimum film thickness",
            "largest pressure",
            "Newton",
            "time",
        ]
        .map(str::to_owned),
    ];
    for point in &curve.points {
        let value = format!("{} {unit}", digits(point.value, 6))
            .trim_end()
            .to_owned();
        let time = format!("{} s", digits(point.seconds, 2));
        rows.push(match &point.outcome {
            Outcome::Solved(s) => {
                let iterations: usize = s.stats.levels.iter().map(|l| l.newton_iterations).sum();
                [
                    value,
                    estimate(&s.summary.film_central),
                    estimate(&s.summary.film_minimum),
                    pressure_estimate(s.summary.pressure_maximum.estimate()),
                    iterations.to_string(),
                    time,
                ]
            }
            Outcome::Failed(_) => {
                let none = || "-".to_owned();
                [value, "failed".to_owned(), none(), none(), none(), time]
            }
        });
    }
    let width = |j: usize| rows.iter().map(|r| r[j].chars().count()).max().unwrap_or(0);
    let widths = [0, 1, 2, 3, 4, 5].map(width);
    for row in &rows {
        let cells = row
            .iter()
            .zip(widths)
            .map(|(cell, w)| format!("{cell:<w$}"));
        let _ = writeln!(
            text,
            "  {}",
            cells.collect::<Vec<_>>().join("  ").trim_end()
        );
    }
    write_remarks(&mut text, curve);
    let _ = writeln!(
        text,
        "\n{} of {} points solved in {} s",
        curve.points.len() - curve.n_failed(),
        curve.n_points,
        digits(curve.wall_seconds, 3)
    );
    if let Some(folder) = folder {
        let _ = writeln!(text, "Results in {}", folder.display());
    }
    text
}

/// Failures, and warnings with the points that they are about.
fn write_remarks(text: &mut String, curve: &CurveSolution) {
    let mut warnings = Vec::new();
    for (i, point) in curve.points.iter().enumerate() {
        match &point.outcome {
            Outcome::Failed(reason) => {
                let _ = writeln!(text, "\n  ! point {} failed: {reason}", i + 1);
            }
            Outcome::Solved(s) => warnings.extend(s.warnings.iter().map(|w| (i, w))),
        }
    }
    for merged in by_kind(warnings) {
        let _ = writeln!(text, "\n  ! {}", merged.line(curve.points.len()));
    }
}
