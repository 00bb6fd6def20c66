//! Derivatives of the figures by inputs: the change of the solution on each grid with an input.
//!
//! ```text
//!   R_l(q_l; q_(l−1), θ) = 0  on grid l, inside grid l − 1:      ∂R_l/∂q_l q̇_l = −(∂R_l/∂q_(l−1) q̇_(l−1) + ∂R_l/∂θ)
//!   j(q_0 … q_n; θ):      dj/dθ = (j(q + s q̇; θ + s) − j(q; θ))/s
//! ```
//! The right sides are differences of the equation at the pressures of the solution, and include every effect of an input:
//! scales, gap, fluid, the shape of the ellipse and with it the cells. One linear solve for each input and grid; any figure then takes one
//! evaluation. The finest grids are omitted: relative derivatives change with the error of the grid, which is far below their required accuracy.

use std::sync::Arc;

use ertel_fem::linear::gmres::{GmresParams, add, dot};
use ertel_fem::linear::recycled::Recycled;
use rayon::prelude::*;

use super::engine::Volumes;
use super::far_pressure::Beyond;
use super::figures::figures;
use super::grid::Grid;
use super::heat::rounds::Rounds;
use super::heat::tangents::{self, WarmSide};
use super::heat::{Params, Warm};
use super::level::{Level, convolution, first_system, refined};
use super::preconditioner::{Pattern, Preconditioner};
use super::step::{Equation, Inverse};
use super::system::{Linearised, State, System};
use crate::contact::Inlet;
use crate::engine::Problem;
use crate::engine::sensitivity::{Derivatives, NoDerivative, Perturbed};
use crate::forms::energy::Heat;
use crate::solution::{Figure, Figures};

/// Figures that have derivatives; of the pressure its smooth maximum: at a ridge, derivatives are those of the cells. That of the minimum on the
/// centreline, which moves from node to node on the grids that are taken, is half of what solves of a ball in its groove have.
const FIGURES: [Figure; 17] = [
    Figure::FilmCentral,
    Figure::FilmMinimum,
    Figure::MeanGapCentral,
    Figure::PressureCentral,
    Figure::AsperityLoadShare,
    Figure::FrictionAsperities,
    Figure::FrictionTotal,
    Figure::TractionCoefficient,
    Figure::TractionCoefficientBody1,
    Figure::TractionCoefficientBody2,
    Figure::FrictionPower,
    Figure::FilmTemperatureMaximum,
    Figure::FilmTemperatureMean,
    Figure::TemperatureBody1Maximum,
    Figure::TemperatureBody1Mean,
    Figure::TemperatureBody2Maximum,
    Figure::TemperatureBody2Mean,
];

/// Finest grids that are omitted, and the fewest that are used: derivatives were compared with those of the adjoint on cells of 0.023
/// half-widths, which is the fifth grid. Coarse grids of lines need not be solutions: the last one that is taken is.
const OMITTED_GRIDS: usize = 3;
const LEAST: usize = 5;

/// The fewest in thermal contacts, whose equations take many times as long.
const LEAST_WARM: usize = 4;

/// Tolerance of the linear systems. Radii that nearly cancel, as those of a ball and its groove, change the equation a hundred times more than
/// the film: with 1e-3 the exponents of lengths by which a film scales add up to 0.79 instead of 1, with 1e-5 to 1.00. Rolling friction needs more:
/// the derivative of the friction power of a ball in pure rolling by temperature is 4 % too small with 1e-5 and 0.03 % with 1e-7. The time of a run did not grow by a measurable amount.
const LINEAR: GmresParams = GmresParams {
    tolerance: 1e-7,
    max_iterations: 100,
    twice: true,
};

/// Right sides, as heights of the film, that are rounding: steps of inputs that count make some of 1e-7 to 1e-3.
const ROUNDING: f64 = 1e-11;

/// Relative error of right sides, which are differences over 1e-5 of an input. Iterations for it improve nothing: derivatives by the two temperatures of a viscosity law, which are opposite,
/// differ by 1.4e-4 with these iterations and by 1.0e-4 without.
const TRUNCATION: f64 = 1e-5;

