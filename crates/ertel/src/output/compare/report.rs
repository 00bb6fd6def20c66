//! The report of a comparison.

use std::fmt::Write;
use std::path::Path;

use super::super::figure::{in_unit, with_bar};
use super::super::lines::{Lines, Table};
use super::super::pictures::film_unit;
use super::super::study::words;
use crate::case::study::AxisValue;
use crate::compare::{Compared, Comparison, Measurand, Outcome, Statistics};
use crate::solution::Estimate;
use crate::words::{CELSIUS, digits};

/// The rows as a table, then bias, scatter and the worst row of each figure.
pub fn comparison_report(comparison: &Comparison, folder: Option<&Path>) -> String {
    let mut out = Lines::default();
    out.title(&comparison.title);
    out.heading("Measured and computed");
    comparison.notes.iter().for_each(|note| out.line(note));
    let mut text = out.text();
    let figures: Vec<Measurand> = comparison.figures().collect();
    for figure in &figures {
        text.push('\n');
        text += &table_of(comparison, *figure).text();
    }
    for said in failures(comparison) {
        let _ = writeln!(text, "\n  ! {said}");
    }
    for figure in &figures {
        text.push('\n');
        write_statistics(&mut text, comparison, *figure);
    }
    let n_solved = comparison.rows.len() - comparison.n_unsolved();
    let _ = writeln!(
        text,
        "\n{n_solved} of {} rows compared, {} points",
        comparison.rows.len(),
        comparison.n_points
    );
    if let Some(folder) = folder {
        let _ = writeln!(text, "Results in {}", folder.display());
    }
    text
}

/// Factor and unit in which a figure is shown.
pub(super) fn unit_of(comparison: &Comparison, figure: Measurand) -> (f64, &'static str) {
    if !figure.is_film() && figure != Measurand::FrictionTorque {
        return (1.0, figure.unit());
    }
    let measured = comparison
        .rows
        .iter()
        .filter_map(|r| r.figures[figure as usize]);
    // A speed ramp spans both units: the thinnest film decides.
    let smallest = measured.fold(f64::MAX, |smallest, c| smallest.min(c.measured.value));
    match figure.is_film() {
        true => film_unit(smallest),
        false if smallest < 1.0 => (1e3, "N mm"),
        false => (1.0, "N m"),
    }
}

/// A table for each figure, and its statistics.
pub(in crate::output) fn write_figures(out: &mut Lines, comparison: &Comparison) {
    for figure in comparison.figures() {
        let words = figure.words();
        let (first, rest) = words.split_at(1);
        out.heading(&(first.to_uppercase() + rest));
        out.table(table_of(comparison, figure));
        for (name, value) in statistics_of(comparison, figure) {
            out.row(name, value);
        }
    }
}

/// The table of a figure.
fn table_of(comparison: &Comparison, figure: Measurand) -> Table {
    let (factor, unit) = unit_of(comparison, figure);
    let in_brackets = |unit: &str| match unit {
        "" => String::new(),
        unit => format!(" ({unit})"),
    };
    let mut header = vec!["line".to_owned()];
    header.extend(comparison.columns.iter().map(|title| {
        let (name, unit) = words(title);
        match unit.as_str() {
            "K" => format!("{name} (°C)"),
            unit => format!("{name}{}", in_brackets(unit)),
        }
    }));
    header.push(format!("{} measured{}", figure.words(), in_brackets(unit)));
    header.extend(["computed", "difference", "agree"].map(str::to_owned));
    let mut rows = Vec::new();
    for row in &comparison.rows {
        let Some(compared) = row.figures[figure as usize] else {
            continue;
        };
        let mut cells = vec![row.line.to_string()];
        cells.extend(row.values.iter().map(shown));
        let measured = Estimate {
            value: compared.measured.value,
            error: compared.measured.uncertainty,
        };
        cells.push(with_bar(measured, factor, ""));
        match compared.computed {
            Some(computed) => cells.extend([
                in_unit(computed, factor, ""),
                difference(&compared),
                agree(&compared),
            ]),
            None => cells.extend(["failed", "-", "-"].map(str::to_owned)),
        }
        rows.push(cells);
    }
    Table::fitted(header, rows)
}

