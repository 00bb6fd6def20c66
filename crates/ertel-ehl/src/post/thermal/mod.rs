//! Temperatures of any film for output, and warnings about them.
//!
//! - `cross_film`: profiles across the film.

pub mod at_rest;
pub mod cross_film;

use ertel_rheology::provenance::TemperatureRange;

use crate::contact::{Scales, Symmetry};
use crate::engine::PointFields;
use crate::engine::heat::walls;
use crate::film::{FilmNodes, Nodal};
use crate::forms::energy::Heat;
use crate::params::ThermalParams;
use crate::solution::{
    Coupling, Figure, FilmTemperatures, HeatBalance, Located, Measured, Thermal,
};
use crate::warning::{Warning, WarningKind};
use crate::words::digits;

/// Temperatures and heat of a solve by its figures; fields, reduction and coupling, which the engine supplies, are empty.
pub fn thermal_of(heat: &Heat, measured: &Measured, balance_error: f64) -> Thermal {
    Thermal {
        inlet_temperature: heat.inlet_temperature,
        film_maximum: measured.located(Figure::FilmTemperatureMaximum),
        film_lowest: measured.located(Figure::FilmTemperatureLowest),
        film_mean: measured.estimate(Figure::FilmTemperatureMean),
        body_1_maximum: measured.located(Figure::TemperatureBody1Maximum),
        body_1_mean: measured.estimate(Figure::TemperatureBody1Mean),
        body_2_maximum: measured.located(Figure::TemperatureBody2Maximum),
        body_2_mean: measured.estimate(Figure::TemperatureBody2Mean),
        balance: HeatBalance {
            shear: measured.estimate(Figure::HeatShear),
            compression: measured.estimate(Figure::HeatCompression),
            to_body_1: measured.estimate(Figure::HeatToBody1),
            to_body_2: measured.estimate(Figure::HeatToBody2),
            by_film: measured.estimate(Figure::HeatByFilm),
            error: balance_error,
        },
        reduction: None,
        coupling: Coupling::default(),
        centreline: FilmTemperatures::default(),
        surface: FilmTemperatures::default(),
        profiles: Vec::new(),
        field: None,
    }
}

/// Excess over the range of the data, K, that is not reported: it is within the accuracy of the laws.
const BEYOND: f64 = 1.0;

/// A place in half-widths; where a half was solved, its mirror image has the same.
fn place([x, y]: [f64; 2], symmetry: Symmetry) -> String {
    // No minus zero.
    let rounded = |v: f64| format!("{:.2}", (100.0 * v).round() / 100.0 + 0.0);
    let x = rounded(x);
    match symmetry {
        _ if y == 0.0 => format!("x/a {x}"),
        Symmetry::Half => format!("x/a {x}, y/a ±{}", rounded(y.abs())),
        Symmetry::Full => format!("x/a {x}, y/a {}", rounded(y)),
    }
}

/// Warnings: temperatures that the data of the lubricant do not cover, points without film.
pub fn warnings(
    thermal: &Thermal,
    ranges: &[TemperatureRange],
    params: &ThermalParams,
    scales: &Scales,
    symmetry: Symmetry,
    extents: [f64; 3],
) -> Vec<Warning> {
    let mut warnings = Vec::new();
    let a = scales.length;
    let place = |at: &Located| place([at.x / a, at.y / a], symmetry);
    for (kind, verb, extreme) in [
        (WarningKind::HottestFilm, "reaches", &thermal.film_maximum),
        (WarningKind::ColdestFilm, "falls to", &thermal.film_lowest),
    ] {
        let temperature = extreme.value;
        // An inlet outside the range is reported with the case.
        let known = TemperatureRange::left(ranges, thermal.inlet_temperature);
        let range = TemperatureRange::left(ranges, temperature).filter(|range| {
            known != Some(*range)
                && (temperature > range.highest + BEYOND || temperature < range.lowest - BEYOND)
        });
        let Some(range) = range else {
            continue;
        };
        let text = format!(
            "the temperature of the film {verb} {:.1} °C at {}; the data of the lubricant are valid {range} ({})",
            temperature - 273.15,
            place(extreme),
            range.basis
        );
        let excess = (temperature - range.highest).max(range.lowest - temperature);
        warnings.push(Warning::beyond(kind, excess, text));
    }
    let [inlet, outlet, side] = extents;
    for [x, y] in &params.profiles {
        if !((inlet..=outlet).contains(x) && y.abs() <= side) {
            let text = format!(
                "no profile across the film at [{x}, {y}] ([thermal] profiles): the contact area extends from {} to {} \
                 half-widths along the motion, and to ±{} across it",
                digits(inlet, 4),
                digits(outlet, 4),
                digits(side, 4)
            );
            warnings.push(Warning::new(WarningKind::NoEffect, text));
        }
    }
    warnings
}

/// Temperatures of points that have some.
pub fn temperatures(nodes: &FilmNodes, points: &[PointFields]) -> FilmTemperatures {
    let mut temperatures = FilmTemperatures::default();
    for profile in points
        .iter()
        .filter_map(|point| point.temperature.as_deref())
    {
        temperatures.push(nodes, &profile.temperature);
    }
    temperatures
}

impl FilmTemperatures {
    /// Adds a point from the temperatures at the film's nodes.
    pub(crate) fn push(&mut self, film: &FilmNodes, values: &Nodal) {
        let [body_1, body_2] = walls(film, values);
        self.mid.push(film.through(values).at(0.0));
        self.mean.push(film.mean(values));
        self.body_1.push(body_1);
        self.body_2.push(body_2);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of a contact that was solved as a whole, the mirror image of a place is another place.
    #[test]
    fn places_have_an_image_only_in_symmetric_contacts() {
        let at = |y, symmetry| place([-0.001, y], symmetry);
        assert_eq!(at(-0.306, Symmetry::Half), "x/a 0.00, y/a ±0.31");
        assert_eq!(at(-0.306, Symmetry::Full), "x/a 0.00, y/a -0.31");
        assert_eq!(at(0.306, Symmetry::Full), "x/a 0.00, y/a 0.31");
        assert_eq!(at(0.0, Symmetry::Full), "x/a 0.00");
    }
}
