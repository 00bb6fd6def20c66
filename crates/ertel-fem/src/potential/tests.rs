use super::*;
use crate::mesh::{SurfaceParams, surface_mesh};

/// A mesh with cells of very different size.
fn mesh(dim: usize) -> SimplexMesh {
    let params = SurfaceParams {
        dim,
        x: [-4.5, 1.5],
        y: [-3.0, 0.0],
    };
    let size = |x: [f64; 2]| {
        let r = x[0].hypot(x[1]);
        let fine = if dim == 1 { 0.01 } else { 0.08 };
        (fine + 0.8 * (r - 1.0).abs()).min(0.8)
    };
    surface_mesh(&params, &size).unwrap().mesh().clone()
}

fn density(points: &[[f64; 3]]) -> Vec<f64> {
    (points.iter())
        .map(|p| (1.0 - p[0] * p[0] - p[1] * p[1]).max(0.0).sqrt() + 0.1 * (5.0 * p[0]).sin())
        .collect()
}

fn targets(space: &Space) -> Vec<[f64; 2]> {
    space.points.iter().map(|p| [p[0], p[1]]).collect()
}

/// Every entry by closed forms.
pub(super) fn dense(
    mesh: &SimplexMesh,
    space: &Space,
    mirrored: bool,
    density: &[f64],
) -> Vec<f64> {
    let kernel = if mesh.dim == 1 {
        Kernel::Logarithm
    } else {
        Kernel::InverseDistance
    };
    let integrals = ElementIntegrals::new(&space.element, kernel);
    let sources = Sources::new(mesh, space, kernel, mirrored);
    let mut entries = vec![0.0; space.element.n_nodes()];
    let mut at = |x: [f64; 2]| {
        let mut sum = 0.0;
        for c in 0..mesh.n_cells() {
            integrals.at(sources.vertices(c), x, &mut entries);
            for (e, node) in entries.iter().zip(space.nodes_of(c)) {
                sum += e * density[*node as usize];
            }
        }
        sum
    };
    (targets(space).into_iter())
        .map(|x| at(x) + if mirrored { at([x[0], -x[1]]) } else { 0.0 })
        .collect()
}

pub(super) fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
    let scale = b.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
    a.iter()
        .zip(b)
        .fold(0.0, |m: f64, (x, y)| m.max((x - y).abs()))
        / scale
}

/// A mesh with cubic densities, and their potential.
fn example(dim: usize, mirrored: bool) -> (SimplexMesh, Space, Vec<f64>, Potential) {
    let mesh = mesh(dim);
    let space = Space::new(&mesh, 3);
    let p = density(&space.points);
    let params = PotentialParams::default();
    let potential = Potential::new(&mesh, &space, &targets(&space), mirrored, &params);
    (mesh, space, p, potential)
}

#[test]
fn equals_its_dense_twin() {
    for (dim, mirrored, full, krylov) in [
        (1, false, 1e-10, 1e-5),
        (2, true, 1e-7, 2e-5),
        (2, false, 1e-7, 2e-5),
    ] {
        let (mesh, space, p, potential) = example(dim, mirrored);
        let exact = dense(&mesh, &space, mirrored, &p);
        let error = |accuracy| largest_difference(&potential.apply(&p, accuracy), &exact);
        let (state, single) = (error(Accuracy::Full), error(Accuracy::Krylov));
        println!(
            "dim {dim} mirrored {mirrored}: {} nodes, {state:.1e} {single:.1e}",
            space.n_nodes()
        );
        assert!(state < full, "{state}");
        assert!(single < krylov, "{single}");
        // the tree is needed
        assert!(potential.tree.levels.len() > 3);
    }
}

#[test]
fn same_bits_on_any_number_of_threads() {
    let mesh = mesh(2);
    let space = Space::new(&mesh, 3);
    let p = density(&space.points);
    let results = [1, 3].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        pool.unwrap().install(|| {
            let params = PotentialParams::default();
            let potential = Potential::new(&mesh, &space, &targets(&space), true, &params);
            [Accuracy::Full, Accuracy::Krylov].map(|a| potential.apply(&p, a))
        })
    });
    assert_eq!(results[0], results[1]);
}

/// Far from the middle of a wide surface the potential of what is there is that of a point load. Small elements near a leaf of large ones
/// were integrated in closed form from a thousand diameters away, where nothing is left of cubic densities.
#[test]
fn far_nodes_of_a_wide_surface() {
    let params = SurfaceParams {
        dim: 2,
        x: [-363.0, 2.5],
        y: [-363.5, 0.0],
    };
    let size = |x: [f64; 2]| {
        let r = x[0].hypot(x[1]);
        0.02_f64.max(0.3 * r).min(60.0)
    };
    let mesh = surface_mesh(&params, &size).unwrap().mesh().clone();
    for order in [2, 3] {
        let space = Space::new(&mesh, order);
        let inside = |p: &[f64; 3]| (1.0 - p[0] * p[0] - p[1] * p[1]).max(0.0).sqrt();
        let p: Vec<f64> = space.points.iter().map(inside).collect();
        let t = targets(&space);
        let potential = Potential::new(&mesh, &space, &t, true, &PotentialParams::default());
        let found = potential.apply(&p, Accuracy::Full);
        // The whole load, 2π/3, from the middle: exact to (1/r)².
        let mut worst = 0.0_f64;
        for (x, v) in t.iter().zip(&found) {
            let r = x[0].hypot(x[1]);
            if r > 50.0 {
                let e = v * r / (2.0 * std::f64::consts::PI / 3.0) - 1.0;
                worst = worst.max(e.abs());
            }
        }
        println!("order {order} {} worst {worst:.1e}", t.len());
        assert!(worst < 0.02, "{worst}");
    }
}
