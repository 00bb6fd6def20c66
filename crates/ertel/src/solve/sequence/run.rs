//! Which stage comes next, until the last has converged.

use std::collections::VecDeque;
use std::sync::Arc;
use std::time::Instant;

use super::rescue::{diffusion_path, halfway, of_lower_order, rescues};
use super::stage::{Finish, StageRun};
use super::start::{cold_start, interpolate};
use super::{Problem, Role, Stage, StageSolution};
use crate::solution::LevelStats;
use crate::solve::adapt::{grading_errors, next_refinement};
use crate::solve::discretisation::{ContactBody, Discretisation, Means};
use crate::solve::evaluate::minimum_film;
use crate::solve::newton::{NewtonStats, Reached};
use crate::solve::{Observer, SolveError};

/// Solves stage by stage; returns the last and the effort on each.
///
/// # Errors
/// When a stage does not converge or cannot be built.
pub fn solve_stages(
    problem: &Problem,
    observer: &mut dyn Observer,
) -> Result<(StageSolution, Vec<LevelStats>), SolveError> {
    Sequence::new(problem).solve(observer)
}

/// Steps that may be halved on one way to a contact.
const MAX_DETOURS: usize = 6;

/// Where a solve stands.
pub(super) struct Sequence<'a> {
    problem: &'a Problem,
    /// Stages to come.
    queue: VecDeque<Stage>,
    /// What to try if these fail.
    rescues: std::vec::IntoIter<Vec<Stage>>,
    /// Why the first way failed: the error to report when all do.
    first_failure: Option<SolveError>,
    stats: Vec<LevelStats>,
    /// Where the next stage starts.
    previous: Option<StageSolution>,
    /// The last solution of a final stage, while a refined mesh is being tried.
    solved: Option<StageSolution>,
    /// The last mesh made, and for which stage.
    mesh: Option<(Stage, Arc<ContactBody>)>,
    /// Halvings of each element that make the next mesh.
    halvings: Vec<u32>,
    /// Steps halved on the present way.
    detours: usize,
    /// Refinements of the mesh that has been tried once more.
    restarted: usize,
    /// Whether the case's own pressures have been tried from those of lower order.
    raised: bool,
    /// Refinements of the mesh that it starts on, if it starts from the solution of another problem.
    inherited: Option<usize>,
}

/// How a stage ended.
struct StageEnd {
    outcome: Result<(), SolveError>,
    solution: StageSolution,
    /// How to refine its mesh, if errors are too large.
    refinement: Option<Vec<u32>>,
}

