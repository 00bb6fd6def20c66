//! Continuous Lagrange spaces on simplicial meshes: global node numbers and affine geometry.

use rustc_hash::FxHashMap;

use crate::element::Lagrange;
use crate::mesh::SimplexMesh;
use crate::quadrature::Quadrature;

/// Identity of a node that does not depend on the cell it is seen from: the mesh vertices that
/// carry it and their barycentric weights in units of 1/order, sorted by vertex.
pub type NodeKey = [(u32, u8); 4];

const NO_VERTEX: (u32, u8) = (u32::MAX, 0);

/// Scalar Lagrange space.
#[derive(Clone, Debug)]
pub struct Space {
    /// The element.
    pub element: Lagrange,
    /// Global node of each element node, `[cell * element.n_nodes() + local]`.
    pub element_nodes: Vec<u32>,
    /// Coordinates of the global nodes.
    pub points: Vec<[f64; 3]>,
    keys: FxHashMap<NodeKey, u32>,
}

impl Space {
    /// Numbers the nodes of order `order` on every cell of the mesh.
    pub fn new(mesh: &SimplexMesh, order: usize) -> Space {
        let element = Lagrange::new(mesh.dim, order);
        let mut keys: FxHashMap<NodeKey, u32> = FxHashMap::default();
        let mut points = Vec::new();
        let mut element_nodes = Vec::with_capacity(mesh.cells.len() * element.n_nodes());
        for cell in &mesh.cells {
            for alpha in element.lattice() {
                let key = node_key(cell, alpha, mesh.dim, |v| v);
                let node = *keys.entry(key).or_insert_with(|| {
                    points.push(lattice_point(mesh, cell, alpha, order));
                    (points.len() - 1) as u32
                });
                element_nodes.push(node);
            }
        }
        Space {
            element,
            element_nodes,
            points,
            keys,
        }
    }

    /// The same with nodes numbered by their first coordinate.
    pub fn along_x(mut self) -> Space {
        let mut order: Vec<u32> = (0..self.n_nodes() as u32).collect();
        order.sort_by(|a, b| {
            let [a, b] = [a, b].map(|n| self.points[*n as usize]);
            a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1]))
        });
        let mut rank = vec![0; order.len()];
        for (new, old) in order.iter().enumerate() {
            rank[*old as usize] = new as u32;
        }
        self.points = order.iter().map(|n| self.points[*n as usize]).collect();
        let renumber = |node: &mut u32| *node = rank[*node as usize];
        self.element_nodes.iter_mut().for_each(renumber);
        self.keys.values_mut().for_each(renumber);
        self
    }

    /// Number of nodes.
    pub fn n_nodes(&self) -> usize {
        self.points.len()
    }

    /// Nodes of one cell.
    pub fn nodes_of(&self, cell: usize) -> &[u32] {
        let n = self.element.n_nodes();
        &self.element_nodes[cell * n..(cell + 1) * n]
    }

    /// Number of elements.
    pub fn n_elements(&self) -> usize {
        self.element_nodes.len() / self.element.n_nodes()
    }

    /// ∫N of each node.
    pub fn integrals(&self, mesh: &SimplexMesh) -> Vec<f64> {
        let rule = Quadrature::simplex(mesh.dim, self.element.order());
        let mut reference = vec![0.0; self.element.n_nodes()];
        for (xi, weight) in rule.points.iter().zip(&rule.weights) {
            for (sum, value) in reference.iter_mut().zip(self.element.values(*xi)) {
                *sum += weight * value;
            }
        }
        let mut integrals = vec![0.0; self.n_nodes()];
        for cell in 0..mesh.n_cells() {
            let determinant = Affine::new(mesh, cell).determinant.abs();
            for (node, value) in self.nodes_of(cell).iter().zip(&reference) {
                integrals[*node as usize] += determinant * value;
            }
        }
        integrals
    }

    /// The mesh vertices that carry each node (ascending, `u32::MAX` beyond the last): nodes of one
    /// vertex, edge or cell have the same.
    pub fn carriers(&self) -> Vec<[u32; 4]> {
        let mut carriers = vec![[u32::MAX; 4]; self.n_nodes()];
        for (key, node) in &self.keys {
            carriers[*node as usize] = key.map(|(vertex, _)| vertex);
        }
        carriers
    }

    /// For each node of this space on a surface mesh, the node of a body space of the same order.
    ///
    /// `to_body` maps surface vertices to body vertices.
    ///
    /// # Panics
    /// When a surface node does not lie on the body: the meshes do not belong together.
    pub fn trace_nodes(&self, surface: &SimplexMesh, to_body: &[u32], body: &Space) -> Vec<u32> {
        let mut map = vec![u32::MAX; self.n_nodes()];
        for (c, cell) in surface.cells.iter().enumerate() {
            for (local, alpha) in self.element.lattice().iter().enumerate() {
                let key = node_key(cell, alpha, surface.dim, |v| to_body[v as usize]);
                map[self.nodes_of(c)[local] as usize] = body.keys[&key];
            }
        }
        map
    }
}

