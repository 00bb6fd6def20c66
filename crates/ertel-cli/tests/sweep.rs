//! `ertel sweep`, end to end.

use std::collections::HashSet;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant, SystemTime};

use serde_json::Value;
use tempfile::TempDir;

use crate::common::{self, Running, code, contains, ertel, read, stderr_of, text, write};

/// Eighteen points in two groups of films.
const STUDY: &str = r#"
title = "Roller"
case = "base.toml"

[[axis]]
key = "motion.entrainment_speed"
from = "0.2 m/s"
to = "2 m/s"
points = 6
spacing = "log"

[[axis]]
key = "contact.load"
values = ["20 kN/m", "30 kN/m", "45 kN/m"]
"#;

/// A folder with `tests/good/quick.toml` as `base.toml`, and a study.
fn workspace(study: &str) -> TempDir {
    let good = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/good/quick.toml");
    let folder = tempfile::tempdir().unwrap();
    std::fs::copy(good, folder.path().join("base.toml")).unwrap();
    write(&folder, "study.toml", study);
    folder
}

fn command(folder: &TempDir, arguments: &str) -> Command {
    common::command(folder, &format!("sweep {arguments}"))
}

fn sweep(folder: &TempDir, arguments: &str) -> Output {
    command(folder, arguments).output().unwrap()
}

/// One column of a table without quotes.
fn column(table: &str, name: &str) -> Vec<String> {
    let mut lines = table.lines().map(|l| l.split(',').collect::<Vec<_>>());
    let head = lines.next().unwrap();
    let i = head.iter().position(|c| *c == name).expect(name);
    lines.map(|cells| cells[i].to_owned()).collect()
}

/// Keys of the journal in its order.
fn keys(journal: &str) -> Vec<String> {
    let key = |line: &str| serde_json::from_str::<Value>(line).unwrap()["key"].to_string();
    journal.lines().map(key).collect()
}

/// A number below one, different each time.
fn random() -> f64 {
    let now = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH);
    let mut x = now.unwrap().as_nanos() as u64 ^ 0x9e37_79b9_7f4a_7c15;
    for _ in 0..3 {
        x ^= x << 13;
        x ^= x >> 7;
        x ^= x << 17;
    }
    (x >> 11) as f64 / (1u64 << 53) as f64
}

#[test]
fn a_study_is_solved_and_its_films_are_fitted() {
    let folder = workspace(STUDY);
    let output = sweep(&folder, "study.toml --dry-run");
    contains(text(&output.stdout), "18 points, 0 finished");
    assert!(!folder.path().join("results").exists());
    let output = sweep(&folder, "study.toml");
    let (report, progress) = (text(&output.stdout), text(&output.stderr));
    code(&output, 0);
    contains(report, "18 of 18 points finished, 0 failed");
    contains(progress, "1/18: point ");
    contains(progress, "left");
    let table = read(&folder, "results/study/results.csv");
    let numbers: Vec<usize> = (column(&table, "point").iter())
        .map(|n| n.parse().unwrap())
        .collect();
    assert_eq!(numbers, (1..=18).collect::<Vec<_>>());
    let loads = column(&table, "contact.load_N_per_m");
    assert_eq!(loads[..4], ["2e4", "3e4", "4.5e4", "2e4"]);
    let starts = column(&table, "start");
    assert!(starts.iter().all(|start| start == "cold"), "{starts:?}");
    // Each point is the case solved alone, within its error bars.
    let curve = r#"[curve]
quantity = "motion.entrainment_speed"
values = ["0.2 m/s", "2 m/s"]
"#;
    let case = read(&folder, "base.toml") + curve;
    write(&folder, "case.toml", case);
    let solve = Command::new(env!("CARGO_BIN_EXE_ertel"))
        .args(["solve", "case.toml", "-q"])
        .current_dir(&folder)
        .status();
    assert!(solve.unwrap().success());
    let alone = read(&folder, "results/case/curve.csv");
    for (i, point) in [0, 15].into_iter().enumerate() {
        let figure = |table: &str, row: usize, name: &str| -> f64 {
            column(table, name)[row].parse().unwrap()
        };
        let film = |table, row| figure(table, row, "film_central_m");
        let bar = |table, row| figure(table, row, "film_central_error_m");
        let off = (film(&table, point) - film(&alone, i)).abs();
        assert!(off <= bar(&table, point) + bar(&alone, i), "{off:e} m off");
    }
    let fit = ertel(&folder, "fit film results/study/results.csv");
    code(&fit, 0);
    contains(text(&fit.stdout), "Central film of 18 results");
}

