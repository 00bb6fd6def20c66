//! Shear of the film as fields.

use crate::contact::{Scales, Shape};
use crate::engine::PointFields;
use crate::engine::friction::is_skewed;
use crate::engine::shear::Shear;
use crate::film::FilmFluid;
use crate::solution::ShearFields;

/// Shear at a list of points.
pub fn fields<'p>(
    fluid: &FilmFluid,
    scales: &Scales,
    shape: &Shape,
    points: impl IntoIterator<Item = &'p PointFields>,
) -> ShearFields {
    let mut shear = Shear::new(fluid, scales);
    let skewed = is_skewed(shape, fluid);
    let mut fields = ShearFields::default();
    for point in points {
        let s = shear.at(point);
        let [mid, body_1, body_2] = s.stress;
        fields.stress_mid.push(mid[0]);
        fields.stress_body_1.push(body_1[0]);
        fields.stress_body_2.push(body_2[0]);
        if skewed {
            for (field, stress) in fields.stress_across.iter_mut().zip(s.stress) {
                field.push(stress[1]);
            }
        }
        fields.rate_mid.push(s.equivalent[0] / s.viscosity);
        fields.generalized_viscosity.push(s.viscosity);
    }
    fields
}
