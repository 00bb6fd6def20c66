//! Settings of the thermal contact.

use serde::Serialize;

/// Heat in film and bodies: discretisation, coupling, bulk temperatures and output.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ThermalParams {
    /// Depth to which both bodies are heated, in Hertz half-widths a (Habchi 2008, section 5.3: D = 3.15).
    pub depth: f64,
    /// Order of the polynomial that the temperature is across the film, 2 to 10.
    pub film_order: usize,
    /// Cubic elements over the depth of each body, thinner towards the film.
    pub solid_elements: usize,
    /// Lagrange order of the temperature in the plane of motion, 1 or 2.
    pub surface_order: usize,
    /// Relative change of temperature rise, film and pressure at which their coupling has converged.
    pub tolerance: f64,
    /// Largest number of rounds of that coupling.
    pub max_iterations: usize,
    /// Bulk temperature of body 1, K; `None`: that of the lubricant in the inlet.
    pub body_1_temperature: Option<f64>,
    /// Bulk temperature of body 2, K; `None`: that of the lubricant in the inlet.
    pub body_2_temperature: Option<f64>,
    /// Points [X, Y], in half-widths, at which profiles across the film are written.
    pub profiles: Vec<[f64; 2]>,
    /// Write the temperature of the whole film and of both bodies.
    pub field: bool,
}

impl Default for ThermalParams {
    fn default() -> Self {
        ThermalParams {
            depth: 3.15,
            film_order: 8,
            solid_elements: 4,
            surface_order: 1,
            tolerance: 1e-4,
            max_iterations: 40,
            body_1_temperature: None,
            body_2_temperature: None,
            profiles: vec![[-1.0, 0.0], [0.0, 0.0], [0.9, 0.0]],
            field: false,
        }
    }
}
