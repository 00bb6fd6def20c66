//! X3P (ISO 25178-72): an archive with a description, `main.xml`, and the heights of a grid beside it or in it. Lengths are in metres.

use miniz_oxide::inflate::decompress_to_vec_with_limit;
use rawzip::{CompressionMethod, ZipArchive};
use roxmltree::{Document, Node};

use super::text::gridded;
use super::{MOST_POINTS, MapError, checked};
use crate::contact::topography::Topography;

/// Bytes of a description at most; heights in one take some tens each.
const LARGEST_DESCRIPTION: usize = 32 * MOST_POINTS;

/// A file of the archive, uncompressed; `None` where there is none.
fn file(archive: &[u8], name: &str, limit: usize) -> Result<Option<Vec<u8>>, MapError> {
    let damaged = |error: &dyn std::fmt::Display| {
        MapError::content(format!("the archive is damaged: {error}"))
    };
    let own = ZipArchive::from_slice(archive).map_err(|e| damaged(&e))?;
    for entry in own.entries() {
        let entry = entry.map_err(|e| damaged(&e))?;
        let path = entry.file_path();
        if !path.as_ref().eq_ignore_ascii_case(name.as_bytes()) {
            continue;
        }
        let place = own.get_entry(entry.wayfinder()).map_err(|e| damaged(&e))?;
        let content = match entry.compression_method() {
            CompressionMethod::STORE => place.data().to_vec(),
            CompressionMethod::DEFLATE => {
                decompress_to_vec_with_limit(place.data(), limit).map_err(|e| damaged(&e))?
            }
            _ => {
                return Err(MapError::content(format!(
                    "`{name}` in the archive is compressed by another method than deflate"
                )));
            }
        };
        if content.len() > limit || rawzip::crc32(&content) != entry.crc32() {
            return Err(damaged(&format!("`{name}` is not what it was")));
        }
        return Ok(Some(content));
    }
    Ok(None)
}

/// The text at a path of elements.
fn at<'a>(node: Node<'a, '_>, path: &[&str]) -> Option<&'a str> {
    let found = path.iter().try_fold(node, |node, name| {
        node.children()
            .find(|child| child.tag_name().name() == *name)
    })?;
    found.text().map(str::trim)
}

/// How heights are written.
#[derive(Clone, Copy)]
enum Number {
    Short,
    Long,
    Float,
    Double,
}

impl Number {
    /// That of an axis.
    fn of(root: Node<'_, '_>, axis: &str) -> Result<Number, MapError> {
        match at(root, &["Record1", "Axes", axis, "DataType"]) {
            Some("I") => Ok(Number::Short),
            Some("L") => Ok(Number::Long),
            Some("F") => Ok(Number::Float),
            Some("D") => Ok(Number::Double),
            other => Err(MapError::content(format!(
                "main.xml: {axis} has the data type {}, which is none of I, L, F and D",
                other.unwrap_or("of no name")
            ))),
        }
    }

    fn size(self) -> usize {
        match self {
            Number::Short => 2,
            Number::Long | Number::Float => 4,
            Number::Double => 8,
        }
    }

    /// Of its bytes, the lowest first.
    fn read(self, bytes: &[u8]) -> f64 {
        let first = |n: usize| {
            let mut own = [0; 8];
            own[..n].copy_from_slice(&bytes[..n]);
            own
        };
        let own = first(self.size());
        let [a, b, c, d, ..] = own;
        match self {
            Number::Short => f64::from(i16::from_le_bytes([a, b])),
            Number::Long => f64::from(i32::from_le_bytes([a, b, c, d])),
            Number::Float => f64::from(f32::from_le_bytes([a, b, c, d])),
            Number::Double => f64::from_le_bytes(own),
        }
    }
}