/// Temperatures are in the table, and the films are thinner than those without heat.
#[test]
fn a_study_with_heat_has_its_temperatures() {
    let study = r#"
case = "thermal.toml"

[[axis]]
key = "motion.slide_to_roll_ratio"
values = [0.0, 0.2, 0.4]

[[axis]]
key = "solver.isothermal"
values = [false, true]
"#;
    let folder = workspace(study);
    let thermal = include_str!("good/thermal.toml");
    write(&folder, "thermal.toml", thermal);
    // Without heat the Newtonian film would transmit more than dry metal does.
    let output = sweep(&folder, "study.toml -q --accept-unresolved");
    code(&output, 0);
    let table = read(&folder, "results/study/results.csv");
    let numbers = |name: &str| -> Vec<Option<f64>> {
        let cells = column(&table, name);
        cells.iter().map(|cell| cell.parse().ok()).collect()
    };
    let value = |name: &str, i: usize| numbers(name)[i].unwrap();
    // Points 0, 2, 4 have heat, points 1, 3, 5 have none.
    for name in [
        "film_temperature_maximum_K",
        "film_temperature_mean_K",
        "temperature_body_1_maximum_K",
        "temperature_body_2_maximum_K",
        "heat_shear_W_per_m",
        "heat_balance_error",
        "thermal_reduction_central",
        "thermal_reduction_minimum",
    ] {
        let has: Vec<bool> = numbers(name).iter().map(Option::is_some).collect();
        assert_eq!(has, [true, false, true, false, true, false], "{name}");
    }
    let ambient = 313.15;
    assert!(value("film_temperature_maximum_K", 4) > value("film_temperature_maximum_K", 2));
    for name in [
        "film_temperature_maximum_K",
        "temperature_body_1_maximum_K",
        "temperature_body_2_maximum_K",
    ] {
        assert!(value(name, 4) > ambient);
    }
    assert!(value("heat_balance_error", 4).abs() < 0.01);
    for (name, of) in [
        ("thermal_reduction_central", "film_central_m"),
        ("thermal_reduction_traction", "traction_coefficient"),
    ] {
        let expected = 1.0 - value(of, 4) / value(of, 5);
        assert!(expected > 0.0 && (value(name, 4) - expected).abs() < 1e-12);
    }
    // Its bar is that of both films together.
    let film = |i| value("film_central_error_m", i) / value("film_central_m", i);
    let ratio = value("film_central_m", 0) / value("film_central_m", 1);
    let bar = value("thermal_reduction_central_error", 0);
    assert!((bar / (ratio * (film(0) + film(1))) - 1.0).abs() < 1e-9);
    // Where nothing slides there is no traction to lose.
    assert_eq!(numbers("thermal_reduction_traction")[0], None);
    for picture in ["film.svg", "traction.svg"] {
        let picture = read(&folder, &format!("results/study/{picture}"));
        assert!(picture.contains("without heat"));
    }
    // In another format they take the place of those before.
    let formats = "--set 'output.pictures=[\"pdf\", \"png\"]'";
    let output = sweep(
        &folder,
        &format!("study.toml -q --accept-unresolved {formats}"),
    );
    code(&output, 0);
    for picture in ["film", "traction"] {
        let file = |suffix| {
            folder
                .path()
                .join(format!("results/study/{picture}.{suffix}"))
        };
        assert!(std::fs::read(file("pdf")).unwrap().starts_with(b"%PDF-"));
        assert!(std::fs::read(file("png")).unwrap().starts_with(b"\x89PNG"));
        assert!(!file("svg").exists());
    }
    // Back to SVG: a PDF file of this name may be the user's own by now.
    let output = sweep(&folder, "study.toml -q --accept-unresolved");
    code(&output, 0);
    for name in ["film.svg", "film.pdf", "traction.svg", "traction.png"] {
        assert!(
            folder.path().join("results/study").join(name).is_file(),
            "{name}"
        );
    }
}

