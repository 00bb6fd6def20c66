//! First meshes, and the search for extreme films on them.

/// Where the crescent of finer cells at the outlet begins, X.
pub const OUTLET_FROM: f64 = -0.3;

/// Share of s² or s that a cell of the longest edge s covers on average, in circular and in line contacts: halved until they are
/// small enough, cells are smaller than that. Measured.
pub const COVERED: [f64; 2] = [0.125, 0.75];

/// Elements in which the smallest film is searched for: the one with the thinnest point of the lattice need not have it.
pub const THINNEST_ELEMENTS: usize = 6;

/// Points per edge of the lattice on which the thinnest point of an element is searched for.
pub const THINNEST_LATTICE: usize = 4;
