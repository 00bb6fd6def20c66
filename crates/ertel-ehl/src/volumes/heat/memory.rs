//! Heat that has flown into a moving body, and the later temperature of its surface.
//!
//! ```text
//!   T = Σ_j w_j φ_j,   ∂φ_j/∂t + u·∇φ_j = χ(∇²φ_j − μ_j² φ_j) + q/ρc                along the surface
//! ```
//! The rates χμ_j² and weights w_j are those of [`super::modes`].
//!
//! These are the instantaneous sources of [`super::source`], θ(t)/√(πχt) = Σ_j w_j e^{−χμ_j²t}. A wave e^{ik·x} of q that goes from q_0 to q_1 in a step Δ makes
//!
//! ```text
//!   φ̂_1 = e^{−zΔ} φ̂_0 + [(I_0 − I_1/Δ) q̂_1 + I_1/Δ q̂_0]/ρc,   z = χ(μ_j² + k²) + ik·u,   I_m = ∫_0^Δ t^m e^{−zt} dt
//! ```
//! without any error but that of q between both instants, for steps of any length. Heat that has moved off the grid is lost. Layers so thin that they follow a passing
//! cell instantaneously have the steady response.
//!
//! Theory: Heat in time.

use rayon::prelude::*;
use realfft::num_complex::Complex64;
use serde::{Deserialize, Serialize};

use super::modes::{Mode, Modes};
use super::source::MovingBody;
use super::spreading::Spreading;
use crate::volumes::convolution::Convolution;
use crate::volumes::grid::Grid;
use crate::volumes::padded::{Fading, NO_FADING, Padded};

/// e-folds after which the slowest mode counts as decayed.
const FORGOTTEN: f64 = 30.0;

/// Stored heat of a body at the nodes of a grid.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Memory {
    /// φ of each mode, K·m.
    fields: Vec<Vec<f64>>,
    /// Heat that flows in, W/m².
    flux: Vec<f64>,
}

impl Memory {
    /// Whether it is one of so many modes at so many nodes.
    pub fn fits(&self, modes: &Modes, n_nodes: usize) -> bool {
        self.fields.len() == modes.each.len()
            && self
                .fields
                .iter()
                .chain([&self.flux])
                .all(|values| values.len() == n_nodes)
    }
}

/// A body below a grid.
#[derive(Clone)]
pub struct Below {
    /// Its motion and material.
    pub body: MovingBody,
    /// Modes of its temperature.
    pub modes: Modes,
    /// Size of a cell, m; infinite across a line contact and where roller shapes define it.
    pub cell: [f64; 2],
    /// Transforms on the grid.
    pub transforms: Padded,
    /// Half-width, m.
    pub length: f64,
}

impl Below {
    /// Below a grid whose half-width is `length`, m; the body moves at a speed at most, m/s.
    pub fn new(grid: &Grid, body: MovingBody, length: f64, speed: f64) -> Below {
        let cell = grid.cell_size(length);
        Below {
            modes: Modes::new(&body, cell, speed),
            transforms: Padded::new(grid),
            body,
            cell,
            length,
        }
    }

    /// Of a body in steady state under this heat.
    pub fn settled(&self, flux: &[f64]) -> Memory {
        let over = Over::new(self, f64::INFINITY, self.body.velocity);
        let arriving = self.transforms.spectrum(flux, NO_FADING);
        let fields = (self.modes.each.iter())
            .map(|mode| {
                let spectrum = over.map(mode, |at| at.cell * at.whole * arriving[at.k]);
                self.transforms.values(spectrum)
            })
            .collect();
        Memory {
            fields,
            flux: flux.to_vec(),
        }
    }

    /// Of one that was never heated.
    pub fn cold(&self, n_nodes: usize) -> Memory {
        Memory {
            fields: vec![vec![0.0; n_nodes]; self.modes.each.len()],
            flux: vec![0.0; n_nodes],
        }
    }

