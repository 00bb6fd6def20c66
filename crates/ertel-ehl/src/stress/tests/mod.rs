//! Stresses against values from outside.

mod fatigue;
mod grid;
mod hertz;
mod layered;

use std::f64::consts::PI;

use super::LineLoad;

/// The largest deviation.
fn worst(deviations: impl IntoIterator<Item = f64>) -> f64 {
    (deviations.into_iter()).fold(0.0, |w: f64, d| w.max(d.abs()))
}

/// Points from −reach to reach.
fn passage(reach: f64, steps: usize) -> Vec<f64> {
    (0..=steps)
        .map(|i| reach * (2.0 * i as f64 / steps as f64 - 1.0))
        .collect()
}

/// The Hertz pressure of a line on nodes that are dense near the rim, with a traction.
fn hertz_line(friction: f64) -> LineLoad {
    let n = 400;
    let nodes: Vec<f64> = (0..=n).map(|i| -(PI * i as f64 / n as f64).cos()).collect();
    let values = (nodes.iter())
        .map(|x| (1.0 - x * x).max(0.0).sqrt())
        .map(|p| [p, friction * p])
        .collect();
    LineLoad::new(nodes, values)
}
