//! The Tait equation of state.

use crate::Scalar;
use crate::error::{Check, LawError};

/// Density from the Tait equation of state (Habchi 2008, eq. 2.15): `ρ = ρ₀ / (V/V_R)`.
#[derive(Debug, Clone, PartialEq)]
pub struct Tait {
    /// Density ρ₀ at ambient pressure and reference temperature (kg/m³).
    pub rho_0: f64,
    /// The relative volume `V/V_R`.
    pub volume: TaitVolume,
}

impl Tait {
    /// Checks that `rho_0` (kg/m³) is positive.
    pub fn new(rho_0: f64, volume: TaitVolume) -> Result<Self, LawError> {
        Check("tait").positive("rho_0", rho_0)?;
        Ok(Self { rho_0, volume })
    }

    /// Density (kg/m³) at `pressure` (Pa above ambient) and `temperature` (K).
    #[inline]
    pub fn density<D: Scalar>(&self, pressure: D, temperature: D) -> D {
        self.volume.relative_volume(pressure, temperature).recip() * self.rho_0
    }
}

/// Volume relative to that at ambient pressure and reference temperature (Habchi 2008, eqs. 2.11 to 2.14):
///
/// ```text
/// V/V_R  = (V₀/V_R) (V/V₀)
/// V/V₀   = 1 - ln[1 + (1 + K₀') p / K₀] / (1 + K₀')
/// V₀/V_R = 1 + a_V (T - T_R)
/// K₀     = K₀R exp(-β_K T)
/// K₀'    = K₀R' exp(β_K' T)          T in kelvin
/// ```
///
/// Without the temperature terms, `K₀ = K₀R`, `K₀' = K₀R'` and `V₀ = V_R`: constants of one isotherm.
#[derive(Debug, Clone, PartialEq)]
pub struct TaitVolume {
    /// Bulk modulus factor K₀R (Pa): the bulk modulus extrapolated to 0 K, or that of the isotherm.
    pub bulk_modulus: f64,
    /// Factor K₀R' of the pressure derivative of the bulk modulus (-).
    pub bulk_modulus_slope: f64,
    /// Temperature terms; without them the constants are those of one isotherm.
    pub thermal: Option<BulkModulusSoftening>,
}

/// Temperature terms of the Tait equation.
#[derive(Debug, Clone, PartialEq)]
pub struct BulkModulusSoftening {
    /// Reference temperature T_R (K), where `V₀ = V_R`.
    pub reference_temperature: f64,
    /// Coefficient β_K of the bulk modulus (1/K).
    pub bulk_modulus_coefficient: f64,
    /// Coefficient β_K' of its pressure derivative (1/K).
    pub bulk_modulus_slope_coefficient: f64,
    /// Thermal expansivity a_V at ambient pressure (1/K).
    pub expansivity: f64,
}

impl BulkModulusSoftening {
    /// Checks the constants for a law.
    pub(super) fn check(&self, check: &Check) -> Result<(), LawError> {
        check.positive("reference_temperature", self.reference_temperature)?;
        check.finite("beta_k", self.bulk_modulus_coefficient)?;
        check.finite("beta_k_prime", self.bulk_modulus_slope_coefficient)?;
        // V₀ must stay positive down to 0 K; expansion upwards has no limit.
        check.that(
            self.expansivity >= 0.0 && self.expansivity * self.reference_temperature < 1.0,
            "a_v",
            self.expansivity,
            "zero or positive and below 1/T_R, else the volume vanishes on cooling",
        )
    }

    /// K₀ (Pa) and K₀' (-) at `temperature` (K), from the factors K₀R (Pa) and K₀R' (-).
    #[inline]
    pub(super) fn bulk_modulus_and_slope<D: Scalar>(
        &self,
        (bulk_modulus, slope): (f64, f64),
        temperature: D,
    ) -> (D, D) {
        (
            (temperature * -self.bulk_modulus_coefficient).exp() * bulk_modulus,
            (temperature * self.bulk_modulus_slope_coefficient).exp() * slope,
        )
    }

    /// V₀/V_R at `temperature` (K).
    #[inline]
    pub(super) fn expansion<D: Scalar>(&self, temperature: D) -> D {
        (temperature - self.reference_temperature) * self.expansivity + 1.0
    }
}

impl TaitVolume {
    /// `bulk_modulus` in Pa, `bulk_modulus_slope` without dimension.
    pub fn new(
        bulk_modulus: f64,
        bulk_modulus_slope: f64,
        thermal: Option<BulkModulusSoftening>,
    ) -> Result<Self, LawError> {
        let check = Check("tait");
        check.positive("k_0r", bulk_modulus)?;
        check.positive("k_0r_prime", bulk_modulus_slope)?;
        if let Some(thermal) = &thermal {
            thermal.check(&check)?;
        }
        Ok(Self {
            bulk_modulus,
            bulk_modulus_slope,
            thermal,
        })
    }

    /// Bulk modulus K₀ (Pa) and its pressure derivative K₀' (-) at ambient pressure and `temperature` (K).
    #[inline]
    pub fn bulk_modulus_and_slope<D: Scalar>(&self, temperature: D) -> (D, D) {
        match &self.thermal {
            None => (D::from(self.bulk_modulus), D::from(self.bulk_modulus_slope)),
            Some(thermal) => thermal
                .bulk_modulus_and_slope((self.bulk_modulus, self.bulk_modulus_slope), temperature),
        }
    }

    /// Relative volume `V/V_R` at `pressure` (Pa above ambient) and `temperature` (K).
    #[inline]
    pub fn relative_volume<D: Scalar>(&self, pressure: D, temperature: D) -> D {
        let (k_0, k_0_prime) = self.bulk_modulus_and_slope(temperature);
        let n = k_0_prime + 1.0;
        let compression = -(pressure * n / k_0).ln_1p() / n + 1.0; // V/V₀
        match &self.thermal {
            None => compression,
            Some(thermal) => compression * thermal.expansion(temperature),
        }
    }
}