/// Killed at random moments, a study gives the same table, byte for byte, and no point is in its journal twice.
#[test]
fn a_killed_study_ends_as_an_undisturbed_one() {
    let folder = workspace(STUDY);
    let clock = Instant::now();
    code(&sweep(&folder, "study.toml -q -o whole"), 0);
    let time = clock.elapsed();
    let undisturbed = read(&folder, "whole/results.csv");
    let n_lines = |name: &str| {
        let journal = folder.path().join(name).join("journal.jsonl");
        let journal = std::fs::read_to_string(journal).unwrap_or_default();
        journal.lines().count()
    };
    let mut n_resumed = 0;
    for round in 0..20 {
        let jobs = ["1", "2", "3"][round % 3];
        let start = |name: &str| {
            command(&folder, &format!("study.toml -q -o {name} -j {jobs}"))
                .stderr(Stdio::piped())
                .spawn()
                .unwrap()
        };
        let killed_within = |name: &str, limit: f64| {
            let mut child = start(name);
            std::thread::sleep(Duration::from_secs_f64(random() * limit));
            // SIGKILL; an error says that it has ended already.
            let _ = child.kill();
            let _ = child.wait();
            n_lines(name)
        };
        // Killed before its end, however fast the machine is now; then again, at any time.
        let mut limit = time.as_secs_f64();
        let mut tries = 0;
        let name = loop {
            let name = format!("killed-{round}-{tries}");
            let n = killed_within(&name, limit);
            if n < 18 {
                n_resumed += usize::from(n > 0);
                break name;
            }
            (limit, tries) = (0.5 * limit, tries + 1);
            assert!(tries < 20);
        };
        n_resumed += usize::from((1..18).contains(&killed_within(&name, limit)));
        let output = start(&name).wait_with_output().unwrap();
        code(&output, 0);
        assert_eq!(read(&folder, &format!("{name}/results.csv")), undisturbed);
        let journal = keys(&read(&folder, &format!("{name}/journal.jsonl")));
        assert_eq!(journal.len(), 18);
        assert_eq!(journal.iter().collect::<HashSet<_>>().len(), 18);
    }
    // Kills before the first point say little.
    assert!(n_resumed >= 2, "{n_resumed} with some points");
}

#[test]
fn a_torn_line_is_dropped() {
    let folder = workspace(STUDY);
    code(&sweep(&folder, "study.toml -q"), 0);
    let undisturbed = read(&folder, "results/study/results.csv");
    let path = folder.path().join("results/study/journal.jsonl");
    let journal = std::fs::read(&path).unwrap();
    let lines: Vec<&[u8]> = journal.split_inclusive(|b| *b == b'\n').collect();
    // Seven points, half of the eighth, as a crash of the machine may leave it.
    let mut torn = lines[..7].concat();
    torn.extend(&lines[7][..lines[7].len() / 2]);
    std::fs::write(&path, &torn).unwrap();
    std::fs::remove_file(folder.path().join("results/study/results.csv")).unwrap();
    let output = sweep(&folder, "study.toml");
    let progress = text(&output.stderr);
    contains(progress, "7 of 18 points are finished already");
    assert_eq!(read(&folder, "results/study/results.csv"), undisturbed);
    assert_eq!(
        keys(&read(&folder, "results/study/journal.jsonl")).len(),
        18
    );
    // Damage within costs that point alone; so does a digit that somebody changed.
    let journal = String::from_utf8(journal).unwrap();
    let i = journal.find("film_central_m\",\"").unwrap() + "film_central_m\",\"".len();
    let mut digit = journal.clone();
    let other = if &journal[i..=i] == "1" { "2" } else { "1" };
    digit.replace_range(i..=i, other);
    for damaged in [journal.replacen("converged", "conv\0rged", 1), digit] {
        std::fs::write(&path, damaged).unwrap();
        let output = sweep(&folder, "study.toml");
        let said = text(&output.stderr);
        contains(said, "17 of 18 points are finished already");
        contains(said, "1 lines of the journal are damaged");
        assert_eq!(read(&folder, "results/study/results.csv"), undisturbed);
    }
}

