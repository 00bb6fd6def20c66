//! The free-volume law of Doolittle.

use crate::Scalar;
use crate::density::TaitVolume;
use crate::error::{Check, LawError};

/// Viscosity from free volume (Doolittle 1951; Habchi 2008, eqs. 2.20 and 2.21), with the Tait equation of state:
///
/// ```text
/// μ  = μ₀ exp{B R₀ [v∞ / (V/V_R - R₀ v∞) - 1/(1 - R₀)]}
/// v∞ = 1 + ε (T - T_R)
/// ```
///
/// `v∞` is the occupied volume relative to that at the reference temperature, R₀ the occupied share of the volume
/// there. At the pressure where the free volume `V/V_R - R₀ v∞` vanishes the formula is singular. Once it predicts
/// `ln(μ/μ₀) > 300` the reciprocal of the free volume continues as a parabola with the same value and two derivatives,
/// so that the viscosity keeps growing.
#[derive(Debug, Clone, PartialEq)]
pub struct Doolittle {
    /// Viscosity μ₀ at ambient pressure and reference temperature (Pa·s).
    pub mu_0: f64,
    /// Doolittle's constant B (-).
    pub b: f64,
    /// Occupied volume fraction R₀ at ambient pressure and reference temperature (-).
    pub occupied_fraction: f64,
    /// Expansion of the occupied volume; without it the constants are those of one isotherm.
    pub thermal: Option<OccupiedVolume>,
    /// Equation of state.
    pub volume: TaitVolume,
}

/// Temperature dependence of the occupied volume.
#[derive(Debug, Clone, PartialEq)]
pub struct OccupiedVolume {
    /// Reference temperature T_R (K).
    pub reference_temperature: f64,
    /// Expansivity ε of the occupied volume (1/K), negative as a rule.
    pub expansivity: f64,
}

/// `ln(μ/μ₀)` above which the singular reciprocal is replaced by its Taylor parabola.
const LARGEST_LN_RATIO: f64 = 300.0;

impl Doolittle {
    /// `mu_0` in Pa·s; `b` and `occupied_fraction` without dimension.
    pub fn new(
        mu_0: f64,
        b: f64,
        occupied_fraction: f64,
        thermal: Option<OccupiedVolume>,
        volume: TaitVolume,
    ) -> Result<Self, LawError> {
        let check = Check("doolittle");
        check.positive("mu_0", mu_0)?;
        check.positive("b", b)?;
        check.that(
            occupied_fraction > 0.0 && occupied_fraction < 1.0,
            "r_0",
            occupied_fraction,
            "between 0 and 1, both excluded",
        )?;
        if let Some(thermal) = &thermal {
            check.positive("reference_temperature", thermal.reference_temperature)?;
            check.finite("epsilon", thermal.expansivity)?;
        }
        Ok(Self {
            mu_0,
            b,
            occupied_fraction,
            thermal,
            volume,
        })
    }

    /// `ln μ`, μ in Pa·s, at `pressure` (Pa above ambient) and `temperature` (K).
    #[inline]
    pub fn ln_viscosity<D: Scalar>(&self, pressure: D, temperature: D) -> D {
        let occupied = match &self.thermal {
            None => D::from(1.0),
            Some(thermal) => {
                (temperature - thermal.reference_temperature) * thermal.expansivity + 1.0
            }
        };
        let free =
            self.volume.relative_volume(pressure, temperature) - occupied * self.occupied_fraction;

        let scale = self.b * self.occupied_fraction;
        let at_reference = scale / (1.0 - self.occupied_fraction);
        let smallest = occupied * (scale / (LARGEST_LN_RATIO + at_reference)); // where ln(μ/μ₀) = 300
        let reciprocal = if free.re() > smallest.re() {
            free.recip()
        } else {
            let e = free / smallest - 1.0;
            (-e + e * e + 1.0) / smallest
        };
        occupied * reciprocal * scale + (self.mu_0.ln() - at_reference)
    }
}
