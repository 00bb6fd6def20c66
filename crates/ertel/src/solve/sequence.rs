//! Coarse-to-fine sequence of levels.

use std::sync::Arc;

use super::discretisation::{BodyConstants, ContactBody, Discretisation, Extents, LevelSizes};
use super::newton::{FilmModel, NewtonLevel, NewtonParams, NewtonStats, RunLabel};
use super::system::{FilmConstants, State};
use super::{Observer, SolveError};
use crate::contact::{ContactKind, hertz};
use crate::film::FilmFluid;
use crate::params::LinearSolver;
use crate::solution::LevelStats;
use crate::solve::evaluate::{central_film, fields_at, minimum_film};

/// One stage of a solve: a mesh, a pressure order, a formulation.
#[derive(Clone, Copy, Debug)]
pub struct Stage {
    /// Cell sizes; a stage with the sizes of the one before keeps its mesh and elastic operator.
    pub sizes: LevelSizes,
    /// Lagrange order of the pressure.
    pub pressure_order: usize,
    /// Constants of the Reynolds equation, penalty at full strength.
    pub constants: FilmConstants,
}

/// Everything a solve needs, dimensionless.
pub struct Problem {
    /// Line or circular.
    pub kind: ContactKind,
    /// Contact area and body.
    pub extents: Extents,
    /// Stages, coarse to fine.
    pub stages: Vec<Stage>,
    /// Order of the displacement.
    pub elastic_order: usize,
    /// Elastic bodies: the equivalent one, or plane and ball.
    pub bodies: Vec<BodyConstants>,
    /// Fluid.
    pub fluid: FilmFluid,
    /// Target of ∫P over the (half) contact area.
    pub load: f64,
    /// Central film of the start.
    pub start_film: f64,
    /// Film scale a²/R, m.
    pub film_scale: f64,
    /// Newton tolerances and limits.
    pub newton: NewtonParams,
    /// Condensed or monolithic.
    pub linear: LinearSolver,
}

/// A converged stage.
pub struct StageSolution {
    /// The discretisation.
    pub discretisation: Discretisation,
    /// The state on it.
    pub state: State,
}

/// Shares of the full cavitation penalty in the first stage, where the free boundary is still
/// far from its place.
const PENALTY_RAMP: [f64; 3] = [1e-4, 1e-2, 1.0];

/// Update, in p_h, below which the next share of the ramp begins.
const RAMP_TOLERANCE: f64 = 1e-2;

/// Solves stage by stage; returns the last and the effort on each.
///
/// # Errors
/// When a stage does not converge or cannot be built.
pub fn solve_stages(
    problem: &Problem,
    observer: &mut dyn Observer,
) -> Result<(StageSolution, Vec<LevelStats>), SolveError> {
    let mut previous: Option<StageSolution> = None;
    let mut stats = Vec::new();
    for (level, stage) in problem.stages.iter().enumerate() {
        let mut effort = NewtonStats::default();
        let same_mesh = level > 0 && problem.stages[level - 1].sizes == stage.sizes;
        let contact = match &previous {
            Some(coarse) if same_mesh => Arc::clone(&coarse.discretisation.contact),
            _ => {
                let contact = ContactBody::new(
                    problem.kind,
                    &problem.extents,
                    &stage.sizes,
                    problem.elastic_order,
                    &problem.bodies,
                )?;
                (effort.seconds.mesh, effort.seconds.operator) = contact.seconds;
                Arc::new(contact)
            }
        };
        let d = Discretisation::new(&contact, stage.pressure_order);
        let n_displacement = contact.space.dofs.n_dofs;
        observer.level(level, problem.stages.len(), d.n_pressure, n_displacement);
        let newton = NewtonLevel::new(&d, problem.load, problem.linear);
        let mut state = match &previous {
            None => cold_start(problem, &d),
            Some(coarse) => interpolate(coarse, &d),
        };
        let ramp: &[f64] = if level == 0 { &PENALTY_RAMP } else { &[1.0] };
        for share in ramp {
            let model = FilmModel {
                fluid: problem.fluid.clone(),
                constants: FilmConstants {
                    penalty: stage.constants.penalty * share,
                    ..stage.constants
                },
            };
            // A start for the next stage need not be converged.
            let last = *share == 1.0 && (level > 0 || problem.stages.len() == 1);
            let mut params = problem.newton;
            if !last {
                params.update_tolerance = RAMP_TOLERANCE;
                params.residual_tolerance = f64::INFINITY;
            }
            let label = RunLabel {
                level,
                penalty_share: *share,
                film_scale: problem.film_scale,
            };
            newton.run(&model, &params, &label, &mut state, &mut effort, observer)?;
        }
        stats.push(LevelStats {
            n_body_cells: contact.body.mesh.n_cells(),
            n_contact_elements: contact.n_elements(),
            n_pressure_dofs: d.n_pressure,
            n_displacement_dofs: n_displacement,
            n_contact_dofs: contact.deflection.n_nodes(),
            pressure_order: stage.pressure_order,
            newton_iterations: effort.iterations,
            krylov_iterations: effort.krylov_iterations,
            factorisations: effort.factorisations,
            film_central: problem.film_scale * central_film(&d, &state),
            film_minimum: problem.film_scale * minimum_film(&d, &state).0,
            seconds: effort.seconds,
        });
        drop(newton);
        previous = Some(StageSolution {
            discretisation: d,
            state,
        });
    }
    Ok((previous.expect("at least one stage"), stats))
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
fn interpolate(coarse: &StageSolution, d: &Discretisation) -> State {
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
            let Some((cell, xi)) = from
                .contact
                .locator
                .find(&from.contact.surface, [p[0], p[1]])
            else {
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
