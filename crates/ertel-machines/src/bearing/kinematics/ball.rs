//! Speeds of a ball between two grooves, with spin.

use crate::bearing::geometry::Ring;

use super::Speeds;

/// On which raceway a ball rolls without spin.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum RacewayControl {
    /// The ball rolls on the outer raceway and spins on the inner one: usual at speed.
    #[default]
    Outer,
    /// The other way round: usual of slow and dry bearings.
    Inner,
}

/// Motion of a ball under the contact angles α_i and α_o, which differ at speed.
///
/// With γ' = D/d_m and the axis of the ball inclined at β to that of the bearing, rolling on both raceways gives, seen from the cage,
/// ```text
///   (ω_i − ω_m)(1 − γ' cos α_i) = γ' ω_R cos(α_i − β)       (ω_m − ω_o)(1 + γ' cos α_o) = γ' ω_R cos(α_o − β)
///   outer control: tan(α_o − β) =  γ' sin α_o/(1 + γ' cos α_o)
///   inner control: tan(α_i − β) = −γ' sin α_i/(1 − γ' cos α_i)
/// ```
/// The ball's velocity is ω_R (sin β, −cos β) in (r, z). The first control is tan β = sin α_o/(cos α_o + γ').
/// Source: Jones, J. Basic Eng. 81 (1959) 1-12; Harris and Kotzalas 2007, Advanced Concepts, chapter 2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BallMotion {
    /// Speed of the cage ω_m, rad/s.
    pub cage: f64,
    /// Speed of the ball about its own axis ω_R, seen from the cage, rad/s.
    pub element: f64,
    /// Attitude β of the ball's axis, rad.
    pub attitude: f64,
}

/// k_i and k_o, with ω_m = (ω_i k_o + ω_o k_i)/(k_i + k_o) and γ' ω_R = (ω_i − ω_o)/(k_i + k_o).
fn ratios(ratio: f64, [inner, outer]: [f64; 2], attitude: f64) -> [f64; 2] {
    [
        (inner - attitude).cos() / (1.0 - ratio * inner.cos()),
        (outer - attitude).cos() / (1.0 + ratio * outer.cos()),
    ]
}

/// Difference of equal spins, relative: some units in the last place.
const ROUNDING: f64 = 1e-12;

impl BallMotion {
    /// Of γ' = D/d_m and the contact angles (rad).
    pub fn new(
        ratio: f64,
        angles: [f64; 2],
        speeds: Speeds,
        control: RacewayControl,
    ) -> BallMotion {
        let [inner, outer] = angles;
        let attitude = match control {
            RacewayControl::Outer => outer - (ratio * outer.sin()).atan2(1.0 + ratio * outer.cos()),
            RacewayControl::Inner => inner + (ratio * inner.sin()).atan2(1.0 - ratio * inner.cos()),
        };
        let [k_i, k_o] = ratios(ratio, angles, attitude);
        BallMotion {
            cage: (speeds.inner * k_o + speeds.outer * k_i) / (k_i + k_o),
            element: speeds.relative() / (ratio * (k_i + k_o)),
            attitude,
        }
    }

    /// Its derivatives by α_i and α_o under outer control.
    pub(crate) fn slopes_under_outer_control(
        &self,
        ratio: f64,
        angles: [f64; 2],
        speeds: Speeds,
    ) -> [BallMotion; 2] {
        let [inner, outer] = angles;
        let square = ratio * ratio;
        let c = ratio * outer.cos();
        let attitude = [0.0, 1.0 - (c + square) / (1.0 + 2.0 * c + square)];
        let k = ratios(ratio, angles, self.attitude);
        let sum = k[0] + k[1];
        let factor = [1.0 - ratio * inner.cos(), 1.0 + ratio * outer.cos()];
        let change_of_factor = [ratio * inner.sin(), -ratio * outer.sin()];
        [0, 1].map(|by| {
            let change = [0, 1].map(|of| {
                let own = if of == by { 1.0 } else { 0.0 };
                let tilt = angles[of] - self.attitude;
                (-tilt.sin() * (own - attitude[by]) - own * k[of] * change_of_factor[of])
                    / factor[of]
            });
            let sum_change = change[0] + change[1];
            let cage = speeds.inner * change[1] + speeds.outer * change[0];
            BallMotion {
                cage: (cage - self.cage * sum_change) / sum,
                element: -self.element * sum_change / sum,
                attitude: attitude[by],
            }
        })
    }

    /// Entrainment speed at a raceway under the contact angle (rad), m/s: ball and raceway move at one speed there; pitch diameter in m.
    ///
    /// u = |ω − ω_m| d_m (1 ∓ γ' cos α)/2
    pub fn entrainment_speed(
        &self,
        ring: Ring,
        ratio: f64,
        pitch_diameter: f64,
        angle: f64,
        speeds: Speeds,
    ) -> f64 {
        let speed = match ring {
            Ring::Inner => speeds.inner,
            Ring::Outer => speeds.outer,
        };
        let radius = 0.5 * pitch_diameter * (1.0 + ring.sign() * ratio * angle.cos());
        (speed - self.cage).abs() * radius
    }