fn node_key(cell: &[u32; 4], alpha: &[u8; 4], dim: usize, rename: impl Fn(u32) -> u32) -> NodeKey {
    let mut key = [NO_VERTEX; 4];
    for i in 0..=dim {
        if alpha[i] > 0 {
            key[i] = (rename(cell[i]), alpha[i]);
        }
    }
    key.sort_unstable();
    key
}

fn lattice_point(mesh: &SimplexMesh, cell: &[u32; 4], alpha: &[u8; 4], order: usize) -> [f64; 3] {
    let mut p = [0.0; 3];
    for i in 0..=mesh.dim {
        let v = mesh.vertices[cell[i] as usize];
        for a in 0..3 {
            p[a] += alpha[i] as f64 * v[a] / order as f64;
        }
    }
    p
}

/// Affine map of one cell.
#[derive(Clone, Copy, Debug)]
pub struct Affine {
    /// ∂ξ_a/∂x_m, x_m the m-th axis that the mesh spans.
    pub inverse: [[f64; 3]; 3],
    /// |det ∂x/∂ξ|.
    pub determinant: f64,
}

impl Affine {
    /// Map of a cell, in the axes that the mesh spans.
    pub fn new(mesh: &SimplexMesh, cell: usize) -> Affine {
        let (d, axes) = (mesh.dim, mesh.axes);
        let c = &mesh.cells[cell];
        let mut j = [[0.0; 3]; 3]; // j[m][a] = ∂x_m/∂ξ_a
        for m in 0..d {
            for a in 0..d {
                j[m][a] = mesh.vertices[c[a + 1] as usize][axes[m]]
                    - mesh.vertices[c[0] as usize][axes[m]];
            }
        }
        let (inverse, determinant) = invert(j, d);
        Affine {
            inverse,
            determinant: determinant.abs(),
        }
    }

    /// Gradient by space coordinates from one by reference coordinates.
    pub fn gradient(&self, reference: [f64; 3]) -> [f64; 3] {
        let mut g = [0.0; 3];
        for (m, gm) in g.iter_mut().enumerate() {
            *gm = (0..3).map(|a| self.inverse[a][m] * reference[a]).sum();
        }
        g
    }

    /// Laplacian from the Hessian by reference coordinates.
    pub fn laplacian(&self, reference: &[[f64; 3]; 3]) -> f64 {
        let mut sum = 0.0;
        for a in 0..3 {
            for b in 0..3 {
                let metric: f64 = (0..3)
                    .map(|m| self.inverse[a][m] * self.inverse[b][m])
                    .sum();
                sum += metric * reference[a][b];
            }
        }
        sum
    }
}

