//! Elastic operators kept on disk: the same results, bit by bit, whatever befalls the files.

use crate::common;

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

use ertel::case::Case;
use ertel::contact::ContactKind;
use ertel::operator_cache::OperatorCache;
use ertel::params::ElasticModel;
use ertel::run::{Session, solve};
use ertel::solution::Solution;
use ertel::solve::Silent;

/// Changes a file, given another one.
type Damage = fn(&mut Vec<u8>, &[u8]);

const LARGE: u64 = 1_000_000_000;

/// A circular contact on a mesh that takes a moment, at the Poisson's ratio of both bodies.
fn small_case() -> Case {
    let mut case = common::case(ContactKind::Circular, 10.0);
    case.plane.elasticity = common::GLASS;
    case.solver.elasticity = Some(ElasticModel::Equivalent);
    case.mesh.hertz_size = 0.4;
    case.mesh.constriction_size = 0.3;
    case.mesh.edge_size = 1.0;
    case.mesh.pressure_order = 2;
    case.solver.error_estimate = false;
    case
}

fn solve_with(folder: &Path, limit: u64, case: &Case) -> Solution {
    let session = Session {
        cache: Some(OperatorCache::new(folder, limit)),
    };
    session.solve(case, &mut Silent).unwrap()
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap();
    let mut files: Vec<PathBuf> = entries.map(|e| e.unwrap().path()).collect();
    files.sort();
    files
}

fn cached(s: &Solution) -> Vec<bool> {
    s.stats.levels.iter().map(|l| l.operator_cached).collect()
}

fn assert_same(a: &Solution, b: &Solution) {
    assert_eq!(a.surface, b.surface);
    assert_eq!(a.history, b.history);
    assert_eq!(a.summary, b.summary);
}

fn mentions(s: &Solution, words: &str) -> bool {
    s.warnings.iter().any(|w| w.contains(words))
}

/// Without, cold and warm: the same bits; another load on the same mesh finds it, another Poisson's
/// ratio does not. The displacement of the body needs no operator at hand.
#[test]
fn a_hit_gives_the_same_bits() {
    let folder = tempfile::tempdir().unwrap();
    let mut case = small_case();
    let without = solve(&case, &mut Silent).unwrap();
    let cold = solve_with(folder.path(), LARGE, &case);
    let warm = solve_with(folder.path(), LARGE, &case);
    assert_same(&without, &cold);
    assert_same(&without, &warm);
    assert!(!cached(&cold).contains(&true) && !cached(&warm).contains(&false));
    assert_eq!(
        cold.stats.levels[0].n_displacement_dofs,
        warm.stats.levels[0].n_displacement_dofs
    );
    assert!(warm.warnings == without.warnings);
    assert_eq!(files(folder.path()).len(), 2);

    case.output.body_field = true;
    let body = solve_with(folder.path(), LARGE, &case).body;
    assert_eq!(body, solve(&case, &mut Silent).unwrap().body);
    case.contact.load *= 1.001;
    assert!(
        cached(&solve_with(folder.path(), LARGE, &case))
            .iter()
            .all(|c| *c)
    );
    case.plane.elasticity.poissons_ratio = 0.35;
    assert!(!cached(&solve_with(folder.path(), LARGE, &case)).contains(&true));
    assert_eq!(files(folder.path()).len(), 4);
}

/// A file cut short, with one bit turned, of another format, of another contact, or not ours at all:
/// a warning, the same result, and a good file after it.
#[test]
fn damaged_files_are_built_anew() {
    let folder = tempfile::tempdir().unwrap();
    let case = small_case();
    let good = solve_with(folder.path(), LARGE, &case);
    let paths = files(folder.path());
    let damages: [(&str, Damage); 6] = [
        ("cut short", |b, _| b.truncate(b.len() - 1)),
        ("cut short", |b, _| b.truncate(17)),
        ("checksum", |b, _| {
            let middle = b.len() / 2;
            b[middle] ^= 1;
        }),
        ("format", |b, _| b[8] ^= 0xff),
        ("another contact", |b, other| *b = other.to_vec()),
        ("no operator", |b, _| *b = vec![b'x'; 4000]),
    ];
    for (words, damage) in damages {
        let mut bytes = fs::read(&paths[0]).unwrap();
        damage(&mut bytes, &fs::read(&paths[1]).unwrap());
        fs::write(&paths[0], bytes).unwrap();
        let again = solve_with(folder.path(), LARGE, &case);
        assert_same(&good, &again);
        assert!(mentions(&again, words), "{words}: {:?}", again.warnings);
        let mended = solve_with(folder.path(), LARGE, &case);
        assert!(!cached(&mended).contains(&false));
        assert_eq!(mended.warnings, good.warnings);
    }
}

/// A folder that cannot be made: a warning, and the solve goes on.
#[test]
fn a_folder_that_cannot_be_written_is_a_warning() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("file");
    fs::write(&file, "").unwrap();
    let case = small_case();
    let s = solve_with(&file.join("cache"), LARGE, &case);
    assert!(mentions(&s, "cannot be kept"), "{:?}", s.warnings);
    assert_same(&s, &solve(&case, &mut Silent).unwrap());
}

/// The least recently used goes first; what alone exceeds the limit is not kept.
#[test]
fn the_size_limit_holds() {
    let folder = tempfile::tempdir().unwrap();
    let mut case = small_case();
    solve_with(folder.path(), LARGE, &case);
    let first = files(folder.path());
    let total: u64 = first.iter().map(|f| f.metadata().unwrap().len()).sum();
    // Both unused for long, then one is used.
    for (k, path) in first.iter().enumerate() {
        let file = fs::File::options().append(true).open(path).unwrap();
        let age = Duration::from_secs(1000 + k as u64);
        file.set_modified(SystemTime::now() - age).unwrap();
    }
    solve_with(folder.path(), LARGE, &case);
    let used = |p: &PathBuf| p.metadata().unwrap().modified().unwrap();
    assert!(
        first
            .iter()
            .all(|p| used(p).elapsed().unwrap().as_secs() < 500)
    );
    case.plane.elasticity.poissons_ratio = 0.35;
    solve_with(folder.path(), total, &case);
    let left = files(folder.path());
    assert_eq!(left.len(), 2);
    assert!(left.iter().all(|p| !first.contains(p)));
    let cache = OperatorCache::new(folder.path(), total);
    assert!(cache.usage().unwrap().bytes <= total);
    assert_eq!(cache.clear().unwrap().n_files, 2);
    solve_with(folder.path(), 1000, &case);
    assert!(files(folder.path()).is_empty());
}

/// Many solves on one empty folder at once: none fails, none sees a half-written file.
#[test]
fn solves_at_once_share_a_folder() {
    let folder = tempfile::tempdir().unwrap();
    let case = small_case();
    let alone = solve(&case, &mut Silent).unwrap();
    std::thread::scope(|scope| {
        let solves: Vec<_> = (0..4)
            .map(|_| scope.spawn(|| solve_with(folder.path(), LARGE, &case)))
            .collect();
        for solve in solves {
            let s = solve.join().unwrap();
            assert_eq!(s.summary, alone.summary);
            assert_eq!(s.warnings, alone.warnings);
        }
    });
    assert_eq!(files(folder.path()).len(), 2);
}
