//! Reynolds' equation against manufactured solutions: orders of convergence of each formulation.
//!
//! ```text
//!   P* is chosen, f = ∇·m with the mass flux m = ρ̄H ū − ε∇P*, ε = ρ̄H³/(μ̄λ), and the discrete
//!   equation with that source is solved for P at a given film: ‖P − P*‖ ~ h^(k+1) in L2, h^k in H1.
//! ```
//! A generalized-Newtonian film, Rabinowitsch's cubic between sliding surfaces, has a flow in closed form:
//!
//! ```text
//!   γ̇ = t(1 + |t|²/κ²), t = τ + sG:   ∫γ̇ = τ + [τ|τ|² + (τ|G|² + 2G τ·G)/12]/κ² = Ω gives τ
//!   q = ∫sγ̇ = G/12 + [(2τ τ·G + G|τ|²)/12 + G|G|²/80]/κ²,   Q = 12ρ̄H²/(μ̄λ) q
//! ```
//! Surfaces move along x (ū = e_x), but those of ellipses slide at an angle and spin.
//!
//! Nothing of the product computes f: fluid, film and flux are written out here again, and
//! differentiated by dual numbers.

use crate::common;

use std::f64::consts::PI;
use std::sync::Arc;

use common::material;
use ertel::contact::{ContactKind, Gap, HertzZone, Inlet, Planar, Scales, Shape, Symmetry, Turn};
use ertel::elastic::Elasticity;
use ertel::film::FilmFluid;
use ertel::params::Formulation;
use ertel::run::problem;
use ertel::solve::contact_surface::ContactSurface;
use ertel::solve::discretisation::{Discretisation, Extents, LevelSizes};
use ertel::solve::points::fields_in;
use ertel::solve::state::{FilmConstants, State};
use ertel::solve::system::System;
use ertel_fem::assembly::CONSTRAINED;
use ertel_fem::linear::NEVER;
use ertel_fem::linear::lu::SparseLu;
use ertel_fem::quadrature::Quadrature;
use ertel_rheology::shear::{Rabinowitsch, ShearLaw, ShearThinning};
use ertel_rheology::{DensityLaw, ViscosityLaw};
use faer::sparse::Triplet;
use num_dual::{Dual64, DualNum};

/// Hertz pressure, Pa: the viscosity rises tenfold.
const P_H: f64 = 0.12e9;
/// Viscosity, Pa·s, and its pressure coefficient, 1/Pa.
const MU_0: f64 = 0.04;
const ALPHA: f64 = 22e-9;
/// λ: element Péclet numbers between 0.05 and 5, all branches of the stabilisation parameter.
const LAMBDA: f64 = 2.0;
/// H0.
const SEPARATION: f64 = 0.6;
/// κ and σ of the film that thins: its flow is several times the Newtonian one.
const KNEE: f64 = 0.4;
const SLIDE: f64 = 0.3;

/// Mean spin of the surfaces of ellipses; σ across the motion, and its spin.
const SPIN: f64 = 0.35;
const SLIDE_ACROSS: f64 = -0.2;
const SLIDE_SPIN: f64 = 0.25;

/// ū and σ.
fn motion<D: DualNum<Primitive = f64> + Copy>(kind: ContactKind, x: D, y: D) -> [[D; 2]; 2] {
    match kind {
        ContactKind::Elliptical => [
            [-y * SPIN + 1.0, x * SPIN],
            [-y * SLIDE_SPIN + SLIDE, x * SLIDE_SPIN + SLIDE_ACROSS],
        ],
        ContactKind::Line | ContactKind::Circular | ContactKind::Roller => {
            let zero = x * 0.0;
            [[zero + 1.0, zero], [zero + SLIDE, zero]]
        }
    }
}

/// The same for the product.
fn fields(kind: ContactKind) -> [Planar; 2] {
    match kind {
        ContactKind::Elliptical => [
            Planar {
                centre: [1.0, 0.0],
                spin: SPIN,
            },
            Planar {
                centre: [SLIDE, SLIDE_ACROSS],
                spin: SLIDE_SPIN,
            },
        ],
        ContactKind::Line | ContactKind::Circular | ContactKind::Roller => {
            [1.0, SLIDE].map(Planar::along_x)
        }
    }
}

/// Which film.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Film {
    Newtonian,
    Rabinowitsch,
}

