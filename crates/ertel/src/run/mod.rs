//! From a case to its solution.
//!
//! ```
//! # use ertel::{case::Case, run, solution::Field, engine::NoObserver};
//! # let roller = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/roller.toml");
//! let case = Case::read(roller.as_ref())?;
//! let solution = run::solve(&case, &mut NoObserver)?;
//! let fields = solution.fields();
//! let pressure = fields.values(Field::Pressure).expect("every contact has a pressure");
//! let largest = pressure.iter().copied().fold(0.0, f64::max);
//! assert!((largest / solution.summary.pressure_maximum.value - 1.0).abs() < 0.01);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod checkpoint;
mod describe;
mod elements;
pub mod over_time;
mod recorder;
pub mod transient;
mod volumes;

use ertel_fem::platform::Instant;

use crate::case::{Case, finite_volumes_refuse};
use crate::contact::Supply;
use crate::engine::{Observer, SolveError};
use crate::params::{Method, SensitivityDemand, SolverParams};
use crate::post;
pub use crate::problem::{estimated_film, groups, predicted_film, problem};
use crate::solution::{Figure, Measured, Solution, Unresolved, Why};
use crate::solve::sequence;
use crate::stress::Stresses;
use crate::warning::{Warning, WarningKind, silence};

/// Version of the numerics: incremented whenever the figures of some case change by more than rounding. Study points
/// solved by an earlier version are then recomputed.
pub const NUMERICS: u32 = 31;

/// Checks that a case can be solved: it has the required data, and an allowed mesh resolves its film.
/// Takes milliseconds.
///
/// # Errors
/// Those of [`solve`] before any computation.
pub fn check(case: &Case) -> Result<(), SolveError> {
    match case.solver.method {
        // A first grid is always small enough.
        Some(Method::FiniteVolumes) => Ok(()),
        None if case.only_by_volumes().is_some() => Ok(()),
        _ => elements::may_begin(case).map(drop),
    }
}

/// Start for the solve of a similar case. Finite volumes start from the dry contact.
pub struct Start {
    own: Option<Box<sequence::Start>>,
    /// Start of the fully flooded contact, for a starved one.
    flooded: Option<Box<sequence::Start>>,
}

/// Solves a case.
///
/// # Errors
/// If no mesh level converges, the mesh cannot be built, or the observer cancels.
pub fn solve(case: &Case, observer: &mut dyn Observer) -> Result<Solution, SolveError> {
    let (solution, _) = solve_from(case, None, observer)?;
    Ok(solution)
}

/// Solves a case from the solution of a similar one if that converges, otherwise from the dry contact. Returns the solution and the
/// start for the next case.
///
/// # Errors
/// As [`solve`].
pub fn solve_from(
    case: &Case,
    start: Option<&Start>,
    observer: &mut dyn Observer,
) -> Result<(Solution, Start), SolveError> {
    // On a thread of the pool: started from outside, each of the thousands of short parallel loops would wait for a
    // thread to wake up.
    rayon::scope(|_| {
        let flooded = start.and_then(|start| start.flooded.as_deref());
        let flooded = solve_flooded(case, flooded, observer)?;
        let start = start.and_then(|start| start.own.as_deref());
        let (mut solution, own) = solve_here(case, start, observer)?;
        if let Some((full, _)) = &flooded {
            solution.compare_with_flooded(full);
        }
        solution.stresses = stresses(case, &solution);
        if let Some(stresses) = &solution.stresses {
            post::stresses::note(&mut solution.measured, stresses);
        }
        silence(&mut solution.warnings, &case.output.silence);
        let start = Start {
            own: own.map(Box::new),
            flooded: flooded.and_then(|(_, start)| start).map(Box::new),
        };
        Ok((solution, start))
    })
}

/// The stresses in the bodies, if the case asks for them.
fn stresses(case: &Case, solution: &Solution) -> Option<Stresses> {
    let params = case.stress.as_ref()?;
    let contact = (&solution.shape, &solution.hertz, case.contact.load);
    let error = pressure_error(&solution.measured);
    Some(post::stresses::stresses(
        params,
        contact,
        (&solution.surface, error),
        &case.coated(),
    ))
}

/// Error bar of the pressure over the pressure; zero without a bar.
fn pressure_error(measured: &Measured) -> f64 {
    let found = [Figure::PressureCentral, Figure::PressureMaximum];
    let pressure = found.into_iter().find_map(|figure| measured.find(figure));
    let relative = pressure.and_then(|p| Some(p.error? / p.value));
    relative.unwrap_or(0.0)
}

/// A solution and the start for the next one.
type Ended = (Solution, Option<sequence::Start>);

/// Target error of the flooded film next to a starved one, over that of the case: only films and their ratios are reported, which seldom depend on its last digits.
const FLOODED_COARSER: f64 = 2.5;

/// The fully flooded case of a starved contact; `None` for a flooded contact, or without convergence.
fn solve_flooded(
    case: &Case,
    start: Option<&sequence::Start>,
    observer: &mut dyn Observer,
) -> Result<Option<Ended>, SolveError> {
    // The flooded film would be that of another worn shape.
    if !case.supply.is_limited() || case.wear.is_some() {
        return Ok(None);
    }
    let mut flooded = Case {
        supply: Supply::Flooded,
        ..case.clone()
    };
    flooded.mesh.target_error = Some(FLOODED_COARSER * volumes::plan(case).target_error);
    flooded.output.sensitivities = SensitivityDemand::Off;
    // Both films are from the same method.
    if first_method(case) == Method::FiniteVolumes {
        flooded.solver.method = Some(Method::FiniteVolumes);
    }
    match solve_here(&flooded, start, observer) {
        Err(SolveError::Interrupted) => Err(SolveError::Interrupted),
        end => Ok(end.ok()),
    }
}

