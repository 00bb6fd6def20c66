//! Studies.

use std::path::PathBuf;
use std::sync::mpsc::Sender;
use std::sync::{Mutex, MutexGuard, PoisonError};

use ertel::case::Study;
use ertel::case::study::MOST_POINTS;
use ertel::study::journal::JOURNAL;
use ertel::study::plan::Plan;
use ertel::sweep::{
    Collector, Shard, SweepObserver, SweepParams, SweepProgress, SweepSummary,
    merge as merge_parts, sweep as run_sweep, sweep_part,
};
use ertel_input::file::{LARGEST_OWN, read_text};
use pyo3::prelude::*;

use crate::case::json;
use crate::errors;
use crate::pool::detached;
use crate::solve::{Cancel, without_gil};

/// A study whose points are solved by other processes, part by part.
#[pyclass(frozen, module = "ertel._ertel")]
pub struct NativeStudy {
    study: Study,
    plan: Plan,
    /// The journal, while the study runs.
    collector: Mutex<Option<Collector>>,
}

#[pymethods]
impl NativeStudy {
    /// Reads a study.
    #[new]
    fn new(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        detached(py, || {
            let study = Study::read(&path)?;
            let plan = Plan::new(&study);
            Ok(Self {
                study,
                plan,
                collector: Mutex::default(),
            })
        })?
        .map_err(errors::input)
    }

    /// Number of points.
    #[getter]
    fn n_points(&self) -> usize {
        self.study.points.len()
    }

    /// The files that it was read from.
    #[getter]
    fn files(&self) -> Vec<PathBuf> {
        self.study.files.clone()
    }

    /// Opens the journal in a folder and locks it; returns the number of finished points.
    fn open(&self, py: Python<'_>, folder: PathBuf, retry: bool) -> PyResult<usize> {
        let collector = detached(py, || Collector::open(&self.study, &folder, retry))?;
        let collector = collector.map_err(errors::sweep)?;
        let n = collector.n_finished();
        *self.lock() = Some(collector);
        Ok(n)
    }

    /// Gives the journal free.
    fn close(&self) {
        *self.lock() = None;
    }

    /// Parts of at most `most` neighbours with points that are not finished: group, and range in the order of its tree.
    fn parts(&self, most: usize) -> Vec<(usize, usize, usize)> {
        let collector = self.lock();
        let is_finished = |place: usize| collector.as_ref().is_some_and(|c| c.is_finished(place));
        let mut parts = Vec::new();
        for group in 0..self.plan.groups.len() {
            let (plan, members) = self.plan.of_group(group);
            let n_parts = plan.order.len().div_ceil(most.max(1));
            for k in 0..n_parts {
                let n = plan.order.len();
                let (start, stop) = (k * n / n_parts, (k + 1) * n / n_parts);
                let mut places = plan.order[start..stop].iter().map(|i| members[*i]);
                if places.any(|place| !is_finished(place)) {
                    parts.push((group, start, stop));
                }
            }
        }
        parts
    }

    /// Places of the points of a group, what each starts from (its number in the group), and their order.
    #[allow(clippy::type_complexity)]
    fn group(&self, group: usize) -> PyResult<(Vec<usize>, Vec<Option<usize>>, Vec<usize>)> {
        if group >= self.plan.groups.len() {
            return Err(errors::CaseError::new_err(format!(
                "there is no group {group}"
            )));
        }
        let (plan, members) = self.plan.of_group(group);
        Ok((members.to_vec(), plan.parents, plan.order))
    }

    /// Puts the journal of a part into the study's; returns the number of new points.
    fn append(&self, py: Python<'_>, journal: &str) -> PyResult<usize> {
        py.detach(|| match self.lock().as_mut() {
            Some(collector) => collector.append(journal),
            None => Ok(0),
        })
        .map_err(errors::sweep)
    }
}

impl NativeStudy {
    fn lock(&self) -> MutexGuard<'_, Option<Collector>> {
        self.collector
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
    }
}

