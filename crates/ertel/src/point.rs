//! Result of a point of a curve or a study: a contact, or a whole machine with its contacts and figures.

use std::sync::Arc;

use crate::case::{CaseEcho, WholeMachine};
use crate::figures::at_contacts::ContactFigures;
use crate::figures::{Row, find};
use crate::run::over_time::over_time;
use crate::run::transient::TransientSolution;
use crate::solution::{Estimate, Figure, FilmReduction, FormulaFilm, Solution, ThermalReduction};
use crate::warning::{Warning, by_kind};

/// A point of a curve or a study, solved or not.
#[derive(Clone, Debug)]
pub struct PointSolution {
    /// Value of the varied quantity, SI; in a study that of the first axis, NaN where it has no numbers.
    pub value: f64,
    /// The point's case.
    pub case: CaseEcho,
    /// Film-thickness formulas.
    pub formulas: Vec<FormulaFilm>,
    /// Its solution, or why there is none; of a whole machine that of the governing contact, where all contacts are solved.
    pub outcome: Outcome,
    /// Whether it is a case in time, solved or not.
    pub is_in_time: bool,
    /// The whole machine, where the point is one.
    pub machine: Option<Arc<MachinePoint>>,
    /// The same point without shear thinning, where requested.
    pub newtonian: Option<Outcome>,
    /// The same point without heat, likewise.
    pub isothermal: Option<Outcome>,
    /// Wall time, s.
    pub seconds: f64,
}

/// A whole machine at a point of a curve or a study.
#[derive(Clone, Debug)]
pub struct MachinePoint {
    /// Its contacts.
    pub solution: MachineSolution,
    /// Its figures; without sums where a contact is not solved.
    pub figures: MachineFigures,
}

impl PointSolution {
    /// Every solution of the point: one, or those of the contacts of a machine.
    pub fn solutions(&self) -> Vec<&Solution> {
        match &self.machine {
            None => self.outcome.solution().into_iter().collect(),
            Some(machine) => {
                let solved = machine.solution.solved();
                solved.filter_map(|(_, p)| p.outcome.solution()).collect()
            }
        }
    }

    /// The figures of a whole machine or of a run in time; none of single contacts.
    pub fn rows(&self) -> &[Row] {
        match (&self.machine, self.outcome.in_time()) {
            (Some(machine), _) => &machine.figures.all,
            (None, Some(run)) => &run.figures,
            (None, None) => &[],
        }
    }

    /// One of them by its name.
    pub fn row(&self, name: &str) -> Option<&Row> {
        find(self.rows(), name)
    }

    /// Whether it has figures that its mesh does not resolve.
    pub fn is_unresolved(&self) -> bool {
        if let Some(run) = self.outcome.in_time() {
            return !run.unresolved.is_empty();
        }
        let mut solutions = self.solutions().into_iter();
        let machine = self.machine.as_ref();
        solutions.any(|solution| !solution.unresolved.is_empty())
            || machine.is_some_and(|machine| machine.figures.unresolved().next().is_some())
    }

    /// Its warnings; of the contacts of a machine the worst of each kind.
    pub fn warnings(&self) -> Vec<Warning> {
        let Some(machine) = &self.machine else {
            return match &self.outcome {
                Outcome::Solved(solution) => solution.warnings.clone(),
                Outcome::InTime(run) => run.warnings.clone(),
                Outcome::Failed(_) => Vec::new(),
            };
        };
        let contacts = self.solutions().into_iter().enumerate();
        let of = contacts.flat_map(|(i, s)| s.warnings.iter().map(move |w| (i, w)));
        let of = by_kind(of).into_iter().map(|merged| merged.worst);
        machine.figures.warnings.iter().cloned().chain(of).collect()
    }

    /// The Newtonian solution, if there is one.
    pub fn newtonian_solution(&self) -> Option<&Solution> {
        self.newtonian.as_ref().and_then(Outcome::solution)
    }

    /// The isothermal solution, if there is one.
    pub fn isothermal_solution(&self) -> Option<&Solution> {
        self.isothermal.as_ref().and_then(Outcome::solution)
    }

