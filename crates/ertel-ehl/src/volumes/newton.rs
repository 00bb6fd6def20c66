//! Newton's method with active sets on one grid.

use ertel_fem::linear::gmres::GmresParams;
use ertel_fem::platform::Instant;

use super::ending::{Ends, Progress, balance_error, entered};
use super::preconditioner::{Pattern, Preconditioner};
use super::step::Step;
use super::system::{Linearised, State, System};
use crate::engine::Observer;
use crate::solution::IterationRecord;

/// Stopping criteria and step limits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NewtonParams {
    /// Allowed remaining errors.
    pub ends: Ends,
    /// Most iterations.
    pub max_iterations: usize,
    /// Largest change of a pressure in one step, in p_h.
    pub largest_change: f64,
    /// Relative residual of the linear solves.
    pub krylov_tolerance: f64,
    /// Most Krylov iterations in a step.
    pub max_krylov_iterations: usize,
    /// Imbalance of a node, over the entrained flow, above which the attempt stops.
    pub most_imbalance: f64,
    /// Whether a factorisation follows where the cycle is not enough; without it, the attempt ends there.
    pub factorises: bool,
    /// Whether steps between rough surfaces are shortened as a whole, not node by node.
    pub damped: bool,
}

impl Default for NewtonParams {
    fn default() -> NewtonParams {
        NewtonParams {
            ends: Ends::of(0.0),
            max_iterations: 30,
            largest_change: 0.4,
            krylov_tolerance: 1e-2,
            max_krylov_iterations: 60,
            most_imbalance: f64::INFINITY,
            factorises: true,
            damped: false,
        }
    }
}

/// Convergence and effort.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct NewtonInfo {
    /// Whether a further step would change little.
    pub converged: bool,
    /// Iterations, with as many preconditioners.
    pub iterations: usize,
    /// Krylov iterations in all.
    pub krylov_iterations: usize,
    /// Largest change of a pressure in the last step, in p_h.
    pub change: f64,
    /// Largest mass imbalance of a wetted node before it, over the entrained flow.
    pub imbalance: f64,
    /// Whether the observer asked to stop.
    pub interrupted: bool,
    /// Wall seconds of the equation with its derivatives, the factorisations and the Krylov iterations.
    pub seconds: [f64; 3],
}

impl NewtonInfo {
    /// Adds the effort of this run to a later one, whose result counts.
    #[must_use]
    pub fn and(self, next: NewtonInfo) -> NewtonInfo {
        NewtonInfo {
            iterations: self.iterations + next.iterations,
            krylov_iterations: self.krylov_iterations + next.krylov_iterations,
            seconds: [0, 1, 2].map(|i: usize| self.seconds[i] + next.seconds[i]),
            ..next
        }
    }
}

/// Imbalance of a node, over the entrained flow, below which mass is conserved where contents are unknown: pressures before a meniscus are so low that their
/// changes do not show the mass that moves it.
const MOST_IMBALANCE: f64 = 1e-3;

/// Largest mass imbalance of a wetted node, over the entrained flow.
fn imbalance(system: &System, at: &Linearised) -> f64 {
    let [i, j] = system.grid.centre();
    let wetted = at
        .outflow
        .iter()
        .zip(&at.wetted)
        .filter(|(_, wetted)| **wetted);
    let largest = wetted.fold(0.0_f64, |m, (outflow, _)| m.max(outflow.abs()));
    largest * system.grid.spacing[0] / at.nodes[system.grid.index(i, j)].film.abs()
}

/// Updates this far below tolerance end the iteration between smooth surfaces even if the mass balance is open: the linear solves cannot close it further in thick films far from the contact.
const NEGLIGIBLE_UPDATE: f64 = 2e-2;

/// Between rough surfaces tighter linear solves then close it, to a multiple of its end or until three steps leave nearly all of its error: at low speeds pressures of 1e-7 p_h drive as much oil
/// around the contact as passes through it, and the edge of the broken film moves by few nodes in each step. Balances of 10 % were left open; with linear solves to 1e-5 a bearing took twice as long.
const CLOSING_TOLERANCE: f64 = 1e-3;
const CLOSED: f64 = 10.0;
const STALLED: f64 = 0.98;

/// Mass that a node with pressure may gain, over the entrained flow there. Nodes by the ridge gain most.
const MOST_GAIN: f64 = 5e-2;

/// How far the iteration has come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Ending {
    /// The next step counts.
    Open,
    /// But for the mass balance, it has converged.
    Unbalanced,
    /// It has converged.
    Converged,
}

