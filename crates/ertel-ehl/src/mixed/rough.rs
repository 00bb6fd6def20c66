//! The local laws of rough surfaces in dimensionless variables: asperity pressure and gap over the distance of the mean planes.

use super::statistics::{mean_gap, share_apart};
use super::table::five_halves;
use super::{Asperities, Flow};
use crate::contact::Scales;

/// Two rough surfaces, in the variables of the film equation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rough {
    /// σ, in a²/R.
    pub rms_height: f64,
    /// κ, in p_h.
    pub stiffness: f64,
    /// Where the oil flows.
    pub flow: Flow,
    /// f_b, if given.
    pub boundary_friction: Option<f64>,
}

/// Width in σ over which the distance h₊ as the gap that flows is rounded at zero: a kink makes the active set cycle.
const ROUNDED: f64 = 1e-4;

/// u from which the mean gap is the distance to the last digit.
const APART: f64 = 9.0;

/// The smallest distance for relative changes, in σ.
const LEAST_GAP: f64 = 0.05;

/// Asperity pressure of the start at the centre, in p_h: from thicker films Newton's method overshoots, since it sees no asperities there.
const PRESSURE_OF_START: f64 = 0.3;

impl Rough {
    /// Of asperities with the composite rms height σ in m; `reduced_modulus` is E' in Pa.
    pub fn new(
        asperities: &Asperities,
        rms_height: f64,
        reduced_modulus: f64,
        scales: &Scales,
    ) -> Rough {
        Rough {
            rms_height: rms_height / scales.film,
            stiffness: asperities.stiffness(reduced_modulus) / scales.pressure,
            flow: asperities.flow,
            boundary_friction: asperities.boundary_friction_coefficient,
        }
    }

    /// p_a at a distance H of the mean planes, and its derivative.
    #[inline]
    pub fn pressure(&self, distance: f64) -> [f64; 2] {
        let [value, slope] = five_halves(distance / self.rms_height);
        [
            self.stiffness * value,
            self.stiffness * slope / self.rms_height,
        ]
    }

    /// h_T and its derivative, the share Φ of the area that is apart.
    #[inline]
    pub fn mean_gap(&self, distance: f64) -> [f64; 2] {
        let u = distance / self.rms_height;
        match u < APART {
            true => [self.rms_height * mean_gap(u), share_apart(u)],
            false => [distance, 1.0],
        }
    }

    /// The gap that flows, and its derivative.
    #[inline]
    pub fn gap(&self, distance: f64) -> [f64; 2] {
        match self.flow {
            Flow::AverageGap => self.mean_gap(distance),
            Flow::Distance => {
                let rounded = distance.hypot(ROUNDED * self.rms_height);
                let gap = match distance > 0.0 {
                    true => 0.5 * (rounded + distance),
                    // Without cancellation.
                    false => 0.5 * (ROUNDED * self.rms_height).powi(2) / (rounded - distance),
                };
                [gap, gap / rounded]
            }
        }
    }

    /// Smallest gap for relative changes: where no oil flows, the distance as the gap that flows vanishes.
    pub fn least_gap(&self) -> f64 {
        match self.flow {
            Flow::AverageGap => 0.0,
            Flow::Distance => LEAST_GAP * self.rms_height,
        }
    }

    /// The smallest film of a start.
    pub fn least_start(&self) -> f64 {
        let (mut low, mut high) = (-8.0, 8.0);
        while high - low > 0.01 {
            let middle = 0.5 * (low + high);
            match self.pressure(middle * self.rms_height)[0] > PRESSURE_OF_START {
                true => low = middle,
                false => high = middle,
            }
        }
        high * self.rms_height
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    const SURFACES: Rough = Rough {
        rms_height: 0.02,
        stiffness: 1.3,
        flow: Flow::AverageGap,
        boundary_friction: None,
    };

    /// Derivatives against differences, for both gaps, overlapping and apart.
    #[test]
    fn slopes_against_differences() {
        let step = 1e-7;
        let of = |law: &dyn Fn(f64) -> [f64; 2]| {
            for h in [-0.1, -0.011, 0.003, 0.03, 0.1, 0.17] {
                let difference = (law(h + step)[0] - law(h - step)[0]) / (2.0 * step);
                assert_relative_eq!(law(h)[1], difference, max_relative = 1e-5, epsilon = 1e-9);
            }
        };
        of(&|h| SURFACES.pressure(h));
        of(&|h| SURFACES.gap(h));
        let distance = Rough {
            flow: Flow::Distance,
            ..SURFACES
        };
        of(&|h| distance.gap(h));
    }

    /// Far apart both gaps are the distance; where mean planes meet, the mean gap is σ/√(2π), and the distance none.
    #[test]
    fn gaps_far_apart_and_in_touch() {
        let distance = Rough {
            flow: Flow::Distance,
            ..SURFACES
        };
        for surfaces in [SURFACES, distance] {
            assert_relative_eq!(surfaces.gap(1.0)[0], 1.0, max_relative = 1e-11);
        }
        let touching = 0.02 / (2.0 * std::f64::consts::PI).sqrt();
        assert_relative_eq!(SURFACES.gap(0.0)[0], touching, max_relative = 1e-14);
        assert!(distance.gap(0.0)[0] < 1e-4 * 0.02 && distance.gap(-0.02)[0] < 1e-8);
        assert_relative_eq!(
            SURFACES.pressure(SURFACES.least_start())[0],
            0.3,
            max_relative = 0.02
        );
    }
}
