//! The profile of a tooth that a rack cutter generates.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::gear::geometry::{GearError, GearPair, Member, Meshing, involute};

/// Points on each of the fillet and the involute, and parts of the fillet.
const POINTS: usize = 200;

/// The right flank of an upright spur tooth, from its root to its tip: half-thickness x and height y over the axis of the gear, m.
pub(super) struct Tooth {
    pub fillet: Vec<[f64; 2]>,
    /// Base radius, m.
    base: f64,
    /// Half of the angle that a tooth takes at its base circle, rad: ψ + inv α.
    half_angle: f64,
    /// Radius at which the involute begins, m.
    pub form_radius: f64,
    /// Half of the angle that a tooth takes at its root circle, rad.
    pub root_angle: f64,
    /// Root radius, m.
    pub root_radius: f64,
}

impl Tooth {
    /// The tooth of an external spur gear of a pair, as its basic rack cuts it.
    ///
    /// The centre of the rack's tip circle ρ is H = m (h_fP* − x) − ρ below the pitch line and E = m (π/4 − h_fP* tan α) − ρ (1 − sin α)/cos α from the middle
    /// of its tooth. The normal of the contact passes through the pitch point; where it is inclined at ψ, from π/2 at the root to α at the end of the flank,
    /// the fillet is at H/sin ψ + ρ from the pitch point, and the gear has turned by the arc (πm/2 − E + H/tan ψ)/r from the middle of its tooth.
    /// Source: ISO 6336-3 (E); the rest follows from the words above.
    pub fn new(pair: &GearPair, member: Member) -> Result<Tooth, GearError> {
        let refuse = |requirement| {
            Err(GearError::Sharing {
                law: "by beams",
                requirement,
            })
        };
        let i = member.index();
        if pair.dimensions.meshing == Meshing::Internal || pair.base_helix_angle != 0.0 {
            return refuse("external spur gears");
        }
        if pair.dimensions.root_diameters[i].is_some() {
            return refuse("roots of the basic rack");
        }
        let rack = pair.dimensions.basic_rack;
        let (m, alpha) = (pair.dimensions.normal_module, pair.pressure_angle);
        let (r, base) = (pair.reference_radii[i], pair.base_radii[i]);
        let rho = m * rack.root_radius;
        let depth = m * (rack.dedendum - pair.shifts[i]) - rho;
        let offset =
            m * (0.25 * PI - rack.dedendum * alpha.tan()) - rho * (1.0 - alpha.sin()) / alpha.cos();
        if offset < 0.0 {
            return refuse("racks whose root radius fits between their flanks");
        }
        // Distance of the end of the flank from the point where the line of action touches the base circle.
        let from_tangent = r * alpha.sin() - depth / alpha.sin() - rho;
        if from_tangent < 0.0 {
            return refuse("teeth that are not undercut");
        }
        let across = FRAC_PI_2 * m - offset;
        let point = |step: usize| {
            let psi = FRAC_PI_2 + (alpha - FRAC_PI_2) * step as f64 / POINTS as f64;
            let distance = depth / psi.sin() + rho;
            let place = [-distance * psi.cos(), r - distance * psi.sin()];
            let turned = (across + depth / psi.tan()) / r;
            let (angle, radius) = (place[0].atan2(place[1]) + turned, place[0].hypot(place[1]));
            [radius * angle.sin(), radius * angle.cos()]
        };
        Ok(Tooth {
            fillet: (0..=POINTS).map(point).collect(),
            base,
            half_angle: (PI + 4.0 * pair.shifts[i] * alpha.tan()) / (2.0 * pair.teeth[i])
                + involute(alpha),
            form_radius: base.hypot(from_tangent),
            root_angle: across / r,
            root_radius: r - depth - rho,
        })
    }

    /// Half of the angle that the tooth takes at a radius (m) of its involute, rad.
    pub fn angle(&self, radius: f64) -> f64 {
        self.half_angle - involute((self.base / radius).min(1.0).acos())
    }

    /// The flank from the root to a radius of the involute (m).
    pub fn up_to(&self, radius: f64) -> Vec<[f64; 2]> {
        let mut flank = self.fillet.clone();
        for step in 1..=POINTS {
            let share = step as f64 / POINTS as f64;
            let at = self.form_radius + share * (radius - self.form_radius);
            let angle = self.angle(at);
            flank.push([at * angle.sin(), at * angle.cos()]);
        }
        flank
    }

    /// Base radius, m.
    pub fn base_radius(&self) -> f64 {
        self.base
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::gear::geometry::GearDimensions;
    use crate::gear::test_data::c14;

    /// The fillet begins at the root circle, without slope to it, and ends on the involute of the form circle, without a corner. At the reference circle the tooth is
    /// m (π/4 + x tan α) thick to each side.
    #[test]
    fn fillets_join_the_involute() {
        let other = GearDimensions {
            pinion_shift: 0.5,
            ..GearDimensions::spur(2e-3, [20, 47], PI / 9.0, 20e-3)
        };
        for dimensions in [c14(), other] {
            let pair = GearPair::new(&dimensions).expect("a pair");
            for member in Member::BOTH {
                let tooth = Tooth::new(&pair, member).expect("a tooth");
                let i = member.index();
                let [x, y] = tooth.fillet[0];
                assert_relative_eq!(x.hypot(y), pair.root_radii[i], max_relative = 1e-12);
                assert_relative_eq!(x.atan2(y), tooth.root_angle, max_relative = 1e-12);
                let [x, y] = tooth.fillet[POINTS];
                assert_relative_eq!(x.hypot(y), tooth.form_radius, max_relative = 1e-12);
                let angle = tooth.angle(tooth.form_radius);
                assert_relative_eq!(x.atan2(y), angle, max_relative = 1e-10);
                // Slopes of both sides, by differences.
                let near = tooth.form_radius * (1.0 + 1e-5);
                let up = [
                    near * tooth.angle(near).sin(),
                    near * tooth.angle(near).cos(),
                ];
                let slope = (up[0] - x) / (up[1] - y);
                let below = |k: usize| {
                    let [a, b] = tooth.fillet[POINTS - k];
                    (x - a) / (y - b)
                };
                // The fillet's slope at its end, from two chords.
                assert_relative_eq!(2.0 * below(1) - below(2), slope, epsilon = 2e-3);
                let r = pair.reference_radii[i];
                let thick =
                    dimensions.normal_module * (0.25 * PI + pair.shifts[i] * (PI / 9.0).tan());
                assert_relative_eq!(r * tooth.angle(r), thick, max_relative = 1e-12);
            }
        }
    }

    #[test]
    fn refusals() {
        let undercut = GearDimensions::spur(2e-3, [14, 60], PI / 9.0, 20e-3);
        let pair = GearPair::new(&undercut).expect("a pair");
        assert!(Tooth::new(&pair, Member::Pinion).is_err());
        assert!(Tooth::new(&pair, Member::Wheel).is_ok());
    }
}