/// Q at dual coordinates.
fn driven(
    film: Film,
    [rho, mu, h]: [Dual64; 3],
    gradient: [Dual64; 2],
    slide: [Dual64; 2],
) -> [Dual64; 2] {
    let g = gradient.map(|p| h * p);
    let dot = |a: [Dual64; 2], b: [Dual64; 2]| a[0] * b[0] + a[1] * b[1];
    let k = 1.0 / (KNEE * KNEE);
    let q = match film {
        Film::Newtonian => g.map(|g| g / 12.0),
        Film::Rabinowitsch => {
            let slide = slide.map(|s| mu * s / h);
            let mut tau = [Dual64::from(0.0); 2];
            // Newton's method; two more steps at the root make the dual part exact, too.
            let mut left = 2;
            while left > 0 {
                let (tt, tg, gg) = (dot(tau, tau), dot(tau, g), dot(g, g));
                let r = [0, 1].map(|i| {
                    tau[i] + (tau[i] * tt + (tau[i] * gg + g[i] * tg * 2.0) / 12.0) * k - slide[i]
                });
                let j = |a: usize, b: usize| {
                    let unit = if a == b { 1.0 } else { 0.0 };
                    (tau[a] * tau[b] * 2.0 + tt * unit + (gg * unit + g[a] * g[b] * 2.0) / 12.0) * k
                        + unit
                };
                let det = j(0, 0) * j(1, 1) - j(0, 1) * j(1, 0);
                let d = [
                    (j(1, 1) * r[0] - j(0, 1) * r[1]) / det,
                    (j(0, 0) * r[1] - j(1, 0) * r[0]) / det,
                ];
                tau = [tau[0] - d[0], tau[1] - d[1]];
                if d[0].re.abs() + d[1].re.abs() < 1e-13 {
                    left -= 1;
                }
            }
            let (tt, tg, gg) = (dot(tau, tau), dot(tau, g), dot(g, g));
            [0, 1].map(|i| {
                g[i] / 12.0 + ((tau[i] * tg * 2.0 + g[i] * tt) / 12.0 + g[i] * gg / 80.0) * k
            })
        }
    };
    q.map(|q| rho * h * h * 12.0 / (mu * LAMBDA) * q)
}

/// Angle of the motion to the first axis of an ellipse, ratio of its axes, and of its curvatures.
const ANGLE: f64 = 0.5;
const RATIO: f64 = 1.6;
const CURVATURES: f64 = 0.45;

/// Coordinates along the axes of the ellipse.
fn turned<D: DualNum<Primitive = f64> + Copy>(x: D, y: D) -> [D; 2] {
    let (s, c) = ANGLE.sin_cos();
    [x * c - y * s, x * s + y * c]
}

/// ½(x² + κy²) along the principal directions.
fn gap(kind: ContactKind, x: Dual64, y: Dual64) -> Dual64 {
    match kind {
        ContactKind::Elliptical | ContactKind::Roller => {
            let [x, y] = turned(x, y);
            (x * x + y * y * CURVATURES) * 0.5
        }
        ContactKind::Line | ContactKind::Circular => (x * x + y * y) * 0.5,
    }
}

/// The geometry of the product.
fn shape(kind: ContactKind) -> Shape {
    let turn = Turn::by(ANGLE);
    match kind {
        ContactKind::Line => Shape::LINE,
        ContactKind::Circular => Shape::CIRCULAR,
        ContactKind::Elliptical | ContactKind::Roller => Shape {
            dim: 2,
            gap: Gap {
                curvature_ratio: CURVATURES,
                turn,
                terms: Vec::new(),
            },
            zone: HertzZone {
                axis_ratio: RATIO,
                turn,
                roller: None,
            },
            symmetry: Symmetry::Full,
            inlet: Inlet::Flooded,
            ends: [f64::INFINITY; 2],
        },
    }
}

/// P*: zero on the edge, level across the symmetry line, lopsided along X.
fn pressure<D: DualNum<Primitive = f64> + Copy>(kind: ContactKind, x: D, y: D) -> D {
    let [x, y] = match kind {
        ContactKind::Elliptical | ContactKind::Roller => {
            // Where the ellipse is a circle and x lies along what the motion becomes there: the edges of the mesh.
            let [x, y] = turned(x, y);
            let (s, c) = ANGLE.sin_cos();
            let length = c.hypot(s / RATIO);
            let [c, s] = [c / length, s / RATIO / length];
            let y = y / RATIO;
            [x * c + y * s, y * c - x * s]
        }
        ContactKind::Line | ContactKind::Circular => [x, y],
    };
    let along = (x * (0.5 * PI)).cos() * (x * 0.4 + 1.0);
    match kind {
        ContactKind::Line => along,
        ContactKind::Circular | ContactKind::Elliptical | ContactKind::Roller => {
            along * (y * (0.5 * PI)).cos()
        }
    }
}

