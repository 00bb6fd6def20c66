//! Cases from the command line: a file or standard input, with values replaced by `--set`.

use std::io::{self, Read};
use std::path::{Path, PathBuf};

use ertel::case::Case;
use ertel_input::file::LARGEST_DOCUMENT;
use ertel_input::{Document, InputError};

use crate::failure::Failure;

/// The argument for standard input, and its name in messages and result folders.
const STDIN: (&str, &str) = ("-", "stdin");

/// A case, and where it comes from.
pub struct Given {
    /// The file, as messages name it; `stdin`.
    pub name: String,
    /// The file; `None` for standard input.
    pub path: Option<PathBuf>,
    /// Its content.
    pub case: Case,
}

impl Given {
    /// Reads a case; `settings` replace its values, `key=value`.
    ///
    /// # Errors
    ///
    /// A bad case, or standard input that cannot be read.
    pub fn read(path: &Path, settings: &[String]) -> Result<Self, Failure> {
        if path.as_os_str() == STDIN.0 {
            let text = stdin()?;
            let case = Case::from_text_with(STDIN.1, &text, Path::new(""), settings)?;
            return Ok(Self {
                name: STDIN.1.to_owned(),
                path: None,
                case,
            });
        }
        let document = Document::read(path).map_err(|error| with_ending(path, error))?;
        let folder = path.parent().unwrap_or(Path::new(""));
        let case = Case::from_text_with(document.file(), document.text(), folder, settings)?;
        Ok(Self {
            name: path.display().to_string(),
            path: Some(path.to_owned()),
            case,
        })
    }

    /// The name of the file without folder and ending.
    pub fn stem(&self) -> PathBuf {
        let stem = self.path.as_deref().and_then(Path::file_stem);
        stem.map_or_else(|| PathBuf::from(STDIN.1), PathBuf::from)
    }

    /// Every file that was read.
    pub fn files(&self) -> Vec<PathBuf> {
        let folder = self.path.as_deref().and_then(Path::parent);
        let mut files = self.case.files(folder.unwrap_or(Path::new("")));
        files.extend(self.path.clone());
        files
    }
}

/// Of a file that is not there and whose name lacks the ending: the one next to it that has it.
fn with_ending(path: &Path, error: InputError) -> InputError {
    let other = path.with_extension("toml");
    match path.extension().is_none() && !path.exists() && other.is_file() {
        true => error.with_help(format!("did you mean {}?", other.display())),
        false => error,
    }
}

fn stdin() -> Result<String, Failure> {
    let failed = |reason: String| Failure::Argument(format!("{} {reason}", STDIN.1));
    let mut bytes = Vec::new();
    (io::stdin()
        .lock()
        .take(LARGEST_DOCUMENT + 1)
        .read_to_end(&mut bytes))
    .map_err(|error| failed(format!("cannot be read: {error}")))?;
    if bytes.len() as u64 > LARGEST_DOCUMENT {
        return Err(failed(format!(
            "is too large: at most {LARGEST_DOCUMENT} bytes are read"
        )));
    }
    String::from_utf8(bytes).map_err(|_| failed("is not UTF-8 text".to_owned()))
}
