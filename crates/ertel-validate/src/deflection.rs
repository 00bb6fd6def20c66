//! Deflection of the body under the Hertz pressure, without any film.

use std::sync::Arc;

use ertel::case::Case;
use ertel::contact::{Family, hertz, pressure_profile};
use ertel::elastic::{Accuracy, FiniteBodyError};
use ertel::engine::{Profile, SolveError};
use ertel::run::problem;
use ertel::solve::contact_surface::ContactSurface;
use ertel::solve::discretisation::Discretisation;
use ertel::solve::state::State;
use ertel_fem::linear::NEVER;

/// Dimensionless deflection δR/a² along the centreline under the Hertz pressure.
#[derive(Clone, Debug, PartialEq)]
pub struct Deflection {
    /// X.
    pub x: Vec<f64>,
    /// Deflection.
    pub value: Vec<f64>,
    /// Unknowns of the elastic problem.
    pub n_displacement_dofs: usize,
}

/// Deflects the body (or both) of a case on its finest mesh.
///
/// # Errors
/// When meshing or the factorisation fails.
pub fn deflect(case: &Case) -> Result<Deflection, SolveError> {
    let problem = problem(case);
    let Some(stage) = problem.plan.stages.last() else {
        return Ok(Deflection {
            x: Vec::new(),
            value: Vec::new(),
            n_displacement_dofs: 0,
        });
    };
    let contact = ContactSurface::new(
        &problem.shape,
        &problem.extents,
        &stage.sizes,
        &problem.elasticity,
        NEVER,
    )
    .map_err(|e: FiniteBodyError| SolveError::from(e))?;
    let contact = Arc::new(contact);
    let d = Discretisation::new(&contact, stage.pressure_order);
    let pressure: Vec<f64> = d
        .pressure
        .points
        .iter()
        .map(|p| pressure_profile(p[0].hypot(p[1])))
        .collect();
    let state = State {
        deflection: d.deflect(&pressure, Accuracy::Full),
        pressure,
        rigid_separation: 0.0,
        ..State::default()
    };
    let profile = Profile::new(&d, &state, 4);
    Ok(Deflection {
        x: profile.x,
        value: profile.fields.iter().map(|f| f.deflection).collect(),
        n_displacement_dofs: contact.n_displacement,
    })
}

impl Deflection {
    /// Largest deviation from Hertz theory on |X| ≤ 1 over the central deflection (the theory's
    /// for a circular contact; a line has none, only its shape counts).
    pub fn error(&self, family: Family) -> f64 {
        match family {
            Family::Point => self.largest(|x, v| v - hertz::deflection_profile(family, x)),
            Family::Cylinder => self.shape_error(family),
        }
    }

    /// Largest deviation of δ(X) − δ(0) on |X| ≤ 1 from Hertz theory, over the circular contact's
    /// central deflection, which is the film scale.
    pub fn shape_error(&self, family: Family) -> f64 {
        let theory = |x: f64| hertz::deflection_profile(family, x);
        let at_centre = self.at(0.0) - theory(0.0);
        self.largest(|x, v| v - theory(x) - at_centre)
    }

    /// Largest difference from another deflection on the same mesh on |X| ≤ 1, over the other's
    /// central value; `None` on another mesh.
    pub fn difference(&self, other: &Deflection) -> Option<f64> {
        if self.x != other.x {
            return None;
        }
        let pairs = self.x.iter().zip(self.value.iter().zip(&other.value));
        let largest = pairs
            .filter(|(x, _)| x.abs() <= 1.0)
            .fold(0.0_f64, |m, (_, (a, b))| m.max((a - b).abs()));
        Some(largest / other.at(0.0).abs())
    }

    /// Value at the sample nearest to X.
    pub fn at(&self, x: f64) -> f64 {
        let nearest = (0..self.x.len())
            .min_by(|i, j| (self.x[*i] - x).abs().total_cmp(&(self.x[*j] - x).abs()));
        nearest.map_or(f64::NAN, |i| self.value[i])
    }

    fn largest(&self, deviation: impl Fn(f64, f64) -> f64) -> f64 {
        let samples = self.x.iter().zip(&self.value);
        samples
            .filter(|(x, _)| x.abs() <= 1.0)
            .fold(0.0, |m, (x, v)| m.max(deviation(*x, *v).abs()))
    }
}
