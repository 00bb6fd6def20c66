//! Smooth fields from linear elements, by recovered gradients.
//!
//! ```text
//!   u ≈ u_i + g·d + ½ dᵀH d    d = x − x_i,  over the nodes around node i, by least squares with weights 1/d²
//! ```
//! g is the gradient at the node (polynomial-preserving recovery: Zhang and Naga, SIAM J. Sci. Comput. 26 (2005)
//! 1192-1213). Each element then has the cubic of its corners' values and gradients; its middle is set so that quadratics
//! are reproduced. Along an edge it is known from the two ends alone: neighbours agree there.

use ertel_fem::element::Lagrange;
use ertel_fem::space::Space;
use nalgebra::DMatrix;
use rayon::prelude::*;

use crate::contact::Symmetry;
use crate::solve::tuning::heat::{RINGS, WELL_POSED};

/// Order of the recovered polynomials.
pub const ORDER: usize = 3;

/// Stencil of the gradient at a node: numbers of the nodes around it, and weights by x and y.
type Stencil = Vec<(u32, [f64; 2])>;

/// Recovery of gradients from the values at the nodes of a space of linear elements.
pub struct Recovery<'a> {
    space: &'a Space,
    stencils: Vec<Stencil>,
}

impl<'a> Recovery<'a> {
    /// For segments along x, or triangles on a whole contact or on the half y ≤ 0 of one that is symmetric about y = 0.
    ///
    /// # Panics
    /// For elements that are not linear.
    pub fn new(space: &'a Space, symmetry: Symmetry) -> Recovery<'a> {
        assert_eq!(space.element.order(), 1);
        let mut neighbours = vec![Vec::new(); space.n_nodes()];
        for cell in 0..space.n_elements() {
            let nodes = space.nodes_of(cell);
            for node in nodes {
                neighbours[*node as usize].extend(nodes.iter().copied().filter(|n| n != node));
            }
        }
        for list in &mut neighbours {
            list.sort_unstable();
            list.dedup();
        }
        // Nodes so near y = 0 lie on the plane of symmetry.
        let reach = space.points.iter().fold(0.0, |r: f64, p| r.max(p[1].abs()));
        let mirror =
            (symmetry == Symmetry::Half && space.element.dim() == 2).then_some(1e-9 * reach);
        let stencils = (0..space.n_nodes() as u32).into_par_iter();
        Recovery {
            space,
            stencils: stencils
                .map(|node| stencil(space, &neighbours, node, mirror))
                .collect(),
        }
    }

    /// The cubics of a field given at the nodes: values at the Lagrange nodes of third order, element by element.
    pub fn cubics(&self, values: &[f64]) -> Vec<f64> {
        let gradients: Vec<[f64; 2]> = (self.stencils.iter().enumerate())
            .map(|(node, stencil)| gradient(stencil, values, node))
            .collect();
        self.cubics_of(values, &gradients)
    }

    /// The same with given gradients at the nodes.
    fn cubics_of(&self, values: &[f64], gradients: &[[f64; 2]]) -> Vec<f64> {
        let lagrange = Lagrange::new(self.space.element.dim(), ORDER);
        let mut cubics = Vec::with_capacity(lagrange.n_nodes() * self.space.n_elements());
        for cell in 0..self.space.n_elements() {
            let nodes = self.space.nodes_of(cell);
            let value = |i: usize| values[nodes[i] as usize];
            let point = |i: usize| self.space.points[nodes[i] as usize];
            // Slope at a corner along the edge to another one, per edge
            let slope = |from: usize, to: usize| {
                let ([a, b], g) = ([from, to].map(point), gradients[nodes[from] as usize]);
                (b[0] - a[0]) * g[0] + (b[1] - a[1]) * g[1]
            };
            let (mut corners, mut edges) = (0.0, 0.0);
            for alpha in lagrange.lattice() {
                let corner = |weight: u8| alpha.iter().position(|a| *a == weight);
                cubics.push(match (corner(3), corner(2), corner(1)) {
                    (Some(i), ..) => {
                        corners += value(i);
                        value(i)
                    }
                    (_, Some(i), Some(j)) => {
                        // Hermite's cubic at a third of the edge
                        let slopes = 4.0 * slope(i, j) + 2.0 * slope(j, i);
                        let third = (20.0 * value(i) + 7.0 * value(j) + slopes) / 27.0;
                        edges += third;
                        third
                    }
                    // The middle: filled in below, when all edges are known
                    _ => 0.0,
                });
            }
            if let Some(middle) = lagrange.lattice().iter().position(|a| a[..3] == [1, 1, 1]) {
                let start = cubics.len() - lagrange.n_nodes();
                cubics[start + middle] = edges / 4.0 - corners / 6.0;
            }
        }
        cubics
    }
}

/// Gradient at a node: differences from its own value, so that a constant has none.
fn gradient(stencil: &Stencil, values: &[f64], node: usize) -> [f64; 2] {
    let mut gradient = [0.0; 2];
    for (other, weights) in stencil {
        let difference = values[*other as usize] - values[node];
        for (g, weight) in gradient.iter_mut().zip(weights) {
            *g += weight * difference;
        }
    }
    gradient
}

/// Weights of the gradient at a node, over as few rings of elements as determine a quadratic.
///
/// On a half, nodes within `mirror` of y = 0 have mirror images of their neighbours around them, and no gradient across.
fn stencil(space: &Space, neighbours: &[Vec<u32>], node: u32, mirror: Option<f64>) -> Stencil {
    let dim = space.element.dim();
    let [x, y, _] = space.points[node as usize];
    let mirror = mirror.filter(|flat| y.abs() <= *flat);
    let (mut patch, mut ring) = (vec![node], 0..1);
    for round in 1..=RINGS {
        for k in ring.clone() {
            for other in &neighbours[patch[k] as usize] {
                if !patch.contains(other) {
                    patch.push(*other);
                }
            }
        }
        ring = ring.end..patch.len();
        let mut samples: Vec<(u32, [f64; 2])> = Vec::new();
        for other in &patch[1..] {
            let [px, py, _] = space.points[*other as usize];
            samples.push((*other, [px - x, py - y]));
            if mirror.is_some_and(|flat| py.abs() > flat) {
                samples.push((*other, [px - x, -py - y]));
            }
        }
        let found = fit(dim, &samples, round == RINGS || ring.is_empty());
        if let Some(mut stencil) = found {
            if mirror.is_some() {
                stencil.iter_mut().for_each(|(_, weights)| weights[1] = 0.0);
            }
            return stencil;
        }
    }
    Vec::new()
}

/// Weights of the samples at distances d in the gradient of the quadratic nearest to them; `None` where they do not
/// determine it well, unless it is to be had `anyway`.
fn fit(dim: usize, samples: &[(u32, [f64; 2])], anyway: bool) -> Option<Stencil> {
    let n_unknowns = if dim == 2 { 5 } else { 2 };
    if samples.len() < n_unknowns && !anyway {
        return None;
    }
    let far = samples.iter().map(|(_, [x, y])| x.hypot(*y));
    let scale = far.fold(0.0, f64::max);
    let mut matrix = DMatrix::zeros(samples.len(), n_unknowns);
    for (row, (_, d)) in samples.iter().enumerate() {
        let [x, y] = d.map(|d| d / scale);
        let weight = 1.0 / x.hypot(y);
        let basis = if dim == 2 {
            [x, y, x * x, x * y, y * y]
        } else {
            [x, x * x, 0.0, 0.0, 0.0]
        };
        for (column, value) in basis[..n_unknowns].iter().enumerate() {
            matrix[(row, column)] = weight * value;
        }
    }
    let svd = matrix.svd(true, true);
    let largest = svd.singular_values.max();
    if svd.singular_values.min() < WELL_POSED * largest && !anyway {
        return None;
    }
    let inverse = svd.pseudo_inverse(WELL_POSED * largest).ok()?;
    let stencil = samples.iter().enumerate().map(|(column, (node, [x, y]))| {
        // The row's weight 1/|d|, and the scale of the unknowns
        let factor = 1.0 / x.hypot(*y);
        let weight = |row: usize| {
            if row < dim {
                factor * inverse[(row, column)]
            } else {
                0.0
            }
        };
        (*node, [weight(0), weight(1)])
    });
    Some(stencil.collect())
}

#[cfg(test)]
mod tests;
