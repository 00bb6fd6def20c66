//! Derivatives of the figures by inputs: how the solution on each grid moves with an input.
//!
//! ```text
//!   R_l(q_l; q_(l−1), θ) = 0  on grid l, inside grid l − 1:      ∂R_l/∂q_l q̇_l = −(∂R_l/∂q_(l−1) q̇_(l−1) + ∂R_l/∂θ)
//!   j(q_0 … q_n; θ):      dj/dθ = (j(q + s q̇; θ + s) − j(q − s q̇; θ − s))/2s
//! ```
//! The right sides are central differences of the equation with the pressures of the solution, so that all that an input moves is in them:
//! scales, gap, fluid, the shape of the ellipse and with it the cells. One linear solve for each input and grid; any figure then takes two
//! evaluations. The finest grids are left out: relative derivatives change with the error of the grid, which is far below what they are asked to.

use std::sync::Arc;

use ertel_fem::linear::gmres::GmresParams;
use rayon::prelude::*;

use super::beyond::Beyond;
use super::engine::Volumes;
use super::figures::figures;
use super::grid::Grid;
use super::level::{Level, convolution, first_system, refined};
use super::preconditioner::{Pattern, Preconditioner};
use super::system::{Linearised, State, System};
use crate::contact::Inlet;
use crate::engine::Problem;
use crate::engine::sensitivity::{Derivatives, NoDerivative, Perturbed};
use crate::solution::{Figure, Figures};

/// Figures that have derivatives; of the pressure its smooth maximum: at a ridge, derivatives are those of the cells. That of the minimum on the
/// centreline, which moves from node to node on the grids that are taken, is half of what solves of a ball in its groove have.
const FIGURES: [Figure; 7] = [
    Figure::FilmCentral,
    Figure::FilmMinimum,
    Figure::PressureCentral,
    Figure::TractionCoefficient,
    Figure::TractionCoefficientBody1,
    Figure::TractionCoefficientBody2,
    Figure::FrictionPower,
];

/// Grids that are left out, the finest first, and how many are taken at least: derivatives were compared with those of the adjoint on cells of 0.023
/// half-widths, which is the fifth grid.
const LEFT_OUT: usize = 3;
const LEAST: usize = 5;

/// How exactly the linear systems are solved. Radii that nearly cancel, as those of a ball and its groove do, move the equation by a hundred times what is
/// left of that in the film: with 1e-3 the exponents of lengths by which a film scales add up to 0.79 in place of 1, with 1e-5 to 1.00.
const LINEAR: GmresParams = GmresParams {
    tolerance: 1e-5,
    max_iterations: 100,
};

/// Share of a right side from which what is new in it is solved for as exactly as all of it, for others to build on.
const LEAST_NEW: f64 = 1e-3;

/// Right sides, as heights of the film, that are rounding: steps of inputs that count make some of 1e-7 to 1e-3.
const ROUNDING: f64 = 1e-11;

/// A solution whose derivatives are asked for.
pub struct Tangents<'a, Plan> {
    problem: &'a Problem<Plan>,
    levels: &'a [Level],
    /// Figures of the solution, and as far as these grids go.
    found: Figures,
    coarser: Figures,
    figures: Vec<Figure>,
}

impl<'a, Plan: Sync> Tangents<'a, Plan> {
    /// Of those figures that are `wanted`; traction has one only where surfaces slide.
    pub fn new(
        problem: &'a Problem<Plan>,
        solved: &'a Volumes,
        wanted: impl Fn(Figure) -> bool,
    ) -> Tangents<'a, Plan> {
        let n = solved.levels.len();
        let levels = &solved.levels[..n.saturating_sub(LEFT_OUT).max(LEAST).min(n)];
        let found = (solved.stats.last()).map_or_else(Figures::default, |level| level.figures);
        let coarser = figures(problem, levels);
        let figures = (FIGURES.into_iter())
            .filter(|f| *f != Figure::TractionCoefficient || problem.fluid.slides())
            .filter(|f| wanted(*f) && found.get(*f).is_some() && coarser.get(*f).is_some());
        Tangents {
            problem,
            levels,
            found,
            coarser,
            figures: figures.collect(),
        }
    }

    /// How many grids are taken, from the coarsest on.
    pub fn grids(&self) -> usize {
        self.levels.len()
    }

    /// What keeps derivatives by an input from being known.
    fn obstacle(&self, sides: &Perturbed<Plan>) -> Option<NoDerivative> {
        let close = |a: f64, b: f64| (a - b).abs() <= 1e-9 * b.abs();
        let own = self.problem;
        sides.problems.iter().find_map(|problem| {
            let moves = own.shape.inlet == Inlet::Meniscus
                && !close(own.extents.inlet, problem.extents.inlet);
            match problem.shape.symmetry == own.shape.symmetry {
                _ if moves => Some(NoDerivative::Edge),
                true => None,
                false => Some(NoDerivative::Mesh),
            }
        })
    }
}

