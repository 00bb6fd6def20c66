//! `--set`, standard input, several cases, `--json`, `--check`, `-v`, colour, `init`, completions and manual pages.

use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use serde_json::Value;
use tempfile::TempDir;

use crate::common::{self, code, contains, read, stderr, stderr_of, stdout, write};

const QUICK: &str = include_str!("good/quick.toml");

fn command(folder: &TempDir, arguments: &str) -> Command {
    let mut command = common::command(folder, arguments);
    for variable in ["NO_COLOR", "CLICOLOR", "CLICOLOR_FORCE"] {
        command.env_remove(variable);
    }
    command
}

fn ertel(folder: &TempDir, arguments: &str) -> Output {
    command(folder, arguments).output().unwrap()
}

fn with_input(folder: &TempDir, arguments: &str, input: &str) -> Output {
    let mut child = command(folder, arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // A command that does not read it may be gone.
    let _ = child.stdin.take().unwrap().write_all(input.as_bytes());
    child.wait_with_output().unwrap()
}

/// A folder with `quick.toml`.
fn workplace() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    write(&folder, "quick.toml", QUICK);
    folder
}

/// The film of a case changed on the command line is that of the file with the change in it, and that file is written with the results.
#[test]
fn values_are_set_on_the_command_line() {
    let folder = workplace();
    let set = "solve quick.toml -q --set 'contact.load=30 kN/m' --set title=Other";
    code(&ertel(&folder, set), 0);
    let text = read(&folder, "results/quick/case.toml");
    contains(&text, "load = \"30 kN/m\"");
    contains(&text, "title = \"Other\"");
    assert!(text.starts_with("# A light line contact"), "{text}");
    write(&folder, "again.toml", &text);
    code(&ertel(&folder, "solve again.toml -q"), 0);
    let film = |name: &str| {
        let json: Value = serde_json::from_str(&read(&folder, name)).unwrap();
        assert_eq!(json["case"]["si"]["contact"]["load"], 3e4);
        json["summary"]["film_central"]["value"].as_f64().unwrap()
    };
    assert_eq!(
        film("results/quick/result.json"),
        film("results/again/result.json")
    );

    let output = ertel(&folder, "estimate quick.toml --set 'contact.load=40 kN/m'");
    code(&output, 0);
    contains(stdout(&output), "40 kN/m");
}

#[test]
fn wrong_values_name_the_option() {
    let folder = workplace();
    for (set, words) in [
        ("contact.load=-1 kN/m", "`load` must be positive"),
        ("contact.laod=1 kN/m", "did you mean `load`?"),
        ("contact.load", "has no value"),
    ] {
        for command in ["solve", "estimate"] {
            let error = stderr_of(
                ertel(&folder, &format!("{command} quick.toml --set '{set}'")),
                2,
            );
            contains(&error, words);
            contains(&error, "--> --set:1:");
        }
    }
    assert!(!folder.path().join("results").exists());
}

#[test]
fn a_study_takes_values_for_its_base_case() {
    let folder = workplace();
    let study = "case = \"quick.toml\"\n\n[[axis]]\nkey = \"contact.load\"\nvalues = [\"20 kN/m\", \"25 kN/m\"]\n";
    write(&folder, "study.toml", study);
    let set = "sweep study.toml -q --set 'motion.entrainment_speed=2 m/s'";
    code(&ertel(&folder, set), 0);
    let table = read(&folder, "results/study/results.csv");
    let column = |name: &str, line: usize| {
        let at = table
            .lines()
            .next()
            .unwrap()
            .split(',')
            .position(|title| title == name);
        table
            .lines()
            .nth(line)
            .unwrap()
            .split(',')
            .nth(at.unwrap())
            .unwrap()
            .to_owned()
    };
    assert_eq!(
        column("entrainment_speed_m_per_s", 1).parse(),
        Ok(2.0),
        "{table}"
    );
    let twice = "sweep study.toml --set 'contact.load=30 kN/m'";
    let output = ertel(&folder, twice);
    code(&output, 2);
    contains(stderr(&output), "`contact.load` varies in this study");

    let json = "sweep study.toml --json --set 'motion.entrainment_speed=3 m/s' -o other";
    let output = ertel(&folder, json);
    code(&output, 0);
    let events = events(&output);
    assert_eq!(names(&events, "point"), 2);
    let film = |i: usize| {
        let point = events
            .iter()
            .find(|e| e["event"] == "point" && e["point"] == i)
            .unwrap();
        assert_eq!(point["converged"], true);
        point["film_central"].as_f64().unwrap()
    };
    let slower: f64 = column("film_central_m", 1).parse().unwrap();
    assert!(
        film(1) > slower && film(2) > slower,
        "faster contacts have thicker films: {table}"
    );
    let result = events.iter().find(|e| e["event"] == "result").unwrap();
    assert_eq!(
        (&result["points"], &result["finished"]),
        (&2.into(), &2.into())
    );
}

