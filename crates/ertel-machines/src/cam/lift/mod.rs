//! Laws of lift.

mod segments;
mod smoothing;
mod spline;

pub use segments::{MotionLaw, Segment};
pub use smoothing::TableLift;
pub use spline::{PeriodicSpline, ROWS};

use std::f64::consts::TAU;

use super::CamError;
use super::error::in_range;

/// Lift s of the follower over the angle θ of the cam; lengths in m, angles in rad.
#[derive(Clone, Debug, PartialEq)]
pub enum LiftLaw {
    /// s = e cos θ: a disc on an axis off its centre, under a flat face.
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
    /// A table of lifts, by a periodic spline through or near it.
    Table(Box<TableLift>),
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

    /// A law through a table of angles (rad) and exact lifts (m); the last row is not the first of the next turn.
    ///
    /// # Errors
    ///
    /// Tables out of order or of unfit size.
    pub fn table(angles: &[f64], lifts: &[f64]) -> Result<LiftLaw, CamError> {
        LiftLaw::rounded_table(angles, lifts, 0.0, None)
    }

    /// A law of a table whose lifts are rounded to a multiple of `digit` (m), the unit of their last digit, or have errors of the root mean square
    /// `tolerance` (m), which is that of rounding if absent: `digit`/√12.
    ///
    /// Errors of a table grow by about 4/Δθ² in s'': lifts that are rounded to 1 µm at each degree make s'' uncertain by several mm if the law interpolates all of
    /// them. Where that counts the law is the smoothest one with these errors; a tolerance of 0 leads through all lifts in any case.
    ///
    /// # Errors
    ///
    /// Tables out of order or of unfit size, and negative tolerances.
    pub fn rounded_table(
        angles: &[f64],
        lifts: &[f64],
        digit: f64,
        tolerance: Option<f64>,
    ) -> Result<LiftLaw, CamError> {
        let rounding = digit / 12.0_f64.sqrt();
        let error = tolerance.unwrap_or(rounding);
        in_range(
            "tolerance of the lifts",
            error,
            error >= 0.0,
            "not negative",
        )?;
        let law = TableLift::new(angles, lifts, TAU, error, tolerance.is_some())?;
        Ok(LiftLaw::Table(Box::new(law)))
    }

    /// By how much s'' (m) may be off at the angle θ (rad), as a table of lifts is rounded; 0 of other laws.
    pub fn acceleration_bar(&self, angle: f64) -> f64 {
        match self {
            LiftLaw::Table(table) => table.bar(angle),
            _ => 0.0,
        }
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
            LiftLaw::Table(table) => table.at(angle),
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
