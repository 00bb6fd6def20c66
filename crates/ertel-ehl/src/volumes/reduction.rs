//! Effect of shear thinning: the film compared with that of the Newtonian fluid on the same grids.
//!
//! ```text
//!   r = 1 − h/h_N on each grid, bars from grid to grid
//! ```
//! Grid errors are similar in both films, so the finest grids are omitted, except for lines, whose grids are small.

use super::engine::{FiniteVolumes, RIDGE_ERROR_SHARE, Volumes};

use super::plan::Plan;
use crate::engine::bars::{Slowest, bar, gap_of};
use crate::engine::{Observer, Problem, SolveError};
use crate::solution::{Estimate, Figure, FilmReduction};

/// Finest grids that are omitted, and the fewest that are used.
const OMITTED_GRIDS: usize = 2;
const LEAST: usize = 4;

/// Compares a solution with the same problem at low-shear viscosity; `None` where that is not solved.
///
/// # Errors
/// When the observer cancels.
pub fn film_reduction(
    thinned: &Volumes,
    mut newtonian: Problem<Plan>,
    observer: &mut dyn Observer,
) -> Result<Option<FilmReduction>, SolveError> {
    let n = thinned.stats.len();
    let omitted = match newtonian.shape.is_line() {
        true => 0,
        false => OMITTED_GRIDS,
    };
    newtonian.plan.most_grids = n.saturating_sub(omitted).max(LEAST).min(n);
    // All of these grids.
    newtonian.plan.target_error = 0.0;
    // Newton's method leaves as much in each of both films.
    let least = 2.0 * RIDGE_ERROR_SHARE * newtonian.plan.newton.ends.film;
    let unthinned = match FiniteVolumes.solve(&newtonian, observer) {
        Err(SolveError::Interrupted) => return Err(SolveError::Interrupted),
        Err(_) => return Ok(None),
        Ok(unthinned) => unthinned,
    };
    let [central, minimum] = [Figure::FilmCentral, Figure::FilmMinimum]
        .map(|figure| on_grids(figure, thinned, &unthinned))
        .map(|found| {
            let found = found?;
            let error = found.error.map(|error| error.max(least));
            Some(Estimate { error, ..found })
        });
    Ok(central
        .zip(minimum)
        .map(|(central, minimum)| FilmReduction { central, minimum }))
}

/// 1 − a figure over that of a simpler contact on the same grids, with its bar from the last three; of films between rough surfaces by the mean gap.
pub(super) fn on_grids(figure: Figure, full: &Volumes, simpler: &Volumes) -> Option<Estimate> {
    let on_grid = |l: usize| {
        let [full, simpler] = [full, simpler].map(|of| {
            let figures = &of.stats.get(l)?.figures;
            match figure {
                Figure::FilmCentral | Figure::FilmMinimum => {
                    gap_of([Some(figures), None, None], figure)[0]
                }
                _ => figures.value(figure),
            }
        });
        Some(1.0 - full? / simpler?)
    };
    let last = (full.stats.len().min(simpler.stats.len())).checked_sub(1)?;
    let values = [0, 1, 2].map(|back| on_grid(last.checked_sub(back)?));
    Some(Estimate {
        value: values[0]?,
        error: bar(values, false, Slowest::of(figure)),
    })
}
