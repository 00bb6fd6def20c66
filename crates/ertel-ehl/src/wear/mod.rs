//! Wear of rough bodies by Archard's law: the shape of the bodies changes over the sliding distance, and with it the contact.
//!
//! ```text
//!   ∂d/∂s = k p_a/H                            scar of a body at rest in the contact: depth d(x, y)
//!   ∂d/∂s = k/(H L) ∫ p_a dx                   track of a body that moves through it: depth d(y), the same all around the track of the length L
//!   V = k/H ∫ W_a ds,   W_a = ∫ p_a dA         worn volume of a body
//! ```
//! s is the sliding distance, p_a the pressure that the asperities bear (all of it where no oil flows), k the wear coefficient and H the hardness of the body, W_a the load
//! of the asperities. The depth is added to the gap. Archard 1953, J. Appl. Phys. 24, 981-988. A track has the mean of ∂d/∂s over its
//! length: each of its points passes under the contact once per L, and slides there for the time dx/u.
//!
//! | module | what |
//! |---|---|
//! | [`depth`] | worn depth at the points of a lattice, as a part of the gap |
//! | [`running_in`] | contact and wear in turn, until the sliding distance |
//!
//! Theory: Mixed lubrication.

pub mod depth;
pub mod running_in;

pub use running_in::{Worn, run_in};

/// How a body wears.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WearingBody {
    /// k, dimensionless.
    pub coefficient: f64,
    /// H, Pa.
    pub hardness: f64,
    /// L, m; `None` of a body at rest in the contact.
    pub track_length: Option<f64>,
}

/// Wear over a sliding distance.
#[derive(Clone, Debug, PartialEq)]
pub struct WearParams {
    /// Body 1 and body 2; `None` where a body does not wear.
    pub bodies: [Option<WearingBody>; 2],
    /// Sliding distance, m.
    pub distance: f64,
    /// Largest depth that both bodies together lose in a step, over the composite rms height.
    pub step: f64,
    /// Most steps.
    pub max_steps: usize,
}

impl WearParams {
    /// Default of `step`: a pressure of asperities falls to 1/e over 0.3 to 0.6 of the rms height, and explicit steps oscillate where one changes it by more than itself.
    pub const STEP: f64 = 0.1;

    /// Default of `max_steps`.
    pub const MAX_STEPS: usize = 400;
}

#[cfg(test)]
mod tests;
