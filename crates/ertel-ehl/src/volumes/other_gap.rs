//! Effect of the gap through which the oil flows between rough surfaces: the same contact with the other choice.
//!
//! Errors of the grids are similar in both, so that the finest grids are omitted, and differences on the same grid are added to the figures of the finest.

use super::engine::{FiniteVolumes, Volumes};
use super::plan::Plan;
use crate::engine::{Observer, Problem, SolveError};
use crate::mixed::Flow;
use crate::solution::{Figure, OtherGap};

/// Finest grids that are omitted, of points and of lines.
const OMITTED_GRIDS: [usize; 2] = [1, 2];

/// Load share of the asperities above which the choice matters.
const SHARE: f64 = 0.01;

/// Figures of a contact solved with the mean gap, where the oil flows through the distance of the mean planes; `None` between smooth surfaces, where asperities bear
/// next to nothing, and where it is not solved.
///
/// # Errors
/// When the observer cancels.
pub fn other_gap(
    solved: &Volumes,
    mut other: Problem<Plan>,
    observer: &mut dyn Observer,
) -> Result<Option<OtherGap>, SolveError> {
    let is_line = other.shape.is_line();
    let Some(rough) = &mut other.rough else {
        return Ok(None);
    };
    rough.flow = Flow::Distance;
    let figures = |of: &Volumes, l: usize, figure| of.stats.get(l)?.figures.value(figure);
    let n = solved.stats.len();
    let share = figures(solved, n.saturating_sub(1), Figure::AsperityLoadShare);
    if share.is_none_or(|share| share < SHARE) {
        return Ok(None);
    }
    let most = n.saturating_sub(OMITTED_GRIDS[usize::from(is_line)]);
    // Coarse grids may not resolve the roughness.
    let coarser = most.checked_sub(1).and_then(|l| solved.levels.get(l));
    if coarser.is_none_or(|level| level.system.rough.is_none()) {
        return Ok(None);
    }
    other.plan.most_grids = most;
    // All of these grids.
    other.plan.target_error = 0.0;
    // Where mean planes overlap no oil flows through their distance: most such contacts have no solution, and a search takes longer than the contact.
    other.plan.continues = false;
    let found = match FiniteVolumes.solve(&other, observer) {
        Err(SolveError::Interrupted) => return Err(SolveError::Interrupted),
        Err(_) => return Ok(None),
        Ok(found) if found.stats.len() < most => return Ok(None),
        Ok(found) => found,
    };
    let of = |figure| {
        let change = figures(&found, most - 1, figure)? - figures(solved, most - 1, figure)?;
        Some(figures(solved, n - 1, figure)? + change)
    };
    let films = [Figure::FilmCentral, Figure::FilmMinimum].map(of);
    let (Some(share), [Some(film_central), Some(film_minimum)]) =
        (of(Figure::AsperityLoadShare), films)
    else {
        return Ok(None);
    };
    Ok(Some(OtherGap {
        asperity_load_share: share,
        film_central,
        film_minimum,
        friction_total: of(Figure::FrictionTotal),
    }))
}
