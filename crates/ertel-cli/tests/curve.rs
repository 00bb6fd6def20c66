//! `ertel solve` of a case with a `[curve]`, end to end.

use std::collections::HashMap;
use std::path::Path;

use tempfile::TempDir;

use crate::common::{
    Running, code, command, contains, ertel, read, rows_of, solve, stderr_of, text, write,
};

const SPEEDS: &str = r#"
[curve]
quantity = "motion.entrainment_speed"
values = ["1 m/s", "1.3 m/s", "900 mm/s"]
"#;

/// A folder with `tests/good/quick.toml`, changed, and a curve.
fn workspace(change: impl Fn(&str) -> String, curve: &str) -> TempDir {
    let good = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/good/quick.toml");
    let folder = tempfile::tempdir().unwrap();
    let text = change(&std::fs::read_to_string(good).unwrap()) + curve;
    write(&folder, "case.toml", text);
    folder
}

/// The table, a map from column to field for each line. No field here has quotes with a comma.
fn table(folder: &TempDir) -> Vec<HashMap<String, String>> {
    rows_of(&folder.path().join("results/case/curve.csv"))
}

#[test]
fn a_curve_is_solved_and_written() {
    let folder = workspace(str::to_owned, &format!("{SPEEDS}folders = true\n"));
    let output = solve(&folder, "case.toml");
    let (report, progress) = (text(&output.stdout), text(&output.stderr));
    code(&output, 0);
    contains(report, "3 of 3 points solved");
    contains(progress, "point 2/3 (1.3 m/s)");
    let rows = table(&folder);
    let speeds: Vec<f64> = (rows.iter())
        .map(|r| r["entrainment_speed_m_per_s"].parse().unwrap())
        .collect();
    assert_eq!(speeds, [1.0, 1.3, 0.9]);
    let starts: Vec<&str> = rows.iter().map(|r| r["start"].as_str()).collect();
    // Finite volumes start from the dry contact.
    assert_eq!(starts, ["cold"; 3]);

    let results = folder.path().join("results/case");
    for name in ["curve.json", "case.toml", "report.txt", "film-curve.svg"] {
        assert!(results.join(name).exists(), "{name}");
    }
    // A point's own case file is a case.
    let point = results.join("points/3");
    assert!(point.join("centreline.csv").exists());
    std::fs::copy(point.join("case.toml"), folder.path().join("point.toml")).unwrap();
    let output = solve(&folder, "point.toml");
    code(&output, 0);
    // Its folder is replaced by a former result of any kind, but not with something else in it.
    code(&solve(&folder, "case.toml -q"), 0);
    std::fs::write(point.join("notes.txt"), "mine").unwrap();
    let error = stderr_of(solve(&folder, "case.toml"), 1);
    contains(&error, "notes.txt");
    assert!(point.join("notes.txt").exists());
}

