//! Finite elements and finite volumes share the contact, the fluid and the evaluation of a film, but not the solver: figures that agree are confirmed
//! independently.

use std::collections::BTreeMap;

use ertel::case::Case;
use ertel::cross_check::{Crossed, Verdict, cross_check};
use ertel::engine::NoObserver;
use ertel::params::{Formulation, Method};
use ertel::run::{first_method, solve};
use ertel::solution::{Figure, Sensitivities, SensitivityMethod, Solution};

use crate::common::solved;
use crate::common::text::read;

fn case(contact: &str, motion: &str, more: &str) -> Case {
    case_of(contact, motion, more, "22")
}

/// The same with a pressure-viscosity coefficient in 1/GPa.
fn case_of(contact: &str, motion: &str, more: &str, alpha: &str) -> Case {
    read(text_of(contact, motion, more, alpha))
}

fn text_of(contact: &str, motion: &str, more: &str, alpha: &str) -> String {
    format!(
        "lubricant = {{ temperature = \"40 degC\", density = {{ law = \"dowson-higginson\", rho_0 = \"870 kg/m^3\" }}, viscosity = {{ law = \
         \"roelands\", mu_0 = \"40 mPa.s\", alpha = \"{alpha} 1/GPa\" }} }}\n[contact]\n{contact}\n[bodies]\nbody_1 = \"steel\"\nbody_2 = \"steel\"\n\
         [motion]\n{motion}\n{more}\n"
    )
}

/// The same with a law of the shear.
fn thinned_by(law: &str, text: &str) -> String {
    let thinning = format!("}}, shear_thinning = {{ {law} }} }}\n[contact]");
    text.replace("} }\n[contact]", &thinning)
}

/// The same with a mineral base oil whose viscosity falls with the temperature.
fn mineral(text: &str) -> String {
    text.replacen(
        "lubricant = { ",
        "lubricant = { base_oil = \"mineral\", ",
        1,
    )
    .replace(
        "mu_0 = ",
        "beta = \"0.04 1/K\", reference_temperature = \"40 degC\", mu_0 = ",
    )
}

/// The solution by finite volumes.
fn by_volumes(case: &mut Case) -> Solution {
    case.solver.method = Some(Method::FiniteVolumes);
    let own = solved(case);
    assert_eq!(own.stats.method, Method::FiniteVolumes);
    own
}

/// A figure of both methods, which must agree.
fn agreed(all: &[Crossed], figure: Figure) -> &Crossed {
    let crossed = all.iter().find(|c| c.figure == figure);
    let crossed = crossed.unwrap_or_else(|| panic!("{figure:?}"));
    assert_eq!(crossed.verdict(), Verdict::Agrees, "{crossed:?}");
    crossed
}

/// Figures of a solution next to those of another one.
fn crossed(own: &Solution, other: &Solution) -> Vec<Crossed> {
    let crossed = |(figure, own)| Crossed {
        figure,
        own,
        other: other.figure(figure),
    };
    own.figures().map(crossed).collect()
}

const METHODS: [Method; 2] = [Method::FiniteElements, Method::FiniteVolumes];

const BALL: &str = "kind = \"circular\"\nradius = \"16 mm\"\nload = \"30 N\"";

/// A ball, a ball that slides across and spins, an ellipse at an angle, one across the motion: both films, their mean and the
/// friction of both engines differ by no more than the sum of their bars, which are narrower than 3 % of films.
#[test]
fn both_engines_agree() {
    let straight = "entrainment_speed = \"0.8 m/s\"\nslide_to_roll_ratio = 0.1";
    let spin = "entrainment_speed = \"0.8 m/s\"\nslide_to_roll_ratio = 0.05\nslide_to_roll_ratio_across = 0.1\nbody_2_spin = \"300 rad/s\"";
    let ellipse = |angle: f64| {
        format!(
            "kind = \"elliptical\"\nradius_x = \"10 mm\"\nradius_y = \"40 mm\"\nentrainment_angle = \"{angle} deg\"\nload = \"60 N\""
        )
    };
    let mesh = "[mesh]\ntarget_error = 0.01";
    for case in [
        case(BALL, straight, mesh),
        case(BALL, spin, mesh),
        case(&ellipse(35.0), straight, mesh),
        case(&ellipse(0.0), straight, mesh),
    ] {
        let own = solved(&case);
        let found = cross_check(&case, &own, &mut NoObserver).unwrap();
        for figure in [
            Figure::FilmCentral,
            Figure::FilmMinimum,
            Figure::FilmZoneMean,
            Figure::FilmCentrelineMinimum,
            Figure::TractionCoefficientBody2,
            Figure::FrictionPower,
        ] {
            agreed(&found.figures, figure);
        }
        for film in [Figure::FilmCentral, Figure::FilmMinimum] {
            let crossed = agreed(&found.figures, film);
            let (_, bars) = crossed.difference().unwrap();
            assert!(bars < 0.03 * crossed.own.value, "{crossed:?}");
        }
    }
}

