//! Local refinement until the films are as accurate as asked for.

use super::bars::{Compared, compared};
use super::discretisation::LevelSizes;
use super::indicator::Indicator;
use crate::contact::{ContactKind, Shape};
use crate::elastic::BodyModel;
use crate::solution::LevelStats;

/// When to refine further, and how far.
#[derive(Clone, Copy, Debug)]
pub struct AdaptParams {
    /// Largest relative error bar of central and minimum film.
    pub target: f64,
    /// Largest root-mean-square error of the pressure over the dry contact, in p_h; `None`: films alone count.
    pub pressure_target: Option<f64>,
    /// Pressure unknowns that a refined mesh may have, about.
    pub max_unknowns: usize,
    /// The same where the films are as accurate as asked for, and the pressure alone is not.
    pub max_unknowns_for_pressure: usize,
    /// Displacement unknowns that a finite-element body below it may have, about.
    pub max_displacement_dofs: usize,
    /// Refinements allowed.
    pub max_refinements: usize,
}

/// Displacement unknowns of a finite-element body per pressure unknown allowed.
const BODY_SHARE: usize = 10;

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

/// Relative errors of central and minimum film that no estimate sees: of cells that grow with depth, by
/// the square of the growth (half the order of energies, measured), of the body's finite size and the smoothed
/// free boundary.
///
/// Measured by reducing the growth: circular contacts, M = 20 to 200, at 0.9, where the films of L = 4 to 10 move by no more than
/// 0.10 and 0.14 %, but those of L = 0 by more (at M = 100, 0.6 moves h_c by 0.2 %); line contacts, M = 5 to 200, at 0.3.
pub fn grading_errors(shape: &Shape, model: BodyModel, sizes: &LevelSizes) -> [f64; 2] {
    if model == BodyModel::HalfSpace {
        return [SMALLEST_ERROR; 2];
    }
    let (errors, growth) = match shape.kind {
        ContactKind::Circular | ContactKind::Elliptical | ContactKind::Roller => {
            ([5e-3, 6e-3], 0.9)
        }
        ContactKind::Line => ([6e-4, 8e-4], 0.3),
    };
    let ratio = sizes.depth_growth / growth;
    errors.map(|e| (e * ratio * ratio).max(SMALLEST_ERROR))
}

/// Smallest error claimed.
const SMALLEST_ERROR: f64 = 1e-4;

/// Error bar over the difference of two meshes, where there is no other estimate (Roache, J. Fluids Eng.
/// 116 (1994) 405-413).
const SAFETY_OF_DIFFERENCE: f64 = 3.0;

/// Error bar over the calibrated estimate.
const SAFETY: f64 = 4.0;

/// Least and largest factor by which the step from mesh to mesh corrects the estimate.
const CALIBRATION: (f64, f64) = (0.75, 4.0);

/// The factor where there is no mesh to calibrate by: first meshes err by up to four times their estimate.
const UNCALIBRATED: f64 = 3.0;

/// Error bar over the estimate of a first mesh.
pub const FIRST_BAR: f64 = SAFETY * UNCALIBRATED;

/// Error bar over the estimate e of what the edges of the contact area do, and how it grows with e: the estimate is linear in the
/// pressure at the edges. Measured: within a tenth where e is below 0.5 % (ball on disc, M = 200), a half of what it should be
/// at 3 % (M = 5).
const SAFETY_OF_EDGES: [f64; 2] = [1.5, 100.0];

/// Largest relative bar for what the edges do: beyond it the estimate says no more than that they are far too near.
const LARGEST_BAR_OF_EDGES: f64 = 10.0;

/// Relative error bar of a film for what the edges of the contact area do to it by estimate.
pub fn bar_of_edges(estimate: f64) -> f64 {
    let bar = estimate * (SAFETY_OF_EDGES[0] + SAFETY_OF_EDGES[1] * estimate);
    bar.min(LARGEST_BAR_OF_EDGES)
}

/// Share of the difference from the mesh before that is the least bar.
const LEAST_SHARE_OF_DIFFERENCE: f64 = 0.3;

