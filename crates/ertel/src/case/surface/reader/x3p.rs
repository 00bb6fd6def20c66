//! X3P (ISO 25178-72): an archive with a description, `main.xml`, and the heights of a grid beside it or in it. Lengths are in metres.

use miniz_oxide::inflate::decompress_to_vec_with_limit;
use rawzip::{CompressionMethod, ZipArchive};
use roxmltree::{Document, Node};

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
fn at<'a>(node: Node<'a, 'a>, path: &[&str]) -> Option<&'a str> {
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
    for axis in ["CX", "CY"] {
        if at(root, &["Record1", "Axes", axis, "AxisType"]).is_some_and(|kind| kind != "I") {
            return Err(MapError::content(format!(
                "main.xml: {axis} is no axis of equal distances; points with their own places are not read"
            )));
        }
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
            let kind = match at(root, &["Record1", "Axes", "CZ", "DataType"]) {
                Some("I") => Number::Short,
                Some("L") => Number::Long,
                Some("F") => Number::Float,
                Some("D") => Number::Double,
                other => {
                    return Err(MapError::content(format!(
                        "main.xml: the heights have the data type {}, which is none of I, L, F and D",
                        other.unwrap_or("of no name")
                    )));
                }
            };
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
    if let Some(name) = at(root, &["Record3", "DataLink", "ValidPointsLink"]) {
        // One bit a point, the lowest first.
        let bits = file(archive, name, n.div_ceil(8))?
            .filter(|bits| bits.len() == n.div_ceil(8))
            .ok_or_else(|| {
                MapError::content(format!("`{name}` does not have a bit for each point"))
            })?;
        for (k, h) in heights.iter_mut().enumerate() {
            if bits[k / 8] >> (k % 8) & 1 == 0 {
                *h = f64::NAN;
            }
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

/// Heights in the description: `x;y;z` or `z` each, empty where a point has none.
fn listed(root: Node<'_, '_>, unit: f64) -> Result<Vec<f64>, MapError> {
    let list = (root.descendants())
        .find(|node| node.tag_name().name() == "DataList")
        .ok_or_else(|| MapError::content("main.xml has neither a PointDataLink nor a DataList"))?;
    (list
        .children()
        .filter(|node| node.tag_name().name() == "Datum"))
    .map(|datum| {
        let text = datum.text().unwrap_or_default();
        let cell = text.rsplit(';').next().unwrap_or_default().trim();
        match cell.parse::<f64>() {
            Ok(value) if !value.is_infinite() => Ok(unit * value),
            _ if cell.is_empty() => Ok(f64::NAN),
            _ => Err(MapError::content(format!(
                "main.xml: \"{cell}\" is no height"
            ))),
        }
    })
    .collect()
}
