//! The state from which a run continues at an instant as if it had not stopped.
//!
//! Grids, operators and the fluid follow from the problem, and places of reliefs from how far the bodies have moved; states and the memory of the steps are kept.
//! Sums are taken in the same order, so a continued run ends with the same digits.

use serde::{Deserialize, Serialize};

use super::heat::HeatMemory;
use crate::contact::Pose;

/// A run at the end of a step.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Checkpoint {
    /// T.
    pub time: f64,
    /// Length of the next step, in T.
    pub(super) step: f64,
    /// Where both bodies have moved, in half-widths.
    pub(super) moved: [Pose; 2],
    /// Statistics so far.
    pub info: Info,
    /// State of the grids.
    pub(super) memory: Memory,
}

impl Checkpoint {
    /// Whether time and steps are those of a run: finite, with a step forward and instants before it.
    pub fn is_whole(&self) -> bool {
        let times = &self.memory.times;
        let is_past = |t: &f64| t.is_finite() && *t <= self.time;
        (self.time >= 0.0 && self.time.is_finite())
            && (self.step > 0.0 && self.step.is_finite())
            && times.iter().all(is_past)
            && times.is_sorted_by(|newer, older| newer >= older)
    }
}

/// States of all grids, and the instants before that count.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub(super) struct Memory {
    /// T of the instants, the newest first.
    pub times: Vec<f64>,
    /// The grids, coarse to fine.
    pub grids: Vec<GridMemory>,
    /// Their heat, where it counts.
    pub heat: Vec<HeatMemory>,
}

/// A grid.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub(super) struct GridMemory {
    pub pressure: Vec<f64>,
    pub wetted: Vec<bool>,
    pub contents: Vec<f64>,
    /// Mass at the nodes at the instants, the newest first.
    pub stored: Vec<Vec<f64>>,
    /// H_0(0).
    pub origin: f64,
    /// H_0 and V at the instants.
    pub places: Vec<f64>,
    pub velocities: Vec<f64>,
}

/// The checkpoint belongs to other grids.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the grids of the checkpoint differ from those of this case")]
pub struct OtherGrids;

/// Statistics of a run.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Info {
    /// Steps taken.
    pub steps: usize,
    /// Steps rejected for their error or for lack of convergence.
    pub refused: usize,
    /// Newton iterations of all of them on all grids.
    pub newton_iterations: usize,
}
