//! Temperature of the surface of a moving body under heat that flows into the cells of a grid.
//!
//! ```text
//!   T = ∫∫ q/(2πkr) e^{−(u r − u·x)/2χ} dA           moving point source (Jaeger 1942; Carslaw and Jaeger 1959, section 10.7)
//!     = 1/ρc ∫₀^∞ X(t) Y(t) θ(t) dt/√(πχt)           the same as a sum of instantaneous sources over a cell (section 10.2), χ = k/ρc
//!   X = ½[erf((x − ut + ½h)/√(4χt)) − erf((x − ut − ½h)/√(4χt))],   Y likewise across
//!   θ = Σ_n (−1)ⁿ e^{−n²D²/χt}                       images: the bulk temperature at the depth D
//!   θ/ρc√(πχt) = Σ_i g p_i,  χt = V_i                of a body with layers ([`crate::layers::HeatedBody`])
//! ```
//! With u = 0 it is a body at rest, which only the depth D keeps cool far from the contact.
//!
//! Theory: Heat by finite volumes.

use std::f64::consts::PI;

use ertel_fem::quadrature::Quadrature;

use crate::layers::{HeatLayer, HeatedBody, ThermalMaterial};

/// A body below a grid of cells, SI.
#[derive(Clone, Debug, PartialEq)]
pub struct MovingBody {
    /// Layers, from the surface down; the other constants are those of the substrate.
    pub layers: Vec<HeatLayer>,
    /// k, W/(m·K).
    pub conductivity: f64,
    /// ρc, J/(m³·K).
    pub capacity: f64,
    /// Velocity along the directions of the grid, m/s.
    pub velocity: [f64; 2],
    /// D, m.
    pub depth: f64,
    /// Conduction along the first direction over that along the others.
    pub stretch: f64,
}

/// Gauss points to a panel of time.
const POINTS: usize = 6;

/// Growth of the panels of time where nothing passes by, and the first one, as a share of the time in which heat spreads over a cell or through the depth, or a cell
/// passes.
const GROWTH: f64 = 1.7;
const FIRST: f64 = 1e-3;

/// e-folds after which a source in a body of finite depth counts as decayed, and the half-extent of the plume in its widths.
const FORGOTTEN: f64 = 30.0;
const WIDTHS: f64 = 5.0;

/// Terms of θ.
const TERMS: usize = 8;

impl MovingBody {
    /// χ, m²/s.
    pub fn diffusivity(&self) -> f64 {
        self.conductivity / self.capacity
    }

    /// θ.
    fn memory(&self, time: f64) -> f64 {
        let b = self.depth * self.depth / (self.diffusivity() * time);
        let sign = |n: usize| if n.is_multiple_of(2) { 1.0 } else { -1.0 };
        match b > PI {
            true => {
                1.0 + (1..TERMS)
                    .map(|n| 2.0 * sign(n) * (-b * (n * n) as f64).exp())
                    .sum::<f64>()
            }
            // The same sum by Poisson's formula.
            false => (0..TERMS)
                .map(|n| 2.0 * (PI / b).sqrt() * (-(PI * (n as f64 + 0.5)).powi(2) / b).exp())
                .sum(),
        }
    }

    /// The body with its layers, if it has any.
    pub fn heated(&self) -> Option<HeatedBody> {
        let substrate = ThermalMaterial {
            conductivity: self.conductivity,
            capacity: self.capacity,
        };
        (!self.layers.is_empty()).then(|| HeatedBody::new(&self.layers, substrate, self.depth))
    }

