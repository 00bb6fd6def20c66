//! Heat by finite volumes: temperatures across the film at the nodes of each grid, and those of the surfaces of two moving half-spaces.
//!
//! ```text
//!   film:    ρc h (∂T/∂t + u ∂T/∂x + v ∂T/∂y) + c ω ∂T/∂s − k/h ∂²T/∂s² = h(Q_shear + Q_comp)        [`columns`], [`transport`]
//!   bodies:  T_w = T_bulk + K * q                                                            [`source`], [`spreading`]
//!   K_film, ρ̄, ū of the film equation by the temperatures                                    [`warmth`]
//! ```
//! Equations and laws of the film are those of the finite elements ([`crate::forms::energy`]).
//!
//! | module | what |
//! |---|---|
//! | [`source`] | temperature of a moving body by the heat that flows into cells |
//! | [`spreading`] | the same on a grid, by fast Fourier transforms |
//! | [`turning`] | spinning bodies, mapped to a plane |
//! | [`memory`], [`modes`] | stored heat of the bodies in time |
//! | [`columns`] | the energy equation of the film over each node |
//! | [`flow`], [`transport`] | heat flow from node to node |
//! | [`march`] | temperatures of the film by those of the walls, along the flow |
//! | [`temperatures`] | Newton's method for film and surfaces |
//! | [`warmth`], [`warm_up`] | temperature-dependent coefficients of the film equation |
//! | [`rounds`] | film and heat in turn, from grid to grid |
//! | [`tangents`] | derivatives of both by an input |
//! | [`figures`], [`output`] | temperatures and heat in numbers; for results |
//!
//! Theory: Heat by finite volumes.

pub mod columns;
pub mod figures;
pub mod flow;
pub mod march;
pub mod memory;
pub mod modes;
pub mod output;
pub mod rounds;
pub mod source;
pub mod spreading;
pub mod tangents;
pub mod temperatures;
pub mod transport;
pub mod turning;
pub mod warm_up;
pub mod warmth;

pub use rounds::Params;

pub use temperatures::Warm;

#[cfg(test)]
mod tests;
