//! `ertel validate` end to end: table, page and exit codes.

use std::path::{Path, PathBuf};
use std::process::Output;

use crate::common::{code, contains, ertel_here, stderr_of, text};

fn validate(folder: &Path, arguments: &str) -> Output {
    ertel_here(&format!(
        "validate {arguments} --folder {}",
        folder.display()
    ))
}

fn studies() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation")
}

/// A folder with one study of one coarse line contact whose film is checked against `value`.
fn study(value: f64) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("roller");
    std::fs::create_dir(&path).unwrap();
    let case = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/good/quick.toml");
    std::fs::copy(case, path.join("case.toml")).unwrap();
    let reference = format!(
        "title = \"Roller\"\nsource = \"a made-up value\"\n\n\
         [[run]]\nname = \"roller\"\ncase = \"case.toml\"\nquick = true\n\n\
         [[check]]\nquantity = \"central-film\"\nvalue = {value}\ntolerance = \"1 %\"\nreason = \"none\"\n"
    );
    std::fs::write(path.join("reference.toml"), reference).unwrap();
    folder
}

#[test]
fn a_comparison_that_does_not_hold_exits_with_1() {
    let folder = study(1.0);
    let table = folder.path().join("all.csv");
    let output = validate(folder.path(), &format!("--table {}", table.display()));
    code(&output, 1);
    let all = (text(&output.stdout).lines())
        .find(|l| l.trim_start().starts_with("all "))
        .unwrap();
    let counts: Vec<&str> = all.split_whitespace().collect();
    assert_eq!(counts[1..4], ["1", "0", "1"]);
    let table = std::fs::read_to_string(table).unwrap();
    let row: Vec<&str> = table.lines().nth(1).unwrap().split(',').collect();
    assert_eq!((row[0], row[3], row[7]), ("roller", "1.0000", "NOT"));
    contains(text(&output.stdout), "NOT");
    contains(text(&output.stderr), "do not hold in: roller");
}

#[test]
fn a_study_that_holds_exits_with_0_and_makes_a_page() {
    let docs = tempfile::tempdir().unwrap();
    let docs = docs.path().join("docs");
    let output = validate(
        &studies(),
        &format!("penalty-scaling --quick --write {}", docs.display()),
    );
    code(&output, 0);
    let table = text(&output.stdout);
    contains(table, "film 1e4, normal");
    assert!(
        !table.contains("h^2 1e2, fine"),
        "a slow run is made: {table}"
    );
    let page = std::fs::read_to_string(docs.join("validation.md")).unwrap();
    assert!(page.contains("](validation/penalty-scaling-outlet.svg)"));
    assert!(docs.join("validation/penalty-scaling-outlet.svg").is_file());
}

/// With names, `--write` leaves the sections of other studies as they are; without, it writes the whole page.
#[test]
fn writing_one_study_keeps_the_sections_of_others() {
    let folder = study(1.0);
    let [first, second] = ["roller", "second"].map(|name| folder.path().join(name));
    std::fs::create_dir(&second).unwrap();
    for file in ["case.toml", "reference.toml"] {
        std::fs::copy(first.join(file), second.join(file)).unwrap();
    }
    let docs = folder.path().join("docs");
    let page = docs.join("validation.md");
    let written = |names: &str| {
        validate(
            folder.path(),
            &format!("{names} --write {}", docs.display()),
        );
        std::fs::read_to_string(&page).unwrap()
    };
    let whole = written("");
    let marked = whole.replace("made-up value", "value by hand");
    assert_eq!(marked.matches("by hand").count(), 2);
    std::fs::write(&page, &marked).unwrap();
    let spliced = written("roller");
    let (roller, second) = spliced.split_once("[validation/second]").unwrap();
    assert!(roller.contains("Source: a made-up value. Cases and remarks: [validation/roller]"));
    assert!(
        roller.ends_with("Source: a value by hand. Cases and remarks: ") && second.contains("H_c")
    );
    assert_eq!(spliced.lines().count(), whole.lines().count());
    assert_eq!(written(""), whole);
}

#[test]
fn unknown_studies_and_bad_references_exit_with_2() {
    let error = stderr_of(validate(&studies(), "table-9-9"), 2);
    assert!(error.contains("table-3-4"), "lists them");
    code(&validate(Path::new("no/such/folder"), ""), 2);
    let folder = study(1.0);
    let path = folder.path().join("roller/reference.toml");
    let reference = std::fs::read_to_string(&path).unwrap();
    for (good, bad) in [
        ("central-film", "centre-film"),
        ("case.toml", "no-case.toml"),
        ("reason = \"none\"", ""),
        ("value = 1", "values = 1"),
        ("value = 1\n", ""),
        ("quick = true", "quick = true\nmoes = [1.0]"),
        ("reason", "runs = [\"ball\"]\nreason"),
    ] {
        std::fs::write(&path, reference.replace(good, bad)).unwrap();
        let output = validate(folder.path(), "");
        assert_eq!(output.status.code(), Some(2), "{bad}");
        assert!(text(&output.stderr).contains("reference.toml") || bad == "no-case.toml");
    }
}

/// The stated effort is brought up to the taken one and shown; all else in the file stays as it is, and the next run changes nothing.
#[test]
fn stated_efforts_are_updated() {
    let folder = study(1.0);
    let path = folder.path().join("roller/reference.toml");
    let before = std::fs::read_to_string(&path).unwrap();
    let before = before.replace(
        "quick = true\n",
        "quick = true\nnewton_iterations =  3000 # of the coarse mesh\n",
    );
    std::fs::write(&path, &before).unwrap();
    let output = validate(folder.path(), "--update");
    let shown = text(&output.stdout);
    contains(shown, "- newton_iterations = 3000\n+ newton_iterations = ");
    let after = std::fs::read_to_string(&path).unwrap();
    let line = |text: &str| {
        let line = text
            .lines()
            .find(|l| l.starts_with("newton_iterations"))
            .unwrap();
        line.to_owned()
    };
    let taken: usize = line(&after)
        .trim_start_matches("newton_iterations =  ")
        .trim_end_matches(" # of the coarse mesh")
        .parse()
        .unwrap();
    assert!((2..100).contains(&taken), "{taken}");
    assert_eq!(
        after.replace(&line(&after), ""),
        before.replace(&line(&before), "")
    );
    let again = validate(folder.path(), "--update");
    assert!(!text(&again.stdout).contains("+ newton_iterations"));
    assert_eq!(std::fs::read_to_string(&path).unwrap(), after);
}
