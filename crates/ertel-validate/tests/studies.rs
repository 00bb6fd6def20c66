//! The quick runs of every validation study hold. `ertel validate` makes all of them.

use std::path::{Path, PathBuf};

use ertel::engine::NoObserver;
use ertel_validate::{self as validate, Selection, Verdict};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation")
}

fn holds(name: &str) {
    let study = validate::read(&folder().join(name)).unwrap();
    let result = study
        .run(Selection::Quick, &mut NoObserver, &mut |_| {})
        .unwrap();
    let n_compared = result
        .rows
        .iter()
        .filter(|r| r.verdict == Verdict::Holds)
        .count();
    assert!(n_compared > 0, "{name} compares nothing");
    assert!(result.holds(), "{}", validate::text(&study, &result));
}

macro_rules! studies {
    ($($test:ident: $name:literal),* $(,)?) => {
        $(#[test]
        fn $test() {
            holds($name);
        })*

        const STUDIES: &[&str] = &[$($name),*];
    };
}

studies! {
    ellipses_hamrock_dowson: "ellipses-hamrock-dowson",
    figure_3_10: "figure-3-10",
    figure_3_3: "figure-3-3",
    figure_3_8: "figure-3-8",
    figure_4_2: "figure-4-2",
    figure_5_2: "figure-5-2",
    figure_a_2: "figure-a-2",
    line_convergence: "line-convergence",
    line_moes: "line-moes",
    penalty_scaling: "penalty-scaling",
    regimes_circular: "regimes-circular",
    table_3_1: "table-3-1",
    table_3_4: "table-3-4",
}

/// Takes minutes only.
const SLOW: &[&str] = &[
    "figure-3-4",
    "figure-4-10",
    "figure-4-11",
    "figure-4-4",
    "figure-4-5",
    "figure-4-6",
    "figure-5-11",
    "figure-5-12",
    "figure-5-13",
    "figure-5-15",
    "figure-5-17",
    "figure-5-5",
    "figure-5-7",
    "figure-5-8",
    "figure-5-9",
    "figure-6-10",
    "figure-6-5",
    "heat-convergence",
    "mourier-cavity",
    "table-3-3",
    "venner-waves",
];

/// Whose effort is shown, not pinned: it is at the edge of what converges.
const UNPINNED: &[&str] = &["figure-3-3", "figure-3-4", "figure-4-2", "figure-5-2"];

#[test]
fn no_study_is_forgotten() {
    let mut known: Vec<&str> = STUDIES.iter().chain(SLOW).copied().collect();
    known.sort_unstable();
    assert_eq!(validate::names(&folder()).unwrap(), known);
    for name in known {
        let study = validate::read(&folder().join(name)).unwrap();
        assert!(folder().join(name).join("README.md").is_file(), "{name}");
        if UNPINNED.contains(&name) {
            continue;
        }
        for run in &study.runs {
            let solves = run.task == validate::Task::Solve;
            assert_eq!(
                run.newton_iterations.is_some(),
                solves,
                "{name}: {}: the iterations of a cold start are pinned",
                run.name
            );
        }
    }
}

/// A value that is off by more than its tolerance, and a pin that is off, are seen.
#[test]
fn a_wrong_value_is_seen() {
    let mut study = validate::read(&folder().join("line-moes")).unwrap();
    study.runs.truncate(1);
    study.checks.clear();
    let quick = |study: &validate::Study| {
        study
            .run(Selection::Quick, &mut NoObserver, &mut |_| {})
            .unwrap()
            .holds()
    };
    assert!(quick(&study));
    study.runs[0].newton_iterations = Some(1);
    assert!(!quick(&study));
}
