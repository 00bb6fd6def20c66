//! Bodies that turn about the contact normal, and surfaces that slide across the motion.

use crate::near::near;
use approx::assert_relative_eq;
use ertel_rheology::shear::{ReeEyring, ShearLaw, ShearThinning};

use super::{Films, Given, Params, ball_on_glass, line, mass_error, run, steady};
use crate::contact::gap::{Body, Form, GapTerm, Relief};
use crate::contact::{Contact, Pose, Turn};
use crate::transient::march::longest_step;
use crate::transient::{Conditions, Course, Speeds};

/// ω of body 1 and body 2, and S_⊥.
const SPIN: [f64; 2] = [0.8, -0.2];
const ACROSS: f64 = 0.5;

fn ball() -> Given {
    Given {
        contact: Contact::circular(0.016, 100.0),
        speed: 0.8,
        target: 2e-2,
        thinning: Some(ShearThinning::of(ShearLaw::ReeEyring(
            ReeEyring::new(6e6).unwrap(),
        ))),
        ..line()
    }
}

/// Of the share of spin and sliding over time.
fn turning(share: impl Fn(f64) -> Course, duration: f64) -> Conditions {
    Conditions {
        slide_to_roll_ratio_across: share(ACROSS),
        spin: SPIN.map(share),
        ..steady(duration)
    }
}

fn params() -> Params {
    Params {
        tolerance: 1e-2,
        ..Params::default()
    }
}

/// By hand: bodies that move at 0.5 and 1.5, the second one spinning at 2, whose surface moves at 3.5 at the edge of the contact: 20/3.5. Waves of 0.12 on the first body move by a 24th of
/// that at the speed of this body: 0.005/0.5, then 0.005/1.5.
#[test]
fn longest_steps_by_hand() {
    let mut problem = ball().problem();
    let mut conditions = Conditions {
        speeds: Speeds::Each([0.5, 1.5].map(Course::Constant)),
        spin: [0.0, 2.0].map(Course::Constant),
        ..steady(1.0)
    };
    let form = Form::Waves {
        wavelength: 0.12,
        amplitude: 0.01,
        direction: 0.0,
    };
    let relief = Relief {
        form,
        body: Body::First,
        place: [0.0; 2],
        moved: Pose::START,
        turn: Turn::NONE,
    };
    let step = |problem: &_, conditions: &_| longest_step(problem, conditions, &params(), 0.0);
    let fastest = params().largest_step / 3.5;
    assert_relative_eq!(step(&problem, &conditions), fastest, max_relative = 1e-12);
    problem.shape.gap.terms.push(GapTerm::Relief(relief));
    assert_relative_eq!(step(&problem, &conditions), 0.01, max_relative = 1e-12);
    conditions.speeds = Speeds::Each([1.5, 0.5].map(Course::Constant));
    near(step(&problem, &conditions), 0.005 / 1.5, 1e-12);
}

/// Films and friction power of a spinning ball stay under constant conditions, and spin and sliding that begin in time lead to them.
#[test]
fn spin_that_begins_leads_to_the_steady_film() {
    let (constant, _) = run(ball().problem(), &turning(Course::Constant, 1.0), &params());
    let ramp = |value: f64| Course::Table(vec![[0.0, 0.0], [1.0, value]]);
    let (begun, _) = run(ball().problem(), &turning(ramp, 6.0), &params());
    let last = |films: &Films| *films.0.last().unwrap();
    let steady = constant.0[0];
    for (which, within) in [(1, 2e-3), (2, 5e-3), (4, 5e-3)] {
        assert_relative_eq!(last(&constant)[which], steady[which], max_relative = 1e-3);
        assert_relative_eq!(last(&begun)[which], steady[which], max_relative = within);
    }
    // Without them the film is another one, and nothing slides.
    let straight = begun.0[0];
    assert!(
        (straight[1] / steady[1] - 1.0).abs() > 5e-3,
        "{straight:?} {steady:?}"
    );
    assert!(straight[4] < 0.1 * steady[4], "{straight:?} {steady:?}");
    assert!(mass_error(&begun) < 1e-2);
}

/// A dent on a body that turns by ω = 0.4 moves on a circle about (0, u/ω) = (0, 2.5): one that starts at 2.5 (−sin 0.64, 1 − cos 0.64) passes the centre at T = 1.6. Both bodies turn alike,
/// so that the oil moves with it.
#[test]
fn a_dent_moves_on_the_circle_of_its_body() {
    let (omega, arrives) = (0.4, 1.6);
    let angle: f64 = omega * arrives;
    let mut problem = ball_on_glass().problem();
    let radius = 0.25;
    problem.plan.largest_cell = 2.4 * radius / 16.0;
    problem.shape.gap.add(
        Form::Round {
            radius,
            height: -100e-9 / problem.scales.film,
        },
        Body::Second,
        [-angle.sin() / omega, (1.0 - angle.cos()) / omega],
    );
    let conditions = Conditions {
        spin: [omega; 2].map(Course::Constant),
        ..steady(1.8)
    };
    let coarse = Params {
        tolerance: 2e-2,
        ..Params::default()
    };
    let (films, _) = run(problem, &conditions, &coarse);
    let smooth = films.0[0][1];
    let deepest = (films.0.iter())
        .max_by(|a, b| a[1].total_cmp(&b[1]))
        .unwrap();
    assert!((deepest[0] - arrives).abs() < 0.06, "{deepest:?}");
    let depth = (deepest[1] - smooth) / 100e-9;
    assert!((0.4..1.0).contains(&depth), "{depth}");
}
