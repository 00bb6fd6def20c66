//! Rollers of finite length against lines, ellipses and closed forms.

use crate::common;

use std::sync::Arc;

use crate::common::text::read;
use approx::assert_relative_eq;
use common::{case, heated, near, solved};
use ertel::case::{Case, Lubricant};
use ertel::contact::roller::{Profile, Roller};
use ertel::contact::{Contact, ContactKind, Hertz, Motion, Symmetry};
use ertel::elastic::Accuracy;
use ertel::engine::{NoObserver, Observer, SolveError};
use ertel::params::{MeshParams, MeshPreset, Method};
use ertel::run::solve;
use ertel::solution::{Estimate, Figure, IterationRecord, Solution};
use ertel::solve::contact_surface::ContactSurface;
use ertel::solve::discretisation::Discretisation;
use ertel::warning::WarningKind;
use ertel_fem::linear::NEVER;
use ertel_rheology::ViscosityLaw;

const RADIUS: f64 = 0.016;
const PRESSURE: f64 = 0.7e9;

/// A roller under a load (N), refined to films within 1 %.
fn roller(load: f64, length: f64, profile: Profile, misalignment: f64) -> Case {
    let mut case = case(ContactKind::Circular, 1.0);
    let roller = Roller {
        length,
        profile,
        misalignment,
    };
    case.contact = Contact::of_roller(RADIUS, load, roller);
    case.mesh = MeshParams::adaptive(1e-2, ContactKind::Roller);
    case
}

/// The line contact at the pressure of these tests.
fn line() -> Case {
    let mut case = case(ContactKind::Circular, 1.0);
    case.contact = Contact::line(RADIUS, 1.0);
    case.contact.load = Hertz::load_for_pressure(&case.contact, case.reduced_modulus(), PRESSURE);
    case.mesh = MeshParams::preset(MeshPreset::Fine, ContactKind::Line);
    case
}

/// A roller of this length with Lundberg's profile for the load per length of that line, under that load.
fn lundberg(length: f64) -> Case {
    let line = line();
    let (w, modulus) = (line.contact.load, line.reduced_modulus());
    let b = line.hertz().half_width;
    roller(
        w * length,
        length,
        Profile::lundberg(length, w, b, modulus),
        0.0,
    )
}

/// Whether two figures agree within their bars and a share of themselves.
fn assert_alike(a: Estimate, b: Estimate, share: f64) {
    let bar = a.error.unwrap() + b.error.unwrap() + share * b.value.abs();
    assert!((a.value - b.value).abs() <= bar, "{a:?} {b:?}");
}

/// In the middle of a long roller of uniform pressure the film and the outlet are those of the line contact.
#[test]
fn the_middle_of_a_long_roller_is_a_line() {
    let (long, line) = (solved(&lundberg(0.012)), solved(&line()));
    assert_eq!(long.shape.symmetry, Symmetry::Half);
    assert_alike(long.summary.film_central, line.summary.film_central, 5e-3);
    assert_alike(
        long.summary.film_centreline_minimum.estimate(),
        line.summary.film_centreline_minimum.estimate(),
        5e-3,
    );
    assert_alike(
        long.summary.outlet_position,
        line.summary.outlet_position,
        5e-3,
    );
    assert!(long.summary.load_balance_error < 1e-7);
    // The ends of a profile for uniform pressure have the thinnest film.
    let thinnest = long.summary.film_minimum_at;
    assert!(thinnest.y < -0.45 * 0.012, "{thinnest:?}");
}

/// Under uniform Hertz pressure half-spaces close the gap of Lundberg's profile: G + δ is level on the middle line, but for the last
/// half-widths, by 3 % of the drop at the ends.
#[test]
fn uniform_pressure_closes_the_gap_of_lundberg() {
    let problem = ertel::run::problem(&lundberg(0.02));
    let contact = ContactSurface::new(
        &problem.shape,
        &problem.extents,
        &common::uniform(0.06),
        &problem.elasticity,
        NEVER,
    );
    let d = Discretisation::new(&Arc::new(contact.unwrap()), 2);
    let pressure = d.pressure.points.iter();
    let pressure: Vec<f64> = pressure
        .map(|p| (1.0 - p[0] * p[0]).max(0.0).sqrt())
        .collect();
    let deflection = d.deflect(&pressure, Accuracy::Full);
    let zone = &d.contact.shape.zone;
    let half = zone.roller.as_ref().unwrap().half_length();
    let gap = &d.contact.shape.gap;
    let levels: Vec<f64> = (d.contact.deflection.points.iter().zip(&deflection))
        .filter(|(p, _)| p[0].abs() < 0.02 && p[1].abs() < half - 3.0)
        .map(|(p, v)| gap.value([p[0], p[1]]) + v)
        .collect();
    let low = levels.iter().fold(f64::INFINITY, |m, v| m.min(*v));
    let high = levels.iter().fold(f64::NEG_INFINITY, |m, v| m.max(*v));
    let drop = gap.value([0.0, half]);
    assert!(levels.len() > 20 && drop > 1.0, "{} {drop}", levels.len());
    assert!(high - low < 0.03 * drop, "{low} to {high}, drop {drop}");
}

