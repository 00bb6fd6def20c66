//! Stages of a solve on their meshes, and meshes halved until the films meet their target.
//!
//! ```text
//!   start  →  comparisons  →  solution        on the first mesh
//!          →  every cell halved  →  solution   until the error bars of both films meet the target
//! ```
//! A mesh on which Newton's method does not converge ends the sequence: the solution on the mesh before is the result, with its error bar.

use ertel_fem::platform::Instant;
use std::sync::Arc;

use super::problem::{LEAST_MESHES, MeshEnd};
use super::stage_run::{DIVERGENCE_LIMIT, StageRun};
use super::start::{cold_start, interpolate};
use super::{Problem, Stage, StageSolution};
use crate::engine::{Observer, SolveError, Stopped};
use crate::solution::{Figure, LevelStats, Role};
use crate::solve::contact_surface::ContactSurface;
use crate::solve::discretisation::Discretisation;
use crate::solve::evaluate::{central_film, minimum_film};
use crate::solve::figures::bars;
use crate::solve::newton_level::{NewtonStats, NewtonStatus};
use crate::solve::state::State;
use crate::solve::tuning::stages::{NO_FILM, STAGES_WITHOUT_END};

/// Solves stage by stage from the dry contact; returns the last and the effort on each.
///
/// # Errors
/// When a stage does not converge or cannot be built.
pub fn solve_stages(
    problem: &Problem,
    observer: &mut dyn Observer,
) -> Result<(StageSolution, Vec<LevelStats>), SolveError> {
    let end = Meshes::new(problem, observer).run(None);
    end.map_err(|error| problem.explained(error))
}

/// The same from the solution of a similar problem instead of the first stage.
pub(super) fn solve_from(
    problem: &Problem,
    from: StageSolution,
    observer: &mut dyn Observer,
) -> Result<(StageSolution, Vec<LevelStats>), SolveError> {
    Meshes::new(problem, observer).run(Some(from))
}

/// Solves the stages of a problem, and keeps the records.
struct Meshes<'a> {
    problem: &'a Problem,
    observer: &'a mut dyn Observer,
    /// Effort and figures of each stage so far.
    stats: Vec<LevelStats>,
    /// The last mesh made, and for which stage.
    mesh: Option<(Stage, Arc<ContactSurface>)>,
    /// Stages that have left no film at the end of a roller.
    without_end: usize,
}

/// A stage as it ended, with the reason if it is not solved.
type Ended = (StageSolution, Option<SolveError>);

