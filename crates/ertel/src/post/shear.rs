//! Shear of the film as fields.

use crate::contact::Scales;
use crate::film::FilmFluid;
use crate::solution::ShearFields;
use crate::solve::evaluate::PointFields;
use crate::solve::shear::Shear;

/// Shear at a list of points.
pub fn fields<'p>(
    fluid: &FilmFluid,
    scales: &Scales,
    points: impl IntoIterator<Item = &'p PointFields>,
) -> ShearFields {
    let mut shear = Shear::new(fluid, scales);
    let mut fields = ShearFields::default();
    for point in points {
        let s = shear.at(point);
        fields.stress_mid.push(s.stress[0]);
        fields.stress_plane.push(s.stress[1]);
        fields.stress_ball.push(s.stress[2]);
        fields.rate_mid.push(s.equivalent[0] / s.viscosity);
        fields.generalized_viscosity.push(s.viscosity);
    }
    fields
}
