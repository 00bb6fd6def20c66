//! From a grid to one with cells of half the size on a smaller patch; pressures outside the patch remain fixed.

use std::sync::{Arc, OnceLock};

use super::contents::Edges;
use super::contents::{Arrival, missing};
use super::deflection::Deflection;
use super::grid::Grid;
use super::heat::Warm;
use super::kernel::Kernel;
use super::system::{Balance, State, System};
use crate::contact::Gap;
use crate::engine::Problem;

/// A grid that was solved on.
pub struct Level {
    /// The film equation there.
    pub system: System,
    /// Its solution.
    pub state: State,
    /// H at the nodes.
    pub films: Vec<f64>,
    /// Where the next grid lies on this one: its first and last node here along each direction.
    pub patch: Option<[[usize; 2]; 2]>,
    /// Heat, where it counts.
    pub warm: Option<Warm>,
    /// Contents of the nodes, computed on first use.
    pub contents: OnceLock<Vec<f64>>,
}

impl Level {
    /// Of a state, without heat and without a next grid.
    pub fn new(system: System, state: State) -> Level {
        Level {
            films: system.films(&state),
            system,
            state,
            patch: None,
            warm: None,
            contents: OnceLock::new(),
        }
    }

    /// The state with the pressures of the oil that asperities leave: a common start of differences.
    pub fn settled(&self) -> State {
        let mut state = self.state.clone();
        self.system.settle(&mut state);
        state
    }

    /// Missing oil at each node compared with a full gap, F.
    pub fn missing(&self, k: usize) -> f64 {
        missing(
            self.system.gap_at(self.films[k]),
            self.held()[k],
            self.ambient_density(),
        )
    }

    /// Contents of the nodes, infinite where gaps are full.
    pub fn held(&self) -> &[f64] {
        let faces = |full: &[bool]| (self.system).faces_around(&self.state, &self.films, full);
        (self.contents).get_or_init(|| self.system.held(&self.state, &self.state.contents, faces))
    }

    /// ρ̄ without pressure.
    pub fn ambient_density(&self) -> f64 {
        self.system.fluid.at(0.0).density[0]
    }

    /// Whether the next grid has a node where this one has.
    pub fn is_refined(&self, i: usize, j: usize) -> bool {
        self.patch
            .is_some_and(|[x, y]| (x[0]..=x[1]).contains(&i) && (y[0]..=y[1]).contains(&j))
    }

    /// Share of its cell that a node represents outside the next grid.
    pub fn share(&self, i: usize, j: usize) -> f64 {
        let grid = &self.system.grid;
        let inside = (self.patch).map_or(0.0, |patch| within(patch, grid, i, j));
        grid.share(i, j) - inside * grid.mirrored_share(j)
    }
}

/// Share of the cell of a node that lies on its grid and in a patch of it: for a node on the edge of both, the part of the cell inside both, not a quarter of it.
fn within(patch: [[usize; 2]; 2], grid: &Grid, i: usize, j: usize) -> f64 {
    let along = |d: usize, at: usize| {
        let [low, high] = patch[d];
        let ends = !(grid.half && d == 1);
        let inside = match at {
            _ if at < low || at > high => 0.0,
            // The row of a line contact.
            _ if low == high => 1.0,
            _ if at == low || (at == high && ends) => 0.5,
            _ => 1.0,
        };
        grid.share_along(d, at).min(inside)
    };
    along(0, i) * along(1, j)
}

/// Values at the nodes of a grid, each times the part of its cell outside a patch over the part on the grid.
pub fn outside(grid: &Grid, patch: [[usize; 2]; 2], values: &[f64]) -> Vec<f64> {
    (grid.nodes().zip(values))
        .map(|([i, j], value)| {
            let own = grid.share_along(0, i) * grid.share_along(1, j);
            match own > 0.0 {
                true => value * (1.0 - within(patch, grid, i, j) / own),
                false => 0.0,
            }
        })
        .collect()
}

/// The deflection of the bodies of a problem on a grid.
pub fn convolution<Plan>(problem: &Problem<Plan>, grid: &Grid) -> Arc<Deflection> {
    Arc::new(Deflection::new(grid, Kernel::of(&problem.elasticity)))
}