    /// Rise of the surface by its stored heat, K.
    pub fn rise(&self, memory: &Memory) -> Vec<f64> {
        let at_once = self.modes.at_once / self.body.capacity;
        let mut rise: Vec<f64> = memory.flux.iter().map(|q| at_once * q).collect();
        for (field, mode) in memory.fields.iter().zip(&self.modes.each) {
            for (rise, value) in rise.iter_mut().zip(field) {
                *rise += mode.weight * value;
            }
        }
        rise
    }
}

/// A time over which a body moves at a mean velocity.
pub struct Over<'a> {
    below: &'a Below,
    /// s.
    duration: f64,
    /// That after which what was on the grid has left it, or the step's, s.
    counted: f64,
    velocity: [f64; 2],
    /// All waves.
    waves: Vec<Along>,
}

/// A wave along the surface.
struct Along {
    /// k², 1/m².
    square: f64,
    /// χk² + ik·u with the smallest χ, 1/s.
    rate: Complex64,
    /// e to the power of minus that times `counted`.
    decay: Complex64,
    /// Transform of a cell, over the heat capacity and the gain of the transforms, m³·K/J.
    cell: f64,
}

/// A wave of a mode over a time.
struct Wave {
    k: usize,
    /// Transform of a cell, over the heat capacity and the gain of the transforms, m³·K/J.
    cell: f64,
    /// e^{−zΔ} over the gain of the transforms; 0 where all has left.
    decay: Complex64,
    /// I_0, s.
    whole: Complex64,
    /// I_1/Δ, s.
    before: Complex64,
}

/// Waves that a thread takes at a time.
const LEAST: usize = 2048;

/// Decay below which stored heat counts as zero.
const NEGLIGIBLE: f64 = 40.0;

