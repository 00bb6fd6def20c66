//! Worn depth at the points of a lattice, and its part of the gap.
//!
//! ```text
//!   δd_ij = k/H δs p_ij,            p_ij = p_a(x_i, y_j) W_a/(Σ p_a Δx Δy)          body at rest
//!   δd_j  = k/(H L) δs Σ_i p_ij Δx                                                  track
//! ```
//! The pressures of the lattice are scaled to the load W_a of the asperities, so that the worn volume is exactly k/H W_a δs.

use std::sync::Arc;

use crate::contact::gap::{Body, Form, GapTerm, HeightMap, Relief};
use crate::contact::{Pose, Shape};
use crate::engine::Film;

/// Share of the largest asperity pressure, and of the largest depth, that is worn at the rim of the lattice at most.
const RIM_PRESSURE: f64 = 1e-6;

/// Points without wear around the lattice: a spline through them swings by a factor of 0.268 less from one to the next.
const RIM: usize = 14;

/// Share of the largest depth at the edge of a scar or track, which grids resolve.
const EDGE: f64 = 0.01;

/// Points at equal distances about the centre of the contact, along and across the motion; one row of a line contact. Lengths in half-widths.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lattice {
    /// Distance of the points along x and y; 1 across a line contact.
    pub spacing: [f64; 2],
    /// Points on either side of the centre.
    pub half: [usize; 2],
}

impl Lattice {
    /// Points along x and y.
    pub fn counts(&self) -> [usize; 2] {
        self.half.map(|n| 2 * n + 1)
    }

    /// Place along a direction.
    fn at(&self, d: usize, i: usize) -> f64 {
        (i as f64 - self.half[d] as f64) * self.spacing[d]
    }

    /// Points at the distances of `spacing` that cover the pressures of the asperities of a film.
    pub fn of(film: &impl Film, shape: &Shape, spacing: [f64; 2]) -> Lattice {
        let points = || film.points().iter().map(|point| &point.fields);
        let largest = points().fold(0.0, |m: f64, at| m.max(at.asperity_pressure));
        let mut reach = [0.0_f64; 2];
        for at in points().filter(|at| at.asperity_pressure > RIM_PRESSURE * largest) {
            for (reach, x) in reach.iter_mut().zip(at.place) {
                *reach = reach.max(x.abs());
            }
        }
        let half = [0, 1].map(|d: usize| match d == 1 && shape.is_line() {
            true => 0,
            false => (reach[d] / spacing[d]).ceil() as usize + RIM,
        });
        Lattice { spacing, half }
    }

    /// The points of both.
    pub fn with(&self, other: &Lattice) -> Lattice {
        Lattice {
            half: [0, 1].map(|d: usize| self.half[d].max(other.half[d])),
            ..*self
        }
    }
}

/// Asperity pressures at the points of a lattice, row by row, in p_h.
pub struct Pressures {
    /// The points.
    pub lattice: Lattice,
    /// p_ij, whose sum over the cells is the load of the asperities.
    pub values: Vec<f64>,
    /// W_a, in p_h and half-widths, of the whole contact.
    pub load: f64,
}

impl Pressures {
    /// Of a film.
    pub fn of(film: &impl Film, shape: &Shape, lattice: Lattice) -> Pressures {
        let [nx, ny] = lattice.counts();
        let at = |k: usize| [lattice.at(0, k % nx), lattice.at(1, k / nx)];
        let is_inner = |i: usize, n: usize| n == 1 || (RIM..n - RIM).contains(&i);
        let mut values: Vec<f64> = (0..nx * ny)
            .map(|k| match is_inner(k % nx, nx) && is_inner(k / nx, ny) {
                true => film.at(at(k)).map_or(0.0, |at| at.asperity_pressure),
                false => 0.0,
            })
            .collect();
        let parts = film.points().iter();
        let load = shape.symmetry.multiplicity()
            * parts
                .map(|point| point.area * point.fields.asperity_pressure)
                .sum::<f64>();
        let [dx, dy] = lattice.spacing;
        let sum = values.iter().sum::<f64>() * dx * dy;
        let factor = if sum > 0.0 { load / sum } else { 0.0 };
        values.iter_mut().for_each(|p| *p *= factor);
        Pressures {
            lattice,
            values,
            load,
        }
    }

    /// Rate of the depth over that of a unit of k s/H: at all points of a body at rest, or along the rows of a body with a track of this length, in half-widths.
    pub fn rates(&self, track: Option<f64>) -> Vec<f64> {
        let Some(length) = track else {
            return self.values.clone();
        };
        let share = self.lattice.spacing[0] / length;
        let rows = self.values.chunks_exact(self.lattice.counts()[0]);
        rows.map(|row| row.iter().sum::<f64>() * share).collect()
    }
}

/// Worn depth of a body.
#[derive(Clone, Debug, PartialEq)]
pub struct Depth {
    /// The points.
    pub lattice: Lattice,
    /// Depths row by row, or one of each row of a track, in a²/R.
    pub values: Vec<f64>,
    /// Length of the track in half-widths, of a body that moves through the contact.
    pub track: Option<f64>,
}

