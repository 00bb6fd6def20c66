//! Studies that are wrong are refused at once, with file, line and reason; tables are safe to open.

use std::time::{Duration, Instant};

use tempfile::TempDir;

use crate::common::{code, contains, ertel, read, stderr_of, write};

fn workspace(study: &str) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    write(&folder, "base.toml", include_str!("good/quick.toml"));
    write(&folder, "study.toml", study);
    folder
}

/// Exit code 2 and words on stderr, in a dry run and without it.
fn refused(folder: &TempDir, words: &[&str]) {
    for more in ["--dry-run", ""] {
        let message = stderr_of(ertel(folder, &format!("sweep study.toml {more}")), 2);
        for words in words {
            contains(&message, words);
        }
        assert!(!folder.path().join("results").exists());
    }
}

const LOADS: &str = "[[axis]]\nkey = \"contact.load\"\nvalues = [\"20 kN/m\", \"30 kN/m\"]\n";

/// Spreadsheets take texts that begin like formulas as texts.
#[test]
fn formulas_in_texts_are_no_formulas_in_the_table() {
    let study = r#"
case = "base.toml"
[[axis]]
key = "title"
values = ["=cmd|' /C calc'!A0", "@sum(1)", "+x, y", "-\t1", "\t=1", "plain"]
zip = "points"
[[axis]]
key = "contact.load"
values = ["20 kN/m", "21 kN/m", "22 kN/m", "23 kN/m", "24 kN/m", "25 kN/m"]
zip = "points"
[[axis]]
key = "motion.slide_to_roll_ratio"
values = [-0.1]
"#;
    let folder = workspace(study);
    code(&ertel(&folder, "sweep study.toml -q -o out"), 0);
    let table = read(&folder, "out/results.csv");
    let starts = [
        "1,\"'=cmd|' /C calc'!A0\",2e4,-1e-1,",
        "2,\"'@sum(1)\",2.1e4,-1e-1,",
        "3,\"'+x, y\",2.2e4,-1e-1,",
        "4,\"'-\t1\",2.3e4,-1e-1,",
        "5,\"'\t=1\",2.4e4,-1e-1,",
        "6,plain,2.5e4,-1e-1,",
    ];
    for (line, start) in table.lines().skip(1).zip(starts) {
        assert!(line.starts_with(start), "{line}");
    }
    assert_eq!(table.lines().count(), 7);
}

#[test]
fn a_base_case_that_is_missing_is_named_with_its_place() {
    let folder = workspace(&format!("title = \"t\"\ncase = \"nothing.toml\"\n{LOADS}"));
    let place = ["nothing.toml cannot be read", "study.toml:2:8", "case = "];
    refused(&folder, &place);

    // Likewise the case of a validation.
    std::fs::create_dir_all(folder.path().join("studies/roller")).unwrap();
    write(
        &folder,
        "studies/roller/reference.toml",
        "title = \"Roller\"\nsource = \"made up\"\n[[run]]\nname = \"roller\"\ncase = \"nothing.toml\"\n",
    );
    let message = stderr_of(ertel(&folder, "validate --folder studies"), 2);
    contains(&message, "reference.toml:5:8");
}

#[test]
fn a_bad_value_in_a_table_is_named_with_file_and_line() {
    let folder = workspace("case = \"base.toml\"\npoints = \"points.csv\"\n");
    write(
        &folder,
        "points.csv",
        "lubricant.temperature_degC,contact.load_kN_per_m,motion.entrainment_speed_m_per_s\n40,50,1\n40,50,-2\n",
    );
    refused(&folder, &["points.csv:3:7", "entrainment speed", "point 2"]);

    // The same line in the table of a law.
    let law = "{ law = \"roelands\", mu_0 = \"40 mPa.s\", alpha = \"20 1/GPa\" }";
    let base = include_str!("good/quick.toml");
    assert!(base.contains(law));
    let table = "{ law = \"table\", file = \"points.csv\" }";
    write(&folder, "base.toml", base.replace(law, table));
    write(
        &folder,
        "study.toml",
        format!("case = \"base.toml\"\n{LOADS}"),
    );
    write(
        &folder,
        "points.csv",
        "temperature [degC],pressure [MPa],viscosity [mPa.s]\n40,0,40\n40,50,-2\n",
    );
    refused(
        &folder,
        &[
            "points.csv:3:3: viscosity: -2 is impossible",
            "base.toml:20:37",
        ],
    );
}

#[test]
fn axes_that_change_nothing_are_refused_with_the_reason() {
    let curve = "values = [{ quantity = \"contact.load\", values = [\"60 kN/m\", \"70 kN/m\"] }]";
    for (key, values, words) in [
        ("curve", curve, "have no [curve]"),
        (
            "curve.quantity",
            "values = [\"contact.load\"]",
            "have no [curve]",
        ),
        ("title", "values = [\"a\", \"b\"]", "the same contact"),
        (
            "output.folder",
            "values = [\"a\", \"b\"]",
            "does not change what is solved",
        ),
        (
            "output",
            "values = [{ folder = \"a\" }]",
            "does not change what is solved",
        ),
    ] {
        let axis = format!("[[axis]]\nkey = \"{key}\"\n{values}\n");
        let folder = workspace(&format!("case = \"base.toml\"\n{LOADS}{axis}"));
        refused(&folder, &[words, "study.toml:6:7", "= help: "]);
    }
    // A column of the table of points.
    let folder = workspace("case = \"base.toml\"\npoints = \"points.csv\"\n");
    write(
        &folder,
        "points.csv",
        "contact.load_N_per_m,output.folder\n20000,a\n30000,b\n",
    );
    refused(&folder, &["points.csv:1:22"]);
    // The same contact under two titles.
    write(
        &folder,
        "points.csv",
        "contact.load_N_per_m,title\n20000,a\n20000,b\n",
    );
    refused(&folder, &["points 1 and 2 are the same case"]);
}

#[test]
fn an_axis_that_is_too_long_is_refused_at_once() {
    let values: Vec<String> = (0..100_000)
        .map(|i| format!("\"{} N/m\"", 20_000 + i))
        .collect();
    let axis = format!(
        "[[axis]]\nkey = \"contact.load\"\nvalues = [{}]\n",
        values.join(", ")
    );
    let speeds: Vec<String> = (1..=11).map(|i| format!("\"{i} m/s\"")).collect();
    let other = format!(
        "[[axis]]\nkey = \"motion.entrainment_speed\"\nvalues = [{}]\n",
        speeds.join(", ")
    );
    let folder = workspace(&format!("case = \"base.toml\"\n{axis}{other}"));
    let clock = Instant::now();
    refused(&folder, &["more than 1000000 points", "study.toml:1:"]);
    assert!(
        clock.elapsed() < Duration::from_secs(20),
        "{:?}",
        clock.elapsed()
    );

    // A table of as many points.
    let rows: String = (0..1_000_001)
        .map(|i| format!("{}\n", 20_000 + i))
        .collect();
    let folder = workspace("case = \"base.toml\"\npoints = \"points.csv\"\n");
    write(
        &folder,
        "points.csv",
        format!("contact.load_N_per_m\n{rows}"),
    );
    let clock = Instant::now();
    refused(&folder, &["more than 1000000 points"]);
    assert!(
        clock.elapsed() < Duration::from_secs(20),
        "{:?}",
        clock.elapsed()
    );
}
