//! The region beyond the first grid of a thick film: pressures of rigid parabolas, which fall with the cube of the distance.
//!
//! ```text
//!   P = λ f(φ) ρ/4H²  of [`super::far_pressure`],   H = H_0 + G,   load beyond = ∫P dA
//! ```
//! Other solutions of the film equation out there fall with the sixth power of the distance, and so does the error of this one.

use std::f64::consts::PI;

use super::far_pressure::{Beyond, FarPressure, PressureThere};
use super::grid::Grid;
use super::patches::bounds;
use super::system::{State, System};
use crate::contact::{Inlet, Shape, Symmetry};
use crate::engine::{PointFields, Problem};

/// Points of the quadrature along a ray, and rays. Along a ray the distance grows by the same factor from point to point: by 1.1 where the contact
/// area goes a hundred times further than the grid.
const POINTS: usize = 48;
const RAYS: usize = 128;

/// Rounding of an edge, relative.
const ROUNDING: f64 = 1e-6;

/// Bisections for the place where a streamline leaves the film: to 1e-6 of its length.
const BISECTIONS: usize = 20;

/// Distance from the origin to the end of a box in a direction.
fn exit([x, y]: [[f64; 2]; 2], [cos, sin]: [f64; 2]) -> f64 {
    let along = |[low, high]: [f64; 2], slope: f64| match slope {
        _ if slope > 0.0 => high / slope,
        _ if slope < 0.0 => low / slope,
        _ => f64::INFINITY,
    };
    along(x, cos).min(along(y, sin))
}

impl Beyond {
    /// Of a grid that ends before the contact area does; flooded contacts alone are full out there.
    pub fn of<Plan>(problem: &Problem<Plan>, grid: &Grid) -> Option<Beyond> {
        let is_whole = grid.rows.is_some() || grid.is_line();
        if problem.shape.inlet != Inlet::Flooded || is_whole {
            return None;
        }
        let boxes = [grid.bounds(), bounds(problem)];
        let [inside, whole] = boxes.map(|bounds| bounds[0][0].abs().max(bounds[1][1]));
        (inside * (1.0 + ROUNDING) < whole).then(|| Beyond::up_to_area(problem, grid))
    }

    /// Between the edges of a grid and those of the contact area of a problem.
    pub fn up_to_area<Plan>(problem: &Problem<Plan>, grid: &Grid) -> Beyond {
        Beyond::around(problem, grid, bounds(problem))
    }

    /// Between the edges of a grid and a box.
    pub fn around<Plan>(problem: &Problem<Plan>, grid: &Grid, whole: [[f64; 2]; 2]) -> Beyond {
        Beyond {
            lambda: problem.scales.lambda,
            far: FarPressure::new(&problem.shape.gap),
            boxes: [grid.bounds(), whole],
        }
    }

    /// P and its slopes in a film of this height.
    fn pressure(&self, shape: &Shape, place: [f64; 2], film: f64) -> PressureThere {
        let there = self.far.at(place, film, shape.gap.at(place).gradient);
        PressureThere {
            value: self.lambda * there.value,
            gradient: there.gradient.map(|slope| self.lambda * slope),
        }
    }

    /// Imposes these pressures at the edges of a first grid, and subtracts the load beyond from that of the grid.
    pub fn note(&self, shape: &Shape, system: &mut System, state: &mut State) {
        self.give(shape, system, state);
        system.beyond = Some(self.clone());
    }

    /// Imposes these pressures at the edges of a grid, and subtracts the load outside from that of the grid.
    pub fn give(&self, shape: &Shape, system: &mut System, state: &mut State) {
        let films = system.films(state);
        for (k, [i, j]) in system.grid.nodes().enumerate() {
            if !system.grid.is_unknown(i, j) {
                let place = system.grid.place(i, j);
                state.give(k, self.pressure(shape, place, films[k]).value);
            }
        }
        let points = self.points(shape, state.separation);
        system.load -= points
            .map(|(area, fields)| area * fields.pressure)
            .sum::<f64>();
    }

    /// Raises the pressures of a start to these: otherwise the film far from the contact would spread by only one node per step.
    pub fn start(&self, shape: &Shape, system: &System, state: &mut State) {
        let films = system.films(state);
        for (k, [i, j]) in system.grid.nodes().enumerate() {
            let place = system.grid.place(i, j);
            if system.grid.is_unknown(i, j) && place != [0.0; 2] {
                let pressure = self.pressure(shape, place, films[k]).value;
                let raised = state.pressure[k].max(pressure);
                if let Some(oil) = state.oil.get_mut(k) {
                    *oil += raised - state.pressure[k];
                }
                state.pressure[k] = raised;
                state.wetted[k] = state.pressure[k] > 0.0;
            }
        }
        // In a film thinner than that of the solution they carry too much.
        let share = system.load / system.integral(&state.pressure);
        if share < 1.0 {
            for (k, [i, j]) in system.grid.nodes().enumerate() {
                if system.grid.is_unknown(i, j) {
                    state.pressure[k] *= share;
                    if let Some(oil) = state.oil.get_mut(k) {
                        *oil *= share;
                    }
                }
            }
        }
    }

