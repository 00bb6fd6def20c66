//! One step in time on all grids, coarse to fine: each grid has its own past, and the pressures beyond it from the grid before.

use std::collections::VecDeque;
use std::sync::Arc;

use super::scheme::{MEMORY, Weights, extrapolation};
use crate::contact::Shape;
use crate::contact::gap::{GapTerm, Relief};
use crate::engine::{Observer, Problem};
use crate::solve::SolveError;
use crate::volumes::Plan;
use crate::volumes::deflection::Deflection;
use crate::volumes::engine::{newton_params, pattern};
use crate::volumes::level::{Level, first_system, refined};
use crate::volumes::newton::{NewtonInfo, newton};
use crate::volumes::preconditioner::Pattern;
use crate::volumes::system::{State, Storage, System};

/// What of an operator is the same at all instants.
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
    /// Those instants.
    times: VecDeque<f64>,
}

/// Where errors of a step are looked at: the dry contact, and what of it reliefs cover.
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

/// A step that was solved.
pub struct Trial {
    levels: Vec<Level>,
    stored: Vec<Vec<f64>>,
    time: f64,
    /// Newton iterations on all grids.
    pub info: NewtonInfo,
    /// Mean error of ρ̄H over the dry contact, relative, with that of the zone of a relief if it is larger; `None` where too few instants are known.
    pub error: Option<f64>,
}

/// ρ̄H at the nodes.
fn mass(system: &System, state: &State, films: &[f64]) -> Vec<f64> {
    let of_node = |(p, h): (&f64, &f64)| system.fluid.at(*p).density[0] * h;
    state.pressure.iter().zip(films).map(of_node).collect()
}

impl Levels {
    /// From the grids of a steady solution.
    ///
    /// # Errors
    /// When no order of elimination is found.
    pub fn new(levels: Vec<Level>, time: f64) -> Result<Levels, SolveError> {
        let fixed = (levels.iter())
            .map(|level| {
                Ok(Fixed {
                    pattern: pattern(&level.system)?,
                    deflection: level.system.convolution.clone(),
                })
            })
            .collect::<Result<_, SolveError>>()?;
        let stored = (levels.iter())
            .map(|level| VecDeque::from([mass(&level.system, &level.state, &level.films)]))
            .collect();
        Ok(Levels {
            levels,
            fixed,
            stored,
            times: VecDeque::from([time]),
        })
    }

    /// The grids at the newest instant.
    pub fn levels(&self) -> &[Level] {
        &self.levels
    }

    /// Forgets what was before the newest instant, where something has a kink.
    pub fn forget(&mut self) {
        self.times.truncate(1);
        for stored in &mut self.stored {
            stored.truncate(1);
        }
    }

    /// A step to an instant, at which the problem is what it is then; `None` where Newton's method does not converge.
    ///
    /// # Errors
    /// When the user wants to stop.
    pub fn step(
        &self,
        problem: &Problem<Plan>,
        time: f64,
        zones: &Zones,
        observer: &mut dyn Observer,
    ) -> Result<Option<Trial>, SolveError> {
        let times: Vec<f64> = std::iter::once(time)
            .chain(self.times.iter().copied())
            .collect();
        let weights = Weights::new(&times);
        let params = newton_params(problem);
        let mut trial = Trial {
            levels: Vec::with_capacity(self.levels.len()),
            stored: Vec::with_capacity(self.levels.len()),
            time,
            info: NewtonInfo::default(),
            error: None,
        };
        for (l, (own, fixed)) in self.levels.iter().zip(&self.fixed).enumerate() {
            let (grid, deflection) = (own.system.grid.clone(), fixed.deflection.clone());
            let (mut system, mut state) = match trial.levels.last_mut() {
                None => (first_system(problem, grid, deflection), own.state.clone()),
                Some(before) => {
                    let (system, beside) = refined(problem, before, grid, deflection);
                    let state = carried_on(&system, &own.state, beside);
                    (system, state)
                }
            };
            system.storage = Some(Storage {
                rate: weights.rate(),
                past: weights.past(self.stored[l].iter()),
            });
            let about = (l, problem.scales.film);
            let info = newton(
                &system,
                &fixed.pattern,
                &mut state,
                &params,
                about,
                observer,
            );
            trial.info = trial.info.and(info);
            if info.interrupted {
                return Err(SolveError::Interrupted);
            }
            if !info.converged {
                return Ok(None);
            }
            let films = system.films(&state);
            trial.stored.push(mass(&system, &state, &films));
            trial.levels.push(Level {
                system,
                state,
                films,
                patch: None,
                warm: None,
            });
        }
        trial.error = self.error(&weights, &times, &trial, zones);
        Ok(Some(trial))
    }

    /// Mean error of ρ̄H on the finest grid over the zones, relative, the largest of which counts.
    fn error(&self, weights: &Weights, times: &[f64], trial: &Trial, zones: &Zones) -> Option<f64> {
        let share = match weights.share_of_error(times) {
            Some(share) => share,
            // Of the step before, of the first order: half of what a line through both instants misses.
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

    /// Goes on to a step.
    pub fn accept(&mut self, trial: Trial) {
        self.levels = trial.levels;
        self.times.push_front(trial.time);
        self.times.truncate(MEMORY);
        for (stored, newest) in self.stored.iter_mut().zip(trial.stored) {
            stored.push_front(newest);
            stored.truncate(MEMORY);
        }
    }
}

/// The state before as a start: along the edge the pressures are those of the grid before.
fn carried_on(system: &System, own: &State, beside: State) -> State {
    let grid = &system.grid;
    let pressure = (grid.nodes().zip(own.pressure.iter().zip(&beside.pressure)))
        .map(|([i, j], (own, beside))| match grid.is_unknown(i, j) {
            true => *own,
            false => *beside,
        })
        .collect();
    State {
        pressure,
        separation: own.separation,
        wetted: own.wetted.clone(),
        contents: own.contents.clone(),
    }
}
