//! Jacobian of the coupled film equations against differences of the residual.

use crate::common;

use std::sync::Arc;

use common::noise;
use ertel::contact::{ContactKind, pressure_profile};
use ertel::elastic::Accuracy;
use ertel::params::{ElasticModel, Formulation};
use ertel::run::problem;
use ertel::solve::contact_surface::ContactSurface;
use ertel::solve::discretisation::{Discretisation, LevelSizes};
use ertel::solve::state::{FilmConstants, State};
use ertel::solve::system::System;
use ertel_fem::assembly::CONSTRAINED;
use ertel_fem::linear::NEVER;
use ertel_rheology::shear::{Carreau, ShearLaw, ShearThinning, StressLimit};

const SIZES: LevelSizes = LevelSizes {
    hertz: 0.4,
    constriction: 0.2,
    rim: 0.2,
    outlet_rim: 0.2,
    rim_width: 0.0,
    edge: 0.8,
    growth: 0.9,
    depth_growth: 0.9,
};

/// Pressures with the deflection that belongs to them.
fn state(d: &Discretisation, pressure: Vec<f64>, rigid_separation: f64) -> State {
    State {
        deflection: d.deflect(&pressure, Accuracy::Full),
        pressure,
        rigid_separation,
        temperature: d.heat.as_ref().map_or_else(Vec::new, |heat| {
            // Hot in the middle, rough from node to node of the contact area.
            let rough = noise(2 * heat.surface.n_nodes(), 3);
            let mut temperature = heat.unheated();
            let columns = temperature.chunks_exact_mut(heat.column.n());
            for (column, r) in columns.zip(rough.chunks_exact(2)) {
                let film = column[heat.column.film_range()].iter_mut();
                for (t, s) in film.zip(heat.column.film.points()) {
                    *t += 25.0
                        + 10.0 * r[0]
                        + 20.0 * (1.0 + 0.3 * r[1]) * (1.0 - 4.0 * s * s)
                        + 8.0 * s;
                }
            }
            temperature
        }),
    }
}

/// Signs of P at the quadrature points, and the smallest film there.
fn signs_and_film(d: &Discretisation, s: &State) -> (Vec<bool>, f64) {
    let mut signs = Vec::new();
    let mut film = f64::INFINITY;
    for c in 0..d.contact.n_elements() {
        for xi in &d.rule.points {
            let f = ertel::solve::points::fields_in(d, s, c, *xi);
            signs.push(f.pressure < 0.0);
            film = film.min(f.film);
        }
    }
    (signs, film)
}

/// J·(dP, dH0) at a rough state with a cavitated outlet against a five-point difference, deflection
/// included; no quadrature point changes the sign of its pressure on the way, so that the residual
/// is smooth there. With a step of
/// 1e-5 and α p_h ≈ 20 the formula's own error is below 1e-13, round-off about 1e-9 of the largest row.
fn check(
    kind: ContactKind,
    elasticity: ElasticModel,
    order: usize,
    thinned: Option<ShearThinning>,
    heat: bool,
) {
    let mut case = common::case(
        kind,
        if kind == ContactKind::Line {
            3e5
        } else {
            100.0
        },
    );
    case.solver.elasticity = Some(elasticity);
    case.body_1.elasticity = common::GLASS;
    case.motion.slide_to_roll_ratio = 0.3;
    if kind == ContactKind::Elliptical {
        case.motion.slide_to_roll_ratio_across = -0.2;
        case.motion.spin = [400.0, -900.0];
        // Nearly along the longer axis, where cells are slender.
        case.contact.entrainment_angle = 1.3;
    }
    if heat {
        case = common::heated(case);
    }
    let mut problem = problem(&case);
    let scales = problem.scales;
    let thins = thinned.is_some();
    let sliding = case.motion.sliding(scales.length);
    problem.fluid = problem
        .fluid
        .with_shear(thinned.as_ref(), &sliding, &scales);
    let contact = ContactSurface::new(
        &problem.shape,
        &problem.extents,
        &SIZES,
        &problem.elasticity,
        NEVER,
    )
    .expect("mesh");
    let mut d = Discretisation::new(&Arc::new(contact), order);
    if let (Some(heat), Some(plan)) = (&problem.heat, &problem.plan.heat) {
        let column = plan.column.clone();
        let unheated = column.unheated(heat);
        d = d.with_heat(1, column, unheated);
    }
    let rough = noise(d.pressure.n_nodes(), 3);
    let pressure: Vec<f64> = (d.pressure.points.iter().zip(&rough).zip(&d.pressure_dofs))
        .map(|((p, r), dof)| {
            if *dof == CONSTRAINED {
                return 0.0;
            }
            let outlet = p[0] > 1.0;
            let base = pressure_profile(p[0].hypot(p[1]));
            if outlet {
                -0.05 * (1.0 + 0.2 * r)
            } else {
                (base + 0.1) * (1.0 + 0.1 * r)
            }
        })
        .collect();
    let mut base = state(&d, pressure, 0.0);
    base.rigid_separation = 0.15 - signs_and_film(&d, &base).1;
    let (signs, film) = signs_and_film(&d, &base);
    assert!(film > 0.1 && signs.contains(&true) && signs.contains(&false));

    let mut direction = noise(d.pressure.n_nodes(), 2);
    for (v, dof) in direction.iter_mut().zip(&d.pressure_dofs) {
        if *dof == CONSTRAINED {
            *v = 0.0;
        }
    }
    let mut unknowns = vec![0.0; d.n_pressure];
    for (v, dof) in direction.iter().zip(&d.pressure_dofs) {
        if *dof != CONSTRAINED {
            unknowns[*dof as usize] = *v;
        }
    }
    let d_separation = 0.7;
    let moved = |step: f64| {
        let pressure = (base.pressure.iter().zip(&direction))
            .map(|(p, v)| p + step * v)
            .collect();
        state(&d, pressure, base.rigid_separation + step * d_separation)
    };
    let step = 1e-5;
    for formulation in [Formulation::Galerkin, Formulation::Supg, Formulation::Gls] {
        for diffusion in [0.0, 0.5] {
            let constants = FilmConstants {
                formulation,
                isotropic_diffusion: diffusion,
                ..problem.plan.stages.last().unwrap().constants
            };
            let residual = |factor: f64| {
                let s = moved(factor * step);
                assert_eq!(signs_and_film(&d, &s).0, signs, "a kink lies on the way");
                System::assemble(&d, &problem.fluid, &constants, &s, None).residual
            };
            let system = System::assemble(&d, &problem.fluid, &constants, &base, None);
            let mut product = vec![0.0; d.n_pressure];
            system
                .products(&d, Accuracy::Full)
                .multiply(&unknowns, &mut product);
            for (y, b) in product.iter_mut().zip(&system.by_separation) {
                *y += d_separation * b;
            }
            let f = [-2.0, -1.0, 1.0, 2.0].map(residual);
            let difference: Vec<f64> = (0..d.n_pressure)
                .map(|i| (f[0][i] - 8.0 * f[1][i] + 8.0 * f[2][i] - f[3][i]) / (12.0 * step))
                .collect();
            // Row by row: inlet and penalty are many decades above the rest.
            let largest = difference.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
            let relative = (product.iter().zip(&difference))
                .map(|(p, d)| (p - d).abs() / (d.abs() + 1e-9 * largest))
                .fold(0.0, f64::max);
            println!(
                "{kind:?} {elasticity:?} thins: {thins} heat: {heat} {formulation:?} diffusion {diffusion}: {relative:.1e}"
            );
            assert!(
                relative < 1e-6,
                "{kind:?} {elasticity:?} thins: {thins} heat: {heat} {formulation:?} diffusion {diffusion}: {relative:.1e}"
            );
        }
    }
}

