//! A study: its points side by side on all cores, each from the one that the plan says.

use std::collections::{BTreeSet, HashMap};
use std::fs;
use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Instant;

use super::journal::{Entries, JOURNAL, Journal, PointKey, Record};
use super::plan::Plan;
use super::table::{StudyEcho, TABLE, record, write_whole};
use super::{Outcome, PointSolution};
use crate::case::{Case, Study};
use crate::output::{self, OutputError};
use crate::reference::film_formulas;
use crate::run::{Session, Start, groups};
use crate::solve::{Observer, SolveError};

/// Folder within that of a study, with the results of its points where these are asked for.
const FOLDERS: &str = "points";
/// Name of the picture of its films, and of that of its tractions.
const FILMS: &str = "film.svg";
const TRACTIONS: &str = "traction.svg";

/// How a study is run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SweepParams {
    /// Points solved at the same time; `None`: as many as cores.
    pub jobs: Option<usize>,
    /// Threads of each of them; `None`: one.
    pub threads: Option<usize>,
    /// Part of the points to be solved.
    pub shard: Option<Shard>,
    /// Whether each point's results are written into a folder of its own.
    pub folders: bool,
    /// Whether points that failed are solved again.
    pub retry: bool,
}

/// Part `index` of `n`, from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// Which, from 1.
    pub index: usize,
    /// Of how many.
    pub n: usize,
}

impl Shard {
    /// Its share of the plan's order: neighbours in the tree stay together.
    fn range(self, n_points: usize) -> std::ops::Range<usize> {
        (self.index - 1) * n_points / self.n..self.index * n_points / self.n
    }
}

/// Follows a study; called from the threads that solve its points.
pub trait SweepObserver: Sync {
    /// The solving begins.
    fn begin(&self, _n_points: usize, _n_kept: usize) {}

    /// A point is finished.
    fn finished(&self, _progress: &SweepProgress<'_>) {}

    /// Whether the user wants to stop.
    fn cancelled(&self) -> bool {
        false
    }
}

impl SweepObserver for crate::solve::Silent {}

/// How far a study is.
#[derive(Clone, Debug)]
pub struct SweepProgress<'a> {
    /// Points that are finished, in this run or an earlier one.
    pub n_finished: usize,
    /// Points of the study, or of the part being run.
    pub n_points: usize,
    /// Index of the point just finished, from 0.
    pub index: usize,
    /// Its values.
    pub label: &'a str,
    /// What became of it.
    pub record: &'a Record,
    /// Estimate of the wall time left, s.
    pub seconds_left: f64,
}

/// What became of a study.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SweepSummary {
    /// Points of the study, or of the part that was run.
    pub n_points: usize,
    /// Points that the journal had already.
    pub n_kept: usize,
    /// Points finished in this run.
    pub n_new: usize,
    /// Points of the journal that were solved again because others start from them.
    pub n_again: usize,
    /// Lines of the journal that could not be read.
    pub n_damaged: usize,
    /// Index, values and reason of the points without solution.
    pub failures: Vec<(usize, String, String)>,
    /// Warnings, each with the indices of its points.
    pub warnings: Vec<(String, Vec<usize>)>,
    /// Wall time, s.
    pub wall_seconds: f64,
    /// Time of the new points, all together, s.
    pub point_seconds: f64,
    /// Whether the user stopped it.
    pub interrupted: bool,
}

/// Why a study was not run.
#[derive(Debug, thiserror::Error)]
pub enum SweepError {
    /// The system refused.
    #[error("{}: {source}", path.display())]
    Io {
        /// Which file.
        path: PathBuf,
        /// The system's reason.
        source: io::Error,
    },
    /// Another run is at work.
    #[error("another run is writing to {}; wait for it, or choose another folder", folder.display())]
    Locked {
        /// The folder.
        folder: PathBuf,
    },
    /// The folder is somebody else's.
    #[error("will not write a study to {}: it holds files, but no study of ertel. Choose another folder", folder.display())]
    Foreign {
        /// The folder.
        folder: PathBuf,
    },
    /// Two points are one.
    #[error("points {first} and {second} are the same case ({label})")]
    Twice {
        /// Number of the first, from 1.
        first: usize,
        /// Number of the second.
        second: usize,
        /// Values of the second.
        label: String,
    },
    /// A part to be joined is no part of the others' study.
    #[error("{} belongs to another study than {}", folder.display(), other.display())]
    Mixed {
        /// Folder of the part.
        folder: PathBuf,
        /// Folder of the first part.
        other: PathBuf,
    },
    /// A part to be joined is no study.
    #[error("{} holds no study of ertel", folder.display())]
    NoStudy {
        /// Folder of the part.
        folder: PathBuf,
    },
    /// Results of a point cannot be written.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// Threads cannot be made.
    #[error("cannot start threads: {0}")]
    Threads(String),
}

