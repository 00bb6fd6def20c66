//! Loads on nodes and grids against closed forms.

use super::super::rectangle::corner;
use super::super::sphere::smallest_sphere;
use super::super::{
    Depths, GridLoad, Hardness, HertzLoad, LineLoad, Load, Planes, Response, Stress,
};
use super::{hertz_line, passage, worst};
use crate::contact::Material;
use crate::layers::{Coated, Plane};

/// A body without layers at depths.
fn bare(poissons_ratio: f64, depths: &[f64]) -> Response {
    let substrate = Material {
        youngs_modulus: 1.0,
        poissons_ratio,
    };
    let layers = Vec::new();
    let plane = |depth: &f64| Plane {
        depth: *depth,
        part: 0,
    };
    let planes: Vec<Plane> = depths.iter().map(plane).collect();
    Response::at(&Coated { layers, substrate }, &planes, 1.0)
}

/// The Hertz pressure of an ellipse with a shear along x and along y, as means over the cells of a grid.
pub(super) fn hertz_grid(n: [usize; 2], ratio: f64, friction: [f64; 2]) -> GridLoad {
    let centres = [0, 1].map(|axis: usize| {
        let reach = [1.6, 1.6 * ratio][axis] * (1.0 - 1.0 / n[axis] as f64);
        passage(reach, n[axis] - 1)
    });
    let half = [0, 1].map(|axis: usize| 0.5 * (centres[axis][1] - centres[axis][0]));
    let parts = 8;
    let within = passage(1.0 - 1.0 / parts as f64, parts - 1);
    let pressure: Vec<f64> = (centres[1].iter())
        .flat_map(|y| centres[0].iter().map(move |x| [*x, *y]))
        .map(|[x, y]| {
            let sum: f64 = (within.iter())
                .flat_map(|s| within.iter().map(move |t| [*s, *t]))
                .map(|[s, t]| [x + s * half[0], (y + t * half[1]) / ratio])
                .map(|[x, y]| (1.0 - x * x - y * y).max(0.0).sqrt())
                .sum();
            sum / (parts * parts) as f64
        })
        .collect();
    let shear = friction.map(|mu| pressure.iter().map(|p| mu * p).collect());
    let [x, y] = shear;
    GridLoad {
        centres,
        values: [pressure, x, y],
    }
}

/// Stress at a point, z ≥ 0, by the sum over the corners of all cells.
fn direct(load: &GridLoad, [x, y, z]: [f64; 3], poisson: f64) -> Stress {
    let ([nx, ny], [dx, dy]) = (load.n(), load.spacing());
    let value = |which: usize, i: usize, j: usize| match i < nx && j < ny {
        true => load.values[which][j * nx + i],
        false => 0.0,
    };
    let mut sum = [0.0; 6];
    for j in 0..=ny {
        for i in 0..=nx {
            // The load that begins at this corner, less its neighbours; indices below zero are beyond the grid, too.
            let (before, below) = (i.wrapping_sub(1), j.wrapping_sub(1));
            let jump = [0, 1, 2].map(|which| {
                value(which, i, j) - value(which, before, j) - value(which, i, below)
                    + value(which, before, below)
            });
            if jump == [0.0; 3] {
                continue;
            }
            let from = [
                x - load.centres[0][0] - (i as f64 - 0.5) * dx,
                y - load.centres[1][0] - (j as f64 - 0.5) * dy,
            ];
            let parts = corner(from[0], from[1], z, poisson);
            for (jump, part) in jump.iter().zip(parts) {
                for (sum, part) in sum.iter_mut().zip(part) {
                    *sum += jump * part;
                }
            }
        }
    }
    Stress(sum)
}

