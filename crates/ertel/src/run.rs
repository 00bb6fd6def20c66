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

use ertel_fem::platform::Instant;

use crate::case::Case;
use crate::contact::{Hertz, Scales, Supply};
use crate::engine::{Engine, Solved};
use crate::params::SensitivityDemand;
use crate::plausible;
use crate::plausible::left_out::Known;
use crate::post;
pub use crate::problem::{estimated_film, groups, predicted_film, problem};
use crate::problem::{problem_beside, problem_by_slices};
use crate::sensitivity::{by_adjoint, by_differences};
use crate::solution::{
    Asked, HeatRound, IterationRecord, Solution, Starvation, Stats, Uncertainties, Unresolved,
};
use crate::solve::adjoint::RoughAdjoints;
use crate::solve::newton::FilmModel;
use crate::solve::sequence::Problem;
pub use crate::solve::sequence::Start;
use crate::solve::{Finished, FiniteElements, Observer, SolveError};
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
    may_begin(case).map(drop)
}

/// The problem of a case, a roller's zone by slices, if a solve may begin.
fn may_begin(case: &Case) -> Result<Problem, SolveError> {
    case.heat()?;
    let problem = problem_by_slices(case);
    problem.check_size()?;
    Ok(problem)
}

/// The problem that a solve begins with.
fn ready(case: &Case) -> Result<Problem, SolveError> {
    let found = may_begin(case)?;
    Ok(match found.shape.zone.roller {
        // Not before it is known that it is worth the time.
        Some(_) => problem(case),
        None => found,
    })
}

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
        let flooded = solve_flooded(case, start, observer)?;
        let (mut solution, start) = solve_here(case, start, ahead, observer)?;
        let Some((full, full_start)) = flooded else {
            return Ok((solution, start));
        };
        solution.beside_flooded(&full);
        Ok((solution, start.beside(full_start)))
    })
}

/// The same case with more oil than the contact takes, where it has less; `None`, too, where that does not converge.
fn solve_flooded(
    case: &Case,
    start: Option<&Start>,
    observer: &mut dyn Observer,
) -> Result<Option<(Solution, Start)>, SolveError> {
    if !case.supply.is_limited() {
        return Ok(None);
    }
    let flooded = Case {
        supply: Supply::Flooded,
        ..case.clone()
    };
    let start = start.and_then(Start::flooded);
    match solve_here(&flooded, start, &[], observer) {
        Err(SolveError::Interrupted) => Err(SolveError::Interrupted),
        end => Ok(end.ok()),
    }
}

fn solve_here(
    case: &Case,
    start: Option<&Start>,
    ahead: &[&Case],
    observer: &mut dyn Observer,
) -> Result<(Solution, Start), SolveError> {
    let clock = Instant::now();
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
            // One after the other: there may be thousands.
            let own = problem.fluid.clone();
            problem.make_room_for(ahead.iter().map(|case| problem_beside(case, &own)));
            FiniteElements.solve(&problem, &mut recorder)?
        }
    };
    let stats = Stats {
        warm: warm_start.is_some(),
        levels: solved.levels().to_vec(),
        wall_seconds: 0.0,
        peak_memory: None,
    };
    let mut solution = describe(case, &problem, &solved, stats, recorder.history)?;
    let mut finest = solved.finest;
    let levels = &solution.stats.levels;
    let rough = finest.adjoints.take().map(|rough| *rough);
    let start = match warm_start {
        Some(start) => start.followed_by(&problem, finest, levels),
        None => Start::new(&problem, finest, levels),
    };
    note_sensitivities(
        &mut solution,
        case,
        &problem,
        (&start, rough),
        recorder.observer,
    )?;
    solution.stats.wall_seconds = clock.elapsed().as_secs_f64();
    solution.stats.peak_memory = peak_memory();
    Ok((solution, start))
}

/// Adds how much each input counts, where that is asked for, and what the uncertainty of the inputs comes to. A solution without is still one.
///
/// # Errors
/// Only when the user wants to stop.
fn note_sensitivities(
    solution: &mut Solution,
    case: &Case,
    problem: &Problem,
    (start, rough): (&Start, Option<RoughAdjoints>),
    observer: &mut dyn Observer,
) -> Result<(), SolveError> {
    if !case.wants_sensitivities() {
        return Ok(());
    }
    let resolved = |figure| solution.resolves(figure);
    let found = match &problem.heat {
        Some(_) => {
            let only_uncertain = case.output.sensitivities != SensitivityDemand::All;
            by_differences(case, problem, start, only_uncertain, resolved, observer)
        }
        None => by_adjoint(case, problem, start.solution(), rough, resolved),
    };
    let found = match found {
        Ok(found) => found,
        Err(SolveError::Interrupted) => return Err(SolveError::Interrupted),
        Err(error) => {
            let text = format!(
                "sensitivities and the uncertainty from the inputs could not be computed: {error}"
            );
            solution.warnings.push(Warning::from(text));
            return Ok(());
        }
    };
    let is_uncertain =
        |key: &str| (case.inputs().iter()).any(|i| i.key == key && i.uncertainty.is_some());
    for input in found
        .left_out
        .iter()
        .filter(|input| is_uncertain(&input.key))
    {
        solution.warnings.push(Warning::from(format!(
            "the uncertainty of the figures leaves out that of {}: {}",
            input.key, input.reason
        )));
    }
    solution.uncertainty = Uncertainties::first_order(&found, case.correlations());
    solution.sensitivities = Some(found);
    Ok(())
}

