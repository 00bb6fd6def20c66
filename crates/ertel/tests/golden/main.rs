//! Golden records: small cases over the whole of the solver, with all that they gave when the records were written.
//!
//! ```text
//! cargo test --release -p ertel --test golden                        compare
//! cargo test --release -p ertel --test golden -- roller --skip tilt  some cases, by name
//! cargo test --release -p ertel --test golden -- --update            rewrite the records, and print the changes
//! ```
//!
//! Each `cases/NAME.toml` has its record `records/NAME.txt`, one value on a line: every figure with its bar and its place, what is not
//! resolved, the kinds of the warnings, balances, derivatives, the size of each mesh with its counts of iterations, and the fields at nine
//! points and summed over all of them. A refactoring leaves all of them as they are. A change of the numerics moves them, and the
//! difference of the records shows what it moved, and by how much.
//!
//! **Threads.** Each case is solved in a pool of one thread and in one of eight, and both must agree to the bit.
//!
//! **To the bit, or within bars.** Floats stand in the records in the fewest decimals that read back as the same bits, and are compared by
//! them. That holds only on a machine that computes like the one that wrote the record: the kernels of dense algebra are chosen by the
//! processor's vector instructions (AVX-512, or AVX2 with FMA, each summing in another order) and their blocks by its caches, and exp and
//! pow come from the system's library. Each record holds all this, `machine.rs`. On another machine sums are rounded otherwise, Newton's
//! method may need another iteration, and a mesh may be refined elsewhere. There figures must agree within a tenth of their error bars,
//! films within 1e-3 and other figures without a bar likewise, and nothing else is compared; the last lines of the output say so.

mod compare;
mod describe;
mod figures;
mod machine;
mod own;
mod record;
mod whole;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

use clap::Parser;
use compare::{Difference, Mode, difference};
use ertel::solution::{Figure, Section};
use libtest_mimic::{Arguments, Failed, Trial};
use machine::Machine;
use record::Record;

/// The options of Rust's own test programs, and one more.
#[derive(Parser)]
struct Options {
    #[command(flatten)]
    usual: Arguments,
    /// Rewrite the records instead of comparing with them, and print the changes
    #[arg(long)]
    update: bool,
}

/// State shared by the trials of a run.
struct Run {
    machine: Machine,
    update: bool,
    tally: Mutex<Tally>,
}

/// Outcomes of the cases.
#[derive(Default)]
struct Tally {
    exact: usize,
    within_bars: usize,
    other_machines: BTreeSet<String>,
    differ: Vec<String>,
    written: Vec<String>,
}

/// The folder of cases or of records.
fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/golden")
        .join(name)
}

/// The names of the files in a folder, without their ending.
fn names(folder: &Path, ending: &str) -> Result<BTreeSet<String>, String> {
    let entries = match std::fs::read_dir(folder) {
        Ok(entries) => entries,
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(BTreeSet::new()),
        Err(error) => return Err(format!("{}: {error}", folder.display())),
    };
    let mut names = BTreeSet::new();
    for entry in entries {
        let path = entry.map_err(|error| error.to_string())?.path();
        if path.extension().is_some_and(|own| own == ending)
            && let Some(stem) = path.file_stem()
        {
            names.insert(stem.to_string_lossy().into_owned());
        }
    }
    Ok(names)
}

impl Run {
    /// The record of a case as this program solves it, the same on one thread and on eight.
    fn solve(&self, name: &str) -> Result<Record, String> {
        let path = folder("cases").join(format!("{name}.toml"));
        let on = |threads: usize| {
            let pool = (rayon::ThreadPoolBuilder::new().num_threads(threads).build())
                .map_err(|error| format!("no pool of {threads} threads: {error}"))?;
            pool.install(|| describe::record(&path, &self.machine))
        };
        let (one, eight) = (on(1)?, on(8)?);
        let found = difference(&one, &eight, Mode::Exact);
        if !found.is_empty() {
            let title = format!("{name} differs on one thread and eight: {}", found.title());
            return Err(self.differs(title, &found));
        }
        Ok(one)
    }

    /// Compares a case with its record, or writes that.
    fn check(&self, name: &str) -> Result<(), String> {
        let path = folder("records").join(format!("{name}.txt"));
        let old = match std::fs::read_to_string(&path) {
            Ok(text) => {
                Some(Record::read(&text).map_err(|error| format!("{}: {error}", path.display()))?)
            }
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => None,
            Err(error) => return Err(format!("{}: {error}", path.display())),
        };
        let new = self.solve(name)?;
        if self.update {
            return self.write(name, &path, old.as_ref(), &new);
        }
        let old = old.ok_or_else(|| format!("{} is missing: run with --update", path.display()))?;
        let (mode, recorded) = self.machine.mode(&old);
        {
            let mut tally = self.tally.lock().map_err(|error| error.to_string())?;
            match mode {
                Mode::Exact => tally.exact += 1,
                Mode::WithinBars => {
                    tally.within_bars += 1;
                    tally.other_machines.insert(recorded);
                }
            }
        }
        let found = difference(&old, &new, mode);
        match found.is_empty() {
            true => Ok(()),
            false => {
                let title = format!("{name} differs from its record: {}", found.title());
                Err(self.differs(title, &found))
            }
        }
    }

