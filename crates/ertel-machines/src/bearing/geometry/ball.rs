//! Ball bearings: deep groove and angular contact.

use ertel_ehl::contact::Curvatures;

use super::{GeometryError, Ring, check_row, radius_along};

/// Largest free contact angle, rad: 85 degrees, beyond which a bearing is a thrust bearing.
const STEEPEST: f64 = 85.0 * std::f64::consts::PI / 180.0;

/// How the play of a ball bearing is given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Play {
    /// Radial internal clearance s = P_d, m: by how much one ring moves across the other one, from stop to stop. Negative: the balls are
    /// squeezed before any load acts.
    Clearance(f64),
    /// Free contact angle α0, rad.
    FreeAngle(f64),
}

/// Internal geometry of a single-row ball bearing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BallGeometry {
    /// Diameter of the balls D, m.
    pub ball_diameter: f64,
    /// Pitch diameter d_m, m.
    pub pitch_diameter: f64,
    /// Number of balls Z.
    pub number: usize,
    /// Radius of the groove over diameter of the ball, f_i and f_o.
    pub groove: [f64; 2],
    /// Clearance or free contact angle.
    pub play: Play,
}

impl BallGeometry {
    /// Whether such a bearing can exist.
    ///
    /// # Errors
    /// Lengths, ratios or angles out of range.
    pub fn check(&self) -> Result<(), GeometryError> {
        check_row(self.ball_diameter, self.pitch_diameter, self.number)?;
        for ring in Ring::BOTH {
            let value = self.groove[ring.index()];
            if !(value > 0.5 && value.is_finite()) {
                return Err(GeometryError::Groove { ring, value });
            }
        }
        match self.play {
            Play::FreeAngle(angle) if !(0.0..=STEEPEST).contains(&angle) => {
                Err(GeometryError::Angle {
                    degrees: angle.to_degrees(),
                })
            }
            Play::Clearance(value) => {
                let largest = 2.0 * self.centre_distance() * (1.0 - STEEPEST.cos());
                match value <= largest && value.is_finite() {
                    true => Ok(()),
                    false => Err(GeometryError::Clearance { value, largest }),
                }
            }
            Play::FreeAngle(_) => Ok(()),
        }
    }

    /// Distance of the centres of both grooves when the balls touch without load, m.
    ///
    /// A = (f_i + f_o − 1) D
    pub fn centre_distance(&self) -> f64 {
        (self.groove[0] + self.groove[1] - 1.0) * self.ball_diameter
    }

    /// Distance from the centre of a groove to that of a ball that touches it, m.
    ///
    /// (f − ½) D
    pub fn reach(&self, ring: Ring) -> f64 {
        (self.groove[ring.index()] - 0.5) * self.ball_diameter
    }

    /// Free contact angle, rad; 0 where the balls are squeezed.
    ///
    /// cos α0 = 1 − s/(2A)
    ///
    /// Source: Harris and Kotzalas 2007, chapter 2.
    pub fn free_angle(&self) -> f64 {
        match self.play {
            Play::FreeAngle(angle) => angle,
            Play::Clearance(s) if s <= 0.0 => 0.0,
            Play::Clearance(s) => (1.0 - 0.5 * s / self.centre_distance()).acos(),
        }
    }

    /// Radial internal clearance s, m.
    ///
    /// s = 2A (1 − cos α0)
    pub fn clearance(&self) -> f64 {
        match self.play {
            Play::Clearance(s) => s,
            Play::FreeAngle(angle) => {
                // 1 − cos without cancellation
                4.0 * self.centre_distance() * (0.5 * angle).sin().powi(2)
            }
        }
    }

    /// From the centre of the outer groove to that of the inner one, radially and axially, m: at no shift of the rings, where the balls
    /// touch at the free contact angle.
    pub fn centres(&self) -> [f64; 2] {
        let a = self.centre_distance();
        [a - 0.5 * self.clearance(), a * self.free_angle().sin()]
    }

    /// Axial play from stop to stop, m: 2A sin α0.
    pub fn axial_play(&self) -> f64 {
        2.0 * self.centre_distance() * self.free_angle().sin()
    }

    /// Radius at which the centres of the inner groove lie, m: the arm of tilts and moments (ISO/TS 16281).
    ///
    /// ℛ_i = d_m/2 + (f_i − ½) D cos α0
    pub fn arm(&self) -> f64 {
        0.5 * self.pitch_diameter + self.reach(Ring::Inner) * self.free_angle().cos()
    }

    /// γ = D cos α/d_m at a contact angle (rad).
    pub fn gamma(&self, angle: f64) -> f64 {
        self.ball_diameter * angle.cos() / self.pitch_diameter
    }

    /// Reduced radii of ball and raceway along and across rolling at a contact angle (rad), m.
    ///
    /// R_x = D/2 (1 ∓ γ),  R_y = D/(2 − 1/f)
    ///
    /// Source: Harris and Kotzalas 2007, chapter 2.
    pub fn radii(&self, ring: Ring, angle: f64) -> [f64; 2] {
        let d = self.ball_diameter;
        [
            radius_along(ring, d, self.gamma(angle)),
            d / (2.0 - self.groove[ring.index()].recip()),
        ]
    }

