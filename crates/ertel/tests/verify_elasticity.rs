//! Elasticity of the body: patch tests, manufactured displacements, Hertz's deflection, and the
//! laws that any elastic response obeys.

use crate::common;

use std::sync::Arc;

use approx::assert_relative_eq;
use common::{hertz_bodies, material, noise, uniform};
use ertel::contact::{ContactKind, Family, Material, hertz, pressure_profile};
use ertel::elastic::{Accuracy, BodySpace, Elasticity, FiniteBodies};
use ertel::forms::elasticity::lame;
use ertel::solve::contact_surface::ContactSurface;
use ertel::solve::discretisation::{Discretisation, Extents, LevelSizes};
use ertel::solve::points::fields_at;
use ertel::solve::state::State;
use ertel_fem::assembly::{CONSTRAINED, DofMap, NodeGraph};
use ertel_fem::linear::NEVER;
use ertel_fem::linear::condensed::Keep;
use ertel_fem::mesh::{BodyMesh, BodyParams, body_mesh};
use ertel_fem::quadrature::Quadrature;
use ertel_fem::space::{Affine, Space};

const KINDS: [ContactKind; 2] = [ContactKind::Line, ContactKind::Circular];
const POISSONS_RATIO: f64 = 0.3;

/// Displacement field with the body force that keeps it in balance, by components; E = 1.
struct Exact {
    displacement: fn(usize, [f64; 3]) -> [f64; 3],
    force: fn(usize, [f64; 3]) -> [f64; 3],
}

/// Axes of a body: x and z of a plane one.
fn axes(dim: usize) -> &'static [usize] {
    if dim == 2 { &[0, 2] } else { &[0, 1, 2] }
}

/// Box [−1, 1] × [−1, 0] × [−1, 0] with cells of one size.
fn cube(dim: usize, size: f64) -> BodyMesh {
    let params = BodyParams {
        dim,
        x_inlet: -1.0,
        x_outlet: 1.0,
        y_side: 1.0,
        width: 2.0,
        depth: 1.0,
    };
    body_mesh(&params, &|_| size).unwrap()
}

