//! Stresses in the bodies of solved contacts, by both methods.

use std::path::Path;

use ertel::case::Case;
use ertel::engine::NoObserver;
use ertel::output;
use ertel::params::OutputParams;
use ertel::run;
use ertel::solution::{Figure, Solution};
use ertel::stress::ShakedownBy;

const LINE: &str = include_str!("golden/cases/line.toml");
const CIRCLE: &str = include_str!("golden/cases/circle.toml");

fn solved(text: &str, method: &str) -> (Case, Solution) {
    let text = format!(
        "{text}\n[solver]\nmethod = \"{method}\"\n[stress]\nplanes = 40\n\
         body_1_hardness = {{ surface = 700, core = 350, case_depth = \"0.3 mm\" }}\n"
    );
    let case = Case::from_text("case.toml", &text, Path::new("")).unwrap();
    let solution = run::solve(&case, &mut NoObserver).unwrap();
    (case, solution)
}

/// The largest stresses are near those of the dry contact, both bodies have opposite tractions, and the loads of the stresses are those of the contact.
fn check(solution: &Solution, dry: [f64; 2]) {
    let stresses = solution.stresses.as_ref().unwrap();
    let (a, p) = (solution.hertz.half_width, solution.hertz.pressure);
    // A thick film has pressure far before the contact.
    assert!(
        (stresses.load_share - 1.0).abs() < 0.03,
        "{}",
        stresses.load_share
    );
    assert!((stresses.dry.von_mises.value / p - dry[0]).abs() < 0.01);
    assert!((stresses.dry.von_mises.depth / a - dry[1]).abs() < 0.02);
    let mu = solution.traction.coefficient.value;
    let [one, two] = &stresses.bodies;
    // Traction at mid-film is the mean of those at the walls.
    assert!(
        (0.5 * (one.traction - two.traction) - mu).abs() < 0.02 * mu.abs(),
        "{} {mu}",
        one.traction
    );
    assert!(one.traction > 0.0 && two.traction < 0.0);
    for body in [one, two] {
        // Below the pressure spike, whose stress at the surface may be larger.
        let deep = body.layers.iter().filter(|layer| layer.depth > 0.3 * a);
        let largest = deep.map(|layer| layer.von_mises).fold(0.0, f64::max);
        assert!((largest / p - dry[0]).abs() < 0.1, "{largest}");
        let shear = &body.orthogonal_half_range;
        let known = stresses.dry.orthogonal_half_range.unwrap();
        // Light loads spread into the inlet.
        assert!((shear.value / known.value - 1.0).abs() < 0.15, "{shear:?}");
        assert!(
            body.lives
                .iter()
                .all(|lives| lives.largest_stress[1].value > 0.0)
        );
    }
    assert!(one.utilisation.is_some() && two.utilisation.is_none());
    let by = match solution.shape.is_line() {
        true => ShakedownBy::OrthogonalShear,
        false => ShakedownBy::SmallestSphere,
    };
    assert_eq!(one.shakedown.by, by);
    assert!(one.shakedown.safety.is_some());
    let figure = solution.figure(Figure::VonMisesBody1).unwrap();
    assert_eq!(figure.value, one.von_mises.value);
}

#[test]
fn line_by_both_methods() {
    let (text, _) = LINE.split_once("[solver]").unwrap();
    let [(_, elements), (case, volumes)] =
        ["finite-elements", "finite-volumes"].map(|method| solved(text, method));
    check(&elements, [0.5575, 0.7043]);
    check(&volumes, [0.5575, 0.7043]);
    let files = output::files(&case.echo(), &volumes, &OutputParams::default()).unwrap();
    let named = |name: &str| files.iter().find(|file| file.name == name).unwrap();
    let table = String::from_utf8(named("stress.csv").bytes.clone()).unwrap();
    assert_eq!(table.lines().count(), 1 + 4 * 41);
    assert!(named("stress.svg").bytes.len() > 1000);
    let json: serde_json::Value = serde_json::from_slice(&named("result.json").bytes).unwrap();
    assert!(
        json["stress"]["bodies"][1]["orthogonal_half_range"]["depth"]
            .as_f64()
            .unwrap()
            > 0.0
    );
    let report = String::from_utf8(named("report.txt").bytes.clone()).unwrap();
    assert!(report.contains("Stresses in the bodies") && report.contains("shakedown"));
}