/// A roller with a crown, a ball with heat, and one that spins, too, by both methods: figures as above, and mean temperatures. The largest ones stand on the ridge of
/// a Newtonian film, which neither resolves at this target.
#[test]
fn both_engines_agree_on_rollers_and_heat() {
    let motion = "entrainment_speed = \"2 m/s\"\nslide_to_roll_ratio = 0.1";
    let roller = "kind = \"roller\"\nradius = \"5 mm\"\nlength = \"8 mm\"\nload = \"200 N\"\n\
                  profile = { kind = \"crown\", crown_radius = \"400 mm\" }";
    let mesh = "[mesh]\ntarget_error = 0.05\n[output]\nsensitivities = false";
    let heat = "[thermal]\n[mesh]\ntarget_error = 0.05\n[output]\nsensitivities = false";
    let warm = mineral(&text_of(BALL, motion, heat, "20"));
    // Either way, at the edge with an eighth of their speeds.
    let spin = format!("{motion}\nbody_1_spin = \"-1500 rad/s\"\nbody_2_spin = \"1500 rad/s\"");
    let contact = "kind = \"circular\"\nradius = \"10 mm\"\nload = \"60 N\"";
    let spinning = warm.replace(motion, &spin).replace(BALL, contact);
    // Newtonian films would transmit more than dry metal does.
    let eyring = "law = \"ree-eyring\", tau_0 = \"6 MPa\"";
    let roller = thinned_by(eyring, &text_of(roller, motion, mesh, "22"));
    let spinning = thinned_by(eyring, &spinning);
    let cases = [roller, warm, spinning].map(read);
    let of_heat = &[
        Figure::FilmTemperatureMean,
        Figure::TemperatureBody1Mean,
        Figure::TemperatureBody2Mean,
        Figure::TractionCoefficient,
    ][..];
    for (mut case, asked) in cases.into_iter().zip([
        &[Figure::TractionCoefficient, Figure::FrictionPower][..],
        of_heat,
        of_heat,
    ]) {
        let own = by_volumes(&mut case);
        let found = cross_check(&case, &own, &mut NoObserver).unwrap();
        let films = [Figure::FilmCentral, Figure::FilmMinimum];
        for figure in films.iter().chain(asked) {
            agreed(&found.figures, *figure);
        }
    }
}

/// In the middle of a long roller whose profile spreads the load evenly film and temperatures are those of the line contact, by finite elements, which has nothing in common with its heat. Along
/// the centreline the largest rises are compared; friction over all of the roller, whose ends differ.
#[test]
fn the_middle_of_a_long_roller_with_heat_is_a_line() {
    let text = |contact: &str, target: f64| {
        let motion = "entrainment_speed = \"4 m/s\"\nslide_to_roll_ratio = 0.4";
        let more =
            format!("[thermal]\n[mesh]\ntarget_error = {target}\n[output]\nsensitivities = false");
        let text = mineral(&text_of(contact, motion, &more, "18"));
        read(thinned_by("law = \"ree-eyring\", tau_0 = \"6 MPa\"", &text))
    };
    let roller = "kind = \"roller\"\nradius = \"15 mm\"\nlength = \"8 mm\"\nload = \"1.2 kN\"\n\
                  profile = { kind = \"logarithmic\", design_load = \"1.2 kN\" }";
    let line = "kind = \"line\"\nradius = \"15 mm\"\nload = \"150 kN/m\"";
    let (roller, line) = (solved(&text(roller, 0.03)), solved(&text(line, 5e-3)));
    let methods = [&roller, &line].map(|s| s.stats.method);
    assert_eq!(methods, [Method::FiniteVolumes, Method::FiniteElements]);
    let figures = |s: &Solution| {
        let thermal = s.thermal.as_ref().unwrap();
        let of = &thermal.centreline;
        let [body_1, body_2, mean] = [&of.body_1, &of.body_2, &of.mean].map(|t| {
            let largest = t.iter().fold(f64::NEG_INFINITY, |m, t| m.max(*t));
            largest - thermal.inlet_temperature
        });
        let friction = s.figure(Figure::TractionCoefficient).unwrap().value;
        [s.summary.film_central.value, body_1, body_2, mean, friction]
    };
    let all = figures(&roller).into_iter().zip(figures(&line));
    for ((found, expected), most) in all.zip([5e-3, 0.02, 0.02, 5e-3, 0.03]) {
        assert!(
            (found / expected - 1.0).abs() < most,
            "{found} {expected} {most}"
        );
    }
}

