//! Temperatures and heat of a solution.
//!
//! - `balance`: where heat comes from and goes to;
//! - `cross_film`: profiles across the film;
//! - `field`: temperature of the whole film and of both bodies.

mod balance;
mod cross_film;
mod field;

use crate::case::Lubricant;
use crate::contact::{ContactKind, Scales};
use crate::film::{FilmNodes, Nodal};
use crate::params::ThermalParams;
use crate::post::profile::Profile;
use crate::solution::{Coupling, FilmTemperatures, LevelStats, Located, Thermal, ThermalReduction};
use crate::solve::discretisation::Discretisation;
use crate::solve::evaluate::{fields_at_quadrature, fields_in};
use crate::solve::heat::space::HeatSpace;
use crate::solve::sequence::{Problem, Role, StageSolution};
use crate::solve::system::State;

/// Temperatures and heat; `None` for an isothermal solution.
pub fn thermal(
    solution: &StageSolution,
    problem: &Problem,
    levels: &[LevelStats],
    scales: &Scales,
    params: &ThermalParams,
) -> Option<Thermal> {
    let (d, state) = (&solution.discretisation, &solution.state);
    let (space, heat) = (d.heat.as_ref()?, problem.heat.as_ref()?);
    let stats = solution.coupling.unwrap_or_default();
    let extremes = Extremes::new(space, state, scales);
    let [film_mean, plane_mean, ball_mean] = zone_means(d, state, space);
    Some(Thermal {
        inlet_temperature: heat.heat.inlet_temperature,
        film_maximum: extremes.film_maximum,
        film_lowest: extremes.film_minimum,
        film_mean,
        plane_maximum: extremes.walls[0],
        plane_mean,
        ball_maximum: extremes.walls[1],
        ball_mean,
        balance: balance::heat_balance(d, state, &problem.fluid, &heat.heat, scales),
        reduction: reduction(levels, problem.fluid.slide() != 0.0),
        coupling: Coupling {
            rounds: stats.rounds,
            contraction: stats.contraction,
            change: stats.change,
            n_temperatures: space.n(),
            iterations: stats.heat.iterations,
            krylov_iterations: stats.heat.krylov_iterations,
        },
        centreline: centreline(d, state, space),
        surface: surface(d, state, space),
        profiles: (params.profiles.iter())
            .filter_map(|point| {
                let plane = heat.heat.bodies[0].velocity;
                cross_film::profile(d, state, &problem.fluid, scales, plane, *point)
            })
            .collect(),
        field: params.field.then(|| field::field(d, state, space, scales)),
    })
}

/// Kelvins beyond the range of the data that are no news: laws are no better than that.
const BEYOND: f64 = 1.0;

/// What the user should know: temperatures that the data of the lubricant do not cover, points without film.
pub fn warnings(
    thermal: &Thermal,
    lubricant: &Lubricant,
    params: &ThermalParams,
    scales: &Scales,
    extents: [f64; 3],
) -> Vec<String> {
    let mut warnings = Vec::new();
    let a = scales.length;
    let place = |at: &Located| match (at.x / a, at.y / a) {
        (x, 0.0) => format!("x/a {x:.2}"),
        (x, y) => format!("x/a {x:.2}, y/a ±{:.2}", y.abs()),
    };
    for (verb, extreme) in [
        ("reaches", &thermal.film_maximum),
        ("falls to", &thermal.film_lowest),
    ] {
        let temperature = extreme.value;
        // A range that the inlet leaves is told by the case.
        let known = lubricant.range_left(thermal.inlet_temperature);
        let range = lubricant.range_left(temperature).filter(|range| {
            known != Some(*range)
                && (temperature > range.highest + BEYOND || temperature < range.lowest - BEYOND)
        });
        let Some(range) = range else {
            continue;
        };
        warnings.push(format!(
            "the temperature of the film {verb} {temperature:.1} K at {}; the data of the lubricant hold {range} ({})",
            place(extreme),
            range.basis
        ));
    }
    let [inlet, outlet, side] = extents;
    for [x, y] in &params.profiles {
        if !((inlet..=outlet).contains(x) && y.abs() <= side) {
            warnings.push(format!(
                "no profile across the film at [{x}, {y}] ([thermal] profiles): the contact area goes from {inlet} to \
                 {outlet} along the motion, and to ±{side} across it"
            ));
        }
    }
    warnings
}

/// Films and tractions with and without heat, where both were found on the same mesh; traction only where the
/// surfaces slide.
fn reduction(levels: &[LevelStats], slides: bool) -> Option<ThermalReduction> {
    let at = levels
        .iter()
        .rposition(|l| l.role == Role::Isothermal && l.converged)?;
    let cold = &levels[at];
    let warm = levels[at + 1..]
        .iter()
        .find(|l| l.converged && !l.role.leads() && l.is_beside(cold))?;
    let isothermal_traction = cold.traction?;
    Some(ThermalReduction {
        film_central: 1.0 - warm.film_central / cold.film_central,
        film_minimum: 1.0 - warm.film_minimum / cold.film_minimum,
        traction: (warm.traction.filter(|_| slides)).map(|t| 1.0 - t / isothermal_traction),
        isothermal_traction,
    })
}

