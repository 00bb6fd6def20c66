//! `ertel compare`, end to end.

use std::path::Path;
use std::process::Output;

use serde_json::Value;
use tempfile::TempDir;

use crate::common::{code, contains, ertel, read, stderr_of, text, write};

const TABLE: &str = "speed [m/s],load [kN/m],film_central [nm],film_central_uncertainty [%],film_minimum [nm]\n\
    0.5,20,300,5,\n1,20,600,5,400\n2,20,700,,\n1,20,550,5,\n";

/// A folder with `tests/good/quick.toml` as `case.toml`, and a table.
fn workspace(table: &str) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    write(&folder, "case.toml", include_str!("good/quick.toml"));
    write(&folder, "films.csv", table);
    folder
}

fn compare(folder: &TempDir, arguments: &str) -> Output {
    ertel(folder, &format!("compare {arguments}"))
}

#[test]
fn films_are_compared_with_those_of_a_sweep() {
    let folder = workspace(TABLE);
    let output = compare(&folder, "case.toml films.csv");
    let (report, progress) = (text(&output.stdout), text(&output.stderr));
    code(&output, 0);
    contains(progress, "3/3: point");
    for words in [
        "central film thickness, computed against measured",
        "minimum film thickness, computed against measured",
        "of 4, within the combined uncertainty; 1 rows have no measurement uncertainty",
        "the table gives no measurement uncertainty",
        "4 of 4 rows compared, 3 points",
        "Results in results/case-films",
    ] {
        contains(report, words);
    }
    // The page says what the report says, and a check what each column is read as.
    let page = read(&folder, "results/case-films/report.html");
    for words in [
        "Central film thickness",
        "4 of 4 rows compared",
        "bias (mean)",
    ] {
        contains(&page, words);
    }
    let checked = compare(&folder, "case.toml films.csv --check");
    let checked = text(&checked.stdout);
    for words in [
        "column `speed [m/s]`: sets motion.entrainment_speed",
        "column `film_central [nm]`: measured central film thickness",
        "column `film_central_uncertainty [%]`: uncertainty of the central film thickness",
    ] {
        contains(checked, words);
    }
    // The same contact solved alone has the same film.
    let case = read(&folder, "case.toml").replace("1 m/s", "2 m/s");
    write(&folder, "alone.toml", case);
    let alone = ertel(&folder, "solve alone.toml -q -o alone");
    code(&alone, 0);
    let alone: Value = serde_json::from_str(&read(&folder, "alone/result.json")).unwrap();
    let film = &alone["summary"]["film_central"];
    let json: Value =
        serde_json::from_str(&read(&folder, "results/case-films/comparison.json")).unwrap();
    assert_eq!(json["format"], "ertel-comparison");
    let row = &json["rows"][2]["figures"]["film_central"];
    let off = row["computed"].as_f64().unwrap() - film["value"].as_f64().unwrap();
    assert!(
        off.abs() <= 2.0 * film["error"].as_f64().unwrap(),
        "{row} {film}"
    );
    let difference = row["computed"].as_f64().unwrap() / 700e-9 - 1.0;
    assert!((row["difference"].as_f64().unwrap() - difference).abs() < 1e-12);
    assert_eq!(json["rows"][1]["point"], json["rows"][3]["point"]);
    let table = read(&folder, "results/case-films/comparison.csv");
    assert_eq!(table.lines().count(), 5);
    assert!(table.starts_with(
        "line,point,motion.entrainment_speed_m_per_s,contact.load_N_per_m,film_central_measured_m,"
    ));
    let svg = read(&folder, "results/case-films/comparison.svg");
    assert!(svg.contains("measured") && svg.contains("computed"));

    // A second run solves nothing; the folder of the study is a study.
    let error = stderr_of(compare(&folder, "case.toml films.csv"), 0);
    assert!(!error.contains("point 1"), "{error}");
    assert!(
        folder
            .path()
            .join("results/case-films/study/results.csv")
            .is_file()
    );
}