#[test]
fn circle_on_a_grid() {
    let (text, _) = CIRCLE.split_once("[mesh]").unwrap();
    let (_, volumes) = solved(text, "finite-volumes");
    // Body 1 is of glass, ν = 0.208: (1 + ν)(1 − z arctan 1/z) − 3/2(1 + z²) on the axis (Johnson 1985, eq. 3.45).
    check(&volumes, [0.6634, 0.4504]);
}

/// The largest stresses are figures of the output times, near those of the dry contact, and of no other instants.
#[test]
fn line_in_time() {
    let (text, _) = LINE.split_once("[mesh]").unwrap();
    let text = format!(
        "{text}\n[transient]\nduration = \"0.5 ms\"\noutput_times = [\"0.5 ms\"]\n[stress]\nplanes = 20\n"
    );
    let case = Case::from_text("case.toml", &text, Path::new("")).unwrap();
    let found = run::transient::solve(&case, &mut NoObserver);
    assert!(found.failure.is_none());
    let of = |figure: Figure| {
        let instants = found.instants.iter();
        let values = instants.map(|instant| instant.measured.figures.value(figure));
        values.collect::<Vec<_>>()
    };
    let values = of(Figure::OrthogonalShearBody2);
    let (last, others) = values.split_last().unwrap();
    assert!(others.iter().skip(1).all(Option::is_none));
    let share = last.unwrap() / case.hertz().pressure;
    assert!((0.2..0.27).contains(&share), "{share}");
    let rows = run::over_time::over_time(&found, true);
    let highest = ertel::figures::find(&rows, "von_mises_body_2_highest").unwrap();
    let of_instants = of(Figure::VonMisesBody2).into_iter().flatten();
    assert_eq!(highest.estimate.value, of_instants.fold(0.0, f64::max));
    let highest = ertel::figures::find(&rows, "near_surface_dang_van_body_1_highest").unwrap();
    let of_instants = of(Figure::NearSurfaceDangVanBody1).into_iter().flatten();
    assert_eq!(
        highest.estimate.value,
        of_instants.fold(f64::NEG_INFINITY, f64::max)
    );
}

const COATED: &str = include_str!("../../../cases/coated-ball-stresses.toml");

fn coated(layers: &str) -> (Case, Solution) {
    let hard = "[{ name = \"dlc\", thickness = \"2 um\" }]";
    let text = COATED.replace(hard, layers) + "\n[mesh]\ntarget_error = \"2 %\"\n";
    let case = Case::from_text("case.toml", &text, Path::new("")).unwrap();
    let solution = run::solve(&case, &mut NoObserver).unwrap();
    (case, solution)
}

/// A coating of 2 µm: both sides of its interface have the tractions and the strains along it in common, and the steel below is hardly affected.
#[test]
fn coated_ball() {
    let (case, solution) = coated("[{ name = \"dlc\", thickness = \"2 um\" }]");
    let stresses = solution.stresses.as_ref().unwrap();
    let [ball, disc] = &stresses.bodies;
    assert!(disc.parts.is_empty() && disc.interfaces.is_empty());
    let [coat, steel] = &ball.parts[..] else {
        panic!("{:?}", ball.parts);
    };
    let materials = [
        case.body_1.layers[0].body.elasticity,
        case.body_1.elasticity,
    ];
    let lower = (ball.layers.iter())
        .position(|layer| layer.site.unwrap().layer.is_none())
        .unwrap();
    let sides = [lower - 1, lower];
    let [above, below] = sides.map(|i| ball.below_largest.stress[i].0);
    let p = solution.hertz.pressure;
    for i in [2, 4, 5] {
        assert!((above[i] - below[i]).abs() < 1e-6 * p);
    }
    let strain = |stress: [f64; 6], side: usize| {
        let of = materials[side];
        (stress[0] - of.poissons_ratio * (stress[1] + stress[2])) / of.youngs_modulus
    };
    let [one, two] = [strain(above, 0), strain(below, 1)];
    assert!((one - two).abs() < 1e-6 * two.abs(), "{one} {two}");
    assert!(sides.iter().all(|i| {
        let depth = ball.axis.depth[*i];
        (depth - 2e-6).abs() < 1e-15 && ball.layers[*i].site.unwrap().interface == Some(1)
    }));
    let shear = ball.interfaces[0].shear.value;
    assert!(shear >= above[4].hypot(above[5]) && (shear / p - 0.05).abs() < 0.05);
    // The largest values of the body are those of its parts.
    let largest = coat.tension.value.max(steel.tension.value);
    assert!((ball.tension.value - largest).abs() < 1e-12 * largest);
    assert_eq!(
        solution.figure(Figure::TensionBody1).unwrap().value,
        largest
    );
    assert!(coat.utilisation.is_some() && steel.utilisation.is_some());
    let (_, bare) = coated("[]");
    let other = &bare.stresses.as_ref().unwrap().bodies[0];
    let ratio = steel.von_mises.value / other.von_mises.value;
    assert!((ratio - 1.0).abs() < 0.01, "{ratio}");
    let lives = |body: &ertel::stress::BodyStresses| body.lives[0].integral[1].unwrap().value;
    assert!((lives(ball) / lives(other) - 1.0).abs() < 0.1);
    let files = output::files(&case.echo(), &solution, &OutputParams::default()).unwrap();
    let text = |name: &str| {
        let file = files.iter().find(|file| file.name == name).unwrap();
        String::from_utf8(file.bytes.clone()).unwrap()
    };
    let table = text("stress.csv");
    let of_coat = table.lines().filter(|line| line.ends_with(",1")).count();
    assert_eq!(of_coat, 2 * lower);
    let json: serde_json::Value = serde_json::from_str(&text("result.json")).unwrap();
    assert_eq!(
        json["stress"]["bodies"][0]["parts"][0]["von_mises"]["site"]["layer"],
        1
    );
    let report = text("report.txt");
    for words in [
        "interface 1: largest shear",
        "layer 1: tension",
        "in the substrate",
    ] {
        assert!(report.contains(words), "{words}");
    }
}