impl<'a> Over<'a> {
    /// A time in s and the mean velocity in it, m/s.
    pub fn new(below: &'a Below, duration: f64, velocity: [f64; 2]) -> Over<'a> {
        let covered = below.transforms.covered();
        let leaves = (0..2)
            .map(|d| covered[d] as f64 * below.cell[d] / velocity[d].abs())
            .fold(FORGOTTEN / below.modes.each[0].rate, f64::min);
        let counted = duration.min(leaves);
        let Below {
            body,
            modes,
            cell,
            transforms,
            length,
        } = below;
        let each = 1.0 / transforms.gain();
        let of_wave = |k: usize| {
            let (turns, is_shortest) = transforms.wave(k);
            let [kx, ky] = [0, 1].map(|d: usize| turns[d] / cell[d]);
            // Of the wave of two nodes only what is real is seen.
            let passing = |d: usize| match is_shortest[d] {
                true => 0.0,
                false => turns[d] / cell[d] * velocity[d],
            };
            let axial = transforms.across(k) / (length * length);
            let square = kx * kx + ky * ky + axial;
            let rate = Complex64::new(modes.diffusivity * square, passing(0) + passing(1));
            Along {
                square,
                rate,
                decay: (-rate * counted).exp(),
                cell: each * sinc(0.5 * turns[0]) * sinc(0.5 * turns[1]) / body.capacity,
            }
        };
        Over {
            duration,
            counted,
            velocity,
            waves: (0..transforms.n_waves())
                .into_par_iter()
                .with_min_len(LEAST)
                .map(of_wave)
                .collect(),
            below,
        }
    }

    /// Something of each wave of a mode, in the order of a spectrum.
    fn map(&self, mode: &Mode, of: impl Fn(&Wave) -> Complex64 + Sync) -> Vec<Complex64> {
        let each = 1.0 / self.below.transforms.gain();
        let t = self.counted;
        let forgotten = (-mode.rate * t).exp();
        let is_left = self.duration <= t;
        (self.waves.par_iter().enumerate())
            .with_min_len(LEAST)
            .map(|(k, along)| {
                let (mut z, mut e) = (along.rate + mode.rate, along.decay * forgotten);
                if mode.spread != 0.0 {
                    let more = mode.spread * along.square;
                    z += more;
                    e *= (-more * t).exp();
                }
                let [whole, first] = integrals(z, e, t);
                of(&Wave {
                    k,
                    cell: along.cell,
                    decay: if is_left {
                        each * e
                    } else {
                        Complex64::default()
                    },
                    whole,
                    before: first / self.duration,
                })
            })
            .collect()
    }

    /// Nodes over which stored heat fades out behind the grid, to avoid a step; inflow upstream carries no heat, and none re-enters at the
    /// other side.
    fn fading(&self) -> Fading {
        let Below {
            cell, transforms, ..
        } = self.below;
        let (covered, padded) = (transforms.covered(), transforms.padded());
        [0, 1].map(|d: usize| {
            let u = self.velocity[d];
            let moved = (u.abs() * self.counted / cell[d]).ceil() as usize;
            let room = (padded[d] - covered[d]).saturating_sub(moved) / 2;
            if u > 0.0 {
                [0, room]
            } else if u < 0.0 {
                [room, 0]
            } else {
                [0, 0]
            }
        })
    }

    /// Response of a surface to the heat at the end of the time, if that grows from zero.
    pub fn spreading(&self) -> Spreading {
        let Below {
            body,
            modes,
            transforms,
            ..
        } = self.below;
        let at_once = modes.at_once / body.capacity;
        let mut symbol = vec![Complex64::default(); transforms.n_waves()];
        for mode in &modes.each {
            let own = self.map(mode, |at| mode.weight * at.cell * (at.whole - at.before));
            for (sum, own) in symbol.iter_mut().zip(own) {
                *sum += own;
            }
        }
        for value in &mut symbol {
            *value += at_once / transforms.gain();
        }
        Spreading::Even(Convolution::new(transforms.clone(), symbol))
    }

    /// The part of a body's stored heat that remains.
    pub fn carried(&self, memory: &Memory) -> Carried {
        let Below {
            modes, transforms, ..
        } = self.below;
        let before = transforms.spectrum(&memory.flux, NO_FADING);
        let fading = self.fading();
        let spectra = (modes.each.iter().zip(&memory.fields))
            .map(|(mode, field)| {
                let is_left =
                    self.duration <= self.counted && mode.rate * self.duration < NEGLIGIBLE;
                let own = is_left.then(|| transforms.spectrum(field, fading));
                self.map(mode, |at| {
                    let new = at.cell * at.before * before[at.k];
                    own.as_ref().map_or(new, |own| new + at.decay * own[at.k])
                })
            })
            .collect();
        Carried { spectra }
    }

    /// Rise of the surface by it, K.
    pub fn rise(&self, carried: &Carried) -> Vec<f64> {
        let Below {
            modes, transforms, ..
        } = self.below;
        let mut sum = vec![Complex64::default(); transforms.n_waves()];
        for (spectrum, mode) in carried.spectra.iter().zip(&modes.each) {
            for (sum, value) in sum.iter_mut().zip(spectrum) {
                *sum += mode.weight * *value;
            }
        }
        transforms.values(sum)
    }

    /// Stored heat of the body at the end, with the heat that flows in then.
    pub fn remembered(&self, carried: Carried, flux: &[f64]) -> Memory {
        let Below {
            modes, transforms, ..
        } = self.below;
        let arriving = transforms.spectrum(flux, NO_FADING);
        let fields = (modes.each.iter().zip(carried.spectra))
            .map(|(mode, carried)| {
                let spectrum = self.map(mode, |at| {
                    carried[at.k] + at.cell * (at.whole - at.before) * arriving[at.k]
                });
                transforms.values(spectrum)
            })
            .collect();
        Memory {
            fields,
            flux: flux.to_vec(),
        }
    }
}

/// The part of stored heat that remains at the end of a time, wave by wave.
pub struct Carried {
    spectra: Vec<Vec<Complex64>>,
}

/// |zt| below which I_m are power series.
const SMALL: f64 = 0.05;

/// I_0 and I_1 over a time with e^{−zt}.
fn integrals(z: Complex64, e: Complex64, t: f64) -> [Complex64; 2] {
    let x = z * t;
    if x.norm_sqr() < SMALL * SMALL {
        let series = |c: [f64; 5]| {
            (c.iter().rev()).fold(Complex64::default(), |sum, c| {
                sum * (-x) + Complex64::from(*c)
            })
        };
        return [
            t * series([1.0, 1.0 / 2.0, 1.0 / 6.0, 1.0 / 24.0, 1.0 / 120.0]),
            t * t * series([1.0 / 2.0, 1.0 / 3.0, 1.0 / 8.0, 1.0 / 30.0, 1.0 / 144.0]),
        ];
    }
    let one = Complex64::from(1.0);
    [(one - e) / z, (one - e * (one + x)) / (z * z)]
}

/// sin x/x.
fn sinc(x: f64) -> f64 {
    if x.abs() < 1e-4 { 1.0 } else { x.sin() / x }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use crate::contact::{HertzZone, Turn};
    use crate::layers::HeatLayer;
    use crate::volumes::rows::Rows;
    use approx::assert_relative_eq;

    /// Half-width, m, and cells of it.
    const A: f64 = 1e-4;
    const CELL: f64 = 0.0625;

    fn grid(half: bool) -> Grid {
        let zone = HertzZone {
            axis_ratio: 1.0,
            turn: Turn::NONE,
            roller: None,
        };
        Grid::covering([[-2.0, 2.0], [-2.0, 2.0]], [CELL; 2], half, &zone)
    }

    /// Steel to a depth of 3.15 half-widths that moves by so many half-widths while heat spreads over one: u a/χ.
    fn below(grid: &Grid, peclet: [f64; 2]) -> Below {
        below_layers(grid, peclet, Vec::new())
    }

    fn below_layers(grid: &Grid, peclet: [f64; 2], layers: Vec<HeatLayer>) -> Below {
        let mut body = MovingBody {
            layers,
            conductivity: 46.0,
            capacity: 7850.0 * 470.0,
            velocity: [0.0; 2],
            depth: 3.15 * A,
            stretch: 1.0,
        };
        let unit = body.diffusivity() / A;
        body.velocity = peclet.map(|p| p * unit);
        let speed = body.velocity.iter().fold(0.0_f64, |m, u| m.max(u.abs()));
        Below::new(grid, body, A, speed)
    }

    /// Heat q e^{−r²/s²} with s half a half-width.
    const WIDTH: f64 = 0.5 * A;
    const HEAT: f64 = 1e7;

    fn bell(grid: &Grid) -> Vec<f64> {
        let heat = grid.nodes().map(|[i, j]| {
            let [x, y] = grid.place(i, j).map(|x| x * A / WIDTH);
            HEAT * (-x * x - y * y).exp()
        });
        heat.collect()
    }

    /// The remaining bell at x after a time, of a body that moves with u.
    fn bell_after(body: &MovingBody, [x, u]: [f64; 2], time: f64) -> f64 {
        let wide = WIDTH * WIDTH + 4.0 * body.diffusivity() * time;
        WIDTH * WIDTH / wide * (-(x - u * time).powi(2) / wide).exp()
    }

    fn largest(values: &[f64]) -> f64 {
        values.iter().fold(0.0, |m, v| m.max(v.abs()))
    }

    /// A thin insulating coating below a good conductor, and a liner.
    fn stacks() -> [Vec<HeatLayer>; 2] {
        [
            vec![
                HeatLayer::new(1e-6, 100.0, 3e6),
                HeatLayer::new(3e-6, 1.0, 2e6),
            ],
            vec![HeatLayer::new(1e-4, 0.25, 2e6)],
        ]
    }

    /// A body in steady state has the steady rise, computed as a sum over time; so has one that is heated for a long time. Bodies that
    /// move along and across, fast and slowly, or not at all: heat that spreads far beyond this small grid re-enters at the other side, by 1 % at most.
    #[test]
    fn for_ever_is_steady() {
        let [coats, liner] = stacks();
        for (peclet, half, layers, most) in [
            ([0.0, 0.0], false, &[][..], 0.015),
            ([2.0, 0.0], true, &[], 0.015),
            ([100.0, 0.0], true, &[], 0.003),
            ([-100.0, 0.0], true, &[], 0.003),
            ([20.0, 30.0], false, &[], 0.003),
            ([0.0, 0.0], false, &coats, 0.015),
            ([0.0, 0.0], false, &liner, 0.015),
            // Modes spread along the surface as their heat does on average.
            ([100.0, 0.0], true, &coats, 0.015),
            ([20.0, 30.0], false, &coats, 0.03),
            ([100.0, 0.0], true, &liner, 0.003),
        ] {
            let grid = grid(half);
            let below = below_layers(&grid, peclet, layers.to_vec());
            let heat = bell(&grid);
            let steady = Spreading::new(&grid, &below.body, A, 0.0).apply(&heat);
            let differs = |own: &[f64]| {
                let errors: Vec<f64> = own.iter().zip(&steady).map(|(a, b)| a - b).collect();
                largest(&errors) / largest(&steady)
            };
            let own = below.rise(&below.settled(&heat));
            assert!(differs(&own) < most, "{peclet:?}: {}", differs(&own));
            // A step of two minutes after rest without heat.
            let over = Over::new(&below, 120.0, below.body.velocity);
            let carried = over.carried(&below.cold(grid.n_nodes()));
            let after = below.rise(&over.remembered(carried, &heat));
            assert!(differs(&after) < most, "{peclet:?}: {}", differs(&after));
        }
    }

    /// The same below a roller whose load falls towards its ends: heat spreads along its axis, too.
    #[test]
    fn for_ever_is_steady_along_a_roller() {
        let places = (-18..=18).map(|j| f64::from(j) / 16.0).collect();
        let rows = Rows::at(places, false);
        let grid = Grid::of_roller([-32, 32], CELL, rows, 18, false);
        let below = below(&grid, [20.0, 0.0]);
        let heat = bell(&grid);
        let steady = Spreading::new(&grid, &below.body, A, 0.0).apply(&heat);
        let own = below.rise(&below.settled(&heat));
        for [i, j] in grid.nodes().filter(|[_, j]| (2..=34).contains(j)) {
            let k = grid.index(i, j);
            let size = largest(&steady);
            assert!(
                (own[k] - steady[k]).abs() < 0.01 * size,
                "{i} {j}: {} {}",
                own[k],
                steady[k]
            );
        }
    }

    /// Many short steps leave a steady state unchanged, even where heat comes in at the upstream edge.
    #[test]
    fn short_steps_keep_what_is_steady() {
        let grid = grid(true);
        let below = below(&grid, [60.0, 0.0]);
        let heat: Vec<f64> = bell(&grid).iter().map(|q| q + 0.1 * HEAT).collect();
        let mut memory = below.settled(&heat);
        let start = below.rise(&memory);
        let u = below.body.velocity[0];
        for _ in 0..40 {
            let over = Over::new(&below, 0.1 * A / u, [u, 0.0]);
            memory = over.remembered(over.carried(&memory), &heat);
        }
        let end = below.rise(&memory);
        let size = largest(&start);
        let [_, j] = grid.centre();
        for i in 0..grid.n[0] {
            let [start, end] = [&start, &end].map(|rise| rise[grid.index(i, j)]);
            assert!((start - end).abs() < 0.01 * size, "{i}: {start} {end}");
        }
    }

    /// Heat from some time on, while the body moves: T = q/ρc ∫_0^t s²/(s² + 4χτ) e^{−(x − uτ)²/(s² + 4χτ)} dτ/√(πχτ), instantaneous sources that spread
    /// (Carslaw and Jaeger 1959, section 10.2), summed here independently. Steps of any lengths give it, and the responses of the steps add up to it.
    #[test]
    fn heat_from_some_time_on() {
        let grid = grid(false);
        let heat = bell(&grid);
        for peclet in [0.0, 40.0] {
            let below = below(&grid, [peclet, 0.0]);
            let (body, u) = (&below.body, below.body.velocity[0]);
            let chi = body.diffusivity();
            // A half-width of way, or what heat spreads over.
            let unit = if u > 0.0 { A / u } else { 0.2 * A * A / chi };
            let exact = |x: f64, t: f64| {
                let n = 20_000;
                let step = t.sqrt() / f64::from(n);
                let sum: f64 = (0..n)
                    .map(|k| ((f64::from(k) + 0.5) * step).powi(2))
                    .map(|time| bell_after(body, [x, u], time))
                    .sum();
                2.0 * HEAT * step * sum / (body.capacity * (PI * chi).sqrt())
            };
            let mut memory = below.cold(grid.n_nodes());
            memory.flux = heat.clone();
            let mut time = 0.0;
            for share in [0.05, 0.3, 0.01, 0.5] {
                let over = Over::new(&below, share * unit, body.velocity);
                let carried = over.carried(&memory);
                let mut parts = over.rise(&carried);
                let by_new = over.spreading().apply(&heat);
                (parts.iter_mut().zip(by_new)).for_each(|(sum, t)| *sum += t);
                memory = over.remembered(carried, &heat);
                time += share * unit;
                let rise = below.rise(&memory);
                let [i, j] = grid.centre();
                let size = exact(0.0, time);
                for k in -6..=12 {
                    let at = grid.index((i as i64 + k) as usize, j);
                    let exact = exact(k as f64 * CELL * A, time);
                    let error = (rise[at] - exact).abs() / size;
                    assert!(error < 0.005, "{peclet} {share} {k}: {} {exact}", rise[at]);
                    assert_relative_eq!(parts[at], rise[at], max_relative = 1e-6);
                }
            }
        }
    }

    /// Without further heating the stored heat moves with the body; after the whole grid has passed none remains, and none re-enters at the other side.
    #[test]
    fn heat_leaves_with_the_body() {
        let grid = grid(true);
        let below = below(&grid, [200.0, 0.0]);
        let mut memory = below.settled(&bell(&grid));
        let none = vec![0.0; grid.n_nodes()];
        let (body, u) = (&below.body, below.body.velocity[0]);
        let start = largest(&below.rise(&memory));
        // The remaining temperature of heating that ended some time ago.
        let exact = |x: f64, ago: f64| {
            let [first, last] = [ago, 40.0 * A / u].map(f64::sqrt);
            let n = 20_000;
            let step = (last - first) / f64::from(n);
            let sum: f64 = (0..n)
                .map(|k| (first + (f64::from(k) + 0.5) * step).powi(2))
                .map(|time| bell_after(body, [x, u], time))
                .sum();
            2.0 * HEAT * step * sum / (body.capacity * (PI * body.diffusivity()).sqrt())
        };
        let mut step = |share: f64| {
            let over = Over::new(&below, share * A / u, [u, 0.0]);
            memory = over.remembered(over.carried(&memory), &none);
            below.rise(&memory)
        };
        // The heat falls to zero within the first step.
        step(0.01);
        let rise = step(0.5);
        let [i, j] = grid.centre();
        for k in -16..=24 {
            let found = rise[grid.index((i as i64 + k) as usize, j)];
            let exact = exact(k as f64 * CELL * A, 0.505 * A / u);
            assert!((found - exact).abs() < 0.01 * start, "{k}: {found} {exact}");
        }
        let remaining = largest(&step(3.4));
        assert!(remaining < 0.01 * start, "{}", remaining / start);
    }
}