    /// Whether a place lies in the contact area.
    pub fn covers(&self, shape: &Shape, place: [f64; 2]) -> bool {
        let [x, y] = shape.zone.turn.to_axes(place);
        let at = [x, y / shape.zone.axis_ratio];
        (at.iter().zip(self.boxes[1])).all(|(x, [low, high])| (low..=high).contains(x))
    }

    /// G where the oil at a place without pressure left the film; `None` before the contact.
    fn departure_gap(&self, shape: &Shape, place: [f64; 2]) -> Option<f64> {
        let since = shape.gap.since_closest(place, [1.0, 0.0]);
        let before = |distance: f64| [place[0] - distance, place[1]];
        let (mut broken, mut full) = (0.0, since);
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (broken + full);
            match self.far.at(before(middle), 1.0, [0.0; 2]).value > 0.0 {
                true => full = middle,
                false => broken = middle,
            }
        }
        (since > 0.0).then(|| shape.gap.value(before(full)))
    }

    /// Points with the areas that they represent, and the fields there.
    pub fn points<'a>(
        &'a self,
        shape: &'a Shape,
        separation: f64,
    ) -> impl Iterator<Item = (f64, PointFields)> + 'a {
        let (first, rays) = match shape.symmetry {
            Symmetry::Half => (-PI, RAYS / 2),
            Symmetry::Full => (-PI, RAYS),
        };
        let turn = 2.0 * PI / RAYS as f64;
        let (zone, [inside, whole]) = (&shape.zone, self.boxes);
        (0..rays).flat_map(move |ray| {
            let (sin, cos) = (first + turn * (ray as f64 + 0.5)).sin_cos();
            let [from, to] = [inside, whole].map(|bounds| exit(bounds, [cos, sin]));
            let step = ((to / from).ln() / POINTS as f64).max(0.0);
            (0..POINTS).map(move |n| {
                let r = from * (step * (n as f64 + 0.5)).exp();
                let place = zone.turn.to_motion([r * cos, zone.axis_ratio * r * sin]);
                let gap = shape.gap.value(place);
                let film = separation + gap;
                let pressure = self.pressure(shape, place, film);
                let departure_gap = self
                    .departure_gap(shape, place)
                    .filter(|_| pressure.value <= 0.0);
                let fields = PointFields {
                    place,
                    missing: departure_gap
                        .map_or(0.0, |gap| (film - (separation + gap).max(0.0)).max(0.0)),
                    pressure: pressure.value,
                    pressure_gradient: pressure.gradient,
                    gap,
                    film,
                    ..PointFields::default()
                };
                (zone.axis_ratio * r * r * step * turn, fields)
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// The load between squares by quadrature in 2000 lines, f by hand (see [`FarPressure`]). Slopes against differences.
    #[test]
    fn load_and_slopes() {
        let shape = Shape {
            symmetry: Symmetry::Half,
            ..Shape::CIRCULAR
        };
        let square = |r: f64| [[-r, r], [-r, r]];
        let beyond = Beyond {
            lambda: 0.7,
            far: FarPressure::new(&shape.gap),
            boxes: [square(30.0), square(300.0)],
        };
        let own: f64 = (beyond.points(&shape, 0.4))
            .map(|(area, fields)| area * fields.pressure)
            .sum();
        let (end, n, width) = (1.892_53_f64, 2000, 0.3);
        let b = -0.8 * end.cos() / (3.0 * end).cosh();
        let mut sum = 0.0;
        for i in 0..n {
            for j in 0..n / 2 {
                let [x, y] = [f64::from(i) - 999.5, -0.5 - f64::from(j)].map(|k| k * width);
                if x.abs() > 30.0 || y < -30.0 {
                    let film = 0.4 + 0.5 * (x * x + y * y);
                    let psi = y.atan2(-x).abs();
                    if psi < end {
                        let f = 0.8 * psi.cos() + b * (3.0 * psi).cosh();
                        sum += width * width * 0.7 * 0.25 * f * x.hypot(y) / film.powi(2);
                    }
                }
            }
        }
        assert_relative_eq!(own, sum, max_relative = 2e-3);
        // Behind the film the oil of the place of rupture, which is at this angle on the same streamline, fills part of the gap.
        for (_, fields) in beyond.points(&shape, 0.4) {
            let [x, y] = fields.place;
            if y.atan2(-x).abs() > end + 0.01 {
                let lacks = 0.5 * (x * x + y * y) - 0.5 * (y / end.sin()).powi(2);
                assert_relative_eq!(fields.missing, lacks, epsilon = 0.02 * fields.gap);
            }
        }
        let at = |place: [f64; 2]| {
            let film = 0.4 + shape.gap.value(place);
            beyond.pressure(&shape, place, film).value
        };
        for (_, fields) in beyond.points(&shape, 0.4).step_by(97) {
            let [x, y] = fields.place;
            if x > -1.0 {
                continue;
            }
            let e = 1e-3;
            let by_x = (at([x + e, y]) - at([x - e, y])) / (2.0 * e);
            let by_y = (at([x, y + e]) - at([x, y - e])) / (2.0 * e);
            assert_relative_eq!(fields.pressure_gradient[0], by_x, max_relative = 1e-5);
            assert_relative_eq!(fields.pressure_gradient[1], by_y, max_relative = 1e-5);
        }
    }
}
