//! Films to compare with the one that was solved for: by formulas, and of the Newtonian fluid.

use serde::Serialize;

use super::Estimate;

/// Film thickness predicted by a published formula.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FormulaFilm {
    /// Name, e.g. "Hamrock-Dowson 1977".
    pub name: &'static str,
    /// Central film thickness, m, where the formula gives one.
    #[serde(rename = "film_central")]
    pub central: Option<f64>,
    /// Minimum film thickness, m, where the formula gives one.
    #[serde(rename = "film_minimum")]
    pub minimum: Option<f64>,
    /// Source of the constants, and what the formula assumes.
    pub source: &'static str,
}

/// Effect of shear thinning on the film: both films on the same mesh.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct FilmReduction {
    /// 1 − h_c/(h_c of the Newtonian fluid).
    #[serde(rename = "film_reduction_central")]
    pub central: Estimate,
    /// 1 − h_min/(h_min of the Newtonian fluid).
    #[serde(rename = "film_reduction_minimum")]
    pub minimum: Estimate,
}
