//! Results for users and programs: report, `result.json`, tables, fields and pictures.
//!
//! [`write()`] writes everything into one folder, as a whole or not at all.

pub mod centreline;
mod check;
pub mod compare;
mod cross_check;
pub mod curve;
mod drawn;
mod estimate;
mod figure;
mod finite;
mod folder;
mod heat;
pub mod html;
mod inputs;
mod lines;
mod machine;
mod mixed;
mod monte_carlo;
pub mod netcdf;
pub mod pictures;
mod report;
mod result_json;
mod results;
mod rows;
mod stress;
mod study;
mod surfaces;
mod target;
pub mod transient;
pub mod vtu;
pub mod wear;
mod workplace;

#[cfg(test)]
mod sample;
#[cfg(test)]
mod tests;
#[cfg(test)]
mod workplace_tests;

pub use check::check_report;
pub use compare::{comparison_report, write_comparison};
pub use cross_check::{cross_check_report, write_cross_check};
pub use curve::{curve_files, curve_json, curve_report, curve_table, point_json, write_curve};
pub use estimate::{ESTIMATE_FORMAT, estimate_json, estimate_report};
pub use figure::unresolved;
pub use folder::{OutputFile, clear_leftovers};
pub use machine::{machine_json, machine_report, machine_table, write_machine};
pub use monte_carlo::{MONTE_CARLO, monte_carlo_report, write_monte_carlo};
pub use report::report;
pub use result_json::{FORMAT, FORMAT_VERSION, result_json};
pub use study::{StudyPicture, study_picture_names, study_pictures};
pub use target::{REPORT_PAGE, check_target, place_of_partial};
pub use transient::{
    transient_files, transient_json, transient_report, transient_table, write_transient,
};

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use folder::{NewFolder, Part};

use crate::case::CaseEcho;
use crate::files::write_whole;
use crate::params::{OutputParams, PictureFormats};
use crate::solution::Solution;

/// Why results were not written. No partial result remains.
#[derive(Debug, thiserror::Error)]
pub enum OutputError {
    /// The system refused: disk full, no permission, and so on.
    #[error("cannot write {}: {source}", path.display())]
    Io {
        /// The file or folder being written.
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
    /// The target holds something other than a former result.
    #[error(
        "will not replace the folder {}: {reason}. Choose another folder, or empty this one",
        path.display()
    )]
    ForeignFolder {
        /// The target.
        path: PathBuf,
        /// The foreign content.
        reason: String,
    },
    /// A number to be written is not finite.
    #[error("the result is not written, because it holds a number that is not finite: {what}")]
    NotFinite {
        /// The number.
        what: String,
    },
    /// The name of a picture has no known format.
    #[error("the name of a picture must end in .svg, .pdf or .png, not {}", path.display())]
    Suffix {
        /// The name.
        path: PathBuf,
    },
    /// A picture cannot be encoded in one of the formats.
    #[error(transparent)]
    Drawing(#[from] ertel_plot::DrawingError),
}

impl OutputError {
    fn io(path: &Path, source: io::Error) -> OutputError {
        OutputError::Io {
            path: path.to_owned(),
            source,
        }
    }
}

/// Writes a result folder: `result.json`, `report.txt`, `report.html`, `case.toml`, `centreline.csv`,
/// `surface.vtu`, `body.vtu`, `result.nc` and the pictures, as `params` requests (its `folder` is ignored); for a thermal contact
/// also `cross-film.csv` and `temperature.vtu`; with stresses in the bodies `stress.csv` and `stress.vtu`; with wear `wear.csv` and `wear-depth.csv`.
///
/// The files are written next to the target, synced to disk, and then moved into place; a
/// former result is replaced, anything else is refused.
///
/// # Errors
/// [`OutputError`]; the target is then unchanged.
pub fn write(
    case: &CaseEcho,
    solution: &Solution,
    target: &Path,
    params: &OutputParams,
) -> Result<(), OutputError> {
    check_solution(case, solution)?;
    let folder = NewFolder::next_to(target)?;
    write_files(folder.root(), case, solution, params)?;
    folder.finish()
}

