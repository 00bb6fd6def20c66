//! One step in time on all grids, coarse to fine: each grid has its own history, and the pressures outside it from the coarser grid.

use std::collections::VecDeque;
use std::sync::Arc;
use std::sync::OnceLock;

use super::body::{Approach, Separations};
use super::checkpoint::{GridMemory, Memory, OtherGrids};
use super::conditions::{Cavities, Conditions};
use super::heat::{GridHeat, HeatTrial, StepMotion};
use super::scheme::{MEMORY, Weights, extrapolation};
use crate::contact::gap::{GapTerm, Relief};
use crate::contact::{Pose, Shape};
use crate::engine::{Observer, Problem, SolveError};
use crate::volumes::Plan;
use crate::volumes::contents::Arrival;
use crate::volumes::deflection::Deflection;
use crate::volumes::engine::BAR_GRIDS;
use crate::volumes::heat::rounds::Rounds;
use crate::volumes::level::{Level, convolution, first_system, refined};
use crate::volumes::newton::{NewtonInfo, newton};
use crate::volumes::patches::{first_cells, grid as patch};
use crate::volumes::plan::newton_params;
use crate::volumes::preconditioner::Pattern;
use crate::volumes::preconditioner::pattern;
use crate::volumes::storage::Storage;
use crate::volumes::system::{State, System};

/// Parts of the operator that do not change in time.
struct Fixed {
    pattern: Pattern,
    deflection: Arc<Deflection>,
}

/// The grids of a steady solution in time.
pub struct Levels {
    levels: Vec<Level>,
    fixed: Vec<Fixed>,
    /// ρ̄H at the nodes of each grid at the instants that count, the newest first.
    stored: Vec<VecDeque<Vec<f64>>>,
    /// H_0 of each grid at them.
    separations: Vec<Separations>,
    /// Those instants.
    times: VecDeque<f64>,
    /// The equation for H_0.
    approach: Approach,
    /// ∫P_r.
    unit: f64,
    cavities: Cavities,
    /// Heat of each grid; none in isothermal contacts.
    heat: Vec<GridHeat>,
    /// Source term of the film at the nodes of each grid at the end of the next step; none without a source.
    #[cfg(test)]
    pub(super) source: Vec<Vec<f64>>,
}

/// Zones of the error estimate of a step: the dry contact, and the part of it that reliefs cover.
pub struct Zones {
    shape: Shape,
    about: Vec<Relief>,
}

impl Zones {
    /// Of a contact at an instant.
    pub fn of(shape: &Shape) -> Zones {
        let about = (shape.gap.terms.iter()).filter_map(|term| match term {
            GapTerm::Relief(relief) if relief.is_within(1.0) => Some(relief.clone()),
            _ => None,
        });
        Zones {
            about: about.collect(),
            shape: shape.clone(),
        }
    }
}

/// Gives the cavities of a grid the contents that flow through them, where the gap counted as full.
fn conserve(level: &mut Level) {
    let (system, state) = (&mut level.system, &mut level.state);
    if system.arrival != Arrival::Flooded {
        return;
    }
    system.arrival = Arrival::FromEdges;
    state.contents = system.arrival.contents(&state.wetted);
    state.contents = system.linearise(state).contents;
    level.contents = OnceLock::new();
}

/// A step that was solved.
pub struct Trial {
    levels: Vec<Level>,
    stored: Vec<Vec<f64>>,
    /// H_0 and its velocity on each grid.
    moved: Vec<[f64; 2]>,
    heat: Vec<HeatTrial>,
    time: f64,
    /// Newton iterations on all grids.
    pub info: NewtonInfo,
    /// Mean error of ρ̄H over the dry contact, relative, with that of the zone of a relief if it is larger; `None` where too few instants are known.
    pub error: Option<f64>,
}

/// Mass at the nodes: ρ̄H, or their contents where those are less.
pub(super) fn held(system: &System, state: &State, films: &[f64]) -> Vec<f64> {
    let of_node = |(k, full): (usize, f64)| match state.contents.get(k) {
        Some(content) => content.min(full),
        None => full,
    };
    let full = system.masses(state, films);
    full.into_iter().enumerate().map(of_node).collect()
}

