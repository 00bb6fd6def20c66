//! Files of the cache of elastic operators: a damaged one is never taken for a good one.

use std::fs;
use std::io;
use std::path::Path;
use std::sync::OnceLock;

use ertel::elastic::CondensedResponse;
use ertel::elastic::store::{Operator, OperatorStore};
use ertel::operator_cache::OperatorCache;
use ertel_fem::linear::compliance::Compliance;
use ertel_fem::mesh::{BodyMesh, BodyParams, body_mesh};

use super::Verdict;
use crate::finding::Defect;
use crate::input::{Input, Target};

/// Surface nodes and near pairs of the response, and its displacement unknowns.
const NODES: usize = 40;
const PAIRS: usize = 25;
const DISPLACEMENTS: usize = 123;
const LIMIT: u64 = 1_000_000;

/// The body of the response.
fn body() -> Option<&'static BodyMesh> {
    static BODY: OnceLock<Option<BodyMesh>> = OnceLock::new();
    let body = BODY.get_or_init(|| {
        let params = BodyParams {
            dim: 2,
            x_inlet: -4.5,
            x_outlet: 1.5,
            y_side: 0.0,
            width: 20.0,
            depth: 20.0,
        };
        body_mesh(&params, &|_| 2.0).ok()
    });
    body.as_ref()
}

/// What is kept of it.
fn operator() -> Option<Operator<'static>> {
    Some(Operator {
        body: body()?,
        elastic_order: 2,
        poissons_ratio: 0.3,
        n: NODES,
        n_near: PAIRS,
    })
}

fn response() -> CondensedResponse {
    let tiles = (0..Compliance::n_stored(NODES))
        .map(|i| 1.0 / (1.0 + i as f64))
        .collect();
    CondensedResponse {
        compliance: Compliance::from_tiles(NODES, tiles),
        near: (0..PAIRS).map(|i| i as f64).collect(),
    }
}

fn file_name(folder: &Path) -> Option<std::path::PathBuf> {
    let entries = fs::read_dir(folder)
        .ok()?
        .filter_map(|e| Some(e.ok()?.path()));
    entries
        .into_iter()
        .find(|path| path.extension().is_some_and(|e| e == "operator"))
}

/// The good file.
///
/// # Errors
/// Folders and files that cannot be written.
pub fn seed() -> io::Result<Input> {
    let folder = tempfile::tempdir()?;
    let cache = OperatorCache::new(folder.path(), LIMIT);
    let operator = operator().ok_or_else(|| io::Error::other("the body has no mesh"))?;
    cache.put(&operator, &response(), DISPLACEMENTS);
    let path = file_name(folder.path()).ok_or_else(|| io::Error::other("no operator was kept"))?;
    let files = vec![(Target::Operator.main_file().to_owned(), fs::read(path)?)];
    Ok(Input {
        target: Target::Operator,
        files,
    })
}

/// Puts the damaged file in the place of the good one and asks the cache for it; shows and clears the cache.
pub fn run(input: &Input, folder: &Path) -> Result<Verdict, Defect> {
    let failed = |error: io::Error| Defect::wrong("the cache fails", error.to_string());
    let place = folder.join("cache");
    let cache = OperatorCache::new(&place, LIMIT);
    let operator = operator().ok_or_else(|| Defect::wrong("the cache fails", "no mesh"))?;
    cache.put(&operator, &response(), DISPLACEMENTS);
    let path = file_name(&place).ok_or_else(|| Defect::wrong("the cache fails", "no file"))?;
    let content = input.file(Target::Operator.main_file());
    fs::write(&path, content).map_err(failed)?;
    let verdict = match cache.get(&operator) {
        Some((found, n)) => {
            let good = response();
            let is_same =
                found.compliance.tiles() == good.compliance.tiles() && found.near == good.near;
            if !is_same || n != DISPLACEMENTS {
                return Err(Defect::wrong(
                    "a damaged operator is taken",
                    path.display().to_string(),
                ));
            }
            Verdict::Taken
        }
        None if cache.take_warnings().is_empty() => {
            return Err(Defect::wrong("a damaged operator without a word", ""));
        }
        None => Verdict::Refused,
    };
    let usage = cache.clear().map_err(failed)?;
    if usage.n_files + usage.n_foreign != 1 || path.exists() != (usage.n_foreign == 1) {
        return Err(Defect::wrong("clearing miscounts", format!("{usage:?}")));
    }
    fs::remove_dir_all(place).map_err(failed)?;
    Ok(verdict)
}
