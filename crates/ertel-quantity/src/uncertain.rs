//! Quantities with an uncertainty: `"40 mPa.s ± 5 %"`, `"16 mm ± 10 um"`, `"40 ± 2 mPa.s"`, `"[36, 44] mPa.s"`.
//!
//! The number after `±` (or `+-`, `+/-`) is half the width of the interval that holds the value with a probability of 95 %, of a normal
//! distribution: two standard deviations (JCGM 100:2008, 6.3.3, with the coverage factor k = 2). Limits in brackets are those of a
//! uniform distribution, of the standard deviation (b − a)/√12 (the same, 4.3.7), about its middle.

use super::number::split_number;
use super::{Dimension, QuantityError, parse};

/// Half a 95 % interval of a normal distribution over its standard deviation.
pub const COVERAGE: f64 = 2.0;

/// Standard deviations to either side at which a normal distribution is cut off: 6 of 100,000 values lie beyond.
pub const CUT: f64 = 4.0;

/// How a quantity is distributed, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Uncertainty {
    /// Normal about the value.
    Normal {
        /// Standard deviation.
        standard: f64,
    },
    /// Anywhere between two limits, the value in the middle.
    Uniform {
        /// Half the distance of the limits.
        half_width: f64,
    },
}

impl Uncertainty {
    /// Standard deviation.
    #[must_use]
    pub fn standard(self) -> f64 {
        match self {
            Self::Normal { standard } => standard,
            Self::Uniform { half_width } => half_width / 3.0_f64.sqrt(),
        }
    }

    /// How far from the value it reaches.
    #[must_use]
    pub fn reach(self) -> f64 {
        match self {
            Self::Normal { standard } => CUT * standard,
            Self::Uniform { half_width } => half_width,
        }
    }
}

/// Reads a quantity of dimension `expected` that may have an uncertainty: its value in SI, and that.
///
/// # Errors
///
/// As [`parse`]; an uncertainty of another dimension, one that is not positive, limits that are not in order.
///
/// ```
/// use ertel_quantity::{parse_uncertain, Dimension, Uncertainty};
/// let (value, uncertainty) = parse_uncertain("16 mm ± 5 %", Dimension::LENGTH)?;
/// assert_eq!(value, 0.016);
/// assert!((uncertainty.unwrap().standard() - 0.0004).abs() < 1e-18);
/// assert!(parse_uncertain("16 mm ± 1 N", Dimension::LENGTH).is_err());
/// # Ok::<(), ertel_quantity::QuantityError>(())
/// ```
pub fn parse_uncertain(
    text: &str,
    expected: Dimension,
) -> Result<(f64, Option<Uncertainty>), QuantityError> {
    let trimmed = text.trim();
    if let Some(rest) = trimmed.strip_prefix('[') {
        return limits(text, rest, expected);
    }
    let Some((value, deviation)) = split(trimmed) else {
        return parse(text, expected).map(|value| (value, None));
    };
    let wrong = |reason: &str| QuantityError::Uncertainty {
        text: text.to_owned(),
        reason: reason.to_owned(),
    };
    let (_, unit) = split_number(deviation).ok_or_else(|| wrong("no number follows the ±"))?;
    if super::is_saybolt(deviation) {
        return Err(wrong(
            "differences of Saybolt seconds are none of viscosity; write the ± in % or mm^2/s",
        ));
    }
    // "40 ± 2 mPa.s": one unit for both.
    let shared;
    let alone = split_number(value).is_some_and(|(_, unit)| unit.is_empty());
    let value = match alone && unit != "%" && !unit.is_empty() {
        true => {
            shared = format!("{value} {unit}");
            shared.as_str()
        }
        false => value,
    };
    let value = parse(value, expected)?;
    let half_width = if unit == "%" {
        if expected == Dimension::TEMPERATURE {
            return Err(wrong(
                "per cent of a temperature depend on its scale; write the ± in K",
            ));
        }
        // "%" alone is no unit of the value here but a share of it.
        value.abs() * parse(deviation, Dimension::DIMENSIONLESS)?
    } else {
        let dimension = match expected {
            Dimension::TEMPERATURE => Dimension::TEMPERATURE_DIFFERENCE,
            dimension => dimension,
        };
        parse(deviation, dimension)?
    };
    if half_width <= 0.0 {
        return Err(wrong("what follows the ± must be above zero"));
    }
    let standard = half_width / COVERAGE;
    Ok((value, Some(Uncertainty::Normal { standard })))
}

