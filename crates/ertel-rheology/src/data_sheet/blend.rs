//! Blends of oils, by mass.
//!
//! Theory: Blends.

use thiserror::Error;

use crate::density::{DowsonHigginson, ThermalExpansion};
use crate::viscosity::{PressureLaw, Walther};
use crate::{DensityLaw, Fluid, LawError, ViscosityLaw};

/// Temperatures (K) at which viscosities are blended: 40 and 100 degC, those of data sheets.
pub const BLENDING_TEMPERATURES: [f64; 2] = [313.15, 373.15];
/// Pressures (Pa) at which the blend is as dense as its parts.
const DENSITY_PRESSURES: [f64; 2] = [0.25e9, 1e9];

/// Oils that cannot be blended.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum BlendError {
    /// A part has no density.
    #[error("{fluid} has no density law, which its share of the volume needs")]
    NoDensity {
        /// Name of the part.
        fluid: String,
    },
    /// A part has one viscosity at every temperature.
    #[error(
        "the viscosity of {fluid} does not depend on temperature; viscosities are blended at 40 and 100 degC"
    )]
    NoTemperature {
        /// Name of the part.
        fluid: String,
    },
    /// The data of a part do not reach the temperatures.
    #[error("the data of {fluid} are valid {range}; viscosities are blended at 40 and 100 degC")]
    TemperatureRange {
        /// Name of the part.
        fluid: String,
        /// The range, in words.
        range: String,
    },
    /// A part is shear-thinning.
    #[error("{fluid} is shear-thinning: no mixing rule is known for it")]
    ShearThinning {
        /// Name of the part.
        fluid: String,
    },
    /// The blend has constants that no oil has.
    #[error(transparent)]
    Law(#[from] LawError),
}

/// An oil blended of others.
#[derive(Debug, Clone, PartialEq)]
pub struct Blend {
    /// Shares of the volume at 40 degC, in the order of the parts; their sum is 1.
    pub volume_shares: Vec<f64>,
    /// Kinematic viscosities (m²/s) at [`BLENDING_TEMPERATURES`].
    pub kinematic_viscosities: [f64; 2],
    /// Pressure-viscosity coefficients (1/Pa), initial slopes, there.
    pub coefficients: [f64; 2],
    /// Law of the density.
    pub density: DensityLaw,
    /// Law of the viscosity.
    pub viscosity: ViscosityLaw,
}

impl Blend {
    /// The blend of `parts`, each with its share of the mass; the shares sum to 1.
    ///
    /// ```text
    /// φᵢ    = (wᵢ/ρᵢ)/Σ wⱼ/ρⱼ                    at 40 degC
    /// 1/ρ   = Σ wᵢ/ρᵢ                            volumes add
    /// lg lg(ν + 0.7) = Σ φᵢ lg lg(νᵢ + 0.7)      ν in mm²/s, at 40 and 100 degC
    /// α     = Σ φᵢ αᵢ                            at 40 and 100 degC
    /// ```
    ///
    /// The viscosity is the ASTM Blending Method of ASTM D7152, at two temperatures; between them Walther's equation is used in straight
    /// lines, so that its A and B are the means of those of the parts. The coefficient is that of mixtures in which ln μ is additive by
    /// volume. The density is the law of Dowson and Higginson through the ambient densities at 40 and 100 degC and the densities of the
    /// mixture at 40 degC under 0.25 and 1 GPa.
    ///
    /// Theory: Blends.
    ///
    /// # Errors
    ///
    /// Parts without density or temperature, that thin in shear, or whose data do not reach 40 and 100 degC.
    pub fn new(parts: &[(f64, &Fluid)]) -> Result<Self, BlendError> {
        let mut own = Vec::new();
        for (share, fluid) in parts {
            own.push((*share, *fluid, density_of(fluid)?));
        }
        let [cold, hot] = BLENDING_TEMPERATURES;
        let volume = |pressure: f64, temperature: f64| -> f64 {
            let specific = own
                .iter()
                .map(|(w, _, law)| w / law.density(pressure, temperature));
            specific.sum()
        };
        let volume_shares: Vec<f64> = own
            .iter()
            .map(|(w, _, law)| w / law.density(0.0, cold) / volume(0.0, cold))
            .collect();
        let mean = |of: &dyn Fn(&Fluid, &DensityLaw) -> f64| -> f64 {
            let parts = own.iter().zip(&volume_shares);
            parts
                .map(|((_, fluid, law), share)| share * of(fluid, law))
                .sum()
        };
        let constants = |fluid: &Fluid, law: &DensityLaw| {
            let nu = |t: f64| (t, fluid.viscosity(0.0, t) / law.density(0.0, t));
            Walther::constants([nu(cold), nu(hot)])
        };
        let (a, b) = (
            mean(&|fluid, law| constants(fluid, law).0),
            mean(&|fluid, law| constants(fluid, law).1),
        );
        let coefficients = [cold, hot].map(|t| mean(&|fluid, _| fluid.pressure_viscosity_slope(t)));
        let density = density(&volume)?;
        let mut law = Walther {
            a,
            b,
            density: density.clone(),
            alpha: coefficients[0],
            reference_temperature: cold,
            alpha_exponent: 0.0,
            pressure: PressureLaw::Roelands,
        };
        let through = law.exponent([(cold, coefficients[0]), (hot, coefficients[1])]);
        law.alpha_exponent = through.unwrap_or(0.0);
        Ok(Self {
            volume_shares,
            kinematic_viscosities: [cold, hot].map(|t| Walther::kinematic_viscosity_of(a, b, t)),
            coefficients,
            density,
            viscosity: ViscosityLaw::Walther(Walther::new(law)?),
        })
    }
}

