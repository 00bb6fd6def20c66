//! Convergence of Newton's method.

use super::{Axis, Chart, Look, Marker, PALETTE, Series, Side};
use crate::solution::{IterationRecord, Solution};

/// Residual and update of every Newton iteration, levels one after the other.
pub fn convergence(title: &str, solution: &Solution, tolerance: Option<f64>) -> Chart {
    let history = &solution.history;
    let curve = |value: fn(&IterationRecord) -> f64| -> Vec<[f64; 2]> {
        let mut points = Vec::new();
        for (i, record) in history.iter().enumerate() {
            if i > 0 && history[i - 1].level != record.level {
                // A new mesh starts a new line
                points.push([f64::NAN; 2]);
            }
            points.push([(i + 1) as f64, value(record)]);
        }
        points
    };
    let residual = curve(|r| r.residual);
    let update = curve(|r| r.update);
    let heights = residual
        .iter()
        .chain(&update)
        .map(|p| p[1])
        .chain(tolerance);
    let mut chart = Chart::new(
        title,
        Axis::count("Newton iteration", history.len()),
        Axis::log_around("Relative residual and update", heights),
    );
    if let Some(tolerance) = tolerance {
        chart.series.push(Series {
            label: "tolerance".into(),
            points: vec![[0.0, tolerance], [history.len() as f64 + 1.0, tolerance]],
            look: Look::Dashed,
            colour: "#7f7f7f".into(),
            side: Side::Left,
        });
    }
    for (label, points, colour) in [
        ("Reynolds residual", residual, PALETTE[0]),
        ("pressure update / *p*_{h}", update, PALETTE[1]),
    ] {
        chart.series.push(Series {
            label: label.into(),
            points,
            look: Look::LineAndDots,
            colour: colour.into(),
            side: Side::Left,
        });
    }
    let mut level = None;
    for (i, record) in history.iter().enumerate() {
        if level != Some(record.level) {
            level = Some(record.level);
            chart.markers.push(Marker {
                x: i as f64 + 0.5,
                label: format!("stage {}", record.level + 1),
            });
        }
    }
    chart
}
