//! What each thread does: it takes a point, solves it and hands on its record.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::mpsc::Sender;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Instant;

use super::folder::point_folder;
use super::queue::Queue;
use super::{SweepError, SweepObserver, SweepParams};
use crate::case::{Case, Study};
use crate::output;
use crate::reference::film_formulas;
use crate::run::{Session, Start, groups};
use crate::solve::{Observer, SolveError};
use crate::study::journal::{PointKey, Record};
use crate::study::plan::Plan;
use crate::study::table::{StudyEcho, record};
use crate::study::{Outcome, PointSolution};

/// What the threads share.
pub(super) struct Shared<'a> {
    pub(super) session: &'a Session,
    pub(super) study: &'a Study,
    pub(super) echo: &'a StudyEcho,
    pub(super) plan: &'a Plan,
    pub(super) wanted: &'a [bool],
    pub(super) folder: &'a Path,
    pub(super) params: &'a SweepParams,
    pub(super) observer: &'a dyn SweepObserver,
    pub(super) state: &'a Mutex<Queue>,
    pub(super) bell: &'a Condvar,
}

pub(super) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Shared<'_> {
    /// Solves points until there are none.
    pub(super) fn work(&self, sender: &Sender<(usize, Record)>) {
        let _alarm = Alarm(self);
        while let Some((index, start)) = self.next() {
            let (end, record) = match self.solve(index, start.as_ref()) {
                Ok(result) => result,
                Err(error) => {
                    lock(self.state).stop(error);
                    self.bell.notify_all();
                    return;
                }
            };
            {
                let mut state = lock(self.state);
                // What starts from a point that failed starts from where that one started.
                state.done(index, end.or(start));
                if !self.wanted[index] {
                    state.n_again += 1;
                }
            }
            self.bell.notify_all();
            if self.wanted[index] && sender.send((index, record)).is_err() {
                return;
            }
        }
    }

    /// The next point with what it starts from; waits while others may make one ready.
    fn next(&self) -> Option<(usize, Option<Arc<Start>>)> {
        let mut state = lock(self.state);
        loop {
            if state.stopped || self.observer.cancelled() {
                state.stopped = true;
                self.bell.notify_all();
                return None;
            }
            if let Some(point) = state.take() {
                return Some(point);
            }
            if state.is_over() {
                self.bell.notify_all();
                return None;
            }
            state = self
                .bell
                .wait(state)
                .unwrap_or_else(PoisonError::into_inner);
        }
    }

    /// Solves a point; fails where the user stops it or its folder cannot be written.
    fn solve(
        &self,
        index: usize,
        start: Option<&Arc<Start>>,
    ) -> Result<(Option<Arc<Start>>, Record), Option<SweepError>> {
        let clock = Instant::now();
        let points = &self.study.points;
        let lean = &points[index].case;
        let key = self.echo.points[index].0;
        // What was read first counts, should its files have changed since.
        let whole = (self.study.whole_case(index)).filter(|whole| PointKey::new(whole) == key);
        let case = whole.as_ref().unwrap_or(lean);
        let companions = self.plan.companions(index);
        let ahead: Vec<&Case> = companions.map(|i| &points[i].case).collect();
        let mut observer = Stop(self);
        let solved = catch_unwind(AssertUnwindSafe(|| {
            self.session
                .solve_from(case, start.map(AsRef::as_ref), &ahead, &mut observer)
        }));
        let mut end = None;
        let outcome = match solved {
            Ok(Ok((solution, reached))) => {
                end = Some(Arc::new(reached));
                Outcome::Solved(Box::new(solution))
            }
            Ok(Err(SolveError::Interrupted)) => return Err(None),
            Ok(Err(error)) => Outcome::Failed(error.to_string()),
            Err(_) => Outcome::Failed("internal error; the message stands above".to_owned()),
        };
        let echo = case.echo();
        if let (true, true, Some(solution)) =
            (self.params.folders, self.wanted[index], outcome.solution())
        {
            let target = point_folder(self.folder, index, points.len());
            output::write(&echo, solution, &target, &case.output).map_err(|e| Some(e.into()))?;
        }
        let lubricant = &case.lubricant;
        let slope = lubricant
            .viscosity
            .pressure_viscosity_slope(lubricant.temperature);
        let point = PointSolution {
            value: f64::NAN,
            formulas: film_formulas(&case.contact, &groups(case, slope)),
            case: echo,
            outcome,
            newtonian: None,
            isothermal: None,
            seconds: clock.elapsed().as_secs_f64(),
        };
        Ok((end, record(key, &point)))
    }
}

/// Stops the other threads when one panics: they would wait for it.
struct Alarm<'a, 'b>(&'a Shared<'b>);

impl Drop for Alarm<'_, '_> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            lock(self.0.state).stop(None);
            self.0.bell.notify_all();
        }
    }
}

/// Stops the solver when the user wants, or when another thread has failed.
struct Stop<'a, 'b>(&'a Shared<'b>);

impl Observer for Stop<'_, '_> {
    fn cancelled(&self) -> bool {
        self.0.observer.cancelled() || lock(self.0.state).stopped
    }
}
