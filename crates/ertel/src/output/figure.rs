//! Figures with error bars as text.

use crate::contact::Symmetry;
use crate::solution::{
    Estimate, Figure, Kind, LEAST_RISE, Located, Solution, Unresolved, WIDEST, WIDEST_OF_PLACE, Why,
};
use crate::words::{CELSIUS, digits, length_unit, pressure_unit};

/// Names of the bodies in outputs.
pub(crate) const BODIES: [&str; 2] = ["body 1", "body 2"];

/// Maximum number of significant digits of a figure.
const MOST_DIGITS: i32 = 6;

/// Digits of a figure without an error bar.
const DIGITS: usize = 4;

/// Maximum decimals of a temperature in K.
const KELVIN_DECIMALS: i32 = 2;

/// Maximum decimals of a place in half-widths.
const PLACE_DECIMALS: i32 = 3;

/// An error bar whose first three digits are at most this is printed with two digits, others with one (Particle Data Group, Review
/// of Particle Physics, introduction, section 5.3).
const TWO_DIGITS_UP_TO: f64 = 354.0;

/// Power of ten of the leading digit.
fn exponent(value: f64) -> i32 {
    value.abs().log10().floor() as i32
}

/// Number of certain decimals, given the error bar; negative if digits before the point are uncertain.
fn decimals(value: f64, error: f64) -> i32 {
    let first = exponent(error);
    let leading = (error * 10f64.powi(2 - first)).round();
    // 950 and more are rounded to the next power of ten: two digits remain.
    let of_bar = match leading {
        l if l <= TWO_DIGITS_UP_TO => 1 - first,
        _ => -first,
    };
    of_bar.min(MOST_DIGITS - 1 - exponent(value.abs().max(error)))
}

/// A number with this many decimals; uncertain digits before the point become zeros.
fn rounded(value: f64, decimals: i32) -> String {
    let text = match usize::try_from(decimals) {
        Ok(decimals) => format!("{value:.decimals$}"),
        Err(_) => {
            let step = 10f64.powi(-decimals);
            format!("{:.0}", step * (value / step).round())
        }
    };
    // Avoids minus zero.
    match text.strip_prefix('-') {
        Some(size) if size.parse() == Ok(0.0) => size.to_owned(),
        _ => text,
    }
}

/// An error bar with this many decimals, never rounded to zero.
fn bar(error: f64, decimals: i32) -> String {
    let text = rounded(error, decimals);
    if text.parse() == Ok(0.0) && error > 0.0 {
        rounded(10f64.powi(-decimals), decimals)
    } else {
        text
    }
}

/// Value and error bar with the certain digits; four digits without a bar, or without an
/// error.
fn parts(value: f64, error: Option<f64>) -> (String, Option<String>) {
    match error {
        Some(error) if error > 0.0 && error.is_finite() => {
            let decimals = decimals(value, error);
            (rounded(value, decimals), Some(bar(error, decimals)))
        }
        error => (digits(value, DIGITS), error.map(|error| error.to_string())),
    }
}

/// Digits of the bounds of a figure whose bar is too wide for a number.
const DIGITS_OF_BOUNDS: usize = 2;

/// The bounds of a figure whose bar is too wide for a number.
fn range(e: Estimate, factor: f64, unit: &str) -> String {
    let (value, error) = (factor * e.value, factor * e.error.unwrap_or(0.0));
    let bound = |v: f64| {
        if v == 0.0 {
            return "0".to_owned();
        }
        let step = 10f64.powi(exponent(v) + 1 - DIGITS_OF_BOUNDS as i32);
        digits((v / step).round() * step, DIGITS_OF_BOUNDS)
    };
    let range = match error < value.abs() {
        true => format!(
            "between {} and {}",
            bound(value - error),
            bound(value + error)
        ),
        false => format!("at most {}", bound(value.abs() + error)),
    };
    format!("{range} {unit}").trim_end().to_owned()
}

