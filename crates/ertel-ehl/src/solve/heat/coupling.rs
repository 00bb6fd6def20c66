//! Film equations and energy equation in turn, until neither changes.
//!
//! Each round solves for the temperatures of the last pressures and films, and for pressures and films at those
//! temperatures. The dependence of the heat of shearing on temperature is inside the first, with its derivative; only the
//! response of films and pressures to the heat, mostly in the inlet, remains between the rounds, and it is
//! weak. The contraction from round to round is reported. Where the film equations do not converge at new
//! temperatures, half of their change is tried first. Where the changes hardly shrink, as where film and heat overshoot each other
//! in turn, only a share of each new temperature is taken, from the changes of the last two rounds (Aitken's relaxation:
//! Irons and Tuck, Int. J. Numer. Methods Eng. 1 (1969) 275-277). Their contraction gives the remaining error, and with
//! it the last round.

use super::newton::{HeatNewton, HeatParams, HeatStats};
use crate::engine::coupling::{INNER_SHARE, NEGLIGIBLE_RISE, Relaxation, StoppingRule};
use crate::engine::{Observer, SolveError};
use crate::forms::energy::Heat;
use crate::solve::evaluate::central_film;
use crate::solve::newton_level::{
    FilmModel, NewtonLevel, NewtonParams, NewtonStats, NewtonStatus, RunLabel,
};
use crate::solve::state::State;
use crate::solve::tuning::heat::{
    FEW_STEPS, LEAST_SHRINKING, MOST_STEPS, ROUGHEST, ROUGHEST_ON_PATH,
};

/// Settings.
#[derive(Clone, Copy, Debug)]
pub struct CouplingParams {
    /// Relative change of temperature rise, pressure and film from round to round, and the error that it leaves, at which all have
    /// converged.
    pub tolerance: f64,
    /// Whether that error counts, or the change alone.
    pub by_error: bool,
    /// Rounds allowed.
    pub max_rounds: usize,
    /// Share of new temperatures below which they are not halved further.
    pub smallest_share: f64,
    /// Whether it is given up at once where temperatures for given films do not converge in a round, because a continuation is known:
    /// these films are of no use.
    pub given_up_early: bool,
    /// Temperatures for given films.
    pub heat: HeatParams,
}

impl Default for CouplingParams {
    fn default() -> Self {
        CouplingParams {
            tolerance: 1e-4,
            by_error: true,
            max_rounds: 40,
            smallest_share: 0.1,
            given_up_early: false,
            heat: HeatParams::default(),
        }
    }
}

/// Convergence of the coupling.
#[derive(Clone, Copy, Debug, Default)]
pub struct CouplingStats {
    /// Rounds.
    pub rounds: usize,
    /// Ratio by which changes shrank from round to round, geometric mean.
    pub contraction: f64,
    /// Last relative change.
    pub change: f64,
    /// That at which all have converged.
    pub tolerance: f64,
    /// Effort on the temperatures.
    pub heat: HeatStats,
}

impl CouplingStats {
    /// The same together with a run before it, from whose end it started.
    #[must_use]
    pub fn after(self, earlier: Option<CouplingStats>) -> CouplingStats {
        let Some(earlier) = earlier else {
            return self;
        };
        CouplingStats {
            rounds: self.rounds + earlier.rounds,
            // A single round has nothing to compare its change with.
            contraction: match self.rounds {
                1 => earlier.contraction,
                _ => self.contraction,
            },
            change: self.change,
            tolerance: self.tolerance,
            heat: HeatStats {
                iterations: self.heat.iterations + earlier.heat.iterations,
                krylov_iterations: self.heat.krylov_iterations + earlier.heat.krylov_iterations,
            },
        }
    }
}

