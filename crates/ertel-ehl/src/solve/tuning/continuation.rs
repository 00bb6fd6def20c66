//! Continuations through easier contacts, and when they are given up.

/// Steps that may be halved in one continuation.
pub const MAX_HALVED_STEPS: usize = 6;

/// The same for fluids whose shear rate grows exponentially with the stress, whose steps are small and cheap.
pub const MAX_HALVED_EXPONENTIAL_STEPS: usize = 12;

/// Error bar of a film up to which a refined mesh that fails with a diffused ridge is not tried again.
pub const GOOD_ENOUGH: f64 = 0.04;

/// Softnesses of an exponential: stress of an e-fold, over that of the law, or its root for Eyring's stress. From each to the next
/// the e-folds of the shear rate of a stress beyond the limit triple.
pub const SOFTNESS: [f64; 7] = [750.0, 250.0, 81.0, 27.0, 9.0, 3.0, 1.0];

/// The one of them at which friction, and the heat of it, is already near that of the law.
pub const MEDIUM_SOFTNESS: f64 = 27.0;

/// Shares θ of the sliding from step to step.
pub const SLIDING: [f64; 7] = [0.03, 0.1, 0.25, 0.45, 0.65, 0.85, 1.0];

/// Isotropic diffusion ρ_id from step to step, between that of a start and none.
pub const DIFFUSION: [f64; 4] = [1.0, 0.25, 0.06, 0.015];

/// Multiples of the case's speed from step to step, before its own.
pub const SPEEDS: [f64; 5] = [32.0, 16.0, 8.0, 4.0, 2.0];

/// Film in the middle at such a speed, in b²/R, up to which a contact is led down from there: thicker ones have other shapes, and other
/// difficulties.
pub const THICKEST: f64 = 0.2;

/// Exponents θ of the viscosity, μ̄^θ, from step to step.
pub const EXPONENTS: [f64; 5] = [0.4, 0.6, 0.75, 0.88, 1.0];

/// Order to which pressures are lowered where they do not converge: those that overshoot little at a spike that the mesh does not resolve.
pub const LOWER_ORDER: usize = 2;

/// Exponent of the speed in the central film of heavily loaded contacts (Hamrock and Dowson, J. Lubr. Technol. 99 (1977), 264-276).
pub const FILM_EXPONENT: f64 = 0.67;

/// Ratio of two values below which the step between them is not halved: of the diffusion, the exponent, the softness, the sliding and the speed.
pub const NEAR: [f64; 5] = [1.4, 1.02, 1.2, 1.04, 1.1];
