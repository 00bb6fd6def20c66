//! Heat of the grids in time: temperatures of the film from earlier ones, those of the surfaces from the stored heat of both bodies.
//!
//! ```text
//!   T_w at the end of a step = T_bulk + T by stored heat + K_Δ * q,      K_Δ the response to the heat of the step
//! ```
//! Heat that enters the bodies outside the next grid is stored separately: it gives the surface temperatures imposed on that grid.

use std::collections::VecDeque;

use serde::{Deserialize, Serialize};

use super::conditions::Conditions;
use super::scheme::{MEMORY, Weights, extrapolation};
use crate::contact::Pose;
use crate::forms::energy::Heat;
use crate::volumes::grid::Grid;
use crate::volumes::heat::memory::{Below, Carried, Memory, Over};
use crate::volumes::heat::rounds::{InTime, Rounds};
use crate::volumes::heat::spreading::Spreading;
use crate::volumes::heat::temperatures::{Bodies, Temperatures, moving_body, unheated};
use crate::volumes::heat::{Params, Warm};
use crate::volumes::level::{Level, Sampled, outside};
use crate::volumes::storage::Storage;

/// A grid's heat at the newest instants.
pub(super) struct GridHeat {
    /// Temperatures at the nodes of the film, the newest first.
    films: VecDeque<Vec<f64>>,
    /// Heat into both bodies at the newest instant, W/m².
    flux: [Vec<f64>; 2],
    /// Pressures, the newest first.
    pressures: VecDeque<Vec<f64>>,
    /// Both bodies.
    below: [Below; 2],
    /// Their stored heat.
    own: [Memory; 2],
    /// Their stored heat from outside the next grid; none below the finest.
    outside: Option<[Memory; 2]>,
    /// Ratio by which changes have shrunk from round to round of film and heat, 0 where it is not known.
    contraction: f64,
}

/// Smallest contraction ratio assumed for the coming rounds.
const LEAST_CONTRACTION: f64 = 0.1;

/// The same for a checkpoint.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub(super) struct HeatMemory {
    films: Vec<Vec<f64>>,
    flux: [Vec<f64>; 2],
    pressures: Vec<Vec<f64>>,
    own: [Memory; 2],
    outside: Option<[Memory; 2]>,
    contraction: f64,
}

/// A step for the bodies.
#[derive(Clone, Copy)]
pub(super) struct StepMotion {
    /// Its length, s.
    seconds: f64,
    /// Mean velocities of both bodies along and across the motion, m/s.
    velocities: [[f64; 2]; 2],
}

impl StepMotion {
    /// Of a step in T, in which the bodies move by a way, in half-widths, without turning.
    pub fn new(heat: &Heat, step: f64, way: [Pose; 2]) -> StepMotion {
        StepMotion {
            seconds: step * heat.length / heat.entrainment_speed,
            velocities: way.map(|way| way.shift.map(|way| way / step * heat.entrainment_speed)),
        }
    }

    fn over<'a>(&self, grid: &Grid, below: &'a Below, b: usize) -> Over<'a> {
        let velocity = grid.turn.to_axes(self.velocities[b]);
        Over::new(below, self.seconds, velocity)
    }
}

/// A grid's heat at the end of a step.
pub(super) struct HeatTrial {
    warm: Warm,
    pressure: Vec<f64>,
    own: [Memory; 2],
    outside: Option<[Memory; 2]>,
    /// Temperatures of both surfaces imposed on the next grid.
    given: [Vec<f64>; 2],
}

/// A step's start on a grid.
pub(super) struct Begun<'a> {
    overs: [Over<'a>; 2],
    carried: [Carried; 2],
    /// Temperatures of both surfaces without the heat of this grid, present or past.
    given: [Vec<f64>; 2],
}

impl GridHeat {
    /// Of a grid at the start.
    pub fn new(level: &Level, heat: &Heat, params: &Params, conditions: &Conditions) -> GridHeat {
        let grid = &level.system.grid;
        let f = level.system.fluid.nodes().map_or(2, |nodes| nodes.n());
        let speed = conditions.fastest() * heat.entrainment_speed;
        let below = [0, 1].map(|b: usize| {
            let body = moving_body(heat, b, grid, params.depth);
            Below::new(grid, body, heat.length, speed)
        });
        let n = grid.n_nodes();
        let (temperatures, own, outside) = match &level.warm {
            Some(warm) => {
                let flux = &warm.temperatures.flux;
                let own = [0, 1].map(|b: usize| below[b].settled(&grid.within_edges(&flux[b])));
                let outside = level.patch.map(|patch| {
                    [0, 1].map(|b: usize| {
                        below[b].settled(&grid.within_edges(&outside(grid, patch, &flux[b])))
                    })
                });
                (warm.temperatures.clone(), own, outside)
            }
            None => {
                let cold = || [0, 1].map(|b: usize| below[b].cold(n));
                (unheated(grid, heat, f), cold(), level.patch.map(|_| cold()))
            }
        };
        GridHeat {
            films: VecDeque::from([temperatures.film]),
            flux: temperatures.flux,
            pressures: VecDeque::from([level.state.oil().to_vec()]),
            below,
            own,
            outside,
            contraction: (level.warm.as_ref()).map_or(0.0, |warm| shrinks(warm, 0.0)),
        }
    }

