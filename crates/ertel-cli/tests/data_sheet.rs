//! An oil from its data sheet, end to end: the shipped case, its report, and the fluids of the database.

use std::path::Path;
use std::process::{Command, Output};

fn ertel(arguments: &[&str]) -> Output {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut command = Command::new(env!("CARGO_BIN_EXE_ertel"));
    command.args(arguments).current_dir(folder);
    command.output().unwrap()
}

fn report(arguments: &[&str]) -> String {
    let output = ertel(arguments);
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {message}");
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn the_shipped_case_is_solved_and_tells_its_estimates() {
    let folder = tempfile::tempdir().unwrap();
    let results = folder.path().join("results");
    let report = report(&[
        "solve",
        "cases/data-sheet-oil.toml",
        "--output",
        results.to_str().unwrap(),
    ]);
    for words in [
        "given by its data sheet: viscosity walther, density dowson-higginson",
        "22.93 1/GPa (estimate, ± 21 %)",
        "0.00058 1/K (estimate, ± 20 %)",
    ] {
        assert!(report.contains(words), "{words}: {report}");
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

#[test]
fn estimates_of_the_database_are_shown_as_such() {
    let shown = report(&["fluids", "show", "iso-vg-46-pao"]);
    for words in [
        "estimated",
        "estimate, ± 21 %",
        "Gold, P. W.",
        "viscosity_index",
    ] {
        assert!(shown.contains(words), "{words}: {shown}");
    }
    let list = report(&["fluids"]);
    assert!(list.lines().count() > 60, "{list}");
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
        let json = report(&["estimate", path.to_str().unwrap(), "--json"]);
        let json: serde_json::Value = serde_json::from_str(&json).unwrap();
        json["film"]["central"].as_f64().unwrap()
    };
    let one = "pressure_viscosity_coefficient_40 = \"22 1/GPa\"\n";
    let two = format!("{one}pressure_viscosity_coefficient_100 = \"13 1/GPa\"\n");
    let hot = "pressure_viscosity_coefficient_100 = \"13 1/GPa\"\n";
    assert_eq!(film(40, one), film(40, &two));
    let (by_two, by_hot, by_one) = (film(100, &two), film(100, hot), film(100, one));
    assert!((by_two / by_hot - 1.0).abs() < 1e-9, "{by_two} {by_hot}");
    // With one index the coefficient at 100 degC is 15.4 1/GPa; the film goes with α to the power of 0.4 to 0.5.
    let ratio = by_two / by_one;
    assert!((0.91..0.95).contains(&ratio), "{ratio}");
}
