//! How well computed figures meet measured ones.

use serde::Serialize;

use super::Compared;

/// Relative differences d = computed/measured - 1 over the rows of a table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Statistics {
    /// Rows with a measured value.
    pub n_measured: usize,
    /// Of these, rows with a solution, whose measured value is not zero.
    pub n_compared: usize,
    /// Mean of d, 1/n Σ d; `None` without rows.
    pub bias: Option<f64>,
    /// √(1/n Σ d²).
    pub rms: Option<f64>,
    /// The largest |d|, with its sign.
    pub worst: Option<f64>,
    /// Its row, from 0.
    pub worst_row: Option<usize>,
    /// Rows whose measurement has an uncertainty.
    pub n_with_uncertainty: usize,
    /// Rows with a solution and an uncertainty, of the measurement or of the calculation.
    pub n_judged: usize,
    /// Of these, rows where both agree within √(u² + e²).
    pub n_within: usize,
}

impl Statistics {
    /// Over all rows; `None` where a row has nothing measured.
    pub fn of(rows: &[Option<Compared>]) -> Self {
        let mut statistics = Self::default();
        let (mut sum, mut squares) = (0.0, 0.0);
        for (i, compared) in rows.iter().enumerate() {
            let Some(compared) = compared else { continue };
            statistics.n_measured += 1;
            statistics.n_with_uncertainty += usize::from(compared.measured.uncertainty.is_some());
            if let Some(is_within) = compared.is_within() {
                statistics.n_judged += 1;
                statistics.n_within += usize::from(is_within);
            }
            let Some(difference) = compared.difference() else {
                continue;
            };
            statistics.n_compared += 1;
            sum += difference;
            squares += difference * difference;
            if statistics
                .worst
                .is_none_or(|worst| difference.abs() > worst.abs())
            {
                statistics.worst = Some(difference);
                statistics.worst_row = Some(i);
            }
        }
        if statistics.n_compared > 0 {
            let n = statistics.n_compared as f64;
            statistics.bias = Some(sum / n);
            statistics.rms = Some((squares / n).sqrt());
        }
        statistics
    }
}
