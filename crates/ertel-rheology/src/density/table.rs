//! Tabulated density.

use crate::interpolation::Isotherms;
use crate::{LawError, Scalar};

/// Density interpolated in a table over pressure and temperature.
///
/// Monotone cubic (PCHIP) in pressure along each isotherm, then in temperature: exact at the knots, continuous slope,
/// no overshoot. Beyond the first and last pressure or temperature it continues in a straight line.
///
/// Theory: Viscosity, Table.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    isotherms: Isotherms,
}

impl Table {
    /// One isotherm for each of `temperatures` (K, increasing): `pressures[i]` (Pa above ambient, increasing) and
    /// `densities[i]` (kg/m³, positive) of equal length, at least two. Isotherms may have different pressures.
    pub fn new(
        temperatures: Vec<f64>,
        pressures: Vec<Vec<f64>>,
        densities: Vec<Vec<f64>>,
    ) -> Result<Self, LawError> {
        Ok(Self {
            isotherms: Isotherms::new(temperatures, pressures, densities)?,
        })
    }

    /// Density (kg/m³) at `pressure` (Pa above ambient) and `temperature` (K).
    #[inline]
    pub fn density<D: Scalar>(&self, pressure: D, temperature: D) -> D {
        self.isotherms.evaluate(pressure, temperature)
    }

    /// Whether there is more than one isotherm.
    pub fn depends_on_temperature(&self) -> bool {
        self.isotherms.depends_on_temperature()
    }

    /// Range `(min, max)` of pressure (Pa) and temperature (K) that every isotherm covers.
    pub fn range(&self) -> [(f64, f64); 2] {
        self.isotherms.range()
    }
}
