//! `ertel estimate` end to end.

use std::path::{Path, PathBuf};
use std::process::Output;

use crate::common::{code, contains, ertel, stderr, stdout};

/// Runs `ertel estimate` in an empty folder, which must stay so.
fn estimate(case: &Path, options: &str) -> Output {
    let folder = tempfile::tempdir().unwrap();
    let output = ertel(&folder, &format!("estimate {} {options}", case.display()));
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
    let output = estimate(&shipped("ball-on-disc.toml"), "");
    code(&output, 0);
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
    let output = estimate(&shipped("ball-on-disc.toml"), "--json");
    code(&output, 0);
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
    let output = estimate(&path, "");
    code(&output, 0);
    for words in [
        "composite roughness σ (rms)",
        "mixed lubrication",
        "shear thinning is not in these formulas",
        "Wilson-Sheu",
    ] {
        contains(stdout(&output), words);
    }

    std::fs::write(&path, text.replace("[bodies]", "[bodies]\nroughness = 3")).unwrap();
    let output = estimate(&path, "");
    code(&output, 2);
    contains(stderr(&output), "`roughness` has no unit");
    assert_eq!(stdout(&output), "");
    let output = estimate(Path::new("no/such/case.toml"), "");
    code(&output, 2);
}

/// The template of a machine in a folder.
fn template(kind: &str) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("machine.toml");
    let output = ertel(&folder, &format!("init {kind} --output machine.toml"));
    code(&output, 0);
    (folder, path)
}

/// Figures and contacts of whole machines without a solve; tables fit into 80 columns, and the check has the main figures.
#[test]
fn whole_machines_are_estimated() {
    let machines: [(&str, &[&str], &[&str]); 3] = [
        (
            "bearing",
            &[
                "viscosity ratio κ                 1.639",
                "dynamic load rating C             19453 N",
                "friction torque of all contacts   needs a solve",
                "minimum Hamrock-Dowson 1977",
                "ball 0, inner ring",
                "ball 1, inner ring ×2",
                "torque, SKF model",
            ],
            &[
                "life factor a_ISO",
                "static safety C_0/P_0",
                "torque, Palmgren model",
            ],
        ),
        (
            "gear",
            &[
                "transverse contact ratio          1.635",
                "from the mean friction after Schlenk",
                "safety against scuffing S_B       give `scuffing_temperature`",
                "power lost in the mesh            needs a solve",
                "smallest specific film λ_GF",
                "minimum Dowson-Higginson 1977",
                "\n  B ",
                "\n  E ",
            ],
            &[
                "power lost after Ohlendorf and Schlenk",
                "largest flash temperature",
            ],
        ),
        (
            "cam",
            &[
                "entrainment reverses              at 50.41, 73.15, 86.85, 109.6 deg",
                "largest pressure angle",
                "mean friction torque              needs a solve",
                "64 deg",
            ],
            &["largest torque of the follower's force"],
        ),
    ];
    for (kind, words, of_check) in machines {
        let (folder, path) = template(kind);
        let output = estimate(&path, "");
        code(&output, 0);
        let text = stdout(&output);
        for words in words {
            assert!(text.contains(words), "{kind}: {words}: {text}");
        }
        let (_, table) = text.split_once("Contacts by formulas\n").unwrap();
        let (table, _) = table.split_once("\nMost loaded contact\n").unwrap();
        for line in table.lines() {
            assert!(line.chars().count() <= 80, "{kind}: {line}");
        }
        let check = ertel(&folder, "solve --check machine.toml");
        code(&check, 0);
        for words in of_check {
            assert!(
                stdout(&check).contains(words),
                "{kind}: {words}: {}",
                stdout(&check)
            );
        }

        std::fs::write(
            &path,
            std::fs::read_to_string(&path)
                .unwrap()
                .replace(" rpm\"", "\""),
        )
        .unwrap();
        let output = estimate(&path, "");
        assert_eq!(output.status.code(), Some(2), "{kind}");
        assert!(
            stderr(&output).contains("has no unit"),
            "{}",
            stderr(&output)
        );
        assert_eq!(stdout(&output), "");
    }
}

/// The document of a machine has the keys of `machine.json`, with the quantities of its contacts.
#[test]
fn json_of_whole_machines() {
    let document = |kind: &str| -> serde_json::Value {
        let (_folder, path) = template(kind);
        let output = estimate(&path, "--json");
        code(&output, 0);
        serde_json::from_str(stdout(&output)).unwrap()
    };
    let number = |json: &serde_json::Value, path: &str| {
        let found = json.pointer(path).and_then(serde_json::Value::as_f64);
        found.unwrap_or_else(|| panic!("{path}: {json:#}"))
    };
    let bearing = document("bearing");
    assert_eq!(bearing["figures"]["kappa"]["words"], "viscosity ratio κ");
    assert_eq!(bearing["not_estimated"]["friction_torque"], "needs a solve");
    // As the table of formulas has it for the most loaded contact.
    assert_eq!(bearing["governing_contact"], 1);
    let film = number(&bearing, "/contacts/0/film_central");
    assert_eq!(film, number(&bearing, "/film/film_central"));
    let angles = "/contact_figures/figures/contact_angle";
    assert_eq!(number(&bearing, &format!("{angles}/value/0")), 0.0);
    assert_eq!(bearing["contacts"].as_array().unwrap().len(), 18);
    assert_eq!(bearing.pointer(angles).unwrap()["unit"], "rad");
    assert_eq!(bearing["units"]["load"], "N");

    let gear = document("gear");
    let labels = gear["contact_figures"]["label"].as_array().unwrap();
    let pitch_point = labels.iter().position(|label| *label == "C").unwrap();
    for name in ["sliding_speed", "flash_temperature"] {
        let path = format!("/contact_figures/figures/{name}/value/{pitch_point}");
        assert_eq!(number(&gear, &path), 0.0);
    }
    assert_eq!(gear["units"]["load"], "N/m");

    let cam = document("cam");
    assert_eq!(cam["entrainment_reversals"].as_array().unwrap().len(), 4);
    assert_eq!(cam["units"]["entrainment_reversals"], "rad");
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
    let output = ertel(&folder, "solve rough.toml");
    code(&output, 0);
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
