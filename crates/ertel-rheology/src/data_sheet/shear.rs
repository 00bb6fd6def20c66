//! Eyring stress and limiting stress by the kind of base oil.
//!
//! Theory: Heat and shear of a kind of oil.

use super::{BaseOil, Estimate};

/// Estimated shear-thinning constants of an oil: `τ₀` of the law of Ree and Eyring, and `Λ` of its limit `τ_L = τ₀ + Λ p`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShearEstimate {
    /// Eyring stress τ₀ (Pa), also the limiting stress at ambient pressure.
    pub eyring_stress: Estimate,
    /// Growth Λ of the limiting stress with pressure (-).
    pub pressure_coefficient: Estimate,
}

impl BaseOil {
    /// Eyring stress and growth of the limiting stress of an oil of this kind:
    ///
    /// ```text
    /// γ̇ = (τ₀/μ) sinh(τ/τ₀),   τ ≤ τ_L = τ₀ + Λ p
    /// ```
    ///
    /// Group III lies midway between mineral and PAO. Λ is taken as the friction coefficient of a full film in sliding, which it is where
    /// the stress of the whole contact is at its limit: elsewhere friction is lower, so that such figures lie at the lower end of Λ. The
    /// form, with τ₀ as the limit at ambient pressure, is that of a public program for polyalphaolefins.
    ///
    /// Theory: Heat and shear of a kind of oil.
    #[must_use]
    pub fn shear(self) -> ShearEstimate {
        let stress = |value: f64| {
            Estimate::even(
                value,
                [0.6, 1.0],
                "johnson_tevaarwerk1977, Eyring stresses of a few MPa",
                "traction programs use 2 to 10 MPa, typically 5 for a mineral oil; kreuz_pao has 4 MPa for polyalphaolefins",
            )
        };
        match self {
            Self::Mineral | Self::Naphthenic => ShearEstimate {
                eyring_stress: stress(5e6),
                pressure_coefficient: Estimate::even(
                    0.056,
                    [0.3, 0.5],
                    "feup_gear, full film of a thrust ball bearing in mineral oil",
                    "Shell T9 has 0.083 (Habchi 2018, Finite Element Modeling of Elastohydrodynamic Lubrication Problems); bearing programs use 0.04",
                ),
            },
            Self::Pao => ShearEstimate {
                eyring_stress: Estimate {
                    source: "kreuz_pao, for the family",
                    ..stress(4e6)
                },
                pressure_coefficient: Estimate::even(
                    0.042,
                    [0.3, 0.3],
                    "kreuz_pao, mean of 0.0395 and of 0.044 of feup_gear, full film of a thrust ball bearing",
                    "both differ by 10 %; of mineral oils figures differ by far more",
                ),
            },
            Self::Ester => ShearEstimate {
                eyring_stress: stress(5e6),
                pressure_coefficient: Estimate::even(
                    0.043,
                    [0.4, 0.4],
                    "feup_gear, full film of a thrust ball bearing in an ester",
                    "one oil; a factor for the friction of gears there is 0.77 of that of a mineral oil, which gives 0.043 too",
                ),
            },
            Self::Pag => ShearEstimate {
                eyring_stress: stress(5e6),
                pressure_coefficient: Estimate::even(
                    0.041,
                    [0.5, 0.3],
                    "feup_gear, mean of 0.044, full film of a thrust ball bearing, and 0.039 by the factor for the friction of gears",
                    "one oil; glycols are reported to have less friction than any other kind (zhang2017, section 2)",
                ),
            },
            Self::GroupIII => {
                let [mineral, pao] = [Self::Mineral.shear(), Self::Pao.shear()];
                ShearEstimate {
                    eyring_stress: Estimate::midway(&mineral.eyring_stress, &pao.eyring_stress),
                    pressure_coefficient: Estimate::midway(
                        &mineral.pressure_coefficient,
                        &pao.pressure_coefficient,
                    ),
                }
            }
        }
    }
}
