//! Half-spaces: closed forms, the finite-element body as it grows, and the laws that any elastic response obeys.

use crate::common;

use std::f64::consts::PI;
use std::sync::Arc;

use crate::common::near;
use approx::assert_relative_eq;
use common::{hertz_bodies, largest_difference, material, noise, uniform};
use ertel::contact::{ContactKind, Family, Material, hertz, pressure_profile};
use ertel::elastic::{Accuracy, Elasticity, HalfSpace, SurfaceResponse};
use ertel::engine::NoObserver;
use ertel::params::{ElasticModel, MeshParams, MeshPreset};
use ertel::run::{problem, solve};
use ertel::solve::contact_surface::ContactSurface;
use ertel::solve::discretisation::{Discretisation, Extents, LevelSizes};
use ertel::solve::points::fields_at;
use ertel::solve::sequence::solve_stages;
use ertel::solve::state::State;
use ertel::solve::system::System;
use ertel_fem::linear::NEVER;

const KINDS: [ContactKind; 2] = [ContactKind::Line, ContactKind::Circular];

/// Around the dry contact, and a body of one size below where there is one.
fn extents(body: f64) -> Extents {
    Extents {
        inlet: -1.6,
        outlet: 1.6,
        side: 1.6,
        body_width: body,
        body_depth: body,
    }
}

fn discretised(
    kind: ContactKind,
    sizes: &LevelSizes,
    elasticity: &Elasticity,
    body: f64,
    pressure_order: usize,
) -> Discretisation {
    let contact = ContactSurface::new(
        &common::shape(kind),
        &extents(body),
        sizes,
        elasticity,
        NEVER,
    );
    Discretisation::new(&Arc::new(contact.unwrap()), pressure_order)
}

/// Pressure and deflection of one order on cells of one size above a half-space in Hertz's scales.
fn half_space(kind: ContactKind, size: f64, order: usize) -> Discretisation {
    let elasticity = Elasticity::half_space(order, &hertz_bodies(kind, &[0.3]));
    discretised(kind, &uniform(size), &elasticity, 60.0, order)
}

fn sampled(d: &Discretisation, pressure: impl Fn(f64) -> f64) -> Vec<f64> {
    let points = d.pressure.points.iter();
    points.map(|p| pressure(p[0].hypot(p[1]))).collect()
}

/// Largest error of the deflection at its nodes, over the largest deflection.
fn error(d: &Discretisation, pressure: &dyn Fn(f64) -> f64, exact: &dyn Fn(f64) -> f64) -> f64 {
    let deflection = d.deflect(&sampled(d, pressure), Accuracy::Full);
    let points = d.contact.deflection.points.iter();
    let exact: Vec<f64> = points.map(|p| exact(p[0].hypot(p[1]))).collect();
    largest_difference(&deflection, &exact)
}

fn scientific(values: &[f64]) -> String {
    let values: Vec<String> = values.iter().map(|v| format!("{v:.1e}")).collect();
    values.join(", ")
}

/// Errors on three meshes, each half as coarse as the one before, and the orders in their mean cell size at which
/// they fall.
fn orders_of(
    kind: ContactKind,
    size: f64,
    order: usize,
    pressure: &dyn Fn(f64) -> f64,
    exact: &dyn Fn(f64) -> f64,
) -> ([f64; 3], [f64; 2]) {
    let meshes = [1.0, 0.5, 0.25].map(|share| half_space(kind, share * size, order));
    let errors = [0, 1, 2].map(|i| error(&meshes[i], pressure, exact));
    let dimension = if kind.is_line() { 1.0 } else { 2.0 };
    let orders = [0, 1].map(|i| {
        let cells =
            meshes[i + 1].contact.n_elements() as f64 / meshes[i].contact.n_elements() as f64;
        dimension * (errors[i] / errors[i + 1]).ln() / cells.ln()
    });
    println!(
        "{kind:?} order {order}: {}, orders {orders:.2?}",
        scientific(&errors)
    );
    (errors, orders)
}

