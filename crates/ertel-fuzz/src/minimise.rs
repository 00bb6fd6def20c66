//! Inputs made smaller as long as they show the same defect.

use std::fs;
use std::io::{self, BufRead, BufReader};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use crate::finding::{Defect, Kind, NOTE};
use crate::input::{Input, Target, scratch};

/// Time for one input: findings should be readable, not as small as can be.
const PATIENCE: Duration = Duration::from_secs(20);

/// Leaves out lines, then pieces of lines, as long as the defect stays.
///
/// # Errors
/// Processes or folders that cannot be made.
pub fn minimise(input: &Input, defect: &Defect) -> io::Result<Input> {
    let until = Instant::now() + PATIENCE;
    let limit = Duration::from_secs_f64(match defect.kind {
        Kind::Hang => 20.0 * input.target.time_limit(),
        _ => 2.0 + input.target.time_limit(),
    });
    let folder = scratch()?;
    let shows = |candidate: &Input| -> io::Result<bool> {
        for entry in fs::read_dir(folder.path())? {
            let path = entry?.path();
            if path.is_file() && !path.ends_with(NOTE) {
                fs::remove_file(path)?;
            }
        }
        candidate.write(folder.path())?;
        Ok(repeat(folder.path(), input.target, limit)?.is_some_and(|found| found.is_like(defect)))
    };
    let mut best = input.clone();
    for index in 0..best.files.len() {
        for by_lines in [true, false] {
            let mut parts = split(&best.files[index].1, by_lines);
            let mut size = parts.len().div_ceil(2);
            while size > 0 && Instant::now() < until {
                let mut start = 0;
                while start < parts.len() && Instant::now() < until {
                    let mut fewer = parts.clone();
                    fewer.drain(start..(start + size).min(parts.len()));
                    let mut candidate = best.clone();
                    candidate.files[index].1 = fewer.concat();
                    if shows(&candidate)? {
                        (best, parts) = (candidate, fewer);
                    } else {
                        start += size;
                    }
                }
                size /= 2;
            }
        }
    }
    Ok(best)
}

/// Lines, or pieces of eight bytes.
fn split(content: &[u8], by_lines: bool) -> Vec<Vec<u8>> {
    match by_lines {
        true => content
            .split_inclusive(|b| *b == b'\n')
            .map(<[u8]>::to_vec)
            .collect(),
        false => content.chunks(8).map(<[u8]>::to_vec).collect(),
    }
}

/// The result of one input, read by a separate process that ends after `limit`.
///
/// # Errors
/// The process cannot be started.
fn repeat(folder: &Path, target: Target, limit: Duration) -> io::Result<Option<Defect>> {
    let mut command = Command::new(std::env::current_exe()?);
    command
        .arg("--repeat")
        .arg(folder)
        .args(["--target", &target.name(), "--json"]);
    let mut child = command
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()?;
    let until = Instant::now() + limit;
    let status = loop {
        if let Some(status) = child.try_wait()? {
            break status;
        }
        if Instant::now() > until {
            child.kill()?;
            child.wait()?;
            return Ok(None);
        }
        std::thread::sleep(Duration::from_millis(1));
    };
    if status.success() {
        return Ok(None);
    }
    let mut line = String::new();
    if let Some(out) = child.stdout.take() {
        BufReader::new(out).read_line(&mut line)?;
    }
    Ok(Some(serde_json::from_str(&line).unwrap_or(Defect {
        kind: Kind::Abort,
        place: status.to_string(),
        message: line,
    })))
}