#[test]
fn a_case_is_read_from_standard_input() {
    let folder = tempfile::tempdir().unwrap();
    let output = with_input(&folder, "solve - --check", QUICK);
    code(&output, 0);
    let output = with_input(&folder, "solve - -q", QUICK);
    code(&output, 0);
    assert_eq!(read(&folder, "results/stdin/case.toml"), QUICK);
    let wrong = QUICK.replace("10 mm", "10 N");
    let output = with_input(&folder, "estimate -", &wrong);
    code(&output, 2);
    contains(stderr(&output), "--> stdin:6:10");
    let output = with_input(&folder, "solve - -", QUICK);
    code(&output, 2);
}

/// One of three does not converge: the others are solved, and the code is its own.
#[test]
fn several_cases_have_separate_folders() {
    let folder = workplace();
    let hard = format!("{QUICK}\n[solver]\nmax_iterations = 1\ntolerance = 1e-11\n");
    write(&folder, "hard.toml", hard);
    write(&folder, "other.toml", QUICK.replace("20 kN/m", "30 kN/m"));
    let output = ertel(&folder, "solve quick.toml hard.toml other.toml -o out");
    code(&output, 3);
    for name in ["out/quick/result.json", "out/other/result.json"] {
        assert!(folder.path().join(name).is_file(), "{name}");
    }
    assert!(!folder.path().join("out/hard").exists());
    let summary = stdout(&output).rsplit("\n\n").next().unwrap();
    let lines: Vec<&str> = summary.lines().collect();
    assert!(lines[0].contains("outcome"), "{summary}");
    assert!(
        lines[1].contains("quick.toml")
            && lines[1].contains("solved")
            && lines[1].contains("central film"),
        "{summary}"
    );
    assert!(
        lines[2].contains("hard.toml") && lines[2].contains("not converged"),
        "{summary}"
    );
    assert!(
        lines[3].contains("other.toml") && lines[3].contains("solved"),
        "{summary}"
    );
    contains(stderr(&output), "1 of 3 cases did not succeed");
}

#[test]
fn several_cases_are_read_before_any_is_solved() {
    let folder = workplace();
    write(&folder, "bad.toml", QUICK.replace("10 mm", "10 N"));
    write(&folder, "worse.toml", "");
    let output = ertel(&folder, "solve quick.toml bad.toml worse.toml");
    code(&output, 2);
    for words in [
        "bad.toml:6:10",
        "the section [contact] is missing",
        "2 of 3 cases are bad; nothing was solved",
    ] {
        contains(stderr(&output), words);
    }
    assert!(!folder.path().join("results").exists());

    std::fs::create_dir(folder.path().join("b")).unwrap();
    write(&folder, "b/quick.toml", QUICK);
    let output = ertel(&folder, "solve quick.toml b/quick.toml");
    code(&output, 2);
    contains(stderr(&output), "into the same folder, results/quick");
    let output = ertel(&folder, "solve quick.toml bad.toml --monte-carlo 5");
    code(&output, 2);
}

