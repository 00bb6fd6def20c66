//! Temperatures of the film and of the surfaces of both bodies at given films.
//!
//! ```text
//!   film:  R(T) = 0 at the inner nodes          walls:  T_w − T_beyond − K * q(T) = 0,  q = −R at the walls
//! ```
//! Newton's method; the linear equations are those of the walls alone, as the film follows from them by a march along the flow.

use std::sync::Arc;

use ertel_fem::linear::gmres::{GmresParams, gmres};

use super::columns::{Columns, FilmHeat, Films};
use super::source::MovingBody;
use super::spreading::Spreading;
use super::transport::{Moved, Sweeps, Transport};
use crate::film::{FilmNodes, MOST_NODES, Nodal, TemperatureProfile};
use crate::forms::energy::{Heat, Heights};
use crate::volumes::faces::Face;
use crate::volumes::grid::Grid;

/// Temperatures at the nodes of a grid and the heat that flows into the bodies.
#[derive(Clone, Debug, Default)]
pub struct Temperatures {
    /// At the nodes of the film, from body 1 to body 2, node by node, K.
    pub film: Vec<f64>,
    /// Heat into both bodies, W/m².
    pub flux: [Vec<f64>; 2],
}

impl Temperatures {
    /// Nodes across the film.
    pub fn n_nodes(&self) -> usize {
        self.film.len() / self.flux[0].len()
    }

    /// Those across the film at a node.
    pub fn profile(&self, k: usize) -> TemperatureProfile {
        let f = self.n_nodes();
        let mut profile = TemperatureProfile::default();
        profile.temperature[..f].copy_from_slice(&self.film[k * f..][..f]);
        profile
    }
}

/// Both bodies under a grid.
#[derive(Clone)]
pub struct Bodies {
    own: [MovingBody; 2],
    /// Their depth, half-widths.
    pub depth: f64,
    /// Rates at which they spin, m/s over a half-width.
    spins: [f64; 2],
    /// Size of a cell, m.
    cell: [f64; 2],
    spreading: [Arc<Spreading>; 2],
    /// Temperatures of both surfaces without the heat of this grid, K.
    pub outer: [Vec<f64>; 2],
}

/// Data of a body, at its bulk temperature.
pub fn moving_body(heat: &Heat, b: usize, grid: &Grid, depth: f64) -> MovingBody {
    let body = &heat.bodies[b];
    let t = body.bulk_temperature;
    MovingBody {
        layers: body.layers.clone(),
        conductivity: body.conductivity.conductivity(0.0, t),
        capacity: body.density * body.heat_capacity.heat_capacity(0.0, t),
        velocity: grid.turn.to_axes(body.velocity.centre),
        depth: depth * heat.length,
        stretch: 1.0,
    }
}

impl Bodies {
    /// Below a grid, with no heat beyond it, down to a depth in half-widths. The kernel of an equal body of `others` below the same grid is reused.
    pub fn new(grid: &Grid, heat: &Heat, depth: f64, others: Option<&Bodies>) -> Bodies {
        let own = [0, 1].map(|b: usize| moving_body(heat, b, grid, depth));
        let cell = grid.cell_size(heat.length);
        let spins = [0, 1].map(|b: usize| heat.bodies[b].velocity.spin);
        Bodies {
            spreading: [0, 1].map(|b: usize| match others {
                Some(others)
                    if others.own[b] == own[b]
                        && others.spins[b] == spins[b]
                        && others.cell == cell =>
                {
                    Arc::clone(&others.spreading[b])
                }
                _ => Arc::new(Spreading::new(grid, &own[b], heat.length, spins[b])),
            }),
            outer: [0, 1].map(|b: usize| vec![heat.bodies[b].bulk_temperature; grid.n_nodes()]),
            spins,
            cell,
            own,
            depth,
        }
    }

    /// Below a grid at an instant, by how both surfaces heat by what flows in then, and their temperatures without it.
    pub fn at_instant(
        grid: &Grid,
        heat: &Heat,
        depth: f64,
        spreading: [Spreading; 2],
        outer: [Vec<f64>; 2],
    ) -> Bodies {
        Bodies {
            own: [0, 1].map(|b: usize| moving_body(heat, b, grid, depth)),
            spreading: spreading.map(Arc::new),
            spins: [0.0; 2],
            cell: grid.cell_size(heat.length),
            outer,
            depth,
        }
    }

    /// Share of the heat that flows in, of the body with the larger one, outside the map of a spinning surface.
    pub fn lost(&self, grid: &Grid, flux: &[Vec<f64>; 2]) -> f64 {
        let share = |b: usize| {
            let mut sums = [0.0; 2];
            for [i, j] in grid.nodes() {
                let heat = grid.share(i, j) * flux[b][grid.index(i, j)].abs();
                sums[0] += heat;
                if self.spreading[b].has_lost(grid.on_axes(i, j)) {
                    sums[1] += heat;
                }
            }
            if sums[0] > 0.0 {
                sums[1] / sums[0]
            } else {
                0.0
            }
        };
        share(0).max(share(1))
    }

