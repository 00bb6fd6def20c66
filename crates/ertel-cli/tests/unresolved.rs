//! Results that are written and not to be trusted: exit code 3, and by request 0.

use crate::common::{
    BRAKING, case_folder, code, contains, ertel, json, read, stderr_of, text, write,
};

const CURVE: &str = "\n[curve]\nquantity = \"motion.entrainment_speed\"\nvalues = [\"1 m/s\", \"1.5 m/s\", \"2 m/s\"]\n";

const STUDY: &str = "case = \"case.toml\"\n[[axis]]\nkey = \"motion.entrainment_speed\"\nvalues = [\"1 m/s\", \"1.5 m/s\"]\n";

/// An inlet edge so near that what it does to the film is beyond any bar.
fn starved() -> String {
    let (steady, _) = BRAKING.split_once("[transient]").unwrap();
    let rolling = steady.replace("slide_to_roll_ratio = 0.1", "slide_to_roll_ratio = 0.0");
    rolling.replace("\"1 m/s\"", "\"2 m/s\"") + "[mesh]\ninlet = -1.2\n"
}

#[test]
fn a_case_that_is_not_resolved_is_written_with_a_warning() {
    let folder = case_folder(&starved());
    let message = stderr_of(ertel(&folder, "solve case.toml"), 3);
    contains(&message, "error: not resolved: the central film thickness");
    contains(&message, "--accept-unresolved");
    let result = json(&folder.path().join("results/case/result.json"));
    let names = result["unresolved"].as_array().unwrap();
    assert!(names.contains(&"film_central".into()) && names.contains(&"film_minimum".into()));

    let accepted = ertel(&folder, "solve case.toml --accept-unresolved");
    code(&accepted, 0);
}

/// Three points, each with its own figures in four kinds of warnings: a line for each kind.
#[test]
fn points_that_are_not_resolved_are_counted_and_their_warnings_merged() {
    let sliding = starved().replace("slide_to_roll_ratio = 0.0", "slide_to_roll_ratio = 0.05");
    let folder = case_folder(&format!("{sliding}{CURVE}"));
    let output = ertel(&folder, "solve case.toml");
    code(&output, 3);
    contains(text(&output.stderr), "3 of 3 points are not resolved");
    let report = text(&output.stdout);
    let warnings: Vec<&str> = report.lines().filter(|l| l.starts_with("  !")).collect();
    assert_eq!(warnings.len(), 4, "{report}");
    assert!(warnings.iter().all(|w| w.contains("all 3 points")));
    contains(warnings[3], "all 3 points, worst at point");
    contains(
        report,
        "  · 3 of 3 points have figures that are not to be used",
    );
    contains(report, "central film thickness in 3");
    let table = read(&folder, "results/case/curve.csv");
    contains(table.lines().nth(1).unwrap(), "film_central film_minimum");
    let accepted = ertel(&folder, "solve case.toml --accept-unresolved");
    code(&accepted, 0);
}

#[test]
fn studies_count_them_too() {
    let folder = case_folder(&starved());
    write(&folder, "study.toml", STUDY);
    let output = ertel(&folder, "sweep study.toml");
    let message = text(&output.stderr);
    code(&output, 3);
    contains(message, "2 of 2 points are not resolved");
    let said = text(&output.stdout);
    contains(said, "central film thickness in 2");
    let accepted = ertel(&folder, "sweep study.toml --accept-unresolved");
    code(&accepted, 0);
}