/// Heat of a flooded line contact and of a starved one: films, friction and temperatures differ by no more than the sum of their bars, 2 % and 0.5 K. What the film carries off is counted
/// as far as the area goes, which is not the same by both.
#[test]
fn both_engines_agree_on_heat_of_lines() {
    const SETTINGS: &str = "[thermal]\n[mesh]\ntarget_error = 0.1\nmax_unknowns = 4000\n[output]\nsensitivities = false";
    let line = "kind = \"line\"\nradius = \"15 mm\"\nload = \"150 kN/m\"";
    let motion = "entrainment_speed = \"4 m/s\"\nslide_to_roll_ratio = 0.5";
    let layer = |nm: u32| format!("[inlet]\noil_layer = \"{nm} nm\"\n");
    let warm = |contact: &str, more: &str| read(mineral(&text_of(contact, motion, more, "18")));
    for mut case in [warm(line, SETTINGS), warm(line, &(layer(400) + SETTINGS))] {
        let own = by_volumes(&mut case);
        let found = cross_check(&case, &own, &mut NoObserver).unwrap();
        for figure in [
            Figure::FilmCentral,
            Figure::FilmMinimum,
            Figure::TractionCoefficient,
            Figure::FilmTemperatureMaximum,
            Figure::FilmTemperatureMean,
            Figure::TemperatureBody1Maximum,
            Figure::TemperatureBody1Mean,
            Figure::TemperatureBody2Maximum,
            Figure::TemperatureBody2Mean,
            Figure::HeatShear,
        ] {
            let crossed = agreed(&found.figures, figure);
            let (difference, _) = crossed.difference().unwrap();
            let most = match figure.unit(false) == "K" {
                true => 0.5,
                false => 0.02 * crossed.own.value,
            };
            assert!(difference.abs() < most, "{crossed:?}");
        }
    }
}

/// Cylinders: a Newtonian fluid, a layer of oil, Eyring's fluid that slides along and across: films, pressure and the outlet differ by no more than the sum of their
/// bars, below 1 % of each. Traction differs by up to 0.6 %, the friction power of the layer by 1.8 %, beyond the bars of the elements, whose penalty leaves a
/// pressure below zero behind the film.
#[test]
fn both_engines_agree_on_lines() {
    let line = "kind = \"line\"\nradius = \"16 mm\"\nload = \"80 kN/m\"";
    let straight = "entrainment_speed = \"0.8 m/s\"\nslide_to_roll_ratio = 0.1";
    let across = format!("{straight}\nslide_to_roll_ratio_across = 0.2");
    let mesh = "[mesh]\ntarget_error = 0.002\n[output]\nsensitivities = false";
    let starved = format!("{mesh}\n[inlet]\noil_layer = \"150 nm\"");
    let plain = |more: &str| text_of(line, straight, more, "10");
    let eyring = thinned_by(
        "law = \"ree-eyring\", tau_0 = \"5 MPa\"",
        &text_of(line, &across, mesh, "22"),
    );
    for text in [plain(mesh), plain(&starved), eyring] {
        let mut case = read(text);
        let own = by_volumes(&mut case);
        case.solver.method = Some(Method::FiniteElements);
        let other = solved(&case);
        let found = crossed(&own, &other);
        for figure in [
            Figure::FilmCentral,
            Figure::FilmMinimum,
            Figure::FilmZoneMean,
            Figure::PressureCentral,
            Figure::OutletPosition,
        ] {
            let crossed = agreed(&found, figure);
            let (_, bars) = crossed.difference().unwrap();
            assert!(bars < 0.01 * crossed.own.value, "{crossed:?}");
        }
        for (figure, share) in [
            (Figure::TractionCoefficient, 0.01),
            (Figure::TractionCoefficientBody2, 0.01),
            (Figure::FrictionPower, 0.02),
        ] {
            let crossed = found.iter().find(|c| c.figure == figure).unwrap();
            let (difference, _) = crossed.difference().unwrap();
            let size = crossed.own.value.abs();
            assert!(difference.abs() < share * size, "{crossed:?}");
        }
        // The same figures.
        let names = |found: &Solution| {
            let figures = found.figures().map(|(figure, _)| figure);
            figures.collect::<Vec<_>>()
        };
        assert_eq!(names(&own), names(&other));
    }
}

