//! The Hertz zone: where the dry contact carries pressure.

use super::{Turn, hertz};

/// A circle, an ellipse, or a strip across the motion; in half-widths a, the semi-axis along the first principal direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HertzZone {
    /// Semi-axis along the second principal direction over that along the first; 1 for circles and strips.
    pub axis_ratio: f64,
    /// From the motion to the principal directions.
    pub turn: Turn,
}

impl HertzZone {
    /// Where a place would lie if the zone were the unit circle and its axes the coordinates.
    #[inline(always)]
    pub fn unit(&self, at: [f64; 2]) -> [f64; 2] {
        let [x, y] = self.turn.to_axes(at);
        [x, y / self.axis_ratio]
    }

    /// The inverse: the place of a point of the unit circle's plane.
    #[inline(always)]
    pub fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        self.turn.to_motion([x, y * self.axis_ratio])
    }

    /// Distance from the centre, 1 on the rim.
    #[inline(always)]
    pub fn radius(&self, at: [f64; 2]) -> f64 {
        let [x, y] = self.unit(at);
        x.hypot(y)
    }

    /// Whether a place lies inside.
    #[inline(always)]
    pub fn contains(&self, at: [f64; 2]) -> bool {
        self.radius(at) < 1.0
    }

    /// Pressure of the dry contact, in p_h.
    #[inline(always)]
    pub fn pressure(&self, at: [f64; 2]) -> f64 {
        hertz::pressure_profile(self.radius(at))
    }

    /// How long a cell is along the motion that would be of the length 1 around the unit circle.
    pub fn stretch_along_motion(&self) -> f64 {
        let [x, y] = self.unit([1.0, 0.0]);
        1.0 / x.hypot(y)
    }

    /// Half the extent of the zone along and across the motion.
    pub fn half_extents(&self) -> [f64; 2] {
        let [c, s] = self.turn.to_axes([1.0, 0.0]);
        let k = self.axis_ratio;
        [c.hypot(k * s), s.hypot(k * c)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Unit circle and zone map onto each other; the widest points of an ellipse turned by 30 degrees, by a scan of its rim.
    #[test]
    fn the_zone_is_the_unit_circle_drawn_out() {
        let zone = HertzZone {
            axis_ratio: 2.5,
            turn: Turn::by(std::f64::consts::FRAC_PI_6),
        };
        let mut widest = [0.0_f64; 2];
        for i in 0..3600 {
            let angle = f64::from(i) * std::f64::consts::TAU / 3600.0;
            let place = zone.place([angle.cos(), angle.sin()]);
            assert_relative_eq!(zone.radius(place), 1.0, max_relative = 1e-14);
            widest = [0, 1].map(|k: usize| widest[k].max(place[k]));
        }
        let extents = zone.half_extents();
        assert_relative_eq!(extents[0], widest[0], max_relative = 1e-6);
        assert_relative_eq!(extents[1], widest[1], max_relative = 1e-6);
        // The end of the second axis lies at 60 degrees to the motion.
        let end = zone.place([0.0, 1.0]);
        assert_relative_eq!(
            end[1].atan2(end[0]).to_degrees(),
            60.0,
            max_relative = 1e-12
        );
    }
}