/// A load that is linear between nodes: the tent of two elements by its integrals, at the surface and below, by adaptive quadrature of Flamant's point loads.
#[test]
fn linear_loads_between_nodes() {
    let load = LineLoad::new(
        vec![-1.0, 0.5, 1.0],
        vec![[0.2, 0.0], [1.0, -0.3], [0.0, 0.4]],
    );
    for (x, z) in [(0.3, 0.2), (-1.4, 0.7), (2.0, 3.0), (0.5, 0.05)] {
        let mut sum = [0.0; 3];
        let n = 400_000;
        for (from, to, f, g) in [
            (-1.0, 0.5, [0.2, 0.0], [1.0, -0.3]),
            (0.5, 1.0, [1.0, -0.3], [0.0, 0.4]),
        ] {
            for i in 0..n {
                let t = (f64::from(i) + 0.5) / f64::from(n);
                let (s, ds) = (from + t * (to - from), (to - from) / f64::from(n));
                let [p, q] = [0, 1].map(|k: usize| f[k] + t * (g[k] - f[k]));
                let (dx, r2) = (x - s, (x - s).powi(2) + z * z);
                // σ_r = −2/(π r²) (p z + q X), along r.
                let radial = -2.0 / std::f64::consts::PI * (p * z + q * dx) / (r2 * r2) * ds;
                for (sum, part) in sum.iter_mut().zip([dx * dx, z * z, dx * z]) {
                    *sum += radial * part;
                }
            }
        }
        let found = load.at(x, z, 0.25).0;
        let [xx, zz, xz] = sum;
        let known = [xx, 0.25 * (xx + zz), zz, 0.0, xz, 0.0];
        let deviation = worst((0..6).map(|i| found[i] - known[i]));
        assert!(deviation < 1e-8, "{deviation:.1e} at {x} {z}");
    }
    let surface = load.at(-0.25, 0.0, 0.3).0;
    assert!((surface[2] + 0.6).abs() < 1e-14 && (surface[4] - 0.15).abs() < 1e-14);
}

#[test]
fn line_on_nodes() {
    let (exact, load) = (
        HertzLoad {
            half_width: 1.0,
            half_width_y: None,
            pressure: 1.0,
            friction: 0.3,
            poisson: 0.3,
        },
        hertz_line(0.3),
    );
    let places = passage(1.5, 61);
    let deviation = worst((places.iter()).flat_map(|x| {
        [0.0, 0.02, 0.3, 1.0].map(|z| {
            let difference = load.at(*x, z, 0.3) - exact.at(*x, 0.0, z);
            worst(difference.0)
        })
    }));
    println!("line on 401 nodes: {deviation:.1e}");
    assert!(deviation < 1e-4);
}

/// Transforms and sums over all corners are the same; at the surface the tractions are the loads.
#[test]
fn planes_are_sums() {
    let load = hertz_grid([21, 12], 1.7, [0.2, -0.1]);
    let depths = [0.0, 1e-9, 0.1, 1.3];
    let response = bare(0.28, &depths);
    let planes = Planes::new(&load, &response);
    for (plane, z) in depths.into_iter().enumerate() {
        let found = planes.at(plane);
        let mut deviation = 0.0;
        for (cell, stress) in found.iter().enumerate() {
            let (i, j) = (cell % 21, cell / 21);
            let place = [load.centres[0][i], load.centres[1][j], z];
            deviation = worst([deviation, worst((*stress - direct(&load, place, 0.28)).0)]);
            if z == 0.0 {
                let [p, x, y] = [0, 1, 2].map(|which: usize| load.values[which][cell]);
                deviation = worst([deviation, stress.0[2] + p, stress.0[4] + x, stress.0[5] + y]);
            }
        }
        assert!(deviation < 1e-12, "{deviation:.1e} at {z}");
    }
}

/// On grids of half the spacing the differences from the exact field fall.
#[test]
fn ellipse_on_grids() {
    let exact = HertzLoad {
        half_width: 1.0,
        half_width_y: Some(2.0),
        pressure: 1.0,
        friction: 0.2,
        poisson: 0.3,
    };
    let deviations = [63, 125].map(|n| {
        let load = hertz_grid([n, n], 2.0, [0.2, 0.0]);
        let depths = [0.1, 0.3, 0.6, 1.2];
        let response = bare(0.3, &depths);
        let planes = Planes::new(&load, &response);
        worst(depths.into_iter().enumerate().flat_map(|(plane, z)| {
            let found = planes.at(plane);
            let cells = (0..n * n).step_by(37);
            let differences: Vec<f64> = cells
                .map(|cell| {
                    let (x, y) = (load.centres[0][cell % n], load.centres[1][cell / n]);
                    worst((found[cell] - exact.at(x, y, z)).0)
                })
                .collect();
            differences
        }))
    });
    println!("ellipse on grids: {deviations:?}");
    assert!(deviations[0] < 1e-2 && deviations[1] < 0.7 * deviations[0]);
}