    /// Rise of the surface of a body by heat at the nodes, K.
    pub fn rise(&self, grid: &Grid, body: usize, flux: &[f64]) -> Vec<f64> {
        self.spreading[body].apply(&grid.within_edges(flux))
    }
}

/// Largest change of a temperature in a step, and the largest undershoot below the coldest inlet temperature, K, as in the finite elements.
const LARGEST_CHANGE: f64 = 60.0;
const BELOW: f64 = 2.0;

/// Tolerance of the wall equations.
const OF_WALLS: GmresParams = GmresParams {
    tolerance: 1e-2,
    max_iterations: 80,
    twice: true,
};

/// Most sweeps, and the relative change in a sweep at which a step is as accurate as the wall equations.
const MOST_SWEEPS: usize = 16;
const SWEEP_TOLERANCE: f64 = 1e-2;

/// Result of a step.
#[derive(Clone, Copy, Debug, Default)]
pub struct StepInfo {
    /// Largest change of a temperature, K.
    pub change: f64,
    /// Krylov iterations.
    pub krylov_iterations: usize,
    /// Sweeps of each.
    pub sweeps: usize,
    /// Whether the equations are finite.
    pub is_finite: bool,
}

/// One Newton step; also returns the equations before it.
pub fn step(
    of: &FilmHeat,
    bodies: &Bodies,
    films: &Films,
    faces: &[Vec<Face>; 2],
    temperatures: &mut Temperatures,
) -> (Columns, StepInfo) {
    let grid = of.grid;
    let f = of.nodes();
    let columns = Columns::new(of, films);
    let mut info = StepInfo {
        is_finite: columns.is_finite(),
        ..StepInfo::default()
    };
    if !info.is_finite {
        return (columns, info);
    }
    let transport = Transport::new(of, &columns, faces, &temperatures.film);
    note_flux(transport.residual(), transport.unknown(), f, temperatures);
    let missing = missing(grid, bodies, f, temperatures);
    let rows: Vec<f64> = transport.residual().iter().map(|r| -r).collect();
    let by_krylov =
        |apply: &dyn Fn(&[f64], &mut [f64]), right: &[f64], walls: &mut [f64]| match gmres(
            apply,
            |_| (),
            right,
            walls,
            OF_WALLS,
        ) {
            Ok(info) => info.iterations,
            Err(error) => error.iterations,
        };
    let found = change(
        &transport,
        grid,
        bodies,
        (&rows, &missing),
        Sweeps::UpTo(MOST_SWEEPS, SWEEP_TOLERANCE),
        by_krylov,
    );
    (info.krylov_iterations, info.sweeps) = (found.krylov_iterations, found.sweeps);
    let temperature = found.temperature;
    let heat = of.heat;
    let coldest = (heat.bodies.iter())
        .map(|body| body.bulk_temperature)
        .fold(heat.inlet_temperature, f64::min);
    for (t, change) in temperatures.film.iter_mut().zip(&temperature) {
        let next = (*t + change.clamp(-LARGEST_CHANGE, LARGEST_CHANGE)).max(coldest - BELOW);
        info.change = info.change.max((next - *t).abs());
        *t = next;
    }
    (columns, info)
}

/// Changes of temperatures for which the equations of the film change by `rows` and those of the walls by `missing`.
pub struct Change {
    /// Node by node, K.
    pub temperature: Vec<f64>,
    /// Heat into both bodies by them, W/m².
    pub flux: [Vec<f64>; 2],
    /// Krylov iterations.
    pub krylov_iterations: usize,
    /// Sweeps of each.
    pub sweeps: usize,
}

/// Solves for them with sweeps over the film, the last of `solve`'s arguments by its equations of the walls; returns its iterations.
pub fn change(
    transport: &Transport,
    grid: &Grid,
    bodies: &Bodies,
    (rows, missing): (&[f64], &[Vec<f64>; 2]),
    sweeps: Sweeps,
    solve: impl FnOnce(&dyn Fn(&[f64], &mut [f64]), &[f64], &mut [f64]) -> usize,
) -> Change {
    let n = grid.n_nodes();
    let zeros = vec![0.0; n];
    let still = [zeros.as_slice(), zeros.as_slice()];
    // Heat from the residual of the film spreads, too.
    let own = transport.moved(still, Some(rows), sweeps);
    let sweeps = match sweeps {
        Sweeps::UpTo(..) => Sweeps::Count(own.sweeps),
        Sweeps::Count(_) => sweeps,
    };
    let by_own = [0, 1].map(|b: usize| bodies.rise(grid, b, &own.flux[b]));
    let mut right = vec![0.0; 2 * n];
    for k in transport.unknown().iter().map(|k| *k as usize) {
        for b in 0..2 {
            right[b * n + k] = missing[b][k] + by_own[b][k];
        }
    }
    let apply = |x: &[f64], y: &mut [f64]| {
        let moved = transport.moved([&x[..n], &x[n..]], None, sweeps);
        y.copy_from_slice(x);
        for b in 0..2 {
            let rise = bodies.rise(grid, b, &moved.flux[b]);
            for k in transport.unknown().iter().map(|k| *k as usize) {
                y[b * n + k] -= rise[k];
            }
        }
    };
    let mut walls = vec![0.0; 2 * n];
    let krylov_iterations = solve(&apply, &right, &mut walls);
    let Moved {
        temperature, flux, ..
    } = transport.moved([&walls[..n], &walls[n..]], Some(rows), sweeps);
    Change {
        temperature,
        flux,
        krylov_iterations,
        sweeps: own.sweeps,
    }
}