/// The figures and fields of a solved problem.
fn describe(
    case: &Case,
    problem: &Problem,
    solved: &Finished,
    stats: Stats,
    history: Vec<IterationRecord>,
) -> Result<Solution, SolveError> {
    let (finest, levels) = (&solved.finest, solved.levels());
    let measured = &solved.measured(problem).with_meniscus(&case.supply);
    let film = &solved.film(problem);
    let extents = finest.discretisation.contact.extents;
    let contact = case.contact.along_motion();
    let hertz = Hertz::new(&contact, case.reduced_modulus());
    let slope = case
        .lubricant
        .viscosity
        .pressure_viscosity_slope(case.lubricant.temperature);
    let asymptotic = case
        .lubricant
        .viscosity
        .pressure_viscosity_reciprocal_asymptotic(case.lubricant.temperature)
        .ok();
    let groups = groups(case, slope);
    let groups_asymptotic = asymptotic.map(|alpha| self::groups(case, alpha));
    let scales = Scales::new(
        &contact,
        &hertz,
        &case.motion,
        case.lubricant.ambient_viscosity(),
        case.lubricant.ambient_density(),
    );
    let model = FilmModel {
        fluid: problem.fluid.clone(),
        constants: finest.stage.constants,
    };
    let traction = post::summary::traction(measured);
    let film_reduction = post::summary::film_reduction(levels, measured);
    let summary = post::summary::summarise(finest, measured, &model, &scales);
    let thermal = (case.thermal())
        .and_then(|params| post::thermal::thermal(finest, problem, levels, measured, params));
    let (checks, summed_to) = post::checks::checks(problem, film, &summary, thermal.as_ref());
    let mut warnings = case.warnings.clone();
    warnings.extend(post::checks::warning(
        &problem.shape,
        &extents,
        scales.length,
        &measured.figures,
    ));
    let order = finest.discretisation.pressure.element.order();
    if order < case.mesh.pressure_order {
        let text = format!(
            "solved with pressures of order {order}: those of order {} did not converge; a finer mesh \
             may carry them",
            case.mesh.pressure_order
        );
        warnings.push(Warning::new(WarningKind::Convergence, text));
    }
    warnings.extend(post::summary::warnings(
        &summary,
        finest,
        levels,
        case.mesh.target_error,
    ));
    if let (Some(thermal), Some(params)) = (&thermal, case.thermal()) {
        let extents = [
            extents.inlet,
            extents.outlet,
            side_of(problem, extents.side),
        ];
        warnings.extend(post::thermal::warnings(
            thermal,
            &case.lubricant.temperature_ranges,
            params,
            &scales,
            finest.discretisation.contact.shape.symmetry,
            extents,
        ));
        let heat = problem.heat.iter();
        warnings
            .extend(heat.flat_map(|heat| post::thermal::at_rest::warnings(heat, thermal, params)));
    }
    let elements = post::elements::elements(finest, &scales);
    let mixed = case.roughness.map(|rms_height| {
        let surfaces = post::mixed::RoughSurfaces {
            rms_height,
            asperities: case.asperities,
            reduced_modulus: case.reduced_modulus(),
            load: case.contact.load,
        };
        let symmetry = problem.shape.symmetry;
        let (motion, summary) = (&case.motion, &summary);
        let mixed = post::mixed::mixed_lubrication(
            &surfaces, motion, symmetry, &elements, summary, &traction,
        );
        warnings.extend(post::mixed::warnings(&mixed, summary, rms_height));
        mixed
    });
    let mut solution = Solution {
        kind: case.contact.kind,
        shape: problem.shape.clone(),
        hertz,
        reduced_modulus: case.reduced_modulus(),
        formulas: crate::reference::film_formulas(&case.contact, &groups, case.relative_density()),
        groups,
        groups_asymptotic,
        scales,
        extents: [
            extents.inlet,
            extents.outlet,
            side_of(problem, extents.side),
        ],
        centreline: post::fields::centreline(finest, &problem.fluid, &scales),
        surface: post::fields::surface(finest, &problem.fluid, &scales),
        elements,
        body: (case.output.body_field)
            .then(|| post::fields::body(finest, &scales))
            .transpose()?
            .flatten(),
        left_out: plausible::left_out::left_out(
            case,
            &Known {
                film_central: summary.film_central.value,
                film_minimum: summary.film_minimum.value,
                friction_power: traction.friction_power.value,
            },
        ),
        unresolved: Vec::new(),
        summary,
        starvation: Starvation::of(measured, &case.supply),
        measured: *measured,
        mixed,
        traction,
        summed_to,
        checks,
        film_reduction,
        sensitivities: None,
        uncertainty: None,
        thermal,
        history,
        stats,
        warnings,
    };
    let asked = Asked {
        bars: case.solver.error_estimate,
        // The forces of spin alone cancel.
        slides: case.motion.sliding_at_centre() > 0.0,
        radius: case.contact.radius,
    };
    solution.unresolved = Unresolved::all(&solution, asked);
    let doubts = plausible::warnings(case, &solution);
    solution.warnings.extend(doubts);
    Ok(solution)
}

/// Half the extent of the contact area across the motion, in half-widths, or semi-axes along y of an ellipse.
fn side_of(problem: &Problem, side: f64) -> f64 {
    let roller = problem.shape.zone.roller.as_ref();
    roller.map_or(side, |roller| roller.half_length())
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
