//! Where the pressure has a ridge that the elements do not resolve.
//!
//! ```text
//!   s = e²/(e² + e₀²)
//! ```
//! e is the error of the pressure in an element, from how slowly its polynomials fall off, or the largest of its neighbours', on the mesh
//! before: a finer one puts the ridge elsewhere. Where s is about 1, pressures of high order overshoot: the ridge before the outlet falls off within a thousandth of a half-width.

use ertel_fem::locate::Locator;
use ertel_fem::mesh::SimplexMesh;
use ertel_fem::quadrature::Quadrature;
use ertel_fem::space::Space;

use super::neighbours::Neighbours;
use crate::solve::tuning::ridge::{CUT_OFF, OWN_RIDGE, SCALE, STEPS};

/// s of each element of `surface`, from the `pressure` on another mesh.
pub(super) fn ridge_shares(
    (other, locator, space): (&SimplexMesh, &Locator, &Space),
    pressure: &[f64],
    surface: &SimplexMesh,
) -> Vec<f64> {
    let neighbours = Neighbours::new(other);
    let shares = shares(&unresolved(space, pressure), &neighbours);
    (0..surface.n_cells())
        .map(|c| {
            let corners = &surface.cell(c)[..=surface.dim];
            let centre = [0, 1].map(|axis: usize| {
                let sum: f64 = (corners.iter())
                    .map(|v| surface.vertices[*v as usize][axis])
                    .sum();
                sum / corners.len() as f64
            });
            let found = locator.find(other, centre);
            let share = found.map_or(0.0, |(cell, _)| shares[cell]);
            (STEPS * share).round() / STEPS
        })
        .collect()
}

/// By how much a ridge may be higher in each element than on the mesh, and how high it may then be, in p_h; zero without one.
pub(super) fn cut_off(
    space: &Space,
    share_at_ridge: impl Fn(usize) -> f64,
    pressure: &[f64],
) -> (Vec<f64>, f64) {
    let range = |c: usize| {
        let values = space.nodes_of(c).iter().map(|n| pressure[*n as usize]);
        values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], p| {
            [low.min(p), high.max(p)]
        })
    };
    let ranges: Vec<[f64; 2]> = (0..space.n_elements()).map(range).collect();
    let cut_off: Vec<f64> = (ranges.iter().enumerate())
        .map(|(c, [low, high])| CUT_OFF * share_at_ridge(c) * (high - low))
        .collect();
    let height = (ranges.iter().zip(&cut_off))
        .filter(|(_, cut)| **cut > 0.0)
        .fold(0.0, |most: f64, ([_, high], cut)| most.max(high + cut));
    (cut_off, height)
}

/// Share of each element at a ridge from the errors of the pressure there and in its neighbours, in p_h.
fn shares(errors: &[f64], neighbours: &Neighbours) -> Vec<f64> {
    (errors.iter().zip(&neighbours.of))
        .map(|(error, around)| {
            let around = around.iter().map(|n| errors[*n as usize]);
            share(around.fold(*error, f64::max))
        })
        .collect()
}

/// s of an error in p_h.
fn share(error: f64) -> f64 {
    let error = error / SCALE;
    error * error / (1.0 + error * error)
}

/// Shares where a mesh has a ridge by its own pressures, which nothing diffuses: those that are about 1.
pub(super) fn own_shares(errors: &[f64], neighbours: &Neighbours) -> Vec<f64> {
    let shares = shares(errors, neighbours).into_iter();
    shares
        .map(|s| if s > OWN_RIDGE { s } else { 0.0 })
        .collect()
}

