//! Solves a case by finite elements.

use super::describe::{Found, describe, has_derivatives, note_sensitivities};
use super::recorder::Recorder;
use crate::case::Case;
use crate::contact::Scales;
use crate::engine::{Observer, SolveError};
use crate::params::{Method, SensitivityDemand};
use crate::problem::problem;
use crate::sensitivity::by_differences;
use crate::solution::{Solution, Stats};
use crate::solve::newton_level::FilmModel;
use crate::solve::sequence::{Problem, Start};
use crate::solve::{Finished, FiniteElements, results};

/// The problem of a case if it can be solved.
pub(super) fn may_begin(case: &Case) -> Result<Problem, SolveError> {
    case.heat()?;
    let problem = problem(case);
    problem.check_size()?;
    Ok(problem)
}

/// Solves a case from a start if that converges, otherwise from the dry contact.
///
/// # Errors
/// As [`super::solve`].
pub(super) fn solve(
    case: &Case,
    start: Option<&Start>,
    observer: &mut dyn Observer,
) -> Result<(Solution, Start), SolveError> {
    let problem = may_begin(case)?;
    let mut recorder = Recorder {
        observer,
        history: Vec::new(),
    };
    let warm = match start.filter(|start| start.suits(&problem)) {
        Some(start) => FiniteElements.solve_from(&problem, start, &mut recorder)?,
        None => None,
    };
    let is_warm = warm.is_some();
    let solved = match warm {
        Some(end) => end,
        None => {
            recorder.history.clear();
            FiniteElements.solve(&problem, &mut recorder)?
        }
    };
    let stats = Stats {
        method: Method::FiniteElements,
        warm: is_warm,
        levels: solved.levels.clone(),
        wall_seconds: 0.0,
        peak_memory: None,
    };
    let found = found(case, &problem, &solved)?;
    let film = solved.film(&problem);
    let mut solution = describe(case, &problem, &film, found, stats, recorder.history);
    drop(film);
    let start = Start::new(&problem, solved.finest);
    if case.wants_sensitivities() {
        let resolved = |figure| has_derivatives(case, &solution, figure);
        let only_uncertain = case.output.sensitivities != SensitivityDemand::All;
        let observer = recorder.observer;
        let found = by_differences(case, &problem, &start, only_uncertain, resolved, observer);
        note_sensitivities(&mut solution, case, found)?;
    }
    Ok((solution, start))
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
    let warnings = results::summary::warnings(&summary, finest, case.mesh.target_error);
    Ok(Found {
        film_reduction: results::summary::film_reduction(levels, &measured),
        other_gap: None,
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
