//! A curve: point by point, each from the solution of the last.

use ertel_fem::platform::Instant;

use crate::case::curve::Quantity;
use crate::case::{Case, Curve};
use crate::output::{CaseEcho, digits};
use crate::reference::film_formulas;
use crate::run::{Session, Start, groups};
use crate::solution::{
    Centreline, ElementFields, Estimate, FilmReduction, FilmTemperatures, FormulaFilm, Solution,
    SurfaceField, ThermalReduction,
};
use crate::solve::{Observer, SolveError};

/// Follows a curve.
pub trait CurveObserver: Observer {
    /// The next point begins: its index from 0, how many there are, and the quantity's value with its unit.
    fn point(&mut self, _index: usize, _n_points: usize, _value: &str) {}
}

impl CurveObserver for crate::solve::Silent {}

/// What became of a curve.
#[derive(Clone, Debug)]
pub struct CurveSolution {
    /// What varies.
    pub quantity: Quantity,
    /// Every point that was begun, in the order of the case file.
    pub points: Vec<PointSolution>,
    /// Points that the curve has.
    pub n_points: usize,
    /// Wall time, s.
    pub wall_seconds: f64,
}

/// One point of a curve.
#[derive(Clone, Debug)]
pub struct PointSolution {
    /// The quantity's value, SI.
    pub value: f64,
    /// The point's case.
    pub case: CaseEcho,
    /// Film-thickness formulas.
    pub formulas: Vec<FormulaFilm>,
    /// Its solution, or why there is none.
    pub outcome: Outcome,
    /// The same point without shear thinning, where the curve asks for it.
    pub newtonian: Option<Outcome>,
    /// The same point without heat, likewise.
    pub isothermal: Option<Outcome>,
    /// Wall time, s.
    pub seconds: f64,
}

impl PointSolution {
    /// The Newtonian solution, if there is one.
    pub fn newtonian_solution(&self) -> Option<&Solution> {
        self.newtonian.as_ref().and_then(Outcome::solution)
    }

    /// The isothermal solution, if there is one.
    pub fn isothermal_solution(&self) -> Option<&Solution> {
        self.isothermal.as_ref().and_then(Outcome::solution)
    }

    /// What heat does to film and traction: beside the point's isothermal solution, else as its own stages tell.
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

    /// What shear thinning does to the film: beside the point's Newtonian solution, else as its own stages tell.
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

/// What became of a point.
#[derive(Clone, Debug)]
pub enum Outcome {
    /// Solved.
    Solved(Box<Solution>),
    /// Not solved; the reason in one sentence.
    Failed(String),
}

impl Outcome {
    /// The solution, if there is one.
    pub fn solution(&self) -> Option<&Solution> {
        match self {
            Outcome::Solved(solution) => Some(solution),
            Outcome::Failed(_) => None,
        }
    }

    /// The reason of a failure.
    pub fn reason(&self) -> Option<&str> {
        match self {
            Outcome::Solved(_) => None,
            Outcome::Failed(reason) => Some(reason),
        }
    }
}

impl CurveSolution {
    /// Points without solution.
    pub fn n_failed(&self) -> usize {
        let failed = |p: &&PointSolution| p.outcome.solution().is_none();
        self.points.iter().filter(failed).count()
    }

