//! Results for people and programs: report, `result.json`, tables, fields and pictures.
//!
//! [`write()`] puts everything into one folder that appears as a whole or not at all.

pub mod centreline;
mod check;
pub mod compare;
mod csv;
pub mod curve;
mod echo;
mod estimate;
mod figure;
mod file;
mod finite;
mod folder;
mod heat;
mod inputs;
mod mixed;
mod monte_carlo;
pub mod plot;
mod report;
mod result_json;
mod study;
mod target;
pub mod vtu;
mod workplace;

#[cfg(test)]
mod fixture;
#[cfg(test)]
mod tests;
#[cfg(test)]
mod workplace_tests;

pub use check::check_report;
pub use compare::{comparison_report, write_comparison};
pub(crate) use csv::{quoted, text_field};
pub use curve::{curve_json, curve_report, curve_table, write_curve};
pub use echo::{BodyEcho, CaseEcho, EstimateEcho, FluidEcho, HeatEcho, MachineEcho, ThermalEcho};
pub use estimate::{ESTIMATE_FORMAT, estimate_json, estimate_report};
pub use figure::unresolved;
pub use file::write_whole;
pub(crate) use file::{TEMPORARY, sync_folder};
pub use folder::clear_leftovers;
pub use monte_carlo::{MONTE_CARLO, MONTE_CARLO_PICTURE, monte_carlo_report, write_monte_carlo};
pub use plot::png::{PngError, check as check_png};
pub use report::{digits, length, pressure, report};
pub use result_json::{FORMAT, FORMAT_VERSION, result_json};
pub use study::{study_films, study_tractions};
pub use target::check_target;

use std::io;
use std::path::{Path, PathBuf};

use folder::{NewFolder, Part};

use crate::params::OutputParams;
use crate::solution::Solution;

/// PNG pixels per unit of the SVG pictures: about 300 dots per inch on a 17 cm wide page.
const PNG_SCALE: f32 = 3.0;

/// Why results were not written. Nothing is left half-written.
#[derive(Debug, thiserror::Error)]
pub enum OutputError {
    /// The system refused: disk full, no permission, and so on.
    #[error("cannot write {}: {source}", path.display())]
    Io {
        /// What was being written.
        path: PathBuf,
        /// The system's reason.
        source: io::Error,
    },
    /// The target exists and is not a folder.
    #[error("cannot write results to {}: it is a file, not a folder", path.display())]
    NotAFolder {
        /// The target.
        path: PathBuf,
    },
    /// The target holds something else than a former result.
    #[error(
        "will not replace the folder {}: {reason}. Choose another folder, or empty this one",
        path.display()
    )]
    ForeignFolder {
        /// The target.
        path: PathBuf,
        /// What it holds.
        reason: String,
    },
    /// A number to be written is not finite.
    #[error("the result is not written, because it holds a number that is not finite: {what}")]
    NotFinite {
        /// Which.
        what: String,
    },
    /// PNG pictures were asked for but cannot be made.
    #[error(transparent)]
    Png(#[from] PngError),
    /// The image of an interferogram cannot be made.
    #[error("cannot make the interferogram: {0}")]
    Image(#[from] plot::ImageError),
}

impl OutputError {
    fn io(path: &Path, source: io::Error) -> OutputError {
        OutputError::Io {
            path: path.to_owned(),
            source,
        }
    }
}

/// What outputs call the bodies.
pub(crate) const BODIES: [&str; 2] = ["body 1", "body 2"];

/// Writes a result folder: `result.json`, `report.txt`, `case.toml`, `centreline.csv`,
/// `surface.vtu`, `body.vtu` and the pictures, as `params` asks (its `folder` is not looked at); of a thermal contact
/// `cross-film.csv` and `temperature.vtu`, too.
///
/// The files are written beside the target first, brought to the disk, and then put in place; a
/// former result there is replaced, anything else is refused.
///
/// # Errors
/// [`OutputError`]; the target is then as it was before.
pub fn write(
    case: &CaseEcho,
    solution: &Solution,
    target: &Path,
    params: &OutputParams,
) -> Result<(), OutputError> {
    if params.png {
        check_png()?;
    }
    if let Some(what) = finite::first_not_finite(case, solution) {
        return Err(OutputError::NotFinite { what });
    }
    let folder = NewFolder::beside(target)?;
    write_files(folder.root(), case, solution, params)?;
    folder.finish()
}

/// The files of one solution.
fn write_files(
    folder: &Part,
    case: &CaseEcho,
    solution: &Solution,
    params: &OutputParams,
) -> Result<(), OutputError> {
    let json = result_json(case, solution)
        .and_then(|json| serde_json::to_string_pretty(&json))
        .map_err(|e| OutputError::io(&folder.shown("result.json"), e.into()))?;
    folder.file("result.json", |out| writeln!(out, "{json}"))?;
    folder.file("report.txt", |out| {
        out.write_all(report(case, solution, None).as_bytes())
    })?;
    if let Some(text) = &case.case_file {
        folder.file("case.toml", |out| out.write_all(text.as_bytes()))?;
    }
    let half_width = solution.hertz.half_width;
    let thermal = solution.thermal.as_ref();
    folder.file("centreline.csv", |out| {
        let temperatures = thermal.map(|t| &t.centreline);
        centreline::write_centreline(out, &solution.centreline, temperatures, half_width)
    })?;
    folder.file("surface.vtu", |out| {
        let temperatures = thermal.map(|t| &t.surface);
        vtu::write_surface(out, &solution.shape, &solution.surface, temperatures)
    })?;
    if let Some(profiles) = thermal.map(|t| &t.profiles).filter(|p| !p.is_empty()) {
        folder.file("cross-film.csv", |out| {
            heat::write_profiles(out, profiles, half_width)
        })?;
    }
    if let Some(field) = thermal.and_then(|t| t.field.as_ref()) {
        folder.file("temperature.vtu", |out| {
            vtu::write_temperature(out, solution.shape.kind, field)
        })?;
    }
    if let Some(body) = solution.body.as_ref().filter(|_| params.body_field) {
        folder.file("body.vtu", |out| {
            vtu::write_body(out, solution.shape.kind, body)
        })?;
    }
    for picture in plot::pictures(&case.title, solution, Some(case.solver.tolerance)) {
        write_picture(folder, &picture, params.png)?;
    }
    if let Some(light) = &params.interferogram {
        let image = plot::Image::new(solution, light, case.fluid.density);
        let png = image.png()?;
        folder.file("interferogram.svg", |out| {
            out.write_all(image.svg(&case.title, &png).as_bytes())
        })?;
        folder.file("interferogram.png", |out| out.write_all(&png))?;
    }
    Ok(())
}

/// A picture as SVG and, if asked for, as PNG.
fn write_picture(folder: &Part, picture: &plot::Picture, png: bool) -> Result<(), OutputError> {
    folder.file(&format!("{}.svg", picture.name), |out| {
        out.write_all(picture.svg.as_bytes())
    })?;
    if png {
        let png = plot::png::from_svg(&picture.svg, PNG_SCALE)?;
        folder.file(&format!("{}.png", picture.name), |out| out.write_all(&png))?;
    }
    Ok(())
}
