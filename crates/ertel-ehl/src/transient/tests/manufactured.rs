//! Manufactured fields: with a source term they solve the equations on the grids, and the only error of the computed fields is that of the steps.
//!
//! ```text
//!   P = P_0 + B [1 + A sin(2πT/T_w) + c sin(2πT/T_c) (x − x_0)/σ],  B = b exp(−|x − x_0|²/2σ²)        H_0 = a_0 + a_1 sin(2πT/T_h)
//!   source = ∇·F (P, H_0, T) + ∂(ρ̄H)/∂T        ∂/∂T by differences of the given fields, of the fourth order
//! ```
//! Speed, load and the place of waves on a body that slides change with them; neither speeds nor films are those of a steady contact at any instant.

use std::f64::consts::TAU;
use std::sync::Arc;

use super::*;
use crate::contact::Pose;
use crate::transient::levels::{Levels, Zones};
use crate::transient::present::Present;
use crate::volumes::deflection::Deflection;
use crate::volumes::ending::Ends;
use crate::volumes::grid::Grid;
use crate::volumes::level::{Level, convolution, first_system, refined};
use crate::volumes::patches::{first_cells, grid as patch};
use crate::volumes::system::State;

/// x_0, on a node of all grids, and σ; P_0 and b. The pressure at the edge of the grid is fixed: the tail of the bump there must be less than the error of the steps, for the film
/// is so thick at the outlet that a pressure of 3e-7 moves as much oil as an error of 5e-5 in the contact.
const MIDDLE: f64 = -0.75;
const WIDTH: f64 = 0.35;
const FLOOR: f64 = 0.05;
const HEIGHT: f64 = 0.4;

/// A of the whole load with T_w, c with T_c, and a_1 with T_h.
const LOAD: [f64; 2] = [0.15, 2.0];
const ODD: [f64; 2] = [0.2, 1.5];
const SEPARATION: [f64; 2] = [0.05, 1.7];

/// T at the end.
const END: f64 = 1.0;

fn swing([amplitude, period]: [f64; 2], time: f64) -> f64 {
    amplitude * (TAU * time / period).sin()
}

fn conditions() -> Conditions {
    let sine = |mean: f64, [amplitude, period]: [f64; 2]| Course::Sine {
        mean,
        amplitude,
        period,
        start: 0.0,
    };
    Conditions {
        speeds: Speeds::Mean {
            entrainment: sine(0.8, [0.2, 1.8]),
            slide_to_roll_ratio: Course::Constant(0.4),
        },
        load: sine(1.0, LOAD),
        ..steady(END)
    }
}

/// A contact with fields that are given.
struct Manufactured<'a> {
    problem: Problem<Plan>,
    present: Present<'a>,
    grids: Vec<(Grid, Arc<Deflection>)>,
    /// ∫P over ∫B at T = 0.
    load_over_bump: f64,
    /// a_0.
    separation: f64,
}