    /// Ends of the panels of time for cells of a size, m, that are no further than some distance from the source.
    fn panels(&self, size: [f64; 2], farthest: [f64; 2]) -> Vec<f64> {
        let ([slow, fast], [through, decay]) = match self.heated() {
            Some(body) => (body.diffusivities(), body.times()),
            None => {
                let chi = self.diffusivity();
                let through = self.depth * self.depth / chi;
                ([chi; 2], [through, 4.0 / (PI * PI) * through])
            }
        };
        let passage = (0..2)
            .map(|d| size[d] / self.velocity[d].abs())
            .fold(f64::INFINITY, f64::min);
        let smallest = size[0].min(size[1]);
        let spreading = smallest * smallest / fast;
        let mut ends = vec![0.0, FIRST * spreading.min(passage).min(through)];
        loop {
            let t = ends[ends.len() - 1];
            let [narrow, wide] =
                [slow, fast].map(|chi| (4.0 * chi * t * self.stretch.max(1.0)).sqrt());
            let has_left = |d: usize| self.velocity[d].abs() * t - farthest[d] > WIDTHS * wide;
            if t > FORGOTTEN * decay || has_left(0) || has_left(1) {
                return ends;
            }
            // Edges of cells pass by within `passage`, blurred by the width of the plume.
            let blurred = (0..2)
                .map(|d| size[d].max(narrow) / self.velocity[d].abs())
                .fold(f64::INFINITY, f64::min);
            let grown = GROWTH * t;
            let next = match grown - t > blurred {
                // Between the edges of cells where nothing blurs them.
                true if blurred == passage => ((t / passage + 0.5).floor() + 0.5) * passage,
                true => t + blurred,
                false => grown,
            };
            ends.push(if next > t * (1.0 + 1e-9) {
                next
            } else {
                t + passage
            });
        }
    }

    /// Gauss points in time of instantaneous sources in such cells.
    fn sources(&self, size: [f64; 2], farthest: [f64; 2]) -> Vec<Source> {
        let rule = Quadrature::simplex(1, 2 * POINTS - 1);
        let unit = self.capacity * (PI * self.diffusivity()).sqrt();
        let panels = self.panels(size, farthest);
        let points = panels.windows(2).flat_map(|ends| {
            let [low, high] = [ends[0], ends[1]].map(f64::sqrt);
            // dt/√t = 2 d√t
            (rule.points.iter().zip(&rule.weights))
                .map(move |(x, w)| [low + (high - low) * x[0], 2.0 * w * (high - low)])
        });
        let Some(body) = self.heated() else {
            let width = (4.0 * self.diffusivity()).sqrt();
            let source = |[root, weight]: [f64; 2]| Source {
                root,
                width: width * root,
                weight: weight * self.memory(root * root) / unit,
            };
            return points.map(source).collect();
        };
        let pulses = points.flat_map(|[root, weight]| {
            let pulse = body.pulse(root * root);
            pulse.spread.map(|[share, variance]| Source {
                root,
                width: (4.0 * variance).sqrt(),
                weight: weight * root * pulse.rise * share,
            })
        });
        pulses.filter(|source| source.weight != 0.0).collect()
    }

    /// Rise of the surface temperature, K/(W/m²), of the cells at offsets from one that takes in heat: −n ≤ i ≤ n along the first direction, −m ≤ j ≤ m along the
    /// second, row by row. Cells are `size` m wide; those of a line contact have no end across.
    pub fn response(&self, size: [f64; 2], [n, m]: [usize; 2]) -> Vec<f64> {
        let counts = [2 * n + 1, 2 * m + 1];
        let farthest = [0, 1].map(|d: usize| match size[d].is_finite() {
            true => [n, m][d] as f64 * size[d],
            false => f64::INFINITY,
        });
        let mut response = vec![0.0; counts[0] * counts[1]];
        let mut shares = counts.map(|n| vec![0.0; n]);
        for source in self.sources(size, farthest) {
            let [over_row, over_rows] = &mut shares;
            let [x, y] = self.velocity.map(|u| u * source.root * source.root);
            let along = Covered::new(over_row, size[0], x, self.stretch.sqrt() * source.width);
            let across = Covered::new(over_rows, size[1], y, source.width);
            let rows = response.chunks_exact_mut(counts[0]).skip(across.first);
            for (row, share) in rows.zip(across.shares) {
                let factor = source.weight * share;
                for (sum, share) in row[along.first..].iter_mut().zip(along.shares) {
                    *sum += factor * share;
                }
            }
        }
        response
    }

