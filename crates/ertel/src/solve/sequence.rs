//! Coarse-to-fine sequence of levels.

use std::collections::VecDeque;
use std::sync::Arc;
use std::time::Instant;

use super::adapt::{AdaptParams, grading_errors, next_refinement};
use super::cache::OperatorCache;
use super::discretisation::{BodyConstants, ContactBody, Discretisation, Extents, LevelSizes};
use super::indicator::{Indicator, indicator};
use super::newton::{FilmModel, NewtonLevel, NewtonParams, NewtonStats, RunLabel};
use super::system::{FilmConstants, State};
use super::{Observer, SolveError};
use crate::contact::{ContactKind, hertz};
use crate::film::FilmFluid;
use crate::params::LinearSolver;
use crate::solution::LevelStats;
use crate::solve::evaluate::{central_film, largest_pressure, minimum_film};

/// One stage of a solve: a mesh, a pressure order, a formulation.
#[derive(Clone, Copy, Debug)]
pub struct Stage {
    /// Cell sizes; a stage with the sizes of the one before keeps its mesh and elastic operator.
    pub sizes: LevelSizes,
    /// Times that the mesh of these sizes has been refined locally.
    pub refinements: usize,
    /// Lagrange order of the pressure.
    pub pressure_order: usize,
    /// Constants of the Reynolds equation, penalty at full strength.
    pub constants: FilmConstants,
    /// Share of the fluid's thickening under pressure.
    pub thickening: f64,
    /// Whether it starts from the Hertz pressure, whatever was reached before.
    pub cold: bool,
    /// What it is for.
    pub role: Role,
}

/// What a stage is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Only starts the next one: loose tolerance, penalty ramp, and what it reaches is good
    /// enough even when it does not converge.
    Start,
    /// Its figures bound the discretisation error; skipped when it does not converge.
    Estimate,
    /// The solution.
    Final,
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
    /// Pressure scale p_h, Pa.
    pub pressure_scale: f64,
    /// Newton tolerances and limits.
    pub newton: NewtonParams,
    /// Condensed or monolithic.
    pub linear: LinearSolver,
    /// Where elastic operators are kept, if anywhere.
    pub cache: Option<OperatorCache>,
    /// Whether errors are estimated.
    pub error_estimate: bool,
    /// Local refinement of the final stage, if an accuracy is asked for.
    pub adapt: Option<AdaptParams>,
}

/// A converged stage.
pub struct StageSolution {
    /// The discretisation.
    pub discretisation: Discretisation,
    /// The state on it.
    pub state: State,
    /// Cell sizes of its mesh.
    pub sizes: LevelSizes,
    /// Times that this mesh has been refined locally.
    pub refinements: usize,
    /// Constants of the Reynolds equation it solves.
    pub constants: FilmConstants,
}

impl StageSolution {
    /// Whether an unconverged state is still near a contact: finite, with film everywhere.
    fn is_usable(&self) -> bool {
        let (film, _) = minimum_film(&self.discretisation, &self.state);
        film.is_finite() && film > 0.0 && self.state.pressure.iter().all(|p| p.is_finite())
    }
}

/// Shares of the full cavitation penalty in the first stage, where the free boundary is still
/// far from its place.
const PENALTY_RAMP: [f64; 3] = [1e-4, 1e-2, 1.0];

/// Update, in p_h, at which a start is good enough.
const START_TOLERANCE: f64 = 1e-2;

/// Update, in p_h, and residual at which a solution is good enough to be measured and refined: error
/// bars are a hundred times as large.
const ROUGH_TOLERANCE: f64 = 1e-5;

/// Newton iterations that a start may take for each share of the ramp.
const START_ITERATIONS: usize = 30;

/// Iterations without a smaller update that a start may take.
const START_PATIENCE: usize = 12;

