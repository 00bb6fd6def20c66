//! Parts of a release: notices of the works of others, the hosted workflow, the list of changes.

use std::process::Command;

use crate::common::{code, contains, root, write};

fn notices() -> String {
    std::fs::read_to_string(root().join("THIRD_PARTY_NOTICES.txt")).unwrap()
}

/// Names and versions of what the crates of a package are made of, by cargo itself.
fn linked(package: &str) -> Vec<String> {
    let arguments = [
        "tree",
        "--offline",
        "--locked",
        "--package",
        package,
        "--edges",
        "normal",
        "--prefix",
        "none",
        "--format",
        "{p}",
    ];
    let output = Command::new(env!("CARGO"))
        .args(arguments)
        .current_dir(root())
        .output()
        .unwrap();
    code(&output, 0);
    let lines = String::from_utf8(output.stdout).unwrap();
    let crates = lines
        .lines()
        .filter(|line| !line.contains(" (/") && !line.is_empty());
    let mut crates: Vec<String> = crates
        .map(|line| {
            line.split_whitespace()
                .take(2)
                .collect::<Vec<_>>()
                .join(" ")
                .replacen(" v", " ", 1)
        })
        .collect();
    crates.sort();
    crates.dedup();
    crates
}

/// A crate that is linked and not named: run packaging/notices.py.
#[test]
fn every_crate_that_is_linked_is_named_with_its_licence() {
    let text = notices();
    let (names, texts) = text.split_once("====").unwrap();
    for package in ["ertel-cli", "ertel-py", "ertel-web"] {
        let crates = linked(package);
        assert!(crates.len() > 50, "{crates:?}");
        for name in crates {
            let named = names
                .lines()
                .find(|line| line.starts_with(&format!("{name} ")));
            let licence = named
                .and_then(|line| line.strip_prefix(&name))
                .unwrap_or_default();
            assert!(!licence.trim().is_empty(), "{package}: {name} is not named");
            let heads = texts.lines().filter(|line| line.starts_with("For: "));
            let has_text = |line: &str| line["For: ".len()..].split(", ").any(|own| own == name);
            assert!(heads.clone().any(has_text), "{name} has no text");
        }
    }
}

#[test]
fn what_is_no_crate_is_named_too() {
    let text = notices();
    for words in ["SIL OPEN FONT LICENSE", "uPlot"] {
        contains(&text, words);
    }
    // Nothing that is shipped is under the terms of the LGPL.
    assert!(!text.contains("GNU LESSER GENERAL PUBLIC LICENSE"));
}

/// Each script or manifest that makes a file of a release takes the notices with it.
#[test]
fn everything_that_is_shipped_has_them() {
    for (maker, line) in [
        (
            "packaging/build.sh",
            "cp \"$program\" THIRD_PARTY_NOTICES.txt",
        ),
        (
            "packaging/build.sh",
            "cp THIRD_PARTY_NOTICES.txt LICENSE-APACHE LICENSE-MIT \"$parts/ertel-$version-documentation/\"",
        ),
        (
            "crates/ertel-cli/Cargo.toml",
            "[\"../../THIRD_PARTY_NOTICES.txt\", \"usr/share/doc/ertel/\"",
        ),
        (
            "crates/ertel-web/build.sh",
            "page/* THIRD_PARTY_NOTICES.txt",
        ),
        (
            "crates/ertel-py/pyproject.toml",
            "\"THIRD_PARTY_NOTICES.txt\"",
        ),
    ] {
        let text = std::fs::read_to_string(root().join(maker)).unwrap();
        assert!(text.contains(line), "{maker}: {line}");
    }
    let of_the_wheel = root().join("crates/ertel-py/THIRD_PARTY_NOTICES.txt");
    assert_eq!(std::fs::read_to_string(of_the_wheel).unwrap(), notices());
}

/// The hosted checks are those of a developer's machine; a tag builds a release and tries it in empty places.
#[test]
fn the_hosted_workflow_runs_what_is_here() {
    let text = std::fs::read_to_string(root().join(".github/workflows/ci.yml")).unwrap();
    let (checks, release) = text.split_once("  release:\n").unwrap();
    assert!(checks.contains("- run: .ci/run\n") && checks.contains("tags: [\"v*\"]"));
    let steps: Vec<&str> = release
        .lines()
        .filter_map(|line| line.trim().strip_prefix("- run: "))
        .collect();
    assert_eq!(
        steps[..3],
        [
            "packaging/check-tag.sh \"$GITHUB_REF_NAME\"",
            "packaging/build.sh",
            "packaging/try.sh"
        ]
    );
    assert!(steps[3].starts_with("gh release create") && release.contains("needs: checks"));
    for script in [
        ".ci/run",
        "packaging/check-tag.sh",
        "packaging/build.sh",
        "packaging/try.sh",
    ] {
        let checked = Command::new("bash")
            .arg("-n")
            .arg(root().join(script))
            .status();
        assert!(checked.unwrap().success(), "{script}");
    }
}

/// A tag of another version, or a version without its date in the list of changes, stops before anything is built.
#[test]
fn a_release_has_its_version_and_its_date() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("packaging")).unwrap();
    let script = folder.path().join("packaging/check-tag.sh");
    std::fs::copy(root().join("packaging/check-tag.sh"), &script).unwrap();
    std::fs::copy(root().join("Cargo.toml"), folder.path().join("Cargo.toml")).unwrap();
    let version = env!("CARGO_PKG_VERSION");
    let check = |tag: &str, heading: &str| {
        let changes = format!("# Changelog\n\n{heading}\n\n## 0.0.1, 2026-01-01\n");
        write(&folder, "CHANGELOG.md", changes);
        let output = Command::new("bash").arg(&script).arg(tag).output().unwrap();
        let said = String::from_utf8([output.stdout, output.stderr].concat()).unwrap();
        (output.status.success(), said)
    };
    let tag = format!("v{version}");
    let (passes, said) = check(&tag, &format!("## {version}, 2026-11-27"));
    assert!(passes && said.contains("2026-11-27"), "{said}");
    for (tag, heading, words) in [
        (
            tag.as_str(),
            format!("## {version}, date to be set"),
            "date to be set",
        ),
        (&tag, "## 99.0.0, 2026-11-27".into(), "99.0.0"),
        ("v99.0.0", format!("## {version}, 2026-11-27"), "v99.0.0"),
    ] {
        let (passes, said) = check(tag, &heading);
        assert!(!passes && said.contains(words), "{tag}, {heading}: {said}");
    }
}

#[test]
fn changes_are_listed_by_version() {
    let text = std::fs::read_to_string(root().join("CHANGELOG.md")).unwrap();
    let first = text.lines().find(|line| line.starts_with("## ")).unwrap();
    assert!(
        first.starts_with(&format!("## {}, ", env!("CARGO_PKG_VERSION"))),
        "{first}"
    );
}