/// Solves with the displacement prescribed on the whole boundary; L2 error of the result.
///
/// The stiffness is the product's: all of it for the lifting, the interior of it to solve.
fn error(body: &BodyMesh, order: usize, exact: &Exact) -> f64 {
    let dim = body.mesh.dim;
    let space = Space::new(&body.mesh, order);
    let on_boundary = |p: [f64; 3]| {
        let near = |a: f64, b: f64| (a - b).abs() < 1e-9;
        near(p[0].abs(), 1.0)
            || near(p[2], 0.0)
            || near(p[2], -1.0)
            || (dim == 3 && (near(p[1], 0.0) || near(p[1], -1.0)))
    };
    let with = |free: &dyn Fn(usize) -> bool| BodySpace {
        dofs: DofMap::new(space.n_nodes(), dim, |node, _| free(node)),
        graph: NodeGraph::new(&space),
        space: space.clone(),
        normal_dofs: Vec::new(),
    };
    let whole = with(&|_| true);
    let interior = with(&|node| !on_boundary(space.points[node]));

    let mut u = vec![0.0; dim * space.n_nodes()];
    for (node, p) in space.points.iter().enumerate() {
        if on_boundary(*p) {
            let value = (exact.displacement)(dim, *p);
            u[node * dim..(node + 1) * dim].copy_from_slice(&value[..dim]);
        }
    }
    let lifted = whole.stiffness(body, POISSONS_RATIO).multiply(&u);

    let rule = Quadrature::simplex(dim, 2 * order + 3);
    let table = space.element.tabulate(&rule);
    let n = table.n_nodes;
    let point = |cell: usize, q: usize| {
        let mut x = [0.0; 3];
        let corner = |k: usize| body.mesh.vertices[body.mesh.cells[cell][k] as usize];
        let xi = rule.points[q];
        for a in 0..3 {
            x[a] = corner(0)[a]
                + (0..dim)
                    .map(|k| xi[k] * (corner(k + 1)[a] - corner(0)[a]))
                    .sum::<f64>();
        }
        x
    };
    let mut load = vec![0.0; interior.dofs.n_dofs];
    for cell in 0..body.mesh.n_cells() {
        let determinant = Affine::new(&body.mesh, cell).determinant;
        for q in 0..rule.len() {
            let force = (exact.force)(dim, point(cell, q));
            let w = rule.weights[q] * determinant;
            for (i, node) in space.nodes_of(cell).iter().enumerate() {
                for (c, dof) in interior.dofs.of_node(*node as usize).iter().enumerate() {
                    if *dof != CONSTRAINED {
                        load[*dof as usize] += w * table.values[q * n + i] * force[c];
                    }
                }
            }
        }
    }
    for node in 0..space.n_nodes() {
        for (c, dof) in interior.dofs.of_node(node).iter().enumerate() {
            if *dof != CONSTRAINED {
                load[*dof as usize] -= lifted[node * dim + c];
            }
        }
    }
    interior
        .factorise(body, POISSONS_RATIO, Keep::Factor, NEVER)
        .unwrap()
        .solve_full(&mut load)
        .unwrap();
    for node in 0..space.n_nodes() {
        for (c, dof) in interior.dofs.of_node(node).iter().enumerate() {
            if *dof != CONSTRAINED {
                u[node * dim + c] = load[*dof as usize];
            }
        }
    }
    let mut sum = 0.0;
    for cell in 0..body.mesh.n_cells() {
        let determinant = Affine::new(&body.mesh, cell).determinant;
        for q in 0..rule.len() {
            let value = (exact.displacement)(dim, point(cell, q));
            for c in 0..dim {
                let ours: f64 = (space.nodes_of(cell).iter().enumerate())
                    .map(|(i, node)| table.values[q * n + i] * u[*node as usize * dim + c])
                    .sum();
                sum += rule.weights[q] * determinant * (ours - value[c]).powi(2);
            }
        }
    }
    sum.sqrt()
}

/// u_m = a_m + Σ_n b_mn x_n: no force.
const LINEAR: Exact = Exact {
    displacement: |dim, p| {
        let b = [[0.3, -0.2, 0.5], [0.1, 0.4, -0.6], [-0.7, 0.2, 0.15]];
        components(dim, |m| {
            0.1 + (axes(dim).iter()).map(|&n| b[m][n] * p[n]).sum::<f64>()
        })
    },
    force: |_, _| [0.0; 3],
};

/// u_m = Σ_n c_mn x_n² + d_m x_0 x_2, force −[(λ+μ) ∂_m div u + μ Δu_m] by hand.
const QUADRATIC: Exact = Exact {
    displacement: |dim, p| {
        components(dim, |m| {
            (axes(dim).iter())
                .map(|&n| C[m][n] * p[n] * p[n])
                .sum::<f64>()
                + D[m] * p[0] * p[2]
        })
    },
    force: |dim, _| {
        let (lambda, mu) = lame(1.0, POISSONS_RATIO);
        components(dim, |m| {
            // div u = Σ_n 2 c_nn x_n + d_0 x_2 + d_2 x_0
            let mixed = match m {
                0 => D[2],
                2 => D[0],
                _ => 0.0,
            };
            let laplacian: f64 = axes(dim).iter().map(|&n| 2.0 * C[m][n]).sum();
            -((lambda + mu) * (2.0 * C[m][m] + mixed) + mu * laplacian)
        })
    },
};
const C: [[f64; 3]; 3] = [[0.3, -0.4, 0.2], [0.5, 0.1, -0.3], [-0.2, 0.6, 0.7]];
const D: [f64; 3] = [0.8, -0.5, 0.35];