/// A solution whose derivatives are computed.
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
        let taken_at_least = match problem.heat {
            Some(_) => LEAST_WARM,
            None => LEAST,
        };
        let least = n.saturating_sub(OMITTED_GRIDS).max(taken_at_least).min(n);
        let is_solved = |taken: &usize| (solved.stats.get(taken - 1)).is_some_and(|s| s.converged);
        let taken = (least.max(1)..=n).find(is_solved).unwrap_or(n);
        let levels = &solved.levels[..taken];
        let found = (solved.stats.last()).map_or_else(Figures::default, |level| level.figures);
        let coarser = figures(problem, levels);
        let figures = (FIGURES.into_iter())
            .filter(|f| *f != Figure::TractionCoefficient || problem.fluid.slides())
            // Of a line it differs from that of the adjoint by a fifth of the largest.
            .filter(|f| *f != Figure::PressureCentral || !problem.shape.is_line())
            .filter(|f| wanted(*f) && found.get(*f).is_some() && coarser.get(*f).is_some());
        Tangents {
            problem,
            levels,
            found,
            coarser,
            figures: figures.collect(),
        }
    }

    /// Number of grids used, from the coarsest on.
    pub fn grids(&self) -> usize {
        self.levels.len()
    }

    /// The reason why derivatives by an input are unavailable, if there is one.
    fn obstacle(&self, problem: &Problem<Plan>) -> Option<NoDerivative> {
        let close = |a: f64, b: f64| (a - b).abs() <= 1e-9 * b.abs();
        let own = self.problem;
        let moves =
            own.shape.inlet == Inlet::Meniscus && !close(own.extents.inlet, problem.extents.inlet);
        match problem.shape.symmetry == own.shape.symmetry {
            _ if moves => Some(NoDerivative::Edge),
            true => None,
            false => Some(NoDerivative::Mesh),
        }
    }
}

impl<Plan: Sync> Tangents<'_, Plan> {
    /// Whether it is the first grid, on which every input has its effect: that of a roughness which it does not resolve is on finer ones.
    fn is_first(&self, level: &Level) -> bool {
        let has_all = level.system.rough.is_some() == self.problem.rough.is_some();
        has_all && std::ptr::eq(level, &self.levels[0])
    }

    /// Moves all sides on to the next grid, with their heat.
    fn heated(
        &self,
        (level, warm): (&Level, &Warm),
        (at, equation, inverse): (&Linearised, &Equation, Inverse),
        (sides, moving): (&mut [MovedSide<Plan>], &mut [bool]),
    ) {
        let params = Params {
            depth: warm.bodies.depth,
            ..Params::default()
        };
        let Some(rounds) = Rounds::new(self.problem, params) else {
            for end in sides {
                *end = Err(NoDerivative::LinearSolver);
            }
            return;
        };
        let is_first = self.is_first(level);
        let heat = rounds.heat;
        let own = WarmSide::own(rounds, level, warm);
        let inputs = sides.iter_mut().zip(&*moving).map(|(side, moves)| {
            let side = side.as_mut().ok().filter(|_| *moves)?;
            side.next_warm((level, warm), heat, params)
        });
        let solved = tangents::solve(
            (&own, warm),
            (at, equation, inverse),
            (LINEAR, is_first),
            inputs,
        );
        for ((end, moves), solved) in sides.iter_mut().zip(moving).zip(solved) {
            *moves = solved.is_some();
            match (solved, end.as_mut()) {
                (Some(Ok(level)), Ok(side)) => side.levels.push(level),
                (Some(Err(reason)), _) => *end = Err(reason),
                _ => {}
            }
        }
    }
}

/// The grids of the solution for a perturbed problem; none where the input does not change the equation.
struct Side<'a, Plan> {
    problem: &'a Problem<Plan>,
    levels: Vec<Level>,
}