    /// The same of heat that varies across the motion like shapes that keep their form, Y = e^{−χκ²t}: at −n ≤ i ≤ n along the rows, for each κ² of `squares`, 1/m². The
    /// body moves along the rows alone.
    pub fn response_to_shapes(&self, size: f64, n: usize, squares: &[f64]) -> Vec<f64> {
        let count = 2 * n + 1;
        let mut response = vec![0.0; count * squares.len()];
        let mut over_row = vec![0.0; count];
        let farthest = [n as f64 * size, f64::INFINITY];
        for source in self.sources([size, f64::INFINITY], farthest) {
            let along = Covered::new(
                &mut over_row,
                size,
                self.velocity[0] * source.root * source.root,
                source.width,
            );
            for (row, square) in response.chunks_exact_mut(count).zip(squares) {
                let spread = 0.25 * source.width * source.width * square;
                if spread > FORGOTTEN {
                    continue;
                }
                let factor = source.weight * (-spread).exp();
                for (sum, share) in row[along.first..].iter_mut().zip(along.shares) {
                    *sum += factor * share;
                }
            }
        }
        response
    }
}

/// An instantaneous source of 1 J/m² in a cell, some time later.
struct Source {
    /// √t, √s.
    root: f64,
    /// √(4χt), m.
    width: f64,
    /// Rise times the duration that the source represents, K·m²/W.
    weight: f64,
}

/// Shares of the heat of a cell that has moved and spread, at the middles of the cells around that it reaches.
struct Covered<'a> {
    /// The first of these cells.
    first: usize,
    shares: &'a [f64],
}

/// Widths of the plume, beyond which erf is one to the last digit.
const REACH: f64 = 6.0;