/// Iterates from `state`, which has temperatures.
///
/// # Errors
/// When the rounds run out, or one of the halves fails.
#[allow(clippy::too_many_arguments)]
pub fn solve_coupled(
    level: &NewtonLevel,
    model: &FilmModel,
    heat: &Heat,
    newton: &NewtonParams,
    params: &CouplingParams,
    label: &RunLabel,
    state: &mut State,
    stats: &mut NewtonStats,
    observer: &mut dyn Observer,
) -> Result<(NewtonStatus, CouplingStats), SolveError> {
    let d = level.discretisation;
    let mut temperatures = HeatNewton::new(d, &model.fluid, heat, params.heat);
    let mut coupling = CouplingStats {
        tolerance: params.tolerance,
        ..CouplingStats::default()
    };
    let mut first_change = 0.0;
    let mut change: f64 = 1.0;
    let mut relaxation = Relaxation::default();
    // By how much steps for the temperatures shrink, of this round or the one before.
    let mut shrinks: f64 = 1.0;
    let stopping = StoppingRule {
        tolerance: params.tolerance,
        inner_share: INNER_SHARE,
        by_error: params.by_error,
    };
    for round in 1..=params.max_rounds {
        if observer.cancelled() {
            return Err(SolveError::Interrupted);
        }
        let before = state.clone();
        let clock = ertel_fem::platform::Instant::now();
        let rise = |state: &State| -> f64 {
            let rise = |t: &f64| (t - heat.inlet_temperature).abs();
            state
                .temperature
                .iter()
                .map(rise)
                .fold(NEGLIGIBLE_RISE, f64::max)
        };
        temperatures.hold_flow(state);
        let mut settled = false;
        let most_steps = match params.given_up_early {
            true => FEW_STEPS,
            false => MOST_STEPS,
        };
        let mut last = f64::INFINITY;
        for _ in 0..most_steps {
            let step = temperatures.step(state)?;
            if last.is_finite() {
                shrinks = (step / last).clamp(LEAST_SHRINKING, 1.0);
            }
            last = step;
            // Far from the solution, in the first round, they say nothing of the next.
            let left = if round == 1 { step } else { shrinks * step } / rise(state);
            settled = left < (INNER_SHARE * change).max(0.1 * params.tolerance);
            if settled {
                break;
            }
        }
        stats.seconds.heat += clock.elapsed().as_secs_f64();
        if !settled && params.given_up_early {
            return Err(SolveError::NotCoupled {
                part: "stage",
                level: label.level,
                rounds: round,
                change,
                contraction: coupling.contraction,
            });
        }
        let roughest = match params.by_error {
            true => ROUGHEST,
            false => ROUGHEST_ON_PATH,
        };
        let inner = NewtonParams {
            update_tolerance: (INNER_SHARE * change)
                .max(newton.update_tolerance)
                .min(roughest),
            residual_tolerance: (INNER_SHARE * change)
                .max(newton.residual_tolerance)
                .min(roughest),
            ..*newton
        };
        let heated = state.temperature.clone();
        let mixed = |share: f64| -> Vec<f64> {
            let pairs = before.temperature.iter().zip(&heated);
            pairs.map(|(t, new)| t + share * (new - t)).collect()
        };
        let differences = heated.iter().zip(&before.temperature);
        let defect: Vec<f64> = differences.map(|(new, t)| new - t).collect();
        let wanted = relaxation.share(&defect);
        let mut share = wanted;
        if share < 1.0 {
            state.temperature = mixed(share);
        }
        let reached = loop {
            match level.run(model, &inner, label, state, stats, observer) {
                Err(SolveError::NotConverged { .. }) if share > params.smallest_share => {
                    share *= 0.5;
                    *state = State {
                        temperature: mixed(share),
                        ..before.clone()
                    };
                }
                outcome => break outcome?,
            }
        };
        let largest = |a: &[f64], b: &[f64]| {
            a.iter()
                .zip(b)
                .fold(0.0_f64, |m, (a, b)| m.max((a - b).abs()))
        };
        let film = central_film(d, state);
        let changes = [
            largest(&state.temperature, &before.temperature) / rise(state),
            largest(&state.pressure, &before.pressure),
            (film - central_film(d, &before)).abs() / film,
        ];
        let previous = change;
        // As if the whole of the new temperatures had been taken
        change = changes.into_iter().fold(0.0, f64::max) / share;
        observer.round(round, change, rise(state));
        coupling.rounds = round;
        coupling.change = change;
        coupling.heat = temperatures.stats;
        if round == 1 {
            first_change = change;
        } else {
            coupling.contraction = (change / first_change).powf(1.0 / (round - 1) as f64);
        }
        let ratio = (round > 1).then_some(change / previous);
        if share == wanted && stopping.holds(change, share, ratio) {
            return Ok((reached, coupling));
        }
        relaxation.taken(share, defect);
    }
    Err(SolveError::NotCoupled {
        part: "stage",
        level: label.level,
        rounds: coupling.rounds,
        change,
        contraction: coupling.contraction,
    })
}
