//! Whether the teeth of a pair exist and run free of each other.

use super::{GearError, GearPair, GearWarning, Member, Meshing, involute};

impl GearPair {
    /// Refuses tip circles without involute, and pointed teeth.
    pub(super) fn check_tips(&self) -> Result<(), GearError> {
        for member in Member::BOTH {
            let i = member.index();
            let (tip, base) = (self.tip_radii[i], self.base_radii[i]);
            // The wheel's tips may have crossed its axis: the sign shows it.
            if tip * base <= 0.0 || tip.abs() <= base.abs() {
                return Err(GearError::TipInsideBase {
                    member,
                    diameter: 2.0 * tip.abs(),
                    base: 2.0 * base.abs(),
                });
            }
            let thickness = self.tip_thickness(member);
            if thickness <= 0.0 {
                return Err(GearError::Pointed { member, thickness });
            }
        }
        Ok(())
    }

    /// Refuses internal pairs whose tips collide outside the path of contact.
    ///
    /// Where both tip circles cross, seen at δ_1 from the pinion's axis and at δ_2 from the wheel's, the corner of the wheel's tooth must be ahead of that of
    /// the pinion's tooth that drives it. Both flanks touch at the pitch point at the angle 0, the corner of the pinion is inv α_a1 − inv α_wt behind and
    /// that of the wheel inv α_wt − inv α_a2 ahead; the wheel turns z_1/z_2 as far as the pinion:
    ///
    /// z_1 (δ_1 + inv α_a1) − z_2 (δ_2 + inv α_a2) + (z_2 − z_1) inv α_wt ≥ 0
    /// cos δ_1 = (r_a2² − r_a1² − a²)/(2 a r_a1),  cos δ_2 = (r_a2² − r_a1² + a²)/(2 a r_a2)
    ///
    /// with all numbers positive. The condition is derived in the words above; Niemann and Winter, Maschinenelemente II, treat it as interference outside the path.
    pub(super) fn check_internal_tips(&self) -> Result<(), GearError> {
        if self.dimensions.meshing == Meshing::External {
            return Ok(());
        }
        if self
            .internal_tip_margin()
            .is_some_and(|margin| margin < 0.0)
        {
            let [pinion, wheel] = self.dimensions.teeth;
            return Err(GearError::InternalTips { pinion, wheel });
        }
        Ok(())
    }

    /// The left side of the condition of [`GearPair::check_internal_tips`], rad times teeth; `None` where the tip circles do not cross.
    pub(super) fn internal_tip_margin(&self) -> Option<f64> {
        let [r_1, r_2] = self.tip_radii.map(f64::abs);
        let [z_1, z_2] = self.teeth.map(f64::abs);
        let a = self.centre_distance;
        let cosines = [
            (r_2 * r_2 - r_1 * r_1 - a * a) / (2.0 * a * r_1),
            (r_2 * r_2 - r_1 * r_1 + a * a) / (2.0 * a * r_2),
        ];
        if cosines.iter().any(|cosine| cosine.abs() > 1.0) {
            return None;
        }
        let [delta_1, delta_2] = cosines.map(f64::acos);
        let [at_tip_1, at_tip_2] =
            [0, 1].map(|i| involute((self.base_radii[i] / self.tip_radii[i]).acos()));
        Some(
            z_1 * (delta_1 + at_tip_1) - z_2 * (delta_2 + at_tip_2)
                + (z_2 - z_1) * involute(self.working_pressure_angle),
        )
    }

    /// Adds warnings about roots.
    ///
    /// A rack cutter whose straight flank reaches h_Ff = m_n (h_fP* − x − ρ_fP* (1 − sin α_n)) below the reference circle leaves an involute from
    ///
    /// r_Ff = √(r_b² + (r sin α_t − h_Ff/sin α_t)²)
    ///
    /// on, and undercuts where h_Ff > r sin² α_t: the last point of its flank passes the point where the line of action touches the base circle.
    /// Source: ISO 21771:2007, form diameter of generated gears. Roots of internal wheels, which a rack does not cut, are not judged but for clearance.
    pub(super) fn add_warnings(&mut self) {
        let rack = self.dimensions.basic_rack;
        let module = self.dimensions.normal_module;
        for member in Member::BOTH {
            let i = member.index();
            // With the signs of ISO 21771 the tip of the other gear, seen from this axis, is at a_w − r_a.
            let distance = self.working_radii[0] + self.working_radii[1];
            let clearance = distance - self.tip_radii[1 - i] - self.root_radii[i];
            if clearance <= 0.0 {
                let warning = GearWarning::NoClearance { member, clearance };
                self.warnings.push(warning);
            }
            if self.teeth[i] < 0.0 || self.dimensions.root_diameters[i].is_some() {
                continue;
            }
            let rounding = rack.root_radius * (1.0 - self.dimensions.normal_pressure_angle.sin());
            let depth = module * (rack.dedendum - self.shifts[i] - rounding);
            let sine = self.pressure_angle.sin();
            let from_tangent = self.reference_radii[i] * sine - depth / sine;
            if from_tangent < 0.0 {
                self.warnings.push(GearWarning::Undercut { member });
                continue;
            }
            let form_radius = self.base_radii[i].hypot(from_tangent);
            let end = [self.points.a, self.points.e][i];
            let contact_radius = self.radius_at(member, end);
            if contact_radius < form_radius * (1.0 - 1e-9) {
                self.warnings.push(GearWarning::BelowForm {
                    member,
                    form_diameter: 2.0 * form_radius,
                    contact_diameter: 2.0 * contact_radius,
                });
            }
        }
    }
}