/// How far the iteration has come.
fn ending(
    system: &System,
    state: &State,
    at: &Linearised,
    progress: &mut Progress,
    ends: &Ends,
) -> Ending {
    let [film, pressure, load] = progress.remaining();
    let is_kept = at.contents.is_empty() || imbalance(system, at) < MOST_IMBALANCE;
    if !(film < ends.film && pressure < ends.pressure && load < ends.load && is_kept) {
        return Ending::Open;
    }
    let h = system.grid.spacing[0];
    let is_kept_by_nodes =
        (at.nodes.iter().zip(&at.outflow).zip(&at.wetted)).all(|((node, outflow), wetted)| {
            !wetted || (outflow * h).abs() < MOST_GAIN * node.mass.abs()
        });
    let open = balance_error(system, at)
        .abs()
        .max(entered(system, state, at));
    let [last, second, before] = progress.open_balances;
    progress.open_balances = [open, last, second];
    let is_negligible =
        film < NEGLIGIBLE_UPDATE * ends.film && pressure < NEGLIGIBLE_UPDATE * ends.pressure;
    let is_done = system.rough.is_none() || open < CLOSED * ends.balance || open > STALLED * before;
    match is_negligible {
        _ if is_kept_by_nodes && open < ends.balance => Ending::Converged,
        true if is_done => Ending::Converged,
        true => Ending::Unbalanced,
        false => Ending::Open,
    }
}

/// Moves the pressures between smooth surfaces on by a step, each by at most `most` and not below zero; returns the largest change.
fn move_pressures(
    (system, at): (&System, &Linearised),
    (state, step): (&mut State, &Step),
    most: f64,
    moved: &mut [f64],
) -> f64 {
    let [nx, _] = system.grid.n;
    let is_given = |k: usize| !system.grid.is_unknown(k % nx, k / nx);
    let mut largest = 0.0;
    for (k, (p, change)) in state.pressure.iter_mut().zip(&step.pressure).enumerate() {
        // Not `clamp`: it would turn NaN into a bound.
        let next = *p
            + if change.abs() > most {
                most.copysign(*change)
            } else {
                *change
            };
        // The active set uses the full Newton step, not the limited one: otherwise nodes at the edge of the film oscillate.
        state.wetted[k] = at.wetted[k] && next > 0.0;
        // Zero pressure where the film has cavitated, without the residual of the linear solver.
        let next = match at.wetted[k] {
            true => next.max(0.0),
            false if is_given(k) => *p,
            false => 0.0,
        };
        // Not `max`: it would lose NaN.
        let size = (next - *p).abs();
        if size > largest || !change.is_finite() {
            largest = if change.is_finite() { size } else { f64::NAN };
        }
        *p = next;
        moved[k] = size;
    }
    largest
}

/// The smallest share of a damped step.
const SHORTEST_STEP: f64 = 0.01;

/// Share of a step that changes no pressure of the oil by more than `most`.
fn share_of_step(at: &Linearised, step: &Step, films: &[f64], most: f64) -> f64 {
    let nodes = at.touching.iter().zip(step.pressure.iter().zip(films));
    let changes = nodes.map(|(of, (p, film))| of.change_of_oil(*p, *film) + of.slack);
    let largest = changes
        .zip(&at.wetted)
        .filter(|(_, wetted)| **wetted)
        .fold(0.0_f64, |largest, (change, _)| largest.max(change.abs()));
    (most / largest).clamp(SHORTEST_STEP, 1.0)
}

/// Moves the pressures of oil and asperities between rough surfaces on by a step; returns the largest change, and the share of the step. No pressure falls below zero. Each changes by at
/// most `most`; in a damped step all of them by the same share of the step, so that the deflection follows them.
fn move_parts(
    (system, at): (&System, &Linearised),
    (state, step): (&mut State, &Step),
    (most, damped): (f64, bool),
    moved: &mut [f64],
) -> [f64; 2] {
    let grid = &system.grid;
    let films = system.change_of_film(&step.pressure, step.separation);
    let share = match damped {
        true => share_of_step(at, step, &films, most),
        false => 1.0,
    };
    let mut largest = 0.0;
    for (k, [i, j]) in grid.nodes().enumerate() {
        let of = &at.touching[k];
        if !grid.is_unknown(i, j) {
            state.wetted[k] = false;
            continue;
        }
        let change = of.change_of_oil(step.pressure[k], films[k]) + of.slack;
        // Not `clamp`: it would turn NaN into a bound.
        let limited = |change: f64| match change.abs() > most {
            _ if damped => share * change,
            true => most.copysign(change),
            false => change,
        };
        let next = state.oil[k] + limited(change);
        state.wetted[k] = at.wetted[k] && next > 0.0;
        let next = if at.wetted[k] { next.max(0.0) } else { 0.0 };
        // The asperities bear the rest, no less than nothing.
        let [touch, slope] = of.pressure;
        let pressure = match damped {
            true => (state.pressure[k] + share * step.pressure[k]).max(next),
            false => next + (touch + limited(slope * films[k])).max(0.0),
        };
        let size = (pressure - state.pressure[k]).abs();
        moved[k] = size;
        let size = size.max((next - state.oil[k]).abs());
        if size > largest || !change.is_finite() {
            largest = if change.is_finite() { size } else { f64::NAN };
        }
        state.oil[k] = next;
        state.pressure[k] = pressure;
    }
    [largest, share]
}

/// Nodes by which the edge of the broken film may move in one step, in addition to the next one, where only the mass balance is open. Without them a bearing took twice as long; with six, the edge passed its place and came back.
const REACH: usize = 2;

