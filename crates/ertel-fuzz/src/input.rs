//! What is fed to a reader: the files of one input, and which reader it is for.

use std::fs;
use std::io;
use std::path::Path;

use serde::{Deserialize, Serialize};

/// A reader of files that users give.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, clap::ValueEnum)]
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
    /// A file of the cache of elastic operators.
    Operator,
    /// Journal and list of points of a sweep.
    Journal,
}

impl Target {
    /// All of them.
    pub const ALL: [Target; 11] = [
        Target::Case,
        Target::Solve,
        Target::Study,
        Target::Points,
        Target::Table,
        Target::FitViscosity,
        Target::FitDensity,
        Target::FitFilm,
        Target::Measured,
        Target::Operator,
        Target::Journal,
    ];

    /// Its name on the command line and in findings.
    pub fn name(self) -> &'static str {
        match self {
            Target::Case => "case",
            Target::Solve => "solve",
            Target::Study => "study",
            Target::Points => "points",
            Target::Table => "table",
            Target::FitViscosity => "fit-viscosity",
            Target::FitDensity => "fit-density",
            Target::FitFilm => "fit-film",
            Target::Measured => "measured",
            Target::Operator => "operator",
            Target::Journal => "journal",
        }
    }

    /// Share of the inputs: what users write by hand and what is quick comes more often.
    pub fn weight(self) -> u32 {
        match self {
            Target::Case => 400,
            Target::Solve => 1,
            Target::Study => 50,
            Target::Points => 100,
            Target::Table => 150,
            Target::FitViscosity => 30,
            Target::FitDensity => 40,
            Target::FitFilm => 15,
            Target::Measured => 60,
            Target::Operator => 60,
            Target::Journal => 40,
        }
    }

    /// The file that is damaged most.
    pub fn main_file(self) -> &'static str {
        match self {
            Target::Case | Target::Solve => "case.toml",
            Target::Study => "study.toml",
            Target::Points => "points.csv",
            Target::Table => "table.csv",
            Target::FitViscosity | Target::FitDensity | Target::FitFilm => "data.csv",
            Target::Measured => "measured.csv",
            Target::Operator => "operator.bin",
            Target::Journal => "journal.jsonl",
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