/// Bodies under a grid, without pressure beyond it.
pub fn first_system<Plan>(
    problem: &Problem<Plan>,
    grid: Grid,
    convolution: Arc<Deflection>,
) -> System {
    let gap = (grid.nodes())
        .map(|[i, j]| problem.shape.gap.value(grid.place(i, j)))
        .collect();
    System {
        convolution,
        gap,
        load: problem.load,
        beyond: None,
        edges: Edges::Rigid(problem.shape.gap.clone()),
        fluid: problem.fluid.clone(),
        lambda: problem.scales.lambda,
        entrainment: problem.entrainment,
        arrival: Arrival::of(problem),
        warmth: Vec::new(),
        storage: None,
        balance: Balance::LOAD,
        rough: (problem.rough.clone()).filter(|rough| rough.is_resolved(grid.spacing[0])),
        grid,
    }
}

/// The dry contact on the first grid, in a film of the start.
pub fn first_state<Plan>(problem: &Problem<Plan>, system: &System) -> State {
    let (grid, zone) = (&system.grid, &problem.shape.zone);
    let mut pressure: Vec<f64> = (grid.nodes())
        .map(|[i, j]| match grid.is_unknown(i, j) {
            true => zone.pressure(grid.place(i, j)),
            false => 0.0,
        })
        .collect();
    // The load of the dry contact as the grid has it.
    let factor = system.load / system.integral(&pressure);
    pressure.iter_mut().for_each(|p| *p *= factor);
    let wetted: Vec<bool> = pressure.iter().map(|p| *p > 0.0).collect();
    let mut state = State {
        contents: system.arrival.contents(&wetted),
        wetted,
        pressure,
        oil: Vec::new(),
        separation: 0.0,
    };
    let [i, j] = grid.centre();
    let films = system.films(&state);
    let least = (system.rough.as_ref()).map_or(0.0, |rough| rough.least_start());
    state.separation = problem.start_film.max(least) - films[grid.index(i, j)];
    system.settle(&mut state);
    state
}

/// System and start of a grid inside that of a level, with nodes at half the distance; sets the patch of the level.
pub fn refined<Plan>(
    problem: &Problem<Plan>,
    before: &mut Level,
    grid: Grid,
    convolution: Arc<Deflection>,
) -> (System, State) {
    let coarse = before.system.grid.clone();
    let sampled = Sampled::new(&coarse, &grid);
    // In numbers of the coarse nodes, from their first one.
    let patch = [0, 1].map(|d: usize| {
        let [low, high] = grid.ends(d);
        [low, high].map(|n| (n / 2 - coarse.first[d]) as usize)
    });
    before.patch = Some(patch);
    let own = &before.state;
    let inside: Vec<f64> = (coarse.nodes().zip(&own.pressure))
        .map(|([i, j], p)| p * within(patch, &coarse, i, j))
        .collect();
    let load_inside: f64 = (coarse.nodes().zip(&inside))
        .map(|([_, j], p)| p * coarse.mirrored_share(j) * coarse.length(1, j))
        .sum::<f64>()
        * coarse.spacing[0];
    let by_inside = before.system.convolution.apply(&inside);
    let outer = beyond(before, &problem.shape.gap, &by_inside);
    let mut system = first_system(problem, grid, convolution);
    if !(system.entrainment.is_along_x() && system.grid.turn.is_none()) {
        let held = before.held();
        let contents = (system.grid.nodes()).map(|[i, j]| sampled.content(held, i, j));
        system.edges = Edges::Known(contents.collect());
    }
    system.load = before.system.load - before.system.integral(&own.pressure) + load_inside;
    let mut pressure = vec![0.0; system.grid.n_nodes()];
    let mut oil = match own.oil.is_empty() {
        true => Vec::new(),
        false => pressure.clone(),
    };
    for [i, j] in system.grid.nodes() {
        let k = system.grid.index(i, j);
        pressure[k] = sampled.linear(&own.pressure, i, j);
        if let Some(oil) = oil.get_mut(k) {
            *oil = sampled.linear(&own.oil, i, j);
        }
        system.gap[k] += sampled.cubic(&outer, i, j);
    }
    let wet = if oil.is_empty() { &pressure } else { &oil };
    let mut state = State {
        contents: match own.contents.is_empty() {
            true => Vec::new(),
            false => (system.grid.nodes().zip(wet))
                .map(|([i, j], p)| match *p > 0.0 {
                    true => f64::INFINITY,
                    false => sampled.content(&own.contents, i, j),
                })
                .collect(),
        },
        wetted: wet.iter().map(|p| *p > 0.0).collect(),
        oil,
        pressure,
        separation: own.separation,
    };
    if state.oil.is_empty() {
        // The first grid that resolves the roughness.
        system.settle(&mut state);
    }
    (system, state)
}

