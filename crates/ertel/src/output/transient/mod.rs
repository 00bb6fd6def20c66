//! Results of a transient case: `transient.csv`, `profiles.csv`, `transient.json`, fields, pictures, a report and its page.

mod animation;
mod conditions;
mod fields;
mod json;
mod netcdf;
mod picture;
mod report;
mod table;

pub use animation::animation;
pub use json::{TRANSIENT_FORMAT, transient_json};
pub use netcdf::transient_netcdf;
pub(super) use picture::{film_axis, film_range};
pub use picture::{film_over_time, map_of_film};
pub use report::transient_report;
pub(super) use report::write_results;
pub use table::{profiles_table, transient_table};

use std::path::Path;

use self::conditions::CONDITIONS;
use super::folder::{NewFolder, OutputFile, Part};
use super::html::transient_page;
use super::pictures::Picture;
use super::target::REPORT_PAGE;
use super::{OutputError, write_picture};
use crate::case::CaseEcho;
use crate::params::OutputParams;
use crate::run::transient::TransientSolution;
use crate::solution::Figure;

/// Writes the results of a transient case into one folder, as [`super::write`] does.
///
/// # Errors
/// [`OutputError`]; the target is then unchanged.
pub fn write_transient(
    case: &CaseEcho,
    found: &TransientSolution,
    target: &Path,
    params: &OutputParams,
) -> Result<(), OutputError> {
    check_finite(found)?;
    let folder = NewFolder::next_to(target)?;
    write_files(folder.root(), case, found, params)?;
    folder.finish()
}

/// The files that [`write_transient`] puts into a folder, in memory.
///
/// # Errors
/// As [`super::files`].
pub fn transient_files(
    case: &CaseEcho,
    found: &TransientSolution,
    params: &OutputParams,
) -> Result<Vec<OutputFile>, OutputError> {
    check_finite(found)?;
    let folder = Part::in_memory();
    write_files(&folder, case, found, params)?;
    Ok(folder.into_files())
}

/// Rejects non-finite numbers.
pub(super) fn check_finite(found: &TransientSolution) -> Result<(), OutputError> {
    for instant in &found.instants {
        let figures = &instant.measured.figures;
        let values = Figure::ALL
            .iter()
            .filter_map(|figure| figures.value(*figure));
        let conditions = CONDITIONS.iter().filter_map(|of| (of.value)(instant));
        let mut all = values.chain(conditions).chain([instant.mass_error]);
        if !all.all(f64::is_finite) {
            let what = format!("a figure at t = {:e} s", instant.time);
            return Err(OutputError::NotFinite { what });
        }
    }
    Ok(())
}

/// The files of a transient case.
pub(super) fn write_files(
    root: &Part,
    case: &CaseEcho,
    found: &TransientSolution,
    params: &OutputParams,
) -> Result<(), OutputError> {
    let is_line = case.contact.kind.is_line();
    root.json("transient.json", transient_json(case, found))?;
    root.bytes("transient.csv", transient_table(found, is_line))?;
    root.bytes("profiles.csv", profiles_table(found))?;
    root.bytes("report.txt", transient_report(case, found, None))?;
    let pictures = pictures(&case.title, found, is_line)?;
    root.bytes(REPORT_PAGE, transient_page(case, found, &pictures))?;
    if let Some(text) = &case.case_file {
        root.bytes("case.toml", text)?;
    }
    if params.vtu {
        fields::write_fields(root, &found.fields)?;
    }
    if params.netcdf {
        root.bytes("result.nc", transient_netcdf(case, found))?;
    }
    if params.animation
        && let Some(bytes) = animation(&case.title, found)?
    {
        root.bytes("animation.png", bytes)?;
    }
    for picture in pictures {
        write_picture(root, &picture, params.pictures)?;
    }
    Ok(())
}

fn pictures(
    title: &str,
    found: &TransientSolution,
    is_line: bool,
) -> Result<Vec<Picture>, OutputError> {
    let films = film_over_time(title, found, is_line).drawing();
    let films = Picture::new("film-time", films);
    let map = map_of_film(title, found)?;
    let map = map.map(|drawing| Picture::new("film-map", drawing));
    Ok(std::iter::once(films).chain(map).collect())
}
