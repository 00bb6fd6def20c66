//! Means, quantiles and correlations of the figures of a sampled study.

use crate::case::study::Study;
use crate::figures::{Definition, Row};
use crate::solution::Figure;
use crate::study::columns::{Column, titled};
use crate::study::journal::Record;

/// Probabilities of the quantiles.
pub const QUANTILES: [f64; 5] = [0.025, 0.25, 0.5, 0.75, 0.975];

/// Statistics of a sampled study.
#[derive(Clone, Debug, PartialEq)]
pub struct MonteCarlo {
    /// Samples.
    pub n: usize,
    /// Samples that were solved; the others count for nothing.
    pub n_solved: usize,
    /// Key paths of the inputs that were sampled.
    pub inputs: Vec<String>,
    /// The figures.
    pub figures: Vec<Distribution>,
}

/// A figure of samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sampled {
    /// That of a contact.
    Contact(Figure),
    /// That of a whole machine, or of a run in time.
    Machine {
        /// Its attributes.
        figure: Definition,
        /// SI unit.
        unit: &'static str,
    },
}

impl Sampled {
    /// Name in results.
    pub fn name(self) -> &'static str {
        match self {
            Sampled::Contact(figure) => figure.name(),
            Sampled::Machine { figure, .. } => figure.name,
        }
    }

    /// Title of its column in the table of the samples.
    fn title(self, is_line: bool) -> String {
        match self {
            Sampled::Contact(figure) => Column::of(figure).title(is_line),
            Sampled::Machine { figure, unit } => titled(figure.name, unit),
        }
    }
}

/// How a figure is distributed.
#[derive(Clone, Debug, PartialEq)]
pub struct Distribution {
    /// Which.
    pub figure: Sampled,
    /// Mean, SI.
    pub mean: f64,
    /// Standard deviation, SI.
    pub standard: f64,
    /// Standard error of the standard deviation, for a normal distribution: s/√(2(n − 1)).
    pub standard_error: f64,
    /// Quantiles of the probabilities 2.5, 25, 50, 75 and 97.5 %, SI.
    pub quantiles: [f64; 5],
    /// Coefficient of correlation with each input.
    pub correlations: Vec<f64>,
    /// The figure of each sample that was solved, SI.
    pub values: Vec<f64>,
}

impl MonteCarlo {
    /// Of a study whose points are samples of a contact, as far as they are finished.
    pub fn of(study: &Study, records: &[Option<Record>]) -> MonteCarlo {
        let figures = Figure::TRACED.into_iter().map(Sampled::Contact);
        MonteCarlo::of_figures(study, records, figures)
    }

    /// Of a study whose points are samples of a whole machine or of a case in time that has these figures.
    pub fn of_rows(study: &Study, records: &[Option<Record>], rows: &[Row]) -> MonteCarlo {
        let figures = rows.iter().map(|row| Sampled::Machine {
            figure: row.figure,
            unit: row.unit,
        });
        MonteCarlo::of_figures(study, records, figures)
    }

    fn of_figures(
        study: &Study,
        records: &[Option<Record>],
        figures: impl Iterator<Item = Sampled>,
    ) -> MonteCarlo {
        let solved: Vec<(usize, &Record)> = (records.iter().enumerate())
            .filter_map(|(i, record)| Some((i, record.as_ref().filter(|r| r.converged)?)))
            .collect();
        let is_line = (study.points.first()).is_some_and(|p| p.case.contact.kind.is_line());
        let of = |figure: Sampled| {
            let column = figure.title(is_line);
            let values: Vec<f64> = (solved.iter())
                .map(|(_, record)| record.field(&column)?.parse().ok())
                .collect::<Option<_>>()?;
            let varies = values.iter().any(|value| *value != values[0]);
            let input = |k: usize| -> Vec<f64> {
                let points = solved.iter().map(|(i, _)| &study.points[*i]);
                points
                    .map(|p| p.values[k].number().unwrap_or(f64::NAN))
                    .collect()
            };
            (values.len() > 1 && varies).then(|| {
                let (mean, standard) = moments(&values);
                let mut sorted = values.clone();
                sorted.sort_by(f64::total_cmp);
                Distribution {
                    figure,
                    mean,
                    standard,
                    standard_error: standard / (2.0 * (values.len() - 1) as f64).sqrt(),
                    quantiles: QUANTILES.map(|p| quantile(&sorted, p)),
                    correlations: (0..study.columns.len())
                        .map(|k| correlation(&input(k), &values))
                        .collect(),
                    values,
                }
            })
        };
        MonteCarlo {
            n: study.points.len(),
            n_solved: solved.len(),
            inputs: study
                .columns
                .iter()
                .map(|column| column.key.clone())
                .collect(),
            figures: figures.filter_map(of).collect(),
        }
    }
}

/// Mean and standard deviation of a sample.
fn moments(values: &[f64]) -> (f64, f64) {
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    let square: f64 = values.iter().map(|v| (v - mean).powi(2)).sum();
    (mean, (square / (n - 1.0)).sqrt())
}

/// Between the values that rise, at the place p(n − 1).
fn quantile(sorted: &[f64], probability: f64) -> f64 {
    let place = probability * (sorted.len() - 1) as f64;
    let below = sorted[place.floor() as usize];
    let above = sorted[place.ceil() as usize];
    below + place.fract() * (above - below)
}

/// Pearson's coefficient.
fn correlation(a: &[f64], b: &[f64]) -> f64 {
    let ((mean_a, dev_a), (mean_b, dev_b)) = (moments(a), moments(b));
    let products = a.iter().zip(b).map(|(x, y)| (x - mean_a) * (y - mean_b));
    products.sum::<f64>() / ((a.len() - 1) as f64 * dev_a * dev_b)
}

#[cfg(test)]
mod tests {
    use crate::near::near;
    use approx::assert_relative_eq;

    use super::*;

    /// By hand: 1, 2, 3, 4 has the mean 2.5, the variance 5/3 and the median 2.5; a straight line through them the coefficient −1.
    #[test]
    fn four_values_by_hand() {
        let values = [1.0, 2.0, 3.0, 4.0];
        let (mean, standard) = moments(&values);
        assert_relative_eq!(mean, 2.5);
        assert_relative_eq!(standard, (5.0_f64 / 3.0).sqrt());
        assert_relative_eq!(quantile(&values, 0.5), 2.5);
        assert_relative_eq!(quantile(&values, 0.025), 1.075);
        let line = values.map(|v| 7.0 - 2.0 * v);
        assert_relative_eq!(correlation(&values, &line), -1.0, max_relative = 1e-14);
        near(correlation(&values, &[1.0, 3.0, 2.0, 4.0]), 0.8, 1e-14);
    }
}
