//! Heat made and carried off.
//!
//! ```text
//!   made:      ∫ h(Q_shear + Q_comp) dA
//!   bodies:    ∫∫ ρc u·∇T dz dA + what is conducted out where temperatures are prescribed
//!   film:      ∮ h∫ρc u·n (T − T_inlet) ds dl   round the area where the film is whole, and what the energy
//!              equation lets it take up beyond
//! ```
//! The film is whole where it is under pressure. Where it has broken into streaks, its thickness does not say how much
//! lubricant flows.

use super::sides::{Side, SideRule, outer_sides};
use super::space::HeatSpace;
use super::system::{Kept, assemble};
use crate::contact::Scales;
use crate::engine::PointFields;
use crate::engine::heat::HeatSums;
use crate::film::FilmFluid;
use crate::film::cross_film::CrossFilm;
use crate::forms::energy::{FilmColumn, Heat, film_column};
use crate::solve::discretisation::Discretisation;
use crate::solve::points::fields_in;
use crate::solve::state::State;
use crate::solve::streams::Streams;
use crate::solve::tuning::heat::PRESSED;

/// Heat made and carried off.
pub fn heat_balance(
    d: &Discretisation,
    state: &State,
    fluid: &FilmFluid,
    heat: &Heat,
    scales: &Scales,
) -> HeatSums {
    let streams = Streams::new(d, state, &heat.mean_velocity());
    let unlifted = Kept {
        streams: Some(&streams),
        ..Kept::default()
    };
    let unlifted = assemble(d, fluid, heat, state, None, unlifted, None);
    let kept = Kept {
        cross_flow: &unlifted.cross_flow,
        streams: Some(&streams),
        ..Kept::default()
    };
    let system = assemble(d, fluid, heat, state, None, kept, None);
    let account = system.account;
    let scale = scales.area(&d.contact.shape);
    HeatSums {
        shear: scale * account.shear,
        compression: scale * account.compression,
        compression_size: scale * account.compression_size,
        to_bodies: [0, 1].map(|b| scale * (account.bodies[b] + account.conducted[b])),
        by_film: scale * carried_by_film(d, (state, &streams), fluid, heat, &system.taken_up),
    }
}

/// Heat that the lubricant carries off, W/m² times half-widths squared; `taken_up` by each element.
fn carried_by_film(
    d: &Discretisation,
    (state, streams): (&State, &Streams),
    fluid: &FilmFluid,
    heat: &Heat,
    taken_up: &[f64],
) -> f64 {
    let Some(space) = d.heat.as_deref() else {
        return 0.0;
    };
    let mut film = Film {
        d,
        space,
        state,
        streams,
        fluid,
        heat,
        rule: CrossFilm::default(),
    };
    let whole: Vec<bool> = (0..d.contact.n_elements())
        .map(|c| film.is_whole(c))
        .collect();
    let beyond = taken_up.iter().zip(&whole).filter(|(_, whole)| !**whole);
    let mut carried: f64 = beyond.map(|(taken_up, _)| taken_up).sum();
    for side in outer_sides(&d.contact, |c| whole[c]) {
        carried += film.through(side);
    }
    carried
}

/// Evaluates the film's heat.
struct Film<'a> {
    d: &'a Discretisation,
    space: &'a HeatSpace,
    state: &'a State,
    streams: &'a Streams,
    fluid: &'a FilmFluid,
    heat: &'a Heat,
    rule: CrossFilm,
}

impl Film<'_> {
    fn column(&mut self, fields: &PointFields) -> FilmColumn {
        let heights = &self.space.column.heights;
        let place = fields.film_place();
        film_column(self.fluid, self.heat, heights, &place, &mut self.rule)
    }

    /// Whether an element is under pressure.
    fn is_whole(&self, c: usize) -> bool {
        let mut nodes = self.d.pressure.nodes_of(c).iter();
        nodes.any(|n| self.state.pressure[*n as usize] > PRESSED)
    }

    /// ∫ h∫ρc u·n (T − T_inlet) ds dl over a side of an element.
    fn through(&mut self, side: Side) -> f64 {
        let heights = &self.space.column.heights;
        let SideRule { normal, points } = SideRule::new(&self.d.contact, side);
        let edge = self.space.edges.binary_search(&side).is_ok();
        let order = self.space.column.film.n() - 1;
        let mut sum = 0.0;
        for (xi, weight) in points {
            let mut fields = fields_in(self.d, self.state, side.0, xi);
            fields.missing += self.streams.missing(&fields);
            let column = self.column(&fields);
            for (k, w) in heights.weights().iter().enumerate() {
                let point = &column.heights[k];
                let out = point.velocity[0] * normal[0] + point.velocity[1] * normal[1];
                let temperature = match edge && out < 0.0 {
                    true => self.heat.entering(heights.points()[k], order),
                    false => point.temperature,
                };
                let rise = temperature - self.heat.inlet_temperature;
                sum += weight * w * point.capacity * out * rise;
            }
        }
        sum
    }
}
