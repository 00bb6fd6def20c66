//! Running a study.

use super::check::{Reference, Row, Verdict};
use super::outcome::{Outcome, Run, Selection, Task};
use super::{Accept, Quantity, Study, deflect};
use ertel::engine::{Observer, SolveError};
use ertel::run::solve;
use ertel::run::transient::{self, InstantObserver};
use ertel::study::{CurveObserver, solve_curve};
use ertel::transient::TransientError;

/// Results of a study.
#[derive(Debug)]
pub struct StudyResult {
    /// One outcome per run.
    pub outcomes: Vec<Outcome>,
    /// The comparisons.
    pub rows: Vec<Row>,
}

impl StudyResult {
    /// Whether no comparison fails.
    pub fn holds(&self) -> bool {
        self.rows.iter().all(|r| r.verdict != Verdict::Fails)
    }
}

/// Allowed iterations of a start: those stated plus 25 %, at least 5. Fewer are no failure.
fn ceiling(stated: f64) -> f64 {
    stated + (0.25 * stated).floor().max(5.0)
}

impl Study {
    /// Makes the selected runs and compares. `begin` hears of each run before it starts.
    ///
    /// # Errors
    /// Only when the observer cancels; a run that fails shows in its rows.
    pub fn run(
        &self,
        selection: Selection,
        observer: &mut dyn CurveObserver,
        begin: &mut dyn FnMut(&Run),
    ) -> Result<StudyResult, SolveError> {
        let mut outcomes = Vec::new();
        for run in &self.runs {
            if selection == Selection::Quick && !run.quick {
                outcomes.push(Outcome::Skipped);
                continue;
            }
            begin(run);
            let outcome = match run.task {
                Task::Solve => solve(&run.case, observer).map(|s| Outcome::Solved(Box::new(s))),
                Task::Deflect => deflect(&run.case).map(Outcome::Deflected),
                Task::Curve => follow(run, observer),
                Task::Transient => march(run, observer),
            };
            outcomes.push(match outcome {
                Ok(outcome) => outcome,
                Err(SolveError::Interrupted) => return Err(SolveError::Interrupted),
                Err(error) => Outcome::Failed(error.to_string()),
            });
        }
        let mut rows = Vec::new();
        for (run, outcome) in self.runs.iter().zip(&outcomes) {
            if let Outcome::Failed(message) = outcome {
                rows.push(Row::failure(&run.name, message));
            }
            if let Outcome::Curve(curve) = outcome {
                let failures = (curve.points.iter())
                    .flat_map(|p| [Some(&p.outcome), p.newtonian.as_ref()])
                    .filter_map(|outcome| outcome?.reason());
                rows.extend(failures.map(|message| Row::failure(&run.name, message)));
            }
        }
        for check in &self.checks {
            rows.extend(check.rows(&self.runs, &outcomes));
        }
        for (run, outcome) in self.runs.iter().zip(&outcomes) {
            rows.extend(run.iterations(outcome));
        }
        Ok(StudyResult { outcomes, rows })
    }

    /// Pictures of the results: file name without suffix, caption, SVG file.
    pub fn draw(&self, result: &StudyResult) -> Vec<(String, String, String)> {
        self.pictures
            .iter()
            .filter_map(|picture| {
                let svg = picture.svg(self, &result.outcomes)?;
                let name = format!("{}-{}", self.name, picture.name);
                Some((name, picture.caption.clone(), svg))
            })
            .collect()
    }
}

/// Follows the contact of a run through time.
fn march(run: &Run, observer: &mut dyn CurveObserver) -> Result<Outcome, SolveError> {
    let found = transient::solve(&run.case, &mut Until(observer));
    match &found.failure {
        None => Ok(Outcome::Transient(Box::new(found))),
        Some(TransientError::Interrupted) => Err(SolveError::Interrupted),
        Some(error) => Ok(Outcome::Failed(error.to_string())),
    }
}

/// Ends a contact over time where the study ends.
struct Until<'a>(&'a mut dyn CurveObserver);

impl Observer for Until<'_> {
    fn cancelled(&self) -> bool {
        self.0.cancelled()
    }
}

impl InstantObserver for Until<'_> {}

/// Solves the curve of a run.
fn follow(run: &Run, observer: &mut dyn CurveObserver) -> Result<Outcome, SolveError> {
    let Some(curve) = &run.case.curve else {
        return Ok(Outcome::Failed("the case has no curve".to_owned()));
    };
    let solution = solve_curve(curve, observer);
    if solution.is_partial() {
        return Err(SolveError::Interrupted);
    }
    Ok(Outcome::Curve(solution))
}

impl Run {
    /// The iterations of a cold start, compared with the stated ones.
    fn iterations(&self, outcome: &Outcome) -> Option<Row> {
        let quantity = Quantity::NewtonIterations;
        let ours = quantity.value(self, outcome, None)?;
        let (reference, accept, source) = match self.newton_iterations {
            Some(stated) => (
                Reference::Value(stated as f64),
                Accept::AtMost(ceiling(stated as f64)),
                "cold start, ceiling of the effort",
            ),
            None => (Reference::Nothing, Accept::Anything, "cold start"),
        };
        Some(Row::new(
            &self.name, quantity, reference, ours, accept, source,
        ))
    }
}
