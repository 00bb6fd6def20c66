//! Newton's method on the film and its linear systems.

/// Residual, over the entrained flow, beyond which an exponential dominates it.
pub const FAR_OUT: f64 = 2.0;

/// Factor by which one step may raise it there: some e-folds, which the next takes off.
pub const MOST_RISE: f64 = 1e4;

/// Multiple of a step that is tried at most.
pub const LONGEST_STRIDE: f64 = 64.0;

/// Share of a step below which an exponential is not to be kept off.
pub const SMALLEST_EXPONENTIAL_SHARE: f64 = 1e-4;

/// Order of convergence by which the next update is predicted: below 2, for linear systems are solved
/// inexactly.
pub const PREDICTED_ORDER: f64 = 1.5;

/// Update, in p_h, above which the next is not predicted: a step that is small by chance after a much larger one proves nothing (Barus,
/// M = 200, L = 10 on a mesh refined at the ridge: 20, then 0.7, then 9).
pub const PREDICTED_FROM: f64 = 0.5;

/// Krylov iterations for a factor of a thousand above which the preconditioner is rebuilt, in line and in circular
/// contacts, where it costs as much as some ten iterations.
pub const STALE_EFFORT: [f64; 2] = [20.0, 10.0];

/// Krylov iterations after which a solve with an old preconditioner is given up.
pub const MOST_STALE_ITERATIONS: usize = 40;
