//! The stiffness of the surface between near nodes, for the preconditioner.

use ertel_fem::assembly::NodeGraph;
use ertel_fem::mesh::SimplexMesh;
use ertel_fem::quadrature::Quadrature;
use ertel_fem::space::{Affine, Space};

/// Pairs of surface nodes (i ≤ j) that share an element, with `wide` also neighbours of neighbours.
pub fn near_pairs(surface: &Space, wide: bool) -> Vec<(u32, u32)> {
    let graph = NodeGraph::new(surface);
    let mut pairs = Vec::new();
    for i in 0..graph.n_nodes() {
        let mut near: Vec<u32> = graph.of(i).to_vec();
        if wide {
            near.extend(graph.of(i).iter().flat_map(|j| graph.of(*j as usize)));
            near.sort_unstable();
            near.dedup();
        }
        let near = near.into_iter().filter(|j| *j as usize >= i);
        pairs.extend(near.map(|j| (i as u32, j)));
    }
    pairs
}

/// Wave number, in 2π over the size of an element, at which the stiffness of an element is that of the bodies. Shares between 0.08 and 0.35 take
/// about as many Krylov iterations.
const WAVE_SHARE: f64 = 0.25;

/// Stiffness of a surface whose answer to a wave of pressure of the wave number k is `answer(k)` times it, between nodes of one
/// element.
///
/// ```text
///   S(k) = 1/answer(k) ≈ S(κ) + S'(κ) (k² − κ²)/(2κ),   κ = 2π s/h_e:   S_T = a M_T + b K_T
/// ```
/// M_T and K_T are mass and stiffness matrix of an element. A half-space, S = k/(2C), has a = κ/(4C), b = 1/(4Cκ).
pub fn symbol_stiffness(
    mesh: &SimplexMesh,
    space: &Space,
    pairs: &[(u32, u32)],
    stretch: &dyn Fn([f64; 2]) -> f64,
    answer: &dyn Fn(f64) -> f64,
) -> Vec<f64> {
    let rule = Quadrature::simplex(mesh.dim, 2 * space.element.order());
    let table = space.element.tabulate(&rule);
    let n = table.n_nodes;
    let mut stiffness = vec![0.0; pairs.len()];
    // Pairs are sorted: those of a node are a range.
    let first: Vec<usize> = (0..=space.n_nodes() as u32)
        .map(|i| pairs.partition_point(|p| p.0 < i))
        .collect();
    for c in 0..mesh.n_cells() {
        let map = Affine::new(mesh, c);
        let size = match mesh.dim {
            1 => map.determinant,
            // The shorter way across a cell as stretched as the Hertz zone.
            _ => {
                let ratio = stretch(mesh.centre(c));
                (map.determinant / ratio.max(ratio.recip())).sqrt()
            }
        };
        let kappa = 2.0 * std::f64::consts::PI * WAVE_SHARE / size;
        let s = 1.0 / answer(kappa);
        let step = 1e-3 * kappa;
        let slope = (1.0 / answer(kappa + step) - 1.0 / answer(kappa - step)) / (2.0 * step);
        let b = slope / (2.0 * kappa);
        let a = s - b * kappa * kappa;
        for (q, weight) in rule.weights.iter().enumerate() {
            let w = weight * map.determinant;
            let values = &table.values[q * n..(q + 1) * n];
            let gradients: Vec<[f64; 3]> = (table.gradients[q * n..(q + 1) * n].iter())
                .map(|g| map.gradient(*g))
                .collect();
            for (i, node) in space.nodes_of(c).iter().enumerate() {
                for (j, other) in space.nodes_of(c).iter().enumerate() {
                    if other < node {
                        continue;
                    }
                    let [g, h] = [gradients[i], gradients[j]];
                    let product = g[0] * h[0] + g[1] * h[1];
                    let of_node = first[*node as usize]..first[*node as usize + 1];
                    let at = pairs[of_node.clone()].binary_search_by_key(other, |p| p.1);
                    let at = of_node.start + at.expect("nodes of one element are near");
                    stiffness[at] += w * (a * values[i] * values[j] + b * product);
                }
            }
        }
    }
    stiffness
}