/// A layer of the material of its body leaves the stresses as they are, but for the places of the planes.
#[test]
fn layer_of_the_same_material() {
    let largest = |layers: &str| {
        let (_, solution) = coated(layers);
        let body = &solution.stresses.as_ref().unwrap().bodies[0];
        let lives = body.lives[1].integral[2].unwrap().value;
        [
            body.von_mises.value,
            body.orthogonal_half_range.value,
            body.dang_van.value,
            lives,
        ]
    };
    let [bare, layered] = ["[]", "[{ name = \"steel\", thickness = \"9 um\" }]"].map(largest);
    for (one, other) in bare.into_iter().zip(layered) {
        assert!((one / other - 1.0).abs() < 1e-3, "{one} {other}");
    }
}

/// A residual stress moves Dang Van's index of each depth by its mean over three times the weight, and is in von Mises over yield strength; shakedown and the other body have none of it.
#[test]
fn residual_stress_in_a_case() {
    let (text, _) = LINE.split_once("[mesh]").unwrap();
    let stresses = |residual: &str| {
        let text = format!(
            "{text}\n[mesh]\ntarget_error = \"2 %\"\n[stress]\nplanes = 20\nbody_1_hardness = {{ uniform = 700 }}\n{residual}\n"
        );
        let case = Case::from_text("case.toml", &text, Path::new("")).unwrap();
        let solution = run::solve(&case, &mut NoObserver).unwrap();
        let report = output::report(&case.echo(), &solution, None);
        assert_eq!(
            report.contains("von Mises with residual stress"),
            !residual.is_empty()
        );
        (solution.stresses.unwrap(), solution.hertz.half_width)
    };
    let (bare, a) = stresses("");
    let table = format!(
        "body_1_residual_stress = {{ depth = [\"0 m\", \"{a} m\"], along = [\"-900 MPa\", \"0 MPa\"], across = [\"-600 MPa\", \"300 MPa\"] }}"
    );
    let (own, _) = stresses(&table);
    let strength = 700.0 * ertel::stress::YIELD_PER_HARDNESS;
    for (bare, own) in bare.bodies[0].layers.iter().zip(&own.bodies[0].layers) {
        let share = (own.depth / a).min(1.0);
        let mean = (-1500e6 + share * 1800e6) / 3.0;
        assert!((own.dang_van - bare.dang_van - 0.3 * mean).abs() < 1e-6 * mean.abs() + 1.0);
        let total = own.total_von_mises.unwrap();
        assert!((own.utilisation.unwrap() / (total / strength) - 1.0).abs() < 1e-12);
        assert_eq!(own.shakedown_shear, bare.shakedown_shear);
        assert_eq!(own.von_mises, bare.von_mises);
    }
    assert!(own.bodies[0].total_von_mises.is_some() && own.bodies[1].total_von_mises.is_none());
    assert_eq!(own.bodies[1].dang_van, bare.bodies[1].dang_van);
}
