//! The integrand against differences, and against the terms of the weak form written out by hand.

use super::*;
use crate::film::PointFluid;
use crate::forms::dual::Dual;
use crate::forms::flow::newtonian;
use approx::assert_relative_eq;

fn constants(formulation: Formulation) -> ElementConstants {
    ElementConstants {
        lambda: 0.01,
        entrainment: Planar::along_x(1.0),
        size: 0.1,
        order: 3,
        penalty: 1e4,
        formulation,
        isotropic_diffusion: 0.5,
        diffusion_tensor: None,
        slenderness: 1.0,
        elastic_stabilisation: true,
        oil_layer: None,
        filling_length: 0.0,
    }
}

/// ū at the point.
const VELOCITY: [f64; 2] = [0.9, -0.3];

fn point<D: Number>(
    s: &PointState<D>,
    fluid: &PointFluid,
    e: &ElementConstants,
    f: f64,
) -> TestCoefficients<D> {
    let m = Properties::around(s.pressure, fluid);
    reynolds_point(s, &m, &newtonian(s, &m, e.lambda), e, VELOCITY, f)
}

/// Independently evaluated: (coth x − 1/x)/x at 0.05, 1 and 30 (30-digit arithmetic).
#[test]
fn upwind_function() {
    for (x, exact) in [
        (0.05, 0.333_277_790_99),
        (1.0, 0.313_035_285_499_331),
        (30.0, 0.032_222_222_222_222),
    ] {
        assert_relative_eq!(upwind(x), exact, max_relative = 1e-10);
    }
    for x in [0.1, 20.0] {
        assert_relative_eq!(upwind(x - 1e-9), upwind(x + 1e-9), max_relative = 1e-7);
    }
}

/// Derivatives by every entry of the state against central differences, for each formulation
/// and on both sides of P = 0; the fluid is ρ̄ = 1 + 0.2P², μ̄ = exp(3P).
#[test]
fn derivatives_match_differences() {
    let fluid = |p: f64| {
        let m = (3.0 * p).exp();
        PointFluid {
            density: [1.0 + 0.2 * p * p, 0.4 * p, 0.4],
            viscosity: [m, 3.0 * m, 9.0 * m],
        }
    };
    let base = |p: f64| [p, -0.7, 0.4, 0.02, 0.3, -0.2, 0.15, 2.0];
    let evaluate = |x: [f64; 8], c: &ElementConstants| {
        let s = PointState {
            pressure: x[0],
            pressure_gradient: [x[1], x[2]],
            pressure_unresolved: x[3],
            film: x[4],
            film_gradient: [x[5], x[6]],
            pressure_curvature: [x[7], 0.0, 0.0],
        };
        let t = point(&s, &fluid(x[0]), c, 0.3);
        [
            t.value,
            t.gradient[0],
            t.gradient[1],
            t.laplacian,
            t.unresolved,
        ]
    };
    for formulation in [Formulation::Galerkin, Formulation::Supg, Formulation::Gls] {
        let c = constants(formulation);
        for p in [0.8, 0.1, -0.05] {
            let x = base(p);
            let d = |i: usize| Dual::<8>::variable(x[i], i);
            let s = PointState {
                pressure: d(0),
                pressure_gradient: [d(1), d(2)],
                pressure_unresolved: d(3),
                film: d(4),
                film_gradient: [d(5), d(6)],
                pressure_curvature: [d(7), Dual::from(0.0), Dual::from(0.0)],
            };
            let t = point(&s, &fluid(p), &c, 0.3);
            let exact = [
                t.value,
                t.gradient[0],
                t.gradient[1],
                t.laplacian,
                t.unresolved,
            ];
            for k in 0..8 {
                let step = 1e-6;
                let (mut up, mut down) = (x, x);
                up[k] += step;
                down[k] -= step;
                let (up, down) = (evaluate(up, &c), evaluate(down, &c));
                for i in 0..5 {
                    let difference = (up[i] - down[i]) / (2.0 * step);
                    assert_relative_eq!(
                        exact[i].slopes[k],
                        difference,
                        max_relative = 1e-5,
                        epsilon = 1e-7
                    );
                }
            }
        }
    }
}

/// SUPG and GLS add nothing where the strong residual vanishes: choose f = R.
#[test]
fn stabilisation_is_consistent() {
    let fluid = PointFluid {
        density: [1.1, 0.2, -0.1],
        viscosity: [5.0, 15.0, 45.0],
    };
    let s = PointState {
        pressure: 0.6,
        pressure_gradient: [0.5, -0.1],
        pressure_curvature: [-0.7, 0.3, -0.5],
        film: 0.2,
        film_gradient: [0.1, 0.05],
        pressure_unresolved: 0.0,
    };
    let mut c = constants(Formulation::Gls);
    // R = −∇ε·∇P − εΔP + ū·(ρ'∇P H + ρ∇H) by hand, ε = ρH³/(μλ)
    let eps = 1.1 * 0.008 / (5.0 * 0.01);
    let k = eps * (0.2 / 1.1 - 3.0);
    let (ex, ey) = (
        k * 0.5 + 3.0 * eps / 0.2 * 0.1,
        k * -0.1 + 3.0 * eps / 0.2 * 0.05,
    );
    let f = -(ex * 0.5 + ey * -0.1) + eps * 1.2 + 0.9 * (0.2 * 0.5 * 0.2 + 1.1 * 0.1)
        - 0.3 * (0.2 * -0.1 * 0.2 + 1.1 * 0.05);
    let all = |formulation| {
        c.formulation = formulation;
        let t = point(&s, &fluid, &c, f);
        [
            t.value,
            t.gradient[0],
            t.gradient[1],
            t.laplacian,
            t.unresolved,
        ]
    };
    let [galerkin, supg, gls] =
        [Formulation::Galerkin, Formulation::Supg, Formulation::Gls].map(all);
    for stabilised in [supg, gls] {
        for (own, plain) in stabilised.into_iter().zip(galerkin) {
            assert_relative_eq!(own, plain, max_relative = 1e-12, epsilon = 1e-14);
        }
    }
    // With another f they add something to the gradients, and GLS to the Laplacian.
    let off = |formulation| {
        c.formulation = formulation;
        let t = point(&s, &fluid, &c, f + 1.0);
        [t.gradient[0], t.laplacian]
    };
    let [plain, supg, gls] = [Formulation::Galerkin, Formulation::Supg, Formulation::Gls].map(off);
    assert!(supg[0] != plain[0] && gls[0] != plain[0] && gls[1] != plain[1]);
}