impl<'a> Manufactured<'a> {
    fn new(given: &Given, n_grids: usize, conditions: &'a Conditions) -> Manufactured<'a> {
        let mut problem = given.problem();
        let waves = Form::Waves {
            wavelength: 1.2,
            amplitude: 0.03,
            direction: 0.0,
        };
        problem.shape.gap.add(
            waves,
            Body::Second,
            // Its first crest, before which waves fade out with a kink of their curvature, has left the grid.
            [2.5, 0.0],
        );
        // The residual of Newton's method is negligible next to the error of the steps.
        problem.plan.newton.krylov_tolerance = 1e-4;
        problem.plan.newton.ends = Ends {
            film: 1e-9,
            pressure: 1e-9,
            balance: 1e-9,
            load: 1e-9,
        };
        let mut grids: Vec<(Grid, Arc<Deflection>)> = Vec::new();
        for l in 0..n_grids {
            let h = first_cells(&problem)[0] / f64::from(1 << l);
            let grid = patch(&problem, h, grids.first().map(|(first, _)| first));
            let deflection = convolution(&problem, &grid);
            grids.push((grid, deflection));
        }
        let (grid, deflection) = grids[0].clone();
        let mut system = first_system(&problem, grid, deflection);
        let bump: Vec<f64> = bumps(&system.grid).collect();
        let floor = vec![FLOOR; bump.len()];
        let [bump, floor] = [bump, floor].map(|values| system.integral(&values));
        problem.load = bump + floor;
        system.load = problem.load;
        let present = Present::new(&mut problem, conditions);
        let mut own = Manufactured {
            problem,
            present,
            grids,
            load_over_bump: (bump + floor) / bump,
            separation: 0.0,
        };
        let [i, j] = system.grid.centre();
        let dry = system.films(&own.state(&system.grid, 0.0));
        own.separation = 0.3 - dry[system.grid.index(i, j)];
        own
    }

    /// The contact at an instant.
    fn set(&mut self, time: f64) {
        // To rounding.
        let parts = 8;
        let moved = (0..parts).fold([Pose::START; 2], |sum, k| {
            let [from, to] = [k, k + 1].map(|k| time * f64::from(k) / f64::from(parts));
            let way = self.present.conditions.way(from, to);
            [0, 1].map(|i: usize| sum[i].then(&way[i]))
        });
        self.present.set(&mut self.problem, time, moved);
    }

    /// The given fields at the nodes of a grid.
    fn state(&self, grid: &Grid, time: f64) -> State {
        let even = 1.0 + self.load_over_bump * swing(LOAD, time);
        let odd = swing(ODD, time);
        let pressure: Vec<f64> = (grid.nodes().zip(bumps(grid)))
            .map(|([i, j], bump)| {
                let [x, _] = grid.on_axes(i, j);
                FLOOR + bump * (even + odd * (x - MIDDLE) / WIDTH)
            })
            .collect();
        State {
            wetted: vec![true; pressure.len()],
            contents: Vec::new(),
            pressure,
            separation: self.separation + swing(SEPARATION, time),
        }
    }

    /// The grids with the given fields; the contact is left as it is at the instant.
    fn levels(&mut self, time: f64) -> Vec<Level> {
        self.set(time);
        let mut levels: Vec<Level> = Vec::new();
        for (grid, deflection) in self.grids.clone() {
            let state = self.state(&grid, time);
            let system = match levels.last_mut() {
                None => first_system(&self.problem, grid, deflection),
                Some(before) => refined(&self.problem, before, grid, deflection).0,
            };
            levels.push(Level::new(system, state));
        }
        levels
    }

    /// ρ̄H of the given fields at the nodes of each grid.
    fn masses(&mut self, time: f64) -> Vec<Vec<f64>> {
        let levels = self.levels(time);
        let of_level = |level: &Level| level.system.masses(&level.state.pressure, &level.films);
        levels.iter().map(of_level).collect()
    }

    /// Source term of the film on each grid; the contact remains as it is at the instant.
    fn source(&mut self, time: f64) -> Vec<Vec<f64>> {
        let e = 1e-3;
        let around = [-2.0, -1.0, 1.0, 2.0].map(|k| self.masses(time + k * e));
        let levels = self.levels(time);
        (levels.iter().enumerate())
            .map(|(l, level)| {
                let outflow = level.system.linearise(&level.state).outflow;
                (outflow.iter().enumerate())
                    .map(|(k, outflow)| {
                        let [a, b, c, d] = [0, 1, 2, 3].map(|i: usize| around[i][l][k]);
                        outflow + (8.0 * (c - b) - (d - a)) / (12.0 * e)
                    })
                    .collect()
            })
            .collect()
    }

    /// Largest errors of pressure and ρ̄H, relative to their largest one or to its own, and of H_0, on all grids at the end of a number of steps of uneven lengths.
    fn errors(&mut self, n: u32) -> [f64; 3] {
        let at = |i: u32| {
            // Every other step is 1.86 times as long as the one before it.
            let s = f64::from(i) + if i % 2 == 1 && i < n { 0.3 } else { 0.0 };
            END * s / f64::from(n)
        };
        let start = self.levels(0.0);
        let (conditions, unit) = (self.present.conditions, self.present.load);
        let mut levels = Levels::new(&self.problem, start, conditions, unit).unwrap();
        for i in 1..=n {
            levels.source = self.source(at(i));
            let way = conditions.way(at(i - 1), at(i));
            let zones = Zones::of(&self.problem.shape);
            let trial = levels.step(&self.problem, (at(i), way), &zones, &mut NoObserver);
            levels.accept(trial.unwrap().expect("Newton's method converges"));
        }
        let exact = self.levels(END);
        (levels.levels().iter().zip(&exact)).fold([0.0; 3], |worst, (own, exact)| {
            let [a, b] = [own, exact].map(|level| &level.state.pressure);
            let largest = b.iter().fold(0.0_f64, |m, p| m.max(*p));
            let pressure = (a.iter().zip(b)).fold(0.0_f64, |m, (a, b)| m.max((a - b).abs()));
            let [a, b] =
                [own, exact].map(|level| level.system.masses(&level.state.pressure, &level.films));
            let mass = (a.iter().zip(&b)).fold(0.0_f64, |m, (a, b)| m.max((a / b - 1.0).abs()));
            let separation = (own.state.separation - exact.state.separation).abs();
            [
                worst[0].max(pressure / largest),
                worst[1].max(mass),
                worst[2].max(separation),
            ]
        })
    }
}

/// B at the nodes.
fn bumps(grid: &Grid) -> impl Iterator<Item = f64> {
    grid.nodes().map(|[i, j]| {
        let [x, y] = grid.on_axes(i, j);
        HEIGHT * (-((x - MIDDLE).powi(2) + y * y) / (2.0 * WIDTH * WIDTH)).exp()
    })
}

/// Errors of pressure, ρ̄H and H_0 fall with the square of the step, by a power between 1.9 and 2.1.
fn assert_second_order(given: &Given, n_grids: usize, steps: [u32; 3]) {
    let conditions = conditions();
    let errors = steps.map(|n| Manufactured::new(given, n_grids, &conditions).errors(n));
    for (which, name) in ["pressure", "mass", "separation"].into_iter().enumerate() {
        let orders = [0, 1].map(|k: usize| (errors[k][which] / errors[k + 1][which]).log2());
        println!("{name}: {:?} {orders:?}", errors.map(|e| e[which]));
        assert!(
            (1.9..2.1).contains(&orders[1]),
            "{name}: {errors:?} {orders:?}"
        );
        assert!(errors[2][which] < 2e-3, "{name}: {errors:?}");
    }
}

/// A line contact on two grids.
#[test]
fn steps_of_a_line_are_of_the_second_order() {
    assert_second_order(&line(), 2, [20, 40, 80]);
}

/// A circular contact on two grids.
#[test]
fn steps_of_a_circle_are_of_the_second_order() {
    let circle = Given {
        contact: Contact::circular(0.016, 100.0),
        speed: 0.8,
        ..line()
    };
    assert_second_order(&circle, 2, [20, 40, 80]);
}
