//! Elastic responses kept on disk: the same mesh and Poisson's ratio need no second factorisation.
//!
//! One file per response, named by the hash of all that determines it. Files are written beside
//! their place and renamed, so that processes may share a folder; one that cannot be read for any
//! reason is built anew. The files longest unused go when the folder grows beyond its limit.

use std::fs::{self, File};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, SystemTime};

use bytemuck::{cast_slice, cast_slice_mut};
use ertel_fem::linear::compliance::Compliance;
use ertel_input::file::open;
use xxhash_rust::xxh3::Xxh3;

use crate::elastic::CondensedResponse;
use crate::elastic::store::{Operator, OperatorStore};

/// Raised whenever the content or the meaning of a file changes, or the numbers in it would.
const VERSION: u32 = 3;
const MAGIC: [u8; 8] = *b"ertel-op";
const EXTENSION: &str = "operator";
const TEMPORARY: &str = ".writing-";
/// Magic, version, reserved; key; checksum of the rest; nodes, near pairs, displacements, reserved.
const HEADER: usize = 80;
/// Age at which the remains of an interrupted process are removed.
const STALE: Duration = Duration::from_secs(3600);

/// Folder of elastic responses.
#[derive(Clone, Debug)]
pub struct OperatorCache {
    folder: PathBuf,
    limit: u64,
    warnings: Arc<Mutex<Vec<String>>>,
}

/// What a cache holds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CacheUsage {
    /// Files.
    pub n_files: usize,
    /// Their size, bytes.
    pub bytes: u64,
    /// Files named like operators that do not begin as those do: they are somebody else's, and stay.
    pub n_foreign: usize,
}

/// Identity of a response: mesh, element order, Poisson's ratio.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OperatorKey(u128);

impl OperatorKey {
    /// Hash of all that the response depends on, bit by bit.
    pub fn new(operator: &Operator<'_>) -> OperatorKey {
        let (body, elastic_order) = (operator.body, operator.elastic_order);
        let mut hash = Xxh3::new();
        let p = body.params();
        hash.update(&VERSION.to_ne_bytes());
        hash.update(cast_slice(&[body.mesh.dim, elastic_order]));
        let geometry = [p.x_inlet, p.x_outlet, p.y_side, p.width, p.depth];
        hash.update(cast_slice(&geometry));
        hash.update(cast_slice(&[operator.poissons_ratio]));
        hash.update(cast_slice(&[
            body.mesh.vertices.len(),
            body.mesh.cells.len(),
        ]));
        hash.update(cast_slice(&body.mesh.vertices));
        hash.update(cast_slice(&body.mesh.cells));
        OperatorKey(hash.digest128())
    }
}

