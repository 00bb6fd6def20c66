//! Heat made and carried off.
//!
//! ```text
//!   made:      ∫ h(Q_shear + Q_comp) dA
//!   bodies:    ∫∫ ρc u ∂T/∂x dz dA + what is conducted out where temperatures are prescribed
//!   film:      ∮ h∫ρc u·n (T − T_inlet) ds dl   round the area where the film is whole, and what the energy
//!              equation lets it take up beyond
//! ```
//! The film is whole where it is under pressure. Where it has broken into streaks, its thickness does not say how much
//! lubricant flows.

use std::collections::HashMap;

use super::space::HeatSpace;
use super::system::{Kept, assemble};
use crate::contact::Scales;
use crate::film::FilmFluid;
use crate::film::cross_film::CrossFilm;
use crate::forms::energy::{FilmColumn, FilmPlace, Heat, film_column};
use crate::solve::discretisation::Discretisation;
use crate::solve::evaluate::{PointFields, fields_in};
use crate::solve::system::State;

/// Pressure over p_h above which an element belongs to the area under pressure.
const PRESSED: f64 = 1e-8;

/// Heat of the whole contact: W (circular) or W/m (line).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Balance {
    /// Made by shear.
    pub shear: f64,
    /// Made by compression, less what expansion takes.
    pub compression: f64,
    /// Carried off by the plane.
    pub to_plane: f64,
    /// Carried off by the ball.
    pub to_ball: f64,
    /// Carried off by the lubricant.
    pub by_film: f64,
    /// (made − carried off)/(heat of shear + size of the heat of compression).
    pub error: f64,
}

/// Heat made and carried off.
pub fn heat_balance(
    d: &Discretisation,
    state: &State,
    fluid: &FilmFluid,
    heat: &Heat,
    scales: &Scales,
) -> Balance {
    let unlifted = assemble(d, fluid, heat, state, None, Kept::default(), None);
    let kept = Kept {
        cross_flow: &unlifted.cross_flow,
        ..Kept::default()
    };
    let system = assemble(d, fluid, heat, state, None, kept, None);
    let account = system.account;
    let scale = scales.area(&d.contact.shape);
    let [to_plane, to_ball] = [0, 1].map(|b| scale * (account.bodies[b] + account.conducted[b]));
    let by_film = scale * carried_by_film(d, state, fluid, heat, &system.taken_up);
    let (shear, compression) = (scale * account.shear, scale * account.compression);
    let size = shear + scale * account.compression_size;
    let lost = shear + compression - to_plane - to_ball - by_film;
    Balance {
        shear,
        compression,
        to_plane,
        to_ball,
        by_film,
        // Nothing is out of balance where there is no heat.
        error: if size > 0.0 { lost / size } else { 0.0 },
    }
}

/// Heat that the lubricant carries off, W/m² times half-widths squared; `taken_up` by each element.
fn carried_by_film(
    d: &Discretisation,
    state: &State,
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
        fluid,
        heat,
        rule: CrossFilm::default(),
    };
    let whole: Vec<bool> = (0..d.contact.n_elements())
        .map(|c| film.is_whole(c))
        .collect();
    let beyond = taken_up.iter().zip(&whole).filter(|(_, whole)| !**whole);
    let mut carried: f64 = beyond.map(|(taken_up, _)| taken_up).sum();
    for (c, side) in outer_sides(d, &whole) {
        carried += film.through(c, side);
    }
    carried
}