pub(super) fn parse(archive: &[u8]) -> Result<Topography, MapError> {
    let description = file(archive, "main.xml", LARGEST_DESCRIPTION)?
        .ok_or_else(|| MapError::content("the archive has no main.xml: it is no X3P file"))?;
    let text = String::from_utf8(description)
        .map_err(|_| MapError::content("main.xml is not UTF-8 text"))?;
    let xml = Document::parse(&text).map_err(|e| MapError::content(format!("main.xml: {e}")))?;
    let root = xml.root_element();
    let number = |path: &[&str]| -> Result<f64, MapError> {
        let name = path.join("/");
        let value =
            at(root, path).ok_or_else(|| MapError::content(format!("main.xml has no {name}")))?;
        match value.parse::<f64>() {
            Ok(value) if value.is_finite() && value > 0.0 => Ok(value),
            _ => Err(MapError::content(format!(
                "main.xml: {name} is \"{value}\", no positive number"
            ))),
        }
    };
    let count = |axis: &str| -> Result<usize, MapError> {
        number(&["Record3", "MatrixDimension", axis]).map(|n| n as usize)
    };
    let is_absolute = |axis: &str| {
        at(root, &["Record1", "Axes", axis, "AxisType"]).is_some_and(|kind| kind == "A")
    };
    if is_absolute("CX") || is_absolute("CY") {
        return placed(archive, root);
    }
    let counts = checked([count("SizeX")?, count("SizeY")?])?;
    if count("SizeZ")? != 1 {
        return Err(MapError::content(
            "main.xml: more than one layer of heights",
        ));
    }
    let increment = |axis: &str| number(&["Record1", "Axes", axis, "Increment"]);
    let spacing = [
        increment("CX")?,
        if counts[1] == 1 {
            1.0
        } else {
            increment("CY")?
        },
    ];
    let unit = increment("CZ").unwrap_or(1.0);
    let n = counts[0] * counts[1];
    let mut heights = match at(root, &["Record3", "DataLink", "PointDataLink"]) {
        Some(name) => {
            let kind = Number::of(root, "CZ")?;
            let bytes = file(archive, name, n * kind.size())?
                .ok_or_else(|| MapError::content(format!("the archive has no `{name}`")))?;
            if bytes.len() != n * kind.size() {
                return Err(MapError::content(format!(
                    "`{name}` has {} bytes, and {} x {} heights take {}",
                    bytes.len(),
                    counts[0],
                    counts[1],
                    n * kind.size()
                )));
            }
            (bytes
                .chunks_exact(kind.size())
                .map(|own| unit * kind.read(own)))
            .collect()
        }
        None => listed(root, unit)?,
    };
    if heights.len() != n {
        return Err(MapError::content(format!(
            "{} heights, where the matrix has {} x {}",
            heights.len(),
            counts[0],
            counts[1]
        )));
    }
    let is_valid = valid(archive, root, n)?;
    for (k, h) in heights.iter_mut().enumerate() {
        if !is_valid(k) {
            *h = f64::NAN;
        }
    }
    if heights.iter().any(|h| h.is_infinite()) {
        return Err(MapError::content("a height is infinite"));
    }
    Ok(Topography {
        counts,
        spacing,
        heights,
    })
}

/// Which of the points have a height: one bit a point, the lowest first.
fn valid(
    archive: &[u8],
    root: Node<'_, '_>,
    n: usize,
) -> Result<impl Fn(usize) -> bool + use<>, MapError> {
    let bits = match at(root, &["Record3", "DataLink", "ValidPointsLink"]) {
        None => None,
        Some(name) => {
            let bits = file(archive, name, n.div_ceil(8))?
                .filter(|bits| bits.len() == n.div_ceil(8))
                .ok_or_else(|| {
                    MapError::content(format!("`{name}` does not have a bit for each point"))
                })?;
            Some(bits)
        }
    };
    Ok(move |k: usize| {
        bits.as_ref()
            .is_none_or(|bits| bits[k / 8] >> (k % 8) & 1 == 1)
    })
}