/// Why a file is of no use.
#[derive(Debug, thiserror::Error)]
enum Unusable {
    #[error(transparent)]
    Io(#[from] io::Error),
    #[error("{0}")]
    Content(&'static str),
}

impl OperatorCache {
    /// Cache in a folder, made when first needed, of at most `limit` bytes.
    pub fn new(folder: impl Into<PathBuf>, limit: u64) -> OperatorCache {
        OperatorCache {
            folder: folder.into(),
            limit,
            warnings: Arc::default(),
        }
    }

    /// Where it is.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Its size limit, bytes.
    pub fn limit(&self) -> u64 {
        self.limit
    }

    fn warn(&self, text: String) {
        let mut warnings = self.warnings.lock().unwrap_or_else(PoisonError::into_inner);
        if !warnings.contains(&text) {
            warnings.push(text);
        }
    }

    fn path(&self, key: OperatorKey) -> PathBuf {
        self.folder.join(format!("{:032x}.{EXTENSION}", key.0))
    }

    fn write(
        &self,
        key: OperatorKey,
        response: &CondensedResponse,
        n_displacement: usize,
    ) -> io::Result<()> {
        fs::create_dir_all(&self.folder)?;
        let n = response.compliance.n();
        let tiles = response.compliance.tiles();
        let sizes = [
            n as u64,
            response.near.len() as u64,
            n_displacement as u64,
            0,
        ];
        let mut header = Vec::with_capacity(HEADER);
        header.extend_from_slice(&MAGIC);
        header.extend_from_slice(&VERSION.to_ne_bytes());
        header.extend_from_slice(&[0; 4]);
        header.extend_from_slice(&key.0.to_ne_bytes());
        header.extend_from_slice(&checksum(&sizes, tiles, &response.near).to_ne_bytes());
        header.extend_from_slice(cast_slice(&sizes));
        let mut file = tempfile::Builder::new()
            .prefix(TEMPORARY)
            .tempfile_in(&self.folder)?;
        file.write_all(&header)?;
        file.write_all(cast_slice(tiles))?;
        file.write_all(cast_slice(&response.near))?;
        file.persist(self.path(key)).map_err(|e| e.error)?;
        Ok(())
    }

    /// Removes the files longest unused until the rest fits, `newest` last.
    fn evict(&self, newest: &Path) {
        let Ok((mut files, _)) = self.files() else {
            return;
        };
        files.sort_by_key(|f| (f.path == newest, f.used));
        let mut total: u64 = files.iter().map(|f| f.bytes).sum();
        for file in files {
            if total <= self.limit {
                break;
            }
            // Another process may have been quicker.
            let _ = fs::remove_file(&file.path);
            total -= file.bytes;
        }
    }

    /// The files of the cache, and how many others have such names; removes what interrupted processes left.
    fn files(&self) -> io::Result<(Vec<CacheFile>, usize)> {
        let entries = match fs::read_dir(&self.folder) {
            Ok(entries) => entries,
            Err(e) if e.kind() == io::ErrorKind::NotFound => return Ok((Vec::new(), 0)),
            Err(e) => return Err(e),
        };
        let mut files = Vec::new();
        let mut n_foreign = 0;
        for path in entries.filter_map(|e| e.ok().map(|e| e.path())) {
            let Ok(metadata) = fs::symlink_metadata(&path) else {
                continue;
            };
            let used = metadata.modified().unwrap_or(SystemTime::UNIX_EPOCH);
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            if name.starts_with(TEMPORARY) {
                if metadata.is_file() && used.elapsed().is_ok_and(|age| age > STALE) {
                    let _ = fs::remove_file(&path);
                }
            } else if path.extension().is_some_and(|e| e == EXTENSION) {
                if metadata.is_file() && begins_as_ours(&path) {
                    files.push(CacheFile {
                        bytes: metadata.len(),
                        used,
                        path,
                    });
                } else {
                    n_foreign += 1;
                }
            }
        }
        Ok((files, n_foreign))
    }

    /// What the cache holds.
    ///
    /// # Errors
    /// When the folder cannot be read; one that does not exist is empty.
    pub fn usage(&self) -> io::Result<CacheUsage> {
        let (files, n_foreign) = self.files()?;
        Ok(CacheUsage {
            n_files: files.len(),
            bytes: files.iter().map(|f| f.bytes).sum(),
            n_foreign,
        })
    }

    /// Removes all operators, and nothing else; returns what there was.
    ///
    /// # Errors
    /// When the folder cannot be read or a file cannot be removed.
    pub fn clear(&self) -> io::Result<CacheUsage> {
        let usage = self.usage()?;
        for file in self.files()?.0 {
            fs::remove_file(file.path)?;
        }
        Ok(usage)
    }
}

impl OperatorStore for OperatorCache {
    fn get(&self, operator: &Operator<'_>) -> Option<(CondensedResponse, usize)> {
        let key = OperatorKey::new(operator);
        let path = self.path(key);
        match read(&path, key, operator.n, operator.n_near) {
            Ok(found) => {
                // The time of last use decides what goes first; it does not matter if this fails.
                if let Ok(file) = File::options().append(true).open(&path) {
                    let _ = file.set_modified(SystemTime::now());
                }
                Some(found)
            }
            Err(Unusable::Io(e)) if e.kind() == io::ErrorKind::NotFound => None,
            Err(e) => {
                self.warn(format!(
                    "the elastic operator in {} cannot be used ({e}) and is built anew",
                    path.display()
                ));
                None
            }
        }
    }

    fn put(&self, operator: &Operator<'_>, response: &CondensedResponse, n_displacement: usize) {
        let key = OperatorKey::new(operator);
        let n = response.compliance.n();
        let size = file_size(n, response.near.len());
        if size > self.limit {
            return;
        }
        if let Err(e) = self.write(key, response, n_displacement) {
            self.warn(format!(
                "elastic operators cannot be kept in {}: {e}",
                self.folder.display()
            ));
        }
        self.evict(&self.path(key));
    }

    fn take_warnings(&self) -> Vec<String> {
        std::mem::take(&mut self.warnings.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

struct CacheFile {
    path: PathBuf,
    bytes: u64,
    used: SystemTime,
}

/// Whether a file begins as every file of a cache does, of this format or another one. One that cannot be read is left alone.
fn begins_as_ours(path: &Path) -> bool {
    let mut start = [0; MAGIC.len()];
    open(path, u64::MAX).is_ok_and(|(mut file, _)| file.read_exact(&mut start).is_ok())
        && start == MAGIC
}

/// Bytes of a response of `n` surface nodes and `n_near` near pairs.
fn file_size(n: usize, n_near: usize) -> u64 {
    (HEADER + 8 * (Compliance::n_stored(n) + n_near)) as u64
}

fn checksum(sizes: &[u64; 4], tiles: &[f64], near: &[f64]) -> u128 {
    let mut hash = Xxh3::new();
    hash.update(cast_slice(sizes));
    hash.update(cast_slice(tiles));
    hash.update(cast_slice(near));
    hash.digest128()
}

fn read(
    path: &Path,
    key: OperatorKey,
    n: usize,
    n_near: usize,
) -> Result<(CondensedResponse, usize), Unusable> {
    let (mut file, metadata) = open(path, u64::MAX).map_err(io::Error::from)?;
    let mut header = [0u8; HEADER];
    file.read_exact(&mut header)
        .map_err(|_| Unusable::Content("it is cut short"))?;
    let (identity, rest) = header.split_at(32);
    if identity[..8] != MAGIC {
        return Err(Unusable::Content("it is no operator of ertel"));
    }
    if identity[8..12] != VERSION.to_ne_bytes() {
        return Err(Unusable::Content("it has another format"));
    }
    if identity[16..32] != key.0.to_ne_bytes() {
        return Err(Unusable::Content("it is another contact's"));
    }
    let (sum, sizes) = rest.split_at(16);
    let mut stored = [0u64; 4];
    cast_slice_mut::<u64, u8>(&mut stored).copy_from_slice(sizes);
    if stored[0] != n as u64 || stored[1] != n_near as u64 {
        return Err(Unusable::Content("its size is wrong"));
    }
    if metadata.len() != file_size(n, n_near) {
        return Err(Unusable::Content("it is cut short"));
    }
    // Straight into the memory where they stay.
    let mut tiles = vec![0f64; Compliance::n_stored(n)];
    file.read_exact(cast_slice_mut(&mut tiles))?;
    let mut near = vec![0f64; n_near];
    file.read_exact(cast_slice_mut(&mut near))?;
    if sum != checksum(&stored, &tiles, &near).to_ne_bytes() {
        return Err(Unusable::Content("its checksum is wrong"));
    }
    let compliance = Compliance::from_tiles(n, tiles);
    Ok((CondensedResponse { compliance, near }, stored[2] as usize))
}
