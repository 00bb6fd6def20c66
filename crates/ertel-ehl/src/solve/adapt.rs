//! Local refinement until the films meet their target accuracy.
//!
//! Theory: Refinement.

use super::bars::{Compared, compared};
use super::discretisation::LevelSizes;
use super::halvings::{Goal, halvings};
use super::indicator::Indicator;
use crate::contact::Shape;
use crate::elastic::BodyModel;
use crate::solution::LevelStats;
pub use crate::solve::tuning::errors::FIRST_BAR;
pub use crate::solve::tuning::errors::SAFETY_OF_RIDGE;
use crate::solve::tuning::errors::{
    CALIBRATION, LARGEST_BAR_OF_EDGES, LEAST_SHARE_OF_DIFFERENCE, SAFETY, SAFETY_OF_DIFFERENCE,
    SAFETY_OF_EDGES, SMALLEST_ERROR, UNCALIBRATED,
};
use crate::solve::tuning::refinement::{
    AS_GOOD_AS_REACHED, BODY_GROWTH, BODY_SHARE, CONFIRMING_GOAL, FEW_ELEMENTS_SHARE,
    FILM_HALVING_RATIO, GOAL, LARGEST_GOAL, LARGEST_GROWTH, LARGEST_PRESSURE_GOAL, LEAST_GROWTH,
    MAX_UNRESOLVED_SHARE, MIN_SHARE_OF_CELLS, NEAR_TARGET, OWN_SHARE, PRESSURE_GOAL,
    PRESSURE_HALVING_RATIO, SHARES, SMALLEST_GOAL, SMALLEST_PRESSURE_GOAL,
};

/// When to refine further, and how far.
#[derive(Clone, Copy, Debug)]
pub struct AdaptParams {
    /// Largest relative error bar of central and minimum film.
    pub target: f64,
    /// Largest root-mean-square error of the pressure over the dry contact, in p_h; `None`: films alone count.
    pub pressure_target: Option<f64>,
    /// Pressure unknowns that a refined mesh may have, about.
    pub max_unknowns: usize,
    /// The same where the films meet their target, and only the pressure does not.
    pub max_unknowns_for_pressure: usize,
    /// Displacement unknowns that a finite-element body below it may have, about.
    pub max_displacement_dofs: usize,
    /// Most refinements.
    pub max_refinements: usize,
}

impl AdaptParams {
    /// Refinement to errors of films and pressure within a number of pressure unknowns.
    pub fn new(target: f64, pressure_target: Option<f64>, max_unknowns: usize) -> AdaptParams {
        AdaptParams {
            target,
            pressure_target,
            max_unknowns,
            max_unknowns_for_pressure: max_unknowns,
            max_displacement_dofs: BODY_SHARE * max_unknowns,
            max_refinements: 10,
        }
    }
}

/// Relative errors of central and minimum film outside the estimate: of cells that grow with depth, by
/// the square of the growth (half the order of energies, measured), of the body's finite size and the smoothed
/// free boundary.
///
/// Measured by reducing the growth: circular contacts, M = 20 to 200, at 0.9, where the films of L = 4 to 10 move by no more than
/// 0.10 and 0.14 %, but those of L = 0 by more (at M = 100, 0.6 moves h_c by 0.2 %); line contacts, M = 5 to 200, at 0.3.
pub fn grading_errors(shape: &Shape, model: BodyModel, sizes: &LevelSizes) -> [f64; 2] {
    if model == BodyModel::HalfSpace {
        return [SMALLEST_ERROR; 2];
    }
    let (errors, growth) = match shape.is_line() {
        false => ([5e-3, 6e-3], 0.9),
        true => ([6e-4, 8e-4], 0.3),
    };
    let ratio = sizes.depth_growth / growth;
    errors.map(|e| (e * ratio * ratio).max(SMALLEST_ERROR))
}

/// Relative error bar of a film from the estimated effect of the edges of the contact area.
pub fn bar_of_edges(estimate: f64) -> f64 {
    let bar = estimate * (SAFETY_OF_EDGES[0] + SAFETY_OF_EDGES[1] * estimate);
    bar.min(LARGEST_BAR_OF_EDGES)
}