/// Deflection under P = (1 − x²)^(n − ½) on a line in Hertz's scales, 2C/π = 1/π, zero at the distance 60.
///
/// With x = cos θ the pressure is sin²ⁿθ dθ, a finite sum of cosines, and
///
/// ```text
///   ln|x − cos θ| = −ln 2 − Σ 2/k T_k(x) cos kθ                     inside
///   ln|x − cos θ| = −ln 2w − Σ 2/k wᵏ cos kθ,  w = |x| − √(x² − 1)   outside
/// ```
fn line_deflection(n: u32, x: f64) -> f64 {
    let x = x.abs();
    // C(2n, n − j)/4ⁿ
    let share = |j: u32| {
        let binomial = (1..=n - j).fold(1.0, |b, i| b * f64::from(n + j + i) / f64::from(i));
        binomial / 4f64.powi(n as i32)
    };
    let w = if x > 1.0 {
        x - (x * x - 1.0).sqrt()
    } else {
        1.0
    };
    let mut integral = -PI * share(0) * (2.0 * w * 60.0).ln();
    for j in 1..=n {
        let sign = if j % 2 == 0 { 1.0 } else { -1.0 };
        let k = f64::from(2 * j);
        let wave = if x > 1.0 {
            w.powf(k)
        } else {
            (k * x.acos()).cos()
        };
        integral -= PI / k * 2.0 * sign * share(j) * wave;
    }
    -integral / PI
}

/// The series at n = 1 is Hertz's deflection.
///
/// Johnson 1985, eq. 2.24b.
#[test]
fn closed_form_of_the_line_is_hertzs() {
    let centre = line_deflection(1, 0.0);
    for x in [0.0, 0.3, 0.99, 1.0, 1.2, 1.6] {
        let shape = hertz::deflection_profile(Family::Cylinder, x);
        assert_relative_eq!(line_deflection(1, x) - centre, shape, epsilon = 1e-13);
    }
}

/// Hertz's pressure ends in a root, of which an element of size h leaves out h^½ on a length h: the deflection's
/// order is 3/2, whatever the elements. How the rim of a circle cuts its cells scatters the errors: the mean order counts.
///
/// Johnson 1985, eqs. 3.19 and 2.24b.
#[test]
fn deflection_under_the_hertz_pressure() {
    for (kind, size, last) in [
        (ContactKind::Line, 0.11, 3e-4),
        (ContactKind::Circular, 0.42, 1e-3),
    ] {
        let exact = |r: f64| match kind {
            ContactKind::Line | ContactKind::Roller => line_deflection(1, r),
            ContactKind::Circular | ContactKind::Elliptical => {
                hertz::deflection_profile(kind.family(), r)
            }
        };
        let (errors, orders) = orders_of(kind, size, 3, &pressure_profile, &exact);
        let mean = 0.5 * (orders[0] + orders[1]);
        assert!(errors[1] < errors[0] && errors[2] < errors[1]);
        assert!(
            errors[2] < last && mean > 1.3,
            "{kind:?}: {errors:?}, {orders:?}"
        );
    }
}

/// Pressures as smooth as the elements can represent: order k + 1 of the interpolation at least. Line: (1 − x²)^(7/2).
/// Circle: exp(−r²/s²), of which 1e-12 lies outside the mesh, deflects s√π exp(−z) I₀(z), z = r²/(2s²), times C.
#[test]
fn deflection_under_smooth_pressures() {
    const S: f64 = 0.3;
    for order in [1, 2, 3] {
        let bell = |x: f64| (1.0 - x * x).max(0.0).powf(3.5);
        let (_, line) = orders_of(ContactKind::Line, 0.21, order, &bell, &|x| {
            line_deflection(4, x)
        });
        let gauss = |r: f64| (-(r / S).powi(2)).exp();
        let exact = |r: f64| {
            let z = 0.5 * (r / S).powi(2);
            let mut term = (-z).exp();
            let mut sum = term;
            for k in 1..200 {
                term *= (0.5 * z / f64::from(k)).powi(2);
                sum += term;
            }
            2.0 / PI * S * PI.sqrt() * sum
        };
        let (_, circular) = orders_of(ContactKind::Circular, 0.21, order, &gauss, &exact);
        let least = (order + 1) as f64 - 0.25;
        assert!(
            line[1] > least && circular[1] > least,
            "{line:?} {circular:?}"
        );
    }
}

