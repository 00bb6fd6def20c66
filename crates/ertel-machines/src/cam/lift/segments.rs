//! Lifts made of dwells, rises and returns.

use std::f64::consts::{PI, TAU};

use super::super::CamError;
use super::super::error::in_range;

/// How a rise or a return runs, over τ from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MotionLaw {
    /// 10 τ³ − 15 τ⁴ + 6 τ⁵: velocity and acceleration vanish at the ends.
    Polynomial345,
    /// 35 τ⁴ − 84 τ⁵ + 70 τ⁶ − 20 τ⁷: jerk vanishes at the ends too.
    Polynomial4567,
    /// τ − sin 2πτ/(2π).
    Cycloidal,
    /// (1 − cos πτ)/2: acceleration jumps at the ends.
    Harmonic,
}

impl MotionLaw {
    /// The law and its first two derivatives by τ. Source: Norton 2002, chapters 2 and 3.
    pub fn at(self, tau: f64) -> [f64; 3] {
        let t = tau;
        match self {
            MotionLaw::Polynomial345 => [
                t * t * t * (10.0 + t * (-15.0 + 6.0 * t)),
                30.0 * t * t * (1.0 + t * (-2.0 + t)),
                60.0 * t * (1.0 + t * (-3.0 + 2.0 * t)),
            ],
            MotionLaw::Polynomial4567 => [
                t.powi(4) * (35.0 + t * (-84.0 + t * (70.0 - 20.0 * t))),
                140.0 * t.powi(3) * (1.0 + t * (-3.0 + t * (3.0 - t))),
                420.0 * t * t * (1.0 + t * (-4.0 + t * (5.0 - 2.0 * t))),
            ],
            MotionLaw::Cycloidal => [
                t - (TAU * t).sin() / TAU,
                1.0 - (TAU * t).cos(),
                TAU * (TAU * t).sin(),
            ],
            MotionLaw::Harmonic => [
                0.5 * (1.0 - (PI * t).cos()),
                0.5 * PI * (PI * t).sin(),
                0.5 * PI * PI * (PI * t).cos(),
            ],
        }
    }
}

/// A part of a turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Segment {
    /// The lift stays.
    Dwell {
        /// Angle it takes, rad.
        angle: f64,
    },
    /// The lift changes.
    Move {
        /// Angle it takes, rad.
        angle: f64,
        /// Change of lift, m; negative of a return.
        lift: f64,
        /// How it runs.
        law: MotionLaw,
    },
}

impl Segment {
    fn angle(&self) -> f64 {
        match self {
            Segment::Dwell { angle } | Segment::Move { angle, .. } => *angle,
        }
    }

    fn lift(&self) -> f64 {
        match self {
            Segment::Dwell { .. } => 0.0,
            Segment::Move { lift, .. } => *lift,
        }
    }
}

/// Refuses segments that do not make up a turn, or do not end where they start.
pub(super) fn check(segments: &[Segment]) -> Result<(), CamError> {
    let (mut sum, mut rise, mut size) = (0.0, 0.0, 0.0);
    for segment in segments {
        let (angle, lift) = (segment.angle(), segment.lift());
        in_range("angle of a segment", angle, angle > 0.0, "positive")?;
        in_range("lift of a segment", lift, true, "a finite number")?;
        sum += angle;
        rise += lift;
        size += lift.abs();
    }
    // Angles in degrees and lifts in mm are sums of rounded numbers.
    if (sum - TAU).abs() > 1e-9 * TAU {
        return Err(CamError::Turn { sum });
    }
    if rise.abs() > 1e-9 * size {
        return Err(CamError::NotClosed { rise });
    }
    Ok(())
}

/// s, s' and s'' at an angle from 0 to 2π (rad).
pub(super) fn at(segments: &[Segment], angle: f64) -> [f64; 3] {
    let (mut start, mut base) = (0.0, 0.0);
    for (i, segment) in segments.iter().enumerate() {
        let width = segment.angle();
        // The last segment takes what rounding leaves of the turn.
        if angle < start + width || i + 1 == segments.len() {
            let Segment::Move { lift, law, .. } = segment else {
                return [base, 0.0, 0.0];
            };
            let [value, first, second] = law.at(((angle - start) / width).min(1.0));
            return [
                base + lift * value,
                lift * first / width,
                lift * second / (width * width),
            ];
        }
        start += width;
        base += segment.lift();
    }
    [0.0; 3]
}
