//! Films from tables, computed and measured.

use ertel::contact::Family;
use ertel::fit::{FilmForm, FilmKind, fit_film, read_films};

#[test]
fn results_are_read_by_their_columns() {
    let csv = "point,film_central_m,film_central_error_m,moes_load,moes_material,speed_group\n\
               1,1e-7,1e-10,20,1,1e-12\n2,,,,,\n3,2e-7,1e-10,10,1,2e-12\n";
    let read_with = |text: &str, form, kind| read_films("r.csv", text, form, kind, Some(0.01));
    let read = |text: &str, kind| read_with(text, FilmForm::Moes, kind);
    let states = read(csv, FilmKind::Central).unwrap().unwrap().states;
    assert_eq!(states.len(), 2);
    assert_eq!(
        (states[1].film, &states[1].variables),
        (2e-7, &vec![10.0, 1.0])
    );
    assert_eq!(states[1].scale, 0.01 * f64::sqrt(2.0 * 2e-12));
    assert!((states[1].error.unwrap() - 1e-10 / 2e-7).abs() < 1e-15);
    // M = W (2U)^(-3/4), L = G (2U)^(1/4)
    let form = FilmForm::HamrockDowson(Family::Point);
    let states = read_with(csv, form, FilmKind::Central)
        .unwrap()
        .unwrap()
        .states;
    let [u, g, w] = states[1].variables[..] else {
        panic!("three groups");
    };
    assert_eq!((u, states[1].scale), (2e-12, 0.01));
    assert!((g * 4e-12f64.powf(0.25) - 1.0).abs() < 1e-12);
    assert!((w * 4e-12f64.powf(-0.75) - 10.0).abs() < 1e-11);
    assert_eq!(read(csv, FilmKind::Minimum), Ok(None));
    let error = read(&csv.replace("moes_load", "m"), FilmKind::Central).unwrap_err();
    assert!(
        error
            .to_string()
            .starts_with("r.csv:1:1: there is no column `moes_load`")
    );
    let error = read(&csv.replace(",20,", ",-20,"), FilmKind::Central).unwrap_err();
    assert_eq!((error.line, error.column), (2, 4), "{error}");
    let error = read_films("r.csv", csv, FilmForm::Moes, FilmKind::Central, None).unwrap_err();
    assert!(error.to_string().contains("radius_m"), "{error}");
    // An isoviscous fluid has no exponent of L; one among others has no logarithm.
    let none = csv.replace(",1,1e-12", ",0,1e-12");
    let error = read(&none, FilmKind::Central).unwrap_err();
    assert_eq!((error.line, error.column), (2, 5), "{error}");
    let none = none.replace(",1,2e-12", ",0,2e-12");
    assert!(read(&none, FilmKind::Central).unwrap().is_some());
}

/// Rig data: films over speed, in the units of the rig.
#[test]
fn films_over_speed_need_speed_alone() {
    let csv = "speed [mm/s]; film_central [nm]; load [N]; temperature [degC]\n\
               100; 10; 20; 40\n200; 16; 20; 40\n400; 25; 20; 40\n800; 40; 20; 40\n";
    let read = |text: &str, form| read_films("rig.csv", text, form, FilmKind::Central, None);
    let films = read(csv, FilmForm::Speed).unwrap().unwrap();
    assert!((films.states[1].film - 16e-9).abs() < 1e-20 && films.states[1].variables == [0.2]);
    assert!(films.warnings.is_empty(), "{:?}", films.warnings);
    let fit = fit_film(&films, 0.95).unwrap();
    // By hand: the four logarithms are 0.693 apart in speed; slope Σ(i - 1.5) ln h / (5 ln 2).
    let logs = [10f64, 16.0, 25.0, 40.0].map(f64::ln);
    let sum = -1.5 * logs[0] - 0.5 * logs[1] + 0.5 * logs[2] + 1.5 * logs[3];
    let slope = sum / (5.0 * 2f64.ln());
    assert!((fit.values()[1] - slope).abs() < 1e-9);
    let heavier = csv.replace("800; 40; 20", "800; 40; 30");
    let films = read(&heavier, FilmForm::Speed).unwrap().unwrap();
    assert!(films.warnings[0].starts_with("the load varies from 20 to 30"));
    // Warnings are in the unit of the column, with its zero.
    for (unit, celsius) in [("degC", ["40", "47.5"]), ("degF", ["104", "117.5"])] {
        let warmer = csv
            .replace("[degC]", &format!("[{unit}]"))
            .replace("20; 40", &format!("20; {}", celsius[0]))
            .replace(
                &format!("800; 40; 20; {}", celsius[0]),
                &format!("800; 40; 20; {}", celsius[1]),
            );
        let films = read(&warmer, FilmForm::Speed).unwrap().unwrap();
        let words = format!(
            "the temperature varies from {} to {} (",
            celsius[0], celsius[1]
        );
        assert!(
            films.warnings[0].starts_with(&words),
            "{:?}",
            films.warnings
        );
    }
    let form = FilmForm::SpeedLoad(Family::Point);
    assert!(read(&heavier, form).unwrap().unwrap().warnings.is_empty());
    // Columns that a form needs and the table has not.
    for (form, text, column) in [
        (
            FilmForm::Speed,
            csv.replace("speed", "column_1"),
            "entrainment_speed",
        ),
        (form, csv.replace("load", "column_3"), "load"),
        (FilmForm::Moes, csv.to_owned(), "moes_load"),
        (
            FilmForm::HamrockDowson(Family::Point),
            csv.to_owned(),
            "moes_load",
        ),
        (FilmForm::Blend(Family::Point), csv.to_owned(), "moes_load"),
    ] {
        let error = read(&text, form).unwrap_err().to_string();
        let missing = format!("rig.csv:1:1: there is no column `{column}`");
        assert!(error.starts_with(&missing), "{error}");
    }
}