/// Heights at which the film's temperature is searched for its extremes, besides its nodes.
const N_HEIGHTS: usize = 64;

/// Extreme temperatures over the nodes of the contact area.
struct Extremes {
    film_maximum: Located,
    film_minimum: Located,
    walls: [Located; 2],
}

impl Extremes {
    fn new(space: &HeatSpace, state: &State, scales: &Scales) -> Extremes {
        let (column, film) = (&space.column, &space.column.film);
        let start = |value: f64| Located {
            value,
            x: 0.0,
            y: 0.0,
        };
        let mut extremes = Extremes {
            film_maximum: start(f64::NEG_INFINITY),
            film_minimum: start(f64::INFINITY),
            walls: [start(f64::NEG_INFINITY); 2],
        };
        for (node, point) in space.surface.points.iter().enumerate() {
            let values = column.film_of(&state.temperature[node * column.n()..][..column.n()]);
            let at = |value: f64| Located {
                value,
                x: point[0] * scales.length,
                // no minus zero
                y: point[1] * scales.length + 0.0,
            };
            let through = film.through(&values);
            let between = (0..=N_HEIGHTS).map(|k| through.at(k as f64 / N_HEIGHTS as f64 - 0.5));
            let (low, high) = between
                .chain(values[..film.n()].iter().copied())
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), t| {
                    (l.min(t), h.max(t))
                });
            if high > extremes.film_maximum.value {
                extremes.film_maximum = at(high);
            }
            if low < extremes.film_minimum.value {
                extremes.film_minimum = at(low);
            }
            for (wall, value) in extremes.walls.iter_mut().zip(walls(film, &values)) {
                if value > wall.value {
                    *wall = at(value);
                }
            }
        }
        extremes
    }
}

/// Temperatures of plane and ball.
fn walls(film: &FilmNodes, values: &Nodal) -> [f64; 2] {
    [values[0], values[film.n() - 1]]
}

/// Means over the Hertz zone: of the film, of the plane's and of the ball's surface.
fn zone_means(d: &Discretisation, state: &State, space: &HeatSpace) -> [f64; 3] {
    let film = &space.column.film;
    let (mut sums, mut zone) = ([0.0; 3], 0.0);
    for c in 0..d.contact.n_elements() {
        for (q, weight) in d.rule.weights.iter().enumerate() {
            let ([x, y, _], fields) = fields_at_quadrature(d, state, c, q);
            let Some(profile) = fields.temperature.filter(|_| x.hypot(y) < 1.0) else {
                continue;
            };
            let area = weight * d.contact.maps[c].determinant;
            let [plane, ball] = walls(film, &profile.temperature);
            zone += area;
            for (sum, t) in (sums.iter_mut()).zip([film.mean(&profile.temperature), plane, ball]) {
                *sum += area * t;
            }
        }
    }
    sums.map(|sum| sum / zone)
}

/// Temperatures at the points of the centreline.
fn centreline(d: &Discretisation, state: &State, space: &HeatSpace) -> FilmTemperatures {
    let profile = Profile::new(d, state, super::fields::PER_EDGE);
    let mut temperatures = FilmTemperatures::default();
    for fields in &profile.fields {
        if let Some(profile) = &fields.temperature {
            temperatures.push(&space.column.film, &profile.temperature);
        }
    }
    temperatures
}

/// Temperatures at the pressure nodes.
fn surface(d: &Discretisation, state: &State, space: &HeatSpace) -> FilmTemperatures {
    let element = &d.pressure.element;
    let order = element.order() as f64;
    let mut values = vec![Nodal::default(); d.pressure.n_nodes()];
    for c in 0..d.contact.n_elements() {
        for (alpha, node) in element.lattice().iter().zip(d.pressure.nodes_of(c)) {
            let xi = [
                f64::from(alpha[1]) / order,
                f64::from(alpha[2]) / order,
                0.0,
            ];
            if let Some(profile) = fields_in(d, state, c, xi).temperature {
                values[*node as usize] = profile.temperature;
            }
        }
    }
    let mut temperatures = FilmTemperatures::default();
    for values in &values {
        temperatures.push(&space.column.film, values);
    }
    temperatures
}

impl FilmTemperatures {
    /// Adds a point from the temperatures at the film's nodes.
    pub(in crate::post) fn push(&mut self, film: &FilmNodes, values: &Nodal) {
        let [plane, ball] = walls(film, values);
        self.mid.push(film.through(values).at(0.0));
        self.mean.push(film.mean(values));
        self.plane.push(plane);
        self.ball.push(ball);
    }
}

/// By which an integral over the (half) contact area, in half-widths squared or half-widths, becomes one over all
/// of it, m² or m.
fn area_scale(kind: ContactKind, scales: &Scales) -> f64 {
    match kind {
        ContactKind::Circular => 2.0 * scales.length * scales.length,
        ContactKind::Line => scales.length,
    }
}