/// Radius of the crown of these tests, m.
const CROWN: f64 = 20.0 * RADIUS;

/// The ellipse of a crowned roller that is longer than its contact, and the roller, tilted by an angle (rad).
fn crowned(tilt: f64) -> [Case; 2] {
    crowned_by(CROWN, 5.0, tilt)
}

/// The same by finite elements, whose meshes these tests look at, for a crown of a radius in m, on a roller as many times as long as half of the contact.
fn crowned_by(crown_radius: f64, length_over: f64, tilt: f64) -> [Case; 2] {
    let mut ellipse = case(ContactKind::Circular, 1.0);
    let contact = Contact::elliptical([RADIUS, crown_radius], 1.0, 0.0);
    let load = Hertz::load_for_pressure(&contact, ellipse.reduced_modulus(), PRESSURE);
    ellipse.contact = Contact { load, ..contact };
    ellipse.mesh = MeshParams::adaptive(1e-2, ContactKind::Elliptical);
    let length = length_over * ellipse.hertz().half_width_y.unwrap();
    let profile = Profile::Crown { crown_radius };
    let mut roller = roller(load, length, profile, tilt);
    roller.solver.method = Some(Method::FiniteElements);
    [ellipse, roller]
}

/// A crowned roller that is longer than its contact has a Hertz ellipse, and its films and pressure.
#[test]
fn a_crowned_roller_is_an_ellipse() {
    let [ellipse, roller] = crowned(0.0).map(|case| solved(&case));
    assert_alike(
        roller.summary.film_central,
        ellipse.summary.film_central,
        2e-3,
    );
    assert_alike(
        roller.summary.film_minimum,
        ellipse.summary.film_minimum,
        2e-3,
    );
    let [p, q] = [&roller, &ellipse].map(|s| s.summary.pressure_maximum.estimate());
    assert_alike(p, q, 5e-3);
    // The half-length of the dry contact by slices is about that of the ellipse.
    let [_, along_y] = roller.shape.zone.half_extents();
    let semi_axis = ellipse.hertz.half_width_y.unwrap() / roller.hertz.half_width;
    assert_relative_eq!(along_y, semi_axis, max_relative = 0.03);
}

/// A thick film behind a crown whose dry contact is three times as wide as that of its line: the contact area goes on behind it. Where a given edge cuts the film off
/// in front of its minimum, the minimum of that area is found, with a warning, and no bar is zero.
#[test]
fn thick_films_behind_a_crown_are_not_cut_off() {
    let lubricant = Lubricant {
        viscosity: ViscosityLaw::roelands(0.02, 19e-9).unwrap(),
        ..case(ContactKind::Circular, 1.0).lubricant
    };
    let of = |contact: Contact, kind: ContactKind| Case {
        contact,
        motion: Motion::straight(2.0, 0.0),
        lubricant: lubricant.clone(),
        mesh: MeshParams::adaptive(1e-2, kind),
        ..case(ContactKind::Circular, 1.0)
    };
    let (radius, crown_radius, load) = (0.005, 0.4, 150.0);
    let crown = Roller {
        length: 0.016,
        profile: Profile::Crown { crown_radius },
        misalignment: 0.0,
    };
    let ellipse = of(
        Contact::elliptical([radius, crown_radius], load, 0.0),
        ContactKind::Elliptical,
    );
    let mut roller = of(Contact::of_roller(radius, load, crown), ContactKind::Roller);
    let found = solved(&roller);
    let minimum = found.summary.film_minimum;
    assert_alike(minimum, solved(&ellipse).summary.film_minimum, 0.0);
    assert!(minimum.error.unwrap() > 1e-5 * minimum.value);
    roller.mesh.outlet = Some(3.0);
    let cut = solved(&roller);
    // The given edge is solved: another minimum in front of it, and the reason.
    assert!(cut.summary.film_minimum.value < 0.95 * minimum.value);
    let kinds = cut.warnings.iter().map(|warning| warning.kind);
    assert!(
        kinds
            .into_iter()
            .any(|kind| kind == WarningKind::OutletEdge)
    );
}

/// Steep ends: a crown of an eighth of the roller's radius has an ellipse four times as long along the motion as across it. Its load per
/// length rises within a part of a half-width, and cells are shorter along the axis than across it.
#[test]
fn a_narrow_crown_is_a_slender_ellipse() {
    let cases = crowned_by(0.125 * RADIUS, 20.0, 0.0);
    let [ellipse, roller] = cases.map(|case| solved(&case));
    let zone = &roller.shape.zone;
    let [_, along_y] = zone.half_extents();
    let [_, _, across] = zone.diffusion_tensor([0.0, along_y]).unwrap();
    assert!(across < 0.1, "{across}");
    let films = |s: &Solution| [s.summary.film_central, s.summary.film_minimum];
    for (roller, ellipse) in films(&roller).into_iter().zip(films(&ellipse)) {
        println!("{roller:?} {ellipse:?}");
        assert_alike(roller, ellipse, 2e-3);
    }
}

