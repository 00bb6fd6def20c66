//! Fields at points: along the centreline, on the contact area and in the body, SI.

use serde::Serialize;

use super::{Field, FilmTemperatures};

fn are_empty(fields: &[Vec<f64>; 3]) -> bool {
    fields.iter().all(Vec::is_empty)
}

/// The pressure of asperities as a column, where there are some.
pub(super) fn asperity_column(pressure: &[f64]) -> Option<(Field, &[f64])> {
    (!pressure.is_empty()).then_some((Field::AsperityPressure, pressure))
}

/// Shear of the film at the points of a profile or a surface, SI. Stresses are those along the motion,
/// positive where body 2 drags the film.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct ShearFields {
    /// Shear stress at mid-film, Pa.
    pub stress_mid: Vec<f64>,
    /// Shear stress at body 1, Pa.
    pub stress_body_1: Vec<f64>,
    /// Shear stress at body 2, Pa.
    pub stress_body_2: Vec<f64>,
    /// Shear stresses across the motion at mid-film, body 1 and body 2, Pa; empty where both halves of the contact are alike.
    #[serde(skip_serializing_if = "are_empty")]
    pub stress_across: [Vec<f64>; 3],
    /// Shear rate at mid-film, its size, 1/s.
    pub rate_mid: Vec<f64>,
    /// Generalized viscosity at mid-film, Pa·s.
    pub generalized_viscosity: Vec<f64>,
}

impl ShearFields {
    /// The fields that there are, with their values.
    pub fn columns(&self) -> Vec<(Field, &[f64])> {
        let [across_mid, across_1, across_2] = &self.stress_across;
        let all: [(Field, &[f64]); 8] = [
            (Field::ShearStressMid, &self.stress_mid),
            (Field::ShearStressBody1, &self.stress_body_1),
            (Field::ShearStressBody2, &self.stress_body_2),
            (Field::ShearRateMid, &self.rate_mid),
            (Field::GeneralizedViscosityMid, &self.generalized_viscosity),
            (Field::ShearStressAcrossMid, across_mid),
            (Field::ShearStressAcrossBody1, across_1),
            (Field::ShearStressAcrossBody2, across_2),
        ];
        (all.into_iter().enumerate())
            .filter(|(i, (_, values))| *i < 5 || !values.is_empty())
            .map(|(_, column)| column)
            .collect()
    }
}

/// Profiles along y = 0, SI.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Centreline {
    /// Position, m.
    pub x: Vec<f64>,
    /// Pressure, Pa; between rough surfaces that of oil and asperities together.
    pub pressure: Vec<f64>,
    /// Pressure of asperities, Pa; empty where there are none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub asperity_pressure: Vec<f64>,
    /// Film thickness, m.
    pub film_thickness: Vec<f64>,
    /// Elastic deflection of both bodies together, m.
    pub deflection: Vec<f64>,
    /// Viscosity, Pa·s.
    pub viscosity: Vec<f64>,
    /// Density, kg/m³.
    pub density: Vec<f64>,
    /// Hertz pressure of the dry contact, Pa.
    pub hertz_pressure: Vec<f64>,
    /// Shear of the film.
    pub shear: ShearFields,
}

/// Fields on the contact area (half domain y ≤ 0 for circular contacts), SI.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct SurfaceField {
    /// Points, m.
    pub points: Vec<[f64; 2]>,
    /// Linear sub-cells: triangles (circular), or segments in the first two entries (line).
    pub cells: Vec<[u32; 3]>,
    /// Order of the elements: on each, a field is the polynomial of this order through its values at the nodes.
    pub order: usize,
    /// Points of each element, in the order of [`ertel_fem::element::Lagrange`].
    pub elements: Vec<u32>,
    /// Pressure, Pa; between rough surfaces that of oil and asperities together.
    pub pressure: Vec<f64>,
    /// Pressure of asperities, Pa; empty where there are none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub asperity_pressure: Vec<f64>,
    /// Film thickness, m.
    pub film_thickness: Vec<f64>,
    /// Elastic deflection, m.
    pub deflection: Vec<f64>,
    /// Viscosity, Pa·s.
    pub viscosity: Vec<f64>,
    /// Density, kg/m³.
    pub density: Vec<f64>,
    /// Shear of the film.
    pub shear: ShearFields,
}

impl Centreline {
    /// The fields that there are, with their values, SI; `temperatures` of a thermal contact at the same places.
    pub fn columns<'a>(
        &'a self,
        temperatures: Option<&'a FilmTemperatures>,
    ) -> Vec<(Field, &'a [f64])> {
        let mut columns: Vec<(Field, &[f64])> = vec![
            (Field::Pressure, &self.pressure),
            (Field::HertzPressure, &self.hertz_pressure),
            (Field::FilmThickness, &self.film_thickness),
            (Field::Deflection, &self.deflection),
            (Field::Viscosity, &self.viscosity),
            (Field::Density, &self.density),
        ];
        columns.extend(asperity_column(&self.asperity_pressure));
        columns.extend(self.shear.columns());
        columns.extend(temperatures.into_iter().flat_map(FilmTemperatures::columns));
        columns
    }
}

/// Displacement of the equivalent body, SI.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct BodyField {
    /// Points, m; y = 0 for line contacts.
    pub points: Vec<[f64; 3]>,
    /// Cell corners and, for order 2, mid-edge nodes in VTK order: 3 or 6 (triangles), 4 or 10
    /// (tetrahedra) entries.
    pub cells: Vec<Vec<u32>>,
    /// Displacement vector, m.
    pub displacement: Vec<[f64; 3]>,
}