#[test]
fn parts_are_joined_to_the_whole() {
    let folder = workspace(STUDY);
    code(&sweep(&folder, "study.toml -q -o whole"), 0);
    let mut parts = Vec::new();
    for i in 1..=4 {
        code(&sweep(&folder, &format!("study.toml -q --shard {i}/4")), 0);
        parts.push(format!("results/study/shards/{i}-of-4"));
    }
    let merge = |parts: &[String]| {
        sweep(
            &folder,
            &format!("--merge results/study {}", parts.join(" ")),
        )
    };
    let message = stderr_of(merge(&parts[..3]), 1);
    contains(&message, "of 18 points are in none of the parts");
    let output = merge(&parts);
    code(&output, 0);
    let whole = read(&folder, "whole/results.csv");
    assert_eq!(read(&folder, "results/study/results.csv"), whole);
    assert_eq!(
        keys(&read(&folder, "results/study/journal.jsonl")).len(),
        18
    );
    // The whole is a study like any other.
    let output = sweep(&folder, "study.toml");
    contains(text(&output.stdout), "18 of them earlier");
    // Parts of something else are refused.
    let other = STUDY.replace("45 kN/m", "40 kN/m");
    write(&folder, "other.toml", other);
    code(&sweep(&folder, "other.toml -q --shard 1/9"), 0);
    let output = merge(&[parts[0].clone(), "results/other/shards/1-of-9".into()]);
    code(&output, 2);
    contains(text(&output.stderr), "another study");
}

#[test]
fn failed_points_carry_their_reason() {
    // Without stabilisation and with so few iterations the heavy point does not converge.
    let study = r#"
case = "base.toml"
[[axis]]
key = "contact.load"
values = ["20 kN/m", "2000 kN/m", "22 kN/m"]
[[axis]]
key = "solver.max_iterations"
values = [7]
[[axis]]
key = "solver.formulation"
values = ["galerkin"]
"#;
    let folder = workspace(study);
    let message = stderr_of(sweep(&folder, "study.toml"), 3);
    contains(&message, "1 of 3 points failed");
    let table = read(&folder, "results/study/results.csv");
    assert_eq!(column(&table, "converged"), ["true", "false", "true"]);
    assert_eq!(column(&table, "film_central_m")[1], "");
    let failed = table.lines().nth(2).unwrap();
    contains(failed, "no convergence");
    // It is kept, unless asked for again.
    let output = sweep(&folder, "study.toml");
    code(&output, 3);
    contains(text(&output.stdout), "0 new");
    let output = sweep(&folder, "study.toml --retry");
    code(&output, 3);
    contains(text(&output.stdout), "1 new");
    assert_eq!(read(&folder, "results/study/results.csv"), table);
    // The others are fitted.
    let fit = ertel(&folder, "fit film results/study/results.csv");
    contains(text(&fit.stderr), "2 films");
}