fn invert(j: [[f64; 3]; 3], d: usize) -> ([[f64; 3]; 3], f64) {
    let mut inv = [[0.0; 3]; 3];
    match d {
        1 => {
            inv[0][0] = 1.0 / j[0][0];
            (inv, j[0][0])
        }
        2 => {
            let det = j[0][0] * j[1][1] - j[0][1] * j[1][0];
            inv[0][0] = j[1][1] / det;
            inv[0][1] = -j[0][1] / det;
            inv[1][0] = -j[1][0] / det;
            inv[1][1] = j[0][0] / det;
            (inv, det)
        }
        _ => {
            let cofactor = |r: usize, c: usize| {
                let (r1, r2, c1, c2) = ((r + 1) % 3, (r + 2) % 3, (c + 1) % 3, (c + 2) % 3);
                j[r1][c1] * j[r2][c2] - j[r1][c2] * j[r2][c1]
            };
            let det: f64 = (0..3).map(|c| j[0][c] * cofactor(0, c)).sum();
            for (r, row) in inv.iter_mut().enumerate() {
                for (c, v) in row.iter_mut().enumerate() {
                    *v = cofactor(c, r) / det;
                }
            }
            (inv, det)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn two_triangles() -> SimplexMesh {
        SimplexMesh {
            dim: 2,
            axes: [0, 1, 2],
            vertices: vec![
                [0.0, 0.0, 0.0],
                [2.0, 0.0, 0.0],
                [0.0, 1.0, 0.0],
                [2.0, 1.0, 0.0],
            ],
            cells: vec![[0, 1, 2, 0], [3, 2, 1, 0]],
        }
    }

    /// Euler: a space of order k on this mesh has (k+1)² nodes; neighbours share k+1.
    #[test]
    fn nodes_are_shared_across_edges() {
        for order in 1..=5 {
            let space = Space::new(&two_triangles(), order);
            assert_eq!(space.n_nodes(), (order + 1) * (order + 1));
            let shared = space
                .nodes_of(0)
                .iter()
                .filter(|n| space.nodes_of(1).contains(n))
                .count();
            assert_eq!(shared, order + 1);
        }
    }

    /// Shared nodes have one place, whichever cell they are seen from.
    #[test]
    fn node_points_match_the_lattice_of_every_cell() {
        let mesh = two_triangles();
        for order in 1..=5 {
            let space = Space::new(&mesh, order);
            for (c, cell) in mesh.cells.iter().enumerate() {
                for (local, alpha) in space.element.lattice().iter().enumerate() {
                    let p = lattice_point(&mesh, cell, alpha, order);
                    let q = space.points[space.nodes_of(c)[local] as usize];
                    for a in 0..3 {
                        assert_relative_eq!(p[a], q[a], epsilon = 1e-14);
                    }
                }
            }
        }
    }

    /// f = x² + 3xy − y²: gradient and Laplacian (zero) of the interpolant, by hand.
    #[test]
    fn affine_gradient_and_laplacian() {
        let mesh = two_triangles();
        let space = Space::new(&mesh, 2);
        let map = Affine::new(&mesh, 1);
        assert_relative_eq!(map.determinant, 2.0);
        let f = |p: [f64; 3]| p[0] * p[0] + 3.0 * p[0] * p[1] - 2.0 * p[1] * p[1];
        // ξ = (0.25, 0.5): x = v0 + 0.25 (v1 − v0) + 0.5 (v2 − v0) = (1.5, 0.5)
        let (mut g, mut lap) = ([0.0; 3], 0.0);
        for (local, (_, dn, ddn)) in space.element.evaluate([0.25, 0.5, 0.0]).iter().enumerate() {
            let v = f(space.points[space.nodes_of(1)[local] as usize]);
            let dn = map.gradient(*dn);
            g[0] += v * dn[0];
            g[1] += v * dn[1];
            lap += v * map.laplacian(ddn);
        }
        assert_relative_eq!(g[0], 2.0 * 1.5 + 3.0 * 0.5, epsilon = 1e-12);
        assert_relative_eq!(g[1], 3.0 * 1.5 - 4.0 * 0.5, epsilon = 1e-12);
        assert_relative_eq!(lap, 2.0 - 4.0, epsilon = 1e-12);
    }

    #[test]
    fn inverse_of_a_tetrahedron_map() {
        let mesh = SimplexMesh {
            dim: 3,
            axes: [0, 1, 2],
            vertices: vec![
                [0.1, 0.0, 0.2],
                [1.3, 0.2, 0.0],
                [0.0, 2.0, 0.3],
                [0.4, 0.1, 1.5],
            ],
            cells: vec![[0, 1, 2, 3]],
        };
        let map = Affine::new(&mesh, 0);
        // The gradient of x itself, built from vertex values, is (1, 0, 0).
        let element = Lagrange::new(3, 1);
        for axis in 0..3 {
            let mut g = [0.0; 3];
            for (v, (_, dn, _)) in element.evaluate([0.2; 3]).iter().enumerate() {
                let dn = map.gradient(*dn);
                for a in 0..3 {
                    g[a] += mesh.vertices[v][axis] * dn[a];
                }
            }
            for a in 0..3 {
                assert_relative_eq!(g[a], if a == axis { 1.0 } else { 0.0 }, epsilon = 1e-13);
            }
        }
    }
}
