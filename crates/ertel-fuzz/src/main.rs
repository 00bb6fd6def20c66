//! Feeds ertel's readers with damaged input files: no panic, no hang, no heap of memory, and errors that say where.
//!
//!     cargo run --release -p ertel-fuzz -- --seconds 60
//!
//! Inputs are made from the shipped cases, studies and data and from the corpus of this crate, and numbered: the
//! same seed and number make the same input. How it works, and why so, stands in docs/decisions/0013.

#[allow(dead_code, reason = "messages are for the tests of the command")]
#[path = "../../ertel-cli/tests/bad/mod.rs"]
mod bad;
#[allow(dead_code)]
#[path = "../../ertel-cli/src/failure.rs"]
mod failure;
mod finding;
mod input;
mod minimise;
mod mutate;
mod seeds;
mod supervise;
mod targets;
mod watch;
mod worker;

use std::io;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::{Duration, Instant};

use clap::{Parser, ValueEnum};

use input::{Target, scratch};
use seeds::Seeds;
use supervise::{Plan, Summary, supervise};
use watch::Watch;
use worker::Job;

/// Feeds ertel's readers with damaged input files
#[derive(Debug, Parser)]
#[command(after_help = "Exit codes: 0 no defect, 1 defects, 2 wrong usage.")]
struct Args {
    /// Stop after this time
    #[arg(long, value_name = "S", value_parser = seconds)]
    seconds: Option<Duration>,
    /// Stop after this many inputs
    #[arg(long, value_name = "N")]
    inputs: Option<u64>,
    /// Which inputs
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Number of the first input
    #[arg(long, default_value_t = 0, value_name = "N")]
    from: u64,
    /// Readers to feed [default: all]
    #[arg(long, value_name = "NAME")]
    target: Vec<Target>,
    /// Folder for inputs that show a defect
    #[arg(long, default_value = "results/fuzz", value_name = "DIR")]
    output: PathBuf,
    /// Feed the files of a folder again, to the reader of `--target`
    #[arg(long, value_name = "DIR", requires = "target")]
    repeat: Option<PathBuf>,
    /// Work in this folder for another process of this command
    #[arg(long, hide = true)]
    worker: Option<PathBuf>,
    /// Show a repeated defect as JSON
    #[arg(long, hide = true)]
    json: bool,
}

fn seconds(text: &str) -> Result<Duration, String> {
    let seconds: f64 = text.parse().map_err(|error| format!("{error}"))?;
    Duration::try_from_secs_f64(seconds).map_err(|error| error.to_string())
}

fn main() -> ExitCode {
    match run(&Args::parse()) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Whether there was no defect.
fn run(args: &Args) -> io::Result<bool> {
    if let (Some(folder), [target]) = (&args.repeat, &args.target[..]) {
        return repeat(folder, *target, args.json);
    }
    let seeds = Seeds::read(&root())?;
    let targets = match args.target.is_empty() {
        true => Target::value_variants().to_vec(),
        false => args.target.clone(),
    };
    let time = match (args.seconds, args.inputs) {
        (None, None) => Some(Duration::from_secs(60)),
        (time, _) => time,
    };
    if let Some(folder) = &args.worker {
        let end = args
            .inputs
            .map_or(u64::MAX, |n| args.from.saturating_add(n));
        let job = Job {
            seed: args.seed,
            targets,
            range: args.from..end,
            time,
            folder: folder.clone(),
        };
        return worker::work(&seeds, &job).map(|()| true);
    }
    let clock = Instant::now();
    let plan = Plan {
        seed: args.seed,
        targets,
        from: args.from,
        inputs: args.inputs,
        time,
        output: args.output.clone(),
    };
    let summary = supervise(&seeds, &plan)?;
    print(&summary, clock.elapsed().as_secs_f64());
    Ok(summary.defects.is_empty())
}

fn print(summary: &Summary, seconds: f64) {
    println!(
        "{} inputs in {seconds:.0} s, {:.0} % of them taken; slowest {:.2} CPU s (input {}), memory {:.0} MB",
        summary.n_inputs,
        100.0 * summary.n_taken as f64 / (summary.n_inputs.max(1) as f64),
        summary.slowest.0,
        summary.slowest.1,
        summary.peak as f64 / 1e6
    );
    for (defect, n) in &summary.defects {
        println!("{n} x {}: {}", defect.kind.name(), defect.message);
    }
    println!("{} defects", summary.defects.len());
}

/// Reads the files of a folder again.
fn repeat(folder: &Path, target: Target, json: bool) -> io::Result<bool> {
    let input = seeds::read_folder(target, folder)?;
    let show = move |defect: &finding::Defect| match json {
        true => println!("{}", serde_json::to_string(defect).unwrap_or_default()),
        false => println!("{}: {}", defect.kind.name(), defect.message),
    };
    let watch = Watch::start(move |defect| {
        show(&defect);
        std::process::exit(1);
    });
    watch::keep_panics();
    let scratch = scratch()?;
    let (result, seconds) = worker::read(&input, scratch.path(), &watch)?;
    let result = match watch::peak() {
        Some(peak) if peak > watch::MEMORY_LIMIT && result.is_ok() => Err(watch::too_much(peak)),
        _ => result,
    };
    match result {
        Ok(verdict) => println!("{verdict:?} in {seconds:.3} CPU s"),
        Err(defect) => {
            show(&defect);
            return Ok(false);
        }
    }
    Ok(true)
}

/// The checkout that the seeds are taken from.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Former defects stay fixed: every input of the corpus is accepted or refused as it should be.
    #[test]
    fn the_corpus_shows_no_defect() {
        let folder = scratch().unwrap();
        let watch = Watch::start(|defect| panic!("{defect:?}"));
        let inputs = seeds::corpus(&root()).unwrap();
        assert!(inputs.len() > 20, "{}", inputs.len());
        for input in inputs {
            let (result, _) = worker::read(&input, folder.path(), &watch).unwrap();
            assert!(result.is_ok(), "{result:?} of {input:?}");
        }
    }
}
