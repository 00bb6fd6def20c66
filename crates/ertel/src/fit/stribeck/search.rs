//! The smallest sum of squares over the constants of rough surfaces.
//!
//! ```text
//!   S(x, f_b) = Σ [(f_i(x) + f_b a_i(x) − m_i)/w_i]²
//!   f_b(x) = Σ a_i (m_i − f_i)/w_i² / Σ a_i²/w_i²                        where S is smallest at given x
//! ```
//! f_i is the friction of the film, a_i that of the asperities over f_b, m_i the measured friction. As f_b follows from x, only x is searched (variable projection:
//! Golub and Pereyra 1973, SIAM J. Numer. Anal. 10, 413-432).

use super::found::FittedPoint;
use super::surrogate::{Range, Surrogate};
use crate::case::Study;
use crate::fit::least_squares::{Minimum, MinimumError, evaluated};

/// Friction of asperities over their load, as case files may have it.
const BOUNDARY_FRICTION: [f64; 2] = [0.0, 2.0];
/// Places per unknown of a lattice, and how often it is refined by the factor `FINER`: places to 1e-5 of the range.
const PLACES: usize = 41;
const REFINEMENTS: usize = 5;
const FINER: f64 = 0.1;
/// By how much a place must be better than those nearer to the middle of the range.
const BETTER: f64 = 1e-9;

/// A measured friction coefficient.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Reading {
    /// Line of the table, from 1.
    pub line: usize,
    /// Number of the point.
    pub point: usize,
    /// Size of the friction coefficient.
    pub measured: f64,
    /// Its uncertainty, or 1 for all.
    pub width: f64,
}

/// Film and asperities of each point over the searched unknowns: functions 2i and 2i + 1 of the polynomials are f and a of point i.
#[derive(Clone, Debug)]
pub(super) struct Model<'a> {
    pub friction: Surrogate,
    pub readings: &'a [Reading],
}

