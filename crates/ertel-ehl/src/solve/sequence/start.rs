//! Where a stage starts: from the dry contact, or from the solution on another mesh.

use super::{Problem, StageSolution};
use crate::elastic::Accuracy;
use crate::solve::discretisation::Discretisation;
use crate::solve::dry::dry_pressure;
use crate::solve::evaluate::{central_film, minimum_film};
use crate::solve::points::{fields_at, pressure_at};
use crate::solve::state::State;

/// Hertz pressure, and H0 such that the central film is the problem's start film.
pub fn cold_start(problem: &Problem, d: &Discretisation) -> State {
    let mut pressure: Vec<f64> = d
        .pressure
        .points
        .iter()
        .map(|p| d.contact.shape.zone.pressure([p[0], p[1]]))
        .collect();
    if problem.shape.zone.roller.is_some() {
        // Slices give only a rough pressure at ends and kinks of the profile.
        pressure = dry_pressure(d, &pressure, problem.load);
    }
    let deflection = d.deflect(&pressure, Accuracy::Full);
    let mut state = State {
        pressure,
        deflection,
        rigid_separation: 0.0,
        temperature: d
            .heat
            .as_ref()
            .map_or_else(Vec::new, |heat| heat.unheated()),
    };
    state.rigid_separation = problem.start_film - central_film(d, &state);
    if let Some(roller) = &problem.shape.zone.roller {
        // The middle of a tilted roller may not touch, and slices are not quite in balance.
        let at = fields_at(d, &state, [0.0, roller.heaviest()]);
        let loaded = at.map_or(0.0, |fields| problem.start_film - fields.film);
        let (thinnest, _) = minimum_film(d, &state);
        state.rigid_separation += loaded.max(0.5 * problem.start_film - thinnest);
    }
    state
}

/// Pressures of a coarser level, without new extrema; same central film.
pub(super) fn interpolate(coarse: &StageSolution, d: &Discretisation) -> State {
    let (from, old) = (&coarse.discretisation, &coarse.state);
    let pressure: Vec<f64> = d
        .pressure
        .points
        .iter()
        .zip(&d.pressure_dofs)
        .map(|(p, dof)| {
            if *dof == ertel_fem::assembly::CONSTRAINED {
                return 0.0;
            }
            pressure_at(from, &old.pressure, [p[0], p[1]])
        })
        .collect();
    let deflection = d.deflect(&pressure, Accuracy::Full);
    let mut state = State {
        pressure,
        deflection,
        rigid_separation: 0.0,
        temperature: temperatures(from, old, d),
    };
    state.rigid_separation = central_film(from, old) - central_film(d, &state);
    // Deflections of two meshes differ by more than the thinnest film has to give.
    let (thinnest, _) = minimum_film(d, &state);
    let floor = 0.5 * minimum_film(from, old).0;
    state.rigid_separation += (floor - thinnest).max(0.0);
    state
}

/// Temperatures of a coarser level, or those before heating where it has none; empty where heat is neglected.
fn temperatures(from: &Discretisation, old: &State, d: &Discretisation) -> Vec<f64> {
    let Some(fine) = &d.heat else {
        return Vec::new();
    };
    let mut temperature = fine.unheated();
    let Some(coarse) = &from.heat else {
        return temperature;
    };
    let n = fine.column.n();
    if coarse.column.n() != n {
        return temperature;
    }
    // A start from another contact may have other inflow temperatures: the rise above them is carried over.
    let offsets: Vec<f64> = (fine.unheated().iter().zip(&coarse.unheated()))
        .take(n)
        .map(|(own, its)| own - its)
        .collect();
    for (column, p) in temperature.chunks_exact_mut(n).zip(&fine.surface.points) {
        let found = from
            .contact
            .locator
            .find(&from.contact.surface, [p[0], p[1]]);
        if let Some((cell, xi)) = found {
            column.copy_from_slice(&coarse.column_in(old, cell, xi));
            for (t, offset) in column.iter_mut().zip(&offsets) {
                *t += offset;
            }
        }
    }
    temperature
}
