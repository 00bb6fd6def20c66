//! Friction of a solved contact of a pair of gears.

use ertel_machines::gear::PathPoint;

use crate::mark::Marked;

/// A solved contact: its coefficient of traction, the resistance to rolling f per length, and the bar of the whole loss over u_m, N/m.
pub(in crate::machine) struct Rubbing {
    pub coefficient: Marked,
    pub resistance: Marked,
    pub total_bar: Marked,
}

impl Rubbing {
    /// Friction power per length (W/m) of this contact under the load of another: where a pair of teeth takes over, the load jumps, and µ and f do not.
    ///
    /// p = µ w |u_2 − u_1| + f u_m
    pub fn power(&self, at: &PathPoint) -> Marked {
        let sliding = self.coefficient.value * at.load_per_length * at.sliding_speed.abs();
        Marked {
            value: sliding + self.resistance.value * at.entrainment_speed,
            error: self.total_bar.error.map(|bar| bar * at.entrainment_speed),
            marks: self.coefficient.marks,
        }
    }
}
