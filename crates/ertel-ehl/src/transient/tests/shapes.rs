//! Ellipses, rollers and shear-thinning oils in time: a steady solution stays, or is reached.

use approx::assert_relative_eq;
use ertel_rheology::shear::{ReeEyring, ShearLaw, ShearThinning};

use super::{Films, Given, Params, line, ramp, run, steady};
use crate::contact::roller::Profile;
use crate::contact::{Contact, Roller};
use crate::engine::NoObserver;
use crate::transient::{Conditions, Course, Speeds};
use crate::volumes::roller_zone::with_rows_by_film;

/// Coarse steps.
fn params() -> Params {
    Params {
        tolerance: 2e-2,
        ..Params::default()
    }
}

/// Films of the last instant are those of the first one.
fn assert_stays(films: &Films, within: f64) {
    let (first, last) = (films.0[0], films.0.last().unwrap());
    assert!(films.0.len() > 3);
    for which in [1, 2] {
        assert_relative_eq!(last[which], first[which], max_relative = within);
    }
}

/// An ellipse whose axes lie at 30 degrees to the motion: no half of it is the mirror image of the other one.
#[test]
fn the_film_of_an_ellipse_at_an_angle_stays() {
    let given = Given {
        contact: Contact::elliptical([0.01, 0.02], 20.0, 0.5),
        target: 5e-2,
        ..line()
    };
    let (films, info) = run(given.problem(), &steady(0.5), &params());
    assert_stays(&films, 1e-3);
    assert_eq!(info.refused, 0);
}

/// A roller with a logarithmic profile: rows at uneven distances.
#[test]
fn the_film_of_a_roller_stays() {
    let given = Given {
        contact: Contact::of_roller(
            5e-3,
            300.0,
            Roller {
                length: 2e-3,
                profile: Profile::lundberg(2e-3, 1.5 * 300.0 / 2e-3, 50e-6, 230.769_230_77e9),
                misalignment: 0.0,
            },
        ),
        speed: 3.0,
        target: 5e-2,
        ..line()
    };
    let problem = with_rows_by_film(given.problem(), &mut NoObserver).unwrap();
    let (films, info) = run(problem, &steady(0.5), &params());
    assert_stays(&films, 1e-3);
    assert_eq!(info.refused, 0);
}

/// Eyring's stress of 4 MPa, with as much sliding as rolling: the film stays under constant conditions; after a ramp it is the one of a steady solve at the speed of its end, sliding included.
#[test]
fn a_film_that_stress_thins_follows_its_sliding() {
    let eyring = ShearThinning::of(ShearLaw::ReeEyring(ReeEyring::new(4e6).unwrap()));
    let slides = |conditions: Conditions| {
        let Speeds::Mean { entrainment, .. } = conditions.speeds else {
            panic!("a ratio");
        };
        Conditions {
            speeds: Speeds::Mean {
                entrainment,
                slide_to_roll_ratio: Course::Constant(1.0),
            },
            ..conditions
        }
    };
    let given = |speed: f64| Given {
        thinning: Some(eyring.clone()),
        speed,
        target: 5e-3,
        ..line()
    };
    let (newtonian, _) = run(line().problem(), &slides(steady(0.01)), &params());
    let (films, info) = run(given(0.5).problem(), &slides(steady(0.5)), &params());
    assert_stays(&films, 1e-4);
    assert_eq!(info.refused, 0);
    let [thinned, thick] = [films.0[0][4], newtonian.0[0][4]];
    assert!(thinned < 0.5 * thick, "friction {thinned}, {thick}");
    let (films, _) = run(given(0.5).problem(), &slides(ramp(14.0)), &params());
    let (slow, _) = run(given(0.25).problem(), &slides(steady(0.01)), &params());
    let (last, steady) = (films.0.last().unwrap(), slow.0[0]);
    assert_relative_eq!(last[1], steady[1], max_relative = 5e-3);
    assert_relative_eq!(last[4], steady[4], max_relative = 1e-2);
}