/// Fluids that thin by shear, as above and with the effect of thinning on the film: Eyring's with sliding across and spin, Carreau's in an ellipse at
/// an angle.
#[test]
fn both_engines_agree_on_thinning() {
    let straight = "entrainment_speed = \"0.8 m/s\"\nslide_to_roll_ratio = 0.3";
    let spin = "entrainment_speed = \"0.8 m/s\"\nslide_to_roll_ratio = 0.2\nslide_to_roll_ratio_across = 0.1\nbody_2_spin = \"300 rad/s\"";
    let ellipse = "kind = \"elliptical\"\nradius_x = \"10 mm\"\nradius_y = \"40 mm\"\nentrainment_angle = \"35 deg\"\nload = \"60 N\"";
    let mesh = "[mesh]\ntarget_error = 0.01";
    let eyring = "law = \"ree-eyring\", tau_0 = \"5 MPa\"";
    let carreau = "law = \"carreau\", g_c = \"0.1 MPa\", n = 0.5, beta_c = 2.0, mu_2 = \"0 Pa.s\"";
    for (contact, motion, law) in [(BALL, spin, eyring), (ellipse, straight, carreau)] {
        let mut case = read(thinned_by(law, &text_of(contact, motion, mesh, "22")));
        let own = by_volumes(&mut case);
        case.solver.method = Some(Method::FiniteElements);
        let other = solved(&case);
        let found = crossed(&own, &other);
        for figure in [
            Figure::FilmCentral,
            Figure::FilmMinimum,
            Figure::FilmZoneMean,
            Figure::TractionCoefficient,
            Figure::TractionCoefficientBody2,
            Figure::FrictionPower,
        ] {
            let crossed = agreed(&found, figure);
            let (_, bars) = crossed.difference().unwrap();
            // Power is summed as far as the bodies go, where its bars hold what lies beyond.
            let is_narrow = bars < 0.03 * crossed.own.value.abs();
            assert!(
                is_narrow || figure == Figure::FrictionPower,
                "{law} {crossed:?}"
            );
        }
        let other = other.film_reduction.unwrap().central;
        let own = own.film_reduction.unwrap().central;
        let bars = own.error.unwrap() + other.error.unwrap();
        assert!(
            (own.value - other.value).abs() < bars,
            "{law} {own:?} {other:?}"
        );
    }
}

/// The load group 9478 at 4.6 GPa, whose first grids have films far below zero: both films within their bars of those of the finite elements on 40,000 cubic
/// pressures (45.93 ± 0.01 and 9.33 nm), and of 2048 cells of an independent solver (45.93 and 9.36 nm by extrapolation).
#[test]
fn thin_film_of_a_heavy_load() {
    let heavy = BALL.replace("30 N", "1000 N");
    let motion = "entrainment_speed = \"0.1 m/s\"\nslide_to_roll_ratio = 0.0";
    let mut case = case(&heavy, motion, "[mesh]\nmax_unknowns = 120000");
    case.solver.method = Some(Method::FiniteVolumes);
    let solution = solved(&case);
    let central = solution.summary.film_central;
    let error = 45.93e-9 - central.value;
    assert!(error.abs() < central.error.unwrap(), "{central:?}");
    assert!(error.abs() < 0.015 * central.value, "{central:?}");
    let minimum = solution.summary.film_minimum;
    assert!(
        (9.34e-9 - minimum.value).abs() < minimum.error.unwrap(),
        "{minimum:?}"
    );
}

