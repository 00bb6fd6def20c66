//! The Murnaghan equation of state.

use super::BulkModulusSoftening;
use crate::Scalar;
use crate::error::{Check, LawError};

/// Density from the equation of state of Murnaghan (Proc. Natl. Acad. Sci. 30, 1944, 244-247), with the temperature
/// terms of the Tait equation (Habchi, Finite Element Modeling of Elastohydrodynamic Lubrication Problems, 2018):
///
/// ```text
/// ρ      = ρ₀ / (V/V_R),   V/V_R = (V₀/V_R) (V/V₀)
/// V/V₀   = (1 + K₀' p / K₀)^(-1/K₀')
/// V₀/V_R = 1 + a_V (T - T_R)
/// K₀     = K₀R exp(-β_K T)
/// K₀'    = K₀R' exp(β_K' T)          T in kelvin
/// ```
///
/// Without the temperature terms, `K₀ = K₀R`, `K₀' = K₀R'` and `V₀ = V_R`: constants of one isotherm. The bulk modulus
/// `K₀ + K₀' p` is linear in pressure.
///
/// Theory: Murnaghan.
#[derive(Debug, Clone, PartialEq)]
pub struct Murnaghan {
    /// Density ρ₀ at ambient pressure and reference temperature (kg/m³).
    pub rho_0: f64,
    /// Bulk modulus factor K₀R (Pa): the bulk modulus extrapolated to 0 K, or that of the isotherm.
    pub bulk_modulus: f64,
    /// Factor K₀R' of the pressure derivative of the bulk modulus (-).
    pub bulk_modulus_slope: f64,
    /// Temperature terms; without them the constants are those of one isotherm.
    pub thermal: Option<BulkModulusSoftening>,
}

impl Murnaghan {
    /// `rho_0` in kg/m³, `bulk_modulus` in Pa, `bulk_modulus_slope` without dimension.
    pub fn new(
        rho_0: f64,
        bulk_modulus: f64,
        bulk_modulus_slope: f64,
        thermal: Option<BulkModulusSoftening>,
    ) -> Result<Self, LawError> {
        let check = Check("murnaghan");
        check.positive("rho_0", rho_0)?;
        check.positive("k_0r", bulk_modulus)?;
        check.positive("k_0r_prime", bulk_modulus_slope)?;
        if let Some(thermal) = &thermal {
            thermal.check(&check)?;
        }
        Ok(Self {
            rho_0,
            bulk_modulus,
            bulk_modulus_slope,
            thermal,
        })
    }

    /// Density (kg/m³) at `pressure` (Pa above ambient) and `temperature` (K).
    #[inline]
    pub fn density<D: Scalar>(&self, pressure: D, temperature: D) -> D {
        let (k_0, k_0_prime) = match &self.thermal {
            None => (D::from(self.bulk_modulus), D::from(self.bulk_modulus_slope)),
            Some(thermal) => thermal
                .bulk_modulus_and_slope((self.bulk_modulus, self.bulk_modulus_slope), temperature),
        };
        let compression = ((pressure * k_0_prime / k_0).ln_1p() / k_0_prime).exp(); // V₀/V
        let expansion = match &self.thermal {
            None => D::from(1.0),
            Some(thermal) => thermal.expansion(temperature),
        };
        compression / expansion * self.rho_0
    }
}
