//! From a steady contact through time, in steps whose lengths follow from their errors.

use serde::{Deserialize, Serialize};

use crate::contact::gap::{Body, GapTerm, Relief};
use crate::contact::{Inlet, Pose, Shape};
use crate::engine::{Engine, Observer, Problem};
use crate::solution::{IterationRecord, Measured};
use crate::solve::SolveError;
use crate::volumes::ending::Ends;
use crate::volumes::level::Level;
use crate::volumes::{FiniteVolumes, Plan};

use super::body::Start;
use super::checkpoint::{Checkpoint, OtherGrids};
use super::conditions::{Cavities, Conditions};
use super::levels::{Levels, Trial, Zones, apart};
use super::present::Present;
use super::told::{At, instant};

/// How steps are chosen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Params {
    /// Relative error of the films that the steps may make in all.
    pub tolerance: f64,
    /// Largest step in T, over the speed at which the surfaces move then.
    pub largest_step: f64,
    /// The same where something is carried to the contact that no error tells of before it is there: a relief, a layer of oil, a cavity.
    pub largest_step_of_arrivals: f64,
    /// Smallest step in T.
    pub smallest_step: f64,
    /// Steps at most.
    pub most_steps: usize,
}

impl Default for Params {
    fn default() -> Params {
        Params {
            tolerance: 3e-3,
            largest_step: 20.0,
            largest_step_of_arrivals: 0.5,
            smallest_step: 1e-8,
            most_steps: 1_000_000,
        }
    }
}

/// What a step may err by, as a mean over the dry contact, over the tolerance of the films to the power of 3/2: films err with the square of the step, a step with
/// its cube. Measured on a ramp of the speed through a line contact, against a tenth of the tolerance: with 0.27, films of 0.38 % where 0.3 % were asked for.
const STEP_ERROR: f64 = 0.15;

/// Share of the tolerance that steps aim at, bounds of their growth, and where one is refused.
const AIM: f64 = 0.85;
const GROWTH: [f64; 2] = [0.3, 2.0];
const REFUSED: f64 = 1.5;

/// First step after a kink, in T, and over the one before it.
const FIRST_STEP: f64 = 0.02;
const AFTER_KINK: f64 = 0.1;

/// Share of a relief's shortest length that its body moves by in a step at most while it is in the contact, so that steps see
/// it whatever their error says of the rest. The amplitudes of waves that are compared with a published table were found with it.
const STEP_OVER_RELIEF: f64 = 1.0 / 24.0;

/// Share of the tolerance of the films that Newton's method and rounds of film and heat leave.
const LEFT: f64 = 1e-2;

/// A contact at an instant.
pub struct Instant<'a> {
    /// T.
    pub time: f64,
    /// Velocities of body 1 and body 2 over that of reference.
    pub speeds: [f64; 2],
    /// Load over that of reference.
    pub load: f64,
    /// By how much the bodies have come nearer since the start, in a²/R.
    pub approach: f64,
    /// Its rate over T.
    pub approach_velocity: f64,
    /// Force of the film over the load of reference.
    pub film_force: f64,
    /// Figures, SI, with what grids and steps may err by.
    pub measured: Measured,
    /// Length of the step that led here, 0 at the start.
    pub step: f64,
    /// Newton iterations on all grids that it took.
    pub newton_iterations: usize,
    /// Mass gained on the finest grid, over what passes the centre at the speed of reference.
    pub mass_error: f64,
    /// Whether it was asked for.
    pub is_asked: bool,
    /// The contact as it is, in the scales of its speed.
    pub problem: &'a Problem<Plan>,
    /// Its grids.
    pub levels: &'a [Level],
}

/// Follows a contact through time.
pub trait TransientObserver: Send + Sync {
    /// An instant is solved.
    fn instant(&mut self, instant: &Instant<'_>);

    /// Who follows the solve of the steady start.
    fn start(&mut self) -> &mut dyn Observer;

    /// Whether the user wants to stop.
    fn cancelled(&self) -> bool {
        false
    }

    /// Whether what the run needs to go on from here is to be told.
    fn wants_checkpoint(&self) -> bool {
        false
    }

    /// Called after a step for which it was wanted, and where the user stops the run, also within a step.
    fn checkpoint(&mut self, _checkpoint: Checkpoint) {}
}

/// How it went.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Info {
    /// Steps taken.
    pub steps: usize,
    /// Steps that erred by too much, or that Newton's method did not solve.
    pub refused: usize,
    /// Newton iterations of all of them on all grids.
    pub newton_iterations: usize,
}