/// Error bars, relative, of central and minimum film, with their parts.
#[derive(Clone, Copy, Debug)]
pub struct ErrorBars {
    /// The bars.
    pub bars: [f64; 2],
    /// What the cells contribute, bodies and free boundary included.
    pub cells: [f64; 2],
    /// What the cells of the contact area contribute by its own estimate to each: refinement lowers it.
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
            let e = e.films;
            [0, 1].map(|j: usize| {
                let theta = if before[j] > e[j] {
                    gone[j] / (before[j] - e[j])
                } else {
                    UNCALIBRATED
                };
                SAFETY * e[j] * theta.clamp(CALIBRATION.0, CALIBRATION.1)
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
    let bars = [0, 1].map(|j: usize| cells[j] + bar_of_edges(edges[j]));
    Some(ErrorBars { bars, cells, own })
}

/// What refinement is to bring down: shares of the elements that add up to an error, or to its square.
pub struct Goal<'a> {
    /// Share of each element.
    pub shares: &'a [f64],
    /// What of their sum may stay.
    pub allowed: f64,
    /// What of an element's share is expected to stay where it is halved.
    pub left_by_halving: f64,
}

/// Of the estimate of a film, in line and in circular contacts: smooth errors fall to 1/32; at free boundaries and spikes much less.
const FILM_LEFT: [f64; 2] = [0.125, 0.06];

/// Of the square of the pressure error: at a ridge with a sharp side, half.
const PRESSURE_LEFT: f64 = 0.4;

/// Halvings of one element in one refinement.
const MOST_HALVINGS: u32 = 2;

/// Halvings of each element of a `dim`-dimensional contact area that are expected to bring every goal down to what it allows, the
/// largest shares first, until there are about `max_growth` times as many elements.
pub fn halvings(goals: &[Goal], dim: usize, max_growth: f64) -> Vec<u32> {
    let n = goals.first().map_or(0, |g| g.shares.len());
    let children = (1u64 << dim) as f64;
    let mut room = (max_growth - 1.0) / CLOSURE * n as f64;
    let mut totals: Vec<f64> = goals.iter().map(|g| g.shares.iter().sum()).collect();
    let mut halvings = vec![0; n];
    let share = |g: &Goal, c: usize, n: u32| g.left_by_halving.powi(n as i32) * g.shares[c];
    // Largest shares first, in units of what is allowed.
    let weigh = |c: usize, n: u32| {
        goals
            .iter()
            .map(|g| share(g, c, n) / g.allowed)
            .fold(0.0, f64::max)
    };
    let mut heap: std::collections::BinaryHeap<Candidate> = (0..n)
        .map(|c| Candidate {
            weight: weigh(c, 0),
            element: c,
        })
        .collect();
    let is_off = |totals: &[f64], j: usize| totals[j] > goals[j].allowed;
    while room > 0.0 && (0..goals.len()).any(|j| is_off(&totals, j)) {
        let Some(Candidate { element, .. }) = heap.pop() else {
            break;
        };
        let n = halvings[element];
        // No use for what is still off.
        let of_use = |j: usize| {
            let least = 1e-3 * goals[j].allowed / halvings.len() as f64;
            is_off(&totals, j) && share(&goals[j], element, n) > least
        };
        if !(0..goals.len()).any(of_use) {
            continue;
        }
        for (total, goal) in totals.iter_mut().zip(goals) {
            *total -= share(goal, element, n) - share(goal, element, n + 1);
        }
        halvings[element] = n + 1;
        room -= (children - 1.0) * children.powi(n as i32);
        if n + 1 < MOST_HALVINGS {
            heap.push(Candidate {
                weight: weigh(element, n + 1),
                element,
            });
        }
    }
    halvings
}

/// Elements that a refinement adds, over those asked for: conformity asks for more.
const CLOSURE: f64 = 1.5;

/// Growth of the body's unknowns over that of the elements on its contact area: cells away from it stay as
/// they are. Measured on circular contacts: 0.38.
const BODY_GROWTH: f64 = 0.5;

/// Growth of a mesh below which refining it is not worth a factorisation.
const LEAST_GROWTH: f64 = 1.2;

/// Growth of a mesh in one refinement, at most: for the films, and for the pressure alone, whose ridge is not where a coarse mesh
/// puts it.
const LARGEST_GROWTH: [f64; 2] = [4.0, 2.5];

/// An element by the weight of its share.
struct Candidate {
    weight: f64,
    element: usize,
}

impl Ord for Candidate {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        // ties by number: the same mesh on every run
        self.weight
            .total_cmp(&other.weight)
            .then(other.element.cmp(&self.element))
    }
}

