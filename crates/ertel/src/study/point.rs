//! One point of a curve or a study: from its case and its start to its outcome.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use ertel_fem::platform::Instant;

use super::machine::{RootStarts, solve_contacts};
use super::{CurveObserver, MachineObserver};
use crate::case::Case;
use crate::case::study::StudyPoint;
use crate::engine::{Observer, SolveError};
use crate::machine::{SolvedMachine, figures, solve_by};
use crate::point::{MachinePoint, Outcome, PointSolution, RunInTime};
use crate::reference::film_formulas;
use crate::run::transient::{InstantObserver, Reached, solve as solve_in_time};
use crate::run::{Start, groups, solve_from};
use crate::solution::{
    Centreline, ElementFields, FilmTemperatures, IterationRecord, Solution, SurfaceField,
};
use crate::transient::TransientError;

/// A point to be solved.
pub(crate) struct Task<'a> {
    pub(crate) point: &'a StudyPoint,
    /// Its place among the points, and their number.
    pub(crate) place: (usize, usize),
    /// Its values, for the observer.
    pub(crate) label: String,
    /// Cases that its mesh should suit, too, if it needs a new one.
    pub(crate) ahead: Vec<&'a Case>,
    /// Which of the [`SIMPLER`] cases are solved, too.
    pub(crate) simpler: [bool; 2],
    /// Whether its fields and iterations are kept.
    pub(crate) fields: bool,
    /// Contacts of a machine that are solved side by side.
    pub(crate) workers: usize,
}

/// Why a point that is a machine has no contacts.
const NO_CONTACTS: &str = "the contacts of the machine can no longer be read: a file that the case is read from has changed";

type Simplify = fn(&mut Case);

/// Cases that may be solved in addition to a point: without shear thinning, and without heat.
const SIMPLER: [(&str, Simplify); 2] = [
    ("Newtonian", |case| case.solver.newtonian = true),
    ("isothermal", |case| case.solver.isothermal = true),
];

/// Results of a point and its simpler cases, from which other points start.
#[derive(Clone, Default)]
pub(crate) struct Ends {
    own: Option<Arc<Start>>,
    simpler: [Option<Arc<Start>>; 2],
    /// Of a machine those of its contacts that start from no other.
    roots: RootStarts,
}

impl Ends {
    /// Those of a single contact.
    pub(super) fn of_contact(own: Option<Arc<Start>>) -> Ends {
        Ends {
            own,
            ..Ends::default()
        }
    }

    /// Result of the contact itself.
    pub(super) fn own(&self) -> Option<Arc<Start>> {
        self.own.clone()
    }
}

/// The user wants to stop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Interrupted;

impl Task<'_> {
    /// Solves the point from the ends of another one. A simpler case starts from that of the other point, the first one from
    /// its own point. What fails is kept with its reason, and others start from where it started.
    pub(crate) fn solve(
        &self,
        mut ends: Ends,
        observer: &mut dyn CurveObserver,
    ) -> Result<(PointSolution, Ends), Interrupted> {
        let clock = Instant::now();
        let case = &self.point.case;
        let (index, n_points) = self.place;
        match &case.whole {
            Some(_) => return self.solve_machine(ends, observer),
            None => observer.point(index, n_points, &self.label),
        }
        let from = ends.own.as_deref();
        let (outcome, end) = attempt(case, from, &self.ahead, self.fields, observer)?;
        ends.own = end.or(ends.own);
        let mut simpler = [None, None];
        for (i, (name, simplify)) in SIMPLER.into_iter().enumerate() {
            if !self.simpler[i] {
                continue;
            }
            observer.point(index, n_points, &format!("{}, {name}", self.label));
            let simplified = |case: &Case| {
                let mut case = case.clone();
                simplify(&mut case);
                case
            };
            let ahead: Vec<Case> = self.ahead.iter().map(|case| simplified(case)).collect();
            let ahead: Vec<&Case> = ahead.iter().collect();
            let from = ends.simpler[i].as_deref().or(ends.own.as_deref());
            let (outcome, end) = attempt(&simplified(case), from, &ahead, false, observer)?;
            simpler[i] = Some(outcome);
            ends.simpler[i] = end.or(ends.simpler[i].take());
        }
        let [newtonian, isothermal] = simpler;
        let point = PointSolution {
            newtonian,
            isothermal,
            ..self.ended(outcome, &clock)
        };
        Ok((point, ends))
    }

    /// Outcome of the point, without its simpler cases.
    fn ended(&self, outcome: Outcome, clock: &Instant) -> PointSolution {
        let case = &self.point.case;
        let lubricant = &case.lubricant;
        let slope = (lubricant.viscosity).pressure_viscosity_slope(lubricant.temperature);
        PointSolution {
            value: self.point.value(),
            case: case.echo(),
            formulas: film_formulas(&case.contact, &groups(case, slope), case.relative_density()),
            outcome,
            is_in_time: case.transient.is_some(),
            machine: None,
            newtonian: None,
            isothermal: None,
            seconds: clock.elapsed().as_secs_f64(),
        }
    }

    /// Solves all contacts of a machine. The first ones of each mesh start from those of the other point.
    fn solve_machine(
        &self,
        ends: Ends,
        observer: &mut dyn CurveObserver,
    ) -> Result<(PointSolution, Ends), Interrupted> {
        let clock = Instant::now();
        let mut observer = MachineObserver {
            observer,
            place: self.place,
            label: &self.label,
        };
        let mut roots = ends.roots.clone();
        let solved = solve_by(&self.point.case, |contacts| {
            let (solution, reached) = solve_contacts(contacts, &roots, self.workers, &mut observer);
            roots = reached;
            solution
        });
        let ends = Ends { roots, ..ends };
        let solved = match solved {
            Ok(Some(solved)) => solved,
            Ok(None) => {
                return Ok((
                    self.ended(Outcome::Failed(NO_CONTACTS.to_owned()), &clock),
                    ends,
                ));
            }
            Err(error) => {
                return Ok((self.ended(Outcome::Failed(error.to_string()), &clock), ends));
            }
        };
        let SolvedMachine {
            case,
            solution,
            balance,
        } = solved;
        if solution.is_partial() {
            return Err(Interrupted);
        }
        let figures = figures(&case, &solution);
        let governing = solution.solution(solution.machine.governing);
        let lost = balance.filter(|balance| !balance.is_found());
        let failure = solution.failure().or(lost.map(|balance| balance.words()));
        let outcome = match (failure, governing) {
            (None, Some(governing)) => Outcome::Solved(Box::new(governing.clone())),
            (None, None) => Outcome::Failed("the governing contact is not loaded".to_owned()),
            (Some(reason), _) => Outcome::Failed(reason),
        };
        let point = PointSolution {
            case: case.echo(),
            machine: Some(Arc::new(MachinePoint { solution, figures })),
            ..self.ended(outcome, &clock)
        };
        Ok((point, ends))
    }
}