/// Sides of the elements of a set that no other element of it shares, by element and opposite corner; those on
/// the symmetry plane left out.
fn outer_sides(d: &Discretisation, set: &[bool]) -> Vec<(usize, usize)> {
    let surface = &d.contact.surface;
    let mut sides: HashMap<Vec<u32>, (usize, usize, usize)> = HashMap::new();
    for c in (0..set.len()).filter(|c| set[*c]) {
        let corners = surface.cell(c);
        for opposite in 0..corners.len() {
            let mut side: Vec<u32> = (0..corners.len())
                .filter(|k| *k != opposite)
                .map(|k| corners[k])
                .collect();
            side.sort_unstable();
            sides.entry(side).or_insert((0, c, opposite)).0 += 1;
        }
    }
    let on_symmetry = |side: &[u32]| {
        let mut points = side.iter().map(|v| surface.vertices[*v as usize]);
        surface.dim == 2 && points.all(|p| p[1].abs() < 1e-12)
    };
    let mut outer: Vec<(usize, usize)> = sides
        .into_iter()
        .filter(|(side, (count, _, _))| *count == 1 && !on_symmetry(side))
        .map(|(_, (_, c, opposite))| (c, opposite))
        .collect();
    // The sum shall not depend on the order of a hash map.
    outer.sort_unstable();
    outer
}

/// Evaluates the film's heat.
struct Film<'a> {
    d: &'a Discretisation,
    space: &'a HeatSpace,
    state: &'a State,
    fluid: &'a FilmFluid,
    heat: &'a Heat,
    rule: CrossFilm,
}

impl Film<'_> {
    fn column(&mut self, fields: &PointFields) -> FilmColumn {
        let heights = &self.space.column.heights;
        let place = FilmPlace {
            pressure: fields.pressure,
            pressure_gradient: fields.pressure_gradient,
            film: fields.film,
            temperature: fields.temperature.unwrap_or_default().temperature,
            held_conductance: None,
        };
        film_column(self.fluid, self.heat, heights, &place, &mut self.rule)
    }

    /// Whether an element is under pressure.
    fn is_whole(&self, c: usize) -> bool {
        let mut nodes = self.d.pressure.nodes_of(c).iter();
        nodes.any(|n| self.state.pressure[*n as usize] > PRESSED)
    }

    /// ∫ h∫ρc u·n (T − T_inlet) ds dl over the side of an element opposite to a corner.
    fn through(&mut self, c: usize, opposite: usize) -> f64 {
        let heights = &self.space.column.heights;
        let contact = &self.d.contact;
        let corner =
            |k: usize| -> [f64; 3] { std::array::from_fn(|i| if i + 1 == k { 1.0 } else { 0.0 }) };
        let place = |k: usize| contact.point(c, corner(k));
        let ends: Vec<usize> = (0..contact.surface.cell(c).len())
            .filter(|k| *k != opposite)
            .collect();
        // Normal with the size of the side, away from the opposite corner.
        let (first, away) = (place(ends[0]), place(opposite));
        let mut normal = match ends[..] {
            [_, b] => {
                let last = place(b);
                [last[1] - first[1], first[0] - last[0]]
            }
            _ => [1.0, 0.0],
        };
        let outward = normal[0] * (first[0] - away[0]) + normal[1] * (first[1] - away[1]);
        if outward < 0.0 {
            normal = normal.map(|n| -n);
        }
        let shift = 0.5 * 0.6_f64.sqrt();
        let points: &[(f64, f64)] = match ends.len() {
            1 => &[(0.0, 1.0)],
            _ => &[
                (0.5 - shift, 5.0 / 18.0),
                (0.5, 8.0 / 18.0),
                (0.5 + shift, 5.0 / 18.0),
            ],
        };
        let mut sum = 0.0;
        for (t, weight) in points {
            let (from, to) = (corner(ends[0]), corner(*ends.last().unwrap_or(&0)));
            let xi = std::array::from_fn(|i| from[i] + t * (to[i] - from[i]));
            let column = self.column(&fields_in(self.d, self.state, c, xi));
            for (k, w) in heights.weights().iter().enumerate() {
                let point = &column.heights[k];
                let out = point.velocity[0] * normal[0] + point.velocity[1] * normal[1];
                let rise = point.temperature - self.heat.inlet_temperature;
                sum += weight * w * point.capacity * out * rise;
            }
        }
        sum
    }
}
