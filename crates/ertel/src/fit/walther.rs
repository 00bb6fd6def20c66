//! Starting values for a fit of Walther's law, and checks that the data determine its constants.

use ertel_rheology::DensityLaw;
use ertel_rheology::viscosity::Walther;

use super::law::ISOTHERM;
use super::{Data, FitError, LawName, Params, State};

/// A and B of an oil of 46 mm²/s at 40 degC and 6.8 at 100 degC.
pub(super) const USUAL: (f64, f64) = (9.418, 3.6844);

/// Pressure (Pa above ambient) up to which states count as measured at ambient pressure: the viscosity rises by some 2 %, which does
/// not determine a coefficient.
pub(super) const AMBIENT: f64 = 1e6;

/// A and B through the states of lowest pressure at the lowest and the highest temperature, by the closed formula of
/// [`Walther::constants`].
pub(super) fn start(data: &Data, density: Option<&DensityLaw>) -> (f64, f64) {
    let [low, high] = data.temperature_range();
    let kinematic = |temperature: f64| {
        let isotherm = data
            .states
            .iter()
            .filter(|s: &&State| (s.temperature - temperature).abs() <= ISOTHERM);
        let first = isotherm.min_by(|a, b| a.pressure.total_cmp(&b.pressure))?;
        let density = density?.density(0.0, first.temperature);
        Some((first.temperature, first.value / density))
    };
    let points = kinematic(low).zip(kinematic(high));
    let found = points.map(|(cold, hot)| Walther::constants([cold, hot]));
    found
        .filter(|(a, b)| a.is_finite() && b.is_finite() && *b > 0.0)
        .unwrap_or(USUAL)
}

/// Refuses a fit without density, a coefficient without pressures to determine it, one held without reference temperature, and one isotherm for A
/// and B.
pub(super) fn check(
    data: &Data,
    params: &Params,
    is_held: impl Fn(&str) -> bool,
) -> Result<(), FitError> {
    match &params.density {
        None => return Err(FitError::NoDensity),
        Some(DensityLaw::Table(_)) => return Err(FitError::TabulatedDensity),
        Some(_) => {}
    }
    let [_, highest] = data.pressure_range();
    match (is_held("alpha"), params.reference_temperature) {
        (false, _) if highest < AMBIENT => return Err(FitError::NoPressures),
        (true, None) => return Err(FitError::NoReferenceTemperature),
        _ => {}
    }
    let [low, high] = data.temperature_range();
    if high - low <= ISOTHERM && !is_held("a") && !is_held("b") {
        let (law, key) = (LawName::Walther, "b");
        return Err(FitError::Undetermined { law, key });
    }
    Ok(())
}
