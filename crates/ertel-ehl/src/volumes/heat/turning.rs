//! Bodies that spin: their surface drawn out into one that moves at the same velocity everywhere.
//!
//! ```text
//!   v = v_0 + ω e_z × r = ω e_z × (r − c),   c = ρ n̂,   ρ = |v_0|/ω,   n̂ = e_z × v_0/|v_0|        c: about which the body turns
//!   r = c + (n − ρ) R(ξ/ρ) n̂    ↔    X = ξ v_0/|v_0| + n n̂                                      v·∇_r = v_0·∇_X
//!   ∇²T = T_nn + T_n/(n − ρ) + (ρ/(ρ − n))² T_ξξ ≈ T_nn + T_ξξ
//! ```
//! What heat a place takes in and how it moves are kept; conduction along the motion, which counts little where bodies move fast beside it, is that of the centre.
//!
//! Theory: Heat by finite volumes.

use crate::volumes::grid::Grid;

/// A surface that spins, and the plane into which it is drawn out.
#[derive(Clone)]
pub struct Turning {
    /// Nodes of the surface.
    own: Grid,
    /// Nodes of the plane.
    plane: Grid,
    /// Unit vector of v_0 along the axes of the grid, and ρ in half-widths.
    along: [f64; 2],
    radius: f64,
}

/// Angle behind or before the centre, rad, beyond which a surface is not followed.
const FARTHEST: f64 = 1.5;

/// Cells of room about the images of nodes, for what is between them.
const ROOM: i64 = 3;

impl Turning {
    /// A body that moves at a velocity at the centre, m/s, and spins at a rate, m/s over a half-width; `None` where it does not spin. One that turns about the centre itself
    /// is left as it is.
    pub fn new(grid: &Grid, velocity: [f64; 2], spin: f64) -> Option<Turning> {
        let speed = velocity[0].hypot(velocity[1]);
        if spin == 0.0 || speed == 0.0 {
            return None;
        }
        let mut turning = Turning {
            own: grid.clone(),
            plane: grid.clone(),
            along: velocity.map(|v| v / speed),
            radius: speed / spin,
        };
        let mut bounds = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        for [i, j] in grid.nodes() {
            let Some(image) = turning.drawn_out(grid.on_axes(i, j)) else {
                continue;
            };
            for (bound, x) in bounds.iter_mut().zip(image) {
                *bound = [bound[0].min(x), bound[1].max(x)];
            }
        }
        for (d, [low, high]) in bounds.into_iter().enumerate() {
            let h = grid.spacing[d];
            let first = (low / h).floor() as i64 - ROOM;
            turning.plane.first[d] = first;
            turning.plane.n[d] = ((high / h).ceil() as i64 + ROOM - first + 1) as usize;
        }
        Some(turning)
    }

    /// Nodes of the plane.
    pub fn plane(&self) -> &Grid {
        &self.plane
    }

    /// ξ and n of a place along the axes, and back.
    fn split(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [u, v] = self.along;
        [u * x + v * y, u * y - v * x]
    }

    fn joined(&self, [along, across]: [f64; 2]) -> [f64; 2] {
        let [u, v] = self.along;
        [u * along - v * across, v * along + u * across]
    }

    /// X of r; `None` beyond what is followed.
    fn drawn_out(&self, place: [f64; 2]) -> Option<[f64; 2]> {
        let [x, y] = self.split(place);
        // (r − c)/(n − ρ) = R(ξ/ρ) n̂ = (−sin, cos).
        let sign = self.radius.signum();
        let [sin, cos] = [sign * x, sign * (self.radius - y)];
        let angle = sin.atan2(cos);
        let distance = sin.hypot(cos);
        (angle.abs() < FARTHEST && distance > 0.0)
            .then(|| self.joined([angle * self.radius, self.radius - sign * distance]))
    }

    /// r of X; `None` on the other side of c.
    fn place(&self, drawn_out: [f64; 2]) -> Option<[f64; 2]> {
        let [along, across] = self.split(drawn_out);
        let angle = along / self.radius;
        let from_centre = across - self.radius;
        let is_own = from_centre * self.radius < 0.0 && angle.abs() < FARTHEST;
        is_own.then(|| {
            let (sin, cos) = angle.sin_cos();
            self.joined([-from_centre * sin, self.radius + from_centre * cos])
        })
    }

    /// Values at the nodes of the plane of those at the nodes of the surface.
    pub fn draw_out(&self, values: &[f64]) -> Vec<f64> {
        sampled(&self.plane, |x| self.place(x), &self.own, values)
    }