/// Solves stage by stage; returns the last and the effort on each.
///
/// # Errors
/// When a stage does not converge or cannot be built.
pub fn solve_stages(
    problem: &Problem,
    observer: &mut dyn Observer,
) -> Result<(StageSolution, Vec<LevelStats>), SolveError> {
    let mut previous: Option<StageSolution> = None;
    // The last solution of a final stage, while a finer one is being tried.
    let mut solved: Option<StageSolution> = None;
    let mut stats: Vec<LevelStats> = Vec::new();
    let mut queue: VecDeque<Stage> = problem.stages.iter().copied().collect();
    let mut rescues = rescues(problem).into_iter();
    let mut first_failure = None;
    let mut halvings: Vec<u32> = Vec::new();
    let mut restarted = 0;
    while let Some(stage) = queue.pop_front() {
        if observer.cancelled() {
            return Err(SolveError::Interrupted);
        }
        let clock = Instant::now();
        let level = stats.len();
        let same_sizes = |p: &&StageSolution| p.sizes == stage.sizes;
        let same_mesh = |p: &&StageSolution| same_sizes(p) && p.refinements == stage.refinements;
        let fresh = previous.as_ref().filter(same_mesh).is_none();
        let contact = match &previous {
            Some(p) if !fresh => Arc::clone(&p.discretisation.contact),
            Some(p) if same_sizes(&p) && p.refinements + 1 == stage.refinements => Arc::new(
                p.discretisation
                    .contact
                    .refined(&halvings, &problem.bodies)?,
            ),
            _ => Arc::new(ContactBody::with_cache(
                problem.kind,
                &problem.extents,
                &stage.sizes,
                problem.elastic_order,
                &problem.bodies,
                problem.cache.as_ref(),
            )?),
        };
        let d = Discretisation::new(&contact, stage.pressure_order);
        let n_displacement = contact.n_displacement;
        observer.level(level, level + 1 + queue.len(), d.n_pressure, n_displacement);
        let mut state = match &previous {
            Some(coarse) if !stage.cold => interpolate(coarse, &d),
            _ => cold_start(problem, &d),
        };
        let mut effort = NewtonStats::default();
        if fresh {
            (effort.seconds.mesh, effort.seconds.operator) = contact.seconds;
        }
        let newton = NewtonLevel::new(&d, problem.load, problem.linear);
        // What is measured only, or refined further, need not be exact.
        let rough = stage.role == Role::Estimate
            || stage.role == Role::Final && problem.adapt.is_some() && stage.refinements == 0;
        let tolerance = if rough { ROUGH_TOLERANCE } else { 0.0 };
        let mut run = |tolerance: f64, state: &mut State, effort: &mut NewtonStats| {
            run_stage(
                problem, &newton, &stage, level, tolerance, state, effort, observer,
            )
        };
        let mut outcome = run(tolerance, &mut state, &mut effort);
        let estimating = Instant::now();
        let wanted = problem.error_estimate && stage.role != Role::Start && outcome.is_ok();
        let indicator = if wanted {
            let model = FilmModel {
                fluid: problem.fluid.clone(),
                constants: stage.constants,
            };
            indicator(&d, &model, &state, newton.near()).ok()
        } else {
            None
        };
        effort.seconds.estimate += estimating.elapsed().as_secs_f64();
        let figures = |outcome: &Result<(), SolveError>, state: &State, effort: &NewtonStats| {
            let mut figures = LevelStats {
                converged: outcome.is_ok(),
                n_body_cells: contact.body.mesh.n_cells(),
                n_contact_elements: contact.n_elements(),
                n_pressure_dofs: d.n_pressure,
                n_displacement_dofs: n_displacement,
                n_contact_dofs: contact.deflection.n_nodes(),
                operator_cached: contact.from_cache,
                pressure_order: stage.pressure_order,
                newton_iterations: effort.iterations,
                krylov_iterations: effort.krylov_iterations,
                factorisations: effort.factorisations,
                film_central: problem.film_scale * central_film(&d, state),
                film_minimum: problem.film_scale * minimum_film(&d, state).0,
                pressure_maximum: problem.pressure_scale * largest_pressure(&d, state).0,
                estimate: indicator.as_ref().map(Indicator::totals),
                seconds: effort.seconds,
            };
            figures.seconds.other = clock.elapsed().as_secs_f64() - figures.seconds.known();
            figures
        };
        stats.push(figures(&outcome, &state, &effort));
        let next = match (&problem.adapt, &indicator, stage.role, &outcome) {
            (Some(adapt), Some(indicator), Role::Final, Ok(())) => next_refinement(
                adapt,
                problem.kind.body_dimension() - 1,
                &stats,
                grading_errors(problem.kind, &stage.sizes),
                stage.refinements,
                indicator,
            ),
            _ => None,
        };
        if rough && stage.role == Role::Final && outcome.is_ok() && next.is_none() {
            // Measured, and already accurate enough: the solution itself, to the end.
            outcome = run(0.0, &mut state, &mut effort);
            stats.pop();
            stats.push(figures(&outcome, &state, &effort));
        }
        let solution = StageSolution {
            discretisation: d,
            state,
            sizes: stage.sizes,
            refinements: stage.refinements,
            constants: stage.constants,
        };
        match outcome {
            Err(SolveError::Interrupted) => return Err(SolveError::Interrupted),
            Ok(()) if stage.role == Role::Start && stage.refinements > 0 => {
                solved = solved.or(previous.replace(solution));
            }
            Ok(()) => {
                (previous, solved) = (Some(solution), None);
                if let Some(next) = next {
                    halvings = next;
                    queue.push_back(Stage {
                        refinements: stage.refinements + 1,
                        ..stage
                    });
                }
            }
            // The refined mesh once more, from a diffusive start; failing that, the mesh before has a
            // solution, with an error bar that says what it is worth.
            Err(_) if stage.refinements > 0 => {
                let usable = stage.role == Role::Start && solution.is_usable();
                if usable {
                    solved = solved.or(previous.replace(solution));
                } else if restarted < stage.refinements && stage.role == Role::Final {
                    restarted = stage.refinements;
                    queue.extend([
                        Stage {
                            sizes: stage.sizes,
                            refinements: stage.refinements,
                            cold: false,
                            ..problem.stages[0]
                        },
                        stage,
                    ]);
                } else {
                    previous = solved.take().or(previous);
                    if let Some(p) = previous.as_mut().filter(|p| p.refinements == 0) {
                        // Only measured so far.
                        let newton =
                            NewtonLevel::new(&p.discretisation, problem.load, problem.linear);
                        let unrefined = Stage {
                            refinements: 0,
                            ..stage
                        };
                        let (state, mut effort) = (&mut p.state, NewtonStats::default());
                        run_stage(
                            problem,
                            &newton,
                            &unrefined,
                            level,
                            0.0,
                            state,
                            &mut effort,
                            observer,
                        )?;
                    }
                    break;
                }
            }
            // The first start: no time is lost on what follows from a bad one.
            Err(e) if stage.role == Role::Start && level == 0 => {
                first_failure = Some(e);
                queue = rescues.next().into_iter().flatten().collect();
                previous = Some(solution);
            }
            Err(_) if stage.role == Role::Start && solution.is_usable() => {
                previous = Some(solution);
            }
            Err(_) if stage.role == Role::Estimate => {}
            Err(e) => {
                let failure = first_failure.get_or_insert(e);
                match rescues.next() {
                    Some(stages) => queue = stages.into(),
                    None => return Err(std::mem::replace(failure, SolveError::Interrupted)),
                }
            }
        }
    }
    let solution = previous.expect("the final stage converged");
    let (film, _) = minimum_film(&solution.discretisation, &solution.state);
    if film <= 0.0 {
        // A root of the discrete equations, but no contact.
        return Err(SolveError::NotConverged {
            level: stats.len() - 1,
            iterations: stats.last().map_or(0, |l| l.newton_iterations),
            residual: 0.0,
            update: 0.0,
            penalty_share: 1.0,
            reason: "the mesh is too coarse for the film, which comes out negative at a point",
        });
    }
    Ok((solution, stats))
}

