//! Cost of contacts: `cargo bench -p ertel`.
//!
//! The shipped cases as they are, the main contact at an error of 0.2 % and a line contact at
//! 0.1 %, each cold and with the elastic operator at hand; then the same discrete problems by the
//! condensed and by the monolithic path. Wall and CPU seconds, medians of several runs, with
//! their split, all in one run on one machine.

#[path = "common/mod.rs"]
mod common;

use std::path::{Path, PathBuf};

use clap::Parser;
use common::{Clock, Seconds, Stopwatch};
use ertel::case::Case;
use ertel::engine::NoObserver;
use ertel::params::{LinearSolver, SensitivityDemand};
use ertel::run::{solve, solve_from};
use ertel::solution::{Estimate, Solution, Timings};
use ertel::study::solve_curve;

/// Cost of contacts.
#[derive(Parser)]
struct Args {
    /// One run of each instead of medians of several
    #[arg(long)]
    once: bool,
    /// Leave out the shipped cases as they are
    #[arg(long)]
    targets: bool,
    /// A whole circular contact by the monolithic path, too: minutes
    #[arg(long)]
    monolithic: bool,
    /// Only shear thinning
    #[arg(long)]
    shear: bool,
    /// Only the curves
    #[arg(long)]
    curves: bool,
    /// Only the cost of sensitivities compared with a warm solve
    #[arg(long)]
    sensitivities: bool,
    /// Given by cargo
    #[arg(long, hide = true)]
    bench: bool,
}

fn main() {
    let args = Args::parse();
    let [few, many] = if args.once { [1, 1] } else { [3, 9] };
    if args.shear {
        println!("{HEAD}");
        shear_thinning(few);
        return;
    }
    if args.curves {
        curves();
        return;
    }
    if args.sensitivities {
        sensitivities(if args.once { 1 } else { 7 });
        return;
    }
    println!("{HEAD}");
    if !args.targets {
        measure("squalane-on-glass", &read("squalane-on-glass", ""), few);
        measure("roller", &read("roller", ""), many);
        println!();
    }
    let main_job = read("ball-on-disc", "[mesh]\ntarget_error = \"0.2 %\"\n");
    let cold = measure("ball-on-disc, 0.2 %", &main_job, few);
    against("(a) main job at 0.2 %, cold", cold, 2.0);
    let line = read("roller", "[mesh]\ntarget_error = \"0.1 %\"\n");
    let cold = measure("roller, 0.1 %", &line, many);
    against("(b) line contact at 0.1 %, cold", cold, 0.1);
    println!();
    monolithic_case("roller", &read("roller", "[mesh]\npreset = \"coarse\"\n"));
    if args.monolithic {
        monolithic_case("ball-on-disc at 10 N", &small());
    }
    shear_thinning(few);
    curves();
    for name in ["roller", "ball-on-disc"] {
        monolithic_iteration(name);
    }
}

const SPEEDS: &str = "[curve]\nquantity = \"motion.entrainment_speed\"\nfrom = \"0.4 m/s\"\nto = \"1.6 m/s\"\npoints = 10\nspacing = \"log\"";

/// A sliding shear-thinning contact over the same contact at its low-shear viscosity, on the same mesh.
fn shear_thinning(runs: usize) {
    let mut case = read("squalane-on-glass", "[mesh]\npreset = \"normal\"\n");
    case.motion.slide_to_roll_ratio = 0.3;
    let mut newtonian = case.clone();
    newtonian.solver.newtonian = true;
    let thinned = measure("squalane, SRR 0.3, normal", &case, runs);
    let plain = measure("  Newtonian", &newtonian, runs);
    println!(
        "(e) shear-thinning/Newtonian: {:.2} wall, {:.2} CPU; at most 2",
        thinned.wall / plain.wall,
        thinned.cpu / plain.cpu
    );
}