/// The files that [`write()`] puts into a folder, in memory, for programs without a disk.
///
/// # Errors
/// [`OutputError`]: pictures that cannot be encoded, and non-finite numbers.
pub fn files(
    case: &CaseEcho,
    solution: &Solution,
    params: &OutputParams,
) -> Result<Vec<OutputFile>, OutputError> {
    check_solution(case, solution)?;
    let folder = Part::in_memory();
    write_files(&folder, case, solution, params)?;
    Ok(folder.into_files())
}

fn check_solution(case: &CaseEcho, solution: &Solution) -> Result<(), OutputError> {
    match finite::first_not_finite(case, solution) {
        Some(what) => Err(OutputError::NotFinite { what }),
        None => Ok(()),
    }
}

/// The files of one solution.
fn write_files(
    folder: &Part,
    case: &CaseEcho,
    solution: &Solution,
    params: &OutputParams,
) -> Result<(), OutputError> {
    folder.json("result.json", result_json(case, solution))?;
    folder.bytes("report.txt", report(case, solution, None))?;
    if let Some(text) = &case.case_file {
        folder.bytes("case.toml", text)?;
    }
    let half_width = solution.hertz.half_width;
    let thermal = solution.thermal.as_ref();
    folder.file("centreline.csv", |out| {
        let temperatures = thermal.map(|t| &t.centreline);
        centreline::write_centreline(out, &solution.centreline, temperatures, half_width)
    })?;
    // The slowest parts, in parallel.
    let (tolerance, scale) = (Some(case.solver.tolerance), case.temperature_scale());
    let surface = || -> io::Result<Vec<u8>> {
        let mut bytes = Vec::new();
        let temperatures = thermal.map(|t| &t.surface);
        vtu::write_surface(&mut bytes, &solution.shape, &solution.surface, temperatures)?;
        Ok(bytes)
    };
    let (page, (pictures, surface)) = rayon::join(
        || html::report_page(case, solution, case.solver.tolerance),
        || {
            let pictures = || pictures::pictures_in(&case.title, solution, tolerance, scale);
            rayon::join(pictures, surface)
        },
    );
    folder.file("surface.vtu", |out| out.write_all(&surface?))?;
    if let Some(profiles) = thermal.map(|t| &t.profiles).filter(|p| !p.is_empty()) {
        folder.file("cross-film.csv", |out| {
            heat::write_profiles(out, profiles, half_width)
        })?;
    }
    if let Some(stresses) = &solution.stresses {
        folder.file("stress.csv", |out| stress::write_profiles(out, stresses))?;
        folder.file("stress.vtu", |out| vtu::write_stresses(out, stresses))?;
    }
    if let Some(wear) = &solution.wear {
        let is_line = solution.shape.is_line();
        folder.file("wear.csv", |out| wear::write_course(out, wear, is_line))?;
        folder.file("wear-depth.csv", |out| wear::write_depths(out, wear))?;
    }
    if let Some(field) = thermal.and_then(|t| t.field.as_ref()) {
        folder.file("temperature.vtu", |out| {
            vtu::write_temperature(out, &solution.shape, field)
        })?;
    }
    if let Some(body) = solution.body.as_ref().filter(|_| params.body_field) {
        folder.file("body.vtu", |out| {
            vtu::write_body(out, &solution.shape, body)
        })?;
    }
    if params.netcdf {
        folder.bytes("result.nc", netcdf::of_solution(&case.title, solution))?;
    }
    folder.bytes(REPORT_PAGE, page)?;
    for picture in pictures {
        write_picture(folder, &picture, params.pictures)?;
    }
    if let Some(light) = &params.interferogram {
        let image = pictures::Image::new(solution, light, case.fluid.density);
        let png = image.png()?;
        folder.bytes("interferogram.png", &png)?;
        // The PNG file is the image alone; SVG and PDF have axes.
        let picture = pictures::Picture::new("interferogram", image.drawing(&case.title, &png));
        let formats = PictureFormats {
            png: false,
            ..params.pictures
        };
        write_picture(folder, &picture, formats)?;
    }
    Ok(())
}

