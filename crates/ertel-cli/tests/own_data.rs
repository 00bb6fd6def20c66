//! Lubricants and materials of the user, in separate files.

use std::path::Path;

use serde_json::Value;

use crate::common::{Workspace, command, contains, stderr_of, text, write};

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

fn central_film(w: &Workspace, name: &str) -> f64 {
    w.succeed(&format!("solve {name} -q -o result"));
    w.json("result/result.json")["summary"]["film_central"]["value"]
        .as_f64()
        .unwrap()
}

/// The same films, to the bit, as with the same laws in the case; the tables of a file are next to it, wherever the case is.
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
    let own = central_film(&w, "own.toml");
    assert_eq!(own, central_film(&w, "written.toml"));
    assert!(central_film(&w, "tabled.toml") > 0.0);
    // A change in the file changes the film: 2^0.7, about.
    write(&w.0, "data/oil.toml", OIL.replace("40 mPa.s", "80 mPa.s"));
    let ratio = central_film(&w, "own.toml") / own;
    assert!((1.5..1.8).contains(&ratio), "{ratio}");
    // The report and `fluids` say where it comes from.
    contains(&w.succeed("solve own.toml -o result"), "data/oil.toml");
    contains(
        &w.succeed("fluids show data/oil.toml --temperature '40 degC'"),
        "80 mPa.s",
    );
    contains(&w.succeed("solids show data/metal.toml"), "200 GPa");
}

/// The entry of `ertel fit` is a lubricant except for its density, which the case gives.
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
    let data = data.display();
    w.succeed(&format!("fit viscosity {data} --law cheng -o my-oil.toml"));
    w.succeed("solve --check case.toml");
    w.succeed("fluids show my-oil.toml");
}

/// Errors point to their origin: the case, or the file.
#[test]
fn errors_name_the_file() {
    let w = Workspace::new(&[
        ("own.toml", &case("lubricant = \"oil.toml\"", "\"steel\"")),
        (
            "body.toml",
            &case("lubricant = \"glycerol\"", "\"metal.toml\""),
        ),
    ]);
    let missing = w.refused("solve own.toml");
    contains(&missing, "oil.toml cannot be read");
    contains(&missing, "own.toml:2:");
    write(&w.0, "oil.toml", format!("{OIL}viscocity = 3\n"));
    let unknown = w.refused("solve own.toml");
    contains(&unknown, "oil.toml:4:1");
    contains(&unknown, "`viscosity`");
    write(&w.0, "oil.toml", OIL.replace("40 mPa.s", "-40 mPa.s"));
    contains(&w.refused("fluids show oil.toml"), "oil.toml:3:");
    write(&w.0, "metal.toml", "youngs_modulus = \"200 GPa\"\n");
    let body = w.refused("solve body.toml");
    contains(&body, "metal.toml");
    contains(&body, "poissons_ratio");
}

/// A name stands for a file of the folder of own data in cases, studies, lists and fits; where the database has it, too, the file
/// counts, and a note says so.
#[test]
fn names_of_own_data_are_added_to_those_of_the_database() {
    let tait = "viscosity = { law = \"constant\", mu_0 = \"10 mPa.s\" }\n[density]\nlaw = \"tait\"\nrho_0 = \"870 kg/m^3\"\n\
        reference_temperature = \"20 degC\"\nk_0r = \"9 GPa\"\nk_0r_prime = 10.5\nbeta_k = \"6.5e-3 1/K\"\nbeta_k_prime = \"0 1/K\"\na_v = \"7.7e-4 1/K\"\n";
    let w = Workspace::new(&[
        ("data/fluids/works-oil.toml", OIL),
        (
            "data/fluids/glycerol.toml",
            &OIL.replace("40 mPa.s", "80 mPa.s"),
        ),
        ("data/fluids/volume.toml", tait),
        ("data/solids/works-metal.toml", METAL),
        (
            "named.toml",
            &case("lubricant = \"works-oil\"", "\"works-metal\""),
        ),
        (
            "path.toml",
            &case(
                "lubricant = \"data/fluids/works-oil.toml\"",
                "\"data/solids/works-metal.toml\"",
            ),
        ),
        (
            "shadow.toml",
            &case("lubricant = \"glycerol\"", "\"steel\""),
        ),
        (
            "shipped.toml",
            &case("lubricant = \"squalane-pip\"", "\"steel\""),
        ),
        (
            "study.toml",
            "case = \"named.toml\"\n[[axis]]\nkey = \"lubricant\"\nvalues = [\"works-oil\", \"thesis-roelands-oil\"]\n",
        ),
    ]);
    // Without the folder the names are unknown; with it, films are those of the files, to the bit.
    let unknown = w.refused("solve named.toml");
    contains(&unknown, "works-");
    let by_path = central_film(&w, "path.toml");
    w.succeed("solve named.toml -q -o result --data data");
    let film = |w: &Workspace| {
        let read = std::fs::read_to_string(w.path("result/result.json")).unwrap();
        let result: Value = serde_json::from_str(&read).unwrap();
        result["summary"]["film_central"]["value"].as_f64().unwrap()
    };
    assert_eq!(film(&w), by_path);
    // The variable does what the option does.
    let with_variable = |arguments: &str| {
        command(&w.0, arguments)
            .env("ERTEL_DATA", "data")
            .output()
            .unwrap()
    };
    for arguments in ["sweep study.toml --dry-run", "solve --check shipped.toml"] {
        let error = stderr_of(with_variable(arguments), 0);
        contains(&error, "note: the fluid `glycerol` is that of data");
    }
    let list = with_variable("fluids");
    contains(text(&list.stdout), "works-oil");
    contains(text(&list.stdout), "squalane-pip");
    assert_eq!(text(&list.stdout).matches("\n  glycerol ").count(), 1);
    contains(text(&with_variable("solids").stdout), "works-metal");
    contains(
        text(&with_variable("fluids show glycerol -t '40 degC'").stdout),
        "80 mPa.s",
    );
    contains(&w.succeed("solids show works-metal --data data"), "200 GPa");
    // The volume of Doolittle's law.
    let measured =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation/appendix-c/fluid-a.csv");
    let measured = measured.display();
    let fit = format!("fit viscosity {measured} --law doolittle --density volume");
    assert!(w.refused(&fit).contains("volume"));
    contains(
        &w.succeed(&format!("{fit} --data data")),
        "equation_of_state",
    );
    // A result never takes the place of what was read.
    let over = w.refused("solve named.toml --data data -o data");
    contains(&over, "will not replace the folder data");
}

#[test]
fn a_folder_that_is_none_is_refused() {
    let w = Workspace::new(&[
        ("file", ""),
        ("empty/x.toml", OIL),
        ("data/fluids/bad.toml", "viscosity = 3\n"),
    ]);
    for (folder, words) in [
        ("nothing", "is not a readable folder"),
        ("file", "is not a readable folder"),
        ("empty", "neither a folder `fluids` nor `solids`"),
    ] {
        let message = w.refused(&format!("fluids --data {folder}"));
        contains(&message, words);
        contains(&message, folder);
    }
    contains(&w.refused("fluids --data data"), "bad.toml:1:");
    let near = w.refused("fluids show badd --data data");
    contains(&near, "did you mean `bad`");
}
