//! A body under its load: settings, planes, and the largest values of two samplings.

use super::results::{Extreme, Layer, OverDepth, Site, StressParams};
use super::{Depths, Hardness, Level, Load, Peak, Residual, Response};
use crate::layers::Coated;

/// Settings and geometry that both bodies share.
pub struct Contact<'a> {
    /// Settings.
    pub params: &'a StressParams,
    /// Largest depth, m.
    pub depth: f64,
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
    /// Its materials.
    pub coated: &'a Coated,
    /// Traction along x over the load.
    pub traction: f64,
    /// Hardness over depth.
    pub hardness: Option<&'a Hardness>,
    /// Residual stress over depth.
    pub residual: Option<&'a Residual>,
}

/// The planes of a load and what they mean.
pub(super) struct Sampled {
    pub(super) depths: Depths,
    pub(super) response: Response,
    pub(super) levels: Vec<Level>,
    pub(super) layers: Vec<Layer>,
}

impl Body<'_> {
    /// Layer or substrate of an index of planes, and the interface that it lies at; `None` without layers.
    pub(super) fn site(&self, depths: &Depths, index: f64) -> Option<Site> {
        let n = self.coated.layers.len();
        (n > 0).then(|| {
            let (part, end) = depths.part(index);
            Site {
                layer: (part < n).then_some(part + 1),
                interface: end.and_then(|below| match below {
                    true => (part < n).then_some(part + 1),
                    false => (part > 0).then_some(part),
                }),
            }
        })
    }
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

    /// The depths of a body.
    pub fn depths(&self, body: &Coated) -> Depths {
        Depths::with_interfaces(self.depth, self.params.planes, &body.interfaces())
    }

    /// The planes of the frictionless dry contact of bodies without layers and of its coarser load.
    pub fn reference(&self, [fine, coarse]: [&Load; 2], body: &Coated) -> Reference {
        let (depths, poisson) = (self.depths(body), body.substrate.poissons_ratio);
        let rough = Response::bare(poisson, &depths.coarser());
        Reference {
            fine: fine.levels(&self.x, &Response::bare(poisson, &depths)),
            coarse: coarse.levels(&self.thinned(coarse), &rough),
        }
    }
}

/// Two samplings of a body, whose difference is the error bar.
pub(super) struct Both<'a> {
    pub(super) fine: &'a Sampled,
    pub(super) coarse: &'a Sampled,
    /// The body.
    pub(super) body: &'a Body<'a>,
    /// Error bar of the pressure of the solution, relative.
    pub(super) relative: f64,
}

impl Both<'_> {
    /// The largest value of the planes below a depth.
    pub(super) fn extreme(&self, pick: &dyn Fn(&Level) -> Peak, from: f64) -> Extreme {
        self.found(pick, &|depths, value| depths.largest(from, value))
    }

    /// The largest value of the planes of a part.
    pub(super) fn extreme_in(&self, pick: &dyn Fn(&Level) -> Peak, part: usize) -> Extreme {
        self.found(pick, &|depths, value| depths.largest_in(part, value))
    }

    /// The largest value of the plane above an interface, which both its sides share.
    pub(super) fn extreme_at(&self, pick: &dyn Fn(&Level) -> Peak, part: usize) -> Extreme {
        self.found(pick, &|depths, value| {
            let last = depths.last_of(part);
            (value(last), last as f64)
        })
    }

    fn found(&self, pick: &dyn Fn(&Level) -> Peak, search: &Search<'_>) -> Extreme {
        let of = |sampled: &Sampled| {
            let value = |t: usize| pick(&sampled.levels[t]).value;
            let (value, t) = search(&sampled.depths, &value);
            (value, t, pick(&sampled.levels[t.round() as usize]))
        };
        let ((value, t, at), (other, other_t, _)) = (of(self.fine), of(self.coarse));
        let depth = self.fine.depths.at(t);
        Extreme {
            value,
            error: (value - other).abs() + self.relative * value.abs(),
            x: at.x,
            y: at.y,
            depth,
            depth_error: (depth - self.coarse.depths.at(other_t)).abs(),
            site: self.body.site(&self.fine.depths, t),
        }
    }

    /// The largest value of the layers below a depth.
    pub(super) fn largest(&self, pick: &dyn Fn(&Layer) -> f64, from: f64) -> OverDepth {
        self.over_depth(pick, &|depths, value| depths.largest(from, value))
    }

    /// The largest value of the layers down to a depth.
    pub(super) fn largest_above(&self, pick: &dyn Fn(&Layer) -> f64, to: f64) -> OverDepth {
        self.over_depth(pick, &|depths, value| depths.largest_above(to, value))
    }

    /// The largest value of the layers of a part.
    pub(super) fn largest_in(&self, pick: &dyn Fn(&Layer) -> f64, part: usize) -> OverDepth {
        self.over_depth(pick, &|depths, value| depths.largest_in(part, value))
    }

    fn over_depth(&self, pick: &dyn Fn(&Layer) -> f64, search: &Search<'_>) -> OverDepth {
        let of = |sampled: &Sampled| {
            let value = |t: usize| pick(&sampled.layers[t]);
            search(&sampled.depths, &value)
        };
        let ((value, t), (other, other_t)) = (of(self.fine), of(self.coarse));
        let depth = self.fine.depths.at(t);
        OverDepth {
            value,
            error: (value - other).abs() + self.relative * value.abs(),
            depth,
            depth_error: (depth - self.coarse.depths.at(other_t)).abs(),
            site: self.body.site(&self.fine.depths, t),
        }
    }
}

/// The largest of the values of planes, and its index.
type Search<'a> = dyn Fn(&Depths, &dyn Fn(usize) -> f64) -> (f64, f64) + 'a;
