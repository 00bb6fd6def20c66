//! Heights as text: rows of them, or points with their places.

use ertel_input::csv::{CsvParams, CsvTable, Vocabulary, is_missing};
use ertel_quantity::Dimension;

use super::{LEAST_POINTS, Layout, MOST_POINTS, MapError, checked};
use crate::contact::topography::Topography;

/// How a point without a height is written.
const NO_HEIGHT: &str = "nan";
/// Relative difference of distances of points that count as equal.
const EQUAL: f64 = 0.01;

/// Places and heights, as the program calls them.
const COLUMNS: Vocabulary<'static> = Vocabulary {
    names: &["x", "y", "z"],
    is_key: &|_| false,
};
/// Bytes from the beginning on among which titles are looked for.
const HEAD: usize = 32_768;

/// Whether a line names columns of places and heights: with their units, or as more than a comment.
pub(super) fn has_header(text: &str) -> bool {
    let end = match text.as_bytes().get(..HEAD) {
        Some(head) => head.iter().rposition(|b| *b == b'\n').unwrap_or(0),
        None => text.len(),
    };
    // Errors further down are reported by the reader of the table.
    let first = || text[..end].lines().find(|line| !is_left_out(line));
    names_columns(&text[..end])
        .or_else(|| names_columns(first()?))
        .unwrap_or(false)
}

/// The same of a table; `None` where it is none.
fn names_columns(text: &str) -> Option<bool> {
    let table = CsvTable::parse_for("", text, &COLUMNS, &CsvParams::default()).ok()?;
    let found = ["x", "z"].map(|name| table.find_with_unit(name, Dimension::LENGTH));
    Some(match found {
        [Ok(Some(_)), Ok(Some(_))] => true,
        // A title without its unit.
        [Ok(Some(_)) | Err(_), Ok(Some(_)) | Err(_)] => {
            !is_left_out(&text[table.header().span.clone()])
        }
        _ => false,
    })
}

/// Empty lines and comments.
fn is_left_out(line: &str) -> bool {
    let line = line.trim();
    line.is_empty() || line.starts_with('#')
}

/// Cells of a line: between semicolons, tabs or commas, or else spaces. Numbers between semicolons, tabs or spaces may have a decimal comma.
fn cells(line: &str, separator: Option<char>) -> Vec<&str> {
    // A row of more is refused; what comes behind it would fill the memory.
    let most = MOST_POINTS + 1;
    match separator {
        None => {
            let mut cells: Vec<&str> = Vec::new();
            for word in line.split_whitespace().take(most) {
                match cells.last_mut() {
                    // Two words for one height that is not there.
                    Some(last)
                        if last.eq_ignore_ascii_case("no") && word.eq_ignore_ascii_case("data") =>
                    {
                        *last = NO_HEIGHT;
                    }
                    _ => cells.push(word),
                }
            }
            cells
        }
        // A separator at the end of a line separates nothing.
        Some(c) => (line.trim_end().strip_suffix(c).unwrap_or(line))
            .split(c)
            .take(most)
            .map(str::trim)
            .collect(),
    }
}

fn separator(text: &str) -> Option<char> {
    let first = text
        .lines()
        .find(|line| !is_left_out(line))
        .unwrap_or_default();
    [';', '\t', ',']
        .into_iter()
        .find(|c| first.trim().contains(*c))
}

/// A number, or not a number where a point has no height.
fn number(cell: &str, separator: Option<char>, line: usize) -> Result<f64, MapError> {
    if is_missing(cell) {
        return Ok(f64::NAN);
    }
    let with_point = match separator {
        Some(',') => cell.to_owned(),
        _ => cell.replacen(',', ".", 1),
    };
    match with_point.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        Ok(_) => Err(MapError::at(
            line,
            format!("\"{cell}\" is no finite height; a point without one is written nan"),
        )),
        Err(_) => Err(MapError::at(line, format!("\"{cell}\" is no number"))),
    }
}

/// Lines with content and their numbers.
fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    (text.lines().enumerate())
        .filter(|(_, line)| !is_left_out(line))
        .map(|(i, line)| (i + 1, line))
}

/// Rows of heights, the first one at the lowest y; one number a line is a profile.
pub(super) fn parse_rows(text: &str, layout: &Layout) -> Result<Topography, MapError> {
    if layout.length_unit.is_some() {
        return Err(MapError::Redundant {
            what: "rows of heights without places (`spacing` includes its unit)",
            key: "length_unit",
        });
    }
    let unit = layout.height_unit.ok_or(MapError::Missing {
        what: "the unit of its heights",
        key: "height_unit",
        example: "um",
    })?;
    let spacing = layout.spacing.ok_or(MapError::Missing {
        what: "the distance of its points",
        key: "spacing",
        example: "1 um",
    })?;
    let separator = separator(text);
    let (mut heights, mut width, mut n) = (Vec::new(), None, 0);
    for (line, content) in lines(text) {
        let cells = cells(content, separator);
        let width = *width.get_or_insert(cells.len());
        if cells.len() != width {
            return Err(MapError::at(
                line,
                format!(
                    "{} heights, where the rows before have {width}",
                    cells.len()
                ),
            ));
        }
        for cell in cells {
            heights.push(unit * number(cell, separator, line)?);
        }
        if heights.len() > MOST_POINTS {
            return Err(MapError::at(
                line,
                format!("more than {MOST_POINTS} points: export fewer"),
            ));
        }
        n += 1;
    }
    let counts = match width {
        None => return Err(MapError::content("the file has no heights")),
        Some(1) => [n, 1],
        Some(width) => [width, n],
    };
    Ok(Topography {
        counts: checked(counts)?,
        spacing: [spacing, layout.row_spacing.unwrap_or(spacing)],
        heights,
    })
}