/// Deflection at points of the centreline, the centre first.
fn along_centreline(d: &Discretisation) -> Vec<f64> {
    let pressure = sampled(d, pressure_profile);
    let state = State {
        deflection: d.deflect(&pressure, Accuracy::Full),
        pressure,
        ..State::default()
    };
    let at = |x: f64| fields_at(d, &state, [x, 0.0]).unwrap().deflection;
    [0.0, 0.5, 0.9, 1.2, -1.5].map(at).to_vec()
}

/// The finite-element body under the same pressure approaches the half-space as it grows: the deflection of a
/// circular contact like 1/B (the far field of a point load), the shape of a line contact like 1/B². The error that
/// remains after extrapolation of the size is from the elements of the body and the root at the edge.
#[test]
fn the_finite_body_grows_into_the_half_space() {
    for (kind, size, order, left) in [
        (ContactKind::Line, 0.1, 2.0, 2e-3),
        (ContactKind::Circular, 0.2, 1.0, 2e-3),
    ] {
        let ratios = hertz_bodies(kind, &[0.3]);
        let reference = along_centreline(&half_space(kind, 0.25 * size, 3));
        let figure = |values: &[f64]| match kind {
            ContactKind::Line | ContactKind::Roller => values[4] - values[0],
            ContactKind::Circular | ContactKind::Elliptical => values[0],
        };
        let sizes = LevelSizes {
            edge: 2.5 * size,
            depth_growth: 0.45,
            ..uniform(size)
        };
        let bodies = [30.0, 60.0, 120.0].map(|body| {
            let elasticity = Elasticity::finite_elements(2, &ratios);
            along_centreline(&discretised(kind, &sizes, &elasticity, body, 3))
        });
        let exact = figure(&reference);
        let e = [0, 1, 2].map(|i| figure(&bodies[i]) - exact);
        let steps = [e[1] - e[0], e[2] - e[1]];
        let rate = (steps[0] / steps[1]).log2();
        // e(B) = e∞ + c/B^order
        let end = e[2] + steps[1] / (2f64.powf(order) - 1.0);
        println!(
            "{kind:?}: {}, order {rate:.2}, extrapolated {end:.1e}",
            scientific(&e)
        );
        assert_relative_eq!(rate, order, epsilon = 0.15);
        assert!(end.abs() < left, "{kind:?}: {end:.1e}");
        assert!(e[0].abs() > e[2].abs());
    }
}

/// Finite bodies, and a half-space on their surface.
fn responses(contact: &ContactSurface) -> [Box<dyn SurfaceResponse>; 2] {
    let half_space = half_space_on(contact, &[material(2.0, 0.25)]);
    let finite = contact.body().unwrap().1.clone();
    [Box::new(finite), Box::new(half_space)]
}

fn half_space_on(contact: &ContactSurface, bodies: &[Material]) -> HalfSpace {
    let (surface, space) = (&contact.surface, &contact.deflection);
    HalfSpace::new(surface, space, bodies, &contact.near_pairs, &contact.shape)
}

/// A surface on two bodies, with linear or quadratic pressures and quadratic deflections.
fn on_two_bodies(kind: ContactKind, pressure_order: usize) -> Discretisation {
    let size = if kind == ContactKind::Line { 0.1 } else { 0.4 };
    let elasticity = Elasticity::finite_elements(2, &hertz_bodies(kind, &[0.2, 0.35]));
    discretised(kind, &uniform(size), &elasticity, 30.0, pressure_order)
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// Built and applied on one thread, two and three.
#[test]
fn same_bits_on_any_number_of_threads() {
    for kind in KINDS {
        let d = on_two_bodies(kind, 2);
        let p = noise(d.pressure.n_nodes(), 1);
        let results = [1, 2, 3].map(|n| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(n).build();
            pool.unwrap().install(|| {
                responses(&d.contact).map(|response| {
                    [
                        response.deflect(&d.trace, &p, Accuracy::Full),
                        response.deflect(&d.trace, &p, Accuracy::Krylov),
                        response.near_stiffness(),
                    ]
                })
            })
        });
        assert!(results[0] == results[1] && results[0] == results[2]);
    }
}

