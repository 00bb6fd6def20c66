//! Heat between surfaces that nothing deforms: the energy equation on its own.

use std::sync::Arc;

use ertel::case::Case;
use ertel::contact::ContactKind;

use super::material;
use ertel::elastic::Elasticity;
use ertel::film::FilmFluid;
use ertel::forms::energy::{Heat, Source};
use ertel::params::ThermalParams;
use ertel::run::problem;
use ertel::solve::contact_surface::ContactSurface;
use ertel::solve::discretisation::{Discretisation, Extents, LevelSizes};
use ertel::solve::heat::column::Column;
use ertel::solve::heat::newton::{HeatNewton, HeatParams};
use ertel::solve::sequence::Problem;
use ertel::solve::state::State;
use ertel_fem::linear::NEVER;

/// Contact area of most of these contacts.
pub const EXTENTS: Extents = Extents {
    inlet: -2.0,
    outlet: 1.0,
    side: 1.5,
    body_width: 12.0,
    body_depth: 12.0,
};

/// Cells of one size everywhere.
fn cells(size: f64) -> LevelSizes {
    LevelSizes {
        growth: 0.9,
        depth_growth: 0.9,
        ..super::uniform(size)
    }
}

/// Surfaces that nothing deforms, half a film scale apart at the centre.
pub fn rigid(
    kind: ContactKind,
    extents: &Extents,
    size: f64,
    order: usize,
    column: Column,
    heat: &Heat,
) -> (Discretisation, State) {
    let bodies = match kind {
        ContactKind::Line | ContactKind::Circular => {
            Elasticity::finite_elements(2, &[material(1.0, 0.3)])
        }
        ContactKind::Elliptical | ContactKind::Roller => {
            Elasticity::half_space(2, &[material(1.0, 0.3)])
        }
    };
    let sizes = cells(size);
    let contact =
        ContactSurface::new(&super::shape(kind), extents, &sizes, &bodies, NEVER).expect("mesh");
    let unheated = column.unheated(heat);
    let d = Discretisation::new(&Arc::new(contact), 2).with_heat(order, column, unheated);
    let state = State {
        pressure: vec![0.0; d.pressure.n_nodes()],
        deflection: vec![0.0; d.contact.deflection.n_nodes()],
        rigid_separation: 0.5,
        temperature: d.heat.as_ref().unwrap().unheated(),
    };
    (d, state)
}

/// A heated contact with a film of this order.
pub fn heated_case(kind: ContactKind, film_order: usize) -> Case {
    let load = if kind == ContactKind::Line { 1e5 } else { 50.0 };
    let mut case = super::heated(super::case(kind, load));
    case.thermal = Some(ThermalParams {
        film_order,
        ..ThermalParams::default()
    });
    case
}

/// Its problem with a lubricant that does not expand.
pub fn problem_without_expansion(case: &Case) -> Problem {
    let mut case = case.clone();
    case.lubricant.density = ertel_rheology::DensityLaw::constant(870.0).unwrap();
    problem(&case)
}

/// Temperatures across the film at a place of the centreline.
pub fn across_film(d: &Discretisation, state: &State, x: f64) -> Vec<f64> {
    let (surface, locator) = (&d.contact.surface, &d.contact.locator);
    let (cell, xi) = locator.find(surface, [x, 0.0]).unwrap();
    let space = d.heat.as_ref().unwrap();
    space.column_in(state, cell, xi)[space.column.film_range()].to_vec()
}

/// Newton's method to the end.
pub fn solve(
    d: &Discretisation,
    fluid: &FilmFluid,
    heat: &Heat,
    state: &mut State,
    source: Source,
) {
    let params = HeatParams {
        linear_tolerance: 1e-10,
        ..HeatParams::default()
    };
    let mut newton = HeatNewton::new(d, fluid, heat, params).with_source(source);
    for _ in 0..30 {
        if newton.step(state).expect("a step") < 1e-9 {
            return;
        }
    }
    panic!("the temperatures do not converge");
}
