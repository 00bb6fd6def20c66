//! Pressure orders at equal error: `cargo bench -p ertel --bench orders`.
//!
//! Each order is refined until the error bars of both films are within the target, or the unknowns are at their
//! limit. Unknowns of the last mesh, of all meshes together, Newton iterations, wall and CPU seconds, as a table in
//! markdown.

#[path = "common/clock.rs"]
mod clock;
#[path = "../tests/common/mod.rs"]
mod common;

use clap::{Parser, ValueEnum};
use clock::{Clock, Seconds};
use ertel::contact::ContactKind;
use ertel::engine::{Observer, SolveError};
use ertel::params::{DEFAULT_MAX_UNKNOWNS, MeshParams};
use ertel::run::solve;
use ertel::solution::{Estimate, Solution};

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Kind {
    Line,
    Circular,
}

/// Pressure orders at equal error.
#[derive(Parser)]
struct Args {
    /// Only line or only circular contacts
    #[arg(long)]
    kind: Option<Kind>,
    /// Only these pressure orders
    #[arg(long, value_delimiter = ',', default_values_t = [2, 3, 4, 5])]
    orders: Vec<usize>,
    /// Errors of both films to reach, per cent
    #[arg(long, value_delimiter = ',', default_values_t = [0.5, 0.2])]
    targets: Vec<f64>,
    /// Pressure unknowns that refinement may go to
    #[arg(long, default_value_t = DEFAULT_MAX_UNKNOWNS)]
    max_unknowns: usize,
    /// CPU seconds after which a solve is stopped
    #[arg(long)]
    limit: Option<f64>,
    /// Given by cargo
    #[arg(long, hide = true)]
    bench: bool,
}

/// Kind, M, L.
const CONTACTS: [(ContactKind, f64, f64); 3] = [
    (ContactKind::Line, 200.0, 10.0),
    (ContactKind::Line, 1000.0, 5.0),
    (ContactKind::Circular, 200.0, 10.0),
];

fn main() {
    let args = Args::parse();
    println!(
        "| contact | target | order | U | all U | P | Newton | CPU s | wall s | ±h_c | ±h_min | reached |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|---|---|");
    let asked = |kind: ContactKind| match args.kind {
        Some(Kind::Line) => kind == ContactKind::Line,
        Some(Kind::Circular) => kind == ContactKind::Circular,
        None => true,
    };
    for (kind, m, l) in CONTACTS.into_iter().filter(|c| asked(c.0)) {
        for target in &args.targets {
            for order in &args.orders {
                let mut case = common::moes_case(kind, m, l);
                case.mesh = MeshParams {
                    pressure_order: *order,
                    max_unknowns: Some(args.max_unknowns),
                    ..MeshParams::adaptive(0.01 * target, kind)
                };
                let mut limit = Limit {
                    clock: Clock::start(),
                    cpu: args.limit.unwrap_or(f64::INFINITY),
                };
                let outcome = solve(&case, &mut limit);
                let time = limit.clock.seconds();
                let kind_name = format!("{kind:?}").to_lowercase();
                println!(
                    "| {kind_name} M = {m}, L = {l} | {target} % | {order} | {} |",
                    columns(outcome, time, 0.01 * target)
                );
            }
        }
    }
}

/// Result and cost.
fn columns(outcome: Result<Solution, SolveError>, time: Seconds, target: f64) -> String {
    let seconds = format!("{:.2} | {:.2}", time.cpu, time.wall);
    let s = match outcome {
        Ok(s) => s,
        Err(e) => return format!("| | | | {seconds} | | | {e}"),
    };
    let levels = &s.stats.levels;
    let last = s.stats.solved().expect("a solution");
    let bar = |e: Estimate| e.error.map_or(f64::NAN, |error| error / e.value);
    let bars = [s.summary.film_central, s.summary.film_minimum].map(bar);
    format!(
        "{} | {} | {} | {} | {seconds} | {:.2} % | {:.2} % | {}",
        last.n_displacement_dofs,
        levels.iter().map(|l| l.n_displacement_dofs).sum::<usize>(),
        last.n_pressure_dofs,
        levels.iter().map(|l| l.newton_iterations).sum::<usize>(),
        100.0 * bars[0],
        100.0 * bars[1],
        if bars.iter().all(|b| *b <= target) {
            "yes"
        } else {
            "no"
        }
    )
}

/// Stops a solve that takes too long.
struct Limit {
    clock: Clock,
    cpu: f64,
}

impl Observer for Limit {
    fn cancelled(&self) -> bool {
        self.clock.seconds().cpu > self.cpu
    }
}
