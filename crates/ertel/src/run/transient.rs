//! A transient case, by finite volumes.

mod amplitude;
mod fields;
mod found;

use std::sync::Arc;

pub use self::fields::InstantFields;
pub use self::found::{FilmMap, InstantProfile, InstantSolution, TransientSolution};

use ertel_fem::platform::Instant as Clock;

use super::checkpoint::{Checkpoint, Collected};

use crate::case::{Case, Reference, Transient, contact_with};
use crate::contact::{Hertz, Motion, Supply};
use crate::engine::Observer;
use crate::params::Method;
use crate::plausible;
use crate::post;
use crate::problem::{largest_cell, problem, with_reliefs};
use crate::solution::{Figure, Measured, OPEN_MASS_BALANCE};
use crate::transient;
use crate::transient::{
    Approach, Conditions, Course, Info, Instant, Mover, Params, Speeds, Start, TransientError,
    TransientObserver, march, resume,
};
use crate::volumes::Plan;
use crate::volumes::fields::{profile, surface};
use crate::volumes::film::PatchedFilm;
use crate::volumes::patches::widest;
use crate::volumes::plan::LEAST_GRIDS;
use crate::volumes::roller_zone::with_rows_by_film;
use crate::warning::{Warning, WarningKind, silence};
use crate::words::{digits, length, pressure};

/// Observes a transient case.
pub trait InstantObserver: Observer {
    /// Called after each solved instant.
    fn instant(&mut self, _reached: &Reached) {}

    /// Whether a checkpoint is wanted after this step.
    fn wants_checkpoint(&self) -> bool {
        false
    }

    /// Called if a checkpoint is wanted, and if the user stops the run.
    fn checkpoint(&mut self, _checkpoint: Checkpoint) {}
}

impl InstantObserver for crate::engine::NoObserver {}

/// Progress of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reached {
    /// Time, s.
    pub time: f64,
    /// Duration, s.
    pub duration: f64,
    /// Number of steps so far.
    pub steps: usize,
    /// Estimate of the remaining wall time, s.
    pub seconds_left: f64,
    /// Central film thickness, m.
    pub film_central: f64,
}

/// Extent of the film map about the centre, in half-widths, and its maximum number of positions.
const MAP: f64 = 1.5;
const MAP_PLACES: usize = 480;

/// Mass error above which a warning is given.
const MASS_ERROR: f64 = 1e-2;

/// Half-widths from the centre to the edges, times the root of the gap over a²/R, for initially separated bodies: rigid parabolas lose 1/200 of their force beyond.
const REACH_APART: f64 = 20.0;

/// Solves a case with `[transient]` from its start.
///
/// # Panics
/// For a case without `[transient]`.
pub fn solve(case: &Case, observer: &mut dyn InstantObserver) -> TransientSolution {
    solve_from(case, None, observer)
}

/// Resumes an interrupted run, with its previous instants.
///
/// # Panics
/// For a case without `[transient]`.
pub fn solve_from(
    case: &Case,
    from: Option<Checkpoint>,
    observer: &mut dyn InstantObserver,
) -> TransientSolution {
    let transient = case.transient.clone().expect("the case has [transient]");
    // On a thread of the pool, as for steady contacts.
    rayon::scope(|_| solve_here(case, &transient, from, observer))
}