    /// How film and pressure change in a step.
    pub fn in_time(&self, weights: &Weights) -> InTime {
        InTime {
            temperature: Storage {
                rate: weights.rate(),
                past: weights.past(self.films.iter()),
            },
            pressure: Storage {
                rate: weights.rate(),
                past: weights.past(self.pressures.iter()),
            },
            contraction: self.contraction,
        }
    }

    /// Begins a step on a grid that ends at the first of some instants, inside one whose heat is known at its end.
    pub fn begin(
        &self,
        rounds: &Rounds,
        grid: &Grid,
        (motion, times): (&StepMotion, &[f64]),
        coarser: Option<(&Level, &HeatTrial)>,
    ) -> (Begun<'_>, (Bodies, Temperatures)) {
        let heat = rounds.heat;
        let overs = [0, 1].map(|b: usize| motion.over(grid, &self.below[b], b));
        let carried = [0, 1].map(|b: usize| overs[b].carried(&self.own[b]));
        let sampled = coarser.map(|(level, trial)| (Sampled::new(&level.system.grid, grid), trial));
        let given = [0, 1].map(|b: usize| match &sampled {
            None => vec![heat.bodies[b].bulk_temperature; grid.n_nodes()],
            Some((sampled, trial)) => (grid.nodes())
                .map(|[i, j]| sampled.cubic(&trial.given[b], i, j))
                .collect(),
        });
        let outer = [0, 1].map(|b: usize| {
            let mut outer = overs[b].rise(&carried[b]);
            (outer.iter_mut().zip(&given[b])).for_each(|(t, given)| *t += given);
            outer
        });
        let spreading: [Spreading; 2] = [0, 1].map(|b: usize| overs[b].spreading());
        let bodies = Bodies::at_instant(grid, heat, rounds.params.depth, spreading, outer);
        let f = self.films[0].len() / grid.n_nodes();
        let (mut film, mut flux) = (self.ahead(times), self.flux.clone());
        if sampled.is_none() {
            // The incoming oil and bodies may have warmed up.
            let arriving = unheated(grid, heat, f).film;
            for [i, j] in grid.nodes().filter(|[i, j]| !grid.is_unknown(*i, *j)) {
                let own = grid.index(i, j) * f;
                film[own..own + f].copy_from_slice(&arriving[own..own + f]);
            }
        }
        if let Some((sampled, trial)) = &sampled {
            // Edge values are those of the coarser grid at the same instant.
            let coarse = &trial.warm.temperatures;
            let edge = || grid.nodes().filter(|[i, j]| !grid.is_unknown(*i, *j));
            for m in 0..f {
                let layer: Vec<f64> = coarse.film.iter().skip(m).step_by(f).copied().collect();
                for [i, j] in edge() {
                    film[grid.index(i, j) * f + m] = sampled.linear(&layer, i, j);
                }
            }
            for (flux, coarse) in flux.iter_mut().zip(&coarse.flux) {
                for [i, j] in edge() {
                    flux[grid.index(i, j)] = sampled.linear(coarse, i, j);
                }
            }
        }
        let begun = Begun {
            overs,
            carried,
            given,
        };
        (begun, (bodies, Temperatures { film, flux }))
    }

    /// Temperatures extrapolated linearly to the first of some instants: a parabola diverges where pressures do.
    fn ahead(&self, times: &[f64]) -> Vec<f64> {
        let known = &times[1..times.len().min(3)];
        match extrapolation(known, times[0])[..] {
            [newest, second] => (self.films[0].iter().zip(&self.films[1]))
                .map(|(a, b)| newest * a + second * b)
                .collect(),
            _ => self.films[0].clone(),
        }
    }

