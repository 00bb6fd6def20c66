//! Error estimates and error bars of the films.

/// Smallest error claimed.
pub const SMALLEST_ERROR: f64 = 1e-4;

/// Error bar over the difference of two meshes, where there is no other estimate (Roache, J. Fluids Eng.
/// 116 (1994) 405-413).
pub const SAFETY_OF_DIFFERENCE: f64 = 3.0;

/// Error bar over the calibrated estimate.
pub const SAFETY: f64 = 4.0;

/// Least and largest factor by which the step from mesh to mesh corrects the estimate.
pub const CALIBRATION: (f64, f64) = (0.75, 4.0);

/// The factor where there is no mesh to calibrate by: errors of first meshes are up to four times their estimate.
pub const UNCALIBRATED: f64 = 3.0;

/// Error bar over the estimate of a first mesh.
pub const FIRST_BAR: f64 = SAFETY * UNCALIBRATED;

/// Error bar over the change by the diffusion at ridges by adjoints, which find at least four fifths of it (ball on disc, M = 199: h_c 0.53 % by adjoints, 0.61 % found).
pub const SAFETY_OF_RIDGE: f64 = 1.5;

/// Error bar over the estimated effect e of the edges of the contact area, and how it grows with e: the estimate is linear in the
/// pressure at the edges. Measured: within a tenth where e is below 0.5 % (ball on disc, M = 200), a half of what it should be
/// at 3 % (M = 5).
pub const SAFETY_OF_EDGES: [f64; 2] = [1.5, 100.0];

/// Largest relative bar for the effect of the edges: beyond it the estimate only shows that they are far too near.
pub const LARGEST_BAR_OF_EDGES: f64 = 10.0;

/// Share of the difference from the mesh before that is the least bar.
pub const LEAST_SHARE_OF_DIFFERENCE: f64 = 0.3;

/// Error of the films over that of the pressure, root mean square in p_h, in line and in point contacts: of ridges and spikes that are far from
/// resolved, the estimates of the films miss a part. Measured: line, M = 200, L = 15: 0.7 (h_min); circular, M = 200, L = 10: 0.06, M = 20, L = 25:
/// 0.065, M = 20, L = 10 without compressibility: 0.01.
pub const UNRESOLVED: [f64; 2] = [0.4, 0.06];

/// Distance, in sizes of the element there, up to which elements are around a place.
pub const AROUND: f64 = 1.5;

/// Constant c_U of the estimate's elastic part, measured on line and circular contacts.
pub const ELASTIC: f64 = 8.0;

/// Constant c_P of its part of the Reynolds equation, likewise.
pub const REYNOLDS: f64 = 2.0;

/// Share of what the length over which a gap fills up changes of the films that is added to the shares of the elements, and the least part
/// of the sizes of the elements' changes that it counts as, though they may cancel.
pub const BLURRING: [f64; 2] = [1.0, 0.5];

/// The same of the diffusion at a ridge, which has a separate bar ([`SAFETY_OF_RIDGE`]) and a share here so that refinement sees it.
pub const RIDGE: [f64; 2] = [RIDGE_SHARE, 0.1];

/// The first of the two.
pub const RIDGE_SHARE: f64 = 0.25;
