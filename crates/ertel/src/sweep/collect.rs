//! Records that other processes have made, put into the journal of their study.

use std::collections::{HashMap, HashSet};
use std::io;
use std::path::Path;

use super::SweepError;
use super::folder::open;
use crate::case::Study;
use crate::study::StudyError;
use crate::study::journal::{Journal, PointKey, Record};
use crate::study::table::StudyEcho;

/// The journal of a study whose points are solved elsewhere; its folder is locked as long as it lives.
#[derive(Debug)]
pub struct Collector {
    journal: Journal,
    /// Place of each point of the study.
    places: HashMap<PointKey, usize>,
    finished: HashSet<usize>,
}

impl Collector {
    /// Opens the folder of a study, or makes it; `retry` takes points that failed for unfinished.
    ///
    /// # Errors
    /// As [`super::sweep`] before it begins.
    pub fn open(study: &Study, folder: &Path, retry: bool) -> Result<Collector, SweepError> {
        let echo = StudyEcho::new(study);
        check_distinct(study, &echo)?;
        let (journal, entries) = open(folder, &echo)?;
        let places: HashMap<PointKey, usize> = (echo.points.iter().enumerate())
            .map(|(i, (key, _))| (*key, i))
            .collect();
        let finished = (entries.records.values())
            .filter(|record| record.converged || !retry)
            .filter_map(|record| places.get(&record.key).copied());
        Ok(Collector {
            journal,
            finished: finished.collect(),
            places,
        })
    }

    /// Whether a point of the study, by its place, is finished.
    pub fn is_finished(&self, place: usize) -> bool {
        self.finished.contains(&place)
    }

    /// Number of points that are finished.
    pub fn n_finished(&self) -> usize {
        self.finished.len()
    }

    /// Appends the lines of another journal that are points of the study and were not finished; returns how many.
    ///
    /// # Errors
    /// [`SweepError::Study`], also for a line that is no record; nothing is appended then.
    pub fn append(&mut self, lines: &str) -> Result<usize, SweepError> {
        let mut records = Vec::new();
        for line in lines.lines() {
            let record = Record::from_line(line.as_bytes()).map_err(|e| {
                StudyError::io(Path::new("the journal of a part"), io::Error::other(e))
            })?;
            let place = self.places.get(&record.key);
            if place.is_some_and(|place| self.finished.insert(*place)) {
                records.push(record);
            }
        }
        self.journal.append_all(&records)?;
        Ok(records.len())
    }
}

pub(super) fn check_distinct(study: &Study, echo: &StudyEcho) -> Result<(), SweepError> {
    let mut seen = HashMap::new();
    for (i, (key, _)) in echo.points.iter().enumerate() {
        if let Some(first) = seen.insert(*key, i) {
            return Err(SweepError::Twice {
                first: first + 1,
                second: i + 1,
                label: study.points[i].label.clone(),
            });
        }
    }
    Ok(())
}