/// Lines of x, y and z, in any order.
pub(super) fn parse_points(text: &str, layout: &Layout) -> Result<Topography, MapError> {
    let [length, height] = [
        (layout.length_unit, "the unit of its places", "length_unit"),
        (layout.height_unit, "the unit of its heights", "height_unit"),
    ]
    .map(|(unit, what, key)| {
        unit.ok_or(MapError::Missing {
            what,
            key,
            example: "um",
        })
    });
    let (length, height) = (length?, height?);
    let separator = separator(text);
    let mut points = Vec::new();
    for (line, content) in lines(text) {
        let cells = cells(content, separator);
        let [x, y, z] = cells.as_slice() else {
            return Err(MapError::at(
                line,
                format!("{} numbers, where a point has x, y and z", cells.len()),
            ));
        };
        let place = |cell: &str| match number(cell, separator, line)? {
            value if value.is_nan() => Err(MapError::at(line, "a point without a place")),
            value => Ok(length * value),
        };
        points.push([place(x)?, place(y)?, height * number(z, separator, line)?]);
        if points.len() > MOST_POINTS {
            return Err(MapError::at(
                line,
                format!("more than {MOST_POINTS} points: export fewer"),
            ));
        }
    }
    gridded(&points)
}

/// A table with the columns x, z and, but of a profile, y, with their units.
pub(super) fn parse_csv(file: &str, text: &str) -> Result<Topography, MapError> {
    let csv = CsvTable::parse_for(file, text, &COLUMNS, &CsvParams::default())?;
    let required = |name: &'static str| {
        csv.find_with_unit(name, Dimension::LENGTH)?
            .ok_or_else(|| csv.error(csv.header(), 0, format!("there is no column `{name}`")))
    };
    let (x, z) = (required("x")?, required("z")?);
    let y = csv.find_with_unit("y", Dimension::LENGTH)?;
    if csv.rows().len() > MOST_POINTS {
        return Err(MapError::content(format!(
            "more than {MOST_POINTS} points: export fewer"
        )));
    }
    let mut points = Vec::with_capacity(csv.rows().len());
    for row in csv.rows() {
        let y = match &y {
            Some(y) => csv.required_number(row, y)?,
            None => 0.0,
        };
        let z = csv.number(row, &z)?.unwrap_or(f64::NAN);
        points.push([csv.required_number(row, &x)?, y, z]);
    }
    gridded(&points)
}

/// Points on a grid whose rows lie along x; those that are not there have no height.
pub(super) fn gridded(points: &[[f64; 3]]) -> Result<Topography, MapError> {
    if points.is_empty() {
        return Err(MapError::content("the file has no points"));
    }
    let axes = [0, 1].map(|d| axis(points.iter().map(|p| p[d]).collect(), d));
    let [(x, dx, nx), (y, dy, ny)] = axes;
    let (dx, dy) = match (dx?, dy?) {
        (Some(dx), dy) => (dx, dy.unwrap_or(dx)),
        (None, _) => {
            return Err(MapError::content(
                "all points have the same x: a profile lies along x",
            ));
        }
    };
    let counts = checked([nx, ny])?;
    let mut heights = vec![f64::NAN; nx * ny];
    let mut is_there = vec![false; nx * ny];
    for [px, py, z] in points {
        let (i, j) = (
            ((px - x) / dx).round() as usize,
            ((py - y) / dy).round() as usize,
        );
        let k = j * nx + i;
        if std::mem::replace(&mut is_there[k], true) {
            return Err(MapError::content(format!(
                "two points at x = {px:e} m, y = {py:e} m"
            )));
        }
        heights[k] = *z;
    }
    Ok(Topography {
        counts,
        spacing: [dx, dy],
        heights,
    })
}

/// First place, distance and number of places of points along an axis; no distance where they are one.
fn axis(mut values: Vec<f64>, d: usize) -> (f64, Result<Option<f64>, MapError>, usize) {
    values.sort_by(f64::total_cmp);
    let (first, last) = (values[0], values[values.len() - 1]);
    let length = last - first;
    let gaps = || values.windows(2).map(|pair| pair[1] - pair[0]);
    // Places that differ by rounding are one.
    let least = length * 1e-6;
    let Some(step) = gaps().filter(|gap| *gap > least).reduce(f64::min) else {
        return (first, Ok(None), 1);
    };
    let n = (length / step).round();
    if n >= MOST_POINTS as f64 {
        let text = format!(
            "points along {} lie at more than {MOST_POINTS} places",
            ["x", "y"][d]
        );
        return (first, Err(MapError::content(text)), LEAST_POINTS);
    }
    let step = length / n;
    let off = |value: &f64| {
        let at = (value - first) / step;
        (at - at.round()).abs() > EQUAL
    };
    let step = match values.iter().find(|value| off(value)) {
        None => Ok(Some(step)),
        Some(value) => Err(MapError::content(format!(
            "points do not lie at equal distances along {}: {value:e} m is none of the places {step:e} m apart",
            ["x", "y"][d]
        ))),
    };
    (first, step, n as usize + 1)
}
