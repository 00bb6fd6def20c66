use super::*;
use crate::mesh::{SurfaceParams, surface_mesh};
use std::time::Instant;

#[test]
#[ignore]
fn timing() {
    for fine in [0.15f64, 0.08, 0.04] {
        let params = SurfaceParams {
            dim: 2,
            x: [-4.5, 1.5],
            y_side: 3.0,
        };
        let size = |x: [f64; 2]| {
            let r = x[0].hypot(x[1]);
            let ring = 0.3 * fine + 0.9 * ((r - 1.0).abs() - 0.05).max(0.0);
            let zone = if r < 1.0 {
                fine
            } else {
                fine + 0.9 * (r - 1.0)
            };
            ring.min(zone).min(0.5)
        };
        let mesh = surface_mesh(&params, &size).unwrap().mesh().clone();
        let space = Space::new(&mesh, 3);
        let targets: Vec<[f64; 2]> = space.points.iter().map(|p| [p[0], p[1]]).collect();
        let p: Vec<f64> = space
            .points
            .iter()
            .map(|p| (1.0 - p[0] * p[0] - p[1] * p[1]).max(0.0).sqrt())
            .collect();
        for (per_box, degrees) in [
            (8, [9, 6]),
            (8, [10, 7]),
            (8, [11, 7]),
            (16, [10, 7]),
            (16, [10, 6]),
        ] {
            let params = PotentialParams {
                elements_per_box: per_box,
                surface_degrees: degrees,
                ..Default::default()
            };
            let t = Instant::now();
            let a = Potential::new(&mesh, &space, &targets, true, &params);
            let build = t.elapsed().as_secs_f64();
            let time = |f: &dyn Fn()| {
                let mut best = f64::INFINITY;
                for _ in 0..10 {
                    let t = Instant::now();
                    f();
                    best = best.min(t.elapsed().as_secs_f64());
                }
                best
            };
            let full = time(&|| {
                a.apply(&p, Accuracy::Full);
            });
            let kry = time(&|| {
                a.apply(&p, Accuracy::Krylov);
            });
            let tr = time(&|| {
                a.apply_transposed(&p, Accuracy::Krylov);
            });
            let rows = targets.len();
            let links: usize = a.forward.iter().map(Vec::len).sum();
            let errors = if fine > 0.1 {
                let d = super::tests::dense(&mesh, &space, true, &p);
                let e = |acc| super::tests::largest_difference(&a.apply(&p, acc), &d);
                [e(Accuracy::Full), e(Accuracy::Krylov)]
            } else {
                [0.0; 2]
            };
            println!(
                "{fine} box {per_box} degrees {degrees:?}: {} elements {rows} nodes: build {build:.3} full {:.2} ms krylov {:.2} ms transposed {:.2} ms; {:.1} MB near {:.1} ({:.0} per row) full {:.1} krylov {:.1}; cells {} links {} errors {:.1e} {:.1e}",
                mesh.n_cells(),
                full * 1e3,
                kry * 1e3,
                tr * 1e3,
                a.bytes() as f64 / 1e6,
                a.near.bytes() as f64 / 1e6,
                a.near.bytes() as f64 / 4.0 / rows as f64,
                a.full.bytes() as f64 / 1e6,
                a.krylov.bytes() as f64 / 1e6,
                a.tree.cells.len(),
                links,
                errors[0],
                errors[1]
            );
        }
    }
}
