//! Modes of the temperature below the surface of a body, each with a rate at which it decays.
//!
//! ```text
//!   one material to the depth D:        μ_n = (n + ½)π/D,  w_n = 2/D                      (Carslaw and Jaeger 1959, section 3.8)
//!   many of them as one:                Σ_n 2/D g(μ_n) ≈ 2/π ∫ g(μ) dμ                    by Gauss's rule in ln μ
//!   layers ([`crate::layers`]):         Z(iω) ≈ (Σ_j w_j/(iω + λ_j) + w_∞)/ρc             λ_j a geometric series, w_j by least squares
//! ```
//! The heat of a mode spreads along the surface with the mean χ of the heat that is 1/λ old.
//!
//! Theory: Heat in time.

use std::f64::consts::PI;

use ertel_fem::quadrature::Quadrature;
use nalgebra::{DMatrix, DVector};
use realfft::num_complex::Complex64;

use super::source::MovingBody;
use crate::layers::HeatedBody;

/// A part of the temperature below the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Mode {
    /// χμ², 1/s.
    pub(super) rate: f64,
    /// w, 1/m.
    pub(super) weight: f64,
    /// χ along the surface over the smallest of all modes, m²/s.
    pub(super) spread: f64,
}

/// Modes that represent the temperature below the surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Modes {
    /// The slowest one first.
    pub(super) each: Vec<Mode>,
    /// Smallest χ along the surface, m²/s.
    pub(super) diffusivity: f64,
    /// Σ w/(χμ²) of those that are not among them, s/m.
    pub(super) at_once: f64,
}

/// Number of exact modes, and the range of μ, as a ratio, that each following mode represents.
const EXACT: usize = 4;
const RATIO: f64 = 4.0;

/// Rate of the fastest mode over that at which a cell passes or heat spreads over it.
const FASTEST: f64 = 10.0;

/// Ratio of the rates of neighbouring modes of a body with layers, and values per mode of the least squares.
const RATE_RATIO: f64 = 1.75;
const VALUES: usize = 3;
/// Modes faster than needed, so that all others are free of what the fastest ones lack.
const FASTER: usize = 4;
/// Singular values below this share of the largest are left out: weights stay small.
const SMALLEST: f64 = 1e-12;

impl Modes {
    /// Of a body below cells of a size, m, that moves at a speed at most, m/s.
    pub fn new(body: &MovingBody, cell: [f64; 2], speed: f64) -> Modes {
        let smallest = cell[0].min(cell[1]);
        let needed = |chi: f64| FASTEST * (speed / smallest).max(chi / (smallest * smallest));
        match body.heated() {
            Some(heated) => {
                let [_, fast] = heated.diffusivities();
                Modes::of_layers(&heated, body.capacity, needed(fast))
            }
            None => Modes::of_one_material(body, needed(body.diffusivity())),
        }
    }

    fn of_one_material(body: &MovingBody, needed: f64) -> Modes {
        let (chi, depth) = (body.diffusivity(), body.depth);
        let mode = |mu: f64, weight: f64| Mode {
            rate: chi * mu * mu,
            weight,
            spread: 0.0,
        };
        let mut each: Vec<Mode> = (0..EXACT)
            .map(|n| mode((n as f64 + 0.5) * PI / depth, 2.0 / depth))
            .collect();
        let rule = Quadrature::simplex(1, 5);
        let mut low = EXACT as f64 * PI / depth;
        while chi * low * low < needed {
            for (x, weight) in rule.points.iter().zip(&rule.weights) {
                let mu = low * RATIO.powf(x[0]);
                each.push(mode(mu, 2.0 / PI * mu * RATIO.ln() * weight));
            }
            low *= RATIO;
        }
        Modes {
            each,
            diffusivity: chi,
            at_once: 2.0 / (PI * chi * low),
        }
    }

    /// Z(iω) ≈ (Σ w_j/(iω + λ_j) + w_∞)/ρc by least squares of the relative errors.
    fn of_layers(body: &HeatedBody, capacity: f64, needed: f64) -> Modes {
        let [_, decay] = body.times();
        let rate = |j: f64| RATE_RATIO.powf(j) / decay;
        let needed = ((needed * decay).ln() / RATE_RATIO.ln()).ceil().max(1.0) as usize;
        let count = needed + FASTER;
        let values = VALUES * (needed + 2);
        // Periodic heat, from steady to as fast as needed: that which only grows leaves the weights undetermined.
        let s = |i: usize| match i / 2 {
            0 => Complex64::default(),
            i => Complex64::new(0.0, rate(i as f64 / VALUES as f64 - 2.0)),
        };
        let part = |i: usize, value: Complex64| {
            if i.is_multiple_of(2) {
                value.re
            } else {
                value.im
            }
        };
        let response = |i: usize| capacity * body.impedance(Complex64::default(), s(i));
        let matrix = DMatrix::from_fn(2 * values, count + 1, |i, j| {
            let mode = match j == count {
                true => Complex64::from(1.0),
                false => 1.0 / (s(i) + rate(j as f64)),
            };
            part(i, mode / response(i))
        });
        let wanted = DVector::from_fn(2 * values, |i, _| part(i, Complex64::from(1.0)));
        let svd = matrix.svd(true, true);
        let least = SMALLEST * svd.singular_values.max();
        let weights = (svd.solve(&wanted, least)).expect("both factors were computed");
        let [slow, _] = body.diffusivities();
        let mode = |j: usize| {
            let rate = rate(j as f64);
            let mean: f64 = body
                .pulse(1.0 / rate)
                .spread
                .iter()
                .map(|[p, v]| p * v * rate)
                .sum();
            Mode {
                rate,
                weight: weights[j],
                spread: mean - slow,
            }
        };
        Modes {
            each: (0..count).map(mode).collect(),
            diffusivity: slow,
            at_once: weights[count],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layers::HeatLayer;

    /// Modes of bodies with layers respond to periodic heat like the layers, up to frequencies at which a surface passes the cells.
    #[test]
    fn modes_of_layers() {
        let (cell, speed) = (6e-6, 12.0);
        for layers in [
            vec![
                HeatLayer::new(1e-6, 100.0, 3e6),
                HeatLayer::new(3e-6, 1.0, 2e6),
            ],
            vec![HeatLayer::new(1e-4, 0.25, 2e6)],
        ] {
            let body = MovingBody {
                layers,
                conductivity: 46.0,
                capacity: 7850.0 * 470.0,
                velocity: [speed, 0.0],
                depth: 3e-4,
                stretch: 1.0,
            };
            let modes = Modes::new(&body, [cell; 2], speed);
            let heated = body.heated().unwrap();
            for i in 0..60 {
                let omega = PI * speed / cell * 1e-6_f64.powf(f64::from(i) / 59.0);
                let s = Complex64::new(0.0, omega);
                let sum: Complex64 = (modes.each.iter())
                    .map(|mode| mode.weight / (s + mode.rate))
                    .sum();
                let own = (sum + modes.at_once) / body.capacity;
                let exact = heated.impedance(Complex64::default(), s);
                let error = (own - exact).norm() / exact.norm();
                assert!(error < 5e-4, "{:?} {omega}: {error}", body.layers);
            }
        }
    }
}