/// Films at one W and one G, as another program writes them: with four digits, the groups computed from M, L and U vary by
/// rounding alone, and have no exponent.
#[test]
fn rounding_of_four_digits_is_no_variation() {
    let (w, g): (f64, f64) = (1.3e-7, 4500.0);
    let mut csv = "film_central_m,moes_load,moes_material,speed_group\n".to_owned();
    for i in 0..40 {
        let u = 1.03e-12 * 1.06f64.powi(i);
        let (m, l) = (w * (2.0 * u).powf(-0.75), g * (2.0 * u).powf(0.25));
        let film = 0.01 * 1.9 * u.powf(0.67);
        csv += &format!("{film:.3e},{m:.3e},{l:.3e},{u:.3e}\n");
    }
    let form = FilmForm::HamrockDowson(Family::Point);
    let films = read_films("r.csv", &csv, form, FilmKind::Central, Some(0.01));
    let films = films.unwrap().unwrap();
    let largest = |i: usize| {
        let values = || films.states.iter().map(|s| s.variables[i]);
        values().fold(0.0, f64::max) / values().fold(f64::INFINITY, f64::min)
    };
    assert!(largest(2) > 1.0 + 5e-4, "{}", largest(2));
    let fit = fit_film(&films, 0.95).unwrap();
    let [_, Some(speed), None, None] = fit.constants[..] else {
        panic!("{:?}", fit.constants);
    };
    assert!((speed.value - 0.67).abs() < 1e-3, "{speed:?}");
    assert!(
        fit.warnings[0].starts_with("G does not vary (it is 4"),
        "{:?}",
        fit.warnings
    );
}

/// Thermal and isothermal films in one table, distinguished by their temperatures or by the switch of a study.
#[test]
fn thermal_and_isothermal_films_are_distinguished() {
    let read = |text: &str| {
        let films = read_films("r.csv", text, FilmForm::Moes, FilmKind::Central, Some(0.01));
        films.unwrap().unwrap().warnings
    };
    let expected = "1 of the films are thermal and 2 isothermal: the form does not distinguish them; omit one kind";
    for [title, with, without] in [
        ["film_temperature_maximum_K", "320", ""],
        ["solver.isothermal", "false", "true"],
    ] {
        // The third point failed: it counts for neither.
        let mixed = format!(
            "film_central_m,moes_load,moes_material,speed_group,{title}\n1e-7,20,1,1e-12,{without}\n\
             9e-8,20,1,1e-12,{with}\n,,,,{with}\n2e-7,10,1,2e-12,{without}\n"
        );
        assert_eq!(read(&mixed), [expected], "{title}");
        let lines = |kind: &str| {
            let end = format!(",{kind}");
            let kept = mixed
                .lines()
                .filter(|line| line.ends_with(&end) || line.ends_with(title));
            kept.collect::<Vec<_>>().join("\n")
        };
        assert!(read(&lines(with)).is_empty() && read(&lines(without)).is_empty());
    }
}
