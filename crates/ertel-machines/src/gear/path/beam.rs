//! Compliance of a pair of spur teeth from the energies of bending, shear and compression of the teeth, of their foundations and of the Hertz contact.

use ertel_ehl::contact::Material;

use super::Operation;
use super::tooth::Tooth;
use crate::gear::geometry::{GearError, GearPair, Member, in_range};

/// Compliances of pairs of teeth along the path of contact.
pub(super) struct Beams {
    teeth: [Tooth; 2],
    materials: [Material; 2],
    bores: [f64; 2],
    contact: f64,
}

impl Beams {
    /// Of a pair, its materials and the radii of its bores (m).
    pub fn new(
        pair: &GearPair,
        operation: &Operation,
        bores: [f64; 2],
    ) -> Result<Beams, GearError> {
        let teeth = [
            Tooth::new(pair, Member::Pinion)?,
            Tooth::new(pair, Member::Wheel)?,
        ];
        for i in 0..2 {
            let inside = bores[i] > 0.0 && bores[i] < teeth[i].root_radius;
            in_range(
                "bore radius",
                bores[i],
                inside,
                "positive and below the root radius",
            )?;
        }
        Ok(Beams {
            teeth,
            materials: operation.materials,
            bores,
            contact: 4.0 / (std::f64::consts::PI * operation.reduced_modulus()),
        })
    }

    /// Stiffness of the pair per face width (N/m²) at the place s (m): 1/k = 1/k_1 + 1/k_2 + 4/(π E'), the last of both flanks in contact
    /// (Yang and Lin 1987).
    pub fn stiffness(&self, pair: &GearPair, s: f64) -> f64 {
        let each = |member: Member| {
            let i = member.index();
            let radius = pair.radius_at(member, s);
            let material = self.materials[i];
            let tooth = &self.teeth[i];
            tooth_compliance(tooth, radius, material)
                + foundation(tooth, radius, material, self.bores[i])
        };
        (each(Member::Pinion) + each(Member::Wheel) + self.contact).recip()
    }
}

/// The angle α' (rad) between the force at a radius (m) and the normal of the tooth's axis, and the height y_I (m) at which the force crosses the axis:
/// α' = arccos(r_b/r) − γ with the half angle γ of the tooth there, y_I = r_b/cos α'.
fn force_line(tooth: &Tooth, radius: f64) -> [f64; 2] {
    let base = tooth.base_radius();
    let angle = (base / radius).min(1.0).acos() - tooth.angle(radius);
    [angle, base / angle.cos()]
}

/// Displacement along a force of 1 N/m at a radius (m) of a tooth on a rigid body, m²/N, by Castigliano's theorem over the heights y below the force.
///
/// ∫ [12 (y_I − y)² cos² α'/(2x)³ + 2.4 (1 + ν) cos² α'/(2x) + sin² α'/(2x)] dy/E
///
/// Sources: Weber and Banaschek 1953; Yang and Lin 1987; Tian 2004 (potential energy).
fn tooth_compliance(tooth: &Tooth, radius: f64, material: Material) -> f64 {
    let [angle, crossing] = force_line(tooth, radius);
    beam(&tooth.up_to(radius), angle, crossing, material)
}

/// The integral of [`tooth_compliance`] over a flank of points [x, y], by the trapezoidal rule.
fn beam(flank: &[[f64; 2]], angle: f64, crossing: f64, material: Material) -> f64 {
    let (sine, cosine) = angle.sin_cos();
    let density = |[x, y]: [f64; 2]| {
        let thickness = 2.0 * x;
        let arm = cosine * (crossing - y);
        12.0 * arm * arm / thickness.powi(3)
            + (2.4 * (1.0 + material.poissons_ratio) * cosine * cosine + sine * sine) / thickness
    };
    let parts = flank.windows(2);
    let sum: f64 = parts
        .map(|ends| 0.5 * (density(ends[0]) + density(ends[1])) * (ends[1][1] - ends[0][1]))
        .sum();
    sum / material.youngs_modulus
}

