//! Measured figures compared with those of the study's points.

use ertel_quantity::Dimension;

use super::{Compared, Measurand, Measured, Measurement, N_MEASURANDS, Statistics};
use crate::case::study::AxisValue;
use crate::solution::Estimate;
use crate::study::journal::Record;
use crate::study::titled;

/// Measurements with the results at their points.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// Title of the case.
    pub title: String,
    /// Titles of the columns that vary: the key, and the SI unit, `contact.load_N`.
    pub columns: Vec<String>,
    /// Quantities of these columns; `None` for names.
    pub dimensions: Vec<Option<Dimension>>,
    /// The rows, in the order of the table.
    pub rows: Vec<ComparedRow>,
    /// Points that were to be solved.
    pub n_points: usize,
    /// Omissions from the table and assumptions about it.
    pub notes: Vec<String>,
}

/// A row of the table with its point.
#[derive(Clone, Debug)]
pub struct ComparedRow {
    /// Line of the table, from 1.
    pub line: usize,
    /// Number of the point, from 0.
    pub point: usize,
    /// Values of the columns, SI.
    pub values: Vec<AxisValue>,
    /// Outcome of the point.
    pub outcome: Outcome,
    /// The figures, in the order of [`Measurand::ALL`]; `None` where nothing was measured.
    pub figures: [Option<Compared>; N_MEASURANDS],
}

/// Outcome of a point.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome {
    /// Solved; the figures that the mesh does not resolve, as the table of the study names them.
    Solved {
        /// Names of these figures; empty where all are resolved.
        unresolved: String,
    },
    /// Not solved; why.
    Failed(String),
    /// Not begun: the run was stopped.
    Open,
}

/// Whether something was measured that depends on the traction: all but films.
fn measured_friction(figures: &[Option<Measurement>; N_MEASURANDS]) -> bool {
    let mut of = Measurand::ALL.iter().zip(figures);
    of.any(|(figure, measured)| !figure.is_film() && measured.is_some())
}

/// Names of figures that are not resolved, without the traction where none was measured: films do not depend on it.
fn that_counts(names: &str, traction_was_measured: bool) -> String {
    let counts = |name: &&str| traction_was_measured || *name != "traction_coefficient";
    let names: Vec<&str> = names.split_whitespace().filter(counts).collect();
    names.join(" ")
}

impl Comparison {
    /// How many points have figures that are not resolved and that the comparison needs.
    pub fn n_unresolved(&self) -> usize {
        let is_open = |row: &&ComparedRow| matches!(&row.outcome, Outcome::Solved { unresolved } if !unresolved.is_empty());
        let points = self.rows.iter().filter(is_open).map(|row| row.point);
        points.collect::<std::collections::BTreeSet<_>>().len()
    }

    /// Joins the rows of a table with the records of its points from `study::finished_points`.
    pub fn new(measured: &Measured, records: &[Option<Record>]) -> Self {
        let study = &measured.study;
        let rows = measured.rows.iter().map(|row| {
            let record = records.get(row.point).and_then(Option::as_ref);
            ComparedRow {
                line: row.line,
                point: row.point,
                values: study.points[row.point].values.clone(),
                outcome: match record {
                    None => Outcome::Open,
                    Some(record) if !record.converged => Outcome::Failed(record.reason.clone()),
                    Some(record) => Outcome::Solved {
                        unresolved: that_counts(
                            record.field("unresolved").unwrap_or_default(),
                            measured_friction(&row.figures),
                        ),
                    },
                },
                figures: Measurand::ALL.map(|figure| {
                    let measured = row.figures[figure as usize]?;
                    let computed = record.and_then(|record| estimate(record, figure));
                    Some(Compared { measured, computed })
                }),
            }
        });
        let first = study.points.first();
        Self {
            title: study.title.clone(),
            columns: study.columns.iter().map(|c| c.header.clone()).collect(),
            dimensions: first.map_or(Vec::new(), |point| {
                let dimension = |value: &AxisValue| match value {
                    AxisValue::Number(_, dimension) => Some(*dimension),
                    AxisValue::Text(_) => None,
                };
                point.values.iter().map(dimension).collect()
            }),
            rows: rows.collect(),
            n_points: study.points.len(),
            notes: measured.notes.clone(),
        }
    }

    /// Figures that the table has.
    pub fn figures(&self) -> impl Iterator<Item = Measurand> + '_ {
        (Measurand::ALL.into_iter())
            .filter(|f| self.rows.iter().any(|r| r.figures[*f as usize].is_some()))
    }

    /// How well a figure is met over all rows.
    pub fn statistics(&self, figure: Measurand) -> Statistics {
        let figures = self.rows.iter().map(|row| row.figures[figure as usize]);
        Statistics::of(&figures.collect::<Vec<_>>())
    }

    /// Rows without a solution.
    pub fn n_unsolved(&self) -> usize {
        let is_solved = |row: &&ComparedRow| !matches!(row.outcome, Outcome::Solved { .. });
        self.rows.iter().filter(is_solved).count()
    }
}

/// A figure of a solved point.
fn estimate(record: &Record, figure: Measurand) -> Option<Estimate> {
    let number = |name: &str| {
        let field = record.field(&titled(name, figure.unit()))?;
        field.parse::<f64>().ok()
    };
    Some(Estimate {
        value: number(figure.name())?,
        error: number(&format!("{}_error", figure.name())),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An unmeasured traction does not affect a comparison of films; films always count.
    #[test]
    fn a_traction_counts_where_it_was_measured() {
        let names = "film_minimum traction_coefficient";
        assert_eq!(that_counts(names, false), "film_minimum");
        assert_eq!(that_counts(names, true), names);
        assert_eq!(that_counts("traction_coefficient", false), "");
    }
}
