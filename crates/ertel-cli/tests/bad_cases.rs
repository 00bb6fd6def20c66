//! Every file in `tests/bad` must be refused with exit code 2, the file's name, and the words after `#!`.

use std::path::Path;
use std::process::Command;

#[test]
fn every_bad_case_is_refused_with_its_reason() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/bad");
    let mut n_cases = 0;
    let mut failures = Vec::new();
    for entry in std::fs::read_dir(&folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|extension| extension != "toml") {
            continue;
        }
        n_cases += 1;
        let name = path.file_name().unwrap().to_str().unwrap();
        let text = std::fs::read_to_string(&path).unwrap();
        let expected: Vec<&str> = text.lines().filter_map(|l| l.strip_prefix("#! ")).collect();
        let output = Command::new(env!("CARGO_BIN_EXE_ertel"))
            .args(["solve", "--check"])
            .arg(&path)
            .output()
            .unwrap();
        let message = String::from_utf8(output.stderr).unwrap();
        if output.status.code() != Some(2) {
            failures.push(format!("{name}: {}\n{message}", output.status));
        }
        if expected.is_empty() {
            failures.push(format!("{name}: says no `#!` line"));
        }
        for words in expected.iter().chain([&name]) {
            if !message.contains(words) {
                failures.push(format!("{name}: `{words}` is not in\n{message}"));
            }
        }
    }
    assert!(n_cases > 50, "only {n_cases} bad cases found");
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