/// Displacement along a force of 1 N/m that the elastic ring below the tooth adds, m²/N.
///
/// cos² α'/E [L (u/s)² + M u/s + P (1 + Q tan² α')],  u = y_I − r_f,  s = 2 r_f θ_f
///
/// with L, M, P and Q as polynomials of h = r_f/r_bore and the half angle θ_f of the tooth at its root: A/θ² + B h² + C h/θ + D/θ + F h + G. They were fitted for
/// 1.4 ≤ h ≤ 7 and 0.01 ≤ θ_f ≤ 0.12.
/// Source: Sainsot, Velex and Duverger, J. Mech. Des. 126, 2004, 748–752; constants as in GEARpie (C. Fernandes).
fn foundation(tooth: &Tooth, radius: f64, material: Material, bore: f64) -> f64 {
    let [angle, crossing] = force_line(tooth, radius);
    let theta = tooth.root_angle;
    let h = tooth.root_radius / bore;
    let fit = |[a, b, c, d, f, g]: [f64; 6]| {
        a / (theta * theta) + b * h * h + c * h / theta + d / theta + f * h + g
    };
    let [l, m, p, q] = [
        [-5.574e-5, -1.9986e-3, -2.3015e-4, 4.7702e-3, 0.0271, 6.8045],
        [60.111e-5, 28.100e-3, -83.431e-4, -9.9256e-3, 0.1624, 0.9086],
        [-50.952e-5, 185.50e-3, 0.0538e-4, 53.300e-3, 0.2895, 0.9236],
        [
            -6.2042e-5, 9.0889e-3, -4.0964e-4, 7.8297e-3, -0.1472, 0.6904,
        ],
    ]
    .map(fit);
    let height = (crossing - tooth.root_radius) / (2.0 * tooth.root_radius * theta);
    let (cosine, tangent) = (angle.cos(), angle.tan());
    cosine * cosine / material.youngs_modulus
        * (l * height * height + m * height + p * (1.0 + q * tangent * tangent))
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::gear::geometry::GearDimensions;
    use crate::gear::test_data::{c14, steel, steel_operation};

    /// A beam of even thickness t = 4 mm and length 8 mm under a force across it at its end: 4 l³/(E t³) + 2.4 (1 + ν) l/(E t) =
    /// (32 + 6.24)/206e9 m²/N; the rule has 400 parts of l. Inclined at 30° with the crossing at its end: cos² 30° times that, and sin² 30° l/(E t).
    #[test]
    fn even_beams() {
        let flank: Vec<[f64; 2]> = (0..=400).map(|i| [2e-3, 2e-5 * f64::from(i)]).collect();
        let straight = beam(&flank, 0.0, 8e-3, steel());
        assert_relative_eq!(straight, 38.24 / 206e9, max_relative = 1e-5);
        let inclined = beam(&flank, std::f64::consts::PI / 6.0, 8e-3, steel());
        assert_relative_eq!(inclined, (0.75 * 38.24 + 0.5) / 206e9, max_relative = 1e-5);
    }

    /// The same pair at the pitch point: 1.77593485394790e-5 and 2.54978012234434e-5 mm²/N of a separate program.
    #[test]
    fn foundations() {
        let pair = GearPair::new(&c14()).expect("a pair");
        let operation = steel_operation(200.0, 1500.0);
        let beams = Beams::new(&pair, &operation, [15e-3; 2]).expect("beams");
        for (member, right) in [
            (Member::Pinion, 1.77593485394790e-11),
            (Member::Wheel, 2.54978012234434e-11),
        ] {
            let tooth = &beams.teeth[member.index()];
            let found = foundation(tooth, pair.radius_at(member, 0.0), steel(), 15e-3);
            assert_relative_eq!(found, right, max_relative = 1e-8);
        }
    }

    /// Two equal gears: a pinion of half the modulus at a place is as soft as a wheel of half the modulus at the mirrored place, and the wheel that is touched near its root bends less than the
    /// pinion near its tip.
    #[test]
    fn equal_gears_may_change_places() {
        let dimensions = GearDimensions::spur(4.5e-3, [24, 24], std::f64::consts::PI / 9.0, 14e-3);
        let pair = GearPair::new(&dimensions).expect("a pair");
        let soft = Material {
            youngs_modulus: 103e9,
            ..steel()
        };
        let compliance = |materials: [Material; 2], s: f64| {
            let operation = Operation {
                materials,
                ..steel_operation(200.0, 1500.0)
            };
            let beams = Beams::new(&pair, &operation, [15e-3; 2]).expect("beams");
            beams.stiffness(&pair, s).recip()
        };
        let s = 0.8 * pair.points.e;
        let pinion = compliance([soft, steel()], s);
        let wheel = compliance([steel(), soft], s);
        assert_relative_eq!(pinion, compliance([steel(), soft], -s), max_relative = 1e-9);
        assert!(pinion > 1.1 * wheel, "{pinion} {wheel}");
    }

    /// C14 with bores of 15 mm, at three places. By a separate program, with the fillet and the involute in 20 000 parts.
    #[test]
    fn against_a_separate_program() {
        let pair = GearPair::new(&c14()).expect("a pair");
        let operation = steel_operation(200.0, 1500.0);
        let beams = Beams::new(&pair, &operation, [15e-3; 2]).expect("beams");
        for (s, right) in [
            (pair.points.a, 9_663_293_420.0),
            (0.0, 13_569_250_613.0),
            (pair.points.e, 9_672_418_763.0),
        ] {
            assert_relative_eq!(beams.stiffness(&pair, s), right, max_relative = 1e-4);
        }
    }
}
