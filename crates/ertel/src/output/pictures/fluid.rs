//! Viscosity of a fluid over pressure.

use crate::words::pressure_unit;
use crate::words::{CELSIUS, digits};
use ertel_plot::{Axis, Chart, Look, Marker, PALETTE, Series};

/// Viscosity against pressure at one temperature.
pub struct ViscosityCurve {
    /// Temperature, K.
    pub temperature: f64,
    /// Pressures, Pa, rising.
    pub pressure: Vec<f64>,
    /// Viscosities, Pa·s.
    pub viscosity: Vec<f64>,
}

/// Viscosity-pressure curves of a fluid on a logarithmic axis. Outside a given range of validity
/// (Pa), the background is shaded and the curves are dashed.
pub fn viscosity_chart(
    title: &str,
    curves: &[ViscosityCurve],
    valid_pressure: Option<[f64; 2]>,
) -> Chart {
    let highest = curves.iter().flat_map(|c| c.pressure.iter().copied());
    let highest = highest.filter(|p| p.is_finite()).fold(0.0, f64::max);
    let (factor, unit) = pressure_unit(highest);
    let values = curves.iter().flat_map(|c| c.viscosity.iter().copied());
    let mut chart = Chart::new(
        title,
        Axis::linear_around(&format!("Pressure *p* ({unit})"), [0.0, factor * highest]),
        Axis::log_close_around("Viscosity *μ* (Pa s)", values),
    );
    chart.x.high = chart
        .x
        .high
        .min(factor * highest)
        .max(chart.x.low + f64::MIN_POSITIVE);
    let [from, to] = valid_pressure.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
    if from > 0.0 && from.is_finite() {
        chart.shaded.push([0.0, factor * from]);
    }
    if to < highest {
        chart.shaded.push([factor * to, factor * highest]);
        chart.markers.push(Marker {
            x: factor * to,
            label: "extrapolated".into(),
        });
    }
    for (i, curve) in curves.iter().enumerate() {
        let points: Vec<[f64; 2]> = curve
            .pressure
            .iter()
            .zip(&curve.viscosity)
            .map(|(p, v)| [*p, *v])
            .collect();
        let label = format!("{} °C", digits(curve.temperature - CELSIUS, 4));
        let parts = [
            (label, from, to, Look::Line),
            (String::new(), f64::NEG_INFINITY, from, Look::Dashed),
            (String::new(), to, f64::INFINITY, Look::Dashed),
        ];
        for (label, low, high, look) in parts {
            let part = between(&points, low, high);
            if part.len() > 1 {
                chart.series.push(Series::new(
                    label,
                    part.into_iter().map(|[p, v]| [factor * p, v]).collect(),
                    look,
                    PALETTE[i % PALETTE.len()],
                ));
            }
        }
    }
    chart
}

/// Part of a curve with x between the bounds; end points are interpolated in ln y.
fn between(points: &[[f64; 2]], low: f64, high: f64) -> Vec<[f64; 2]> {
    let mut part = Vec::new();
    for (i, [x, y]) in points.iter().enumerate() {
        if let Some([x0, y0]) = i.checked_sub(1).map(|j| points[j]) {
            for bound in [low, high] {
                if x0 < bound && bound < *x {
                    let t = (bound - x0) / (x - x0);
                    part.push([bound, y0 * (y / y0).powf(t)]);
                }
            }
        }
        if (low..=high).contains(x) {
            part.push([*x, *y]);
        }
    }
    part
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An exponential is a straight line on a logarithmic axis: cut at 0.5, it is e^0.5.
    #[test]
    fn curve_is_cut_at_the_end_of_its_range() {
        let curve = [[0.0, 1.0], [1.0, 1f64.exp()], [2.0, 2f64.exp()]];
        let inside = between(&curve, 0.0, 0.5);
        assert_eq!((inside.len(), inside[1][0]), (2, 0.5));
        assert!((inside[1][1] - 0.5f64.exp()).abs() < 1e-12);
        assert_eq!(between(&curve, 0.5, f64::INFINITY).len(), 3);
    }
}
