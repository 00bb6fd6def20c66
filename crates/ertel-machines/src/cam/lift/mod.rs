//! Laws of lift.

mod segments;
mod smoothing;
mod spline;

pub use segments::{MotionLaw, Segment};
pub use spline::PeriodicSpline;

use std::f64::consts::TAU;

use super::CamError;
use super::error::in_range;

/// Lift s of the follower over the angle θ of the cam; lengths in m, angles in rad.
#[derive(Clone, Debug, PartialEq)]
pub enum LiftLaw {
    /// s = e cos θ: a disc on an axis beside its centre, under a flat face.
    Eccentric {
        /// Eccentricity e, m.
        eccentricity: f64,
    },
    /// s = (h/2)(1 − cos nθ).
    Harmonic {
        /// Full lift h, m.
        lift: f64,
        /// Lobes n.
        lobes: u32,
    },
    /// Dwells, rises and returns one after another, from θ = 0 and s = 0 on.
    Segments(Vec<Segment>),
    /// A table of lifts, interpolated by a periodic spline.
    Table(PeriodicSpline),
}

impl LiftLaw {
    /// A law of segments.
    ///
    /// # Errors
    ///
    /// Segments that do not make up a turn or do not end where they start.
    pub fn segments(segments: Vec<Segment>) -> Result<LiftLaw, CamError> {
        segments::check(&segments)?;
        Ok(LiftLaw::Segments(segments))
    }

    /// A law through a table of angles (rad) and lifts (m); the last row is not the first of the next turn.
    ///
    /// # Errors
    ///
    /// Tables out of order or of unfit size.
    pub fn table(angles: &[f64], lifts: &[f64]) -> Result<LiftLaw, CamError> {
        Ok(LiftLaw::Table(PeriodicSpline::new(angles, lifts, TAU)?))
    }

    /// A smooth law near a table whose lifts have errors, such as of rounding, of the root mean square `tolerance` (m).
    ///
    /// Errors of a table grow by about 4/Δθ² in s'': lifts that are rounded to 1 µm at each degree make s'' uncertain by several mm if the law goes through all of them.
    ///
    /// # Errors
    ///
    /// Tables out of order or of unfit size, and negative tolerances.
    pub fn smooth_table(
        angles: &[f64],
        lifts: &[f64],
        tolerance: f64,
    ) -> Result<LiftLaw, CamError> {
        let inside = tolerance >= 0.0;
        in_range("tolerance of the lifts", tolerance, inside, "not negative")?;
        if tolerance == 0.0 {
            return LiftLaw::table(angles, lifts);
        }
        let spline = smoothing::smooth(angles, lifts, TAU, tolerance)?;
        Ok(LiftLaw::Table(spline))
    }

    /// s, s' and s'' (m, per rad and rad²) at the angle θ (rad).
    pub fn at(&self, angle: f64) -> [f64; 3] {
        match self {
            LiftLaw::Eccentric { eccentricity: e } => {
                [e * angle.cos(), -e * angle.sin(), -e * angle.cos()]
            }
            LiftLaw::Harmonic { lift, lobes } => {
                let n = f64::from(*lobes);
                let (half, phase) = (0.5 * lift, n * angle);
                [
                    half * (1.0 - phase.cos()),
                    half * n * phase.sin(),
                    half * n * n * phase.cos(),
                ]
            }
            LiftLaw::Segments(parts) => segments::at(parts, angle.rem_euclid(TAU)),
            LiftLaw::Table(spline) => spline.at(angle),
        }
    }

    /// Refuses numbers that no lift has.
    pub(super) fn check(&self) -> Result<(), CamError> {
        match self {
            LiftLaw::Eccentric { eccentricity } => {
                in_range("eccentricity", *eccentricity, true, "a finite number")
            }
            LiftLaw::Harmonic { lift, lobes } => {
                in_range("lift", *lift, true, "a finite number")?;
                in_range("lobes", f64::from(*lobes), *lobes > 0, "positive")
            }
            LiftLaw::Segments(parts) => segments::check(parts),
            LiftLaw::Table(_) => Ok(()),
        }
    }
}