/// Deflection at the nodes of a level by all pressures but those of the next grid.
fn beyond(level: &Level, gap: &Gap, by_inside: &[f64]) -> Vec<f64> {
    let grid = &level.system.grid;
    (grid.nodes().zip(level.films.iter().zip(by_inside)))
        .map(|([i, j], (film, inside))| {
            film - level.state.separation - gap.value(grid.place(i, j)) - inside
        })
        .collect()
}

/// Values of a coarse grid at the nodes of one with half the spacing inside it.
pub struct Sampled<'a> {
    coarse: &'a Grid,
    /// Number of the first fine node from the first coarse one, in fine nodes.
    start: [i64; 2],
}

impl<'a> Sampled<'a> {
    /// Of a coarse grid at the nodes of a fine one inside it.
    pub fn new(coarse: &'a Grid, fine: &Grid) -> Sampled<'a> {
        Sampled {
            coarse,
            start: [0, 1].map(|d: usize| fine.first[d] - 2 * coarse.first[d]),
        }
    }

    fn at(&self, values: &[f64], x: i64, y: i64) -> f64 {
        let [cx, cy] = self.coarse.n.map(|n| n as i64);
        let y = match self.coarse.half && y >= cy {
            true => 2 * (cy - 1) - y,
            false => y,
        };
        values[(self.coarse).index(x.clamp(0, cx - 1) as usize, y.clamp(0, cy - 1) as usize)]
    }

    /// The coarse node at or before a fine one along each direction, and steps from there: one where the fine node lies between two coarse ones.
    fn node(&self, i: usize, j: usize) -> [[i64; 2]; 2] {
        let at = [self.start[0] + i as i64, self.start[1] + j as i64];
        [at.map(|n| n.div_euclid(2)), at.map(|n| n.rem_euclid(2))]
    }

    /// Values of the four nodes around, those of one or two nodes more than once.
    fn corners(&self, values: &[f64], i: usize, j: usize) -> [f64; 4] {
        let [[x, y], [a, b]] = self.node(i, j);
        [[0, 0], [a, 0], [0, b], [a, b]].map(|[a, b]| self.at(values, x + a, y + b))
    }

    /// Linear between the nodes: no new extremum.
    pub fn linear(&self, values: &[f64], i: usize, j: usize) -> f64 {
        0.25 * self.corners(values, i, j).iter().sum::<f64>()
    }

    /// The same of contents, from nodes that have one.
    fn content(&self, values: &[f64], i: usize, j: usize) -> f64 {
        let corners = self.corners(values, i, j);
        let known = corners.iter().filter(|content| content.is_finite());
        match known.clone().count() {
            0 => f64::INFINITY,
            n => known.sum::<f64>() / n as f64,
        }
    }

    /// Cubic between the nodes.
    pub fn cubic(&self, values: &[f64], i: usize, j: usize) -> f64 {
        let [[x, y], [a, b]] = self.node(i, j);
        let between = |v: [f64; 4]| (9.0 * (v[1] + v[2]) - v[0] - v[3]) / 16.0;
        let along = |y: i64| match a {
            0 => self.at(values, x, y),
            _ => between([-1, 0, 1, 2].map(|d| self.at(values, x + d, y))),
        };
        match b {
            0 => along(y),
            _ => between([-1, 0, 1, 2].map(|d| along(y + d))),
        }
    }
}
