//! Mixed lubrication end to end: the shipped Stribeck case, a point contact with its tables, a study, and the commands of the guide.

use std::collections::HashMap;
use std::path::Path;

use serde_json::Value;
use tempfile::TempDir;

use crate::common::{
    code, contains, ertel, read, root, rows_of, stderr_of, stdout_of, text, write,
};

const ASPERITIES: &str = "[surface_roughness]
body_1_rms_height = \"120 nm\"
body_2_rms_height = \"160 nm\"
asperity_group = 0.06
rms_height_to_asperity_radius = 1e-2
boundary_friction_coefficient = 0.12
";

fn number(row: &HashMap<String, String>, column: &str) -> f64 {
    let field = row
        .get(column)
        .unwrap_or_else(|| panic!("no column {column}"));
    field
        .parse()
        .unwrap_or_else(|_| panic!("{column}: {field:?}"))
}

fn close(a: f64, b: f64, relative: f64) {
    assert!((a - b).abs() <= relative * b.abs(), "{a} is not {b}");
}

/// The shipped ball on a disc, sliding, with asperities, on a coarser mesh.
fn rough_ball() -> (TempDir, String) {
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(root().join("cases/ball-on-disc.toml")).unwrap();
    let sliding = text.replace("slide_to_roll_ratio = 0.0", "slide_to_roll_ratio = -0.2");
    assert_ne!(sliding, text);
    let text = sliding
        + "shear_thinning = { law = \"ree-eyring\", tau_0 = \"5 MPa\" }\n"
        + "\n[mesh]\ntarget_error = \"1 %\"\n"
        + ASPERITIES;
    write(&folder, "ball.toml", &text);
    (folder, text)
}

/// Results of the shipped case with wear: label, conserved volumes of both bodies, error bars of the steps, tables, and a contact that runs in.
fn assert_worn(folder: &Path, report: &str) {
    let label = "trend: Archard's law with an assumed coefficient";
    contains(report, label);
    let json = std::fs::read_to_string(folder.join("result.json")).unwrap();
    let json: Value = serde_json::from_str(&json).unwrap();
    let wear = &json["wear"];
    assert_eq!(wear["label"], label);
    let course = wear["course"].as_array().unwrap();
    assert_eq!(course.len() as u64 - 1, wear["steps"].as_u64().unwrap());
    let at = |row: &Value, key: &str| row[key].as_f64().unwrap();
    let worn: f64 = (course.windows(2))
        .map(|pair| {
            let distance = at(&pair[1], "sliding_distance") - at(&pair[0], "sliding_distance");
            1e-7 / 7e9 * 20e3 * at(&pair[0], "asperity_load_share") * distance
        })
        .sum();
    for body in [&wear["body_1"], &wear["body_2"]] {
        let volume = at(&body["volume"], "value");
        close(volume, worn, 1e-12);
        assert!(at(body, "volume_deviation").abs() < 1e-12);
        assert!(at(&body["volume"], "error") < 0.1 * volume);
    }
    assert!(wear["body_1"].get("length").is_none() && at(&wear["body_2"], "length") > 0.0);
    let (first, last) = (&course[0], course.last().unwrap());
    assert!(at(last, "film_central") > at(first, "film_central"));
    assert!(at(last, "pressure_maximum") < at(first, "pressure_maximum"));
    close(
        at(&json["figures"]["asperity_load_share"], "value"),
        at(last, "asperity_load_share"),
        1e-12,
    );
    let table = std::fs::read_to_string(folder.join("wear.csv")).unwrap();
    assert_eq!(table.lines().next(), Some(&*format!("# {label}")));
    assert_eq!(table.lines().count(), course.len() + 2);
    let depths = std::fs::read_to_string(folder.join("wear-depth.csv")).unwrap();
    contains(&depths, "\n2,along,");
    assert!(!depths.contains("\n1,") && folder.join("wear.svg").is_file());
}

