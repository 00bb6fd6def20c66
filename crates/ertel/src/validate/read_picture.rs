//! Reading the pictures of a study.

use ertel_rheology::input::{Bounds, InputError, Table};

use super::profiles::Profile;
use super::read::{formula_key, indices};
use super::{Picture, PictureKind, Quantity, Study};
use crate::reference::FilmFormula;

pub(super) fn read_picture(mut table: Table<'_>, study: &Study) -> Result<Picture, InputError> {
    let name = table.required_str("name")?.to_owned();
    let caption = table.required_str("caption")?.to_owned();
    let kinds = [
        "centreline",
        "deflection",
        "deflection-error",
        "film-over-load",
        "penalty",
        "profiles",
        "pressures",
        "films",
        "mid-temperatures",
        "cross-film",
        "temperatures",
        "map",
        "film-curves",
        "film-shape",
        "traction-curves",
    ]
    .map(|k| (k, k));
    let range = match table.optional_numbers("range", Bounds::ANY)? {
        Some(range) => Some(pair(&table, "range", &range, "`range` is [low, high]")?),
        None => None,
    };
    let kind = match table.required_choice("kind", &kinds)? {
        "centreline" => PictureKind::Centreline(picture_run(&mut table, study)?),
        "map" => {
            let fields = MAPS.map(|name| (name, name));
            let field = table.required_choice("field", &fields)?;
            PictureKind::Map(picture_run(&mut table, study)?, field)
        }
        "deflection" => PictureKind::Deflection,
        "deflection-error" => PictureKind::DeflectionError,
        "film-over-load" => {
            let formulas = FilmFormula::ALL.map(|f| (formula_key(f), f));
            let formula = table.required_choice("formula", &formulas)?;
            PictureKind::FilmOverLoad(formula, picture_runs(&mut table, study)?)
        }
        "profiles" => {
            let (runs, columns) = panels(&mut table, study)?;
            PictureKind::Profiles(runs, columns)
        }
        "cross-film" => {
            let (runs, columns) = panels(&mut table, study)?;
            PictureKind::CrossFilm(runs, columns)
        }
        "temperatures" => {
            let (runs, columns) = panels(&mut table, study)?;
            PictureKind::Temperatures(runs, columns)
        }
        kind @ ("pressures" | "films" | "mid-temperatures") => {
            let runs = picture_runs(&mut table, study)?;
            let zoom = table.optional_numbers("zoom", Bounds::ANY)?;
            let zoom = zoom.ok_or_else(|| table.missing("zoom"))?;
            let zoom = pair(&table, "zoom", &zoom, "`zoom` is [from, to] in X")?;
            let profile = match kind {
                "pressures" => Profile::Pressure,
                "films" => Profile::Film,
                _ => Profile::Temperature,
            };
            PictureKind::Overlay(profile, runs, zoom)
        }
        "film-curves" => PictureKind::FilmCurves(picture_runs(&mut table, study)?),
        "film-shape" => PictureKind::FilmShape(picture_run(&mut table, study)?),
        "traction-curves" => PictureKind::TractionCurves(picture_runs(&mut table, study)?),
        _ => {
            let quantities = Quantity::ALL.map(|q| (q.key(), q));
            PictureKind::Penalty(table.required_choice("quantity", &quantities)?)
        }
    };
    table.finish()?;
    Ok(Picture {
        name,
        caption,
        kind,
        range,
    })
}

/// Maps of a solution that a study can show.
const MAPS: [&str; 5] = [
    "pressure",
    "film",
    "temperature-mid",
    "temperature-plane",
    "temperature-ball",
];

fn pair(
    table: &Table<'_>,
    key: &str,
    numbers: &[f64],
    message: &str,
) -> Result<[f64; 2], InputError> {
    match *numbers {
        [low, high] => Ok([low, high]),
        _ => Err(table.error(key, message)),
    }
}

/// `run` of a picture of one run.
fn picture_run(table: &mut Table<'_>, study: &Study) -> Result<usize, InputError> {
    let run = table.required_str("run")?;
    Ok(indices(table, "run", &[run], study)?[0])
}

/// `runs` of a picture of panels, and its `columns`.
fn panels(table: &mut Table<'_>, study: &Study) -> Result<(Vec<usize>, usize), InputError> {
    let runs = picture_runs(table, study)?;
    let columns = table.optional_integer("columns", 1..=4)?;
    let columns = columns.and_then(|n| usize::try_from(n).ok());
    Ok((runs, columns.unwrap_or(2)))
}

/// `runs` of a picture, all if left out.
fn picture_runs(table: &mut Table<'_>, study: &Study) -> Result<Vec<usize>, InputError> {
    match table.optional_strs("runs")? {
        Some(runs) => indices(table, "runs", &runs, study),
        None => Ok((0..study.runs.len()).collect()),
    }
}
