//! The process that reads inputs: it may die of one, and is started again behind it.

use std::fs;
use std::io::{self, Write};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use serde::{Deserialize, Serialize};

use crate::finding::{Defect, Kind};
use crate::input::{Input, Target};
use crate::seeds::Seeds;
use crate::targets::{self, Verdict};
use crate::watch::{self, Watch};

/// Inputs after which the figures are reported.
const PERIOD: u64 = 5000;
/// File with the number of the input being read, for those that kill the process.
const PROGRESS: &str = "progress";

/// The task of a worker.
#[derive(Clone, Debug)]
pub struct Job {
    /// Seed of all inputs.
    pub seed: u64,
    /// Readers.
    pub targets: Vec<Target>,
    /// The first input, and the one behind the last.
    pub range: std::ops::Range<u64>,
    /// Time that is left.
    pub time: Option<Duration>,
    /// Its folder.
    pub folder: PathBuf,
}

/// Reports of a worker, a line of JSON each.
#[derive(Debug, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Message {
    /// A defect.
    Defect {
        /// Which input.
        index: u64,
        /// What.
        defect: Defect,
    },
    /// Figures so far.
    Figures(Figures),
    /// The end.
    Done,
}

/// Figures of the inputs since the last ones.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Figures {
    /// Inputs read.
    pub n_inputs: u64,
    /// Of them, those that were taken.
    pub n_taken: u64,
    /// The input behind the last one.
    pub next: u64,
    /// CPU seconds of the slowest, and which one.
    pub slowest: (f64, u64),
    /// Most memory of the process, bytes.
    pub peak: u64,
}

/// Number of the input that a dead worker was reading.
pub fn progress(folder: &Path) -> Option<u64> {
    fs::read_to_string(folder.join(PROGRESS)).ok()?.parse().ok()
}

/// Reads inputs until the last one or the end of the time.
///
/// # Errors
/// Its folder, or its output, fails.
pub fn work(seeds: &Seeds, job: &Job) -> io::Result<()> {
    let until = job.time.map(|time| Instant::now() + time);
    let folder = job.folder.join("input");
    let index_file = job.folder.join(PROGRESS);
    let watch = Watch::start({
        let index_file = index_file.clone();
        move |defect| {
            let index = fs::read_to_string(&index_file)
                .ok()
                .and_then(|text| text.parse().ok());
            let _ = report(&Message::Defect {
                index: index.unwrap_or(0),
                defect,
            });
            std::process::exit(3);
        }
    });
    watch::keep_panics();
    let mut figures = Figures {
        next: job.range.start,
        ..Figures::default()
    };
    for index in job.range.clone() {
        if until.is_some_and(|until| Instant::now() > until) {
            break;
        }
        let input = seeds.input(job.seed, index, &job.targets);
        fs::write(&index_file, index.to_string())?;
        let (result, seconds) = read(&input, &folder, &watch)?;
        figures.n_inputs += 1;
        figures.next = index + 1;
        figures.n_taken += u64::from(result == Ok(Verdict::Taken));
        if seconds > figures.slowest.0 {
            figures.slowest = (seconds, index);
        }
        figures.peak = figures.peak.max(watch::peak().unwrap_or(0));
        let is_large = figures.peak > watch::MEMORY_LIMIT;
        let defect = result
            .err()
            .or_else(|| is_large.then(|| watch::too_much(figures.peak)));
        let is_defect = defect.is_some();
        if let Some(defect) = defect {
            report(&Message::Defect { index, defect })?;
        }
        if is_defect || figures.n_inputs.is_multiple_of(PERIOD) {
            report(&Message::Figures(std::mem::take(&mut figures)))?;
            figures.next = index + 1;
        }
        if is_large {
            // The peak of a process does not come down: the next input is read by a new process.
            std::process::exit(3);
        }
    }
    report(&Message::Figures(figures))?;
    report(&Message::Done)
}

/// Reads one input: what became of it, and the CPU seconds that it took.
///
/// # Errors
/// The folder fails.
pub fn read(
    input: &Input,
    folder: &Path,
    watch: &Watch,
) -> io::Result<(Result<Verdict, Defect>, f64)> {
    let _ = fs::remove_dir_all(folder);
    fs::create_dir_all(folder)?;
    input.write(folder)?;
    watch.begin(input.target.time_limit());
    let result = catch_unwind(AssertUnwindSafe(|| targets::run(input, folder)));
    let seconds = watch.end();
    let panic = watch::take_panic();
    let result = result.unwrap_or_else(|_| {
        Err(panic.unwrap_or(Defect {
            kind: Kind::Panic,
            place: "unknown".into(),
            message: "a panic without words".into(),
        }))
    });
    Ok((result, seconds))
}

fn report(message: &Message) -> io::Result<()> {
    let mut line = serde_json::to_string(message)?;
    line.push('\n');
    let mut out = io::stdout().lock();
    out.write_all(line.as_bytes())?;
    out.flush()
}
