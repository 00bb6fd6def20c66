//! Points that give their places (axes of the type A), of a matrix or a list: they must lie on a grid, in whatever order.

use roxmltree::Node;

use super::super::text::gridded;
use super::super::{MOST_POINTS, MapError};
use super::archive::{Archive, DESCRIPTION};
use super::description::{Axis, at, data, of_link, valid};
use crate::contact::topography::Topography;

/// The axes, and points in a row of the matrix, if there is one.
struct Layout<'a> {
    axes: [Axis<'a>; 3],
    row: Option<usize>,
}

pub(super) fn parse<'a>(archive: &Archive<'_>, root: Node<'a, 'a>) -> Result<Topography, MapError> {
    let count = |path: &[&str]| at(root, path).and_then(|text| text.parse::<usize>().ok());
    let rows = ["SizeX", "SizeY"].map(|size| count(&["Record3", "MatrixDimension", size]));
    let n = match (count(&["Record3", "ListDimension"]), rows) {
        (Some(n), _) => Some(n),
        (None, [Some(nx), Some(ny)]) => nx.checked_mul(ny),
        _ => None,
    };
    let n = n.filter(|n| (1..=MOST_POINTS).contains(n)).ok_or_else(|| {
        MapError::content(format!(
            "{DESCRIPTION} does not say how many points there are, 1 to {MOST_POINTS}"
        ))
    })?;
    let layout = Layout {
        axes: [
            Axis::read(root, "CX")?,
            Axis::read(root, "CY")?,
            Axis::read(root, "CZ")?,
        ],
        row: rows[0].filter(|nx| *nx > 0),
    };
    if layout.row.is_none() && layout.axes.iter().any(|axis| !axis.is_absolute) {
        return Err(MapError::content(format!(
            "{DESCRIPTION}: in a list of points both x and y must be of the type A"
        )));
    }
    let mut points = match of_link(root, "PointDataLink") {
        Some(name) => layout.binary(archive, root, name, n)?,
        None => layout.listed(root)?,
    };
    if points.len() != n {
        return Err(MapError::content(format!(
            "{} points, where the file states {n}",
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
    points.retain(|[x, y, _]| x.is_finite() && y.is_finite());
    if points.iter().any(|[.., z]| z.is_infinite()) {
        return Err(MapError::content("a height is infinite"));
    }
    gridded(&points)
}

impl Layout<'_> {
    /// A point from its numbers, in the order of the axes that have one; the others have the place in the matrix.
    fn point(&self, k: usize, mut next: impl FnMut(usize) -> f64) -> [f64; 3] {
        std::array::from_fn(|d| {
            let axis = &self.axes[d];
            let number = match (axis.is_absolute, d, self.row) {
                (true, ..) => next(d),
                (false, 0, Some(nx)) => (k % nx) as f64,
                (false, 1, Some(nx)) => (k / nx) as f64,
                _ => 0.0,
            };
            axis.value(number)
        })
    }

    /// Points of a binary file.
    fn binary(
        &self,
        archive: &Archive<'_>,
        root: Node<'_, '_>,
        name: &str,
        n: usize,
    ) -> Result<Vec<[f64; 3]>, MapError> {
        let mut kinds = [None; 3];
        for (kind, axis) in kinds.iter_mut().zip(&self.axes) {
            if axis.is_absolute {
                *kind = Some(axis.number()?);
            }
        }
        let size: usize = kinds.iter().flatten().map(|kind| kind.size()).sum();
        let bytes = archive.points(name, n * size, of_link(root, "MD5ChecksumPointData"))?;
        if bytes.len() != n * size {
            return Err(MapError::content(format!(
                "`{name}` has {} bytes, and {n} points take {}",
                bytes.len(),
                n * size
            )));
        }
        let point = |(k, mut bytes): (usize, &[u8])| {
            self.point(k, |d| {
                let Some(kind) = kinds[d] else { return 0.0 };
                let (own, rest) = bytes.split_at(kind.size());
                bytes = rest;
                kind.read(own)
            })
        };
        Ok(bytes.chunks_exact(size).enumerate().map(point).collect())
    }

    /// Points of the description: all three numbers, or those alone that the axes take from the file.
    fn listed<'a>(&self, root: Node<'a, 'a>) -> Result<Vec<[f64; 3]>, MapError> {
        let needed = self.axes.iter().filter(|axis| axis.is_absolute).count();
        let mut points = Vec::new();
        for (k, text) in data(root)?.into_iter().enumerate() {
            if text.is_empty() {
                points.push([f64::NAN; 3]);
                continue;
            }
            let error = || MapError::content(format!("{DESCRIPTION}: \"{text}\" is no point"));
            let cells: Vec<&str> = text.split(';').map(str::trim).collect();
            if cells.len() != 3 && cells.len() != needed {
                return Err(error());
            }
            let mut numbers = [0.0; 3];
            let mut rest = cells.iter();
            for (d, axis) in self.axes.iter().enumerate() {
                if !axis.is_absolute && cells.len() == needed {
                    continue;
                }
                let cell = rest.next().copied().unwrap_or_default();
                numbers[d] = match cell.parse::<f64>() {
                    Ok(value) => value,
                    Err(_) if cell.is_empty() && d == 2 => f64::NAN,
                    Err(_) => return Err(error()),
                };
            }
            points.push(self.point(k, |d| numbers[d]));
        }
        Ok(points)
    }
}
