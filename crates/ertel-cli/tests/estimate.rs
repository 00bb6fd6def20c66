//! `ertel estimate` end to end.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use crate::common::{contains, stderr, stdout};

/// Runs `ertel estimate` in an empty folder, which must stay so.
fn estimate(case: &Path, options: &[&str]) -> Output {
    let folder = tempfile::tempdir().unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_ertel"))
        .arg("estimate")
        .arg(case)
        .args(options)
        .current_dir(folder.path())
        .output()
        .unwrap();
    assert!(folder.path().read_dir().unwrap().next().is_none());
    output
}

fn shipped(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../cases")
        .join(name)
}

/// Figures of an independent script for the case (Habchi 2008, Tables 3.3 and 3.4).
#[test]
fn text_has_the_figures() {
    let output = estimate(&shipped("ball-on-disc.toml"), &[]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    for words in [
        "218.3 µm",
        "1.002 GPa",
        "M 199.3   L 10.36",
        "264.1 nm",
        "148.6 nm",
        "243.9 nm",
        "piezoviscous-rigid, close to piezoviscous-elastic",
        "0.00424",
        "inertia is negligible",
    ] {
        contains(stdout(&output), words);
    }
    assert_eq!(stderr(&output), "");
}

#[test]
fn json_has_the_figures_with_units() {
    let output = estimate(&shipped("ball-on-disc.toml"), &["--json"]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let json: serde_json::Value = serde_json::from_str(stdout(&output)).unwrap();
    assert_eq!(json["format"], "ertel-estimate");
    let near = |path: &str, value: f64| {
        let found = json.pointer(path).and_then(serde_json::Value::as_f64);
        let found = found.unwrap_or_else(|| panic!("{path}: {json:#}"));
        assert!((found / value - 1.0).abs() < 2e-5, "{path}: {found}");
    };
    near("/hertz/half_width", 218.279e-6);
    near("/groups/moes_load", 199.26);
    near("/formulas/0/film_central", 264.066e-9);
    near("/formulas/0/film_minimum", 148.596e-9);
    // 298.135 nm of an incompressible oil over 1 + 0.6 p/(1 + 1.7 p) at p = 1.00212 GPa.
    near("/film/film_central", 243.894e-9);
    assert_eq!(json["regime"]["regime"], "piezoviscous-rigid");
    assert_eq!(json["units"]["film_central"], "m");
    assert_eq!(json["reynolds"]["inertia_matters"], false);
}

/// Words about roughness and shear thinning; bad input has code 2.
#[test]
fn warnings_and_errors() {
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(shipped("squalane-on-glass.toml")).unwrap();
    let path = folder.path().join("rough.toml");
    let rough = text.replace("[bodies]", "[bodies]\nroughness = \"1 um\"");
    std::fs::write(&path, rough).unwrap();
    let output = estimate(&path, &[]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    for words in [
        "composite roughness σ (rms)",
        "mixed lubrication",
        "shear thinning is not in these formulas",
        "Wilson-Sheu",
    ] {
        contains(stdout(&output), words);
    }

    std::fs::write(&path, text.replace("[bodies]", "[bodies]\nroughness = 3")).unwrap();
    let output = estimate(&path, &[]);
    assert_eq!(output.status.code(), Some(2));
    contains(stderr(&output), "`roughness` has no unit");
    assert_eq!(stdout(&output), "");
    let output = estimate(Path::new("no/such/case.toml"), &[]);
    assert_eq!(output.status.code(), Some(2));
}

/// A computed film is set against the roughness, too: some 200 nm here.
#[test]
fn solve_shows_the_lambda_ratio() {
    let folder = tempfile::tempdir().unwrap();
    let quick = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/good/quick.toml");
    let text = std::fs::read_to_string(quick).unwrap();
    let path = folder.path().join("rough.toml");
    let rough = text.replace("[bodies]", "[bodies]\nroughness = \"1 um\"");
    std::fs::write(&path, rough).unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_ertel"))
        .arg("solve")
        .arg(&path)
        .current_dir(folder.path())
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let result = folder.path().join("results/rough/result.json");
    let json: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(result).unwrap()).unwrap();
    let film = json["summary"]["film_minimum"]["value"].as_f64().unwrap();
    let lambda = format!("{:.2} times the roughness: mixed", film / 1e-6);
    for words in [lambda.as_str(), "lambda ratio h_min/σ"] {
        contains(stdout(&output), words);
    }
    assert_eq!(json["case"]["si"]["roughness"], 1e-6);
}