/// A value of a column; temperatures in °C.
fn shown(value: &AxisValue) -> String {
    match value {
        AxisValue::Number(value, dimension) if dimension.si_unit() == "K" => {
            digits(value - CELSIUS, 4)
        }
        AxisValue::Number(value, _) => digits(*value, 4),
        AxisValue::Text(text) => text.chars().filter(|c| !c.is_control()).collect(),
    }
}

fn difference(compared: &Compared) -> String {
    let share = compared.difference();
    share.map_or("-".to_owned(), percent)
}

fn percent(share: f64) -> String {
    format!("{:+.1} %", 100.0 * share)
}

fn agree(compared: &Compared) -> String {
    match compared.is_within() {
        Some(true) => "yes",
        Some(false) => "no",
        None => "-",
    }
    .to_owned()
}

/// Rows that are omitted or not resolved, as sentences.
pub(in crate::output) fn failures(comparison: &Comparison) -> Vec<String> {
    let of = comparison.rows.iter().filter_map(|row| {
        let said = match &row.outcome {
            Outcome::Solved { unresolved } if unresolved.is_empty() => return None,
            Outcome::Solved { unresolved } => format!("is not resolved by the mesh: {unresolved}"),
            Outcome::Failed(reason) => format!("is omitted; its point failed: {reason}"),
            Outcome::Open => "is omitted; its point was not started".to_owned(),
        };
        Some(format!("line {} {said}", row.line))
    });
    of.collect()
}

fn write_statistics(text: &mut String, comparison: &Comparison, figure: Measurand) {
    let found = statistics_of(comparison, figure);
    if found.is_empty() {
        let _ = writeln!(text, "{}: no row could be compared", figure.words());
        return;
    }
    let _ = writeln!(text, "{}, computed against measured", figure.words());
    for (name, value) in found {
        let _ = writeln!(text, "  {name:<22}{value}");
    }
}

/// Bias, scatter and the worst row; empty if no row could be compared.
fn statistics_of(comparison: &Comparison, figure: Measurand) -> Vec<(&'static str, String)> {
    let statistics = comparison.statistics(figure);
    let Statistics {
        bias: Some(bias),
        rms: Some(rms),
        worst: Some(worst),
        worst_row: Some(row),
        ..
    } = statistics
    else {
        return Vec::new();
    };
    let at = comparison.rows[row].line;
    let agreed = format!("{} of {}", statistics.n_within, statistics.n_judged);
    let mut lines = vec![
        ("bias (mean)", percent(bias)),
        ("rms", format!("{:.1} %", 100.0 * rms)),
        ("worst", format!("{} (line {at})", percent(worst))),
        ("agree", agreed + &basis(&statistics)),
    ];
    let zeros = statistics.n_measured - statistics.n_compared - unsolved(comparison, figure);
    if zeros > 0 {
        lines.push((
            "measured as zero",
            format!("{zeros}; not in bias, rms and worst"),
        ));
    }
    lines
}

/// Rows of a figure without a solution.
fn unsolved(comparison: &Comparison, figure: Measurand) -> usize {
    let rows = comparison
        .rows
        .iter()
        .filter_map(|r| r.figures[figure as usize]);
    rows.filter(|compared| compared.computed.is_none()).count()
}

/// The uncertainty used to judge the agreement of the rows.
fn basis(statistics: &Statistics) -> String {
    match statistics.n_with_uncertainty {
        0 => ", within the error bar of the calculation alone: the table gives no measurement uncertainty".to_owned(),
        n if n == statistics.n_measured => {
            ", within the combined uncertainty of measurement and calculation".to_owned()
        }
        n => format!(
            ", within the combined uncertainty; {} rows have no measurement uncertainty and are judged by the error bar of \
             the calculation alone",
            statistics.n_measured - n
        ),
    }
}