/// Curves of ten points: traction of a shear-thinning oil, and film over speed.
fn curves() {
    curve(
        "squalane, slide-to-roll ratio to 0.6",
        &read("squalane-traction", ""),
    );
    curve(
        "entrainment speed, 0.4 to 1.6 m/s",
        &read("ball-on-disc", SPEEDS),
    );
}

/// A curve over its contact alone from a cold start.
fn curve(name: &str, case: &Case) {
    let mut points = case.curve.clone().expect("a case with a curve");
    // The Newtonian curve is a second curve.
    points.newtonian = false;
    let clock = Clock::start();
    solve(case, &mut NoObserver).expect("a shipped case converges");
    let cold = clock.seconds();
    let clock = Clock::start();
    let curve = solve_curve(&points, &mut NoObserver);
    let time = clock.seconds();
    let solved = || curve.points.iter().filter_map(|p| p.outcome.solution());
    println!(
        "(d) {name}: {} of {} points, {} warm, {} Newton iterations; {:.3} s wall, {:.3} s CPU; of one cold case {:.2} wall, {:.2} CPU, of the curve's first point {:.2} wall; at most 4",
        solved().count(),
        curve.n_points,
        solved().filter(|s| s.stats.warm).count(),
        solved()
            .flat_map(|s| &s.stats.levels)
            .map(|l| l.newton_iterations)
            .sum::<usize>(),
        time.wall,
        time.cpu,
        time.wall / cold.wall,
        time.cpu / cold.cpu,
        time.wall / curve.points[0].seconds,
    );
}

/// A circular contact that a small mesh resolves.
fn small() -> Case {
    let mut case = read("ball-on-disc", "[solver]\nerror_estimate = false\n");
    case.contact.load = 10.0;
    case.mesh.hertz_size = 0.4;
    case.mesh.constriction_size = 0.3;
    case.mesh.edge_size = 1.0;
    case.mesh.depth_growth = 0.9;
    case.mesh.pressure_order = 2;
    case
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases")
}

/// A shipped case with more tables.
fn read(name: &str, tables: &str) -> Case {
    let path = folder().join(format!("{name}.toml"));
    let text = std::fs::read_to_string(&path).expect("a shipped case");
    let text = format!("{text}\n{tables}");
    let mut case = Case::from_text(name, &text, &folder()).expect("a valid case");
    case.output.body_field = false;
    case
}

const HEAD: &str = "case                          wall s   CPU s |  mesh operator assembly factors krylov other | newton krylov       U      P    ±hc  ±hmin";

/// Medians of several solves, printed with the split of the last.
fn measure(name: &str, case: &Case, runs: usize) -> Seconds {
    let mut times = Vec::new();
    let mut last = None;
    for _ in 0..runs {
        let clock = Clock::start();
        let solution = solve(case, &mut NoObserver);
        last = Some(solution.expect("a shipped case converges"));
        times.push(clock.seconds());
    }
    let time = median(times);
    row(name, time, &last.expect("at least one run"));
    time
}

fn median(times: Vec<Seconds>) -> Seconds {
    let middle = |value: fn(&Seconds) -> f64| {
        let mut values: Vec<f64> = times.iter().map(value).collect();
        values.sort_by(f64::total_cmp);
        values[values.len() / 2]
    };
    Seconds {
        wall: middle(|s| s.wall),
        cpu: middle(|s| s.cpu),
    }
}

fn row(name: &str, time: Seconds, solution: &Solution) {
    let levels = &solution.stats.levels;
    let seconds = |part: fn(&Timings) -> f64| levels.iter().map(|l| part(&l.seconds)).sum::<f64>();
    let bar = |e: Estimate| {
        e.error.map_or("      ".to_owned(), |b| {
            format!("{:5.2}%", 100.0 * b / e.value)
        })
    };
    let last = solution.stats.solved().expect("a solution");
    println!(
        "{name:<28} {:>7.3} {:>7.3} | {:>5.3} {:>8.3} {:>8.3} {:>7.3} {:>6.3} {:>5.3} | {:>6} {:>6} {:>7} {:>6} {} {}",
        time.wall,
        time.cpu,
        seconds(|s| s.mesh),
        seconds(|s| s.operator),
        seconds(|s| s.assembly),
        seconds(|s| s.factorisation),
        seconds(|s| s.krylov),
        seconds(|s| s.other),
        levels.iter().map(|l| l.newton_iterations).sum::<usize>(),
        levels.iter().map(|l| l.krylov_iterations).sum::<usize>(),
        last.n_displacement_dofs,
        last.n_pressure_dofs,
        bar(solution.summary.film_central),
        bar(solution.summary.film_minimum),
    );
}

