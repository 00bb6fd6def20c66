//! The geometry that follows from the dimensions of a pair.

use std::f64::consts::PI;

use super::{
    GearDimensions, GearError, GearWarning, Member, TipAlteration, inverse_involute, involute,
};

/// The centre distance may differ by this many modules from that without backlash: shifts are written with a few digits, and teeth are made thinner.
const CENTRE_DISTANCE_TOLERANCE: f64 = 5e-3;

/// Points on the line of action, m from the pitch point C, positive towards the pinion's tip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinePoints {
    /// Where the line touches the pinion's base circle, T_1.
    pub pinion_tangent: f64,
    /// Tip of the wheel.
    pub a: f64,
    /// Inner point of single contact: one base pitch before E.
    pub b: f64,
    /// Outer point of single contact: one base pitch after A.
    pub d: f64,
    /// Tip of the pinion.
    pub e: f64,
    /// Where the line touches the wheel's base circle, T_2; of an internal wheel, on the same side as T_1 and beyond it.
    pub wheel_tangent: f64,
}

/// A pair of gears and its geometry. Arrays have the pinion first; lengths in m, angles in rad. Radii of an internal wheel are negative, as in
/// ISO 21771, and so is its number of teeth here.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct GearPair {
    /// The dimensions as given.
    pub dimensions: GearDimensions,
    /// Teeth z; negative of an internal wheel.
    pub teeth: [f64; 2],
    /// Profile shift coefficients x.
    pub shifts: [f64; 2],
    /// Tip alteration coefficient k.
    pub tip_alteration: f64,
    /// Transverse pressure angle α_t.
    pub pressure_angle: f64,
    /// Working transverse pressure angle α_wt.
    pub working_pressure_angle: f64,
    /// Base helix angle β_b.
    pub base_helix_angle: f64,
    /// Working centre distance a_w; positive of internal pairs too.
    pub centre_distance: f64,
    /// Reference radii r.
    pub reference_radii: [f64; 2],
    /// Base radii r_b.
    pub base_radii: [f64; 2],
    /// Working pitch radii r_w.
    pub working_radii: [f64; 2],
    /// Tip radii r_a.
    pub tip_radii: [f64; 2],
    /// Root radii r_f.
    pub root_radii: [f64; 2],
    /// Common face width b.
    pub face_width: f64,
    /// Transverse base pitch p_bt.
    pub base_pitch: f64,
    /// Points on the line of action.
    pub points: LinePoints,
    /// Transverse contact ratio ε_α.
    pub contact_ratio: f64,
    /// Overlap ratio ε_β.
    pub overlap_ratio: f64,
    /// Warnings.
    pub warnings: Vec<GearWarning>,
}

