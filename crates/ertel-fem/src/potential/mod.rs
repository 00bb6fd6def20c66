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
mod tree;

use crate::linear::dense::{Real, add_product, vectorised};
use crate::mesh::SimplexMesh;
use crate::quadrature::Quadrature;
use crate::space::{Affine, Space};

use expansion::Basis;
use far::{Direction, Ends, FarField, Links};
use integrals::ElementIntegrals;
use near::NearField;
use tree::{Cell, Link, Tree};

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

/// Numbers of expansions, entries and sums.
pub(crate) trait Number: Real + Sync {
    /// Numbers in the widest vector.
    const LANES: usize;
    fn from_f64(v: f64) -> Self;
    fn to_f64(self) -> f64;
}

impl Number for f32 {
    const LANES: usize = 16;
    #[inline(always)]
    fn from_f64(v: f64) -> f32 {
        v as f32
    }
    #[inline(always)]
    fn to_f64(self) -> f64 {
        f64::from(self)
    }
}

impl Number for f64 {
    const LANES: usize = 8;
    #[inline(always)]
    fn from_f64(v: f64) -> f64 {
        v
    }
    #[inline(always)]
    fn to_f64(self) -> f64 {
        self
    }
}

/// Σ a_i b_i in the precision of the second, several sums side by side.
#[inline(always)]
fn mixed_dot<S: Number, T: Number>(a: &[S], b: &[T]) -> T {
    const L: usize = 16;
    let convert = |v: S| T::from_f64(v.to_f64());
    let mut sums = [T::default(); L];
    let (xs, ys) = (a.chunks_exact(L), b.chunks_exact(L));
    let rest = xs.remainder().iter().zip(ys.remainder());
    for (x, y) in xs.zip(ys) {
        for l in 0..L {
            sums[l] += convert(x[l]) * y[l];
        }
    }
    // Halves onto halves: vectors, where one by one would wait for each addition.
    let mut half = L / 2;
    while half > 0 {
        for l in 0..half {
            let other = sums[l + half];
            sums[l] += other;
        }
        half /= 2;
    }
    let mut sum = sums[0];
    for (x, y) in rest {
        sum += convert(*x) * *y;
    }
    sum
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

    fn transposed<T: Number>(&self, values: &[T]) -> Vec<T> {
        match self {
            Near::Single(near) => near.transposed(values),
            Near::Double(near) => near.transposed(values),
        }
    }
}

/// The density's elements and their Gauss points.
pub(crate) struct Sources<'a> {
    space: &'a Space,
    kernel: Kernel,
    mirrored: bool,
    corners: Vec<[f64; 2]>,
    determinants: Vec<f64>,
    rule: Quadrature,
    table: Vec<f64>,
    /// Element by element.
    points: Vec<[f64; 2]>,
}