fn solve_here(
    case: &Case,
    transient: &Arc<Transient>,
    from: Option<Checkpoint>,
    observer: &mut dyn InstantObserver,
) -> TransientSolution {
    let clock = Clock::now();
    let by = transient.reference(case);
    let Reference { speed, load, .. } = by;
    let mut reference = case.clone();
    reference.contact = contact_with(case, load, by.radius);
    // A case symmetric across the motion is so at all times.
    let largest = |course: &Course| course.largest(transient.duration);
    reference.motion = Motion {
        slide_to_roll_ratio_across: largest(&transient.slide_to_roll_ratio_across),
        spin: transient.spin.each_ref().map(largest),
        ..Motion::straight(speed, case.motion.slide_to_roll_ratio)
    };
    reference.solver.method = Some(Method::FiniteVolumes);
    let mut problem = problem(&reference).with_plan(plan(&reference));
    let (length, film) = (problem.scales.length, problem.scales.film);
    let unit = length / speed;
    let conditions = conditions(transient, by, film, unit);
    if let Start::Apart { gap, .. } = conditions.start {
        // Oil flows out on all sides, unless the case states otherwise.
        problem.start_film = gap.max(problem.start_film.min(1.0));
        let reach = REACH_APART * gap.max(1.0).sqrt();
        let extents = &mut problem.extents;
        extents.inlet = case.mesh.inlet.unwrap_or(-reach);
        extents.outlet = case.mesh.outlet.unwrap_or(reach);
        if case.mesh.side.is_none() {
            extents.side = reach;
        }
    } else if conditions.turns() {
        // The outlet may become the inlet.
        problem.extents.outlet = problem.extents.outlet.max(-problem.extents.inlet);
    }
    // Far pressures of steady parabolas do not apply: the contact area ends with the grid.
    let widest = widest(&problem);
    let (mesh, extents) = (&case.mesh, &mut problem.extents);
    if mesh.inlet.is_none() {
        extents.inlet = extents.inlet.max(-widest);
    }
    if mesh.outlet.is_none() {
        extents.outlet = extents.outlet.min(widest);
    }
    if mesh.side.is_none() {
        extents.side = extents.side.min(widest);
    }
    let oil_layer_delay = oil_layer_delay(transient, -problem.extents.inlet * length);
    problem.shape = with_reliefs(problem.shape, &case.reliefs, &mut problem.scales);
    problem.load = problem.scales.load;
    problem.plan.largest_cell = largest_cell(&problem.shape);
    let (from, before) = match from {
        Some(from) => (Some(from.physics), (from.collected, from.wall_seconds)),
        None => (None, (Collected::default(), 0.0)),
    };
    let (collected, wall_seconds) = before;
    let mut collector = Collector {
        case,
        observer,
        clock,
        begun: from.as_ref().map_or(0.0, |from| from.time * unit),
        scales: [length, film, problem.scales.pressure],
        unit,
        speed,
        load,
        hertz: Hertz::new(&reference.contact.along_motion(), case.reduced_modulus()),
        transient,
        n_outputs: transient.output_times.len(),
        steady: Steady {
            radius: case.contact.along_motion().radius,
            temperature: case.lubricant.temperature,
            oil_layer: match case.supply {
                Supply::OilLayer { thickness } => Some(thickness),
                Supply::Flooded | Supply::Meniscus { .. } => None,
            },
        },
        found: TransientSolution {
            instants: collected.instants,
            profiles: collected.profiles,
            fields: collected.fields,
            map: collected.map,
            amplitude_ratios: Vec::new(),
            half_width: length,
            info: Info::default(),
            failure: None,
            warnings: case.warnings.clone(),
            wall_seconds,
        },
    };
    let params = Params {
        tolerance: transient.tolerance,
        ..Params::default()
    };
    let end = with_rows_by_film(problem, collector.observer)
        .map_err(TransientError::from)
        .and_then(|problem| match &from {
            None => march(problem, &conditions, &params, &mut collector),
            Some(from) => resume(problem, &conditions, &params, from, &mut collector),
        });
    let mut found = collector.found;
    match end {
        Ok(info) => found.info = info,
        Err(error) => {
            found.info = error.info().unwrap_or_else(|| statistics(&found.instants));
            found.failure = Some(error);
        }
    }
    found.warnings.extend(oil_layer_delay);
    found.amplitude_ratios = amplitude::amplitude_ratios(case, &found.instants);
    found.warnings.extend(warnings(&found));
    found.warnings.extend(excessive_pressure(case, &found));
    let largest = |figure| {
        let values = found
            .instants
            .iter()
            .map(|instant| instant.measured.estimate(figure).value);
        values
            .filter(|value| value.is_finite())
            .fold(0.0, |m: f64, value| match value.abs() > m.abs() {
                true => value,
                false => m,
            })
    };
    let [friction, film] = [Figure::TractionCoefficient, Figure::FilmCentral].map(largest);
    found
        .warnings
        .extend(plausible::in_time(case, friction, film));
    silence(&mut found.warnings, &case.output.silence);
    found.wall_seconds += clock.elapsed().as_secs_f64();
    found
}

