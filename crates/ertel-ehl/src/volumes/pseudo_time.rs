//! A steady film as the end of one in time: for grids where Newton's method does not converge from the film that the grid before gives.
//!
//! ```text
//!   G_i + (m_i − m_i')/ΔT = 0,    m_i': mass at the node one step before        implicit Euler; ΔT grows until the film is steady
//! ```
//! The mass that nodes store keeps each step near the film before it, so that Newton's method converges where ΔT is short enough. The load is borne at all instants.

use super::ending::Ends;
use super::newton::{NewtonInfo, NewtonParams, newton};
use super::preconditioner::Pattern;
use super::storage::Storage;
use super::system::{State, System};
use crate::engine::Observer;

/// First step, in half-widths over the entrainment speed: that of a few cells of the coarsest grids.
const FIRST_STEP: f64 = 0.05;

/// Step from which the film is solved as steady: oil passes the contact in 2.
const LAST_STEP: f64 = 50.0;

/// Step below which the march has failed. A starved film of 38 nm needed 6e-3.
const LEAST_STEP: f64 = 1e-4;

/// Growth of the step after one that converges, and reduction after one that does not.
const GROWTH: f64 = 2.0;
const REDUCTION: f64 = 8.0;

/// Most steps: the same film needed 31.
const MOST_STEPS: usize = 60;

/// Newton iterations of a step, and the relative error of its film: the film of an instant is not a result.
const MOST_ITERATIONS: usize = 12;
const STEP_ERROR: f64 = 0.02;

/// Marches from `state` to the steady film of a grid, and ends with it in `state`.
pub fn march(
    system: &mut System,
    pattern: &Pattern,
    state: &mut State,
    params: &NewtonParams,
    about: (usize, f64),
    observer: &mut dyn Observer,
) -> NewtonInfo {
    let mut all = NewtonInfo::default();
    let of_step = NewtonParams {
        ends: Ends::of(STEP_ERROR),
        max_iterations: MOST_ITERATIONS.min(params.max_iterations),
        ..*params
    };
    let mut step = FIRST_STEP;
    for _ in 0..MOST_STEPS {
        let is_steady = step > LAST_STEP;
        system.storage = (!is_steady).then(|| storage(system, state, step));
        let before = state.clone();
        let params = if is_steady { params } else { &of_step };
        let info = newton(system, pattern, state, params, about, observer);
        all = all.and(NewtonInfo {
            converged: info.converged && is_steady,
            // An error reports the change of the last step that failed.
            change: match info.converged {
                true => all.change,
                false => info.change,
            },
            ..info
        });
        if all.converged || all.interrupted {
            break;
        }
        if info.converged {
            step *= GROWTH;
        } else {
            *state = before;
            step = step.min(LAST_STEP) / REDUCTION;
        }
        if step < LEAST_STEP {
            break;
        }
    }
    system.storage = None;
    all
}

/// The mass at the nodes, one step before.
fn storage(system: &System, state: &State, step: f64) -> Storage {
    let at = system.linearise(state);
    let held = |(k, full): (usize, f64)| (at.contents.get(k)).map_or(full, |own| own.min(full));
    let masses = at.nodes.iter().map(|node| node.mass).enumerate();
    Storage {
        rate: step.recip(),
        past: masses.map(|mass| -held(mass) / step).collect(),
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::contact::Motion;
    use crate::engine::NoObserver;
    use crate::volumes::level::{convolution, first_state, first_system};
    use crate::volumes::patches::{first_cells, grid};
    use crate::volumes::plan::newton_params;
    use crate::volumes::preconditioner::pattern;
    use crate::volumes::tests::problem;

    /// The steady film does not depend on the way to it: Newton's method finds the same one from the dry contact.
    #[test]
    fn the_end_is_the_steady_film() {
        let problem = problem(&Motion::straight(0.8, 0.0), 0.001);
        let grid = grid(&problem, first_cells(&problem)[0], None);
        let deflection = convolution(&problem, &grid);
        let mut system = first_system(&problem, grid, deflection);
        let start = first_state(&problem, &system);
        let (pattern, params) = (pattern(&system).unwrap(), newton_params(&problem, 0));
        let about = (0, problem.scales.film);
        let (mut steady, mut marched) = (start.clone(), start);
        let found = newton(
            &system,
            &pattern,
            &mut steady,
            &params,
            about,
            &mut NoObserver,
        );
        assert!(found.converged);
        let found = march(
            &mut system,
            &pattern,
            &mut marched,
            &params,
            about,
            &mut NoObserver,
        );
        assert!(found.converged && system.storage.is_none());
        assert!(found.iterations > 20, "no march in {}", found.iterations);
        let [steady, marched] = [&steady, &marched].map(|state| system.films(state));
        for (marched, steady) in marched.iter().zip(&steady) {
            assert_relative_eq!(marched, steady, max_relative = 1e-4);
        }
    }
}
