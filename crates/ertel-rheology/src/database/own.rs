//! Files of the user: by their path, or by their name in a folder of own data.
//!
//! ```text
//! my-data/fluids/my-oil.toml     lubricant = "my-oil"
//! my-data/solids/my-steel.toml   body_2 = "my-steel"
//! ```
//!
//! The folder is set once, by the program that reads cases, before it reads any.

use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use super::DatabaseError;
use crate::Files;
use ertel_input::Document;
use ertel_input::file::{LARGEST_DOCUMENT, read_text};

/// Fluids and solids of the user.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct OwnData {
    /// The folder.
    pub folder: PathBuf,
    /// Names in its folder `fluids`, in alphabetical order.
    pub fluids: Vec<String>,
    /// Names in its folder `solids`.
    pub solids: Vec<String>,
}

static OWN: OnceLock<OwnData> = OnceLock::new();

/// Makes names refer to the files of a folder, too: `NAME` for `fluids/NAME.toml` or `solids/NAME.toml`. A name that the
/// database has, too, is that of the file. Returns what was found.
///
/// # Errors
///
/// [`DatabaseError::Folder`]: no folder, one that cannot be read, one without `fluids` and `solids`, and a second one.
pub fn use_own_data(folder: &Path) -> Result<&'static OwnData, DatabaseError> {
    let failed = |reason: String| DatabaseError::Folder {
        path: folder.display().to_string(),
        reason,
    };
    let found = OwnData {
        folder: folder.to_owned(),
        fluids: names(&folder.join("fluids"))
            .map_err(|e| failed(format!("cannot be read: fluids: {e}")))?,
        solids: names(&folder.join("solids"))
            .map_err(|e| failed(format!("cannot be read: solids: {e}")))?,
    };
    if !folder.is_dir() {
        return Err(failed("is not a readable folder".to_owned()));
    }
    if !folder.join("fluids").is_dir() && !folder.join("solids").is_dir() {
        let reason = "has neither a folder `fluids` nor `solids`; own data are fluids/NAME.toml and solids/NAME.toml in it";
        return Err(failed(reason.to_owned()));
    }
    let set = OWN.get_or_init(|| found.clone());
    match *set == found {
        true => Ok(set),
        false => Err(failed(format!(
            "was given after {}; only one folder of own data is allowed",
            set.folder.display()
        ))),
    }
}

/// The folder of own data and its contents, if there is one.
pub fn own_data() -> Option<&'static OwnData> {
    OWN.get()
}

/// Names of the TOML files in a folder; none where there is no folder.
fn names(folder: &Path) -> std::io::Result<Vec<String>> {
    if !folder.exists() {
        return Ok(Vec::new());
    }
    let mut names = Vec::new();
    for entry in std::fs::read_dir(folder)? {
        // A case, which is text, cannot name any other file.
        let Ok(name) = entry?.file_name().into_string() else {
            continue;
        };
        if let Some(stem) = name
            .strip_suffix(".toml")
            .filter(|stem| !stem.is_empty() && !stem.starts_with('.'))
        {
            names.push(stem.to_owned());
        }
    }
    names.sort_unstable();
    Ok(names)
}

/// Which kind of data.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Lubricants.
    Fluid,
    /// Materials.
    Solid,
}

/// The file of the user that a name stands for: itself if it ends with `.toml`, then in the folder of a case, else one of the own
/// data; `None` of a name of the database.
pub fn own_path(kind: Kind, name: &str, folder: &Path) -> Option<PathBuf> {
    if is_file(name) {
        return Some(folder.join(name));
    }
    let own = own_data()?;
    let (names, within) = match kind {
        Kind::Fluid => (&own.fluids, "fluids"),
        Kind::Solid => (&own.solids, "solids"),
    };
    let is_there = names.iter().any(|own| own == name);
    is_there.then(|| own.folder.join(within).join(format!("{name}.toml")))
}

/// A file of the user.
pub(super) struct OwnFile {
    path: PathBuf,
    pub document: Document,
}

impl OwnFile {
    pub fn read(path: PathBuf) -> Result<Self, DatabaseError> {
        let text = read_text(&path, LARGEST_DOCUMENT).map_err(|error| DatabaseError::File {
            path: path.display().to_string(),
            reason: error.to_string(),
        })?;
        let document = Document::parse(path.display().to_string(), text)?;
        Ok(Self { path, document })
    }

    pub fn files(&self) -> Files<'_> {
        Files::Folder(self.path.parent().unwrap_or(Path::new("")))
    }
}

/// Whether a name is that of a file of the user.
pub fn is_file(name: &str) -> bool {
    name.ends_with(".toml")
}
