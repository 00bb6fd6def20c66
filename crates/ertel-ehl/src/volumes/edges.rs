//! Effect of edges near the contact on its films.
//!
//! ```text
//!   given at the edges:   P = λ f(φ) ρ/4H²  of [`super::far_pressure`]     around points
//!                         P = −λ c X/H²,  X < 0,  c = 1/3                  along cylinders
//! ```
//! The contact area has P = 0 along its edges. A film that continues outside has about these pressures there, and carries the load outside (Kapitza 1955). One Newton step
//! from the solution to that film, minus one with unchanged edges (the remaining residual), is the effect of the edges to first order.

use ertel_fem::linear::gmres::GmresParams;

use super::ending::LEAST_FILM;
use super::extremes::lowest;
use super::far_pressure::Beyond;
use super::figures::central;
use super::level::Level;
use super::plan::{Plan, newton_params};
use super::preconditioner::Preconditioner;
use super::preconditioner::pattern;
use super::system::{State, System};
use crate::contact::Inlet;
use crate::engine::far_field::far_field;
use crate::engine::{Problem, SolveError};

/// Grids among which the finest that covers the whole area is taken: on the third, cells are a tenth of a half-width where edges are near enough to count.
const GRIDS: usize = 3;

/// Relative changes of the central and the minimum film where the film continues outside the edges of the contact area; zero where the inlet is not flooded or the grids have
/// the pressures of that film along their edges.
///
/// # Errors
/// Where no order of elimination is found.
pub fn effects(problem: &Problem<Plan>, levels: &[Level]) -> Result<[f64; 2], SolveError> {
    let covers = |level: &&Level| level.system.grid.walls == levels[0].system.grid.walls;
    let level = levels.iter().take(GRIDS).take_while(covers).last();
    let is_flooded = problem.shape.inlet == Inlet::Flooded;
    let Some(level) = level.filter(|level| is_flooded && level.system.beyond.is_none()) else {
        return Ok([0.0; 2]);
    };
    let (mut system, mut state) = (level.system.clone(), level.state.clone());
    continue_outside(problem, &mut system, &mut state);
    let Some(here) = stepped(problem, &level.system, &level.state)? else {
        return Ok([0.0; 2]);
    };
    let Some(there) = stepped(problem, &system, &state)? else {
        return Ok([0.0; 2]);
    };
    // Coarse grids have minimum films near zero.
    let size = |film: usize| here[film].abs().max(LEAST_FILM * here[0].abs());
    Ok([0, 1].map(|film: usize| ((there[film] - here[film]) / size(film)).abs()))
}

/// Central and minimum film after a step of Newton's method; `None` where it cannot be taken.
fn stepped(
    problem: &Problem<Plan>,
    system: &System,
    state: &State,
) -> Result<Option<[f64; 2]>, SolveError> {
    let params = newton_params(problem);
    let at = system.linearise(state);
    let pattern = pattern(system)?;
    let Some(mut preconditioner) = Preconditioner::new(&pattern, &at) else {
        return Ok(None);
    };
    let linear = GmresParams {
        tolerance: params.krylov_tolerance,
        max_iterations: params.max_krylov_iterations,
        twice: false,
    };
    let step = system.step(&at, state, &mut preconditioner, linear);
    if step.krylov_iterations >= params.max_krylov_iterations || !step.separation.is_finite() {
        return Ok(None);
    }
    let mut state = state.clone();
    for (p, change) in state.pressure.iter_mut().zip(&step.pressure) {
        *p += change;
    }
    state.separation += step.separation;
    let levels = [Level::new(system.clone(), state)];
    Ok(lowest(&levels).map(|lowest| [central(&levels), lowest.film]))
}

/// Gives the edges the pressures of a film that continues, and takes the load outside off that of the grid.
fn continue_outside(problem: &Problem<Plan>, system: &mut System, state: &mut State) {
    let shape = &problem.shape;
    let grid = &system.grid;
    if !(grid.is_line() || grid.rows.is_some()) {
        let [inlet, side] = problem.reach;
        let reach = [[-inlet, inlet], [-side, side]];
        return Beyond::around(problem, grid, reach).give(shape, system, state);
    }
    let c = problem.scales.lambda * far_field(&shape.gap)[0];
    let films = system.films(state);
    let inlet = grid.bounds()[0][0].abs();
    for [i, j] in grid.nodes() {
        let x = grid.place(i, j)[0];
        if x < 0.0 && !grid.is_unknown(i, j) && !grid.is_end(j) {
            let k = grid.index(i, j);
            state.pressure[k] = -c * x / films[k].powi(2);
        }
    }
    // ∫P dX = 2c/X² from the edge on, H = X²/2.
    let rows = (0..grid.n[1]).filter(|j| !grid.is_end(*j));
    let width: f64 = rows
        .map(|j| grid.mirrored_share(j) * grid.length(1, j))
        .sum();
    system.load -= 2.0 * c * width / inlet.powi(2);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::{Contact, Motion};
    use crate::volumes::grid::Grid;
    use crate::volumes::level::{convolution, first_state, first_system};
    use crate::volumes::tests::problem_of;
    use approx::assert_relative_eq;

    /// Before a cylinder, P = λ|X|/3H² with H = X²/2 carries ∫ 4λ/3|X|³ dX = 2λ/3·4² up to X = −4.
    #[test]
    fn load_before_the_edge_of_a_line() {
        let contact = Contact::line(0.01, 1e5);
        let problem = problem_of(&contact, &Motion::straight(0.5, 0.0), 0.01);
        let grid = Grid::of_line([-40, 20], 0.1);
        let deflection = convolution(&problem, &grid);
        let mut system = first_system(&problem, grid, deflection);
        let mut state = first_state(&problem, &system);
        let before = system.load;
        continue_outside(&problem, &mut system, &mut state);
        let hand = 2.0 * problem.scales.lambda / (3.0 * 16.0);
        assert_relative_eq!(before - system.load, hand, max_relative = 1e-6);
    }
}
