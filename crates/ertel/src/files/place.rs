//! Absolute path of a name given by the user, which need not exist yet.

use std::ffi::OsString;
use std::fs;
use std::io;
use std::path::{Component, Path, PathBuf};

/// Most links on the way, as many as Linux follows.
const MOST_LINKS: usize = 40;

/// The absolute path of a name, existing or not: links are followed, also those to nothing, `.` and
/// `..` are taken out. Two spellings of one place give one path.
///
/// # Errors
/// The system's reason, an empty path, and links that lead to each other.
pub fn place(path: &Path) -> io::Result<PathBuf> {
    let mut ahead = Vec::new();
    let mut place = PathBuf::new();
    lay_out(&std::path::absolute(path)?, &mut ahead, &mut place);
    let mut n_links = 0;
    while let Some(step) = ahead.pop() {
        if step == ".." {
            place.pop();
            continue;
        }
        let next = place.join(&step);
        match fs::read_link(&next) {
            Ok(to) => {
                n_links += 1;
                if n_links > MOST_LINKS {
                    return Err(io::Error::other("its links lead to each other"));
                }
                lay_out(&to, &mut ahead, &mut place);
            }
            // No link, or nothing there yet.
            Err(_) => place = next,
        }
    }
    Ok(as_the_system_spells(place))
}

/// Puts the steps of a path on those ahead, the first on top; an absolute path starts from the root.
fn lay_out(path: &Path, ahead: &mut Vec<OsString>, place: &mut PathBuf) {
    let mut root = PathBuf::new();
    let mut steps = Vec::new();
    for component in path.components() {
        match component {
            Component::Prefix(_) | Component::RootDir => root.push(component),
            Component::CurDir => {}
            Component::ParentDir => steps.push(OsString::from("..")),
            Component::Normal(name) => steps.push(name.to_owned()),
        }
    }
    if !root.as_os_str().is_empty() {
        *place = root;
    }
    ahead.extend(steps.into_iter().rev());
}

/// The same with the part that exists as the system has it: its own case of letters, long names.
fn as_the_system_spells(place: PathBuf) -> PathBuf {
    let existing = place
        .ancestors()
        .find_map(|a| Some((a, fs::canonicalize(a).ok()?)));
    match existing {
        Some((ancestor, known)) => match place.strip_prefix(ancestor) {
            Ok(rest) if rest.as_os_str().is_empty() => known,
            Ok(rest) => known.join(rest),
            Err(_) => place,
        },
        None => place,
    }
}

#[cfg(all(test, unix))]
mod tests {
    use std::os::unix::fs::symlink;

    use super::*;

    /// Every spelling of a folder that is not there yet leads to one path.
    #[test]
    fn spellings_of_one_place() {
        let folder = tempfile::tempdir().unwrap();
        let root = fs::canonicalize(folder.path()).unwrap();
        fs::create_dir_all(root.join("a/b")).unwrap();
        symlink("a", root.join("relative")).unwrap();
        symlink(root.join("a/b"), root.join("a/absolute")).unwrap();
        symlink("later/deep", root.join("to-nothing")).unwrap();
        symlink("to-nothing", root.join("chain")).unwrap();
        for (spelled, meant) in [
            ("a/new", "a/new"),
            ("./a/./new", "a/new"),
            ("not-there/../a/new", "a/new"),
            ("a/b/../new/", "a/new"),
            ("relative/new", "a/new"),
            // Up from where the link leads, not from where it is.
            ("a/absolute/../new", "a/new"),
            ("relative/b/../../a/absolute/x", "a/b/x"),
            ("to-nothing", "later/deep"),
            ("chain/x", "later/deep/x"),
        ] {
            assert_eq!(
                place(&root.join(spelled)).unwrap(),
                root.join(meant),
                "{spelled}"
            );
        }
        assert_eq!(place(Path::new("/..")).unwrap(), Path::new("/"));
        assert!(place(Path::new("")).is_err());
    }

    #[test]
    fn links_to_each_other_end() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        symlink("b", at("a")).unwrap();
        symlink("a", at("b")).unwrap();
        let error = place(&at("a/x")).unwrap_err();
        assert_eq!(error.to_string(), "its links lead to each other");
    }
}