/// u_m = a_m sin(k_m·x + m), force −[(λ+μ) ∂_m div u + μ Δu_m] by hand.
const WAVES: Exact = Exact {
    displacement: |dim, p| components(dim, |m| A[m] * phase(dim, m, p).sin()),
    force: |dim, p| {
        let (lambda, mu) = lame(1.0, POISSONS_RATIO);
        components(dim, |m| {
            let square: f64 = axes(dim).iter().map(|&n| K[m][n].powi(2)).sum();
            let divergence: f64 = (axes(dim).iter())
                .map(|&n| A[n] * K[n][n] * K[n][m] * phase(dim, n, p).sin())
                .sum();
            (lambda + mu) * divergence + mu * square * A[m] * phase(dim, m, p).sin()
        })
    },
};
const A: [f64; 3] = [1.0, -0.7, 0.5];
const K: [[f64; 3]; 3] = [[1.5, 0.8, -1.0], [0.6, -1.2, 1.1], [-0.9, 1.3, 2.0]];

fn phase(dim: usize, m: usize, p: [f64; 3]) -> f64 {
    m as f64 + axes(dim).iter().map(|&n| K[m][n] * p[n]).sum::<f64>()
}

/// Components of a vector in the order of the unknowns.
fn components(dim: usize, value: impl Fn(usize) -> f64) -> [f64; 3] {
    let mut v = [0.0; 3];
    for (c, &axis) in axes(dim).iter().enumerate() {
        v[c] = value(axis);
    }
    v
}

/// Constant strain is met by both elements, linear strain under a body force by the quadratic one
/// and not by the linear one.
#[test]
fn patch_tests() {
    for dim in [2, 3] {
        let body = cube(dim, 0.5);
        for order in [1, 2] {
            assert!(error(&body, order, &LINEAR) < 1e-13);
        }
        assert!(error(&body, 2, &QUADRATIC) < 1e-13);
        assert!(error(&body, 1, &QUADRATIC) > 1e-3);
    }
}

/// L2 order of convergence: element order + 1.
///
/// Habchi 2008, eqs. 3.4 and 3.5.
#[test]
fn manufactured_displacement() {
    for (dim, coarse) in [(2, 0.2), (3, 0.5)] {
        for order in [1, 2] {
            let [a, b] = [coarse, 0.5 * coarse].map(|size| {
                let body = cube(dim, size);
                let volume_per_cell = 1.0 / body.mesh.n_cells() as f64;
                (
                    volume_per_cell.powf(1.0 / dim as f64),
                    error(&body, order, &WAVES),
                )
            });
            let rate = (a.1 / b.1).ln() / (a.0 / b.0).ln();
            println!(
                "{dim}D order {order}: {:.1e} -> {:.1e}, rate {rate:.2}",
                a.1, b.1
            );
            assert!(
                (rate - (order + 1) as f64).abs() < 0.3,
                "{dim}D, order {order}: {rate:.2}"
            );
        }
    }
}

/// Uniform pressure on the whole upper side of a block without lateral strain (ν = 0), clamped
/// below: it shortens by P depth/E, whatever the mesh.
#[test]
fn block_under_uniform_pressure() {
    let extents = Extents {
        inlet: -1.0,
        outlet: 1.0,
        side: 1.0,
        body_width: 2.0,
        body_depth: 3.0,
    };
    for kind in KINDS {
        let d = on_bodies(kind, &extents, &uniform(0.5), &[material(7.0, 0.0)]);
        let pressure = vec![2.0; d.pressure.n_nodes()];
        for w in d.deflect(&pressure, Accuracy::Full) {
            assert_relative_eq!(w, 2.0 * 3.0 / 7.0, max_relative = 1e-11);
        }
    }
}

/// Contact area of the thesis on a cubic (square) body; cells of `size` under the Hertz zone.
fn contact(kind: ContactKind, body: f64, size: f64, growth: f64, ratios: &[f64]) -> Discretisation {
    let extents = Extents {
        inlet: -4.5,
        outlet: 1.5,
        side: 3.0,
        body_width: body,
        body_depth: body,
    };
    let sizes = LevelSizes {
        hertz: size,
        constriction: size,
        rim: size,
        outlet_rim: size,
        rim_width: 0.0,
        edge: 2.5 * size,
        growth,
        depth_growth: growth,
    };
    on_bodies(kind, &extents, &sizes, &hertz_bodies(kind, ratios))
}

