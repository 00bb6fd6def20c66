//! What follows from the end of a stage: which comes next, and where it starts.

use super::paths::{diffusion_path, halfway};
use super::rescue::{of_lower_order, rescues};
use super::run::{Sequence, StageEnd};
use super::stage::{Finish, StageRun};
use super::{Role, Stage};
use crate::solve::newton::NewtonStats;
use crate::solve::{Observer, SolveError};

/// Steps that may be halved on one way to a contact.
const MAX_DETOURS: usize = 6;

/// The same for fluids whose shear rate grows exponentially with the stress, whose steps are small and cheap.
const MAX_EXPONENTIAL_DETOURS: usize = 12;

impl Sequence<'_> {
    /// Draws the conclusions of a stage: what the next one starts from, and which comes next.
    pub(super) fn proceed(
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
            // Those of lower order stand.
            Ok(()) if self.raises(stage) && !solution.has_film() => {}
            Err(_) if self.raises(stage) => {}
            Ok(()) => {
                self.previous = Some(solution);
                self.solved = None;
                if let Some(refinement) = refinement {
                    self.halvings = refinement.halvings;
                    self.for_pressure_alone = refinement.for_pressure_alone;
                    self.queue.push_back(Stage {
                        refinements: stage.refinements + 1,
                        near: false,
                        impatient: false,
                        ..*stage
                    });
                } else {
                    self.raise(stage);
                }
            }
            // The refined mesh once more, from a diffusive start; failing that, the mesh before has a
            // solution, with an error bar that says what it is worth.
            Err(_) if stage.refinements > 0 => {
                // Films that are as accurate as asked for need no second try.
                if self.restarted == stage.refinements || self.for_pressure_alone {
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
        let led = stage.role == Role::Final
            && self.first_failure.is_some()
            && from.converged
            && from.stage.role != Role::Start
            && from.stage.thickening == stage.thickening
            && from.stage.softness == stage.softness
            && from.stage.sliding == stage.sliding
            && from.stage.is_on_mesh_of(stage);
        of_lower_order(stage).filter(|_| led)
    }

    /// The case's own pressures next, on the finest mesh that those of lower order have come to; once.
    fn raise(&mut self, stage: &Stage) {
        let order = self.problem.stages.last().map(|last| last.pressure_order);
        let own = order.filter(|own| *own > stage.pressure_order && !self.raised);
        if let Some(pressure_order) = own
            && stage.role == Role::Final
            && self.inherited.is_none()
        {
            self.raised = true;
            self.queue.push_back(Stage {
                pressure_order,
                // Those of lower order stand, and an exponential seldom bears the overshoots of others.
                impatient: self.problem.fluid.is_exponential(),
                ..*stage
            });
        }
    }

    /// Whether a stage has the case's own pressures where a solution with those of lower order stands on its mesh.
    fn raises(&self, stage: &Stage) -> bool {
        let from = self.previous.as_ref().map(|p| &p.stage);
        let below = |from: &Stage| {
            from.role == Role::Final
                && from.pressure_order < stage.pressure_order
                && from.is_on_mesh_of(stage)
        };
        self.raised && from.is_some_and(below)
    }

    /// Half of the step to a stage.
    fn halfway(&self, stage: &Stage) -> Option<Stage> {
        let most = match self.problem.fluid.is_exponential() {
            true => MAX_EXPONENTIAL_DETOURS,
            false => MAX_DETOURS,
        };
        let from = self.previous.as_ref().filter(|_| self.detours < most)?;
        halfway(&from.stage, stage)
    }

    /// Gives the refined mesh of a stage up: the solution on the mesh before stands.
    fn stop_refining(&mut self, observer: &mut dyn Observer) -> Result<(), SolveError> {
        self.queue.clear();
        if let Some(solved) = self.solved.take() {
            self.previous = Some(solved);
        }
        // Only measured so far.
        if let Some(p) = (self.previous.as_mut()).filter(|p| p.stage.role == Role::Final) {
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
        if let Some(stage) = self.previous.as_ref().map(|p| p.stage) {
            self.raise(&stage);
        }
        Ok(())
    }
}
