//! Starts from the solution of a similar problem.

/// Ratio by which the contact area of a mesh or its cells are changed for the sake of a later problem.
pub const MOST_ROOM: f64 = 2.0;

/// The same for the contact area: far from the contact cells grow with the distance, and there are few.
pub const MOST_REACH: f64 = 5.0;

/// Ratio of the predicted films beyond which a start is too far away.
pub const FARTHEST_FILM: f64 = 4.0;

/// Ratio by which a contact area, measured from the centre, may fall short of what a problem needs.
pub const SHORTEST_REACH: f64 = 0.97;

/// Ratio by which it may exceed that: cells out there cost little.
pub const LONGEST_REACH: f64 = 6.0;

/// Ratio of cell sizes to those of a problem, where nothing is refined by estimates.
pub const COARSEST: f64 = 1.3;

/// The same where meshes are refined until the target is reached.
pub const COARSEST_REFINED: f64 = 3.0;

/// And how much finer they may be: a mesh that is too fine costs time.
pub const FINEST: f64 = 0.25;

/// Largest error bar, in targets, that is taken where the mesh of a start cannot be refined further: a separate
/// mesh might do better, for several times the time.
pub const LARGEST_MISS: f64 = 2.0;

/// The same over the error of the start's own mesh.
pub const MISS_GROWTH: f64 = 1.5;

/// Share of the predicted new minimum film that the rescaled start has left at the least.
pub const LEAST_FILM: f64 = 0.5;
