//! Sliding losses of a mesh.

use std::f64::consts::PI;

use super::geometry::{GearError, GearPair};
use super::path::{LoadSharing, Operation, PathPoint, Sharing};

/// Parts of each of the stretches between A, B, C, D and E, and slices across the face of helical teeth, in which losses are summed.
const PARTS: usize = 80;
const SLICES: usize = 32;

/// Sliding losses of a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshLoss {
    /// Loss factor H_V: the power lost over the power at the pinion, at the friction 1.
    pub loss_factor: f64,
    /// Mean power lost, W.
    pub power: f64,
    /// Mean coefficient of friction: power/(input power H_V).
    pub mean_friction: f64,
}

impl GearPair {
    /// Loss factor after Ohlendorf, of even sharing and 1 ≤ ε_α ≤ 2 with the pitch point in single contact.
    ///
    /// H_V = π (u + 1)/(z_1 u cos β_b) (1 − ε_α + ε_1² + ε_2²),  u = z_2/z_1,  ε_1 = CE/p_bt,  ε_2 = AC/p_bt
    ///
    /// with z_2 negative of internal wheels. Source: Ohlendorf 1958; Niemann and Winter, Maschinenelemente II.
    pub fn ohlendorf_loss_factor(&self) -> f64 {
        let ratio = self.teeth[1] / self.teeth[0];
        let [one, two] = [self.points.e, -self.points.a].map(|length| length / self.base_pitch);
        PI * (ratio + 1.0) / (self.teeth[0] * ratio * self.base_helix_angle.cos())
            * (1.0 - self.contact_ratio + one * one + two * two)
    }

    /// Losses by the sum over the plane of action, with a coefficient of friction for each contact.
    ///
    /// P = (1/p_bt) ∫_A^E ∫_b μ w |u_2 − u_1| dy/cos β_b ds
    ///
    /// as each pair passes the path in AE/v_tb and one pair enters in p_bt/v_tb. With μ = 1, over T_1 ω_1: H_V (Wimmer 2006).
    ///
    /// # Errors
    ///
    /// As [`GearPair::path`].
    pub fn loss(
        &self,
        operation: &Operation,
        sharing: LoadSharing,
        friction: impl Fn(&PathPoint) -> f64,
    ) -> Result<MeshLoss, GearError> {
        operation.check()?;
        let sharing = Sharing::new(self, operation, sharing)?;
        let points = self.points;
        let mut ends = vec![points.a, points.b, 0.0, points.d, points.e];
        ends.retain(|s| *s >= points.a && *s <= points.e);
        ends.sort_by(f64::total_cmp);
        let slices = if self.base_helix_angle == 0.0 {
            1
        } else {
            SLICES
        };
        let across = self.face_width / slices as f64 / self.base_helix_angle.cos();
        let (mut at_friction_1, mut power) = (0.0, 0.0);
        for stretch in ends.windows(2) {
            let step = (stretch[1] - stretch[0]) / PARTS as f64;
            for part in 0..PARTS {
                let s = stretch[0] + (part as f64 + 0.5) * step;
                for slice in 0..slices {
                    let y = ((slice as f64 + 0.5) / slices as f64 - 0.5) * self.face_width;
                    let point = self.contact(operation, &sharing, s, y, None);
                    let lost = point.load_per_length * point.sliding_speed.abs() * across * step
                        / self.base_pitch;
                    at_friction_1 += lost;
                    power += friction(&point) * lost;
                }
            }
        }
        Ok(MeshLoss {
            loss_factor: at_friction_1 / operation.power(),
            power,
            mean_friction: power / at_friction_1,
        })
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::gear::test_data::{c14, h501, h701, steel_operation};

    /// Reports of GEARpie at even sharing; its sums over 1000 × some places are good to 0.3 %. C14 at 200 N·m, 1500 1/min and μ = 0.0483: 295.17 W.
    #[test]
    fn published_reports() {
        for (dimensions, ohlendorf, wimmer) in [
            (c14(), 0.1950, 0.1945),
            (h501(), 0.1639, 0.1869),
            (h701(), 0.1225, 0.1404),
        ] {
            let pair = GearPair::new(&dimensions).expect("a pair");
            assert!((pair.ohlendorf_loss_factor() - ohlendorf).abs() < 6e-5);
            let operation = steel_operation(200.0, 1500.0);
            let loss = pair
                .loss(&operation, LoadSharing::Uniform, |_| 0.0483)
                .expect("a loss");
            assert_relative_eq!(loss.loss_factor, wimmer, max_relative = 4e-3);
            assert_relative_eq!(loss.mean_friction, 0.0483, max_relative = 1e-12);
            if ohlendorf == 0.1950 {
                assert_relative_eq!(loss.power, 295.17, max_relative = 4e-3);
                // Straight teeth that share evenly are what the closed form is for.
                let closed = pair.ohlendorf_loss_factor();
                assert_relative_eq!(loss.loss_factor, closed, max_relative = 1e-10);
            }
        }
    }

    /// Friction that differs along the path: μ = 1 on the pinion's addendum only leaves one part. Of C14, by hand with shares 1/2, 1, 1/2:
    /// ∫ from C to E of X s ds = s_D²/2 + (s_E² − s_D²)/4, times ω_1 (1 + 1/u) F_bt/p_bt over the power, which is F_bt v_tb.
    #[test]
    fn friction_of_a_part() {
        let pair = GearPair::new(&c14()).expect("a pair");
        let operation = steel_operation(200.0, 1500.0);
        let loss = pair
            .loss(&operation, LoadSharing::Uniform, |point| {
                f64::from(u8::from(point.position > 0.0))
            })
            .expect("a loss");
        let (d, e) = (pair.points.d, pair.points.e);
        let part = (0.5 * d * d + 0.25 * (e * e - d * d)) * (1.0 + 16.0 / 24.0)
            / (pair.base_pitch * pair.base_radii[0]);
        assert_relative_eq!(loss.power / operation.power(), part, max_relative = 1e-9);
    }
}
