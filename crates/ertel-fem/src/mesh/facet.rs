//! Facets of the body's boundary, and the contact surface as a separate mesh.

use super::simplex::SimplexMesh;

/// Part of a mesh's boundary.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct FacetMesh {
    /// vertices of each facet, first `dim` used (`u32::MAX` beyond). Solid: counter-clockwise seen from outside.
    /// Plane body: the outward normal is the direction of the segment turned from x towards z (by +90 degrees)
    pub facets: Vec<[u32; 3]>,
    /// cell that owns each facet
    pub cells: Vec<u32>,
}

impl FacetMesh {
    /// Facets of `mesh` (a body, not a surface) whose vertices all satisfy `on_face`; this must describe a part of
    /// the boundary that no interior facet lies in, such as one side of a box.
    pub fn extract(mesh: &SimplexMesh, on_face: impl Fn([f64; 3]) -> bool) -> Self {
        let on_face: Vec<bool> = mesh.vertices.iter().map(|&x| on_face(x)).collect();
        let mut found = Self::default();
        for (index, cell) in mesh.cells.iter().enumerate() {
            let cell = &cell[..=mesh.dim];
            if cell.iter().filter(|&&v| on_face[v as usize]).count() != mesh.dim {
                continue;
            }
            for opposite in (0..cell.len()).filter(|&i| !on_face[cell[i] as usize]) {
                found.facets.push(outward_facet(cell, opposite));
                found.cells.push(index as u32);
            }
        }
        found
    }
}

/// The facet opposite to a local vertex of a positively oriented cell.
fn outward_facet(cell: &[u32], opposite: usize) -> [u32; 3] {
    let mut facet = [u32::MAX; 3];
    let others = cell.iter().enumerate().filter(|&(i, _)| i != opposite);
    for (slot, (_, &v)) in facet.iter_mut().zip(others) {
        *slot = v;
    }
    // dropping vertex i from an even permutation leaves the outward orientation with sign (-1)^i; a segment of
    // a counter-clockwise boundary has the outside on its right, our convention is the left
    let flip = opposite.is_multiple_of(2) == (cell.len() == 3);
    if flip {
        facet.swap(0, 1);
    }
    facet
}

/// The contact patch as a separate mesh: triangles in x-y, or segments along x.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactMesh {
    /// the surface; cell i is facet i of the body's contact facets, vertices in the same order
    pub mesh: SimplexMesh,
    /// body vertex of each surface vertex
    pub body_vertices: Vec<u32>,
}

impl ContactMesh {
    /// Surface of `body` made of the facets `contact`.
    pub fn extract(body: &SimplexMesh, contact: &FacetMesh) -> Self {
        let dim = body.dim - 1;
        let mut body_vertices: Vec<u32> = contact
            .facets
            .iter()
            .flat_map(|f| f[..=dim].iter().copied())
            .collect();
        body_vertices.sort_unstable();
        body_vertices.dedup();
        let mut surface_vertex = vec![u32::MAX; body.n_vertices()];
        for (i, &v) in body_vertices.iter().enumerate() {
            surface_vertex[v as usize] = i as u32;
        }
        let vertices: Vec<[f64; 3]> = body_vertices
            .iter()
            .map(|&v| body.vertices[v as usize])
            .collect();
        let mut cells = Vec::with_capacity(contact.facets.len());
        for facet in &contact.facets {
            let mut cell = [u32::MAX; 4];
            for (slot, &v) in cell.iter_mut().zip(&facet[..=dim]) {
                *slot = surface_vertex[v as usize];
            }
            cells.push(cell);
        }
        Self {
            mesh: SimplexMesh {
                dim,
                axes: [0, 1, 2],
                vertices,
                cells,
            },
            body_vertices,
        }
    }
}
