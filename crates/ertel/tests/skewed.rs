//! Sliding at an angle, and spin: against straight motion, closed forms of the Newtonian film, mirror images and the balance of energy.

use crate::common;

use approx::assert_relative_eq;
use common::{case, heated, near, solved};
use ertel::case::Case;
use ertel::contact::{ContactKind, Symmetry};
use ertel::params::MeshParams;
use ertel_rheology::shear::{Carreau, ShearLaw, ShearThinning};

/// A ball on a plane, with a film that stress thins or not.
fn contact(thins: bool) -> Case {
    let mut case = case(ContactKind::Circular, 40.0);
    case.mesh = MeshParams::adaptive(5e-3, ContactKind::Circular);
    let carreau = Carreau::new(5e6, 0.5, 2.0, 0.1).unwrap();
    case.lubricant.shear_thinning = thins.then(|| ShearThinning::of(ShearLaw::Carreau(carreau)));
    case
}

fn alike(a: ertel::solution::Estimate, b: ertel::solution::Estimate, what: &str) {
    let bar = a.error.unwrap() + b.error.unwrap();
    assert!((a.value - b.value).abs() <= bar, "{what}: {a:?} {b:?}");
}

/// Around a ball all directions of sliding are equivalent: 30 % across gives the traction across that 30 % along gives along. (The rolling
/// part differs, but not at mid-film.)
#[test]
fn sliding_across_a_ball_is_sliding_along_it() {
    let mut along = contact(false);
    along.motion.slide_to_roll_ratio = 0.3;
    let mut across = contact(false);
    across.motion.slide_to_roll_ratio_across = 0.3;
    let [along, across] = [solved(&along), solved(&across)];
    assert_eq!(along.shape.symmetry, Symmetry::Half);
    assert_eq!(across.shape.symmetry, Symmetry::Full);
    assert!(along.traction.across.is_none());
    alike(
        along.summary.film_central,
        across.summary.film_central,
        "h_c",
    );
    alike(
        along.summary.film_minimum,
        across.summary.film_minimum,
        "h_min",
    );
    let turned = across.traction.across.unwrap();
    alike(along.traction.coefficient, turned.coefficient, "traction");
    alike(along.traction.force, turned.force, "force");
    // None along the motion, within its bar.
    let rest = across.traction.coefficient;
    assert!(rest.value.abs() <= rest.error.unwrap(), "{rest:?}");
}

/// Sliding has no effect on a Newtonian film of one temperature: τ = ηΔu/h at mid-film. The components are as those of the sliding.
#[test]
fn newtonian_film_pulls_as_it_slides() {
    let mut case = contact(false);
    case.motion.slide_to_roll_ratio = 0.04;
    case.motion.slide_to_roll_ratio_across = -0.06;
    let straight = solved(&case);
    let across = straight.traction.across.unwrap();
    near(
        across.coefficient.value,
        -1.5 * straight.traction.coefficient.value,
        1e-9,
    );
}

/// Sliding across and spin the other way round: the mirror image.
#[test]
fn mirrored_motion_mirrors_the_contact() {
    let mirrored = [1.0, -1.0].map(|sign| {
        let mut case = contact(true);
        case.motion.slide_to_roll_ratio = 0.1;
        case.motion.slide_to_roll_ratio_across = 0.05 * sign;
        case.motion.spin = [0.0, 600.0 * sign];
        solved(&case)
    });
    let [a, b] = &mirrored;
    for (a, b) in [
        (a.summary.film_central, b.summary.film_central),
        (a.summary.film_minimum, b.summary.film_minimum),
        (a.traction.coefficient, b.traction.coefficient),
        (a.traction.friction_power, b.traction.friction_power),
    ] {
        alike(a, b, "mirror");
    }
    let [a, b] = [a, b].map(|s| {
        let across = s.traction.across.unwrap();
        (
            across.coefficient,
            s.traction.moment.unwrap(),
            s.summary.film_minimum_at.y,
        )
    });
    // Bars of what spin does allow for what the outer half of the ball adds, and are wide.
    for (a, b) in [(a.0, b.0), (a.1, b.1)] {
        assert!(
            (a.value + b.value).abs() <= 0.01 * a.value.abs(),
            "{a:?} {b:?}"
        );
    }
    // The thinnest film lies at one side, then at the other.
    assert!(a.2 * b.2 < 0.0, "{} {}", a.2, b.2);
}

/// The power of the surfaces heats the film: P = F·Δu + MΔω + rolling loss, which the sliding changes little. And generated heat
/// is carried off, to within 1 %.
#[test]
fn friction_power_is_work_of_force_and_moment() {
    let mut case = contact(true);
    case.motion.spin = [0.0; 2];
    let rolling = solved(&case).traction.friction_power.value;
    case.motion.slide_to_roll_ratio = 0.1;
    case.motion.slide_to_roll_ratio_across = 0.08;
    case.motion.spin = [-300.0, 700.0];
    let s = solved(&case);
    let t = &s.traction;
    let u_m = case.motion.entrainment_speed;
    let work = t.force.value * 0.1 * u_m
        + t.across.unwrap().force.value * 0.08 * u_m
        + t.moment.unwrap().value * 1000.0;
    let bar = t.friction_power.error.unwrap();
    println!("{} = {work} + {rolling}", t.friction_power.value);
    assert_relative_eq!(
        t.friction_power.value - work,
        rolling,
        max_relative = 0.03,
        epsilon = bar
    );
    assert!(t.moment.unwrap().value * 1000.0 > 0.2 * work);
    let mut hot = heated(case);
    hot.mesh = MeshParams::adaptive(2e-2, ContactKind::Circular);
    let thermal = solved(&hot).thermal.unwrap();
    assert!(
        thermal.balance.error.abs() < 0.01,
        "{}",
        thermal.balance.error
    );
    assert!(thermal.film_maximum.value > 313.5);
}

/// A line contact whose surfaces slide along its length: traction across, no moment.
#[test]
fn rollers_slide_along_their_axes() {
    let mut case = case(ContactKind::Line, 5e4);
    let carreau = Carreau::new(5e6, 0.5, 2.0, 0.1).unwrap();
    case.lubricant.shear_thinning = Some(ShearThinning::of(ShearLaw::Carreau(carreau)));
    case.mesh = MeshParams::adaptive(2e-3, ContactKind::Line);
    let [along, across] = [[0.05, 0.0], [0.0, 0.05]].map(|[along, across]| {
        let mut case = case.clone();
        case.motion.slide_to_roll_ratio = along;
        case.motion.slide_to_roll_ratio_across = across;
        solved(&case)
    });
    let turned = across.traction.across.unwrap();
    assert!(across.traction.moment.is_none());
    // The pressure gradient adds to the stress in the one direction and stands across it in the other.
    let ratio = turned.coefficient.value / along.traction.coefficient.value;
    assert!((ratio - 1.0).abs() < 0.05, "{ratio}");
    let h = [&along, &across].map(|s| s.summary.film_central.value);
    assert_relative_eq!(h[0], h[1], max_relative = 0.01);
}