/// Outcome of a case, and the start for others. A failure of any kind does not affect the others.
fn attempt(
    case: &Case,
    from: Option<&Start>,
    ahead: &[&Case],
    fields: bool,
    observer: &mut dyn CurveObserver,
) -> Result<(Outcome, Option<Arc<Start>>), Interrupted> {
    if case.transient.is_some() {
        return Ok((attempt_in_time(case, fields, observer)?, None));
    }
    let solve = || solve_from(case, from, ahead, observer);
    let failed = |reason| Ok((Outcome::Failed(reason), None));
    match catch_unwind(AssertUnwindSafe(solve)) {
        Ok(Ok((mut solution, end))) => {
            if !fields {
                drop_fields(&mut solution);
            }
            Ok((Outcome::Solved(Box::new(solution)), Some(Arc::new(end))))
        }
        Ok(Err(SolveError::Interrupted)) => Err(Interrupted),
        Ok(Err(error)) => failed(error.to_string()),
        Err(_) => failed(PANICKED.to_owned()),
    }
}

/// Why a point whose solve panicked is not solved.
const PANICKED: &str = "internal error; see the message above";

/// Outcome of a case in time, which starts from no other: its own steady contact, or separated bodies.
fn attempt_in_time(
    case: &Case,
    keep: bool,
    observer: &mut dyn CurveObserver,
) -> Result<Outcome, Interrupted> {
    let solve = || solve_in_time(case, &mut Instants(observer));
    let Ok(found) = catch_unwind(AssertUnwindSafe(solve)) else {
        return Ok(Outcome::Failed(PANICKED.to_owned()));
    };
    match &found.failure {
        Some(TransientError::Interrupted) => Err(Interrupted),
        Some(error) => Ok(Outcome::Failed(error.to_string())),
        None => Ok(Outcome::InTime(Box::new(RunInTime::new(
            found,
            case.contact.kind.is_line(),
            keep,
        )))),
    }
}

/// Reports the instants of a point to the observer of a curve.
struct Instants<'a>(&'a mut dyn CurveObserver);

impl Observer for Instants<'_> {
    fn level(&mut self, level: usize, n_levels: usize, n_pressure: usize, n_displacement: usize) {
        self.0.level(level, n_levels, n_pressure, n_displacement);
    }

    fn grid(&mut self, grid: usize, n_pressure: usize) {
        self.0.grid(grid, n_pressure);
    }

    fn iteration(&mut self, record: &IterationRecord) {
        self.0.iteration(record);
    }

    fn round(&mut self, round: usize, change: f64, rise: f64) {
        self.0.round(round, change, rise);
    }

    fn cancelled(&self) -> bool {
        self.0.cancelled()
    }
}

impl InstantObserver for Instants<'_> {
    fn instant(&mut self, reached: &Reached) {
        self.0.reached(reached);
    }
}

/// A long study keeps figures only.
fn drop_fields(solution: &mut Solution) {
    solution.centreline = Centreline::default();
    solution.surface = SurfaceField::default();
    solution.elements = ElementFields::default();
    solution.body = None;
    if let Some(thermal) = &mut solution.thermal {
        thermal.centreline = FilmTemperatures::default();
        thermal.surface = FilmTemperatures::default();
        thermal.profiles = Vec::new();
        thermal.field = None;
    }
    solution.history = Vec::new();
}
