//! A study: its points in parallel on all cores, each from the one given by the plan.

mod collect;
mod error;
mod folder;
mod merge;
mod params;
mod work;

use std::collections::HashMap;
use std::collections::HashSet;
use std::ops::Range;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

use crate::case::Study;
use crate::study::journal::{PointKey, Record};
use crate::study::plan::Plan;
use crate::study::walk::Walk;
use crate::study::{StudyEcho, cores};
use crate::warning::by_kind;
use collect::check_distinct;
use folder::{has_folder, look, open, write_results};
use work::Shared;

pub use collect::Collector;
pub use error::SweepError;
pub use folder::{FOLDERS, SHARDS, files};
pub use merge::merge;
pub use params::{Shard, SweepObserver, SweepParams, SweepProgress, SweepSummary};

/// Runs a study in a folder, or its remaining points, and writes its table.
///
/// Finished points are in the folder's journal, from which the next run continues. The result of a point does not
/// depend on which points the journal had, nor on the number of cores: where a point starts from one that
/// is finished, that one is solved again.
///
/// # Errors
/// [`SweepError`]; points finished until then are kept. A point that is not solved is no error.
pub fn sweep(
    study: &Study,
    folder: &Path,
    params: &SweepParams,
    observer: &dyn SweepObserver,
) -> Result<SweepSummary, SweepError> {
    let plan = Plan::new(study);
    let part = match params.shard {
        Some(shard) => shard.range(plan.order.len()),
        None => 0..plan.order.len(),
    };
    sweep_part(study, (&plan, part), folder, params, observer)
}

/// Runs a part of the order of a plan, which is that of the study; `params.shard` is ignored.
///
/// # Errors
/// As [`sweep`].
pub fn sweep_part(
    study: &Study,
    (plan, part): (&Plan, Range<usize>),
    folder: &Path,
    params: &SweepParams,
    observer: &dyn SweepObserver,
) -> Result<SweepSummary, SweepError> {
    let clock = Instant::now();
    let echo = StudyEcho::new(study);
    check_distinct(study, &echo)?;
    let (mut journal, entries) = open(folder, &echo)?;
    let mine: Vec<usize> = plan.order[part].to_vec();
    let is_kept = |i: usize| {
        let record = entries.records.get(&echo.points[i].0);
        record.is_some_and(|r| r.converged || !params.retry)
            && (!params.folders || has_folder(folder, i, study, record))
    };
    let n_kept = mine.iter().filter(|i| is_kept(**i)).count();
    let mut summary = SweepSummary {
        n_points: mine.len(),
        n_kept,
        n_damaged: entries.n_damaged,
        ..SweepSummary::default()
    };
    let mut wanted = vec![false; study.points.len()];
    for i in &mine {
        wanted[*i] = !is_kept(*i);
    }
    let mut records = entries.records;
    observer.begin(mine.len(), n_kept);
    let walk = Walk::new(plan, &wanted);
    let threads = params.threads.unwrap_or(1).max(1);
    let jobs = params.jobs.unwrap_or(cores().div_ceil(threads));
    let shared = Shared {
        study,
        echo: &echo,
        wanted: &wanted,
        folder,
        params,
        observer,
        walk: &walk,
        threads: jobs * threads,
        n_again: AtomicUsize::new(0),
    };
    let jobs = jobs.clamp(1, walk.n_needed.max(1));
    solve_points(&shared, [jobs, threads], |index, record| {
        journal.append(&record)?;
        summary.n_new += 1;
        summary.point_seconds += record.seconds;
        let n_finished = n_kept + summary.n_new;
        let elapsed = clock.elapsed().as_secs_f64();
        let left = (mine.len() - n_finished) as f64;
        observer.finished(&SweepProgress {
            n_finished,
            n_points: mine.len(),
            index,
            label: &study.points[index].label,
            record: &record,
            seconds_left: elapsed / summary.n_new as f64 * left,
        });
        records.insert(record.key, record);
        Ok(())
    })?;
    summary.n_again = shared.n_again.load(Ordering::Relaxed);
    summary.interrupted = n_kept + summary.n_new < mine.len();
    if !summary.interrupted {
        // The journal may have points of another part, or of what the study was before.
        let own: HashSet<PointKey> = mine.iter().map(|i| echo.points[*i].0).collect();
        records.retain(|key, _| own.contains(key));
        write_results(folder, &echo, &records)?;
    }
    summary.add_points(study, &echo, mine, &records);
    summary.wall_seconds = clock.elapsed().as_secs_f64();
    Ok(summary)
}

/// Solves the points that are needed in several jobs, each with its threads; `finished` has their records one after the other.
fn solve_points(
    shared: &Shared<'_>,
    [jobs, threads]: [usize; 2],
    mut finished: impl FnMut(usize, Record) -> Result<(), SweepError>,
) -> Result<(), SweepError> {
    let pools: Vec<rayon::ThreadPool> = (0..jobs)
        .map(|_| {
            rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .map_err(|e| SweepError::Threads(e.to_string()))
        })
        .collect::<Result<_, _>>()?;
    let (sender, receiver) = std::sync::mpsc::channel::<(usize, Record)>();
    std::thread::scope(|scope| {
        let work = |pool| {
            let sender = sender.clone();
            scope.spawn(move || rayon::ThreadPool::install(pool, || shared.work(&sender)))
        };
        let threads: Vec<_> = pools.iter().map(work).collect();
        drop(sender);
        let mut failure = None;
        for (index, record) in receiver {
            if let Err(error) = finished(index, record) {
                shared.walk.stop();
                failure = Some(error);
                break;
            }
        }
        for thread in threads {
            match thread.join() {
                Ok(end) => failure = failure.or(end.err().flatten()),
                Err(panic) => std::panic::resume_unwind(panic),
            }
        }
        failure.map_or(Ok(()), Err)
    })
}

impl SweepSummary {
    /// Adds failures, unresolved figures and warnings of some points.
    fn add_points(
        &mut self,
        study: &Study,
        echo: &StudyEcho,
        mut points: Vec<usize>,
        records: &HashMap<PointKey, Record>,
    ) {
        let mut warnings = Vec::new();
        points.sort_unstable();
        for i in points {
            let Some(record) = records.get(&echo.points[i].0) else {
                continue;
            };
            if !record.converged {
                let label = study.points[i].label.clone();
                self.failures.push((i, label, record.reason.clone()));
            }
            self.n_unresolved += usize::from(record.is_unresolved());
            self.unresolved.add(|column| record.field(column));
            let shown = (record.warnings.iter()).filter(|w| w.is_shown_with(&echo.silence));
            warnings.extend(shown.map(|w| (i, w)));
        }
        self.warnings = by_kind(warnings);
    }
}

/// Points of the study that are finished, of those in the folder.
///
/// # Errors
/// [`SweepError`], as [`sweep`] has it before it begins.
pub fn finished_points(study: &Study, folder: &Path) -> Result<Vec<Option<Record>>, SweepError> {
    check_distinct(study, &StudyEcho::new(study))?;
    let entries = look(folder)?;
    let record = |p: &crate::case::study::StudyPoint| {
        let key = PointKey::new(&p.case);
        entries.records.get(&key).cloned()
    };
    Ok(study.points.iter().map(record).collect())
}
