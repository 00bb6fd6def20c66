//! Film and heat in turn on a grid, until neither changes.
//!
//! Temperatures are computed for the films and pressures of the last round at fixed flow ([`crate::forms::energy`]), then films and pressures at those
//! temperatures. Where changes hardly shrink, only a share of each is taken ([`Relaxation`]).

use ertel_fem::platform::Instant;

use super::columns::{Columns, FilmHeat, Films};
use super::temperatures::{self, Account, Bodies, Effort, Temperatures, Warm, step, unheated};
use super::warm_up::warmth;
use crate::engine::HeatError;
use crate::engine::coupling::{INNER_SHARE, NEGLIGIBLE_RISE, Relaxation};
use crate::engine::{Observer, Problem, SolveError};
use crate::forms::energy::{Heat, Heights};
use crate::volumes::contents::missing;
use crate::volumes::level::{Level, Sampled, outside};
use crate::volumes::newton::NewtonInfo;
use crate::volumes::storage::Storage;
use crate::volumes::system::{Linearised, State, System};

/// Parameters of the heat solver.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Params {
    /// Depth of the bodies, half-widths.
    pub depth: f64,
    /// Relative change per round, and remaining error, at which film and heat have converged.
    pub tolerance: f64,
    /// The same as a share of the target error of the films, where that is more.
    pub share_of_target: f64,
    /// Rounds at most.
    pub max_rounds: usize,
}

impl Default for Params {
    fn default() -> Params {
        Params {
            depth: 3.15,
            tolerance: 1e-4,
            share_of_target: 0.25,
            max_rounds: 40,
        }
    }
}

impl Params {
    /// The tolerance for a target error of the films.
    pub fn in_force(&self, target_error: f64) -> f64 {
        self.tolerance.max(self.share_of_target * target_error)
    }
}

/// Ratio of successive changes above which the flow is held fixed from then on.
const SLOW: f64 = 0.3;

/// Most rounds on a grid that serves only as a start: it is too coarse for the film, and some nodes keep changing.
const ROUNDS_OF_STARTS: usize = 5;

/// Change, in tolerances, above which contraction ratios are ignored.
const MAX_CHANGE_FOR_RATIO: f64 = 30.0;

/// Largest share of the heat into a body that may enter where the map of a spinning surface does not apply.
const MOST_LOST: f64 = 0.02;

/// Steps for the temperatures in a round at most.
const MOST_STEPS: usize = 12;

/// Inputs of a round other than films and temperatures.
pub struct Rounds<'a> {
    /// Heat of the contact.
    pub heat: &'a Heat,
    /// Heights at which the film is heated.
    pub heights: Heights,
    /// Parameters.
    pub params: Params,
    /// Whether the surfaces have reliefs.
    has_reliefs: bool,
    /// How temperatures at the nodes of the film and pressures change in time, where they do.
    pub in_time: Option<InTime>,
}

/// ∂T/∂t and ∂p/∂t of a film by what they were, over the time a/u_m.
pub struct InTime {
    /// Of temperatures, node by node, K.
    pub temperature: Storage,
    /// Of P.
    pub pressure: Storage,
    /// Ratio by which changes have shrunk from round to round before.
    pub contraction: f64,
}

impl InTime {
    /// ∂P/∂T at pressures.
    fn pressure_rate(&self, pressure: &[f64]) -> Vec<f64> {
        let Storage { rate, past } = &self.pressure;
        (pressure.iter().zip(past))
            .map(|(p, past)| rate * p + past)
            .collect()
    }
}

