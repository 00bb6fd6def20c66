//! A case solved by two methods: table and file.

use std::path::Path;

use super::OutputError;
use super::lines::{Lines, Table};
use super::results::value;
use crate::cross_check::{CrossCheck, Crossed, Verdict};
use crate::solution::Solution;
use crate::words::digits;

/// Name of the file in the result folder.
const FILE: &str = "cross-check.csv";

/// The figures of both methods as a table.
pub fn cross_check_report(solution: &Solution, found: &CrossCheck) -> String {
    let [own, other] = found.methods.map(|method| method.words());
    let mut out = Lines::default();
    out.heading(&format!("Cross-check by {other}"));
    let row = |crossed: &Crossed| {
        let text = |at| value(solution, crossed.figure, at);
        vec![
            crossed.figure.title(),
            text(&crossed.own),
            crossed.other.as_ref().map_or("–".to_owned(), text),
            crossed.verdict().words().to_owned(),
        ]
    };
    out.table(Table {
        head: ["", own, other, ""].map(str::to_owned).to_vec(),
        rows: found.figures.iter().map(row).collect(),
        widths: vec![(34, 0), (28, 2), (28, 2), (0, 0)],
    });
    let [agree, differ, open] =
        [Verdict::Agrees, Verdict::Differs, Verdict::NotResolved].map(|v| found.count(v));
    out.row(
        "figures",
        format!("{agree} agree within the sum of both error bars, {differ} differ, {open} are not resolved by both"),
    );
    let [first, second] = found.seconds.map(|s| digits(s, 3));
    out.row(
        "wall time",
        format!("{first} s by {own}, {second} s by {other}"),
    );
    out.text()
}

/// Writes the SI figures of both methods into an existing result folder.
///
/// # Errors
/// When the file cannot be written.
pub fn write_cross_check(
    solution: &Solution,
    found: &CrossCheck,
    folder: &Path,
) -> Result<(), OutputError> {
    let names = found.methods.map(|method| method.name().replace('-', "_"));
    let mut text = format!(
        "figure,unit,{0},{0}_bar,{1},{1}_bar,verdict\n",
        names[0], names[1]
    );
    let number = |value: Option<f64>| value.map_or(String::new(), |v| format!("{v:e}"));
    for crossed in &found.figures {
        let cells = [
            crossed.figure.name().to_owned(),
            crossed.figure.unit(solution.shape.is_line()).to_owned(),
            number(Some(crossed.own.value)),
            number(crossed.own.error),
            number(crossed.other.map(|other| other.value)),
            number(crossed.other.and_then(|other| other.error)),
            crossed.verdict().words().to_owned(),
        ];
        text += &cells.join(",");
        text.push('\n');
    }
    let path = folder.join(FILE);
    std::fs::write(&path, text).map_err(|error| OutputError::io(&path, error))
}
