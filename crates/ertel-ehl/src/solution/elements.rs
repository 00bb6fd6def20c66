//! Fields as the polynomials that were solved for, element by element, SI.

use serde::Serialize;

/// A field that is a polynomial on each element, given by its values at the element's Lagrange nodes.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Polynomials {
    /// Order of the polynomials.
    pub order: usize,
    /// Values, `[element * nodes per element + node]`, nodes in the order of [`ertel_fem::element::Lagrange`].
    pub values: Vec<f64>,
}

/// Temperatures as polynomials, K.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct TemperaturePolynomials {
    /// At mid-film.
    pub mid: Polynomials,
    /// Mean across the film.
    pub mean: Polynomials,
    /// Surface of body 1.
    pub body_1: Polynomials,
    /// Surface of body 2.
    pub body_2: Polynomials,
}

/// The fields that pictures show, on the contact area (half domain y ≤ 0 for circular contacts). Pictures sample them
/// as finely as they need.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct ElementFields {
    /// Dimension of the elements: 2 triangles (circular), 1 segments (line).
    pub dim: usize,
    /// Corners, m.
    pub vertices: Vec<[f64; 2]>,
    /// Elements by their corners: triangles, or segments in the first two entries.
    pub cells: Vec<[u32; 3]>,
    /// Pressure, Pa.
    pub pressure: Polynomials,
    /// Film thickness, m.
    pub film_thickness: Polynomials,
    /// Temperatures, where they vary.
    pub temperatures: Option<TemperaturePolynomials>,
}
