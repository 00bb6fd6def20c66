//! Lives relative to that of a reference contact.
//!
//! ```text
//!   ln(1/S) ~ N^e ∫ (τ − τ_u)^c / z^h dV      c = 31/3, h = 7/3, e = 10/9 of point contacts, 9/8 of lines
//! ```
//! Lundberg and Palmgren (1947) with the largest half range τ_0 of the orthogonal shear and its depth z_0, ln(1/S) ~ N^e τ_0^c/z_0^(h−1);
//! the volume integral and the fatigue limit τ_u after Ioannides and Harris (1985). Lives are relative to a reference contact: the constants of
//! proportion are those of a steel and a test and are not known here.

use serde::Serialize;

use super::Depths;
use super::load::{Level, RowShear};

/// Exponent of the stress.
const STRESS_EXPONENT: f64 = 31.0 / 3.0;
/// Exponent of the depth.
const DEPTH_EXPONENT: f64 = 7.0 / 3.0;
/// Weibull's exponent of point contacts and of lines.
const WEIBULL: [f64; 2] = [10.0 / 9.0, 9.0 / 8.0];

/// The stress that decides over fatigue.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Criterion {
    /// Half the range of σ_xz over a passage.
    HalfRangeOfOrthogonalShear,
    /// Largest shear stress in the plane of motion over a passage.
    LargestShear,
}

impl Criterion {
    /// Both.
    pub const ALL: [Criterion; 2] = [
        Criterion::HalfRangeOfOrthogonalShear,
        Criterion::LargestShear,
    ];

    /// In words.
    pub fn words(self) -> &'static str {
        match self {
            Criterion::HalfRangeOfOrthogonalShear => "half range of orthogonal shear",
            Criterion::LargestShear => "largest shear",
        }
    }

    fn of(self, row: &RowShear) -> f64 {
        match self {
            Criterion::HalfRangeOfOrthogonalShear => row.half_range,
            Criterion::LargestShear => row.largest,
        }
    }
}

/// The levels of a body and their depths, from which lives are computed.
#[derive(Clone, Copy)]
pub struct Volume<'a> {
    /// Depths of the levels.
    pub depths: &'a Depths,
    /// The levels.
    pub levels: &'a [Level],
    /// Whether the contact is a line or a roller.
    pub is_line: bool,
    /// Depth from which it is counted: layers are not.
    pub top: f64,
}

impl Volume<'_> {
    fn weibull(&self) -> f64 {
        WEIBULL[usize::from(self.is_line)]
    }

    /// Exponent of the stress in a life.
    pub(super) fn stress_exponent(&self) -> f64 {
        STRESS_EXPONENT / self.weibull()
    }

    /// ∫∫ (τ − τ_u)^c/z^h dz dy below a depth, up to a factor of the grid.
    fn integral(&self, criterion: Criterion, cut: f64, limit: f64) -> f64 {
        let rows = self.levels.first().map_or(0, |level| level.rows.len());
        (0..rows)
            .map(|j| {
                let values: Vec<f64> = (self.levels.iter())
                    .map(|level| criterion.of(&level.rows[j]))
                    .collect();
                self.depths.integral(cut.max(self.top), &values, |z, v| {
                    (v - limit).max(0.0).powf(STRESS_EXPONENT) / z.powf(DEPTH_EXPONENT)
                })
            })
            .sum()
    }

    /// Life over that of a reference contact without fatigue limit, by the volume integral below a depth; `None` if no stress exceeds the limit.
    pub fn integral_life(
        &self,
        reference: &Volume<'_>,
        criterion: Criterion,
        cut: f64,
        limit: f64,
    ) -> Option<f64> {
        let own = self.integral(criterion, cut, limit);
        let other = reference.integral(criterion, cut, 0.0);
        (own > 0.0).then(|| (other / own).powf(1.0 / self.weibull()))
    }

    /// The largest value of a criterion below a depth, and its depth.
    pub fn largest(&self, criterion: Criterion, cut: f64) -> [f64; 2] {
        let worst = |level: &Level| {
            let rows = level.rows.iter().map(|row| criterion.of(row));
            rows.fold(0.0, f64::max)
        };
        let values: Vec<f64> = self.levels.iter().map(worst).collect();
        let cut = cut.max(self.top);
        let (value, index) = self.depths.largest(cut, |i| values[i]);
        let at_cut = self.depths.value(cut, &values);
        match at_cut > value {
            true => [at_cut, cut],
            false => [value, self.depths.at(index)],
        }
    }

    /// Life over that of a reference contact, by the largest stress and its depth below the cut.
    pub fn stress_life(&self, reference: &Volume<'_>, criterion: Criterion, cut: f64) -> f64 {
        let [own, depth] = self.largest(criterion, cut);
        let [other, other_depth] = reference.largest(criterion, cut);
        let risk =
            (own / other).powf(STRESS_EXPONENT) * (other_depth / depth).powf(DEPTH_EXPONENT - 1.0);
        risk.powf(-1.0 / self.weibull())
    }
}

/// τ_0/p_0 and z_0 over the minor semi-axis of an ellipse that rolls along its minor semi-axis, from the ratio of minor to major semi-axis; 0: a line.
///
/// ```text
///   b/a = √((t² − 1)(2t − 1)),   τ_0/p_0 = √(2t − 1)/(2t(t + 1)),   z_0/b = 1/((t + 1)√(2t − 1))
/// ```
/// Source: Lundberg and Palmgren 1947.
pub fn lundberg_palmgren(minor_over_major: f64) -> [f64; 2] {
    let ratio = |t: f64| ((t * t - 1.0) * (2.0 * t - 1.0)).sqrt();
    let (mut low, mut high) = (1.0, 2.0);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        match ratio(middle) < minor_over_major {
            true => low = middle,
            false => high = middle,
        }
    }
    let root = (2.0 * low - 1.0).sqrt();
    [root / (2.0 * low * (low + 1.0)), 1.0 / ((low + 1.0) * root)]
}