/// Error bars, relative, of central and minimum film, with their parts.
#[derive(Clone, Copy, Debug)]
pub struct ErrorBars {
    /// The bars.
    pub bars: [f64; 2],
    /// Contribution of the cells, bodies and free boundary included.
    pub cells: [f64; 2],
    /// Contribution of the cells of the contact area by the estimate of each film: refinement lowers it.
    pub own: [f64; 2],
}

/// Relative error bars of central and minimum film from the last converged mesh and the one before.
///
/// The estimate E of the last mesh is corrected by what the step from the mesh before has shown: with
/// h_1, E_1 there and h_2, E_2 here, |h_1 − h_2| ≈ θ(E_1 − E_2), and the bar is four times θE_2. A difference
/// can vanish by chance, so that θ does not fall below three quarters; without a mesh before it is 3, and the bar not below half of the other
/// film's. Root of the sum of squares with the errors of [`grading_errors`]; not below three tenths of the
/// difference, since estimates can miss a part.
///
/// Without estimates the bar is three times the difference of two meshes.
pub fn error_bars(levels: &[LevelStats], grading: [f64; 2]) -> Option<ErrorBars> {
    let Compared { fine, coarse } = compared(levels)?;
    let films = LevelStats::films;
    let difference =
        |c: &LevelStats| [0, 1].map(|j: usize| (films(c)[j] / films(fine)[j] - 1.0).abs());
    let comparable = coarse.filter(|c| c.estimate.is_some());
    let gone = comparable.map_or([0.0; 2], difference);
    let own = match (fine.estimate, coarse) {
        (Some(e), _) => {
            let before = comparable.and_then(|c| c.estimate).unwrap_or(e).films;
            let (e, ridge) = (e.films, e.ridge);
            [0, 1].map(|j: usize| {
                let theta = if before[j] > e[j] {
                    gone[j] / (before[j] - e[j])
                } else {
                    UNCALIBRATED
                };
                SAFETY * e[j] * theta.clamp(CALIBRATION.0, CALIBRATION.1)
                    + SAFETY_OF_RIDGE * ridge[j]
            })
        }
        (None, Some(c)) => difference(c).map(|d| SAFETY_OF_DIFFERENCE * d),
        (None, None) => return None,
    };
    let estimated = [0, 1].map(|j: usize| own[j].max(0.5 * own[1 - j]));
    let edges = fine.estimate.map_or([0.0; 2], |e| e.edges);
    let cells = [0, 1].map(|j: usize| {
        let sum = estimated[j].hypot(grading[j]);
        sum.max(LEAST_SHARE_OF_DIFFERENCE * gone[j])
    });
    let unresolved = fine.estimate.map_or(0.0, |e| e.unresolved);
    let bars = [0, 1].map(|j: usize| cells[j].hypot(unresolved) + bar_of_edges(edges[j]));
    Some(ErrorBars { bars, cells, own })
}

/// Quantity that a refinement makes more accurate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RefinementTarget {
    /// The films.
    Films,
    /// Films close to their target, and the pressure with them.
    Both,
    /// The pressure alone: the films meet their target.
    Pressure,
}

/// A refinement to come.
#[derive(Clone, Debug)]
pub struct Refinement {
    /// Halvings of each element.
    pub halvings: Vec<u32>,
    /// Its target.
    pub aim: RefinementTarget,
    /// Larger of the error bars of both films before it.
    pub film_bar: f64,
}

/// Why no mesh follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RefinementEnd {
    /// The errors meet their targets.
    Reached,
    /// A finer mesh would have more than so many pressure unknowns.
    Unknowns(usize),
    /// Its finite-element body would have more than so many displacement unknowns.
    BodyUnknowns(usize),
    /// So many refinements are allowed.
    Refinements(usize),
    /// The cells suffice for the films, but not for the pressure, which is not refined further; its remaining error widens the bars of the
    /// films.
    Pressure,
    /// The estimates require no cell to be halved.
    NothingToHalve,
    /// The errors could not be estimated.
    NoEstimate,
}

