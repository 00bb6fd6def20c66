//! Potentials of piecewise polynomial densities on a surface or a line, φ(x) = ∫ p(y) K(|x − y|) dy.
//!
//! The density has nodal values in a Lagrange space; the potential is wanted at points of the same plane. Elements around a point are integrated
//! in closed form ([`integrals`]), the others by Gauss sums whose far field is evaluated by expansions: work and memory grow
//! like the number of elements. Products are exact transposes of each other up to rounding, and have the same
//! bits on any number of threads.

mod expansion;
mod far;
pub mod integrals;
mod kernel;
mod lanes;
mod near;
mod near_blocks;
mod number;
mod sources;
mod tree;

use crate::mesh::SimplexMesh;
use crate::space::Space;

use expansion::Basis;
use far::{FarField, Links};
use integrals::ElementIntegrals;
use near::NearField;
use number::Number;
use sources::{Sources, target_ends};
use tree::Tree;

pub use kernel::Kernel;

/// How accurate a product is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Accuracy {
    /// For states and residuals.
    Full,
    /// For Krylov iterations, in single precision.
    Krylov,
}

/// Degrees of the expansions, and sizes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PotentialParams {
    /// Total degrees below which expansions are cut, over a surface: full accuracy, Krylov.
    pub surface_degrees: [usize; 2],
    /// The same along a line.
    pub line_degrees: [usize; 2],
    /// Elements' worth of sources that a box holds at most.
    pub elements_per_box: usize,
}

impl Default for PotentialParams {
    fn default() -> Self {
        PotentialParams {
            surface_degrees: [11, 7],
            line_degrees: [20, 12],
            elements_per_box: 12,
        }
    }
}

/// The near field: where films are thin compared with the deflection, as along lines, single precision would be visible.
enum Near {
    Single(NearField<f32>),
    Double(NearField<f64>),
}

impl Near {
    fn bytes(&self) -> usize {
        match self {
            Near::Single(near) => near.bytes(),
            Near::Double(near) => near.bytes(),
        }
    }

    fn add<T: Number>(&self, density: &[T], sums: &mut [T]) {
        match self {
            Near::Single(near) => near.add(density, sums),
            Near::Double(near) => near.add(density, sums),
        }
    }
}

/// The potential of nodal densities at a list of points.
pub struct Potential {
    kernel: Kernel,
    tree: Tree,
    links: Links,
    full: FarField<f64>,
    krylov: FarField<f32>,
    near: Near,
}

impl Potential {
    /// Potential at `targets` of densities in `space`, a Lagrange space on `mesh` (segments: −ln r; triangles:
    /// 1/r). With `mirrored`, the density continues evenly beyond y = 0, and mesh and targets lie at y ≤ 0.
    pub fn new(
        mesh: &SimplexMesh,
        space: &Space,
        targets: &[[f64; 2]],
        mirrored: bool,
        params: &PotentialParams,
    ) -> Potential {
        let (kernel, degrees) = match mesh.dim {
            1 => (Kernel::Logarithm, params.line_degrees),
            _ => (Kernel::InverseDistance, params.surface_degrees),
        };
        let sources = Sources::new(mesh, space, kernel, mirrored);
        let most = params.elements_per_box * sources.per_element();
        let tree = Tree::new(&sources.points, targets, mirrored, most);
        let (links, near) = tree.lists();
        let basis = Basis::new(mesh.dim, degrees[0]);
        let few = Basis::new(mesh.dim, degrees[1]).len();
        let across = basis.shared_coefficients(kernel);
        let ends = [
            sources.ends(&tree, &basis),
            target_ends(&tree, targets, &basis),
        ];
        let integrals = ElementIntegrals::new(&space.element, kernel);
        Potential {
            kernel,
            full: FarField::new(&basis, basis.len(), &across, &ends[0], &ends[1]),
            krylov: FarField::new(&basis, few, &across, &ends[0], &ends[1]),
            near: match kernel {
                Kernel::InverseDistance => {
                    Near::Single(NearField::new(&sources, targets, &tree, &near, &integrals))
                }
                Kernel::Logarithm => {
                    Near::Double(NearField::new(&sources, targets, &tree, &near, &integrals))
                }
            },
            links: Links::new(&links),
            tree,
        }
    }

    /// Bytes that it takes, about.
    pub fn bytes(&self) -> usize {
        self.near.bytes() + self.full.bytes() + self.krylov.bytes() + self.links.bytes()
    }

    /// Entries of the near field.
    pub fn near_entries(&self) -> usize {
        match &self.near {
            Near::Single(near) => near.entries(),
            Near::Double(near) => near.entries(),
        }
    }

    /// Potential at the targets of nodal densities.
    pub fn apply(&self, density: &[f64], accuracy: Accuracy) -> Vec<f64> {
        match accuracy {
            Accuracy::Full => self.product(&self.full, density),
            Accuracy::Krylov => self.product(&self.krylov, density),
        }
    }

    fn product<T: Number>(&self, far: &FarField<T>, density: &[f64]) -> Vec<f64> {
        let density: Vec<T> = density.iter().map(|v| T::from_f64(*v)).collect();
        let tree = &self.tree;
        let mut sums = far.apply(tree, &self.links, self.kernel, &density);
        // Leaves stand level by level, their targets in the order of the tree.
        let mut ordered = vec![T::default(); tree.target_order.len()];
        for (column, sum) in far.targets.columns.iter().zip(&sums) {
            ordered[*column as usize] = *sum;
        }
        self.near.add(&density, &mut ordered);
        sums.clear();
        let mut out = vec![0.0; ordered.len()];
        for (target, sum) in tree.target_order.iter().zip(&ordered) {
            out[*target as usize] = sum.to_f64();
        }
        out
    }
}

#[cfg(test)]
mod tests;