impl Levels {
    /// From the grids of a steady solution, with ∫P_r.
    ///
    /// # Errors
    /// When no order of elimination is found.
    pub fn new(
        problem: &Problem<Plan>,
        levels: Vec<Level>,
        conditions: &Conditions,
        unit: f64,
    ) -> Result<Levels, SolveError> {
        let (mut levels, cavities) = (levels, conditions.cavities);
        if cavities == Cavities::Conserved {
            levels.iter_mut().for_each(conserve);
        }
        let fixed = (levels.iter())
            .map(|level| {
                Ok(Fixed {
                    pattern: pattern(&level.system)?,
                    deflection: level.system.convolution.clone(),
                })
            })
            .collect::<Result<_, SolveError>>()?;
        let stored = (levels.iter())
            .map(|level| VecDeque::from([held(&level.system, &level.state, &level.films)]))
            .collect();
        let separations = (levels.iter())
            .map(|level| Separations::new(level.state.separation, conditions.start.velocity()))
            .collect();
        let of_grid = |level, heat| GridHeat::new(level, heat, &problem.plan.heat, conditions);
        Ok(Levels {
            heat: (problem.heat.iter())
                .flat_map(|heat| levels.iter().map(move |level| of_grid(level, heat)))
                .collect(),
            levels,
            fixed,
            stored,
            separations,
            times: VecDeque::from([0.0]),
            approach: conditions.approach.clone(),
            unit,
            cavities,
            #[cfg(test)]
            source: Vec::new(),
        })
    }

    /// The grids at the newest instant.
    pub fn levels(&self) -> &[Level] {
        &self.levels
    }

    /// Approach of the bodies on the finest grid, and its velocity.
    pub fn approached(&self) -> [f64; 2] {
        let finest = self.separations.last();
        finest.map_or([f64::NAN; 2], Separations::approached)
    }

    /// ∫P over all grids, under a load of reference; `load` is the one at the newest instant.
    pub fn force(&self, load: f64) -> f64 {
        // The rest of the load is carried outside the finest grid.
        self.levels.last().map_or(f64::NAN, |level| {
            load - level.system.load + level.system.integral(&level.state.pressure)
        })
    }

    /// Lets cavities keep the oil that has flown in, if mass is to be conserved there.
    fn conserve(&self, system: &mut System) {
        if self.cavities == Cavities::Conserved && system.arrival == Arrival::Flooded {
            system.arrival = Arrival::FromEdges;
        }
    }

    /// Their state for a checkpoint.
    pub(super) fn memory(&self) -> Memory {
        let grids = self.levels.iter().zip(&self.stored).zip(&self.separations);
        Memory {
            times: self.times.iter().copied().collect(),
            grids: grids
                .map(|((level, stored), separations)| {
                    let (origin, [places, velocities]) = separations.memory();
                    GridMemory {
                        pressure: level.state.pressure.clone(),
                        oil: level.state.oil.clone(),
                        wetted: level.state.wetted.clone(),
                        contents: level.state.contents.clone(),
                        stored: stored.iter().cloned().collect(),
                        origin,
                        places,
                        velocities,
                    }
                })
                .collect(),
            heat: self.heat.iter().map(GridHeat::memory).collect(),
        }
    }

    /// Continues from a stored state.
    ///
    /// # Errors
    /// For other grids.
    pub(super) fn remember(&mut self, memory: &Memory) -> Result<(), OtherGrids> {
        let fits = |(level, grid): (&Level, &GridMemory)| {
            let n = level.system.grid.n_nodes();
            let is_whole = |values: &Vec<f64>| values.len() == n;
            let sizes = [grid.places.len(), grid.velocities.len(), grid.stored.len()];
            is_whole(&grid.pressure)
                && grid.oil.len() == level.state.oil.len()
                && grid.wetted.len() == n
                && (grid.contents.len() == level.state.contents.len())
                && grid.stored.iter().all(is_whole)
                && sizes.iter().all(|size| *size == memory.times.len())
        };
        let is_like = !memory.times.is_empty()
            && memory.grids.len() == self.levels.len()
            && self.levels.iter().zip(&memory.grids).all(fits)
            && memory.heat.len() == self.heat.len()
            && (self.heat.iter().zip(&memory.heat))
                .all(|(own, heat)| own.fits(heat, memory.times.len()));
        if !is_like {
            return Err(OtherGrids);
        }
        self.times = memory.times.iter().copied().collect();
        (self.heat.iter_mut().zip(&memory.heat)).for_each(|(own, heat)| own.remember(heat));
        for (l, grid) in memory.grids.iter().enumerate() {
            self.levels[l].state = State {
                pressure: grid.pressure.clone(),
                oil: grid.oil.clone(),
                separation: grid.places[0],
                wetted: grid.wetted.clone(),
                contents: grid.contents.clone(),
            };
            self.levels[l].contents = OnceLock::new();
            self.stored[l] = grid.stored.iter().cloned().collect();
            let moved = [&grid.places, &grid.velocities];
            self.separations[l] = Separations::remembered(grid.origin, moved);
        }
        Ok(())
    }

