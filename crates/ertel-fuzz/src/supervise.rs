//! Runs workers, gathers what they find, starts a new one where one died.

use std::collections::HashMap;
use std::fs;
use std::io::{self, BufRead, BufReader};
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use crate::finding::{Defect, Kind, NOTE};
use crate::input::{Input, Target, scratch};
use crate::minimise::minimise;
use crate::seeds::Seeds;
use crate::worker::{Figures, Message, progress};

/// The requested run.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Seed of all inputs.
    pub seed: u64,
    /// Readers.
    pub targets: Vec<Target>,
    /// First input.
    pub from: u64,
    /// Inputs, at most.
    pub inputs: Option<u64>,
    /// Time, at most.
    pub time: Option<Duration>,
    /// Where findings go.
    pub output: PathBuf,
}

/// Result of the run.
#[derive(Clone, Debug, Default)]
pub struct Summary {
    /// Inputs read.
    pub n_inputs: u64,
    /// Of them, those that were taken.
    pub n_taken: u64,
    /// CPU seconds of the slowest, and which one.
    pub slowest: (f64, u64),
    /// Most memory of a worker, bytes.
    pub peak: u64,
    /// Different defects, with the number of inputs that show each.
    pub defects: Vec<(Defect, u64)>,
}

impl Summary {
    fn add(&mut self, figures: &Figures) {
        self.n_inputs += figures.n_inputs;
        self.n_taken += figures.n_taken;
        if figures.slowest.0 > self.slowest.0 {
            self.slowest = figures.slowest;
        }
        self.peak = self.peak.max(figures.peak);
    }

    /// Counts a defect; whether it is a new one.
    fn count(&mut self, defect: &Defect) -> bool {
        match self
            .defects
            .iter_mut()
            .find(|(known, _)| known.is_like(defect))
        {
            Some((_, n)) => {
                *n += 1;
                false
            }
            None => {
                self.defects.push((defect.clone(), 1));
                true
            }
        }
    }
}

/// Feeds inputs until the time or their number is over.
///
/// # Errors
/// Workers that cannot be started, folders that cannot be written.
pub fn supervise(seeds: &Seeds, plan: &Plan) -> io::Result<Summary> {
    let until = plan.time.map(|time| Instant::now() + time);
    let end = plan
        .inputs
        .map_or(u64::MAX, |n| plan.from.saturating_add(n));
    let mut summary = Summary::default();
    let mut next = plan.from;
    let folder = scratch()?;
    loop {
        let left = until.map(|until| until.saturating_duration_since(Instant::now()));
        if next >= end || left.is_some_and(|left| left.is_zero()) {
            return Ok(summary);
        }
        let mut command = Command::new(std::env::current_exe()?);
        command.arg("--worker").arg(folder.path());
        command.args([
            "--seed",
            &plan.seed.to_string(),
            "--from",
            &next.to_string(),
        ]);
        if end < u64::MAX {
            command.args(["--inputs", &(end - next).to_string()]);
        }
        if let Some(left) = left {
            command.args(["--seconds", &left.as_secs_f64().to_string()]);
        }
        for target in &plan.targets {
            command.args(["--target", &target.name()]);
        }
        // The output of an abort is reported as a finding.
        let mut worker = command
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()?;
        let mut found = HashMap::new();
        let mut done = false;
        if let Some(out) = worker.stdout.take() {
            for line in BufReader::new(out).lines() {
                match serde_json::from_str(&line?) {
                    Ok(Message::Figures(figures)) => {
                        next = next.max(figures.next);
                        summary.add(&figures);
                        eprintln!(
                            "{} inputs, {} defects",
                            summary.n_inputs,
                            summary.defects.len()
                        );
                    }
                    Ok(Message::Defect { index, defect }) => drop(found.insert(index, defect)),
                    Ok(Message::Done) => done = true,
                    Err(_) => {}
                }
            }
        }
        let status = worker.wait()?;
        if !done {
            let index = progress(folder.path()).unwrap_or(next);
            summary.n_inputs += index + 1 - next.min(index + 1);
            next = next.max(index + 1);
            found.entry(index).or_insert_with(|| Defect {
                kind: Kind::Abort,
                place: status.to_string(),
                message: format!("the process ended with {status}"),
            });
        }
        for (index, defect) in found {
            if summary.count(&defect) {
                let input = seeds.input(plan.seed, index, &plan.targets);
                report(plan, index, &defect, &input)?;
            }
        }
        if done {
            return Ok(summary);
        }
    }
}

/// Makes the input smaller and writes it, with the command that repeats it.
fn report(plan: &Plan, index: u64, defect: &Defect, input: &Input) -> io::Result<()> {
    let name = format!(
        "{}-{}-{}-{index}",
        input.target.name(),
        defect.kind.name(),
        plan.seed
    );
    let folder = plan.output.join(&name);
    eprintln!("{name}: {}", defect.message);
    let small = minimise(input, defect)?;
    fs::create_dir_all(&folder)?;
    small.write(&folder)?;
    let target = input.target.name();
    let command = format!(
        "cargo run --release -p ertel-fuzz -- --repeat {} --target {target}",
        folder.display()
    );
    let note = format!(
        "{}\n{}\n\n    {command}\n",
        defect.kind.name(),
        defect.message
    );
    fs::write(folder.join(NOTE), note)?;
    eprintln!("  {} of {} bytes; {command}", small.len(), input.len());
    Ok(())
}
