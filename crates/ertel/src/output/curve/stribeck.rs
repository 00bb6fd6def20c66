//! The Stribeck curve: film and asperity friction over speed.

use ertel_quantity::Dimension;

use super::frame::largest;
use crate::solution::MixedFriction;
use crate::study::{CurveSolution, PointSolution};
use ertel_plot::{Axis, Chart, Look, Marker, PALETTE, Series, Side};

/// Friction coefficients over the logarithmic entrainment speed: film, asperities and total. The lambda ratio is on the right axis.
/// `None` if the curve is not over a speed, or no point has asperity friction. Failed points are marked.
pub fn stribeck_chart(title: &str, curve: &CurveSolution) -> Option<Chart> {
    let friction = |p: &PointSolution| p.outcome.solution()?.mixed.as_ref()?.friction().copied();
    let is_over_speed = curve.quantity.dimension == Dimension::SPEED;
    if !is_over_speed || !curve.points.iter().any(|p| friction(p).is_some()) {
        return None;
    }
    let speed = |p: &PointSolution| p.case.motion.entrainment_speed;
    let fastest = largest(curve.points.iter().map(speed));
    let (factor, unit) = if fastest < 0.1 {
        (1e3, "mm/s")
    } else {
        (1.0, "m/s")
    };
    let over_speed = |value: &dyn Fn(&PointSolution) -> Option<f64>| {
        let point = |p: &PointSolution| [factor * speed(p), value(p).unwrap_or(f64::NAN)];
        let mut points: Vec<[f64; 2]> = curve.points.iter().map(point).collect();
        points.sort_by(|a, b| a[0].total_cmp(&b[0]));
        points
    };
    let size = |i: usize| over_speed(&|p| friction(p).map(|f| MixedFriction::sizes(&f)[i]));
    let series = |label: &str, look, colour: usize, points| {
        Series::new(label, points, look, PALETTE[colour])
    };
    let ratio = over_speed(&|p| Some(p.outcome.solution()?.mixed.as_ref()?.lambda_minimum.value));
    let curves = vec![
        series("film and asperities", Look::LineAndDots, 0, size(2)),
        series("film", Look::Dashed, 2, size(0)),
        series("asperities", Look::Line, 1, size(1)),
        Series {
            side: Side::Right,
            ..series("lambda ratio (right)", Look::Circles, 3, ratio)
        },
    ];
    let label = format!("Entrainment speed *u*_{{m}} ({unit})");
    let x = Axis::log_close_around(&label, curve.points.iter().map(|p| factor * speed(p)));
    let heights = |side| {
        let points = curves.iter().filter(move |s| s.side == side);
        let heights = points.flat_map(|s| &s.points).map(|p| p[1]);
        heights.filter(|h| h.is_finite() && *h > 0.0)
    };
    let most = largest(heights(Side::Left));
    let y = Axis::linear_around("Friction coefficient", [0.0, most]);
    let mut chart = Chart::new(title, x, y);
    chart.heading = "Oil and asperities share the load".to_owned();
    let axis = Axis::log_close_around("Lambda ratio *h*_{min}/*σ*", heights(Side::Right));
    chart.y_right = Some(axis);
    chart.series = curves;
    let failed = curve
        .points
        .iter()
        .filter(|p| p.outcome.solution().is_none());
    chart.markers = failed
        .map(|p| Marker {
            x: factor * speed(p),
            label: "failed".into(),
        })
        .collect();
    Some(chart)
}
