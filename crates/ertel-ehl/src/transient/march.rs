//! From a steady contact through time, in steps whose lengths follow from their errors.

use crate::contact::gap::{Body, GapTerm, Relief};
use crate::contact::{Inlet, Pose, Shape};
use crate::engine::{Observer, Problem, SolveError};
use crate::solution::IterationRecord;
use crate::volumes::ending::Ends;
use crate::volumes::{FiniteVolumes, Plan};

use super::body::Start;
use super::checkpoint::{Checkpoint, Info};
use super::conditions::{Cavities, Conditions};
use super::levels::{Levels, Trial, Zones, apart};
use super::present::Present;
use super::report::{InstantMeta, measure};
use super::run::{Params, TransientError, TransientObserver};

/// Allowed local error per step (mean over the dry contact), divided by tolerance^(3/2): films err with the square of the step, a step with
/// its cube. Measured on a ramp of the speed through a line contact, against a tenth of the tolerance: with 0.27, films of 0.38 % where 0.3 % were asked for.
const STEP_ERROR: f64 = 0.15;

/// Share of the tolerance that steps aim at, bounds of their growth, and where one is refused.
const AIM: f64 = 0.85;
const GROWTH: [f64; 2] = [0.3, 2.0];
const REFUSED: f64 = 1.5;

/// First step after a kink, in T, and over the one before it.
const FIRST_STEP: f64 = 0.02;
const AFTER_KINK: f64 = 0.1;

/// Share of a relief's shortest length that its body moves by in a step at most while it is in the contact, so that steps resolve
/// it whatever the error estimate of the rest. The comparison of wave amplitudes with a published table uses this value.
const STEP_OVER_RELIEF: f64 = 1.0 / 24.0;

/// Convergence tolerance of Newton's method and of the film-heat coupling, over the tolerance of the films.
const SOLVER_SHARE: f64 = 1e-2;

/// Distance from the centre, in half-widths, within which reliefs limit the step.
const RELIEF_RADIUS: f64 = 1.1;

/// The reliefs of a contact.
fn reliefs(shape: &Shape) -> impl Iterator<Item = &Relief> {
    shape.gap.terms.iter().filter_map(|term| match term {
        GapTerm::Relief(relief) => Some(relief),
        GapTerm::Roller(_) | GapTerm::Curvature(_) => None,
    })
}

/// Forwards only the user's request to stop.
struct Quiet<'a>(&'a mut dyn TransientObserver);

impl Observer for Quiet<'_> {
    fn level(&mut self, _: usize, _: usize, _: usize, _: usize) {}

    fn iteration(&mut self, _: &IterationRecord) {}

    fn cancelled(&self) -> bool {
        self.0.cancelled()
    }
}

/// Solves a contact from its steady state at T = 0 on. The scales of the problem are those of the speed and the load of reference.
///
/// # Errors
/// Without a steady start, when steps get too short, and when the user stops the run; instants reported until then remain valid.
pub fn march(
    problem: Problem<Plan>,
    conditions: &Conditions,
    params: &Params,
    observer: &mut dyn TransientObserver,
) -> Result<Info, TransientError> {
    run(problem, conditions, params, None, observer)
}

/// Continues from a checkpoint of the same contact, conditions and parameters; the observer receives the instants after it.
///
/// # Errors
/// As [`march`], and for a checkpoint of another contact.
pub fn resume(
    problem: Problem<Plan>,
    conditions: &Conditions,
    params: &Params,
    from: &Checkpoint,
    observer: &mut dyn TransientObserver,
) -> Result<Info, TransientError> {
    run(problem, conditions, params, Some(from), observer)
}