#[test]
fn line() {
    check(ContactKind::Line, ElasticModel::Equivalent, 3, None, false);
    check(ContactKind::Line, ElasticModel::TwoBodies, 2, None, false);
    check(ContactKind::Line, ElasticModel::HalfSpace, 3, None, false);
}

#[test]
fn circular() {
    check(
        ContactKind::Circular,
        ElasticModel::Equivalent,
        2,
        None,
        false,
    );
    check(
        ContactKind::Circular,
        ElasticModel::TwoBodies,
        3,
        None,
        false,
    );
    check(
        ContactKind::Circular,
        ElasticModel::HalfSpace,
        2,
        None,
        false,
    );
    for kind in [ContactKind::Elliptical, ContactKind::Roller] {
        check(kind, ElasticModel::HalfSpace, 2, None, false);
    }
}

/// Laws of which every part acts in these states: two plateaus, and a limit that moves with the pressure.
fn thinning() -> [ShearThinning; 2] {
    // β_c = 2: with others the flow has a corner where the stress passes zero, and differences lose digits.
    let carreau = Carreau::new(1e6, 0.5, 2.0, 0.2).unwrap();
    [
        ShearThinning::of(ShearLaw::Carreau(carreau.clone())),
        ShearThinning {
            law: Some(ShearLaw::Carreau(carreau)),
            limit: Some(StressLimit::new(2e8, 0.1).unwrap()),
        },
    ]
}

#[test]
fn line_shear_thinning() {
    for law in thinning() {
        check(
            ContactKind::Line,
            ElasticModel::Equivalent,
            3,
            Some(law),
            false,
        );
    }
}

#[test]
fn circular_shear_thinning() {
    for law in thinning() {
        check(
            ContactKind::Circular,
            ElasticModel::Equivalent,
            2,
            Some(law),
            false,
        );
    }
}

/// Sliding at an angle, and spin.
#[test]
fn elliptical_shear_thinning() {
    for law in thinning() {
        for heat in [false, true] {
            check(
                ContactKind::Elliptical,
                ElasticModel::HalfSpace,
                2,
                Some(law.clone()),
                heat,
            );
        }
    }
}

/// Rough temperatures, Newtonian and thinned.
#[test]
fn heated() {
    check(ContactKind::Line, ElasticModel::Equivalent, 3, None, true);
    let [carreau, _] = thinning();
    check(
        ContactKind::Line,
        ElasticModel::Equivalent,
        2,
        Some(carreau.clone()),
        true,
    );
    check(
        ContactKind::Circular,
        ElasticModel::Equivalent,
        2,
        Some(carreau.clone()),
        true,
    );
    check(
        ContactKind::Circular,
        ElasticModel::HalfSpace,
        2,
        Some(carreau),
        true,
    );
}
