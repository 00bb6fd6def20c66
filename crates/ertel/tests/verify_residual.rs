//! The scale of the residual in Newton's method against integrals by hand.

use crate::common;

use ertel::contact::ContactKind;
use ertel::params::Formulation;
use ertel::run::problem;
use ertel::solve::contact_surface::ContactSurface;
use ertel::solve::discretisation::{Discretisation, Extents};
use ertel::solve::state::{FilmConstants, State};
use ertel::solve::system::System;
use ertel_fem::linear::NEVER;

/// P = 0, ρ̄ = 1, Galerkin: entrainment is all there is, and the relative residual is 1. At the node X_i of linear elements of size l it is
/// −∫H ∂N_i/∂X with H = X²/2 + H0: (H̄_right − H̄_left), H̄ the mean over an element, by the means of X². The quadrature is exact for X².
#[test]
fn residual_is_relative_to_the_entrained_flow() {
    let mut case = common::case(ContactKind::Line, 1e5);
    case.lubricant.density = ertel_rheology::DensityLaw::constant(870.0).unwrap();
    let problem = problem(&case);
    let extents = Extents {
        inlet: -2.0,
        outlet: 1.0,
        side: 1.0,
        body_width: 12.0,
        body_depth: 12.0,
    };
    let contact = ContactSurface::new(
        &ertel::contact::Shape::LINE,
        &extents,
        &common::uniform(0.1),
        &problem.elasticity,
        NEVER,
    )
    .unwrap();
    let d = Discretisation::new(&std::sync::Arc::new(contact), 1);
    let constants = FilmConstants {
        formulation: Formulation::Galerkin,
        isotropic_diffusion: 0.0,
        ridge_diffusion: 0.0,
        ..problem.plan.stages[0].constants
    };
    let state = State {
        pressure: vec![0.0; d.pressure.n_nodes()],
        deflection: vec![0.0; d.contact.deflection.n_nodes()],
        rigid_separation: 0.4,
        ..State::default()
    };
    let system = System::assemble(&d, &problem.fluid, &constants, &state, None);
    let mut points: Vec<f64> = d.pressure.points.iter().map(|p| p[0]).collect();
    points.sort_by(f64::total_cmp);
    let mean = |a: f64, b: f64| 0.4 + (a * a + a * b + b * b) / 6.0;
    let rows = points
        .windows(3)
        .map(|x| mean(x[1], x[2]) - mean(x[0], x[1]));
    let scale = rows.map(|r| r * r).sum::<f64>().sqrt();
    println!("{} against {scale}", system.residual_scale);
    assert!((system.residual_scale / scale - 1.0).abs() < 1e-10);
    assert!((system.relative_residual() - 1.0).abs() < 1e-12);
    // Of ten times the residual it is ten times as much.
    let tenfold = System {
        residual: system.residual.iter().map(|r| 10.0 * r).collect(),
        ..system
    };
    assert!((tenfold.relative_residual() - 10.0).abs() < 1e-11);
}
