//! Expansions in Chebyshev polynomials, and how they go from box to box.
//!
//! ```text
//!   K(x, y) ≈ Σ_αβ T_α(x) K_αβ T_β(y)    x, y in the frames of two boxes that do not touch, |α|, |β| < p
//!   M_β = Σ_q w_q T_β(y_q)               moments of a box;  those of its parent follow from them exactly
//!   φ(x) = Σ_α T_α(x) Σ_β K_αβ M_β
//! ```
//! A black-box fast multipole method (Fong and Darve, J. Comput. Phys. 228 (2009) 8712-8725) in coefficients instead of
//! values at nodes, cut at a total degree: T_α = T_a(x) T_b(y) with a + b < p.

use std::sync::{Arc, Mutex, PoisonError};

use super::Kernel;

/// Products T_a(x) T_b(y) of a total degree below p; along a line T_a(x) alone.
#[derive(Clone, Debug)]
pub struct Basis {
    /// p.
    pub degree: usize,
    /// Exponents (a, b), by total degree: the basis of a smaller p comes first.
    pub exponents: Vec<[usize; 2]>,
}

impl Basis {
    /// The basis over a surface (`dim` 2) or a line (`dim` 1).
    pub fn new(dim: usize, degree: usize) -> Basis {
        let of_total = |total: usize| match dim {
            1 => vec![[total, 0]],
            _ => (0..=total).map(|b| [total - b, b]).collect(),
        };
        Basis {
            degree,
            exponents: (0..degree).flat_map(of_total).collect(),
        }
    }

    /// Number of functions.
    pub fn len(&self) -> usize {
        self.exponents.len()
    }

    /// Values at a point of the box [−1, 1]².
    pub fn values(&self, point: [f64; 2], out: &mut [f64]) {
        let mut t = [[0.0; MAX_DEGREE]; 2];
        for (t, x) in t.iter_mut().zip(point) {
            t[0] = 1.0;
            t[1] = x;
            for k in 2..self.degree {
                t[k] = 2.0 * x * t[k - 1] - t[k - 2];
            }
        }
        for (value, [a, b]) in out.iter_mut().zip(&self.exponents) {
            *value = t[0][*a] * t[1][*b];
        }
    }

    /// Row-major matrix of the moments of a box from those of its child in a quadrant.
    pub fn parent_from_child(&self, quadrant: usize) -> Vec<f64> {
        let along = [quadrant % 2, quadrant / 2].map(|q| half_interval(self.degree, q == 1));
        let mut matrix = Vec::with_capacity(self.len() * self.len());
        for [a, b] in &self.exponents {
            matrix
                .extend((self.exponents.iter()).map(|[c, d]| along[0][*a][*c] * along[1][*b][*d]));
        }
        matrix
    }

    /// Row-major coefficients K_αβ for boxes of half-side 1 of which the second's centre is 2 `offset` away.
    pub fn coefficients(&self, kernel: Kernel, offset: [i8; 2]) -> Vec<f64> {
        let dim = self.exponents.iter().any(|e| e[1] > 0) as usize + 1;
        let n = self.degree + OVERSAMPLING;
        let nodes: Vec<f64> = (0..n)
            .map(|k| (std::f64::consts::PI * (k as f64 + 0.5) / n as f64).cos())
            .collect();
        // f ↦ its coefficients: c_a = (2 − δ_a0)/n Σ_k f(x_k) T_a(x_k)
        let transform: Vec<Vec<f64>> = (0..self.degree)
            .map(|a| {
                let weight = if a == 0 { 1.0 } else { 2.0 } / n as f64;
                nodes
                    .iter()
                    .map(|x| weight * (a as f64 * x.acos()).cos())
                    .collect()
            })
            .collect();
        let one_row = vec![vec![1.0]];
        let (second, by_y) = match dim {
            2 => (&nodes[..], &transform),
            _ => (&[0.0][..], &one_row),
        };
        // Values by (x_1, x_2, y_1, y_2), target x and source y; then axis by axis from values to coefficients.
        let mut table = Vec::new();
        for x1 in &nodes {
            for x2 in second {
                for y1 in &nodes {
                    let d1 = x1 - y1 - 2.0 * f64::from(offset[0]);
                    table.extend(
                        second
                            .iter()
                            .map(|y2| kernel.at(d1.hypot(x2 - y2 - 2.0 * f64::from(offset[1])))),
                    );
                }
            }
        }
        // The first axis goes to the end each time: after four times all stand as before.
        for rows in [&transform, by_y, &transform, by_y] {
            table = transformed(&table, rows);
        }
        let (p, q) = (self.degree, by_y.len());
        let mut matrix = Vec::with_capacity(self.len() * self.len());
        for [a, b] in &self.exponents {
            matrix
                .extend((self.exponents.iter()).map(|[c, d]| table[((a * q + b) * p + c) * q + d]));
        }
        matrix
    }

