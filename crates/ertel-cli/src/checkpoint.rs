//! The file that a run in time keeps to go on from.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use ertel::case::Case;
use ertel::run::checkpoint::{Checkpoint, MAGIC};
use ertel_quantity::Dimension;

use crate::args::SolveArgs;
use crate::failure::Failure;

/// A file beside the results, where there is to be one.
#[derive(Default)]
pub struct Checkpoints {
    kept: Option<Kept>,
}

struct Kept {
    path: PathBuf,
    interval: Duration,
    last: Instant,
    /// Why it could not be written.
    failure: Option<String>,
}

/// How often it is written where a run that goes on does not say.
const USUAL: Duration = Duration::from_secs(600);

impl Checkpoints {
    /// The file for the results in a folder, and what is to be gone on from.
    pub fn open(
        case: &Case,
        folder: &Path,
        arguments: &SolveArgs,
    ) -> Result<(Checkpoints, Option<Checkpoint>), Failure> {
        let interval = arguments.checkpoint.as_deref().map(interval).transpose()?;
        if interval.is_none() && !arguments.resume {
            return Ok((Checkpoints::default(), None));
        }
        let mut name = folder.file_name().unwrap_or_default().to_owned();
        name.push(".checkpoint");
        let path = folder.with_file_name(name);
        let shown = path.display();
        let from = match (std::fs::read(&path), arguments.resume) {
            (Ok(bytes), true) => {
                let wrong = |error| Failure::Argument(format!("{shown}: {error}"));
                Some(Checkpoint::from_bytes(&bytes, case).map_err(wrong)?)
            }
            (Err(error), true) => {
                return Err(Failure::Argument(format!(
                    "{shown}: {error}\n  = help: --resume goes on from where a run with --checkpoint stopped"
                )));
            }
            (Ok(bytes), false) => {
                let help = match bytes.starts_with(MAGIC) {
                    true => {
                        "a run that stopped has left it: go on from there with --resume, or delete it"
                    }
                    false => "it is no checkpoint: give the results another folder by --output",
                };
                return Err(Failure::Argument(format!(
                    "{shown} is there already\n  = help: {help}"
                )));
            }
            (Err(_), false) => None,
        };
        let kept = Kept {
            path,
            interval: interval.unwrap_or(USUAL),
            last: Instant::now(),
            failure: None,
        };
        Ok((Checkpoints { kept: Some(kept) }, from))
    }

    /// Whether it is time to write it.
    pub fn is_due(&self) -> bool {
        (self.kept.as_ref()).is_some_and(|kept| kept.last.elapsed() >= kept.interval)
    }

    /// Writes it; returns why it could not be, where it could before.
    pub fn write(&mut self, checkpoint: &Checkpoint) -> Option<String> {
        let kept = self.kept.as_mut()?;
        let failure = replace(&kept.path, &checkpoint.to_bytes())
            .err()
            .map(|error| format!("{}: {error}", kept.path.display()));
        let is_known = kept.failure.is_some();
        kept.failure.clone_from(&failure);
        kept.last = Instant::now();
        failure.filter(|_| !is_known)
    }

    /// Ends with the run: without the file where it came to its end.
    pub fn close(self, is_complete: bool) -> Result<(), Failure> {
        let Some(kept) = self.kept else { return Ok(()) };
        if is_complete {
            // It may never have been written.
            let _ = std::fs::remove_file(&kept.path);
            return Ok(());
        }
        kept.failure
            .map_or(Ok(()), |text| Err(Failure::Other(text)))
    }
}

/// A file as a whole, or as it was before.
fn replace(path: &Path, bytes: &[u8]) -> std::io::Result<()> {
    let folder = path
        .parent()
        .filter(|folder| !folder.as_os_str().is_empty());
    let folder = folder.unwrap_or(Path::new("."));
    std::fs::create_dir_all(folder)?;
    let mut file = tempfile::NamedTempFile::new_in(folder)?;
    file.write_all(bytes)?;
    file.as_file().sync_all()?;
    file.persist(path)?;
    Ok(())
}

/// A wall time.
fn interval(text: &str) -> Result<Duration, Failure> {
    let wrong = |reason: String| Failure::Argument(format!("--checkpoint \"{text}\": {reason}"));
    let seconds = ertel_quantity::parse(text, Dimension::TIME).map_err(|e| wrong(e.to_string()))?;
    Duration::try_from_secs_f64(seconds).map_err(|_| wrong("must be a time from 0 s on".to_owned()))
}