/// Step statistics of an interrupted run, from its instants; refused steps are not counted.
fn statistics(instants: &[InstantSolution]) -> Info {
    let steps = instants.iter().filter(|instant| instant.step > 0.0);
    let iterations = steps.clone().map(|instant| instant.newton_iterations);
    Info {
        steps: steps.clone().count(),
        refused: 0,
        newton_iterations: iterations.sum(),
    }
}

/// Grid plan of a transient case: the films of each instant need no finer grids than those of a steady contact, and the pressure spike of a line is not evaluated.
fn plan(case: &Case) -> Plan {
    Plan {
        least_grids: [LEAST_GRIDS, LEAST_GRIDS + 1],
        ..super::volumes::plan(case)
    }
}

/// Time-dependent conditions in the scales of the contact; film thickness in m, and seconds per unit time.
fn conditions(transient: &Transient, by: Reference, film: f64, unit: f64) -> Conditions {
    let Reference {
        speed,
        load,
        radius,
    } = by;
    let over = |course: &Course, value: f64| course.scaled(1.0 / unit, 1.0 / value);
    Conditions {
        speeds: match &transient.speeds {
            Speeds::Mean {
                entrainment,
                slide_to_roll_ratio,
            } => Speeds::Mean {
                entrainment: over(entrainment, speed),
                slide_to_roll_ratio: over(slide_to_roll_ratio, 1.0),
            },
            Speeds::Each(speeds) => Speeds::Each(speeds.each_ref().map(|u| over(u, speed))),
        },
        slide_to_roll_ratio_across: over(&transient.slide_to_roll_ratio_across, 1.0),
        spin: (transient.spin.each_ref()).map(|spin| over(spin, 1.0 / unit)),
        load: over(&transient.load, load),
        radius: (transient.radius.as_ref()).map_or(Course::Constant(1.0), |own| over(own, radius)),
        temperature: (transient.temperature.as_ref()).map(|own| over(own, 1.0)),
        layer: (transient.oil_layer.as_ref()).map(|own| over(own, film)),
        cavities: transient.cavities,
        approach: match &transient.approach {
            Approach::Massless => Approach::Massless,
            Approach::Given(course) => Approach::Given(over(course, film)),
            Approach::Body(body) => Approach::Body(Mover {
                mass: body.mass * film / (unit * unit) / load,
                damping: body.damping * film / unit / load,
                stiffness: body.stiffness * film / load,
            }),
        },
        start: match transient.start {
            Start::Steady => Start::Steady,
            Start::Apart { gap, velocity } => Start::Apart {
                gap: gap / film,
                velocity: velocity * unit / film,
            },
        },
        duration: transient.duration / unit,
        instants: transient.output_times.iter().map(|t| t / unit).collect(),
    }
}

/// Collects the results.
struct Collector<'a> {
    case: &'a Case,
    /// Start time of this run, s.
    begun: f64,
    observer: &'a mut dyn InstantObserver,
    clock: Clock,
    /// Scales of length, film and pressure.
    scales: [f64; 3],
    /// Seconds per unit time.
    unit: f64,
    speed: f64,
    load: f64,
    /// The dry contact of reference.
    hertz: Hertz,
    transient: &'a Transient,
    steady: Steady,
    n_outputs: usize,
    found: TransientSolution,
}

