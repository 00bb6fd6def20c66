//! `fields.pvd` and a VTU file for each output time.

use super::super::OutputError;
use super::super::folder::Part;
use super::super::vtu::{write_collection, write_instant};
use crate::run::transient::InstantFields;

/// Prefix and suffix of the file names; the number of the output time, from 1, is between them.
const NAME: [&str; 2] = ["fields-", ".vtu"];

/// Writes the fields of all output times and the collection that lists them.
pub(super) fn write_fields(root: &Part, fields: &InstantFields) -> Result<(), OutputError> {
    let width = fields.times.len().to_string().len().max(3);
    let name = |number: usize| format!("{}{:0width$}{}", NAME[0], number + 1, NAME[1]);
    for number in 0..fields.times.len() {
        root.file(&name(number), |out| write_instant(out, fields, number))?;
    }
    root.file("fields.pvd", |out| {
        let files = fields.times.iter().enumerate();
        write_collection(out, files.map(|(number, time)| (*time, name(number))))
    })
}

/// Whether a file has the name of an instant's fields: `fields-001.vtu`.
pub(in crate::output) fn is_file_of_instant(name: &str) -> bool {
    name.strip_prefix(NAME[0])
        .and_then(|rest| rest.strip_suffix(NAME[1]))
        .is_some_and(|number| !number.is_empty() && number.bytes().all(|b| b.is_ascii_digit()))
}
