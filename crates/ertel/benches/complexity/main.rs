//! Complexity: time and memory over unknowns (Habchi 2008, Table 3.2 and Figure 3.6).
//!
//! `cargo bench -p ertel --bench complexity` solves the shipped line and circular contacts on finer
//! and finer meshes, each in a separate process, whose peak memory is that of the case. The
//! monolithic path is stopped after a few Newton iterations. `--largest` goes on to meshes that
//! take minutes and up to 8 GiB.

#[path = "../common/mod.rs"]
mod common;
mod report;

use std::path::{Path, PathBuf};
use std::process::Command;

use clap::Parser;
use common::{Clock, Stopwatch};
use ertel::case::Case;
use ertel::contact::ContactKind;
use ertel::params::{ElasticModel, LinearSolver, MeshParams};
use ertel::run::solve;
use serde::{Deserialize, Serialize};

/// Time and memory over unknowns.
#[derive(Parser)]
struct Args {
    /// The largest meshes, too: minutes each, up to 8 GiB
    #[arg(long)]
    largest: bool,
    /// Keep the points that the output folder has; measure only what is missing
    #[arg(long)]
    keep: bool,
    /// Only the first so many meshes of each kind
    #[arg(long)]
    meshes: Option<usize>,
    /// Folder of the results, from the root of the repository
    #[arg(long, default_value = "target/complexity")]
    output: PathBuf,
    /// One case, in this process: used by the command itself
    #[arg(long, hide = true, num_args = 2)]
    one: Option<Vec<String>>,
    /// Given by cargo
    #[arg(long, hide = true)]
    bench: bool,
}

/// The swept quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
enum Sweep {
    Line,
    Circular,
    CircularBody,
    LineMonolithic,
    CircularMonolithic,
}

impl Sweep {
    const ALL: [Sweep; 5] = [
        Sweep::Line,
        Sweep::Circular,
        Sweep::CircularBody,
        Sweep::LineMonolithic,
        Sweep::CircularMonolithic,
    ];

    fn name(self) -> &'static str {
        match self {
            Sweep::Line => "line",
            Sweep::Circular => "circular",
            Sweep::CircularBody => "circular-body",
            Sweep::LineMonolithic => "line-monolithic",
            Sweep::CircularMonolithic => "circular-monolithic",
        }
    }

    fn is_monolithic(self) -> bool {
        matches!(self, Sweep::LineMonolithic | Sweep::CircularMonolithic)
    }

    fn kind(self) -> ContactKind {
        match self {
            Sweep::Line | Sweep::LineMonolithic => ContactKind::Line,
            Sweep::Circular | Sweep::CircularBody | Sweep::CircularMonolithic => {
                ContactKind::Circular
            }
        }
    }

    /// Factors on the cell sizes of the default mesh; those of the second list with `--largest`.
    fn factors(self) -> (&'static [f64], &'static [f64]) {
        match self {
            Sweep::Line => (&[8.0, 4.0, 2.0, 1.0, 0.5, 0.25, 0.125, 0.0625], &[0.03125]),
            Sweep::Circular => (&[1.0, 0.7, 0.5, 0.35, 0.25, 0.18, 0.13], &[0.09]),
            Sweep::CircularBody => (&[5.0, 2.8, 2.0, 1.4, 1.0], &[0.7, 0.5]),
            Sweep::LineMonolithic => (&[8.0, 4.0, 2.0, 1.0, 0.5, 0.25, 0.125], &[0.0625]),
            Sweep::CircularMonolithic => (&[4.0, 2.8, 2.0], &[1.6, 1.2]),
        }
    }
}

/// Cost of a mesh.
#[derive(Clone, Debug, Serialize, Deserialize)]
struct Point {
    sweep: Sweep,
    factor: f64,
    /// Unknowns of the last stage.
    n_displacement: usize,
    n_pressure: usize,
    /// Seconds per Newton iteration of that stage.
    iteration_wall: f64,
    iteration_cpu: f64,
    /// Seconds of the whole case; none where it was stopped.
    case_wall: Option<f64>,
    case_cpu: Option<f64>,
    newton: Option<usize>,
    /// Wall seconds that the elastic operator of the last stage takes to build, and a Krylov iteration there.
    operator: Option<f64>,
    krylov: Option<f64>,
    /// Peak resident memory, bytes.
    memory: Option<u64>,
}

impl Point {
    fn unknowns(&self) -> f64 {
        (self.n_displacement + self.n_pressure) as f64
    }
}