impl GearPair {
    /// Geometry of a pair.
    ///
    /// With z_2, r_2 and a negative of an internal wheel:
    ///
    /// m_t = m_n/cos β,  tan α_t = tan α_n/cos β,  sin β_b = sin β cos α_n,  r = m_t z/2,  r_b = r cos α_t,  a = r_1 + r_2
    /// inv α_wt = inv α_t + 2 tan α_n (x_1 + x_2)/(z_1 + z_2),  a_w = a cos α_t/cos α_wt,  r_w = r_b/cos α_wt
    /// r_a = r + m_n (h_aP* + x + k),  r_f = r − m_n (h_fP* − x)
    /// p_bt = π m_t cos α_t,  ε_α = AE/p_bt,  ε_β = b sin β/(π m_n)
    ///
    /// Source: ISO 21771:2007, 4 and 5; the indices 1 and 2 are the pinion and the wheel there.
    ///
    /// # Errors
    ///
    /// Numbers out of range, and pairs that cannot mesh: see [`GearError`].
    pub fn new(dimensions: &GearDimensions) -> Result<GearPair, GearError> {
        dimensions.check()?;
        let sign = dimensions.meshing.sign();
        let module = dimensions.normal_module;
        let (alpha_n, beta) = (dimensions.normal_pressure_angle, dimensions.helix_angle);
        let teeth = [
            f64::from(dimensions.teeth[0]),
            sign * f64::from(dimensions.teeth[1]),
        ];
        let transverse_module = module / beta.cos();
        // Straight teeth keep α_n to the last bit.
        let pressure_angle = if beta == 0.0 {
            alpha_n
        } else {
            (alpha_n.tan() / beta.cos()).atan()
        };
        let base_helix_angle = (beta.sin() * alpha_n.cos()).asin();
        let reference_radii = teeth.map(|z| 0.5 * transverse_module * z);
        let base_radii = reference_radii.map(|r| r * pressure_angle.cos());

        let (working_pressure_angle, shifts) = working_angle(dimensions, teeth, pressure_angle)?;
        let working_radii = base_radii.map(|r| r / working_pressure_angle.cos());
        let centre_distance = working_radii[0] + working_radii[1];
        let reference_distance = reference_radii[0] + reference_radii[1];
        let tip_alteration = match dimensions.tip_alteration {
            TipAlteration::None => 0.0,
            TipAlteration::KeepClearance => {
                (centre_distance - reference_distance) / module - (shifts[0] + shifts[1])
            }
        };
        let rack = dimensions.basic_rack;
        let signs = [1.0, sign];
        let tip_radii = [0, 1].map(|i| match dimensions.tip_diameters[i] {
            Some(diameter) => 0.5 * signs[i] * diameter,
            None => reference_radii[i] + module * (rack.addendum + shifts[i] + tip_alteration),
        });
        let root_radii = [0, 1].map(|i| match dimensions.root_diameters[i] {
            Some(diameter) => 0.5 * signs[i] * diameter,
            None => reference_radii[i] - module * (rack.dedendum - shifts[i]),
        });
        let base_pitch = PI * transverse_module * pressure_angle.cos();
        let face_width = dimensions.face_widths[0].min(dimensions.face_widths[1]);
        let mut pair = GearPair {
            dimensions: dimensions.clone(),
            teeth,
            shifts,
            tip_alteration,
            pressure_angle,
            working_pressure_angle,
            base_helix_angle,
            centre_distance: centre_distance.abs(),
            reference_radii,
            base_radii,
            working_radii,
            tip_radii,
            root_radii,
            face_width,
            base_pitch,
            points: LinePoints {
                pinion_tangent: -working_radii[0] * working_pressure_angle.sin(),
                a: 0.0,
                b: 0.0,
                d: 0.0,
                e: 0.0,
                wheel_tangent: working_radii[1] * working_pressure_angle.sin(),
            },
            contact_ratio: 0.0,
            overlap_ratio: face_width * beta.sin() / (PI * module),
            warnings: Vec::new(),
        };
        pair.check_tips()?;
        pair.lay_path();
        pair.contact_ratio = (pair.points.e - pair.points.a) / base_pitch;
        if pair.contact_ratio < 1.0 {
            return Err(GearError::ContactRatio {
                ratio: pair.contact_ratio,
            });
        }
        pair.check_internal_tips()?;
        pair.add_warnings();
        Ok(pair)
    }

    /// Signed radii of curvature (m) in the transverse section at the place s (m): ρ_1 = r_w1 sin α_wt + s, ρ_2 = r_w2 sin α_wt − s, pinion first. The
    /// wheel's is negative where it is internal: concave.
    pub fn curvature_radii(&self, s: f64) -> [f64; 2] {
        [
            s - self.points.pinion_tangent,
            self.points.wheel_tangent - s,
        ]
    }

    /// Roll angle (rad) of the pinion at the place s (m): ξ = ρ_1/r_b1, from where the line of action touches its base circle.
    ///
    /// Source: ISO 21771:2007, rolling angle of the involute.
    pub fn roll_angle(&self, s: f64) -> f64 {
        self.curvature_radii(s)[0] / self.base_radii[0]
    }

    /// Reduced radius (m) across the contact line at the place s (m): R = 1/[(1/ρ_1 + 1/ρ_2) cos β_b].
    pub fn reduced_radius(&self, s: f64) -> f64 {
        let [pinion, wheel] = self.curvature_radii(s);
        pinion * wheel / (pinion + wheel) / self.base_helix_angle.cos()
    }

    /// Radius (m) of a gear at which it is touched at the place s (m): √(r_b² + ρ²); positive.
    pub fn radius_at(&self, member: Member, s: f64) -> f64 {
        let i = member.index();
        self.base_radii[i].hypot(self.curvature_radii(s)[i])
    }

