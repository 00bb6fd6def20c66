//! An oil from its data sheet, end to end: the shipped case, its report, and the fluids of the database.

use std::path::Path;

use crate::common::{contains, ertel, root, stdout_of};

fn report(arguments: &str) -> String {
    stdout_of(ertel(root(), arguments), 0)
}

#[test]
fn the_shipped_case_is_solved_and_shows_its_estimates() {
    let folder = tempfile::tempdir().unwrap();
    let results = folder.path().join("results");
    let report = report(&format!(
        "solve cases/data-sheet-oil.toml --output {}",
        results.display()
    ));
    for words in [
        "given by its data sheet: viscosity walther, density dowson-higginson",
        "22.93 1/GPa (estimate, ± 21 %)",
        "0.00058 1/K (estimate, ± 20 %)",
    ] {
        contains(&report, words);
    }
    let json = std::fs::read_to_string(results.join("result.json")).unwrap();
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    let fluid = &json["case"]["si"]["fluid"];
    let estimates = fluid["estimates"].as_array().unwrap();
    let keys: Vec<&str> = estimates
        .iter()
        .map(|e| e["key"].as_str().unwrap())
        .collect();
    assert_eq!(keys, ["density.beta", "pressure_viscosity_coefficient"]);
    assert!(
        estimates[1]["source"]
            .as_str()
            .unwrap()
            .starts_with("gold2001")
    );
    // 46 mm²/s times 870 (1 - 5.8e-4 · 25) kg/m³.
    let viscosity = fluid["viscosity"].as_f64().unwrap();
    assert!(
        (viscosity / (46e-6 * 870.0 * 0.9855) - 1.0).abs() < 1e-9,
        "{viscosity}"
    );
}

/// The row of an oil's datum: its value, the unit, and whether it is an estimate.
fn datum<'a>(shown: &'a str, key: &str) -> Vec<&'a str> {
    let mut rows = shown.lines().map(|line| line.split_whitespace());
    let row = rows.find(|row| row.clone().next() == Some(key));
    let row = row.unwrap_or_else(|| panic!("no row {key}: {shown}"));
    row.skip(1).take(3).collect()
}

/// An oil of each kind: the correlation of Gold et al., 1.36 s ν^t · 10 1/GPa, with their constants and ν in mm²/s of the oil's source.
#[test]
fn estimates_of_the_database_are_shown_as_such() {
    for (oil, s, t, viscosity, range) in [
        ("iso-vg-46-mineral", 0.9904, 0.1390, 45.69, "± 21 %"),
        ("iso-vg-46-pao", 0.7382, 0.1335, 45.81, "± 21 %"),
        ("ester-iso-vg-320", 0.6605, 0.1360, 299.6, "± 21 %"),
        ("pag-iso-vg-320", 0.5489, 0.1485, 287.3, "± 30 %"),
    ] {
        let shown = report(&format!("fluids show {oil}"));
        let [value, unit, status] = datum(&shown, "pressure_viscosity_coefficient")[..] else {
            panic!("{shown}");
        };
        let value: f64 = value.parse().unwrap();
        let expected = 13.6 * s * f64::powf(viscosity, t);
        assert!(
            (value / expected - 1.0).abs() < 5e-4,
            "{oil}: {value}, by hand {expected}"
        );
        assert_eq!([unit, status], ["1/GPa", "estimated"], "{oil}");
        let note = format!("pressure_viscosity_coefficient: estimate, {range}:");
        assert!(shown.contains(&note), "{note} {shown}");
        contains(&shown, "Gold, P. W.");
    }
    // A value from a source is no estimate.
    let shown = report("fluids show fva-3");
    let given = datum(&shown, "pressure_viscosity_coefficient");
    assert_eq!(given, ["20", "1/GPa", "code"]);
    let shown = report("fluids show iso-vg-46-pao");
    let given = datum(&shown, "kinematic_viscosity_40");
    assert_eq!(given, ["45.81", "cSt", "code"]);
}

/// Estimates of heat and shear by the kind of an oil are shown apart from its data, with their ranges.
#[test]
fn estimates_by_kind_are_shown_apart() {
    let shown = report("fluids show iso-vg-46-pao");
    let (own, by_kind) = shown
        .split_once("Estimates by the kind of the base oil (PAO)")
        .unwrap_or_else(|| panic!("{shown}"));
    assert!(!own.contains("thermal_conductivity"), "{own}");
    for (key, value) in [
        (
            "thermal_conductivity.k_0",
            ["0.157", "W/(m.K)", "estimated"],
        ),
        (
            "heat_capacity.rho_c_0",
            ["1.725", "MJ/(m^3.K)", "estimated"],
        ),
        ("shear_thinning.tau_0", ["4", "MPa", "estimated"]),
    ] {
        assert_eq!(datum(by_kind, key), value);
    }
    contains(by_kind, "shear_thinning.limit.lambda: estimate, ± 30 %:");
    let shown = report("fluids show water");
    assert!(!shown.contains("kind of the base oil"), "{shown}");
}

/// Each file of the database has one line.
#[test]
fn every_fluid_is_listed() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../ertel-rheology/data/fluids");
    let files = std::fs::read_dir(folder).unwrap();
    let mut files: Vec<String> = files
        .map(|file| file.unwrap().path())
        .filter(|path| path.extension().is_some_and(|end| end == "toml"))
        .map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned())
        .collect();
    files.sort();
    let list = report("fluids");
    let lines = list.lines().filter(|line| line.starts_with("  "));
    let listed: Vec<&str> = (lines.filter_map(|line| line.split_whitespace().next())).collect();
    assert_eq!(listed, files);
}

/// A second coefficient, at 100 degC: the film there is that of an oil with this one alone, the film at 40 degC stays.
#[test]
fn a_second_coefficient_moves_the_film_of_its_temperature() {
    let folder = tempfile::tempdir().unwrap();
    let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/data-sheet-oil.toml");
    let case = std::fs::read_to_string(shipped).unwrap();
    let film = |celsius: u32, lines: &str| {
        let at = format!("temperature = \"{celsius} degC\"");
        let text = case.replace("temperature = \"40 degC\"", &at) + lines;
        let path = folder.path().join("case.toml");
        std::fs::write(&path, text).unwrap();
        let json = report(&format!("estimate {} --json", path.display()));
        let json: serde_json::Value = serde_json::from_str(&json).unwrap();
        json["film"]["film_central"].as_f64().unwrap()
    };
    let one = "pressure_viscosity_coefficient_40 = \"22 1/GPa\"\n";
    let two = format!("{one}pressure_viscosity_coefficient_100 = \"13 1/GPa\"\n");
    let hot = "pressure_viscosity_coefficient_100 = \"13 1/GPa\"\n";
    assert_eq!(film(40, one), film(40, &two));
    let (by_two, by_hot, by_one) = (film(100, &two), film(100, hot), film(100, one));
    assert!((by_two / by_hot - 1.0).abs() < 1e-9, "{by_two} {by_hot}");
    // With one index the coefficient at 100 degC is 15.4 1/GPa; the film is proportional to α to the power of 0.4 to 0.5.
    let ratio = by_two / by_one;
    assert!((0.91..0.95).contains(&ratio), "{ratio}");
}