    /// Effect of heat on film and traction: from the point's isothermal solution, else from its own stages.
    pub fn thermal_reduction(&self) -> Option<ThermalReduction> {
        let thermal = self.outcome.solution()?;
        let Some(isothermal) = self.isothermal_solution() else {
            return thermal.thermal.as_ref()?.reduction;
        };
        let (with, without) = (&thermal.summary, &isothermal.summary);
        let slides = self.case.motion.slides();
        let isothermal_traction = isothermal.traction.coefficient;
        Some(ThermalReduction {
            film_central: Estimate::reduction(with.film_central, without.film_central),
            film_minimum: Estimate::reduction(with.film_minimum, without.film_minimum),
            traction: slides
                .then(|| Estimate::reduction(thermal.traction.coefficient, isothermal_traction)),
            isothermal_traction,
        })
    }

    /// Effect of shear thinning on the film: from the point's Newtonian solution, else from its own stages.
    pub fn film_reduction(&self) -> Option<FilmReduction> {
        let thinned = self.outcome.solution()?;
        let Some(newtonian) = self.newtonian_solution() else {
            return thinned.film_reduction;
        };
        let (with, without) = (&thinned.summary, &newtonian.summary);
        Some(FilmReduction {
            central: Estimate::reduction(with.film_central, without.film_central),
            minimum: Estimate::reduction(with.film_minimum, without.film_minimum),
        })
    }
}

/// Outcome of a point.
#[derive(Clone, Debug)]
pub enum Outcome {
    /// Solved.
    Solved(Box<Solution>),
    /// Solved from the start of its time to the end.
    InTime(Box<RunInTime>),
    /// Not solved; the reason in one sentence.
    Failed(String),
}

/// A case in time at a point of a curve or a study.
#[derive(Clone, Debug)]
pub struct RunInTime {
    /// Figures of the whole run.
    pub figures: Vec<Row>,
    /// Steps in time, and how many were refused.
    pub steps: [usize; 2],
    /// Newton iterations on all grids.
    pub newton_iterations: usize,
    /// Names of the films that are not resolved at some instant.
    pub unresolved: Vec<&'static str>,
    /// Warnings.
    pub warnings: Vec<Warning>,
    /// All instants, where they are kept.
    pub instants: Option<Arc<TransientSolution>>,
}

impl RunInTime {
    /// Outcome of a run that has reached its end, of a line or another contact; `keep` keeps its instants.
    pub(crate) fn new(found: TransientSolution, is_line: bool, keep: bool) -> RunInTime {
        let films = [Figure::FilmCentral, Figure::FilmMinimum];
        let is_unresolved = |film: &Figure| {
            let mut instants = found.instants.iter();
            instants.any(|instant| !instant.measured.is_resolved(*film))
        };
        RunInTime {
            figures: over_time(&found, is_line),
            steps: [found.info.steps, found.info.refused],
            newton_iterations: found.info.newton_iterations,
            unresolved: (films.into_iter().filter(is_unresolved))
                .map(Figure::name)
                .collect(),
            warnings: found.warnings.clone(),
            instants: keep.then(|| Arc::new(found)),
        }
    }
}

impl Outcome {
    /// The solution, if there is one; of a case in time there is none.
    pub fn solution(&self) -> Option<&Solution> {
        match self {
            Outcome::Solved(solution) => Some(solution),
            Outcome::InTime(_) | Outcome::Failed(_) => None,
        }
    }

    /// The run, if it is that of a case in time.
    pub fn in_time(&self) -> Option<&RunInTime> {
        match self {
            Outcome::InTime(run) => Some(run),
            Outcome::Solved(_) | Outcome::Failed(_) => None,
        }
    }

    /// Whether it is solved, as a steady contact or in time.
    pub fn is_solved(&self) -> bool {
        self.reason().is_none()
    }

    /// The reason of a failure.
    pub fn reason(&self) -> Option<&str> {
        match self {
            Outcome::Solved(_) | Outcome::InTime(_) => None,
            Outcome::Failed(reason) => Some(reason),
        }
    }
}