/// A figure with error bar and unit; the value times `factor` is in this unit. Bounds only if the bar is too wide for a number.
pub fn in_unit(e: Estimate, factor: f64, unit: &str) -> String {
    match e.is_resolved() {
        true => with_bar(e, factor, unit),
        false => format!("not resolved ({})", range(e, factor, unit)),
    }
}

/// A number with its uncertainty, however large, as for a measurement.
pub fn with_bar(e: Estimate, factor: f64, unit: &str) -> String {
    let (value, error) = (factor * e.value, e.error.map(|error| factor * error));
    let largest = value.abs().max(error.unwrap_or(0.0));
    let text = match error {
        None | Some(0.0) if value == 0.0 => "0".to_owned(),
        // Powers of ten instead of long rows of zeros.
        Some(error) if error > 0.0 && !(-4..9).contains(&exponent(largest)) => {
            let power = exponent(largest);
            let scale = 10f64.powi(-power);
            let (value, error) = parts(scale * value, Some(scale * error));
            format!("({value} ± {})e{power}", error.unwrap_or_default())
        }
        _ => match parts(value, error) {
            (value, Some(error)) => format!("{value} ± {error}"),
            (value, None) => value,
        },
    };
    format!("{text} {unit}").trim_end().to_owned()
}

/// A dimensionless figure.
pub fn number(e: Estimate) -> String {
    in_unit(e, 1.0, "")
}

/// A share in per cent.
pub fn percent(e: Estimate) -> String {
    match e.error {
        Some(_) => in_unit(e, 100.0, "%"),
        None => format!("{:.1} %", 100.0 * e.value),
    }
}

/// A number with a power of ten.
pub fn power(value: f64) -> String {
    format!("{value:.3e}")
}

/// Smaller shares are round-off.
const ROUND_OFF: f64 = 1e-9;

/// A share in per cent, or with a power of ten where it is small.
pub fn percent_or_power(share: f64) -> String {
    if share == 0.0 {
        "0".to_owned()
    } else if share.abs() < ROUND_OFF {
        "below 1e-9".to_owned()
    } else if share.abs() < 1e-4 {
        power(share)
    } else {
        format!("{} %", digits(100.0 * share, 3))
    }
}

/// A temperature (K) in °C, with its rise above the inlet temperature in K.
pub fn temperature(e: Estimate, inlet: Option<f64>) -> String {
    let rise = inlet.map_or(e.value, |inlet| (e.value - inlet).abs().max(LEAST_RISE));
    if e.error.is_some_and(|error| error > WIDEST * rise) {
        return not_resolved_temperature(e);
    }
    let error = e.error.filter(|error| *error > 0.0);
    let shown = error.map_or(KELVIN_DECIMALS, |error| {
        decimals(e.value, error).min(KELVIN_DECIMALS)
    });
    let error = error.map_or(String::new(), |error| format!(" ± {}", bar(error, shown)));
    let celsius = rounded(e.value - CELSIUS, shown);
    let rise = inlet.map_or(String::new(), |inlet| {
        let rise = rounded(e.value - inlet, shown);
        let sign = if rise.starts_with('-') { "" } else { "+" };
        format!(" ({sign}{rise} K)")
    });
    format!("{celsius}{error} °C{rise}")
}

fn not_resolved_temperature(e: Estimate) -> String {
    let error = e.error.unwrap_or(0.0);
    let [low, high] = [e.value - error, e.value + error].map(|t| rounded(t - CELSIUS, 0));
    format!("not resolved (between {low} and {high} °C)")
}

/// A length in a readable unit.
pub fn estimate(e: &Estimate) -> String {
    let (factor, unit) = length_unit(largest(e));
    in_unit(*e, factor, unit)
}

/// A pressure or stress in a readable unit.
pub fn pressure_estimate(e: Estimate) -> String {
    let (factor, unit) = pressure_unit(largest(&e));
    in_unit(e, factor, unit)
}