/// A measured time compared with its target.
fn against(what: &str, time: Seconds, target: f64) {
    println!(
        "{what:<44} {:.3} s wall, {:.3} s CPU; at most {target} s: {:.2} of it",
        time.wall,
        time.cpu,
        time.wall / target
    );
}

/// A whole case on a small mesh by both paths.
fn monolithic_case(name: &str, case: &Case) {
    let mut case = case.clone();
    let condensed = measure(&format!("{name}, small"), &case, 3);
    case.solver.linear = LinearSolver::Monolithic;
    let monolithic = measure("  monolithic", &case, 1);
    println!(
        "(c) {name}, small mesh, whole case: monolithic/condensed {:.1} wall, {:.1} CPU",
        monolithic.wall / condensed.wall,
        monolithic.cpu / condensed.cpu
    );
}

/// Newton iterations of the first stage by both paths.
fn monolithic_iteration(name: &str) {
    let mut case = read(name, "");
    let mut times = Vec::new();
    for (linear, n) in [(LinearSolver::Condensed, 10), (LinearSolver::Monolithic, 3)] {
        case.solver.linear = linear;
        let mut watch = Stopwatch::stopping_after(n);
        // It ends by being stopped.
        let _ = solve(&case, &mut watch);
        let stage = &watch.stages[0];
        times.push((
            stage.n_displacement + stage.n_pressure,
            stage.per_iteration(),
        ));
    }
    let [(n, condensed), (_, monolithic)] = times[..] else {
        return;
    };
    println!(
        "(c) {name}, first stage, {n} unknowns, a Newton iteration: condensed {:.4} s ({:.4} CPU), \
         monolithic {:.3} s ({:.3} CPU); ratio {:.0} wall, {:.0} CPU",
        condensed.wall,
        condensed.cpu,
        monolithic.wall,
        monolithic.cpu,
        monolithic.wall / condensed.wall,
        monolithic.cpu / condensed.cpu
    );
}

/// A contact that starts from the solution under 1 % less load, with and without sensitivities, in turn: what they add.
fn sensitivities(runs: usize) {
    for name in ["ball-on-disc", "roller", "squalane-on-glass"] {
        let case = read(name, "");
        let (_, start) = solve_from(&case, None, &[], &mut NoObserver).expect("a shipped case");
        let load = case.inputs().iter().find(|i| i.key == "contact.load");
        let load = 1.01 * load.expect("a load").value;
        let next = case
            .with_values([("contact.load".to_owned(), load)].into())
            .expect("1 % more load");
        let mut seconds = [Vec::new(), Vec::new()];
        for _ in 0..runs {
            let demands = [SensitivityDemand::Off, SensitivityDemand::WhereCheap];
            for (demand, seconds) in demands.into_iter().zip(&mut seconds) {
                let mut next = next.clone();
                next.output.sensitivities = demand;
                let clock = std::time::Instant::now();
                let (solution, _) =
                    solve_from(&next, Some(&start), &[], &mut NoObserver).expect("a warm solve");
                seconds.push(clock.elapsed().as_secs_f64());
                assert!(solution.stats.warm);
            }
        }
        let [without, with] = seconds.map(|mut s| {
            s.sort_by(f64::total_cmp);
            s[s.len() / 2]
        });
        println!(
            "{name}: warm {without:.3} s, with sensitivities {with:.3} s: {:.0} % more; at most 30 %",
            100.0 * (with / without - 1.0)
        );
    }
}
