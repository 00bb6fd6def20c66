//! Elastic half-spaces by closed-form integrals and a fast summation.
//!
//! ```text
//!   δ(x) = C/π ∫ P(y)/|x − y| dA              point contacts   (Johnson 1985, eq. 3.19)
//!   δ(x) = −2C/π ∫ P(y) ln(|x − y|/d) dy      line contacts    (Johnson 1985, eq. 2.24b), zero at the distance d of the load
//!
//!   C = Σ(1 − ν²)/E over the bodies
//! ```
//! The deflection is exact at its nodes for the pressure that the elements carry, and a polynomial between them.

use std::f64::consts::PI;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use ertel_fem::mesh::SimplexMesh;
use ertel_fem::potential::{Accuracy, Potential, PotentialParams};
use ertel_fem::space::Space;

use super::near::symbol_stiffness;
use super::{SurfaceResponse, Trace, compliance};
use crate::contact::{Material, Shape, Symmetry};

/// Distance, in half-widths, at which the deflection by a line load is zero: the depth of the finite-element body that represents a
/// half-space in Habchi's thesis. It shifts only the separation.
pub const LINE_REFERENCE: f64 = 60.0;

/// Half-spaces under one load.
pub struct HalfSpace {
    /// None once released.
    potential: Mutex<Option<Arc<Potential>>>,
    mesh: SimplexMesh,
    space: Space,
    /// Σ(1 − ν²)/E.
    compliance: f64,
    /// Whether the pressure continues beyond y = 0.
    mirrored: bool,
    /// Deflection over potential.
    factor: f64,
    /// ∫N of each deflection node, times the contribution of the reference distance to the deflection.
    lift: Option<Vec<f64>>,
    near: Vec<f64>,
}

impl HalfSpace {
    /// Half-spaces of the given constants below a contact area, with deflections in `space`; `pairs` are those of
    /// [`near_pairs`](super::near_pairs).
    pub fn new(
        mesh: &SimplexMesh,
        space: &Space,
        bodies: &[Material],
        pairs: &[(u32, u32)],
        shape: &Shape,
    ) -> HalfSpace {
        let line = mesh.dim == 1;
        let mirrored = shape.symmetry == Symmetry::Half;
        let c = compliance(bodies);
        let factor = c / PI * if line { 2.0 } else { 1.0 };
        HalfSpace {
            potential: Mutex::new(Some(Arc::new(potential(mesh, space, mirrored)))),
            mesh: mesh.clone(),
            space: space.clone(),
            compliance: c,
            mirrored,
            factor,
            lift: line.then(|| {
                let shift = factor * LINE_REFERENCE.ln();
                space
                    .integrals(mesh)
                    .into_iter()
                    .map(|v| shift * v)
                    .collect()
            }),
            near: symbol_stiffness(mesh, space, pairs, &|at| shape.zone.stretch(at), &|k| {
                2.0 * c / k
            }),
        }
    }

    fn potential(&self) -> Arc<Potential> {
        if let Some(kept) = &*self.kept() {
            return Arc::clone(kept);
        }
        // Outside the lock: a thread that waits for others may start a task that needs it, too.
        let made = Arc::new(potential(&self.mesh, &self.space, self.mirrored));
        Arc::clone(self.kept().get_or_insert(made))
    }

    fn kept(&self) -> MutexGuard<'_, Option<Arc<Potential>>> {
        self.potential
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
    }
}

impl SurfaceResponse for HalfSpace {
    fn deflect(&self, trace: &Trace, pressure: &[f64], accuracy: Accuracy) -> Vec<f64> {
        let values = trace.values(pressure);
        let mut deflection = self.potential().apply(&values, accuracy);
        let lift = self.lift.as_ref().map_or(0.0, |lift| dot(lift, &values));
        for d in &mut deflection {
            *d = self.factor * *d + lift;
        }
        deflection
    }

    fn near_stiffness(&self) -> Vec<f64> {
        self.near.clone()
    }

    fn compliance(&self) -> f64 {
        self.compliance
    }

    fn release(&self) {
        *self.kept() = None;
    }
}

/// At the nodes of a space.
fn potential(mesh: &SimplexMesh, space: &Space, mirrored: bool) -> Potential {
    let targets: Vec<[f64; 2]> = space.points.iter().map(|p| [p[0], p[1]]).collect();
    let params = PotentialParams::default();
    Potential::new(mesh, space, &targets, mirrored, &params)
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}
