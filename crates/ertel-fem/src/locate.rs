//! Finds the cell that holds a point of a line or surface mesh.

use crate::mesh::SimplexMesh;

/// Cells binned by their bounding boxes.
#[derive(Clone, Debug)]
pub struct Locator {
    lower: [f64; 2],
    spacing: [f64; 2],
    n_bins: [usize; 2],
    bins: Vec<Vec<u32>>,
}

impl Locator {
    /// Bins the cells of a mesh of dimension 1 (along x) or 2 (x, y).
    pub fn new(mesh: &SimplexMesh) -> Locator {
        let side = (mesh.n_cells() as f64)
            .powf(1.0 / mesh.dim as f64)
            .ceil()
            .max(1.0) as usize;
        let n_bins = if mesh.dim == 1 {
            [side, 1]
        } else {
            [side, side]
        };
        let (mut lower, mut upper) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for v in &mesh.vertices {
            for a in 0..2 {
                lower[a] = lower[a].min(v[a]);
                upper[a] = upper[a].max(v[a]);
            }
        }
        let spacing = [0, 1].map(|a| ((upper[a] - lower[a]) / n_bins[a] as f64).max(1e-300));
        let mut locator = Locator {
            lower,
            spacing,
            n_bins,
            bins: vec![Vec::new(); n_bins[0] * n_bins[1]],
        };
        for cell in 0..mesh.n_cells() {
            let points = mesh.cell(cell).iter().map(|v| mesh.vertices[*v as usize]);
            let (mut lo, mut hi) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
            for p in points {
                for a in 0..2 {
                    lo[a] = lo[a].min(p[a]);
                    hi[a] = hi[a].max(p[a]);
                }
            }
            let (lo, hi) = (locator.bin(lo), locator.bin(hi));
            for j in lo[1]..=hi[1] {
                for i in lo[0]..=hi[0] {
                    locator.bins[j * n_bins[0] + i].push(cell as u32);
                }
            }
        }
        locator
    }

    fn bin(&self, p: [f64; 2]) -> [usize; 2] {
        [0, 1].map(|a| {
            let k = ((p[a] - self.lower[a]) / self.spacing[a]).floor().max(0.0) as usize;
            k.min(self.n_bins[a] - 1)
        })
    }

    /// Cell and reference coordinates of a point; a point outside by less than a billionth of
    /// the cell counts as inside.
    pub fn find(&self, mesh: &SimplexMesh, point: [f64; 2]) -> Option<(usize, [f64; 3])> {
        let [i, j] = self.bin(point);
        let mut best: Option<(f64, usize, [f64; 3])> = None;
        for cell in &self.bins[j * self.n_bins[0] + i] {
            let xi = reference_point(mesh, *cell as usize, point);
            let rest = 1.0 - xi[0] - xi[1];
            let inside = if mesh.dim == 1 {
                xi[0].min(rest)
            } else {
                xi[0].min(xi[1]).min(rest)
            };
            if best.is_none_or(|b| inside > b.0) {
                best = Some((inside, *cell as usize, xi));
            }
        }
        best.filter(|b| b.0 > -1e-9).map(|(_, cell, xi)| (cell, xi))
    }
}

/// Reference coordinates of a point with respect to a cell, inside it or not.
pub fn reference_point(mesh: &SimplexMesh, cell: usize, p: [f64; 2]) -> [f64; 3] {
    let vertices = mesh.cell(cell);
    let v: [[f64; 3]; 3] =
        std::array::from_fn(|k| mesh.vertices[vertices[k.min(vertices.len() - 1)] as usize]);
    let d = [p[0] - v[0][0], p[1] - v[0][1]];
    if mesh.dim == 1 {
        return [d[0] / (v[1][0] - v[0][0]), 0.0, 0.0];
    }
    let (a, b) = (
        [v[1][0] - v[0][0], v[1][1] - v[0][1]],
        [v[2][0] - v[0][0], v[2][1] - v[0][1]],
    );
    let det = a[0] * b[1] - a[1] * b[0];
    [
        (d[0] * b[1] - d[1] * b[0]) / det,
        (a[0] * d[1] - a[1] * d[0]) / det,
        0.0,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn square(n: usize) -> SimplexMesh {
        let mut vertices = Vec::new();
        for j in 0..=n {
            for i in 0..=n {
                // graded: cells of very different size
                let g = |k: usize| (k as f64 / n as f64).powi(3);
                vertices.push([g(i), g(j), 0.0]);
            }
        }
        let id = |i: usize, j: usize| (j * (n + 1) + i) as u32;
        let mut cells = Vec::new();
        for j in 0..n {
            for i in 0..n {
                cells.push([id(i, j), id(i + 1, j), id(i, j + 1), 0]);
                cells.push([id(i + 1, j + 1), id(i, j + 1), id(i + 1, j), 0]);
            }
        }
        SimplexMesh {
            dim: 2,
            axes: [0, 1, 2],
            vertices,
            cells,
        }
    }

    #[test]
    fn every_point_is_found_and_mapped_back() {
        let mesh = square(9);
        let locator = Locator::new(&mesh);
        for k in 0..500 {
            let p = [
                (k as f64 * 0.618_034).fract(),
                (k as f64 * 0.414_214).fract(),
            ];
            let (cell, xi) = locator.find(&mesh, p).expect("inside");
            let v: Vec<_> = mesh
                .cell(cell)
                .iter()
                .map(|v| mesh.vertices[*v as usize])
                .collect();
            for a in 0..2 {
                let x = v[0][a] + xi[0] * (v[1][a] - v[0][a]) + xi[1] * (v[2][a] - v[0][a]);
                assert_relative_eq!(x, p[a], epsilon = 1e-12);
            }
        }
        assert!(locator.find(&mesh, [1.0, 1.0]).is_some());
        assert!(locator.find(&mesh, [1.1, 0.5]).is_none());
    }

    #[test]
    fn segments_too() {
        let mesh = SimplexMesh {
            dim: 1,
            axes: [0, 1, 2],
            vertices: vec![[-1.0, 0.0, 0.0], [3.0, 0.0, 0.0], [0.0, 0.0, 0.0]],
            cells: vec![[0, 2, 0, 0], [2, 1, 0, 0]],
        };
        let (cell, xi) = Locator::new(&mesh).find(&mesh, [0.75, 0.0]).unwrap();
        assert_eq!(cell, 1);
        assert_relative_eq!(xi[0], 0.25, epsilon = 1e-14);
    }
}
