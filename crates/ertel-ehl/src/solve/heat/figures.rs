//! Temperatures of film and walls in a few numbers.

use super::space::HeatSpace;
use crate::engine::heat::walls;
use crate::solve::system::State;

/// A temperature in K with its place in half-widths.
pub type Extreme = (f64, [f64; 2]);

/// Heights at which the film's temperature is searched for its extremes, in addition to its nodes.
const N_HEIGHTS: usize = 64;

/// Extreme temperatures over the nodes of the contact area.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extremes {
    /// Largest of the film.
    pub film_maximum: Extreme,
    /// Smallest of the film.
    pub film_lowest: Extreme,
    /// Largest of the surfaces of plane and ball.
    pub walls: [Extreme; 2],
}

impl Extremes {
    /// Searches the nodes of a heat space.
    pub fn new(space: &HeatSpace, state: &State) -> Extremes {
        let (column, film) = (&space.column, &space.column.film);
        let lowest = (f64::NEG_INFINITY, [0.0; 2]);
        let mut extremes = Extremes {
            film_maximum: lowest,
            film_lowest: (f64::INFINITY, [0.0; 2]),
            walls: [lowest; 2],
        };
        for (node, point) in space.surface.points.iter().enumerate() {
            let values = column.film_of(&state.temperature[node * column.n()..][..column.n()]);
            // no minus zero
            let at = [point[0], point[1] + 0.0];
            let through = film.through(&values);
            let between = (0..=N_HEIGHTS).map(|k| through.at(k as f64 / N_HEIGHTS as f64 - 0.5));
            let (low, high) = between
                .chain(values[..film.n()].iter().copied())
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), t| {
                    (l.min(t), h.max(t))
                });
            if high > extremes.film_maximum.0 {
                extremes.film_maximum = (high, at);
            }
            if low < extremes.film_lowest.0 {
                extremes.film_lowest = (low, at);
            }
            for (wall, value) in extremes.walls.iter_mut().zip(walls(film, &values)) {
                if value > wall.0 {
                    *wall = (value, at);
                }
            }
        }
        extremes
    }
}
