//! When Newton's method ends on a grid: when what the next step would change is far below what the figures are told to.
//!
//! ```text
//!   left of x after a step:  |δ_n| min(1, |δ_n|/|δ_(n−1)|)        x: ln H of the nodes with pressure, P, ∫|P| dA
//! ```
//! Films settle two or three iterations before the pressures by the ridge, which no grid resolves: those have bars of a tenth of p_h. Pressures far from a thick film are
//! small, but carry much of the load: that of all changes together counts as well.

use super::grid::Grid;
use super::system::{Linearised, State, System};

/// What may be left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ends {
    /// Of the film at any node with pressure, relative.
    pub film: f64,
    /// Of a pressure, in p_h.
    pub pressure: f64,
    /// Of the balance of the whole film, over what passes through its centre.
    pub balance: f64,
    /// Of the load that pressures change by, relative.
    pub load: f64,
}

impl Ends {
    /// For films with some relative error. Measured: where the film at the ridge is left with 1e-3, central and minimum film are right to 2e-5 and less,
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

/// Share of the error of the films that is left of them at the ridge, and what is left of its pressure then: of a ridge of p_h it is 0.03 p_h at most,
/// where the grids tell it with bars of 0.1 p_h.
const SHARE: f64 = 0.5;
const PRESSURE: f64 = 30.0;

/// Share of what is left of the films that is left of the load: a film in the isoviscous rigid regime, the thickest, is inversely proportional to it.
const LOAD: f64 = 0.1;

/// Ends by the films of targets as small and as large as can be.
const LEAST_END: f64 = 1e-5;
const MOST_END: f64 = 1e-3;

/// How the steps on a grid have gone.
#[derive(Debug, Default)]
pub struct Progress {
    /// H before the last step, and changes by the last steps, the newest first.
    films: Vec<f64>,
    film: [f64; 2],
    pressure: [f64; 2],
    load: [f64; 2],
}

/// Share of the central film that others count as at least: coarse grids have films about zero.
pub const LEAST_FILM: f64 = 0.1;

/// Share of a change that the linear solves may leave.
const LEAST_SHARE: f64 = 0.02;

impl Progress {
    /// Notes the largest change of a pressure in a step, and the load of all changes over that of the pressures.
    pub fn note_step(&mut self, change: f64, load: f64) {
        self.pressure = [change, self.pressure[0]];
        self.load = [load, self.load[0]];
    }

    /// Notes the films after a step.
    pub fn note_films(&mut self, system: &System, at: &Linearised) {
        let [i, j] = system.grid.centre();
        let least = LEAST_FILM * at.nodes[system.grid.index(i, j)].film.abs();
        let changes = at.nodes.iter().zip(&self.films).zip(&at.wetted);
        let largest = changes
            .filter(|(_, wetted)| **wetted)
            .map(|((node, before), _)| (node.film - before).abs() / node.film.abs().max(least))
            .fold(0.0, f64::max);
        self.film = [largest, self.film[0]];
        self.films.clear();
        self.films.extend(at.nodes.iter().map(|node| node.film));
    }

    /// What is left of the films, of the pressures, and of the load that changes.
    pub fn left(&self) -> [f64; 3] {
        [self.film, self.pressure, self.load].map(|[last, before]| {
            let share = if before > 0.0 { last / before } else { 1.0 };
            last * share.clamp(LEAST_SHARE, 1.0)
        })
    }
}

/// Mass that a grid gains or loses in all nodes whose balance is solved, over what passes the section through its centre.
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

/// What passes the section through the centre, along or across the grid; in time, what would at the speed of reference, as speeds may vanish.
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
