//! Dry contacts with layers against integral equations solved elsewhere.

use crate::contact::{HertzZone, Material, Turn};
use crate::elastic::Elasticity;
use crate::layers::Layer;
use crate::volumes::deflection::Deflection;
use crate::volumes::grid::Grid;
use crate::volumes::kernel::Kernel;

/// Change of the pressure over the load at which an iteration ends, and most iterations.
const SETTLED: f64 = 1e-7;
const MOST: usize = 400;

/// The pressure of a parabola under a load, in cells of an area, by conjugate gradients (Polonsky and Keer 1999).
fn dry_pressure(grid: &Grid, deflection: &Deflection, load: f64, area: f64) -> Vec<f64> {
    let gap: Vec<f64> = (grid.nodes())
        .map(|[i, j]| grid.on_axes(i, j))
        .map(|[x, y]| 0.5 * (x * x + y * y))
        .collect();
    let n = gap.len();
    let mut p: Vec<f64> = gap.iter().map(|g| (0.6 - g).max(0.0).sqrt()).collect();
    let scale = |p: &mut [f64]| {
        let factor = load / (area * p.iter().sum::<f64>());
        p.iter_mut().for_each(|p| *p *= factor);
    };
    scale(&mut p);
    let (mut t, mut before, mut conjugate) = (vec![0.0; n], 1.0, 0.0);
    for _ in 0..MOST {
        let mean = |values: &[f64], p: &[f64]| {
            let active = || values.iter().zip(p).filter(|(_, p)| **p > 0.0);
            active().map(|(v, _)| v).sum::<f64>() / active().count() as f64
        };
        let mut g: Vec<f64> = (deflection.apply(&p).iter().zip(&gap))
            .map(|(u, h)| u + h)
            .collect();
        let middle = mean(&g, &p);
        g.iter_mut().for_each(|g| *g -= middle);
        let active: Vec<bool> = p.iter().map(|p| *p > 0.0).collect();
        let size: f64 = (0..n).filter(|i| active[*i]).map(|i| g[i] * g[i]).sum();
        t = (0..n)
            .map(|i| match active[i] {
                true => g[i] + conjugate * size / before * t[i],
                false => 0.0,
            })
            .collect::<Vec<f64>>();
        before = size;
        let mut r = deflection.apply(&t);
        let middle = mean(&r, &p);
        r.iter_mut().for_each(|r| *r -= middle);
        let sum = |v: &[f64]| {
            (0..n)
                .filter(|i| active[*i])
                .map(|i| v[i] * t[i])
                .sum::<f64>()
        };
        let step = sum(&g) / sum(&r);
        let old = p.clone();
        let is_overlap = |i: usize| !active[i] && g[i] < 0.0;
        conjugate = match (0..n).any(is_overlap) {
            true => 0.0,
            false => 1.0,
        };
        p = (0..n)
            .map(|i| match active[i] {
                true => (old[i] - step * t[i]).max(0.0),
                false => (-step * g[i]).max(0.0),
            })
            .collect();
        scale(&mut p);
        let change: f64 = p.iter().zip(&old).map(|(p, o)| (p - o).abs()).sum();
        if area * change < SETTLED * load {
            break;
        }
    }
    p
}

/// A rigid parabola on a half-space with a layer of this E₁/E₂ and thickness over the half-width of the bare contact; ν = 0.3.
fn largest(grid: &Grid, compliance: f64, load: f64, layer: Option<[f64; 2]>) -> f64 {
    let material = |e: f64| Material {
        youngs_modulus: e * 0.91 / compliance,
        poissons_ratio: 0.3,
    };
    let layers = layer.map(|[e, thickness]| Layer {
        thickness,
        material: material(e),
    });
    let bodies = Elasticity::half_space(1, &[material(1.0)]);
    let bodies = bodies.with_layers(vec![layers.into_iter().collect()]);
    let deflection = Deflection::new(grid, Kernel::of(&bodies));
    let [dx, dy] = grid.cell_size(1.0);
    let area = if dy.is_finite() { dx * dy } else { dx };
    let pressure = dry_pressure(grid, &deflection, load, area);
    pressure.into_iter().fold(0.0, f64::max)
}

/// E₁/E₂, thickness over the half-width, and the largest pressure over Hertz's: of a sphere by a Fredholm equation, of a cylinder by Chebyshev series.
const SPHERES: [[f64; 3]; 6] = [
    [1.0, 0.2, 1.0],
    [0.25, 0.2, 0.7938504795],
    [0.25, 1.0, 0.5071376115],
    [0.5, 0.05, 0.9744742199],
    [2.0, 0.2, 1.058043825],
    [4.0, 1.0, 2.283465979],
];
const CYLINDERS: [[f64; 3]; 5] = [
    [1.0, 0.2, 1.0],
    [0.25, 0.2, 0.8741672411],
    [0.25, 1.0, 0.665856675],
    [2.0, 0.2, 1.034461568],
    [4.0, 0.05, 1.020003511],
];

/// Grids err by 1e-3, their ratio to the bare contact on the same grid by less.
#[test]
fn dry_sphere_and_cylinder_on_layers() {
    use std::f64::consts::PI;
    let zone = HertzZone {
        axis_ratio: 1.0,
        turn: Turn::NONE,
        roller: None,
    };
    let grid = Grid::covering([[-1.6, 1.6], [-1.6, 1.6]], [0.05; 2], false, &zone);
    let of = |layer| largest(&grid, 2.0 / PI, 2.0 * PI / 3.0, layer);
    let bare = of(None);
    for [e, thickness, known] in SPHERES {
        let found = of(Some([e, thickness])) / bare;
        assert!(
            (found / known - 1.0).abs() < 2e-3,
            "sphere {e} {thickness}: {found}"
        );
    }
    let line = Grid::of_line([-300, 300], 0.01);
    let of = |layer| largest(&line, 0.5, 0.5 * PI, layer);
    let bare = of(None);
    for [e, thickness, known] in CYLINDERS {
        let found = of(Some([e, thickness])) / bare;
        assert!(
            (found / known - 1.0).abs() < 2e-3,
            "cylinder {e} {thickness}: {found}"
        );
    }
}
