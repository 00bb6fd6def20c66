//! The problem of a contact, dimensionless.

use crate::contact::{Planar, Scales, Shape};
use crate::elastic::Elasticity;
use crate::film::FilmFluid;
use crate::forms::energy::Heat;

/// Contact area, and the body below it, in Hertz half-widths.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extents {
    /// Inlet edge X of the contact area.
    pub inlet: f64,
    /// Outlet edge X.
    pub outlet: f64,
    /// Side edge |Y|, of ellipses in semi-axes along y.
    pub side: f64,
    /// Width of the body.
    pub body_width: f64,
    /// Depth of the body.
    pub body_depth: f64,
}

/// A contact to be solved, and how an engine goes about it.
pub struct Problem<Plan> {
    /// Geometry of the contact and of its oil.
    pub shape: Shape,
    /// Contact area and body.
    pub extents: Extents,
    /// Distances of inlet and side, in half-widths, to which the contact area goes where they are not set by hand.
    pub reach: [f64; 2],
    /// Elastic bodies.
    pub elasticity: Elasticity,
    /// Fluid, with the sliding of the surfaces.
    pub fluid: FilmFluid,
    /// ū, the mean velocity of the surfaces over the entrainment speed.
    pub entrainment: Planar,
    /// Target of ∫P over the part of the contact area that is solved.
    pub load: f64,
    /// Central film of the start.
    pub start_film: f64,
    /// Heat of film and bodies, where it counts.
    pub heat: Option<Heat>,
    /// Scales of its variables.
    pub scales: Scales,
    /// How the engine goes about it.
    pub plan: Plan,
}

impl<Plan> Problem<Plan> {
    /// The same contact for an engine that goes about it in another way.
    pub fn with_plan<Other>(self, plan: Other) -> Problem<Other> {
        Problem {
            shape: self.shape,
            extents: self.extents,
            reach: self.reach,
            elasticity: self.elasticity,
            fluid: self.fluid,
            entrainment: self.entrainment,
            load: self.load,
            start_film: self.start_film,
            heat: self.heat,
            scales: self.scales,
            plan,
        }
    }
}