impl SweepError {
    pub(super) fn io(path: &Path, source: io::Error) -> SweepError {
        SweepError::Io {
            path: path.to_owned(),
            source,
        }
    }
}

/// Runs a study in a folder, or what is left of it, and writes its table.
///
/// Finished points stand in the folder's journal, from which the next run goes on. What a point comes to does not
/// depend on which points the journal had, nor on the number of cores: where a point starts from one that
/// is finished, that one is solved once more.
///
/// # Errors
/// [`SweepError`]; points finished until then are kept. A point that is not solved is no error.
pub fn sweep(
    session: &Session,
    study: &Study,
    folder: &Path,
    params: &SweepParams,
    observer: &dyn SweepObserver,
) -> Result<SweepSummary, SweepError> {
    let clock = Instant::now();
    let echo = StudyEcho::new(study);
    check_distinct(study, &echo)?;
    let (mut journal, entries) = open(folder)?;
    echo.write(folder)?;
    let plan = Plan::new(study);
    let part = match params.shard {
        Some(shard) => shard.range(plan.order.len()),
        None => 0..plan.order.len(),
    };
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
    let mut records = entries.records.clone();
    let wanted: Vec<bool> = {
        let mut wanted = vec![false; study.points.len()];
        for i in &mine {
            wanted[*i] = !is_kept(*i);
        }
        wanted
    };
    observer.begin(mine.len(), n_kept);
    let queue = Queue::new(&plan, &wanted);
    let state = Mutex::new(queue);
    let bell = Condvar::new();
    let shared = Shared {
        session,
        study,
        echo: &echo,
        plan: &plan,
        wanted: &wanted,
        folder,
        params,
        observer,
        state: &state,
        bell: &bell,
    };
    let threads = params.threads.unwrap_or(1).max(1);
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let n_wanted = lock(&state).n_needed;
    let jobs = params.jobs.unwrap_or(cores.div_ceil(threads));
    let jobs = jobs.clamp(1, n_wanted.max(1));
    let (sender, receiver) = std::sync::mpsc::channel::<(usize, Record)>();
    let pools: Vec<rayon::ThreadPool> = (0..jobs)
        .map(|_| {
            rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .map_err(|e| SweepError::Threads(e.to_string()))
        })
        .collect::<Result<_, _>>()?;
    std::thread::scope(|scope| {
        for pool in &pools {
            let (shared, sender) = (&shared, sender.clone());
            scope.spawn(move || pool.install(|| shared.work(&sender)));
        }
        drop(sender);
        // Records are appended one after the other, here.
        for (index, record) in receiver {
            if let Err(error) = journal.append(&record) {
                lock(&state).stop(Some(error));
                bell.notify_all();
                break;
            }
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
        }
    });
    let queue = state.into_inner().unwrap_or_else(PoisonError::into_inner);
    if let Some(error) = queue.error {
        return Err(error);
    }
    summary.n_again = queue.n_again;
    summary.interrupted = n_kept + summary.n_new < mine.len();
    if !summary.interrupted {
        let own: HashMap<PointKey, Record> = (mine.iter())
            .filter_map(|i| {
                let key = echo.points[*i].0;
                Some((key, records.get(&key)?.clone()))
            })
            .collect();
        write_results(folder, &echo, &own)?;
    }
    let mut sorted = mine;
    sorted.sort_unstable();
    for i in sorted {
        let Some(record) = records.get(&echo.points[i].0) else {
            continue;
        };
        if !record.converged {
            let label = study.points[i].label.clone();
            summary.failures.push((i, label, record.reason.clone()));
        }
        for warning in &record.warnings {
            match summary
                .warnings
                .iter_mut()
                .find(|(text, _)| text == warning)
            {
                Some((_, points)) => points.push(i),
                None => summary.warnings.push((warning.clone(), vec![i])),
            }
        }
    }
    summary.wall_seconds = clock.elapsed().as_secs_f64();
    Ok(summary)
}

