//! Speeds of rollers.

use super::Speeds;

/// Motion of a roller that rolls on both rings.
///
/// ```text
///   ω_m = [ω_i (1 − γ) + ω_o (1 + γ)]/2
///   ω_R = (ω_i − ω_o)(1 − γ²)/(2γ),   u = |ω_i − ω_o| d_m (1 − γ²)/4
/// ```
/// Source: Harris and Kotzalas 2007, chapter 10.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RollerMotion {
    /// Speed of the cage ω_m, rad/s.
    pub cage: f64,
    /// Speed of the roller about its own axis, seen from the cage, rad/s; positive where it turns against the inner ring.
    pub element: f64,
    /// Entrainment speed at both raceways, m/s; of cones in the middle of the contact.
    pub entrainment_speed: f64,
}

impl RollerMotion {
    /// Of γ = D/d_m and the pitch diameter in m.
    pub fn new(gamma: f64, pitch_diameter: f64, speeds: Speeds) -> RollerMotion {
        let relative = speeds.relative();
        let factor = 1.0 - gamma * gamma;
        RollerMotion {
            cage: 0.5 * (speeds.inner * (1.0 - gamma) + speeds.outer * (1.0 + gamma)),
            element: relative * factor / (2.0 * gamma),
            entrainment_speed: relative.abs() * pitch_diameter * factor / 4.0,
        }
    }

    /// Of a tapered roller of the half angle ν between raceways of the angles α_i and α_o (rad), all with one apex, at the distance s (m)
    /// from it: it rolls without sliding all along, and spins with the raceways.
    ///
    /// ```text
    ///   (ω_i − ω_m) sin α_i = (ω_m − ω_o) sin α_o = ω_R sin ν,   u = |ω_R| s sin ν
    /// ```
    pub fn of_cones(
        half_angle: f64,
        angles: [f64; 2],
        apex_distance: f64,
        speeds: Speeds,
    ) -> RollerMotion {
        let [inner, outer] = angles.map(f64::sin);
        let element = speeds.relative() * inner * outer / ((inner + outer) * half_angle.sin());
        RollerMotion {
            cage: (speeds.inner * inner + speeds.outer * outer) / (inner + outer),
            element,
            entrainment_speed: element.abs() * apex_distance * half_angle.sin(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// By hand, γ = 0.2, d_m = 50 mm, 100 and −20 rad/s: cage (80 − 24)/2 = 28, roller 120 · 0.96/0.4 = 288 rad/s, 120 · 0.05 · 0.24 =
    /// 1.44 m/s, which is 288 rad/s on 5 mm.
    #[test]
    fn by_hand() {
        let speeds = Speeds {
            inner: 100.0,
            outer: -20.0,
        };
        let motion = RollerMotion::new(0.2, 0.05, speeds);
        assert_relative_eq!(motion.cage, 28.0, max_relative = 1e-12);
        assert_relative_eq!(motion.element, 288.0, max_relative = 1e-12);
        assert_relative_eq!(motion.entrainment_speed, 1.44, max_relative = 1e-12);
        assert_relative_eq!(288.0 * 0.005, 1.44, max_relative = 1e-12);
    }

    /// Angular velocities by vectors in the plane of r and z: seen from the cage, ring and roller differ by a rotation about the generator
    /// that they share.
    #[test]
    fn cones_roll_about_their_generators() {
        use nalgebra::Vector2;
        let speeds = Speeds {
            inner: 100.0,
            outer: -20.0,
        };
        let (nu, angles) = (0.03_f64, [0.2, 0.26]);
        let motion = RollerMotion::of_cones(nu, angles, 0.1, speeds);
        // (r, z), the apex at the origin and the rollers towards −z
        let along = |a: f64| Vector2::new(a.sin(), -a.cos());
        let roller = motion.element * along(0.23);
        for (speed, angle) in [(speeds.inner, 0.2), (speeds.outer, 0.26)] {
            let ring = Vector2::new(0.0, speed - motion.cage);
            let between = ring - roller;
            let generator = along(angle);
            let across = between[0] * generator[1] - between[1] * generator[0];
            assert_relative_eq!(across, 0.0, epsilon = 1e-9);
            // about the outward normal (cos α, sin α), both turn alike
            let normal = Vector2::new(angle.cos(), angle.sin());
            let spin = motion.element * nu.sin();
            assert_relative_eq!(ring.dot(&normal).abs(), spin, max_relative = 1e-9);
            assert_relative_eq!(roller.dot(&normal).abs(), spin, max_relative = 1e-9);
        }
        let surface = (speeds.inner - motion.cage) * 0.1 * 0.2_f64.sin();
        assert_relative_eq!(motion.entrainment_speed, surface, max_relative = 1e-12);
    }
}
