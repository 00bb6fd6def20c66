//! GMRES with right preconditioning (Saad and Schultz 1986; Saad 2003, algorithm 9.5).

use rayon::prelude::*;

/// When to stop.
#[derive(Clone, Copy, Debug)]
pub struct GmresParams {
    /// Relative residual to reach.
    pub tolerance: f64,
    /// Largest number of iterations; there is no restart.
    pub max_iterations: usize,
    /// Whether each direction is made orthogonal to those before it twice, so that round-off does not stall tight tolerances.
    pub twice: bool,
}

impl GmresParams {
    /// How an iteration that stopped at a relative residual ended.
    pub(super) fn end(&self, iterations: usize, residual: f64) -> Result<GmresInfo, GmresError> {
        if residual <= self.tolerance {
            Ok(GmresInfo { iterations })
        } else {
            Err(GmresError {
                iterations,
                residual,
            })
        }
    }
}

impl Default for GmresParams {
    fn default() -> Self {
        GmresParams {
            tolerance: 1e-10,
            max_iterations: 200,
            twice: true,
        }
    }
}

/// Statistics of the iteration.
#[derive(Clone, Copy, Debug)]
pub struct GmresInfo {
    /// Iterations, one product with the matrix and one preconditioner each.
    pub iterations: usize,
}

/// The tolerance was not reached.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("GMRES stopped at a relative residual of {residual:.1e} after {iterations} iterations")]
pub struct GmresError {
    /// Iterations spent.
    pub iterations: usize,
    /// Relative residual reached.
    pub residual: f64,
}

/// Solves A x = b from x = 0 with the right preconditioner M: A M⁻¹ y = b, x = M⁻¹ y.
///
/// `apply` overwrites its second argument with A times the first; `precondition` solves in place.
///
/// # Errors
/// When the tolerance is not reached; `x` then holds the best iterate.
pub fn gmres(
    mut apply: impl FnMut(&[f64], &mut [f64]),
    mut precondition: impl FnMut(&mut [f64]),
    b: &[f64],
    x: &mut [f64],
    params: GmresParams,
) -> Result<GmresInfo, GmresError> {
    let n = b.len();
    let norm_b = norm(b);
    x.fill(0.0);
    if norm_b == 0.0 {
        return params.end(0, 0.0);
    }
    let mut basis: Vec<Vec<f64>> = vec![b.iter().map(|v| v / norm_b).collect()];
    let mut columns: Vec<Vec<f64>> = Vec::new(); // R of the QR factorisation of H
    let mut rotations: Vec<(f64, f64)> = Vec::new();
    let mut g = vec![norm_b];
    let mut preconditioned: Vec<Vec<f64>> = Vec::new();
    let mut residual = 1.0;
    for k in 0..params.max_iterations {
        let mut z = basis[k].clone();
        precondition(&mut z);
        let mut w = vec![0.0; n];
        apply(&z, &mut w);
        preconditioned.push(z);
        let norm_w = norm(&w);
        // Modified Gram-Schmidt.
        let mut h = vec![0.0; k + 2];
        for _ in 0..if params.twice { 2 } else { 1 } {
            for (i, v) in basis.iter().enumerate() {
                let c = dot(v, &w);
                h[i] += c;
                add(&mut w, -c, v);
            }
        }
        h[k + 1] = norm(&w);
        let tail = h[k + 1];
        for (i, (c, s)) in rotations.iter().enumerate() {
            let (a, b) = (h[i], h[i + 1]);
            h[i] = c * a + s * b;
            h[i + 1] = -s * a + c * b;
        }
        let r = h[k].hypot(h[k + 1]);
        // Nothing but round-off is left beyond the basis: measured by the product itself, so that units do not matter.
        let breakdown = tail <= 1e-14 * norm_w || r == 0.0 || !r.is_finite();
        let (c, s) = if r > 0.0 {
            (h[k] / r, h[k + 1] / r)
        } else {
            (1.0, 0.0)
        };
        h[k] = r;
        h.truncate(k + 1);
        columns.push(h);
        rotations.push((c, s));
        let last = g[k];
        g[k] = c * last;
        g.push(-s * last);
        residual = g[k + 1].abs() / norm_b;
        if residual <= params.tolerance || breakdown || k + 1 == params.max_iterations {
            break;
        }
        basis.push(w.iter().map(|v| v / tail).collect());
    }
    let m = columns.len();
    let mut y = vec![0.0; m];
    for i in (0..m).rev() {
        let sum: f64 = (i + 1..m).map(|j| columns[j][i] * y[j]).sum();
        y[i] = if columns[i][i] != 0.0 {
            (g[i] - sum) / columns[i][i]
        } else {
            0.0
        };
    }
    for (yi, z) in y.iter().zip(&preconditioned) {
        add(x, *yi, z);
    }
    params.end(m, residual)
}

/// Numbers of a vector that a thread takes at a time; the same on every machine, so that sums are too. Shorter vectors are not worth a second thread.
const CHUNK: usize = 32_768;

/// a·b.
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    dot_by(a, b, |a, b| a.iter().zip(b).map(|(x, y)| x * y).sum())
}

