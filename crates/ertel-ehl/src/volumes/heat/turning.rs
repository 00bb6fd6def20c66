//! Spinning bodies: their surface is mapped to a plane that moves at the velocity of the centre.
//!
//! ```text
//!   v = v_0 + ω e_z × r = ω e_z × (r − c),   c = ρ n̂,   ρ = |v_0|/ω,   n̂ = e_z × v_0/|v_0|        c: about which the body turns
//!   r = c + (n − ρ) R(ξ/ρ) n̂    ↔    (ξ, n)                                                        v·∇ = |v_0| ∂/∂ξ
//!   ∇²T = T_nn + T_n/(n − ρ) + κT_ξξ,   κ = (ρ/(ρ − n))²
//!   T = Σ_j K_j * (L_j(n) q),   κ_j at n_j/ρ = −τ, 0, τ                                             L_j the parabolas through them
//! ```
//! κ is that of the place where heat flows in: it spreads little across the motion before it has passed. T_n/(n − ρ) is that of the centre, a slow drift.
//!
//! Theory: Heat by finite volumes.

use rayon::prelude::*;
use realfft::num_complex::Complex64;

use super::source::MovingBody;
use crate::volumes::grid::Grid;
use crate::volumes::padded::{NO_FADING, Padded};

/// Spreading of heat in a body that spins under a grid.
pub struct Turning {
    surface: SurfaceMap,
    transforms: Padded,
    /// Transforms of K_j, over the gain of the transforms.
    symbols: [Vec<Complex64>; 3],
}

/// τ.
const PLANE_OFFSET: f64 = 0.4;

/// Distance in τ beyond which κ is constant.
const FURTHEST: f64 = 1.25;

/// Numbers that a thread takes at a time.
const BATCH: usize = 4096;

impl Turning {
    /// In a body below a grid whose half-width is `length`, m; it spins about the centre at a rate, m/s over a half-width. `None` where it does not, or turns about the centre itself.
    pub fn new(grid: &Grid, body: &MovingBody, length: f64, spin: f64) -> Option<Turning> {
        let surface = SurfaceMap::new(grid, body.velocity, spin)?;
        let transforms = Padded::new(&surface.plane);
        let size = surface.plane.cell_size(length);
        let reach = transforms.covered().map(|n| n - 1);
        let [u, v] = body.velocity;
        let drift = body.diffusivity() / (surface.radius * length);
        let symbol = |n: f64| {
            let own = MovingBody {
                velocity: [u.hypot(v), drift],
                stretch: (1.0 - n).powi(-2),
                ..body.clone()
            };
            transforms.of_response(&own.response(size, reach))
        };
        Some(Turning {
            symbols: [-PLANE_OFFSET, 0.0, PLANE_OFFSET].map(symbol),
            transforms,
            surface,
        })
    }

    /// Whether a place along the axes is outside the map.
    pub fn has_lost(&self, place: [f64; 2]) -> bool {
        self.surface
            .image(place)
            .is_none_or(|[_, n]| n.abs() > self.surface.radius.abs())
    }

    /// Rises at the nodes, K, by the heat that flows in there, W/m².
    pub fn apply(&self, heat: &[f64]) -> Vec<f64> {
        let plane = &self.surface.plane;
        let heat = self.surface.on_plane(heat);
        let mut sum = vec![Complex64::default(); self.transforms.n_waves()];
        for (j, symbol) in self.symbols.iter().enumerate() {
            let share = |k: usize| {
                let [_, n] = plane.on_axes(0, k / plane.n[0]);
                let t = n / self.surface.radius / PLANE_OFFSET;
                parabolas(t.clamp(-FURTHEST, FURTHEST))[j]
            };
            let own: Vec<f64> = (heat.iter().enumerate())
                .map(|(k, q)| share(k) * q)
                .collect();
            let spectrum = self.transforms.spectrum(&own, NO_FADING);
            (sum.par_iter_mut().zip(spectrum).zip(symbol))
                .with_min_len(BATCH)
                .for_each(|((sum, value), factor)| *sum += value * factor);
        }
        self.surface.on_surface(&self.transforms.values(sum))
    }
}

/// Parabolas that are 1 at one of −1, 0 and 1, and 0 at the others.
fn parabolas(t: f64) -> [f64; 3] {
    [0.5 * t * (t - 1.0), 1.0 - t * t, 0.5 * t * (t + 1.0)]
}

/// A spinning surface, and the plane to which it is mapped.
struct SurfaceMap {
    /// Nodes of the surface.
    own: Grid,
    /// Nodes of the plane, at ξ and n.
    plane: Grid,
    /// Unit vector of v_0 along the axes of the grid, and ρ in half-widths.
    along: [f64; 2],
    radius: f64,
}

