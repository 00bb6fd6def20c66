//! Assembly of symmetric vector-valued forms into compressed sparse columns.

use rayon::prelude::*;

use crate::space::Space;

/// Marks a constrained component: it has no equation.
pub const CONSTRAINED: u32 = u32::MAX;

/// Degrees of freedom of a vector field: `n_components` per node, numbered node by node.
#[derive(Clone, Debug)]
pub struct DofMap {
    /// Components per node.
    pub n_components: usize,
    /// `[node * n_components + component]`, or [`CONSTRAINED`].
    pub dofs: Vec<u32>,
    /// Number of unknowns.
    pub n_dofs: usize,
}

impl DofMap {
    /// Numbers every component for which `free(node, component)` holds.
    pub fn new(n_nodes: usize, n_components: usize, free: impl Fn(usize, usize) -> bool) -> DofMap {
        let mut n_dofs = 0;
        let mut dofs = vec![CONSTRAINED; n_nodes * n_components];
        for node in 0..n_nodes {
            for c in 0..n_components {
                if free(node, c) {
                    dofs[node * n_components + c] = n_dofs as u32;
                    n_dofs += 1;
                }
            }
        }
        DofMap {
            n_components,
            dofs,
            n_dofs,
        }
    }

    /// The unknowns of one node, in order of components.
    pub fn of_node(&self, node: usize) -> &[u32] {
        &self.dofs[node * self.n_components..(node + 1) * self.n_components]
    }
}

/// Neighbours of each node (itself included), ascending; compressed rows.
#[derive(Clone, Debug)]
pub struct NodeGraph {
    /// Row starts.
    pub offsets: Vec<usize>,
    /// Neighbours.
    pub neighbours: Vec<u32>,
}

impl NodeGraph {
    /// Two nodes are neighbours when an element has both.
    pub fn new(space: &Space) -> NodeGraph {
        let n_nodes = space.n_nodes();
        let n_local = space.element.n_nodes();
        let mut starts = vec![0usize; n_nodes + 1];
        for n in &space.element_nodes {
            starts[*n as usize + 1] += 1;
        }
        for i in 0..n_nodes {
            starts[i + 1] += starts[i];
        }
        let mut fill = starts.clone();
        let mut elements = vec![0u32; space.element_nodes.len()];
        for (i, n) in space.element_nodes.iter().enumerate() {
            elements[fill[*n as usize]] = (i / n_local) as u32;
            fill[*n as usize] += 1;
        }
        let rows: Vec<Vec<u32>> = (0..n_nodes)
            .into_par_iter()
            .map(|n| {
                let mut row: Vec<u32> = elements[starts[n]..starts[n + 1]]
                    .iter()
                    .flat_map(|e| space.nodes_of(*e as usize).iter().copied())
                    .collect();
                row.sort_unstable();
                row.dedup();
                row
            })
            .collect();
        let mut offsets = vec![0];
        let mut neighbours = Vec::new();
        for row in rows {
            neighbours.extend(row);
            offsets.push(neighbours.len());
        }
        NodeGraph {
            offsets,
            neighbours,
        }
    }

    /// Neighbours of one node.
    pub fn of(&self, node: usize) -> &[u32] {
        &self.neighbours[self.offsets[node]..self.offsets[node + 1]]
    }

    /// Number of nodes.
    pub fn n_nodes(&self) -> usize {
        self.offsets.len() - 1
    }
}

/// Upper triangle of a symmetric matrix in compressed columns.
#[derive(Clone, Debug)]
pub struct SymmetricMatrix {
    /// Order of the matrix.
    pub n: usize,
    /// Column starts.
    pub col_ptr: Vec<usize>,
    /// Rows, ascending in each column, none below the diagonal.
    pub row_idx: Vec<usize>,
    /// Values.
    pub values: Vec<f64>,
}

impl SymmetricMatrix {
    /// y = A x.
    pub fn multiply(&self, x: &[f64]) -> Vec<f64> {
        let mut y = vec![0.0; self.n];
        for j in 0..self.n {
            for k in self.col_ptr[j]..self.col_ptr[j + 1] {
                let i = self.row_idx[k];
                y[i] += self.values[k] * x[j];
                if i != j {
                    y[j] += self.values[k] * x[i];
                }
            }
        }
        y
    }
}

/// Unknowns of a node that are not constrained.
fn active(dofs: &DofMap, node: usize) -> impl Iterator<Item = usize> + '_ {
    let own = dofs.of_node(node).iter().filter(|d| **d != CONSTRAINED);
    own.map(|d| *d as usize)
}

/// Where columns start, and where the block of each neighbour starts in a column: the blocks of all neighbours a < b, then the node's own upper
/// triangle.
fn columns(graph: &NodeGraph, dofs: &DofMap) -> (Vec<usize>, Vec<u32>) {
    let mut col_ptr = vec![0usize; dofs.n_dofs + 1];
    let mut block_start = vec![0u32; graph.neighbours.len()];
    for b in 0..graph.n_nodes() {
        let mut height = 0;
        for k in graph.offsets[b]..graph.offsets[b + 1] {
            let a = graph.neighbours[k] as usize;
            block_start[k] = height as u32;
            if a < b {
                height += active(dofs, a).count();
            }
        }
        for (own, d) in active(dofs, b).enumerate() {
            col_ptr[d + 1] = height + own + 1;
        }
    }
    for j in 0..dofs.n_dofs {
        col_ptr[j + 1] += col_ptr[j];
    }
    (col_ptr, block_start)
}