/// A maximum pressure; only a lower bound if the mesh does not resolve the peak.
pub fn peak(at: &Located) -> String {
    peak_of(at.estimate(), at.resolved)
}

/// The same without its place.
pub fn peak_of(e: Estimate, resolved: bool) -> String {
    if resolved {
        return pressure_estimate(e);
    }
    let (factor, unit) = pressure_unit(e.value);
    format!(
        "at least {} {unit}, not resolved",
        floored(factor * e.value)
    )
}

/// Three digits, rounded down.
fn floored(value: f64) -> String {
    if value <= 0.0 || !value.is_finite() {
        return digits(value, 3);
    }
    let step = 10f64.powi(exponent(value) - 2);
    // A number within rounding of a step counts as that step.
    digits((value / step * (1.0 + 1e-12)).floor() * step, 3)
}

/// A figure that a result does not state: `the minimum film thickness (between 0.1 and 0.7 nm)`.
pub fn unresolved(u: &Unresolved) -> String {
    let (factor, unit) = unit_of_size(u.figure.kind(), largest(&u.estimate));
    let text = match u.why {
        Why::WideBar => range(u.estimate, factor, unit),
        Why::NoBar => "no error bar could be computed".to_owned(),
        Why::BeyondBodies => format!(
            "{} {unit}, beyond the radius",
            digits(factor * u.estimate.value, 2)
        ),
        Why::BeyondPhysics => format!(
            "{} is beyond what is physically possible",
            format!("{} {unit}", digits(factor * u.estimate.value, 2)).trim_end()
        ),
        Why::OpenBalance => format!(
            "heat balance error {} % of the generated heat",
            digits(100.0 * u.estimate.value, 2)
        ),
        Why::OpenMassBalance => format!(
            "mass balance error {} % of the flow through the centre",
            digits(100.0 * u.estimate.value, 2)
        ),
    };
    format!("{} ({text})", u.words())
}

/// Factor and unit for a figure of this size (SI); per cent for a share.
pub fn unit_of_size(kind: Kind, size: f64) -> (f64, &'static str) {
    match kind {
        Kind::Length | Kind::Position | Kind::Offset => length_unit(size),
        Kind::PeakPressure | Kind::Stress => pressure_unit(size),
        Kind::Share => (100.0, "%"),
        Kind::Temperature
        | Kind::Coefficient
        | Kind::Force
        | Kind::Moment
        | Kind::Power
        | Kind::Rise
        | Kind::Angle
        | Kind::Speed
        | Kind::AngularSpeed
        | Kind::Duration
        | Kind::Revolutions => (1.0, kind.unit(false)),
    }
}

/// Name of an axis of a figure, its symbol in italics: `Central film thickness *h*_{c}`.
pub fn axis_name(figure: Figure) -> String {
    let mut name = figure.words().to_owned();
    if let Some(first) = name.get_mut(..1) {
        first.make_ascii_uppercase();
    }
    match figure.symbol().split_once('_') {
        Some((letter, index)) => format!("{name} *{letter}*_{{{index}}}"),
        None if figure.symbol().is_empty() => name,
        None => format!("{name} *{}*", figure.symbol()),
    }
}

/// The size that determines the unit: the value, unless it is smaller than its bar.
fn largest(e: &Estimate) -> f64 {
    e.value.abs().max(e.error.unwrap_or(0.0))
}

/// A position along the motion, in half-widths.
pub fn position(e: Estimate, half_width: f64) -> String {
    if e.error
        .is_some_and(|error| error > WIDEST_OF_PLACE * half_width)
    {
        return PLACE_NOT_RESOLVED.to_owned();
    }
    let (x, error) = (
        e.value / half_width,
        e.error.map(|error| error / half_width),
    );
    let (x, error) = coordinates([x, 0.0], error);
    let error = error.map_or(String::new(), |error| format!(" ± {error}"));
    format!("at x/a {}{error}", x[0])
}

const PLACE_NOT_RESOLVED: &str = "place not resolved";

