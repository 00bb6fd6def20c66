//! What the shipped cases cost: `cargo bench -p ertel`.
//!
//! Wall seconds (median of the runs) with their split, and the ratio of the monolithic to the
//! condensed path on the same discrete problem, all in one run on one machine.

use std::path::Path;
use std::time::Instant;

use ertel::case::Case;
use ertel::params::LinearSolver;
use ertel::run::solve;
use ertel::solution::{Solution, Timings};
use ertel::solve::Silent;

fn main() {
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    let read = |name: &str| Case::read(&cases.join(name)).expect("a shipped case");

    println!(
        "case            runs   wall s    mesh  operator  assembly  factors  krylov   newton  krylov its"
    );
    for (name, runs) in [
        ("ball-on-disc", 3),
        ("squalane-on-glass", 3),
        ("roller", 15),
    ] {
        let (wall, solution) = measure(&read(&format!("{name}.toml")), runs);
        row(name, runs, wall, &solution);
    }

    let mut case = read("roller.toml");
    case.mesh.hertz_size = 0.05;
    case.mesh.constriction_size = 0.02;
    let (condensed, solution) = measure(&case, 5);
    row("roller, coarse", 5, condensed, &solution);
    case.solver.linear = LinearSolver::Monolithic;
    let (monolithic, solution) = measure(&case, 5);
    row("  monolithic", 5, monolithic, &solution);
    println!(
        "monolithic/condensed, roller on the coarse mesh: {:.1}",
        monolithic / condensed
    );
}

/// Median wall seconds of several solves, and the last solution.
fn measure(case: &Case, runs: usize) -> (f64, Solution) {
    let mut walls = Vec::new();
    let mut last = None;
    for _ in 0..runs {
        let clock = Instant::now();
        last = Some(solve(case, &mut Silent).expect("a shipped case converges"));
        walls.push(clock.elapsed().as_secs_f64());
    }
    walls.sort_by(f64::total_cmp);
    (walls[runs / 2], last.expect("at least one run"))
}

fn row(name: &str, runs: usize, wall: f64, solution: &Solution) {
    let levels = &solution.stats.levels;
    let seconds = |part: fn(&Timings) -> f64| levels.iter().map(|l| part(&l.seconds)).sum::<f64>();
    println!(
        "{name:<15} {runs:>4} {wall:>8.3} {:>7.3} {:>9.3} {:>9.3} {:>8.3} {:>7.3} {:>8} {:>11}",
        seconds(|s| s.mesh),
        seconds(|s| s.operator),
        seconds(|s| s.assembly),
        seconds(|s| s.factorisation),
        seconds(|s| s.krylov),
        levels.iter().map(|l| l.newton_iterations).sum::<usize>(),
        levels.iter().map(|l| l.krylov_iterations).sum::<usize>(),
    );
}