/// Cubic pressures on quadratic bodies.
fn on_bodies(
    kind: ContactKind,
    extents: &Extents,
    sizes: &LevelSizes,
    bodies: &[Material],
) -> Discretisation {
    let elasticity = Elasticity::finite_elements(2, bodies);
    let contact =
        ContactSurface::new(&common::shape(kind), extents, sizes, &elasticity, NEVER).unwrap();
    Discretisation::new(&Arc::new(contact), 3)
}

/// The condensed bodies below a contact area.
fn condensed(d: &Discretisation) -> &FiniteBodies {
    d.contact.body().unwrap().1
}

/// Computed less exact deflection under the Hertz pressure at points of the centreline, the
/// centre first.
fn hertz_error(d: &Discretisation) -> Vec<f64> {
    let family = match d.contact.shape.is_line() {
        true => Family::Cylinder,
        false => Family::Point,
    };
    let pressure: Vec<f64> = (d.pressure.points.iter())
        .map(|p| pressure_profile(p[0].hypot(p[1])))
        .collect();
    let state = State {
        deflection: d.deflect(&pressure, Accuracy::Full),
        pressure,
        rigid_separation: 0.0,
        ..State::default()
    };
    [0.0, 0.5, 0.9, 1.1, 1.4, -2.0, -3.5]
        .iter()
        .map(|x| {
            fields_at(d, &state, [*x, 0.0]).unwrap().deflection
                - hertz::deflection_profile(family, *x)
        })
        .collect()
}

/// Largest error of the deflection relative to the centre: a shift of the whole surface only
/// changes H0.
fn shape_error(d: &Discretisation) -> f64 {
    let e = hertz_error(d);
    e.iter().fold(0.0, |m, v| m.max((v - e[0]).abs()))
}

/// Deflection under the Hertz pressure against the half-space (Johnson 1985, section 3.4, 4.2):
/// the error halves at least when the cells do, until the finite body shows.
///
/// Habchi 2008, eq. 3.6.
#[test]
fn hertz_deflection_under_refinement() {
    for (kind, body, size, tolerance) in [
        (ContactKind::Line, 480.0, 0.2, 1e-3),
        (ContactKind::Circular, 120.0, 0.4, 1e-3),
    ] {
        let errors = [1.0, 0.5]
            .map(|share| shape_error(&contact(kind, body, share * size, 0.8 * share, &[0.3])));
        println!("{kind:?}: {:.1e} -> {:.1e}", errors[0], errors[1]);
        assert!(
            errors[1] < 0.5 * errors[0] && errors[1] < tolerance,
            "{kind:?}: {errors:?}"
        );
    }
}

/// The finite body, clamped at its bottom, is too stiff by a term 1/B (a point load's far field),
/// B its size: doubling B halves what is missing.
#[test]
fn box_effect_of_a_circular_contact() {
    let e = [15.0, 30.0, 60.0, 120.0]
        .map(|b| hertz_error(&contact(ContactKind::Circular, b, 0.4, 0.9, &[0.3]))[0]);
    let orders = [0, 1].map(|i| ((e[i + 1] - e[i]) / (e[i + 2] - e[i + 1])).log2());
    println!("centre {e:?}, orders {orders:.3?}");
    assert!(e.windows(2).all(|w| w[0] < w[1]));
    for order in orders {
        assert_relative_eq!(order, 1.0, epsilon = 0.1);
    }
    // 0.7 % of the Hertz deflection for the thesis's body of 60 half-widths.
    assert!((e[3] - e[2]).abs() < 0.003);
}

