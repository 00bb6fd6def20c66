//! Figures with error bars: those of the finest stage are those of the summary, and two meshes give each a bar.

use crate::common;

use std::path::Path;

use crate::common::text::{BALL, read};
use common::{contains, heated};
use ertel::contact::ContactKind;
use ertel::engine::NoObserver;
use ertel::output::{report, result_json};
use ertel::params::{MeshParams, MeshPreset};
use ertel::run::solve;
use ertel::solution::Role;
use ertel::solution::{Estimate, Figure, Located};

#[test]
fn every_figure_of_a_thermal_contact_has_its_bar() {
    let mut case = heated(common::case(ContactKind::Line, 8e4));
    case.motion.slide_to_roll_ratio = 0.4;
    // One solution, and one mesh to compare it with.
    case.mesh = MeshParams {
        target_error: None,
        ..MeshParams::preset(MeshPreset::Coarse, ContactKind::Line)
    };
    case.solver.error_estimate = true;
    let solution = solve(&case, &mut NoObserver).unwrap();
    let (s, t) = (&solution.summary, &solution.traction);
    let heat = solution.thermal.as_ref().unwrap();
    let estimates = [
        (Figure::FilmCentral, s.film_central),
        (Figure::FilmMinimum, s.film_minimum),
        (Figure::OutletPosition, s.outlet_position),
        (Figure::TractionCoefficient, t.coefficient),
        (Figure::TractionCoefficientBody1, t.coefficient_body_1),
        (Figure::TractionCoefficientBody2, t.coefficient_body_2),
        (Figure::TractionForce, t.force),
        (Figure::FrictionPower, t.friction_power),
        (Figure::ShearStressMaximum, t.shear_stress_maximum),
        (Figure::FilmTemperatureMean, heat.film_mean),
        (Figure::TemperatureBody1Mean, heat.body_1_mean),
        (Figure::TemperatureBody2Mean, heat.body_2_mean),
        (Figure::HeatShear, heat.balance.shear),
        (Figure::HeatCompression, heat.balance.compression),
        (Figure::HeatToBody1, heat.balance.to_body_1),
        (Figure::HeatToBody2, heat.balance.to_body_2),
        (Figure::HeatByFilm, heat.balance.by_film),
    ];
    let located = [
        (Figure::FilmMinimum, s.film_minimum_at),
        (Figure::FilmCentrelineMinimum, s.film_centreline_minimum),
        (Figure::PressureMaximum, s.pressure_maximum),
        (Figure::PressureCentral, s.pressure_central),
        (Figure::FilmTemperatureMaximum, heat.film_maximum),
        (Figure::FilmTemperatureLowest, heat.film_lowest),
        (Figure::TemperatureBody1Maximum, heat.body_1_maximum),
        (Figure::TemperatureBody2Maximum, heat.body_2_maximum),
    ];
    let finest = solution.stats.solved().unwrap();
    let check = |figure: Figure, e: Estimate| {
        let name = figure.name();
        assert_eq!(finest.figures.value(figure), Some(e.value), "{name}");
        assert!(e.error.is_some_and(|error| error > 0.0), "{name}: {e:?}");
    };
    for (figure, e) in estimates {
        check(figure, e);
    }
    for (figure, at) in located {
        let Located { x, y, .. } = at;
        check(figure, at.estimate());
        assert!(at.place_error.is_some(), "{}", figure.name());
        assert_eq!(finest.figures.get(figure).unwrap().place, Some([x, y]));
    }
    // The coarse mesh shows the effect of heat; so do its bars.
    let reduction = heat.reduction.unwrap();
    for e in [reduction.film_central, reduction.traction.unwrap()] {
        assert!(e.error.unwrap() > 0.0, "{e:?}");
    }
    // A stage that only leads to others has its films and its largest pressure.
    let start = &solution.stats.levels[0];
    assert_eq!(start.role, Role::Start);
    assert!(start.figures.value(Figure::PressureMaximum).is_some());
    assert_eq!(start.figures.value(Figure::FrictionPower), None);

    let echo = case.echo();
    let json = result_json(&echo, &solution).unwrap();
    for path in [
        "/summary/outlet_position",
        "/summary/pressure_maximum",
        "/traction/traction_coefficient",
        "/traction/friction_power",
        "/thermal/film_temperature_maximum",
        "/thermal/balance/heat_to_body_2",
        "/thermal/reduction/thermal_reduction_central",
    ] {
        let figure = json.pointer(path).unwrap();
        assert!(
            figure["value"].is_f64() && figure["error"].is_f64() && figure["resolved"].is_boolean(),
            "{path}"
        );
    }
    let level = json.pointer("/stats/levels/0/film_central").unwrap();
    assert!(level.is_f64());
    let text = report(&echo, &solution, None);
    for name in [
        "largest pressure",
        "outlet boundary",
        "traction coefficient",
        "friction power",
        "largest shear stress",
        "mean film temperature",
        "heat made by shear",
        "reduction by heat",
    ] {
        let line = result(&text, name);
        assert!(
            line.is_some_and(|line| line.contains('±') || line.contains("not resolved")),
            "{name}\n{text}"
        );
    }
}

