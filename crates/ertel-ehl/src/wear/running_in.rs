//! Contact and wear in turn: solve the contact, wear the bodies by a step, solve it again from the last solution, until the sliding distance.
//!
//! Steps are explicit; each is limited by the largest depth. The run is repeated with steps of twice the depth: the change of a figure by that is the error bar of the steps, whose
//! errors are of the first order.

use super::depth::{Depth, Lattice, Pressures};
use super::params::{WearParams, WearingBody};
use crate::contact::gap::Body;
use crate::engine::{Observer, Problem, SolveError};
use crate::solution::{BodyWear, Estimate, Figure, Measured, Wear, WearStep};
use crate::volumes::film::PatchedFilm;
use crate::volumes::{FiniteVolumes, Plan, Volumes};

/// Multiple of the depth of the steps of the run that gives the error bar.
const COARSER: f64 = 2.0;

/// Share of the margin of the finest grid around the dry contact that a scar may reach into, and by how much wider than the scar the grids then are.
const INTO_MARGIN: f64 = 0.5;
const WIDER: f64 = 1.2;

/// A worn contact.
pub struct Worn {
    /// The contact at the end.
    pub solved: Volumes,
    /// Its figures with error bars of grids and steps.
    pub measured: Measured,
    /// Worn bodies, and the contact over the distance.
    pub wear: Wear,
}

/// Wears a contact. Its gap has the worn shape, and its grids cover the scar, afterwards.
///
/// # Errors
/// When the contact does not converge, steps run out, or the observer cancels.
pub fn run_in(
    problem: &mut Problem<Plan>,
    params: &WearParams,
    observer: &mut dyn Observer,
) -> Result<Worn, SolveError> {
    let first = FiniteVolumes.solve(problem, observer)?;
    let (plan, n_terms) = (problem.plan, problem.shape.gap.terms.len());
    // The same grids at all distances: figures change by wear alone.
    problem.plan.most_grids = first.levels.len();
    problem.plan.target_error = 0.0;
    let mut run = |problem: &mut Problem<Plan>, step: f64| {
        problem.shape.gap.terms.truncate(n_terms);
        problem.plan.inner = plan.inner;
        let params = WearParams {
            step,
            ..params.clone()
        };
        let mut run = Run::new(problem, &first, &params);
        run.go(problem, n_terms, observer)?;
        Ok::<_, SolveError>((run.course, run.depths, run.volumes, run.latest))
    };
    let coarse = run(problem, COARSER * params.step)?;
    let (course, depths, volumes, latest) = run(problem, params.step)?;
    problem.plan = Plan {
        inner: problem.plan.inner,
        ..plan
    };
    let solved = latest.unwrap_or(first);
    let mut measured = solved.measured(problem);
    if let Some(coarser) = &coarse.3 {
        measured.widen_by_changes(&coarser.measured(problem));
    }
    let [length, film] = [problem.scales.length, problem.scales.film];
    // Wear is as uncertain as the load that causes it.
    let share = measured.find(Figure::AsperityLoadShare);
    let of_grids = share.map_or(0.0, |share| share.error.unwrap_or(0.0) / share.value);
    let body = |i: usize| {
        let (own, depth, other) = (
            params.bodies[i]?,
            depths[i].as_ref()?,
            coarse.1[i].as_ref()?,
        );
        let of = |value: f64, other: f64, scale: f64| Estimate {
            value: scale * value,
            error: Some(scale * ((other - value).abs() + of_grids * value)),
        };
        let area = match problem.shape.is_line() {
            true => length,
            false => length * length,
        };
        // A track around a line contact has the volume per length of the line.
        let [scar_length, width] = depth.size().map(|size| size.map(|size| length * size));
        Some(BodyWear {
            wear_coefficient: own.coefficient,
            hardness: own.hardness,
            track_length: own.track_length,
            depth: of(depth.largest(), other.largest(), film),
            volume: of(volumes[i], coarse.2[i], area * film),
            volume_deviation: match volumes[i] > 0.0 {
                true => depth.volume() / volumes[i] - 1.0,
                false => 0.0,
            },
            length: scar_length,
            width,
            profiles: [false, true].map(|across| {
                let points = depth.profile(across).into_iter();
                points.map(|[x, d]| [length * x, film * d]).collect()
            }),
        })
    };
    let wear = Wear {
        label: Wear::LABEL,
        sliding_distance: params.distance,
        steps: course.len() - 1,
        body_1: body(0),
        body_2: body(1),
        course,
    };
    Ok(Worn {
        solved,
        measured,
        wear,
    })
}

/// A run over the sliding distance with steps of one size.
struct Run<'a> {
    first: &'a Volumes,
    params: &'a WearParams,
    /// Distance of the points of lattices.
    spacing: [f64; 2],
    depths: [Option<Depth>; 2],
    /// Archard's volume of each body, in half-widths and a²/R.
    volumes: [f64; 2],
    /// Distance so far, m.
    distance: f64,
    course: Vec<WearStep>,
    latest: Option<Volumes>,
}