/// Points that tell where they are (axes of the type A), of a matrix or a list: they must lie on a grid, in whatever order.
fn placed<'a>(archive: &[u8], root: Node<'a, 'a>) -> Result<Topography, MapError> {
    let count = |path: &[&str]| at(root, path).and_then(|text| text.parse::<usize>().ok());
    let rows = ["SizeX", "SizeY"].map(|size| count(&["Record3", "MatrixDimension", size]));
    let n = match (count(&["Record3", "ListDimension"]), rows) {
        (Some(n), _) => Some(n),
        (None, [Some(nx), Some(ny)]) => nx.checked_mul(ny),
        _ => None,
    };
    let n = n.filter(|n| (1..=MOST_POINTS).contains(n)).ok_or_else(|| {
        MapError::content(format!(
            "main.xml does not say how many points there are, 1 to {MOST_POINTS}"
        ))
    })?;
    let axis = |name: &'static str| -> Result<Axis, MapError> {
        let of = |key: &str| at(root, &["Record1", "Axes", name, key]);
        let increment = of("Increment").map_or(Some(1.0), |text| text.parse::<f64>().ok());
        let increment = increment.filter(|value| value.is_finite() && *value > 0.0);
        let increment = increment.ok_or_else(|| {
            MapError::content(format!(
                "main.xml: the increment of {name} is no positive number"
            ))
        })?;
        let is_absolute = name == "CZ" || of("AxisType") == Some("A");
        Ok(Axis {
            name,
            increment,
            is_absolute,
        })
    };
    let axes = [axis("CX")?, axis("CY")?, axis("CZ")?];
    if rows[0].is_none() && axes.iter().any(|axis| !axis.is_absolute) {
        return Err(MapError::content(
            "main.xml: in a list of points both x and y must be of the type A",
        ));
    }
    // Place in the matrix where an axis has equal distances.
    let own = |k: usize, d: usize| match (d, rows[0]) {
        (0, Some(nx)) => (k % nx) as f64,
        (1, Some(nx)) => (k / nx) as f64,
        _ => 0.0,
    };
    let told = |k: usize, mut next: Box<dyn FnMut(usize) -> f64 + '_>| {
        let mut point = [0.0; 3];
        for (d, axis) in axes.iter().enumerate() {
            let value = if axis.is_absolute { next(d) } else { own(k, d) };
            point[d] = axis.increment * value;
        }
        point
    };
    let mut points: Vec<[f64; 3]> = match at(root, &["Record3", "DataLink", "PointDataLink"]) {
        Some(name) => {
            let mut kinds = [None; 3];
            for (kind, axis) in kinds.iter_mut().zip(&axes) {
                if axis.is_absolute {
                    *kind = Some(Number::of(root, axis.name)?);
                }
            }
            let size: usize = kinds.iter().flatten().map(|kind| kind.size()).sum();
            let bytes = file(archive, name, n * size)?
                .ok_or_else(|| MapError::content(format!("the archive has no `{name}`")))?;
            if bytes.len() != n * size {
                return Err(MapError::content(format!(
                    "`{name}` has {} bytes, and {n} points take {}",
                    bytes.len(),
                    n * size
                )));
            }
            let point = |(k, mut bytes): (usize, &[u8])| {
                let next = move |d: usize| {
                    let Some(kind) = kinds[d] else { return 0.0 };
                    let (own, rest) = bytes.split_at(kind.size());
                    bytes = rest;
                    kind.read(own)
                };
                told(k, Box::new(next))
            };
            bytes.chunks_exact(size).enumerate().map(point).collect()
        }
        None => {
            let texts = data(root)?;
            let mut points = Vec::new();
            for (k, text) in texts.into_iter().enumerate() {
                let cells: Vec<&str> = text.split(';').map(str::trim).collect();
                let needed = axes.iter().filter(|axis| axis.is_absolute).count();
                if text.is_empty() {
                    points.push([f64::NAN; 3]);
                    continue;
                }
                // All three, or those alone that are told.
                if cells.len() != 3 && cells.len() != needed {
                    return Err(MapError::content(format!(
                        "main.xml: \"{text}\" is no point"
                    )));
                }
                let mut numbers = [0.0; 3];
                let mut rest = cells.iter();
                for (d, axis) in axes.iter().enumerate() {
                    if !axis.is_absolute && cells.len() == needed {
                        continue;
                    }
                    let cell = rest.next().copied().unwrap_or_default();
                    numbers[d] = match cell.parse::<f64>() {
                        Ok(value) => value,
                        Err(_) if cell.is_empty() && d == 2 => f64::NAN,
                        Err(_) => {
                            return Err(MapError::content(format!(
                                "main.xml: \"{text}\" is no point"
                            )));
                        }
                    };
                }
                points.push(told(k, Box::new(move |d| numbers[d])));
            }
            points
        }
    };
    if points.len() != n {
        return Err(MapError::content(format!(
            "{} points, where the file tells of {n}",
            points.len()
        )));
    }
    let is_valid = valid(archive, root, n)?;
    for (k, point) in points.iter_mut().enumerate() {
        if !is_valid(k) {
            point[2] = f64::NAN;
        }
    }
    // Points without a place have no height either.
    points.retain(|[x, y, z]| z.is_nan() || (x.is_finite() && y.is_finite()));
    points.retain(|[x, y, _]| x.is_finite() && y.is_finite());
    if points.iter().any(|[.., z]| z.is_infinite()) {
        return Err(MapError::content("a height is infinite"));
    }
    gridded(&points)
}

/// An axis of points that tell where they are.
struct Axis {
    name: &'static str,
    /// What its numbers are in, m; of an axis of equal distances these.
    increment: f64,
    is_absolute: bool,
}

/// The texts of the points in the description.
fn data<'a>(root: Node<'a, 'a>) -> Result<Vec<&'a str>, MapError> {
    let list = (root.descendants())
        .find(|node| node.tag_name().name() == "DataList")
        .ok_or_else(|| MapError::content("main.xml has neither a PointDataLink nor a DataList"))?;
    let points = list
        .children()
        .filter(|node| node.tag_name().name() == "Datum");
    Ok(points
        .map(|datum| datum.text().unwrap_or_default().trim())
        .collect())
}

/// Heights in the description: `x;y;z` or `z` each, empty where a point has none.
fn listed<'a>(root: Node<'a, 'a>, unit: f64) -> Result<Vec<f64>, MapError> {
    let heights = data(root)?.into_iter().map(|text| {
        let cell = text.rsplit(';').next().unwrap_or_default().trim();
        match cell.parse::<f64>() {
            Ok(value) if !value.is_infinite() => Ok(unit * value),
            _ if cell.is_empty() => Ok(f64::NAN),
            _ => Err(MapError::content(format!(
                "main.xml: \"{cell}\" is no height"
            ))),
        }
    });
    heights.collect()
}
