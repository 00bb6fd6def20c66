//! Cost of whole machines: `cargo bench -p ertel --bench machines`.
//!
//! The shipped bearing, gear pair (without and with heat) and cam: wall and CPU time of all contacts in parallel, and of a sample of the different
//! contacts solved one by one from cold starts on one thread, all in one run on one machine. The ratio is the saving by the cores, the starts from neighbours and the merging of
//! identical contacts.

#[path = "common/clock.rs"]
mod clock;

use std::num::NonZeroUsize;
use std::path::Path;

use clap::Parser;
use clock::{Clock, Seconds};
use ertel::case::Case;
use ertel::engine::NoObserver;
use ertel::run;
use ertel::study::solve_machine;

/// Cases, each with settings.
const MACHINES: [(&str, &[&str]); 4] = [
    ("bearing-6206", &[]),
    ("fzg-c", &[]),
    ("fzg-c", &["thermal={}"]),
    ("cam-turn", &[]),
];

#[derive(Parser)]
struct Args {
    /// Solve this many of the different contacts by themselves, spread over the machine
    #[arg(long, default_value = "4")]
    cold: NonZeroUsize,
    /// Given by cargo
    #[arg(long, hide = true)]
    bench: bool,
}

fn main() {
    let args = Args::parse();
    println!(
        "| machine | contacts | different | wall s | CPU s | wall s of one contact | one by one/machine |"
    );
    println!("|---|---|---|---|---|---|---|");
    for (name, settings) in MACHINES {
        row(name, settings, args.cold.get());
    }
}

/// Solves a machine, then some of its contacts.
fn row(name: &str, settings: &[&str], cold: usize) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../cases/machine")
        .join(format!("{name}.toml"));
    let settings: Vec<String> = settings.iter().map(|s| (*s).to_owned()).collect();
    let text = std::fs::read_to_string(&path).expect("a shipped case");
    let case = Case::from_text_with(name, &text, Path::new(""), &settings).expect("a case");
    let contacts = case.contacts.as_ref().expect("a whole machine");
    let clock = Clock::start();
    let solution = solve_machine(contacts, &mut NoObserver);
    let whole = clock.seconds();
    assert_eq!(solution.n_failed(), 0, "{name}");
    let points = &contacts.study.points;
    let cold = cold.min(points.len());
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    let pool = pool.expect("a pool of one thread");
    let mut one = Seconds::default();
    for i in (0..cold).map(|i| (2 * i + 1) * points.len() / (2 * cold)) {
        let clock = Clock::start();
        let solved = pool.install(|| run::solve(&points[i].case, &mut NoObserver));
        solved.expect("a contact of a shipped case converges");
        one.wall += clock.seconds().wall / cold as f64;
    }
    let loaded = (contacts.machine.contacts.iter()).filter(|contact| contact.like.is_some());
    let n = loaded.count();
    println!(
        "| {name}{} | {n} | {} | {:.1} | {:.1} | {:.2} | {:.1} |",
        if settings.is_empty() { "" } else { ", heat" },
        points.len(),
        whole.wall,
        whole.cpu,
        one.wall,
        n as f64 * one.wall / whole.wall,
    );
}
