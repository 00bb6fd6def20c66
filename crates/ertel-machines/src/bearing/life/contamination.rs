//! Contamination factor: formula for grease, guide values for any oil.

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
/// of oil lubrication were not found in a source: [`contamination_guide`] has guide values.
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

/// How clean oil or grease is, by guide values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GuideCleanliness {
    /// Particles of the size of the film: laboratories.
    Extreme,
    /// Oil through extremely fine filters; sealed bearings with grease.
    High,
    /// Oil through fine filters.
    Normal,
    /// Slight contamination.
    Slight,
    /// Typical contamination: wear of other parts.
    Typical,
    /// Heavily contaminated surroundings, or seals that do not suffice.
    Severe,
    /// Very heavy contamination.
    VerySevere,
}

/// Least and largest guide value of e_C for the mean diameter (d + D)/2, m.
///
/// Source: ISO 281 in Schaeffler, Rolling Bearings, catalogue HR 1, 2006, page 41.
///
/// # Errors
/// A diameter that is not positive.
pub fn contamination_guide(
    cleanliness: GuideCleanliness,
    mean_diameter: f64,
) -> Result<[f64; 2], Error> {
    let large = positive("mean diameter", mean_diameter)? >= 0.1;
    let [small_bearings, large_bearings] = match cleanliness {
        GuideCleanliness::Extreme => [[1.0, 1.0], [1.0, 1.0]],
        GuideCleanliness::High => [[0.6, 0.8], [0.8, 0.9]],
        GuideCleanliness::Normal => [[0.5, 0.6], [0.6, 0.8]],
        GuideCleanliness::Slight => [[0.3, 0.5], [0.4, 0.6]],
        GuideCleanliness::Typical => [[0.1, 0.3], [0.2, 0.4]],
        GuideCleanliness::Severe => [[0.0, 0.1], [0.0, 0.1]],
        GuideCleanliness::VerySevere => [[0.0, 0.0], [0.0, 0.0]],
    };
    Ok(if large {
        large_bearings
    } else {
        small_bearings
    })
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

    /// Entries of the table, and the formula for grease of high cleanliness at κ = 1 and 64 mm, 0.706, lies between its own.
    #[test]
    fn guide_values() {
        let at = |c, d| contamination_guide(c, d).unwrap();
        assert_eq!(at(GuideCleanliness::Typical, 0.05), [0.1, 0.3]);
        assert_eq!(at(GuideCleanliness::Typical, 0.1), [0.2, 0.4]);
        let [low, high] = at(GuideCleanliness::High, 0.064);
        let formula = contamination_factor(Cleanliness::High, 1.0, 0.064).unwrap();
        assert!(low < formula && formula < high);
        assert!(contamination_guide(GuideCleanliness::High, 0.0).is_err());
    }
}