/// Steps that run out end with exit code 3, how far the wear came and what to try, and write nothing.
#[test]
fn wear_that_ends_on_the_way() {
    let folder = tempfile::tempdir().unwrap();
    let case = root().join("cases/wear.toml");
    let case = case.to_str().unwrap();
    let output = ertel(
        &folder,
        &format!("solve {case} --set wear.max_steps=1 --output worn"),
    );
    let message = stderr_of(output, 3);
    for words in [
        "the wear ends at a sliding distance of",
        "of 200 m, after 1 step:",
        "max_steps",
        "nothing was written",
    ] {
        contains(&message, words);
    }
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
}

/// The commands of the guide, run by the built program; the picture, the table and its sums.
#[test]
fn commands_of_the_guide_give_a_stribeck_curve() {
    let page = std::fs::read_to_string(root().join("docs/guide/mixed-lubrication.md")).unwrap();
    let commands = page
        .lines()
        .filter_map(|l| l.strip_prefix("    cargo run --release -- "));
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("cases")).unwrap();
    for case in ["cases/stribeck.toml", "cases/wear.toml"] {
        std::fs::copy(root().join(case), folder.path().join(case)).unwrap();
    }
    let mut outputs = Vec::new();
    for command in commands {
        let output = ertel(&folder, command);
        assert_eq!(
            output.status.code(),
            Some(0),
            "{command}: {}",
            text(&output.stderr)
        );
        outputs.push(text(&output.stdout).to_owned());
    }
    let [estimate, solved, worn] = &outputs[..] else {
        panic!("{} commands", outputs.len());
    };
    assert_worn(&folder.path().join("results/wear"), worn);
    for words in [
        "σβη 0.06, σ/β 0.01, boundary friction 0.12",
        "lambda ratio",
        "asperity load",
        "Greenwood and Tripp",
    ] {
        contains(estimate, words);
    }
    for words in [
        "lambda ratio",
        "load on asperities",
        "total friction coefficient",
    ] {
        contains(solved, words);
    }
    assert!(!solved.contains("smooth surfaces"), "{solved}");
    let rows = rows_of(&folder.path().join("results/stribeck/curve.csv"));
    assert_eq!(rows.len(), 15);
    let sigma = 0.25e-6;
    for row in &rows {
        close(
            number(row, "lambda_minimum"),
            number(row, "film_minimum_m") / sigma,
            1e-12,
        );
        let share = number(row, "asperity_load_share");
        close(share, number(row, "asperity_load_N_per_m") / 20e3, 1e-12);
        let (fluid, asperities) = (
            number(row, "friction_fluid"),
            number(row, "friction_asperities"),
        );
        close(fluid, number(row, "traction_coefficient"), 1e-12);
        close(asperities, 0.12 * share, 1e-9);
        close(number(row, "friction_total"), fluid + asperities, 1e-12);
    }
    // From the film to the asperities as the speed falls: share and friction of asperities rise, the total has its minimum in between.
    let total: Vec<f64> = rows.iter().map(|r| number(r, "friction_total")).collect();
    let share: Vec<f64> = rows
        .iter()
        .map(|r| number(r, "asperity_load_share"))
        .collect();
    assert!(share.windows(2).all(|w| w[1] > w[0]), "{share:?}");
    assert!(share[0] < 1e-3 && share[14] > 0.9, "{share:?}");
    let least = (0..15)
        .min_by(|a, b| total[*a].total_cmp(&total[*b]))
        .unwrap();
    assert!((1..14).contains(&least), "{total:?}");
    assert!(total[14] > 1.3 * total[least], "{total:?}");
    let picture = folder.path().join("results/stribeck/stribeck.svg");
    let picture = std::fs::read_to_string(picture).unwrap();
    for words in [
        "film and asperities",
        "Oil and asperities share the load",
        "Friction coefficient",
    ] {
        contains(&picture, words);
    }
    // The folder is known as a result, with the picture, and may be written again.
    let again = ertel(&folder, "solve cases/stribeck.toml");
    code(&again, 0);
}