/// Prescribed deflection: quadratic, so that the deflection element holds it exactly.
fn deflection<D: DualNum<Primitive = f64> + Copy>(x: D, y: D) -> D {
    x * x * 0.15 - x * 0.1 + y * 0.05 - x * y * 0.08
}

/// ∇·(ρ̄H ū − Q), Q = ε∇P* or of the thinned film, from Habchi 2008, eqs. 2.10, 2.18, 2.29.
fn source(kind: ContactKind, film: Film, point: [f64; 3]) -> f64 {
    let flux = |x: Dual64, y: Dual64| -> [Dual64; 2] {
        // ∇P* at dual coordinates: one level of dual numbers inside the other
        type Nested = num_dual::Dual<Dual64>;
        let inner = |v: Dual64, seed: f64| Nested::new(v, Dual64::from(seed));
        let px = pressure(kind, inner(x, 1.0), inner(y, 0.0)).eps;
        let py = pressure(kind, inner(x, 0.0), inner(y, 1.0)).eps;
        let p = pressure(kind, x, y) * P_H;
        let h = gap(kind, x, y) + deflection(x, y) + SEPARATION;
        let rho = p * 0.6e-9 / (p * 1.7e-9 + 1.0) + 1.0;
        let log = MU_0.ln() + 9.67;
        let z = ALPHA / (5.1e-9 * log);
        let mu = (((p * 5.1e-9 + 1.0).powf(z) - 1.0) * log).exp();
        let [velocity, slide] = motion(kind, x, y);
        let q = driven(film, [rho, mu, h], [px, py], slide);
        [0, 1].map(|i| rho * h * velocity[i] - q[i])
    };
    let (x, y) = (Dual64::from(point[0]), Dual64::from(point[1]));
    let mut divergence = flux(x.derivative(), y)[0].eps;
    if !kind.is_line() {
        divergence += flux(x, y.derivative())[1].eps;
    }
    divergence
}

fn fluid(kind: ContactKind, film: Film) -> FilmFluid {
    let cubic = Rabinowitsch::new(KNEE * P_H, 1.0 / 3.0).unwrap();
    let thinning = ShearThinning::of(ShearLaw::Rabinowitsch(cubic));
    let scales = Scales {
        length: 1.0,
        pressure: P_H,
        film: 1.0,
        viscosity: MU_0,
        density: 870.0,
        lambda: LAMBDA,
        elastic_stress: 1.0,
        load: 1.0,
    };
    FilmFluid::new(
        &DensityLaw::dowson_higginson(870.0).unwrap(),
        &ViscosityLaw::roelands(MU_0, ALPHA).unwrap(),
        313.15,
        &scales,
    )
    .with_shear(
        (film == Film::Rabinowitsch).then_some(&thinning),
        &fields(kind)[1].times(12.0 / LAMBDA),
        &scales,
    )
}

/// Uniform mesh of the patch [−1, 1] (× [−1, 0], or × [−1, 1] in the coordinates of an ellipse) on a body that grows as fast as it may.
fn mesh(kind: ContactKind, size: f64) -> Arc<ContactSurface> {
    let extents = Extents {
        inlet: -1.0,
        outlet: 1.0,
        side: 1.0,
        body_width: 4.0,
        body_depth: 2.0,
    };
    let sizes = LevelSizes {
        depth_growth: 20.0,
        ..common::uniform(size)
    };
    let rigid = match kind {
        ContactKind::Line | ContactKind::Circular => Elasticity::finite_elements(2, &[]),
        // Its response does not count: the deflection is prescribed.
        ContactKind::Elliptical | ContactKind::Roller => {
            Elasticity::half_space(2, &[material(1.0, 0.3)])
        }
    };
    Arc::new(ContactSurface::new(&shape(kind), &extents, &sizes, &rigid, NEVER).unwrap())
}

