//! Parts of one study joined.

use std::path::{Path, PathBuf};
use std::time::Instant;

use super::folder::{look, open, write_results};
use super::{SweepError, SweepSummary};
use crate::study::table::StudyEcho;

/// Joins parts of one study: their journals and their table, in a folder that may hold a part of it.
///
/// # Errors
/// [`SweepError`]: no parts, parts of different studies, folders without a study, and the system's reasons.
pub fn merge(target: &Path, parts: &[PathBuf]) -> Result<SweepSummary, SweepError> {
    let clock = Instant::now();
    let mut study: Option<(StudyEcho, &Path)> = None;
    let mut all = Vec::new();
    for part in parts {
        let echo = StudyEcho::read(part)?.ok_or_else(|| SweepError::NoStudy {
            folder: part.clone(),
        })?;
        match &study {
            Some((first, other))
                if first.points != echo.points || first.columns != echo.columns =>
            {
                return Err(SweepError::Mixed {
                    folder: part.clone(),
                    other: other.to_path_buf(),
                });
            }
            Some(_) => {}
            None => study = Some((echo, part)),
        }
        all.push(look(part)?);
    }
    let Some((echo, _)) = study else {
        return Err(SweepError::NoParts);
    };
    let (mut journal, former) = open(target, &echo)?;
    let mut records = former.records;
    let mut summary = SweepSummary {
        n_points: echo.points.len(),
        n_damaged: former.n_damaged + all.iter().map(|e| e.n_damaged).sum::<usize>(),
        ..SweepSummary::default()
    };
    for (i, (key, values)) in echo.points.iter().enumerate() {
        let found = all.iter().filter_map(|entries| entries.records.get(key));
        // A part may have retried points that failed in another.
        let found = found.max_by_key(|record| record.converged);
        let known = records.get(key).is_some_and(|record| record.converged);
        match found {
            Some(record) if !known && records.get(key) != Some(record) => {
                journal.append(record)?;
                summary.n_new += 1;
                records.insert(*key, record.clone());
            }
            _ => summary.n_kept += usize::from(records.contains_key(key)),
        }
        match records.get(key) {
            Some(record) if !record.converged => {
                let label = values.join(", ");
                summary.failures.push((i, label, record.reason.clone()));
            }
            Some(record) => {
                summary.n_unresolved += usize::from(record.is_unresolved());
                summary.unresolved.add(|column| record.field(column));
            }
            None => summary.interrupted = true,
        }
    }
    write_results(target, &echo, &records)?;
    summary.wall_seconds = clock.elapsed().as_secs_f64();
    Ok(summary)
}
