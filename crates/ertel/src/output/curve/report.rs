//! What a user reads of a curve.

use std::fmt::Write;
use std::path::Path;

use super::super::figure::{estimate, number, peak, temperature};
use super::super::mixed::share;
use crate::case::CaseEcho;
use crate::solution::MixedLubrication;
use crate::study::{CurveSolution, Outcome, PointSolution, value_text};
use crate::warning::by_kind;
use crate::words::digits;

/// The points as a table, failures with their reasons, warnings.
pub fn curve_report(case: &CaseEcho, curve: &CurveSolution, folder: Option<&Path>) -> String {
    let mut title: String = case.title.chars().filter(|c| !c.is_control()).collect();
    if title.trim().is_empty() {
        title = "Elastohydrodynamic contact".to_owned();
    }
    let rule = "─".repeat(title.chars().count().max(4));
    let mut text = format!("{title}\n{rule}\n\nCurve over {}\n", curve.quantity.path);
    let rows = rows(curve);
    let width = |j: usize| rows.iter().map(|r| r[j].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..rows[0].len()).map(width).collect();
    for row in &rows {
        let cells = row
            .iter()
            .zip(&widths)
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

/// The table with its header; of rough surfaces with the lambda ratio, with boundary friction with the friction of film and asperities.
fn rows(curve: &CurveSolution) -> Vec<Vec<String>> {
    let mixed = |p: &PointSolution| p.outcome.solution()?.mixed.clone();
    let found: Vec<MixedLubrication> = curve.points.iter().filter_map(mixed).collect();
    let is_rough = !found.is_empty();
    let has_asperities = found.iter().any(|m| m.asperities.is_some());
    let has_friction = found.iter().any(|m| m.friction().is_some());
    let solved = || curve.points.iter().filter_map(|p| p.outcome.solution());
    let slides = curve.points.iter().any(|p| p.case.motion.slides());
    let is_hot = solved().any(|s| s.thermal.is_some());
    let columns = [
        (true, curve.quantity.name),
        (true, "central film thickness"),
        (true, "minimum film thickness"),
        (is_rough, "lambda ratio"),
        (has_asperities, "load on asperities"),
        (has_friction, "total friction coefficient"),
        (true, "smooth pressure maximum"),
        (slides, "traction coefficient"),
        (is_hot, "largest film temperature"),
        (true, "Newton"),
        (true, "time"),
    ];
    let shown = |cells: [String; 11]| {
        let cells = cells.into_iter().zip(&columns);
        let cells = cells.filter_map(|(cell, (is_shown, _))| is_shown.then_some(cell));
        cells.collect::<Vec<String>>()
    };
    let mut rows = vec![shown(columns.map(|(_, title)| title.to_owned()))];
    let none = || "-".to_owned();
    for point in &curve.points {
        let value = value_text(&curve.quantity, point.value);
        let time = format!("{} s", digits(point.seconds, 2));
        let failed = || "failed".to_owned();
        rows.push(shown(match &point.outcome {
            Outcome::Solved(s) => {
                let iterations: usize = s.stats.levels.iter().map(|l| l.newton_iterations).sum();
                let mixed = s.mixed.as_ref();
                let asperities = mixed.and_then(|m| m.asperities.as_ref());
                let friction = mixed.and_then(MixedLubrication::friction);
                [
                    value,
                    estimate(&s.summary.film_central),
                    estimate(&s.summary.film_minimum),
                    mixed.map_or_else(none, |m| number(m.lambda_minimum)),
                    asperities.map_or_else(none, |a| share(a.asperity_load_share)),
                    friction.map_or_else(none, |f| number(f.friction_total)),
                    peak(&s.summary.pressure_central),
                    number(s.traction.size()),
                    (s.thermal.as_ref())
                        .map_or_else(none, |t| temperature(t.film_maximum.estimate(), None)),
                    iterations.to_string(),
                    time,
                ]
            }
            Outcome::Failed(_) => [
                value,
                failed(),
                none(),
                none(),
                none(),
                none(),
                none(),
                none(),
                none(),
                none(),
                time,
            ],
        }));
    }
    rows
}

/// Failures, and warnings with the points that they are about.
fn write_remarks(text: &mut String, curve: &CurveSolution) {
    let mut warnings = Vec::new();
    for (i, point) in curve.points.iter().enumerate() {
        match &point.outcome {
            Outcome::Failed(reason) => {
                let _ = writeln!(text, "\n  ! point {} failed: {reason}", i + 1);
            }
            Outcome::Solved(s) => {
                let told = s.warnings.iter().filter(|w| !w.kind.is_note());
                warnings.extend(told.map(|w| (i, w)));
            }
        }
    }
    for merged in by_kind(warnings) {
        let _ = writeln!(text, "\n  ! {}", merged.line(curve.points.len()));
    }
}