/// Largest angle of the map behind or before the centre, rad.
const FARTHEST: f64 = 1.5;

/// Cells of room about the images of nodes, for what is between them.
const ROOM: i64 = 3;

impl SurfaceMap {
    /// A surface that moves at a velocity at the centre and spins, the same over a half-width.
    fn new(grid: &Grid, velocity: [f64; 2], spin: f64) -> Option<SurfaceMap> {
        let speed = velocity[0].hypot(velocity[1]);
        if spin == 0.0 || speed == 0.0 {
            return None;
        }
        let [u, v] = velocity.map(|v| v / speed);
        let mut drawn = SurfaceMap {
            own: grid.clone(),
            plane: grid.clone(),
            along: [u, v],
            radius: speed / spin,
        };
        let mut bounds = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        for [i, j] in grid.nodes() {
            let Some(image) = drawn.image(grid.on_axes(i, j)) else {
                continue;
            };
            for (bound, x) in bounds.iter_mut().zip(image) {
                *bound = [bound[0].min(x), bound[1].max(x)];
            }
        }
        // As far apart as a cell is long along each direction.
        let [hx, hy] = grid.spacing;
        drawn.plane.spacing = [1.0 / (u / hx).hypot(v / hy), 1.0 / (v / hx).hypot(u / hy)];
        drawn.plane.half = false;
        for (d, [low, high]) in bounds.into_iter().enumerate() {
            let h = drawn.plane.spacing[d];
            let first = (low / h).floor() as i64 - ROOM;
            drawn.plane.first[d] = first;
            drawn.plane.n[d] = ((high / h).ceil() as i64 + ROOM - first + 1) as usize;
        }
        Some(drawn)
    }

    /// ξ and n of a place along the axes; `None` outside the map.
    fn image(&self, [x, y]: [f64; 2]) -> Option<[f64; 2]> {
        let [u, v] = self.along;
        let [along, across] = [u * x + v * y, u * y - v * x];
        // (r − c)/(n − ρ) = R(ξ/ρ) n̂ = (−sin, cos).
        let sign = self.radius.signum();
        let [sin, cos] = [sign * along, sign * (self.radius - across)];
        let (angle, distance) = (sin.atan2(cos), sin.hypot(cos));
        (angle.abs() < FARTHEST && distance > 0.0)
            .then_some([angle * self.radius, self.radius - sign * distance])
    }

    /// The place along the axes at ξ and n; `None` on the other side of c.
    fn place(&self, [xi, n]: [f64; 2]) -> Option<[f64; 2]> {
        let [u, v] = self.along;
        let angle = xi / self.radius;
        let from_centre = n - self.radius;
        let is_own = from_centre * self.radius < 0.0 && angle.abs() < FARTHEST;
        is_own.then(|| {
            let (sin, cos) = angle.sin_cos();
            let [along, across] = [-from_centre * sin, self.radius + from_centre * cos];
            [u * along - v * across, v * along + u * across]
        })
    }

    /// Values at the nodes of the plane of those at the nodes of the surface.
    fn on_plane(&self, values: &[f64]) -> Vec<f64> {
        sampled(&self.plane, |x| self.place(x), &self.own, values)
    }

    /// Values at the nodes of the surface of those at the nodes of the plane.
    fn on_surface(&self, values: &[f64]) -> Vec<f64> {
        sampled(&self.own, |x| self.image(x), &self.plane, values)
    }
}