impl<'a> Sequence<'a> {
    fn new(problem: &'a Problem) -> Sequence<'a> {
        Sequence {
            problem,
            queue: problem.stages.iter().copied().collect(),
            rescues: rescues(problem, true).into_iter(),
            first_failure: None,
            stats: Vec::new(),
            previous: None,
            solved: None,
            mesh: None,
            halvings: Vec::new(),
            detours: 0,
            restarted: 0,
            raised: false,
            inherited: None,
        }
    }

    /// One stage that starts from a solution on its mesh, and refinements after it.
    pub fn from(problem: &'a Problem, previous: StageSolution, stage: Stage) -> Sequence<'a> {
        Sequence {
            queue: VecDeque::from([stage]),
            rescues: Vec::new().into_iter(),
            previous: Some(previous),
            inherited: Some(stage.refinements),
            ..Sequence::new(problem)
        }
    }

    /// Runs the stages to the end.
    pub fn solve(
        mut self,
        observer: &mut dyn Observer,
    ) -> Result<(StageSolution, Vec<LevelStats>), SolveError> {
        while let Some(stage) = self.queue.pop_front() {
            if observer.cancelled() {
                return Err(SolveError::Interrupted);
            }
            let mut end = self.run(&stage, observer)?;
            if self.inherited.is_some() && self.stats.len() == 1 {
                // What it started from solves another problem: there is nothing to go back to.
                std::mem::replace(&mut end.outcome, Ok(()))?;
            }
            self.proceed(&stage, end, observer)?;
        }
        let solution = self.previous.filter(|s| s.stage.role == Role::Final);
        let Some(solution) = solution.filter(|s| s.converged) else {
            return Err(self.first_failure.unwrap_or(SolveError::Interrupted));
        };
        let stats = self.stats;
        let (film, _) = minimum_film(&solution.discretisation, &solution.state);
        if film <= 0.0 {
            // A root of the discrete equations, but no contact.
            return Err(SolveError::NotConverged {
                level: stats.len() - 1,
                iterations: stats.last().map_or(0, |l| l.newton_iterations),
                residual: solution.reached.residual,
                update: solution.reached.update,
                penalty_share: 1.0,
                reason: "the mesh is too coarse for the film, which comes out negative at a point",
            });
        }
        Ok((solution, stats))
    }

    /// The mesh of a stage with its elastic operator, and whether it had to be made.
    fn mesh(
        &mut self,
        stage: &Stage,
        observer: &dyn Observer,
    ) -> Result<(Arc<ContactBody>, bool), SolveError> {
        let previous = self.previous.as_ref();
        let known = previous
            .map(|p| (&p.stage, &p.discretisation.contact))
            .into_iter()
            .chain(self.mesh.iter().map(|(of, mesh)| (of, mesh)))
            .find(|(of, _)| stage.is_on_mesh_of(of));
        if let Some((_, mesh)) = known {
            return Ok((Arc::clone(mesh), false));
        }
        let problem = self.problem;
        let refined = previous.filter(|p| {
            p.stage.sizes == stage.sizes && p.stage.refinements + 1 == stage.refinements
        });
        let stop = || observer.cancelled();
        let means = Means {
            cache: problem.cache.as_ref(),
            stop: &stop,
        };
        // Not both at a time
        self.mesh = None;
        let mesh = Arc::new(match refined {
            Some(p) => {
                (p.discretisation.contact).refined(&self.halvings, &problem.bodies, means)?
            }
            None => ContactBody::with_cache(
                problem.kind,
                &problem.extents,
                &stage.sizes,
                problem.elastic_order,
                &problem.bodies,
                means,
            )?,
        });
        self.mesh = Some((*stage, Arc::clone(&mesh)));
        Ok((mesh, true))
    }

    /// Solves a stage and measures it.
    fn run(&mut self, stage: &Stage, observer: &mut dyn Observer) -> Result<StageEnd, SolveError> {
        let clock = Instant::now();
        let problem = self.problem;
        let level = self.stats.len();
        let (contact, fresh) = self.mesh(stage, observer)?;
        let mut effort = NewtonStats::default();
        if fresh {
            (effort.seconds.mesh, effort.seconds.operator) = contact.seconds;
        }
        let mut d = Discretisation::new(&contact, stage.pressure_order);
        if let Some(heat) = problem.heat.as_ref().filter(|_| stage.heated) {
            d = d.with_heat(
                heat.surface_order,
                heat.column.clone(),
                heat.column.unheated(&heat.heat),
            );
        }
        observer.level(
            level,
            level + 1 + self.queue.len(),
            d.n_pressure,
            contact.n_displacement,
        );
        let mut state = match &self.previous {
            Some(coarse) if !stage.cold => interpolate(coarse, &d),
            _ => cold_start(problem, &d),
        };
        let run = StageRun::new(problem, stage, level, &d);
        // What is measured only, or refined further, need not be exact.
        let last = stage.role == Role::Final;
        let measured = matches!(stage.role, Role::Estimate | Role::Final);
        let rough = matches!(
            stage.role,
            Role::Estimate | Role::Comparison | Role::Isothermal
        ) || last && problem.adapt.is_some() && stage.refinements == 0;
        let finish = if rough { Finish::Rough } else { Finish::Exact };
        let mut outcome = run.solve(finish, &mut state, &mut effort, observer);
        let wanted = problem.error_estimate && measured && outcome.is_ok();
        if wanted && observer.cancelled() {
            return Err(SolveError::Interrupted);
        }
        let indicator = if wanted {
            run.measure(&state, &mut effort)
        } else {
            None
        };
        let figures = run.figures(outcome.is_ok(), &state, &effort, indicator.as_ref(), clock);
        self.stats.push(figures);
        let refinement = match (&problem.adapt, &indicator) {
            (Some(adapt), Some(indicator)) if last => next_refinement(
                adapt,
                problem.kind.body_dimension() - 1,
                &self.stats,
                grading_errors(problem.kind, &stage.sizes),
                stage.refinements - self.inherited.unwrap_or(0),
                indicator,
            ),
            _ => None,
        };
        if rough && last && outcome.is_ok() && refinement.is_none() {
            // Measured, and already accurate enough: the solution itself, to the end.
            let rough = outcome.ok().and_then(|(_, coupling)| coupling);
            outcome = run
                .solve(Finish::Exact, &mut state, &mut effort, observer)
                .map(|(reached, coupling)| (reached, coupling.map(|c| c.after(rough))));
            let figures = run.figures(outcome.is_ok(), &state, &effort, indicator.as_ref(), clock);
            self.stats[level] = figures;
        }
        let (outcome, (reached, coupling)) = match outcome {
            Ok(reached) => (Ok(()), reached),
            Err(e) => {
                let reached = Reached::of_failure(&e);
                (Err(e), (reached, None))
            }
        };
        let solution = StageSolution {
            discretisation: d,
            state,
            stage: *stage,
            reached,
            converged: outcome.is_ok(),
            rough: false,
            coupling,
        };
        Ok(StageEnd {
            outcome,
            solution,
            refinement,
        })
    }

    /// Draws the conclusions of a stage: what the next one starts from, and which comes next.
    fn proceed(
        &mut self,
        stage: &Stage,
        end: StageEnd,
        observer: &mut dyn Observer,
    ) -> Result<(), SolveError> {
        let StageEnd {
            outcome,
            solution,
            refinement,
        } = end;
        let leads = stage.role.leads();
        match outcome {
            Err(SolveError::Interrupted) => return Err(SolveError::Interrupted),
            _ if stage.refinements > 0 && leads => {
                // Good enough, or the way ends here.
                if outcome.is_ok() || solution.is_usable() {
                    let before = self.previous.replace(solution);
                    self.solved = self.solved.take().or(before);
                } else {
                    return self.stop_refining(observer);
                }
            }
            Ok(()) => {
                self.previous = Some(solution);
                self.solved = None;
                if let Some(halvings) = refinement {
                    self.halvings = halvings;
                    self.queue.push_back(Stage {
                        refinements: stage.refinements + 1,
                        near: false,
                        ..*stage
                    });
                } else if let Some(own) = self.own_order(stage) {
                    self.raised = true;
                    self.queue.push_back(own);
                }
            }
            // Those of lower order stand.
            Err(_) if self.raised => return self.stop_refining(observer),
            // The refined mesh once more, from a diffusive start; failing that, the mesh before has a
            // solution, with an error bar that says what it is worth.
            Err(_) if stage.refinements > 0 => {
                if self.restarted == stage.refinements {
                    return self.stop_refining(observer);
                }
                self.restarted = stage.refinements;
                let restart = Stage {
                    sizes: stage.sizes,
                    refinements: stage.refinements,
                    newtonian: stage.newtonian,
                    cold: false,
                    ..self.problem.stages[0]
                };
                self.queue.push_back(restart);
                self.queue.extend(diffusion_path(&restart, stage));
                self.queue.push_back(*stage);
            }
            // The first start: no time is lost on what follows from a bad one.
            Err(e) if leads && self.stats.len() == 1 => {
                self.first_failure = Some(e);
                self.rescues = rescues(self.problem, false).into_iter();
                self.queue = self.rescues.next().into_iter().flatten().collect();
                self.previous = Some(solution);
            }
            // A step of a way was too long.
            Err(_) if let Some(halfway) = self.halfway(stage) => {
                self.detours += 1;
                self.queue.push_front(*stage);
                self.queue.push_front(halfway);
            }
            Err(_) if leads && solution.is_usable() => self.previous = Some(solution),
            Err(_) if stage.role == Role::Estimate || stage.role.compares() => {}
            Err(e) => {
                let lower = self.lower(stage);
                let failure = self.first_failure.get_or_insert(e);
                self.detours = 0;
                match lower
                    .map(|stage| vec![stage])
                    .or_else(|| self.rescues.next())
                {
                    Some(stages) => self.queue = stages.into(),
                    None => return Err(std::mem::replace(failure, SolveError::Interrupted)),
                }
            }
        }
        Ok(())
    }

    /// A failed final stage with pressures of lower order, where a way has led to it.
    fn lower(&self, stage: &Stage) -> Option<Stage> {
        let from = self.previous.as_ref()?;
        let led = self.first_failure.is_some()
            && from.converged
            && from.stage.role != Role::Start
            && from.stage.thickening == stage.thickening
            && from.stage.is_on_mesh_of(stage);
        of_lower_order(stage).filter(|_| led)
    }

    /// The case's own pressures, on the finest mesh that those of lower order have come to.
    fn own_order(&self, stage: &Stage) -> Option<Stage> {
        let order = self.problem.stages.last()?.pressure_order;
        let raise = stage.role == Role::Final
            && stage.pressure_order < order
            && !self.raised
            && self.inherited.is_none();
        raise.then_some(Stage {
            pressure_order: order,
            ..*stage
        })
    }

    /// Half of the step to a stage.
    fn halfway(&self, stage: &Stage) -> Option<Stage> {
        let from = self
            .previous
            .as_ref()
            .filter(|_| self.detours < MAX_DETOURS)?;
        halfway(&from.stage, stage)
    }

    /// Gives the refined mesh of a stage up: the solution on the mesh before stands.
    fn stop_refining(&mut self, observer: &mut dyn Observer) -> Result<(), SolveError> {
        self.queue.clear();
        if let Some(solved) = self.solved.take() {
            self.previous = Some(solved);
        }
        if let Some(p) = (self.previous.as_mut()).filter(|p| p.stage.refinements == 0) {
            // Only measured so far.
            let level = self.stats.len() - 1;
            let run = StageRun::new(self.problem, &p.stage, level, &p.discretisation);
            let mut effort = NewtonStats::default();
            let (rough, mut state) = (p.coupling, p.state.clone());
            match run.solve(Finish::Exact, &mut state, &mut effort, observer) {
                Ok((reached, coupling)) => {
                    p.state = state;
                    (p.reached, p.coupling) = (reached, coupling.map(|c| c.after(rough)));
                }
                Err(SolveError::Interrupted) => return Err(SolveError::Interrupted),
                // What was measured stands.
                Err(_) => p.rough = true,
            }
        }
        Ok(())
    }
}
