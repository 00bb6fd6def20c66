//! The pressure far from a contact, where the surfaces are parabolas and rigid (Kapitza 1955).

use std::f64::consts::PI;

use super::Extents;
use crate::contact::{Gap, Outline, Scales, Shape};
use crate::solution::BeyondEdges;

/// c of the pressure −λ c·X/H² far from a contact, along and across the motion.
pub fn far_field(gap: &Gap) -> [f64; 2] {
    let kappa = gap.curvature_ratio;
    let [along, across] = gap.turn.to_axes([1.0, 0.0]);
    let first = 1.0 / (3.0 + 2.0 * kappa);
    let second = kappa / (3.0 * kappa + 2.0);
    gap.turn.to_motion([first * along, second * across])
}

/// Rolling resistance between the edges r_0 of the contact area and its default distance r_1, for rigid parabolic
/// surfaces:
///
/// ```text
///   P = −c λ X/H²,  X < 0:   ∫½H ∂P/∂X dA = πcλ ln(r_1/r_0),  H = r²/2,  c = 1/5    around a sphere
///                                         = 3cλ (1/r_0 − 1/r_1),  H = X²/2,  c = 1/3    along a cylinder
/// ```
/// (Kapitza 1955), the sum of both walls against the motion; `reach` is r_1 at the inlet and at the side, in half-widths, `stress_scale` a p_h/R in Pa. Around a sphere it
/// grows without bound with r_1.
pub fn beyond_edges(
    shape: &Shape,
    extents: &Extents,
    reach: [f64; 2],
    stress_scale: f64,
    scales: &Scales,
) -> BeyondEdges {
    let edge = extents.inlet.abs();
    // No entrainment beyond the bodies.
    let reach = [
        reach[0].min(shape.ends[0]),
        reach[1].min(shape.ends[1] / shape.zone.axis_ratio),
    ];
    let further = match shape.outline() {
        Outline::Ellipse => (reach[0] / edge).max(reach[1] / extents.side),
        Outline::Strip | Outline::Roller(_) => reach[0] / edge,
    };
    if further <= 1.0 {
        return BeyondEdges::default();
    }
    // Over the part that is solved, as the load.
    let drag = scales.lambda
        * far_field(&shape.gap)[0]
        * match shape.outline() {
            // Over rings as stretched as the Hertz zone, or stretched in any other way.
            Outline::Ellipse => {
                PI * further.ln()
                    / (shape.symmetry.multiplicity() * shape.gap.curvature_ratio.sqrt())
            }
            Outline::Strip => 3.0 * (1.0 - 1.0 / further) / edge,
            // The cylinder's, all along the part that is solved.
            Outline::Roller(roller) => {
                let length = 2.0 * roller.half_length();
                3.0 * (1.0 - 1.0 / further) / edge * length / shape.symmetry.multiplicity()
            }
        };
    let speed = scales.entrainment_speed();
    BeyondEdges {
        traction: drag * stress_scale / (scales.load * scales.pressure),
        // Of both walls, at the mean speed.
        power: 2.0 * drag * stress_scale * scales.area(shape) * speed,
        cut: 1.0 - 1.0 / further,
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::contact::{HertzZone, Inlet, Symmetry, Turn};

    /// The far field by quadrature in ring and angle, ½H ∂P/∂X by differences, over the half of a ball and the line of a roller.
    #[test]
    fn drag_beyond_the_edges() {
        let scales = Scales {
            length: 2e-4,
            pressure: 1e9,
            film: 2.5e-6,
            viscosity: 0.04,
            density: 870.0,
            lambda: 0.01,
            elastic_stress: 8e10,
            load: PI / 3.0,
        };
        let extents = |inlet, side| Extents {
            inlet,
            outlet: 1.5,
            side,
            body_width: 60.0,
            body_depth: 60.0,
        };
        let slope = |p: &dyn Fn(f64) -> f64, x: f64| (p(x + 1e-4) - p(x - 1e-4)) / 2e-4;
        let n = 2000;
        let radii = (0..n).map(|i| {
            (
                3.0 + 6.0 * (f64::from(i) + 0.5) / f64::from(n),
                6.0 / f64::from(n),
            )
        });
        let [mut ball, mut barrel, mut roller] = [0.0; 3];
        let ellipse = Shape {
            dim: 2,
            gap: Gap {
                curvature_ratio: 0.3,
                turn: Turn::NONE,
                terms: Vec::new(),
            },
            zone: HertzZone {
                axis_ratio: 1.7,
                turn: Turn::NONE,
                roller: None,
            },
            symmetry: Symmetry::Full,
            inlet: Inlet::Flooded,
            ends: [f64::INFINITY; 2],
        };
        for (r, width) in radii {
            for k in 0..64 {
                // A quarter of the plane: X < 0, one side of Y = 0
                let angle = 0.5 * PI * (f64::from(k) + 0.5) / 64.0;
                let (x, y) = (-r * angle.cos(), r * angle.sin());
                let film = |x: f64| 0.5 * (x * x + y * y);
                let p = |x: f64| -0.2 * scales.lambda * x / film(x).powi(2);
                ball += 0.5 * PI / 64.0 * r * width * 0.5 * film(x) * slope(&p, x);
                // Both sides, in rings 1.7 times as wide as long
                let film = |x: f64| ellipse.gap.value([x, 1.7 * y]);
                let p = |x: f64| -scales.lambda / 3.6 * x / film(x).powi(2);
                barrel += PI / 64.0 * 1.7 * r * width * 0.5 * film(x) * slope(&p, x);
            }
            let p = |x: f64| -scales.lambda / 3.0 * x / (0.5 * x * x).powi(2);
            roller += width * 0.25 * r * r * slope(&p, -r);
        }
        let unit = 1.25e7;
        for (shape, reach, drag) in [
            (Shape::CIRCULAR, [9.0, 6.0], ball),
            (ellipse, [9.0, 6.0], barrel),
            (Shape::LINE, [9.0, 0.0], roller),
        ] {
            let found = beyond_edges(&shape, &extents(-3.0, 4.0), reach, unit, &scales);
            let traction = drag * unit / (scales.load * scales.pressure);
            assert_relative_eq!(found.traction, traction, max_relative = 1e-4);
            // 2 F u of a force F, with the entrainment speed u = λa³p_h/(12 μ R²).
            let speed = 0.01 * 8e-12 * 1e9 / (12.0 * 0.04 * 0.016 * 0.016);
            let force = drag * unit * scales.area(&shape);
            assert_relative_eq!(found.power, 2.0 * force * speed, max_relative = 1e-4);
            assert_relative_eq!(found.cut, 2.0 / 3.0, max_relative = 1e-12);
        }
        let own = beyond_edges(
            &Shape::CIRCULAR,
            &extents(-9.0, 6.0),
            [9.0, 6.0],
            unit,
            &scales,
        );
        assert_eq!(own, BeyondEdges::default());
    }
}
