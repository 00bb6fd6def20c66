//! A closed or full stderr or stdout stops no work: results are written, and nothing panics.
#![cfg(target_os = "linux")]

use std::process::{Command, Stdio};

use tempfile::TempDir;

use crate::common::{copy, read, write};

/// Cases, a curve, studies and measurements.
fn workspace() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    copy("tests/good/quick.toml", &folder, "base.toml");
    let base = read(&folder, "base.toml");
    let curve = "[curve]\nquantity = \"contact.load\"\nvalues = [\"20 kN/m\", \"30 kN/m\"]\n";
    write(&folder, "curve.toml", &(base + curve));
    write(
        &folder,
        "study.toml",
        "case = \"base.toml\"\n[[axis]]\nkey = \"contact.load\"\nvalues = [\"20 kN/m\", \"30 kN/m\"]\n",
    );
    copy(
        "../../validation/appendix-c/fluid-a.csv",
        &folder,
        "mine.csv",
    );
    copy("tests/good/quick.toml", &folder, "studies/roller/case.toml");
    write(
        &folder,
        "studies/roller/reference.toml",
        "title = \"Roller\"\nsource = \"made up\"\n\n[[run]]\nname = \"roller\"\ncase = \"case.toml\"\nquick = true\n\n\
         [[check]]\nquantity = \"central-film\"\n",
    );
    write(&folder, "bad.toml", "[contact]\nkind = \"round\"\n");
    folder
}

/// Commands, what each writes, and its exit code when all is well.
const COMMANDS: [(&str, &str, i32); 8] = [
    ("solve base.toml -o case", "case/result.json", 0),
    ("solve curve.toml -o curve", "curve/curve.csv", 0),
    ("sweep study.toml -o study", "study/results.csv", 0),
    // Goes on, and says so.
    ("sweep study.toml -o study", "study/results.csv", 0),
    (
        "fit viscosity mine.csv --law barus -o entry.toml",
        "entry.toml",
        0,
    ),
    (
        "validate --folder studies --table all.csv --write docs",
        "docs/validation.md",
        0,
    ),
    ("solve bad.toml", "bad.toml", 2),
    ("fluids show squalane-pip --plot oil.svg", "oil.svg", 0),
];

fn run(redirection: &str, code_of_success: i32) {
    let folder = workspace();
    for (arguments, written, code) in COMMANDS {
        let output = Command::new("sh")
            .arg("-c")
            .arg(format!("exec \"$0\" {arguments} {redirection}"))
            .arg(env!("CARGO_BIN_EXE_ertel"))
            .current_dir(&folder)
            .output()
            .unwrap();
        let expected = match code {
            0 => code_of_success,
            code => code,
        };
        let message = String::from_utf8_lossy(&output.stderr);
        let what = format!("{arguments} {redirection}");
        assert_eq!(output.status.code(), Some(expected), "{what}: {message}");
        assert!(folder.path().join(written).exists(), "{what}");
        assert!(!message.contains("panicked"), "{what}: {message}");
    }
}

#[test]
fn a_full_stderr_stops_nothing() {
    run("2>/dev/full", 0);
}

/// The results are there, but not everything went well.
#[test]
fn a_full_stdout_is_reported_when_the_work_is_done() {
    run(">/dev/full", 1);
}

/// As `ertel solve case.toml 2>&1 | head -1` does.
#[test]
fn closed_pipes_stop_nothing() {
    let folder = workspace();
    for (arguments, written, code) in COMMANDS {
        let mut child = Command::new(env!("CARGO_BIN_EXE_ertel"))
            .args(arguments.split(' '))
            .current_dir(&folder)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        drop((child.stdout.take(), child.stderr.take()));
        assert_eq!(child.wait().unwrap().code(), Some(code), "{arguments}");
        assert!(folder.path().join(written).exists(), "{arguments}");
    }
}