impl Covered<'_> {
    /// Moved by `shift` and spread over `width`: ½ erf differences, in the room for all cells.
    fn new(room: &mut [f64], size: f64, shift: f64, width: f64) -> Covered<'_> {
        let n = room.len();
        let middle = (n / 2) as f64;
        // A cell without an end is everywhere.
        let edge = |k: usize| match size.is_finite() {
            true => ((k as f64 - middle - 0.5) * size - shift) / width,
            false => f64::INFINITY.copysign(k as f64 - middle - 0.5),
        };
        let place = |x: f64| match size.is_finite() {
            true => ((shift + x * width) / size + middle + 0.5).clamp(0.0, n as f64),
            false => middle + 0.5,
        };
        let first = place(-REACH).floor() as usize;
        let end = place(REACH).ceil() as usize;
        let value = |x: f64| match x.abs() > REACH {
            true => x.signum(),
            false => libm::erf(x),
        };
        let mut before = value(edge(first));
        for (k, share) in room[first..end].iter_mut().enumerate() {
            let next = value(edge(first + k + 1));
            *share = 0.5 * (next - before);
            before = next;
        }
        Covered {
            first,
            shares: &room[first..end],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use realfft::num_complex::Complex64;

    fn steel(velocity: [f64; 2], depth: f64) -> MovingBody {
        MovingBody {
            layers: Vec::new(),
            conductivity: 46.0,
            capacity: 7850.0 * 470.0,
            velocity,
            depth,
            stretch: 1.0,
        }
    }

    /// Rise at places x/b of a band of heat q(x) that is 2b wide, in units of q₀ b/k, which has no end across.
    fn band(peclet: f64, flux: impl Fn(f64) -> f64, half: usize) -> Vec<f64> {
        let b = 1e-4;
        let chi = steel([0.0; 2], 1.0).diffusivity();
        let body = steel([2.0 * chi * peclet / b, 0.0], 1.0);
        let h = 2.0 * b / (2 * half) as f64;
        let n = 2 * half;
        let response = body.response([h, f64::INFINITY], [n, 0]);
        let x = |i: usize| (i as f64 + 0.5 - half as f64) / half as f64;
        (0..n)
            .map(|i| {
                let sum: f64 = (0..n).map(|j| response[n + i - j] * flux(x(j))).sum();
                sum * body.conductivity / b
            })
            .collect()
    }

    /// Jaeger's uniform band (J. Proc. R. Soc. N.S.W. 76, 1942, 203; Carslaw and Jaeger 1959, section 10.7), integrated here independently: T = 2χq/πku ∫ e^ξ K₀|ξ| dξ from L(x/b − 1) to L(x/b + 1), L = ub/2χ.
    #[test]
    fn jaegers_band() {
        // K₀ by ∫ e^{−z cosh t} dt.
        let k0 = |z: f64| -> f64 {
            let n = 4000;
            let step = 12.0 / f64::from(n);
            (0..n)
                .map(|k| step * (-z * ((f64::from(k) + 0.5) * step).cosh()).exp())
                .sum()
        };
        for peclet in [0.5, 5.0] {
            let found = band(peclet, |_| 1.0, 200);
            for i in [40, 200, 300, 390] {
                let x = (i as f64 + 0.5 - 200.0) / 200.0;
                let (low, high) = (peclet * (x - 1.0), peclet * (x + 1.0));
                // ξ = ±y² takes the logarithm of K₀ away.
                let part = |end: f64, sign: f64| -> f64 {
                    let n = 1000;
                    let step = end.sqrt() / f64::from(n);
                    (0..n)
                        .map(|k| {
                            let y = (f64::from(k) + 0.5) * step;
                            2.0 * y * step * (sign * y * y).exp() * k0(y * y)
                        })
                        .sum()
                };
                let integral = part(-low, -1.0) + part(high, 1.0);
                let exact = integral / (PI * peclet);
                assert_relative_eq!(found[i], exact, max_relative = 2e-3);
            }
        }
    }

    /// Bands that move fast: largest rises √2/√π of a uniform flux at its end, 0.78598 of an elliptic one at 0.6522, in units of Q/(b e √(u/b)) with Q the heat of the
    /// band (one-dimensional conduction, integrated separately).
    #[test]
    fn fast_bands() {
        let peclet: f64 = 2000.0;
        let unit = (2.0 * peclet).sqrt();
        let uniform = band(peclet, |_| 0.5, 200);
        // At the end of the last cell, half a cell behind its middle.
        let last = uniform[399] * unit * (1.0 + 0.5 * 0.5 / 400.0);
        assert_relative_eq!(last, 0.797_884_6, max_relative = 3e-3);
        let ellipse = band(peclet, |x| 2.0 / PI * (1.0 - x * x).max(0.0).sqrt(), 200);
        let (at, largest) =
            ellipse.iter().enumerate().fold(
                (0, 0.0),
                |best, (i, t)| {
                    if *t > best.1 { (i, *t) } else { best }
                },
            );
        assert_relative_eq!(largest * unit, 0.785_983_4, max_relative = 3e-3);
        assert!(((at as f64 + 0.5 - 200.0) / 200.0 - 0.6522).abs() < 0.01);
    }

    /// Heat that varies along one direction like cos κy is a sum of cells along it; a body that moves across them, at rest and fast.
    #[test]
    fn shapes_are_sums_of_cells() {
        let (h, n) = (2e-5, 12);
        for speed in [0.0, 0.3, -3.0] {
            let body = steel([speed, 0.0], 3e-4);
            let wavelength = 40.0;
            let turn = 2.0 * PI / wavelength;
            let far = 160;
            let cells = body.response([h; 2], [n, far]);
            let count = 2 * n + 1;
            let kappa = turn / h;
            let shape = body.response_to_shapes(h, n, &[0.0, kappa * kappa]);
            for i in 0..count {
                let sum: f64 = (0..=2 * far)
                    .map(|j| cells[j * count + i] * (turn * (j as f64 - far as f64)).cos())
                    .sum();
                // A wave that is level in each cell is smaller by sin(x)/x.
                let level = sum / ((0.5 * turn).sin() / (0.5 * turn));
                let size = shape[count + n].abs();
                assert!(
                    (shape[count + i] - level).abs() < 3e-3 * size,
                    "{speed} {i}"
                );
                let line = body.response([h, f64::INFINITY], [n, 0]);
                assert_relative_eq!(shape[i], line[i], max_relative = 1e-12);
            }
        }
    }

    /// Waves of heat, level in the cells of a line, on bodies with layers against their response in closed form.
    #[test]
    fn waves_over_layers() {
        let (h, wavelength) = (5e-6, 40_usize);
        let turn = 2.0 * PI / wavelength as f64;
        let layer = HeatLayer::new;
        for (layers, speed, most) in [
            (vec![layer(3e-6, 1.0, 2e6)], 2.0, 2e-5),
            (vec![layer(3e-6, 1.0, 2e6)], 0.0, 2e-5),
            (vec![layer(3e-5, 1.0, 2e6)], 12.0, 2e-5),
            (
                vec![layer(1e-6, 200.0, 3e6), layer(4e-6, 1.0, 2e6)],
                1.0,
                5e-4,
            ),
            (vec![layer(3e-5, 0.25, 2e6)], 0.05, 2e-3),
            // Three moments of the spread do not suffice here.
            (vec![layer(2e-5, 0.25, 2e6)], 0.0, 4e-2),
        ] {
            let body = MovingBody {
                layers,
                ..steel([speed, 0.0], 3e-4)
            };
            let far = 60 * wavelength;
            let response = body.response([h, f64::INFINITY], [far, 0]);
            let phase = |i: usize| Complex64::cis(-turn * (i as f64 - far as f64));
            // Fades out: a sum that ends with a jump errs by half of its last wave.
            let fading = |i: usize| {
                let share = (i as f64 / far as f64 - 1.0).abs();
                (0.5 * PI * (2.0 * share - 1.0).max(0.0)).cos().powi(2)
            };
            let sum: Complex64 = (response.iter().enumerate())
                .map(|(i, r)| fading(i) * r * phase(i))
                .sum();
            // Level cells are a sum of waves, whose lengths differ by a turn per cell.
            let heated = body.heated().unwrap();
            let exact: Complex64 = (-2000..=2000)
                .map(|alias| {
                    let turn = turn + 2.0 * PI * f64::from(alias);
                    let wave = turn / h;
                    let s = Complex64::new(0.0, wave * speed);
                    (0.5 * turn).sin() / (0.5 * turn) * heated.impedance((wave * wave).into(), s)
                })
                .sum();
            let error = (sum - exact).norm() / exact.norm();
            assert!(error < most, "{speed} {:?}: {error}", body.layers);
        }
    }

    /// A square at rest on a half-space has ln(1 + √2) 4/π of q h/2k at its middle (Carslaw and Jaeger 1959, section 10.5), where the depth is 300 times its width; and a wide layer of
    /// depth D rises by q D/k.
    #[test]
    fn bodies_at_rest() {
        let body = steel([0.0; 2], 0.3);
        let found = body.response([1e-3; 2], [0, 0])[0];
        let exact = 4.0 / PI * (1.0 + 2.0_f64.sqrt()).ln() * 0.5e-3 / 46.0;
        // The image at twice the depth takes away h²/(2π k 2D)·2.
        assert_relative_eq!(found, exact, max_relative = 2e-3);
        let layer = steel([0.0; 2], 1e-3);
        let wide = layer.response([0.1; 2], [0, 0])[0];
        assert_relative_eq!(wide, 1e-3 / 46.0, max_relative = 1e-6);
    }

    /// A body that moves the other way, or along the second direction, has the mirrored field.
    #[test]
    fn motion_in_any_direction() {
        let along = steel([0.4, 0.0], 1e-2).response([1e-5; 2], [3, 3]);
        let back = steel([-0.4, 0.0], 1e-2).response([1e-5; 2], [3, 3]);
        let across = steel([0.0, 0.4], 1e-2).response([1e-5; 2], [3, 3]);
        for j in 0..7 {
            for i in 0..7 {
                assert_relative_eq!(along[7 * j + i], back[7 * j + 6 - i], max_relative = 1e-9);
                assert_relative_eq!(along[7 * j + i], across[7 * i + j], max_relative = 1e-9);
            }
        }
        // Of point sources e^{u·x/2χ} downstream over e^{−u·x/2χ} upstream, x two cells.
        let chi = steel([0.0; 2], 1.0).diffusivity();
        let ratio = along[3 * 7 + 5] / along[3 * 7 + 1];
        assert_relative_eq!(ratio, (0.4 * 2e-5 / chi).exp(), max_relative = 0.03);
    }
}