/// Errors of the discrete solution on one mesh: mean element size, L2 norm, H1 seminorm.
fn errors(
    kind: ContactKind,
    contact: &Arc<ContactSurface>,
    order: usize,
    film: Film,
    formulation: Formulation,
    diffusion: f64,
) -> [f64; 3] {
    let like = match kind {
        ContactKind::Line => ContactKind::Line,
        ContactKind::Circular | ContactKind::Elliptical | ContactKind::Roller => {
            ContactKind::Circular
        }
    };
    let d = Discretisation::new(contact, order);
    let constants = FilmConstants {
        lambda: LAMBDA,
        entrainment: fields(kind)[0],
        formulation,
        isotropic_diffusion: diffusion,
        ridge_diffusion: 0.0,
        penalty: 0.0,
        ..problem(&common::case(like, 100.0)).plan.stages[0].constants
    };
    let fluid = fluid(kind, film);
    let mut state = State {
        pressure: (d.pressure.points.iter().zip(&d.pressure_dofs))
            .map(|(p, dof)| {
                if *dof == CONSTRAINED {
                    0.0
                } else {
                    0.9 * pressure(kind, p[0], p[1])
                }
            })
            .collect(),
        deflection: (contact.deflection.points.iter())
            .map(|p| deflection(p[0], p[1]))
            .collect(),
        rigid_separation: SEPARATION,
        ..State::default()
    };
    let f = |point: [f64; 3]| source(kind, film, point);
    let (n, m) = (d.pressure_table.n_nodes, d.deflection_table.n_nodes);
    for iteration in 0.. {
        assert!(iteration < 12, "Newton's method does not converge");
        let system = System::assemble(&d, &fluid, &constants, &state, Some(&f));
        let mut triplets = Vec::new();
        for c in 0..contact.n_elements() {
            let nodes = d.pressure.nodes_of(c);
            for (i, row) in nodes.iter().enumerate() {
                for (j, column) in nodes.iter().enumerate() {
                    let (row, column) = (
                        d.pressure_dofs[*row as usize],
                        d.pressure_dofs[*column as usize],
                    );
                    if row != CONSTRAINED && column != CONSTRAINED {
                        let value = system.blocks[(c * n + i) * (n + m) + j];
                        triplets.push(Triplet::new(row as usize, column as usize, value));
                    }
                }
            }
        }
        let mut step = system.residual;
        SparseLu::new(d.n_pressure, &triplets)
            .unwrap()
            .solve(&mut step);
        for (p, dof) in state.pressure.iter_mut().zip(&d.pressure_dofs) {
            if *dof != CONSTRAINED {
                *p -= step[*dof as usize];
            }
        }
        if step.iter().all(|s| s.abs() < 1e-12) {
            break;
        }
    }
    let rule = Quadrature::simplex(contact.surface.dim, 2 * order + 4);
    let (mut l2, mut h1, mut area) = (0.0, 0.0, 0.0);
    for c in 0..contact.n_elements() {
        for (xi, w) in rule.points.iter().zip(&rule.weights) {
            let w = w * contact.maps[c].determinant;
            let [x, y] = contact.point(c, *xi);
            let ours = fields_in(&d, &state, c, *xi);
            let by = |x: Dual64, y: Dual64| pressure(kind, x, y).eps;
            let (x_dual, y_dual) = (Dual64::from(x), Dual64::from(y));
            let exact = [
                by(x_dual.derivative(), y_dual),
                by(x_dual, y_dual.derivative()),
            ];
            l2 += w * (ours.pressure - pressure(kind, x, y)).powi(2);
            h1 += w
                * (0..2)
                    .map(|a| (ours.pressure_gradient[a] - exact[a]).powi(2))
                    .sum::<f64>();
            area += w;
        }
    }
    let size = (area / contact.n_elements() as f64).powf(1.0 / contact.surface.dim as f64);
    [size, l2.sqrt(), h1.sqrt()]
}

/// Orders between two meshes, in L2 and H1.
fn orders(coarse: [f64; 3], fine: [f64; 3]) -> [f64; 2] {
    [1, 2].map(|i| (coarse[i] / fine[i]).ln() / (coarse[0] / fine[0]).ln())
}

fn expect(
    kind: ContactKind,
    sizes: impl Fn(usize) -> [f64; 2],
    film: Film,
    formulation: Formulation,
) {
    // The thinned film takes much longer; what differs does not depend on the order.
    let highest = if film == Film::Newtonian { 5 } else { 3 };
    for order in 1..=highest {
        let [coarse, fine] =
            sizes(order).map(|s| errors(kind, &mesh(kind, s), order, film, formulation, 0.0));
        let [l2, h1] = orders(coarse, fine);
        println!(
            "{kind:?} {film:?} {formulation:?} k = {order}: L2 {:.1e} -> {:.1e}, order {l2:.2}; H1 order {h1:.2}",
            coarse[1], fine[1]
        );
        // From order 4 on the term for the unresolved pressure, which falls faster than the rest, is
        // still the larger part of the error on these meshes.
        let excess = if order > 3 && formulation != Formulation::Galerkin {
            1.0
        } else {
            0.3
        };
        for (rate, exact) in [(l2, order + 1), (h1, order)] {
            let surplus = rate - exact as f64;
            assert!(
                -0.3 < surplus && surplus < excess,
                "{kind:?} {film:?} {formulation:?}, order {order}: rate {rate:.2} instead of {exact}"
            );
        }
    }
}

