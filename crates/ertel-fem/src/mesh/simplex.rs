//! Vertices and cells, and their measures.

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
}
