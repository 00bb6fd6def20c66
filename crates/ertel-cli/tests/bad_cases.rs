//! Every case of `tests/bad`, in `cases.txt` or in a separate file, must be refused with exit code 2, the file's name, and the words after `!`.

use std::path::Path;

use crate::bad::{BadCase, bad_cases};
use crate::common::{ertel, write};

#[test]
fn every_bad_case_is_refused_with_its_reason() {
    let mut cases = bad_cases(include_str!("bad/cases.txt"));
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/bad");
    for entry in std::fs::read_dir(&folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|extension| extension != "toml") {
            continue;
        }
        let text = std::fs::read_to_string(&path).unwrap();
        let expected = text.lines().filter_map(|line| line.strip_prefix("#! "));
        cases.push(BadCase {
            name: path.file_stem().unwrap().to_str().unwrap().to_owned(),
            expected: expected.map(str::to_owned).collect(),
            text,
        });
    }
    assert!(cases.len() > 200, "only {} bad cases found", cases.len());
    let folder = tempfile::tempdir().unwrap();
    let mut failures = Vec::new();
    for case in cases {
        let name = format!("{}.toml", case.name);
        write(&folder, &name, &case.text);
        let output = ertel(&folder, &format!("solve --check {name}"));
        let message = String::from_utf8(output.stderr).unwrap();
        if output.status.code() != Some(2) {
            failures.push(format!("{name}: {}\n{message}", output.status));
        }
        if case.expected.is_empty() {
            failures.push(format!("{name}: does not say what to expect"));
        }
        for words in case.expected.iter().chain([&name]) {
            if !message.contains(words) {
                failures.push(format!("{name}: `{words}` is not in\n{message}"));
            }
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
