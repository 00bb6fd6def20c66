//! Generalised conjugate residuals with right preconditioning (Eisenstat, Elman and Schultz 1983) for one matrix and many right sides: every direction
//! is kept, and serves the right sides that follow (as in de Sturler 1996).
//!
//! ```text
//!   z_k = M⁻¹ r_k,  A Z = Q R,  QᵀQ = 1:      c = Qᵀb,   r = b − Q c,   x = Z R⁻¹ c
//! ```
//! For the first right side the iterates are those of GMRES.

use super::dense::vectorised;
use super::gmres::{GmresError, GmresInfo, GmresParams, add, dot_by};

/// Directions of a matrix and its products with them.
#[derive(Default)]
pub struct Recycled {
    /// z.
    directions: Vec<Vec<f64>>,
    /// q.
    products: Vec<Vec<f64>>,
    /// Columns of R, as far as the diagonal.
    columns: Vec<Vec<f64>>,
    /// R⁻¹ c of the last solve.
    shares: Vec<f64>,
}

impl Recycled {
    /// Solves A x = b by the directions that there are, and as many new ones as it takes. Arguments as those of [`gmres`](super::gmres::gmres);
    /// directions are made orthogonal once: what that leaves shows in the residual, which is followed as it is.
    ///
    /// # Errors
    /// When the tolerance is not reached; `x` then holds the best iterate.
    pub fn solve(
        &mut self,
        mut apply: impl FnMut(&[f64], &mut [f64]),
        mut precondition: impl FnMut(&mut [f64]),
        b: &[f64],
        x: &mut [f64],
        params: GmresParams,
    ) -> Result<GmresInfo, GmresError> {
        let size = norm(b);
        let mut r = b.to_vec();
        let mut shares = Vec::new();
        for q in &self.products {
            shares.push(take_off(&mut r, q));
        }
        let mut iterations = 0;
        let residual = loop {
            let residual = if size > 0.0 { norm(&r) / size } else { 0.0 };
            if residual <= params.tolerance || iterations == params.max_iterations {
                break residual;
            }
            let mut z = r.clone();
            precondition(&mut z);
            let mut q = vec![0.0; r.len()];
            apply(&z, &mut q);
            let whole = norm(&q);
            let mut column: Vec<f64> = (self.products.iter())
                .map(|other| take_off(&mut q, other))
                .collect();
            let left = norm(&q);
            // Nothing but round-off is new, or a number that is none.
            if !(left > 1e-14 * whole && left.is_finite()) {
                break residual;
            }
            iterations += 1;
            q.iter_mut().for_each(|v| *v /= left);
            column.push(left);
            shares.push(take_off(&mut r, &q));
            self.directions.push(z);
            self.products.push(q);
            self.columns.push(column);
        };
        self.combine(shares, x);
        params.end(iterations, residual)
    }

    /// Shares of the directions in the last solution, in the order in which they were multiplied by A.
    pub fn shares(&self) -> &[f64] {
        &self.shares
    }

    /// x = Z R⁻¹ c.
    fn combine(&mut self, mut c: Vec<f64>, x: &mut [f64]) {
        x.fill(0.0);
        for k in (0..c.len()).rev() {
            c[k] /= self.columns[k][k];
            let y = c[k];
            for (c, r) in c[..k].iter_mut().zip(&self.columns[k]) {
                *c -= y * r;
            }
            add(x, y, &self.directions[k]);
        }
        self.shares = c;
    }
}

/// Sums that are kept apart: one after the other each would wait for the one before.
const LANES: usize = 16;

/// a·b.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    dot_by(a, b, |a, b| vectorised(|| by_lanes(a, b)))
}