/// Every line of stdout is one object.
fn events(output: &Output) -> Vec<Value> {
    let parse =
        |line| serde_json::from_str::<Value>(line).unwrap_or_else(|e| panic!("{line}: {e}"));
    let events: Vec<Value> = stdout(output).lines().map(parse).collect();
    let last = events.last().expect("a last event");
    assert_eq!(last["event"], "finished");
    assert_eq!(
        last["exit_code"].as_i64(),
        output.status.code().map(i64::from)
    );
    assert!(
        events
            .iter()
            .all(|e| e["event"].is_string() && e["seconds"].is_number())
    );
    events
}

fn names(events: &[Value], name: &str) -> usize {
    events.iter().filter(|e| e["event"] == name).count()
}

#[test]
fn a_solve_reports_its_events_to_programs() {
    let folder = workplace();
    let output = ertel(
        &folder,
        "solve quick.toml --json --set motion.slide_to_roll_ratio=2.5",
    );
    code(&output, 0);
    assert_eq!(stderr(&output), "");
    let events = events(&output);
    assert_eq!(events[0]["event"], "started");
    assert_eq!(events[0]["case"], "quick.toml");
    assert!(names(&events, "stage") > 0 && names(&events, "iteration") > 3);
    let warning = events.iter().find(|e| e["event"] == "warning").unwrap();
    assert_eq!(warning["kind"], "opposite-motion");
    let result = &events.iter().find(|e| e["event"] == "result").unwrap()["result"];
    let file: Value = serde_json::from_str(&read(&folder, "results/quick/result.json")).unwrap();
    assert_eq!(result["summary"], file["summary"]);
    assert_eq!(result["traction"], file["traction"]);
}

#[test]
fn a_curve_reports_its_points_to_programs() {
    let folder = workplace();
    let curve = "\n[curve]\nquantity = \"contact.load\"\nvalues = [\"20 kN/m\", \"25 kN/m\"]\n";
    write(&folder, "curve.toml", format!("{QUICK}{curve}"));
    let output = ertel(&folder, "solve curve.toml --json");
    code(&output, 0);
    let events = events(&output);
    assert_eq!(
        (names(&events, "point_started"), names(&events, "point")),
        (2, 2)
    );
    assert_eq!(events[0]["points"], 2);
    // Each as soon as it is solved.
    let of_points: Vec<&str> = (events.iter().filter_map(|e| e["event"].as_str()))
        .filter(|name| name.starts_with("point"))
        .collect();
    assert_eq!(
        of_points,
        ["point_started", "point", "point_started", "point"]
    );
    let point = events.iter().find(|e| e["event"] == "point").unwrap();
    assert!(
        point["summary"]["film_central"]["value"].as_f64() > Some(1e-8),
        "{point}"
    );
    assert!(
        point["wall_seconds"].as_f64() <= point["seconds"].as_f64(),
        "{point}"
    );
    // The terminal's table of a curve without sliding or heat has neither traction nor temperature; with both it has.
    let table = ertel(&folder, "solve curve.toml");
    assert!(
        !stdout(&table).contains("traction coefficient"),
        "{}",
        stdout(&table)
    );
    let table = ertel(
        &folder,
        "solve curve.toml --set motion.slide_to_roll_ratio=0.1",
    );
    contains(stdout(&table), "traction coefficient");
    assert!(
        !stdout(&table).contains("largest film temperature"),
        "{}",
        stdout(&table)
    );
}

#[test]
fn failures_are_reported_to_programs() {
    let folder = workplace();
    let output = ertel(&folder, "solve quick.toml --json --set 'contact.load=5 N'");
    code(&output, 2);
    let found = events(&output);
    assert_eq!(found[0]["event"], "failed");
    assert_eq!(
        (&found[0]["file"], &found[0]["key"]),
        (&"--set".into(), &"contact.load".into())
    );
    assert_eq!(found[0]["line"], 1);

    let output = ertel(&folder, "solve no.toml --json");
    code(&output, 2);
    assert_eq!(names(&events(&output), "failed"), 1);

    let hard = format!("{QUICK}\n[solver]\nmax_iterations = 1\ntolerance = 1e-11\n");
    write(&folder, "hard.toml", hard);
    let output = ertel(&folder, "solve hard.toml --json");
    code(&output, 3);
    let found = events(&output);
    let failed = found.iter().find(|e| e["event"] == "failed").unwrap();
    assert_eq!(failed["exit_code"], 3);
    contains(failed["message"].as_str().unwrap(), "converge");
    assert!(!folder.path().join("results/hard").exists());

    let output = ertel(&folder, "sweep no.toml --json");
    code(&output, 2);
    assert_eq!(names(&events(&output), "failed"), 1);
}

