//! Heights over a plane: measured ones of a file, and those that are made.

use std::path::Path;
use std::sync::Arc;

use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::{Dimension, Unit};
use serde::Serialize;

use super::reader::{Layout, MOST_POINTS, MapError, read};
use super::{HEIGHT, SIZE, direction};
use crate::contact::gap::{Form, HeightMap};
use crate::contact::topography::{
    Generated, Levelling, Parameters, Pass, SelfAffine, Spectrum, Topography, radial_spectrum,
    spectrum,
};
use crate::words::length;

/// Source, treatment and description of heights.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SurfaceEcho {
    /// The file as the case names it; `None` where they are made.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// Format of the file, or "generated".
    pub format: &'static str,
    /// xxh3 of its bytes, 16 hexadecimal digits.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hash: Option<String>,
    /// Points in a row, and rows; one row of a profile.
    pub points: [usize; 2],
    /// Distances of points in a row, and of rows, m.
    pub spacing: [f64; 2],
    /// Points without a height, which a membrane through those about them filled.
    pub missing: usize,
    /// Form that was subtracted.
    pub level: &'static str,
    /// Cutoff of the filter that shorter waves pass, m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub high_pass: Option<f64>,
    /// Cutoff of the filter that longer waves pass, m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub low_pass: Option<f64>,
    /// Width over which heights fall to zero along the rim, m.
    pub taper: f64,
    /// Parameters of the levelled surface.
    pub levelled: Parameters,
    /// Those of the filtered one, before the taper.
    pub filtered: Parameters,
    /// Spectra of the levelled surface, along the rows and across them.
    pub levelled_spectra: [Spectrum; 2],
    /// Those of the filtered one.
    pub filtered_spectra: [Spectrum; 2],
    /// Spectrum of the levelled surface over all directions; none of a profile.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub levelled_radial_spectrum: Option<Spectrum>,
    /// That of the filtered one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub filtered_radial_spectrum: Option<Spectrum>,
}

/// Share of points without a height that is filled where the case does not say another.
const MISSING: f64 = 0.05;
/// Share of the shorter side over which heights fall to zero where the case does not say.
const TAPER: f64 = 0.1;
/// Distances of points that make up the shortest wavelength they can have, and points of a wavelength of surfaces that are made.
const SHORTEST: f64 = 2.0;
const POINTS_OF_WAVE: f64 = 6.0;

/// `kind = "map"`.
pub(super) fn measured(
    table: &mut Table<'_>,
    is_line: bool,
    folder: &Path,
) -> Result<(Form, SurfaceEcho), InputError> {
    let file = table.required_str("file")?;
    let layouts = [("rows", false), ("points", true)];
    let layout = Layout {
        spacing: table.optional_quantity("spacing", Dimension::LENGTH, SIZE)?,
        row_spacing: table.optional_quantity("row_spacing", Dimension::LENGTH, SIZE)?,
        height_unit: unit(table, "height_unit")?,
        length_unit: unit(table, "length_unit")?,
        has_points: table.optional_choice("layout", &layouts)?.unwrap_or(false),
    };
    let most = table
        .optional_number("missing_share", Bounds::closed(0.0, 0.5))?
        .unwrap_or(MISSING);
    let levels = [
        ("none", None),
        ("mean", Some(Levelling::Mean)),
        ("plane", Some(Levelling::Plane)),
        ("quadratic", Some(Levelling::Quadratic)),
    ];
    let level = (table.optional_choice("level", &levels)?).unwrap_or(Some(Levelling::Plane));
    let high_pass = table.optional_quantity("high_pass", Dimension::LENGTH, SIZE)?;
    let low_pass = table.optional_quantity("low_pass", Dimension::LENGTH, SIZE)?;
    let taper = table.optional_quantity("taper", Dimension::LENGTH, SIZE)?;
    let direction = direction(table, is_line, 1.0)?;
    let path = folder.join(file);
    let heights = read(&path, &layout).map_err(|error| {
        let key = match error {
            MapError::Redundant { key, .. } => key,
            _ => "file",
        };
        let text = match error {
            MapError::Csv(error) => error.to_string(),
            error => format!("{} {error}", path.display()),
        };
        table.error(key, text)
    })?;
    let mut map = heights.map;
    if is_line && !map.is_profile() {
        return Err(table.error(
            "file",
            format!(
                "{} has {} rows: a line contact, along which all is the same, takes a profile of one row",
                path.display(),
                map.counts[1]
            ),
        ));
    }
    let missing = map.n_holes();
    check_holes(table, missing, map.heights.len(), most)?;
    if level.is_some_and(|level| !map.level(level)) || !map.fill() {
        return Err(table.error("file", "too few points have a height to level the surface"));
    }
    let own = Own {
        file: Some(file.to_owned()),
        format: heights.format.words(),
        heights_by: heights.format.heights_by(),
        hash: Some(format!("{:016x}", heights.hash)),
        missing,
        level: levels
            .iter()
            .find(|(_, own)| *own == level)
            .map_or("none", |(name, _)| name),
        high_pass,
        low_pass,
    };
    let finest = low_pass.unwrap_or(SHORTEST * finest_spacing(&map));
    finished(table, map, own, taper, (finest, direction))
}

