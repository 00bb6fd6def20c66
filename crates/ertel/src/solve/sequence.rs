//! Coarse-to-fine sequence of levels.

use super::discretisation::{BodyConstants, Discretisation, Extents, LevelSizes};
use super::newton::{FilmModel, NewtonLevel, NewtonParams, NewtonStats, RunLabel};
use super::system::{FilmConstants, State};
use super::{Observer, SolveError};
use crate::contact::{ContactKind, hertz};
use crate::film::FilmFluid;
use crate::post::film::{central_film, fields_at, minimum_film};
use crate::solution::LevelStats;

/// Everything a solve needs, dimensionless.
pub struct Problem {
    /// Line or circular.
    pub kind: ContactKind,
    /// Contact area and body.
    pub extents: Extents,
    /// Levels, coarse to fine: sizes and pressure order.
    pub levels: Vec<(LevelSizes, usize)>,
    /// Order of the displacement.
    pub elastic_order: usize,
    /// Elastic bodies: the equivalent one, or plane and ball.
    pub bodies: Vec<BodyConstants>,
    /// Fluid.
    pub fluid: FilmFluid,
    /// Constants of the Reynolds equation, penalty at full strength.
    pub constants: FilmConstants,
    /// Target of ∫P over the (half) contact area.
    pub load: f64,
    /// Central film of the start.
    pub start_film: f64,
    /// Film scale a²/R, m.
    pub film_scale: f64,
    /// Newton tolerances of the finest level.
    pub newton: NewtonParams,
}

/// A converged level.
pub struct LevelSolution {
    /// The discretisation.
    pub discretisation: Discretisation,
    /// The state on it.
    pub state: State,
}

/// Shares of the full cavitation penalty on the coarsest level, where the free boundary is
/// still far from its place.
const PENALTY_RAMP: [f64; 3] = [1e-4, 1e-2, 1.0];

/// Update, in p_h, below which the next stage of the ramp begins.
const STAGE_TOLERANCE: f64 = 1e-2;

/// Solves level by level; returns the finest and the effort on each.
///
/// # Errors
/// When a level does not converge or cannot be built.
pub fn solve_levels(
    problem: &Problem,
    observer: &mut dyn Observer,
) -> Result<(LevelSolution, Vec<LevelStats>), SolveError> {
    let mut previous: Option<LevelSolution> = None;
    let mut stats = Vec::new();
    let n_levels = problem.levels.len();
    for (level, (sizes, order)) in problem.levels.iter().enumerate() {
        let d = Discretisation::new(
            problem.kind,
            &problem.extents,
            sizes,
            *order,
            problem.elastic_order,
            &problem.bodies,
        )?;
        observer.level(level, n_levels, d.n_pressure, d.body_space.dofs.n_dofs);
        let mut effort = NewtonStats::default();
        effort.seconds.mesh = d.seconds.0;
        effort.seconds.operator = d.seconds.1;
        let newton = NewtonLevel::new(&d, problem.load);
        let mut state = match &previous {
            None => cold_start(problem, &d),
            Some(coarse) => interpolate(coarse, &d),
        };
        let ramp: &[f64] = if previous.is_none() {
            &PENALTY_RAMP
        } else {
            &[1.0]
        };
        for share in ramp {
            let model = FilmModel {
                fluid: problem.fluid.clone(),
                constants: FilmConstants {
                    penalty: problem.constants.penalty * share,
                    ..problem.constants
                },
            };
            let last = *share == 1.0;
            let params = NewtonParams {
                update_tolerance: if last {
                    problem.newton.update_tolerance
                } else {
                    STAGE_TOLERANCE
                },
                residual_tolerance: if last {
                    problem.newton.residual_tolerance
                } else {
                    f64::INFINITY
                },
                ..problem.newton
            };
            let label = RunLabel {
                level,
                penalty_share: *share,
                film_scale: problem.film_scale,
            };
            newton.run(&model, &params, &label, &mut state, &mut effort, observer)?;
        }
        stats.push(LevelStats {
            n_body_cells: d.body.mesh.n_cells(),
            n_contact_elements: d.maps.len(),
            n_pressure_dofs: d.n_pressure,
            n_displacement_dofs: d.body_space.dofs.n_dofs,
            n_contact_dofs: d.deflection.n_nodes(),
            pressure_order: *order,
            newton_iterations: effort.iterations,
            krylov_iterations: effort.krylov_iterations,
            factorisations: effort.factorisations,
            film_central: problem.film_scale * central_film(&d, &state),
            film_minimum: problem.film_scale * minimum_film(&d, &state).0,
            seconds: effort.seconds,
        });
        drop(newton);
        previous = Some(LevelSolution {
            discretisation: d,
            state,
        });
    }
    Ok((previous.expect("at least one level"), stats))
}

/// Hertz pressure, and H0 such that the central film is the problem's start film.
fn cold_start(problem: &Problem, d: &Discretisation) -> State {
    let pressure: Vec<f64> = d
        .pressure
        .points
        .iter()
        .map(|p| hertz::pressure_profile(p[0].hypot(p[1])))
        .collect();
    let deflection = d.deflect(&pressure);
    let mut state = State {
        pressure,
        deflection,
        rigid_separation: 0.0,
    };
    state.rigid_separation = problem.start_film - central_film(d, &state);
    state
}

/// Pressures of a coarser level, without new extrema; same central film.
fn interpolate(coarse: &LevelSolution, d: &Discretisation) -> State {
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
            let Some((cell, xi)) = from.locator.find(&from.surface, [p[0], p[1]]) else {
                return 0.0;
            };
            let nodes = from.pressure.nodes_of(cell);
            let values = nodes.iter().map(|n| old.pressure[*n as usize]);
            let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| {
                (l.min(v), h.max(v))
            });
            let value: f64 = from
                .pressure
                .element
                .evaluate(xi)
                .iter()
                .zip(nodes)
                .map(|(b, n)| b.0 * old.pressure[*n as usize])
                .sum();
            value.clamp(low, high)
        })
        .collect();
    let deflection = d.deflect(&pressure);
    let mut state = State {
        pressure,
        deflection,
        rigid_separation: 0.0,
    };
    let target = fields_at(from, old, [0.0, 0.0]).map_or(0.0, |f| f.film);
    state.rigid_separation = target - central_film(d, &state);
    state
}