#[test]
fn a_changed_study_solves_what_changed() {
    let folder = workspace(STUDY);
    code(&sweep(&folder, "study.toml -q"), 0);
    let more = STUDY.replace("\"45 kN/m\"", "\"45 kN/m\", \"60 kN/m\"");
    write(&folder, "study.toml", more);
    let output = sweep(&folder, "study.toml");
    let report = text(&output.stdout);
    contains(report, "24 of 24 points finished, 18 of them earlier");
    let table = read(&folder, "results/study/results.csv");
    assert_eq!(column(&table, "contact.load_N_per_m")[3], "6e4");
    // Another viscosity is another case in every point; the former ones are omitted from the table.
    let base = read(&folder, "base.toml").replace("40 mPa.s", "41 mPa.s");
    write(&folder, "base.toml", base);
    let output = sweep(&folder, "study.toml");
    contains(
        text(&output.stdout),
        "24 of 24 points finished, 0 failed; 24 new",
    );
    let second = read(&folder, "results/study/results.csv");
    assert_eq!(second.lines().count(), 25);
    let thick = |table: &str| -> f64 { column(table, "film_central_m")[0].parse().unwrap() };
    assert!(thick(&second) > 1.01 * thick(&table));
}

#[test]
fn each_point_has_a_folder_where_asked_for() {
    let study = "case = \"base.toml\"\n[[axis]]\nkey = \"contact.load\"\nvalues = [\"20 kN/m\", \"30 kN/m\"]\n";
    let folder = workspace(study);
    code(&sweep(&folder, "study.toml -q"), 0);
    let table = read(&folder, "results/study/results.csv");
    assert!(!folder.path().join("results/study/points").exists());
    // Finished points have their folders made up for.
    code(&sweep(&folder, "study.toml -q --folders"), 0);
    assert_eq!(read(&folder, "results/study/results.csv"), table);
    let result = read(&folder, "results/study/points/2/result.json");
    let result: Value = serde_json::from_str(&result).unwrap();
    assert_eq!(result["case"]["si"]["contact"]["load"], 30e3);
    let solve = Command::new(env!("CARGO_BIN_EXE_ertel"))
        .args(["solve", "--check", "results/study/points/2/case.toml"])
        .current_dir(&folder)
        .status();
    assert!(solve.unwrap().success());
}

#[test]
fn what_cannot_be_run_is_refused() {
    let folder = workspace(STUDY);
    let refused = |arguments: &str, code: i32, words: &str| {
        contains(&stderr_of(sweep(&folder, arguments), code), words);
    };
    for shard in ["0/3", "4/3", "1", "a/b"] {
        let arguments = format!("study.toml --shard {shard}");
        refused(&arguments, 2, "the third of eight parts");
    }
    refused("", 2, "STUDY.toml");
    refused("--merge out nothing", 2, "is not a study");
    std::fs::create_dir(folder.path().join("mine")).unwrap();
    write(&folder, "mine/notes.txt", "mine");
    refused("study.toml -o mine", 1, "no study.json of ertel");
    // The same case in two points.
    let twice = "case = \"base.toml\"\npoints = \"twice.csv\"\n";
    write(&folder, "twice.toml", twice);
    let points = "title,contact.load_kN_per_m\na,20\nb,20\n";
    write(&folder, "twice.csv", points);
    refused("twice.toml", 2, "points 1 and 2 are the same case");
    // Two runs at a time.
    let mut child = command(&folder, "study.toml -j 1")
        .stderr(Stdio::piped())
        .stdout(Stdio::null())
        .spawn()
        .unwrap();
    let mut lines = std::io::BufRead::lines(std::io::BufReader::new(child.stderr.take().unwrap()));
    assert!(lines.next().unwrap().unwrap().contains("1/18"));
    refused("study.toml", 1, "another run is writing");
    for _ in lines {}
    assert!(child.wait().unwrap().success());
}

#[cfg(unix)]
#[test]
fn an_interrupted_study_says_how_to_go_on() {
    let folder = workspace(&STUDY.replace("points = 6", "points = 300"));
    let mut run = Running::start(command(&folder, "study.toml"));
    assert!(run.lines.next().unwrap().unwrap().contains("1/900"));
    let rest = run.interrupt();
    contains(rest.last().unwrap(), "continues with the others");
    assert!(!folder.path().join("results/study/results.csv").exists());
    assert!(!read(&folder, "results/study/journal.jsonl").is_empty());
}
