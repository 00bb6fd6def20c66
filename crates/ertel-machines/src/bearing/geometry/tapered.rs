//! Tapered roller bearings.

use ertel_ehl::contact::Curvatures;
use ertel_ehl::contact::roller::Profile;

use super::{GeometryError, Ring, RollerProfile, check_row, positive};

/// Steepest cup angle, rad: 45 degrees.
const STEEPEST: f64 = std::f64::consts::FRAC_PI_4;

/// Internal geometry of a single-row tapered roller bearing.
///
/// Rollers and both raceways are cones with one apex on the axis. With the cup angle α_o and the roller's half angle ν, the roller's axis
/// is inclined at α_o − ν to that of the bearing, and the inner raceway at α_i = α_o − 2ν.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TaperedGeometry {
    /// Diameter of the rollers in their middle D, m.
    pub roller_diameter: f64,
    /// Length of the contact L, m.
    pub length: f64,
    /// Pitch diameter d_m through the middles of the rollers, m.
    pub pitch_diameter: f64,
    /// Number of rollers Z.
    pub number: usize,
    /// Contact angle of the outer raceway α_o, rad: half of the cup's angle.
    pub cup_angle: f64,
    /// Relief of the rollers.
    pub profile: RollerProfile,
}

impl TaperedGeometry {
    /// Whether such a bearing can exist.
    ///
    /// # Errors
    /// Lengths or angles out of range.
    pub fn check(&self) -> Result<(), GeometryError> {
        check_row(self.roller_diameter, self.pitch_diameter, self.number)?;
        positive("roller length", self.length)?;
        self.profile.check(self.length)?;
        let good = self.cup_angle > 0.0 && self.cup_angle <= STEEPEST;
        match good && self.angle(Ring::Inner) > 0.0 {
            true => Ok(()),
            false => Err(GeometryError::Angle {
                degrees: self.cup_angle.to_degrees(),
            }),
        }
    }

    /// Half angle of a roller ν, rad.
    ///
    /// tan ν/sin(α_o − ν) = D/d_m: roller and pitch circle seen from the apex; by Newton's method
    pub fn half_angle(&self) -> f64 {
        let ratio = self.roller_diameter / self.pitch_diameter;
        let (s, c) = self.cup_angle.sin_cos();
        let mut nu = (ratio * s).atan2(1.0 + ratio * c);
        for _ in 0..20 {
            let axis = self.cup_angle - nu;
            let rest = nu.tan() - ratio * axis.sin();
            nu -= rest / (nu.cos().powi(-2) + ratio * axis.cos());
        }
        nu
    }

    /// Inclination of the roller's axis to that of the bearing, rad: α_o − ν.
    pub fn axis_angle(&self) -> f64 {
        self.cup_angle - self.half_angle()
    }

    /// Contact angle of a raceway, rad.
    pub fn angle(&self, ring: Ring) -> f64 {
        match ring {
            Ring::Inner => self.cup_angle - 2.0 * self.half_angle(),
            Ring::Outer => self.cup_angle,
        }
    }

    /// Distance of the middle of the contacts from the apex along the raceways, m.
    ///
    /// s = d_m/(2 sin(α_o − ν) cos ν)
    pub fn apex_distance(&self) -> f64 {
        0.5 * self.pitch_diameter / (self.axis_angle().sin() * self.half_angle().cos())
    }

    /// Curvatures of raceway and roller themselves along and across rolling, 1/m: those of the cones in the middle of the contact; the
    /// relief is left out.
    ///
    /// roller 1/(s tan ν),  inner raceway 1/(s tan α_i),  outer raceway −1/(s tan α_o)
    pub fn curvatures(&self, ring: Ring) -> [Curvatures; 2] {
        let of = |angle: f64| 1.0 / (self.apex_distance() * angle.tan());
        [
            [-ring.sign() * of(self.angle(ring)), 0.0],
            [of(self.half_angle()), 0.0],
        ]
    }

    /// Reduced radius along rolling in the middle of the contact, m.
    pub fn radius(&self, ring: Ring) -> f64 {
        let [raceway, roller] = self.curvatures(ring);
        1.0 / (raceway[0] + roller[0])
    }