/// Values of a grid at the images of the nodes of another, by cubics; zero where there are none.
fn sampled(
    at: &Grid,
    image: impl Fn([f64; 2]) -> Option<[f64; 2]> + Sync,
    of: &Grid,
    values: &[f64],
) -> Vec<f64> {
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
    use std::f64::consts::PI;

    fn grid(h: f64) -> Grid {
        let zone = HertzZone {
            axis_ratio: 1.5,
            turn: Turn::NONE,
            roller: None,
        };
        Grid::covering([[-2.0, 2.0], [-1.5, 1.5]], [h; 2], false, &zone)
    }

    /// Images move along ξ at the speed of the centre where places move at their own velocity, for both senses of spin; and the inverse map returns.
    #[test]
    fn images_move_alike() {
        for (velocity, spin) in [([2.0, 0.0], 0.6), ([-1.0, 0.5], 0.4), ([0.3, 1.0], -0.3)] {
            let turning = SurfaceMap::new(&grid(0.25), velocity, spin).unwrap();
            for place in [[0.0, 0.0], [0.7, -0.4], [-1.1, 0.9], [0.2, 1.3]] {
                let image = turning.image(place).unwrap();
                let back = turning.place(image).unwrap();
                let later = {
                    let [x, y] = place;
                    let dt = 1e-6;
                    [
                        x + dt * (velocity[0] - spin * y),
                        y + dt * (velocity[1] + spin * x),
                    ]
                };
                let moved = turning.image(later).unwrap();
                for d in 0..2 {
                    assert_relative_eq!(back[d], place[d], epsilon = 1e-12);
                    let expected = if d == 0 {
                        velocity[0].hypot(velocity[1])
                    } else {
                        0.0
                    };
                    assert_relative_eq!((moved[d] - image[d]) / 1e-6, expected, epsilon = 1e-5);
                }
            }
        }
    }

    /// Smooth values come back from the plane; errors fall faster than the third power of the cell.
    #[test]
    fn there_and_back() {
        let errors = [0.125, 0.0625].map(|h| {
            let grid = grid(h);
            let turning = SurfaceMap::new(&grid, [1.0, 0.2], 0.4).unwrap();
            let bell = |[x, y]: [f64; 2]| (-2.0 * (x * x + y * y)).exp();
            let values: Vec<f64> = grid
                .nodes()
                .map(|[i, j]| bell(grid.on_axes(i, j)))
                .collect();
            let back = turning.on_surface(&turning.on_plane(&values));
            (back.iter().zip(&values))
                .map(|(a, b)| (a - b).abs())
                .fold(0.0, f64::max)
        });
        assert!(
            errors[1] < 3e-4 && errors[0] / errors[1] > 8.0,
            "{errors:?}"
        );
    }

    /// A body that turns under a spot of heat against the sum of its instantaneous sources, each of which has turned with the body: R(ωt)(r' − c) + c, spread over √(4χt). With κ = 1 and without
    /// drift both errors are twice as large.
    #[test]
    fn a_body_that_spins() {
        let zone = HertzZone {
            axis_ratio: 1.0,
            turn: Turn::NONE,
            roller: None,
        };
        let a = 1e-4;
        let grid = Grid::covering([[-3.0, 3.0], [-3.0, 3.0]], [0.0625; 2], false, &zone);
        for (peclet, most) in [(10.0, 0.013), (40.0, 0.006)] {
            let mut body = MovingBody {
                layers: Vec::new(),
                conductivity: 46.0,
                capacity: 7850.0 * 470.0,
                velocity: [0.0; 2],
                depth: 10.0 * a,
                stretch: 1.0,
            };
            let chi = body.diffusivity();
            let speed = peclet * chi / a;
            body.velocity = [speed, 0.0];
            let spin = 0.3 * speed;
            let turning = Turning::new(&grid, &body, a, spin).unwrap();
            let (width, at) = (0.5, [-0.5, 0.6]);
            let spot = |[x, y]: [f64; 2]| {
                (-((x - at[0]).powi(2) + (y - at[1]).powi(2)) / (width * width)).exp()
            };
            let heat: Vec<f64> = (grid.nodes())
                .map(|[i, j]| 1e7 * spot(grid.on_axes(i, j)))
                .collect();
            let found = turning.apply(&heat);
            let exact = |[x, y]: [f64; 2]| {
                // Heat that returns after half a turn is neglected.
                let (n, last) = (4000, PI * a / spin);
                let step = f64::sqrt(last) / f64::from(n);
                let sum: f64 = (0..n)
                    .map(|k| ((f64::from(k) + 0.5) * step).powi(2))
                    .map(|t| {
                        // The middle of the spot turns about c = (0, v/ω).
                        let (sin, cos) = (spin / a * t).sin_cos();
                        let centre = speed / spin;
                        let from = [at[0], at[1] - centre];
                        let moved = [
                            cos * from[0] - sin * from[1],
                            centre + sin * from[0] + cos * from[1],
                        ];
                        let wide = width * width + 4.0 * chi * t / (a * a);
                        let distance = (x - moved[0]).powi(2) + (y - moved[1]).powi(2);
                        width * width / wide * (-distance / wide).exp()
                    })
                    .sum();
                2e7 * step * sum / (body.capacity * (PI * chi).sqrt())
            };
            let largest = found.iter().fold(0.0_f64, |m, t| m.max(*t));
            let mut worst = 0.0_f64;
            for j in (8..grid.n[1]).step_by(12) {
                for i in (8..grid.n[0]).step_by(12) {
                    let own = exact(grid.on_axes(i, j));
                    worst = worst.max((found[grid.index(i, j)] - own).abs() / largest);
                }
            }
            assert!(worst < most, "{peclet}: {worst}");
        }
    }
}
