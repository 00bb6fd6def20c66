//! Reading the pictures of a study.

use ertel_input::{Bounds, InputError, Table};

use super::instants::read_published;
use super::profiles::Profile;
use super::{Picture, PictureKind, Quantity, Study};
use ertel::reference::FilmFormula;

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
        "pressures-across",
        "films",
        "mid-temperatures",
        "cross-film",
        "temperatures",
        "map",
        "film-curves",
        "film-shape",
        "traction-curves",
        "instants",
    ]
    .map(|k| (k, k));
    let kind_name = table.required_choice("kind", &kinds)?;
    let kind = match kind_name {
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
        kind @ ("pressures" | "pressures-across" | "films" | "mid-temperatures") => {
            let runs = picture_runs(&mut table, study)?;
            let zoom = table.optional_numbers("zoom", Bounds::ANY)?;
            let zoom = zoom.ok_or_else(|| table.missing("zoom"))?;
            let zoom = pair(&table, "zoom", &zoom, "`zoom` is [from, to] in X")?;
            let profile = match kind {
                "pressures" => Profile::Pressure,
                "pressures-across" => Profile::PressureAcross,
                "films" => Profile::Film,
                _ => Profile::Temperature,
            };
            PictureKind::Overlay(profile, runs, zoom)
        }
        "instants" => {
            let run = picture_run(&mut table, study)?;
            let columns = columns(&mut table)?;
            PictureKind::Instants(run, read_published(&mut table, study, run)?, columns)
        }
        "film-curves" => PictureKind::FilmCurves(picture_runs(&mut table, study)?),
        "film-shape" => PictureKind::FilmShape(picture_run(&mut table, study)?),
        "traction-curves" => PictureKind::TractionCurves(picture_runs(&mut table, study)?),
        _ => {
            let quantities = Quantity::all()
                .into_iter()
                .map(|q| (q.key(), q))
                .collect::<Vec<_>>();
            PictureKind::Penalty(table.required_choice("quantity", &quantities)?)
        }
    };
    let range = range(&mut table, kind_name, &kind)?;
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
    "temperature-body-1",
    "temperature-body-2",
];

/// `range` of a picture with a left axis.
fn range(
    table: &mut Table<'_>,
    name: &str,
    kind: &PictureKind,
) -> Result<Option<[f64; 2]>, InputError> {
    let Some(range) = table.optional_numbers("range", Bounds::ANY)? else {
        return Ok(None);
    };
    if !kind.has_left_axis() {
        let message = format!("a picture of kind `{name}` has no `range`");
        let help = "`range` belongs to centreline, deflection, deflection-error, film-over-load, penalty, film-curves, \
                    film-shape and traction-curves; remove it here";
        return Err(table.error("range", message).with_help(help));
    }
    match pair(table, "range", &range, "`range` is [low, high]")? {
        [low, high] if low < high => Ok(Some([low, high])),
        _ => Err(table.error("range", "`range` is [low, high], the lower end first")),
    }
}

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
    Ok((runs, columns(table)?))
}

/// `columns` of a picture of panels.
fn columns(table: &mut Table<'_>) -> Result<usize, InputError> {
    let columns = table.optional_integer("columns", 1..=4)?;
    let columns = columns.and_then(|n| usize::try_from(n).ok());
    Ok(columns.unwrap_or(2))
}

/// `runs` of a picture, all if absent.
fn picture_runs(table: &mut Table<'_>, study: &Study) -> Result<Vec<usize>, InputError> {
    match table.optional_strs("runs")? {
        Some(runs) => indices(table, "runs", &runs, study),
        None => Ok((0..study.runs.len()).collect()),
    }
}

pub(super) fn indices(
    table: &Table<'_>,
    key: &str,
    names: &[&str],
    study: &Study,
) -> Result<Vec<usize>, InputError> {
    names
        .iter()
        .map(|name| {
            let found = study.runs.iter().position(|run| run.name == *name);
            found.ok_or_else(|| table.error(key, format!("no run is called `{name}`")))
        })
        .collect()
}

pub(super) fn formula_key(formula: FilmFormula) -> &'static str {
    match formula {
        FilmFormula::HamrockDowson => "hamrock-dowson",
        FilmFormula::NijenbanningVennerMoes => "nijenbanning-venner-moes",
        FilmFormula::VennerIsoviscous => "venner-isoviscous",
        FilmFormula::Chittenden => "chittenden",
        FilmFormula::MoesLine => "moes-line",
        FilmFormula::DowsonHigginson => "dowson-higginson",
        FilmFormula::DowsonHigginson1966 => "dowson-higginson-1966",
        FilmFormula::DowsonToyoda => "dowson-toyoda",
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use ertel_input::Document;

    use super::*;

    fn read(text: &str) -> Result<Picture, InputError> {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation/line-moes");
        let study = crate::read(&folder).unwrap();
        let text = format!("name = \"p\"\ncaption = \"c\"\n{text}");
        read_picture(Document::parse("r.toml", &text).unwrap().root(), &study)
    }

    /// Kinds without a left axis refuse a range of it, with place and choices; the others take it.
    #[test]
    fn range_belongs_to_a_left_axis() {
        for (kind, rest) in [
            ("profiles", ""),
            ("cross-film", ""),
            ("temperatures", ""),
            ("films", "zoom = [0, 1]"),
            ("map", "field = \"film\"\nrun = \"Barus, M 5, L 0\""),
        ] {
            let text = format!("kind = \"{kind}\"\n{rest}\n");
            assert_eq!(read(&text).unwrap().range, None);
            let error = read(&format!("range = [1, 2]\n{text}"))
                .unwrap_err()
                .to_string();
            assert!(
                error.contains(&format!("a picture of kind `{kind}` has no `range`")),
                "{error}"
            );
            assert!(
                error.contains("r.toml:3:") && error.contains("film-curves"),
                "{error}"
            );
        }
        for kind in ["deflection", "film-curves", "traction-curves"] {
            let ranged = |range: &str| read(&format!("kind = \"{kind}\"\nrange = {range}\n"));
            assert_eq!(ranged("[1, 2]").unwrap().range, Some([1.0, 2.0]));
            for wrong in ["[2, 1]", "[1]"] {
                let error = ranged(wrong).unwrap_err().to_string();
                assert!(
                    error.contains("r.toml:4:") && error.contains("[low, high]"),
                    "{error}"
                );
            }
        }
    }
}
