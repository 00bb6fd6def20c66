//! The law of Roelands.

use crate::Scalar;
use crate::error::{Check, LawError};

/// Viscosity after Roelands (1966; Habchi 2008, eq. 2.18):
///
/// ```text
/// μ  = μ₀ exp{(ln μ₀ + 9.67) [-1 + (1 + p/p₀)^Z ((T - 138)/(T_R - 138))^(-S₀)]}
/// Z  = α p₀ / (ln μ₀ + 9.67)
/// S₀ = β (T_R - 138) / (ln μ₀ + 9.67)
/// ```
///
/// μ₀ in Pa·s, T in kelvin. Roelands' own pressure constant is 1/p₀ = 5.1e-9 1/Pa.
#[derive(Debug, Clone, PartialEq)]
pub struct Roelands {
    /// Viscosity μ₀ at ambient pressure and reference temperature (Pa·s).
    pub mu_0: f64,
    /// Pressure-viscosity index Z (-).
    pub pressure_index: f64,
    /// Pressure constant p₀ (Pa).
    pub p_0: f64,
    /// Temperature dependence; without it the viscosity depends on pressure only.
    pub thermal: Option<TemperatureSlope>,
    /// ln μ₀, worked out once.
    ln_mu_0: f64,
}

/// Temperature dependence of Roelands' law.
#[derive(Debug, Clone, PartialEq)]
pub struct TemperatureSlope {
    /// Temperature T_R at which μ₀ holds (K).
    pub reference_temperature: f64,
    /// Temperature-viscosity coefficient `β = -d ln μ/dT` at T_R and ambient pressure (1/K).
    pub beta: f64,
}

/// `-ln μ` of the pole where all isotherms meet, μ in Pa·s.
const POLE_LN_VISCOSITY: f64 = 9.67;
/// Temperature of the pole (K).
const POLE_TEMPERATURE: f64 = 138.0;

impl Roelands {
    /// The law's own pressure constant p₀ = 1/5.1e-9 (Pa).
    pub const PRESSURE_CONSTANT: f64 = 1.0 / 5.1e-9;

    /// From the initial slope `alpha` (1/Pa); `mu_0` in Pa·s, `p_0` in Pa.
    pub fn from_alpha(
        mu_0: f64,
        alpha: f64,
        p_0: f64,
        thermal: Option<TemperatureSlope>,
    ) -> Result<Self, LawError> {
        let check = Check("roelands");
        check_viscosity(&check, mu_0)?;
        check.not_negative("alpha", alpha)?;
        check.positive("p_0", p_0)?;
        Self::from_index(
            mu_0,
            alpha * p_0 / (mu_0.ln() + POLE_LN_VISCOSITY),
            p_0,
            thermal,
        )
    }

    /// From the index `pressure_index` Z (-); `mu_0` in Pa·s, `p_0` in Pa.
    pub fn from_index(
        mu_0: f64,
        pressure_index: f64,
        p_0: f64,
        thermal: Option<TemperatureSlope>,
    ) -> Result<Self, LawError> {
        let check = Check("roelands");
        check_viscosity(&check, mu_0)?;
        check.not_negative("z", pressure_index)?;
        check.positive("p_0", p_0)?;
        if let Some(thermal) = &thermal {
            check.that(
                thermal.reference_temperature > POLE_TEMPERATURE,
                "reference_temperature",
                thermal.reference_temperature,
                "above 138 K, the pole of the law",
            )?;
            check.not_negative("beta", thermal.beta)?;
        }
        Ok(Self {
            mu_0,
            pressure_index,
            p_0,
            thermal,
            ln_mu_0: mu_0.ln(),
        })
    }

    /// `ln μ`, μ in Pa·s, at `pressure` (Pa above ambient) and `temperature` (K, above 138).
    #[inline]
    pub fn ln_viscosity<D: Scalar>(&self, pressure: D, temperature: D) -> D {
        let ln_mu_0 = self.ln_mu_0;
        let height = ln_mu_0 + POLE_LN_VISCOSITY; // ln(μ₀/μ∞)
        // ln[(1 + p/p₀)^Z ((T - 138)/(T_R - 138))^(-S₀)]
        let mut exponent = (pressure / self.p_0).ln_1p() * self.pressure_index;
        if let Some(thermal) = &self.thermal {
            let span = thermal.reference_temperature - POLE_TEMPERATURE;
            let s_0 = thermal.beta * span / height;
            exponent -= ((temperature - POLE_TEMPERATURE) / span).ln() * s_0;
        }
        exponent.exp_m1() * height + ln_mu_0
    }
}

fn check_viscosity(check: &Check, mu_0: f64) -> Result<(), LawError> {
    check.positive("mu_0", mu_0)?;
    check.that(
        mu_0.ln() + POLE_LN_VISCOSITY > 0.0,
        "mu_0",
        mu_0,
        "above 6.315e-5 Pa.s, the pole of the law (ln mu_0 + 9.67 > 0)",
    )
}