fn run(
    mut problem: Problem<Plan>,
    conditions: &Conditions,
    params: &Params,
    from: Option<&Checkpoint>,
    observer: &mut dyn TransientObserver,
) -> Result<Info, TransientError> {
    let unit = problem.scales.length / problem.scales.entrainment_speed();
    // The residual of a steady start changes the solution in the first steps.
    let heat = &mut problem.plan.heat;
    (heat.tolerance, heat.share_of_target) = (SOLVER_SHARE * params.tolerance, 0.0);
    let present = Present::new(&mut problem, conditions);
    let mut moved = [Pose::START; 2];
    present.set(&mut problem, 0.0, moved);
    let first = match conditions.start {
        Start::Steady => {
            present.refine_for_thinnest(&mut problem, observer.start())?;
            present.set(&mut problem, 0.0, moved);
            FiniteVolumes.solve(&problem, observer.start())?.levels
        }
        Start::Apart { gap, .. } => apart(&problem, gap),
    };
    problem.plan.newton.ends = Ends {
        balance: SOLVER_SHARE * params.tolerance,
        ..Ends::of(2.0 * SOLVER_SHARE * params.tolerance)
    };
    let (cell, needed) = (first.last(), problem.plan.largest_cell);
    if let Some(cell) = cell
        .map(|level| level.system.grid.spacing[0])
        .filter(|h| *h > needed)
    {
        return Err(TransientError::Coarse { cell, needed });
    }
    let mut levels = Levels::new(&problem, first, conditions, present.load)?;
    let mut info = Info::default();
    let report = |problem: &mut Problem<Plan>,
                  levels: &Levels,
                  at: InstantMeta,
                  observer: &mut dyn TransientObserver| {
        present.in_own_scales(problem, levels);
        observer.instant(&measure(levels, problem, &present, params, at));
    };
    let target = STEP_ERROR * params.tolerance.powf(1.5);
    // Bodies closer than a²/R approach each other within that time.
    let first_step = match conditions.start {
        Start::Apart { gap, .. } => FIRST_STEP * gap.min(1.0),
        Start::Steady => FIRST_STEP,
    };
    let (mut time, mut step) = (0.0, first_step);
    match from {
        Some(from) => {
            levels.remember(&from.memory)?;
            (time, step, moved, info) = (from.time, from.step, from.moved, from.info);
            // The length of the next step follows from where reliefs are.
            present.set(&mut problem, time, moved);
        }
        None => {
            let start = InstantMeta {
                is_asked: true,
                ..InstantMeta::default()
            };
            report(&mut problem, &levels, start, observer);
        }
    }
    // State at the newest instant: a trial step that a stop interrupts is repeated.
    let mut accepted = (step, info);
    let mut ahead = conditions.stops();
    ahead.retain(|(stop, _)| *stop >= time);
    for (stop, is_kink) in ahead {
        while time < stop {
            step = step.min(longest_step(&problem, conditions, params, time));
            // Avoid a very short step before a stop.
            let remaining = stop - time;
            let to = match remaining {
                _ if remaining <= step * (1.0 + 1e-9) => stop,
                _ if remaining < 2.0 * step => time + 0.5 * remaining,
                _ => time + step,
            };
            let taken = to - time;
            let way = conditions.way(time, to);
            let next = [0, 1].map(|i: usize| moved[i].then(&way[i]));
            present.set(&mut problem, to, next);
            let zones = Zones::of(&problem.shape);
            let trial = match levels.step(&problem, (to, way), &zones, &mut Quiet(observer)) {
                Err(SolveError::Interrupted) => {
                    let (step, info) = accepted;
                    observer.checkpoint(Checkpoint {
                        time,
                        step,
                        moved,
                        info,
                        memory: levels.memory(),
                    });
                    return Err(TransientError::Interrupted);
                }
                trial => trial?,
            };
            info.newton_iterations += trial.as_ref().map_or(0, |trial| trial.info.iterations);
            let growth = match trial.as_ref().map(|trial| trial.error) {
                // Newton's method did not converge.
                None => GROWTH[0],
                Some(None) => 1.0,
                Some(Some(error)) => {
                    let growth = AIM * (target / error.max(f64::MIN_POSITIVE)).cbrt();
                    growth.clamp(GROWTH[0], GROWTH[1])
                }
            };
            let is_right = |trial: &Trial| trial.error.is_none_or(|e| e <= REFUSED * target);
            let Some(trial) = trial.filter(is_right) else {
                info.refused += 1;
                step = taken * growth.min(0.5);
                if step < params.smallest_step || info.steps + info.refused > params.most_steps {
                    return Err(TransientError::Stuck {
                        time,
                        duration: conditions.duration,
                        step: taken,
                        unit,
                        info,
                    });
                }
                continue;
            };
            let newton_iterations = trial.info.iterations;
            levels.accept(trial);
            info.steps += 1;
            // A step shortened only by a stop does not limit the next one.
            step = (taken * growth).max(if growth >= 1.0 { step } else { 0.0 });
            (time, moved) = (to, next);
            accepted = (step, info);
            let at = InstantMeta {
                time,
                step: taken,
                newton_iterations,
                is_asked: time == stop && conditions.is_asked(stop),
            };
            report(&mut problem, &levels, at, observer);
            let is_cancelled = observer.cancelled();
            if is_cancelled || observer.wants_checkpoint() {
                observer.checkpoint(Checkpoint {
                    time,
                    step,
                    moved,
                    info,
                    memory: levels.memory(),
                });
            }
            if is_cancelled {
                return Err(TransientError::Interrupted);
            }
        }
        if is_kink {
            levels.forget();
            step = (AFTER_KINK * step).min(FIRST_STEP);
        }
    }
    Ok(info)
}

/// Lower bound of the speed, over the reference speed, for the length of steps.
const SLOW: f64 = 1e-3;

/// Longest step that the motion at an instant allows.
pub(super) fn longest_step(
    problem: &Problem<Plan>,
    conditions: &Conditions,
    params: &Params,
    time: f64,
) -> f64 {
    // At the edge of the contact, which spin moves, too.
    let reach = problem.shape.zone.axis_ratio.max(1.0);
    let speeds = (conditions.velocities(time))
        .map(|v| v.centre[0].hypot(v.centre[1]) + reach * v.spin.abs());
    let fastest = speeds.iter().fold(0.0_f64, |m, u| m.max(*u));
    let is_carried = problem.shape.gap.has_reliefs()
        || problem.shape.inlet != Inlet::Flooded
        || conditions.cavities == Cavities::Conserved;
    let largest = match is_carried {
        true => params.largest_step_of_arrivals,
        false => params.largest_step,
    };
    let of_motion = (largest / fastest.max(SLOW)).min(conditions.visible(time));
    let about = reliefs(&problem.shape).filter(|relief| relief.is_within(RELIEF_RADIUS));
    about.fold(of_motion, |step, relief| {
        let speed = speeds[match relief.body {
            Body::First => 0,
            Body::Second => 1,
        }];
        step.min(STEP_OVER_RELIEF * relief.form.finest() / speed.max(SLOW))
    })
}