/// The grids of the solution for a problem on one side of it; none where the input does not move the equation.
struct Side<'a, Plan> {
    problem: &'a Problem<Plan>,
    levels: Vec<Level>,
}

impl<Plan> Side<'_, Plan> {
    /// The equation on the next grid, with pressures of the solution where they are unknown there and those of this side beyond.
    fn next(&mut self, own: &Level) -> (System, State) {
        let zone = &self.problem.shape.zone;
        let h = own.system.grid.spacing[0];
        let before = &own.system.grid;
        let grid = match (&before.rows, &zone.roller) {
            (Some(rows), Some(roller)) => Grid {
                rows: Some(rows.drawn_to(roller.half_length())),
                ..before.clone()
            },
            _ => Grid {
                spacing: [h, h * zone.axis_ratio],
                turn: zone.turn,
                ..before.clone()
            },
        };
        // Of the same cells, the bodies are half-spaces of the same scaled compliance.
        let alike = match &grid.rows {
            None => grid.spacing == before.spacing,
            Some(_) => grid.rows == before.rows,
        };
        let deflection = match alike {
            true => Arc::clone(&own.system.convolution),
            false => convolution(self.problem, &grid),
        };
        let mut state = own.state.clone();
        let system = match self.levels.last_mut() {
            None => {
                let mut system = first_system(self.problem, grid, deflection);
                state.contents = system.arrival.contents(&state.wetted);
                Beyond::note(self.problem, &mut system, &mut state);
                system
            }
            Some(before) => {
                let (system, start) = refined(self.problem, before, grid, deflection);
                for (k, [i, j]) in system.grid.nodes().enumerate() {
                    if !system.grid.is_unknown(i, j) {
                        state.pressure[k] = start.pressure[k];
                        if let Some(content) = state.contents.get_mut(k) {
                            *content = start.contents[k];
                        }
                    }
                }
                system
            }
        };
        (system, state)
    }
}

/// A grid of the solution with what its linear systems share.
struct Solver<'a> {
    level: &'a Level,
    at: Linearised,
    preconditioner: Preconditioner<'a>,
    by_separation: Vec<f64>,
    /// Right sides that were solved for, at right angles to each other as heights of the film, with their solutions: inputs move the equation in few
    /// ways, as speed and viscosity do.
    known: Vec<(Vector, Vector)>,
}

/// Values at the nodes, and that of the load or of the separation.
#[derive(Clone)]
struct Vector {
    nodes: Vec<f64>,
    last: f64,
}

impl Vector {
    fn add(&mut self, factor: f64, other: &Vector) {
        for (value, other) in self.nodes.iter_mut().zip(&other.nodes) {
            *value += factor * other;
        }
        self.last += factor * other.last;
    }

    fn scaled(mut self, factor: f64) -> Vector {
        self.nodes.iter_mut().for_each(|value| *value *= factor);
        self.last *= factor;
        self
    }
}

