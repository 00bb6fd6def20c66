//! Cost of studies: `cargo bench -p ertel --bench sweeps`.
//!
//! The shipped studies, and a sample of their points as single cold cases on one thread: time of the
//! whole, of a point and of a cold case, and their ratio, all in one run on one machine. `-- --large N`: one study of N line
//! contacts, and how time, memory and journal grow with its points.

#[path = "common/clock.rs"]
mod clock;

use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

use clap::Parser;
use clock::{Clock, Seconds};
use ertel::case::Study;
use ertel::engine::NoObserver;
use ertel::run;
use ertel::study::plan::Plan;
use ertel::sweep::{SweepObserver, SweepParams, SweepProgress, sweep};

/// A hundred line contacts, twenty circular ones with heat, and a hundred without.
const STUDIES: [&str; 3] = [
    "speeds-and-loads",
    "glycerol-speeds-and-sliding",
    "ball-on-disc-speeds-and-loads",
];

/// Cost of studies.
#[derive(Parser)]
struct Args {
    /// Study files instead of the shipped ones
    studies: Vec<PathBuf>,
    /// Solve this many of the points as single cold cases, spread over the study
    #[arg(long, default_value = "6")]
    cold: NonZeroUsize,
    /// Points solved at the same time (default: as many as cores)
    #[arg(long)]
    jobs: Option<usize>,
    /// One study of this many line contacts (rounded to a square) instead of all
    #[arg(long)]
    large: Option<usize>,
    /// Given by cargo
    #[arg(long, hide = true)]
    bench: bool,
}

fn main() {
    let args = Args::parse();
    if let Some(n_points) = args.large {
        large(n_points, args.jobs);
        return;
    }
    let shipped = || {
        let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
        STUDIES.map(|name| cases.join(format!("{name}.toml")))
    };
    let studies = match args.studies.is_empty() {
        true => shipped().to_vec(),
        false => args.studies,
    };
    // Points and cold cases alike have one thread.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    let pool = pool.expect("a pool of one thread");
    println!(
        "| study | points | solved | wall s | CPU s | CPU s per point | CPU s of a cold case | point/cold case | cold points |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    for path in studies {
        let study = Study::read(&path).expect("a study");
        row(&path, &study, args.cold.get(), args.jobs, &pool);
    }
}

/// Runs a study, then some of its points one by one.
fn row(path: &Path, study: &Study, n_cold: usize, jobs: Option<usize>, pool: &rayon::ThreadPool) {
    let folder = tempfile::tempdir().expect("a folder for the study");
    let params = SweepParams {
        jobs,
        threads: Some(1),
        shard: None,
        folders: false,
        retry: false,
    };
    let clock = Clock::start();
    let summary = sweep(study, folder.path(), &params, &NoObserver).expect("a study");
    let whole = clock.seconds();
    let n_points = study.points.len();
    let n_cold = n_cold.min(n_points);
    // In the middle of equal parts of the list.
    let sample = (0..n_cold).map(|i| (2 * i + 1) * n_points / (2 * n_cold));
    let mut cold = Seconds::default();
    for i in sample {
        let clock = Clock::start();
        let solution = pool.install(|| run::solve(&study.points[i].case, &mut NoObserver));
        solution.expect("a shipped point converges");
        let time = clock.seconds();
        cold.wall += time.wall / n_cold as f64;
        cold.cpu += time.cpu / n_cold as f64;
    }
    let per_point = whole.cpu / n_points as f64;
    let plan = Plan::new(study);
    println!(
        "| {} | {n_points} | {} | {:.1} | {:.1} | {per_point:.3} | {:.3} | {:.2} | {} |",
        path.file_stem().unwrap_or_default().to_string_lossy(),
        n_points - summary.failures.len(),
        whole.wall,
        whole.cpu,
        cold.cpu,
        per_point / cold.cpu,
        plan.parents.iter().filter(|p| p.is_none()).count(),
    );
}

/// A study of line contacts over speed and load, to 1 %.
fn large(n_points: usize, jobs: Option<usize>) {
    let side = (n_points as f64).sqrt().round() as usize;
    let folder = tempfile::tempdir().expect("a folder for the study");
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    let path = folder.path().join("large.toml");
    std::fs::copy(cases.join("roller.toml"), folder.path().join("roller.toml")).expect("a copy");
    let axis = |key: &str, from: &str, to: &str| {
        format!(
            "[[axis]]\nkey = \"{key}\"\nfrom = \"{from}\"\nto = \"{to}\"\npoints = {side}\nspacing = \"log\"\n"
        )
    };
    let text = [
        "case = \"roller.toml\"\n".to_owned(),
        axis("motion.entrainment_speed", "0.2 m/s", "5 m/s"),
        axis("contact.load", "50 kN/m", "500 kN/m"),
        "[[axis]]\nkey = \"mesh.target_error\"\nvalues = [\"1 %\"]\n".to_owned(),
    ];
    std::fs::write(&path, text.concat()).expect("a study file");
    println!("| points | wall s | CPU s | points per wall s | memory MB | journal MB |");
    println!("|---|---|---|---|---|---|");
    let clock = Clock::start();
    let study = Study::read(&path).expect("a study");
    let results = folder.path().join("results");
    let growth = Growth {
        clock,
        every: (study.points.len() / 10).max(1),
        journal: results.join("journal.jsonl"),
    };
    growth.row(0);
    let params = SweepParams {
        jobs,
        threads: Some(1),
        ..SweepParams::default()
    };
    let summary = sweep(&study, &results, &params, &growth).expect("a study");
    growth.row(study.points.len());
    println!("\n{} failed", summary.failures.len());
}

/// Prints a row at each tenth of a study.
struct Growth {
    clock: Clock,
    every: usize,
    journal: PathBuf,
}

impl Growth {
    fn row(&self, n: usize) {
        let time = self.clock.seconds();
        let journal = std::fs::metadata(&self.journal).map_or(0, |meta| meta.len());
        println!(
            "| {n} | {:.1} | {:.1} | {:.1} | {} | {:.1} |",
            time.wall,
            time.cpu,
            n as f64 / time.wall,
            resident().map_or("-".to_owned(), |bytes| format!("{:.0}", bytes / 1e6)),
            journal as f64 / 1e6,
        );
    }
}

impl SweepObserver for Growth {
    fn finished(&self, progress: &SweepProgress<'_>) {
        if progress.n_finished.is_multiple_of(self.every) {
            self.row(progress.n_finished);
        }
    }
}

/// Memory in use, bytes, where the system reports it.
fn resident() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = text.lines().find(|line| line.starts_with("VmRSS:"))?;
    let kilobytes: f64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(1024.0 * kilobytes)
}