/// Cell sizes: fine enough for the asymptotic rate, coarse enough to stay above round-off.
fn line(order: usize) -> [f64; 2] {
    let h = [0.05, 0.05, 0.05, 0.1, 0.15][order - 1];
    [h, 0.5 * h]
}

fn circular(order: usize) -> [f64; 2] {
    let h = [0.127, 0.127, 0.36, 0.36, 0.36][order - 1];
    [h, 0.5 * h]
}

/// Habchi 2008, eqs. 2.29, 3.8 and 3.9.
#[test]
fn line_galerkin() {
    expect(
        ContactKind::Line,
        line,
        Film::Newtonian,
        Formulation::Galerkin,
    );
}

/// Habchi 2008, eqs. 3.13 to 3.15 and 3.17.
#[test]
fn line_supg() {
    expect(ContactKind::Line, line, Film::Newtonian, Formulation::Supg);
}

/// Theory: Weak form.
/// Habchi 2008, eqs. 3.13, 3.16 and 3.17.
#[test]
fn line_gls() {
    expect(ContactKind::Line, line, Film::Newtonian, Formulation::Gls);
}

/// Habchi 2008, eqs. 2.29, 3.8 and 3.9.
#[test]
fn circular_galerkin() {
    expect(
        ContactKind::Circular,
        circular,
        Film::Newtonian,
        Formulation::Galerkin,
    );
}

#[test]
fn circular_supg() {
    expect(
        ContactKind::Circular,
        circular,
        Film::Newtonian,
        Formulation::Supg,
    );
}

/// Theory: Weak form.
#[test]
fn circular_gls() {
    expect(
        ContactKind::Circular,
        circular,
        Film::Newtonian,
        Formulation::Gls,
    );
}

/// The whole of an ellipse at an angle to the motion, on a mesh as stretched as it is.
#[test]
fn elliptical() {
    for formulation in [Formulation::Galerkin, Formulation::Gls] {
        expect(
            ContactKind::Elliptical,
            circular,
            Film::Newtonian,
            formulation,
        );
    }
}

/// Habchi 2008, eqs. 4.9, 4.11 and 4.12.
#[test]
fn line_shear_thinning() {
    for formulation in [Formulation::Galerkin, Formulation::Supg, Formulation::Gls] {
        expect(ContactKind::Line, line, Film::Rabinowitsch, formulation);
    }
}

#[test]
fn circular_shear_thinning() {
    for formulation in [Formulation::Galerkin, Formulation::Gls] {
        expect(
            ContactKind::Circular,
            circular,
            Film::Rabinowitsch,
            formulation,
        );
    }
}

#[test]
fn elliptical_shear_thinning() {
    for formulation in [Formulation::Galerkin, Formulation::Gls] {
        expect(
            ContactKind::Elliptical,
            circular,
            Film::Rabinowitsch,
            formulation,
        );
    }
}

/// Isotropic diffusion, ρ_id h_e|β|/(2l) ∇P·∇W, is not consistent: whatever the element, the error
/// falls with h only.
///
/// Habchi 2008, eq. 3.18.
#[test]
fn isotropic_diffusion_is_of_first_order() {
    for (kind, sizes) in [
        (ContactKind::Line, [0.05, 0.025]),
        (ContactKind::Circular, [0.18, 0.09]),
    ] {
        for order in [2, 3] {
            let [coarse, fine] = sizes.map(|s| {
                errors(
                    kind,
                    &mesh(kind, s),
                    order,
                    Film::Newtonian,
                    Formulation::Gls,
                    0.5,
                )
            });
            let rates = orders(coarse, fine);
            println!("{kind:?} k = {order} with diffusion: orders {rates:.2?}");
            for rate in rates {
                assert!(
                    (rate - 1.0).abs() < 0.15,
                    "{kind:?}, order {order}: {rate:.2}"
                );
            }
        }
    }
}