/// a·b, with `serial` for each part, in the same order for any number of threads.
pub(super) fn dot_by(a: &[f64], b: &[f64], serial: impl Fn(&[f64], &[f64]) -> f64 + Sync) -> f64 {
    if a.len() <= 2 * CHUNK {
        return serial(a, b);
    }
    let sums: Vec<f64> = (a.par_chunks(CHUNK).zip(b.par_chunks(CHUNK)))
        .map(|(a, b)| serial(a, b))
        .collect();
    sums.iter().sum()
}

/// a ← a + c b.
pub fn add(a: &mut [f64], c: f64, b: &[f64]) {
    let serial = |a: &mut [f64], b: &[f64]| a.iter_mut().zip(b).for_each(|(a, b)| *a += c * b);
    match a.len() <= 2 * CHUNK {
        true => serial(a, b),
        false => (a.par_chunks_mut(CHUNK).zip(b.par_chunks(CHUNK))).for_each(|(a, b)| serial(a, b)),
    }
}

fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn convection_diffusion(x: &[f64], y: &mut [f64]) {
        let n = x.len();
        for i in 0..n {
            let left = if i > 0 { x[i - 1] } else { 0.0 };
            let right = if i + 1 < n { x[i + 1] } else { 0.0 };
            y[i] = 2.5 * x[i] - 1.4 * left - 0.6 * right;
        }
    }

    /// A known solution is recovered, with and without a preconditioner.
    #[test]
    fn recovers_a_known_solution() {
        let exact: Vec<f64> = (0..60).map(|i| (0.3 * i as f64).sin() + 0.1).collect();
        let mut b = vec![0.0; 60];
        convection_diffusion(&exact, &mut b);
        let mut x = vec![0.0; 60];
        for scale in [1.0, 2.5] {
            let info = gmres(
                convection_diffusion,
                |z| z.iter_mut().for_each(|v| *v /= scale),
                &b,
                &mut x,
                GmresParams {
                    tolerance: 1e-12,
                    max_iterations: 100,
                    ..GmresParams::default()
                },
            )
            .unwrap();
            assert!(info.iterations <= 60);
            for (a, e) in x.iter().zip(&exact) {
                assert_relative_eq!(a, e, epsilon = 1e-9);
            }
        }
    }

    /// With the matrix itself as preconditioner one iteration does.
    #[test]
    fn exact_preconditioner_takes_one_iteration() {
        let b = [1.0, -2.0, 3.0];
        let d = [2.0, 4.0, 8.0];
        let mut x = [0.0; 3];
        let info = gmres(
            |u, v| (0..3).for_each(|i| v[i] = d[i] * u[i]),
            |z| (0..3).for_each(|i| z[i] /= d[i]),
            &b,
            &mut x,
            GmresParams::default(),
        )
        .unwrap();
        assert_eq!(info.iterations, 1);
        assert_relative_eq!(x[1], -0.5, epsilon = 1e-15);
    }

    /// Units are a matter of choice: the same system, near the identity as preconditioned ones are, with matrix, right side or
    /// both times 1e±11 takes the same iterations to the same solution, up to the factors of both.
    #[test]
    fn units_do_not_matter() {
        let exact: Vec<f64> = (0..60).map(|i| (0.3 * i as f64).sin() + 0.1).collect();
        let near_identity = |x: &[f64], y: &mut [f64]| {
            convection_diffusion(x, y);
            for (y, x) in y.iter_mut().zip(x) {
                *y = x + 1e-3 * *y;
            }
        };
        let mut b = vec![0.0; 60];
        near_identity(&exact, &mut b);
        let params = GmresParams {
            tolerance: 1e-12,
            max_iterations: 100,
            ..GmresParams::default()
        };
        let solve = |matrix: f64, right: f64| {
            let rhs: Vec<f64> = b.iter().map(|v| right * v).collect();
            let mut x = vec![0.0; 60];
            let product = |u: &[f64], v: &mut [f64]| {
                near_identity(u, v);
                v.iter_mut().for_each(|v| *v *= matrix);
            };
            let info = gmres(product, |_: &mut [f64]| {}, &rhs, &mut x, params).unwrap();
            x.iter_mut().for_each(|v| *v *= matrix / right);
            (info.iterations, x)
        };
        let (iterations, solution) = solve(1.0, 1.0);
        for (matrix, right) in [
            (1e11, 1e11),
            (1e-11, 1e-11),
            (1.0, 1e11),
            (1.0, 1e-11),
            (1e11, 1.0),
            (1e-11, 1.0),
        ] {
            let (n, x) = solve(matrix, right);
            assert_eq!(n, iterations, "matrix {matrix:e}, right side {right:e}");
            for (a, e) in x.iter().zip(&solution) {
                assert_relative_eq!(a, e, epsilon = 1e-10);
            }
        }
    }

    #[test]
    fn says_when_it_does_not_converge() {
        let b = vec![1.0; 60];
        let mut x = vec![0.0; 60];
        let params = GmresParams {
            tolerance: 1e-12,
            max_iterations: 3,
            ..GmresParams::default()
        };
        let e = gmres(convection_diffusion, |_| {}, &b, &mut x, params).unwrap_err();
        assert_eq!(e.iterations, 3);
    }
}