/// Ball on disc, M = 199, L = 10, whose ridge reaches 1.10 to 1.15 GPa (52,900 pressures, and 54,837 along the ridge), above the 1.0112 GPa of
/// the middle that every mesh finds. The middle is accurate to 1 %, and the largest pressure is a lower bound that the ridge
/// may exceed; neither has it a sensitivity, nor a bar that omits the ridge.
#[test]
fn the_middle_is_resolved_and_the_ridge_is_a_lower_bound() {
    let text = format!("{BALL}[mesh]\ntarget_error = \"2 %\"\n[output]\nsensitivities = true\n");
    let case = read(text);
    let solution = common::solved(&case);
    let s = &solution.summary;
    let middle = s.pressure_central;
    assert!(middle.resolved, "{middle:?}");
    assert!(middle.error.unwrap() < 0.01 * middle.value, "{middle:?}");
    assert!((middle.value - 1.0112e9).abs() < 0.001e9, "{middle:?}");
    let largest = s.pressure_maximum;
    assert!(!largest.resolved, "{largest:?}");
    assert!(
        largest.value + largest.error.unwrap() > 1.12e9,
        "{largest:?}"
    );
    assert!(s.pressure_ridge.is_none_or(|ridge| !ridge.resolved));
    let sensitivities = solution.sensitivities.as_ref().unwrap();
    assert!(
        solution
            .sensitivities
            .as_ref()
            .unwrap()
            .figures
            .iter()
            .all(|f| f.figure != Figure::PressureMaximum)
    );
    // A dry contact's largest pressure is proportional to the cube root of the load, and a film of a tenth of the approach changes that by little.
    let of_middle = sensitivities
        .figures
        .iter()
        .find(|f| f.figure == Figure::PressureCentral)
        .unwrap();
    let by_load = sensitivities
        .logarithmic(of_middle)
        .into_iter()
        .find(|(key, _)| *key == "contact.load")
        .unwrap()
        .1;
    assert!((by_load - 1.0 / 3.0).abs() < 0.05, "{by_load}");
    let report = report(&case.echo(), &solution, None);
    let line = result(&report, "largest pressure").unwrap();
    assert!(
        line.contains("at least 1.0") && line.contains("not resolved"),
        "{line}"
    );
    contains(result(&report, "smooth pressure maximum").unwrap(), "±");
    let json = result_json(&case.echo(), &solution).unwrap();
    assert_eq!(json["summary"]["pressure_maximum"]["resolved"], false);
    assert_eq!(json["summary"]["pressure_central"]["resolved"], true);
}

/// Line of the results of a report.
fn result<'t>(text: &'t str, name: &str) -> Option<&'t str> {
    let results = text.lines().skip_while(|line| *line != "Results");
    let mut lines = results.skip(1);
    lines.find(|line| line.trim().starts_with(name))
}

/// The path to a single mesh contains no information on its errors: there are no bars, and no digits of them.
#[test]
fn without_an_estimate_there_are_no_bars() {
    let mut case = common::case(ContactKind::Line, 8e4);
    case.mesh.target_error = None;
    case.solver.error_estimate = false;
    let solution = solve(&case, &mut NoObserver).unwrap();
    assert_eq!(solution.summary.pressure_maximum.error, None);
    assert_eq!(solution.traction.friction_power.error, None);
    let text = report(&case.echo(), &solution, None);
    for name in ["largest pressure", "outlet boundary", "friction power"] {
        let line = result(&text, name);
        assert!(
            line.is_some_and(|line| !line.contains('±')),
            "{name}\n{text}"
        );
    }
}

/// The mean film is named in the registry and where it is measured, and nowhere else in the code: report, page, documents and tables read it from
/// the registry.
#[test]
fn a_figure_is_named_in_two_files() {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut files = Vec::new();
    sources(&crates, &mut files);
    assert!(files.len() > 400, "{} files", files.len());
    let mut found: Vec<String> = (files.iter())
        .filter(|file| {
            let text = std::fs::read_to_string(file).unwrap();
            ["FilmZoneMean", "film_zone_mean\"", "mean film in"]
                .iter()
                .any(|name| text.contains(name))
        })
        .map(|file| file.strip_prefix(&crates).unwrap().display().to_string())
        .collect();
    found.sort();
    let expected = [
        "ertel-ehl/src/engine/figures.rs",
        "ertel-ehl/src/solution/figures.rs",
    ];
    assert_eq!(found, expected);

    let case = common::case(ContactKind::Line, 8e4);
    let solution = solve(&case, &mut NoObserver).unwrap();
    let mean = solution.figure(Figure::FilmZoneMean).unwrap();
    let document = result_json(&case.echo(), &solution).unwrap();
    assert_eq!(document["figures"]["film_zone_mean"]["value"], mean.value);
    assert_eq!(document["figures"]["film_zone_mean"]["unit"], "m");
    assert!(report(&case.echo(), &solution, None).contains("mean film in the Hertz zone"));
    let page = ertel::output::html::report_page(&case.echo(), &solution, 1e-6);
    assert!(page.contains("film_zone_mean"));
    let titles: Vec<String> = ertel::study::columns().map(|c| c.title(true)).collect();
    assert!(titles.contains(&"film_zone_mean_m".to_owned()));
    // Between the smallest film and the largest of the dry contact's zone, and near the central one where the film is flat.
    let central = solution.summary.film_central.value;
    assert!(
        (mean.value / central - 1.0).abs() < 0.2,
        "{}",
        mean.value / central
    );
}

/// Sources below `src`, without tests.
fn sources(folder: &Path, found: &mut Vec<std::path::PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        if path.is_dir() && name != "tests" && name != "target" {
            sources(&path, found);
        } else if name.ends_with(".rs")
            && !name.contains("test")
            && path.iter().any(|part| part == "src")
        {
            found.push(path);
        }
    }
}