    /// Ends a step with its solution.
    pub fn end(
        &self,
        level: &Level,
        patch: Option<[[usize; 2]; 2]>,
        (begun, warm): (Begun, Warm),
    ) -> HeatTrial {
        let grid = &level.system.grid;
        let Begun {
            overs,
            carried: [first, second],
            mut given,
        } = begun;
        let flux = &warm.temperatures.flux;
        let remembered = |b: usize, carried: Carried, flux: &[f64]| {
            overs[b].remembered(carried, &grid.within_edges(flux))
        };
        let own = [
            remembered(0, first, &flux[0]),
            remembered(1, second, &flux[1]),
        ];
        let outside = patch.zip(self.outside.as_ref()).map(|(patch, before)| {
            [0, 1].map(|b: usize| {
                let arriving = outside(grid, patch, &flux[b]);
                let all = remembered(b, overs[b].carried(&before[b]), &arriving);
                let rise = self.below[b].rise(&all);
                (given[b].iter_mut().zip(rise)).for_each(|(t, rise)| *t += rise);
                all
            })
        });
        HeatTrial {
            pressure: level.state.oil().to_vec(),
            own,
            outside,
            given,
            warm,
        }
    }

    /// Advances to the end of a step.
    pub fn accept(&mut self, trial: HeatTrial) -> Warm {
        let Temperatures { film, flux } = &trial.warm.temperatures;
        self.films.push_front(film.clone());
        self.films.truncate(MEMORY);
        self.flux.clone_from(flux);
        self.pressures.push_front(trial.pressure);
        self.pressures.truncate(MEMORY);
        self.own = trial.own;
        self.outside = trial.outside;
        self.contraction = shrinks(&trial.warm, self.contraction);
        trial.warm
    }

    /// Forgets earlier temperatures and pressures; the stored heat of the bodies remains.
    pub fn forget(&mut self) {
        self.films.truncate(1);
        self.pressures.truncate(1);
    }

    /// Its state for a checkpoint.
    pub fn memory(&self) -> HeatMemory {
        HeatMemory {
            films: self.films.iter().cloned().collect(),
            flux: self.flux.clone(),
            pressures: self.pressures.iter().cloned().collect(),
            own: self.own.clone(),
            outside: self.outside.clone(),
            contraction: self.contraction,
        }
    }

    /// Whether a stored state with so many instants fits this grid.
    pub fn fits(&self, memory: &HeatMemory, instants: usize) -> bool {
        let n = self.pressures[0].len();
        let n_film = self.films[0].len();
        let both = |memories: &[Memory; 2]| {
            (memories.iter().zip(&self.below)).all(|(m, below)| m.fits(&below.modes, n))
        };
        memory.films.len() == instants
            && memory.pressures.len() == instants
            && memory.films.iter().all(|film| film.len() == n_film)
            && (memory.flux.iter().chain(&memory.pressures)).all(|values| values.len() == n)
            && both(&memory.own)
            && memory.outside.is_some() == self.outside.is_some()
            && memory.outside.iter().all(both)
    }

    /// Continues from a stored state.
    pub fn remember(&mut self, memory: &HeatMemory) {
        self.films = memory.films.iter().cloned().collect();
        self.flux = memory.flux.clone();
        self.pressures = memory.pressures.iter().cloned().collect();
        self.own = memory.own.clone();
        self.outside = memory.outside.clone();
        self.contraction = memory.contraction;
    }
}

/// The ratio by which changes shrank; after a single round the previous ratio.
fn shrinks(warm: &Warm, before: f64) -> f64 {
    match warm.effort.rounds > 1 {
        true => warm.effort.contraction.max(LEAST_CONTRACTION),
        false => before,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::Motion;
    use crate::forms::energy::BodyHeat;
    use approx::assert_relative_eq;
    use ertel_rheology::{ConductivityLaw, HeatCapacityLaw};

    /// By hand: 2 a/u of 0.1 mm and 0.5 m/s are 0.4 ms; a body that moves by a half-width meanwhile has 0.25 m/s.
    #[test]
    fn steps_in_seconds() {
        let body = |velocity| BodyHeat {
            layers: Vec::new(),
            density: 7850.0,
            conductivity: ConductivityLaw::constant(46.0).unwrap(),
            heat_capacity: HeatCapacityLaw::constant(470.0).unwrap(),
            velocity,
            bulk_temperature: 320.0,
        };
        let heat = Heat {
            conductivity: ConductivityLaw::constant(0.13).unwrap(),
            heat_capacity: HeatCapacityLaw::constant(2000.0).unwrap(),
            bodies: Motion::straight(0.5, 0.0).surfaces(1e-4).map(body),
            inlet_temperature: 313.15,
            length: 1e-4,
            film: 1e-6,
            pressure: 1e9,
            density: 870.0,
            viscosity: 0.04,
            lambda: 0.01,
            entrainment_speed: 0.5,
        };
        let way = [[1.0, 0.0], [2.0, -1.0]].map(|shift| Pose { shift, angle: 0.0 });
        let motion = StepMotion::new(&heat, 2.0, way);
        assert_relative_eq!(motion.seconds, 4e-4, max_relative = 1e-12);
        assert_eq!(motion.velocities, [[0.25, 0.0], [0.5, -0.25]]);
    }
}
