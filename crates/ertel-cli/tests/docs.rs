//! The documentation: every command of the guides that start from shipped files runs.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use crate::common::{ertel, root};

/// Pages whose commands are run, each in one folder from the first to the last.
const RUN: [&str; 12] = [
    "guide/tutorial.md",
    "guide/bearing.md",
    "guide/gear.md",
    "guide/cam.md",
    "guide/rig.md",
    "guide/time.md",
    "guide/own-oil.md",
    "guide/surfaces.md",
    "guide/refrigerant.md",
    "guide/pages.md",
    "gallery.md",
    "developer/debugging.md",
];

/// Results of a command that are no failure: a figure that the mesh does not resolve is written with a warning; and the
/// page on debugging shows a solve that does not converge.
const DONE: [i32; 2] = [0, 3];

/// Copies a folder of shipped files.
fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap() {
        let path = entry.unwrap().path();
        let target = to.join(path.file_name().unwrap());
        match path.is_dir() {
            true => copy(&path, &target),
            false => {
                fs::copy(&path, target).unwrap();
            }
        }
    }
}

#[test]
fn every_command_of_the_guides_runs() {
    let root = root();
    let folder = tempfile::tempdir().unwrap();
    copy(&root.join("cases"), &folder.path().join("cases"));
    copy(
        &root.join("validation/appendix-c"),
        &folder.path().join("validation/appendix-c"),
    );
    let mut done = BTreeSet::new();
    for page in RUN {
        let text = fs::read_to_string(root.join("docs").join(page)).unwrap();
        let commands: Vec<&str> = text
            .lines()
            .filter_map(|l| l.strip_prefix("    ertel "))
            .collect();
        assert!(!commands.is_empty(), "{page} has no command");
        for command in commands {
            // The gallery solves what the guides have solved.
            let same = command.split(" --output").next().unwrap().to_owned();
            if !done.insert(same) && page == "gallery.md" {
                continue;
            }
            let output = ertel(&folder, command);
            let code = output.status.code().unwrap();
            let errors = String::from_utf8_lossy(&output.stderr);
            assert!(
                DONE.contains(&code),
                "{page}: ertel {command}: {code}\n{errors}"
            );
        }
        crate::held::check(page, &text, folder.path());
    }
}

/// Commands of pages whose blocks of text show a part of what they print; of a long line its beginning.
const PRINTED: [(&str, &str); 3] = [
    ("guide/uncertainty.md", "ertel solve cases/roller.toml"),
    (
        "developer/debugging.md",
        "ertel solve cases/roller.toml --set solver.method=finite-elements --set solver.newtonian=true --set \"lubricant.viscosity.alpha=80 1/GPa\" --set \"contact.load=1 MN/m\" --verbose --output hard",
    ),
    (
        "developer/debugging.md",
        "ertel solve cases/roller.toml --set solver.method=finite-volumes --set solver.newtonian=true --set \"lubricant.viscosity.alpha=80 1/GPa\" --set \"contact.load=1 MN/m\" --verbose --output hard-volumes",
    ),
];

#[test]
fn what_the_docs_print_is_what_the_program_prints() {
    let root = root();
    for (page, command) in PRINTED {
        let text = fs::read_to_string(root.join("docs").join(page)).unwrap();
        let after = text.split_once(&format!("    {command}\n")).unwrap().1;
        // The text before the next command is printed by this one.
        let own = after.split("\n    ertel ").next().unwrap();
        let blocks = own.split("```text\n").skip(1);
        let shown: Vec<&str> = (blocks.map(|rest| rest.split_once("```").unwrap().0))
            .flat_map(str::lines)
            .collect();
        assert!(!shown.is_empty(), "{page} shows nothing of {command}");
        let folder = tempfile::tempdir().unwrap();
        copy(&root.join("cases"), &folder.path().join("cases"));
        let output = ertel(&folder, command.strip_prefix("ertel ").unwrap());
        let printed = [&output.stdout, &output.stderr].map(|text| String::from_utf8_lossy(text));
        let printed = printed.concat();
        for line in shown {
            assert!(
                printed
                    .lines()
                    .any(|l| says_the_same(l, line) || l.starts_with(line)),
                "{page} shows\n{line}\nwhich is not in\n{printed}"
            );
        }
    }
}

/// Whether two lines have the same words, and numbers that differ by no more than meshes do: 2 %, or 0.003.
fn says_the_same(one: &str, other: &str) -> bool {
    let [one, other] = [one, other].map(|line| line.split_whitespace().collect::<Vec<_>>());
    let number = |word: &str| word.trim_end_matches([',', ';']).parse::<f64>();
    let alike = |(a, b): (&&str, &&str)| match (number(a), number(b)) {
        (Ok(a), Ok(b)) => (a - b).abs() <= (0.02 * b.abs()).max(0.003),
        _ => a == b,
    };
    one.len() == other.len() && one.iter().zip(&other).all(alike)
}