/// Force of the film over that of reference from which bodies have stresses.
const PRESSED: f64 = 1e-3;

impl Collector<'_> {
    /// The figures of an instant, with those of the bodies at output times.
    fn measured(&self, instant: &Instant<'_>, film: &PatchedFilm<'_>) -> Measured {
        let mut measured = instant.measured;
        let Some(params) = &self.case.stress else {
            return measured;
        };
        if !instant.is_asked || instant.film_force < PRESSED {
            return measured;
        }
        let (surface, _) = surface(instant.problem, film);
        let contact = (
            &instant.problem.shape,
            &self.hertz,
            instant.film_force * self.load,
        );
        let error = super::pressure_error(&measured);
        let stresses =
            post::stresses::stresses(params, contact, (&surface, error), &self.case.coated());
        post::stresses::note(&mut measured, &stresses);
        measured
    }
}

/// Values of conditions that do not vary: m, K, m.
struct Steady {
    radius: f64,
    temperature: f64,
    oil_layer: Option<f64>,
}

impl TransientObserver for Collector<'_> {
    fn instant(&mut self, instant: &Instant<'_>) {
        let [length, film, pressure] = self.scales;
        let time = instant.time * self.unit;
        let patched = PatchedFilm::new(&instant.problem.shape, instant.levels);
        let profile = profile(&patched);
        let map = &mut self.found.map;
        if map.x.is_empty() {
            let about: Vec<f64> = (profile.x.iter().copied())
                .filter(|x| x.abs() <= MAP)
                .collect();
            let stride = about.len().div_ceil(MAP_PLACES).max(1);
            map.x = about
                .into_iter()
                .step_by(stride)
                .map(|x| x * length)
                .collect();
        }
        let films: Vec<f64> = profile.fields.iter().map(|f| f.film * film).collect();
        let x: Vec<f64> = profile.x.iter().map(|x| x * length).collect();
        // The grids are fixed, and so are the positions.
        let mut own = x.iter().zip(profile.fields.iter().zip(&films));
        let row = map.x.iter().map(|place| {
            own.find(|(x, _)| *x >= place)
                .map_or([f32::NAN; 2], |(_, (at, film))| {
                    [*film, at.pressure * pressure].map(|v| v as f32)
                })
        });
        let (films_there, pressures) = row.map(|[film, pressure]| (film, pressure)).unzip();
        map.films.push(films_there);
        map.pressures.push(pressures);
        if instant.is_asked {
            self.found.fields.push(
                time,
                &patched,
                &profile,
                &instant.problem.shape,
                self.scales,
                self.n_outputs,
            );
            self.found.profiles.push(InstantProfile {
                time,
                pressure: profile
                    .fields
                    .iter()
                    .map(|f| f.pressure * pressure)
                    .collect(),
                film: films,
                x,
            });
        }
        let central = instant.measured.estimate(Figure::FilmCentral).value;
        self.found.instants.push(InstantSolution {
            time,
            speeds: instant.speeds.map(|u| u * self.speed),
            spin: (self.transient.spin.each_ref()).map(|spin| spin.at(time)),
            load: instant.load * self.load,
            radius: (self.transient.radius.as_ref()).map_or(self.steady.radius, |own| own.at(time)),
            temperature: (self.transient.temperature.as_ref())
                .map_or(self.steady.temperature, |own| own.at(time)),
            oil_layer: match &self.transient.oil_layer {
                Some(own) => Some(own.at(time)),
                None => self.steady.oil_layer,
            },
            approach: instant.approach * film,
            approach_velocity: instant.approach_velocity * film / self.unit,
            film_force: instant.film_force * self.load,
            measured: self.measured(instant, &patched),
            step: instant.step * self.unit,
            newton_iterations: instant.newton_iterations,
            mass_error: instant.mass_error,
        });
        let elapsed = self.clock.elapsed().as_secs_f64();
        let share = (time - self.begun) / (self.transient.duration - self.begun);
        self.observer.instant(&Reached {
            time,
            duration: self.transient.duration,
            steps: self.found.instants.len() - 1,
            seconds_left: elapsed * (1.0 - share).max(0.0) / share,
            film_central: central,
        });
    }

    fn start(&mut self) -> &mut dyn Observer {
        self.observer
    }

    fn cancelled(&self) -> bool {
        self.observer.cancelled()
    }

    fn wants_checkpoint(&self) -> bool {
        self.observer.wants_checkpoint()
    }

    fn checkpoint(&mut self, checkpoint: transient::Checkpoint) {
        let seconds = self.found.wall_seconds + self.clock.elapsed().as_secs_f64();
        let checkpoint = Checkpoint::new(self.case, checkpoint, &self.found, seconds);
        self.observer.checkpoint(checkpoint);
    }
}

