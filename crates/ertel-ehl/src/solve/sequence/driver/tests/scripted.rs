//! A solver whose stages end as scripted, for tests of the driver.

use crate::solve::sequence::driver::*;

/// How a stage ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ending {
    Solved,
    /// Solved, with errors that are too large: of the films, or of the pressure.
    Inaccurate {
        aim: RefinementTarget,
    },
    /// Failed near a contact.
    Stalled,
    /// Failed far from any.
    Diverged,
    Interrupted,
}

use Ending::{Diverged, Interrupted, Solved, Stalled};

/// Films that are not accurate enough.
pub const COARSE: Ending = Ending::Inaccurate {
    aim: RefinementTarget::Films,
};

/// Solution of a stage.
#[derive(Clone, Debug)]
pub struct Point {
    pub stage: Stage,
    pub ending: Ending,
    pub finished: bool,
}

impl Trial for Point {
    fn stage(&self) -> &Stage {
        &self.stage
    }
    fn converged(&self) -> bool {
        matches!(self.ending, Solved | Ending::Inaccurate { .. })
    }
    fn is_usable(&self) -> bool {
        self.ending != Diverged
    }
}

/// Each stage, and the one whose end it starts from.
pub type Trace = Vec<(Stage, Option<Stage>)>;

/// Ends each stage by a rule.
pub struct Scripted<'a, F> {
    pub rule: F,
    pub trace: &'a mut Trace,
}

impl<F: FnMut(usize, &Stage) -> Ending> StageSolver for Scripted<'_, F> {
    type Solution = Point;

    fn solve(
        &mut self,
        task: Task<Point>,
        _: &mut dyn Observer,
    ) -> Result<StageEnd<Point>, SolveError> {
        let (stage, number) = (*task.stage, self.trace.len());
        assert_eq!(task.halvings.is_empty(), stage.refinements == 0);
        let ending = (self.rule)(number, &stage);
        self.trace.push((stage, task.from.map(|point| point.stage)));
        Ok(StageEnd {
            outcome: match ending {
                Solved => Ok(None),
                Ending::Inaccurate { aim } => Ok(Some(Refinement {
                    halvings: vec![1],
                    aim,
                    film_bar: 0.005,
                })),
                Stalled | Diverged => Err(failure(number)),
                Interrupted => Err(SolveError::Interrupted),
            },
            solution: Point {
                stage,
                ending,
                finished: false,
            },
        })
    }

    fn finish(&mut self, solution: &mut Point, _: &mut dyn Observer) -> Result<(), SolveError> {
        solution.finished = true;
        Ok(())
    }
}

fn failure(level: usize) -> SolveError {
    SolveError::NotConverged {
        level,
        iterations: 1,
        residual: 1.0,
        update: 1.0,
        penalty_share: 1.0,
        reason: crate::engine::Stopped::Circling,
    }
}

/// Stage that an error is of.
pub fn level_of(error: &SolveError) -> usize {
    match error {
        SolveError::NotConverged { level, .. } => *level,
        SolveError::AllFailed { first, .. } => level_of(first),
        other => panic!("{other}"),
    }
}

pub fn run(
    outline: Outline,
    rule: impl FnMut(usize, &Stage) -> Ending,
) -> (Result<Point, SolveError>, Trace) {
    let mut trace = Vec::new();
    let solver = Scripted {
        rule,
        trace: &mut trace,
    };
    let observer = &mut crate::engine::NoObserver;
    let end = Driver::new(outline, solver, observer).run();
    (end.map(|(point, _)| point), trace)
}