/// Pressures have one hill and, beyond its pass, the ridge: none of the other extrema that elements make, and none below zero.
#[test]
fn pressures_have_no_false_extremum() {
    let mut case = case(
        BALL,
        "entrainment_speed = \"0.8 m/s\"\nslide_to_roll_ratio = 0.0",
        "",
    );
    case.solver.method = Some(Method::FiniteVolumes);
    let solution = solved(&case);
    let line = &solution.centreline;
    assert!(line.pressure.iter().all(|p| *p >= 0.0));
    let turns = line.pressure.windows(3).filter(|w| {
        let rises = [w[1] - w[0], w[2] - w[1]];
        rises[0] * rises[1] < 0.0
    });
    // The hill, the pass and the ridge.
    assert_eq!(turns.count(), 3);
}

/// Contacts that finite elements do not solve within their iteration limit are solved by finite volumes, with a warning, unless the method is given.
#[test]
fn volumes_solve_contacts_that_elements_do_not() {
    let motion = "entrainment_speed = \"0.8 m/s\"\nslide_to_roll_ratio = 0.0";
    // Lines with heat: elements are tried first.
    let line = "kind = \"line\"\nradius = \"10 mm\"\nload = \"20 kN/m\"";
    let more = "[thermal]\n[mesh]\ntarget_error = 0.05";
    let mut case = read(mineral(&text_of(line, motion, more, "22")));
    case.solver.max_iterations = 1;
    let solution = solved(&case);
    assert_eq!(solution.stats.method, Method::FiniteVolumes);
    let reported = solution
        .warnings
        .iter()
        .filter(|w| w.contains("solved by finite volumes"));
    assert_eq!(reported.count(), 1);
    case.solver.method = Some(Method::FiniteElements);
    assert!(solve(&case, &mut NoObserver).is_err());
    // Nor where the case itself requests elements.
    case.solver.method = None;
    case.solver.formulation = Formulation::Supg;
    assert!(solve(&case, &mut NoObserver).is_err());
}

/// A ball at M = 5, L = 7, whose film is thicker than the contact is deep and reaches hundreds of half-widths far, and one at M = 20, L = 16, where the
/// viscosity grows by e³² up to the Hertz pressure: films of both methods differ by no more than their bars, or by half a per cent.
#[test]
fn thick_films_and_steep_viscosities() {
    let motion = "entrainment_speed = \"0.8 m/s\"\nslide_to_roll_ratio = 0.0";
    for (load, alpha) in [("2.5", "15"), ("10", "34")] {
        let ball = BALL.replace("30 N", &format!("{load} N"));
        let mut case = case_of(&ball, motion, "[mesh]\ntarget_error = 0.02", alpha);
        let films = METHODS.map(|method| {
            case.solver.method = Some(method);
            let solution = solved(&case);
            assert_eq!(solution.stats.method, method);
            [Figure::FilmCentral, Figure::FilmMinimum].map(|f| solution.measured.estimate(f))
        });
        for (a, b) in films[0].iter().zip(&films[1]) {
            let bars = a.error.unwrap() + b.error.unwrap();
            let difference = (a.value - b.value).abs();
            assert!(difference < bars.max(5e-3 * b.value), "{a:?} {b:?}");
        }
    }
}