/// Refuses a map in which a larger share than `most` of its `n` points have no height.
fn check_holes(table: &Table<'_>, missing: usize, n: usize, most: f64) -> Result<(), InputError> {
    if missing as f64 <= most * n as f64 {
        return Ok(());
    }
    Err(table
        .error(
            "file",
            format!(
                "{missing} of {n} points have no height, {} %, and at most {} % are filled",
                crate::words::digits(100.0 * missing as f64 / n as f64, 3),
                crate::words::digits(100.0 * most, 3)
            ),
        )
        .with_help("fill them in the instrument, crop them, or raise `missing_share`"))
}

/// `kind = "generated"`.
pub(super) fn generated(
    table: &mut Table<'_>,
    is_line: bool,
) -> Result<(Form, SurfaceEcho), InputError> {
    let size = |table: &mut Table<'_>, key| table.required_quantity(key, Dimension::LENGTH, SIZE);
    let along = size(table, "length")?;
    let across = match is_line {
        true => None,
        false => Some(size(table, "width")?),
    };
    let law = SelfAffine {
        rolloff: size(table, "rolloff_wavelength")?,
        shortest: size(table, "shortest_wavelength")?,
        hurst: table.required_number("hurst_exponent", Bounds::closed(0.0, 1.0))?,
        sq: table.required_quantity("rms_height", Dimension::LENGTH, HEIGHT)?,
        anisotropy: match is_line {
            true => 1.0,
            false => {
                (table.optional_number("anisotropy", Bounds::closed(0.01, 100.0))?).unwrap_or(1.0)
            }
        },
        lay: 0.0,
    };
    let seed = table.required_integer("seed", 0..=i64::from(u32::MAX))?;
    let taper = table.optional_quantity("taper", Dimension::LENGTH, SIZE)?;
    let direction = direction(table, is_line, 1.0)?;
    if law.rolloff < law.shortest {
        return Err(table.error(
            "rolloff_wavelength",
            "it is shorter than `shortest_wavelength`",
        ));
    }
    let points = |length: f64| (POINTS_OF_WAVE * length / law.shortest).ceil() + 1.0;
    let counts = [points(along), across.map_or(1.0, points)];
    if counts[0] * counts[1] > MOST_POINTS as f64 {
        return Err(table.error(
            "shortest_wavelength",
            format!(
                "{} x {} points are too many, {POINTS_OF_WAVE} over the shortest wavelength: at most {MOST_POINTS}",
                counts[0], counts[1]
            ),
        ));
    }
    let mut random = fastrand::Rng::with_seed(seed as u64);
    let made = Generated {
        law,
        counts: counts.map(|n| n as usize),
        spacing: [
            along / (counts[0] - 1.0),
            across.map_or(1.0, |w| w / (counts[1] - 1.0)),
        ],
    };
    let map = (made.make(|| random.f64()))
        .filter(|map| map.counts[0] >= 4 && (is_line || map.counts[1] >= 4));
    let Some(map) = map else {
        return Err(table.error("length", "no wave of the spectrum fits into the surface"));
    };
    let own = Own {
        file: None,
        format: "generated",
        heights_by: "`rms_height`",
        hash: None,
        missing: 0,
        level: "none",
        high_pass: None,
        low_pass: None,
    };
    finished(table, map, own, taper, (law.shortest, direction))
}

/// Heights before they are filtered.
struct Own {
    file: Option<String>,
    format: &'static str,
    /// The input that scales the heights.
    heights_by: &'static str,
    hash: Option<String>,
    missing: usize,
    level: &'static str,
    high_pass: Option<f64>,
    low_pass: Option<f64>,
}

