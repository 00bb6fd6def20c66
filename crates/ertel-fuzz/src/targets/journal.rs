//! Journals and lists of points of sweeps: looked at, joined, their tables written.

use std::fs;
use std::io;
use std::path::Path;
use std::sync::OnceLock;

use ertel::case::Study;
use ertel::study::journal::{JOURNAL, Record};
use ertel::study::{POINTS, StudyEcho};
use ertel::sweep::{finished_points, merge};

use super::{Verdict, check_text};
use crate::finding::Defect;
use crate::input::{Input, Target};

const STUDY: &str = include_str!("../../../../cases/speeds-and-loads.toml");
const ROLLER: &str = include_str!("../../../../cases/roller.toml");
/// Points of the study that is fed.
const FEW: &str = "points = 3";

fn study() -> Option<&'static Study> {
    static STUDY_READ: OnceLock<Option<Study>> = OnceLock::new();
    let read = || {
        let folder = tempfile::tempdir().ok()?;
        let path = folder.path().join("study.toml");
        fs::write(&path, STUDY.replace("points = 20", FEW)).ok()?;
        fs::write(folder.path().join("roller.toml"), ROLLER).ok()?;
        Study::read(&path).ok()
    };
    STUDY_READ.get_or_init(read).as_ref()
}

/// The journal of a finished study.
///
/// # Errors
/// Folders and files that cannot be written.
pub fn seed() -> io::Result<Input> {
    let study = study().ok_or_else(|| io::Error::other("the study cannot be read"))?;
    let echo = StudyEcho::new(study);
    let mut journal = String::new();
    for (i, (key, _)) in echo.points.iter().enumerate() {
        let film = format!("{:e}", 1e-7 * (1 + i) as f64);
        let names = [
            "film_central_m",
            "film_minimum_m",
            "film_central_error_m",
            "traction_coefficient",
        ];
        let record = Record {
            key: *key,
            converged: i != 4,
            reason: if i == 4 {
                "no convergence".into()
            } else {
                String::new()
            },
            fields: names
                .iter()
                .map(|name| ((*name).to_owned().into(), film.clone().into()))
                .collect(),
            warnings: Vec::new(),
            seconds: 0.5,
        };
        journal += &serde_json::to_string(&record)?;
        journal.push('\n');
    }
    let points = serde_json::to_string_pretty(&echo)?;
    Ok(Input {
        target: Target::Journal,
        files: vec![
            (JOURNAL.to_owned(), journal.into_bytes()),
            (POINTS.to_owned(), points.into_bytes()),
        ],
    })
}

/// Looks at a study in the folder and joins it with itself into another one.
pub fn run(folder: &Path) -> Result<Verdict, Defect> {
    let study = study().ok_or_else(|| Defect::wrong("no study", ""))?;
    let failed = |error: io::Error| Defect::wrong("a folder fails", error.to_string());
    let part = folder.join("part");
    fs::create_dir(&part).map_err(failed)?;
    for name in [JOURNAL, POINTS] {
        fs::rename(folder.join(name), part.join(name)).map_err(failed)?;
    }
    let mut verdict = Verdict::Taken;
    match finished_points(study, &part) {
        Ok(points) if points.len() != study.points.len() => {
            return Err(Defect::wrong("points are lost", points.len().to_string()));
        }
        Ok(_) => {}
        Err(error) => verdict = check_sweep(&error.to_string(), folder)?,
    }
    let target = folder.join("whole");
    let parts = [part.clone(), part.clone()];
    if let Err(error) = merge(&target, &parts) {
        verdict = check_sweep(&error.to_string(), folder)?;
    }
    let _ = fs::remove_dir_all(&target);
    fs::remove_dir_all(&part).map_err(failed)?;
    Ok(verdict)
}

/// An error of a sweep names the folder, or two points.
pub fn check_sweep(text: &str, folder: &Path) -> Result<Verdict, Defect> {
    if !text.contains(&folder.display().to_string()) && !text.contains("point") {
        return Err(Defect::wrong("an error without folder", text));
    }
    // The command escapes what it prints.
    check_text(&ertel_input::escaped(text))
}
