//! The body under a contact patch.

use super::MeshError;
use super::bisection::Bisection;
use super::facet::{ContactMesh, FacetMesh};
use super::layout::{BodyParams, choose_layout};
use super::simplex::{SimplexMesh, longest_edge};

/// The body's mesh with its contact facets, refinable in place.
#[derive(Debug, Clone)]
pub struct BodyMesh {
    /// the body
    pub mesh: SimplexMesh,
    /// facets on the patch, z = 0
    pub contact: FacetMesh,
    params: BodyParams,
    bisection: Bisection,
}

/// Meshes the body so that no longest edge exceeds the size field: that of a cell at its barycentre, that of a facet
/// on the upper side (z = 0) at its vertices and barycentre.
///
/// The surface, where the load acts, so has the requested size, while the cells below may grow at once; sampling
/// them at their vertices too costs about a third more nodes for the same error of the deflection. The patch is met
/// exactly, however coarse the size field. A field that varies by more than about 1 per unit length can hide a fine
/// zone between the sample points of coarse cells.
///
/// # Errors
/// Parameters out of range, a size that is not positive, or too many cells.
pub fn body_mesh(
    params: &BodyParams,
    size: &dyn Fn([f64; 3]) -> f64,
) -> Result<BodyMesh, MeshError> {
    params.check()?;
    let layout = choose_layout(params)?;
    let axes: &[usize] = if params.dim == 2 { &[0, 2] } else { &[0, 1, 2] };
    let mut bisection =
        Bisection::from_cubes(axes, layout.lower, layout.side, layout.n_cubes, layout.maps);
    refine_to_size(&mut bisection, params, size)?;
    Ok(BodyMesh::from_bisection(bisection, *params))
}

fn refine_to_size(
    bisection: &mut Bisection,
    params: &BodyParams,
    size: &dyn Fn([f64; 3]) -> f64,
) -> Result<(), MeshError> {
    let positive = |point: [f64; 3]| {
        let value = size(point);
        if value > 0.0 {
            Ok(value)
        } else {
            Err(MeshError::Size { value, point })
        }
    };
    let barycentre = |vertices: &[[f64; 3]], simplex: &[u32]| {
        let mut mean = [0.0; 3];
        for &v in simplex {
            (0..3).for_each(|k| mean[k] += vertices[v as usize][k] / simplex.len() as f64);
        }
        mean
    };
    let dim = params.dim;
    bisection.refine_while(|vertices, cell| {
        if longest_edge(vertices, cell) > positive(barycentre(vertices, cell))? {
            return Ok(true);
        }
        let (mut facet, mut n) = ([0; 4], 0);
        for &v in cell.iter().filter(|&&v| vertices[v as usize][2] == 0.0) {
            (facet[n], n) = (v, n + 1);
        }
        let facet = &facet[..n];
        if n < dim {
            return Ok(false);
        }
        let mut allowed = positive(barycentre(vertices, facet))?;
        for &v in facet {
            allowed = allowed.min(positive(vertices[v as usize])?);
        }
        Ok(longest_edge(vertices, facet) > allowed || params.straddles_patch(vertices, facet))
    })
}

impl BodyMesh {
    fn from_bisection(bisection: Bisection, params: BodyParams) -> Self {
        let mesh = bisection.mesh();
        let contact = FacetMesh::extract(&mesh, |x| params.on_patch(x));
        Self {
            mesh,
            contact,
            params,
            bisection,
        }
    }

    /// Parameters of the body.
    #[must_use]
    pub fn params(&self) -> &BodyParams {
        &self.params
    }

    /// The contact patch as a separate mesh.
    #[must_use]
    pub fn contact_mesh(&self) -> ContactMesh {
        ContactMesh::extract(&self.mesh, &self.contact)
    }

    /// Bisects the cells at the contact patch until the longest edge of each facet inside facet i of `contact` is at
    /// most `sizes[i]`, and others as conformity demands. Below the patch the cells grow as fast as conformity
    /// lets them. Vertices keep their numbers.
    ///
    /// # Errors
    /// A size that is not positive, or too many cells; the mesh is then unchanged.
    ///
    /// # Panics
    /// When there is not one size for each facet.
    pub fn refine_contact(&mut self, sizes: &[f64]) -> Result<(), MeshError> {
        let n_facets = self.contact.facets.len();
        assert_eq!(sizes.len(), n_facets, "one size for each facet");
        let mut allowed = vec![f64::INFINITY; self.mesh.n_cells()];
        for ((facet, cell), &size) in self
            .contact
            .facets
            .iter()
            .zip(&self.contact.cells)
            .zip(sizes)
        {
            if size.is_nan() || size <= 0.0 {
                let point = self.mesh.vertices[facet[0] as usize];
                return Err(MeshError::Size { value: size, point });
            }
            allowed[*cell as usize] = size;
        }
        let mut bisection = self.bisection.clone();
        loop {
            let marked: Vec<u32> = (0..bisection.n_cells())
                .filter(|&cell| {
                    let (mut facet, mut n) = ([0; 4], 0);
                    for &v in bisection.cell(cell) {
                        if bisection.vertices()[v as usize][2] == 0.0 {
                            (facet[n], n) = (v, n + 1);
                        }
                    }
                    n == self.params.dim
                        && longest_edge(bisection.vertices(), &facet[..n]) > allowed[cell]
                })
                .map(|cell| cell as u32)
                .collect();
            if marked.is_empty() {
                break;
            }
            let origin = bisection.refine_marked(&marked)?;
            allowed = origin.iter().map(|&cell| allowed[cell as usize]).collect();
        }
        *self = Self::from_bisection(bisection, self.params);
        Ok(())
    }
}
