//! Temperatures of film and walls, and the heat of a contact, in a few numbers.

use super::{PointTable, Problem};
use crate::film::{FilmNodes, Nodal};
use crate::solution::{Figure, Figures, Reading};

/// A temperature in K with its place in half-widths.
pub type Extreme = (f64, [f64; 2]);

/// Heights at which the film's temperature is searched for its extremes, in addition to its nodes.
const N_HEIGHTS: usize = 64;

/// Extreme temperatures over the contact area.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extremes {
    /// Largest of the film.
    pub film_maximum: Extreme,
    /// Smallest of the film.
    pub film_lowest: Extreme,
    /// Largest of the surfaces of body 1 and of body 2.
    pub walls: [Extreme; 2],
}

impl Default for Extremes {
    /// Of no points.
    fn default() -> Extremes {
        let none = (f64::NEG_INFINITY, [0.0; 2]);
        Extremes {
            film_maximum: none,
            film_lowest: (f64::INFINITY, [0.0; 2]),
            walls: [none; 2],
        }
    }
}

impl Extremes {
    /// Includes a place, in half-widths, with its temperatures across the film.
    pub fn include(&mut self, film: &FilmNodes, values: &Nodal, place: [f64; 2]) {
        let through = film.through(values);
        let between = (0..=N_HEIGHTS).map(|k| through.at(k as f64 / N_HEIGHTS as f64 - 0.5));
        for t in between.chain(values[..film.n()].iter().copied()) {
            if t > self.film_maximum.0 {
                self.film_maximum = (t, place);
            }
            if t < self.film_lowest.0 {
                self.film_lowest = (t, place);
            }
        }
        for (wall, t) in self.walls.iter_mut().zip(walls(film, values)) {
            if t > wall.0 {
                *wall = (t, place);
            }
        }
    }
}

/// Heat of the whole contact: W, or W/m of line contacts.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct HeatSums {
    /// Made by shear.
    pub shear: f64,
    /// Made by the friction of asperities.
    pub rubbing: f64,
    /// Made by compression, minus the heat that expansion absorbs.
    pub compression: f64,
    /// The sum of its sizes.
    pub compression_size: f64,
    /// Into both bodies.
    pub to_bodies: [f64; 2],
    /// Carried off by the lubricant.
    pub by_film: f64,
}

impl HeatSums {
    /// (made − carried off)/(heat of shear + size of the heat of compression); zero without heat.
    pub fn error(&self) -> f64 {
        let made = self.shear + self.rubbing;
        let size = made + self.compression_size;
        let lost = made + self.compression - self.to_bodies[0] - self.to_bodies[1] - self.by_film;
        if size > 0.0 { lost / size } else { 0.0 }
    }
}

/// Notes temperatures and heat of a film whose nodes across it are `nodes`.
pub fn note_heat<Plan>(
    figures: &mut Figures,
    problem: &Problem<Plan>,
    points: &PointTable,
    nodes: &FilmNodes,
    extremes: &Extremes,
    sums: &HeatSums,
) {
    let Some(heat) = &problem.heat else { return };
    let inlet = heat.inlet_temperature;
    for (figure, (value, place)) in [
        (Figure::FilmTemperatureMaximum, extremes.film_maximum),
        (Figure::FilmTemperatureLowest, extremes.film_lowest),
        (Figure::TemperatureBody1Maximum, extremes.walls[0]),
        (Figure::TemperatureBody2Maximum, extremes.walls[1]),
    ] {
        let reading = Reading {
            place: Some(place.map(|x| x * problem.scales.length)),
            ..Reading::of_rise(value, value - inlet)
        };
        figures.note(figure, reading);
    }
    // The error of cooling behind the contact is that of heating in it.
    if let Some(lowest) = figures.get(Figure::FilmTemperatureLowest) {
        let size = lowest.size.max((extremes.film_maximum.0 - inlet).abs());
        figures.note(Figure::FilmTemperatureLowest, Reading { size, ..lowest });
    }
    let means = [
        Figure::FilmTemperatureMean,
        Figure::TemperatureBody1Mean,
        Figure::TemperatureBody2Mean,
    ];
    for (figure, value) in means.into_iter().zip(zone_means(points, nodes)) {
        let reading = Reading {
            size: (value - inlet).abs(),
            ..Reading::new(value)
        };
        figures.note(figure, reading);
    }
    // The work of the surfaces becomes heat by shear or by compression of the lubricant.
    if let Some(power) = figures.get(Figure::FrictionPower) {
        let heats = power.value - power.misfit;
        let misfit = (heats - sums.shear - sums.rubbing - sums.compression).abs();
        figures.note(Figure::FrictionPower, Reading { misfit, ..power });
    }
    for (figure, value) in [
        (Figure::HeatShear, sums.shear),
        (Figure::HeatCompression, sums.compression),
        (Figure::HeatToBody1, sums.to_bodies[0]),
        (Figure::HeatToBody2, sums.to_bodies[1]),
        (Figure::HeatByFilm, sums.by_film),
    ] {
        figures.note(figure, Reading::new(value));
    }
    if problem.rough.is_some() {
        figures.note(Figure::HeatAsperities, Reading::new(sums.rubbing));
    }
}

/// Temperatures of the surfaces of body 1 and of body 2, K.
pub fn walls(film: &FilmNodes, values: &Nodal) -> [f64; 2] {
    [values[0], values[film.n() - 1]]
}

/// Means over the Hertz zone, K: of the film, of the surfaces of body 1 and of body 2.
fn zone_means(points: &PointTable, film: &FilmNodes) -> [f64; 3] {
    points.mean_in_zone(|fields| {
        let temperature = &fields.temperature.as_ref()?.temperature;
        let [body_1, body_2] = walls(film, temperature);
        Some([film.mean(temperature), body_1, body_2])
    })
}
