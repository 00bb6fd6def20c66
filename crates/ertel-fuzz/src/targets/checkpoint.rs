//! Checkpoints of runs in time: as damage leaves them, and with a hash that fits the damaged bytes, so that the reader behind the hash is reached.

use std::path::Path;
use std::time::Duration;

use ertel::case::Case;
use ertel::output;
use ertel::run::checkpoint::Checkpoint;
use ertel::run::transient::solve_from;

use super::stopped::{HEAD, RUN, Stop, sealed, whole};
use super::{Verdict, check_text};
use crate::finding::Defect;
use crate::input::Input;

/// Time after which a run is stopped within a step.
const PATIENCE: Duration = Duration::from_millis(400);

/// Reads head and run as `--resume` does; then both, and the run alone, with a hash that fits.
pub fn run(input: &Input, folder: &Path) -> Result<Verdict, Defect> {
    let whole = whole().ok_or_else(|| Defect::wrong("no checkpoint", ""))?;
    let (head, run) = (input.file(HEAD), input.file(RUN));
    if let Ok(case) = Case::read(&folder.join("case.toml")) {
        let bytes = [head, run].concat();
        match Checkpoint::from_bytes(&bytes, &case) {
            Ok(_) if bytes == [&whole.head[..], &whole.run].concat() => {}
            Ok(_) => return Err(Defect::wrong("a damaged checkpoint is accepted", "")),
            Err(error) => drop(check_text(&error.to_string())?),
        }
    }
    if head != whole.head {
        resumed(&sealed(head, run), &whole.case)?;
    }
    resumed(&sealed(&whole.head, run), &whole.case)
}

/// Reads a checkpoint; what is accepted keeps its content when it is written again, and a run continues from there to its first stop.
fn resumed(bytes: &[u8], case: &Case) -> Result<Verdict, Defect> {
    let from = match Checkpoint::from_bytes(bytes, case) {
        Ok(from) => from,
        Err(error) => return check_text(&error.to_string()),
    };
    let written = from.to_bytes();
    if written.len() > bytes.len() {
        return Err(Defect::wrong("more is read than there is", ""));
    }
    match Checkpoint::from_bytes(&written, case) {
        Ok(again) if again.to_bytes() == written => {}
        Ok(_) => return Err(Defect::wrong("a checkpoint that changes", "")),
        Err(error) => return Err(Defect::wrong("a checkpoint lost", error.to_string())),
    }
    let mut stop = Stop::after(0, PATIENCE);
    let found = solve_from(case, Some(from), &mut stop);
    if let Some(failure) = &found.failure {
        check_text(&ertel_input::escaped(&failure.to_string()))?;
    }
    // Values that are not finite are refused there.
    if let Err(error) = output::transient_files(&case.echo(), &found, &case.output) {
        check_text(&ertel_input::escaped(&error.to_string()))?;
    }
    Ok(Verdict::Taken)
}
