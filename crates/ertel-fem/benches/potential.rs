//! Potentials of densities on graded surface meshes: `cargo bench -p ertel-fem --bench potential -- --largest 200000`.
//!
//! Nodes, seconds to build, milliseconds of products (least of several), megabytes and near entries per row, from
//! 5,000 nodes on; then the exponents of their growth, fitted by least squares.

use std::hint::black_box;
use std::time::Instant;

use ertel_fem::mesh::{SimplexMesh, SurfaceParams, surface_mesh};
use ertel_fem::potential::{Accuracy, Potential, PotentialParams};
use ertel_fem::space::Space;

/// Order of the density.
const ORDER: usize = 3;
/// Sizes of the finest cells, in radii of the loaded disc, about a factor 1.4 from one to the next.
const SIZES: [f64; 9] = [0.4, 0.28, 0.2, 0.14, 0.1, 0.07, 0.05, 0.035, 0.025];
const NAMES: [&str; 4] = ["build s", "full ms", "krylov ms", "MB"];

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let largest = (arguments.iter().position(|a| a == "--largest")).map_or(100_000, |k| {
        arguments[k + 1].parse().expect("a number of nodes")
    });
    println!("| nodes | {} | near per row |", NAMES.join(" | "));
    println!("|---:|---:|---:|---:|---:|---:|");
    let mut rows: Vec<(f64, [f64; 4])> = Vec::new();
    for size in SIZES {
        let mesh = graded(size);
        let space = Space::new(&mesh, ORDER);
        let nodes = space.n_nodes();
        if nodes < 5_000 {
            continue;
        }
        if nodes > largest {
            break;
        }
        let (values, near) = measured(&mesh, &space);
        let texts: Vec<String> = values.iter().map(|v| format!("{v:.3}")).collect();
        println!("| {nodes} | {} | {near:.0} |", texts.join(" | "));
        rows.push((nodes as f64, values));
    }
    if rows.len() > 1 {
        let exponents = (0..NAMES.len()).map(|k| {
            let points: Vec<[f64; 2]> = (rows.iter())
                .map(|(n, values)| [n.ln(), values[k].ln()])
                .collect();
            format!("{:.2}", slope(&points))
        });
        let exponents: Vec<String> = exponents.collect();
        println!("| exponent | {} | |", exponents.join(" | "));
    }
}

/// A contact area with a fine loaded disc and a finer ring at its edge.
fn graded(fine: f64) -> SimplexMesh {
    let params = SurfaceParams {
        dim: 2,
        x: [-4.5, 1.5],
        y: [-3.0, 0.0],
    };
    let size = |x: [f64; 2]| {
        let r = x[0].hypot(x[1]);
        let ring = 0.3 * fine + 0.9 * ((r - 1.0).abs() - 0.05).max(0.0);
        let zone = fine + 0.9 * (r - 1.0).max(0.0);
        ring.min(zone).min(0.5)
    };
    let mesh = surface_mesh(&params, &size).expect("the sizes are positive");
    mesh.mesh().clone()
}

fn measured(mesh: &SimplexMesh, space: &Space) -> ([f64; 4], f64) {
    let targets: Vec<[f64; 2]> = space.points.iter().map(|p| [p[0], p[1]]).collect();
    let density: Vec<f64> = (targets.iter())
        .map(|[x, y]| (1.0 - x * x - y * y).max(0.0).sqrt())
        .collect();
    let params = PotentialParams::default();
    let build = || Potential::new(mesh, space, &targets, true, &params);
    let potential = build();
    let milli = |v: f64| 1e3 * v;
    let values = [
        least(3, || drop(black_box(build()))),
        milli(least(10, || {
            black_box(potential.apply(&density, Accuracy::Full));
        })),
        milli(least(20, || {
            black_box(potential.apply(&density, Accuracy::Krylov));
        })),
        potential.bytes() as f64 / 1e6,
    ];
    let near = potential.near_entries() as f64 / targets.len() as f64;
    (values, near)
}

/// Least seconds of several runs.
fn least(runs: usize, mut run: impl FnMut()) -> f64 {
    (0..runs)
        .map(|_| {
            let start = Instant::now();
            run();
            start.elapsed().as_secs_f64()
        })
        .fold(f64::INFINITY, f64::min)
}

/// Slope of the straight line through points by least squares.
fn slope(points: &[[f64; 2]]) -> f64 {
    let n = points.len() as f64;
    let mean = [0, 1].map(|a: usize| points.iter().map(|p| p[a]).sum::<f64>() / n);
    let products = |b: usize| -> f64 {
        (points.iter())
            .map(|p| (p[0] - mean[0]) * (p[b] - mean[b]))
            .sum()
    };
    products(1) / products(0)
}
