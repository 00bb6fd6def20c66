//! Cylindrical roller bearings.

use ertel_ehl::contact::Curvatures;
use ertel_ehl::contact::roller::Profile;

use super::{GeometryError, Ring, check_row, positive, radius_along};

/// Relief of a roller towards its ends; the drop acts in the contacts with either ring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RollerProfile {
    /// A cylinder.
    Cylinder,
    /// An arc of this radius along the roller, m.
    Crown(f64),
    /// The logarithmic reference profile of ISO/TS 16281.
    Logarithmic,
}

impl RollerProfile {
    /// Whether a roller of a length (m) can have it.
    pub(super) fn check(self, length: f64) -> Result<(), GeometryError> {
        match self {
            Self::Crown(radius) if radius.is_nan() || radius <= 0.5 * length => {
                Err(GeometryError::Crown(radius))
            }
            Self::Cylinder | Self::Crown(_) | Self::Logarithmic => Ok(()),
        }
    }

    /// Relief of a roller of a length and a diameter (m); none of a cylinder or cone.
    pub(super) fn relief(self, length: f64, diameter: f64) -> Option<Profile> {
        match self {
            Self::Cylinder => None,
            Self::Crown(crown_radius) => Some(Profile::Crown { crown_radius }),
            Self::Logarithmic => Some(Profile::iso_16281(length, diameter)),
        }
    }
}

/// Internal geometry of a single-row cylindrical roller bearing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RollerGeometry {
    /// Diameter of the rollers D, m.
    pub roller_diameter: f64,
    /// Length of the contact L, m.
    pub length: f64,
    /// Pitch diameter d_m, m.
    pub pitch_diameter: f64,
    /// Number of rollers Z.
    pub number: usize,
    /// Radial internal clearance s, m, from stop to stop; negative of a preloaded bearing.
    pub clearance: f64,
    /// Relief of the rollers.
    pub profile: RollerProfile,
}

impl RollerGeometry {
    /// Whether such a bearing can exist.
    ///
    /// # Errors
    /// Lengths out of range.
    pub fn check(&self) -> Result<(), GeometryError> {
        check_row(self.roller_diameter, self.pitch_diameter, self.number)?;
        positive("roller length", self.length)?;
        if !self.clearance.is_finite() {
            return Err(GeometryError::Length {
                name: "clearance",
                value: self.clearance,
            });
        }
        self.profile.check(self.length)
    }

    /// Relief of a roller as solvers of lubricated contacts take it; none of a cylinder.
    pub fn relief(&self) -> Option<Profile> {
        self.profile.relief(self.length, self.roller_diameter)
    }

    /// Drop from the cylinder at z from the middle (m), m.
    pub fn drop(&self, z: f64) -> f64 {
        (self.relief()).map_or(0.0, |profile| profile.drop(self.length, z)[0])
    }

    /// γ = D/d_m.
    pub fn gamma(&self) -> f64 {
        self.roller_diameter / self.pitch_diameter
    }

    /// Reduced radius along rolling, m: R_x = D/2 (1 ∓ γ).
    pub fn radius(&self, ring: Ring) -> f64 {
        radius_along(ring, self.roller_diameter, self.gamma())
    }

    /// Curvatures of raceway and roller themselves along and across rolling, 1/m; the relief is left out.
    pub fn curvatures(&self, ring: Ring) -> [Curvatures; 2] {
        let roller = 2.0 / self.roller_diameter;
        [[self.radius(ring).recip() - roller, 0.0], [roller, 0.0]]
    }

    /// Mass of a roller of the given density (kg/m³), kg.
    pub fn mass(&self, density: f64) -> f64 {
        density * std::f64::consts::PI * self.roller_diameter.powi(2) * self.length / 4.0
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::near::near;
    use approx::assert_relative_eq;

    pub(crate) fn cylindrical() -> RollerGeometry {
        RollerGeometry {
            roller_diameter: 10e-3,
            length: 10e-3,
            pitch_diameter: 54e-3,
            number: 14,
            clearance: 0.0,
            profile: RollerProfile::Cylinder,
        }
    }

    /// By hand: γ = 10/54, R_x = 5 (1 ∓ γ) mm; a crown of 2 m drops by 5²/(2 · 2000) = 6.25 µm at the ends of 10 mm, the logarithm by
    /// 3.5 µm ln(4/3) = 1.006887 µm halfway.
    #[test]
    fn by_hand() {
        let bearing = cylindrical();
        near(bearing.radius(Ring::Inner), 4.074_074e-3, 1e-6);
        near(bearing.radius(Ring::Outer), 5.925_926e-3, 1e-6);
        // 2/(54 − 10) per mm
        let raceway = bearing.curvatures(Ring::Inner)[0][0];
        assert_relative_eq!(raceway, 2.0 / 44e-3, max_relative = 1e-12);
        assert_eq!(bearing.drop(5e-3), 0.0);
        let with = |profile| RollerGeometry { profile, ..bearing };
        let crowned = with(RollerProfile::Crown(2.0)).drop(5e-3);
        assert_relative_eq!(crowned, 6.25e-6, max_relative = 1e-5);
        let logarithmic = with(RollerProfile::Logarithmic).drop(2.5e-3);
        assert_relative_eq!(logarithmic, 1.006_887e-6, max_relative = 1e-6);
        assert!(with(RollerProfile::Crown(4e-3)).check().is_err());
        assert!(with(RollerProfile::Crown(2.0)).check().is_ok());
    }
}
