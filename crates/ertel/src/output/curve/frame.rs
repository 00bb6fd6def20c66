//! Axes and points of a diagram over the quantity of a curve.

use ertel_quantity::Dimension;

use super::super::pictures::is_wide;
use crate::case::curve::Quantity;
use crate::study::{CurveSolution, PointSolution, RPM};
use crate::words::{CELSIUS, pressure_unit};
use ertel_plot::{Axis, AxisScale, Chart, Marker};

/// Diagram over the quantity of a curve, without series; call [`fit_y`] after adding them.
pub(super) fn curve_chart(title: &str, curve: &CurveSolution, y_label: &str) -> Chart {
    let values = || curve.points.iter().map(|p| p.value);
    let (shown, unit) = shown_unit(&curve.quantity, largest(values().map(f64::abs)));
    let label = axis_label(&curve.quantity, unit);
    // The sliding axis starts at pure rolling, as in traction curves.
    let is_ratio = curve.quantity.dimension == Dimension::DIMENSIONLESS;
    let x = if !is_ratio && is_wide(values()) {
        Axis::log_close_around(&label, values().map(shown))
    } else {
        let origin = is_ratio.then_some(0.0);
        Axis::linear_around(&label, values().map(shown).chain(origin))
    };
    let mut chart = Chart::new(title, x, Axis::linear(y_label, 0.0, 1.0));
    let failed = curve.points.iter().filter(|p| !p.outcome.is_solved());
    chart.markers = failed
        .map(|p| Marker {
            x: shown(p.value),
            label: "failed".into(),
        })
        .collect();
    chart
}

/// Fits the left axis to the series. It is logarithmic if the x axis is, because power laws are then straight lines.
pub(super) fn fit_y(chart: &mut Chart) {
    let heights = || {
        let points = chart.series.iter().flat_map(|s| &s.points);
        points.map(|p| p[1]).filter(|h| h.is_finite())
    };
    let label = chart.y.label.clone();
    let y = if chart.x.scale == AxisScale::Log && is_wide(heights()) {
        Axis::log_close_around(&label, heights())
    } else {
        Axis::linear_around(&label, heights().chain([0.0]))
    };
    chart.y = y;
}

/// One point per point of the curve; not finite without a value.
pub(super) fn points_over(
    curve: &CurveSolution,
    value: impl Fn(&PointSolution) -> Option<f64>,
) -> Vec<[f64; 2]> {
    let size = largest(curve.points.iter().map(|p| p.value.abs()));
    let (shown, _) = shown_unit(&curve.quantity, size);
    let mut points: Vec<[f64; 2]> = (curve.points.iter())
        .map(|p| [shown(p.value), value(p).unwrap_or(f64::NAN)])
        .collect();
    points.sort_by(|a, b| a[0].total_cmp(&b[0]));
    points
}

pub(super) fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, f64::max)
}

/// Display unit of the quantity, given its largest value (SI).
fn shown_unit(quantity: &Quantity, size: f64) -> (fn(f64) -> f64, &'static str) {
    match quantity.dimension {
        Dimension::SPEED if size < 0.1 => (|v| 1e3 * v, "mm/s"),
        Dimension::SPEED => (|v| v, "m/s"),
        Dimension::FORCE if size < 0.1 => (|v| 1e3 * v, "mN"),
        Dimension::FORCE => (|v| v, "N"),
        Dimension::FORCE_PER_LENGTH => (|v| 1e-3 * v, "kN/m"),
        Dimension::PRESSURE if pressure_unit(size).1 == "MPa" => (|v| 1e-6 * v, "MPa"),
        Dimension::PRESSURE => (|v| 1e-9 * v, "GPa"),
        Dimension::LENGTH => (|v| 1e3 * v, "mm"),
        Dimension::TEMPERATURE => (|v| v - CELSIUS, "°C"),
        Dimension::ANGULAR_SPEED => (|v| RPM * v, "rpm"),
        _ if quantity.is_torque() => (|v| v, "N m"),
        _ => (|v| v, ""),
    }
}

fn axis_label(quantity: &Quantity, unit: &str) -> String {
    let mut name = quantity.name.to_owned();
    if let Some(first) = name.get_mut(..1) {
        first.make_ascii_uppercase();
    }
    let symbol = match quantity.symbol {
        "" => String::new(),
        symbol => format!(" {symbol}"),
    };
    let unit = match unit {
        "" => String::new(),
        unit => format!(" ({unit})"),
    };
    format!("{name}{symbol}{unit}")
}
