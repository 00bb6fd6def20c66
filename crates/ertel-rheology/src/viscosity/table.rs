//! Tabulated viscosity.

use crate::interpolation::Isotherms;
use crate::{LawError, Scalar};

/// Viscosity interpolated in a table over pressure and temperature.
///
/// `ln μ` is interpolated by monotone cubics (PCHIP) in pressure along each isotherm, then in temperature: exact at the
/// knots, continuous slope, no overshoot. Beyond the first and last pressure or temperature `ln μ` continues in a
/// straight line.
///
/// Theory: Viscosity, Table.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// Of `ln μ`.
    isotherms: Isotherms,
}

impl Table {
    /// One isotherm for each of `temperatures` (K, increasing): `pressures[i]` (Pa above ambient, increasing) and
    /// `viscosities[i]` (Pa·s, positive) of equal length, at least two. Isotherms may have different pressures.
    pub fn new(
        temperatures: Vec<f64>,
        pressures: Vec<Vec<f64>>,
        viscosities: Vec<Vec<f64>>,
    ) -> Result<Self, LawError> {
        Ok(Self {
            isotherms: Isotherms::new(temperatures, pressures, viscosities)?.map(f64::ln),
        })
    }

    /// `ln μ`, μ in Pa·s, at `pressure` (Pa above ambient) and `temperature` (K).
    #[inline]
    pub fn ln_viscosity<D: Scalar>(&self, pressure: D, temperature: D) -> D {
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