impl<'a> Sources<'a> {
    fn new(mesh: &SimplexMesh, space: &'a Space, kernel: Kernel, mirrored: bool) -> Sources<'a> {
        // Degree k of the density and several more of the kernel; along lines more points cost next to nothing.
        let degrees = if mesh.dim == 1 { 6 } else { 2 };
        let rule = Quadrature::simplex(mesh.dim, 2 * (space.element.order() + degrees));
        let table = (rule.points.iter()).flat_map(|xi| space.element.values(*xi));
        let corners: Vec<[f64; 2]> = (0..mesh.n_cells())
            .flat_map(|c| mesh.cell(c))
            .map(|v| mesh.vertices[*v as usize])
            .map(|p| [p[0], p[1]])
            .collect();
        let n = mesh.dim + 1;
        let points = (corners.chunks_exact(n))
            .flat_map(|v| {
                rule.points.iter().map(move |xi| {
                    [0, 1].map(|a: usize| {
                        v[0][a] + (1..n).map(|k| xi[k - 1] * (v[k][a] - v[0][a])).sum::<f64>()
                    })
                })
            })
            .collect();
        Sources {
            space,
            kernel,
            mirrored,
            determinants: (0..mesh.n_cells())
                .map(|c| Affine::new(mesh, c).determinant.abs())
                .collect(),
            table: table.collect(),
            corners,
            rule,
            points,
        }
    }

    fn n_elements(&self) -> usize {
        self.determinants.len()
    }

    fn per_element(&self) -> usize {
        self.rule.len()
    }

    fn vertices(&self, element: usize) -> &[[f64; 2]] {
        let n = self.space.element.dim() + 1;
        &self.corners[element * n..(element + 1) * n]
    }

    fn bounds(&self, element: usize) -> ([f64; 2], [f64; 2]) {
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for v in self.vertices(element) {
            for a in 0..2 {
                low[a] = low[a].min(v[a]);
                high[a] = high[a].max(v[a]);
            }
        }
        (low, high)
    }

    fn weight(&self, element: usize, q: usize) -> f64 {
        self.determinants[element] * self.rule.weights[q]
    }

    /// Shape functions at a Gauss point.
    fn shapes(&self, q: usize) -> &[f64] {
        let n = self.space.element.n_nodes();
        &self.table[q * n..(q + 1) * n]
    }

    /// Operators from nodal densities to moments of the leaves.
    fn ends(&self, tree: &Tree, basis: &Basis) -> Ends<f64> {
        let per_element = self.per_element();
        ends_of_leaves(tree, |cell, centre, half| {
            let own = &tree.source_order[cell.sources.clone()];
            let element = |s: &u32| *s as usize / per_element;
            let mut nodes: Vec<u32> = Vec::new();
            let mut last = usize::MAX;
            for s in own {
                if element(s) != last {
                    last = element(s);
                    nodes.extend(self.space.nodes_of(last));
                }
            }
            nodes.sort_unstable();
            nodes.dedup();
            let mut columns = vec![0.0; nodes.len() * basis.len()];
            let (mut values, mut weights) = (Vec::new(), Vec::new());
            for own in own.chunk_by(|s, t| element(s) == element(t)) {
                let e = element(&own[0]);
                values.resize(own.len() * basis.len(), 0.0);
                for (s, values) in own.iter().zip(values.chunks_exact_mut(basis.len())) {
                    let y = self.points[*s as usize];
                    let y = [0, 1].map(|a: usize| (y[a] - centre[a]) / half);
                    basis.values(y, values);
                }
                for (j, node) in self.space.nodes_of(e).iter().enumerate() {
                    let at = nodes.binary_search(node).expect("listed above") * basis.len();
                    let column = &mut columns[at..at + basis.len()];
                    weights.clear();
                    weights.extend(own.iter().map(|s| {
                        let q = *s as usize % per_element;
                        self.weight(e, q) * self.shapes(q)[j]
                    }));
                    vectorised(|| add_product(&values, &weights, column));
                }
            }
            (nodes, columns)
        })
    }
}

/// Places and operators of all leaves; `of_leaf` has the cell, its centre and its half-width.
fn ends_of_leaves(
    tree: &Tree,
    of_leaf: impl Fn(&Cell, [f64; 2], f64) -> (Vec<u32>, Vec<f64>) + Sync,
) -> Ends<f64> {
    use rayon::prelude::*;
    let of_cell = |c: usize| match &tree.cells[c] {
        cell if cell.is_leaf() => {
            let (centre, half) = tree.frame(c);
            of_leaf(cell, centre, half)
        }
        _ => (Vec::new(), Vec::new()),
    };
    collect_ends((0..tree.cells.len()).into_par_iter().map(of_cell).collect())
}

/// Operators from local expansions to the targets of the leaves.
fn target_ends(tree: &Tree, targets: &[[f64; 2]], basis: &Basis) -> Ends<f64> {
    ends_of_leaves(tree, |cell, centre, half| {
        let own = cell.targets.clone();
        let mut columns = vec![0.0; own.len() * basis.len()];
        for (target, column) in tree.target_order[own.clone()]
            .iter()
            .zip(columns.chunks_exact_mut(basis.len()))
        {
            let x = targets[*target as usize];
            basis.values([0, 1].map(|a: usize| (x[a] - centre[a]) / half), column);
        }
        // by place in the order of the tree
        (own.map(|t| t as u32).collect(), columns)
    })
}

fn collect_ends(leaves: Vec<(Vec<u32>, Vec<f64>)>) -> Ends<f64> {
    let mut ends = Ends::default();
    for (columns, values) in leaves {
        let start = ends.columns.len();
        ends.columns.extend(columns);
        ends.values.extend(values);
        ends.ranges.push(start..ends.columns.len());
    }
    ends
}

/// The potential of nodal densities at a list of points.
pub struct Potential {
    kernel: Kernel,
    n_nodes: usize,
    tree: Tree,
    forward: Links,
    backward: Links,
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
        let (forward, near) = tree.lists();
        let backward = reversed(&forward);
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
            n_nodes: space.n_nodes(),
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
            forward: Links::new(&forward),
            backward: Links::new(&backward),
            tree,
        }
    }

    /// Bytes that it takes, about.
    pub fn bytes(&self) -> usize {
        let links = self.forward.bytes() + self.backward.bytes();
        self.near.bytes() + self.full.bytes() + self.krylov.bytes() + links
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

    /// The transpose: from values at the targets to nodes.
    pub fn apply_transposed(&self, values: &[f64], accuracy: Accuracy) -> Vec<f64> {
        match accuracy {
            Accuracy::Full => self.product_transposed(&self.full, values),
            Accuracy::Krylov => self.product_transposed(&self.krylov, values),
        }
    }

    fn product<T: Number>(&self, far: &FarField<T>, density: &[f64]) -> Vec<f64> {
        let density: Vec<T> = density.iter().map(|v| T::from_f64(*v)).collect();
        let (tree, forward) = (&self.tree, Direction::Forward);
        let mut sums = far.apply(tree, &self.forward, self.kernel, forward, &density);
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

    fn product_transposed<T: Number>(&self, far: &FarField<T>, values: &[f64]) -> Vec<f64> {
        let tree = &self.tree;
        let ordered: Vec<T> = (tree.target_order.iter())
            .map(|target| T::from_f64(values[*target as usize]))
            .collect();
        let parts = far.apply(
            tree,
            &self.backward,
            self.kernel,
            Direction::Backward,
            &ordered,
        );
        let near = self.near.transposed(&ordered);
        let mut out: Vec<f64> = near.iter().map(|v| v.to_f64()).collect();
        for (node, part) in far.sources.columns.iter().zip(&parts) {
            out[*node as usize] += part.to_f64();
        }
        debug_assert_eq!(out.len(), self.n_nodes);
        out
    }
}

/// The same links seen from their other ends.
fn reversed(links: &[Vec<Link>]) -> Vec<Vec<Link>> {
    let mut reversed = vec![Vec::new(); links.len()];
    for (target, links) in links.iter().enumerate() {
        for link in links {
            let [dx, dy] = link.offset;
            // The image of a box sees the image of the other where that sees the box: y stays.
            let offset = [-dx, if link.image { dy } else { -dy }];
            reversed[link.from as usize].push(Link {
                from: target as u32,
                image: link.image,
                offset,
            });
        }
    }
    reversed
}

#[cfg(test)]
mod tests;
