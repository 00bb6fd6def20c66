//! Checks that need more than one value.

use ertel_rheology::input::{Bounds, InputError, Table};

use super::Case;
use crate::contact::{Contact, ContactKind, Hertz};
use crate::output::{digits, length, pressure};

/// Hertz pressures of lubricated contacts, Pa.
pub(super) const HERTZ_PRESSURE: Bounds = Bounds::closed(MIN_PRESSURE, MAX_PRESSURE);
const MIN_PRESSURE: f64 = 1e6;
const MAX_PRESSURE: f64 = 5e9;
/// Half-width over radius from which the parabola of Hertz theory is a poor sphere.
const POOR_PARABOLA: f64 = 0.2;

/// The Hertz contact, if it is one that the theory covers.
pub(super) fn hertz(
    table: &Table<'_>,
    contact: &Contact,
    reduced_modulus: f64,
) -> Result<Hertz, InputError> {
    let hertz = Hertz::new(contact, reduced_modulus);
    // A Hertz pressure given as such was checked before the round trip through the load.
    let rounding = Bounds::closed(MIN_PRESSURE * (1.0 - 1e-12), MAX_PRESSURE * (1.0 + 1e-12));
    if !rounding.contains(hertz.pressure) {
        let unit = match contact.kind {
            ContactKind::Circular => "N",
            ContactKind::Line => "N/m",
        };
        let load = |pressure| {
            Hertz::load_for_pressure(contact.kind, contact.radius, reduced_modulus, pressure)
        };
        return Err(table
            .error(
                "load",
                format!(
                    "this load gives a Hertz pressure of {}, outside 1 MPa to 5 GPa",
                    pressure(hertz.pressure)
                ),
            )
            .with_help(format!(
                "with this radius and these bodies the load must be between {} {unit} and {} {unit}",
                rounded(load(MIN_PRESSURE), f64::ceil),
                rounded(load(MAX_PRESSURE), f64::floor)
            )));
    }
    if hertz.half_width >= contact.radius {
        return Err(table
            .error(
                "radius",
                format!(
                    "the contact half-width, {}, exceeds the radius",
                    length(hertz.half_width)
                ),
            )
            .with_help(
                "Hertz theory and the film equation hold for contacts much smaller than the bodies",
            ));
    }
    Ok(hertz)
}

/// What the user should know, one sentence each.
pub(super) fn warnings(case: &Case, hertz: &Hertz) -> Vec<String> {
    let mut warnings = Vec::new();
    let ratio = case.motion.slide_to_roll_ratio;
    if ratio.abs() > 2.0 {
        warnings.push(format!(
            "the slide-to-roll ratio {ratio} is beyond 2: the surfaces move in opposite directions"
        ));
    }
    let share = hertz.half_width / case.contact.radius;
    if share > POOR_PARABOLA {
        warnings.push(format!(
            "the contact half-width is {share:.2} of the radius: the parabolic gap of Hertz theory is crude"
        ));
    }
    warnings
}

/// Four significant digits, rounded up or down so that the number itself still fits.
fn rounded(value: f64, direction: fn(f64) -> f64) -> String {
    let step = 10_f64.powf(value.log10().floor() - 3.0);
    digits(direction(value / step) * step, 4)
}
