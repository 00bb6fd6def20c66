//! Oil and asperities at a node between rough surfaces.
//!
//! ```text
//!   P = p + p_a(H),   g = g(H)                 p: P of the oil, g: the gap that flows
//!   δp = δP − p_a' δH + r,   δg = g' δH        r = P − p_a(H) − p, zero at a solution
//! ```
//! p is a variable of Newton's method like P, tied to it by a linearised equation: it stays positive however steep p_a is. Where the film has
//! cavitated p = 0, and the asperities bear all of P.
//!
//! Theory: Mixed lubrication.

use rayon::prelude::*;

use super::system::{Linearised, State, System};
use crate::forms::energy::Heat;

/// Nodes that a thread takes at a time.
const BATCH: usize = 1024;

/// What asperities bear at a node.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Touch {
    /// p_a and its derivative by H.
    pub pressure: [f64; 2],
    /// g and its derivative by H.
    pub gap: [f64; 2],
    /// r.
    pub slack: f64,
}

impl Touch {
    /// δp without r.
    #[inline]
    pub fn change_of_oil(&self, pressure: f64, film: f64) -> f64 {
        pressure - self.pressure[1] * film
    }
}

impl System {
    /// The gap that flows at a distance H.
    #[inline]
    pub fn gap_at(&self, film: f64) -> f64 {
        self.rough.as_ref().map_or(film, |rough| rough.gap(film)[0])
    }

    /// Asperities at all nodes; none between smooth surfaces. Where the pressures are given, their parts are, too.
    pub(super) fn touching(&self, state: &State, films: &[f64]) -> Vec<Touch> {
        let Some(rough) = &self.rough else {
            return Vec::new();
        };
        let [nx, _] = self.grid.n;
        let of_node = |k: usize| {
            let gap = rough.gap(films[k]);
            if !self.grid.is_unknown(k % nx, k / nx) {
                return Touch {
                    gap,
                    ..Touch::default()
                };
            }
            let pressure = rough.pressure(films[k]);
            Touch {
                pressure,
                gap,
                slack: state.pressure[k] - pressure[0] - state.oil()[k],
            }
        };
        let nodes = (0..films.len()).into_par_iter().with_min_len(BATCH);
        nodes.map(of_node).collect()
    }

    /// The gap that flows at all nodes.
    pub fn gaps(&self, state: &State) -> Vec<f64> {
        let mut gaps = self.films(state);
        gaps.iter_mut().for_each(|gap| *gap = self.gap_at(*gap));
        gaps
    }

    /// Heat of the friction of asperities at all nodes, W/m², half of it at each surface; none without asperities that rub.
    pub fn rubbing(&self, state: &State, heat: &Heat) -> Vec<f64> {
        let boundary = self
            .rough
            .as_ref()
            .and_then(|rough| rough.boundary_friction);
        let (Some(boundary), false) = (boundary, self.fluid.slide().is_zero()) else {
            return Vec::new();
        };
        // Δu = Ω-speed a p_h/R h/μ, as in the friction of the film.
        let speed = heat.pressure * heat.film.powi(2) / (heat.length * heat.viscosity);
        let parts = self
            .grid
            .nodes()
            .zip(state.pressure.iter().zip(state.oil()));
        parts
            .map(|([i, j], (pressure, oil))| {
                let [u, v] = self.fluid.slide().at(self.grid.place(i, j));
                boundary * (pressure - oil) * heat.pressure * speed * u.hypot(v)
            })
            .collect()
    }

    /// Gives the oil the part of the pressures that asperities leave, where the film is wetted.
    pub fn settle(&self, state: &mut State) {
        let Some(rough) = &self.rough else {
            return;
        };
        let films = self.films(state);
        let grid = &self.grid;
        state.oil = (grid
            .nodes()
            .zip(state.pressure.iter().zip(&films))
            .enumerate())
        .map(|(k, ([i, j], (p, film)))| match state.wetted[k] {
            _ if !grid.is_unknown(i, j) => state.oil.get(k).copied().unwrap_or(*p),
            true => (p - rough.pressure(*film)[0]).max(0.0),
            false => 0.0,
        })
        .collect();
    }
}

impl Linearised {
    /// Changes of the pressures of the oil and of the gaps that flow by those of P and H; `None` between smooth surfaces, where they are these.
    pub(super) fn parts(&self, pressure: &[f64], film: &[f64]) -> Option<[Vec<f64>; 2]> {
        if self.touching.is_empty() {
            return None;
        }
        let both = || self.touching.iter().zip(pressure.iter().zip(film));
        Some([
            both()
                .map(|(of, (p, h))| of.change_of_oil(*p, *h))
                .collect(),
            both().map(|(of, (_, h))| of.gap[1] * h).collect(),
        ])
    }

    /// r at a node.
    pub(super) fn slack_at(&self, k: usize) -> f64 {
        self.touching.get(k).map_or(0.0, |of| of.slack)
    }

    /// r at all nodes with pressure unknown; `None` between smooth surfaces.
    pub(super) fn slack(&self) -> Option<Vec<f64>> {
        (!self.touching.is_empty()).then(|| self.touching.iter().map(|of| of.slack).collect())
    }
}
