//! The contact patch alone: a line or a rectangle.

use super::MeshError;
use super::bisection::{AxisMap, Bisection};
use super::simplex::{SimplexMesh, longest_edge};

/// Contact patch; any unit of length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfaceParams {
    /// 1: a segment along x; 2: a rectangle in x-y
    pub dim: usize,
    /// from and to along x
    pub x: [f64; 2],
    /// from and to along y (not read for `dim` 1)
    pub y: [f64; 2],
}

/// Mesh of the patch, refinable in place. The patch is met exactly.
#[derive(Debug, Clone)]
pub struct SurfaceMesh {
    mesh: SimplexMesh,
    bisection: Bisection,
}

/// Start squares across the patch: few, but not more stretched than need be.
const MOST_SQUARES: usize = 8;
/// Weight of their number against their stretch.
const SQUARE_WEIGHT: f64 = 0.05;

/// Meshes the patch so that no cell's longest edge exceeds the size field at its vertices and its barycentre.
///
/// # Errors
/// Parameters out of range, a size that is not positive, or too many cells.
pub fn surface_mesh(
    params: &SurfaceParams,
    size: &dyn Fn([f64; 2]) -> f64,
) -> Result<SurfaceMesh, MeshError> {
    let [x0, x1] = params.x;
    let require = |ok: bool, name, value, expected| match ok {
        true => Ok(()),
        false => Err(MeshError::Parameter {
            name,
            value,
            expected,
        }),
    };
    let dim_is_known = matches!(params.dim, 1 | 2);
    require(dim_is_known, "dim", params.dim as f64, "must be 1 or 2")?;
    let length = x1 - x0;
    let along = length.is_finite() && length > 0.0;
    require(along, "x_outlet", x1, "must exceed x_inlet")?;
    let [y0, y1] = params.y;
    let width = y1 - y0;
    let across = params.dim == 1 || (width.is_finite() && width > 0.0);
    require(across, "y_side", width, "must be positive")?;

    let linear = |n: usize, low: f64, high: f64| AxisMap {
        knots: vec![[0.0, low], [n as f64, high]],
    };
    let mut bisection = if params.dim == 1 {
        let maps = [linear(1, x0, x1), AxisMap::default(), AxisMap::default()];
        Bisection::from_cubes(&[0], [0.0; 3], 1.0, [1, 0, 0], maps)
    } else {
        // The line y = 0 is met exactly: profiles and symmetric meshes use it.
        let crossed = y0 < 0.0 && y1 > 0.0;
        let [nx, half] = squares(length, if crossed { 0.5 * width } else { width });
        let ny = if crossed { 2 * half } else { half };
        let across = match crossed {
            true => AxisMap {
                knots: vec![[0.0, y0], [half as f64, 0.0], [ny as f64, y1]],
            },
            false => linear(ny, y0, y1),
        };
        let maps = [linear(nx, x0, x1), across, AxisMap::default()];
        Bisection::from_cubes(&[0, 1], [0.0; 3], 1.0, [nx, ny, 0], maps)
    };
    let positive = |p: [f64; 3]| {
        let value = size([p[0], p[1]]);
        if value > 0.0 {
            Ok(value)
        } else {
            Err(MeshError::Size { value, point: p })
        }
    };
    bisection.refine_while(|vertices, cell| {
        let mut mean = [0.0; 3];
        let mut allowed = f64::INFINITY;
        for v in cell {
            let p = vertices[*v as usize];
            allowed = allowed.min(positive(p)?);
            (0..3).for_each(|k| mean[k] += p[k] / cell.len() as f64);
        }
        Ok(longest_edge(vertices, cell) > allowed.min(positive(mean)?))
    })?;
    Ok(SurfaceMesh::from_bisection(bisection))
}

/// Numbers of start squares along and across a rectangle.
fn squares(length: f64, side: f64) -> [usize; 2] {
    let candidates = (1..=MOST_SQUARES).map(|n| {
        let (nx, ny) = match length >= side {
            true => ((length / side * n as f64).round().max(1.0), n as f64),
            false => (n as f64, (side / length * n as f64).round().max(1.0)),
        };
        let stretch = (length / nx / (side / ny)).ln().abs();
        (
            stretch + SQUARE_WEIGHT * (nx * ny).ln(),
            [nx as usize, ny as usize],
        )
    });
    let best = candidates.min_by(|a, b| a.0.total_cmp(&b.0));
    best.expect("there are candidates").1
}

impl SurfaceMesh {
    fn from_bisection(bisection: Bisection) -> SurfaceMesh {
        SurfaceMesh {
            mesh: bisection.mesh(),
            bisection,
        }
    }

    /// The current mesh.
    #[must_use]
    pub fn mesh(&self) -> &SimplexMesh {
        &self.mesh
    }

    /// The same with cells bisected until the longest edge of each cell inside cell i is at most `sizes[i]`, and others as
    /// conformity demands.
    ///
    /// # Errors
    /// A size that is not positive, or too many cells.
    ///
    /// # Panics
    /// When there is not one size for each cell.
    pub fn refined(&self, sizes: &[f64]) -> Result<SurfaceMesh, MeshError> {
        assert_eq!(sizes.len(), self.mesh.n_cells(), "one size for each cell");
        if let Some((cell, value)) = sizes
            .iter()
            .enumerate()
            .find(|(_, s)| s.is_nan() || **s <= 0.0)
        {
            return Err(MeshError::Size {
                value: *value,
                point: self.mesh.vertices[self.mesh.cell(cell)[0] as usize],
            });
        }
        let mut bisection = self.bisection.clone();
        let mut allowed = sizes.to_vec();
        loop {
            let marked: Vec<u32> = (0..bisection.n_cells())
                .filter(|&c| longest_edge(bisection.vertices(), bisection.cell(c)) > allowed[c])
                .map(|c| c as u32)
                .collect();
            if marked.is_empty() {
                return Ok(SurfaceMesh::from_bisection(bisection));
            }
            let origin = bisection.refine_marked(&marked)?;
            allowed = origin.iter().map(|&c| allowed[c as usize]).collect();
        }
    }
}