impl<'a> Run<'a> {
    fn new(problem: &Problem<Plan>, first: &'a Volumes, params: &'a WearParams) -> Run<'a> {
        let spacing = first.levels.last().map_or([1.0; 2], |level| {
            let own = level.system.grid.spacing;
            match level.system.grid.turn.is_none() {
                true => own,
                false => [own[0].min(own[1]); 2],
            }
        });
        let lattice = Lattice {
            spacing,
            half: [0; 2],
        };
        let track = |body: WearingBody| body.track_length.map(|l| l / problem.scales.length);
        Run {
            first,
            params,
            spacing,
            depths: (params.bodies).map(|body| Some(Depth::none(lattice, track(body?)))),
            volumes: [0.0; 2],
            distance: 0.0,
            course: Vec::new(),
            latest: None,
        }
    }

    fn go(
        &mut self,
        problem: &mut Problem<Plan>,
        n_terms: usize,
        observer: &mut dyn Observer,
    ) -> Result<(), SolveError> {
        loop {
            self.note(problem);
            let remaining = self.params.distance - self.distance;
            if remaining <= 0.0 {
                return Ok(());
            }
            let pressures = self.pressures(problem);
            let rates = self.rates(problem, &pressures);
            let largest: f64 = (rates.iter().flatten())
                .map(|(rates, factor)| factor * rates.iter().copied().fold(0.0, f64::max))
                .sum();
            if largest == 0.0 {
                // Nothing changes any more.
                self.distance = self.params.distance;
                continue;
            }
            let rms_height = problem.rough.as_ref().map_or(0.0, |own| own.rms_height);
            let most = self.params.step * rms_height / largest;
            let step = remaining / (remaining / most).ceil();
            let (before, steps) = (self.distance, self.course.len() - 1);
            let stopped = |error: Option<SolveError>| SolveError::Worn {
                distance: before,
                of: self.params.distance,
                steps,
                error: error.map(Box::new),
            };
            if steps >= self.params.max_steps {
                return Err(stopped(None));
            }
            self.distance = match step < remaining {
                true => before + step,
                false => self.params.distance,
            };
            for (i, rates) in rates.iter().enumerate() {
                if let (Some(depth), Some((rates, factor))) = (&mut self.depths[i], rates) {
                    *depth = depth.on(pressures.lattice);
                    depth.add(rates, factor * step);
                    self.volumes[i] += factor * step * pressures.load;
                }
            }
            self.shape(problem, n_terms);
            let found = match FiniteVolumes.solve_from(problem, Some(self.solved()), observer) {
                Err(SolveError::Interrupted) => return Err(SolveError::Interrupted),
                Err(_) => FiniteVolumes.solve(problem, observer),
                found => found,
            };
            self.latest = Some(match found {
                Err(SolveError::Interrupted) => return Err(SolveError::Interrupted),
                Err(error) => return Err(stopped(Some(error))),
                Ok(found) => found,
            });
        }
    }

    /// The contact as it is worn now.
    fn solved(&self) -> &Volumes {
        self.latest.as_ref().unwrap_or(self.first)
    }

    /// Asperity pressures on a lattice that covers them and all wear so far.
    fn pressures(&self, problem: &Problem<Plan>) -> Pressures {
        let film = PatchedFilm::new(&problem.shape, &self.solved().levels);
        let own = Lattice::of(&film, &problem.shape, self.spacing);
        let all = self.depths.iter().flatten();
        let lattice = all.fold(own, |lattice, depth| lattice.with(&depth.lattice));
        Pressures::of(&film, &problem.shape, lattice)
    }

    /// Rates of the depths of both bodies, and their factors in a²/R per m of sliding.
    fn rates(
        &self,
        problem: &Problem<Plan>,
        pressures: &Pressures,
    ) -> [Option<(Vec<f64>, f64)>; 2] {
        let scales = &problem.scales;
        [0, 1].map(|i: usize| {
            let (body, depth) = (self.params.bodies[i]?, self.depths[i].as_ref()?);
            let factor = body.coefficient / body.hardness * scales.pressure / scales.film;
            Some((pressures.rates(depth.track), factor))
        })
    }

    /// Gives the gap the worn shape, and the grids the scar.
    fn shape(&self, problem: &mut Problem<Plan>, n_terms: usize) {
        problem.shape.gap.terms.truncate(n_terms);
        let terms = [Body::First, Body::Second].into_iter().zip(&self.depths);
        let terms = terms.filter_map(|(body, depth)| depth.as_ref()?.term(body, &problem.shape));
        let terms: Vec<_> = terms.collect();
        problem.shape.gap.terms.extend(terms);
        let all = self.depths.iter().flatten();
        let reach = all.fold(0.0, |m: f64, depth| m.max(depth.reach(&problem.shape)));
        let margin = problem.plan.margin * self.spacing[0];
        if reach > problem.plan.inner + INTO_MARGIN * margin {
            problem.plan.inner = WIDER * reach;
        }
    }

    /// Notes the contact at the distance so far.
    fn note(&mut self, problem: &Problem<Plan>) {
        let measured = self.solved().measured(problem);
        let value = |figure| measured.find(figure).map(|found| found.value);
        let [length, film] = [problem.scales.length, problem.scales.film];
        let area = match problem.shape.is_line() {
            true => length,
            false => length * length,
        };
        let worn = |i: usize| {
            let depth = self.depths[i].as_ref()?;
            Some([film * depth.largest(), area * film * self.volumes[i]])
        };
        self.course.push(WearStep {
            sliding_distance: self.distance,
            asperity_load_share: value(Figure::AsperityLoadShare).unwrap_or(0.0),
            film_central: measured.estimate(Figure::FilmCentral).value,
            film_minimum: measured.estimate(Figure::FilmMinimum).value,
            pressure_maximum: measured.estimate(Figure::PressureMaximum).value,
            friction_total: value(Figure::FrictionTotal),
            body_1_depth: worn(0).map(|[depth, _]| depth),
            body_2_depth: worn(1).map(|[depth, _]| depth),
            body_1_volume: worn(0).map(|[_, volume]| volume),
            body_2_volume: worn(1).map(|[_, volume]| volume),
        });
    }
}