impl<'a> Meshes<'a> {
    fn new(problem: &'a Problem, observer: &'a mut dyn Observer) -> Meshes<'a> {
        Meshes {
            problem,
            observer,
            stats: Vec::new(),
            mesh: None,
            without_end: 0,
        }
    }

    /// All stages, then finer meshes.
    fn run(
        mut self,
        start: Option<StageSolution>,
    ) -> Result<(StageSolution, Vec<LevelStats>), SolveError> {
        let stages = &self.problem.plan.stages;
        let first = usize::from(start.is_some());
        let mut current = start;
        for (n, stage) in stages.iter().enumerate().skip(first) {
            let contact = self.mesh(stage)?;
            let (end, error) =
                self.solve(stage, contact, current.as_ref(), stages.len() - 1 - n)?;
            match (error, stage.role) {
                (None, _) => current = Some(end),
                (Some(_), Role::Start) if is_usable(&end) => current = Some(end),
                // Optional.
                (Some(_), Role::Estimate | Role::Comparison | Role::Isothermal) => {}
                (Some(error), _) => return Err(error),
            }
        }
        let mut solution = self.halved(current.expect("a plan has stages"))?;
        let (film, _) = minimum_film(&solution.discretisation, &solution.state);
        if film > 0.0 {
            // Large, and of no use to those who have the solution.
            self.mesh = None;
            solution.mesh_end.get_or_insert(MeshEnd::Reached);
            return Ok((solution, self.stats));
        }
        // A root of the discrete equations, but no contact.
        Err(SolveError::NotConverged {
            level: self.stats.len() - 1,
            iterations: self.stats.last().map_or(0, |l| l.newton_iterations),
            residual: solution.reached.residual,
            update: solution.reached.update,
            penalty_share: 1.0,
            reason: Stopped::NegativeFilm,
        })
    }

    /// The solution on finer and finer meshes.
    fn halved(&mut self, mut solution: StageSolution) -> Result<StageSolution, SolveError> {
        loop {
            if let Err(end) = self.may_be_halved(&solution) {
                solution.mesh_end = Some(end);
                return Ok(solution);
            }
            let stage = Stage {
                halvings: solution.stage.halvings + 1,
                ..solution.stage
            };
            let contact = self.halved_mesh(&stage, &solution)?;
            match self.solve(&stage, contact, Some(&solution), 0)? {
                (finer, None) => solution = finer,
                (_, Some(_)) => {
                    solution.mesh_end = Some(MeshEnd::NotConverged);
                    return Ok(solution);
                }
            }
        }
    }

    /// Whether a finer mesh follows.
    ///
    /// # Errors
    /// Why not.
    fn may_be_halved(&self, solution: &StageSolution) -> Result<(), MeshEnd> {
        let target = (self.problem.plan.target.as_ref()).ok_or(MeshEnd::Reached)?;
        let bars = bars(self.problem, &solution.stage, &self.stats);
        let is_met = [Figure::FilmCentral, Figure::FilmMinimum].map(|figure| {
            let film = self.stats.last().and_then(|l| l.figures.value(figure));
            let bar = bars.get(figure).map(|bar| bar.value);
            film.zip(bar)
                .is_some_and(|(film, bar)| bar <= target.error * film)
        });
        let n_meshes = 1 + solution.stage.halvings;
        if is_met == [true; 2] && n_meshes >= LEAST_MESHES {
            return Err(MeshEnd::Reached);
        }
        let growth = 1 << self.problem.shape.dim;
        let is_free = n_meshes < LEAST_MESHES;
        if !is_free && growth * solution.discretisation.n_pressure > target.max_unknowns {
            return Err(MeshEnd::Unknowns(target.max_unknowns));
        }
        Ok(())
    }

    /// Whether the contact of a roller runs over its end, as more than one stage has found.
    ///
    /// # Errors
    /// If it does: the pressure is zero there, and the surfaces touch.
    fn check_ends(&mut self, d: &Discretisation, state: &State) -> Result<(), SolveError> {
        let Some(roller) = &self.problem.shape.zone.roller else {
            return Ok(());
        };
        let (film, [_, y]) = minimum_film(d, state);
        if roller.is_at_edge(y) && film < NO_FILM * central_film(d, state) {
            self.without_end += 1;
        }
        if self.without_end < STAGES_WITHOUT_END {
            return Ok(());
        }
        Err(SolveError::EndCarries {
            place: y.signum() * roller.half_length() * self.problem.scales.length,
            film: film * self.problem.scales.film,
        })
    }

    /// The mesh of a stage with its elastic operator, and the seconds that it took to make it here.
    fn mesh(&mut self, stage: &Stage) -> Result<(Arc<ContactSurface>, [f64; 2]), SolveError> {
        if let Some((_, mesh)) = (self.mesh.as_ref()).filter(|(of, _)| stage.is_on_mesh_of(of)) {
            return Ok((Arc::clone(mesh), [0.0; 2]));
        }
        let problem = self.problem;
        let observer = &*self.observer;
        // Not both at a time.
        self.mesh = None;
        let mesh = ContactSurface::new(
            &problem.shape,
            &problem.extents,
            &stage.sizes,
            &problem.elasticity,
            &|| observer.cancelled(),
        )?;
        Ok(self.keep(stage, mesh))
    }

    /// The mesh of a solution with every cell halved.
    fn halved_mesh(
        &mut self,
        stage: &Stage,
        solution: &StageSolution,
    ) -> Result<(Arc<ContactSurface>, [f64; 2]), SolveError> {
        let observer = &*self.observer;
        self.mesh = None;
        let contact = &solution.discretisation.contact;
        // The state is moved without it.
        contact.response.release();
        let mesh = contact.halved(&|| observer.cancelled())?;
        Ok(self.keep(stage, mesh))
    }

    fn keep(&mut self, stage: &Stage, mesh: ContactSurface) -> (Arc<ContactSurface>, [f64; 2]) {
        let mesh = Arc::new(mesh);
        self.mesh = Some((*stage, Arc::clone(&mesh)));
        let seconds = mesh.seconds.into();
        (mesh, seconds)
    }

    /// Newton's method on a stage.
    ///
    /// # Errors
    /// Where the stage cannot start, or the user wants to stop. Failure of Newton's method is an outcome, not an error.
    fn solve(
        &mut self,
        stage: &Stage,
        (contact, seconds): (Arc<ContactSurface>, [f64; 2]),
        from: Option<&StageSolution>,
        stages_to_come: usize,
    ) -> Result<Ended, SolveError> {
        let clock = Instant::now();
        let problem = self.problem;
        let level = self.stats.len();
        let mut effort = NewtonStats::default();
        [effort.seconds.mesh, effort.seconds.operator] = seconds;
        let d = discretised(problem, stage, &contact);
        let n_levels = level + 1 + stages_to_come;
        (self.observer).level(level, n_levels, d.n_pressure, contact.n_displacement);
        let mut state = match from {
            Some(coarse) => interpolate(coarse, &d),
            None => cold_start(problem, &d),
        };
        let run = StageRun::new(problem, stage, level, &d);
        let outcome = run.solve(&mut state, &mut effort, self.observer);
        if matches!(outcome, Err(SolveError::Interrupted)) {
            return Err(SolveError::Interrupted);
        }
        self.check_ends(&d, &state)?;
        let mut stats = run.stats(outcome.is_ok(), &state, &effort);
        stats.seconds.other =
            clock.elapsed().as_secs_f64() + seconds[0] + seconds[1] - stats.seconds.known();
        self.stats.push(stats);
        let (reached, coupling) = match &outcome {
            Ok(reached) => *reached,
            Err(error) => (NewtonStatus::of_failure(error), None),
        };
        let solution = StageSolution {
            discretisation: d,
            state,
            stage: *stage,
            reached,
            mesh_end: None,
            coupling,
        };
        Ok((solution, outcome.err()))
    }
}

/// Whether an unconverged state is finite, has film everywhere, and is nearer than the dry contact.
fn is_usable(solution: &StageSolution) -> bool {
    let (film, _) = minimum_film(&solution.discretisation, &solution.state);
    film.is_finite()
        && film > 0.0
        && solution.state.pressure.iter().all(|p| p.is_finite())
        && solution.reached.residual <= DIVERGENCE_LIMIT
}

/// Pressure space of a stage on a contact area, with temperatures where it has them.
pub(super) fn discretised(
    problem: &Problem,
    stage: &Stage,
    contact: &Arc<ContactSurface>,
) -> Discretisation {
    let d = Discretisation::new(contact, stage.pressure_order);
    let heat = problem.heat.as_ref().zip(problem.plan.heat.as_ref());
    match heat.filter(|_| stage.heated) {
        Some((heat, plan)) => d.with_heat(
            plan.surface_order,
            plan.column.clone(),
            plan.column.unheated(heat),
        ),
        None => d,
    }
}