/// Rows of the entries, column by column.
fn rows(graph: &NodeGraph, dofs: &DofMap, col_ptr: &[usize]) -> Vec<usize> {
    let mut row_idx = vec![0; col_ptr[dofs.n_dofs]];
    for b in 0..graph.n_nodes() {
        for d in active(dofs, b) {
            let mut k = col_ptr[d];
            let end = col_ptr[d + 1];
            for a in graph.of(b).iter().take_while(|a| **a as usize <= b) {
                for e in active(dofs, *a as usize) {
                    if k < end {
                        row_idx[k] = e;
                        k += 1;
                    }
                }
            }
        }
    }
    row_idx
}

/// Sums element matrices over all elements.
///
/// `element_matrix(cell, out)` fills a row-major square matrix whose index is
/// `local_node * n_components + component`; only its symmetry is relied upon.
pub fn assemble_symmetric(
    space: &Space,
    graph: &NodeGraph,
    dofs: &DofMap,
    element_matrix: impl Fn(usize, &mut [f64]) + Sync,
) -> SymmetricMatrix {
    let nc = dofs.n_components;
    let n_local = space.element.n_nodes();
    let (col_ptr, block_start) = columns(graph, dofs);
    let row_idx = rows(graph, dofs, &col_ptr);

    // Element matrices in parallel, scatter in order: the sum does not depend on threads.
    let size = n_local * nc;
    let mut values = vec![0.0; row_idx.len()];
    let chunk = 2048;
    let mut buffer = vec![0.0; chunk * size * size];
    for first in (0..space.n_elements()).step_by(chunk) {
        let n = chunk.min(space.n_elements() - first);
        buffer[..n * size * size]
            .par_chunks_mut(size * size)
            .enumerate()
            .for_each(|(e, out)| element_matrix(first + e, out));
        for e in 0..n {
            let matrix = &buffer[e * size * size..(e + 1) * size * size];
            let nodes = space.nodes_of(first + e);
            for (lb, b) in nodes.iter().enumerate() {
                let b = *b as usize;
                for (la, a) in nodes.iter().enumerate().filter(|(_, a)| **a as usize <= b) {
                    let a = *a as usize;
                    let slot = graph.of(b).binary_search(&(a as u32)).expect("neighbours");
                    let start = block_start[graph.offsets[b] + slot] as usize;
                    for (n, column) in dofs.of_node(b).iter().enumerate() {
                        if *column == CONSTRAINED {
                            continue;
                        }
                        let mut k = col_ptr[*column as usize] + start;
                        for (m, row) in dofs.of_node(a).iter().enumerate() {
                            if *row == CONSTRAINED || *row > *column {
                                continue;
                            }
                            values[k] += matrix[(la * nc + m) * size + lb * nc + n];
                            k += 1;
                        }
                    }
                }
            }
        }
    }
    SymmetricMatrix {
        n: dofs.n_dofs,
        col_ptr,
        row_idx,
        values,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::SimplexMesh;

    /// Against a dense sum of the same element matrices, with constraints.
    #[test]
    fn sparse_assembly_equals_dense() {
        let mesh = SimplexMesh {
            dim: 2,
            axes: [0, 1, 2],
            vertices: vec![
                [0.0, 0.0, 0.0],
                [1.0, 0.0, 0.0],
                [0.0, 1.0, 0.0],
                [1.0, 1.0, 0.0],
                [2.0, 0.5, 0.0],
            ],
            cells: vec![[0, 1, 2, 0], [3, 2, 1, 0], [1, 4, 3, 0]],
        };
        let space = Space::new(&mesh, 2);
        let graph = NodeGraph::new(&space);
        let dofs = DofMap::new(space.n_nodes(), 2, |n, c| (n + c) % 4 != 0);
        let size = 12;
        let kernel = |cell: usize, out: &mut [f64]| {
            for i in 0..size {
                for j in 0..size {
                    out[i * size + j] =
                        (cell + 1) as f64 * ((i + j) as f64).sin() + if i == j { 5.0 } else { 0.0 };
                }
            }
        };
        let matrix = assemble_symmetric(&space, &graph, &dofs, kernel);
        let mut dense = vec![vec![0.0; dofs.n_dofs]; dofs.n_dofs];
        let mut local = vec![0.0; size * size];
        for cell in 0..3 {
            kernel(cell, &mut local);
            for i in 0..size {
                for j in 0..size {
                    let nodes = space.nodes_of(cell);
                    let di = dofs.of_node(nodes[i / 2] as usize)[i % 2];
                    let dj = dofs.of_node(nodes[j / 2] as usize)[j % 2];
                    if di != CONSTRAINED && dj != CONSTRAINED {
                        dense[di as usize][dj as usize] += local[i * size + j];
                    }
                }
            }
        }
        let x: Vec<f64> = (0..dofs.n_dofs).map(|i| (i as f64 * 0.7).cos()).collect();
        for (row, y) in dense.iter().zip(matrix.multiply(&x)) {
            let exact: f64 = row.iter().zip(&x).map(|(a, b)| a * b).sum();
            approx::assert_relative_eq!(y, exact, epsilon = 1e-11);
        }
        for j in 0..matrix.n {
            let rows = &matrix.row_idx[matrix.col_ptr[j]..matrix.col_ptr[j + 1]];
            assert!(rows.is_sorted() && rows.last() == Some(&j));
        }
    }
}