/// The next refinement.
///
/// # Errors
/// No refinement: the targets, or a limit, are reached.
pub fn next_refinement(
    params: &AdaptParams,
    dim: usize,
    levels: &[LevelStats],
    grading: [f64; 2],
    n_refinements: usize,
    indicator: &Indicator,
) -> Result<Refinement, RefinementEnd> {
    // Films come first: on meshes that resolve the ridge sharply, Newton's method converges worse.
    let errors = error_bars(levels, grading).ok_or(RefinementEnd::NoEstimate)?;
    let level = levels.last().ok_or(RefinementEnd::NoEstimate)?;
    // Refinement does not reduce the errors of the edges.
    let targets = indicator
        .edges
        .map(|edges| (params.target - bar_of_edges(edges)).max(MIN_SHARE_OF_CELLS * params.target));
    let plan = |cells: [f64; 2], pressure: Option<f64>, even_few: bool| {
        let of = Targets {
            cells,
            pressure,
            even_few,
        };
        planned(params, dim, level, &errors, n_refinements, indicator, of)
    };
    // The cells by themselves, and the pressure by its own target.
    let end = match plan(targets, params.pressure_target, false) {
        Err(RefinementEnd::Reached) => RefinementEnd::Reached,
        next => return next,
    };
    // The bars combine both: where the sum is still too wide, each gets its share.
    let unresolved = level.estimate.map_or(0.0, |e| e.unresolved);
    let bar = |j: usize| errors.cells[j].hypot(unresolved);
    if (0..2).all(|j| bar(j) <= targets[j]) {
        return Err(end);
    }
    let mendable = dim == 1 || params.pressure_target.is_some();
    let shares = [0, 1].map(|j: usize| shares(targets[j], errors.cells[j], unresolved, mendable));
    let of_pressure = shares[0][1].min(shares[1][1]);
    let pressure = (mendable && unresolved > of_pressure)
        .then(|| indicator.pressure_error() * of_pressure / unresolved);
    match plan(shares.map(|s| s[0]), pressure, true) {
        Err(RefinementEnd::Reached) => Err(RefinementEnd::Pressure),
        next => next,
    }
}

/// Shares of a film's target for the cells and for unresolved pressures: c² + u² = t².
///
/// The remainder where the other needs less than its usual share, else the usual shares; where pressures are not refined,
/// the cells make room for them if there is any.
fn shares(target: f64, cells: f64, unresolved: f64, mendable: bool) -> [f64; 2] {
    let left_by = |other: f64| (target * target - other * other).max(0.0).sqrt();
    let [of_cells, of_pressure] = SHARES.map(|share| share * target);
    if unresolved <= of_pressure || (!mendable && unresolved <= MAX_UNRESOLVED_SHARE * target) {
        [left_by(unresolved), unresolved]
    } else if cells <= of_cells {
        [cells, left_by(cells)]
    } else if mendable {
        [of_cells, of_pressure]
    } else {
        // Refinement does not help bars that stay too wide.
        [cells, unresolved]
    }
}

/// Target errors of a refinement.
struct Targets {
    /// Relative error bars of both films from the cells.
    cells: [f64; 2],
    /// Root-mean-square error of the pressure.
    pressure: Option<f64>,
    /// Whether it is refined even if the pressure needs only few cells.
    even_few: bool,
}