/// The density of a part, if the part can be blended.
fn density_of(fluid: &Fluid) -> Result<&DensityLaw, BlendError> {
    let name = || fluid.name.clone();
    let Some(density) = &fluid.density else {
        return Err(BlendError::NoDensity { fluid: name() });
    };
    if !fluid.viscosity.depends_on_temperature() {
        return Err(BlendError::NoTemperature { fluid: name() });
    }
    let ranges = fluid.temperature_ranges();
    let left = (ranges.iter()).find(|r| BLENDING_TEMPERATURES.iter().any(|t| !r.contains(*t)));
    if let Some(range) = left {
        return Err(BlendError::TemperatureRange {
            fluid: name(),
            range: range.to_string(),
        });
    }
    if fluid.shear_thinning.is_some() {
        return Err(BlendError::ShearThinning { fluid: name() });
    }
    Ok(density)
}

/// The law of Dowson and Higginson with the specific volume (m³/kg) that `volume` has at a pressure and a temperature.
fn density(volume: &dyn Fn(f64, f64) -> f64) -> Result<DensityLaw, LawError> {
    let [cold, hot] = BLENDING_TEMPERATURES;
    let rho_0 = 1.0 / volume(0.0, cold);
    let beta = (1.0 - volume(0.0, cold) / volume(0.0, hot)) / (hot - cold);
    // p/(ρ/ρ₀ - 1) = 1/c₁ + p c₂/c₁, a line.
    let [(p_1, y_1), (p_2, y_2)] =
        DENSITY_PRESSURES.map(|p| (p, p / (volume(0.0, cold) / volume(p, cold) - 1.0)));
    let slope = (y_2 - y_1) / (p_2 - p_1);
    let c_1 = 1.0 / (y_1 - slope * p_1);
    let thermal = ThermalExpansion {
        reference_temperature: cold,
        temperature_coefficient: beta,
    };
    let law = DowsonHigginson::with_constants(rho_0, c_1, slope * c_1, Some(thermal))?;
    Ok(DensityLaw::DowsonHigginson(law))
}

#[cfg(all(test, feature = "read"))]
mod tests {
    use crate::near::near;
    use approx::assert_relative_eq;

    use super::*;
    use crate::database;

    fn fluid(name: &str) -> Fluid {
        database::fluid(name).unwrap()
    }

    fn blend(parts: &[(f64, &str)]) -> Result<Blend, BlendError> {
        let fluids: Vec<Fluid> = parts.iter().map(|(_, name)| fluid(name)).collect();
        let parts: Vec<(f64, &Fluid)> = parts.iter().map(|(w, _)| *w).zip(&fluids).collect();
        Blend::new(&parts)
    }

    /// An oil with these kinematic viscosities, mm²/s, and this density at every temperature, kg/m³.
    fn oil(nu_40: f64, nu_100: f64, rho: f64, alpha: f64) -> Fluid {
        let density = DensityLaw::dowson_higginson(rho).unwrap();
        let (a, b) = Walther::constants([(313.15, 1e-6 * nu_40), (373.15, 1e-6 * nu_100)]);
        let law = Walther {
            a,
            b,
            density: density.clone(),
            alpha,
            reference_temperature: 313.15,
            alpha_exponent: 0.0,
            pressure: PressureLaw::Barus,
        };
        let mut fluid = fluid("iso-vg-46-mineral");
        fluid.viscosity = ViscosityLaw::Walther(Walther::new(law).unwrap());
        fluid.density = Some(density);
        fluid
    }

