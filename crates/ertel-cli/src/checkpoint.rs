//! The checkpoint of a run in time, from which it can continue.

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use ertel::case::Case;
use ertel::files::{clear_unfinished, write_whole};
use ertel::run::checkpoint::{Checkpoint, NAME};
use ertel_input::file::read_bytes;
use ertel_quantity::Dimension;

use crate::args::SolveArgs;
use crate::failure::Failure;

/// A file next to the results, if requested.
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

/// Most bytes of a checkpoint that are read: those of about a million steps, each of which is kept with its figures and its centreline.
const LARGEST: u64 = 16_000_000_000;

/// Interval of a resumed run without `--checkpoint`.
const USUAL: Duration = Duration::from_secs(600);

impl Checkpoints {
    /// The file for the results in a folder, and the checkpoint to resume from.
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
        clear_unfinished(path.parent().unwrap_or(Path::new("")));
        let from = former(&path, case, arguments.resume)?;
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

    /// Writes it; returns the reason of a first failure.
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

    /// Closes it at the end of the run; the file of a complete run is removed.
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

/// The checkpoint to resume from; a new run refuses an existing file.
fn former(path: &Path, case: &Case, resumes: bool) -> Result<Option<Checkpoint>, Failure> {
    let shown = path.display();
    let refuse = |text: String, help: &str| Failure::Argument(format!("{text}\n  = help: {help}"));
    match (read_bytes(path, LARGEST), resumes) {
        (Ok(bytes), true) => match Checkpoint::from_bytes(&bytes, case) {
            Ok(from) => Ok(Some(from)),
            Err(error) => Err(refuse(
                format!("{shown}: {error}"),
                "nothing was changed; to begin at the start of the time, delete the file and omit --resume",
            )),
        },
        (Err(error), true) => Err(refuse(
            format!("{shown} {error}"),
            "--resume continues a run with --checkpoint that was stopped",
        )),
        (Ok(bytes), false) => Err(refuse(
            format!("{shown} is there already"),
            match bytes.starts_with(NAME) {
                true => {
                    "it is from a run that was stopped: continue it with --resume, or delete it"
                }
                false => "it is no checkpoint: give the results another folder by --output",
            },
        )),
        (Err(error), false) if error.is_missing() => Ok(None),
        (Err(error), false) => Err(refuse(
            format!("{shown} {error}"),
            "a checkpoint goes there: give the results another folder by --output",
        )),
    }
}

/// A file as a whole, or as it was before.
fn replace(path: &Path, bytes: &[u8]) -> std::io::Result<()> {
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder)?;
    }
    write_whole(path, bytes)
}

/// A wall time.
fn interval(text: &str) -> Result<Duration, Failure> {
    let wrong = |reason: String| Failure::Argument(format!("--checkpoint \"{text}\": {reason}"));
    let seconds = ertel_quantity::parse(text, Dimension::TIME).map_err(|e| wrong(e.to_string()))?;
    Duration::try_from_secs_f64(seconds).map_err(|_| wrong("must be a time from 0 s on".to_owned()))
}