impl<'a> Rounds<'a> {
    /// Of a problem, where heat counts.
    pub fn new<Plan>(problem: &'a Problem<Plan>, params: Params) -> Option<Rounds<'a>> {
        Some(Rounds {
            heat: problem.heat.as_ref()?,
            heights: temperatures::heights(&problem.fluid)?,
            params,
            has_reliefs: problem.shape.gap.has_reliefs(),
            in_time: None,
        })
    }

    /// Initial heat on a grid, from that of the grid before. The kernels of equal bodies of `alike` are reused.
    pub fn start(
        &self,
        system: &System,
        before: Option<&Level>,
        alike: Option<&Bodies>,
    ) -> (Bodies, Temperatures) {
        let (grid, heat) = (&system.grid, self.heat);
        let f = system.fluid.nodes().map_or(2, |nodes| nodes.n());
        let mut bodies = Bodies::new(grid, heat, self.params.depth, alike);
        let mut own = unheated(grid, heat, f);
        let Some((level, warm, patch)) =
            before.and_then(|level| Some((level, level.warm.as_ref()?, level.patch?)))
        else {
            return (bodies, own);
        };
        let coarse = &level.system.grid;
        let sampled = Sampled::new(coarse, grid);
        for m in 0..f {
            let layer: Vec<f64> = warm
                .temperatures
                .film
                .iter()
                .skip(m)
                .step_by(f)
                .copied()
                .collect();
            for [i, j] in grid.nodes() {
                own.film[grid.index(i, j) * f + m] = sampled.linear(&layer, i, j);
            }
        }
        for b in 0..2 {
            let flux = &warm.temperatures.flux[b];
            let mut outer = (warm.bodies).rise(coarse, b, &outside(coarse, patch, flux));
            (outer.iter_mut().zip(&warm.bodies.outer[b])).for_each(|(t, outer)| *t += outer);
            for [i, j] in grid.nodes() {
                let k = grid.index(i, j);
                own.flux[b][k] = sampled.linear(flux, i, j);
                bodies.outer[b][k] = sampled.cubic(&outer, i, j);
            }
        }
        (bodies, own)
    }

    /// Sets the coefficients of the film equation by the temperatures.
    pub fn warm_up(&self, system: &mut System, state: &State, temperatures: &Temperatures) {
        let gaps = system.gaps(state);
        system.warmth = warmth(system, state.oil(), &gaps, &temperatures.film);
    }

    /// Rounds on a grid whose film has been solved at the given temperatures; `solve` solves it again.
    ///
    /// # Errors
    /// When the rounds do not converge, a film is not found, or the observer cancels.
    pub fn run(
        &self,
        (level, target, is_start): (usize, f64, bool),
        (system, state): (&mut System, &mut State),
        (bodies, mut own): (Bodies, Temperatures),
        mut solve: impl FnMut(
            &mut System,
            &mut State,
            &mut dyn Observer,
        ) -> Result<NewtonInfo, SolveError>,
        observer: &mut dyn Observer,
    ) -> Result<(Warm, Vec<NewtonInfo>), SolveError> {
        let mut effort = Effort::default();
        let mut infos = Vec::new();
        let (mut change, mut first) = (1.0_f64, 0.0);
        let mut relaxation = Relaxation::default();
        let mut hold = false;
        let tolerance = self.params.in_force(target);
        let most = match is_start {
            true => self.params.max_rounds.min(ROUNDS_OF_STARTS),
            false => self.params.max_rounds,
        };
        for round in 1..=most {
            if observer.cancelled() {
                return Err(SolveError::Interrupted);
            }
            let clock = Instant::now();
            let before = (own.clone(), state.clone());
            let centre = centre(system, state);
            let aim = (INNER_SHARE * change).max(INNER_SHARE * tolerance);
            let holds = level == 0 && round == 1 || hold;
            self.temperatures(system, state, &bodies, &mut own, (aim, holds), &mut effort)?;
            let defect: Vec<f64> = (own.film.iter().zip(&before.0.film))
                .map(|(new, t)| new - t)
                .collect();
            let share = relaxation.share(&defect);
            if share < 1.0 {
                for (t, (old, d)) in own.film.iter_mut().zip(before.0.film.iter().zip(&defect)) {
                    *t = old + share * d;
                }
            }
            self.warm_up(system, state, &own);
            effort.seconds += clock.elapsed().as_secs_f64();
            let info = solve(system, state, observer)?;
            infos.push(info);
            if !info.converged {
                return Err(SolveError::GridNotConverged {
                    level,
                    iterations: info.iterations,
                    change: info.change,
                    has_reliefs: self.has_reliefs,
                });
            }
            let rise = largest_rise(&own, self.heat);
            let previous = change;
            change = (mean_rise(&own.film, &before.0.film, state.oil()) / rise)
                .max((self::centre(system, state) / centre - 1.0).abs())
                .max(mean_change(&state.pressure, &before.1.pressure))
                / share;
            observer.round(round, change, rise);
            effort.rounds = round;
            effort.change = change;
            if round == 1 {
                first = change;
            } else {
                effort.contraction = (change / first).powf(1.0 / (round - 1) as f64);
            }
            // In the first round of a time step, the ratio of earlier instants.
            let known = self.in_time.as_ref().map(|in_time| in_time.contraction);
            let ratio = match round {
                1 => known.filter(|ratio| *ratio > 0.0),
                _ => Some(change / previous),
            };
            hold |= ratio.is_some_and(|ratio| ratio > SLOW);
            let settled = ratio.is_some_and(|ratio| has_settled(change, share, ratio, tolerance));
            effort.settled = settled;
            // Grids before the first one whose figures are used serve only as a start.
            if settled || is_start && round == most {
                let clock = Instant::now();
                let account = self.account(system, state, &mut own);
                effort.seconds += clock.elapsed().as_secs_f64();
                // The first grid covers all.
                let share = match level {
                    0 => bodies.lost(&system.grid, &own.flux),
                    _ => 0.0,
                };
                if share > MOST_LOST {
                    return Err(HeatError::Turns { share }.into());
                }
                let warm = Warm {
                    bodies,
                    temperatures: own,
                    account,
                    effort,
                };
                return Ok((warm, infos));
            }
            relaxation.taken(share, defect);
        }
        Err(SolveError::NotCoupled {
            part: "grid",
            level,
            rounds: effort.rounds,
            change,
            contraction: effort.contraction,
        })
    }

    /// Temperatures for the current films.
    fn temperatures(
        &self,
        system: &System,
        state: &State,
        bodies: &Bodies,
        own: &mut Temperatures,
        (aim, holds): (f64, bool),
        effort: &mut Effort,
    ) -> Result<(), SolveError> {
        let of = self.film_heat(system);
        let at = system.linearise(state);
        let films: Vec<f64> = at.nodes.iter().map(|node| node.film).collect();
        let lacking = lacking(system, state, &at);
        let rate = self.pressure_rate(state);
        let rubbing = system.rubbing(state, self.heat);
        let as_it_stands = Films {
            pressure_rate: &rate,
            pressure: state.oil(),
            rubbing: &rubbing,
            film: &films,
            missing: &lacking,
            temperature: &own.film.clone(),
            held: &[],
        };
        let held = match holds {
            true => Columns::new(&of, &as_it_stands).conductance,
            false => Vec::new(),
        };
        for _ in 0..MOST_STEPS {
            let now = Films {
                temperature: &own.film.clone(),
                held: &held,
                ..as_it_stands
            };
            let (_, info) = step(&of, bodies, &now, &at.faces, own);
            if !info.is_finite || info.change.is_nan() {
                return Err(HeatError::NotFinite.into());
            }
            effort.iterations += 1;
            effort.krylov_iterations += info.krylov_iterations;
            if info.change < aim * largest_rise(own, self.heat) {
                break;
            }
        }
        Ok(())
    }

    fn pressure_rate(&self, state: &State) -> Vec<f64> {
        let rate = |in_time: &InTime| in_time.pressure_rate(state.oil());
        self.in_time.as_ref().map_or_else(Vec::new, rate)
    }

    /// The film for the energy equation.
    pub fn film_heat<'b>(&'b self, system: &'b System) -> FilmHeat<'b> {
        FilmHeat {
            grid: &system.grid,
            fluid: &system.fluid,
            heat: self.heat,
            heights: &self.heights,
            stored: self.in_time.as_ref().map(|in_time| &in_time.temperature),
        }
    }

    /// Heat made and carried off.
    fn account(&self, system: &System, state: &State, own: &mut Temperatures) -> Account {
        let at = system.linearise(state);
        let films: Vec<f64> = at.nodes.iter().map(|node| node.film).collect();
        let lacking = lacking(system, state, &at);
        let rate = self.pressure_rate(state);
        let rubbing = system.rubbing(state, self.heat);
        let now = Films {
            pressure_rate: &rate,
            pressure: state.oil(),
            rubbing: &rubbing,
            film: &films,
            missing: &lacking,
            temperature: &own.film.clone(),
            held: &[],
        };
        temperatures::account(&self.film_heat(system), &now, &at.faces, own)
    }
}

/// Whether the remaining error after a change is below a tolerance: the geometric series of the changes that follow. The ratio is used only if the change itself
/// is small.
fn has_settled(change: f64, share: f64, ratio: f64, tolerance: f64) -> bool {
    // With relaxation the ratio is at least 1 − share.
    let remaining = share * change * ratio / (1.0 - ratio);
    ratio < 1.0 && remaining < tolerance && change < MAX_CHANGE_FOR_RATIO * tolerance
        || change < INNER_SHARE * tolerance
}

/// Missing oil of the gaps at the nodes.
pub(super) fn lacking(system: &System, state: &State, at: &Linearised) -> Vec<f64> {
    let density = system.fluid.at(0.0).density[0];
    let contents = system.held(state, &at.contents, |_| at.faces.clone());
    (at.nodes.iter().zip(contents))
        .map(|(node, content)| missing(node.film, content, density))
        .collect()
}

/// The gap that flows at the centre.
fn centre(system: &System, state: &State) -> f64 {
    let [i, j] = system.grid.centre();
    system.gap_at(system.films(state)[system.grid.index(i, j)])
}

/// Root mean square change of the pressure where there is some.
fn mean_change(a: &[f64], b: &[f64]) -> f64 {
    let (mut sum, mut square) = (0.0, 0.0);
    for (a, b) in a.iter().zip(b) {
        sum += (a - b) * (a - b);
        square += a * a;
    }
    (sum / square).sqrt()
}

/// Root mean square change of the temperatures of the film where there is pressure, K.
fn mean_rise(a: &[f64], b: &[f64], pressure: &[f64]) -> f64 {
    let f = a.len() / pressure.len();
    let (mut sum, mut n) = (0.0, 0);
    for (k, _) in pressure.iter().enumerate().filter(|(_, p)| **p > 0.0) {
        let change = (k * f..(k + 1) * f).map(|m| (a[m] - b[m]) * (a[m] - b[m]));
        sum += change.sum::<f64>();
        n += f;
    }
    (sum / (n as f64).max(1.0)).sqrt()
}

/// Largest rise over the inlet, K.
pub(super) fn largest_rise(own: &Temperatures, heat: &Heat) -> f64 {
    (own.film.iter())
        .map(|t| (t - heat.inlet_temperature).abs())
        .fold(NEGLIGIBLE_RISE, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: a pressure of 0.5 after one of 0.15, two steps to a unit of time: 2 · 0.5 − 0.3.
    #[test]
    fn rates_by_hand() {
        let storage = |past: f64| Storage {
            rate: 2.0,
            past: vec![past],
        };
        let in_time = InTime {
            temperature: storage(0.0),
            pressure: storage(-0.3),
            contraction: 0.0,
        };
        assert!((in_time.pressure_rate(&[0.5])[0] - 0.7).abs() < 1e-12);
    }

    /// By hand: changes of 0.1 that shrink by a tenth leave 0.011; with half steps, 0.0056; slowly shrinking changes leave more than their own size, and ratios of large ones are ignored.
    #[test]
    fn remaining_errors_by_hand() {
        assert!(has_settled(0.1, 1.0, 0.1, 0.0112) && !has_settled(0.1, 1.0, 0.1, 0.011));
        assert!(has_settled(0.1, 0.5, 0.1, 0.0056));
        assert!(!has_settled(0.1, 1.0, 0.9, 0.5) && !has_settled(0.1, 1.0, 1.2, 0.5));
        assert!(!has_settled(0.1, 1.0, 1e-3, 1e-3));
        assert!(has_settled(1e-5, 1.0, 2.0, 1e-3));
    }
}