    /// Tip thickness (m) in the transverse section: s_a = 2 r_a (ψ + inv α_t − inv α_a), ψ = (π + 4 x tan α_n)/(2 z), cos α_a = r_b/r_a; of both signs of z.
    ///
    /// Source: ISO 21771:2007, tooth thickness at a circle.
    pub fn tip_thickness(&self, member: Member) -> f64 {
        let i = member.index();
        let tangent = self.dimensions.normal_pressure_angle.tan();
        let half_angle = (PI + 4.0 * self.shifts[i] * tangent) / (2.0 * self.teeth[i]);
        let at_tip = (self.base_radii[i] / self.tip_radii[i]).acos();
        2.0 * self.tip_radii[i] * (half_angle + involute(self.pressure_angle) - involute(at_tip))
    }

    /// Ratio of the shaft speeds |z_2|/z_1.
    pub fn ratio(&self) -> f64 {
        (self.teeth[1] / self.teeth[0]).abs()
    }

    /// Relief of both gears together (m) at the place s (m), normal to the flanks.
    pub fn relief(&self, s: f64) -> f64 {
        let distances = [self.points.e - s, s - self.points.a];
        let each = |i: usize| {
            self.dimensions.reliefs[i].map_or(0.0, |relief| relief.at(distances[i].max(0.0)))
        };
        each(0) + each(1)
    }

    /// Lays A, B, D and E: tips cut the line at ρ_a = √(r_a² − r_b²), but not beyond the points where it touches the base circles.
    fn lay_path(&mut self) {
        let at_tip = |i: usize| {
            let (tip, base) = (self.tip_radii[i], self.base_radii[i]);
            (tip * tip - base * base).sqrt().copysign(tip)
        };
        let mut a = self.points.wheel_tangent - at_tip(1);
        let mut e = self.points.pinion_tangent + at_tip(0);
        // A hundred-millionth of the length: the tip of a rack-like wheel ends at the tangent point within round-off.
        let slack = 1e-8 * self.base_pitch;
        if a < self.points.pinion_tangent {
            if a < self.points.pinion_tangent - slack {
                self.warnings.push(GearWarning::TipBeyondTangent {
                    member: Member::Pinion,
                });
            }
            a = self.points.pinion_tangent;
        }
        if self.teeth[1] > 0.0 && e > self.points.wheel_tangent {
            if e > self.points.wheel_tangent + slack {
                self.warnings.push(GearWarning::TipBeyondTangent {
                    member: Member::Wheel,
                });
            }
            e = self.points.wheel_tangent;
        }
        self.points.a = a;
        self.points.b = e - self.base_pitch;
        self.points.d = a + self.base_pitch;
        self.points.e = e;
    }
}

/// Working pressure angle and profile shifts, from whichever of the shifts and the centre distance are given.
fn working_angle(
    dimensions: &GearDimensions,
    teeth: [f64; 2],
    alpha_t: f64,
) -> Result<(f64, [f64; 2]), GearError> {
    let sum_of_teeth = teeth[0] + teeth[1];
    let module = dimensions.normal_module;
    let base_distance =
        0.5 * module / dimensions.helix_angle.cos() * sum_of_teeth.abs() * alpha_t.cos();
    let tangent = dimensions.normal_pressure_angle.tan();
    let pinion = dimensions.pinion_shift;
    let without_backlash = |sum: f64| {
        inverse_involute(involute(alpha_t) + 2.0 * tangent * sum / sum_of_teeth)
            .filter(|angle| *angle > 0.0)
            .ok_or(GearError::ProfileShift { sum })
    };
    let Some(given) = dimensions.centre_distance else {
        let wheel = dimensions.wheel_shift.unwrap_or(0.0);
        // The inverse of the involute would lose the last bits of gears without shift.
        let angle = if pinion + wheel == 0.0 {
            alpha_t
        } else {
            without_backlash(pinion + wheel)?
        };
        return Ok((angle, [pinion, wheel]));
    };
    if given <= base_distance {
        return Err(GearError::CentreDistance {
            centre_distance: given,
            smallest: base_distance,
        });
    }
    let angle = (base_distance / given).acos();
    let Some(wheel) = dimensions.wheel_shift else {
        let sum = (involute(angle) - involute(alpha_t)) * sum_of_teeth / (2.0 * tangent);
        return Ok((angle, [pinion, sum - pinion]));
    };
    let from_shifts = base_distance / without_backlash(pinion + wheel)?.cos();
    if (given - from_shifts).abs() > CENTRE_DISTANCE_TOLERANCE * module {
        return Err(GearError::Inconsistent { given, from_shifts });
    }
    Ok((angle, [pinion, wheel]))
}