/// Shares of the fluid's thickening through which a contact is led that does not start otherwise.
const THICKENING: [f64; 5] = [0.4, 0.6, 0.75, 0.88, 1.0];

/// What is tried, in turn, when the start or the final stage does not converge: a start with a fluid that
/// thickens less, made thicker step by step; then the start on the fine mesh, which may carry what the
/// coarse one could not; then pressures of lower order, which overshoot
/// less at a spike that the mesh does not resolve.
fn rescues(problem: &Problem) -> Vec<Vec<Stage>> {
    let (Some(start), Some(last)) = (problem.stages.first(), problem.stages.last()) else {
        return Vec::new();
    };
    // A mesh that only starts refinements may be too coarse for the film.
    let finer = match problem.adapt {
        Some(_) => last.sizes.scaled(0.5),
        None => last.sizes,
    };
    let mut continuation: Vec<Stage> = THICKENING
        .iter()
        .enumerate()
        .map(|(i, thickening)| Stage {
            thickening: *thickening,
            cold: i == 0,
            ..*start
        })
        .collect();
    continuation.extend(&problem.stages[1..]);
    let restart = vec![
        Stage {
            sizes: finer,
            ..*start
        },
        Stage {
            sizes: finer,
            ..*last
        },
    ];
    let mut rescues = vec![continuation, restart];
    rescues.extend((1..last.pressure_order).rev().map(|pressure_order| {
        let lower = |stage: &Stage| Stage {
            pressure_order,
            ..*stage
        };
        problem.stages.iter().map(lower).collect()
    }));
    rescues
}

/// Newton's method on one stage, through the penalty ramp if it is a start.
#[allow(clippy::too_many_arguments)]
fn run_stage(
    problem: &Problem,
    newton: &NewtonLevel,
    stage: &Stage,
    level: usize,
    tolerance: f64,
    state: &mut State,
    effort: &mut NewtonStats,
    observer: &mut dyn Observer,
) -> Result<(), SolveError> {
    let start = stage.role == Role::Start;
    let mut outcome = Ok(());
    for share in if start { &PENALTY_RAMP[..] } else { &[1.0] } {
        let model = FilmModel {
            fluid: problem.fluid.with_thickening(stage.thickening),
            constants: FilmConstants {
                penalty: stage.constants.penalty * share,
                ..stage.constants
            },
        };
        let mut params = problem.newton;
        params.update_tolerance = params.update_tolerance.max(tolerance);
        params.residual_tolerance = params.residual_tolerance.max(tolerance);
        if start {
            params.update_tolerance = START_TOLERANCE;
            params.residual_tolerance = f64::INFINITY;
            params.max_iterations = START_ITERATIONS;
            params.patience = START_PATIENCE;
        }
        let label = RunLabel {
            level,
            penalty_share: *share,
            film_scale: problem.film_scale,
        };
        outcome = newton.run(&model, &params, &label, state, effort, observer);
        let stalled = matches!(outcome, Err(SolveError::NotConverged { .. }));
        if outcome.is_err() && !(start && stalled) {
            return outcome;
        }
    }
    outcome
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
    state.rigid_separation = central_film(from, old) - central_film(d, &state);
    // Deflections of two meshes differ by more than the thinnest film has to give.
    let (thinnest, _) = minimum_film(d, &state);
    let floor = 0.5 * minimum_film(from, old).0;
    state.rigid_separation += (floor - thinnest).max(0.0);
    state
}
