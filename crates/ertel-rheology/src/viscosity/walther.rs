//! Kinematic viscosity over temperature by Walther's equation, with a law of pressure.

use std::f64::consts::LN_10;

use super::Roelands;
use crate::error::{Check, LawError};
use crate::{DensityLaw, Scalar};

/// Viscosity of an oil of which the data sheet gives the kinematic viscosity at two temperatures:
///
/// ```text
/// μ(p, T)   = ν(T) ρ(0, T) exp{...}
/// lg lg z   = A - B lg T,   z = ν + 0.7 + exp(-1.47 - 1.84 ν - 0.51 ν²)     ν in mm²/s, T in kelvin
/// Roelands:   exp{(ln μ₀ + 9.67) [(1 + p/p₀)^Z - 1]},   μ₀ = ν(T) ρ(0, T),   1/p₀ = 5.1e-9 1/Pa
/// Barus:      exp(α p)
/// ```
///
/// Over temperature the equation of Walther and MacCoull as in ASTM D341, whose exponential term matters below 2 mm²/s;
/// `ν` follows from `z` by the practice's approximation `ν = y - exp(-0.7487 - 3.295 y + 0.6119 y² - 0.3193 y³)`,
/// `y = z - 0.7`. The index Z follows from the coefficient α at the reference temperature; at others the initial slope is
/// `Z (ln μ₀(T) + 9.67)/p₀`. Above the temperature where that would vanish (μ₀ = 63 µPa·s) pressure has no influence.
///
/// Of an oil whose coefficient is known at two temperatures, Z (of Barus: α) is proportional to a power of the absolute temperature,
///
/// ```text
/// Z(T) = Z(T_R) (T/T_R)^k        Barus:  α(T) = α(T_R) (T/T_R)^k
/// ```
///
/// which is positive and monotone at every temperature. k = 0, the same index at every temperature, is Roelands' law itself. He
/// lets Z follow `C + D lg(1 + t/135)`, t in degC, which is within 1 % of the power between 30 and 100 degC but negative
/// somewhere.
///
/// Theory: Walther.
/// Theory: Coefficients at two temperatures.
#[derive(Debug, Clone, PartialEq)]
pub struct Walther {
    /// Constant A of Walther's equation (-).
    pub a: f64,
    /// Constant B of Walther's equation (-).
    pub b: f64,
    /// Density law of the same lubricant.
    pub density: DensityLaw,
    /// Pressure-viscosity coefficient α at ambient pressure and the reference temperature (1/Pa).
    pub alpha: f64,
    /// Reference temperature T_R at which `alpha` holds (K).
    pub reference_temperature: f64,
    /// Exponent k of the absolute temperature in the index Z, of Barus in α (-).
    pub alpha_exponent: f64,
    /// How the viscosity grows with pressure.
    pub pressure: PressureLaw,
}

/// How the viscosity grows with pressure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PressureLaw {
    /// As in the law of Roelands.
    Roelands,
    /// As in the law of Barus.
    Barus,
}

