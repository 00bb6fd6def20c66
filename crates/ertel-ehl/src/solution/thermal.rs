//! Temperatures and heat of a solution, SI.

use serde::Serialize;

use super::{Estimate, Field, Located};

/// Temperatures and heat.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Thermal {
    /// Inflow temperature of the lubricant, K.
    pub inlet_temperature: f64,
    /// Largest temperature of the film, K.
    #[serde(rename = "film_temperature_maximum")]
    pub film_maximum: Located,
    /// Smallest temperature of the film, K.
    #[serde(rename = "film_temperature_lowest")]
    pub film_lowest: Located,
    /// Mean temperature of the film over the Hertz zone and across the film, K.
    #[serde(rename = "film_temperature_mean")]
    pub film_mean: Estimate,
    /// Largest temperature of the surface of body 1, K.
    #[serde(rename = "temperature_body_1_maximum")]
    pub body_1_maximum: Located,
    /// Mean temperature of the surface of body 1 over the Hertz zone, K.
    #[serde(rename = "temperature_body_1_mean")]
    pub body_1_mean: Estimate,
    /// Largest temperature of the surface of body 2, K.
    #[serde(rename = "temperature_body_2_maximum")]
    pub body_2_maximum: Located,
    /// Mean temperature of the surface of body 2 over the Hertz zone, K.
    #[serde(rename = "temperature_body_2_mean")]
    pub body_2_mean: Estimate,
    /// Sources and sinks of heat.
    pub balance: HeatBalance,
    /// Effect of heat on film and traction; `None` where the isothermal film was not found.
    pub reduction: Option<ThermalReduction>,
    /// Convergence of the film-temperature coupling.
    pub coupling: Coupling,
    /// Temperatures at the points of [`super::Centreline`].
    #[serde(skip)]
    pub centreline: FilmTemperatures,
    /// Temperatures at the points of [`super::SurfaceField`].
    #[serde(skip)]
    pub surface: FilmTemperatures,
    /// Profiles across the film.
    #[serde(skip)]
    pub profiles: Vec<CrossProfile>,
    /// Temperature of film and bodies, if requested.
    #[serde(skip)]
    pub field: Option<TemperatureField>,
}

/// Heat of the whole contact: W (circular) or W/m (line).
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct HeatBalance {
    /// Made by shear.
    #[serde(rename = "heat_shear")]
    pub shear: Estimate,
    /// Made by compression, less what expansion takes.
    #[serde(rename = "heat_compression")]
    pub compression: Estimate,
    /// Carried off by body 1.
    #[serde(rename = "heat_to_body_1")]
    pub to_body_1: Estimate,
    /// Carried off by body 2.
    #[serde(rename = "heat_to_body_2")]
    pub to_body_2: Estimate,
    /// Carried off by the lubricant.
    #[serde(rename = "heat_by_film")]
    pub by_film: Estimate,
    /// (made − carried off)/(heat of shear + size of the heat of compression).
    #[serde(rename = "heat_balance_error")]
    pub error: f64,
}

/// Effect of heat: the same mesh with and without it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ThermalReduction {
    /// 1 − h_c/(h_c without heat).
    #[serde(rename = "thermal_reduction_central")]
    pub film_central: Estimate,
    /// 1 − h_min/(h_min without heat).
    #[serde(rename = "thermal_reduction_minimum")]
    pub film_minimum: Estimate,
    /// 1 − traction/(traction without heat); `None` without traction.
    #[serde(rename = "thermal_reduction_traction")]
    pub traction: Option<Estimate>,
    /// Traction coefficient without heat.
    #[serde(rename = "isothermal_traction_coefficient")]
    pub isothermal_traction: Estimate,
}

/// Convergence of the film-temperature coupling.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Coupling {
    /// Rounds on the last mesh.
    pub rounds: usize,
    /// Ratio by which changes shrank from round to round.
    pub contraction: f64,
    /// Last relative change of temperature rise, pressure and film from round to round.
    pub change: f64,
    /// Error left by such changes at which film and heat count as converged.
    pub tolerance: f64,
    /// Temperatures computed.
    pub n_temperatures: usize,
    /// Newton iterations for them on the last mesh.
    pub iterations: usize,
    /// Krylov iterations for them on the last mesh.
    pub krylov_iterations: usize,
}

/// Temperatures at a list of points, K.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct FilmTemperatures {
    /// At mid-film.
    pub mid: Vec<f64>,
    /// Mean across the film.
    pub mean: Vec<f64>,
    /// Surface of body 1.
    pub body_1: Vec<f64>,
    /// Surface of body 2.
    pub body_2: Vec<f64>,
}

impl FilmTemperatures {
    /// Each field with its values.
    pub fn columns(&self) -> [(Field, &[f64]); 4] {
        [
            (Field::TemperatureMid, &self.mid),
            (Field::TemperatureMean, &self.mean),
            (Field::TemperatureBody1, &self.body_1),
            (Field::TemperatureBody2, &self.body_2),
        ]
    }
}

/// Profile across the film at a point.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct CrossProfile {
    /// Place, m.
    pub x: f64,
    /// Place, m.
    pub y: f64,
    /// Film thickness, m.
    pub film_thickness: f64,
    /// Height over body 1, m.
    pub z: Vec<f64>,
    /// Temperature, K.
    pub temperature: Vec<f64>,
    /// Velocity along the motion, m/s.
    pub velocity_x: Vec<f64>,
    /// Velocity across it, m/s.
    pub velocity_y: Vec<f64>,
    /// Size of the shear rate, 1/s.
    pub shear_rate: Vec<f64>,
    /// Generalized viscosity, Pa·s.
    pub viscosity: Vec<f64>,
}

/// Temperature in the film and both bodies, cell by cell, for pictures. The film is drawn at its thickness times
/// `film_magnification`.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct TemperatureField {
    /// Points, m.
    pub points: Vec<[f64; 3]>,
    /// Corners: wedges (circular: six, bottom triangle first) or quadrilaterals (line: four, in order round).
    pub cells: Vec<Vec<u32>>,
    /// 0 plane, 1 film, 2 ball.
    pub region: Vec<u8>,
    /// Temperature at the points, K.
    pub temperature: Vec<f64>,
    /// By which the film's thickness is stretched.
    pub film_magnification: f64,
}
