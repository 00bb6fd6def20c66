//! Target cell sizes from geometric zones.

/// A region of the body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Zone {
    /// points of the plane z = `center[2]` within `radius` of `center`: fine on the surface, growing at once below
    Disc {
        /// centre
        center: [f64; 3],
        /// radius
        radius: f64,
    },
    /// axis-parallel box (flat where `min` and `max` agree)
    Box {
        /// lowest corner
        min: [f64; 3],
        /// highest corner
        max: [f64; 3],
    },
    /// points of the plane z = `center[2]` within `half_width` of the circle around `center`, of which only the
    /// arc x >= `x_min` counts: a flat ring, or a crescent
    Arc {
        /// centre
        center: [f64; 3],
        /// radius of the circle
        radius: f64,
        /// half the width of the strip along it
        half_width: f64,
        /// where the arc begins (`f64::NEG_INFINITY`: the whole ring)
        x_min: f64,
    },
}

impl Zone {
    /// Distance from a point to the zone, 0 inside; infinite for an empty arc.
    #[must_use]
    pub fn distance(&self, point: [f64; 3]) -> f64 {
        match *self {
            Self::Disc { center, radius } => {
                let rho = (point[0] - center[0]).hypot(point[1] - center[1]);
                (rho - radius).max(0.0).hypot(point[2] - center[2])
            }
            Self::Box { min, max } => {
                norm([0, 1, 2].map(|k: usize| (min[k] - point[k]).max(point[k] - max[k]).max(0.0)))
            }
            Self::Arc {
                center,
                radius,
                half_width,
                x_min,
            } => {
                let d = [0, 1, 2].map(|k: usize| point[k] - center[k]);
                let rho = d[0].hypot(d[1]);
                let x_start = x_min - center[0];
                if x_start > radius {
                    return f64::INFINITY;
                }
                // on the axis every point of the circle is as near as any other
                let nearest_x = if rho > 0.0 {
                    d[0] * radius / rho
                } else {
                    radius
                };
                let to_arc = if nearest_x >= x_start {
                    (rho - radius).abs()
                } else {
                    let y_start = (radius * radius - x_start * x_start).max(0.0).sqrt();
                    (d[0] - x_start).hypot(d[1].abs() - y_start)
                };
                (to_arc - half_width).max(0.0).hypot(d[2])
            }
        }
    }
}

fn norm(d: [f64; 3]) -> f64 {
    (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt()
}

/// A zone with its cell size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SizeZone {
    /// where
    pub zone: Zone,
    /// longest edge allowed inside
    pub size: f64,
}

/// Size field `min over zones of (size + growth · distance)`.
///
/// Sizes bound the longest edge; the mean edge of a mesh is about 0.65 of it. A growth up to 1 keeps the deflection
/// under a Hertz pressure as accurate as its surface mesh; larger ones save little (see the decision record).
#[derive(Debug, Clone, PartialEq)]
pub struct SizeField {
    /// zones with their sizes; none: infinite size everywhere
    pub zones: Vec<SizeZone>,
    /// growth of the size per distance from a zone
    pub growth: f64,
}

impl SizeField {
    /// Longest edge allowed at a point.
    #[must_use]
    pub fn size(&self, point: [f64; 3]) -> f64 {
        self.zones
            .iter()
            .map(|z| z.size + self.growth * z.zone.distance(point))
            .fold(f64::INFINITY, f64::min)
    }
}
