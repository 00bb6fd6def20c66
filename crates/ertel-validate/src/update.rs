//! Stated efforts brought up to what runs take.

use std::fmt;

use toml_edit::{DocumentMut, value};

use super::{Quantity, Study, StudyResult};

/// A stated effort that changes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Change {
    /// Run.
    pub run: String,
    /// Newton iterations stated.
    pub stated: usize,
    /// Newton iterations that it took.
    pub taken: usize,
}

impl fmt::Display for Change {
    /// As a difference of two files shows it.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "  {}\n- newton_iterations = {}\n+ newton_iterations = {}",
            self.run, self.stated, self.taken
        )
    }
}

/// Brings `newton_iterations` of the runs in the text of a `reference.toml` up to what they took; runs that state none, that
/// were skipped or failed are unchanged. Comments and layout stay.
///
/// # Errors
/// Text that is no TOML, or not that of the study.
pub fn update(
    text: &str,
    study: &Study,
    result: &StudyResult,
) -> Result<(String, Vec<Change>), String> {
    let mut document: DocumentMut = text
        .parse()
        .map_err(|error: toml_edit::TomlError| error.to_string())?;
    let runs = (document.get_mut("run"))
        .and_then(|runs| runs.as_array_of_tables_mut())
        .filter(|runs| runs.len() == study.runs.len())
        .ok_or("its runs are not those of the study")?;
    let mut changes = Vec::new();
    for ((run, outcome), table) in study.runs.iter().zip(&result.outcomes).zip(runs.iter_mut()) {
        let taken = Quantity::NewtonIterations.value(run, outcome, None);
        let (Some(stated), Some(taken)) = (run.newton_iterations, taken) else {
            continue;
        };
        let taken = taken as usize;
        let Some(item) = table.get_mut("newton_iterations") else {
            return Err(format!("its run `{}` is not that of the study", run.name));
        };
        if taken != stated {
            let decor = item.as_value().map(|v| v.decor().clone());
            *item = value(taken as i64);
            if let (Some(decor), Some(new)) = (decor, item.as_value_mut()) {
                *new.decor_mut() = decor;
            }
            changes.push(Change {
                run: run.name.clone(),
                stated,
                taken,
            });
        }
    }
    Ok((document.to_string(), changes))
}