impl Depth {
    /// No wear yet.
    pub fn none(lattice: Lattice, track: Option<f64>) -> Depth {
        let [nx, ny] = lattice.counts();
        let columns = if track.is_some() { 1 } else { nx };
        Depth {
            lattice,
            values: vec![0.0; columns * ny],
            track,
        }
    }

    /// The same on a lattice that has at least its points, at the same distances.
    pub fn on(&self, lattice: Lattice) -> Depth {
        let mut wider = Depth::none(lattice, self.track);
        let more = [0, 1].map(|d: usize| lattice.half[d] - self.lattice.half[d]);
        let [own, all] = [&self.lattice, &lattice].map(|of| match self.track {
            Some(_) => 1,
            None => of.counts()[0],
        });
        let first = if all > 1 { more[0] } else { 0 };
        for (j, row) in self.values.chunks_exact(own).enumerate() {
            let start = (j + more[1]) * all + first;
            wider.values[start..start + own].copy_from_slice(row);
        }
        wider
    }

    /// Wears by a multiple of the rates.
    pub fn add(&mut self, rates: &[f64], factor: f64) {
        (self.values.iter_mut().zip(rates)).for_each(|(depth, rate)| *depth += factor * rate);
    }

    /// Largest depth, a²/R.
    pub fn largest(&self) -> f64 {
        self.values.iter().copied().fold(0.0, f64::max)
    }

    /// The worn surface: that of the body, a spline through the depths; `None` without wear, and of a track all across a line contact, which is no change of the shape.
    fn heights(&self) -> Option<HeightMap> {
        let (counts, spacing) = (self.lattice.counts(), self.lattice.spacing);
        let heights: Vec<f64> = self.values.iter().map(|depth| -depth).collect();
        let shape = match self.track {
            None => (counts, spacing),
            Some(_) => ([counts[1], 1], [spacing[1]; 2]),
        };
        (self.largest() > 0.0 && shape.0[0] > 1).then(|| HeightMap::new(shape.0, shape.1, &heights))
    }

    /// Worn volume of the surface in the gap, in half-widths and a²/R; of line contacts per length.
    pub fn volume(&self) -> f64 {
        let area = match self.heights() {
            Some(heights) => -heights.integral(),
            None => self.values.iter().sum(),
        };
        area * self.track.unwrap_or(1.0)
    }

    /// Its part of the gap, on the surface of a body.
    pub fn term(&self, body: Body, shape: &Shape) -> Option<GapTerm> {
        let along_x = self.track.is_none();
        let form = Form::Map {
            map: Arc::new(self.heights()?),
            units: [1.0; 2],
            finest: self.lattice.spacing[0],
            direction: if along_x {
                0.0
            } else {
                std::f64::consts::FRAC_PI_2
            },
        };
        Some(GapTerm::Relief(Relief {
            form,
            body,
            place: [0.0; 2],
            moved: Pose::START,
            turn: shape.gap.turn,
        }))
    }

    /// Places along the motion through the centre, or across it, with the depths there; empty where the depth does not vary.
    pub fn profile(&self, across: bool) -> Vec<[f64; 2]> {
        let [nx, ny] = self.lattice.counts();
        let [i, j] = self.lattice.half;
        let columns = if self.track.is_some() { 1 } else { nx };
        let i = if columns > 1 { i } else { 0 };
        match across {
            false if columns > 1 => (0..nx)
                .map(|i| [self.lattice.at(0, i), self.values[j * columns + i]])
                .collect(),
            true if ny > 1 => (0..ny)
                .map(|j| [self.lattice.at(1, j), self.values[j * columns + i]])
                .collect(),
            _ => Vec::new(),
        }
    }

    /// Points with at least [`EDGE`] of the largest depth: their places along and across the motion.
    fn inside(&self) -> impl Iterator<Item = [f64; 2]> {
        let columns = if self.track.is_some() {
            1
        } else {
            self.lattice.counts()[0]
        };
        let least = EDGE * self.largest();
        let deep = (self.values.iter().enumerate()).filter(move |(_, depth)| **depth > least);
        deep.map(move |(k, _)| {
            let x = if columns > 1 {
                self.lattice.at(0, k % columns)
            } else {
                0.0
            };
            [x, self.lattice.at(1, k / columns)]
        })
    }

    /// Distance from the centre to which it reaches along the principal directions, in the plane in which the dry contact is the unit circle.
    pub fn reach(&self, shape: &Shape) -> f64 {
        let zone = &shape.zone;
        let far = self.inside().map(|place| {
            let [x, y] = zone.turn.to_axes(place);
            x.abs().max((y / zone.axis_ratio).abs())
        });
        far.fold(0.0, f64::max)
    }

    /// Length along and width across the motion of the part with at least 1 % of the largest depth, in half-widths; `None` of directions along which the depth does not vary.
    pub fn size(&self) -> [Option<f64>; 2] {
        let varies = [self.track.is_none(), self.lattice.half[1] > 0];
        [0, 1].map(|d: usize| {
            let ends = self.inside().map(|place| place[d]).fold(None, |ends, x| {
                let [low, high] = ends.unwrap_or([x; 2]);
                Some([f64::min(low, x), f64::max(high, x)])
            });
            ends.filter(|_| varies[d]).map(|[low, high]| high - low)
        })
    }
}
