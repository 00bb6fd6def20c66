//! Deflection of the contact surface by the film pressure.
//!
//! - [`HalfSpace`]: closed-form integrals and a fast summation, for homogeneous bodies (the default);
//! - [`FiniteBodies`]: finite-element bodies condensed to their surface, as in Habchi's thesis.
//!
//! Both use nodal pressures and deflections at the nodes of a [`Trace`], and do not depend on the film.

mod finite_elements;
mod half_space;
mod near;
mod response;
mod trace;

pub use crate::contact::material::compliance;
pub use ertel_fem::potential::Accuracy;
pub use finite_elements::{
    BodySpace, CondensedResponse, ElasticBody, FiniteBodies, FiniteBody, FiniteBodyError,
};
pub use half_space::{HalfSpace, LINE_REFERENCE};
pub use near::{near_pairs, symbol_stiffness};
pub use response::SurfaceResponse;
pub use trace::Trace;

use crate::contact::Material;
use crate::layers::{Coated, Layer};

/// Which bodies deflect, and how they are computed.
#[derive(Clone, Debug, PartialEq)]
pub struct Elasticity {
    /// How.
    pub model: BodyModel,
    /// Lagrange order of the deflection; of a half-space not below that of the pressure.
    pub order: usize,
    /// The bodies, moduli over R p_h/a; none for a rigid contact.
    pub bodies: Vec<Material>,
    /// Layers of each body from its surface down, thicknesses in half-widths; empty where no body has any.
    pub layers: Vec<Vec<Layer>>,
}

/// How bodies are computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BodyModel {
    /// Half-spaces.
    HalfSpace,
    /// Finite elements.
    FiniteElements,
}

impl Elasticity {
    /// Half-spaces.
    pub fn half_space(order: usize, bodies: &[Material]) -> Elasticity {
        Elasticity {
            model: BodyModel::HalfSpace,
            order,
            bodies: bodies.to_vec(),
            layers: Vec::new(),
        }
    }

    /// Finite-element bodies.
    pub fn finite_elements(order: usize, bodies: &[Material]) -> Elasticity {
        Elasticity {
            model: BodyModel::FiniteElements,
            order,
            bodies: bodies.to_vec(),
            layers: Vec::new(),
        }
    }

    /// The same with layers on each body.
    #[must_use]
    pub fn with_layers(self, layers: Vec<Vec<Layer>>) -> Elasticity {
        Elasticity { layers, ..self }
    }

    /// The bodies with their layers.
    pub fn coated(&self) -> Vec<Coated> {
        let layers = self
            .layers
            .iter()
            .cloned()
            .chain(std::iter::repeat(Vec::new()));
        (self.bodies.iter().zip(layers))
            .map(|(substrate, layers)| Coated {
                layers,
                substrate: *substrate,
            })
            .collect()
    }
}
