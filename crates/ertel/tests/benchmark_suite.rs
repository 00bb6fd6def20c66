//! The benchmark suite: its values agree with each other, and with the program.

use std::fs;
use std::path::{Path, PathBuf};

use crate::common::solved;
use crate::common::text::read;

fn suite() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../benchmark-suite")
}

/// A row of `values.csv`: case, figure, and value and error of both methods.
fn values() -> Vec<(String, String, [f64; 4])> {
    let text = fs::read_to_string(suite().join("values.csv")).unwrap();
    let row = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        let numbers = [3, 4, 5, 6].map(|i: usize| cells[i].parse().unwrap());
        (cells[0].to_owned(), cells[1].to_owned(), numbers)
    };
    text.lines().skip(1).map(row).collect()
}

/// The difference of both methods lies within their error bars together.
#[test]
fn both_methods_agree() {
    let values = values();
    for (case, figure, [volumes, error, elements, other_error]) in &values {
        let apart = (volumes - elements).abs();
        assert!(
            apart <= error + other_error,
            "{case} {figure}: {volumes} {elements}"
        );
    }
    let paper = fs::read_to_string(suite().join("../docs/paper/paper.md")).unwrap();
    let sentence = format!("All {} differences lie within the error bars", values.len());
    assert!(paper.contains(&sentence), "{sentence}");
    for entry in fs::read_dir(suite().join("cases")).unwrap() {
        let name = entry
            .unwrap()
            .path()
            .file_stem()
            .unwrap()
            .to_str()
            .unwrap()
            .to_owned();
        let films = values
            .iter()
            .filter(|(case, figure, _)| *case == name && figure.starts_with("film_"));
        assert!(films.count() >= 2, "{name}");
    }
}

/// Solutions on default grids differ from the values by no more than both bars.
#[test]
fn default_grids_agree_with_the_values() {
    let values = values();
    for name in ["line", "circle", "circle-soft"] {
        let path = suite().join("cases").join(name).with_extension("toml");
        let solution = solved(&read(fs::read_to_string(path).unwrap()));
        for (_, figure, [value, bar, ..]) in values.iter().filter(|(case, ..)| case == name) {
            let mut found = solution.figures();
            let (_, found) = found.find(|(of, _)| of.name() == figure).unwrap();
            let apart = (found.value - value).abs();
            let most = bar + found.error.unwrap();
            assert!(apart <= most, "{name} {figure}: {found:?}, not {value}");
        }
    }
}
