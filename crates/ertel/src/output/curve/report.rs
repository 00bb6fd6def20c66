//! The report of a curve.

use std::fmt::Write;
use std::path::Path;

use super::super::figure::{estimate, number, peak, temperature};
use super::super::lines::{Lines, Table};
use super::super::mixed::share;
use super::super::rows::{REPORTED, shown};
use crate::case::CaseEcho;
use crate::figures::Definition;
use crate::figures::run::FILM_CENTRAL_LOWEST;
use crate::solution::MixedLubrication;
use crate::study::{CurveSolution, Outcome, PointSolution, UnresolvedFigures, value_text};
use crate::warning::by_kind;
use crate::words::digits;

/// The points as a table, failures with their reasons, and warnings.
pub fn curve_report(case: &CaseEcho, curve: &CurveSolution, folder: Option<&Path>) -> String {
    let mut out = Lines::default();
    out.title(&case.title);
    out.heading(&format!("Curve over {}", curve.quantity.path));
    let is_machine = curve.points.iter().any(|p| p.machine.is_some());
    let is_in_time = curve.points.iter().any(|p| p.is_in_time);
    out.table(match is_machine || is_in_time {
        true => table_of_figures(curve, !is_machine),
        false => table(curve),
    });
    let mut text = out.text();
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

/// The table with its header; lambda ratio for rough surfaces, film and asperity friction with boundary friction.
fn table(curve: &CurveSolution) -> Table {
    let mixed = |p: &PointSolution| p.outcome.solution()?.mixed.clone();
    let found: Vec<MixedLubrication> = curve.points.iter().filter_map(mixed).collect();
    let is_rough = !found.is_empty();
    let has_asperities = found.iter().any(|m| m.asperities.is_some());
    let has_friction = found.iter().any(|m| m.friction().is_some());
    let solved = || curve.points.iter().filter_map(|p| p.outcome.solution());
    let slides = curve.points.iter().any(|p| p.case.motion.slides());
    let is_across = solved().any(|s| s.traction.across.is_some());
    let is_hot = solved().any(|s| s.thermal.is_some());
    let has_cold = (curve.points.iter()).any(|p| p.isothermal_solution().is_some());
    let columns = [
        (true, curve.quantity.name),
        (true, "central film thickness"),
        (true, "minimum film thickness"),
        (is_rough, "lambda ratio"),
        (has_asperities, "load on asperities"),
        (has_friction, "total friction coefficient"),
        (true, "smooth pressure maximum"),
        (slides, "traction coefficient"),
        (is_across, "across"),
        (is_hot, "largest film temperature"),
        (has_cold, "central film without heat"),
        (has_cold && slides, "traction without heat"),
        (true, "Newton"),
        (true, "time"),
    ];
    let shown = |cells: [String; 14]| {
        let cells = cells.into_iter().zip(&columns);
        let cells = cells.filter_map(|(cell, (is_shown, _))| is_shown.then_some(cell));
        cells.collect::<Vec<String>>()
    };
    let head = shown(columns.map(|(_, title)| title.to_owned()));
    let mut rows = Vec::new();
    let none = || "-".to_owned();
    for point in &curve.points {
        let value = value_text(&curve.quantity, point.value);
        let time = format!("{} s", digits(point.seconds, 2));
        rows.push(shown(match &point.outcome {
            Outcome::Solved(s) => {
                let iterations: usize = s.stats.levels.iter().map(|l| l.newton_iterations).sum();
                let mixed = s.mixed.as_ref();
                let cold = point.isothermal_solution();
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
                    number(s.traction.coefficient),
                    (s.traction.across.as_ref()).map_or_else(none, |a| number(a.coefficient)),
                    (s.thermal.as_ref())
                        .map_or_else(none, |t| temperature(t.film_maximum.estimate(), None)),
                    cold.map_or_else(none, |s| estimate(&s.summary.film_central)),
                    cold.map_or_else(none, |s| number(s.traction.coefficient)),
                    iterations.to_string(),
                    time,
                ]
            }
            Outcome::InTime(_) | Outcome::Failed(_) => {
                let mut cells = std::array::from_fn(|_| none());
                [cells[0], cells[1], cells[13]] = [value, "failed".to_owned(), time];
                cells
            }
        }));
    }
    Table::fitted(head, rows)
}

/// The table of whole machines or transient runs with its header and their main figures, of runs those that are not zero in all of them.
fn table_of_figures(curve: &CurveSolution, is_in_time: bool) -> Table {
    let columns: Vec<Definition> = (REPORTED.iter())
        .filter_map(|figure| {
            let mut found = curve.points.iter().filter_map(|p| p.row(figure.name));
            let row = found.find(|row| !is_in_time || row.estimate.value != 0.0);
            Some(row?.figure)
        })
        .collect();
    let mut head = vec![curve.quantity.name.to_owned()];
    head.extend(columns.iter().map(|figure| figure.words.to_owned()));
    let effort = if is_in_time { "steps" } else { "contacts" };
    head.extend([effort, "time"].map(str::to_owned));
    let mut rows = Vec::new();
    for point in &curve.points {
        let mut row = vec![value_text(&curve.quantity, point.value)];
        row.extend(columns.iter().map(|figure| match point.row(figure.name) {
            Some(found) => shown(found),
            None if *figure == FILM_CENTRAL_LOWEST => "failed".to_owned(),
            None => "-".to_owned(),
        }));
        row.push(match (&point.machine, point.outcome.in_time()) {
            (Some(of), _) => match (of.solution.n_contacts(), of.solution.n_failed()) {
                (all, 0) => all.to_string(),
                (all, failed) => format!("{failed} of {all} failed"),
            },
            (None, Some(run)) => run.steps[0].to_string(),
            (None, None) if is_in_time => "-".to_owned(),
            (None, None) => "failed".to_owned(),
        });
        row.push(format!("{} s", digits(point.seconds, 2)));
        rows.push(row);
    }
    Table::fitted(head, rows)
}

/// Failures, and warnings with their points.
fn write_remarks(text: &mut String, curve: &CurveSolution) {
    if curve.is_partial() {
        let (n, all) = (curve.points.len(), curve.n_points);
        let _ = writeln!(text, "\n  ! interrupted: {n} of {all} points have ended");
    }
    for (i, point) in curve.points.iter().enumerate() {
        if let Outcome::Failed(reason) = &point.outcome {
            let _ = writeln!(text, "\n  ! point {} failed: {reason}", i + 1);
        }
    }
    let all: Vec<_> = curve.points.iter().map(PointSolution::warnings).collect();
    let warnings = all.iter().enumerate().flat_map(|(i, of)| {
        let shown = of.iter().filter(|w| w.is_shown());
        shown.map(move |w| (i, w))
    });
    for merged in by_kind(warnings) {
        let line = merged.with_text(merged.line(curve.points.len()));
        let _ = writeln!(text, "\n  ! {}", line.coded());
    }
    if let Some(line) = UnresolvedFigures::of_curve(curve).line(curve.points.len()) {
        let _ = writeln!(text, "\n  · {line}");
    }
}
