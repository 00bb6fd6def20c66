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
mod params;
pub mod running_in;

pub use params::{WearParams, WearingBody};
pub use running_in::{Worn, run_in};

#[cfg(test)]
mod tests;