    /// Relief of a roller along its generator; none of a cone.
    pub fn relief(&self) -> Option<Profile> {
        self.profile.relief(self.length, self.roller_diameter)
    }

    /// Mass of a roller of the given density (kg/m³), kg: a truncated cone.
    pub fn mass(&self, density: f64) -> f64 {
        let taper = self.length * self.half_angle().tan();
        let square = (3.0 * self.roller_diameter.powi(2) + taper * taper) / 12.0;
        density * std::f64::consts::PI * self.length * square
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bearing::test_data::tapered;
    use crate::near::near;
    use approx::assert_relative_eq;

    /// By hand: tan ν = (8/46) sin(14° − ν) at ν = 2.0579°: 0.035933 and 0.173913 · sin 11.9421° = 0.173913 · 0.206922 = 0.035986; at ν =
    /// 2.0605° 0.0359782 and 0.173913 · 0.2068777 = 0.0359787. The middle of the roller then lies at 23/sin 11.9395° = 111.178 mm from the
    /// apex, and its radius is 111.178 tan ν = 4.000 mm.
    #[test]
    fn cones_by_hand() {
        let bearing = tapered();
        let nu = bearing.half_angle();
        assert_relative_eq!(nu.to_degrees(), 2.0605, max_relative = 1e-4);
        let axis = bearing.apex_distance() * nu.cos();
        assert_relative_eq!(axis, 111.178e-3, max_relative = 1e-4);
        assert_relative_eq!(axis * nu.tan(), 4e-3, max_relative = 1e-12);
        near(bearing.angle(Ring::Inner).to_degrees(), 9.879, 1e-4);
    }

    /// Near the formula of cylinders with γ = D cos α/d_m, which takes one angle for both: R_x = D/2 (1 ∓ γ) within 2 %; exactly, raceway
    /// and roller of the outer ring have the radii s tan α_o and s tan ν.
    #[test]
    fn radii() {
        let bearing = tapered();
        let gamma = 8.0 / 46.0 * bearing.axis_angle().cos();
        for (ring, sign) in [(Ring::Inner, -1.0), (Ring::Outer, 1.0)] {
            let cylinder = 4e-3 * (1.0 + sign * gamma);
            assert_relative_eq!(bearing.radius(ring), cylinder, max_relative = 0.02);
        }
        let s = bearing.apex_distance();
        let (cup, roller) = (
            s * 14_f64.to_radians().tan(),
            s * bearing.half_angle().tan(),
        );
        let outer = cup * roller / (cup - roller);
        assert_relative_eq!(bearing.radius(Ring::Outer), outer, max_relative = 1e-12);
    }

    /// The volume of a slender cone's frustum in 1000 discs of the radius D/2 + z tan ν; a steep cup, so that the taper counts.
    #[test]
    fn mass_by_discs() {
        let steep = TaperedGeometry {
            cup_angle: 40_f64.to_radians(),
            ..tapered()
        };
        let taper = steep.half_angle().tan();
        let step = 11e-3 / 1000.0;
        let volume: f64 = (0..1000)
            .map(|k| {
                let z = (f64::from(k) + 0.5) * step - 5.5e-3;
                std::f64::consts::PI * (4e-3 + z * taper).powi(2) * step
            })
            .sum();
        assert_relative_eq!(steep.mass(7850.0), 7850.0 * volume, max_relative = 1e-6);
    }

    #[test]
    fn out_of_range() {
        let good = tapered();
        assert_eq!(good.check(), Ok(()));
        let bad = [
            TaperedGeometry {
                cup_angle: 0.0,
                ..good
            },
            TaperedGeometry {
                cup_angle: 1.0,
                ..good
            },
            TaperedGeometry {
                length: -1.0,
                ..good
            },
            TaperedGeometry { number: 40, ..good },
            TaperedGeometry {
                profile: RollerProfile::Crown(1e-3),
                ..good
            },
        ];
        assert!(bad.iter().all(|b| b.check().is_err()));
    }
}
