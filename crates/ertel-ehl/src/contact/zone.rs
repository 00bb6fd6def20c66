//! The Hertz zone: where the dry contact carries pressure.
//!
//! Theory: Contact area.

use std::sync::Arc;

use super::roller::RollerZone;
use super::{Turn, pressure_profile};

/// A circle, an ellipse, a strip across the motion, or the zone of a roller; in half-widths a, the semi-axis along the first principal direction.
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
    /// Where a place lies in the plane in which meshes are made: there the zone is the unit circle and x lies along the motion, or a
    /// roller is shortened along its axis. Lines along the motion stay so.
    #[inline(always)]
    pub fn unit(&self, at: [f64; 2]) -> [f64; 2] {
        match &self.roller {
            None if self.turn.is_none() => self.circle(at),
            None => self.heading().to_motion(self.circle(at)),
            Some(roller) => [at[0], roller.unit(at[1])],
        }
    }

    /// Whether oil that enters a contact area by an edge across the longer axis passes the zone: that from the corner between this edge and the inlet misses
    /// the unit circle. Distances from the centre, in semi-axes.
    ///
    /// ```text
    ///   side u_x − inlet u_y ≥ |u|        u: the motion in the plane in which the zone is the unit circle
    /// ```
    pub fn is_passed_from(&self, side: f64, inlet: f64) -> bool {
        let [along, across] = self.circle([1.0, 0.0]).map(f64::abs);
        side * along - inlet * across >= along.hypot(across)
    }

    /// A place in semi-axes of an ellipse.
    #[inline(always)]
    fn circle(&self, at: [f64; 2]) -> [f64; 2] {
        let [x, y] = self.turn.to_axes(at);
        [x, y / self.axis_ratio]
    }

    /// From the image of the motion to that of the axes, in the plane where the zone is the unit circle.
    fn heading(&self) -> Turn {
        let [x, y] = self.circle([1.0, 0.0]);
        Turn::by(y.atan2(x))
    }

    /// The inverse: the place of a point of that plane.
    #[inline(always)]
    pub fn place(&self, at: [f64; 2]) -> [f64; 2] {
        if let Some(roller) = &self.roller {
            return [at[0], roller.place(at[1])];
        }
        let [x, y] = match self.turn.is_none() {
            true => at,
            false => self.heading().to_axes(at),
        };
        self.turn.to_motion([x, y * self.axis_ratio])
    }

    /// Direction in which the outside lies from an edge whose outward normal is n where meshes are made.
    pub fn outward(&self, normal: [f64; 2]) -> [f64; 2] {
        if self.turn.is_none() {
            return normal;
        }
        // The gradient of n·unit(r), and unit is linear.
        let along = |e: [f64; 2]| {
            let [x, y] = self.unit(e);
            normal[0] * x + normal[1] * y
        };
        let gradient = [along([1.0, 0.0]), along([0.0, 1.0])];
        let norm = gradient[0].hypot(gradient[1]);
        gradient.map(|g| g / norm)
    }

    /// Aspect ratio, second over first principal direction, of a cell at a place that is square in the plane of the mesh.
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
        let [x, y] = self.circle(at);
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
        self.peak(at) * pressure_profile(self.radius(at))
    }

    /// Its largest value: at the centre, of rollers in the slice of a place.
    #[inline(always)]
    pub fn peak(&self, at: [f64; 2]) -> f64 {
        self.roller
            .as_ref()
            .map_or(1.0, |roller| roller.peak(at[1]))
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
        let [x, y] = self.circle([1.0, 0.0]);
        1.0 / x.hypot(y)
    }

    /// How much a diffusion that is in proportion to the length of a cell along the motion is reduced where cells are shorter than
    /// that, min(1, (s/s_m)²) along each principal direction, with the semi-axis s and the half-width s_m along the motion: the
    /// components xx, xy, yy of a tensor along and across the motion. `None`: not at all, as in circles and most of a roller.
    pub fn diffusion_tensor(&self, at: [f64; 2]) -> Option<[f64; 3]> {
        let along = self.stretch_along_motion();
        let share = |semi_axis: f64| (semi_axis / along).powi(2).min(1.0);
        let [d1, d2] = [share(1.0), share(self.stretch(at))];
        // Except for rounding.
        if d1.min(d2) > 1.0 - 1e-9 {
            return None;
        }
        let [c, s] = self.turn.to_axes([1.0, 0.0]);
        Some([
            d1 * c * c + d2 * s * s,
            (d2 - d1) * s * c,
            d1 * s * s + d2 * c * c,
        ])
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

    /// Nothing is reduced in circles and where the motion is along the shorter axis; along the longer axis the shorter one has the
    /// square of the ratio; of a turned ellipse each principal direction has its share.
    #[test]
    fn diffusion_across_slender_zones() {
        let zone = |axis_ratio, degrees: f64| HertzZone {
            axis_ratio,
            turn: Turn::by(degrees.to_radians()),
            roller: None,
        };
        for (ratio, degrees) in [(1.0, 0.0), (1.0, 30.0), (8.0, 0.0)] {
            assert_eq!(zone(ratio, degrees).diffusion_tensor([0.0; 2]), None);
        }
        let [xx, xy, yy] = zone(0.1, 0.0).diffusion_tensor([0.0; 2]).unwrap();
        assert_eq!([xx, xy], [1.0, 0.0]);
        assert_relative_eq!(yy, 0.01, max_relative = 1e-14);
        // At 30 degrees the half-width along the motion is 1/√(¾ + ¼/k²), k = 0.1: 1/√25.75.
        let turned = zone(0.1, 30.0);
        let [xx, xy, yy] = turned.diffusion_tensor([0.0; 2]).unwrap();
        for (axis, share) in [([1.0, 0.0], 1.0), ([0.0, 1.0], 0.01 * 25.75)] {
            let [x, y] = turned.turn.to_motion(axis);
            assert_relative_eq!(xx * x + xy * y, share * x, max_relative = 1e-13);
            assert_relative_eq!(xy * x + yy * y, share * y, max_relative = 1e-13);
        }
    }

    /// Along a roller cells are long but at steep ends of the contact, here of a load that rises over 0.4 half-widths: 0.3 of that.
    #[test]
    fn diffusion_at_the_ends_of_a_roller() {
        let load = |y: f64| ((49.7 - y.abs()) / 0.4).clamp(0.0, 1.0);
        let roller = RollerZone::new(50.0, load, &[]);
        let stretch = roller.stretch(49.7);
        assert_relative_eq!(stretch, 0.12, max_relative = 0.2);
        let zone = HertzZone {
            axis_ratio: 1.0,
            turn: Turn::NONE,
            roller: Some(Arc::new(roller)),
        };
        assert_eq!(zone.diffusion_tensor([0.3, 0.0]), None);
        let tensor = zone.diffusion_tensor([0.3, 49.7]);
        assert_eq!(tensor, Some([1.0, 0.0, stretch * stretch]));
    }

    /// Unit circle and zone map onto each other, lines along the motion onto such lines; the widest points of an ellipse turned by 30 degrees, by a scan of its rim.
    #[test]
    fn the_zone_is_a_stretched_unit_circle() {
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
            let [c, s] = zone.unit(place);
            assert_relative_eq!(c, angle.cos(), epsilon = 1e-14);
            assert_relative_eq!(s, angle.sin(), epsilon = 1e-14);
            widest = [0, 1].map(|k: usize| widest[k].max(place[k]));
        }
        let extents = zone.half_extents();
        assert_relative_eq!(extents[0], widest[0], max_relative = 1e-6);
        assert_relative_eq!(extents[1], widest[1], max_relative = 1e-6);
        let [x, y] = zone.unit([3.0, 0.0]);
        assert!(x > 0.0 && y.abs() < 1e-14, "{x} {y}");
        // The first axis, of the length 1, lies at −30 degrees to the motion, the second at 60.
        let (c, s) = (0.75_f64.sqrt(), 0.5);
        assert_relative_eq!(zone.radius([c, -s]), 1.0, max_relative = 1e-14);
        assert_relative_eq!(zone.radius([2.5 * s, 2.5 * c]), 1.0, max_relative = 1e-14);
        // Along an edge of the mesh nothing changes across it.
        for normal in [[1.0, 0.0], [0.0, -1.0]] {
            let [nx, ny] = zone.outward(normal);
            let edge = zone.place([-normal[1], normal[0]]);
            assert_relative_eq!(nx * edge[0] + ny * edge[1], 0.0, epsilon = 1e-14);
            let beyond = zone.place(normal);
            assert!(nx * beyond[0] + ny * beyond[1] > 0.0);
            assert_relative_eq!(nx.hypot(ny), 1.0, max_relative = 1e-14);
        }
    }
}
