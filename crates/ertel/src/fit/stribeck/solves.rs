//! Contacts at the points of a measured Stribeck curve, with other constants of their rough surfaces.

use std::sync::atomic::{AtomicUsize, Ordering};

use super::error::StribeckError;
use crate::case::study::StudyPoint;
use crate::case::{Case, Study};
use crate::engine::{Observer, SolveError};
use crate::mixed::AsperityLaw;
use crate::params::SensitivityDemand;
use crate::run;
use crate::solution::Solution;

/// Target error of the films: a search needs trends, and measured friction scatters by more.
pub const TARGET_ERROR: f64 = 0.01;
/// Boundary friction coefficient of cases that give none; friction is proportional to it, and only heat depends on it otherwise.
const ANY_FRICTION: f64 = 0.1;
/// Least boundary friction coefficient of the heat of asperities, over which their friction is taken.
const LEAST_FRICTION: f64 = 1e-3;

/// Follows a fit.
pub trait FitObserver: Sync {
    /// A round begins: from 1, with so many contacts to solve.
    fn round(&self, _round: usize, _n_solves: usize) {}
    /// Whether the user wants to stop.
    fn cancelled(&self) -> bool {
        false
    }
}

/// Friction at the points with some constants: for each point that of the film, then that of the asperities over f_b; and the largest error bar of their sum.
pub(super) struct Solved {
    pub parts: Vec<f64>,
    pub bar: f64,
}

/// The contacts of a curve.
pub(super) struct Contacts {
    cases: Vec<Case>,
}

impl Contacts {
    /// Of the points of a study, without results that the fit does not need.
    pub(super) fn new(study: &Study) -> Result<Contacts, StribeckError> {
        let of = |point: &StudyPoint| {
            let mut case = point.case.clone();
            if case.transient.is_some() {
                return Err(StribeckError::InTime);
            }
            let Some(asperities) = &mut case.asperities else {
                return Err(StribeckError::NoAsperities);
            };
            // The contact with the other gap is not needed.
            asperities.flow_is_chosen = true;
            let given = asperities.boundary_friction_coefficient;
            let usable = given.filter(|friction| *friction > 0.0);
            asperities.boundary_friction_coefficient = Some(usable.unwrap_or(ANY_FRICTION));
            let own = case.mesh.target_error.unwrap_or(TARGET_ERROR);
            case.mesh.target_error = Some(own.max(TARGET_ERROR));
            case.output.sensitivities = SensitivityDemand::Off;
            case.stress = None;
            Ok(case)
        };
        let cases = study.points.iter().map(of).collect::<Result<_, _>>()?;
        Ok(Contacts { cases })
    }

    /// The first case.
    pub(super) fn first(&self) -> Option<&Case> {
        self.cases.first()
    }

    /// How many there are.
    pub(super) fn len(&self) -> usize {
        self.cases.len()
    }

    /// Whether the heat of the asperities changes the film.
    pub(super) fn are_thermal(&self) -> bool {
        self.cases.iter().any(|case| case.thermal().is_some())
    }

    /// Takes a boundary friction coefficient for the heat of the asperities.
    pub(super) fn set_friction(&mut self, friction: f64) {
        for case in &mut self.cases {
            if let Some(asperities) = &mut case.asperities {
                asperities.boundary_friction_coefficient = Some(friction.max(LEAST_FRICTION));
            }
        }
    }

    /// Solves the points at each node, ln σ and perhaps ln σβη. A node at which a point fails has the reason.
    pub(super) fn solve(
        &self,
        nodes: &[Vec<f64>],
        observer: &dyn FitObserver,
    ) -> Result<Vec<Result<Solved, String>>, StribeckError> {
        let n = self.cases.len();
        let solve = |task: usize| {
            let case = with_constants(&self.cases[task % n], &nodes[task / n]);
            match run::solve(&case, &mut Stop(observer)) {
                Ok(solution) => parts(&case, &solution)
                    .map(Ok)
                    .ok_or(StribeckError::NoSliding),
                Err(SolveError::Interrupted) => Err(StribeckError::Interrupted),
                Err(error) => Ok(Err(error.to_string())),
            }
        };
        let solved = side_by_side(nodes.len() * n, &solve)?;
        let of_node = |points: &[Result<[f64; 3], String>]| {
            let mut all = Solved {
                parts: Vec::new(),
                bar: 0.0,
            };
            for point in points {
                let [film, asperities, bar] = point.clone()?;
                all.parts.extend([film, asperities]);
                all.bar = all.bar.max(bar);
            }
            Ok(all)
        };
        Ok(solved.chunks(n).map(of_node).collect())
    }
}

/// Results of tasks, in their order, by a thread for each core; the first error ends all of them.
fn side_by_side<T: Send, E: Send>(
    n_tasks: usize,
    task: &(dyn Fn(usize) -> Result<T, E> + Sync),
) -> Result<Vec<T>, E> {
    let next = AtomicUsize::new(0);
    let work = || {
        let mut found = Vec::new();
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            if index >= n_tasks {
                return Ok(found);
            }
            match task(index) {
                Ok(value) => found.push((index, value)),
                Err(error) => {
                    next.store(n_tasks, Ordering::Relaxed);
                    return Err(error);
                }
            }
        }
    };
    let workers = std::thread::available_parallelism().map_or(1, usize::from);
    let ended: Vec<Result<Vec<(usize, T)>, E>> = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..workers).map(|_| scope.spawn(work)).collect();
        let joined = threads.into_iter().map(|thread| thread.join());
        joined
            .map(|ended| ended.unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
            .collect()
    });
    let mut all = Vec::new();
    for found in ended {
        all.extend(found?);
    }
    all.sort_by_key(|(index, _)| *index);
    Ok(all.into_iter().map(|(_, value)| value).collect())
}

/// A case with a composite rms height, m, and perhaps σβη by their logarithms.
fn with_constants(case: &Case, logarithms: &[f64]) -> Case {
    let mut own = case.clone();
    own.roughness = logarithms.first().map(|ln| ln.exp());
    let group = logarithms.get(1).map(|ln| ln.exp());
    if let Some(asperities) = &mut own.asperities
        && let AsperityLaw::GreenwoodTripp(summits) | AsperityLaw::GreenwoodWilliamson(summits) =
            &mut asperities.law
        && let Some(group) = group
    {
        summits.asperity_group = group;
    }
    own
}

/// Friction of the film, of the asperities over f_b, with the sign that makes the sum positive, and the error bar of the sum; `None` without sliding.
fn parts(case: &Case, solution: &Solution) -> Option<[f64; 3]> {
    let coefficient = case.asperities.as_ref()?.boundary_friction_coefficient?;
    let friction = solution.mixed.as_ref()?.friction()?;
    let sign = friction.friction_total.value.signum();
    Some([
        sign * friction.friction_fluid.value,
        sign * friction.friction_asperities.value / coefficient,
        friction.friction_total.error.unwrap_or(0.0),
    ])
}

/// Passes on that the user stops the fit.
struct Stop<'a>(&'a dyn FitObserver);

impl Observer for Stop<'_> {
    fn cancelled(&self) -> bool {
        self.0.cancelled()
    }
}
