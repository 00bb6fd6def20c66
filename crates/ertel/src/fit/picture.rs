//! The fitted law over the data.

use super::walther::AMBIENT;
use super::{Data, Fit, Property};
use crate::words::digits;
use ertel_plot::{Axis, Chart, Look, PALETTE, Series};

/// Points of a curve.
const N_POINTS: usize = 121;
/// Temperatures (K) nearer than this are shown as one isotherm.
const SAME: f64 = 0.5;

/// Diagram of the states and the law over pressure, one colour per isotherm; over temperature where all states are at one pressure.
pub fn picture(fit: &Fit, data: &Data, title: &str) -> Chart {
    let [low, high] = data.pressure_range();
    if high - low < AMBIENT && fit.name.is_thermal() {
        return over_temperature(fit, data, title);
    }
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
    let factor = factor(data.property);
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
        series.push(Series::new(
            format!("{} °C", digits(temperature - 273.15, 4)),
            curve,
            Look::Line,
            colour,
        ));
        series.push(Series::new("", points, Look::Circles, colour));
    }
    let all = || series.iter().flat_map(|s| &s.points);
    let x = Axis::linear_around(
        "Pressure *p* (MPa)",
        all().map(|p| p[0]).chain([0.0]).collect::<Vec<_>>(),
    );
    let values: Vec<f64> = all().map(|p| p[1]).collect();
    let y = axis(data.property, values);
    chart(fit, title, [x, y], series)
}

/// The states and the law at the lowest pressure over temperature.
fn over_temperature(fit: &Fit, data: &Data, title: &str) -> Chart {
    let factor = factor(data.property);
    let celsius = |temperature: f64| temperature - 273.15;
    let [pressure, _] = data.pressure_range();
    let [low, high] = data.temperature_range();
    let states = data.states.iter();
    let points: Vec<[f64; 2]> = states
        .map(|s| [celsius(s.temperature), factor * s.value])
        .collect();
    let curve: Vec<[f64; 2]> = (0..N_POINTS)
        .map(|k| low + (high - low) * k as f64 / (N_POINTS - 1) as f64)
        .map(|t| [celsius(t), factor * fit.law.ln_value(pressure, t).exp()])
        .collect();
    let all = || points.iter().chain(&curve);
    let x = Axis::linear_around(
        "Temperature *T* (°C)",
        all().map(|p| p[0]).collect::<Vec<_>>(),
    );
    let y = axis(data.property, all().map(|p| p[1]).collect());
    let series = [(curve, Look::Line), (points, Look::Circles)]
        .map(|(points, look)| Series::new("", points, look, PALETTE[0]));
    chart(fit, title, [x, y], series.into())
}

/// From SI to the unit of the picture.
fn factor(property: Property) -> f64 {
    match property {
        Property::Viscosity => 1e3,
        Property::Density => 1.0,
    }
}

fn axis(property: Property, values: Vec<f64>) -> Axis {
    match property {
        Property::Viscosity => Axis::log_close_around("Viscosity *μ* (mPa s)", values),
        Property::Density => Axis::linear_around("Density *ρ* (kg/m³)", values),
    }
}

fn chart(fit: &Fit, title: &str, [x, y]: [Axis; 2], series: Vec<Series>) -> Chart {
    let mut chart = Chart::new(title, x, y);
    chart.heading = format!(
        "{}: rms {} %",
        fit.name.name(),
        digits(100.0 * fit.rms(), 2)
    );
    chart.series = series;
    chart
}
