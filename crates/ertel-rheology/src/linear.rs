//! The factor of properties that are linear in pressure and temperature.

use crate::Scalar;
use crate::error::{Check, LawError};

/// `1 + a_T (T - T_R) + a_p p`, limited to a tenth from below.
#[derive(Debug, Clone, PartialEq)]
pub struct LinearFactor {
    /// Temperature T_R at which the factor is one (K).
    pub reference_temperature: f64,
    /// Coefficient a_T of the temperature (1/K).
    pub temperature_coefficient: f64,
    /// Coefficient a_p of the pressure (1/Pa).
    pub pressure_coefficient: f64,
}

/// Share below which no property falls: a straight line from measured states reaches it only where it has lost its
/// meaning, and heat equations need a positive number there, too.
pub(crate) const SMALLEST: f64 = 0.1;

impl LinearFactor {
    /// `reference_temperature` in K, `temperature_coefficient` in 1/K, `pressure_coefficient` in 1/Pa.
    ///
    /// # Errors
    ///
    /// Numbers that are not finite, a reference temperature that is not positive.
    pub fn new(
        reference_temperature: f64,
        temperature_coefficient: f64,
        pressure_coefficient: f64,
    ) -> Result<Self, LawError> {
        let check = Check("linear");
        check.positive("reference_temperature", reference_temperature)?;
        check.finite("a_t", temperature_coefficient)?;
        check.finite("a_p", pressure_coefficient)?;
        Ok(Self {
            reference_temperature,
            temperature_coefficient,
            pressure_coefficient,
        })
    }

    /// The factor at `pressure` (Pa above ambient) and `temperature` (K).
    #[inline]
    pub fn value<D: Scalar>(&self, pressure: D, temperature: D) -> D {
        let warming = (temperature - self.reference_temperature) * self.temperature_coefficient;
        at_least_smallest(warming + pressure * self.pressure_coefficient + 1.0)
    }
}

/// `pressure`, or zero below ambient.
#[inline]
pub(crate) fn not_below_ambient<D: Scalar>(pressure: D) -> D {
    if pressure.re() < 0.0 {
        D::from(0.0)
    } else {
        pressure
    }
}

/// `factor`, or the smallest share where it falls below.
#[inline]
pub(crate) fn at_least_smallest<D: Scalar>(factor: D) -> D {
    if factor.re() < SMALLEST {
        D::from(SMALLEST)
    } else {
        factor
    }
}