/// A point contact: `mixed` of result.json and the report; far smoother surfaces carry nothing on asperities.
#[test]
fn result_of_a_rough_ball() {
    let (folder, given) = rough_ball();
    let report = stdout_of(ertel(&folder, "solve ball.toml"), 0);
    let json = |name: &str| -> Value {
        let path = folder.path().join("results").join(name).join("result.json");
        serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
    };
    let result = json("ball");
    let mixed = &result["mixed"];
    let value = |v: &Value| v["value"].as_f64().unwrap();
    let minimum = value(&result["summary"]["film_minimum"]);
    close(value(&mixed["lambda_minimum"]), minimum / 0.2e-6, 1e-12);
    assert_eq!(mixed["separation"], "mixed");
    let asperities = &mixed["asperities"];
    let share = value(&asperities["asperity_load_share"]);
    assert!(0.0 < share && share < 1.0, "{share}");
    assert!(asperities["asperity_load_share"]["error"].as_f64().unwrap() > 0.0);
    // The plane is the faster surface: friction has the sign of the traction.
    let friction = &asperities["friction"];
    close(value(&friction["friction_asperities"]), -0.12 * share, 1e-6);
    assert!(value(&friction["friction_fluid"]) < 0.0);
    assert_eq!(result["units"]["asperity_pressure_maximum"], "Pa");
    for words in [
        "asperity load",
        "total friction coefficient",
        "mixed lubrication",
    ] {
        contains(&report, words);
    }
    // The film of far smoother surfaces bears all.
    let smooth = given.replace("120 nm", "2 nm").replace("160 nm", "1 nm");
    write(&folder, "smooth.toml", smooth);
    let output = ertel(&folder, "solve smooth.toml");
    code(&output, 0);
    let smooth = json("smooth");
    let share = value(&smooth["mixed"]["asperities"]["asperity_load_share"]);
    assert!(share < 1e-12, "{share}");
    let total = value(&smooth["mixed"]["asperities"]["friction"]["friction_total"]);
    close(
        total,
        value(&smooth["figures"]["traction_coefficient"]),
        1e-9,
    );
    assert_eq!(smooth["mixed"]["separation"], "full");
}

/// Where no method shares the load between oil and asperities they are refused, with their line and the choice.
#[test]
fn asperities_are_not_left_out_silently() {
    let (folder, given) = rough_ball();
    for (keys, words) in [
        (
            "[solver]\nmethod = \"finite-elements\"\n",
            "finite-elements\", which knows no asperities",
        ),
        (
            "[solver]\nelasticity = \"equivalent\"\n",
            "finite-element bodies",
        ),
    ] {
        write(&folder, "ball.toml", given.clone() + keys);
        let message = stderr_of(ertel(&folder, "solve ball.toml --check"), 2);
        for words in ["asperity_group", "cannot share the load", words] {
            contains(&message, words);
        }
    }
}

/// The shipped cylinder at one speed, with other keys of the asperities.
fn cylinder(folder: &TempDir, name: &str, keys: &str) -> Value {
    let text = std::fs::read_to_string(root().join("cases/stribeck.toml")).unwrap();
    let (text, _) = text.split_once("[curve]").unwrap();
    let (before, rest) = text.split_once("asperity_group").unwrap();
    let (_, after) = rest.split_once("\n\n").unwrap();
    let text = format!("{before}{keys}\nboundary_friction_coefficient = 0.12\n\n{after}");
    let text = text.replace(
        "entrainment_speed = \"0.5 m/s\"",
        "entrainment_speed = \"0.25 m/s\"",
    );
    solved_as(folder, name, &text)
}

