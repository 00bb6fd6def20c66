//! From a case to its solution.
//!
//! ```
//! # use ertel::{case::Case, run, solution::Field, solve::NoObserver};
//! # let roller = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/roller.toml");
//! let case = Case::read(roller.as_ref())?;
//! let solution = run::solve(&case, &mut NoObserver)?;
//! let fields = solution.fields();
//! let pressure = fields.values(Field::Pressure).expect("every contact has a pressure");
//! let largest = pressure.iter().copied().fold(0.0, f64::max);
//! assert!((largest / solution.summary.pressure_maximum.value - 1.0).abs() < 0.01);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod describe;
mod elements;
mod volumes;

use crate::case::{Case, finite_volumes_refuse};
use crate::contact::Supply;
use crate::params::{Method, SolverParams};
pub use crate::problem::{estimated_film, groups, predicted_film, problem};
use crate::solution::{HeatRound, IterationRecord, Solution};
use crate::solve::sequence;
use crate::solve::{Observer, SolveError};
use crate::warning::{Warning, WarningKind};

/// Version of the numerics: raised whenever the figures of some case move by more than rounding, so that points of studies that
/// were solved before are solved anew.
pub const NUMERICS: u32 = 12;

/// Whether a solve of the case would begin: it has the data that it needs, and a mesh that is allowed resolves its film.
/// Takes milliseconds.
///
/// # Errors
/// As [`solve`] has them before any work.
pub fn check(case: &Case) -> Result<(), SolveError> {
    elements::may_begin(case).map(drop)
}

/// What the solve of a similar case can start from. Finite volumes start from the dry contact.
pub struct Start(Option<Box<sequence::Start>>);

/// Solves a case.
///
/// # Errors
/// When no mesh level converges, the mesh cannot be built, or the observer cancels.
pub fn solve(case: &Case, observer: &mut dyn Observer) -> Result<Solution, SolveError> {
    let (solution, _) = solve_from(case, None, &[], observer)?;
    Ok(solution)
}

/// Solves a case from the solution of a similar one, where that leads to its own; else from the dry contact,
/// on a mesh that suits those of the cases `ahead` that are similar, too. Returns with the solution what the
/// next case can start from.
///
/// # Errors
/// As [`solve`].
pub fn solve_from(
    case: &Case,
    start: Option<&Start>,
    ahead: &[&Case],
    observer: &mut dyn Observer,
) -> Result<(Solution, Start), SolveError> {
    // On a thread of the pool: from outside, each of the thousands of short parallel loops would wait for one
    // thread to be woken before it began.
    rayon::scope(|_| {
        let start = start.and_then(|start| start.0.as_deref());
        let flooded = solve_flooded(case, start, observer)?;
        let (mut solution, start) = solve_here(case, start, ahead, observer)?;
        let Some((full, full_start)) = flooded else {
            return Ok((solution, Start(start.map(Box::new))));
        };
        solution.beside_flooded(&full);
        let start = match (start, full_start) {
            (Some(start), Some(full)) => Some(start.beside(full)),
            (start, _) => start,
        };
        Ok((solution, Start(start.map(Box::new))))
    })
}

/// A solution, and what the next one can start from.
type Ended = (Solution, Option<sequence::Start>);

/// The same case with more oil than the contact takes, where it has less; `None`, too, where that does not converge.
fn solve_flooded(
    case: &Case,
    start: Option<&sequence::Start>,
    observer: &mut dyn Observer,
) -> Result<Option<Ended>, SolveError> {
    if !case.supply.is_limited() {
        return Ok(None);
    }
    let flooded = Case {
        supply: Supply::Flooded,
        ..case.clone()
    };
    let start = start.and_then(sequence::Start::flooded);
    match solve_here(&flooded, start, &[], observer) {
        Err(SolveError::Interrupted) => Err(SolveError::Interrupted),
        end => Ok(end.ok()),
    }
}

fn solve_here(
    case: &Case,
    start: Option<&sequence::Start>,
    ahead: &[&Case],
    observer: &mut dyn Observer,
) -> Result<Ended, SolveError> {
    if case.solver.method == Some(Method::FiniteVolumes) {
        return Ok((volumes::solve(case, observer)?, None));
    }
    match elements::solve(case, start, ahead, observer) {
        Ok((solution, start)) => Ok((solution, Some(start))),
        Err(error) if may_be_tried_again(case, &error) => {
            let mut solution = match volumes::solve(case, observer) {
                Ok(solution) => solution,
                Err(SolveError::Interrupted) => return Err(SolveError::Interrupted),
                Err(_) => return Err(error),
            };
            let text =
                format!("solved by finite volumes, as finite elements did not converge: {error}");
            solution
                .warnings
                .push(Warning::new(WarningKind::Method, text));
            Ok((solution, None))
        }
        Err(error) => Err(error),
    }
}

/// Whether a case that finite elements did not solve is left to finite volumes: not where it asks for elements of its own.
fn may_be_tried_again(case: &Case, error: &SolveError) -> bool {
    let did_not_converge = matches!(
        error,
        SolveError::NotConverged { .. }
            | SolveError::AllFailed { .. }
            | SolveError::Krylov(_)
            | SolveError::Factorisation(_)
    );
    let (own, usual) = (&case.solver, SolverParams::default());
    let asks_for_elements = own.method.is_some()
        || own.formulation != usual.formulation
        || own.isotropic_diffusion != usual.isotropic_diffusion
        || own.ridge_diffusion != usual.ridge_diffusion
        || own.elastic_stabilisation != usual.elastic_stabilisation
        || own.penalty != usual.penalty
        || own.penalty_scaling != usual.penalty_scaling;
    did_not_converge && !asks_for_elements && finite_volumes_refuse(case).is_none()
}

/// Passes everything on and keeps the iterations.
struct Recorder<'a> {
    observer: &'a mut dyn Observer,
    history: Vec<IterationRecord>,
}

impl Observer for Recorder<'_> {
    fn level(&mut self, level: usize, n_levels: usize, n_pressure: usize, n_displacement: usize) {
        self.observer
            .level(level, n_levels, n_pressure, n_displacement);
    }

    fn iteration(&mut self, record: &IterationRecord) {
        self.history.push(record.clone());
        self.observer.iteration(record);
    }

    fn round(&mut self, round: usize, change: f64, rise: f64) {
        if let Some(last) = self.history.last_mut() {
            last.heat = Some(HeatRound {
                change,
                temperature_rise: rise,
            });
        }
        self.observer.round(round, change, rise);
    }

    fn cancelled(&self) -> bool {
        self.observer.cancelled()
    }
}

/// Peak resident memory of this process in bytes, from Linux's process status.
fn peak_memory() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|l| l.starts_with("VmHWM:"))?;
    let kib: u64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(1024 * kib)
}
