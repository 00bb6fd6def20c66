//! Contamination factor of grease lubrication.

use super::{Error, positive};

/// How clean a grease is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cleanliness {
    /// High cleanliness.
    High,
    /// Normal cleanliness.
    Normal,
    /// Slight to typical contamination.
    Typical,
    /// Severe contamination.
    Severe,
    /// Very severe contamination.
    VerySevere,
}

impl Cleanliness {
    /// c_1 and c_2.
    fn constants(self) -> [f64; 2] {
        match self {
            Cleanliness::High => [0.0864, 0.6796],
            Cleanliness::Normal => [0.0432, 1.141],
            Cleanliness::Typical => [0.0177, 1.887],
            Cleanliness::Severe => [0.0115, 2.662],
            Cleanliness::VerySevere => [0.006_17, 4.06],
        }
    }
}

/// e_C of grease lubrication with the viscosity ratio κ and the pitch diameter (m), from 0 to 1.
///
/// e_C = c_1 κ^0.68 d_m^0.55 (1 − c_2/d_m^(1/3)),  d_m in mm
///
/// c_1 κ^0.68 d_m^0.55 and e_C itself are 1 at the most, negative values count as 0. Source: ISO 281:2007, annex A, as a public
/// implementation for slewing bearings quotes it, without its further factor 0.173, which belongs to no formula of the standard. Constants
/// of oil lubrication were not found in a source.
///
/// # Errors
/// Numbers that are not positive.
pub fn contamination_factor(
    cleanliness: Cleanliness,
    viscosity_ratio: f64,
    pitch_diameter: f64,
) -> Result<f64, Error> {
    let [c_1, c_2] = cleanliness.constants();
    let pitch = positive("pitch diameter", pitch_diameter)? * 1e3;
    let kappa = positive("κ", viscosity_ratio)?;
    let film = (c_1 * kappa.powf(0.68) * pitch.powf(0.55)).min(1.0);
    Ok((film * (1.0 - c_2 / pitch.cbrt())).clamp(0.0, 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// By hand, κ = 1, d_m = 64 mm: 64^0.55 = 9.84916, 64^(1/3) = 4: high 0.850967 (1 − 0.1699) = 0.706388, normal 0.425484 (1 − 0.28525) =
    /// 0.304115; very severe below zero: 0.
    #[test]
    fn by_hand() {
        let at = |c| contamination_factor(c, 1.0, 0.064).unwrap();
        assert_relative_eq!(at(Cleanliness::High), 0.706_388, max_relative = 1e-5);
        assert_relative_eq!(at(Cleanliness::Normal), 0.304_115, max_relative = 1e-5);
        assert_eq!(at(Cleanliness::VerySevere), 0.0);
        assert!(at(Cleanliness::Severe) < at(Cleanliness::Typical));
        let thick = contamination_factor(Cleanliness::High, 4.0, 1.0).unwrap();
        assert_relative_eq!(thick, 1.0 - 0.067_96, max_relative = 1e-9);
    }
}
