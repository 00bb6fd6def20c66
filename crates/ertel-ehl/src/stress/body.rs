//! A body under its load: settings, planes, and the largest values of two samplings.

use super::depths::crest;
use super::results::{Extreme, Layer, OverDepth, StressParams};
use super::{Depths, Hardness, Level, Load, Peak};

/// Settings and geometry that both bodies share.
pub struct Contact<'a> {
    /// Settings.
    pub params: &'a StressParams,
    /// Depths of the planes.
    pub depths: Depths,
    /// Depth from which lives are computed.
    pub cut: f64,
    /// Points of a passage, of a grid its own.
    pub x: Vec<f64>,
    /// Whether it is a line or a roller.
    pub is_line: bool,
    /// Hertz pressure, Pa.
    pub pressure: f64,
    /// How far along x the section is kept, m.
    pub reach: f64,
    /// Error bar of the pressure of the solution over the pressure.
    pub relative_error: f64,
}

impl Contact<'_> {
    /// The half range of σ_xz that decides over a plane: of a roller in its middle, away from the ends.
    pub(super) fn half_range(&self, level: &Level) -> Peak {
        match self.is_line {
            true => level.middle_range,
            false => level.half_range,
        }
    }
}

/// A body.
pub struct Body<'a> {
    /// Its load.
    pub load: &'a Load,
    /// The same half as dense.
    pub coarse: &'a Load,
    /// Poisson's ratio.
    pub poisson: f64,
    /// Traction along x over the load.
    pub traction: f64,
    /// Hardness over depth.
    pub hardness: Option<&'a Hardness>,
}

/// The planes of a load and what they mean.
pub(super) struct Sampled {
    pub(super) depths: Depths,
    pub(super) levels: Vec<Level>,
    pub(super) layers: Vec<Layer>,
}

/// The planes of the frictionless dry contact, and those of half as dense a load.
pub struct Reference {
    /// At the depths of the contact.
    pub fine: Vec<Level>,
    /// At half as many.
    pub coarse: Vec<Level>,
}

impl Contact<'_> {
    /// Points of a passage that are half as dense; of a grid its own.
    pub(super) fn thinned(&self, load: &Load) -> Vec<f64> {
        match load {
            Load::Grid(load) => load.centres[0].clone(),
            _ => self.x.iter().copied().step_by(2).collect(),
        }
    }

    /// The planes of the frictionless dry contact and of its coarser load.
    pub fn reference(&self, [fine, coarse]: [&Load; 2], poisson: f64) -> Reference {
        Reference {
            fine: fine.levels(&self.x, &self.depths, poisson),
            coarse: coarse.levels(&self.thinned(coarse), &self.depths.coarser(), poisson),
        }
    }
}

/// Two samplings of a body, whose difference is the error bar.
pub(super) struct Both<'a> {
    pub(super) fine: &'a Sampled,
    pub(super) coarse: &'a Sampled,
    /// Error bar of the pressure of the solution, relative.
    pub(super) relative: f64,
}

impl Both<'_> {
    /// The largest value of the planes below a depth.
    pub(super) fn extreme(&self, pick: &dyn Fn(&Level) -> Peak, from: f64) -> Extreme {
        let of = |sampled: &Sampled| {
            let value = |t: usize| pick(&sampled.levels[t]).value;
            let (value, t) = largest(&sampled.depths, sampled.levels.len(), value, from);
            let at = pick(&sampled.levels[t.round() as usize]);
            (value, sampled.depths.at(t), at)
        };
        let ((value, depth, at), (other, other_depth, _)) = (of(self.fine), of(self.coarse));
        Extreme {
            value,
            error: (value - other).abs() + self.relative * value.abs(),
            x: at.x,
            y: at.y,
            depth,
            depth_error: (depth - other_depth).abs(),
        }
    }

    /// The largest value of the layers below a depth.
    pub(super) fn largest(&self, pick: &dyn Fn(&Layer) -> f64, from: f64) -> OverDepth {
        let of = |sampled: &Sampled| {
            let value = |t: usize| pick(&sampled.layers[t]);
            let (value, t) = largest(&sampled.depths, sampled.layers.len(), value, from);
            (value, sampled.depths.at(t))
        };
        let ((value, depth), (other, other_depth)) = (of(self.fine), of(self.coarse));
        OverDepth {
            value,
            error: (value - other).abs() + self.relative * value.abs(),
            depth,
            depth_error: (depth - other_depth).abs(),
        }
    }
}

/// The largest of `n` values over the depths from one on, and its index.
fn largest(depths: &Depths, n: usize, value: impl Fn(usize) -> f64, from: f64) -> (f64, f64) {
    let first = (depths.index(from).ceil() as usize).min(n - 1);
    let (value, t) = crest(n - first, |i| value(first + i));
    (value, first as f64 + t)
}