/// Place of a figure, in half-widths.
pub fn place(solution: &Solution, at: &Located) -> String {
    if !at.place_resolved {
        return PLACE_NOT_RESOLVED.to_owned();
    }
    let a = solution.hertz.half_width;
    let along = Estimate {
        value: at.x,
        error: at.place_error,
    };
    match solution.shape.is_line() {
        true => position(along, a),
        false if at.y == 0.0 => format!("{}, y/a 0", position(along, a)),
        false => {
            let error = at.place_error.map(|error| error / a);
            // The opposite sign is that of the mirror image.
            let (sign, y) = match solution.shape.symmetry {
                Symmetry::Half => ("±", at.y.abs()),
                Symmetry::Full => ("", at.y),
            };
            let ([x, y], error) = coordinates([at.x / a, y / a], error);
            let within = error.map_or(String::new(), |error| format!(", to {error}"));
            format!("at x/a {x}, y/a {sign}{y}{within}")
        }
    }
}

/// Coordinates and their error bar in half-widths.
fn coordinates(place: [f64; 2], error: Option<f64>) -> ([String; 2], Option<String>) {
    let shown = match error {
        Some(error) if error > 0.0 => decimals(1.0, error).clamp(0, PLACE_DECIMALS),
        _ => PLACE_DECIMALS,
    };
    let error = error.filter(|error| *error > 0.0);
    (
        place.map(|x| rounded(x, shown)),
        error.map(|error| bar(error, shown)),
    )
}

#[cfg(test)]
mod tests {
    use super::super::sample;
    use super::*;
    use crate::solution::Asked;

    fn e(value: f64, error: f64) -> Estimate {
        Estimate {
            value,
            error: Some(error),
        }
    }

    #[test]
    fn round_off_is_not_shown() {
        let shown = [0.0, 2.2e-16, -3.3e-10, 6.158e-6, -0.0192].map(percent_or_power);
        let expected = ["0", "below 1e-9", "below 1e-9", "6.158e-6", "-1.92 %"];
        assert_eq!(shown, expected);
    }

    #[test]
    fn error_bars_set_the_digits() {
        for (value, error, text) in [
            (249.19, 0.34, "249.19 ± 0.34"),
            (1.0623, 0.05, "1.06 ± 0.05"),
            (1.0623, 0.052, "1.06 ± 0.05"),
            (1.2345, 0.0123, "1.234 ± 0.012"),
            (1.0623, 0.097, "1.06 ± 0.10"),
            (0.03, 0.05, "not resolved (at most 0.08)"),
            (-0.001, 0.5, "not resolved (at most 0.5)"),
            (0.03, 0.02, "not resolved (between 0.01 and 0.05)"),
            (0.03, 0.015, "0.030 ± 0.015"),
            (12345.0, 2345.0, "12300 ± 2300"),
            (12345.0, 678.0, "12300 ± 700"),
            (1.0, 1e-12, "1.00000 ± 0.00001"),
            (1.5e-7, 2e-8, "(1.50 ± 0.20)e-7"),
            (0.0, 0.0, "0"),
            (0.5, 0.0, "0.5 ± 0"),
        ] {
            assert_eq!(number(e(value, error)), text);
        }
        assert_eq!(
            number(Estimate {
                value: 0.034567,
                error: None
            }),
            "0.03457"
        );
    }