/// Plane strain: the surface sinks by 2w/(πE*) ln 2 = ln 2/2 (dimensionless) more for each doubling
/// of the body, E* = E'/2 (Johnson 1985, eq. 2.19); its shape feels the bottom as 1/B².
#[test]
fn box_effect_of_a_line_contact() {
    let e = [30.0, 60.0, 120.0, 240.0]
        .map(|b| hertz_error(&contact(ContactKind::Line, b, 0.1, 0.4, &[0.3])));
    let shape = |i: usize| e[i][6] - e[i][0];
    let orders = [0, 1].map(|i| ((shape(i + 1) - shape(i)) / (shape(i + 2) - shape(i + 1))).log2());
    println!("shape orders {orders:.3?}");
    for i in 0..3 {
        println!("{}", e[i + 1][0] - e[i][0]);
        assert_relative_eq!(e[i + 1][0] - e[i][0], 0.5 * 2f64.ln(), max_relative = 3e-3);
    }
    for order in orders {
        assert_relative_eq!(order, 2.0, epsilon = 0.15);
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// Work of one load on the deflection of another is mutual (Betti) and, on its own, positive.
#[test]
fn response_is_reciprocal_and_positive() {
    for kind in KINDS {
        let d = contact(kind, 60.0, 0.4, 0.9, &[0.2, 0.35]);
        let n = d.contact.deflection.n_nodes();
        for seed in 1..4 {
            let (f, g) = (noise(n, seed), noise(n, 100 + seed));
            let bodies = condensed(&d);
            let (w_f, w_g) = (bodies.deflect_loads(&f), bodies.deflect_loads(&g));
            let own = [dot(&f, &w_f), dot(&g, &w_g)];
            assert!(own[0] > 0.0 && own[1] > 0.0);
            let scale = (own[0] * own[1]).sqrt();
            assert_relative_eq!(dot(&f, &w_g), dot(&g, &w_f), epsilon = 1e-12 * scale);
        }
    }
}

/// The condensed solve gives the normal displacement of the whole body's solution, which satisfies
/// the whole body's equations; the bodies' shares add up.
#[test]
fn condensed_response_equals_full_solution() {
    for kind in KINDS {
        let ratios = [0.2, 0.35];
        let d = contact(kind, 60.0, 0.4, 0.9, &ratios);
        let deflection = &d.contact.deflection;
        let (body, bodies) = d.contact.body().unwrap();
        let space = body.space(deflection);
        let load = noise(deflection.n_nodes(), 7);
        let mut sum = vec![0.0; load.len()];
        for share in &bodies.bodies {
            let mut f = vec![0.0; space.dofs.n_dofs];
            for (dof, v) in space.normal_dofs.iter().zip(&load) {
                f[*dof] = *v;
            }
            let mut u = f.clone();
            space
                .factorise(
                    &body.mesh,
                    share.material.poissons_ratio,
                    Keep::Factor,
                    NEVER,
                )
                .unwrap()
                .solve_full(&mut u)
                .unwrap();
            let stiffness = space.stiffness(&body.mesh, share.material.poissons_ratio);
            for (a, b) in stiffness.multiply(&u).iter().zip(&f) {
                assert_relative_eq!(a, b, epsilon = 1e-10);
            }
            for (s, dof) in sum.iter_mut().zip(&space.normal_dofs) {
                *s += u[*dof] / share.material.youngs_modulus;
            }
        }
        for (a, b) in bodies.deflect_loads(&load).iter().zip(&sum) {
            assert_relative_eq!(a, b, epsilon = 1e-11);
        }
    }
}

/// Two bodies of one ratio, each of twice the modulus, are one body.
#[test]
fn equal_bodies_in_series() {
    for kind in KINDS {
        let [one, two] = [vec![0.3], vec![0.3, 0.3]].map(|r| contact(kind, 60.0, 0.8, 0.9, &r));
        let load = noise(one.contact.deflection.n_nodes(), 3);
        let (a, b) = (
            condensed(&one).deflect_loads(&load),
            condensed(&two).deflect_loads(&load),
        );
        for (a, b) in a.iter().zip(&b) {
            assert_relative_eq!(a, b, epsilon = 1e-13);
        }
    }
}