impl Model<'_> {
    /// f_b and S at x.
    fn projected(&self, x: &[f64]) -> [f64; 2] {
        let parts = self.friction.at(x);
        let (mut moment, mut square) = (0.0, 0.0);
        for of in self.readings {
            let (film, share) = (parts[2 * of.point], parts[2 * of.point + 1]);
            let weight = of.width.powi(-2);
            moment += weight * share * (of.measured - film);
            square += weight * share * share;
        }
        let [least, most] = BOUNDARY_FRICTION;
        let friction = match square > 0.0 {
            true => (moment / square).clamp(least, most),
            false => least,
        };
        let residuals = self.residuals(friction, x);
        [friction, residuals.iter().map(|r| r * r).sum()]
    }

    /// Calculated less measured friction over the uncertainty, by reading.
    fn residuals(&self, friction: f64, x: &[f64]) -> Vec<f64> {
        let parts = self.friction.at(x);
        let of = |of: &Reading| {
            let sum = parts[2 * of.point] + friction * parts[2 * of.point + 1];
            (sum - of.measured) / of.width
        };
        self.readings.iter().map(of).collect()
    }

    /// The readings with the fitted friction.
    pub(super) fn points(&self, study: &Study, friction: f64, x: &[f64]) -> Vec<FittedPoint> {
        let parts = self.friction.at(x);
        let of = |of: &Reading| {
            let asperities = friction * parts[2 * of.point + 1];
            FittedPoint {
                line: of.line,
                label: study.points[of.point].label.clone(),
                measured: of.measured,
                fitted: parts[2 * of.point] + asperities,
                asperities,
            }
        };
        self.readings.iter().map(of).collect()
    }

    /// f_b and x of the smallest S in a range.
    pub(super) fn search(&self, range: &Range) -> (f64, Vec<f64>) {
        let mut places: Vec<f64> = (0..PLACES)
            .map(|i| 2.0 * i as f64 / (PLACES - 1) as f64 - 1.0)
            .collect();
        // From the middle outwards: where the data determine nothing, nothing moves.
        places.sort_by(|a, b| a.abs().total_cmp(&b.abs()));
        let mut own = range.clone();
        let [mut friction, mut least] = self.projected(&own.centre);
        for _ in 0..REFINEMENTS {
            let middle = own.clone();
            for x in middle.lattice(&places) {
                let is_within = range.place(&x).iter().all(|t| t.abs() <= 1.0);
                let [of, sum] = self.projected(&x);
                if is_within && sum < least * (1.0 - BETTER) {
                    (friction, least) = (of, sum);
                    own.centre = x;
                }
            }
            own.half_width *= FINER;
        }
        (friction, own.centre)
    }

    /// How well f_b and x are known. Unknowns without influence are left out: `None` for them, else their place in the minimum.
    pub(super) fn uncertainty(
        &self,
        friction: f64,
        x: &[f64],
    ) -> Result<(Minimum, Vec<Option<usize>>), MinimumError> {
        let mut all = vec![friction];
        all.extend(x);
        let mut kept: Vec<usize> = (0..all.len()).collect();
        loop {
            let start: Vec<f64> = kept.iter().map(|i| all[*i]).collect();
            let residuals = |own: &[f64], r: &mut [f64]| {
                let mut at = all.clone();
                for (i, value) in kept.iter().zip(own) {
                    at[*i] = *value;
                }
                r.copy_from_slice(&self.residuals(at[0], &at[1..]));
            };
            match evaluated(self.readings.len(), start, 0.95, residuals) {
                Err(MinimumError::NoInfluence(lost)) => {
                    kept.remove(lost);
                }
                Err(error) => return Err(error),
                Ok(minimum) => {
                    let place = |i: usize| kept.iter().position(|own| *own == i);
                    return Ok((minimum, (0..all.len()).map(place).collect()));
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Film e^x u and share e^(−u e^(−x)) at some speeds u, as polynomials over x.
    fn friction(range: &Range, speeds: &[f64]) -> Surrogate {
        let nodes = range.nodes(9);
        let of = |x: &Vec<f64>| {
            let both = |u: &f64| [0.01 * u, (-u * (-x[0]).exp()).exp()];
            speeds.iter().flat_map(both).collect()
        };
        let values: Vec<Vec<f64>> = nodes.iter().map(of).collect();
        Surrogate::new(range, 7, &nodes, &values).unwrap()
    }

    fn readings(speeds: &[f64], measured: impl Fn(f64) -> f64) -> Vec<Reading> {
        let of = |(point, u): (usize, &f64)| Reading {
            line: point + 2,
            point,
            measured: measured(*u),
            width: 1.0,
        };
        speeds.iter().enumerate().map(of).collect()
    }

    /// Exact data give the constants back; a share that is the same at all speeds leaves x without influence, but not f_b.
    #[test]
    fn exact_data_give_their_constants() {
        let range = Range {
            centre: vec![0.2],
            half_width: 0.5,
        };
        let speeds = [0.1, 0.3, 1.0, 2.0, 3.0];
        let data = readings(&speeds, |u| 0.01 * u + 0.12 * (-u).exp());
        let model = Model {
            friction: friction(&range, &speeds),
            readings: &data,
        };
        let (boundary, x) = model.search(&range);
        assert_relative_eq!(boundary, 0.12, max_relative = 1e-4);
        assert!(x[0].abs() < 1e-4, "{x:?}");
        let (minimum, places) = model.uncertainty(boundary, &x).unwrap();
        assert_eq!(places, [Some(0), Some(1)]);
        assert!(minimum.standard(1) < 1e-3);

        let nodes = range.nodes(4);
        let flat: Vec<Vec<f64>> = nodes.iter().map(|_| [0.0, 1.0].repeat(5)).collect();
        let model = Model {
            friction: Surrogate::new(&range, 2, &nodes, &flat).unwrap(),
            readings: &readings(&speeds, |u| 0.1 + 0.001 * u),
        };
        let (boundary, x) = model.search(&range);
        assert_eq!(x, range.centre);
        // The mean: 0.1 + 0.001 · 6.4/5; its standard error is the scatter over √5.
        assert_relative_eq!(boundary, 0.10128, max_relative = 1e-12);
        let (minimum, places) = model.uncertainty(boundary, &x).unwrap();
        assert_eq!(places, [Some(0), None]);
        let expected = minimum.scatter / 5f64.sqrt();
        assert_relative_eq!(minimum.standard(0), expected, max_relative = 1e-6);
    }
}
