//! The user's cache of elastic operators, and `ertel cache`.

use std::path::PathBuf;

use ertel::operator_cache::OperatorCache;
use etcetera::BaseStrategy;

use crate::args::{CacheArgs, CacheCommand};
use crate::failure::Failure;
use crate::print;

/// Names the folder; empty: no cache.
const FOLDER: &str = "ERTEL_CACHE";
/// Limits its size.
const LIMIT: &str = "ERTEL_CACHE_LIMIT";
/// Unless limited otherwise: bytes.
const DEFAULT_LIMIT: u64 = 2_000_000_000;

/// The user's cache: `ERTEL_CACHE`, or `ertel` in the system's folder for caches; `None` when
/// switched off or when there is no such folder.
///
/// # Errors
/// A limit that is no size.
pub fn user_cache() -> Result<Option<OperatorCache>, Failure> {
    let limit = match std::env::var_os(LIMIT) {
        Some(text) => {
            let text = text.to_string_lossy();
            parse_size(&text).ok_or_else(|| {
                Failure::Argument(format!(
                    "{LIMIT}={text} is no size: write a number with kB, MB or GB, such as \"500 MB\""
                ))
            })?
        }
        None => DEFAULT_LIMIT,
    };
    let folder = match std::env::var_os(FOLDER) {
        Some(folder) if folder.is_empty() => None,
        Some(folder) => Some(PathBuf::from(folder)),
        None => etcetera::base_strategy::choose_native_strategy()
            .ok()
            .map(|strategy| strategy.cache_dir().join("ertel")),
    };
    Ok(folder.map(|folder| OperatorCache::new(folder, limit)))
}

/// Bytes of "2 GB", "500MB", "10 kB".
fn parse_size(text: &str) -> Option<u64> {
    let text = text.trim();
    let split = text.find(|c: char| c.is_alphabetic())?;
    let (number, unit) = text.split_at(split);
    let factor = match unit {
        "kB" => 1e3,
        "MB" => 1e6,
        "GB" => 1e9,
        _ => return None,
    };
    let number: f64 = number.trim().parse().ok()?;
    (number.is_finite() && number >= 0.0).then_some((number * factor) as u64)
}

/// Runs the command.
///
/// # Errors
/// A folder that cannot be read or files that cannot be removed.
pub fn run(arguments: &CacheArgs) -> Result<(), Failure> {
    let Some(cache) = user_cache()? else {
        return print::stdout("no cache is in use\n");
    };
    let megabytes = |bytes: u64| format!("{:.1} MB", bytes as f64 / 1e6);
    let failed = |error| Failure::Other(format!("cache {}: {error}", cache.folder().display()));
    match arguments.command {
        CacheCommand::Show => {
            let usage = cache.usage().map_err(failed)?;
            print::stdout(&format!(
                "{}\n{} elastic operators, {} of at most {}\n{}",
                cache.folder().display(),
                usage.n_files,
                megabytes(usage.bytes),
                megabytes(cache.limit()),
                foreign(usage.n_foreign)
            ))
        }
        CacheCommand::Clear => {
            let usage = cache.clear().map_err(failed)?;
            print::stdout(&format!(
                "{}\n{} elastic operators removed, {}\n{}",
                cache.folder().display(),
                usage.n_files,
                megabytes(usage.bytes),
                foreign(usage.n_foreign)
            ))
        }
    }
}

/// What is said of files that are not ertel's, or too damaged to be told from such.
fn foreign(n: usize) -> String {
    match n {
        0 => String::new(),
        1 => "1 file *.operator does not begin as those of ertel do and stays\n".to_owned(),
        n => format!("{n} files *.operator do not begin as those of ertel do and stay\n"),
    }
}

#[cfg(test)]
mod tests {
    use super::parse_size;

    #[test]
    fn sizes() {
        assert_eq!(parse_size("2 GB"), Some(2_000_000_000));
        assert_eq!(parse_size("0.5MB"), Some(500_000));
        assert_eq!(parse_size("0 kB"), Some(0));
        for bad in ["", "2", "GB", "-1 GB", "2 gb", "nan GB"] {
            assert_eq!(parse_size(bad), None, "{bad}");
        }
    }
}
