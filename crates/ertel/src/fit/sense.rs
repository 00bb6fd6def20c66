//! Checks of a fitted law for behaviour that no lubricant shows.

use super::{Data, Fit, Property};
use crate::words::digits;

/// Root mean square of the relative deviations above which a law does not describe the data.
pub const LARGEST_RMS: f64 = 0.1;

/// Share of the ranges of the data over which slopes are checked.
const STEP: f64 = 1e-3;

/// Warnings on implausible behaviour of a fitted law, over the range of its data: a viscosity that falls with pressure (a negative
/// pressure-viscosity coefficient) or rises with temperature, a density likewise, and deviations above [`LARGEST_RMS`].
pub fn nonsense(fit: &Fit, data: &Data) -> Vec<String> {
    let mut found = Vec::new();
    let name = data.property.name();
    let ln = |p: f64, t: f64| fit.law.ln_value(p, t);
    let [p_low, p_high] = data.pressure_range();
    let [t_low, t_high] = data.temperature_range();
    let step = STEP * (p_high - p_low);
    let falls = |state: &&super::State| {
        let p = state.pressure.min(p_high - step);
        step > 0.0 && ln(p + step, state.temperature) < ln(p, state.temperature)
    };
    if let Some(state) = data.states.iter().find(falls) {
        let what = match data.property {
            Property::Viscosity => "its pressure-viscosity coefficient is negative",
            Property::Density => "its compressibility is negative",
        };
        found.push(format!(
            "the fitted {name} falls with pressure at {} MPa and {} °C: {what}",
            digits(1e-6 * state.pressure, 4),
            digits(state.temperature - 273.15, 4)
        ));
    }
    let step = STEP * (t_high - t_low);
    let rises = |state: &&super::State| {
        let t = state.temperature.min(t_high - step);
        step > 0.0 && ln(state.pressure, t + step) > ln(state.pressure, t)
    };
    if let Some(state) = data.states.iter().find(rises) {
        found.push(format!(
            "the fitted {name} rises with temperature at {} MPa and {} °C",
            digits(1e-6 * state.pressure, 4),
            digits(state.temperature - 273.15, 4)
        ));
    }
    if fit.rms() > LARGEST_RMS {
        found.push(format!(
            "the law `{}` does not describe the data: the rms of its deviations is {} %, above {} %",
            fit.name.name(),
            digits(100.0 * fit.rms(), 3),
            digits(100.0 * LARGEST_RMS, 3)
        ));
    }
    found
}
