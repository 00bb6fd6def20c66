//! `fields.pvd` and a VTU file for each output time.

use super::super::OutputError;
use super::super::folder::Part;
use super::super::target::FIELDS;
use super::super::vtu::{write_collection, write_instant};
use crate::run::transient::InstantFields;

/// Writes the fields of all output times and the collection that lists them.
pub(super) fn write_fields(root: &Part, fields: &InstantFields) -> Result<(), OutputError> {
    let width = fields.times.len().to_string().len().max(3);
    let name = |number: usize| format!("{}{:0width$}{}", FIELDS[0], number + 1, FIELDS[1]);
    for number in 0..fields.times.len() {
        root.file(&name(number), |out| write_instant(out, fields, number))?;
    }
    root.file("fields.pvd", |out| {
        let files = fields.times.iter().enumerate();
        write_collection(out, files.map(|(number, time)| (*time, name(number))))
    })
}
