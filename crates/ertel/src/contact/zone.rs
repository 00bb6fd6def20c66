//! The Hertz zone: where the dry contact carries pressure.

use std::sync::Arc;

use super::roller::RollerZone;
use super::{Turn, hertz};

/// A circle, an ellipse, a strip across the motion, or what a roller has; in half-widths a, the semi-axis along the first principal direction.
#[derive(Clone, Debug, PartialEq)]
pub struct HertzZone {
    /// Semi-axis along the second principal direction over that along the first; 1 for circles, strips and rollers.
    pub axis_ratio: f64,
    /// From the motion to the principal directions.
    pub turn: Turn,
    /// The zone of a roller; it is not turned against the motion.
    pub roller: Option<Arc<RollerZone>>,
}

impl HertzZone {
    /// Where a place lies in the plane in which meshes are made: there the zone is the unit circle and its axes the coordinates, or a
    /// roller is shortened along its axis.
    #[inline(always)]
    pub fn unit(&self, at: [f64; 2]) -> [f64; 2] {
        let [x, y] = self.turn.to_axes(at);
        match &self.roller {
            None => [x, y / self.axis_ratio],
            Some(roller) => [x, roller.unit(y)],
        }
    }

    /// The inverse: the place of a point of that plane.
    #[inline(always)]
    pub fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let y = match &self.roller {
            None => y * self.axis_ratio,
            Some(roller) => roller.place(y),
        };
        self.turn.to_motion([x, y])
    }

    /// How much longer along the second principal direction than along the first a cell is at a place that is not so where it was made.
    #[inline(always)]
    pub fn stretch(&self, at: [f64; 2]) -> f64 {
        match &self.roller {
            None => self.axis_ratio,
            Some(roller) => roller.stretch(at[1]),
        }
    }

    /// Distance from the centre, of rollers from the axis, 1 on the rim.
    #[inline(always)]
    pub fn radius(&self, at: [f64; 2]) -> f64 {
        if let Some(roller) = &self.roller {
            return roller.radius(at);
        }
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
        self.peak(at) * hertz::pressure_profile(self.radius(at))
    }

    /// Its largest value: at the centre, of rollers in the slice of a place.
    #[inline(always)]
    pub fn peak(&self, at: [f64; 2]) -> f64 {
        self.roller
            .as_ref()
            .map_or(1.0, |roller| roller.peak(at[1]))
    }

    /// The place whose distance is `share` of that of another, on the way from there to the centre or the axis.
    pub fn drawn_in(&self, [x, y]: [f64; 2], share: f64) -> [f64; 2] {
        match &self.roller {
            None => [share * x, share * y],
            Some(_) => [share * x, y],
        }
    }

    /// Half the length of the zone on the centreline y = 0.
    pub fn centreline_half_width(&self) -> f64 {
        match &self.roller {
            None => self.stretch_along_motion(),
            Some(roller) => roller.peak(0.0),
        }
    }

    /// How long a cell is along the motion that would be of the length 1 around the unit circle.
    pub fn stretch_along_motion(&self) -> f64 {
        let [x, y] = self.unit([1.0, 0.0]);
        1.0 / x.hypot(y)
    }

    /// Half the extent of the zone along and across the motion.
    pub fn half_extents(&self) -> [f64; 2] {
        if let Some(roller) = &self.roller {
            return roller.half_extents();
        }
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
            roller: None,
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
