//! From a problem to its solution: meshes from coarse to fine, Newton's method on each.

pub mod adapt;
pub mod adjoint;
pub mod bars;
pub mod discretisation;
pub mod dry;
mod element;
pub mod evaluate;
pub mod figures;
mod halvings;
pub mod heat;
pub mod indicator;
mod minima;
pub mod monolithic;
mod neighbours;
pub mod newton;
pub mod preconditioner;
pub mod profile;
mod ridge;
pub mod sensitivity;
pub mod sequence;
pub mod shear;
pub mod sizes;
mod step;
pub mod system;
pub mod weighted;

use ertel_fem::linear::condensed::CholeskyError;
use ertel_fem::linear::gmres::GmresError;
use ertel_fem::linear::lu::LuError;

pub use discretisation::DiscretisationError;

use crate::solution::IterationRecord;

/// Follows a solve; every method has a default that does nothing.
///
/// Threads of the solver ask it whether to stop.
pub trait Observer: Send + Sync {
    /// A new stage begins.
    fn level(
        &mut self,
        _level: usize,
        _n_levels: usize,
        _n_pressure: usize,
        _n_displacement: usize,
    ) {
    }

    /// A Newton iteration ended.
    fn iteration(&mut self, _record: &IterationRecord) {}

    /// A round of the coupling of film and heat ended: the largest relative change of temperature rise, pressure and
    /// film, and the largest rise, K.
    fn round(&mut self, _round: usize, _change: f64, _rise: f64) {}

    /// Whether the user wants to stop; asked before each stage, between the fronts of a factorisation of the
    /// bodies, and before each linear solve.
    fn cancelled(&self) -> bool {
        false
    }
}

/// Observes nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct Silent;

impl Observer for Silent {}

/// A solve failed.
#[derive(Debug, thiserror::Error)]
pub enum SolveError {
    /// Newton's method did not converge.
    #[error(
        "no convergence in stage {} after {iterations} Newton iterations: {reason}; \
         last relative residual {residual:.1e}, last pressure update {update:.1e} p_h, \
         {:.2} % of the cavitation penalty in force",
        level + 1,
        100.0 * penalty_share
    )]
    NotConverged {
        /// Stage, 0 the first.
        level: usize,
        /// Newton iterations in this stage.
        iterations: usize,
        /// Last relative residual.
        residual: f64,
        /// Last pressure update over p_h.
        update: f64,
        /// Share of the full penalty in force.
        penalty_share: f64,
        /// Why it stopped.
        reason: &'static str,
    },
    /// Film and temperature did not come to rest together.
    #[error(
        "no convergence in stage {}: film and temperature still change by {change:.1e} after {rounds} rounds \
         (by a factor of {contraction:.2} from round to round)",
        level + 1
    )]
    NotCoupled {
        /// Stage, 0 the first.
        level: usize,
        /// Rounds.
        rounds: usize,
        /// Last relative change of temperature rise, pressure or film.
        change: f64,
        /// Ratio of changes from round to round.
        contraction: f64,
    },
    /// No mesh that is allowed resolves the film.
    #[error(
        "the film is too thin to resolve: formulas predict a central film of {:.3e} m, {ratio:.1e} of a²/R; its pressure builds up \
         within {length:.1e} half-widths, so that the first mesh needs cells of {size:.1e} half-widths and about {unknowns:.0} \
         pressure unknowns, where {limit:.0} are allowed",
        film
    )]
    TooThin {
        /// Predicted central film thickness, m.
        film: f64,
        /// The same over a²/R.
        ratio: f64,
        /// Length over which pressure builds up, in half-widths.
        length: f64,
        /// Cell size at the rim, in half-widths.
        size: f64,
        /// Unknowns of the first mesh, about.
        unknowns: f64,
        /// Unknowns allowed for it.
        limit: f64,
        /// What to change.
        help: &'static str,
    },
    /// The contact of a roller runs over its end.
    #[error(
        "no solution with a film everywhere: the contact runs over the end of the roller at y = {:.4} mm; pressure falls to nothing \
         there, the raceway comes out, and the thinnest film near the end is {:.3} nm, as on former meshes",
        1e3 * place,
        1e9 * film
    )]
    EndCarries {
        /// y of the end, m.
        place: f64,
        /// Film there, m; negative where the mesh does not keep the bodies apart.
        film: f64,
    },
    /// Heat lacks data.
    #[error("{0}; {help}", help = .0.advice())]
    MissingHeatData(#[from] crate::case::MissingHeatData),
    /// The temperatures could not be computed.
    #[error("temperatures: {0}")]
    Heat(#[from] heat::newton::HeatError),
    /// A linear system could not be solved.
    #[error("no convergence: the linear equations of a step cannot be solved: {0}")]
    Krylov(#[from] GmresError),
    /// A factorisation failed.
    #[error(
        "no convergence: the equations at the pressures found so far cannot be solved ({0}), as where the viscosity changes by more \
         decades than can be computed; constants of the lubricant's laws that are far from those of an oil do so"
    )]
    Factorisation(#[from] LuError),
    /// Mesh or elastic operator failed.
    #[error(transparent)]
    Discretisation(DiscretisationError),
    /// The observer asked to stop.
    #[error("interrupted")]
    Interrupted,
}

impl SolveError {
    /// What to try where a solve comes to no end for a reason of its own; `None`: what often helps.
    #[must_use]
    pub fn advice(&self) -> Option<&'static str> {
        match self {
            SolveError::EndCarries { .. } => Some(
                "more relief at the ends of the profile (kind = \"logarithmic\" with a design_load of this load or more falls off \
                 steeply enough without a tilt), less load or less misalignment; real ends are rounded, which a table can describe",
            ),
            _ => None,
        }
    }
}

impl From<DiscretisationError> for SolveError {
    fn from(error: DiscretisationError) -> SolveError {
        match error {
            DiscretisationError::Elastic(CholeskyError::Interrupted) => SolveError::Interrupted,
            error => SolveError::Discretisation(error),
        }
    }
}
