//! The centreline y = 0 and what is read off it, dimensionless.

use crate::solve::discretisation::Discretisation;
use crate::solve::evaluate::{PointFields, fields_at};
use crate::solve::system::State;

/// Fields along the centreline, X ascending.
#[derive(Clone, Debug, Default)]
pub struct Profile {
    /// X.
    pub x: Vec<f64>,
    /// Fields at each X.
    pub fields: Vec<PointFields>,
}

impl Profile {
    /// Samples every element edge on the centreline at `per_edge` intervals.
    pub fn new(d: &Discretisation, state: &State, per_edge: usize) -> Profile {
        let mut knots: Vec<f64> = d
            .contact
            .surface
            .vertices
            .iter()
            .filter(|v| v[1].abs() < 1e-12)
            .map(|v| v[0])
            .collect();
        knots.sort_by(f64::total_cmp);
        let mut x = Vec::new();
        for pair in knots.windows(2) {
            x.extend(
                (0..per_edge).map(|i| pair[0] + (pair[1] - pair[0]) * i as f64 / per_edge as f64),
            );
        }
        x.extend(knots.last());
        let mut profile = Profile::default();
        for x in x {
            if let Some(f) = fields_at(d, state, [x, 0.0]) {
                profile.x.push(x);
                profile.fields.push(f);
            }
        }
        profile
    }

    /// Smallest film thickness and its X.
    pub fn film_minimum(&self) -> (f64, f64) {
        self.extreme(|f| -f.film)
            .map_or((f64::NAN, f64::NAN), |i| (self.fields[i].film, self.x[i]))
    }

    /// Where the film breaks: the first X downstream of the largest pressure with P ≤ 0, between
    /// samples by linear interpolation; the last X if there is none.
    pub fn outlet(&self) -> f64 {
        let Some(top) = self.extreme(|f| f.pressure) else {
            return f64::NAN;
        };
        for i in top.max(1)..self.x.len() {
            let (p0, p1) = (self.fields[i - 1].pressure, self.fields[i].pressure);
            if p1 <= 0.0 && p0 > 0.0 {
                return self.x[i - 1] + (self.x[i] - self.x[i - 1]) * p0 / (p0 - p1);
            }
        }
        self.x.last().copied().unwrap_or(f64::NAN)
    }

    /// Pressure spike: the last local maximum before the outlet that stands behind a dip at least
    /// 0.2 % of p_h below it, downstream of the centre.
    pub fn spike(&self) -> Option<(f64, f64)> {
        let p = |i: usize| self.fields[i].pressure;
        let end = self.x.iter().position(|x| *x >= self.outlet())?;
        let start = self.x.iter().position(|x| *x >= 0.0)?;
        let (mut dip, mut spike): (f64, Option<usize>) = (f64::INFINITY, None);
        for i in start..end {
            dip = dip.min(p(i));
            if p(i) > dip + 2e-3 && spike.is_none_or(|s| p(i) > p(s)) {
                spike = Some(i);
            }
        }
        spike.map(|i| (p(i), self.x[i]))
    }

    fn extreme(&self, score: impl Fn(&PointFields) -> f64) -> Option<usize> {
        (0..self.x.len()).max_by(|i, j| score(&self.fields[*i]).total_cmp(&score(&self.fields[*j])))
    }
}