    /// Spin of ring and ball about the normal that points from the ring to the ball, rad/s, under the contact angle (rad).
    ///
    /// ```text
    ///   inner:  (ω_i − ω_m) sin α_i,   −ω_R sin(α_i − β)
    ///   outer:  (ω_m − ω_o) sin α_o,    ω_R sin(α_o − β)
    /// ```
    pub fn spin(&self, ring: Ring, angle: f64, speeds: Speeds) -> [f64; 2] {
        let of_ball = self.element * (angle - self.attitude).sin();
        let [of_ring, of_ball] = match ring {
            Ring::Inner => [(speeds.inner - self.cage) * angle.sin(), -of_ball],
            Ring::Outer => [(self.cage - speeds.outer) * angle.sin(), of_ball],
        };
        // Both are equal on the raceway that controls the ball.
        match (of_ring - of_ball).abs() <= ROUNDING * of_ring.abs() {
            true => [of_ring; 2],
            false => [of_ring, of_ball],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::{assert_abs_diff_eq, assert_relative_eq};

    const SPEEDS: Speeds = Speeds {
        inner: 1000.0,
        outer: -200.0,
    };

    /// One angle: cage and ball of Harris and Kotzalas 2007, chapter 10, ω_m = [ω_i (1 − γ) + ω_o (1 + γ)]/2, and at α = 0 also
    /// ω_R = (ω_i − ω_o)(1 − γ²)/(2γ), without spin.
    #[test]
    fn simple_formulas() {
        for control in [RacewayControl::Outer, RacewayControl::Inner] {
            let motion = BallMotion::new(0.2, [0.5, 0.5], SPEEDS, control);
            let gamma = 0.2 * 0.5_f64.cos();
            let cage = 0.5 * (1000.0 * (1.0 - gamma) - 200.0 * (1.0 + gamma));
            assert_relative_eq!(motion.cage, cage, max_relative = 1e-12);
            let flat = BallMotion::new(0.2, [0.0; 2], SPEEDS, control);
            assert_relative_eq!(flat.element, 1200.0 * 0.96 / 0.4, max_relative = 1e-12);
            assert_eq!(flat.spin(Ring::Inner, 0.0, SPEEDS), [0.0, 0.0]);
        }
    }

    /// Velocities by vector products. Ball centre at d_m/2 on r, contacts at ∓(D/2)(cos α, sin α); relative velocity at both contacts zero,
    /// and the relative angular velocity has no part along the normal of the raceway that controls.
    #[test]
    fn rolling_by_vectors() {
        use nalgebra::Vector3;
        let (pitch, diameter, angles) = (0.07, 0.0127, [0.75, 0.6]);
        for control in [RacewayControl::Outer, RacewayControl::Inner] {
            let motion = BallMotion::new(diameter / pitch, angles, SPEEDS, control);
            // (r, t, z)
            let cage = Vector3::new(0.0, 0.0, motion.cage);
            let (s, c) = motion.attitude.sin_cos();
            let ball = cage + motion.element * Vector3::new(s, 0.0, -c);
            let centre = Vector3::new(0.5 * pitch, 0.0, 0.0);
            for ring in Ring::BOTH {
                let angle = angles[ring.index()];
                let out = ring.sign() * Vector3::new(angle.cos(), 0.0, angle.sin());
                let arm = 0.5 * diameter * out;
                let of_ball = cage.cross(&centre) + ball.cross(&arm);
                let speed = [SPEEDS.inner, SPEEDS.outer][ring.index()];
                let of_ring = Vector3::new(0.0, 0.0, speed);
                let slip = of_ball - of_ring.cross(&(centre + arm));
                assert_abs_diff_eq!(slip.norm(), 0.0, epsilon = 1e-10);
                let surface = (of_ring - cage).cross(&(centre + arm)).norm();
                let entrainment =
                    motion.entrainment_speed(ring, diameter / pitch, pitch, angle, SPEEDS);
                assert_relative_eq!(entrainment, surface, max_relative = 1e-12);
                // from the ring to the ball
                let normal = -out;
                let spin = motion.spin(ring, angle, SPEEDS);
                // Spins are counted from the cage.
                assert_relative_eq!(spin[0], (of_ring - cage).dot(&normal), max_relative = 1e-12);
                assert_relative_eq!(spin[1], (ball - cage).dot(&normal), max_relative = 1e-12);
                let controls = (control == RacewayControl::Outer) == (ring == Ring::Outer);
                assert_eq!(spin[0] == spin[1], controls, "{ring:?} {spin:?}");
            }
        }
    }

    /// tan β = sin α/(cos α + γ'), by hand for α = 40°, γ' = 0.18: 0.642788/0.946044 = 0.679448.
    #[test]
    fn attitude_by_hand() {
        let angle = 40_f64.to_radians();
        let motion = BallMotion::new(0.18, [angle; 2], SPEEDS, RacewayControl::Outer);
        assert_relative_eq!(motion.attitude.tan(), 0.679_448, max_relative = 1e-5);
    }

    #[test]
    fn slopes_are_differences() {
        let (ratio, angles, step) = (0.2, [0.8, 0.65], 1e-6);
        let of = |angles| BallMotion::new(ratio, angles, SPEEDS, RacewayControl::Outer);
        let slopes = of(angles).slopes_under_outer_control(ratio, angles, SPEEDS);
        for by in [0, 1] {
            let shifted = |sign: f64| {
                let mut moved = angles;
                moved[by] += sign * step;
                of(moved)
            };
            let (low, high) = (shifted(-1.0), shifted(1.0));
            let difference = |a: f64, b: f64| (b - a) / (2.0 * step);
            let [cage, element, attitude] = [
                difference(low.cage, high.cage),
                difference(low.element, high.element),
                difference(low.attitude, high.attitude),
            ];
            assert_abs_diff_eq!(slopes[by].cage, cage, epsilon = 1e-4);
            assert_abs_diff_eq!(slopes[by].element, element, epsilon = 1e-4);
            assert_abs_diff_eq!(slopes[by].attitude, attitude, epsilon = 1e-8);
        }
    }
}