/// Half-width and pressure by hand: R 10 mm, w 20 kN/m, E' = 206 GPa/(1 - 0.3²) of two steels; p = √(w E'/(2πR)).
#[test]
fn a_check_says_what_it_checked() {
    let folder = workplace();
    let output = ertel(&folder, "solve --check quick.toml");
    code(&output, 0);
    for words in [
        "Steel roller on steel plane",
        "radius R                          10 mm",
        "load                              20 kN/m",
        "By formulas",
        "central film",
        "contacts to solve                 1\n",
        "estimated time                    1 s on one core (rough)",
        "results/quick",
        "quick.toml is valid (check only)",
    ] {
        contains(stdout(&output), words);
    }
    assert!(!folder.path().join("results").exists());
    assert_eq!(stdout(&ertel(&folder, "solve --check -q quick.toml")), "");
    let output = ertel(&folder, "solve --check --json quick.toml");
    let checked = &events(&output)[0];
    assert_eq!(checked["event"], "checked");
    assert_eq!(checked["points"], 1);
    assert!(checked["film_central"].as_f64().unwrap() > 1e-8);
}

#[test]
fn verbose_shows_files_and_meshes() {
    let folder = workplace();
    let output = ertel(&folder, "solve quick.toml -v");
    code(&output, 0);
    for words in [
        "read quick.toml",
        "Hertz pressure",
        "results will go to results/quick",
        "Newton  1: film ",
    ] {
        contains(stderr(&output), words);
    }
    for words in [
        "\nMeshes\n",
        "pressure unknowns of order",
        "\nFiles\n",
        "results/quick/result.json",
    ] {
        contains(stdout(&output), words);
    }
    code(&ertel(&folder, "solve quick.toml -v -q"), 2);
}

#[test]
fn colours_are_for_terminals() {
    let folder = workplace();
    let bad = "solve no.toml";
    let red = "\u{1b}[1m\u{1b}[31merror:\u{1b}[0m";
    let run = |arguments: &str, variable: Option<(&str, &str)>| {
        let mut command = command(&folder, arguments);
        command.envs(variable);
        stderr(&command.output().unwrap()).to_owned()
    };
    assert!(run(bad, None).starts_with("error: no.toml"));
    assert!(run("solve no.toml --color always", None).starts_with(red));
    assert!(run(bad, Some(("CLICOLOR_FORCE", "1"))).starts_with(red));
    assert!(run(bad, Some(("NO_COLOR", "1"))).starts_with("error:"));
    let never = "solve no.toml --color never";
    assert!(run(never, Some(("CLICOLOR_FORCE", "1"))).starts_with("error:"));
    // Control characters of a file are shown, not obeyed, in colour as well.
    write(&folder, "esc.toml", QUICK.replace("line", "\\u001b[2J"));
    let error = run("solve esc.toml --color always", None);
    contains(&error, "\\u001b[2J");
}