    /// [`all_coefficients`](Self::all_coefficients), computed once in a program.
    pub fn shared_coefficients(&self, kernel: Kernel) -> Arc<Vec<Vec<f64>>> {
        let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
        let same = |entry: &&Known| entry.0 == kernel && entry.1 == self.degree;
        if let Some((_, _, coefficients)) = known.iter().find(same) {
            return coefficients.clone();
        }
        let coefficients = Arc::new(self.all_coefficients(kernel));
        known.push((kernel, self.degree, coefficients.clone()));
        coefficients
    }

    /// Coefficients for every offset that occurs between boxes of one level, by [`offset_index`].
    pub fn all_coefficients(&self, kernel: Kernel) -> Vec<Vec<f64>> {
        let dim = self.exponents.iter().any(|e| e[1] > 0) as usize + 1;
        let reach: Vec<[i8; 2]> = (-REACH..=REACH)
            .flat_map(|dx| (-REACH..=REACH).map(move |dy| [dx, dy]))
            .collect();
        // Those with 0 ≤ dy ≤ dx; the others follow by mirror images and by exchange of the axes.
        let base: Vec<Vec<f64>> = (reach.iter())
            .map(
                |d| match d[0] > 1 && d[1] >= 0 && d[1] <= d[0] && (dim == 2 || d[1] == 0) {
                    true => self.coefficients(kernel, *d),
                    false => Vec::new(),
                },
            )
            .collect();
        let place = |e: [usize; 2]| {
            let found = self.exponents.iter().position(|own| *own == e);
            found.expect("the basis is symmetric in its axes")
        };
        (reach.iter())
            .map(|d| {
                let size = d.map(|c| c.abs());
                let swapped = size[1] > size[0];
                let from = if swapped { [size[1], size[0]] } else { size };
                let source = &base[offset_index(from)];
                if source.is_empty() || (dim == 1 && d[1] != 0) {
                    return Vec::new();
                }
                let n = self.len();
                let mut matrix = vec![0.0; n * n];
                for (i, alpha) in self.exponents.iter().enumerate() {
                    for (j, beta) in self.exponents.iter().enumerate() {
                        let parity = |axis: usize| match d[axis] < 0 {
                            true => alpha[axis] + beta[axis],
                            false => 0,
                        };
                        let sign = if (parity(0) + parity(1)) % 2 == 0 {
                            1.0
                        } else {
                            -1.0
                        };
                        let (k, l) = match swapped {
                            true => (place([alpha[1], alpha[0]]), place([beta[1], beta[0]])),
                            false => (i, j),
                        };
                        matrix[i * n + j] = sign * source[k * n + l];
                    }
                }
                matrix
            })
            .collect()
    }
}

/// Kernel, p and coefficients.
type Known = (Kernel, usize, Arc<Vec<Vec<f64>>>);

/// Coefficients that operators have asked for so far.
static KNOWN: Mutex<Vec<Known>> = Mutex::new(Vec::new());

/// Highest p.
pub const MAX_DEGREE: usize = 24;
/// Chebyshev nodes beyond p by which the coefficients of the kernel are computed.
const OVERSAMPLING: usize = 4;
/// Largest offset of boxes that exchange expansions.
const REACH: i8 = 3;

/// Place of an offset in [`Basis::all_coefficients`].
pub fn offset_index(offset: [i8; 2]) -> usize {
    let along = |d: i8| (d + REACH) as usize;
    along(offset[0]) * (2 * REACH as usize + 1) + along(offset[1])
}