/// The parts before and after the sign.
fn split(text: &str) -> Option<(&str, &str)> {
    let signs = ["±", "+/-", "+-"];
    let (value, deviation) = signs.iter().find_map(|sign| text.split_once(sign))?;
    Some((value.trim(), deviation.trim()))
}

/// `a, b] unit`.
fn limits(
    text: &str,
    rest: &str,
    expected: Dimension,
) -> Result<(f64, Option<Uncertainty>), QuantityError> {
    let wrong = |reason: &str| QuantityError::Uncertainty {
        text: text.to_owned(),
        reason: reason.to_owned(),
    };
    let (inner, unit) =
        (rest.split_once(']')).ok_or_else(|| wrong("the bracket of the limits is not closed"))?;
    let ends: Vec<&str> = inner.split(',').map(str::trim).collect();
    let [low, high] = ends[..] else {
        return Err(wrong("there must be two limits, as in \"[36, 44] mPa.s\""));
    };
    let end = |number: &str| parse(&format!("{number} {}", unit.trim()), expected);
    let (low, high) = (end(low)?, end(high)?);
    if low >= high {
        return Err(wrong("the first limit must be below the second"));
    }
    let half_width = 0.5 * (high - low);
    Ok((
        0.5 * (low + high),
        Some(Uncertainty::Uniform { half_width }),
    ))
}

/// Correlation of two quantities with an uncertainty.
#[derive(Clone, Debug, PartialEq)]
pub struct Correlation {
    /// Their key paths.
    pub keys: [String; 2],
    /// Correlation coefficient, between −1 and 1.
    pub coefficient: f64,
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn standard(text: &str, dimension: Dimension) -> (f64, f64) {
        let (value, uncertainty) = parse_uncertain(text, dimension).unwrap();
        (value, uncertainty.map_or(0.0, Uncertainty::standard))
    }

    /// By hand: half of 5 % of 40 mPa.s is 1 mPa.s; 8 mPa.s between limits are 8/√12.
    #[test]
    fn written_in_all_ways() {
        let viscosity = Dimension::VISCOSITY;
        for text in [
            "40 mPa.s ± 5 %",
            "40 mPa.s +- 2 mPa.s",
            "40 ± 2 mPa.s",
            "0.04 Pa.s+/-2 mPa.s",
        ] {
            let (value, deviation) = standard(text, viscosity);
            assert_relative_eq!(value, 0.04, max_relative = 1e-15);
            assert_relative_eq!(deviation, 1e-3, max_relative = 1e-12);
        }
        let (value, deviation) = standard("[36, 44] mPa.s", viscosity);
        assert_relative_eq!(value, 0.04, max_relative = 1e-15);
        assert_relative_eq!(deviation, 8e-3 / 12.0_f64.sqrt(), max_relative = 1e-12);
        let (value, deviation) = standard("40 degC ± 2 K", Dimension::TEMPERATURE);
        assert_eq!((value, deviation), (313.15, 1.0));
        let (value, deviation) = standard("-0.3 ± 10 %", Dimension::DIMENSIONLESS);
        assert_relative_eq!(value, -0.3);
        assert_relative_eq!(deviation, 0.015, max_relative = 1e-12);
        assert_eq!(standard("16 mm", Dimension::LENGTH), (0.016, 0.0));
    }

    #[test]
    fn wrong_ones_are_refused() {
        for (text, dimension, part) in [
            ("40 mPa.s ± 2 mm", Dimension::VISCOSITY, "a length"),
            ("40 mPa.s ± 2", Dimension::VISCOSITY, "has no unit"),
            ("40 mPa.s ±", Dimension::VISCOSITY, "no number"),
            ("40 mPa.s ± 0 %", Dimension::VISCOSITY, "above zero"),
            ("40 mPa.s ± -5 %", Dimension::VISCOSITY, "above zero"),
            ("40 mPa.s ± nan %", Dimension::VISCOSITY, "no number"),
            ("40 degC ± 5 %", Dimension::TEMPERATURE, "in K"),
            ("[44, 36] mPa.s", Dimension::VISCOSITY, "below the second"),
            ("[36, 40, 44] mPa.s", Dimension::VISCOSITY, "two limits"),
            ("[36, 44 mPa.s", Dimension::VISCOSITY, "not closed"),
            ("[36, 44]", Dimension::VISCOSITY, "no unit"),
        ] {
            let error = parse_uncertain(text, dimension).unwrap_err().to_string();
            assert!(error.contains(part), "{text}: {error}");
        }
    }
}