/// Solves part `range` of a group of a study's points in a separate folder; returns its journal.
#[pyfunction]
pub fn solve_part(
    py: Python<'_>,
    path: PathBuf,
    folder: PathBuf,
    group: (Vec<usize>, Vec<Option<usize>>, Vec<usize>),
    range: (usize, usize),
) -> PyResult<String> {
    let (members, parents, order) = group;
    let n = members.len();
    let ordered = |start: usize, stop: usize| start <= stop && stop <= n;
    if parents.len() != n || order.len() != n || !ordered(range.0, range.1) {
        return Err(errors::CaseError::new_err(
            "a part of a study that does not fit its group",
        ));
    }
    let study = detached(py, || Study::read_some(&path, Some(&members)))?;
    let study = study.map_err(errors::input)?;
    let plan = Plan {
        parents,
        order,
        groups: vec![(0..n).collect()],
    };
    let params = SweepParams {
        jobs: Some(1),
        threads: Some(1),
        ..SweepParams::default()
    };
    let summary = without_gil(py, None, |sender, cancel| {
        let messages = Messages::new(sender, false, cancel);
        let part = (&plan, range.0..range.1);
        sweep_part(&study, part, &folder, &params, &messages)
    })?;
    summary.map_err(errors::sweep)?;
    read_text(&folder.join(JOURNAL), LARGEST_OWN)
        .map_err(|e| errors::OutputError::new_err(format!("the journal of the part {e}")))
}

/// Sends each finished point as JSON.
pub struct Messages {
    sender: Mutex<Sender<String>>,
    wanted: bool,
    cancel: Cancel,
}

impl Messages {
    pub fn new(sender: Sender<String>, wanted: bool, cancel: Cancel) -> Self {
        Self {
            sender: Mutex::new(sender),
            wanted,
            cancel,
        }
    }
}

impl SweepObserver for Messages {
    fn finished(&self, progress: &SweepProgress<'_>) {
        if !self.wanted {
            return;
        }
        let message = serde_json::json!({
            "event": "point",
            "point": progress.index + 1,
            "n_finished": progress.n_finished,
            "n_points": progress.n_points,
            "label": progress.label,
            "converged": progress.record.converged,
            "seconds_left": progress.seconds_left,
        });
        if let Ok(sender) = self.sender.lock() {
            let _ = sender.send(message.to_string());
        }
    }

    fn cancelled(&self) -> bool {
        self.cancel.is_set()
    }
}

/// Runs a study in a folder, or part `shard[0]` of `shard[1]` of it; returns a summary as JSON.
#[pyfunction]
#[pyo3(signature = (path, folder, *, jobs=None, threads=None, shard=None, folders=false, retry=false, progress=None))]
#[allow(clippy::too_many_arguments)]
pub fn sweep(
    py: Python<'_>,
    path: PathBuf,
    folder: PathBuf,
    jobs: Option<usize>,
    threads: Option<usize>,
    shard: Option<(usize, usize)>,
    folders: bool,
    retry: bool,
    progress: Option<Py<PyAny>>,
) -> PyResult<String> {
    let of = |(index, n)| {
        let wrong = || {
            errors::CaseError::new_err(format!(
                "shard ({index}, {n}): the first number goes from 1 to the second, and the second to {MOST_POINTS}"
            ))
        };
        Shard::new(index, n).ok_or_else(wrong)
    };
    let shard = shard.map(of).transpose()?;
    if let Some(name) = [("jobs", jobs), ("threads", threads)]
        .iter()
        .find(|(_, n)| *n == Some(0))
    {
        return Err(errors::CaseError::new_err(format!(
            "{} = 0: one at least",
            name.0
        )));
    }
    let study = detached(py, || Study::read(&path))?.map_err(errors::input)?;
    let params = SweepParams {
        jobs,
        threads,
        shard,
        folders,
        retry,
    };
    let wanted = progress.is_some();
    let summary = without_gil(py, progress.as_ref(), |sender, cancel| {
        let messages = Messages::new(sender, wanted, cancel);
        run_sweep(&study, &folder, &params, &messages)
    })?;
    described(&summary.map_err(errors::sweep)?)
}

/// Joins the parts of a study into `target`; returns a summary as JSON.
#[pyfunction]
pub fn merge(py: Python<'_>, target: PathBuf, parts: Vec<PathBuf>) -> PyResult<String> {
    let summary = detached(py, || merge_parts(&target, &parts))?;
    described(&summary.map_err(errors::sweep)?)
}

/// A summary as JSON.
pub fn described(summary: &SweepSummary) -> PyResult<String> {
    json(&serde_json::json!({
        "n_points": summary.n_points,
        "n_kept": summary.n_kept,
        "n_new": summary.n_new,
        "n_again": summary.n_again,
        "n_damaged": summary.n_damaged,
        "n_unresolved": summary.n_unresolved,
        "failures": summary.failures.iter()
            .map(|(i, label, reason)| serde_json::json!({"point": i + 1, "label": label, "reason": reason}))
            .collect::<Vec<_>>(),
        "warnings": summary.warnings.iter().map(|w| w.line(summary.n_points)).collect::<Vec<_>>(),
        "wall_seconds": summary.wall_seconds,
        "point_seconds": summary.point_seconds,
        "interrupted": summary.interrupted,
    }))
}
