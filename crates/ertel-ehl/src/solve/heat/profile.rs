//! Temperatures of a state, and film quantities of the energy equation, at points of the contact area.

use super::space::HeatSpace;
use crate::film::{MOST_NODES, TemperatureProfile};
use crate::forms::energy::FilmPlace;
use crate::solve::discretisation::Discretisation;
use crate::solve::points::fields_from;
use crate::solve::state::State;
use crate::solve::streams::Streams;

impl HeatSpace {
    /// Film quantities of the energy equation at a point of its quadrature rule.
    pub fn film_at(
        &self,
        d: &Discretisation,
        state: &State,
        streams: Option<&Streams>,
        (cell, q): (usize, usize),
    ) -> FilmPlace {
        let [pressure, deflection] = &self.film_tables;
        let mut fields = fields_from(d, state, cell, q, [pressure, deflection]);
        fields.missing += streams.map_or(0.0, |streams| streams.missing(&fields));
        let n = self.table.n_nodes;
        let mut temperature = [0.0; MOST_NODES];
        for (j, node) in self.surface.nodes_of(cell).iter().enumerate() {
            let value = self.table.values[q * n + j];
            let column = &state.temperature[*node as usize * self.column.n()..];
            for (sum, t) in temperature
                .iter_mut()
                .zip(&column[self.column.film_range()])
            {
                *sum += value * t;
            }
        }
        FilmPlace {
            at: fields.place,
            pressure: fields.pressure,
            pressure_rate: 0.0,
            pressure_gradient: fields.pressure_gradient,
            film: fields.film,
            filling: fields.filling(),
            temperature,
            held_conductance: None,
        }
    }

    /// Temperature across the film at a point of the film equations' rule.
    pub fn profile_at(
        &self,
        d: &Discretisation,
        state: &State,
        cell: usize,
        q: usize,
    ) -> TemperatureProfile {
        let n = self.film_table.n_nodes;
        self.profile(d, state, cell, |j| {
            (
                self.film_table.values[q * n + j],
                self.film_table.gradients[q * n + j],
            )
        })
    }

    /// The same at reference coordinates of an element.
    pub fn profile_in(
        &self,
        d: &Discretisation,
        state: &State,
        cell: usize,
        xi: [f64; 3],
    ) -> TemperatureProfile {
        let basis: Vec<_> = self.surface.element.gradients(xi).collect();
        self.profile(d, state, cell, |j| basis[j])
    }

    fn profile(
        &self,
        d: &Discretisation,
        state: &State,
        cell: usize,
        basis: impl Fn(usize) -> (f64, [f64; 3]),
    ) -> TemperatureProfile {
        let mut profile = TemperatureProfile::default();
        let (range, n) = (self.column.film_range(), self.column.n());
        for (j, node) in self.surface.nodes_of(cell).iter().enumerate() {
            let (value, gradient) = basis(j);
            let [gx, gy, _] = d.contact.maps[cell].gradient(gradient);
            let film = &state.temperature[*node as usize * n..][range.clone()];
            for (m, t) in film.iter().enumerate().take(MOST_NODES) {
                profile.temperature[m] += value * t;
                profile.slopes[0][m] += gx * t;
                profile.slopes[1][m] += gy * t;
            }
        }
        profile
    }

    /// Temperatures of the column at reference coordinates of an element.
    pub fn column_in(&self, state: &State, cell: usize, xi: [f64; 3]) -> Vec<f64> {
        let n = self.column.n();
        let mut column = vec![0.0; n];
        let basis = self.surface.element.values(xi);
        for (value, node) in basis.zip(self.surface.nodes_of(cell)) {
            let at_node = &state.temperature[*node as usize * n..][..n];
            for (sum, t) in column.iter_mut().zip(at_node) {
                *sum += value * t;
            }
        }
        column
    }
}
