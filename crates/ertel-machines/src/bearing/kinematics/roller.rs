//! Speeds of a cylindrical roller.

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
    /// Entrainment speed at both raceways, m/s.
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
}