impl Solver<'_> {
    /// Product of right sides as heights of the film.
    fn product(&self, a: &Vector, b: &Vector) -> f64 {
        let nodes = a.nodes.iter().zip(&b.nodes).zip(&self.preconditioner.scale);
        nodes.map(|((a, b), s)| a * b / (s * s)).sum::<f64>() + a.last * b.last
    }

    /// Solves for a right side, of which only what those before it do not hold is new.
    ///
    /// # Errors
    /// When the Krylov iterations run out.
    fn solve(&mut self, right: Vector) -> Result<Vector, NoDerivative> {
        let size = self.product(&right, &right).sqrt();
        let mut solution = Vector {
            nodes: vec![0.0; right.nodes.len()],
            last: 0.0,
        };
        let mut rest = right;
        for (known, by) in &self.known {
            let share = self.product(&rest, known);
            rest.add(-share, known);
            solution.add(share, by);
        }
        let left = self.product(&rest, &rest).sqrt();
        if left <= LINEAR.tolerance * size {
            return Ok(solution);
        }
        // What is small need not be exact, but is no base for others then.
        let is_new = left > LEAST_NEW * size;
        let tolerance = match is_new {
            true => LINEAR.tolerance,
            false => LINEAR.tolerance * size / left,
        };
        let step = self.level.system.respond(
            &self.at,
            (&rest.nodes, rest.last),
            &self.by_separation,
            &mut self.preconditioner,
            GmresParams {
                tolerance,
                ..LINEAR
            },
        );
        if step.krylov_iterations >= LINEAR.max_iterations {
            return Err(NoDerivative::LinearSolver);
        }
        let found = Vector {
            nodes: step.pressure,
            last: step.separation,
        };
        solution.add(1.0, &found);
        if is_new {
            let found = found.scaled(1.0 / left);
            self.known.push((rest.scaled(1.0 / left), found));
        }
        Ok(solution)
    }

    /// Moves both sides of an input on to this grid; tells whether it moves at all.
    ///
    /// # Errors
    /// When the Krylov iterations run out.
    fn advance<Plan>(&mut self, sides: &mut [Side<Plan>; 2]) -> Result<bool, NoDerivative> {
        let own = self.level;
        let next = sides.each_mut().map(|side| side.next(own));
        let equations = next
            .each_ref()
            .map(|(system, state)| system.linearise(state));
        let [below, above] = &equations;
        let rows: Vec<f64> = (self.at.wetted.iter().enumerate())
            .map(|(k, wetted)| match wetted {
                true => -0.5 * (above.outflow[k] - below.outflow[k]),
                false => 0.0,
            })
            .collect();
        let load = 0.5 * (above.missing_load - below.missing_load);
        let right = Vector {
            nodes: rows,
            last: load,
        };
        // What does not move the first grid moves none.
        if sides[0].levels.is_empty() && self.product(&right, &right) < ROUNDING * ROUNDING {
            return Ok(false);
        }
        let step = self.solve(right)?;
        let moved = sides.iter_mut().zip(next).zip(equations);
        for (((side, (system, mut state)), equation), sign) in moved.zip([-1.0, 1.0]) {
            state.contents = equation.contents;
            // Where the film has broken there is no pressure, not even what a linear solver leaves: the next grid would take that for a full gap.
            let changes = step.nodes.iter().zip(&self.at.wetted);
            for (p, (change, wetted)) in state.pressure.iter_mut().zip(changes) {
                if *wetted {
                    *p += sign * change;
                }
            }
            state.separation += sign * step.last;
            side.levels.push(Level {
                films: system.films(&state),
                system,
                state,
                patch: None,
            });
        }
        Ok(true)
    }
}

impl<Plan: Sync> Derivatives<Plan> for Tangents<'_, Plan> {
    fn figures(&self) -> Vec<Figure> {
        self.figures.clone()
    }

    fn value(&self, figure: Figure) -> f64 {
        self.found.value(figure).unwrap_or(f64::NAN)
    }

    fn derivatives(&self, inputs: &[Perturbed<Plan>]) -> Vec<Result<Vec<f64>, NoDerivative>> {
        let mut sides: Vec<Result<[Side<Plan>; 2], NoDerivative>> = (inputs.iter())
            .map(|input| match self.obstacle(input) {
                Some(obstacle) => Err(obstacle),
                None => Ok(input.problems.each_ref().map(|problem| Side {
                    problem,
                    levels: Vec::new(),
                })),
            })
            .collect();
        let mut moving = vec![true; sides.len()];
        for level in self.levels {
            let at = level.system.linearise(&level.state);
            let inverse = level.system.convolution.stencils();
            let pattern = Pattern::new(&level.system.grid, inverse).ok();
            let preconditioner = (pattern.as_ref()).and_then(|p| Preconditioner::new(p, &at));
            let Some(mut preconditioner) = preconditioner else {
                return (inputs.iter())
                    .map(|_| Err(NoDerivative::LinearSolver))
                    .collect();
            };
            let by_separation = level.system.by_separation(&at, &mut preconditioner);
            let mut solver = Solver {
                level,
                at,
                preconditioner,
                by_separation,
                known: Vec::new(),
            };
            for (end, moves) in sides.iter_mut().zip(&mut moving) {
                if let (Ok(sides), true) = (end.as_mut(), *moves) {
                    match solver.advance(sides) {
                        Ok(moved) => *moves = moved,
                        Err(reason) => *end = Err(reason),
                    }
                }
            }
        }
        (sides.into_par_iter().zip(inputs))
            .map(|(sides, input)| {
                let of_side = |side: &Side<Plan>| {
                    let moved = !side.levels.is_empty();
                    let levels: &[Level] = if moved { &side.levels } else { self.levels };
                    figures(side.problem, levels)
                };
                let [below, above] = sides?.each_ref().map(of_side);
                let derivative = |figure: &Figure| {
                    let of = |figures: &Figures| figures.value(*figure).unwrap_or(f64::NAN);
                    // Relative to the value on the same grids.
                    let ratio = self.value(*figure) / of(&self.coarser);
                    ratio * (of(&above) - of(&below)) / input.distance
                };
                Ok(self.figures.iter().map(derivative).collect())
            })
            .collect()
    }
}
