//! Vertices and cells, their measures and quality.

/// Mesh of triangles (`dim` 2), tetrahedra (`dim` 3) or segments (`dim` 1) in space.
#[derive(Debug, Clone, PartialEq)]
pub struct SimplexMesh {
    /// dimension of the cells: 1, 2 or 3
    pub dim: usize,
    /// coordinate axes that the mesh spans (first `dim` used): `[0, 1, 2]` for a solid, `[0, 2, _]` for a plane
    /// body in x-z, `[0, 1, _]` for the contact surface of a solid, `[0, _, _]` for a segment along x
    pub axes: [usize; 3],
    /// vertex coordinates, always three (y = 0 throughout in a plane body)
    pub vertices: Vec<[f64; 3]>,
    /// vertex indices of each cell, first `dim + 1` used; positively oriented with respect to `axes`
    pub cells: Vec<[u32; 4]>,
}

/// Counts and shape of a mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshStats {
    /// number of cells
    pub n_cells: usize,
    /// number of vertices
    pub n_vertices: usize,
    /// smallest quality, see [`SimplexMesh::quality`]
    pub min_quality: f64,
    /// largest quality
    pub max_quality: f64,
    /// mean quality
    pub mean_quality: f64,
    /// length of the shortest edge
    pub min_edge: f64,
    /// length of the longest edge
    pub max_edge: f64,
}

pub(super) fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    ((a[0] - b[0]).powi(2) + (a[1] - b[1]).powi(2) + (a[2] - b[2]).powi(2)).sqrt()
}

/// Length of the longest edge of the simplex with these vertices.
pub(super) fn longest_edge(vertices: &[[f64; 3]], cell: &[u32]) -> f64 {
    let mut longest = 0.0_f64;
    for (i, &a) in cell.iter().enumerate() {
        for &b in &cell[i + 1..] {
            longest = longest.max(distance(vertices[a as usize], vertices[b as usize]));
        }
    }
    longest
}

/// Measure with sign: `det(x1 - x0, ..., xn - x0) / n!` in the coordinates `axes`.
pub(super) fn signed_measure(vertices: &[[f64; 3]], cell: &[u32], axes: &[usize]) -> f64 {
    let x0 = vertices[cell[0] as usize];
    let edge = |i: usize, k: usize| vertices[cell[i] as usize][axes[k]] - x0[axes[k]];
    match axes.len() {
        1 => edge(1, 0),
        2 => (edge(1, 0) * edge(2, 1) - edge(1, 1) * edge(2, 0)) / 2.0,
        _ => {
            let minor = |a: usize, b: usize| edge(2, a) * edge(3, b) - edge(2, b) * edge(3, a);
            (edge(1, 0) * minor(1, 2) + edge(1, 1) * minor(2, 0) + edge(1, 2) * minor(0, 1)) / 6.0
        }
    }
}

impl SimplexMesh {
    /// Number of cells.
    #[must_use]
    pub fn n_cells(&self) -> usize {
        self.cells.len()
    }

    /// Number of vertices.
    #[must_use]
    pub fn n_vertices(&self) -> usize {
        self.vertices.len()
    }

    /// Vertex indices of a cell (`dim + 1` of them).
    #[must_use]
    pub fn cell(&self, cell: usize) -> &[u32] {
        &self.cells[cell][..=self.dim]
    }

    /// Length, area or volume of a cell, negative if the cell is inverted.
    #[must_use]
    pub fn measure(&self, cell: usize) -> f64 {
        signed_measure(&self.vertices, self.cell(cell), &self.axes[..self.dim])
    }

    /// Mean of the vertices of a cell, x and y.
    #[must_use]
    pub fn centre(&self, cell: usize) -> [f64; 2] {
        let nodes = self.cell(cell);
        [0, 1].map(|a: usize| {
            let sum: f64 = nodes.iter().map(|v| self.vertices[*v as usize][a]).sum();
            sum / nodes.len() as f64
        })
    }

    /// Longest edge of a cell.
    #[must_use]
    pub fn longest_edge(&self, cell: usize) -> f64 {
        longest_edge(&self.vertices, self.cell(cell))
    }

    /// Normalised radius ratio `n r / R` of inscribed to circumscribed sphere: 1 for the regular simplex, 0 for a
    /// degenerate one (segments: always 1).
    ///
    /// Triangle: `r = 2 A / sum l`, `R = l0 l1 l2 / (4 A)`. Tetrahedron: `r = 3 V / sum A`,
    /// `R = sqrt(s (s - 2 p0) (s - 2 p1) (s - 2 p2)) / (24 V)` with the products `p` of opposite edges, `s` their sum.
    #[must_use]
    pub fn quality(&self, cell: usize) -> f64 {
        let x: Vec<[f64; 3]> = self
            .cell(cell)
            .iter()
            .map(|&v| self.vertices[v as usize])
            .collect();
        let length = |i: usize, j: usize| distance(x[i], x[j]);
        let measure = self.measure(cell).abs();
        match self.dim {
            1 => 1.0,
            2 => {
                let l = [length(0, 1), length(1, 2), length(2, 0)];
                16.0 * measure * measure / (l.iter().sum::<f64>() * l.iter().product::<f64>())
            }
            _ => {
                let p = [
                    length(0, 1) * length(2, 3),
                    length(0, 2) * length(1, 3),
                    length(0, 3) * length(1, 2),
                ];
                let s: f64 = p.iter().sum();
                let surface: f64 = [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]]
                    .map(|f| triangle_area(f.map(|i| x[i])))
                    .iter()
                    .sum();
                let heron = (s * (s - 2.0 * p[0]) * (s - 2.0 * p[1]) * (s - 2.0 * p[2]))
                    .max(0.0)
                    .sqrt();
                if heron == 0.0 {
                    0.0
                } else {
                    216.0 * measure * measure / (surface * heron)
                }
            }
        }
    }

    /// Counts, quality and edge lengths of the whole mesh.
    #[must_use]
    pub fn stats(&self) -> MeshStats {
        let mut stats = MeshStats {
            n_cells: self.n_cells(),
            n_vertices: self.n_vertices(),
            min_quality: f64::INFINITY,
            max_quality: 0.0,
            mean_quality: 0.0,
            min_edge: f64::INFINITY,
            max_edge: 0.0,
        };
        for c in 0..self.n_cells() {
            let quality = self.quality(c);
            stats.min_quality = stats.min_quality.min(quality);
            stats.max_quality = stats.max_quality.max(quality);
            stats.mean_quality += quality / self.n_cells() as f64;
            let cell = self.cell(c);
            for (i, &a) in cell.iter().enumerate() {
                for &b in &cell[i + 1..] {
                    let length = distance(self.vertices[a as usize], self.vertices[b as usize]);
                    stats.min_edge = stats.min_edge.min(length);
                    stats.max_edge = stats.max_edge.max(length);
                }
            }
        }
        stats
    }
}

fn triangle_area(x: [[f64; 3]; 3]) -> f64 {
    let edge = |i: usize| [x[i][0] - x[0][0], x[i][1] - x[0][1], x[i][2] - x[0][2]];
    let (a, b) = (edge(1), edge(2));
    let normal = [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ];
    normal.iter().map(|n| n * n).sum::<f64>().sqrt() / 2.0
}
