//! The problem of a contact, dimensionless.

use crate::contact::{Planar, Scales, Shape};
use crate::elastic::Elasticity;
use crate::film::FilmFluid;
use crate::forms::energy::Heat;
use crate::mixed::Rough;

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

/// A contact to be solved, with the settings of an engine.
pub struct Problem<Plan> {
    /// Geometry of the contact and of its oil.
    pub shape: Shape,
    /// Contact area and body.
    pub extents: Extents,
    /// Default distances of inlet and side of the contact area, in half-widths.
    pub reach: [f64; 2],
    /// Elastic bodies.
    pub elasticity: Elasticity,
    /// Fluid, with the sliding of the surfaces.
    pub fluid: FilmFluid,
    /// The same fluid with the law for friction, where the film is solved without that law.
    pub friction: Option<FilmFluid>,
    /// ū, the mean velocity of the surfaces over the entrainment speed.
    pub entrainment: Planar,
    /// Target of ∫P over the part of the contact area that is solved.
    pub load: f64,
    /// Central film of the start.
    pub start_film: f64,
    /// Heat of film and bodies, in thermal contacts.
    pub heat: Option<Heat>,
    /// Rough surfaces whose asperities bear a part of the load, if described.
    pub rough: Option<Rough>,
    /// Scales of its variables.
    pub scales: Scales,
    /// Settings of the engine.
    pub plan: Plan,
}

impl<Plan> Problem<Plan> {
    /// The fluid for friction.
    pub fn friction_fluid(&self) -> &FilmFluid {
        self.friction.as_ref().unwrap_or(&self.fluid)
    }

    /// The same contact with the settings of another engine.
    pub fn with_plan<Other>(self, plan: Other) -> Problem<Other> {
        Problem {
            shape: self.shape,
            extents: self.extents,
            reach: self.reach,
            elasticity: self.elasticity,
            fluid: self.fluid,
            friction: self.friction,
            entrainment: self.entrainment,
            load: self.load,
            start_film: self.start_film,
            heat: self.heat,
            rough: self.rough,
            scales: self.scales,
            plan,
        }
    }
}