    /// Forgets the instants before the newest one, at a kink.
    pub fn forget(&mut self) {
        self.times.truncate(1);
        for stored in &mut self.stored {
            stored.truncate(1);
        }
        self.separations.iter_mut().for_each(Separations::forget);
        self.heat.iter_mut().for_each(GridHeat::forget);
    }

    /// A step to an instant, with the problem of that instant and the motion `way` of the bodies, in half-widths; `None` where Newton's method
    /// or the film-heat coupling does not converge.
    ///
    /// # Errors
    /// When the user wants to stop.
    pub fn step(
        &self,
        problem: &Problem<Plan>,
        (time, way): (f64, [Pose; 2]),
        zones: &Zones,
        observer: &mut dyn Observer,
    ) -> Result<Option<Trial>, SolveError> {
        let times: Vec<f64> = std::iter::once(time)
            .chain(self.times.iter().copied())
            .collect();
        let weights = Weights::new(&times);
        let mut trial = Trial {
            levels: Vec::with_capacity(self.levels.len()),
            stored: Vec::with_capacity(self.levels.len()),
            moved: Vec::with_capacity(self.levels.len()),
            heat: Vec::with_capacity(self.heat.len()),
            time,
            info: NewtonInfo::default(),
            error: None,
        };
        for (l, (own, fixed)) in self.levels.iter().zip(&self.fixed).enumerate() {
            let params = newton_params(problem, l);
            let (grid, deflection) = (own.system.grid.clone(), fixed.deflection.clone());
            let (mut system, mut state) = match trial.levels.last_mut() {
                None => {
                    let mut system = first_system(problem, grid, deflection);
                    self.conserve(&mut system);
                    let state = arrived(&system, own.state.clone());
                    (system, state)
                }
                Some(before) => {
                    let (mut system, coarse) = refined(problem, before, grid, deflection);
                    self.conserve(&mut system);
                    let state = carried_on(&system, &own.state, coarse);
                    (system, state)
                }
            };
            system.storage = Some(Storage {
                rate: weights.rate(),
                past: weights.past(self.stored[l].iter()),
            });
            #[cfg(test)]
            self.feed(l, &mut system);
            let separations = &self.separations[l];
            system.balance = separations.balance(&self.approach, &weights, time, self.unit);
            let about = (l, problem.scales.film);
            let solve = |system: &mut System, state: &mut State, observer: &mut dyn Observer| {
                let info = newton(system, &fixed.pattern, state, &params, about, observer);
                match info.interrupted {
                    true => Err(SolveError::Interrupted),
                    false => Ok(info),
                }
            };
            let mut warm = None;
            if let (Some(heat), Some(mut rounds)) =
                (self.heat.get(l), Rounds::new(problem, problem.plan.heat))
            {
                rounds.in_time = Some(heat.in_time(&weights));
                let motion = StepMotion::new(rounds.heat, time - self.times[0], way);
                let coarser = trial.levels.last().zip(trial.heat.last());
                let (begun, start) = heat.begin(&rounds, &system.grid, (&motion, &times), coarser);
                rounds.warm_up(&mut system, &state, &start.1);
                let both = (&mut system, &mut state);
                match rounds.run((l, 0.0, false), both, start, solve, observer) {
                    Ok((found, infos)) => {
                        trial.info = infos.into_iter().fold(trial.info, NewtonInfo::and);
                        warm = Some((begun, found));
                    }
                    Err(SolveError::Interrupted) => return Err(SolveError::Interrupted),
                    Err(_) => return Ok(None),
                }
            } else {
                let info = solve(&mut system, &mut state, observer)?;
                trial.info = trial.info.and(info);
                if !info.converged {
                    return Ok(None);
                }
            }
            let films = system.films(&state);
            trial.stored.push(held(&system, &state, &films));
            let velocity = separations.velocity(&weights, state.separation);
            trial.moved.push([state.separation, velocity]);
            trial.levels.push(Level {
                system,
                state,
                films,
                patch: None,
                contents: OnceLock::new(),
                warm: None,
            });
            if let (Some(found), Some(heat), Some(level)) =
                (warm, self.heat.get(l), trial.levels.last())
            {
                trial.heat.push(heat.end(level, own.patch, found));
            }
        }
        trial.error = self.error(&weights, &times, &trial, zones);
        Ok(Some(trial))
    }

    /// Adds the source of manufactured fields.
    #[cfg(test)]
    fn feed(&self, l: usize, system: &mut System) {
        if let (Some(source), Some(storage)) = (self.source.get(l), &mut system.storage) {
            let past = storage.past.iter_mut().zip(source);
            past.for_each(|(past, source)| *past -= source);
        }
    }

