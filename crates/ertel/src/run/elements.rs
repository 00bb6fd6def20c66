//! Solves a case by finite elements.

use super::describe::{Found, describe, has_derivatives, note_sensitivities};
use super::recorder::Recorder;
use crate::case::Case;
use crate::contact::Scales;
use crate::engine::{Observer, SolveError};
use crate::params::{Method, SensitivityDemand};
use crate::problem::{nearby_problem, problem, problem_by_slices};
use crate::sensitivity::{by_adjoint, by_differences};
use crate::solution::{Sensitivities, Solution, Stats};
use crate::solve::adjoint::RoughAdjoints;
use crate::solve::newton_level::FilmModel;
use crate::solve::sequence::{Problem, Start};
use crate::solve::{Finished, FiniteElements, results};
use crate::warning::{Warning, WarningKind};

/// The problem of a case if it can be solved; the zone of a roller by slices.
pub(super) fn may_begin(case: &Case) -> Result<Problem, SolveError> {
    case.heat()?;
    let problem = problem_by_slices(case);
    problem.check_size()?;
    Ok(problem)
}

/// The initial problem of a solve.
fn ready(case: &Case) -> Result<Problem, SolveError> {
    let found = may_begin(case)?;
    Ok(match found.shape.zone.roller {
        // Built only after the check succeeds, because it takes time.
        Some(_) => problem(case),
        None => found,
    })
}

/// Solves a case from a start if that converges, otherwise from the dry contact.
///
/// # Errors
/// As [`super::solve`].
pub(super) fn solve(
    case: &Case,
    start: Option<&Start>,
    ahead: &[&Case],
    observer: &mut dyn Observer,
) -> Result<(Solution, Start), SolveError> {
    let mut problem = ready(case)?;
    let mut recorder = Recorder {
        observer,
        history: Vec::new(),
    };
    let warm = match start.filter(|start| start.suits(&problem)) {
        Some(start) => FiniteElements.solve_from(&problem, start, &mut recorder)?,
        None => None,
    };
    let warm_start = start.filter(|_| warm.is_some());
    let solved = match warm {
        Some(end) => end,
        None => {
            recorder.history.clear();
            // One at a time: there may be thousands.
            let own = problem.fluid.clone();
            problem.make_room_for(ahead.iter().map(|case| nearby_problem(case, &own)));
            FiniteElements.solve(&problem, &mut recorder)?
        }
    };
    let stats = Stats {
        method: Method::FiniteElements,
        warm: warm_start.is_some(),
        levels: solved.levels.clone(),
        wall_seconds: 0.0,
        peak_memory: None,
    };
    let found = found(case, &problem, &solved)?;
    let film = solved.film(&problem);
    let mut solution = describe(case, &problem, &film, found, stats, recorder.history);
    drop(film);
    let mut finest = solved.finest;
    let levels = &solution.stats.levels;
    let rough = finest.adjoints.take().map(|rough| *rough);
    let start = Start::new(&problem, finest, levels, warm_start);
    if case.wants_sensitivities() {
        let by = (&start, rough);
        let found = sensitivities(&solution, case, &problem, by, recorder.observer);
        note_sensitivities(&mut solution, case, found)?;
    }
    Ok((solution, start))
}

/// Sensitivities to the inputs.
///
/// # Errors
/// If they cannot be computed, or the user stops the run.
fn sensitivities(
    solution: &Solution,
    case: &Case,
    problem: &Problem,
    (start, rough): (&Start, Option<RoughAdjoints>),
    observer: &mut dyn Observer,
) -> Result<Sensitivities, SolveError> {
    let resolved = |figure| solution.resolves(figure) && has_derivatives(case, figure);
    match &problem.heat {
        Some(_) => {
            let only_uncertain = case.output.sensitivities != SensitivityDemand::All;
            by_differences(case, problem, start, only_uncertain, resolved, observer)
        }
        None => by_adjoint(case, problem, start.solution(), rough, resolved),
    }
}

/// Results of the elements, SI.
fn found(case: &Case, problem: &Problem, solved: &Finished) -> Result<Found, SolveError> {
    let (finest, levels) = (&solved.finest, &solved.levels);
    let measured = solved.measured(problem).with_meniscus(&case.supply);
    let extents = finest.discretisation.contact.extents;
    let scales: &Scales = &problem.scales;
    let model = FilmModel {
        fluid: problem.fluid.clone(),
        constants: finest.stage.constants,
    };
    let summary = results::summary::summarise(finest, &measured, &model, scales);
    let thermal = (case.thermal())
        .and_then(|params| results::thermal::thermal(finest, problem, levels, &measured, params));
    let mut warnings = Vec::new();
    let order = finest.discretisation.pressure.element.order();
    if order < case.mesh.pressure_order {
        let text = format!(
            "solved with pressures of order {order}: those of order {} did not converge; a finer mesh \
             may help",
            case.mesh.pressure_order
        );
        warnings.push(Warning::new(WarningKind::Convergence, text));
    }
    warnings.extend(results::summary::warnings(
        &summary,
        finest,
        levels,
        case.mesh.target_error,
    ));
    Ok(Found {
        film_reduction: results::summary::film_reduction(levels, &measured),
        centreline: results::fields::centreline(finest, problem.friction_fluid(), scales),
        surface: results::fields::surface(finest, problem.friction_fluid(), scales),
        elements: results::elements::elements(finest, scales),
        body: (case.output.body_field)
            .then(|| results::fields::body(finest, scales))
            .transpose()?
            .flatten(),
        extents,
        measured,
        summary,
        thermal,
        warnings,
    })
}
