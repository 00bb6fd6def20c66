//! Conductivity and heat capacity by the kind of base oil.
//!
//! Theory: Heat and shear of a kind of oil.

use super::{BaseOil, Estimate};

/// Estimated thermal properties of an oil: the constants of the laws of Larsson and Andersson
/// ([`crate::conductivity::LarssonAndersson`], [`crate::heat_capacity::LarssonAndersson`]).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeatEstimate {
    /// Conductivity k₀ at ambient pressure (W/(m·K)).
    pub conductivity: Estimate,
    /// Initial slope d₁ of the conductivity over pressure (1/Pa).
    pub d_1: f64,
    /// Coefficient d₂ by which it saturates (1/Pa).
    pub d_2: f64,
    /// Heat capacity per volume (ρ c)₀ at ambient pressure and `reference_temperature` (J/(m³·K)).
    pub volumetric_heat: Estimate,
    /// Temperature of the heat capacity (K).
    pub reference_temperature: f64,
    /// Temperature coefficient β₀ at ambient pressure (1/K).
    pub beta_0: f64,
    /// Its relative slope b₁ with pressure (1/Pa).
    pub b_1: f64,
    /// Its relative curvature b₂ with pressure (1/Pa²).
    pub b_2: f64,
    /// Initial relative slope k₁ of the heat capacity with pressure (1/Pa).
    pub k_1: f64,
    /// Coefficient k₂ by which that saturates (1/Pa).
    pub k_2: f64,
}

/// Temperature at which the synthetic oils' heat capacities hold (K).
const CELSIUS_40: f64 = 313.15;

impl BaseOil {
    /// Conductivity and heat capacity per volume of an oil of this kind, with how both change with pressure and temperature:
    ///
    /// ```text
    /// k   = k₀ [1 + d₁ p/(1 + d₂ p)]
    /// ρ c = (ρ c)₀ [1 + β₀ (1 + b₁ p + b₂ p²) (T - T_R)] [1 + k₁ p/(1 + k₂ p)]
    /// ```
    ///
    /// Group III lies midway between mineral and PAO in k₀ and (ρ c)₀ and is as mineral otherwise. The constants of mineral oil and of PAO are those of Larsson
    /// and Andersson (Proc. IMechE J 214, 2000, 337-342) as public programs have them: paraffinic mineral oil, and the mean of five
    /// polyalphaolefins. The page lists the data within the ranges.
    ///
    /// Theory: Heat and shear of a kind of oil.
    #[must_use]
    pub fn heat(self) -> HeatEstimate {
        let as_pao = HeatEstimate {
            conductivity: Estimate::even(
                0.157,
                [0.11, 0.11],
                "kreuz_pao, PAO 4, 10, 40, 100; everitt_ehl, PAO B",
                "five polyalphaolefins there have 0.141 to 0.165 W/(m.K)",
            ),
            d_1: 1.40e-9,
            d_2: 0.34e-9,
            volumetric_heat: Estimate::even(
                1.725e6,
                [0.1, 0.15],
                "kreuz_pao, PAO 4, 10, 40, 100; everitt_ehl, PAO B; larsson_andersson2000 for pressure and temperature",
                "five polyalphaolefins there have 1.67 to 1.77 MJ/(m^3.K), feup_gear uses 1.95",
            ),
            reference_temperature: CELSIUS_40,
            beta_0: 6.5e-4,
            b_1: 2.7e-9,
            b_2: -1.5e-18,
            k_1: 0.41e-9,
            k_2: 1.05e-9,
        };
        match self {
            Self::Pao => as_pao,
            Self::Mineral | Self::Naphthenic => HeatEstimate {
                conductivity: Estimate::even(
                    0.137,
                    [0.3, 0.12],
                    "larsson_andersson2000, paraffinic mineral oil",
                    "eight mineral oils and correlations have 0.096 to 0.152 W/(m.K) (docs/theory/rheology.md)",
                ),
                d_1: 1.72e-9,
                d_2: 0.54e-9,
                volumetric_heat: Estimate::even(
                    1.71e6,
                    [0.11, 0.16],
                    "larsson_andersson2000, paraffinic mineral oil",
                    "seven mineral oils and correlations have 0.90 to 1.16 times as much at 40 degC (docs/theory/rheology.md)",
                ),
                reference_temperature: 295.0,
                beta_0: 9.3e-4,
                b_1: 1.4e-9,
                b_2: -0.51e-18,
                k_1: 0.47e-9,
                k_2: 0.81e-9,
            },
            Self::Ester => HeatEstimate {
                conductivity: Estimate::even(
                    0.153,
                    [0.13, 0.12],
                    "baomaokuan_bearing, MIL-L-7808 and MIL-L-23699",
                    "both ester turbine oils there have 0.145 and 0.161 W/(m.K) at 40 degC, feup_gear uses 0.134; pressure as \
                     for a PAO",
                ),
                volumetric_heat: Estimate::even(
                    1.90e6,
                    [0.1, 0.1],
                    "baomaokuan_bearing, MIL-L-7808 and MIL-L-23699; feup_gear",
                    "three esters there have 1.72, 1.92 and 2.07 MJ/(m^3.K) at 40 degC; pressure as for a PAO",
                ),
                beta_0: 8.5e-4,
                ..as_pao
            },
            Self::Pag => HeatEstimate {
                conductivity: Estimate::even(
                    0.145,
                    [0.3, 0.3],
                    "none, midway of the other kinds",
                    "no measured conductivity of a polyalkylene glycol was found; the range covers the 0.115 W/(m.K) that feup_gear \
                     uses",
                ),
                volumetric_heat: Estimate::even(
                    2.08e6,
                    [0.2, 0.2],
                    "none, 2000 J/(kg.K), as of other oils, times the density of a polyalkylene glycol",
                    "no measured heat capacity of a polyalkylene glycol was found; the range covers the 2.40 MJ/(m^3.K) that feup_gear \
                     uses",
                ),
                beta_0: 8.5e-4,
                ..as_pao
            },
            Self::GroupIII => {
                let [mineral, pao] = [Self::Mineral.heat(), as_pao];
                // At another temperature, by the coefficient of its kind.
                let warmed = Estimate {
                    value: pao.volumetric_heat.value
                        * (1.0 + pao.beta_0 * (mineral.reference_temperature - CELSIUS_40)),
                    ..pao.volumetric_heat
                };
                HeatEstimate {
                    conductivity: Estimate::midway(&mineral.conductivity, &pao.conductivity),
                    volumetric_heat: Estimate::midway(&mineral.volumetric_heat, &warmed),
                    ..mineral
                }
            }
        }
    }
}