    /// The text of a failure, whose first line is kept for the end.
    fn differs(&self, title: String, found: &Difference) -> String {
        let text = format!("{title}\n{}", found.text());
        if let Ok(mut tally) = self.tally.lock() {
            tally.differ.push(title);
        }
        text
    }

    fn write(
        &self,
        name: &str,
        path: &Path,
        old: Option<&Record>,
        new: &Record,
    ) -> Result<(), String> {
        let change = match old {
            Some(old) if old == new => return Ok(()),
            Some(old) => {
                let found = difference(old, new, Mode::Exact);
                match found.is_empty() {
                    true => format!("{name}: written for this machine, no value changed\n"),
                    false => format!("{name}: {}\n{}", found.title(), found.text()),
                }
            }
            None => format!("{name}: new, {} values\n", new.len()),
        };
        std::fs::create_dir_all(folder("records")).map_err(|error| error.to_string())?;
        std::fs::write(path, new.text(name))
            .map_err(|error| format!("{}: {error}", path.display()))?;
        let mut tally = self.tally.lock().map_err(|error| error.to_string())?;
        tally.written.push(change);
        Ok(())
    }

    /// Records without a case are errors, or are removed.
    fn no_record_without_case(&self) -> Result<(), String> {
        let cases = names(&folder("cases"), "toml")?;
        let records = names(&folder("records"), "txt")?;
        for name in records.difference(&cases) {
            let path = folder("records").join(format!("{name}.txt"));
            if !self.update {
                return Err(format!("{} has no case: remove it", path.display()));
            }
            std::fs::remove_file(&path).map_err(|error| format!("{}: {error}", path.display()))?;
            let mut tally = self.tally.lock().map_err(|error| error.to_string())?;
            tally.written.push(format!("{name}: record removed\n"));
        }
        Ok(())
    }

    /// Prints how records were compared, or what changed in them.
    fn sum_up(&self) {
        let Ok(tally) = self.tally.lock() else {
            return;
        };
        let sorted = |texts: &[String]| {
            let mut texts = texts.to_vec();
            texts.sort();
            texts
        };
        let changes = sorted(&tally.written);
        for text in &changes {
            print!("{text}");
        }
        for title in sorted(&tally.differ) {
            println!("{title}");
        }
        if self.update {
            println!("{} records written or removed", changes.len());
        }
        if tally.exact > 0 {
            println!("{} cases compared to the bit", tally.exact);
        }
        if tally.within_bars > 0 {
            println!(
                "{} cases compared within a tenth of their error bars only, counts and fields not at all, because their records come \
                 from a machine that computes otherwise:\n  this machine: {}",
                tally.within_bars, self.machine
            );
            for machine in &tally.other_machines {
                println!("  recorded on:  {machine}");
            }
        }
    }
}

/// The records hold every figure that there is, with its bar: a case is missing for one that none of them has.
fn every_figure_is_in_a_record() -> Result<(), String> {
    let mut keys = BTreeSet::new();
    for name in names(&folder("records"), "txt")? {
        let path = folder("records").join(format!("{name}.txt"));
        let text = std::fs::read_to_string(&path).map_err(|error| error.to_string())?;
        keys.extend(Record::read(&text)?.keys_in("figures"));
    }
    for figure in Figure::ALL {
        let mut needed = vec![figure.name().to_owned(), format!("{} bar", figure.name())];
        if figure.has_place() {
            needed.push(format!("{} x", figure.name()));
            // Places of stresses are points of a row.
            if figure.section() != Section::Stress {
                needed.push(format!("{} place bar", figure.name()));
            }
        }
        if let Some(missing) = needed.iter().find(|key| !keys.contains(*key)) {
            return Err(format!("no record has `{missing}`"));
        }
    }
    Ok(())
}

/// A trial of a function.
fn trial(
    name: impl Into<String>,
    run: impl FnOnce() -> Result<(), String> + Send + 'static,
) -> Trial {
    Trial::test(name, || run().map_err(Failed::from))
}

fn main() -> std::process::ExitCode {
    let options = Options::parse();
    let cases = match names(&folder("cases"), "toml") {
        Ok(cases) => cases,
        Err(error) => {
            eprintln!("error: {error}");
            return std::process::ExitCode::FAILURE;
        }
    };
    let run = Arc::new(Run {
        machine: Machine::this(),
        update: options.update,
        tally: Mutex::default(),
    });
    let mut trials: Vec<Trial> = (cases.into_iter())
        .map(|name| {
            let run = Arc::clone(&run);
            trial(name.clone(), move || run.check(&name))
        })
        .collect();
    let own = Arc::clone(&run);
    trials.push(trial("records::no_record_without_case", move || {
        own.no_record_without_case()
    }));
    if !options.update {
        trials.push(trial(
            "records::every_figure_is_in_a_record",
            every_figure_is_in_a_record,
        ));
    }
    trials.extend(own::trials());
    let conclusion = libtest_mimic::run(&options.usual, trials);
    if !options.usual.list {
        run.sum_up();
    }
    conclusion.exit_code()
}