/// Root mean square error of a field of order k in each element, from how fast its polynomials' parts of rising degree fall off.
///
/// ```text
///   e ≈ s min(1, s/t),   s = ‖p − Π_(k−1) p‖,  t = ‖p − Π_(k−2) p‖    over the element
/// ```
/// Where the mesh resolves the field, s/t is small, and e the next term of a geometric series; at a ridge narrower than the element,
/// where misfits of neighbours say little, s/t is about 1.
pub(super) fn unresolved(space: &Space, field: &[f64]) -> Vec<f64> {
    let element = &space.element;
    let (dim, order) = (element.dim(), element.order());
    let rule = Quadrature::simplex(dim, 2 * order);
    let parts =
        [order - 1, order.saturating_sub(2)].map(|degree| element.fluctuations(degree, &rule));
    let total: f64 = rule.weights.iter().sum();
    let n = element.n_nodes();
    (0..space.n_elements())
        .map(|c| {
            let values: Vec<f64> = space
                .nodes_of(c)
                .iter()
                .map(|v| field[*v as usize])
                .collect();
            let [s, t] = parts.each_ref().map(|table| {
                let squares = (table.chunks_exact(n).zip(&rule.weights)).map(|(row, weight)| {
                    let value: f64 = row.iter().zip(&values).map(|(b, v)| b * v).sum();
                    weight / total * value * value
                });
                squares.sum::<f64>().sqrt()
            });
            if t > 0.0 { s * (s / t).min(1.0) } else { 0.0 }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// n by n squares of side 1/n, halved.
    fn square(n: usize) -> SimplexMesh {
        let at = |i: usize, j: usize| (i + j * (n + 1)) as u32;
        let mut cells = Vec::new();
        for j in 0..n {
            for i in 0..n {
                let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
                cells.push([a, b, c, u32::MAX]);
                cells.push([a, c, d, u32::MAX]);
            }
        }
        SimplexMesh {
            dim: 2,
            axes: [0, 1, 2],
            vertices: (0..(n + 1) * (n + 1))
                .map(|k| {
                    let [i, j] = [k % (n + 1), k / (n + 1)];
                    [i as f64 / n as f64, j as f64 / n as f64, 0.0]
                })
                .collect(),
            cells,
        }
    }

    /// A jump at x = 0.6 has its elements, and their neighbours, of another mesh at the same place; smooth pressures have none.
    #[test]
    fn shares_appear_where_pressures_are_not_resolved() {
        let (coarse, fine) = (square(10), square(20));
        let (space, locator) = (Space::new(&coarse, 3), Locator::new(&coarse));
        let shares = |pressure: &dyn Fn(f64) -> f64| {
            let nodal: Vec<f64> = space.points.iter().map(|p| pressure(p[0])).collect();
            ridge_shares((&coarse, &locator, &space), &nodal, &fine)
        };
        let smooth = shares(&|x| x - x * x);
        assert!(smooth.iter().all(|s| *s == 0.0));
        let jump = shares(&|x| if x < 0.57 { 0.8 } else { 0.2 });
        for (c, share) in jump.iter().enumerate() {
            let x = (fine.cell(c)[..3].iter())
                .map(|v| fine.vertices[*v as usize][0])
                .sum::<f64>()
                / 3.0;
            if (0.5..0.6).contains(&x) {
                assert_relative_eq!(*share, 1.0, max_relative = 0.05);
            } else if !(0.4..0.7).contains(&x) {
                assert_eq!(*share, 0.0);
            }
        }
    }

    /// By hand: in an element with a share of one half, pressures from 0 to 0.8 may be cut off by 0.75 · ½ · 0.8 = 0.3, up to 1.1.
    #[test]
    fn cut_off_scales_with_the_pressure_range() {
        let space = Space::new(&square(3), 3);
        let mut pressure = vec![0.0; space.n_nodes()];
        let own = space.nodes_of(0);
        pressure[own[0] as usize] = 0.8;
        let share = |c: usize| if c == 0 { 0.5 } else { 0.0 };
        let (cut, height) = cut_off(&space, share, &pressure);
        assert_relative_eq!(cut[0], 0.3, max_relative = 1e-12);
        assert!(cut[1..].iter().all(|c| *c == 0.0));
        assert_relative_eq!(height, 1.1, max_relative = 1e-12);
    }
}
