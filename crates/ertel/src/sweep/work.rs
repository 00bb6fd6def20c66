//! Work of each thread: it takes a point, solves it and passes on its record.

use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::Sender;

use super::folder::point_folder;
use super::{SweepError, SweepObserver, SweepParams};
use crate::case::Study;
use crate::engine::Observer;
use crate::output;
use crate::study::CurveObserver;
use crate::study::journal::{PointKey, Record};
use crate::study::point::{Ends, Interrupted, Task};
use crate::study::table::{StudyEcho, record};
use crate::study::walk::Walk;

/// State shared by the threads.
pub(super) struct Shared<'a> {
    pub(super) study: &'a Study,
    pub(super) echo: &'a StudyEcho,
    pub(super) wanted: &'a [bool],
    pub(super) folder: &'a Path,
    pub(super) params: &'a SweepParams,
    pub(super) observer: &'a dyn SweepObserver,
    pub(super) walk: &'a Walk<Ends>,
    /// Threads of all points together.
    pub(super) threads: usize,
    /// Points solved that are not wanted.
    pub(super) n_again: AtomicUsize,
}

/// Why a thread stops: an error, or the user.
type Stopped = Option<SweepError>;

impl Shared<'_> {
    /// Solves points until there are none, and sends the records of those that are wanted.
    pub(super) fn work(&self, sender: &Sender<(usize, Record)>) -> Result<(), Stopped> {
        self.walk.run(|index, from| {
            let (record, ends) = self.solve(index, from)?;
            match self.wanted[index] {
                true => sender.send((index, record)).map_err(|_| None)?,
                false => drop(self.n_again.fetch_add(1, Ordering::Relaxed)),
            }
            Ok(ends)
        })
    }

    /// Solves a point; fails where the user stops it or its folder cannot be written.
    fn solve(&self, index: usize, from: Ends) -> Result<(Record, Ends), Stopped> {
        if self.observer.cancelled() {
            return Err(None);
        }
        let points = &self.study.points;
        let key = self.echo.points[index].0;
        // The files as first read count, even if they have changed since.
        let whole = self.study.whole_point(index);
        let whole = whole.filter(|whole| PointKey::new(&whole.case) == key);
        let point = whole.as_ref().unwrap_or(&points[index]);
        let folders = self.params.folders && self.wanted[index];
        let task = Task {
            point,
            place: (index, points.len()),
            label: point.label.clone(),
            simpler: [false; 2],
            fields: folders,
            // Idle cores help with the contacts of a machine.
            workers: self.threads / self.walk.n_running().max(1),
        };
        let solved = task.solve(from, &mut Stop(self));
        let (solved, ends) = solved.map_err(|Interrupted| None)?;
        if let (true, Some(run)) = (folders, solved.outcome.in_time()) {
            let target = point_folder(self.folder, index, points.len());
            let instants = run.instants.as_ref().expect("they are kept for folders");
            output::write_transient(&solved.case, instants, &target, &point.case.output)
                .map_err(|e| Some(e.into()))?;
        }
        if let (true, Some(solution)) = (folders, solved.outcome.solution()) {
            let target = point_folder(self.folder, index, points.len());
            let (case, params) = (&solved.case, &point.case.output);
            match &solved.machine {
                None => output::write(case, solution, &target, params),
                Some(of) => output::write_machine(case, &of.solution, &of.figures, &target, params),
            }
            .map_err(|e| Some(e.into()))?;
        }
        Ok((record(key, &solved), ends))
    }
}

/// Stops the solver when the user wants, or when another thread has failed.
struct Stop<'a, 'b>(&'a Shared<'b>);

impl Observer for Stop<'_, '_> {
    fn cancelled(&self) -> bool {
        self.0.observer.cancelled() || self.0.walk.is_stopped()
    }
}

impl CurveObserver for Stop<'_, '_> {}