/// Why time stops.
#[derive(Debug, thiserror::Error)]
pub enum TransientError {
    /// No steady contact to begin with.
    #[error("the steady contact at the start: {0}")]
    Start(SolveError),
    /// The checkpoint is not one of this case.
    #[error(transparent)]
    OtherGrids(#[from] OtherGrids),
    /// The observer asked to stop.
    #[error("interrupted")]
    Interrupted,
    /// The grids do not resolve a relief.
    #[error(
        "the shortest length of a relief needs cells of {needed:.1e} half-widths, and [mesh] max_unknowns allows {cell:.1e}"
    )]
    Coarse {
        /// Cell of the finest grid, in half-widths.
        cell: f64,
        /// Cell that resolves it.
        needed: f64,
    },
    /// Steps get shorter and shorter.
    #[error(
        "no step leads on from {:.4e} s of {:.4e} s: the last one tried is {:.1e} s long, after {} steps",
        time * unit, duration * unit, step * unit, info.steps
    )]
    Stuck {
        /// T reached.
        time: f64,
        /// T asked for.
        duration: f64,
        /// The last step tried.
        step: f64,
        /// Seconds in T.
        unit: f64,
        /// How it went so far.
        info: Info,
    },
}

impl From<SolveError> for TransientError {
    fn from(error: SolveError) -> TransientError {
        match error {
            SolveError::Interrupted => TransientError::Interrupted,
            error => TransientError::Start(error),
        }
    }
}

impl TransientError {
    /// What to try.
    pub fn advice(&self) -> Option<&'static str> {
        match self {
            // Time is solved by finite volumes alone.
            TransientError::Start(SolveError::GridNotConverged {
                has_reliefs: false, ..
            }) => Some("a start with a thicker film: a higher speed or less load at t = 0"),
            TransientError::Start(error) => error.advice(),
            TransientError::Coarse { .. } => Some("a larger [mesh] max_unknowns"),
            TransientError::Stuck { .. } => {
                Some("a larger `tolerance`, or changes that are slower or smaller")
            }
            TransientError::OtherGrids(_) | TransientError::Interrupted => None,
        }
    }

    /// How it went until then, where there were steps.
    pub fn info(&self) -> Option<Info> {
        match self {
            TransientError::Stuck { info, .. } => Some(*info),
            _ => None,
        }
    }
}

/// Half-widths from the centre within which reliefs count for the length of steps.
const ABOUT: f64 = 1.1;

/// The reliefs of a contact.
fn reliefs(shape: &Shape) -> impl Iterator<Item = &Relief> {
    shape.gap.terms.iter().filter_map(|term| match term {
        GapTerm::Relief(relief) => Some(relief),
        GapTerm::Roller(_) | GapTerm::Curvature(_) => None,
    })
}

/// Passes on whether the user wants to stop, and nothing else.
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
/// Without a steady start, when steps get too short, and when the user wants to stop; what the observer was told until then stands.
pub fn march(
    problem: Problem<Plan>,
    conditions: &Conditions,
    params: &Params,
    observer: &mut dyn TransientObserver,
) -> Result<Info, TransientError> {
    run(problem, conditions, params, None, observer)
}

/// Goes on from a checkpoint of the same contact, conditions and parameters; the observer is told the instants after it.
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
    // What a steady start leaves open changes in the first steps.
    let heat = &mut problem.plan.heat;
    (heat.tolerance, heat.share_of_target) = (LEFT * params.tolerance, 0.0);
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
        balance: LEFT * params.tolerance,
        ..Ends::of(2.0 * LEFT * params.tolerance)
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
    let tell = |problem: &mut Problem<Plan>,
                levels: &Levels,
                at: At,
                observer: &mut dyn TransientObserver| {
        present.in_own_scales(problem, levels);
        observer.instant(&instant(levels, problem, &present, params, at));
    };
    let target = STEP_ERROR * params.tolerance.powf(1.5);
    // Bodies that are apart by less than a²/R come near to each other within that.
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
            let start = At {
                is_asked: true,
                ..At::default()
            };
            tell(&mut problem, &levels, start, observer);
        }
    }
    // As they were when the newest instant was reached: trials that a stop cuts short are done again.
    let mut accepted = (step, info);
    let mut ahead = conditions.stops();
    ahead.retain(|(stop, _)| *stop >= time);
    for (stop, is_kink) in ahead {
        while time < stop {
            step = step.min(longest_step(&problem, conditions, params, time));
            // No sliver before a stop.
            let left = stop - time;
            let to = match left {
                _ if left <= step * (1.0 + 1e-9) => stop,
                _ if left < 2.0 * step => time + 0.5 * left,
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
            // A step that only a stop has shortened says nothing of longer ones.
            step = (taken * growth).max(if growth >= 1.0 { step } else { 0.0 });
            (time, moved) = (to, next);
            accepted = (step, info);
            let at = At {
                time,
                step: taken,
                newton_iterations,
                is_asked: time == stop && conditions.is_asked(stop),
            };
            tell(&mut problem, &levels, at, observer);
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

/// Speed over that of reference as which slower ones count for the length of steps.
const SLOW: f64 = 1e-3;

/// Longest step that the motion at an instant allows.
fn longest_step(
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
    let about = reliefs(&problem.shape).filter(|relief| relief.is_within(ABOUT));
    about.fold(of_motion, |step, relief| {
        let speed = speeds[match relief.body {
            Body::First => 0,
            Body::Second => 1,
        }];
        step.min(STEP_OVER_RELIEF * relief.form.finest() / speed.max(SLOW))
    })
}