/// Wets the surroundings of nodes that have just filled and hold pressure; the next step dries those that do not fill.
fn spread(system: &System, state: &mut State, filled: &[usize]) {
    let [nx, ny] = system.grid.n;
    let holding: Vec<usize> = (filled.iter().copied())
        .filter(|k| state.wetted[*k])
        .collect();
    for k in holding {
        let [i, j] = [k % nx, k / nx];
        let columns = i.saturating_sub(REACH)..(i + REACH + 1).min(nx);
        for row in j.saturating_sub(REACH)..(j + REACH + 1).min(ny) {
            state.wetted[row * nx..][columns.clone()].fill(true);
        }
    }
}

/// Solves on a grid, starting from `state` and ending with the solution in it. `film_scale` is a²/R in m.
pub fn newton(
    system: &System,
    pattern: &Pattern,
    state: &mut State,
    params: &NewtonParams,
    (level, film_scale): (usize, f64),
    observer: &mut dyn Observer,
) -> NewtonInfo {
    let mut info = NewtonInfo::default();
    let [i, j] = system.grid.centre();
    let centre = system.grid.index(i, j);
    let mut linear = GmresParams {
        tolerance: params.krylov_tolerance,
        max_iterations: params.max_krylov_iterations,
        // A loose tolerance.
        twice: false,
    };
    let mut direct = false;
    let mut progress = Progress::default();
    // A step from an unfinished linear solve, or a share of one, is no evidence of convergence.
    let mut exact = false;
    loop {
        if observer.cancelled() {
            info.interrupted = true;
            return info;
        }
        let clock = Instant::now();
        let at = system.linearise(state);
        progress.note_films(system, &at);
        let ending = match exact {
            true => ending(system, state, &at, &mut progress, &params.ends),
            false => Ending::Open,
        };
        info.seconds[0] += clock.elapsed().as_secs_f64();
        let is_last = info.iterations == params.max_iterations;
        if ending == Ending::Converged || (ending == Ending::Unbalanced && is_last) {
            state.contents = at.contents;
            info.converged = true;
            return info;
        }
        if is_last {
            return info;
        }
        if ending == Ending::Unbalanced {
            linear.tolerance = linear.tolerance.min(CLOSING_TOLERANCE);
        }
        let clock = Instant::now();
        let approximated = match direct {
            true => Preconditioner::factorised(pattern, &at),
            false => Preconditioner::new(pattern, &at)
                .or_else(|| Preconditioner::factorised(pattern, &at)),
        };
        let Some(mut preconditioner) = approximated else {
            return info;
        };
        info.seconds[1] += clock.elapsed().as_secs_f64();
        let clock = Instant::now();
        state.contents.clone_from(&at.contents);
        let mut step = system.step(&at, state, &mut preconditioner, linear);
        let failed =
            step.krylov_iterations >= params.max_krylov_iterations || !step.separation.is_finite();
        if failed && !params.factorises {
            return info;
        }
        if failed && !preconditioner.is_direct {
            // The cycle is not enough: a factorisation from here on.
            direct = true;
            info.krylov_iterations += step.krylov_iterations;
            if let Some(mut factorised) = Preconditioner::factorised(pattern, &at) {
                step = system.step(&at, state, &mut factorised, linear);
            }
        }
        info.seconds[2] += clock.elapsed().as_secs_f64();
        info.iterations += 1;
        info.krylov_iterations += step.krylov_iterations;
        let mut moved = vec![0.0; step.pressure.len()];
        let has_filled = |k: &usize| at.wetted[*k] && !state.wetted[*k];
        let filled: Vec<usize> = match ending {
            Ending::Unbalanced => (0..moved.len()).filter(has_filled).collect(),
            _ => Vec::new(),
        };
        let most = params.largest_change;
        let mut share = 1.0;
        if at.touching.is_empty() {
            info.change = move_pressures((system, &at), (state, &step), most, &mut moved);
        } else {
            let limits = (most, params.damped);
            [info.change, share] = move_parts((system, &at), (state, &step), limits, &mut moved);
        }
        state.separation += share * step.separation;
        spread(system, state, &filled);
        // Around thick films all pressures are far below that of the dry contact.
        let largest = state.pressure.iter().fold(0.0_f64, |m, p| m.max(*p));
        if largest < 1.0 && largest > 0.0 {
            info.change /= largest;
        }
        let load = system.integral(&state.pressure);
        let moved_load = if load > 0.0 {
            system.integral(&moved) / load
        } else {
            0.0
        };
        info.imbalance = imbalance(system, &at);
        if info.imbalance > params.most_imbalance {
            return info;
        }
        // A diverged step is not reported: the next attempt starts again.
        if !(info.change.is_finite() && state.separation.is_finite()) {
            return info;
        }
        observer.iteration(&IterationRecord {
            level,
            pressure_order: 1,
            penalty_share: 1.0,
            iteration: info.iterations,
            residual: info.imbalance,
            update: info.change,
            step: share,
            krylov_iterations: step.krylov_iterations,
            film_central: film_scale * at.nodes[centre].film,
            heat: None,
        });
        exact = step.krylov_iterations < params.max_krylov_iterations && share == 1.0;
        progress.note_step(info.change, moved_load);
    }
}