/// Traction against sliding, with the Newtonian curve.
#[test]
fn a_sliding_curve_shows_its_traction() {
    let thins = |case: &str| {
        let law = "shear_thinning = { law = \"ree-eyring\", tau_0 = \"0.2 MPa\" }\n\n[mesh]";
        case.replace("[mesh]", law)
    };
    let ratios = "[curve]\nquantity = \"motion.slide_to_roll_ratio\"\nvalues = [0.0, 0.1, 0.2]\nnewtonian = true\n";
    let folder = workspace(thins, ratios);
    let progress = stderr_of(solve(&folder, "case.toml"), 0);
    contains(&progress, "point 2/3 (0.1, Newtonian)");
    assert!(
        folder
            .path()
            .join("results/case/traction-curve.svg")
            .exists()
    );
    let rows = table(&folder);
    let column =
        |name: &str| -> Vec<f64> { rows.iter().map(|r| r[name].parse().unwrap()).collect() };
    let (traction, newtonian) = (
        column("traction_coefficient"),
        column("newtonian_traction_coefficient"),
    );
    assert_eq!(traction[0], 0.0);
    assert!(traction[2] > traction[1] && traction[1] > 0.0);
    assert!(newtonian[2] > 1.5 * traction[2]);
    // Newtonian stress is proportional to the sliding speed, and its film is constant.
    assert!((newtonian[2] / newtonian[1] - 2.0).abs() < 1e-4);
    let (film, thick) = (column("film_central_m"), column("newtonian_film_central_m"));
    assert!((thick[2] / thick[0] - 1.0).abs() < 1e-5);
    for (i, reduction) in column("film_reduction_central").into_iter().enumerate() {
        assert!((reduction - (1.0 - film[i] / thick[i])).abs() < 1e-12);
        assert!(reduction > 0.0);
    }
    assert!(column("friction_power_W_per_m").iter().all(|p| *p > 0.0));
    // The reduction errs by what both films do; the other figures of a cold point have their own bars.
    let bar = |name: &str| -> f64 { rows[0][name].parse().unwrap() };
    let relative =
        bar("film_central_error_m") / film[0] + bar("newtonian_film_central_error_m") / thick[0];
    let expected = relative * film[0] / thick[0];
    assert!((bar("film_reduction_central_error") / expected - 1.0).abs() < 1e-9);
    assert!(bar("friction_power_error_W_per_m") > 0.0 && bar("pressure_maximum_error_Pa") > 0.0);
}

#[test]
fn a_failed_point_leaves_the_others_standing() {
    // Without stabilisation and with so few iterations the heavy point does not converge.
    let few =
        |case: &str| format!("{case}\n[solver]\nmax_iterations = 6\nformulation = \"galerkin\"\n");
    let loads = "[curve]\nquantity = \"contact.load\"\nvalues = [\"20 kN/m\", \"2000 kN/m\", \"22 kN/m\"]\n";
    let folder = workspace(few, loads);
    let output = solve(&folder, "case.toml");
    let message = text(&output.stderr);
    code(&output, 3);
    contains(message, "1 of 3 points failed");
    contains(text(&output.stdout), "point 2 failed");
    let rows = table(&folder);
    let converged: Vec<&str> = rows.iter().map(|r| r["converged"].as_str()).collect();
    assert_eq!(converged, ["true", "false", "true"]);
    assert_eq!(rows[1]["film_central_m"], "");
    assert!(rows[1]["reason"].contains("no convergence"), "{rows:?}");
    let film: f64 = rows[2]["film_central_m"].parse().unwrap();
    assert!(film > 0.0);
}

#[cfg(unix)]
#[test]
fn an_interrupted_curve_keeps_its_points() {
    let range = "[curve]\nquantity = \"contact.load\"\nfrom = \"20 kN/m\"\nto = \"40 kN/m\"\npoints = 1000\n";
    let folder = workspace(str::to_owned, range);
    let mut run = Running::start(command(&folder, "solve case.toml"));
    let third = run
        .lines
        .by_ref()
        .find(|l| l.as_ref().unwrap().contains("point 3/1000"));
    assert!(third.is_some());
    let rest = run.interrupt();
    assert!(rest.last().unwrap().contains("of 1000 points"), "{rest:?}");
    let rows = table(&folder);
    assert!((2..1000).contains(&rows.len()));
    assert!(rows.iter().all(|r| r["converged"] == "true"));
}

