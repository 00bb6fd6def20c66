//! Codes of warnings: `ertel explain`, and `silence` of a case.

use ertel::warning::WarningKind;
use serde_json::Value;
use tempfile::TempDir;

use crate::common::{
    code, contains, ertel, ertel_here, read, solve, stderr, stderr_of, stdout, write,
};

#[test]
fn codes_are_explained() {
    let list = ertel_here("explain");
    code(&list, 0);
    for kind in WarningKind::ALL {
        let is_it = |line: &&str| line.starts_with(&format!("  {kind} "));
        assert_eq!(stdout(&list).lines().filter(is_it).count(), 1, "{kind}");
    }
    // As a message shows it.
    for code in ["friction", "[friction]"] {
        let text = ertel_here(&format!("explain {code}"));
        for words in ["0.15", "Johnson", "shear_thinning", "not possible"] {
            contains(stdout(&text), words);
        }
    }
    let error = stderr_of(ertel_here("explain fricton"), 2);
    contains(&error, "the codes are unusual-input, ");
}

/// A line between oils of a data sheet, which always has the note on its law, with sliding beyond 2, which warns.
fn case(silence: &str) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let text = format!(
        "[contact]\nkind = \"line\"\nradius = \"10 mm\"\nload = \"100 kN/m\"\n\n[bodies]\nbody_1 = \"steel\"\nbody_2 = \"steel\"\n\n\
         [motion]\nentrainment_speed = \"1 m/s\"\nslide_to_roll_ratio = 2.5\n\n[lubricant]\ntemperature = \"60 degC\"\niso_vg = 46\nbase_oil = \"mineral\"\n\
         shear_thinning = {{ law = \"estimate\" }}\n\n[output]\npictures = []\n{silence}\n"
    );
    write(&folder, "case.toml", &text);
    folder
}

const BOTH: &str = "silence = [\"law-range\", \"opposite-motion\"]";

#[test]
fn silenced_warnings_are_not_shown_but_counted() {
    let folder = case("");
    let shown = stderr(&ertel(&folder, "solve case.toml --check")).to_owned();
    contains(&shown, "[law-range]");
    contains(&shown, "[opposite-motion]");
    let folder = case(BOTH);
    let output = ertel(&folder, "solve case.toml --check");
    code(&output, 0);
    let shown = stderr(&output);
    assert!(
        !shown.contains("law-range") && !shown.contains("opposite-motion"),
        "{shown}"
    );
    solve(
        &folder,
        "case.toml --output out --quiet --accept-unresolved",
    );
    let result: Value = serde_json::from_str(&read(&folder, "out/result.json")).unwrap();
    assert_eq!(result["silenced"]["law-range"], 1);
    assert_eq!(result["silenced"]["opposite-motion"], 1);
    let codes = result["warning_codes"].as_array().unwrap();
    assert_eq!(codes.len(), result["warnings"].as_array().unwrap().len());
    assert!(!codes.contains(&"opposite-motion".into()), "{codes:?}");
    let report = read(&folder, "out/report.txt");
    assert!(!report.contains("extrapolated above"), "{report}");
}

#[test]
fn unknown_codes_and_unusable_figures_are_refused() {
    for (code, words) in [
        ("law-rang", "the codes are unusual-input, "),
        ("friction", "cannot be silenced"),
    ] {
        let folder = case(&format!("silence = [\"{code}\"]"));
        let shown = stderr_of(ertel(&folder, "solve case.toml --check"), 2);
        contains(&shown, words);
        contains(&shown, "case.toml:22");
    }
}

/// The name of a case without its ending.
#[test]
fn a_case_without_ending_is_named() {
    let folder = case("");
    let error = stderr_of(ertel(&folder, "solve case --check"), 2);
    contains(&error, "did you mean case.toml?");
}
