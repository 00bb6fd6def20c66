//! Commands do not overwrite the files that they read.

use std::fs;
use std::path::{Path, PathBuf};

use ertel::files::place;

use crate::failure::Failure;

/// Refuses files to be written that are among those being read, whatever their names; `what` is how messages call an
/// output, such as `--output`.
///
/// # Errors
///
/// [`Failure::Argument`] that names both.
pub fn keep(inputs: &[PathBuf], outputs: &[(&str, &Path)]) -> Result<(), Failure> {
    for (what, output) in outputs {
        if let Some(input) = inputs.iter().find(|input| is_same(input, output)) {
            return Err(Failure::Argument(format!(
                "{what} {} would overwrite {}, which this command reads; choose another place",
                output.display(),
                input.display()
            )));
        }
    }
    Ok(())
}

/// Refuses a folder to be replaced that holds a file being read.
///
/// # Errors
///
/// [`Failure::Argument`] that names both.
pub fn keep_within(inputs: &[PathBuf], folder: &Path) -> Result<(), Failure> {
    let Ok(place) = fs::canonicalize(folder) else {
        return Ok(()); // Nothing there yet.
    };
    let within = |input: &&PathBuf| fs::canonicalize(input).is_ok_and(|p| p.starts_with(&place));
    match inputs.iter().find(within) {
        Some(input) => Err(Failure::Argument(format!(
            "will not replace the folder {}: it holds {}, which this command reads. Choose another folder with --output",
            folder.display(),
            input.display()
        ))),
        None => Ok(()),
    }
}

/// Refuses files that exist already, which somebody may have written or changed by hand, unless `force` is set.
///
/// # Errors
///
/// [`Failure::Argument`] that names the file.
pub fn refuse_existing(outputs: &[&Path], force: bool) -> Result<(), Failure> {
    let exists = |path: &&&Path| path.symlink_metadata().is_ok();
    match outputs.iter().find(exists) {
        Some(path) if !force => Err(Failure::Argument(format!(
            "will not overwrite {}; choose another name, or add --force",
            path.display()
        ))),
        _ => Ok(()),
    }
}

/// Whether two files to be written would be one.
pub fn is_one_place(a: &Path, b: &Path) -> bool {
    let both = |a: &Place, b: &Place| a.is_within(b) && b.is_within(a);
    a == b || is_same(a, b) || with_places(a, b, both).unwrap_or(false)
}

/// Whether of two folders to be written one would be the other or lie within it, however they are spelled and whatever of them exists
/// already.
pub fn overlap(a: &Path, b: &Path) -> bool {
    let either = |a: &Place, b: &Place| a.is_within(b) || b.is_within(a);
    a.starts_with(b) || b.starts_with(a) || with_places(a, b, either).unwrap_or(false)
}

fn with_places(a: &Path, b: &Path, found: impl Fn(&Place, &Place) -> bool) -> Option<bool> {
    Some(found(&Place::of(a)?, &Place::of(b)?))
}

/// Target of a path: its existing part, and the part to be made.
struct Place {
    existing: PathBuf,
    ahead: PathBuf,
}

impl Place {
    fn of(path: &Path) -> Option<Self> {
        let place = place(path).ok()?;
        let existing = place.ancestors().find(|a| a.exists())?.to_owned();
        let ahead = place.strip_prefix(&existing).ok()?.to_owned();
        Some(Self { existing, ahead })
    }

    /// Whether it is the other or lies within it.
    fn is_within(&self, other: &Self) -> bool {
        if other.ahead.as_os_str().is_empty() {
            let mut ancestors = self.existing.ancestors();
            return ancestors.any(|a| is_same_place(a, &other.existing));
        }
        is_same_place(&self.existing, &other.existing)
            && begins_with(&self.ahead, &other.ahead, || ignores_case(&self.existing))
    }
}

/// Whether a path begins with another, where names may differ in case alone if the file system takes these for one.
fn begins_with(path: &Path, start: &Path, ignores_case: impl Fn() -> bool) -> bool {
    let lower = |path: &Path| PathBuf::from(path.to_string_lossy().to_lowercase());
    path.starts_with(start) || (lower(path).starts_with(lower(start)) && ignores_case())
}

/// Whether two existing folders are the same, also through a second mount.
fn is_same_place(a: &Path, b: &Path) -> bool {
    a == b || (a.is_dir() && b.is_dir() && same_file::is_same_file(a, b).unwrap_or(false))
}

/// Whether a folder ignores the case of names; tested with a name in it, else with that of the folder.
fn ignores_case(folder: &Path) -> bool {
    let swapped = |path: &Path| {
        let name = path.file_name()?.to_str()?;
        let other: String = name
            .chars()
            .map(|c| match c {
                c if c.is_ascii_lowercase() => c.to_ascii_uppercase(),
                c => c.to_ascii_lowercase(),
            })
            .collect();
        (other != name).then(|| path.with_file_name(other))
    };
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let names = entries.map(|entry| entry.path()).chain([folder.to_owned()]);
    let mut pairs = names.filter_map(|path| Some((swapped(&path)?, path)));
    pairs.next().is_some_and(|(other, path)| {
        is_same(&other, &path) || (other.is_dir() && is_same_place(&other, &path))
    })
}

/// Whether two names are those of one file: links of both kinds count.
fn is_same(a: &Path, b: &Path) -> bool {
    // Opening a pipe could wait for ever.
    let is_file = |path: &Path| fs::metadata(path).is_ok_and(|m| m.is_file());
    is_file(a) && is_file(b) && same_file::is_same_file(a, b).unwrap_or(false)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folders_within_each_other_overlap() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        fs::create_dir(at("there")).unwrap();
        for (a, b) in [
            ("new", "new"),
            ("new", "./new"),
            ("new/x", "new"),
            ("new/x", "new/y/../x"),
            ("new/x", "./not-there/../new/./x/deep"),
            ("there", "there/x"),
            ("there/../there/x", "there"),
        ] {
            assert!(overlap(&at(a), &at(b)), "{a}, {b}");
            assert!(overlap(&at(b), &at(a)), "{b}, {a}");
        }
        for (a, b) in [
            ("new", "news"),
            ("new/x", "new/y"),
            ("there/x", "new/x"),
            ("there/x", "x"),
        ] {
            assert!(!overlap(&at(a), &at(b)), "{a}, {b}");
        }
        assert!(is_one_place(
            &at("there/a.svg"),
            &at("there/../there/a.svg")
        ));
        assert!(!is_one_place(&at("there/a.svg"), &at("there")));
    }

    #[test]
    fn case_counts_where_the_file_system_says_so() {
        let [a, b] = ["Results/A", "results"].map(Path::new);
        assert!(begins_with(a, b, || true));
        assert!(!begins_with(a, b, || false));
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("name"), "").unwrap();
        let is_one = folder.path().join("NAME").exists();
        assert_eq!(ignores_case(folder.path()), is_one);
        assert_eq!(
            overlap(&folder.path().join("x"), &folder.path().join("X")),
            is_one
        );
    }
}
