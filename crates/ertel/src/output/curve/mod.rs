//! Results of a curve: `curve.csv`, `curve.json`, the pictures, a report, and point folders.

mod frame;
mod json;
mod machine;
mod picture;
mod report;
mod stribeck;
mod table;

pub use json::{CURVE_FORMAT, curve_json, point_json};
pub use picture::{film_chart, film_shape_chart, films_chart, traction_chart, tractions_chart};
pub use report::curve_report;
pub use stribeck::stribeck_chart;
pub use table::curve_table;

use std::path::Path;

use super::folder::{NewFolder, OutputFile, Part};
use super::html::curve_page;
use super::machine::{check as check_machine, write_files_of_machine};
use super::pictures::Picture;
use super::target::REPORT_PAGE;
use super::transient::{check_finite, write_files as write_files_in_time};
use super::{OutputError, finite, write_files, write_picture};
use crate::case::CaseEcho;
use crate::params::OutputParams;
use crate::study::{CurveSolution, Outcome, PointSolution};
use ertel_plot::Chart;

/// Writes the results of a curve into one folder, as [`super::write`] does; `folders` adds the results of each
/// solved point in a separate folder, `points/01`.
///
/// # Errors
/// [`OutputError`]; the target is then unchanged.
pub fn write_curve(
    case: &CaseEcho,
    curve: &CurveSolution,
    target: &Path,
    params: &OutputParams,
    folders: bool,
) -> Result<(), OutputError> {
    check_curve(curve)?;
    let folder = NewFolder::next_to(target)?;
    write_files_of_curve(folder.root(), case, curve, params)?;
    if folders {
        let width = curve.n_points.to_string().len();
        for (i, point) in curve.points.iter().enumerate() {
            if let Some(run) = point.outcome.in_time() {
                let part = folder.point(&format!("{:0width$}", i + 1))?;
                let instants = run.instants.as_ref().expect("they are kept for folders");
                write_files_in_time(&part, &point.case, instants, params)?;
            }
            let Outcome::Solved(solution) = &point.outcome else {
                continue;
            };
            let part = folder.point(&format!("{:0width$}", i + 1))?;
            match &point.machine {
                None => write_files(&part, &point.case, solution, params)?,
                Some(of) => {
                    let (solution, figures) = (&of.solution, &of.figures);
                    write_files_of_machine(&part, &point.case, solution, figures, params)?;
                }
            }
        }
    }
    folder.finish()
}

/// The curve's files, as written by [`write_curve`], in memory.
///
/// # Errors
/// As [`super::files`].
pub fn curve_files(
    case: &CaseEcho,
    curve: &CurveSolution,
    params: &OutputParams,
) -> Result<Vec<OutputFile>, OutputError> {
    check_curve(curve)?;
    let folder = Part::in_memory();
    write_files_of_curve(&folder, case, curve, params)?;
    Ok(folder.into_files())
}

fn check_curve(curve: &CurveSolution) -> Result<(), OutputError> {
    for (i, point) in curve.points.iter().enumerate() {
        let run = point.outcome.in_time();
        if let Some(instants) = run.and_then(|run| run.instants.as_ref()) {
            check_finite(instants)?;
        }
        if let Some(machine) = &point.machine {
            check_machine(&machine.solution, &machine.figures)?;
        }
        let simpler = [&point.newtonian, &point.isothermal].map(Option::as_ref);
        for outcome in [[Some(&point.outcome); 1].as_slice(), &simpler].concat() {
            let solution = outcome.and_then(Outcome::solution);
            if let Some(what) = solution.and_then(|s| finite::first_not_finite(&point.case, s)) {
                let what = format!("{what}, in point {}", i + 1);
                return Err(OutputError::NotFinite { what });
            }
        }
    }
    Ok(())
}

fn write_files_of_curve(
    root: &Part,
    case: &CaseEcho,
    curve: &CurveSolution,
    params: &OutputParams,
) -> Result<(), OutputError> {
    root.json("curve.json", curve_json(case, curve))?;
    root.bytes("curve.csv", curve_table(curve))?;
    root.bytes("report.txt", curve_report(case, curve, None))?;
    root.bytes(REPORT_PAGE, curve_page(case, curve))?;
    if let Some(text) = &case.case_file {
        root.bytes("case.toml", text)?;
    }
    for picture in pictures(&case.title, curve) {
        write_picture(root, &picture, params.pictures)?;
    }
    Ok(())
}

/// Every picture of a curve.
fn pictures(title: &str, curve: &CurveSolution) -> Vec<Picture> {
    let has_figures = |point: &PointSolution| point.machine.is_some() || point.is_in_time;
    if curve.points.iter().any(has_figures) {
        return machine::pictures(title, curve);
    }
    let picture = |name, chart: Chart| Picture::new(name, chart.drawing());
    let film = picture("film-curve", film_chart(title, curve));
    let traction = traction_chart(title, curve).map(|chart| picture("traction-curve", chart));
    let stribeck = stribeck_chart(title, curve).map(|chart| picture("stribeck", chart));
    [Some(film), traction, stribeck]
        .into_iter()
        .flatten()
        .collect()
}
