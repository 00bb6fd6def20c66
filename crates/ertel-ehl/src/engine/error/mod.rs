//! Reasons for a solve to fail, by any numerical method.

mod advice;
mod missing;

pub use missing::{MissingDatum, MissingHeatData};

use ertel_fem::linear::block_ilu::BlockIluError;
use ertel_fem::linear::condensed::CholeskyError;
use ertel_fem::linear::gmres::GmresError;
use ertel_fem::linear::lu::LuError;

use crate::elastic::FiniteBodyError;
use crate::words::length;

/// Why Newton's method stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Stopped {
    /// The equations have no value at the pressures found.
    #[error("the residual is not finite")]
    NotFinite,
    /// Nor anywhere along the step.
    #[error("no step leads to a finite residual")]
    NoStep,
    /// The updates cycle.
    #[error("the updates no longer shrink")]
    Circling,
    /// They shrink, but too slowly.
    #[error("the iterations ran out")]
    OutOfIterations,
    /// A root of the discrete equations, but no contact.
    #[error("the mesh is too coarse for the film, which comes out negative at a point")]
    NegativeFilm,
}

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
        reason: Stopped,
    },
    /// Newton's method of finite volumes did not converge.
    #[error(
        "no convergence of finite volumes on grid {}: after {iterations} Newton iterations {}",
        level + 1,
        pressures(*change)
    )]
    GridNotConverged {
        /// Grid, 0 the first.
        level: usize,
        /// Newton iterations in all, over all speeds that were tried.
        iterations: usize,
        /// Last change of a pressure over p_h; not finite where the last attempt diverged.
        change: f64,
        /// Whether the surfaces have reliefs, which finite volumes alone solve.
        has_reliefs: bool,
    },
    /// The film-temperature coupling did not converge.
    #[error(
        "no convergence in {part} {}: film and temperature still change by {change:.1e} after {rounds} rounds \
         (by a factor of {contraction:.2} from round to round)",
        level + 1
    )]
    NotCoupled {
        /// Unit of `level`: stages, or the grids of finite volumes.
        part: &'static str,
        /// Its number, 0 the first.
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
        "the film is too thin to resolve: formulas predict a central film of {:.3e} m{}, {ratio:.1e} of a²/R; its pressure builds up \
         within {length:.1e} half-widths, so that the first mesh needs cells of {size:.1e} half-widths and about {unknowns:.0} \
         pressure unknowns, where {limit:.0} are allowed",
        film,
        if *sheared { ", with shear thinning ([lubricant.shear_thinning]) at the shear rates of the inlet" } else { "" }
    )]
    TooThin {
        /// Predicted central film thickness, m.
        film: f64,
        /// Whether shear thinning counts in it.
        sheared: bool,
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
        /// Advice.
        help: &'static str,
    },
    /// The contact of a roller runs over its end.
    #[error(
        "no solution with a film everywhere: the contact runs over the end of the roller at y = {:.4} mm. The pressure is zero there and \
         the surfaces touch; the thinnest film near the end is {:.3} nm, also on the previous mesh",
        1e3 * place,
        1e9 * film
    )]
    EndCarries {
        /// y of the end, m.
        place: f64,
        /// Film there, m; negative where the bodies overlap on the mesh.
        film: f64,
    },
    /// No grid that is allowed resolves the reliefs of the surfaces.
    #[error(
        "the shortest length of a relief needs cells of {needed:.1e} half-widths, and [mesh] max_unknowns allows {cell:.1e}"
    )]
    ReliefNotResolved {
        /// Cell of the finest grid, in half-widths.
        cell: f64,
        /// Cell that resolves them.
        needed: f64,
    },
    /// Neither method converged.
    #[error("{first}; {method} failed, too: {second}")]
    BothFailed {
        /// Why the first method failed.
        first: Box<SolveError>,
        /// The second method in words.
        method: &'static str,
        /// Why it failed.
        second: Box<SolveError>,
    },
    /// A contact that wears did not reach its sliding distance.
    #[error(
        "the wear ends at a sliding distance of {} of {}, after {steps} step{}: {}",
        length(*distance),
        length(*of),
        if *steps == 1 { "" } else { "s" },
        error.as_ref().map_or("[wear] max_steps allows no more".to_owned(), ToString::to_string)
    )]
    Worn {
        /// Distance at the last solution, m.
        distance: f64,
        /// Sliding distance of the case, m.
        of: f64,
        /// Steps until then.
        steps: usize,
        /// Why the next one failed; `None` where the steps ran out.
        error: Option<Box<SolveError>>,
    },
    /// The solve failed where shear thins the fluid in the inlet far more than oils.
    #[error(
        "{error}; [lubricant.shear_thinning] leaves about {:.2} % of the Newtonian film, by formula: shear stresses in the inlet are far \
         above the onset of thinning",
        100.0 * share
    )]
    Thinned {
        /// The failure.
        error: Box<SolveError>,
        /// Film over that of the Newtonian fluid, about.
        share: f64,
    },
    /// Thermal data are missing.
    #[error("{0}; {help}", help = .0.advice())]
    MissingHeatData(#[from] MissingHeatData),
    /// The temperatures could not be computed.
    #[error("temperatures: {0}")]
    Heat(#[from] HeatError),
    /// A linear system could not be solved.
    #[error(
        "no convergence: the linear equations of a step cannot be solved accurately enough (relative residual {:.1e})",
        .0.residual
    )]
    Krylov(#[from] GmresError),
    /// A factorisation failed.
    #[error(
        "no convergence: the linear system is singular at the current pressures ({0}), for example because the viscosity varies by too many \
         decades; check the constants of the viscosity law"
    )]
    Factorisation(#[from] LuError),
    /// Mesh or elastic operator failed.
    #[error(transparent)]
    Discretisation(FiniteBodyError),
    /// The observer asked to stop.
    #[error("interrupted")]
    Interrupted,
}

/// Temperatures could not be computed.
#[derive(Debug, thiserror::Error)]
pub enum HeatError {
    /// The preconditioner broke down.
    #[error(transparent)]
    Factorisation(#[from] BlockIluError),
    /// The linear solver did not converge.
    #[error(transparent)]
    Krylov(#[from] GmresError),
    /// The heat of shearing is beyond all bounds, as where a pressure gradient asks for more than the limiting stress.
    #[error(
        "shearing heats the film beyond all bounds: at the pressures found so far its shear stress is far above the limiting or \
         Eyring stress of the law, where shear rates grow exponentially"
    )]
    Overheated,
    /// A temperature or a source is not a number.
    #[error("the heat of the film is not finite")]
    NotFinite,
    /// By finite volumes: too much heat flows into a body where it turns about a point near the contact.
    #[error(
        "{:.0} % of the heat into a body flows in where finite volumes do not follow its surface, beyond the point about which it turns or more than a quarter of a turn from the contact",
        100.0 * share
    )]
    Turns {
        /// That share.
        share: f64,
    },
}

/// How far the pressures came.
fn pressures(change: f64) -> String {
    match change.is_finite() {
        true => format!("pressures still change by {change:.1e} p_h"),
        false => "the last attempt diverges".to_owned(),
    }
}

impl From<FiniteBodyError> for SolveError {
    fn from(error: FiniteBodyError) -> SolveError {
        match error {
            FiniteBodyError::Elastic(CholeskyError::Interrupted) => SolveError::Interrupted,
            error => SolveError::Discretisation(error),
        }
    }
}