/// A crown that falls off by half of what the ends need: the contact runs over them, the film there comes out at or below zero on
/// every mesh, and the solve fails.
#[test]
fn a_contact_that_runs_over_the_ends_is_reported() {
    let case = lundberg(0.004);
    let length = 0.004;
    let drop = case.contact.roller.as_ref().unwrap().height(0.5 * length)[0];
    let profile = Profile::Crown {
        crown_radius: 0.25 * length * length / drop,
    };
    let case = roller(case.contact.load, length, profile, 0.0);
    let outcome = solve(&case, &mut NoObserver);
    let Err(error @ SolveError::EndCarries { place, .. }) = outcome else {
        panic!("{:?}", outcome.map(|s| s.summary.film_minimum_at));
    };
    assert_relative_eq!(place.abs(), 0.5 * length, max_relative = 1e-5);
    assert!(error.advice().is_some());
}

/// A tilt θ moves the contact of a crown of the radius R along it by θR, towards the end that it presses in; the opposite tilt to the
/// other one. The film does not change, nor does the pressure.
#[test]
fn a_tilt_shifts_the_contact_along_the_crown() {
    let [ellipse, _] = crowned(0.0);
    let semi_axis = ellipse.hertz().half_width_y.unwrap();
    let tilt = 0.4 * semi_axis / CROWN;
    let ellipse = solved(&ellipse);
    let [right, left] = [tilt, -tilt].map(|angle| {
        let [_, case] = crowned(angle);
        let solution = solved(&case);
        assert_eq!(solution.shape.symmetry, Symmetry::Full);
        assert_alike(
            solution.summary.film_minimum,
            ellipse.summary.film_minimum,
            5e-3,
        );
        let figure = |figure| solution.figure(figure).unwrap();
        let position = figure(Figure::LoadPosition);
        let bar = position.error.unwrap() + 2e-3 * semi_axis;
        let shift = angle * CROWN;
        assert!((position.value - shift).abs() < bar, "{position:?} {shift}");
        let moment = figure(Figure::RollerMoment).value;
        near(moment, case.contact.load * position.value, 1e-9);
        [Figure::EdgePressureRight, Figure::EdgePressureLeft].map(figure)
    });
    // Mirror images: the ends exchange their pressures.
    let [a, b] = [right, left];
    assert_alike(a[0].estimate(), b[1].estimate(), 5e-3);
    assert!(a[0].value > 2.0 * a[1].value && b[1].value > 2.0 * b[0].value);
    assert!(a[0].y > 0.0 && b[1].y < 0.0);
}

/// Counts Newton iterations, and gives up after a number of them.
struct Count(usize, usize);

impl Observer for Count {
    fn iteration(&mut self, _: &IterationRecord) {
        self.0 += 1;
    }

    fn cancelled(&self) -> bool {
        self.0 > self.1
    }
}

/// A tilt that presses one end of a logarithmic profile in until its pressure falls to zero within half a half-width: the step from the
/// diffusive start is too long, and is given up for a continuation in diffusion. 69 Newton iterations in all; where it was tried to the end,
/// and then repeated with a softer penalty, more than 94 were not enough.
#[test]
fn a_tilted_logarithmic_roller_is_solved() {
    let text = include_str!("../../../cases/cylindrical-roller.toml");
    let text = text.replace("misalignment = \"0 deg\"", "misalignment = \"0.01 deg\"");
    let text = format!("{text}\n[mesh]\ntarget_error = \"2 %\"\n");
    let case = read(&text);
    near(
        case.contact.roller.as_ref().unwrap().misalignment,
        0.01_f64.to_radians(),
        1e-12,
    );
    let mut count = Count(0, 85);
    let solution = solve(&case, &mut count).unwrap();
    let film = solution.summary.film_central;
    // The middle does as without a tilt: 214.9 nm.
    assert!(
        (film.value - 214.9e-9).abs() < film.error.unwrap() + 0.5e-9,
        "{film:?}"
    );
    assert!(solution.figure(Figure::LoadPosition).unwrap().value > 0.0);
}

/// Heat under a tilted roller: generated heat is carried off, and the film is warmer than the inflow.
#[test]
fn heat_of_a_tilted_roller() {
    let [_, mut case] = crowned_by(2.0 * RADIUS, 2.5, 2e-4);
    case = heated(case);
    case.motion.slide_to_roll_ratio = 0.2;
    case.mesh = MeshParams::adaptive(0.02, ContactKind::Roller);
    case.solver.method = None;
    let solution = solved(&case);
    let thermal = solution.thermal.as_ref().unwrap();
    let error = thermal.balance.error;
    assert!(error.abs() < 0.02, "{error}");
    assert!(thermal.film_maximum.value > case.lubricant.temperature + 1.0);
    assert!(solution.figure(Figure::LoadPosition).unwrap().value > 0.0);
}
