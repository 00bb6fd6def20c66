//! Diffusion at ridges of the pressure.

/// e₀, error of the pressure in p_h from which a ridge is diffused (decision 0023).
pub const SCALE: f64 = 0.005;

/// Shares of the diffusion are multiples of one over this, so that rounding errors of the previous mesh do not change the equations.
pub const STEPS: f64 = 64.0;

/// Height that diffusion may remove from a ridge, over the range of the pressure in the element. Measured on ball on disc, M = 199, next to
/// the centreline: 0.75 GPa with 13,700 pressures, 1.15 GPa with 48,000, and 1.28 GPa with 261,000 without diffusion.
pub const CUT_OFF: f64 = 0.75;

/// Share from which an element counts as one of a ridge without diffusion.
pub const OWN_RIDGE: f64 = 0.5;