    /// Values at the nodes of the surface of those at the nodes of the plane.
    pub fn draw_back(&self, values: &[f64]) -> Vec<f64> {
        sampled(&self.own, |x| self.drawn_out(x), &self.plane, values)
    }
}

/// Values of a grid at the images of the nodes of another, by cubics; nothing where there are none.
fn sampled(
    at: &Grid,
    image: impl Fn([f64; 2]) -> Option<[f64; 2]> + Sync,
    of: &Grid,
    values: &[f64],
) -> Vec<f64> {
    use rayon::prelude::*;
    let [nx, ny] = of.n.map(|n| n as i64);
    let value = |k: usize| {
        let place = image(at.on_axes(k % at.n[0], k / at.n[0]))?;
        let parts = [0, 1].map(|d: usize| {
            let cells = place[d] / of.spacing[d] - of.first[d] as f64;
            let first = cells.floor();
            (first as i64 - 1, weights(cells - first))
        });
        let [(i, along), (j, across)] = parts;
        let mut sum = 0.0;
        for (dj, weight) in (j..).zip(across) {
            if !(0..ny).contains(&dj) {
                continue;
            }
            for (di, w) in (i..).zip(along) {
                if (0..nx).contains(&di) {
                    sum += weight * w * values[of.index(di as usize, dj as usize)];
                }
            }
        }
        Some(sum)
    };
    (0..at.n_nodes())
        .into_par_iter()
        .with_min_len(LEAST)
        .map(|k| value(k).unwrap_or(0.0))
        .collect()
}

/// Nodes that a thread takes at a time.
const LEAST: usize = 1024;

/// Weights of the nodes at −1, 0, 1 and 2 of a cubic at 0 ≤ t < 1 (Lagrange).
fn weights(t: f64) -> [f64; 4] {
    let [a, b, c] = [t + 1.0, t - 1.0, t - 2.0];
    [
        -t * b * c / 6.0,
        a * b * c / 2.0,
        -a * t * c / 2.0,
        a * t * b / 6.0,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::{HertzZone, Turn};
    use approx::assert_relative_eq;

    fn grid(h: f64) -> Grid {
        let zone = HertzZone {
            axis_ratio: 1.5,
            turn: Turn::NONE,
            roller: None,
        };
        Grid::covering([[-2.0, 2.0], [-1.5, 1.5]], h, false, &zone)
    }

    /// Images move at the velocity of the centre where places move at their own, whatever the velocity and whichever way the body spins; and there is a way back.
    #[test]
    fn images_move_alike() {
        for (velocity, spin) in [([2.0, 0.0], 0.6), ([-1.0, 0.5], 0.4), ([0.3, 1.0], -0.3)] {
            let turning = Turning::new(&grid(0.25), velocity, spin).unwrap();
            for place in [[0.0, 0.0], [0.7, -0.4], [-1.1, 0.9], [0.2, 1.3]] {
                let image = turning.drawn_out(place).unwrap();
                let back = turning.place(image).unwrap();
                let later = {
                    let [x, y] = place;
                    let dt = 1e-6;
                    [
                        x + dt * (velocity[0] - spin * y),
                        y + dt * (velocity[1] + spin * x),
                    ]
                };
                let moved = turning.drawn_out(later).unwrap();
                for d in 0..2 {
                    assert_relative_eq!(back[d], place[d], epsilon = 1e-12);
                    assert_relative_eq!((moved[d] - image[d]) / 1e-6, velocity[d], epsilon = 1e-5);
                }
            }
        }
    }

    /// Smooth values come back from the plane; errors fall with the fourth power of the cell.
    #[test]
    fn there_and_back() {
        let errors = [0.125, 0.0625].map(|h| {
            let grid = grid(h);
            let turning = Turning::new(&grid, [1.0, 0.2], 0.4).unwrap();
            let bell = |[x, y]: [f64; 2]| (-2.0 * (x * x + y * y)).exp();
            let values: Vec<f64> = grid
                .nodes()
                .map(|[i, j]| bell(grid.on_axes(i, j)))
                .collect();
            let back = turning.draw_back(&turning.draw_out(&values));
            (back.iter().zip(&values))
                .map(|(a, b)| (a - b).abs())
                .fold(0.0, f64::max)
        });
        assert!(
            errors[1] < 1e-4 && errors[0] / errors[1] > 10.0,
            "{errors:?}"
        );
    }
}
