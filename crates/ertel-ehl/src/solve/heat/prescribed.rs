//! Which temperatures are prescribed.

use super::space::HeatSpace;
use crate::contact::Symmetry;
use crate::forms::energy::Heat;
use crate::solve::contact_surface::ContactSurface;
use crate::solve::discretisation::Discretisation;

/// Which temperatures are prescribed: those at the bottom of the bodies, and those with which bodies enter.
pub(super) fn prescribed(d: &Discretisation, space: &HeatSpace, heat: &Heat) -> Vec<bool> {
    let column = &space.column;
    let n = column.n();
    let mut fixed = vec![false; space.n()];
    for (node, point) in space.surface.points.iter().enumerate() {
        let own = &mut fixed[node * n..(node + 1) * n];
        for body in 0..2 {
            own[column.bottom(body)] = true;
        }
        let Some(outward) = outward(&d.contact, *point) else {
            continue;
        };
        for (body, law) in heat.bodies.iter().enumerate() {
            let [u, v] = law.velocity.at([point[0], point[1]]);
            if outward[0] * u + outward[1] * v <= 0.0 {
                own[column.body_range(body)].fill(true);
            }
        }
    }
    fixed
}

/// Direction in which the outside lies from a point of an edge that the motion crosses, along and across the motion.
fn outward(contact: &ContactSurface, [x, y, _]: [f64; 3]) -> Option<[f64; 2]> {
    let (e, shape) = (&contact.extents, &contact.shape);
    let tiny = 1e-9 * (e.outlet - e.inlet);
    let [x, y] = shape.zone.unit([x, y]);
    let normal = if x < e.inlet + tiny {
        [-1.0, 0.0]
    } else if x > e.outlet - tiny {
        [1.0, 0.0]
    } else if shape.symmetry == Symmetry::Half || y.abs() < e.side - tiny {
        return None;
    } else {
        [0.0, y.signum()]
    };
    Some(shape.zone.outward(normal))
}
