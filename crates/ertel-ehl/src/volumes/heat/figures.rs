//! Temperatures and heat of a film on patches, in numbers.

use crate::engine::heat::{walls, zone_means};
use crate::engine::{Film, Problem};
use crate::film::FilmNodes;
use crate::solution::{Figure, Figures, Reading};
use crate::volumes::film::{PatchedFilm, share};
use crate::volumes::level::Level;

/// Heat of the whole contact, W.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Balance {
    /// Made by shear.
    pub shear: f64,
    /// Made by compression.
    pub compression: f64,
    /// The sum of its sizes.
    pub compression_size: f64,
    /// Into both bodies.
    pub to_bodies: [f64; 2],
    /// Carried off by the lubricant.
    pub by_film: f64,
}

impl Balance {
    /// (made − carried off)/(heat of shear + size of the heat of compression).
    pub fn error(&self) -> f64 {
        let size = self.shear + self.compression_size;
        let lost =
            self.shear + self.compression - self.to_bodies[0] - self.to_bodies[1] - self.by_film;
        if size > 0.0 { lost / size } else { 0.0 }
    }
}

/// Over all grids.
pub fn balance<Plan>(problem: &Problem<Plan>, levels: &[Level]) -> Balance {
    let mut sum = Balance::default();
    let area = problem.scales.area(&problem.shape);
    for (l, level) in levels.iter().enumerate() {
        let Some(warm) = &level.warm else { continue };
        let grid = &level.system.grid;
        for [i, j] in grid.nodes() {
            let k = grid.index(i, j);
            let weight = area * grid.cell(j) * share(levels, l, i, j);
            if weight == 0.0 {
                continue;
            }
            let [shear, compression, size] = warm.account.made[k];
            sum.shear += weight * shear;
            sum.compression += weight * compression;
            sum.compression_size += weight * size;
            for b in 0..2 {
                sum.to_bodies[b] += weight * warm.temperatures.flux[b][k];
            }
            sum.by_film += weight * warm.account.carried[k];
        }
    }
    sum
}

/// Heights between its nodes at which the film's temperature is searched for extremes.
const N_HEIGHTS: usize = 64;

/// Notes temperatures and heat.
pub fn note_heat<Plan>(
    figures: &mut Figures,
    problem: &Problem<Plan>,
    film: &PatchedFilm,
    nodes: &FilmNodes,
) {
    let Some(heat) = &problem.heat else { return };
    let levels = film.levels();
    let f = nodes.n();
    let none = (f64::NEG_INFINITY, [0.0; 2]);
    let (mut hottest, mut coldest, mut surfaces) = (none, (f64::INFINITY, [0.0; 2]), [none; 2]);
    for (l, level) in levels.iter().enumerate() {
        let Some(warm) = &level.warm else { continue };
        let grid = &level.system.grid;
        for [i, j] in grid.nodes() {
            if share(levels, l, i, j) == 0.0 {
                continue;
            }
            let mut values = crate::film::Nodal::default();
            values[..f].copy_from_slice(&warm.temperatures.film[grid.index(i, j) * f..][..f]);
            let at = grid.place(i, j);
            let through = nodes.through(&values);
            let between = (0..=N_HEIGHTS).map(|k| through.at(k as f64 / N_HEIGHTS as f64 - 0.5));
            for t in between.chain(values[..f].iter().copied()) {
                if t > hottest.0 {
                    hottest = (t, at);
                }
                if t < coldest.0 {
                    coldest = (t, at);
                }
            }
            for (surface, t) in surfaces.iter_mut().zip(walls(nodes, &values)) {
                if t > surface.0 {
                    *surface = (t, at);
                }
            }
        }
    }
    let inlet = heat.inlet_temperature;
    let length = problem.scales.length;
    for (figure, (value, place)) in [
        (Figure::FilmTemperatureMaximum, hottest),
        (Figure::FilmTemperatureLowest, coldest),
        (Figure::TemperatureBody1Maximum, surfaces[0]),
        (Figure::TemperatureBody2Maximum, surfaces[1]),
    ] {
        let reading = Reading {
            place: Some(place.map(|x| (x + 0.0) * length)),
            ..Reading::of_rise(value, value - inlet)
        };
        figures.note(figure, reading);
    }
    // The error of cooling behind the contact is that of heating in it.
    if let Some(lowest) = figures.get(Figure::FilmTemperatureLowest) {
        let size = lowest.size.max((hottest.0 - inlet).abs());
        figures.note(Figure::FilmTemperatureLowest, Reading { size, ..lowest });
    }
    let means = [
        Figure::FilmTemperatureMean,
        Figure::TemperatureBody1Mean,
        Figure::TemperatureBody2Mean,
    ];
    for (figure, value) in means.into_iter().zip(zone_means(film.points(), nodes)) {
        let reading = Reading {
            size: (value - inlet).abs(),
            ..Reading::new(value)
        };
        figures.note(figure, reading);
    }
    let balance = balance(problem, levels);
    // The work of the surfaces becomes heat by shear or by compression of the lubricant.
    if let Some(power) = figures.get(Figure::FrictionPower) {
        let heats = power.value - power.misfit;
        let misfit = (heats - balance.shear - balance.compression).abs();
        figures.note(Figure::FrictionPower, Reading { misfit, ..power });
    }
    for (figure, value) in [
        (Figure::HeatShear, balance.shear),
        (Figure::HeatCompression, balance.compression),
        (Figure::HeatToBody1, balance.to_bodies[0]),
        (Figure::HeatToBody2, balance.to_bodies[1]),
        (Figure::HeatByFilm, balance.by_film),
    ] {
        figures.note(figure, Reading::new(value));
    }
}