#[test]
fn init_writes_templates_that_pass_the_check() {
    let folder = tempfile::tempdir().unwrap();
    let list = with_input(&folder, "init", "");
    code(&list, 0);
    let names: Vec<&str> = (stdout(&list).lines().skip(1))
        .take_while(|line| !line.trim().is_empty())
        .map(|line| line.split_whitespace().next().unwrap())
        .collect();
    assert_eq!(
        names,
        [
            "bearing",
            "bearing-ball",
            "roller-bearing",
            "gear",
            "gear-contact",
            "helical-gear",
            "helical-gear-contact",
            "fzg",
            "cam",
            "cam-contact",
            "rig",
            "ball",
            "line",
            "roller"
        ]
    );
    for name in names {
        let file = format!("{name}.toml");
        code(&ertel(&folder, &format!("init {name} -o {file}")), 0);
        let printed = ertel(&folder, &format!("init {name}"));
        assert_eq!(stdout(&printed), read(&folder, &file));
        let check = ertel(&folder, &format!("solve --check {file}"));
        code(&check, 0);
        // Of an oil by its data sheet the program says that its viscosity under pressure is a correlation, of the bearing that its film is thin.
        let is_known = |line: &str| match name {
            "bearing" | "fzg" => {
                line.contains("viscosity law extrapolated")
                    || line.contains("times the roughness: mixed")
            }
            // A flat follower moves against the cam on a part of the turn.
            "cam" => {
                line.contains("viscosity law extrapolated")
                    || line.contains("in opposite directions")
            }
            _ => false,
        };
        let shown = stderr(&check);
        assert!(shown.lines().all(is_known), "{name}: {shown}");
    }
    let again = ertel(&folder, "init gear -o rig.toml");
    code(&again, 2);
    contains(stderr(&again), "will not overwrite rig.toml");
    assert!(read(&folder, "rig.toml").contains("ball-on-disc"));
    let unknown = ertel(&folder, "init geer");
    code(&unknown, 2);
    contains(
        stderr(&unknown),
        "one of: bearing, bearing-ball, roller-bearing, gear",
    );
}

#[test]
fn init_asks_and_checks_the_answers() {
    let folder = tempfile::tempdir().unwrap();
    let answers = "20 mm\n40 N\n3000 rpm\n2 m/s\n1.5 m/s\n\n\n\n\n\n\n\n\n";
    let output = with_input(&folder, "init rig --ask -o my.toml", answers);
    code(&output, 0);
    contains(stderr(&output), "u = π d n/60");
    let text = read(&folder, "my.toml");
    contains(&text, "ball_diameter = \"20 mm\"");
    contains(&text, "ball_speed = \"2 m/s\"");
    code(&ertel(&folder, "solve --check my.toml"), 0);
    let short = with_input(&folder, "init rig --ask -o short.toml", "20 mm\n");
    code(&short, 2);
    assert!(!folder.path().join("short.toml").exists());
}

#[test]
fn completions_and_manual_pages() {
    let folder = tempfile::tempdir().unwrap();
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let output = ertel(&folder, &format!("completions {shell}"));
        code(&output, 0);
        assert!(
            stdout(&output).contains("solve") && stdout(&output).contains("monte-carlo"),
            "{shell}"
        );
    }
    code(&ertel(&folder, "completions basic"), 2);
    let page = ertel(&folder, "man");
    code(&page, 0);
    contains(stdout(&page), ".SH SYNOPSIS");
    for _ in 0..2 {
        code(&ertel(&folder, "man -o man"), 0);
    }
    for name in [
        "ertel.1",
        "ertel-solve.1",
        "ertel-fit-viscosity.1",
        "ertel-init.1",
    ] {
        assert!(folder.path().join("man").join(name).is_file(), "{name}");
    }
    assert!(read(&folder, "man/ertel-solve.1").contains("monte\\-carlo"));
    write(&folder, "man/ertel-solve.1", "mine");
    code(&ertel(&folder, "man -o man"), 2);
    assert_eq!(read(&folder, "man/ertel-solve.1"), "mine");
}

/// Unusual values bring a question, and the published cases have none.
#[test]
fn published_cases_raise_no_questions() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut n_cases = 0;
    for entry in std::fs::read_dir(root.join("validation")).unwrap() {
        let folder = entry.unwrap().path();
        let Ok(entries) = std::fs::read_dir(&folder) else {
            continue;
        };
        for entry in entries {
            let path = entry.unwrap().path();
            let is_case =
                path.extension().is_some_and(|e| e == "toml") && !path.ends_with("reference.toml");
            if !is_case {
                continue;
            }
            let Ok(case) = ertel::case::Case::read(&path) else {
                continue;
            };
            n_cases += 1;
            let asked = case
                .warnings
                .iter()
                .find(|w| w.text.contains("far from the usual range"));
            assert_eq!(asked, None, "{}", path.display());
        }
    }
    assert!(n_cases > 30, "{n_cases}");
}