/// Heat into the bodies by the equations of the walls.
pub(super) fn note_flux(
    residual: &[f64],
    unknown: &[u32],
    f: usize,
    temperatures: &mut Temperatures,
) {
    for k in unknown.iter().map(|k| *k as usize) {
        let rows = &residual[k * f..][..f];
        temperatures.flux[0][k] = -rows[0];
        temperatures.flux[1][k] = -rows[f - 1];
    }
}

/// Wall residual: the temperature of the surfaces by the heat into the bodies, minus their own, K.
pub(super) fn missing(
    grid: &Grid,
    bodies: &Bodies,
    f: usize,
    temperatures: &Temperatures,
) -> [Vec<f64>; 2] {
    [0, 1].map(|b: usize| {
        let mut missing = bodies.rise(grid, b, &temperatures.flux[b]);
        for (k, value) in missing.iter_mut().enumerate() {
            let node = k * f + if b == 0 { 0 } else { f - 1 };
            *value += bodies.outer[b][k] - temperatures.film[node];
        }
        missing
    })
}

/// Inlet temperatures of lubricant and bodies, across the film, K.
pub fn column(heat: &Heat, f: usize) -> Nodal {
    let nodes = FilmNodes::new(f - 1);
    let mut column = [0.0; MOST_NODES];
    for (t, s) in column.iter_mut().zip(nodes.points()) {
        *t = heat.entering(*s, f - 1);
    }
    column
}

/// The same at all nodes.
pub fn unheated(grid: &Grid, heat: &Heat, f: usize) -> Temperatures {
    Temperatures {
        film: column(heat, f)[..f].repeat(grid.n_nodes()),
        flux: [0, 1].map(|_| vec![0.0; grid.n_nodes()]),
    }
}

/// Heat of the film and of both bodies per area of each unknown node: of shear, compression and its size, carried by the lubricant, into the bodies, W/m².
#[derive(Clone)]
pub struct Account {
    /// At each node.
    pub made: Vec<[f64; 3]>,
    /// Likewise.
    pub carried: Vec<f64>,
}

/// Heat balance at given temperatures, which set the heat into the bodies.
pub fn account(
    of: &FilmHeat,
    films: &Films,
    faces: &[Vec<Face>; 2],
    temperatures: &mut Temperatures,
) -> Account {
    let columns = Columns::new(of, films);
    let transport = Transport::new(of, &columns, faces, &temperatures.film);
    note_flux(
        transport.residual(),
        transport.unknown(),
        of.nodes(),
        temperatures,
    );
    let mut carried = transport.carried().to_vec();
    // Where temperatures are given, the lubricant carries off the heat made, except the known part into the bodies.
    for (k, carried) in carried.iter_mut().enumerate() {
        if !of.grid.is_unknown(k % of.grid.n[0], k / of.grid.n[0]) {
            let [shear, compression, _] = columns.made[k];
            *carried = shear + compression - temperatures.flux[0][k] - temperatures.flux[1][k];
        }
    }
    Account {
        carried,
        made: columns.made.clone(),
    }
}

/// Heights for the nodes of a film.
pub fn heights(of: &crate::film::FilmFluid) -> Option<Heights> {
    of.nodes().map(Heights::new)
}

/// Effort on the heat of a grid.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Effort {
    /// Rounds of film and heat.
    pub rounds: usize,
    /// Ratio by which changes shrank from round to round.
    pub contraction: f64,
    /// The last change.
    pub change: f64,
    /// Whether film and heat have converged: grids that serve only as a start need not.
    pub settled: bool,
    /// Steps for the temperatures.
    pub iterations: usize,
    /// Krylov iterations for them.
    pub krylov_iterations: usize,
    /// Wall seconds for them.
    pub seconds: f64,
}

/// Heat of a grid.
pub struct Warm {
    /// The bodies below it.
    pub bodies: Bodies,
    /// Temperatures.
    pub temperatures: Temperatures,
    /// Heat made and carried off at each node.
    pub account: Account,
    /// Effort.
    pub effort: Effort,
}
