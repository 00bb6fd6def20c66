//! Lubricants and materials of the user, in files of their own.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;

const OIL: &str = r#"
density = { law = "dowson-higginson", rho_0 = "870 kg/m^3" }
viscosity = { law = "roelands", mu_0 = "40 mPa.s", alpha = "20 1/GPa", beta = "0.04 1/K", reference_temperature = "40 degC" }
"#;

const METAL: &str = "youngs_modulus = \"200 GPa\"\npoissons_ratio = 0.3\n";

const CASE: &str = r#"
LUBRICANT
temperature = "60 degC"
[contact]
kind = "line"
radius = "10 mm"
load = "50 kN/m"
[bodies]
body_1 = "steel"
body_2 = BODY
[motion]
entrainment_speed = "2 m/s"
slide_to_roll_ratio = 0
[mesh]
target_error = "3 %"
"#;

fn case(lubricant: &str, body: &str) -> String {
    CASE.replace("LUBRICANT", lubricant).replace("BODY", body)
}

struct Workspace(tempfile::TempDir);

impl Workspace {
    fn new(files: &[(&str, &str)]) -> Workspace {
        let workspace = Workspace(tempfile::tempdir().unwrap());
        for (name, text) in files {
            workspace.write(name, text);
        }
        workspace
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn write(&self, name: &str, text: &str) {
        let path = self.path(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
    }

    fn ertel(&self, arguments: &[&str]) -> Output {
        Command::new(env!("CARGO_BIN_EXE_ertel"))
            .current_dir(self.0.path())
            .args(arguments)
            .output()
            .unwrap()
    }

    fn done(&self, arguments: &[&str]) -> String {
        let output = self.ertel(arguments);
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        text(&output.stdout).to_owned()
    }

    /// What bad input is answered with.
    fn refused(&self, arguments: &[&str]) -> String {
        let output = self.ertel(arguments);
        assert_eq!(output.status.code(), Some(2), "{}", text(&output.stderr));
        text(&output.stderr).to_owned()
    }

    fn central_film(&self, name: &str) -> f64 {
        self.done(&["solve", name, "-q", "-o", "result"]);
        let read = std::fs::read_to_string(self.path("result/result.json")).unwrap();
        let result: Value = serde_json::from_str(&read).unwrap();
        result["summary"]["film_central"]["value"].as_f64().unwrap()
    }
}

fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).unwrap()
}

/// The same films, to the bit, as with the same laws in the case; the tables of a file lie beside it, wherever the case lies.
#[test]
fn a_file_stands_for_what_is_in_it() {
    let oil = OIL.trim().replace('\n', ", ");
    let table = "temperature_degC,pressure_MPa,density_kg_per_m3\n40,0,870\n80,0,850\n40,2000,1000\n80,2000,980\n";
    let tabled = OIL.replace(
        "{ law = \"dowson-higginson\", rho_0 = \"870 kg/m^3\" }",
        "{ law = \"table\", file = \"density.csv\" }",
    );
    let w = Workspace::new(&[
        ("data/oil.toml", OIL),
        ("data/tabled.toml", &tabled),
        ("data/density.csv", table),
        ("data/metal.toml", METAL),
        (
            "own.toml",
            &case("lubricant = \"data/oil.toml\"", "\"data/metal.toml\""),
        ),
        (
            "written.toml",
            &case(
                &format!("lubricant = {{ temperature = \"60 degC\", {oil} }}"),
                "{ youngs_modulus = \"200 GPa\", poissons_ratio = 0.3 }",
            )
            .replacen("temperature = \"60 degC\"\n", "\n", 1),
        ),
        (
            "tabled.toml",
            &case("lubricant = \"data/tabled.toml\"", "\"steel\""),
        ),
    ]);
    let own = w.central_film("own.toml");
    assert_eq!(own, w.central_film("written.toml"));
    assert!(w.central_film("tabled.toml") > 0.0);
    // What changes in the file changes the film: 2^0.7, about.
    w.write("data/oil.toml", &OIL.replace("40 mPa.s", "80 mPa.s"));
    let ratio = w.central_film("own.toml") / own;
    assert!((1.5..1.8).contains(&ratio), "{ratio}");
    // The report and `fluids` say where it comes from.
    assert!(
        w.done(&["solve", "own.toml", "-o", "result"])
            .contains("data/oil.toml")
    );
    assert!(
        w.done(&[
            "fluids",
            "show",
            "data/oil.toml",
            "--temperature",
            "40 degC"
        ])
        .contains("80 mPa.s")
    );
    assert!(
        w.done(&["solids", "show", "data/metal.toml"])
            .contains("200 GPa")
    );
}

/// What `ertel fit` writes is a lubricant but for its density, which the case gives.
#[test]
fn a_fit_is_a_lubricant() {
    let data =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation/appendix-c/fluid-a.csv");
    let w = Workspace::new(&[(
        "case.toml",
        &case(
            "",
            "\"steel\"\n[lubricant]\nname = \"my-oil.toml\"\ntemperature = \"20 degC\"\n\
             density = { law = \"dowson-higginson\", rho_0 = \"870 kg/m^3\" }",
        )
        .replacen("temperature = \"60 degC\"\n", "\n", 1),
    )]);
    let data = data.to_str().unwrap();
    w.done(&[
        "fit",
        "viscosity",
        data,
        "--law",
        "cheng",
        "-o",
        "my-oil.toml",
    ]);
    w.done(&["solve", "--check", "case.toml"]);
    w.done(&["fluids", "show", "my-oil.toml"]);
}

/// Errors stand where they are made: in the case, or in the file.
#[test]
fn errors_name_the_file() {
    let w = Workspace::new(&[
        ("own.toml", &case("lubricant = \"oil.toml\"", "\"steel\"")),
        (
            "body.toml",
            &case("lubricant = \"glycerol\"", "\"metal.toml\""),
        ),
    ]);
    let missing = w.refused(&["solve", "own.toml"]);
    assert!(missing.contains("oil.toml cannot be read"), "{missing}");
    assert!(missing.contains("own.toml:2:"), "{missing}");
    w.write("oil.toml", &format!("{OIL}viscocity = 3\n"));
    let unknown = w.refused(&["solve", "own.toml"]);
    assert!(unknown.contains("oil.toml:4:1"), "{unknown}");
    assert!(unknown.contains("`viscosity`"), "{unknown}");
    w.write("oil.toml", &OIL.replace("40 mPa.s", "-40 mPa.s"));
    assert!(
        w.refused(&["fluids", "show", "oil.toml"])
            .contains("oil.toml:3:")
    );
    w.write("metal.toml", "youngs_modulus = \"200 GPa\"\n");
    let body = w.refused(&["solve", "body.toml"]);
    assert!(
        body.contains("metal.toml") && body.contains("poissons_ratio"),
        "{body}"
    );
}
