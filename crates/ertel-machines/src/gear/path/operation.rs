//! Torque, speed and elasticity of a running pair.

use ertel_ehl::contact::{Material, reduced_modulus};

use crate::gear::geometry::{GearError, GearPair, in_range};

/// How a pair runs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Operation {
    /// Torque on the pinion, N·m.
    pub pinion_torque: f64,
    /// Speed of the pinion, rad/s.
    pub pinion_speed: f64,
    /// Elastic constants of the pinion and the wheel; the modulus in Pa.
    pub materials: [Material; 2],
}

impl Operation {
    /// Refuses torques and speeds that are not positive, and materials that are not elastic.
    pub(crate) fn check(&self) -> Result<(), GearError> {
        let positive = |name, value: f64| in_range(name, value, value > 0.0, "positive");
        positive("pinion torque", self.pinion_torque)?;
        positive("pinion speed", self.pinion_speed)?;
        for material in self.materials {
            positive("Young's modulus", material.youngs_modulus)?;
            let nu = material.poissons_ratio;
            let requirement = "between −1 and 0.5";
            in_range(
                "Poisson's ratio",
                nu,
                (-1.0..=0.5).contains(&nu),
                requirement,
            )?;
        }
        Ok(())
    }

    /// Reduced modulus E' of both gears, Pa.
    pub fn reduced_modulus(&self) -> f64 {
        let [pinion, wheel] = self.materials;
        reduced_modulus(wheel, pinion)
    }

    /// Force in the transverse plane of action, N: F_bt = T_1/r_b1.
    pub fn base_force(&self, pair: &GearPair) -> f64 {
        self.pinion_torque / pair.base_radii[0]
    }

    /// Speed of the base circles, m/s: v_tb = ω_1 r_b1, at which contacts travel along the line of action.
    pub fn base_speed(&self, pair: &GearPair) -> f64 {
        self.pinion_speed * pair.base_radii[0]
    }

    /// Power at the pinion, W.
    pub fn power(&self) -> f64 {
        self.pinion_torque * self.pinion_speed
    }

    /// Surface speeds (m/s) across the contact line at the place s (m), pinion first: u = ω ρ with the transverse radius ρ.
    ///
    /// The normal of the plane of action lies in the transverse section, and so does the direction across the contact line in the flanks.
    pub fn surface_speeds(&self, pair: &GearPair, s: f64) -> [f64; 2] {
        let [pinion, wheel] = pair.curvature_radii(s);
        [
            self.pinion_speed * pinion,
            self.pinion_speed / pair.ratio() * wheel.abs(),
        ]
    }
}