    /// Whether the user stopped it before the last point.
    pub fn is_partial(&self) -> bool {
        self.points.len() < self.n_points
    }
}

/// Solves the points of a curve in their order, each from the last one that was solved. A point that fails
/// is kept with its reason. When the observer cancels, the points until then are returned. Newtonian and isothermal
/// solutions, where the curve asks for them, start from one another, the first one from its own point.
///
/// Fields and iterations of the solutions are kept only where the curve asks for folders.
pub fn solve_curve(
    session: &Session,
    curve: &Curve,
    observer: &mut dyn CurveObserver,
) -> CurveSolution {
    let clock = Instant::now();
    let mut points = Vec::new();
    let mut start: Option<Start> = None;
    let mut besides = [
        Beside::new(curve.newtonian, "Newtonian", newtonian_case),
        Beside::new(curve.isothermal, "isothermal", isothermal_case),
    ];
    for (index, point) in curve.points.iter().enumerate() {
        let clock = Instant::now();
        let value = format!("{} {}", digits(point.value, 6), curve.quantity.unit());
        let value = value.trim_end();
        observer.point(index, curve.points.len(), value);
        let ahead: Vec<&Case> = curve.points[index + 1..].iter().map(|p| &p.case).collect();
        let outcome = match session.solve_from(&point.case, start.as_ref(), &ahead, observer) {
            Ok((mut solution, end)) => {
                start = Some(end);
                if !curve.folders {
                    drop_fields(&mut solution);
                }
                Outcome::Solved(Box::new(solution))
            }
            Err(SolveError::Interrupted) => break,
            Err(error) => Outcome::Failed(error.to_string()),
        };
        let mut outcomes = [None, None];
        let mut interrupted = false;
        for (beside, outcome) in besides.iter_mut().zip(&mut outcomes) {
            let Some(beside) = beside else { continue };
            observer.point(
                index,
                curve.points.len(),
                &format!("{value}, {}", beside.name),
            );
            match beside.solve(session, &point.case, start.as_ref(), &ahead, observer) {
                Some(solved) => *outcome = Some(solved),
                None => {
                    interrupted = true;
                    break;
                }
            }
        }
        if interrupted {
            break;
        }
        let [newtonian, isothermal] = outcomes;
        let case = &point.case;
        let lubricant = &case.lubricant;
        let slope = lubricant
            .viscosity
            .pressure_viscosity_slope(lubricant.temperature);
        points.push(PointSolution {
            value: point.value,
            case: case.echo(),
            formulas: film_formulas(&case.contact, &groups(case, slope)),
            outcome,
            newtonian,
            isothermal,
            seconds: clock.elapsed().as_secs_f64(),
        });
    }
    CurveSolution {
        quantity: curve.quantity,
        points,
        n_points: curve.points.len(),
        wall_seconds: clock.elapsed().as_secs_f64(),
    }
}

/// A simpler case solved beside each point, each from the one before.
struct Beside {
    name: &'static str,
    simpler: fn(&Case) -> Case,
    start: Option<Start>,
}

impl Beside {
    fn new(wanted: bool, name: &'static str, simpler: fn(&Case) -> Case) -> Option<Beside> {
        wanted.then_some(Beside {
            name,
            simpler,
            start: None,
        })
    }

    /// The simpler case of a point, the first one from the point's own solution; `None` when the observer cancels.
    fn solve(
        &mut self,
        session: &Session,
        case: &Case,
        start: Option<&Start>,
        ahead: &[&Case],
        observer: &mut dyn CurveObserver,
    ) -> Option<Outcome> {
        let ahead: Vec<Case> = ahead.iter().map(|case| (self.simpler)(case)).collect();
        let ahead: Vec<&Case> = ahead.iter().collect();
        let from = self.start.as_ref().or(start);
        match session.solve_from(&(self.simpler)(case), from, &ahead, observer) {
            Ok((mut solution, end)) => {
                self.start = Some(end);
                drop_fields(&mut solution);
                Some(Outcome::Solved(Box::new(solution)))
            }
            Err(SolveError::Interrupted) => None,
            Err(error) => Some(Outcome::Failed(error.to_string())),
        }
    }
}

/// The case without heat.
fn isothermal_case(case: &Case) -> Case {
    let mut case = case.clone();
    case.solver.isothermal = true;
    case
}

/// The case with the lubricant's low-shear viscosity alone.
fn newtonian_case(case: &Case) -> Case {
    let mut case = case.clone();
    case.solver.newtonian = true;
    case
}

/// A long curve keeps figures only.
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
