//! The comparisons as tables.

use super::check::{Accept, Row, Verdict};
use super::{Study, StudyResult};
use ertel::files::{quoted, text_field};

/// Columns of the table.
pub(super) const HEAD: [&str; 8] = [
    "run",
    "quantity",
    "published",
    "ours",
    "difference",
    "tolerance",
    "",
    "published by",
];

/// Table of a study for the terminal.
pub fn text(study: &Study, result: &StudyResult) -> String {
    let mut rows = vec![HEAD.map(str::to_owned)];
    rows.extend(result.rows.iter().map(cells));
    let widths: Vec<usize> = (0..HEAD.len())
        .map(|c| rows.iter().map(|r| r[c].chars().count()).max().unwrap_or(0))
        .collect();
    let mut out = format!("{} ({})\n", study.title, study.name);
    for row in rows {
        let mut line = String::from(" ");
        for (cell, width) in row.iter().zip(&widths) {
            line.push_str(&format!(" {cell:<width$} "));
        }
        out.push_str(line.trim_end());
        out.push('\n');
    }
    for row in &result.rows {
        if let Some(message) = &row.message {
            out.push_str(&format!("  {}: {message}\n", row.run));
        }
    }
    out
}

/// One line for each study: its comparisons, how many hold, how many do not, its time; then the sum.
pub fn summary(studies: &[(&Study, &StudyResult, f64)]) -> String {
    let mut rows = vec![["study", "comparisons", "hold", "do not", "seconds"].map(str::to_owned)];
    let mut sum = (0, 0, 0.0);
    for (study, result, seconds) in studies {
        let count = |verdict| result.rows.iter().filter(|r| r.verdict == verdict).count();
        let (hold, fail) = (count(Verdict::Holds), count(Verdict::Fails));
        sum = (sum.0 + hold, sum.1 + fail, sum.2 + seconds);
        rows.push(counts(&study.name, hold, fail, *seconds));
    }
    rows.push(counts("all", sum.0, sum.1, sum.2));
    let width = |c: usize| rows.iter().map(|r| r[c].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..5).map(width).collect();
    let line = |row: &[String; 5]| {
        let first = format!("  {:<w$}", row[0], w = widths[0]);
        let rest = (1..5).map(|c| format!("  {:>w$}", row[c], w = widths[c]));
        first + &rest.collect::<String>() + "\n"
    };
    rows.iter().map(line).collect()
}

fn counts(name: &str, hold: usize, fail: usize, seconds: f64) -> [String; 5] {
    [
        name.to_owned(),
        (hold + fail).to_string(),
        hold.to_string(),
        fail.to_string(),
        format!("{seconds:.0}"),
    ]
}

/// All comparisons of all studies as CSV.
pub fn csv(studies: &[(&Study, &StudyResult, f64)]) -> String {
    let mut out = String::from(
        "study,run,quantity,published,ours,difference,tolerance,verdict,published_by\n",
    );
    for (study, result, _) in studies {
        for row in &result.rows {
            let [run, label, figures @ .., source] = cells(row);
            let mut fields = [&study.name, &run, &label].map(|t| text_field(t)).to_vec();
            // Differences and tolerances have signs and units: no texts of a user.
            fields.extend(figures.iter().map(|cell| quoted(cell)));
            fields.push(text_field(&source));
            out.push_str(&fields.join(","));
            out.push('\n');
        }
    }
    out
}

pub(super) fn cells(row: &Row) -> [String; 8] {
    let is_count = row.label == "Newton iterations" || row.label == "unknowns";
    let show = |v: f64| {
        if is_count {
            format!("{v:.0}")
        } else if row.is_share {
            share(v)
        } else {
            significant(v)
        }
    };
    let difference = row.reference.zip(row.ours).map(|(r, ours)| {
        if is_count {
            format!("{:+.0}", ours - r)
        } else if row.is_share {
            format!("{:+.2} points", 100.0 * (ours - r))
        } else if matches!(row.accept, Accept::Absolute(_)) || r == 0.0 {
            format!("{:+.1e}", ours - r)
        } else {
            format!("{:+.2} %", 100.0 * (ours / r - 1.0))
        }
    });
    [
        row.run.clone(),
        row.label.clone(),
        row.reference.map(show).unwrap_or_default(),
        row.ours.map(show).unwrap_or_default(),
        difference.unwrap_or_default(),
        tolerance(row.accept, row.is_share, is_count),
        match row.verdict {
            Verdict::Holds => "ok".to_owned(),
            Verdict::Fails => "NOT".to_owned(),
            Verdict::Shown => String::new(),
        },
        row.source.clone(),
    ]
}

pub(super) fn tolerance(accept: Accept, is_share: bool, is_count: bool) -> String {
    let show = |v: f64| {
        if is_share { share(v) } else { short(v) }
    };
    match accept {
        Accept::Relative(limit) => format!("{} %", short(100.0 * limit)),
        Accept::Absolute(limit) if is_count => format!("{limit:.0}"),
        Accept::Absolute(limit) => show(limit),
        Accept::AtMost(limit) => format!("at most {}", show(limit)),
        Accept::Between(low, high) => format!("{} to {}", show(low), show(high)),
        Accept::Sign => "sign".to_owned(),
        Accept::Anything => String::new(),
    }
}

fn share(v: f64) -> String {
    if v != 0.0 && v.abs() < 5e-5 {
        format!("{:.1e} %", 100.0 * v)
    } else {
        format!("{:.3} %", 100.0 * v)
    }
}

/// Few digits.
fn short(v: f64) -> String {
    let text = format!("{v:.4}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text.is_empty() || text == "0" || text == "-0" {
        format!("{v:.0e}")
    } else {
        text.to_owned()
    }
}

/// Five significant digits.
fn significant(v: f64) -> String {
    if v == 0.0 || !v.is_finite() {
        return format!("{v}");
    }
    let exponent = v.abs().log10().floor() as i32;
    if (-3..5).contains(&exponent) {
        format!("{v:.*}", usize::try_from(4 - exponent).unwrap_or(0))
    } else {
        format!("{v:.3e}")
    }
}