/// T_a(x) = Σ_c e_ac T_c(ξ) on the lower or upper half of [−1, 1], x = (ξ ∓ 1)/2.
fn half_interval(n: usize, upper: bool) -> Vec<Vec<f64>> {
    let shift = if upper { 0.5 } else { -0.5 };
    // x Σ c_k T_k(ξ) = Σ c_k (shift T_k + (T_(k+1) + T_|k−1|)/4)
    let by_x = |c: &[f64]| {
        let mut product = vec![0.0; n + 1];
        for (k, c) in c.iter().enumerate().take(n) {
            product[k] += shift * c;
            product[k + 1] += 0.25 * c;
            product[k.abs_diff(1)] += 0.25 * c;
        }
        product.truncate(n);
        product
    };
    let mut rows: Vec<Vec<f64>> = Vec::with_capacity(n);
    for a in 0..n {
        let mut row = vec![0.0; n];
        match a {
            0 => row[0] = 1.0,
            1 => row = by_x(&rows[0]),
            _ => {
                let twice = by_x(&rows[a - 1]);
                for (r, (t, before)) in row.iter_mut().zip(twice.iter().zip(&rows[a - 2])) {
                    *r = 2.0 * t - before;
                }
            }
        }
        rows.push(row);
    }
    rows
}

/// Σ_k rows[a][k] table[k, ·], stored as [·, a].
fn transformed(table: &[f64], rows: &[Vec<f64>]) -> Vec<f64> {
    let (n, p) = (rows[0].len(), rows.len());
    let rest = table.len() / n;
    let mut out = vec![0.0; rest * p];
    for (k, slice) in table.chunks_exact(rest).enumerate() {
        let column: Vec<f64> = rows.iter().map(|row| row[k]).collect();
        for (out, value) in out.chunks_exact_mut(p).zip(slice) {
            for (o, c) in out.iter_mut().zip(&column) {
                *o += c * value;
            }
        }
    }
    out
}

#[cfg(test)]
fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// The polynomials of a box are those of its quadrants, exactly.
    #[test]
    fn polynomials_of_a_box_from_those_of_its_children() {
        let basis = Basis::new(2, 7);
        let n = basis.len();
        let (mut whole, mut part) = (vec![0.0; n], vec![0.0; n]);
        for quadrant in 0..4 {
            let matrix = basis.parent_from_child(quadrant);
            let centre = [quadrant % 2, quadrant / 2].map(|q| q as f64 - 0.5);
            for xi in [[0.3, -0.8], [-1.0, 1.0]] {
                basis.values([0, 1].map(|a: usize| centre[a] + 0.5 * xi[a]), &mut whole);
                basis.values(xi, &mut part);
                for (row, value) in matrix.chunks_exact(n).zip(&whole) {
                    assert_relative_eq!(dot(row, &part), *value, epsilon = 1e-13);
                }
            }
        }
    }

    /// The kernel between points of two boxes, for every offset, against its own value.
    #[test]
    fn expansions_give_the_kernel_back() {
        for (dim, kernel, degree, tolerance) in [
            (2, Kernel::InverseDistance, 10, 2e-6),
            (1, Kernel::Logarithm, 16, 1e-11),
        ] {
            let basis = Basis::new(dim, degree);
            let n = basis.len();
            let all = basis.all_coefficients(kernel);
            let (mut tx, mut ty) = (vec![0.0; n], vec![0.0; n]);
            for dx in -3..=3i8 {
                for dy in if dim == 2 { -3..=3i8 } else { 0..=0 } {
                    if dx.abs().max(dy.abs()) < 2 {
                        continue;
                    }
                    let matrix = &all[offset_index([dx, dy])];
                    let second = if dim == 2 { 1.0 } else { 0.0 };
                    for (x, y) in [([0.9, -0.3], [-0.7, 0.95]), ([-1.0, 0.2], [0.1, -0.4])] {
                        basis.values(x, &mut tx);
                        basis.values(y, &mut ty);
                        let found: f64 = (matrix.chunks_exact(n).zip(&tx))
                            .map(|(row, t)| t * dot(row, &ty))
                            .sum();
                        let d = [
                            x[0] - y[0] - 2.0 * f64::from(dx),
                            second * (x[1] - y[1] - 2.0 * f64::from(dy)),
                        ];
                        assert_relative_eq!(
                            found,
                            kernel.at(d[0].hypot(d[1])),
                            epsilon = tolerance
                        );
                    }
                }
            }
        }
    }
}
