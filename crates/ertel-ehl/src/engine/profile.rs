//! The centreline y = 0 and its figures, dimensionless.

use super::PointFields;

/// Fields along the centreline, X ascending.
#[derive(Clone, Debug, Default)]
pub struct Profile {
    /// X.
    pub x: Vec<f64>,
    /// Fields at each X.
    pub fields: Vec<PointFields>,
}

/// Where a layer of oil fills the gap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Meniscus {
    /// X from which on it is full.
    pub place: f64,
    /// Error of `place` on its grid, in addition to the error shown by finer grids.
    pub misfit: f64,
}

/// Depth, in p_h, of a dip that sets a spike apart from the rest of the profile.
const SPIKE_DEPTH: f64 = 2e-3;

impl Profile {
    /// Smallest film thickness and its X.
    pub fn film_minimum(&self) -> (f64, f64) {
        self.extreme(|f| -f.film)
            .map_or((f64::NAN, f64::NAN), |i| (self.fields[i].film, self.x[i]))
    }

    /// Where the film breaks: the first X downstream of the largest pressure with P ≤ 0, between
    /// samples by linear interpolation, or where a layer of oil no longer fills the gap; the last X if there is none.
    pub fn outlet(&self) -> f64 {
        let Some(top) = self.extreme(|f| f.pressure) else {
            return f64::NAN;
        };
        for i in top.max(1)..self.x.len() {
            let (p0, p1) = (self.fields[i - 1].pressure, self.fields[i].pressure);
            if p1 <= 0.0 && p0 > 0.0 {
                return self.x[i - 1] + (self.x[i] - self.x[i - 1]) * p0 / (p0 - p1);
            }
            if self.fields[i].missing > 0.0 {
                return self.x[i];
            }
        }
        self.x.last().copied().unwrap_or(f64::NAN)
    }

    /// Start of the filled gap behind a layer of oil: the pressure in front of the place where the gap fills up
    /// decays as it would to zero from the meniscus, where the gap is filled by 1/e. `None` where it is full everywhere.
    pub fn meniscus(&self, layer: f64) -> Option<Meniscus> {
        let full = 1.0 - (-1.0_f64).exp();
        let i = self.last_lacking(layer, full)?;
        let [here, next] = [i, i + 1].map(|i| self.lacking(layer, i));
        Some(Meniscus {
            place: self.x[i] + (self.x[i + 1] - self.x[i]) * (here - full) / (here - next),
            misfit: 0.0,
        })
    }

    /// The same where the content of each node follows from balances: the missing oil of the last node before the meniscus is the empty share of the
    /// distance to the next one. Accurate to half of that distance.
    pub fn meniscus_of_contents(&self, layer: f64) -> Option<Meniscus> {
        let i = self.last_lacking(layer, 0.0)?;
        let distance = self.x[i + 1] - self.x[i];
        Some(Meniscus {
            place: self.x[i] + distance * self.lacking(layer, i).min(1.0),
            misfit: 0.5 * distance,
        })
    }

    /// The last sample before the centre whose missing oil exceeds a share of that under the layer alone.
    fn last_lacking(&self, layer: f64, share: f64) -> Option<usize> {
        let centre = self.x.iter().position(|x| *x >= 0.0)?;
        (0..centre).rev().find(|i| self.lacking(layer, *i) > share)
    }

    /// Missing oil of a sample, over that under the layer alone.
    fn lacking(&self, layer: f64, i: usize) -> f64 {
        let f = &self.fields[i];
        match f.flowing() > layer {
            true => f.missing / (f.flowing() - layer),
            false => 0.0,
        }
    }

    /// Pressure spike: between the centre and the outlet, the highest pressure behind a dip that
    /// lies at least 0.2 % of p_h below it and below the pressures before it.
    pub fn spike(&self) -> Option<(f64, f64)> {
        let p = |i: usize| self.fields[i].total_pressure();
        let outlet = self.outlet();
        let end = self.x.iter().position(|x| *x >= outlet)?;
        let start = self.x.iter().position(|x| *x >= 0.0)?;
        let (mut top, mut dip) = (f64::NEG_INFINITY, f64::INFINITY);
        let mut spike: Option<usize> = None;
        for i in start..end {
            if p(i) < top - SPIKE_DEPTH {
                dip = dip.min(p(i));
            }
            if dip.is_finite() && p(i) > dip + SPIKE_DEPTH && spike.is_none_or(|s| p(i) > p(s)) {
                spike = Some(i);
            }
            top = top.max(p(i));
        }
        spike.map(|i| (p(i), self.x[i]))
    }

    fn extreme(&self, score: impl Fn(&PointFields) -> f64) -> Option<usize> {
        (0..self.x.len()).max_by(|i, j| score(&self.fields[*i]).total_cmp(&score(&self.fields[*j])))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// P = 1 − X² + 0.4 exp(−((X − 0.8)/0.03)²), minus 0.3 to end the film where that is zero.
    fn profile(bump: f64) -> Profile {
        let x: Vec<f64> = (0..=3000).map(|i| -1.5 + i as f64 * 1e-3).collect();
        let fields = x
            .iter()
            .map(|x| PointFields {
                place: [*x, 0.0],
                pressure: 0.7 - x * x + bump * (-((x - 0.8) / 0.03).powi(2)).exp(),
                film: 0.1 + 0.02 * (x - 0.5_f64).powi(2),
                ..PointFields::default()
            })
            .collect();
        Profile { x, fields }
    }

    /// By hand: the spike's top near 0.7 − 0.64 + 0.4 at X = 0.8; without the bump the film ends
    /// at √0.7 and there is no spike; the film is thinnest at 0.5.
    #[test]
    fn spike_outlet_and_minimum_of_a_made_up_profile() {
        let (p, x) = profile(0.4).spike().unwrap();
        assert_relative_eq!(p, 0.46, max_relative = 0.01);
        assert_relative_eq!(x, 0.8, epsilon = 3e-3);
        assert_eq!(profile(0.0).spike(), None);
        assert_relative_eq!(profile(0.0).outlet(), 0.7_f64.sqrt(), epsilon = 1e-6);
        assert_relative_eq!(profile(0.0).film_minimum().1, 0.5, epsilon = 1e-9);
    }
}