    /// Change of the curvature 1/R_x with the contact angle (rad), 1/m.
    ///
    /// d(1/R_x)/dα = ∓(2/d_m) sin α/(1 ∓ γ)²
    pub(crate) fn curvature_slope(&self, ring: Ring, angle: f64) -> f64 {
        let factor = 1.0 + ring.sign() * self.gamma(angle);
        ring.sign() * 2.0 * angle.sin() / (self.pitch_diameter * factor * factor)
    }

    /// Curvatures of raceway and ball themselves along and across rolling, 1/m.
    pub fn curvatures(&self, ring: Ring, angle: f64) -> [Curvatures; 2] {
        let ball = 2.0 / self.ball_diameter;
        let [along, across] = self.radii(ring, angle);
        [[along.recip() - ball, across.recip() - ball], [ball, ball]]
    }

    /// Mass of a ball of the given density (kg/m³), kg.
    pub fn mass(&self, density: f64) -> f64 {
        density * std::f64::consts::PI * self.ball_diameter.powi(3) / 6.0
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::near::near;
    use approx::assert_relative_eq;

    /// 6206-like with 15 µm.
    pub(crate) fn deep_groove() -> BallGeometry {
        BallGeometry {
            ball_diameter: 9.525e-3,
            pitch_diameter: 46e-3,
            number: 9,
            groove: [0.515, 0.525],
            play: Play::Clearance(15e-6),
        }
    }

    /// By hand: A = 0.04 · 9.525 = 0.381 mm, cos α0 = 1 − 0.015/0.762 = 0.980315, α0 = 11.3873°, s back again, axial play
    /// 0.762 sin α0 = 0.150449 mm.
    #[test]
    fn free_angle_by_hand() {
        let bearing = deep_groove();
        assert_relative_eq!(bearing.centre_distance(), 0.381e-3, max_relative = 1e-12);
        let angle = bearing.free_angle();
        assert_relative_eq!(angle.to_degrees(), 11.387_300_58, max_relative = 1e-9);
        let by_angle = BallGeometry {
            play: Play::FreeAngle(angle),
            ..bearing
        };
        assert_relative_eq!(by_angle.clearance(), 15e-6, max_relative = 1e-9);
        near(by_angle.centres()[0], bearing.centres()[0], 1e-12);
        assert_relative_eq!(bearing.axial_play(), 0.150_449e-3, max_relative = 1e-5);
        let squeezed = BallGeometry {
            play: Play::Clearance(-4e-6),
            ..bearing
        };
        assert_eq!(squeezed.free_angle(), 0.0);
        assert_relative_eq!(squeezed.centres()[0], 0.383e-3, max_relative = 1e-12);
    }

    /// By hand at α = 0: γ = 9.525/46 = 0.2070652, R_x = 4.7625 · 0.7929348 = 3.776352 mm inside, 5.748648 mm outside; R_y =
    /// 9.525/(2 − 1/0.515) = 163.5125 mm inside. ρ of the inner raceway: 2/(46 − 9.525) per mm.
    #[test]
    fn radii_by_hand() {
        let bearing = deep_groove();
        let [x, y] = bearing.radii(Ring::Inner, 0.0);
        assert_relative_eq!(x, 3.776_352e-3, max_relative = 1e-6);
        assert_relative_eq!(y, 163.5125e-3, max_relative = 1e-9);
        near(bearing.radii(Ring::Outer, 0.0)[0], 5.748_648e-3, 1e-6);
        let [raceway, ball] = bearing.curvatures(Ring::Inner, 0.0);
        assert_relative_eq!(raceway[0], 2.0 / 36.475e-3, max_relative = 1e-12);
        assert_relative_eq!(raceway[1], -1.0 / (0.515 * 9.525e-3), max_relative = 1e-12);
        assert_eq!(ball[0], ball[1]);
    }

    #[test]
    fn slopes_of_curvatures_are_differences() {
        let bearing = deep_groove();
        for ring in Ring::BOTH {
            let of = |a: f64| bearing.radii(ring, a)[0].recip();
            let difference = (of(0.7 + 1e-6) - of(0.7 - 1e-6)) / 2e-6;
            near(bearing.curvature_slope(ring, 0.7), difference, 1e-7);
        }
    }

    #[test]
    fn geometries_out_of_range() {
        let good = deep_groove();
        assert_eq!(good.check(), Ok(()));
        let most = GeometryError::Number {
            number: 16,
            most: 15,
        };
        // 46 sin(π/15) = 9.564, 46 sin(π/16) = 8.974
        assert_eq!(BallGeometry { number: 15, ..good }.check(), Ok(()));
        assert_eq!(BallGeometry { number: 16, ..good }.check(), Err(most));
        let bad = [
            BallGeometry {
                ball_diameter: f64::NAN,
                ..good
            },
            BallGeometry {
                ball_diameter: 50e-3,
                ..good
            },
            BallGeometry {
                groove: [0.5, 0.52],
                ..good
            },
            BallGeometry {
                play: Play::Clearance(1.0),
                ..good
            },
            BallGeometry {
                play: Play::FreeAngle(-0.1),
                ..good
            },
        ];
        assert!(bad.iter().all(|b| b.check().is_err()));
        // 2 · 0.381 mm (1 − cos 85°) = 695.6 µm
        let wide = BallGeometry {
            play: Play::Clearance(2e-3),
            ..good
        };
        let said = wide.check().unwrap_err().to_string();
        assert!(
            said.contains("2000 µm") && said.contains("695.6 µm"),
            "{said}"
        );
    }
}