/// a, b, c and d of the weak form, term by term as in the module documentation, with Pe and τ from coth here. None of the
/// terms of the stabilisation changes the order of convergence, for all are consistent: only their size can be tested.
#[test]
fn terms_of_the_weak_form() {
    let fluid = PointFluid {
        density: [1.1, 0.2, -0.1],
        viscosity: [5.0, 15.0, 45.0],
    };
    // ε between 2.2 and 2.2e-4: Péclet numbers on all three branches; pressures on both sides of the penalty's
    for (film, pressure) in [(1.0_f64, 0.6), (0.3, 0.6), (0.05, 0.6), (0.3, -0.01)] {
        let drift = [0.07, 0.02];
        let [u, v] = VELOCITY;
        let s = PointState {
            pressure,
            pressure_gradient: [0.5, -0.1],
            pressure_curvature: [-0.7, 0.3, -0.5],
            film,
            film_gradient: [0.1, 0.05],
            pressure_unresolved: 0.02,
        };
        let (size, l, f) = (0.1, 3.0, 0.3);
        let eps = 1.1 * film.powi(3) / (5.0 * 0.1);
        let grad_eps = [0, 1].map(|i: usize| {
            eps * ((0.2 / 1.1 - 3.0) * s.pressure_gradient[i] + 3.0 / film * s.film_gradient[i])
        });
        let divergence = grad_eps[0] * 0.5 - grad_eps[1] * 0.1 - 1.2 * eps;
        let penalty = 1e4 * f64::min(pressure, 0.0);
        let carried = 0.2 * (0.5 * u - 0.1 * v) * film
            + (drift[0] * u + drift[1] * v)
            + 1.1 * (0.1 * u + 0.05 * v);
        let residual = -divergence + carried + penalty - f;
        let coth = |x: f64| 1.0 / x.tanh() - 1.0 / x;
        for formulation in [Formulation::Galerkin, Formulation::Supg, Formulation::Gls] {
            for elastic in [false, true] {
                let slender = [1.0, -0.2, 0.3];
                for (diffusion, tensor) in [(0.0, None), (0.5, None), (0.5, Some(slender))] {
                    let c = ElementConstants {
                        lambda: 0.1,
                        isotropic_diffusion: diffusion,
                        diffusion_tensor: tensor,
                        slenderness: if tensor.is_some() { 2.0 } else { 1.0 },
                        elastic_stabilisation: elastic,
                        ..constants(formulation)
                    };
                    let m = Properties::around(s.pressure, &fluid);
                    let flow = Flow {
                        drift,
                        ..newtonian(&s, &m, c.lambda)
                    };
                    let found = reynolds_point(&s, &m, &flow, &c, VELOCITY, f);
                    let supg = f64::from(u8::from(formulation != Formulation::Galerkin));
                    let gls = f64::from(u8::from(formulation == Formulation::Gls));
                    let elastic = f64::from(u8::from(elastic));
                    let beta = film * 0.2 + elastic * 0.3 * 1.1 * size;
                    let speed = beta * (u * u + v * v).sqrt();
                    // A cell is √2 times as long along the motion as across.
                    let slender_eps = if tensor.is_some() { 2.0 * eps } else { eps };
                    let tau =
                        size / (2.0 * l * speed) * coth(speed * size / (2.0 * l * slender_eps));
                    let weight = supg * tau * residual;
                    let spread = diffusion * size * film * 0.2 / (2.0 * l);
                    let [xx, xy, yy] = tensor.unwrap_or([1.0, 0.0, 1.0]);
                    let spread = [0.5 * xx - 0.1 * xy, 0.5 * xy - 0.1 * yy].map(|s| s * spread);
                    let pe_unresolved = 1.1 * size * size / (2.0 * l * eps);
                    let unresolved = supg * elastic * coth(pe_unresolved) * 1.1 / size * 0.02;
                    let expected = [
                        penalty - f,
                        eps * 0.5 + spread[0] - 1.1 * film * u
                            + weight * (beta * u - gls * grad_eps[0]),
                        -eps * 0.1 + spread[1] - 1.1 * film * v
                            + weight * (beta * v - gls * grad_eps[1]),
                        -gls * weight * eps,
                        unresolved,
                    ];
                    let ours = [
                        found.value,
                        found.gradient[0],
                        found.gradient[1],
                        found.laplacian,
                        found.unresolved,
                    ];
                    for (ours, expected) in ours.into_iter().zip(expected) {
                        assert_relative_eq!(ours, expected, max_relative = 1e-9, epsilon = 1e-15);
                    }
                }
            }
        }
    }
}