/// Distance of points: the larger one of a map.
fn finest_spacing(map: &Topography) -> f64 {
    match map.is_profile() {
        true => map.spacing[0],
        false => map.spacing[0].max(map.spacing[1]),
    }
}

/// Refuses filters that no wave of the surface passes; `spacing` of its points and its shorter `side` in m.
fn check_filters(table: &Table<'_>, own: &Own, spacing: f64, side: f64) -> Result<(), InputError> {
    for (key, cutoff) in [("high_pass", own.high_pass), ("low_pass", own.low_pass)] {
        if let Some(cutoff) = cutoff.filter(|c| *c < SHORTEST * spacing || *c > side) {
            return Err(table.error(
                key,
                format!(
                    "a cutoff of {} is outside the wavelengths of the surface: from {} (twice the distance of its points) to {} (its shorter side)",
                    length(cutoff),
                    length(SHORTEST * spacing),
                    length(side)
                ),
            ));
        }
    }
    match (own.high_pass, own.low_pass) {
        (Some(high), Some(low)) if high <= low => Err(table.error(
            "low_pass",
            "no wave passes both filters: `low_pass` must be shorter than `high_pass`",
        )),
        _ => Ok(()),
    }
}

/// The width of the taper: that of the case, or the usual one, two distances of points at least where the surface has as many.
fn taper_width(
    table: &Table<'_>,
    taper: Option<f64>,
    spacing: f64,
    side: f64,
) -> Result<f64, InputError> {
    let [least, most] = [(SHORTEST * spacing).min(0.5 * side), 0.5 * side];
    let taper = taper.unwrap_or((TAPER * side).max(least));
    if taper < least || taper > most {
        return Err(table.error(
            "taper",
            format!(
                "a taper of {}: from {}, two distances of points, to {}, half of the shorter side",
                length(taper),
                length(least),
                length(most)
            ),
        ));
    }
    Ok(taper)
}

/// Filters, describes and tapers heights, and lays a spline through them.
fn finished(
    table: &Table<'_>,
    mut map: Topography,
    own: Own,
    taper: Option<f64>,
    (finest, direction): (f64, f64),
) -> Result<(Form, SurfaceEcho), InputError> {
    let spacing = finest_spacing(&map);
    let [along, across] = map.sides();
    let side = if map.is_profile() {
        along
    } else {
        along.min(across)
    };
    check_filters(table, &own, spacing, side)?;
    let taper = taper_width(table, taper, spacing, side)?;
    let levelled = map.parameters();
    let spectra = |map: &Topography| [0, 1].map(|d| spectrum(map, d));
    let levelled_spectra = spectra(&map);
    let levelled_radial_spectrum = radial_spectrum(&map);
    for (pass, cutoff) in [(Pass::Short, own.high_pass), (Pass::Long, own.low_pass)] {
        if let Some(cutoff) = cutoff {
            map.filter(pass, cutoff);
        }
    }
    let (filtered, filtered_spectra) = (map.parameters(), spectra(&map));
    if !HEIGHT.contains(filtered.sz) {
        return Err(table.error(
            if own.file.is_some() {
                "file"
            } else {
                "rms_height"
            },
            format!(
                "heights of the surface differ by {}, where 1 pm to 1 mm is a relief; check {}",
                length(filtered.sz),
                own.heights_by
            ),
        ));
    }
    let echo = SurfaceEcho {
        file: own.file,
        format: own.format,
        hash: own.hash,
        points: map.counts,
        spacing: map.spacing,
        missing: own.missing,
        level: own.level,
        high_pass: own.high_pass,
        low_pass: own.low_pass,
        taper,
        levelled,
        filtered,
        levelled_spectra,
        filtered_spectra,
        levelled_radial_spectrum,
        filtered_radial_spectrum: radial_spectrum(&map),
    };
    map.taper(taper);
    let form = Form::Map {
        map: Arc::new(HeightMap::new(map.counts, map.spacing, &map.heights)),
        units: [1.0, 1.0],
        finest,
        direction,
    };
    Ok((form, echo))
}

/// A unit of length, m.
fn unit(table: &mut Table<'_>, key: &str) -> Result<Option<f64>, InputError> {
    let Some(text) = table.optional_str(key)? else {
        return Ok(None);
    };
    match Unit::parse_as(text, Dimension::LENGTH) {
        Ok(unit) => Ok(Some(unit.to_si(1.0))),
        Err(error) => Err(table
            .error(key, error.to_string())
            .with_help("a unit of length, such as \"nm\", \"um\" or \"m\"")),
    }
}
