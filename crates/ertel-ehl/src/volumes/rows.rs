//! Rows of nodes at uneven distances along the axis of a roller: close together where its dry contact ends or its profile has a kink.
//!
//! ```text
//!   y_j = Y(v_j),  v_j at even distances         Y: the map by which elements are stretched along rollers (see [`RollerZone`])
//! ```
//! Y is smooth but for a kink of its slope here and there, so that differences over neighbouring rows are of the second order.

use std::sync::Arc;

use crate::contact::roller::RollerZone;

/// Rows of a grid.
#[derive(Clone, Debug, PartialEq)]
pub struct Rows {
    /// Places along the axis, rising.
    places: Vec<f64>,
    /// Length that a row represents: from half-way from the row before to half-way to the next one, from the end of the roller on; of a centreline with its mirror image.
    heights: Vec<f64>,
    /// Whether the last row is the centreline, beyond which all is mirrored.
    half: bool,
}

impl Rows {
    /// Of a roller, with this many steps from its end y < 0 to the middle and from there to the other end. [`RING`] rows lie beyond each end, with
    /// zero length.
    pub fn new(zone: &RollerZone, steps: [usize; 2], half: bool) -> Rows {
        let (side, middle) = (zone.side(), zone.unit(0.0));
        let [left, right] = steps;
        let before = (0..left).map(|n| middle - (middle + side) * (left - n) as f64 / left as f64);
        let behind = (1..=right).map(|n| middle + (side - middle) * n as f64 / right as f64);
        let mut places: Vec<f64> = before.map(|v| zone.place(v)).collect();
        places.push(0.0);
        if !half {
            places.extend(behind.map(|v| zone.place(v)));
        }
        let n = places.len();
        let step = places[1] - places[0];
        let beyond = |from: f64, step: f64| (1..=RING).map(move |n| from + n as f64 * step);
        let mut all: Vec<f64> = beyond(places[0], -step).collect();
        all.reverse();
        all.extend(&places);
        if !half {
            all.extend(beyond(places[n - 1], places[n - 1] - places[n - 2]));
        }
        Rows::at(all, half)
    }

    /// At these places, [`RING`] of them beyond each end.
    pub fn at(places: Vec<f64>, half: bool) -> Rows {
        let last = places.len() - 1;
        let [first_end, last_end] = [RING, if half { last } else { last - RING }];
        let height = |j: usize| {
            let below = if j > first_end {
                places[j] - places[j - 1]
            } else {
                0.0
            };
            let above = match j {
                _ if half && j == last => below,
                _ if j < last_end => places[j + 1] - places[j],
                _ => 0.0,
            };
            match (first_end..=last_end).contains(&j) {
                true => 0.5 * (below + above),
                false => 0.0,
            }
        };
        Rows {
            heights: (0..=last).map(height).collect(),
            places,
            half,
        }
    }

    /// The same rows of a roller of another half length.
    #[must_use]
    pub fn drawn_to(self: &Arc<Rows>, half_length: f64) -> Arc<Rows> {
        let ratio = -half_length / self.places[RING];
        // Equal except for rounding.
        if (ratio - 1.0).abs() < 1e-12 {
            return Arc::clone(self);
        }
        let drawn = |values: &[f64]| values.iter().map(|y| ratio * y).collect();
        Arc::new(Rows {
            places: drawn(&self.places),
            heights: drawn(&self.heights),
            half: self.half,
        })
    }

    /// Their number.
    pub fn n(&self) -> usize {
        self.places.len()
    }

    /// Where each one is.
    pub fn places(&self) -> &[f64] {
        &self.places
    }

    /// Length that a row represents.
    #[inline(always)]
    pub fn height(&self, j: usize) -> f64 {
        self.heights[j]
    }

    /// Distance of a row from the next one.
    #[inline(always)]
    pub fn step(&self, j: usize) -> f64 {
        let j = j.min(self.places.len() - 2);
        self.places[j + 1] - self.places[j]
    }

    /// The ends of the roller that the rows go to.
    pub fn ends(&self) -> Vec<f64> {
        let last = self.places.len() - 1 - RING;
        match self.half {
            true => vec![self.places[RING]],
            false => vec![self.places[RING], self.places[last]],
        }
    }

    /// Whether a row lies on an end of the roller or beyond: there is no pressure.
    #[inline(always)]
    pub fn is_end(&self, j: usize) -> bool {
        j <= RING || (!self.half && j + RING + 1 >= self.places.len())
    }

    /// The row at or before a place, and how far it is from there to the next one; `None` beyond the ends.
    pub fn find(&self, y: f64) -> Option<(usize, f64)> {
        let last = self.places.len() - 1 - if self.half { 0 } else { RING };
        let [low, high] = [self.places[RING], self.places[last]];
        // Rounding must not lead out of the roller.
        let slack = 1e-12 * (high - low);
        if !(low - slack..=high + slack).contains(&y) {
            return None;
        }
        let after = self.places.partition_point(|place| *place <= y);
        let j = after.clamp(RING + 1, last) - 1;
        Some((j, (y - self.places[j]) / self.step(j)))
    }
}

/// Layers of nodes along an edge whose pressure is given: the reach of the third-order upwind fluxes.
pub const RING: usize = 2;
