use std::fs::{self, File};
use std::path::Path;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use super::target::check_target;
use super::workplace::{Exchange, Workplace, clear, exchange};
use super::{FORMAT, OutputError};

/// Simulates a system without an atomic exchange.
const NO_EXCHANGE: Exchange = |_, _| Ok(false);

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let mut names: Vec<String> = entries
        .map(|e| e.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

fn fill(folder: &Path, note: &str) {
    fs::create_dir_all(folder).unwrap();
    let json = format!("{{\"format\": \"{FORMAT}\", \"note\": \"{note}\"}}");
    fs::write(folder.join("result.json"), json).unwrap();
    fs::write(folder.join("report.txt"), note).unwrap();
}

fn put(parent: &Path, note: &str, exchange: Exchange) -> Result<(), OutputError> {
    let workplace = Workplace::create_in(parent).unwrap();
    fill(&workplace.new_folder(), note);
    workplace.put(&parent.join("case"), parent, exchange)
}

fn note(parent: &Path) -> String {
    fs::read_to_string(parent.join("case/report.txt")).unwrap()
}

/// A continuous observer always finds a result, the former one or the new one.
#[cfg(any(target_os = "linux", target_vendor = "apple"))]
#[test]
fn a_result_exists_at_every_moment() {
    let place = tempfile::tempdir().unwrap();
    put(place.path(), "0", exchange).unwrap();
    let (is_over, n_looks) = (AtomicBool::new(false), AtomicUsize::new(0));
    let report = place.path().join("case/report.txt");
    let n_missing = std::thread::scope(|scope| {
        let look = || {
            let mut n_missing = 0;
            while !is_over.load(Ordering::Relaxed) {
                n_missing += usize::from(fs::metadata(&report).is_err());
                n_looks.fetch_add(1, Ordering::Relaxed);
            }
            n_missing
        };
        let watcher = scope.spawn(look);
        for i in 1..=500 {
            put(place.path(), &i.to_string(), exchange).unwrap();
        }
        is_over.store(true, Ordering::Relaxed);
        watcher.join().unwrap()
    });
    assert_eq!(n_missing, 0, "of {}", n_looks.load(Ordering::Relaxed));
    assert_eq!(note(place.path()), "500");
    assert_eq!(names(place.path()), ["case"]);
}

#[test]
fn results_are_replaced_without_exchange() {
    let place = tempfile::tempdir().unwrap();
    for note in ["old", "new"] {
        put(place.path(), note, NO_EXCHANGE).unwrap();
    }
    assert_eq!(note(place.path()), "new");
    assert_eq!(names(place.path()), ["case"]);
}

/// Files added to the former result at the last moment are not lost.
#[test]
fn foreign_files_restore_the_former_result() {
    for exchange in [exchange as Exchange, NO_EXCHANGE] {
        let place = tempfile::tempdir().unwrap();
        put(place.path(), "old", exchange).unwrap();
        fs::write(place.path().join("case/notes.txt"), "precious").unwrap();
        let error = put(place.path(), "new", exchange).unwrap_err();
        assert!(error.to_string().contains("notes.txt"), "{error}");
        assert_eq!(note(place.path()), "old");
        assert_eq!(names(place.path()), ["case"]);
    }
}

#[test]
fn remains_of_a_killed_run_are_cleared() {
    let place = tempfile::tempdir().unwrap();
    let parent = place.path();
    fill(&parent.join("case"), "new");
    // Killed while writing, and after the exchange.
    let left = parent.join(".ertel-abc123");
    fill(&left.join("new"), "old");
    File::create(left.join("lock")).unwrap();
    // Killed before locking its folder, and just before the end of its removal.
    fs::create_dir(parent.join(".ertel-empty")).unwrap();
    fs::create_dir(parent.join(".ertel-lock")).unwrap();
    File::create(parent.join(".ertel-lock/lock")).unwrap();
    // A running process, foreign files, and the remains of another program.
    let alive = Workplace::create_in(parent).unwrap();
    let mine = parent.join(".ertel-mine");
    fill(&mine.join("new"), "old");
    fs::write(mine.join("new/notes.txt"), "precious").unwrap();
    File::create(mine.join("lock")).unwrap();
    fs::create_dir(parent.join(".ertel-other")).unwrap();
    fs::write(parent.join(".ertel-other/file"), "").unwrap();
    fs::write(parent.join(".ertel-other/lock"), "").unwrap();
    clear(parent);
    assert!(alive.new_folder().exists() && !left.exists());
    drop(alive);
    assert_eq!(names(parent), [".ertel-mine", ".ertel-other", "case"]);
    assert_eq!(names(&parent.join(".ertel-other")), ["file", "lock"]);
    assert_eq!(note(parent), "new");
}

/// Killed between two renames, without atomic exchange.
#[test]
fn a_moved_former_result_is_restored() {
    let place = tempfile::tempdir().unwrap();
    let parent = place.path();
    let left = parent.join(".ertel-abc123");
    fill(&left.join("former/case"), "old");
    fill(&left.join("new"), "new");
    File::create(left.join("lock")).unwrap();
    clear(parent);
    assert_eq!(names(parent), ["case"]);
    assert_eq!(note(parent), "old");
    check_target(&parent.join("case")).unwrap();
}