/// Warns about the delay of a varying oil layer, carried over the distance (m) to the contact.
fn oil_layer_delay(transient: &Transient, distance: f64) -> Option<Warning> {
    let changes = transient.oil_layer.is_some();
    let [first, second] = transient.speeds.at(0.0);
    let seconds = distance / (0.5 * (first + second));
    let text = format!(
        "`oil_layer` applies at the inlet edge, {} upstream of the centre: at the initial speed, the oil takes {} s to reach the centre",
        length(distance),
        digits(seconds, 3)
    );
    changes.then(|| match seconds < transient.duration {
        true => Warning::new(WarningKind::OnItsWay, text),
        false => Warning::new(
            WarningKind::OilLayerLate,
            format!("{text}, longer than the duration"),
        ),
    })
}

/// Hertz pressure above which no film law is valid, Pa.
const MAX_HERTZ_PRESSURE: f64 = 5e9;

/// Warns if the Hertz pressure of the film force exceeds all laws: for impacts and prescribed approaches, the force is known only at the end.
fn excessive_pressure(case: &Case, found: &TransientSolution) -> Option<Warning> {
    let mut contact = case.contact.clone();
    contact.load = (found.instants.iter()).fold(0.0, |m, instant| instant.film_force.max(m));
    let hertz = Hertz::new(&contact, case.reduced_modulus());
    (found.moves() && hertz.pressure > MAX_HERTZ_PRESSURE).then(|| {
        Warning::new(WarningKind::PressureRange, format!(
            "the film force corresponds to a Hertz pressure of {}, above 5 GPa: the lubricant laws are not valid there",
            pressure(hertz.pressure)
        ))
    })
}

/// Warnings from the instants.
fn warnings(found: &TransientSolution) -> Vec<Warning> {
    let mut warnings = Vec::new();
    let instants = &found.instants;
    for (kind, name, figure) in [
        (
            WarningKind::CentralFilmError,
            "central",
            Figure::FilmCentral,
        ),
        (
            WarningKind::MinimumFilmError,
            "minimum",
            Figure::FilmMinimum,
        ),
    ] {
        let unresolved = instants
            .iter()
            .filter(|instant| !instant.measured.is_resolved(figure));
        let n = unresolved.count();
        if n > 0 {
            let text = format!(
                "the {name} film thickness is not resolved at {n} of {} instants: see the column `unresolved`; raise [mesh] max_unknowns",
                instants.len()
            );
            warnings.push(Warning::new(kind, text));
        }
    }
    let worst = instants
        .iter()
        .map(|instant| instant.mass_error.abs())
        .fold(0.0, f64::max);
    // The first instant is that of the steady contact.
    if worst > MASS_ERROR {
        warnings.push(Warning::new(WarningKind::MassBalance, format!(
            "the film gains or loses up to {} % of what passes the centre in a step: see the column `mass_error`{}",
            digits(100.0 * worst, 2),
            match worst > OPEN_MASS_BALANCE {
                true => ", and no figure of these instants is resolved; move the edges of [mesh] further out",
                false => "",
            }
        )));
    }
    warnings
}
