//! The fitted law over the data.

use super::{Data, Fit, Property};
use crate::words::digits;
use ertel_plot::{Axis, Chart, Look, PALETTE, Series, Side};

/// Points of a curve.
const N_POINTS: usize = 121;
/// Temperatures (K) nearer than this are shown as one isotherm.
const SAME: f64 = 0.5;

/// Diagram of the states and the law over pressure, one colour per isotherm.
pub fn picture(fit: &Fit, data: &Data, title: &str) -> Chart {
    let mut isotherms: Vec<f64> = Vec::new();
    for state in &data.states {
        if isotherms
            .iter()
            .all(|t| (t - state.temperature).abs() > SAME)
        {
            isotherms.push(state.temperature);
        }
    }
    isotherms.sort_by(f64::total_cmp);
    let factor = match data.property {
        Property::Viscosity => 1e3,
        Property::Density => 1.0,
    };
    let mut series = Vec::new();
    for (i, temperature) in isotherms.iter().enumerate() {
        let states = data
            .states
            .iter()
            .filter(|s| (s.temperature - temperature).abs() <= SAME);
        let points: Vec<[f64; 2]> = states
            .map(|s| [1e-6 * s.pressure, factor * s.value])
            .collect();
        let low = points.iter().map(|p| p[0]).fold(f64::INFINITY, f64::min);
        let high = points
            .iter()
            .map(|p| p[0])
            .fold(f64::NEG_INFINITY, f64::max);
        let curve = (0..N_POINTS)
            .map(|k| low + (high - low) * k as f64 / (N_POINTS - 1) as f64)
            .map(|p| [p, factor * fit.law.ln_value(1e6 * p, *temperature).exp()])
            .collect();
        let colour = PALETTE[i % PALETTE.len()];
        series.push(Series {
            label: format!("{} °C", digits(temperature - 273.15, 4)),
            points: curve,
            look: Look::Line,
            colour: colour.into(),
            side: Side::Left,
        });
        series.push(Series {
            label: String::new(),
            points,
            look: Look::Circles,
            colour: colour.into(),
            side: Side::Left,
        });
    }
    let all = || series.iter().flat_map(|s| &s.points);
    let x = Axis::linear_around(
        "Pressure *p* (MPa)",
        all().map(|p| p[0]).chain([0.0]).collect::<Vec<_>>(),
    );
    let values: Vec<f64> = all().map(|p| p[1]).collect();
    let y = match data.property {
        Property::Viscosity => Axis::log_close_around("Viscosity *μ* (mPa s)", values),
        Property::Density => Axis::linear_around("Density *ρ* (kg/m³)", values),
    };
    let mut chart = Chart::new(title, x, y);
    chart.heading = format!(
        "{}: rms {} %",
        fit.name.name(),
        digits(100.0 * fit.rms(), 2)
    );
    chart.series = series;
    chart
}
