//! Inputs of readers: the files of one input, and the reader that it is for.

use std::fs;
use std::io;
use std::path::Path;

use clap::ValueEnum;
use serde::{Deserialize, Serialize};

/// A reader of files that users give.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Target {
    /// A case file: read, checked, estimated, its problem set up.
    Case,
    /// The same of line contacts, with a few iterations of the solver.
    Solve,
    /// A study with its base case.
    Study,
    /// A study with a table of points.
    Points,
    /// A case with tables of laws.
    Table,
    /// Measured viscosities, fitted by every law.
    FitViscosity,
    /// Measured densities, likewise.
    FitDensity,
    /// Films, fitted by every form.
    FitFilm,
    /// Measured films, a table or an export of a rig, with the case that they are compared with.
    Measured,
    /// Journal and list of points of a sweep.
    Journal,
    /// A case file of a machine.
    Machine,
    /// Values that replace those of a case, as `--set` does.
    Settings,
    /// Answers to the questions of `ertel init --ask`.
    Answers,
    /// A lubricant and a solid of the user, with a table of a law.
    OwnData,
    /// The list of points of a sweep, with its journal.
    StudyList,
    /// Results in a folder that a new one is to replace.
    CurveResult,
    /// Pages of results, shown one by one and side by side.
    View,
    /// Arguments that the functions of the Python package pass to the library.
    Python,
    /// Requests of the page in a browser.
    Web,
    /// A case with a map of a surface: text or SDF.
    Surface,
    /// The same with the parts of an X3P.
    X3p,
    /// A case with a table of what changes in time.
    Course,
    /// A checkpoint of a run in time, with its case.
    Checkpoint,
    /// A folder of results that the Python package opens.
    Read,
}

impl Target {
    /// Its name on the command line and in findings.
    pub fn name(self) -> String {
        let value = self.to_possible_value().expect("no target is skipped");
        value.get_name().to_owned()
    }

    /// Share of the inputs: what users write by hand and what is quick comes more often.
    pub fn weight(self) -> u32 {
        match self {
            Target::Case => 400,
            Target::Solve => 1,
            Target::Study => 50,
            Target::Points => 100,
            Target::Table => 150,
            Target::FitViscosity | Target::StudyList | Target::CurveResult | Target::Python => 30,
            Target::FitDensity | Target::Journal | Target::View => 40,
            Target::FitFilm | Target::Checkpoint => 15,
            Target::Answers => 10,
            Target::Machine => 80,
            Target::Measured
            | Target::Settings
            | Target::OwnData
            | Target::Web
            | Target::Surface
            | Target::X3p
            | Target::Course
            | Target::Read => 60,
        }
    }

    /// The file that is damaged most.
    pub fn main_file(self) -> &'static str {
        match self {
            Target::Case | Target::Solve | Target::Machine | Target::Web => "case.toml",
            Target::Study => "study.toml",
            Target::Points => "points.csv",
            Target::Table => "table.csv",
            Target::FitViscosity | Target::FitDensity | Target::FitFilm => "data.csv",
            Target::Measured => "measured.csv",
            Target::Journal => "journal.jsonl",
            Target::Settings => "settings.txt",
            Target::Answers => "answers.txt",
            Target::OwnData => "oil.toml",
            Target::StudyList => "study.json",
            Target::CurveResult => "curve.json",
            Target::View => "report.html",
            Target::Python => "call.json",
            Target::Surface => "map.txt",
            Target::X3p => "main.xml",
            Target::Course => "course.csv",
            Target::Checkpoint => "run.bin",
            Target::Read => "surface.csv",
        }
    }

    /// CPU seconds from which an input counts as a hang.
    pub fn time_limit(self) -> f64 {
        match self {
            // The solver is asked to stop after a moment, but finishes the factorisation that it has begun.
            Target::Solve => 10.0,
            _ => 2.0,
        }
    }
}

/// One input.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Input {
    /// The reader.
    pub target: Target,
    /// Names and contents of its files.
    pub files: Vec<(String, Vec<u8>)>,
}

impl Input {
    /// The content of a file; empty where there is none of that name.
    pub fn file(&self, name: &str) -> &[u8] {
        let found = self.files.iter().find(|(own, _)| own == name);
        found.map_or(&[], |(_, content)| content)
    }

    /// Replaces the content of a file, or adds it.
    pub fn set(&mut self, name: &str, content: Vec<u8>) {
        match self.files.iter_mut().find(|(own, _)| own == name) {
            Some((_, old)) => *old = content,
            None => self.files.push((name.to_owned(), content)),
        }
    }

    /// Writes its files into a folder that has no others.
    ///
    /// # Errors
    /// The system's.
    pub fn write(&self, folder: &Path) -> io::Result<()> {
        for (name, content) in &self.files {
            fs::write(folder.join(name), content)?;
        }
        Ok(())
    }

    /// Bytes of all files.
    pub fn len(&self) -> usize {
        self.files.iter().map(|(_, content)| content.len()).sum()
    }
}

/// A folder for the files of inputs: in memory where the system has such a place, as each is read once.
pub fn scratch() -> io::Result<tempfile::TempDir> {
    let memory = Path::new("/dev/shm");
    match memory.is_dir() {
        true => tempfile::tempdir_in(memory).or_else(|_| tempfile::tempdir()),
        false => tempfile::tempdir(),
    }
}