impl<Plan> Side<'_, Plan> {
    /// The equation on the next grid, with pressures of the solution where they are unknown there and those of this side beyond.
    fn next(&mut self, own: &Level) -> (System, State) {
        let zone = &self.problem.shape.zone;
        let before = &own.system.grid;
        let [along, across] = before.unit_cell();
        let grid = match (&before.rows, &zone.roller) {
            (Some(rows), Some(roller)) => Grid {
                rows: Some(rows.drawn_to(roller.half_length())),
                ..before.clone()
            },
            _ if before.is_line() => before.clone(),
            _ => Grid {
                spacing: [along, across * zone.axis_ratio],
                stretch: zone.axis_ratio,
                turn: zone.turn,
                ..before.clone()
            },
        };
        // Of the same cells, the bodies are half-spaces of the same scaled compliance; the thickness of layers changes with the half-width.
        let has_layers = self.problem.elasticity.layers.iter().any(|l| !l.is_empty());
        let alike = match &grid.rows {
            _ if has_layers => false,
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
                // As on the grid of the solution: edges would jump where only the contact area of this side goes beyond it.
                if own.system.beyond.is_some() {
                    let beyond = Beyond::up_to_area(self.problem, &system.grid);
                    beyond.note(&self.problem.shape, &mut system, &mut state);
                }
                system
            }
            Some(before) => {
                let (system, start) = refined(self.problem, before, grid, deflection);
                for (k, [i, j]) in system.grid.nodes().enumerate() {
                    if !system.grid.is_unknown(i, j) {
                        state.pressure[k] = start.pressure[k];
                        if let Some(oil) = state.oil.get_mut(k) {
                            *oil = start.oil[k];
                        }
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

/// The problem that an input was moved to, or why the input has no derivative.
type MovedSide<'a, Plan> = Result<Side<'a, Plan>, NoDerivative>;

impl<'a, Plan> Side<'a, Plan> {
    /// Of a problem.
    fn new(problem: &'a Problem<Plan>) -> Side<'a, Plan> {
        Side {
            problem,
            levels: Vec::new(),
        }
    }

    /// The same with heat.
    fn next_warm(
        &mut self,
        own: (&Level, &Warm),
        heat: &Heat,
        params: Params,
    ) -> Option<WarmSide<'a>> {
        let rounds = Rounds::new(self.problem, params)?;
        let (system, mut state) = self.next(own.0);
        system.settle(&mut state);
        let film = (system, state);
        Some(WarmSide::new(rounds, film, self.levels.last(), own, heat))
    }
}

/// A grid of the solution for a perturbed problem, and the equation there with the pressures of the solution.
struct Moved {
    system: System,
    state: State,
    equation: Linearised,
}

impl<Plan: Sync> Side<'_, Plan> {
    /// On the next grid.
    fn moved(&mut self, own: &Level) -> Moved {
        let (system, mut state) = self.next(own);
        system.settle(&mut state);
        let mut equation = system.linearise(&state);
        state.contents = std::mem::take(&mut equation.contents);
        Moved {
            system,
            state,
            equation,
        }
    }

    /// Moves on to the next grid by the derivatives of its pressures and of its separation.
    fn advance(&mut self, moved: Moved, at: &Linearised, by: Option<&[f64]>) {
        let Moved {
            system, mut state, ..
        } = moved;
        if let Some(by) = by {
            state.moved(by, 1.0, &at.wetted);
            system.settle(&mut state);
        }
        self.levels.push(Level::new(system, state));
    }
}

impl Moved {
    /// The right side of the equation of the derivatives, a difference from the solution's own problem.
    fn right(&self, own: &Moved, at: &Linearised, equation: &Equation) -> Vec<f64> {
        let (side, own) = (&self.equation, &own.equation);
        let rows = self.system.rows_between(at, own, side);
        equation.right(&rows, side.missing_load - own.missing_load)
    }
}

/// A right side without the error of its difference. If it is a combination of those before, except for this error, that combination is returned; otherwise the right side itself, and its
/// new direction is added to `independent`, which are orthonormal.
fn combined(independent: &mut Vec<Vec<f64>>, right: &[f64]) -> Vec<f64> {
    let mut rest = right.to_vec();
    for of in independent.iter() {
        let share = dot(of, &rest);
        add(&mut rest, -share, of);
    }
    let size = |of: &[f64]| dot(of, of).sqrt();
    let left = size(&rest);
    if left <= TRUNCATION * size(right) {
        return right
            .iter()
            .zip(rest)
            .map(|(right, rest)| right - rest)
            .collect();
    }
    rest.iter_mut().for_each(|value| *value /= left);
    independent.push(rest);
    right.to_vec()
}

impl<Plan: Sync> Derivatives<Plan> for Tangents<'_, Plan> {
    fn figures(&self) -> Vec<Figure> {
        self.figures.clone()
    }

    fn value(&self, figure: Figure) -> f64 {
        self.found.value(figure).unwrap_or(f64::NAN)
    }

    fn derivatives(&self, inputs: &[Perturbed<Plan>]) -> Vec<Result<Vec<f64>, NoDerivative>> {
        let mut sides: Vec<MovedSide<Plan>> = (inputs.iter())
            .map(|input| match self.obstacle(&input.problem) {
                Some(obstacle) => Err(obstacle),
                None => Ok(Side::new(&input.problem)),
            })
            .collect();
        let mut own = Side::new(self.problem);
        let mut moving = vec![true; sides.len()];
        for level in self.levels {
            let at = level.system.linearise(&level.settled());
            let pattern = Pattern::new(&level.system).ok();
            let preconditioner = (pattern.as_ref()).and_then(|p| Preconditioner::new(p, &at));
            let Some(mut preconditioner) = preconditioner else {
                return (inputs.iter())
                    .map(|_| Err(NoDerivative::LinearSolver))
                    .collect();
            };
            let equation = Equation::new(&level.system, &at, &preconditioner.scale);
            if let Some(warm) = &level.warm {
                let inverse = Inverse::new(&equation, &mut preconditioner);
                self.heated(
                    (level, warm),
                    (&at, &equation, inverse),
                    (&mut sides, &mut moving),
                );
                continue;
            }
            let here = own.moved(level);
            let is_first = self.is_first(level);
            let moved: Vec<Option<(Moved, Vec<f64>)>> = (sides.par_iter_mut().zip(&moving))
                .map(|(side, moves)| {
                    let side = side.as_mut().ok().filter(|_| *moves)?;
                    let moved = side.moved(level);
                    let right = moved.right(&here, &at, &equation);
                    // An input without effect on the first grid has none on the others.
                    let moves = !is_first || dot(&right, &right) >= ROUNDING * ROUNDING;
                    moves.then_some((moved, right))
                })
                .collect();
            own.advance(here, &at, None);
            let mut inverse = Inverse::new(&equation, &mut preconditioner);
            // Many inputs, such as speed and viscosity, change the equation in the same way: directions of one are reused for others.
            let mut recycled = Recycled::default();
            let mut independent = Vec::new();
            let mut solve = |right: &[f64]| {
                let right = combined(&mut independent, right);
                let mut x = vec![0.0; equation.n_rows()];
                let apply = |x: &[f64], y: &mut [f64]| equation.apply(x, y);
                let solved = recycled.solve(apply, |r| inverse.solve(r), &right, &mut x, LINEAR);
                solved.map(|_| x).map_err(|_| NoDerivative::LinearSolver)
            };
            let solved: Vec<_> = (moved.iter())
                .map(|moved| moved.as_ref().map(|(_, right)| solve(right)))
                .collect();
            for (moves, moved) in moving.iter_mut().zip(&moved) {
                *moves = moved.is_some();
            }
            let all = sides.par_iter_mut().zip(moved).zip(solved);
            all.for_each(|((end, moved), solved)| {
                let (Ok(side), Some((moved, _)), Some(solved)) = (end.as_mut(), moved, solved)
                else {
                    return;
                };
                match solved {
                    Ok(by) => side.advance(moved, &at, Some(&by)),
                    Err(reason) => *end = Err(reason),
                }
            });
        }
        let moved_from = match self.problem.heat {
            Some(_) => self.coarser,
            None => figures(self.problem, &own.levels),
        };
        (sides.into_par_iter().zip(inputs))
            .map(|(side, input)| {
                let side = side?;
                let [here, there] = match side.levels.is_empty() {
                    true if self.problem.heat.is_some() => [self.coarser; 2],
                    true => [self.coarser, figures(side.problem, self.levels)],
                    false => [moved_from, figures(side.problem, &side.levels)],
                };
                let derivative = |figure: &Figure| {
                    let of = |figures: &Figures| figures.value(*figure).unwrap_or(f64::NAN);
                    // Relative to the value on the same grids.
                    let ratio = match (&self.problem.rough, figure) {
                        // Distances of the mean planes of rough surfaces may vanish.
                        (Some(_), Figure::FilmCentral | Figure::FilmMinimum) => 1.0,
                        _ => self.value(*figure) / of(&self.coarser),
                    };
                    ratio * (of(&there) - of(&here)) / input.step
                };
                Ok(self.figures.iter().map(derivative).collect())
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// By hand: a right side that differs from 3 (1, 0, 1) + 2 (0, 1, 0) by 2e-6 in a third direction becomes that combination; one that differs by 2e-4 is independent.
    #[test]
    fn errors_of_differences_are_no_new_right_side() {
        let mut independent = Vec::new();
        for right in [[1.0, 0.0, 1.0], [2.0, 1.0, 2.0]] {
            assert_eq!(combined(&mut independent, &right), right);
        }
        let found = combined(&mut independent, &[3.0 + 2e-6, 2.0, 3.0 - 2e-6]);
        for (found, by_hand) in found.into_iter().zip([3.0, 2.0, 3.0]) {
            assert_relative_eq!(found, by_hand, max_relative = 1e-12);
        }
        assert_eq!(independent.len(), 2);
        let third = [3.0 + 2e-4, 2.0, 3.0 - 2e-4];
        assert_eq!(combined(&mut independent, &third), third);
        assert_eq!(independent.len(), 3);
    }
}