impl PartialOrd for Candidate {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Candidate {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Candidate {}

/// A refinement to come.
#[derive(Clone, Debug)]
pub struct Refinement {
    /// Halvings of each element.
    pub halvings: Vec<u32>,
    /// Whether the films are as accurate as asked for already, and only the pressure is not.
    pub for_pressure_alone: bool,
}

/// The next refinement, or `None` when the targets are reached or a limit is.
pub fn next_refinement(
    params: &AdaptParams,
    dim: usize,
    levels: &[LevelStats],
    grading: [f64; 2],
    n_refinements: usize,
    indicator: &Indicator,
) -> Option<Refinement> {
    // What the edges do, no refinement mends. Films come first: on meshes that draw the ridge sharply, Newton's method converges worse.
    let ErrorBars { cells, own, .. } = error_bars(levels, grading)?;
    let level = levels.last()?;
    let for_pressure_alone = cells.iter().all(|c| *c <= params.target);
    let most = match for_pressure_alone {
        true => params.max_unknowns_for_pressure,
        false => params.max_unknowns,
    };
    let mut growth = most as f64 / level.n_pressure_dofs as f64;
    if level.n_displacement_dofs > 0 {
        let body = params.max_displacement_dofs as f64 / level.n_displacement_dofs as f64;
        growth = growth.min(1.0 + (body - 1.0) / BODY_GROWTH);
    }
    growth = growth.min(LARGEST_GROWTH[usize::from(for_pressure_alone)]);
    if growth <= LEAST_GROWTH || n_refinements >= params.max_refinements {
        return None;
    }
    // Each film by its own estimate: that a bar is half of the other's at least is mended with the other.
    let enough = |j: usize| own[j] <= OWN_SHARE * params.target;
    let both = (0..2).all(enough);
    let totals = indicator.totals();
    let lists = [
        (0, &indicator.central),
        (1, &indicator.minimum),
        (1, &indicator.rival),
    ];
    let mut goals: Vec<Goal> = (lists.into_iter())
        .filter(|(j, _)| cells[*j] > params.target && (both || !enough(*j)))
        .filter_map(|(j, shares)| {
            let sum: f64 = shares.iter().sum();
            let allowed = GOAL * params.target / own[j] * totals[j];
            (both || sum > allowed).then(|| Goal {
                shares,
                allowed: allowed.min(LARGEST_GOAL * sum),
                left_by_halving: FILM_LEFT[dim - 1],
            })
        })
        .filter(|goal| !goal.shares.is_empty())
        .collect();
    let target = params.pressure_target.unwrap_or(f64::INFINITY);
    if for_pressure_alone && indicator.pressure_error() > target {
        let sum: f64 = indicator.pressure.iter().sum();
        goals.push(Goal {
            shares: &indicator.pressure,
            allowed: (PRESSURE_GOAL * target)
                .powi(2)
                .clamp(SMALLEST_PRESSURE_GOAL * sum, LARGEST_PRESSURE_GOAL * sum),
            left_by_halving: PRESSURE_LEFT,
        });
    }
    if goals.is_empty() {
        return None;
    }
    let halvings = halvings(&goals, dim, growth);
    let halved = halvings.iter().filter(|h| **h > 0).count() as f64;
    let few = for_pressure_alone && halved < FEW * halvings.len() as f64;
    (!few).then_some(Refinement {
        halvings,
        for_pressure_alone,
    })
}

/// Share of the elements for which alone a mesh is not refined once more, where films are as accurate as asked for: the pressure's
/// target is as good as reached.
const FEW: f64 = 0.01;

/// Share of the target that the estimate aims at: refinement may fall short.
const GOAL: f64 = 0.6;

/// Share of the target up to which a film's own estimate asks for no refinement where the other's does.
const OWN_SHARE: f64 = 0.9;

/// The same for the pressure, whose estimate is no bound.
const PRESSURE_GOAL: f64 = 0.9;

/// Share of its square that a refinement aims at, at least and at most: a ridge is not where a coarse mesh puts it, and cells that
/// are made too fine at a wrong place are of no use.
const SMALLEST_PRESSURE_GOAL: f64 = 0.2;
const LARGEST_PRESSURE_GOAL: f64 = 0.7;

/// Share of its estimate that a refinement aims at, at most. With less refinement the few largest shares
/// go, and of the error, which is a sum of shares of both signs, much more stays than of the estimate.
const LARGEST_GOAL: f64 = 0.125;

#[cfg(test)]
mod tests;
