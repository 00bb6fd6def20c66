//! Elements that share a side, and how little the polynomials of neighbours continue each other.

use rustc_hash::FxHashMap;

use ertel_fem::locate::reference_point;
use ertel_fem::mesh::SimplexMesh;
use ertel_fem::quadrature::Quadrature;
use ertel_fem::space::Space;

/// Elements that share a side.
pub(super) struct Neighbours {
    /// Neighbours of each element.
    pub of: Vec<Vec<u32>>,
}

impl Neighbours {
    /// Those of a mesh.
    pub fn new(surface: &SimplexMesh) -> Neighbours {
        let mut sides: FxHashMap<[u32; 2], u32> = FxHashMap::default();
        let mut of = vec![Vec::with_capacity(surface.dim + 1); surface.n_cells()];
        for c in 0..surface.n_cells() {
            let cell = surface.cell(c);
            for (i, &a) in cell.iter().enumerate() {
                for &b in &cell[i + 1..] {
                    // a segment's sides are its ends, a triangle's its edges
                    let keys = if surface.dim == 1 {
                        [Some([a, a]), Some([b, b])]
                    } else {
                        [Some([a.min(b), a.max(b)]), None]
                    };
                    for key in keys.into_iter().flatten() {
                        if let Some(other) = sides.insert(key, c as u32) {
                            of[c].push(other);
                            of[other as usize].push(c as u32);
                        }
                    }
                }
            }
        }
        Neighbours { of }
    }

    /// Root mean square error of each field in each element, estimated from how far the polynomials of
    /// its neighbours, continued into it, are off.
    pub fn misfit(&self, surface: &SimplexMesh, space: &Space, fields: &[&[f64]]) -> Vec<Vec<f64>> {
        let rule = Quadrature::simplex(surface.dim, 2);
        let factor = continuation_factor(space.element.order());
        let values = |xi: [f64; 3]| -> Vec<f64> { space.element.values(xi).collect() };
        let table: Vec<_> = rule.points.iter().map(|xi| values(*xi)).collect();
        let mut basis = values([0.0; 3]);
        let at = |cell: usize, basis: &[f64], field: &[f64]| -> f64 {
            basis
                .iter()
                .zip(space.nodes_of(cell))
                .map(|(b, node)| b * field[*node as usize])
                .sum()
        };
        let total: f64 = rule.weights.iter().sum();
        let mut errors = vec![vec![0.0; surface.n_cells()]; fields.len()];
        for c in 0..surface.n_cells() {
            let vertex = |k: usize| surface.vertices[surface.cell(c)[k] as usize];
            let mut squares = vec![0.0; fields.len()];
            for &other in &self.of[c] {
                for (q, weight) in rule.weights.iter().enumerate() {
                    let xi = rule.points[q];
                    let point = [0, 1].map(|a: usize| {
                        vertex(0)[a]
                            + (1..=surface.dim)
                                .map(|k| xi[k - 1] * (vertex(k)[a] - vertex(0)[a]))
                                .sum::<f64>()
                    });
                    let there = reference_point(surface, other as usize, point);
                    basis.clear();
                    basis.extend(space.element.values(there));
                    for (square, field) in squares.iter_mut().zip(fields) {
                        let gap = at(other as usize, &basis, field) - at(c, &table[q], field);
                        *square += weight / total * gap * gap;
                    }
                }
            }
            let count = self.of[c].len().max(1) as f64;
            for (error, square) in errors.iter_mut().zip(&squares) {
                error[c] = factor * (square / count).sqrt();
            }
        }
        errors
    }
}

/// Interpolation error of x^(k+1) on a segment over the misfit of the interpolant on the next segment,
/// both root mean square.
///
/// ```text
///   e = Π_i (x − i/k),   misfit = Π_i (x − i/k) − Π_i (x − 1 − i/k),   0 ≤ x ≤ 1
/// ```
fn continuation_factor(order: usize) -> f64 {
    let error = |x: f64| {
        (0..=order)
            .map(|i| x - i as f64 / order as f64)
            .product::<f64>()
    };
    let rule = Quadrature::simplex(1, 2 * order + 2);
    let rms = |f: &dyn Fn(f64) -> f64| {
        rule.points
            .iter()
            .zip(&rule.weights)
            .map(|(x, w)| w * f(x[0]).powi(2))
            .sum::<f64>()
            .sqrt()
    };
    rms(&error) / rms(&|x| error(x) - error(x - 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn line(n: usize) -> SimplexMesh {
        SimplexMesh {
            dim: 1,
            axes: [0, 1, 2],
            vertices: (0..=n).map(|i| [i as f64 / n as f64, 0.0, 0.0]).collect(),
            cells: (0..n as u32)
                .map(|i| [i, i + 1, u32::MAX, u32::MAX])
                .collect(),
        }
    }

    /// By hand for k = 1: ‖x(x − 1)‖ = √(1/30), ‖2(x − 1)‖ = 2/√3; and on a mesh, x³ interpolated by
    /// quadratics errs by h³‖t(t − ½)(t − 1)‖ = h³√(1/840).
    #[test]
    fn misfit_is_the_interpolation_error_of_the_next_power() {
        assert_relative_eq!(
            continuation_factor(1),
            (1.0_f64 / 30.0).sqrt() / (2.0 / 3.0_f64.sqrt()),
            max_relative = 1e-12
        );
        let mesh = line(8);
        let space = Space::new(&mesh, 2);
        let cube: Vec<f64> = space.points.iter().map(|p| p[0].powi(3)).collect();
        let square: Vec<f64> = space.points.iter().map(|p| p[0].powi(2)).collect();
        let found = Neighbours::new(&mesh).misfit(&mesh, &space, &[&cube, &square]);
        for (c, s) in found[0].iter().zip(&found[1]) {
            assert_relative_eq!(*c, (1.0_f64 / 840.0).sqrt() / 512.0, max_relative = 0.15);
            assert!(*s < 1e-14);
        }
    }
}
