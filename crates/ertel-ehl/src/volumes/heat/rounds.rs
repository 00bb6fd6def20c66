//! Film and heat in turn on a grid, until neither changes.
//!
//! Temperatures are found for the films and pressures of the last round with the flow held ([`crate::forms::energy`]), then films and pressures at those
//! temperatures. Where changes hardly shrink, only a share of each is taken ([`crate::solve::heat::relaxation`]).

use ertel_fem::platform::Instant;

use super::columns::{Columns, FilmHeat, Films};
use super::temperatures::{self, Account, Bodies, Temperatures, step, unheated};
use super::warmth::warmth;
use crate::engine::{Observer, Problem};
use crate::forms::energy::{Heat, Heights};
use crate::solve::SolveError;
use crate::solve::heat::newton::HeatError;
use crate::solve::heat::relaxation::Relaxation;
use crate::solve::heat::stopping::StoppingRule;
use crate::solve::tuning::heat::{INNER_SHARE, NEGLIGIBLE_RISE};
use crate::volumes::contents::missing;
use crate::volumes::level::{Level, Sampled, within};
use crate::volumes::newton::NewtonInfo;
use crate::volumes::system::{State, System};

/// How heat is solved for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Depth of the bodies, half-widths.
    pub depth: f64,
    /// Relative change from round to round, and the error that it leaves, at which film and heat have converged.
    pub tolerance: f64,
    /// Rounds at most.
    pub max_rounds: usize,
}

impl Default for Settings {
    fn default() -> Settings {
        Settings {
            depth: 3.15,
            tolerance: 1e-4,
            max_rounds: 40,
        }
    }
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

/// Steps for the temperatures in a round at most.
const MOST_STEPS: usize = 12;

/// What a round needs besides films and temperatures.
pub struct Rounds<'a> {
    /// Heat of the contact.
    pub heat: &'a Heat,
    /// Heights at which the film is heated.
    pub heights: Heights,
    /// Settings.
    pub settings: Settings,
}

impl<'a> Rounds<'a> {
    /// Of a problem, where heat counts.
    pub fn new<Plan>(problem: &'a Problem<Plan>, settings: Settings) -> Option<Rounds<'a>> {
        Some(Rounds {
            heat: problem.heat.as_ref()?,
            heights: temperatures::heights(&problem.fluid)?,
            settings,
        })
    }

    /// Heat to begin with on a grid, from that of the grid before.
    pub fn start(&self, system: &System, before: Option<&Level>) -> (Bodies, Temperatures) {
        let (grid, heat) = (&system.grid, self.heat);
        let f = system.fluid.nodes().map_or(2, |nodes| nodes.n());
        let mut bodies = Bodies::new(grid, heat, self.settings.depth);
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
            let beyond: Vec<f64> = (coarse.nodes().zip(flux))
                .map(|([i, j], q)| q * (1.0 - within(patch, coarse.half, i, j)))
                .collect();
            let mut outer = warm.bodies.rise(coarse, b, &beyond);
            (outer.iter_mut().zip(&warm.bodies.outer[b])).for_each(|(t, outer)| *t += outer);
            for [i, j] in grid.nodes() {
                let k = grid.index(i, j);
                own.flux[b][k] = sampled.linear(flux, i, j);
                bodies.outer[b][k] = sampled.cubic(&outer, i, j);
            }
        }
        (bodies, own)
    }

    /// Makes the film equation one of the temperatures.
    pub fn warm_up(&self, system: &mut System, state: &State, temperatures: &Temperatures) {
        let films = system.films(state);
        system.warmth = warmth(system, &state.pressure, &films, &temperatures.film);
    }

    /// Rounds on a grid whose film has been solved at the temperatures that come; `solve` solves it again.
    ///
    /// # Errors
    /// When rounds run out, a film is not found, or the observer cancels.
    pub fn run(
        &self,
        level: usize,
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
        let stopping = StoppingRule {
            tolerance: self.settings.tolerance,
            inner_share: INNER_SHARE,
            by_error: true,
        };
        for round in 1..=self.settings.max_rounds {
            if observer.cancelled() {
                return Err(SolveError::Interrupted);
            }
            let clock = Instant::now();
            let before = (own.clone(), state.clone());
            let centre = centre(system, state);
            let aim = (INNER_SHARE * change).max(0.1 * self.settings.tolerance);
            self.temperatures(system, state, &bodies, &mut own, aim, &mut effort)?;
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
                });
            }
            let rise = largest_rise(&own, self.heat);
            let largest = |a: &[f64], b: &[f64]| {
                (a.iter().zip(b)).fold(0.0_f64, |m, (a, b)| m.max((a - b).abs()))
            };
            let previous = change;
            change = (largest(&own.film, &before.0.film) / rise)
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
            let ratio = (round > 1).then_some(change / previous);
            if stopping.holds(change, share, ratio) {
                let clock = Instant::now();
                let account = self.account(system, state, &mut own);
                effort.seconds += clock.elapsed().as_secs_f64();
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
            level,
            rounds: effort.rounds,
            change,
            contraction: effort.contraction,
        })
    }

    /// Temperatures at the films as they stand.
    fn temperatures(
        &self,
        system: &System,
        state: &State,
        bodies: &Bodies,
        own: &mut Temperatures,
        aim: f64,
        effort: &mut Effort,
    ) -> Result<(), SolveError> {
        let of = self.film_heat(system);
        let at = system.linearise(state);
        let films: Vec<f64> = at.nodes.iter().map(|node| node.film).collect();
        let lacking = lacking(system, &films, &at.contents);
        let as_it_stands = Films {
            pressure: &state.pressure,
            film: &films,
            missing: &lacking,
            temperature: &own.film.clone(),
            held: &[],
        };
        let held = Columns::new(&of, &as_it_stands).conductance;
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
            if std::env::var("HEAT").is_ok() {
                eprintln!(
                    "  heat step {:?} rise {}",
                    info,
                    largest_rise(own, self.heat)
                );
            }
            if info.change < aim * largest_rise(own, self.heat) {
                break;
            }
        }
        Ok(())
    }

    fn film_heat<'b>(&'b self, system: &'b System) -> FilmHeat<'b> {
        FilmHeat {
            grid: &system.grid,
            fluid: &system.fluid,
            heat: self.heat,
            heights: &self.heights,
        }
    }

    /// Heat made and carried off.
    fn account(&self, system: &System, state: &State, own: &mut Temperatures) -> Account {
        let at = system.linearise(state);
        let films: Vec<f64> = at.nodes.iter().map(|node| node.film).collect();
        let lacking = lacking(system, &films, &at.contents);
        let now = Films {
            pressure: &state.pressure,
            film: &films,
            missing: &lacking,
            temperature: &own.film.clone(),
            held: &[],
        };
        temperatures::account(&self.film_heat(system), &now, &at.faces, own)
    }
}

/// What the gaps lack at the nodes.
fn lacking(system: &System, films: &[f64], contents: &[f64]) -> Vec<f64> {
    let density = system.fluid.at(0.0).density[0];
    (films.iter().zip(contents))
        .map(|(film, content)| missing(*film, *content, density))
        .collect()
}

/// H at the centre.
fn centre(system: &System, state: &State) -> f64 {
    let [i, j] = system.grid.centre();
    system.films(state)[system.grid.index(i, j)]
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

/// Largest rise over the inlet, K.
fn largest_rise(own: &Temperatures, heat: &Heat) -> f64 {
    (own.film.iter())
        .map(|t| (t - heat.inlet_temperature).abs())
        .fold(NEGLIGIBLE_RISE, f64::max)
}