impl PressureLaw {
    /// The laws with their names in data files.
    pub const NAMES: [(&'static str, PressureLaw); 2] =
        [("roelands", Self::Roelands), ("barus", Self::Barus)];
}

/// `-ln μ` of the pole of Roelands' law, μ in Pa·s.
const POLE_LN_VISCOSITY: f64 = 9.67;
/// mm²/s in m²/s.
const SQUARE_MILLIMETRE: f64 = 1e-6;

impl Walther {
    /// The law with its constants.
    ///
    /// # Errors
    ///
    /// Constants that are not finite, B not positive, a viscosity at the reference temperature that is not above the
    /// pole of Roelands' law, negative α.
    pub fn new(constants: Self) -> Result<Self, LawError> {
        let check = Check("walther");
        check.finite("a", constants.a)?;
        check.positive("b", constants.b)?;
        check.not_negative("alpha", constants.alpha)?;
        check.positive("reference_temperature", constants.reference_temperature)?;
        check.finite("alpha_exponent", constants.alpha_exponent)?;
        let ln_mu = constants.ln_ambient(constants.reference_temperature);
        check.that(
            ln_mu > -POLE_LN_VISCOSITY && ln_mu < 30.0,
            "a",
            constants.a,
            "such that the viscosity at the reference temperature lies between 6.315e-5 Pa.s and 1e13 Pa.s",
        )?;
        Ok(constants)
    }

    /// A and B from the kinematic viscosities (m²/s) at two temperatures (K).
    pub fn constants([(t_1, nu_1), (t_2, nu_2)]: [(f64, f64); 2]) -> (f64, f64) {
        let lg_lg_z = |nu: f64| z(nu / SQUARE_MILLIMETRE).log10().log10();
        let b = (lg_lg_z(nu_1) - lg_lg_z(nu_2)) / (t_2 / t_1).log10();
        (lg_lg_z(nu_1) + b * t_1.log10(), b)
    }

    /// Kinematic viscosity (m²/s) at ambient pressure and `temperature` (K).
    #[inline]
    pub fn kinematic_viscosity<D: Scalar>(&self, temperature: D) -> D {
        ln_kinematic_viscosity((self.a, self.b), temperature).exp()
    }

    /// The same of constants `a` and `b` alone.
    #[must_use]
    pub fn kinematic_viscosity_of(a: f64, b: f64, temperature: f64) -> f64 {
        ln_kinematic_viscosity((a, b), temperature).exp()
    }

    /// `ln μ` at ambient pressure, μ in Pa·s, and `temperature` (K).
    #[inline]
    fn ln_ambient<D: Scalar>(&self, temperature: D) -> D {
        ln_kinematic_viscosity((self.a, self.b), temperature)
            + self.density.density(D::from(0.0), temperature).ln()
    }

    /// Exponent k with which the initial slope is `alpha_1` and `alpha_2` (1/Pa) at two temperatures (K), whatever `alpha` is:
    ///
    /// ```text
    /// k = ln(Z₂/Z₁)/ln(T₂/T₁),   Z = α p₀/(ln μ₀(T) + 9.67);   Barus: α instead of Z
    /// ```
    ///
    /// `None` where a viscosity is not above the pole of Roelands' law, or a coefficient not above zero.
    #[must_use]
    pub fn exponent(&self, [(t_1, alpha_1), (t_2, alpha_2)]: [(f64, f64); 2]) -> Option<f64> {
        let index = |temperature: f64, alpha: f64| match self.pressure {
            PressureLaw::Barus => alpha,
            PressureLaw::Roelands => alpha / (self.ln_ambient(temperature) + POLE_LN_VISCOSITY),
        };
        let [z_1, z_2] = [index(t_1, alpha_1), index(t_2, alpha_2)];
        let exponent = (z_2 / z_1).ln() / (t_2 / t_1).ln();
        (z_1 > 0.0 && z_2 > 0.0 && exponent.is_finite()).then_some(exponent)
    }

    /// `rise` as it is at the reference temperature, at `temperature` (K).
    #[inline]
    fn at<D: Scalar>(&self, temperature: D, rise: D) -> D {
        if self.alpha_exponent == 0.0 {
            return rise;
        }
        rise * ((temperature / self.reference_temperature).ln() * self.alpha_exponent).exp()
    }

    /// `ln μ`, μ in Pa·s, at `pressure` (Pa above ambient) and `temperature` (K).
    #[inline]
    pub fn ln_viscosity<D: Scalar>(&self, pressure: D, temperature: D) -> D {
        let ambient = self.ln_ambient(temperature);
        match self.pressure {
            PressureLaw::Barus => ambient + self.at(temperature, pressure * self.alpha),
            PressureLaw::Roelands => {
                let height = ambient + POLE_LN_VISCOSITY;
                if height.re() <= 0.0 {
                    return ambient;
                }
                let p_0 = Roelands::PRESSURE_CONSTANT;
                let at_reference = self.ln_ambient(self.reference_temperature) + POLE_LN_VISCOSITY;
                let index = self.alpha * p_0 / at_reference;
                let exponent = self.at(temperature, (pressure / p_0).ln_1p() * index);
                ambient + height * exponent.exp_m1()
            }
        }
    }
}

/// `z` of Walther's equation from ν in mm²/s.
fn z(nu: f64) -> f64 {
    nu + 0.7 + (-1.47 - 1.84 * nu - 0.51 * nu * nu).exp()
}

/// `lg z` above which the corrections in `ν` lie below the last digit.
const LARGE_LG_Z: f64 = 20.0;

/// `ln ν` (ν in m²/s) at ambient pressure and `temperature` (K) from Walther's constants A and B.
#[inline]
fn ln_kinematic_viscosity<D: Scalar>((a, b): (f64, f64), temperature: D) -> D {
    let lg_z = (-temperature.ln() * b + a * LN_10).exp();
    let ln_z = lg_z * LN_10;
    let ln_nu = if lg_z.re() > LARGE_LG_Z {
        ln_z
    } else {
        let y = ln_z.exp() - 0.7;
        let correction = -(y * (y * (y * 0.3193 - 0.6119) + 3.295)) - 0.7487;
        (y - correction.exp()).ln()
    };
    ln_nu + SQUARE_MILLIMETRE.ln()
}