fn main() {
    let args = Args::parse();
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    if let Some(one) = &args.one {
        let sweep = Sweep::ALL.into_iter().find(|s| s.name() == one[0]);
        let point = measure(
            &root,
            sweep.expect("a sweep"),
            one[1].parse().expect("a factor"),
        );
        println!("{}", serde_json::to_string(&point).expect("plain data"));
        return;
    }
    let folder = root.join(&args.output);
    let file = folder.join("complexity.json");
    let mut points = if args.keep { read(&file) } else { Vec::new() };
    println!("{}", report::HEAD);
    points.iter().for_each(|p| println!("{}", report::line(p)));
    for sweep in Sweep::ALL {
        let (usual, largest) = sweep.factors();
        let more = if args.largest { largest } else { &[] };
        let factors = usual.iter().chain(more);
        for factor in factors.take(args.meshes.unwrap_or(usize::MAX)) {
            if points
                .iter()
                .any(|p| p.sweep == sweep && p.factor == *factor)
            {
                continue;
            }
            match in_separate_process(sweep, *factor) {
                Ok(point) => {
                    println!("{}", report::line(&point));
                    points.push(point);
                }
                Err(message) => println!("{} {factor}: {message}", sweep.name()),
            }
        }
    }
    points.sort_by(|a, b| b.factor.total_cmp(&a.factor));
    let text = report::markdown(&points);
    println!("\n{text}");
    let data = serde_json::to_string_pretty(&points).expect("plain data");
    let written = std::fs::create_dir_all(&folder)
        .and_then(|()| std::fs::write(file, data))
        .and_then(|()| std::fs::write(folder.join("complexity.md"), text))
        .and_then(|()| std::fs::write(folder.join("complexity.svg"), report::svg(&points)));
    match written {
        Ok(()) => println!("complexity.json, .md and .svg in {}", folder.display()),
        Err(error) => println!("cannot write into {}: {error}", folder.display()),
    }
}

/// Points of an earlier run; none if there are none.
fn read(file: &Path) -> Vec<Point> {
    let text = std::fs::read_to_string(file).unwrap_or_default();
    serde_json::from_str(&text).unwrap_or_default()
}

fn in_separate_process(sweep: Sweep, factor: f64) -> Result<Point, String> {
    let program = std::env::current_exe().map_err(|e| e.to_string())?;
    let output = Command::new(program)
        .args(["--one", sweep.name(), &factor.to_string()])
        .output()
        .map_err(|e| e.to_string())?;
    let failure = || String::from_utf8_lossy(&output.stderr).trim().to_owned();
    serde_json::from_slice(&output.stdout).map_err(|_| failure())
}

/// Largest cells of the contact area, in half-widths.
const LARGEST_CELL: f64 = 2.0;

/// Fastest growth of cells away from it, per distance.
const FASTEST_GROWTH: f64 = 2.0;

/// Newton iterations after which a monolithic run is stopped.
const MONOLITHIC_ITERATIONS: usize = 4;

fn measure(root: &Path, sweep: Sweep, factor: f64) -> Point {
    let name = match sweep.kind() {
        ContactKind::Line => "roller.toml",
        ContactKind::Circular | ContactKind::Elliptical | ContactKind::Roller => {
            "ball-on-disc.toml"
        }
    };
    let mut case = Case::read(&root.join("cases").join(name)).expect("a shipped case");
    case.mesh = MeshParams::preset(Default::default(), sweep.kind());
    // The first stage, where a monolithic run is stopped, has cells twice as large.
    let factor_here = if sweep.is_monolithic() {
        case.solver.linear = LinearSolver::Monolithic;
        0.5 * factor
    } else {
        factor
    };
    case.mesh.hertz_size *= factor_here;
    case.mesh.constriction_size *= factor_here;
    if factor_here > 1.0 {
        // The film's own length at the rim would keep coarse meshes from becoming any coarser.
        case.mesh.rim_size = Some(case.mesh.hertz_size);
    }
    case.mesh.edge_size = (case.mesh.edge_size * factor_here).min(LARGEST_CELL);
    let growth = factor_here.sqrt();
    case.mesh.growth = (case.mesh.growth * growth).min(FASTEST_GROWTH);
    case.mesh.depth_growth = (case.mesh.depth_growth * growth).min(FASTEST_GROWTH);
    case.output.body_field = false;
    if sweep == Sweep::CircularBody {
        case.solver.elasticity = Some(ElasticModel::Equivalent);
    }
    let mut watch = if sweep.is_monolithic() {
        Stopwatch::stopping_after(MONOLITHIC_ITERATIONS)
    } else {
        Stopwatch::default()
    };
    let clock = Clock::start();
    let outcome = solve(&case, &mut watch);
    let seconds = clock.seconds();
    // A mesh too coarse for convergence still shows the cost of an iteration.
    let solution = outcome.ok();
    let stage = watch.stages.last().expect("a stage");
    let iteration = stage.per_iteration();
    let last = solution.as_ref().and_then(|s| s.stats.levels.last());
    Point {
        sweep,
        factor,
        n_displacement: stage.n_displacement,
        n_pressure: stage.n_pressure,
        iteration_wall: iteration.wall,
        iteration_cpu: iteration.cpu,
        case_wall: solution.as_ref().map(|_| seconds.wall),
        case_cpu: solution.as_ref().map(|_| seconds.cpu),
        newton: solution
            .as_ref()
            .map(|s| s.stats.levels.iter().map(|l| l.newton_iterations).sum()),
        operator: last.map(|l| l.seconds.operator),
        krylov: last.map(|l| l.seconds.krylov / l.krylov_iterations as f64),
        memory: peak_memory(),
    }
}

/// Peak resident memory of this process, bytes, where Linux reports it.
fn peak_memory() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|l| l.starts_with("VmHWM:"))?;
    let kib: u64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(1024 * kib)
}