    /// Mean error of ρ̄H on the finest grid over the zones, relative, the largest of which counts.
    fn error(&self, weights: &Weights, times: &[f64], trial: &Trial, zones: &Zones) -> Option<f64> {
        let share = match weights.share_of_error(times) {
            Some(share) => share,
            // For first-order steps: half of the difference from the line through both earlier instants.
            None if times.len() == MEMORY => 0.5,
            None => return None,
        };
        let ahead = extrapolation(&times[1..], times[0]);
        let (grid, here) = (&trial.levels.last()?.system.grid, trial.stored.last()?);
        let before = self.stored.last()?;
        let mut sums = [[0.0; 2]; 2];
        for ((k, [i, j]), q) in grid.nodes().enumerate().zip(here) {
            let place = grid.place(i, j);
            if !grid.is_unknown(i, j) || !zones.shape.zone.contains(place) {
                continue;
            }
            let predicted: f64 = ahead.iter().zip(before).map(|(w, q)| w * q[k]).sum();
            let error = ((q - predicted) / q).abs();
            sums[0] = [sums[0][0] + error, sums[0][1] + 1.0];
            if zones.about.iter().any(|relief| relief.covers(place)) {
                sums[1] = [sums[1][0] + error, sums[1][1] + 1.0];
            }
        }
        let mean = |[sum, n]: [f64; 2]| if n > 0.0 { sum / n } else { 0.0 };
        Some(share * mean(sums[0]).max(mean(sums[1])))
    }

    /// Accepts a step.
    pub fn accept(&mut self, trial: Trial) {
        self.levels = trial.levels;
        let heat = self.heat.iter_mut().zip(trial.heat);
        for (level, (own, newest)) in self.levels.iter_mut().zip(heat) {
            level.warm = Some(own.accept(newest));
        }
        self.times.push_front(trial.time);
        self.times.truncate(MEMORY);
        for (stored, newest) in self.stored.iter_mut().zip(trial.stored) {
            stored.push_front(newest);
            stored.truncate(MEMORY);
        }
        for (own, [separation, velocity]) in self.separations.iter_mut().zip(trial.moved) {
            own.accept(separation, velocity, MEMORY);
        }
    }
}

/// Cell size of the finest grid over the root of the target error, where there is no steady film to choose it by: errors fall with the square of the cell.
const CELL_OVER_ROOT: f64 = 0.25;

/// Grids without pressure, the bodies apart by H at the centre of the contact.
pub fn apart(problem: &Problem<Plan>, gap: f64) -> Vec<Level> {
    let plan = &problem.plan;
    let finest = (CELL_OVER_ROOT * plan.target_error.sqrt()).min(plan.largest_cell);
    let least = plan.least_grids[usize::from(problem.shape.is_line())];
    let mut levels: Vec<Level> = Vec::new();
    let [mut h, _] = first_cells(problem);
    while levels.len() < plan.most_grids {
        let grid = patch(problem, h, levels.first().map(|level| &level.system.grid));
        if grid.n_nodes() > plan.max_unknowns && levels.len() >= BAR_GRIDS {
            break;
        }
        let deflection = convolution(problem, &grid);
        let (system, state) = match levels.last_mut() {
            None => {
                let system = first_system(problem, grid, deflection);
                let n = system.grid.n_nodes();
                let mut state = State {
                    pressure: vec![0.0; n],
                    oil: Vec::new(),
                    separation: gap,
                    wetted: vec![true; n],
                    contents: Vec::new(),
                };
                system.settle(&mut state);
                (system, state)
            }
            Some(before) => refined(problem, before, grid, deflection),
        };
        levels.push(Level::new(system, state));
        if h <= finest && levels.len() >= least {
            break;
        }
        h *= 0.5;
    }
    levels
}

/// The previous state as a start, with the oil that arrives at the edge at the end of the step.
fn arrived(system: &System, mut state: State) -> State {
    let arriving = system.arrival.contents(&state.wetted);
    for ([i, j], (own, arriving)) in
        (system.grid.nodes()).zip(state.contents.iter_mut().zip(arriving))
    {
        if !system.grid.is_unknown(i, j) {
            *own = arriving;
        }
    }
    state
}

/// The previous state as a start, with edge pressures and contents from the coarser grid.
fn carried_on(system: &System, own: &State, coarse: State) -> State {
    let grid = &system.grid;
    let carried = |own: &[f64], coarse: &[f64]| {
        (grid.nodes().zip(own.iter().zip(coarse)))
            .map(|([i, j], (own, coarse))| match grid.is_unknown(i, j) {
                true => *own,
                false => *coarse,
            })
            .collect()
    };
    State {
        pressure: carried(&own.pressure, &coarse.pressure),
        oil: carried(&own.oil, &coarse.oil),
        separation: own.separation,
        wetted: own.wetted.clone(),
        contents: carried(&own.contents, &coarse.contents),
    }
}