#[inline(always)]
fn by_lanes(a: &[f64], b: &[f64]) -> f64 {
    let ((a, a_end), (b, b_end)) = (a.as_chunks::<LANES>(), b.as_chunks::<LANES>());
    let mut sums = [0.0; LANES];
    for (a, b) in a.iter().zip(b) {
        for (sum, (a, b)) in sums.iter_mut().zip(a.iter().zip(b)) {
            *sum += a * b;
        }
    }
    let end: f64 = a_end.iter().zip(b_end).map(|(a, b)| a * b).sum();
    sums.iter().sum::<f64>() + end
}

/// Takes its part along a unit vector off a vector; returns its share.
fn take_off(v: &mut [f64], unit: &[f64]) -> f64 {
    let share = dot(unit, v);
    add(v, -share, unit);
    share
}

fn norm(v: &[f64]) -> f64 {
    dot(v, v).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::linear::gmres::gmres;
    use approx::assert_relative_eq;

    const N: usize = 80;

    fn product(x: &[f64], y: &mut [f64]) {
        for i in 0..N {
            let left = if i > 0 { x[i - 1] } else { 0.0 };
            let right = if i + 1 < N { x[i + 1] } else { 0.0 };
            y[i] = (2.2 + 0.01 * i as f64) * x[i] - 1.4 * left - 0.6 * right;
        }
    }

    fn wave(k: f64) -> Vec<f64> {
        (0..N).map(|i| (k * i as f64).sin() + 0.1).collect()
    }

    /// A known solution comes back, in as many iterations as GMRES takes; a linear combination of earlier right sides takes none, and one near
    /// them fewer than a fresh solve.
    #[test]
    fn directions_serve_again() {
        let params = GmresParams {
            tolerance: 1e-8,
            max_iterations: 80,
            ..GmresParams::default()
        };
        let right = |exact: &[f64]| {
            let mut b = vec![0.0; N];
            product(exact, &mut b);
            b
        };
        let mut recycled = Recycled::default();
        let mut x = vec![0.0; N];
        let (first, second) = (wave(0.3), wave(0.31));
        let info = (recycled.solve(product, |_| {}, &right(&first), &mut x, params)).unwrap();
        let mut other = vec![0.0; N];
        let of_gmres = gmres(product, |_| {}, &right(&first), &mut other, params).unwrap();
        assert_eq!(info.iterations, of_gmres.iterations);
        for ((x, other), exact) in x.iter().zip(&other).zip(&first) {
            assert_relative_eq!(x, other, epsilon = 1e-10);
            assert_relative_eq!(x, exact, epsilon = 1e-6);
        }
        let next = (recycled.solve(product, |_| {}, &right(&second), &mut x, params)).unwrap();
        assert!(next.iterations < info.iterations, "{next:?}");
        let mixed: Vec<f64> = first
            .iter()
            .zip(&second)
            .map(|(a, b)| 3.0 * a - b)
            .collect();
        let last = (recycled.solve(product, |_| {}, &right(&mixed), &mut x, params)).unwrap();
        assert_eq!(last.iterations, 0);
        for (x, exact) in x.iter().zip(&mixed) {
            assert_relative_eq!(x, exact, epsilon = 1e-5);
        }
        assert_eq!(recycled.directions.len(), info.iterations + next.iterations);
    }

    /// Iterations that run out, a matrix that makes nothing new, and nothing to solve for.
    #[test]
    fn unsolvable_problems_are_errors() {
        let few = GmresParams {
            max_iterations: 3,
            ..GmresParams::default()
        };
        let mut x = vec![0.0; N];
        let failed = Recycled::default().solve(product, |_| {}, &wave(0.3), &mut x, few);
        assert_eq!(failed.unwrap_err().iterations, 3);
        let nothing = |_: &[f64], y: &mut [f64]| y.fill(0.0);
        assert!((Recycled::default().solve(nothing, |_| {}, &wave(0.3), &mut x, few)).is_err());
        let info = (Recycled::default().solve(product, |_| {}, &[0.0; N], &mut x, few)).unwrap();
        assert_eq!((info.iterations, x[3]), (0, 0.0));
    }
}
