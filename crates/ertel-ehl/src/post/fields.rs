//! Fields of any film for output, in SI.

use crate::contact::{Scales, Shape};
use crate::engine::{PointFields, Profile};
use crate::film::FilmFluid;
use crate::solution::{Centreline, SurfaceField};

/// Pressures of asperities, Pa; none where there are none.
fn of_asperities(points: &[PointFields], scales: &Scales) -> Vec<f64> {
    let pressures = points.iter().map(|f| f.asperity_pressure);
    match pressures.clone().all(|p| p == 0.0) {
        true => Vec::new(),
        false => pressures.map(|p| p * scales.pressure).collect(),
    }
}

/// A profile in SI, with derived fields.
pub fn centreline_of(
    profile: &Profile,
    shape: &Shape,
    fluid: &FilmFluid,
    scales: &Scales,
) -> Centreline {
    let mut line = Centreline::default();
    for (x, f) in profile.x.iter().zip(&profile.fields) {
        let local = fluid.local(f.pressure, f.temperature.as_deref());
        let properties = local.point();
        line.x.push(x * scales.length);
        line.pressure.push(f.total_pressure() * scales.pressure);
        line.film_thickness.push(f.film * scales.film);
        line.deflection.push(f.deflection * scales.film);
        line.viscosity
            .push(properties.viscosity[0] * scales.viscosity);
        line.density.push(properties.density[0] * scales.density);
        line.hertz_pressure
            .push(shape.zone.pressure([*x, 0.0]) * scales.pressure);
    }
    line.asperity_pressure = of_asperities(&profile.fields, scales);
    line.shear = super::shear::fields(fluid, scales, shape, &profile.fields);
    line
}

/// Fields at points in SI, with derived fields; the caller sets places and cells.
pub fn surface_of(
    points: &[PointFields],
    shape: &Shape,
    fluid: &FilmFluid,
    scales: &Scales,
) -> SurfaceField {
    let mut field = SurfaceField::default();
    for f in points {
        let local = fluid.local(f.pressure, f.temperature.as_deref());
        let properties = local.point();
        field.points.push(f.place.map(|x| x * scales.length));
        field.film_thickness.push(f.film * scales.film);
        field.deflection.push(f.deflection * scales.film);
        field.pressure.push(f.total_pressure() * scales.pressure);
        field
            .viscosity
            .push(properties.viscosity[0] * scales.viscosity);
        field.density.push(properties.density[0] * scales.density);
    }
    field.asperity_pressure = of_asperities(points, scales);
    field.shear = super::shear::fields(fluid, scales, shape, points);
    field
}