/// Sensitivities of a sliding ball, an ellipse at an angle and a cylinder by linear solves agree with those by differences of elements to 3 % of the largest, of the minimum film to 5 %: that of the ellipse by
/// its load is -0.173 on fine grids, -0.199 and -0.157 here.
#[test]
fn both_methods_give_the_same_sensitivities() {
    let motion = "entrainment_speed = \"0.8 m/s\"\nslide_to_roll_ratio = 0.1";
    let ellipse = "kind = \"elliptical\"\nradius_x = \"10 mm\"\nradius_y = \"30 mm\"\nentrainment_angle = \"25 deg\"\nload = \"60 N\"";
    let more = "[mesh]\ntarget_error = 0.02\n[output]\nsensitivities = true";
    let cylinder = "kind = \"line\"\nradius = \"16 mm\"\nload = \"60 kN/m\"";
    for contact in [BALL, ellipse, cylinder] {
        // Newtonian films of the others would transmit more than dry metal does.
        let motion = match contact == BALL {
            true => motion.to_owned(),
            false => motion.replace("0.1", "0.001"),
        };
        let mut case = case(contact, &motion, more);
        let [elements, volumes] = METHODS.map(|method| {
            case.solver.method = Some(method);
            solved(&case).sensitivities.unwrap()
        });
        assert_eq!(elements.by, SensitivityMethod::Differences);
        assert_eq!(volumes.by, SensitivityMethod::LinearSolves);
        for figure in [
            Figure::FilmCentral,
            Figure::FilmMinimum,
            Figure::TractionCoefficient,
        ] {
            let of = |found: &Sensitivities| {
                let figure = found.figures.iter().find(|f| f.figure == figure).unwrap();
                let by = found.logarithmic(figure);
                let by = by.into_iter().map(|(key, by)| (key.to_owned(), by));
                by.collect::<BTreeMap<String, f64>>()
            };
            let (own, other) = (of(&elements), of(&volumes));
            // The temperature counts from absolute zero, and would hide the others.
            let is_counted = |key: &String| !key.contains("temperature");
            let largest = (own.iter().filter(|(key, _)| is_counted(key)))
                .fold(0.0_f64, |m, (_, by)| m.max(by.abs()));
            for (key, by) in own.iter().filter(|(key, _)| is_counted(key)) {
                let difference = (by - other[key]).abs();
                // By steps of 1 %, and of traction by the slope of an exponential.
                let most = match figure {
                    Figure::FilmMinimum => 0.07,
                    Figure::TractionCoefficient => 0.05,
                    _ => 0.03,
                };
                assert!(
                    difference < most * largest,
                    "{figure:?} {key}: {by} {}",
                    other[key]
                );
            }
        }
    }
}

/// Without a method contacts are solved by volumes, lines with heat and cases with keys of elements by elements.
#[test]
fn the_method_that_takes_less_time() {
    let motion = "entrainment_speed = \"0.8 m/s\"\nslide_to_roll_ratio = 0.0";
    let ellipse =
        "kind = \"elliptical\"\nradius_x = \"10 mm\"\nradius_y = \"30 mm\"\nload = \"60 N\"";
    let line = "kind = \"line\"\nradius = \"10 mm\"\nload = \"100 kN/m\"";
    let layer = "[inlet]\noil_layer = \"150 nm\"";
    let [elements, volumes] = METHODS;
    let thinned = |law: &str| read(thinned_by(law, &text_of(BALL, motion, "", "22")));
    let heated = |contact: &str| read(mineral(&text_of(contact, motion, "[thermal]", "22")));
    for (case, method) in [
        (case(ellipse, motion, ""), volumes),
        (case(BALL, motion, layer), volumes),
        (
            thinned("law = \"rabinowitsch\", tau_0 = \"5 MPa\", n = 0.5"),
            volumes,
        ),
        (case(BALL, motion, ""), volumes),
        (heated(BALL), volumes),
        (case(line, motion, ""), volumes),
        (heated(line), elements),
        (case(ellipse, motion, "[mesh]\ngrowth = 1.5"), elements),
        (
            case(ellipse, motion, "[solver]\nformulation = \"gls\""),
            elements,
        ),
        (
            case(ellipse, motion, "[solver]\nmethod = \"finite-elements\""),
            elements,
        ),
    ] {
        assert_eq!(first_method(&case), method, "{}", case.source);
    }
}

/// The film of an ellipse at 45 degrees in a thick oil is of some hundred times the depth of the contact; a try of Newton's method on a grid that ends
/// in no number is repeated with shorter steps and leaves none in the history.
#[test]
fn a_try_that_ends_in_no_number_leaves_none() {
    let text = "lubricant = { name = \"pao-650\", temperature = \"348 K\" }\n[contact]\nkind = \"elliptical\"\nradius_x = \"36 mm\"\n\
        radius_y = \"3 mm\"\nhertz_pressure = \"0.45 GPa\"\nentrainment_angle = \"45 deg\"\n[bodies]\nbody_1 = \"steel\"\nbody_2 = \"steel\"\n\
        [motion]\nentrainment_speed = \"12 m/s\"\nslide_to_roll_ratio = 0.0\n[solver]\nmethod = \"finite-volumes\"\nnewtonian = true\n\
        isothermal = true\n[output]\nsensitivities = false";
    let solution = solved(&read(text));
    assert!(solution.history.iter().all(|step| step.update.is_finite()));
    assert!(solution.summary.film_central.value > 1e-6);
}
