//! Sources and targets: elements with their Gauss points, and operators between nodal values or targets and expansions.

use super::Kernel;
use super::expansion::Basis;
use super::far::Ends;
use super::tree::{Cell, Tree};
use crate::linear::dense::{add_product, vectorised};
use crate::mesh::SimplexMesh;
use crate::quadrature::Quadrature;
use crate::space::{Affine, Space};

/// The density's elements and their Gauss points.
pub(crate) struct Sources<'a> {
    pub(super) space: &'a Space,
    pub(super) kernel: Kernel,
    pub(super) mirrored: bool,
    pub(super) corners: Vec<[f64; 2]>,
    pub(super) determinants: Vec<f64>,
    pub(super) rule: Quadrature,
    pub(super) table: Vec<f64>,
    /// Element by element.
    pub(super) points: Vec<[f64; 2]>,
}

impl<'a> Sources<'a> {
    pub(super) fn new(
        mesh: &SimplexMesh,
        space: &'a Space,
        kernel: Kernel,
        mirrored: bool,
    ) -> Sources<'a> {
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

    pub(super) fn n_elements(&self) -> usize {
        self.determinants.len()
    }

    pub(super) fn per_element(&self) -> usize {
        self.rule.len()
    }

    pub(super) fn vertices(&self, element: usize) -> &[[f64; 2]] {
        let n = self.space.element.dim() + 1;
        &self.corners[element * n..(element + 1) * n]
    }

    pub(super) fn bounds(&self, element: usize) -> ([f64; 2], [f64; 2]) {
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for v in self.vertices(element) {
            for a in 0..2 {
                low[a] = low[a].min(v[a]);
                high[a] = high[a].max(v[a]);
            }
        }
        (low, high)
    }

    pub(super) fn weight(&self, element: usize, q: usize) -> f64 {
        self.determinants[element] * self.rule.weights[q]
    }

    /// Shape functions at a Gauss point.
    pub(super) fn shapes(&self, q: usize) -> &[f64] {
        let n = self.space.element.n_nodes();
        &self.table[q * n..(q + 1) * n]
    }

    /// Operators from nodal densities to moments of the leaves.
    pub(super) fn ends(&self, tree: &Tree, basis: &Basis) -> Ends<f64> {
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
pub(super) fn target_ends(tree: &Tree, targets: &[[f64; 2]], basis: &Basis) -> Ends<f64> {
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