/// A picture in the requested formats.
fn write_picture(
    folder: &Part,
    picture: &pictures::Picture,
    formats: PictureFormats,
) -> Result<(), OutputError> {
    let write = |suffix: &str, content: &[u8]| {
        let name = format!("{}.{suffix}", picture.name);
        folder.bytes(&name, content)
    };
    if formats.svg {
        write("svg", picture.svg.as_bytes())?;
    }
    let others = PictureFormats {
        svg: false,
        ..formats
    };
    for (suffix, content) in drawn(&picture.drawing, others)? {
        write(suffix, &content)?;
    }
    Ok(())
}

/// Suffix and content of a file.
pub(crate) type SuffixedFile = (&'static str, Vec<u8>);

/// The files of a picture in the requested formats.
fn drawn(
    drawing: &ertel_plot::Drawing,
    formats: PictureFormats,
) -> Result<Vec<SuffixedFile>, ertel_plot::DrawingError> {
    let svg = formats.svg.then(|| drawing.svg().into_bytes());
    let pdf = formats.pdf.then(|| drawing.pdf()).transpose()?;
    let png = formats.png.then(|| drawing.png()).transpose()?;
    let files = PictureFormats::NAMES.into_iter().zip([svg, pdf, png]);
    Ok(files
        .filter_map(|(suffix, content)| Some((suffix, content?)))
        .collect())
}

/// Writes a picture as [`put_picture`] does. All formats are encoded before the first file is written.
///
/// # Errors
/// [`OutputError`].
pub(crate) fn replace_picture(
    folder: &Path,
    name: &str,
    drawing: Option<&ertel_plot::Drawing>,
    formats: PictureFormats,
    former: PictureFormats,
) -> Result<(), OutputError> {
    put_picture(folder, name, &picture_files(drawing, formats)?, former)
}

/// The files of a picture, if any, in the requested formats.
///
/// # Errors
/// [`OutputError`] if a picture cannot be encoded.
pub(crate) fn picture_files(
    drawing: Option<&ertel_plot::Drawing>,
    formats: PictureFormats,
) -> Result<Vec<SuffixedFile>, OutputError> {
    Ok(drawing.map_or(Ok(Vec::new()), |drawing| drawn(drawing, formats))?)
}

/// Writes a picture as `name.svg`, `name.pdf` and `name.png`, as far as these files exist. A file of a former run in one of the
/// formats `former` is removed if it has no replacement, because it would show another result; others may be the user's.
///
/// # Errors
/// [`OutputError`].
pub(crate) fn put_picture(
    folder: &Path,
    name: &str,
    files: &[SuffixedFile],
    former: PictureFormats,
) -> Result<(), OutputError> {
    let path = |suffix: &str| folder.join(format!("{name}.{suffix}"));
    let is_former = [former.svg, former.pdf, former.png];
    for (suffix, _) in PictureFormats::NAMES
        .into_iter()
        .zip(is_former)
        .filter(|(suffix, is_former)| *is_former && files.iter().all(|(own, _)| own != suffix))
    {
        match fs::remove_file(path(suffix)) {
            Err(e) if e.kind() != io::ErrorKind::NotFound => {
                return Err(OutputError::io(&path(suffix), e));
            }
            _ => {}
        }
    }
    for (suffix, content) in files {
        write_whole(&path(suffix), content).map_err(|e| OutputError::io(&path(suffix), e))?;
    }
    Ok(())
}

/// Writes a picture into one file, in the format given by its suffix.
///
/// # Errors
/// [`OutputError::Suffix`] for a suffix other than those of [`PictureFormats::NAMES`].
pub fn write_drawing(path: &Path, drawing: &ertel_plot::Drawing) -> Result<(), OutputError> {
    for (_, content) in drawn(drawing, picture_format(path)?)? {
        write_whole(path, &content).map_err(|e| OutputError::io(path, e))?;
    }
    Ok(())
}

/// The format given by the suffix of a file name.
///
/// # Errors
/// [`OutputError::Suffix`].
pub fn picture_format(path: &Path) -> Result<PictureFormats, OutputError> {
    let suffix = path.extension().and_then(|s| s.to_str());
    let suffix = suffix.map(str::to_ascii_lowercase);
    PictureFormats::named([suffix.as_deref().unwrap_or_default()]).ok_or_else(|| {
        OutputError::Suffix {
            path: path.to_owned(),
        }
    })
}
