//! How well computed figures meet measured ones.

use serde::Serialize;

use super::Measurement;
use crate::solution::Estimate;

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

/// A figure measured and computed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Compared {
    /// As measured.
    pub measured: Measurement,
    /// As computed; `None` where the point has no solution.
    pub computed: Option<Estimate>,
}

impl Compared {
    /// computed/measured - 1; `None` without a solution, and of a measured value of zero. Tractions are compared by their size,
    /// since rigs report no sign.
    pub fn difference(&self) -> Option<f64> {
        let (computed, measured) = (self.computed?.value.abs(), self.measured.value.abs());
        (measured > 0.0).then(|| computed / measured - 1.0)
    }

    /// Uncertainty of the difference of both, √(u² + e²) of the measurement's u and the error bar e of the calculation (ASME V&V
    /// 20-2009, section 1-5, without the uncertainty of the inputs, which a table does not contain); unknown uncertainties count as zero.
    /// `None` where neither is known.
    pub fn uncertainty(&self) -> Option<f64> {
        let error = self.computed.and_then(|computed| computed.error);
        match (self.measured.uncertainty, error) {
            (None, None) => None,
            (u, e) => Some(u.unwrap_or(0.0).hypot(e.unwrap_or(0.0))),
        }
    }

    /// Whether both agree within their uncertainty; `None` without a solution, or without any uncertainty.
    pub fn is_within(&self) -> Option<bool> {
        let off = (self.computed?.value.abs() - self.measured.value.abs()).abs();
        Some(off <= self.uncertainty()?)
    }
}
