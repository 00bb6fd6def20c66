//! When Newton's method ends on a grid: when the next step would change the figures by far less than their errors.
//!
//! ```text
//!   remaining error of x after a step:  |δ_n| min(1, |δ_n|/|δ_(n−1)|)        x: ln H of the nodes with pressure, P, ∫|P| dA
//! ```
//! Films converge two or three iterations before the pressures by the ridge, which no grid resolves and whose error bars are 0.1 p_h. Pressures far from a thick film are
//! small, but carry much of the load: the load of all changes must be small as well.

use super::grid::Grid;
use super::system::{Linearised, State, System};

/// Allowed remaining errors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ends {
    /// Film at any node with pressure, relative.
    pub film: f64,
    /// Pressure, in p_h.
    pub pressure: f64,
    /// Mass balance of the whole film, over the flow through its centre.
    pub balance: f64,
    /// Load of the pressure changes, relative.
    pub load: f64,
}

impl Ends {
    /// For films with some relative error. Measured: with an error of 1e-3 in the film at the ridge, central and minimum film are accurate to 2e-5 or better,
    /// a thirtieth of their bars.
    pub fn of(target_error: f64) -> Ends {
        let film = (SHARE * target_error).clamp(LEAST_END, MOST_END);
        Ends {
            film,
            pressure: PRESSURE * film,
            balance: film,
            load: LOAD * film,
        }
    }
}

/// Remaining error of the film at the ridge, over the target error; and that of the pressure there, over that of the film: at most 0.03 p_h for a ridge of p_h,
/// whose error bars from the grids are 0.1 p_h.
const SHARE: f64 = 0.5;
const PRESSURE: f64 = 30.0;

/// Remaining error of the load, over that of the films: a film in the isoviscous rigid regime, the thickest, is inversely proportional to it.
const LOAD: f64 = 0.1;

/// Limits of the allowed error of the film.
const LEAST_END: f64 = 1e-5;
const MOST_END: f64 = 1e-3;

/// History of the steps on a grid.
#[derive(Debug)]
pub struct Progress {
    /// H before the last step, and changes by the last steps, the newest first.
    films: Vec<f64>,
    film: [f64; 2],
    pressure: [f64; 2],
    load: [f64; 2],
    /// Errors of the mass balance when films and pressures last met their ends, the newest first.
    pub open_balances: [f64; 3],
}

/// Smallest film for relative changes, over the central film: coarse grids have films near zero.
pub const LEAST_FILM: f64 = 0.1;

/// Share of a change that the linear solves may leave.
const LEAST_SHARE: f64 = 0.02;

impl Default for Progress {
    fn default() -> Progress {
        Progress {
            films: Vec::new(),
            film: [0.0; 2],
            pressure: [0.0; 2],
            load: [0.0; 2],
            open_balances: [f64::INFINITY; 3],
        }
    }
}

impl Progress {
    /// Notes the largest change of a pressure in a step, and the load of all changes over that of the pressures.
    pub fn note_step(&mut self, change: f64, load: f64) {
        self.pressure = [change, self.pressure[0]];
        self.load = [load, self.load[0]];
    }

    /// Notes the films after a step.
    pub fn note_films(&mut self, system: &System, at: &Linearised) {
        let [i, j] = system.grid.centre();
        let least_gap = (system.rough.as_ref()).map_or(0.0, |rough| rough.least_gap());
        let least = (LEAST_FILM * at.nodes[system.grid.index(i, j)].film.abs()).max(least_gap);
        let changes = at.nodes.iter().zip(&self.films).zip(&at.wetted);
        let largest = changes
            .filter(|(_, wetted)| **wetted)
            .map(|((node, before), _)| (node.film - before).abs() / node.film.abs().max(least))
            .fold(0.0, f64::max);
        self.film = [largest, self.film[0]];
        self.films.clear();
        self.films.extend(at.nodes.iter().map(|node| node.film));
    }

    /// Remaining errors of the films, the pressures and the load.
    pub fn remaining(&self) -> [f64; 3] {
        [self.film, self.pressure, self.load].map(|[last, before]| {
            let share = if before > 0.0 { last / before } else { 1.0 };
            last * share.clamp(LEAST_SHARE, 1.0)
        })
    }
}

/// Mass that a grid gains or loses in all nodes whose balance is solved, over the flow through the section at its centre.
pub fn balance_error(system: &System, at: &Linearised) -> f64 {
    let grid = &system.grid;
    gained(
        system,
        at,
        |k| at.wetted[k] || !at.contents.is_empty(),
        |outflow| outflow,
    ) / passing(grid, at)
}

/// The same of the nodes that have too little outflow for a broken film since the last step.
pub fn entered(system: &System, state: &State, at: &Linearised) -> f64 {
    gained(system, at, |k| at.wetted[k] && !state.wetted[k], f64::abs) / passing(&system.grid, at)
}

/// Sum over the unknown nodes of a kind.
fn gained(
    system: &System,
    at: &Linearised,
    counts: impl Fn(usize) -> bool,
    of: impl Fn(f64) -> f64,
) -> f64 {
    let grid = &system.grid;
    (grid.nodes().enumerate())
        .filter(|(k, [i, j])| counts(*k) && grid.is_unknown(*i, *j))
        .map(|(k, [i, j])| grid.share(i, j) * grid.cell(j) * of(at.outflow[k]))
        .sum()
}

/// Flow through the section at the centre, along or across the grid; in time, that at the reference speed, as speeds may vanish.
fn passing(grid: &Grid, at: &Linearised) -> f64 {
    let [i, j] = grid.centre();
    let in_time = at.storage_rate > 0.0;
    let through = |direction: usize, nodes: &mut dyn Iterator<Item = [usize; 2]>| -> f64 {
        let flux = |[i, j]: [usize; 2]| match in_time {
            true => at.nodes[grid.index(i, j)].mass,
            false => at.faces[direction][grid.index(i, j)].flux,
        };
        nodes
            .map(|at| grid.share(at[0], at[1]) * grid.length(1 - direction, at[1]) * flux(at))
            .sum::<f64>()
    };
    let along = through(0, &mut (0..grid.n[1]).map(|j| [i, j]));
    let across = through(1, &mut (0..grid.n[0]).map(|i| [i, j]));
    along.abs().max(across.abs())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::Planar;
    use crate::volumes::tests::system;
    use approx::assert_relative_eq;

    /// By hand: a node of 0.25 by 0.35 gains 1 per area; through the seven inner rows of 0.35 at the centre passes a film of 0.5 at the cosine of 0.3 to the rows.
    #[test]
    fn mass_gained_over_the_flow_through_the_centre() {
        let (mut system, mut state) = system(false, Planar::along_x(1.0));
        system.gap.fill(0.5);
        state.pressure.fill(0.0);
        state.wetted.fill(false);
        state.separation = 0.0;
        let mut at = system.linearise(&state);
        let [i, j] = system.grid.centre();
        let k = system.grid.index(i, j);
        at.outflow.fill(0.0);
        at.wetted.fill(false);
        (at.outflow[k], at.wetted[k]) = (1.0, true);
        let passing = system.fluid.at(0.0).density[0] * 0.5 * 0.3_f64.cos() * 7.0 * 0.35;
        let found = balance_error(&system, &at);
        assert_relative_eq!(found, 0.25 * 0.35 / passing, max_relative = 1e-9);
    }
}
