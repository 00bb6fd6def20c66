//! Runs that stop and continue.

use std::sync::atomic::{AtomicUsize, Ordering};

use super::{Given, Params, line, ramp, steady};
use crate::contact::Contact;
use crate::contact::gap::{Body, Form};
use crate::engine::{NoObserver, Observer, Problem};
use crate::solution::Measured;
use crate::transient::{
    Approach, Cavities, Checkpoint, Conditions, Course, Info, Instant, Mover, OtherGrids,
    TransientError, TransientObserver, march, resume,
};
use crate::volumes::Plan;

/// Notes the instants, and stops after some of them.
struct Stopping {
    most: usize,
    /// How often the solver may ask whether to stop.
    most_questions: usize,
    questions: AtomicUsize,
    instants: Vec<(f64, Measured, f64, f64)>,
    checkpoint: Option<Checkpoint>,
    quiet: NoObserver,
}

impl Stopping {
    fn after(most: usize) -> Stopping {
        Stopping {
            most,
            most_questions: usize::MAX,
            questions: AtomicUsize::new(0),
            instants: Vec::new(),
            checkpoint: None,
            quiet: NoObserver,
        }
    }
}

impl TransientObserver for Stopping {
    fn instant(&mut self, instant: &Instant<'_>) {
        self.instants.push((
            instant.time,
            instant.measured,
            instant.approach,
            instant.mass_error,
        ));
    }

    fn start(&mut self) -> &mut dyn Observer {
        &mut self.quiet
    }

    fn cancelled(&self) -> bool {
        let questions = self.questions.fetch_add(1, Ordering::Relaxed);
        self.instants.len() >= self.most || questions >= self.most_questions
    }

    fn checkpoint(&mut self, checkpoint: Checkpoint) {
        self.checkpoint = Some(checkpoint);
    }
}

fn params() -> Params {
    Params {
        tolerance: 2e-2,
        ..Params::default()
    }
}

/// Stops a run after some numbers of instants, the last one of them, and within steps, and goes on: to the digit as the run without a stop.
fn assert_goes_on(problem: &dyn Fn() -> Problem<Plan>, conditions: &Conditions) {
    let mut whole = Stopping::after(usize::MAX);
    let all = march(problem(), conditions, &params(), &mut whole).unwrap();
    let n = whole.instants.len();
    let questions = whole.questions.load(Ordering::Relaxed);
    let after = [2, 3, n / 2, n - 1].map(Stopping::after);
    let within = [1, 3, 6].map(|i| Stopping {
        most_questions: i * questions / 7,
        ..Stopping::after(usize::MAX)
    });
    for mut first in after.into_iter().chain(within) {
        let error = march(problem(), conditions, &params(), &mut first).unwrap_err();
        assert!(matches!(error, TransientError::Interrupted));
        let checkpoint = first.checkpoint.unwrap();
        let mut rest = Stopping::after(usize::MAX);
        let info = resume(problem(), conditions, &params(), &checkpoint, &mut rest).unwrap();
        first.instants.extend(rest.instants);
        assert_eq!(first.instants, whole.instants);
        assert_eq!(info, all);
    }
}

/// A line with a relief on a body.
fn with_relief(form: Form, place: f64) -> Problem<Plan> {
    let mut problem = line().problem();
    problem.plan.largest_cell = form.finest() / 16.0;
    problem.shape.gap.add(form, Body::Second, [place, 0.0]);
    problem
}

/// Reliefs that move limit the steps by where they are: waves, and a groove that comes, passes and goes, under a speed with kinks.
#[test]
fn a_run_with_reliefs_goes_on_to_the_digit() {
    let waves = Form::Waves {
        wavelength: 1.0,
        amplitude: 0.01,
        direction: 0.0,
    };
    assert_goes_on(&|| with_relief(waves.clone(), -1.5), &steady(2.0));
    let groove = Form::Ridge {
        half_width: 0.4,
        height: -0.02,
        direction: 0.0,
    };
    let passing = Conditions {
        instants: Vec::new(),
        ..ramp(5.0)
    };
    assert_goes_on(&|| with_relief(groove.clone(), -2.0), &passing);
}

/// Ramps with kinks, cavities with conserved oil, and a body that moves by its inertia.
#[test]
fn a_run_that_stopped_goes_on_to_the_digit() {
    assert_goes_on(&|| line().problem(), &ramp(5.0));
    let conserved = Conditions {
        cavities: Cavities::Conserved,
        ..ramp(1.5)
    };
    assert_goes_on(&|| line().problem(), &conserved);
    let swings = Conditions {
        load: Course::Table(vec![[0.0, 1.0], [1.0, 1.1]]),
        approach: Approach::Body(Mover {
            mass: 0.01,
            damping: 0.3,
            stiffness: 0.2,
        }),
        ..steady(2.0)
    };
    assert_goes_on(&|| line().problem(), &swings);
}

/// A checkpoint of a line is not valid for a circle.
#[test]
fn other_grids_are_refused() {
    let mut first = Stopping::after(2);
    march(line().problem(), &ramp(5.0), &params(), &mut first).unwrap_err();
    let circle = Given {
        contact: Contact::circular(0.016, 100.0),
        target: 5e-2,
        ..line()
    };
    let checkpoint = first.checkpoint.unwrap();
    let mut rest = Stopping::after(usize::MAX);
    let end = resume(
        circle.problem(),
        &ramp(5.0),
        &params(),
        &checkpoint,
        &mut rest,
    );
    assert!(matches!(end, Err(TransientError::OtherGrids(OtherGrids))));
    assert!(rest.instants.is_empty());
    assert_eq!(
        checkpoint.info,
        Info {
            steps: 1,
            ..checkpoint.info
        }
    );
}
