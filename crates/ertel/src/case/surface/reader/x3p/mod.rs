//! X3P (ISO 25178-72): an archive with a description, `main.xml`, and the heights of a grid in another file or in it. Lengths are in metres.

mod archive;
mod description;
pub(super) mod md5;
mod placed;

use roxmltree::Node;

use super::{MapError, checked, finite};
use crate::contact::topography::Topography;
use archive::{Archive, DESCRIPTION};
use description::{Axis, LARGEST_DESCRIPTION, at, data, of_link, parsed, required, valid};

pub(super) fn parse(archive: &[u8]) -> Result<Topography, MapError> {
    let archive = Archive::open(archive)?;
    let text = archive
        .file(DESCRIPTION, LARGEST_DESCRIPTION)?
        .unwrap_or_default();
    let text = String::from_utf8(text)
        .map_err(|_| MapError::content(format!("{DESCRIPTION} is not UTF-8 text")))?;
    let xml = parsed(&text)?;
    let root = xml.root_element();
    if let Some(list) = at(root, &["Record4", "ChecksumFile"]) {
        archive.check_description(text.as_bytes(), list)?;
    }
    let is_absolute = |axis: &str| at(root, &["Record1", "Axes", axis, "AxisType"]) == Some("A");
    if is_absolute("CX") || is_absolute("CY") {
        return placed::parse(&archive, root);
    }
    grid(&archive, root)
}

/// Heights at equal distances.
fn grid<'a>(archive: &Archive<'_>, root: Node<'a, 'a>) -> Result<Topography, MapError> {
    let count = |axis: &str| -> Result<usize, MapError> {
        required(root, &["Record3", "MatrixDimension", axis]).map(|n| n as usize)
    };
    let counts = checked([count("SizeX")?, count("SizeY")?])?;
    if count("SizeZ")? != 1 {
        return Err(MapError::content(format!(
            "{DESCRIPTION}: more than one layer of heights"
        )));
    }
    let increment = |name| Axis::read(root, name).map(|axis| axis.increment);
    let spacing = [
        increment("CX")?,
        if counts[1] == 1 {
            1.0
        } else {
            increment("CY")?
        },
    ];
    let axis = Axis::read(root, "CZ")?;
    let n = counts[0] * counts[1];
    let mut heights = match of_link(root, "PointDataLink") {
        Some(name) => {
            let kind = axis.number()?;
            let bytes =
                archive.points(name, n * kind.size(), of_link(root, "MD5ChecksumPointData"))?;
            if bytes.len() != n * kind.size() {
                return Err(MapError::content(format!(
                    "`{name}` has {} bytes, and {} x {} heights take {}",
                    bytes.len(),
                    counts[0],
                    counts[1],
                    n * kind.size()
                )));
            }
            (bytes.chunks_exact(kind.size()))
                .map(|own| axis.value(kind.read(own)))
                .collect()
        }
        None => listed(root, &axis)?,
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
    finite(counts, spacing, heights)
}

/// Heights in the description: `x;y;z` or `z` each, empty where a point has none.
fn listed<'a>(root: Node<'a, 'a>, axis: &Axis<'_>) -> Result<Vec<f64>, MapError> {
    let heights = data(root)?.into_iter().map(|text| {
        let cell = text.rsplit(';').next().unwrap_or_default().trim();
        match cell.parse::<f64>() {
            Ok(value) if !value.is_infinite() => Ok(axis.value(value)),
            _ if cell.is_empty() => Ok(f64::NAN),
            _ => Err(MapError::content(format!(
                "{DESCRIPTION}: \"{cell}\" is no height"
            ))),
        }
    });
    heights.collect()
}
