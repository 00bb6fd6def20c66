//! How asperities press: laws of the asperity pressure over the distance of the mean planes.
//!
//! ```text
//!   Greenwood and Tripp       p_a = 16√2π/15 (σβη)² √(σ/β) E* F_{5/2}(u),   u = h/σ     two rough surfaces of one kind
//!   Greenwood and Williamson  p_a = 4/3 (σβη) √(σ/β) E* F_{3/2}(u)                      one rough surface on a smooth one
//!   Persson                   p_a = β E* exp(−u/γ)                                       randomly rough, in interaction: see [`Persson`]
//!   table                     ln p_a by monotone cubic pieces over h                    measured, or of another program
//!   hardness H                p_a ≤ H Q(u),   Q(u) = ½ erfc(u/√2);  Persson  p_a ≤ H A_r/A_0    asperities that flow
//! ```
//! Greenwood and Tripp 1970, Proc. IMechE 185, 625-633. Greenwood and Williamson 1966, Proc. R. Soc. A 295, 300-319: summits are taken as Gaussian with the
//! rms height σ of the surface about its mean plane. The limit is that of Abbott and Firestone (1933, Mechanical Engineering 55, 569): where all asperities
//! flow, the area in touch is the share Q of the area above the other mean plane, and each of its points bears the hardness H. Persson's law has its area in touch.
//!
//! Theory: Mixed lubrication.

use std::f64::consts::PI;

use serde::Serialize;

use super::flow::{Flow, Orientation};
use super::persson::Persson;
use super::pressure_table::PressureTable;
use super::statistics::{area_above, five_halves_integral, three_halves_integral};

/// Summits of equal tip radius and Gaussian heights.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Summits {
    /// σβη: composite rms height, tip radius and density of asperities, dimensionless.
    pub asperity_group: f64,
    /// σ/β: composite rms height over tip radius.
    pub rms_height_to_asperity_radius: f64,
}

/// How asperities press over the distance of the mean planes.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case", tag = "asperity_law")]
pub enum AsperityLaw {
    /// Summits on both surfaces.
    GreenwoodTripp(Summits),
    /// Summits on one surface.
    GreenwoodWilliamson(Summits),
    /// Randomly rough surfaces, exponential over the distance.
    Persson(Persson),
    /// A table of pressures over distances.
    Table(PressureTable),
}

impl AsperityLaw {
    /// For reports.
    pub fn source(&self) -> &'static str {
        match self {
            AsperityLaw::GreenwoodTripp(_) => "Greenwood and Tripp 1970",
            AsperityLaw::GreenwoodWilliamson(_) => "Greenwood and Williamson 1966",
            AsperityLaw::Persson(_) => "Persson 2007",
            AsperityLaw::Table(_) => "table of asperity pressures",
        }
    }

    /// κ, Pa, the factor of F_{5/2}, F_{3/2} or exp(−u/γ); `None` for a table. `reduced_modulus` is E' = 2E* in Pa.
    pub fn stiffness(&self, reduced_modulus: f64) -> Option<f64> {
        let modulus = 0.5 * reduced_modulus;
        let root = |of: &Summits| of.rms_height_to_asperity_radius.sqrt();
        match self {
            AsperityLaw::GreenwoodTripp(of) => Some(
                16.0 * 2f64.sqrt() * PI / 15.0 * of.asperity_group.powi(2) * root(of) * modulus,
            ),
            AsperityLaw::GreenwoodWilliamson(of) => {
                Some(4.0 / 3.0 * of.asperity_group * root(of) * modulus)
            }
            AsperityLaw::Persson(of) => Some(of.pressure_factor * modulus),
            AsperityLaw::Table(_) => None,
        }
    }

    /// Share of the area in touch that bears the hardness where all asperities flow, at the distance over σ and the elastic pressure over E*.
    fn area_in_touch(&self, film_to_height: f64, pressure: f64) -> f64 {
        match self {
            AsperityLaw::Persson(of) => of.area_in_touch(pressure)[0],
            _ => area_above(film_to_height),
        }
    }
}

/// Asperities of two surfaces.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Asperities {
    /// How they press.
    #[serde(flatten)]
    pub law: AsperityLaw,
    /// Hardness of the softer surface, Pa, if asperities flow.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hardness: Option<f64>,
    /// Friction of asperities over their load, if given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub boundary_friction_coefficient: Option<f64>,
    /// Where the oil flows.
    pub flow: Flow,
    /// Whether the case chooses it.
    #[serde(skip)]
    pub flow_is_chosen: bool,
    /// Orientation of the roughness, with the flow factors of Patir and Cheng.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub orientation: Option<Orientation>,
}

impl Asperities {
    /// Asperity pressure, Pa, at a distance of the mean planes over the composite rms height σ in m; `reduced_modulus` is E' = 2E* in Pa.
    pub fn pressure(&self, film_to_height: f64, rms_height: f64, reduced_modulus: f64) -> f64 {
        let modulus = 0.5 * reduced_modulus;
        let elastic = match (&self.law, self.law.stiffness(reduced_modulus)) {
            (AsperityLaw::GreenwoodTripp(_), Some(k)) => k * five_halves_integral(film_to_height),
            (AsperityLaw::GreenwoodWilliamson(_), Some(k)) => {
                k * three_halves_integral(film_to_height)
            }
            (AsperityLaw::Persson(of), Some(_)) => modulus * of.pressure(film_to_height)[0],
            (AsperityLaw::Table(table), _) => table.at(film_to_height * rms_height)[0],
            (_, None) => 0.0,
        };
        match self.hardness {
            Some(hardness) => {
                elastic.min(hardness * (self.law).area_in_touch(film_to_height, elastic / modulus))
            }
            None => elastic,
        }
    }
}