    /// By hand: 0.5 kg of 900 and 0.5 kg of 850 kg/m³ have 5.5556e-4 and 5.8824e-4 m³, φ = 0.48571 and 0.51429, ρ = 874.286.
    /// lg lg 100.7 = 0.301687, lg lg 32.7 = 0.180283: the mean 0.239251 is 10^10^0.239251 - 0.7 = 53.60 mm²/s; at 100 degC lg lg 11.7 =
    /// 0.028647, lg lg 6.7 = -0.082981: -0.028762, 7.928 mm²/s. α = 0.48571 · 24 + 0.51429 · 16 = 19.886 1/GPa.
    #[test]
    fn two_oils_by_hand() {
        let parts = [oil(100.0, 11.0, 900.0, 24e-9), oil(32.0, 6.0, 850.0, 16e-9)];
        let blend = Blend::new(&[(0.5, &parts[0]), (0.5, &parts[1])]).unwrap();
        assert_relative_eq!(blend.volume_shares[0], 0.485_714, max_relative = 1e-5);
        near(blend.density.density(0.0, 313.15), 874.286, 1e-6);
        let [nu_40, nu_100] = blend.kinematic_viscosities.map(|nu| 1e6 * nu);
        assert_relative_eq!(nu_40, 53.601, max_relative = 3e-5);
        assert_relative_eq!(nu_100, 7.9282, max_relative = 3e-5);
        for (temperature, alpha) in [(313.15, 19.886e-9), (373.15, 19.886e-9)] {
            let slope = blend.viscosity.pressure_viscosity_slope(temperature);
            assert_relative_eq!(slope, alpha, max_relative = 1e-4);
        }
        // Both have the compressibility of Dowson and Higginson, and so has the blend.
        let dense = |pressure: f64| blend.density.density(pressure, 313.15);
        near(dense(0.5e9) / dense(0.0), 1.0 + 0.3 / 1.85, 1e-9);
    }

    /// 32.05 % of 5 mm²/s and 67.95 % of 12 mm²/s make 9 mm²/s by mass, an example with the blending number lg ν/lg(1000 ν) (in mm²/s) of
    /// the page tasfiyehroghan.com on blending motor oils; by that number itself 8.89 mm²/s. Refutas' number is 14.534 ln ln(ν + 0.8) + 10.975,
    /// by mass. Of three rules the largest difference is 2 %.
    #[test]
    fn a_published_blend_by_other_rules() {
        let parts = [oil(5.0, 1.8, 870.0, 1e-8), oil(12.0, 3.0, 870.0, 1e-8)];
        let blend = Blend::new(&[(0.3205, &parts[0]), (0.6795, &parts[1])]).unwrap();
        let nu = 1e6 * blend.kinematic_viscosities[0];
        let refutas = |nu: f64| 14.534 * (nu + 0.8_f64).ln().ln() + 10.975;
        let mixed = 0.3205 * refutas(5.0) + 0.6795 * refutas(12.0);
        let by_refutas = ((mixed - 10.975) / 14.534_f64).exp().exp() - 0.8;
        assert_relative_eq!(nu, by_refutas, max_relative = 5e-3);
        assert_relative_eq!(nu, 8.89, max_relative = 0.02);
        assert_relative_eq!(nu, 9.0, max_relative = 0.03);
    }

    /// Parts of one oil make this oil; ASTM D341 is inverted to 1e-7 for thin ones.
    #[test]
    fn an_oil_blended_with_itself() {
        for name in ["iso-vg-220-pao", "pao-10", "nynas-t22", "gear-oil-80w-90"] {
            let own = fluid(name);
            let blend = blend(&[(0.3, name), (0.7, name)]).unwrap();
            for temperature in [313.15, 373.15] {
                assert_relative_eq!(
                    blend.viscosity.viscosity(0.0, temperature),
                    own.viscosity(0.0, temperature),
                    max_relative = 1e-6
                );
                assert_relative_eq!(
                    blend.viscosity.pressure_viscosity_slope(temperature),
                    own.pressure_viscosity_slope(temperature),
                    max_relative = 1e-6
                );
            }
            for pressure in [0.0, 0.25e9, 1e9] {
                assert_relative_eq!(
                    blend.density.density(pressure, 313.15),
                    own.density(pressure, 313.15).unwrap(),
                    max_relative = 1e-9
                );
            }
        }
    }

    #[test]
    fn fluids_that_cannot_be_blended() {
        let refused = |name: &str| blend(&[(0.5, "pao-4"), (0.5, name)]).unwrap_err();
        let is = |error: BlendError, word: &str| {
            assert!(error.to_string().contains(word), "{error}");
        };
        is(refused("polyphenyl-ether-5p4e"), "no density law");
        is(refused("venner-oil"), "does not depend on temperature");
        is(refused("r134a"), "valid from");
        is(refused("pao-650"), "does not depend on temperature");
        let mut thin = fluid("pao-4");
        thin.shear_thinning = fluid("squalane-pip").shear_thinning;
        let error = Blend::new(&[(1.0, &thin)]).unwrap_err();
        is(error, "shear-thinning");
    }
}
