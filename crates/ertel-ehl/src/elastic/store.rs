//! Where elastic responses may be kept from one solve to the next. The solver knows this trait alone; files are written by its users.

use std::fmt;

use ertel_fem::mesh::BodyMesh;

use super::CondensedResponse;

/// Cells of a body below which its response is built about as soon as looked up.
pub const SMALLEST: usize = 1_000;

/// All that determines an elastic response.
#[derive(Clone, Copy, Debug)]
pub struct Operator<'a> {
    /// Mesh of the body.
    pub body: &'a BodyMesh,
    /// Lagrange order of the displacement.
    pub elastic_order: usize,
    /// Poisson's ratio.
    pub poissons_ratio: f64,
    /// Surface nodes.
    pub n: usize,
    /// Pairs of them that are near to each other.
    pub n_near: usize,
}

/// Keeps elastic responses.
pub trait OperatorStore: fmt::Debug + Send + Sync {
    /// The response with the number of displacement unknowns, if it is there and good.
    fn get(&self, operator: &Operator<'_>) -> Option<(CondensedResponse, usize)>;

    /// Keeps a response; that it cannot is no error.
    fn put(&self, operator: &Operator<'_>, response: &CondensedResponse, n_displacement: usize);

    /// Warnings since the last call.
    fn take_warnings(&self) -> Vec<String>;
}
