//! Quantities of a dimension from text, and why a text is none.

use super::number::split_number;
use super::{Dimension, Unit, UnitError, comma};

/// Why a text is not the quantity asked for.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum QuantityError {
    /// The text does not start with a number.
    #[error("`{text}` does not start with a number (write for example `16 mm` or `2.2e-8 1/Pa`)")]
    NotANumber {
        /// The text as given.
        text: String,
    },
    /// The number is NaN, infinite or too large for a 64-bit float.
    #[error("`{text}` is not a finite number")]
    NotFinite {
        /// The text as given.
        text: String,
    },
    /// A comma within the number.
    #[error(
        "`{text}` has a comma in its number; write a decimal point: {}",
        comma::listed(readings)
    )]
    Comma {
        /// The text as given.
        text: String,
        /// Possible readings, as they are to be written; one or two.
        readings: Vec<String>,
    },
    /// A number without the required unit.
    #[error("`{text}` has no unit; {} is needed ({})", expected.name(), expected.examples())]
    MissingUnit {
        /// The text as given.
        text: String,
        /// The required dimension.
        expected: Dimension,
    },
    /// The unit cannot be read.
    #[error("`{text}`: {source}")]
    Unit {
        /// The text as given.
        text: String,
        /// The problem with the unit.
        source: UnitError,
    },
    /// The unit is known but measures something else.
    #[error(
        "`{text}` is {}, but {} is needed ({})",
        found.name(), expected.name(), expected.examples()
    )]
    WrongDimension {
        /// The text as given.
        text: String,
        /// The dimension of the text.
        found: Dimension,
        /// The required dimension.
        expected: Dimension,
    },
    /// The uncertainty cannot be read.
    #[error("`{text}`: {reason}")]
    Uncertainty {
        /// The text as given.
        text: String,
        /// The problem with it.
        reason: String,
    },
    /// Seconds of a Saybolt viscometer that no oil has.
    #[error("`{text}`: Saybolt seconds begin at 32 SUS (1.8 mm^2/s); write mm^2/s")]
    Saybolt {
        /// The text as given.
        text: String,
    },
    /// A temperature below 0 K.
    #[error("`{text}` is below absolute zero")]
    BelowAbsoluteZero {
        /// The text as given.
        text: String,
    },
}

/// Reads `text` as a quantity of dimension `expected` and returns its value in SI.
///
/// # Errors
///
/// [`QuantityError`] if the text is no number with a unit, or the unit measures something else. The value
/// returned is always finite.
///
/// ```
/// use ertel_quantity::{parse, Dimension};
/// assert_eq!(parse("16 mm", Dimension::LENGTH), Ok(0.016));
/// assert_eq!(parse("40 degC", Dimension::TEMPERATURE), Ok(313.15));
/// assert!(parse("100 mm", Dimension::FORCE).is_err());
/// ```
pub fn parse(text: &str, expected: Dimension) -> Result<f64, QuantityError> {
    let trimmed = text.trim();
    let own = || text.to_owned();
    let (number, unit_text) = split_number(trimmed).ok_or_else(|| {
        let unsigned = trimmed.trim_start_matches(['+', '-']).to_ascii_lowercase();
        if unsigned.starts_with("nan") || unsigned.starts_with("inf") {
            QuantityError::NotFinite { text: own() }
        } else {
            QuantityError::NotANumber { text: own() }
        }
    })?;
    if let Some(readings) = comma::readings(trimmed) {
        return Err(QuantityError::Comma {
            text: own(),
            readings,
        });
    }
    if unit_text.is_empty() && expected != Dimension::DIMENSIONLESS {
        return Err(QuantityError::MissingUnit {
            text: own(),
            expected,
        });
    }
    let unit = Unit::parse_as(unit_text, expected).map_err(|source| QuantityError::Unit {
        text: own(),
        source,
    })?;
    if !unit.dimension().same_exponents(expected) {
        return Err(QuantityError::WrongDimension {
            text: own(),
            found: unit.dimension(),
            expected,
        });
    }
    let value = if expected == Dimension::TEMPERATURE_DIFFERENCE {
        unit.difference_to_si(number)
    } else {
        unit.to_si(number)
    };
    if unit.is_saybolt() && !value.is_finite() {
        return Err(QuantityError::Saybolt { text: own() });
    }
    if !value.is_finite() {
        return Err(QuantityError::NotFinite { text: own() });
    }
    if expected == Dimension::TEMPERATURE && value < 0.0 {
        return Err(QuantityError::BelowAbsoluteZero { text: own() });
    }
    Ok(value)
}