/// Shear along y is that along x with the axes exchanged.
#[test]
fn shear_across() {
    let along = hertz_grid([16, 16], 1.0, [0.4, 0.0]);
    let across = hertz_grid([16, 16], 1.0, [0.0, 0.4]);
    let [xx, yy, zz, xy, xz, yz] = direct(&along, [0.3, -0.4, 0.2], 0.3).0;
    let found = direct(&across, [-0.4, 0.3, 0.2], 0.3);
    let turned = Stress([yy, xx, zz, xy, yz, xz]);
    assert!(worst((found - turned).0) < 1e-13);
}

#[test]
fn principal_stresses() {
    let stress = Stress([3.0, 3.0, 4.0, 1.0, 1.0, 1.0]);
    let [first, second, third] = stress.principal();
    let trace = first + second + third;
    assert!((trace - 10.0).abs() < 1e-13 && first >= second && second >= third);
    let determinant = 3.0 * (12.0 - 1.0) - (4.0 - 1.0) + (1.0 - 3.0);
    assert!((first * second * third - determinant).abs() < 1e-12);
    assert!((Stress([2.0, 0.0, 0.0, 0.0, 0.0, 0.0]).von_mises() - 2.0).abs() < 1e-14);
    assert!((Stress([0.0, 0.0, 0.0, 0.0, 1.0, 0.0]).largest_shear() - 1.0).abs() < 1e-14);
}

#[test]
fn smallest_spheres() {
    let at = |x: f64, y: f64, z: f64| [x, y, z, 0.0, 0.0];
    // An obtuse triangle: its longest side; a point within does not matter.
    let flat = [
        at(-2.0, 0.0, 0.0),
        at(2.0, 0.0, 0.0),
        at(0.5, 0.3, 0.0),
        at(0.0, 0.1, 0.0),
    ];
    let (centre, radius) = smallest_sphere(&flat);
    assert!((radius - 2.0).abs() < 1e-12 && worst(centre) < 1e-12);
    // The corners of a cube.
    let cube: Vec<_> = (0..8_u8)
        .map(|i| at(f64::from(i & 1), f64::from(i >> 1 & 1), f64::from(i >> 2)))
        .collect();
    let (centre, radius) = smallest_sphere(&cube);
    assert!((radius - 0.75_f64.sqrt()).abs() < 1e-12);
    assert!(worst(centre[..3].iter().map(|c| c - 0.5)) < 1e-12);
}

#[test]
fn hardness_over_depth() {
    let case = Hardness::of_case(700.0, 350.0, 1e-3).unwrap();
    let found = [0.0, 1e-3, 20e-3].map(|z| case.at(z));
    assert!(
        worst([found[0] - 700.0, found[1] - 550.0, found[2] - 350.0]) < 0.5,
        "{found:?}"
    );
    let table = Hardness::of_table(vec![[0.1e-3, 700.0], [0.5e-3, 500.0], [1e-3, 400.0]]).unwrap();
    assert_eq!(
        [0.0, 0.3e-3, 2e-3].map(|z| table.at(z).round()),
        [700.0, 600.0, 400.0]
    );
    for bad in [
        vec![[0.0, 700.0]],
        vec![[0.0, 700.0], [0.0, 400.0]],
        vec![[0.0, 400.0], [1e-3, 700.0]],
        vec![[0.0, 700.0], [1e-3, 350.0], [2e-3, 400.0]],
    ] {
        assert!(Hardness::of_table(bad).is_err());
    }
    assert!(Hardness::of_case(700.0, 600.0, 1e-3).is_err());
    assert!(Hardness::of_case(300.0, 350.0, 1e-3).is_err());
}

/// 10^6 points: 125 × 125 in 64 planes. Run by hand, with `--ignored --nocapture`.
#[test]
#[ignore = "a measurement of time"]
fn a_million_points() {
    let load = hertz_grid([125, 125], 1.0, [0.1, 0.0]);
    let x = load.centres[0].clone();
    let depths = Depths::new(3.0, 63);
    let clock = std::time::Instant::now();
    let levels = Load::Grid(load).levels(&x, &Response::bare(0.3, &depths));
    println!(
        "{} planes of 125 x 125 points: {:.2} s",
        levels.len(),
        clock.elapsed().as_secs_f64()
    );
}