/// Points of the study that are finished, of those in the folder.
///
/// # Errors
/// [`SweepError::Io`].
pub fn finished_points(study: &Study, folder: &Path) -> Result<Vec<Option<Record>>, SweepError> {
    let entries = Entries::read(folder)?;
    let record = |p: &crate::case::study::StudyPoint| {
        let key = PointKey::new(&p.case);
        entries.records.get(&key).cloned()
    };
    Ok(study.points.iter().map(record).collect())
}

/// Joins parts of one study: their journals and their table, in a folder that may hold a part of it.
///
/// # Errors
/// [`SweepError`]: parts of different studies, folders without a study, and the system's reasons.
pub fn merge(target: &Path, parts: &[PathBuf]) -> Result<SweepSummary, SweepError> {
    let clock = Instant::now();
    let mut study: Option<(StudyEcho, &Path)> = None;
    let mut all = Vec::new();
    for part in parts {
        let echo = StudyEcho::read(part)?.ok_or_else(|| SweepError::NoStudy {
            folder: part.clone(),
        })?;
        match &study {
            Some((first, other))
                if first.points != echo.points || first.columns != echo.columns =>
            {
                return Err(SweepError::Mixed {
                    folder: part.clone(),
                    other: other.to_path_buf(),
                });
            }
            Some(_) => {}
            None => study = Some((echo, part)),
        }
        all.push(Entries::read(part)?);
    }
    let Some((echo, _)) = study else {
        return Ok(SweepSummary::default());
    };
    let (mut journal, former) = open(target)?;
    echo.write(target)?;
    let mut records = former.records;
    let mut summary = SweepSummary {
        n_points: echo.points.len(),
        n_damaged: former.n_damaged + all.iter().map(|e| e.n_damaged).sum::<usize>(),
        ..SweepSummary::default()
    };
    for (i, (key, values)) in echo.points.iter().enumerate() {
        let found = all.iter().filter_map(|entries| entries.records.get(key));
        // A part may have tried once more what failed in another.
        let found = found.max_by_key(|record| record.converged);
        let known = records.get(key).is_some_and(|record| record.converged);
        match found {
            Some(record) if !known && records.get(key) != Some(record) => {
                journal.append(record)?;
                summary.n_new += 1;
                records.insert(*key, record.clone());
            }
            _ => summary.n_kept += usize::from(records.contains_key(key)),
        }
        match records.get(key) {
            Some(record) if !record.converged => {
                let label = values.join(", ");
                summary.failures.push((i, label, record.reason.clone()));
            }
            Some(_) => {}
            None => summary.interrupted = true,
        }
    }
    write_results(target, &echo, &records)?;
    summary.wall_seconds = clock.elapsed().as_secs_f64();
    Ok(summary)
}

/// The table and the pictures that it makes.
fn write_results(
    folder: &Path,
    echo: &StudyEcho,
    records: &HashMap<PointKey, Record>,
) -> Result<(), SweepError> {
    write_whole(&folder.join(TABLE), echo.table(records).as_bytes())?;
    for (name, chart) in [
        (FILMS, output::study_films(echo, records)),
        (TRACTIONS, output::study_tractions(echo, records)),
    ] {
        if let Some(chart) = chart {
            write_whole(&folder.join(name), chart.svg().as_bytes())?;
        }
    }
    Ok(())
}

/// Makes the folder of a study, or opens a former one.
fn open(folder: &Path) -> Result<(Journal, Entries), SweepError> {
    fs::create_dir_all(folder).map_err(|e| SweepError::io(folder, e))?;
    let names = fs::read_dir(folder).map_err(|e| SweepError::io(folder, e))?;
    let mut names = names.filter_map(|e| Some(e.ok()?.file_name()));
    let known = StudyEcho::read(folder)?.is_some() || folder.join(JOURNAL).exists();
    if !known && names.any(|name| !name.to_string_lossy().starts_with('.') && name != "shards") {
        return Err(SweepError::Foreign {
            folder: folder.to_owned(),
        });
    }
    Journal::open(folder)
}

