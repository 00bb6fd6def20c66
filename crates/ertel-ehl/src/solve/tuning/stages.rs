//! Stages: tolerances, penalty ramps and iteration limits of Newton's method by the role of a stage.

/// Shares of the full cavitation penalty in a start, where the free boundary is still
/// far from its place.
pub const PENALTY_RAMP: [f64; 2] = [1e-3, 1.0];

/// Shares of the penalty, by decades, for a stage in which the updates of Newton's method cycle: a penalty many times
/// the usual one makes pressures below zero so small that points at the free boundary go over to the
/// other side in each step.
pub const PENALTY_CONTINUATION: [f64; 4] = [1e-4, 1e-3, 1e-2, 1e-1];

/// Update, in p_h, at which a start is good enough.
pub const START_TOLERANCE: f64 = 3e-2;

/// Residual at which a solution is good enough to be measured.
pub const ROUGH_RESIDUAL: f64 = 1e-3;

/// Update, in p_h, at which it is: error bars have to hold (M = 200, L = 10: with 1e-2, the bar of h_min is 1.1e-3, and the error 1.4e-3).
pub const ROUGH_UPDATE: f64 = 1e-3;

/// Newton iterations that a start may take for each share of the penalty ramp.
pub const START_ITERATIONS: usize = 30;

/// Newton iterations of a start without a smaller update.
pub const START_STAGNATION: usize = 12;

/// Relative residual of a stalled start with which the rest of the ramp is not tried: that of the dry contact is
/// about 1.4, and starts that come through in the end have got it to 0.2 and mostly far below. Nothing starts from a state with more.
pub const DIVERGENCE_LIMIT: f64 = 0.5;

/// Film near an edge of a roller that presses in, over that in the centre, below which there is none. The thinnest film of 34 rollers
/// that are solved is a fifth of the central one at least; of 19 others it is less than this, near such an edge, in two stages.
pub const NO_FILM: f64 = 0.02;

/// Stages with less film than [`NO_FILM`] after which the end of a roller is taken to press in: the film of a first coarse mesh may be
/// negative and come back.
pub const STAGES_WITHOUT_END: usize = 2;

/// Pressure unknowns beyond which a mesh that is not refined is not started, by half-spaces and by finite-element bodies, whose
/// operator takes gigabytes.
pub const MOST_UNKNOWNS: [f64; 2] = [1e6, 4e4];

/// Cell size at the rim over that in the Hertz zone, below which a film is thin.
pub const THIN_RIM: f64 = 0.2;

/// Ratio of the predicted films beyond which the solution of a similar problem is no start.
pub const FARTHEST_FILM: f64 = 4.0;

/// Share of the predicted new minimum film that such a start has left at the least.
pub const LEAST_FILM: f64 = 0.5;
