//! What shear thinning does to the film: beside the film of the Newtonian fluid on the same grids.
//!
//! ```text
//!   r = 1 − h/h_N on each grid, bars from grid to grid
//! ```
//! Errors of the grid are alike in both films, so that the finest grids are left out; of lines, whose grids are small, none.

use super::engine::{FiniteVolumes, Plan, Volumes};
use super::figures::{Slowest, bar};
use crate::engine::{Engine, Observer, Problem};
use crate::solution::{Estimate, Figure, FilmReduction};
use crate::solve::SolveError;

/// Grids that are left out, the finest first, and how many are taken at least.
const LEFT_OUT: usize = 2;
const LEAST: usize = 4;

/// Of a solution, beside the same problem with the fluid at its low-shear viscosity; `None` where that is not solved.
///
/// # Errors
/// When the observer cancels.
pub fn film_reduction(
    thinned: &Volumes,
    mut newtonian: Problem<Plan>,
    observer: &mut dyn Observer,
) -> Result<Option<FilmReduction>, SolveError> {
    let n = thinned.stats.len();
    let left_out = match newtonian.shape.is_line() {
        true => 0,
        false => LEFT_OUT,
    };
    newtonian.plan.most_grids = n.saturating_sub(left_out).max(LEAST).min(n);
    // All of these grids.
    newtonian.plan.target_error = 0.0;
    let beside = match FiniteVolumes.solve(&newtonian, observer) {
        Err(SolveError::Interrupted) => return Err(SolveError::Interrupted),
        Err(_) => return Ok(None),
        Ok(beside) => beside,
    };
    let of = |figure| -> Option<Estimate> {
        let on_grid = |l: usize| {
            let [h, full] = [thinned, &beside].map(|of| of.stats.get(l)?.figures.value(figure));
            Some(1.0 - h? / full?)
        };
        let last = beside.stats.len().checked_sub(1)?;
        let values = [0, 1, 2].map(|back| on_grid(last.checked_sub(back)?));
        Some(Estimate {
            value: values[0]?,
            error: bar(values, false, Slowest::of(figure)),
        })
    };
    let [central, minimum] = [Figure::FilmCentral, Figure::FilmMinimum].map(of);
    Ok(central
        .zip(minimum)
        .map(|(central, minimum)| FilmReduction { central, minimum }))
}
