//! Load ratings and rating lives after ISO 281, ISO 76 and ISO/TS 16281.
//!
//! Input and output are in m and N; the standards' formulas use mm and N, and values are converted inside.
//! Constants and tables are those of the standards as public implementations quote them; the standards themselves were not available. Ratings
//! of a real bearing are its maker's: those computed from a geometry suit comparisons.

mod contamination;
mod equivalent;
mod error;
mod factor;
mod fatigue_limit;
mod induced;
mod rating;
mod reference;
mod roller_rating;
mod roller_reference;
mod table;

pub use contamination::{Cleanliness, GuideCleanliness, contamination_factor, contamination_guide};
pub use equivalent::{
    Factors, dynamic_equivalent_load, dynamic_factors, factors, static_equivalent_load,
};
pub use error::Error;
pub(crate) use error::positive;
pub use factor::{
    Kind, Lubrication, life_factor, reference_viscosity, reliability_factor, viscosity_ratio,
};
pub use fatigue_limit::{fatigue_limit, fatigue_limit_of_contact, simple_fatigue_limit};
pub use induced::{induced_axial_load, is_one_sided, nominal_angle};
pub use rating::{
    BALL_EXPONENT, ROLLER_EXPONENT, ball_rating, ball_rating_factor, deep_groove_static_rating,
    has_wide_grooves,
};
pub use reference::{ReferenceLife, equivalent_element_load, reference_life};
pub use roller_rating::{
    RollerRow, roller_equivalent_load, roller_factors, roller_rating, roller_rating_factor,
    roller_static_factors, roller_static_rating,
};
pub use roller_reference::{roller_reference_life, stress_riser};

/// Basic rating life, in revolutions, of the rating C and the equivalent load P, both N.
///
/// L10 = 10⁶ (C/P)^p
///
/// # Errors
/// Loads or ratings that are not positive.
pub fn basic_life(rating: f64, load: f64, exponent: f64) -> Result<f64, Error> {
    let ratio = positive("rating", rating)? / positive("equivalent load", load)?;
    Ok(1e6 * ratio.powf(exponent))
}

/// Modified rating life, in revolutions.
///
/// L_nm = a_1 a_ISO L10, or L_nmr with the reference life L10r
pub fn modified_life(life: f64, reliability: f64, life_factor: f64) -> f64 {
    reliability * life_factor * life
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Four digits, and ranges without an end.
    #[test]
    fn ranges_in_words() {
        let said = |value, low, high| {
            let name = "κ";
            Error::Range {
                name,
                value,
                low,
                high,
            }
            .to_string()
        };
        let text = said(0.069_608_395_489_7, 0.1, f64::INFINITY);
        assert_eq!(text, "κ is 0.06961; the standard covers 0.1 and more");
        let text = said(3.0, f64::NEG_INFINITY, 1.0);
        assert_eq!(text, "κ is 3; the standard covers 1 and less");
        let text = said(12.0, 1.0, 10.0);
        assert_eq!(text, "κ is 12; the standard covers 1 to 10");
    }

    /// By hand: (20/2)³ = 1000 million; rollers 10^(10/3) = 2154.43 million; 0.64 · 2 of it.
    #[test]
    fn lives_by_hand() {
        let ball = basic_life(20e3, 2e3, BALL_EXPONENT).unwrap();
        assert_relative_eq!(ball, 1e9, max_relative = 1e-12);
        let roller = basic_life(20e3, 2e3, ROLLER_EXPONENT).unwrap();
        assert_relative_eq!(roller, 2.154_43e9, max_relative = 1e-5);
        assert_relative_eq!(modified_life(ball, 0.64, 2.0), 1.28e9, max_relative = 1e-12);
        assert!(basic_life(20e3, 0.0, BALL_EXPONENT).is_err());
    }
}