/// The refinement that leads to targets.
///
/// # Errors
/// Why there is none.
fn planned(
    params: &AdaptParams,
    dim: usize,
    level: &LevelStats,
    errors: &ErrorBars,
    n_refinements: usize,
    indicator: &Indicator,
    targets: Targets,
) -> Result<Refinement, RefinementEnd> {
    let ErrorBars { cells, own, .. } = *errors;
    let within = |factor: f64| (cells.iter().zip(&targets.cells)).all(|(c, t)| *c <= factor * t);
    let films_suffice = within(1.0);
    // The remaining errors of the films no longer move the ridge.
    let pressure =
        pressure_goal(targets.pressure, indicator).filter(|_| films_suffice || within(NEAR_TARGET));
    let mut goals = match films_suffice {
        true => Vec::new(),
        false => film_goals(targets.cells, dim, cells, own, indicator),
    };
    let aim = match (goals.is_empty(), pressure.is_some()) {
        (true, false) if films_suffice => return Err(RefinementEnd::Reached),
        (true, false) => return Err(RefinementEnd::NothingToHalve),
        (true, true) => RefinementTarget::Pressure,
        (false, true) => RefinementTarget::Both,
        (false, false) => RefinementTarget::Films,
    };
    let most = match films_suffice {
        true => params.max_unknowns_for_pressure,
        false => params.max_unknowns,
    };
    let growth = most as f64 / level.n_pressure_dofs as f64;
    let body_growth = match level.n_displacement_dofs {
        0 => f64::INFINITY,
        n => 1.0 + (params.max_displacement_dofs as f64 / n as f64 - 1.0) / BODY_GROWTH,
    };
    if growth <= LEAST_GROWTH {
        return Err(RefinementEnd::Unknowns(most));
    }
    if body_growth <= LEAST_GROWTH {
        return Err(RefinementEnd::BodyUnknowns(params.max_displacement_dofs));
    }
    if n_refinements >= params.max_refinements {
        return Err(RefinementEnd::Refinements(params.max_refinements));
    }
    goals.extend(pressure);
    let growth = growth
        .min(body_growth)
        .min(LARGEST_GROWTH[usize::from(aim != RefinementTarget::Films)]);
    let halvings = halvings(&goals, dim, growth);
    let halved = halvings.iter().filter(|h| **h > 0).count() as f64;
    if halved == 0.0 {
        return Err(RefinementEnd::NothingToHalve);
    }
    let as_good_as_reached = (targets.pressure)
        .is_some_and(|target| indicator.pressure_error() < AS_GOOD_AS_REACHED * target);
    let few = aim == RefinementTarget::Pressure
        && as_good_as_reached
        && !targets.even_few
        && halved < FEW_ELEMENTS_SHARE * halvings.len() as f64;
    match few {
        true => Err(RefinementEnd::Reached),
        false => Ok(Refinement {
            halvings,
            aim,
            film_bar: cells[0].max(cells[1]),
        }),
    }
}

/// Goals for the films whose bars are too wide.
///
/// Each by its own estimate: a bar set by half of the other's falls with the other. Where both estimates are good enough
/// and bars are wide because films have moved much from the mesh before, a finer mesh is to confirm them.
fn film_goals<'a>(
    targets: [f64; 2],
    dim: usize,
    cells: [f64; 2],
    own: [f64; 2],
    indicator: &'a Indicator,
) -> Vec<Goal<'a>> {
    let enough = |j: usize| own[j] <= OWN_SHARE * targets[j];
    let confirmed = (0..2).all(|j| cells[j] <= targets[j] || enough(j));
    let largest = if confirmed {
        CONFIRMING_GOAL
    } else {
        LARGEST_GOAL
    };
    let totals = indicator.totals();
    let lists = [
        (0, &indicator.central),
        (1, &indicator.minimum),
        (1, &indicator.rival),
    ];
    (lists.into_iter())
        .filter(|(_, shares)| !shares.is_empty())
        .filter(|(j, _)| cells[*j] > targets[*j] && (confirmed || !enough(*j)))
        .filter_map(|(j, shares)| {
            let sum: f64 = shares.iter().sum();
            let allowed = GOAL * targets[j] / own[j] * totals[j];
            (confirmed || sum > allowed).then(|| Goal {
                shares,
                allowed: allowed.clamp(SMALLEST_GOAL * sum, largest * sum),
                ratio: FILM_HALVING_RATIO[dim - 1],
            })
        })
        .collect()
}

/// The goal for the pressure, if its error is too large.
fn pressure_goal(target: Option<f64>, indicator: &Indicator) -> Option<Goal<'_>> {
    let target = target?;
    let sum: f64 = indicator.pressure.iter().sum();
    (indicator.pressure_error() > target).then(|| Goal {
        shares: &indicator.pressure,
        allowed: (PRESSURE_GOAL * target)
            .powi(2)
            .clamp(SMALLEST_PRESSURE_GOAL * sum, LARGEST_PRESSURE_GOAL * sum),
        ratio: PRESSURE_HALVING_RATIO,
    })
}

#[cfg(test)]
mod tests;
