//! Local refinement until the films are as accurate as asked for.

use super::bars::{Compared, compared};
use super::discretisation::LevelSizes;
use super::indicator::Indicator;
use crate::contact::ContactKind;
use crate::solution::LevelStats;

/// When to refine further, and how far.
#[derive(Clone, Copy, Debug)]
pub struct AdaptParams {
    /// Largest relative error bar of central and minimum film.
    pub target: f64,
    /// Displacement unknowns that a refined mesh may have, about.
    pub max_displacement_dofs: usize,
    /// Deflection unknowns that it may have on the contact area, about.
    pub max_contact_dofs: usize,
    /// Refinements allowed.
    pub max_refinements: usize,
}

impl AdaptParams {
    /// Refinement to a relative error within a number of displacement unknowns. The dense compliance of
    /// the contact area weighs as much as the body when the area has a twentieth of them.
    pub fn new(target: f64, max_displacement_dofs: usize) -> AdaptParams {
        AdaptParams {
            target,
            max_displacement_dofs,
            max_contact_dofs: max_displacement_dofs / 20,
            max_refinements: 8,
        }
    }
}

/// Relative errors of central and minimum film that no estimate sees: of cells that grow with depth, by
/// the square of the growth (half the order of energies, measured), of the body's finite size and the smoothed
/// free boundary.
///
/// Measured by reducing the growth: circular contacts, M = 20 to 200, at 0.9, where the films of L = 4 to 10 move by no more than
/// 0.10 and 0.14 %, but those of L = 0 by more (at M = 100, 0.6 moves h_c by 0.2 %); line contacts, M = 5 to 200, at 0.3.
pub fn grading_errors(kind: ContactKind, sizes: &LevelSizes) -> [f64; 2] {
    let (errors, growth) = match kind {
        ContactKind::Circular => ([5e-3, 6e-3], 0.9),
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
const SAFETY: f64 = 3.0;

/// Least and largest factor by which the step from mesh to mesh corrects the estimate.
const CALIBRATION: (f64, f64) = (0.75, 4.0);

/// The factor where there is no mesh to calibrate by.
const UNCALIBRATED: f64 = 1.5;

/// Share of the difference from the mesh before that is the least bar.
const LEAST_SHARE_OF_DIFFERENCE: f64 = 0.2;

/// Error bars, relative, of central and minimum film, with their parts.
#[derive(Clone, Copy, Debug)]
pub struct ErrorBars {
    /// The bars.
    pub bars: [f64; 2],
    /// What the cells of the contact area contribute by estimate: refinement lowers it.
    pub estimated: [f64; 2],
}

/// Relative error bars of central and minimum film from the last converged mesh and the one before.
///
/// The estimate E of the last mesh is corrected by what the step from the mesh before has shown: with
/// h_1, E_1 there and h_2, E_2 here, |h_1 − h_2| ≈ θ(E_1 − E_2), and the bar is three times θE_2. A difference
/// can vanish by chance, so that θ does not fall below three quarters; without a mesh before it is 1.5, and the bar not below half of the other
/// film's. Root of the sum of squares with the errors of [`grading_errors`]; not below a fifth of the
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
            let before = comparable.and_then(|c| c.estimate).unwrap_or(e);
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
    let bars = [0, 1].map(|j: usize| {
        estimated[j]
            .hypot(grading[j])
            .max(LEAST_SHARE_OF_DIFFERENCE * gone[j])
    });
    Some(ErrorBars { bars, estimated })
}

/// Share of the estimate that is expected to stay where an element is halved. Smooth errors fall to 1/32;
/// at free boundaries and spikes much less.
const LEFT_BY_HALVING: f64 = 0.125;

/// Halvings of one element in one refinement.
const MOST_HALVINGS: u32 = 2;

/// Halvings of each element of a `dim`-dimensional contact area that are expected to bring both estimates
/// down to `goal` times their present values, the largest shares first, until there are about
/// `max_growth` times as many elements.
pub fn halvings(indicator: &Indicator, goal: [f64; 2], dim: usize, max_growth: f64) -> Vec<u32> {
    let children = (1u64 << dim) as f64;
    let mut room = (max_growth - 1.0) / CLOSURE * indicator.central.len() as f64;
    let mut totals = indicator.totals();
    let goals = [0, 1].map(|j: usize| goal[j] * totals[j]);
    let mut halvings = vec![0; indicator.central.len()];
    let share = |c: usize, n: u32| {
        let left = LEFT_BY_HALVING.powi(n as i32);
        [left * indicator.central[c], left * indicator.minimum[c]]
    };
    // Largest shares first, in units of the goal of the film that is still off.
    let weigh = |c: usize, n: u32| {
        let s = share(c, n);
        (s[0] / goals[0]).max(s[1] / goals[1])
    };
    let mut heap: std::collections::BinaryHeap<Candidate> = (0..halvings.len())
        .map(|c| Candidate {
            weight: weigh(c, 0),
            element: c,
        })
        .collect();
    while room > 0.0 && (0..2).any(|j| totals[j] > goals[j]) {
        let Some(Candidate { element, .. }) = heap.pop() else {
            break;
        };
        let n = halvings[element];
        let (before, after) = (share(element, n), share(element, n + 1));
        // No use for the film that is still off.
        if !(0..2)
            .any(|j| totals[j] > goals[j] && before[j] > 1e-3 * goals[j] / halvings.len() as f64)
        {
            continue;
        }
        for j in 0..2 {
            totals[j] -= before[j] - after[j];
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

/// Halvings of the next refinement, or `None` when the target is reached or a limit is.
pub fn next_refinement(
    params: &AdaptParams,
    dim: usize,
    levels: &[LevelStats],
    grading: [f64; 2],
    n_refinements: usize,
    indicator: &Indicator,
) -> Option<Vec<u32>> {
    let ErrorBars { bars, estimated } = error_bars(levels, grading)?;
    let level = levels.last()?;
    let body = params.max_displacement_dofs as f64 / level.n_displacement_dofs as f64;
    let growth = (1.0 + (body - 1.0) / BODY_GROWTH)
        .min(params.max_contact_dofs as f64 / level.n_contact_dofs as f64);
    let room = growth > LEAST_GROWTH && n_refinements < params.max_refinements;
    if bars.iter().all(|b| *b <= params.target) || !room {
        return None;
    }
    let goal = [0, 1].map(|j: usize| {
        if bars[j] > params.target {
            (GOAL * params.target / estimated[j]).min(LARGEST_GOAL)
        } else {
            1.0
        }
    });
    Some(halvings(indicator, goal, dim, growth))
}

/// Share of the target that the estimate aims at: refinement may fall short.
const GOAL: f64 = 0.6;

/// Share of its estimate that a refinement aims at, at most. With less refinement the few largest shares
/// go, and of the error, which is a sum of shares of both signs, much more stays than of the estimate.
const LARGEST_GOAL: f64 = 0.125;