/// The state that Newton's method ends with satisfies the film equations with the deflection of its pressure:
/// its residual is far below that of a pressure one part in ten thousand off.
#[test]
fn solutions_satisfy_the_equations() {
    for (kind, load) in [(ContactKind::Line, 3e5), (ContactKind::Circular, 10.0)] {
        let mut case = common::case(kind, load);
        case.solver.error_estimate = false;
        assert_eq!(case.elastic_model(), ElasticModel::HalfSpace);
        let problem = problem(&case);
        let end = solve_stages(&problem, &mut NoObserver).unwrap().0;
        let d = &end.discretisation;
        let residual = |factor: f64| {
            let pressure: Vec<f64> = end.state.pressure.iter().map(|p| factor * p).collect();
            let state = State {
                deflection: d.deflect(&pressure, Accuracy::Full),
                pressure,
                ..end.state.clone()
            };
            let r =
                System::assemble(d, &problem.fluid, &end.stage.constants, &state, None).residual;
            dot(&r, &r).sqrt()
        };
        let own = d.deflect(&end.state.pressure, Accuracy::Full);
        assert!(largest_difference(&end.state.deflection, &own) < 1e-13);
        let share = residual(1.0) / residual(1.0001);
        println!("{kind:?}: {share:.1e}");
        assert!(share < 1e-4, "{kind:?}: {share:.1e}");
        near(d.integral(&end.state.pressure), problem.load, 1e-10);
    }
}

/// Ball on disc on cells of the same sizes, above a half-space and above a body of 120 half-widths: the differences are
/// the two meshes, the elements of the body and the part of its bottom that H0 does not take up.
#[test]
fn films_agree_with_those_of_a_large_body() {
    let mut case = common::moes_case(ContactKind::Circular, 20.0, 5.0);
    case.mesh = MeshParams {
        body_width: Some(120.0),
        body_depth: Some(120.0),
        // by themselves, half-spaces take a wider contact area
        inlet: Some(-6.5),
        outlet: Some(2.0),
        side: Some(4.5),
        ..MeshParams::preset(MeshPreset::Normal, ContactKind::Circular)
    };
    case.solver.error_estimate = false;
    let [half, body] = [ElasticModel::HalfSpace, ElasticModel::Equivalent].map(|model| {
        case.solver.elasticity = Some(model);
        solve(&case, &mut NoObserver).unwrap()
    });
    assert_eq!(half.stats.levels.last().unwrap().n_displacement_dofs, 0);
    assert!(body.stats.levels.last().unwrap().n_displacement_dofs > 10_000);
    for (a, b) in [
        (half.summary.film_central, body.summary.film_central),
        (half.summary.film_minimum, body.summary.film_minimum),
    ] {
        println!("{:.2e}", a.value / b.value - 1.0);
        assert_relative_eq!(a.value, b.value, max_relative = 1.5e-3);
    }
}

/// An operator that was given back is made again when requested, with the same bits, by several threads at once, too.
#[test]
fn released_operators_come_back() {
    for kind in KINDS {
        let d = half_space(kind, 0.2, 3);
        let pressure = noise(d.pressure.n_nodes(), 1);
        let before = d.deflect(&pressure, Accuracy::Full);
        d.contact.response.release();
        let (a, b) = rayon::join(
            || d.deflect(&pressure, Accuracy::Full),
            || d.deflect(&pressure, Accuracy::Full),
        );
        assert_eq!(a, before);
        assert_eq!(b, before);
    }
}
