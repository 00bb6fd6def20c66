//! Tabulated thermal conductivity.

use crate::interpolation::Isotherms;
use crate::{LawError, Scalar};

/// Conductivity interpolated in a table over pressure and temperature.
///
/// Monotone cubic (PCHIP) in pressure along each isotherm, then in temperature: exact at the knots, no overshoot.
/// Beyond the first and last pressure or temperature the end value holds.
///
/// Theory: Conductivity and heat capacity, Table.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    isotherms: Isotherms,
}

impl Table {
    /// One isotherm for each of `temperatures` (K, increasing): `pressures[i]` (Pa above ambient, increasing) and
    /// `conductivities[i]` (W/(m·K), positive) of equal length; an isotherm of one pressure does not depend on it.
    pub fn new(
        temperatures: Vec<f64>,
        pressures: Vec<Vec<f64>>,
        conductivities: Vec<Vec<f64>>,
    ) -> Result<Self, LawError> {
        Ok(Self {
            isotherms: Isotherms::held(temperatures, pressures, conductivities)?,
        })
    }

    /// Conductivity (W/(m·K)) at `pressure` (Pa above ambient) and `temperature` (K).
    #[inline]
    pub fn conductivity<D: Scalar>(&self, pressure: D, temperature: D) -> D {
        self.isotherms.evaluate(pressure, temperature)
    }

    /// Range `(min, max)` of pressure (Pa) and temperature (K) that every isotherm covers.
    pub fn range(&self) -> [(f64, f64); 2] {
        self.isotherms.range()
    }
}