fn check_distinct(study: &Study, echo: &StudyEcho) -> Result<(), SweepError> {
    let mut seen = HashMap::new();
    for (i, (key, _)) in echo.points.iter().enumerate() {
        if let Some(first) = seen.insert(*key, i) {
            return Err(SweepError::Twice {
                first: first + 1,
                second: i + 1,
                label: study.points[i].label.clone(),
            });
        }
    }
    Ok(())
}

/// Folder of a point's results: its number with as many digits as the last one has.
fn point_folder(folder: &Path, index: usize, n_points: usize) -> PathBuf {
    let width = n_points.to_string().len();
    folder.join(FOLDERS).join(format!("{:0width$}", index + 1))
}

fn has_folder(folder: &Path, index: usize, study: &Study, record: Option<&Record>) -> bool {
    record.is_some_and(|r| !r.converged)
        || point_folder(folder, index, study.points.len())
            .join("result.json")
            .exists()
}

/// Points that wait, by their place in the plan's order, and the ends that others start from.
struct Queue {
    /// Points to be solved, for their own sake or because others start from them.
    needed: Vec<bool>,
    n_needed: usize,
    /// Place of each point in the order.
    place: Vec<usize>,
    /// Needed points that start from each point.
    children: Vec<Vec<usize>>,
    ready: BTreeSet<(usize, usize)>,
    /// What each ready or running point starts from.
    starts: HashMap<usize, Option<Arc<Start>>>,
    n_running: usize,
    n_again: usize,
    stopped: bool,
    error: Option<SweepError>,
}

impl Queue {
    fn new(plan: &Plan, wanted: &[bool]) -> Queue {
        let n = plan.order.len();
        let mut needed = wanted.to_vec();
        let mut place = vec![0; n];
        let mut children = vec![Vec::new(); n];
        for (position, i) in plan.order.iter().enumerate().rev() {
            place[*i] = position;
            if let (true, Some(parent)) = (needed[*i], plan.parents[*i]) {
                needed[parent] = true;
                children[parent].push(*i);
            }
        }
        let roots = (0..n).filter(|i| needed[*i] && plan.parents[*i].is_none());
        let ready: BTreeSet<_> = roots.map(|i| (place[i], i)).collect();
        Queue {
            n_needed: needed.iter().filter(|n| **n).count(),
            starts: ready.iter().map(|(_, i)| (*i, None)).collect(),
            needed,
            place,
            children,
            ready,
            n_running: 0,
            n_again: 0,
            stopped: false,
            error: None,
        }
    }

    fn stop(&mut self, error: Option<SweepError>) {
        self.stopped = true;
        if self.error.is_none() {
            self.error = error;
        }
    }

    /// A point is done; those that start from it are ready.
    fn done(&mut self, index: usize, end: Option<Arc<Start>>) {
        debug_assert!(self.needed[index]);
        self.n_running -= 1;
        for child in std::mem::take(&mut self.children[index]) {
            self.starts.insert(child, end.clone());
            self.ready.insert((self.place[child], child));
        }
    }
}

/// What the threads share.
struct Shared<'a> {
    session: &'a Session,
    study: &'a Study,
    echo: &'a StudyEcho,
    plan: &'a Plan,
    wanted: &'a [bool],
    folder: &'a Path,
    params: &'a SweepParams,
    observer: &'a dyn SweepObserver,
    state: &'a Mutex<Queue>,
    bell: &'a Condvar,
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Shared<'_> {
    /// Solves points until there are none.
    fn work(&self, sender: &std::sync::mpsc::Sender<(usize, Record)>) {
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
            if let Some((_, index)) = state.ready.pop_first() {
                state.n_running += 1;
                return Some((index, state.starts.remove(&index).flatten()));
            }
            if state.n_running == 0 {
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
        let case = &points[index].case;
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
            formulas: film_formulas(case.contact.kind, case.contact.radius, &groups(case, slope)),
            case: echo,
            outcome,
            newtonian: None,
            isothermal: None,
            seconds: clock.elapsed().as_secs_f64(),
        };
        Ok((end, record(self.echo.points[index].0, &point)))
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