#[test]
fn failed_points_are_reported_and_omitted() {
    let folder =
        workspace("speed [m/s],film_central [nm],solver.max_iterations\n0.5,300,40\n1,600,1\n");
    let output = compare(&folder, "case.toml films.csv -o out");
    let report = text(&output.stdout);
    assert_eq!(output.status.code(), Some(3), "{report}");
    contains(text(&output.stderr), "1 of 2 points failed and are omitted");
    contains(report, "line 3 is omitted; its point failed");
    contains(report, "1 of 2 rows compared");
    let json: Value = serde_json::from_str(&read(&folder, "out/comparison.json")).unwrap();
    assert_eq!(json["statistics"]["film_central"]["n_compared"], 1);
    assert!(json["rows"][1]["figures"]["film_central"]["computed"].is_null());
    assert!(folder.path().join("out/comparison.svg").is_file());
}

#[test]
fn files_of_others_stay() {
    let folder = workspace(TABLE);
    let place = |name: &str| folder.path().join(name);
    std::fs::create_dir_all(place("mine/study")).unwrap();
    std::fs::write(place("mine/study/notes.txt"), "mine").unwrap();
    std::fs::create_dir_all(place("own")).unwrap();
    std::fs::write(place("own/comparison.csv"), "mine").unwrap();
    std::fs::write(place("file"), "mine").unwrap();
    for target in ["mine", "own", "file", "."] {
        let output = compare(&folder, &format!("case.toml films.csv -o {target}"));
        let message = text(&output.stderr);
        assert!(
            matches!(output.status.code(), Some(1 | 2)),
            "{target}: {message}"
        );
        assert!(output.stdout.is_empty());
    }
    assert_eq!(read(&folder, "mine/study/notes.txt"), "mine");
    assert_eq!(read(&folder, "own/comparison.csv"), "mine");
    assert_eq!(read(&folder, "file"), "mine");
    assert_eq!(read(&folder, "films.csv"), TABLE);
}

#[test]
fn a_bad_table_exits_with_2_and_writes_nothing() {
    for (table, words) in [
        ("speed [m/s],film_central\n1,100\n", "films.csv:1:2"),
        ("speed [m/s],film_central [nm]\n1,-100\n", "films.csv:2:2"),
        ("speed [m/s],film_central [nm]\n-1e9,100\n", "films.csv:2:1"),
        ("load [N],film_central [nm]\n20,100\n", "films.csv:2:1"),
    ] {
        let folder = workspace(table);
        for more in ["--check", ""] {
            let output = compare(&folder, &format!("case.toml films.csv {more}"));
            let message = text(&output.stderr);
            code(&output, 2);
            contains(message, words);
            assert!(!folder.path().join("results").exists());
        }
    }
    let folder = workspace(TABLE);
    let curve = "\n[curve]\nquantity = \"contact.load\"\nvalues = [\"20 kN/m\", \"30 kN/m\"]\n";
    let case = read(&folder, "case.toml") + curve;
    write(&folder, "case.toml", case);
    let message = stderr_of(compare(&folder, "case.toml films.csv"), 2);
    contains(&message, "case.toml:");
    contains(&message, "[curve]");
}

/// Every command of the guide, in the folder that it is written for.
#[test]
fn the_commands_of_the_guide_run() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let page = std::fs::read_to_string(root.join("docs/guide/compare.md")).unwrap();
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("cases")).unwrap();
    for name in ["measured-films.toml", "measured-films.csv"] {
        std::fs::copy(
            root.join("cases").join(name),
            folder.path().join("cases").join(name),
        )
        .unwrap();
    }
    let mut n = 0;
    for line in page
        .lines()
        .filter_map(|l| l.strip_prefix("    ertel compare "))
    {
        // Placeholders of the reader's own files.
        if line.contains("my-") {
            continue;
        }
        let output = compare(&folder, line);
        assert_eq!(
            output.status.code(),
            Some(0),
            "{line}: {}",
            text(&output.stderr)
        );
        n += 1;
    }
    assert!(n >= 2, "{n} commands");
    // The figures that the page shows.
    let json = std::fs::read_to_string(
        folder
            .path()
            .join("results/measured-films-measured-films/comparison.json"),
    );
    let json: Value = serde_json::from_str(&json.unwrap()).unwrap();
    let bias = 100.0 * json["statistics"]["film_central"]["bias"].as_f64().unwrap();
    contains(&page, &format!("bias (mean)           {bias:+.1} %"));
}
