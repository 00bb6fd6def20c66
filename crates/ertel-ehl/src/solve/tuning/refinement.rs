//! Which elements are halved, and when refinement ends.

/// Displacement unknowns of a finite-element body per pressure unknown allowed.
pub const BODY_SHARE: usize = 10;

/// Ratio of the estimate of a film after halving the elements to that before, in line and in circular contacts: 1/32 for smooth errors; at
/// free boundaries and spikes much larger.
pub const FILM_HALVING_RATIO: [f64; 2] = [0.125, 0.06];

/// Ratio of the square of the pressure error after halving the elements to that before: at a ridge with a sharp side, 1/2.
pub const PRESSURE_HALVING_RATIO: f64 = 0.4;

/// Growth of the body's unknowns over that of the elements on its contact area: cells away from it stay as
/// they are. Measured on circular contacts: 0.38.
pub const BODY_GROWTH: f64 = 0.5;

/// Growth of a mesh below which refining it is not worth a factorisation.
pub const LEAST_GROWTH: f64 = 1.2;

/// Growth of a mesh in one refinement, at most: for the films alone, and for the pressure, whose ridge is not where a coarse mesh
/// puts it.
pub const LARGEST_GROWTH: [f64; 2] = [4.0, 2.5];

/// Usual shares of a film's target for cells and for pressures that are not resolved: 0.8² + 0.6² = 1.
pub const SHARES: [f64; 2] = [0.8, 0.6];

/// Largest share of a film's target that is given to unresolved pressures which refinement does not address.
pub const MAX_UNRESOLVED_SHARE: f64 = 0.9;

/// Error bars of the films, over their target, from which on a mesh is refined for films and pressure at once.
pub const NEAR_TARGET: f64 = 4.0;

/// Share of the elements for which alone a mesh is not refined again, where films meet their target and the pressure
/// nearly does.
pub const FEW_ELEMENTS_SHARE: f64 = 0.01;

/// Multiple of the pressure's target that counts as reached.
pub const AS_GOOD_AS_REACHED: f64 = 1.5;

/// Share of the target that the cells are allowed at least, whatever the edges do.
pub const MIN_SHARE_OF_CELLS: f64 = 0.5;

/// Share of the target that the estimate aims at: refinement may fall short.
pub const GOAL: f64 = 0.6;

/// Share of the target up to which a film's own estimate asks for no refinement where the other's does.
pub const OWN_SHARE: f64 = 0.9;

/// The same for the pressure, whose estimate is no bound.
pub const PRESSURE_GOAL: f64 = 0.9;

/// Share of the square of the pressure's estimate that a refinement aims at, at least: cells that are made too fine at a wrong place are of no
/// use.
pub const SMALLEST_PRESSURE_GOAL: f64 = 0.2;

/// The same at most: a ridge is not where a coarse mesh puts it.
pub const LARGEST_PRESSURE_GOAL: f64 = 0.7;

/// Share of a film's estimate that a refinement aims at, at least: a coarse mesh does not predict the next but two.
/// Measured on slender ellipses at M = 1,000: with 2 % the last mesh has two thirds of the elements that it has without.
pub const SMALLEST_GOAL: f64 = 0.02;

/// Share of a film's estimate that a refinement aims at, at most. With less refinement the few largest shares
/// go, and of the error, which is a sum of shares of both signs, much more stays than of the estimate.
pub const LARGEST_GOAL: f64 = 0.125;

/// The same where the estimates of both films are good enough, and a mesh that differs is enough to confirm them.
pub const CONFIRMING_GOAL: f64 = 0.4;

/// Halvings of one element in one refinement.
pub const MOST_HALVINGS: u32 = 2;

/// Elements that a refinement adds, over those requested: conformity requires more.
pub const CLOSURE: f64 = 1.5;

/// Film at a minimum, over the lowest, up to which it may come to be the lowest on a finer mesh.
pub const NEARLY_AS_DEEP: f64 = 1.3;

/// Height of the ridge between two minima, over the higher of them, from which they are two.
pub const RIDGE: f64 = 1.05;