/// result.json of a case.
fn solved_as(folder: &TempDir, name: &str, case: &str) -> Value {
    std::fs::write(folder.path().join(format!("{name}.toml")), case).unwrap();
    let arguments = format!("solve {name}.toml");
    code(&ertel(folder, &arguments), 0);
    let path = folder.path().join("results").join(name).join("result.json");
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

/// Without the key `flow` results contain those of the other gap: what a solve with it finds.
#[test]
fn range_of_both_gaps() {
    let folder = tempfile::tempdir().unwrap();
    let law = "asperity_group = 0.06\nrms_height_to_asperity_radius = 1e-2\n";
    let both = cylinder(&folder, "both", law);
    let other = &both["mixed"]["asperities"]["other_gap"];
    let alone = cylinder(&folder, "alone", &format!("{law}flow = \"distance\"\n"));
    let asperities = &alone["mixed"]["asperities"];
    assert!(asperities["other_gap"].is_null());
    let value = |v: &Value| v["value"].as_f64().unwrap();
    let share = value(&asperities["asperity_load_share"]);
    close(other["asperity_load_share"].as_f64().unwrap(), share, 1e-3);
    let own = value(&both["mixed"]["asperities"]["asperity_load_share"]);
    assert!(own > share + 0.05, "{own} {share}");
    for film in ["film_central", "film_minimum"] {
        let alone = value(&alone["summary"][film]);
        close(other[film].as_f64().unwrap(), alone, 1e-3);
    }
    let report = read(&folder, "results/both/report.txt");
    contains(&report, "with the other gap");
}

/// A table of the pressures of Greenwood and Tripp gives what the law does; summits on one surface alone, a hardness and flow factors give something else.
#[test]
fn laws_of_asperities() {
    let folder = tempfile::tempdir().unwrap();
    let summits = "asperity_group = 0.06\nrms_height_to_asperity_radius = 1e-2\n";
    // 16√2π/15 · 0.06² · 0.1 · 115.385 GPa · F_{5/2}(h/0.25 µm) by a sum.
    let table = "asperity_law = \"table\"\nasperity_distances = [\"-375.0 nm\", \"-250.0 nm\", \"-125.0 nm\", \"0.0 nm\", \"125.0 nm\", \"250.0 nm\", \"375.0 nm\", \"500.0 nm\", \"625.0 nm\", \"750.0 nm\", \"875.0 nm\", \"1000.0 nm\", \"1125.0 nm\", \"1250.0 nm\"]\nasperity_pressures = [\"9.78775e+08 Pa\", \"5.42431e+08 Pa\", \"2.72097e+08 Pa\", \"1.21387e+08 Pa\", \"4.7324e+07 Pa\", \"1.5859e+07 Pa\", \"4.50068e+06 Pa\", \"1.06768e+06 Pa\", \"209391 Pa\", \"33637 Pa\", \"4392.28 Pa\", \"463.272 Pa\", \"39.2642 Pa\", \"2.66263 Pa\"]\n";
    let share = |name: &str, keys: &str| {
        let result = cylinder(&folder, name, &format!("{keys}flow = \"average-gap\"\n"));
        let share = &result["mixed"]["asperities"]["asperity_load_share"]["value"];
        share.as_f64().unwrap()
    };
    let own = share("tripp", summits);
    close(share("table", table), own, 0.01);
    let one = format!("asperity_law = \"greenwood-williamson\"\n{summits}");
    let soft = share("soft", &format!("{one}hardness = \"200 MPa\"\n"));
    let one = share("williamson", &one);
    assert!((one / own - 1.0).abs() > 0.02, "{one} {own}");
    assert!(soft < 0.9 * one, "{soft} {one}");
    // 0.02 · 115.385 GPa · e^(−h/0.1 µm): two rows of a table, which is exponential between them.
    let random = "asperity_law = \"persson\"\nrms_slope = 0.1\ndecay_length_to_rms_height = 0.4\npressure_factor = 0.02\n";
    let rows = "asperity_law = \"table\"\nasperity_distances = [\"0 nm\", \"1000 nm\"]\nasperity_pressures = [\"2.307692308e9 Pa\", \"104769.069 Pa\"]\n";
    close(share("persson", random), share("rows", rows), 1e-4);
    let factors = format!("{summits}flow = \"patir-cheng\"\norientation = \"1/9\"\n");
    let factors = cylinder(&folder, "factors", &factors);
    let factors = &factors["mixed"]["asperities"]["asperity_load_share"]["value"];
    assert!(factors.as_f64().unwrap() < 0.95 * own, "{factors} {own}");
}

/// Flanks that asperities touch lose more than smooth ones, and every contact has the load of its asperities.
#[test]
fn gears_with_rough_flanks() {
    let folder = tempfile::tempdir().unwrap();
    let given = std::fs::read_to_string(root().join("cases/machine/fzg-c.toml")).unwrap();
    let given = given.replace("points = 30", "points = 4");
    let rough = "\n[surface_roughness]\nbody_1_rms_height = \"0.5 um\"\nbody_2_rms_height = \"0.5 um\"\nasperity_group = 0.05\n\
                 rms_height_to_asperity_radius = 5e-3\nboundary_friction_coefficient = 0.12\nflow = \"average-gap\"\n";
    let solved = |name: &str, case: String| -> Value {
        std::fs::write(folder.path().join(format!("{name}.toml")), case).unwrap();
        let output = ertel(&folder, &format!("solve {name}.toml"));
        code(&output, 0);
        let path = folder
            .path()
            .join("results")
            .join(name)
            .join("machine.json");
        serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
    };
    let smooth = solved("smooth", given.clone());
    let rough = solved("rough", given + rough);
    let loss = |of: &Value| of["figures"]["friction_power"]["value"].as_f64().unwrap();
    assert!(loss(&rough) > 1.1 * loss(&smooth));
    let contacts = rough["contacts"].as_array().unwrap();
    for contact in contacts {
        let share = &contact["solution"]["figures"]["asperity_load_share"]["value"];
        let share = share.as_f64().unwrap();
        assert!(0.05 < share && share < 0.5, "{share}");
    }
    let largest = &rough["figures"]["asperity_load_share_maximum"]["value"];
    assert!(largest.as_f64().unwrap() < 0.5);
}

/// A study has the columns, too, and any key of the section may vary.
#[test]
fn study_of_roughness() {
    let (folder, _) = rough_ball();
    let study = "title = \"Roughness\"\ncase = \"ball.toml\"\n[[axis]]\nkey = \"surface_roughness.asperity_group\"\nvalues = [0.03, 0.06]\n";
    write(&folder, "study.toml", study);
    let output = ertel(&folder, "sweep study.toml");
    code(&output, 0);
    let rows = rows_of(&folder.path().join("results/study/results.csv"));
    let share = |i: usize| number(&rows[i], "asperity_load_share");
    // p_a is as the square of σβη at one and the same film, but stiffer asperities lift the surfaces.
    let ratio = share(1) / share(0);
    assert!((1.5..4.0).contains(&ratio), "{ratio}");
    for column in ["lambda_minimum", "lambda_central", "friction_total"] {
        number(&rows[0], column);
    }
}

/// Gears, bearings and cams whose film is 0.7 of their roughness run in mixed lubrication, not boundary (Zhu and Wang 2012).
#[test]
fn machines_at_lambda_0_7_are_mixed() {
    let folder = tempfile::tempdir().unwrap();
    let mut n_machines = 0;
    for entry in std::fs::read_dir(root().join("cases/machine")).unwrap() {
        let path = entry.unwrap().path();
        let given = std::fs::read_to_string(&path).unwrap();
        if given.contains("[surface_roughness]") {
            continue; // It has its own roughness.
        }
        let estimate = |file: &Path| -> Value {
            let output = ertel(
                folder.path(),
                &format!("estimate --json {}", file.display()),
            );
            code(&output, 0);
            serde_json::from_str(text(&output.stdout)).unwrap()
        };
        let film = &estimate(&path)["film"];
        let film = film["film_minimum"]
            .as_f64()
            .or(film["film_central"].as_f64());
        let each = film.unwrap() / 0.7 / 2f64.sqrt() * 1e6;
        let rough = folder.path().join(path.file_name().unwrap());
        let section = format!(
            "\n[surface_roughness]\nbody_1_rms_height = \"{each} um\"\nbody_2_rms_height = \"{each} um\"\n"
        );
        std::fs::write(&rough, given + &section).unwrap();
        let lambda = &estimate(&rough)["lambda"];
        let ratio = lambda["lambda_minimum"]
            .as_f64()
            .or(lambda["lambda_central"].as_f64());
        close(ratio.unwrap(), 0.7, 1e-9);
        assert_eq!(lambda["separation"], "mixed", "{}", path.display());
        n_machines += 1;
    }
    assert!(n_machines >= 6);
}
