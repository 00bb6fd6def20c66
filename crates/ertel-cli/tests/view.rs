//! `ertel view`: which files it shows, and which it refuses to write.

use crate::common::{code, ertel};
use std::fs;
use std::process::Output;

fn error(output: &Output) -> (i32, String) {
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    (output.status.code().unwrap(), text)
}

#[test]
fn results_are_shown_and_files_of_users_kept() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let case = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/roller.toml");
    for name in ["one", "two"] {
        let output = ertel(folder, &format!("solve {case} -o {name} --quiet"));
        code(&output, 0);
    }
    let page = fs::read_to_string(folder.join("one/report.html")).unwrap();
    assert!(page.len() < 2_000_000);

    let single = ertel(folder, "view one --no-browser");
    assert_eq!(
        String::from_utf8_lossy(&single.stdout).trim(),
        "one/report.html"
    );
    let both = "view one two/report.html --no-browser -o both.html";
    code(&ertel(folder, both), 0);
    let joint = fs::read_to_string(folder.join("both.html")).unwrap();
    assert!(joint.contains("Comparison of results"));
    // A page of ertel is replaced.
    code(&ertel(folder, both), 0);

    fs::write(folder.join("mine.html"), "<p>mine</p>").unwrap();
    fs::create_dir(folder.join("empty")).unwrap();
    for (arguments, expected) in [
        ("view one -o mine.html", "is no page of ertel"),
        (
            "view one -o one/report.html",
            "one of the pages to be shown",
        ),
        ("view one -o empty", "it is a folder"),
        ("view empty", "empty/report.html: no such file"),
        ("view nothere", "nothere: no such result folder"),
        ("view nowhere", "nowhere"),
        ("view mine.html", "not a result page"),
        ("view", "RESULT"),
    ] {
        let (code, text) = error(&ertel(folder, &format!("{arguments} --no-browser")));
        assert_eq!(code, 2, "{arguments:?}: {text}");
        assert!(text.contains(expected), "{arguments:?}: {text}");
    }
    assert_eq!(
        fs::read_to_string(folder.join("mine.html")).unwrap(),
        "<p>mine</p>"
    );
    assert_eq!(
        fs::read_to_string(folder.join("one/report.html")).unwrap(),
        page
    );
}