/// A traction curve with heat and the isothermal one: points start warm, with their temperatures.
#[test]
fn a_thermal_curve_shows_the_isothermal_one() {
    let slides = "\n[curve]\nquantity = \"motion.slide_to_roll_ratio\"\nvalues = [0, 0.2, 0.4]\nisothermal = true\n";
    let thermal = |_: &str| include_str!("good/thermal.toml").to_owned();
    let folder = workspace(thermal, slides);
    let output = solve(&folder, "case.toml");
    let message = text(&output.stderr);
    code(&output, 0);
    contains(message, "isothermal");
    let report = text(&output.stdout);
    for words in ["central film without heat", "traction without heat", " °C"] {
        contains(report, words);
    }
    let rows = table(&folder);
    let starts: Vec<&str> = rows.iter().map(|r| r["start"].as_str()).collect();
    assert_eq!(starts, ["cold", "warm", "warm"]);
    let column =
        |name: &str| -> Vec<f64> { rows.iter().map(|r| r[name].parse().unwrap()).collect() };
    let [traction, cold] = ["traction_coefficient", "isothermal_traction_coefficient"].map(column);
    // Heat takes traction away, the more of it is made.
    assert!(traction[1] < cold[1] && traction[2] < cold[2]);
    assert_eq!(rows[0]["thermal_reduction_traction"], "");
    for i in [1, 2] {
        let reduction: f64 = rows[i]["thermal_reduction_traction"].parse().unwrap();
        assert!((reduction - (1.0 - traction[i] / cold[i])).abs() < 1e-12);
    }
    let top = column("film_temperature_maximum_K");
    assert!(
        313.15 < top[0] && top[0] < top[1] && top[1] < top[2],
        "{top:?}"
    );
    assert!(column("heat_balance_error").iter().all(|e| e.abs() < 0.01));
    let [made, friction] = ["heat_shear_W_per_m", "friction_power_W_per_m"].map(column);
    assert!((made[2] / friction[2] - 1.0).abs() < 0.01);
    let json = read(&folder, "results/case/curve.json");
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!(json["points"][2]["isothermal"]["converged"], true);
    let mean = &json["points"][2]["figures"]["film_temperature_mean"]["value"];
    assert!(mean.as_f64().unwrap() > 313.15);
    let picture = std::fs::read_to_string(folder.path().join("results/case/traction-curve.svg"));
    assert!(picture.unwrap().contains("isothermal"));
}

/// The guide's curve and the study that it corresponds to, copied from there, for a light contact: the same values, the same
/// columns, and films within the error bars of both.
#[test]
fn the_guide_makes_a_study_of_a_curve() {
    let guide = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/guide/studies.md");
    let guide = std::fs::read_to_string(guide).unwrap();
    let (_, section) = guide.split_once("## A curve as a study").unwrap();
    let blocks: Vec<&str> = (section.split("```toml\n").skip(1))
        .map(|rest| rest.split("```").next().unwrap())
        .collect();
    let folder = workspace(str::to_owned, blocks[0]);
    let write = |name: &str, text: &str| write(&folder, name, text);
    write("ball-on-disc.toml", include_str!("good/quick.toml"));
    write("film-over-speed.toml", blocks[1]);
    let output = solve(&folder, "case.toml -q");
    code(&output, 0);
    let curve = table(&folder);

    assert!(section.contains("    ertel sweep film-over-speed.toml\n"));
    let output = ertel(&folder, "sweep film-over-speed.toml -q");
    code(&output, 0);
    let study = rows_of(&folder.path().join("results/film-over-speed/results.csv"));
    assert_eq!((curve.len(), study.len()), (5, 5));
    for (point, row) in curve.iter().zip(&study) {
        let number =
            |row: &HashMap<String, String>, name: &str| -> f64 { row[name].parse().unwrap() };
        assert_eq!(
            point["entrainment_speed_m_per_s"],
            row["motion.entrainment_speed_m_per_s"]
        );
        let own = |name: &&String| {
            *name != "seconds"
                && !name.starts_with("newtonian_")
                && !name.starts_with("isothermal_")
        };
        for name in point.keys().filter(own) {
            assert!(row.contains_key(name), "{name}");
        }
        let off = number(point, "film_central_m") - number(row, "film_central_m");
        let bars = number(point, "film_central_error_m") + number(row, "film_central_error_m");
        assert!(off.abs() <= bars, "{off:e} m off, bars {bars:e} m");
    }
}