    #[test]
    fn units_suit_value_and_bar() {
        assert_eq!(estimate(&e(244.824e-9, 0.82e-9)), "244.8 ± 0.8 nm");
        assert_eq!(estimate(&e(1.2345e-6, 12.3e-9)), "1.234 ± 0.012 µm");
        assert_eq!(pressure_estimate(e(1.0623e9, 5e7)), "1.06 ± 0.05 GPa");
        assert_eq!(
            pressure_estimate(e(0.7e9, 2e9)),
            "not resolved (at most 2.7 GPa)"
        );
        assert_eq!(percent(e(0.3061, 0.0023)), "30.61 ± 0.23 %");
        assert_eq!(
            temperature(e(330.042, 0.4), Some(313.0)),
            "56.9 ± 0.4 °C (+17.0 K)"
        );
        assert_eq!(
            temperature(e(312.96, 0.4), Some(313.0)),
            "39.8 ± 0.4 °C (+0.0 K)"
        );
        assert_eq!(
            temperature(e(333.0, 12.0), Some(313.0)),
            "not resolved (between 48 and 72 °C)"
        );
        assert_eq!(temperature(e(318.9634, 0.0193), None), "45.81 ± 0.02 °C");
        let plain = Estimate {
            value: 310.0,
            error: None,
        };
        assert_eq!(temperature(plain, Some(313.0)), "36.85 °C (-3.00 K)");
    }

    /// By hand, for a film of 245.0 ± 0.8 nm: not stated are a bar of 150 nm, a missing bar that was requested, and a film of 20 mm on bodies of 16 mm.
    #[test]
    fn unresolved_figures_have_a_reason() {
        let asked = Asked {
            bars: true,
            slides: false,
            radius: 0.016,
        };
        let reason = |film: Estimate, asked| {
            let (_, mut solution) = sample::circle().clone();
            solution.summary.film_central = film;
            let found = Unresolved::all(&solution, asked);
            (found.iter().map(unresolved).collect::<Vec<_>>()).join("; ")
        };
        assert_eq!(reason(e(245e-9, 0.8e-9), asked), "");
        assert_eq!(
            reason(e(245e-9, 150e-9), asked),
            "the central film thickness (between 95 and 400 nm)"
        );
        let without = Estimate {
            value: 245e-9,
            error: None,
        };
        assert_eq!(
            reason(without, asked),
            "the central film thickness (no error bar could be computed)"
        );
        assert_eq!(
            reason(
                without,
                Asked {
                    bars: false,
                    ..asked
                }
            ),
            ""
        );
        assert_eq!(
            reason(e(0.02, 1e-4), asked),
            "the central film thickness (20 mm, beyond the radius)"
        );
    }

    /// A peak that the mesh cuts off is a lower bound; rounding does not raise it.
    #[test]
    fn peaks_that_are_not_resolved_are_lower_bounds() {
        let at = |value: f64, error: f64, resolved: bool| Located {
            value,
            error: Some(error),
            resolved,
            x: 0.0,
            y: 0.0,
            place_error: None,
            place_resolved: true,
        };
        assert_eq!(peak(&at(1.0112e9, 0.0013e9, true)), "1.0112 ± 0.0013 GPa");
        assert_eq!(
            peak(&at(1.0169e9, 0.34e9, false)),
            "at least 1.01 GPa, not resolved"
        );
        assert_eq!(
            peak(&at(7.2e8, 2.2e8, false)),
            "at least 720 MPa, not resolved"
        );
    }

    #[test]
    fn places_have_the_digits_of_their_bars() {
        let (_, solution) = sample::circle();
        let a = solution.hertz.half_width;
        let at = |y: f64, error: Option<f64>| {
            let at = Located {
                value: 1.0,
                error: None,
                resolved: true,
                x: 0.8754 * a,
                y: y * a,
                place_error: error.map(|error| error * a),
                place_resolved: error.is_none_or(|error| error <= 0.25),
            };
            place(solution, &at)
        };
        assert_eq!(at(0.0, None), "at x/a 0.875, y/a 0");
        assert_eq!(at(0.0, Some(0.04)), "at x/a 0.88 ± 0.04, y/a 0");
        assert_eq!(
            at(-0.906, Some(0.012)),
            "at x/a 0.875, y/a ±0.906, to 0.012"
        );
        assert_eq!(at(-0.906, Some(0.25)), "at x/a 0.88, y/a ±0.91, to 0.25");
        assert_eq!(at(-0.906, Some(0.27)), "place not resolved");
        assert_eq!(at(-0.906, Some(1e-7)), "at x/a 0.875, y/a ±0.906, to 0.001");
    }
}