/// Outcomes of the contacts of a machine.
#[derive(Clone, Debug)]
pub struct MachineSolution {
    /// The machine.
    pub machine: Arc<WholeMachine>,
    /// Outcome of each contact that represents others, by its place among the contacts; `None` where it is unloaded, another contact
    /// represents it, or the user stopped before.
    pub contacts: Vec<Option<PointSolution>>,
    /// Wall time, s.
    pub wall_seconds: f64,
}

impl MachineSolution {
    /// Outcome of the contact that represents this one.
    pub fn of(&self, contact: usize) -> Option<&PointSolution> {
        let like = self.machine.contacts[contact].like?;
        self.contacts[like].as_ref()
    }

    /// Its solution, if it has one.
    pub fn solution(&self, contact: usize) -> Option<&Solution> {
        self.of(contact)?.outcome.solution()
    }

    /// The contacts that ended, solved or failed, with their places.
    pub fn solved(&self) -> impl Iterator<Item = (usize, &PointSolution)> {
        let contacts = self.contacts.iter().enumerate();
        contacts.filter_map(|(i, point)| Some((i, point.as_ref()?)))
    }

    /// Contacts to be solved, identical ones counted once.
    pub fn n_contacts(&self) -> usize {
        distinct(&self.machine).len()
    }

    /// Those of them without solution.
    pub fn n_failed(&self) -> usize {
        let failed = self
            .solved()
            .filter(|(_, p)| p.outcome.solution().is_none());
        failed.count()
    }

    /// How many of its contacts have no solution, and why the first of them; `None` where all are solved.
    pub fn failure(&self) -> Option<String> {
        let mut failed = self.solved().filter_map(|(i, point)| match &point.outcome {
            Outcome::Failed(reason) => Some((i, reason)),
            Outcome::Solved(_) | Outcome::InTime(_) => None,
        });
        let (first, reason) = failed.next()?;
        let n = 1 + failed.count();
        let (all, name) = (self.n_contacts(), &self.machine.contacts[first].name);
        Some(format!("{n} of {all} contacts failed; {name}: {reason}"))
    }

    /// Contacts with a solution, identical ones counted once.
    pub fn n_solved(&self) -> usize {
        self.solved().count() - self.n_failed()
    }

    /// Whether the user stopped it before the last contact.
    pub fn is_partial(&self) -> bool {
        self.solved().count() < self.n_contacts()
    }

    /// How far an interrupted machine came, in words; `None` where all contacts have ended.
    pub fn interruption(&self) -> Option<String> {
        self.is_partial().then(|| {
            let (n, all) = (self.n_solved(), self.n_contacts());
            format!("interrupted: {n} of {all} different contacts solved")
        })
    }

    /// The machine before its contacts are solved.
    #[must_use]
    pub(crate) fn unsolved(&self) -> MachineSolution {
        MachineSolution {
            machine: self.machine.clone(),
            contacts: vec![None; self.contacts.len()],
            wall_seconds: self.wall_seconds,
        }
    }
}

/// Places of the contacts that are solved.
pub(crate) fn distinct(machine: &WholeMachine) -> Vec<usize> {
    let contacts = machine.contacts.iter().enumerate();
    let own = contacts.filter(|(i, contact)| contact.like == Some(*i));
    own.map(|(i, _)| i).collect()
}

/// The figures of a machine, those of its contacts, and warnings about them.
#[derive(Clone, Debug, Default)]
pub struct MachineFigures {
    /// The figures in their order.
    pub all: Vec<Row>,
    /// Figures at each contact.
    pub at_contacts: ContactFigures,
    /// Warnings.
    pub warnings: Vec<Warning>,
}

impl MachineFigures {
    /// Those that are not resolved.
    pub fn unresolved(&self) -> impl Iterator<Item = &Row> {
        self.all.iter().filter(|row| !row.estimate.is_resolved())
    }

    /// A figure by its name.
    pub fn find(&self, name: &str) -> Option<&Row> {
        find(&self.all, name)
    }
}