impl QuantityError {
    /// Advice on what to write instead, beyond the units that fit.
    #[must_use]
    pub fn advice(&self) -> Option<String> {
        let Self::WrongDimension {
            text,
            found,
            expected,
        } = self
        else {
            return None;
        };
        let of =
            |found_wanted, expected_wanted| *found == found_wanted && *expected == expected_wanted;
        if of(Dimension::ANGULAR_SPEED, Dimension::SPEED) {
            return Some(of_rotation(text));
        }
        if of(Dimension::SHEAR_RATE, Dimension::ANGULAR_SPEED) {
            return Some("revolutions per minute are written \"3000 rpm\"".to_owned());
        }
        if *found == Dimension::SHEAR_RATE && *expected == Dimension::SPEED {
            return Some(of_rotation(text));
        }
        // A mass where a force is needed, alone or in a pressure.
        let gravity = Dimension::SPEED.per(Dimension::TIME);
        if found.times(gravity).same_exponents(*expected) {
            return Some("a weight is a force: write kgf for the weight of a kilogram, lbf for that of a pound".to_owned());
        }
        if of(Dimension::MASS, Dimension::FORCE_PER_LENGTH) {
            return Some(
                "a load per length is a force over a length: N/mm, kN/m, lbf/in".to_owned(),
            );
        }
        if of(Dimension::VISCOSITY, Dimension::KINEMATIC_VISCOSITY) {
            return Some(
                "the kinematic viscosity is the dynamic one over the density, ν = μ/ρ".to_owned(),
            );
        }
        if of(Dimension::DIMENSIONLESS, Dimension::KINEMATIC_VISCOSITY)
            || of(Dimension::ANGLE, Dimension::KINEMATIC_VISCOSITY)
        {
            return Some(
                "kinematic viscosities are read in mm^2/s, cSt and Saybolt seconds, \"215 SUS\""
                    .to_owned(),
            );
        }
        if of(Dimension::KINEMATIC_VISCOSITY, Dimension::VISCOSITY) {
            return Some(
                "the dynamic viscosity is the kinematic one times the density, μ = ν ρ; `kinematic_viscosity_40` and \
                 `kinematic_viscosity_100` of [lubricant] take the kinematic ones of a data sheet"
                    .to_owned(),
            );
        }
        None
    }
}

/// How to give a rotational speed where a surface speed is asked for.
fn of_rotation(text: &str) -> String {
    const DIAMETER: f64 = 0.02;
    let example = match parse(text, Dimension::ANGULAR_SPEED) {
        Ok(speed) => {
            let surface = 0.5 * speed * DIAMETER;
            let decimals = (3 - surface.abs().log10().floor() as i32).clamp(0, 9) as usize;
            let surface = format!("{surface:.decimals$}");
            format!("; with d = 20 mm, {} are \"{surface} m/s\"", text.trim())
        }
        Err(_) => String::new(),
    };
    format!(
        "a surface of the diameter d that turns n times per minute moves at u = π d n/60{example}; bearings, gears and cams of \
         [machine] take rpm (inner_ring_speed, pinion_speed, cam_speed)"
    )
}

/// Reads `text` as a quantity of whatever dimension its unit has: its value in SI, and what it measures; `None` for
/// anything else.
///
/// ```
/// use ertel_quantity::{parse_any, Dimension};
/// assert_eq!(parse_any("16 mm"), Some((0.016, Dimension::LENGTH)));
/// assert_eq!(parse_any("steel"), None);
/// ```
#[must_use]
pub fn parse_any(text: &str) -> Option<(f64, Dimension)> {
    let (number, unit) = split_number(text.trim())?;
    let unit = Unit::parse(unit).ok()?;
    let value = unit.to_si(number);
    value.is_finite().then_some((value, unit.dimension()))
}