fn solve_here(
    case: &Case,
    start: Option<&sequence::Start>,
    observer: &mut dyn Observer,
) -> Result<Ended, SolveError> {
    let by = |method: Method, observer: &mut dyn Observer| -> Result<Ended, SolveError> {
        let clock = Instant::now();
        let (mut solution, start) = match method {
            Method::FiniteElements => {
                let (solution, start) = elements::solve(case, start, observer)?;
                (solution, Some(start))
            }
            Method::FiniteVolumes => {
                check(case)?;
                (volumes::solve(case, observer)?, None)
            }
        };
        solution.stats.wall_seconds = clock.elapsed().as_secs_f64();
        solution.stats.peak_memory = peak_memory();
        Ok((solution, start))
    };
    let first = first_method(case);
    match by(first, observer) {
        Err(error) if did_not_converge(&error) && may_use_other_method(case, first) => {
            match by(first.other(), observer) {
                Ok(end) => Ok(noting(end, first, &format!("did not converge: {error}"))),
                Err(SolveError::Interrupted) => Err(SolveError::Interrupted),
                Err(second) => Err(SolveError::BothFailed {
                    first: Box::new(error),
                    method: first.other().words(),
                    second: Box::new(second),
                }),
            }
        }
        // Not the other way round: grids end at their limit of unknowns, and elements took minutes there without resolving the film either.
        Ok(end)
            if first == Method::FiniteElements
                && lacks_a_film(case, &end.0)
                && may_use_other_method(case, first) =>
        {
            match by(first.other(), observer) {
                Ok(other) if unresolved_films(&other.0).is_empty() => {
                    let lacking = unresolved_films(&end.0).join(" and ");
                    Ok(noting(other, first, &format!("did not resolve {lacking}")))
                }
                Err(SolveError::Interrupted) => Err(SolveError::Interrupted),
                _ => Ok(end),
            }
        }
        end => end,
    }
}

/// A solution by the method other than `first`, with the outcome of that one.
fn noting((mut solution, start): Ended, first: Method, what: &str) -> Ended {
    let [first, second] = [first, first.other()].map(Method::words);
    let text = format!("solved by {second}, as {first} {what}");
    (solution.warnings).push(Warning::new(WarningKind::Method, text));
    (solution, start)
}

/// The films that a solution does not resolve, in words.
fn unresolved_films(solution: &Solution) -> Vec<String> {
    let films = [Figure::FilmCentral, Figure::FilmMinimum];
    (solution.unresolved.iter())
        .filter(|u| films.contains(&u.figure) && u.why != Why::BeyondBodies)
        .map(Unresolved::words)
        .collect()
}

/// Whether a solution does not resolve a film although only the method limits its meshes: near edges no method is better, and a limit on
/// unknowns is intended.
fn lacks_a_film(case: &Case, solution: &Solution) -> bool {
    let mesh = &case.mesh;
    let is_free = mesh.max_unknowns.is_none()
        && mesh.inlet.is_none()
        && mesh.outlet.is_none()
        && mesh.side.is_none();
    is_free && case.solver.error_estimate && !unresolved_films(solution).is_empty()
}

/// The method that a case requests, otherwise finite volumes; finite elements for lines with heat and without a limit of the stress, which they solve in a fraction of the time, and for contacts that finite
/// volumes do not solve (docs/decisions/0039-elements-and-volumes.md).
pub fn first_method(case: &Case) -> Method {
    if let Some(method) = case.solver.method {
        return method;
    }
    if case.only_by_volumes().is_some() {
        return Method::FiniteVolumes;
    }
    let has_limit = case.shear_thinning().is_some_and(|law| law.limit.is_some());
    let is_warm_line = case.thermal().is_some() && case.contact.kind.is_line() && !has_limit;
    match needs_elements(case) || is_warm_line || finite_volumes_refuse(case).is_some() {
        true => Method::FiniteElements,
        false => Method::FiniteVolumes,
    }
}

/// Whether a case requires finite elements.
fn needs_elements(case: &Case) -> bool {
    let (own, usual) = (&case.solver, SolverParams::default());
    case.has_key_of_elements()
        || own.error_estimate != usual.error_estimate
        || own.formulation != usual.formulation
        || own.isotropic_diffusion != usual.isotropic_diffusion
        || own.elastic_stabilisation != usual.elastic_stabilisation
        || own.penalty != usual.penalty
        || own.penalty_scaling != usual.penalty_scaling
}

/// Whether a solve failed for a reason specific to its method.
fn did_not_converge(error: &SolveError) -> bool {
    matches!(
        error,
        SolveError::NotConverged { .. }
            | SolveError::Thinned { .. }
            | SolveError::Krylov(_)
            | SolveError::Factorisation(_)
            | SolveError::GridNotConverged { .. }
            | SolveError::NotCoupled { .. }
            | SolveError::Heat(_)
    )
}

/// Whether a case that a method does not solve is passed to the other one.
fn may_use_other_method(case: &Case, first: Method) -> bool {
    let is_open = case.solver.method.is_none() && !needs_elements(case);
    let other_solves = match first {
        Method::FiniteElements => finite_volumes_refuse(case).is_none(),
        Method::FiniteVolumes => case.only_by_volumes().is_none(),
    };
    is_open && other_solves
}

/// Peak resident memory of this process in bytes, from Linux's process status.
fn peak_memory() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|l| l.starts_with("VmHWM:"))?;
    let kib: u64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(1024 * kib)
}
