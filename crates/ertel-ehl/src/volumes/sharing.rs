//! How oil and asperities share a pressure, and the heat of the asperities.

use super::system::{State, System};
use crate::forms::energy::Heat;

impl System {
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
