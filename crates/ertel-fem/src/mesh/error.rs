//! Why a mesh cannot be built.

/// Why a mesh could not be built.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MeshError {
    /// A parameter is outside its range.
    #[error("mesh parameter {name} = {value}: {expected}")]
    Parameter {
        /// name of the parameter
        name: &'static str,
        /// the value given
        value: f64,
        /// the requirement
        expected: &'static str,
    },
    /// The size field is not a positive number somewhere in the body.
    #[error("size field is {value} at {point:?}: must be positive")]
    Size {
        /// the value returned
        value: f64,
        /// where
        point: [f64; 3],
    },
    /// No grid of near-cubic start cells fits: the box is very flat, or its sides pass the patch at a small distance.
    #[error(
        "box of width {width} and depth {depth} does not take near-cubic cells: too flat, or a side almost at the patch"
    )]
    Proportions {
        /// box width
        width: f64,
        /// box depth
        depth: f64,
    },
    /// The size field asks for too many cells.
    #[error("mesh exceeds {limit} cells: the size field is too fine")]
    TooManyCells {
        /// the largest number of cells allowed
        limit: usize,
    },
}
