//! Linear elasticity of the body.
//!
//! ```text
//!   ∫ σ(u) : ε(v) dΩ = −∫_c P v_n dΓ,   σ = λ tr(ε) I + 2μ ε
//! ```
//! u = 0 at the bottom, u_y = 0 on the symmetry plane, everything else free
//! (Habchi 2008, eqs. 3.4, 3.5, 3.9). Line contacts: plane strain, the same form in (x, z).

/// Lamé constants (λ, μ) of Young's modulus E and Poisson's ratio ν, in units of E.
///
/// λ = Eν/[(1+ν)(1−2ν)], μ = E/[2(1+ν)]
pub fn lame(youngs_modulus: f64, poissons_ratio: f64) -> (f64, f64) {
    let (e, nu) = (youngs_modulus, poissons_ratio);
    (
        e * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)),
        e / (2.0 * (1.0 + nu)),
    )
}

/// Adds one quadrature point's share of the element stiffness, row-major with index
/// `node * dim + component`:
///
/// K_(im)(jn) = w [λ ∂_m N_i ∂_n N_j + μ ∂_n N_i ∂_m N_j + μ δ_mn ∇N_i·∇N_j]
///
/// `gradients` are by space coordinates; `weight` includes the Jacobian determinant.
pub fn stiffness_point(
    dim: usize,
    (lambda, mu): (f64, f64),
    gradients: &[[f64; 3]],
    weight: f64,
    stiffness: &mut [f64],
) {
    let size = gradients.len() * dim;
    for (i, gi) in gradients.iter().enumerate() {
        for (j, gj) in gradients.iter().enumerate() {
            let dot: f64 = (0..dim).map(|k| gi[k] * gj[k]).sum();
            for m in 0..dim {
                for n in 0..dim {
                    let mut k = lambda * gi[m] * gj[n] + mu * gi[n] * gj[m];
                    if m == n {
                        k += mu * dot;
                    }
                    stiffness[(i * dim + m) * size + j * dim + n] += weight * k;
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Plane strain: σ_xx/ε_xx at ε_zz = 0 is E(1−ν)/[(1+ν)(1−2ν)] (Habchi 2008, eq. 3.4).
    #[test]
    fn uniaxial_strain_modulus() {
        let (e, nu) = (210e9, 0.3);
        let (lambda, mu) = lame(e, nu);
        let modulus = e * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu));
        assert_relative_eq!(lambda + 2.0 * mu, modulus, max_relative = 1e-14);
    }

    /// Rigid translations and rotations store no energy; a uniform strain stores
    /// ½[λ tr(ε)² + 2μ ε:ε] per volume.
    #[test]
    fn energy_of_rigid_motion_and_uniform_strain() {
        let x = [
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.0, 0.0, 1.0],
        ];
        let gradients = [
            [-1.0, -1.0, -1.0],
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.0, 0.0, 1.0],
        ];
        let lame = lame(1.0, 0.25);
        let mut k = vec![0.0; 144];
        stiffness_point(3, lame, &gradients, 1.0, &mut k);
        let energy = |a: [[f64; 3]; 3]| {
            let u: Vec<f64> = x
                .iter()
                .flat_map(|p| {
                    (0..3)
                        .map(|m| 0.7 + (0..3).map(|n| a[m][n] * p[n]).sum::<f64>())
                        .collect::<Vec<_>>()
                })
                .collect();
            let mut sum = 0.0;
            for i in 0..12 {
                for j in 0..12 {
                    sum += 0.5 * u[i] * k[i * 12 + j] * u[j];
                }
            }
            sum
        };
        assert_relative_eq!(
            energy([[0.0, 0.3, -0.2], [-0.3, 0.0, 0.5], [0.2, -0.5, 0.0]]),
            0.0,
            epsilon = 1e-14
        );
        let e = [[0.1, 0.05, -0.02], [0.05, -0.3, 0.04], [-0.02, 0.04, 0.2]];
        let trace: f64 = e[0][0] + e[1][1] + e[2][2];
        let square: f64 = e.iter().flatten().map(|v| v * v).sum();
        let exact = 0.5 * (lame.0 * trace * trace + 2.0 * lame.1 * square);
        assert_relative_eq!(energy(e), exact, max_relative = 1e-13);
    }
}
