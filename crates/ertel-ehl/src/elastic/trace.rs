//! The spaces of pressure and deflection on the contact area.

use ertel_fem::kernel;
use ertel_fem::linear::dense::vectorised;
use ertel_fem::mesh::SimplexMesh;
use ertel_fem::quadrature::Quadrature;
use ertel_fem::space::{Affine, Space};

/// Pressure and deflection on one mesh of the contact area, and the maps between them.
#[derive(Clone, Debug)]
pub struct Trace {
    /// Deflection nodes.
    pub deflection: Space,
    pressure_nodes: Vec<u32>,
    /// Element matrices ∫N_δ N_P, row-major, deflection by pressure node.
    coupling: Vec<f64>,
    /// N_P at the deflection nodes of an element, row by row.
    lattice: Vec<f64>,
    /// An element of each deflection node, and its place there.
    owners: Vec<(u32, u32)>,
    /// ∫1 of each element over its reference element.
    determinants: Vec<f64>,
}

impl Trace {
    /// Joins two spaces on a mesh; the rule is exact for their products.
    pub fn new(
        mesh: &SimplexMesh,
        pressure: &Space,
        deflection: &Space,
        rule: &Quadrature,
    ) -> Trace {
        let (p, w) = (
            pressure.element.tabulate(rule),
            deflection.element.tabulate(rule),
        );
        let (n, m) = (p.n_nodes, w.n_nodes);
        let determinants: Vec<f64> = (0..mesh.n_cells())
            .map(|c| Affine::new(mesh, c).determinant)
            .collect();
        let mut coupling = vec![0.0; mesh.n_cells() * n * m];
        for (block, determinant) in coupling.chunks_exact_mut(n * m).zip(&determinants) {
            for (q, weight) in rule.weights.iter().enumerate() {
                let scale = weight * determinant;
                for j in 0..n {
                    let v = scale * p.values[q * n + j];
                    for i in 0..m {
                        block[i * n + j] += v * w.values[q * m + i];
                    }
                }
            }
        }
        let order = deflection.element.order() as f64;
        let lattice = deflection.element.lattice().iter().flat_map(|alpha| {
            let xi = [1, 2, 3].map(|v: usize| f64::from(alpha[v]) / order);
            pressure.element.values(xi)
        });
        let mut owners = vec![(0, 0); deflection.n_nodes()];
        for c in 0..mesh.n_cells() {
            for (i, node) in deflection.nodes_of(c).iter().enumerate() {
                owners[*node as usize] = (c as u32, i as u32);
            }
        }
        Trace {
            pressure_nodes: pressure.element_nodes.clone(),
            coupling,
            lattice: lattice.collect(),
            owners,
            deflection: deflection.clone(),
            determinants,
        }
    }

    fn per_element(&self) -> (usize, usize) {
        let n_elements = self.determinants.len().max(1);
        (
            self.pressure_nodes.len() / n_elements,
            self.deflection.element.n_nodes(),
        )
    }

    /// Nodes and matrix ∫N_δ N_P of each element: deflection nodes, pressure nodes, entries row by row.
    pub fn elements(&self) -> impl Iterator<Item = (&[u32], &[u32], &[f64])> {
        let (n, m) = self.per_element();
        (self.deflection.element_nodes.chunks_exact(m))
            .zip(self.pressure_nodes.chunks_exact(n))
            .zip(self.coupling.chunks_exact(n * m))
            .map(|((below, nodes), block)| (below, nodes, block))
    }

    /// Loads ∫p N of the deflection nodes under nodal pressures.
    pub fn loads(&self, pressure: &[f64]) -> Vec<f64> {
        let mut loads = vec![0.0; self.deflection.n_nodes()];
        vectorised(Loads {
            trace: self,
            pressure,
            loads: &mut loads,
        });
        loads
    }

    /// Nodes of the pressure in the element of a deflection node, and their shape functions there.
    fn at_node(&self, (element, place): (u32, u32)) -> (&[u32], &[f64]) {
        let (n, _) = self.per_element();
        let (c, i) = (element as usize, place as usize);
        (
            &self.pressure_nodes[c * n..(c + 1) * n],
            &self.lattice[i * n..(i + 1) * n],
        )
    }

    /// Whether pressure and deflection have the same nodes.
    fn is_one_space(&self) -> bool {
        self.pressure_nodes == self.deflection.element_nodes
    }

    /// Pressures at the deflection nodes.
    pub fn values(&self, pressure: &[f64]) -> Vec<f64> {
        if self.is_one_space() {
            return pressure.to_vec();
        }
        (self.owners.iter())
            .map(|owner| {
                let (nodes, basis) = self.at_node(*owner);
                nodes
                    .iter()
                    .zip(basis)
                    .map(|(n, b)| b * pressure[*n as usize])
                    .sum()
            })
            .collect()
    }
}

kernel! {
    Loads ['a] ['a] (trace: &'a Trace, pressure: &'a [f64], loads: &'a mut [f64]) -> () {
        for (below, nodes, block) in trace.elements() {
            for (row, target) in block.chunks_exact(nodes.len()).zip(below) {
                let sum: f64 = row.iter().zip(nodes).map(|(v, j)| v * pressure[*j as usize]).sum();
                loads[*target as usize] += sum;
            }
        }
    }
}
