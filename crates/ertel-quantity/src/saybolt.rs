//! Saybolt universal seconds, ASTM D2161.
//!
//! The time that 60 cm³ of an oil take through the orifice of the viscometer is not proportional to its viscosity. At 100 °F
//!
//! ```text
//! U = 4.6324 ν + (1 + 0.03264 ν)/[(3930.2 + 262.7 ν + 23.97 ν² + 1.646 ν³) 10⁻⁵]      ν in mm²/s, U in s
//! U_t = U [1 + 0.000061 (t − 100)]                                                   t in °F
//! ```

use super::number::split_number;

/// Names of the seconds.
pub(super) const NAMES: [&str; 5] = ["SUS", "SSU", "SUV", "sus", "ssu"];

/// Temperature (K) of the formula: 100 °F.
pub(super) const FAHRENHEIT_100: f64 = 310.927_777_777_777_8;

/// Smallest viscosity (mm²/s) and time (s) of the conversion.
const LEAST: [f64; 2] = [1.8, 31.9];
/// Largest viscosity (mm²/s) to look for.
const MOST: f64 = 1e7;

/// Whether a quantity is written in Saybolt seconds.
#[must_use]
pub fn is_saybolt(text: &str) -> bool {
    // Of "215 SUS ± 2 %" the first unit counts.
    let value = text.split(['±', '+']).next().unwrap_or_default();
    split_number(value.trim()).is_some_and(|(_, unit)| NAMES.contains(&unit))
}

/// Saybolt universal seconds of the kinematic viscosity `nu` (m²/s) at `temperature` (K).
#[must_use]
pub fn seconds(nu: f64, temperature: f64) -> f64 {
    let nu = 1e6 * nu;
    let cubic = 3930.2 + nu * (262.7 + nu * (23.97 + 1.646 * nu));
    let at_100 = 4.6324 * nu + (1.0 + 0.032_64 * nu) / (cubic * 1e-5);
    let fahrenheit = 1.8 * temperature - 459.67;
    at_100 * (1.0 + 6.1e-5 * (fahrenheit - 100.0))
}

/// Kinematic viscosity (m²/s) of `seconds` at `temperature` (K); NaN below 32 SUS, where the conversion ends.
#[must_use]
pub fn kinematic_viscosity(seconds: f64, temperature: f64) -> f64 {
    let of = |nu: f64| self::seconds(1e-6 * nu, temperature);
    let (mut low, mut high) = (LEAST[0], MOST);
    if seconds.is_nan() || seconds < LEAST[1] || seconds < of(low) || seconds > of(high) {
        return f64::NAN;
    }
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        match of(middle) < seconds {
            true => low = middle,
            false => high = middle,
        }
    }
    1e-6 * 0.5 * (low + high)
}

/// Kinematic viscosity (m²/s) at `temperature` (K) of the seconds that mean `nu` at 100 °F.
#[must_use]
pub fn corrected(nu: f64, temperature: f64) -> f64 {
    kinematic_viscosity(seconds(nu, FAHRENHEIT_100), temperature)
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// By hand from the formula, in mm²/s and seconds at 100 °F; 100 mm²/s are 463.5 SUS in the tables of the standard, 20 are 97.8.
    #[test]
    fn seconds_of_the_standard() {
        for (nu, expected) in [
            (2.0, 32.6),
            (20.0, 97.82),
            (46.0, 214.19),
            (100.0, 463.5),
            (320.0, 1482.4),
        ] {
            let found = seconds(1e-6 * nu, FAHRENHEIT_100);
            assert_relative_eq!(found, expected, max_relative = 1e-3);
            assert_relative_eq!(
                kinematic_viscosity(found, FAHRENHEIT_100),
                1e-6 * nu,
                max_relative = 1e-12
            );
        }
        // 210 °F: 1 + 0.000061 · 110 times as long.
        let ratio = seconds(8e-6, 372.038_888_888_9) / seconds(8e-6, FAHRENHEIT_100);
        assert_relative_eq!(ratio, 1.006_71, max_relative = 1e-9);
        assert!(kinematic_viscosity(30.0, FAHRENHEIT_100).is_nan());
        assert!(kinematic_viscosity(f64::NAN, FAHRENHEIT_100).is_nan());
    }
}
