//! A case in time, by finite volumes.

mod amplitude;
mod fields;

use std::sync::Arc;

pub use self::fields::InstantFields;

use ertel_fem::platform::Instant as Clock;
use serde::{Deserialize, Serialize};

use super::checkpoint::{Checkpoint, Collected};

use crate::case::{Case, Reference, Transient, contact_with};
use crate::contact::{Hertz, Motion, Supply};
use crate::engine::Observer;
use crate::params::Method;
use crate::plausible;
use crate::problem::{largest_cell, problem_by_slices, with_reliefs};
use crate::solution::{Estimate, Figure, Measured, OPEN_MASS_BALANCE};
use crate::transient;
use crate::transient::{
    Approach, Conditions, Course, Info, Instant, Mover, Params, Speeds, Start, TransientError,
    TransientObserver, march, resume,
};
use crate::volumes::Plan;
use crate::volumes::engine::LEAST_GRIDS;
use crate::volumes::fields::profile;
use crate::volumes::film::PatchedFilm;
use crate::volumes::patches::widest;
use crate::volumes::roller_zone::with_rows_by_film;
use crate::warning::{Warning, WarningKind, silence};
use crate::words::{digits, length, pressure};

/// Follows a case through time.
pub trait InstantObserver: Observer {
    /// An instant is solved.
    fn instant(&mut self, _reached: &Reached) {}

    /// Whether a checkpoint is wanted after this step.
    fn wants_checkpoint(&self) -> bool {
        false
    }

    /// It is told where it was wanted, and where the user stops the run.
    fn checkpoint(&mut self, _checkpoint: Checkpoint) {}
}

impl InstantObserver for crate::solve::NoObserver {}

/// How far time has come.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reached {
    /// Time, s.
    pub time: f64,
    /// Where it ends, s.
    pub duration: f64,
    /// Steps so far.
    pub steps: usize,
    /// Estimate of the wall time left, s.
    pub seconds_left: f64,
    /// Central film thickness, m.
    pub film_central: f64,
}

/// A contact at an instant, SI.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct InstantSolution {
    /// Time, s.
    pub time: f64,
    /// Speeds of body 1 and body 2 along the motion, m/s.
    pub speeds: [f64; 2],
    /// Angular velocities of both about the contact normal, rad/s.
    pub spin: [f64; 2],
    /// Load, N, of line contacts N/m.
    pub load: f64,
    /// Radius along the motion, m.
    pub radius: f64,
    /// Temperature of bodies and oil, K.
    pub temperature: f64,
    /// Thickness of the layer of oil at the edge of the contact area, m; none where the contact is flooded.
    pub oil_layer: Option<f64>,
    /// By how much the bodies have come nearer since t = 0, m.
    pub approach: f64,
    /// Its rate, m/s; negative where they part.
    pub approach_velocity: f64,
    /// Force of the film, N, of line contacts N/m.
    pub film_force: f64,
    /// Figures with error bars: what the grids may err by at this instant, and the tolerance of the steps.
    pub measured: Measured,
    /// Length of the step that led here, s; 0 at the start.
    pub step: f64,
    /// Newton iterations of that step on all grids.
    pub newton_iterations: usize,
    /// Mass that the film gained or lost, over what passes the centre at the largest entrainment speed.
    pub mass_error: f64,
}

/// The centreline at an instant, SI.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct InstantProfile {
    /// Time, s.
    pub time: f64,
    /// Places along the motion, m.
    pub x: Vec<f64>,
    /// Pressure there, Pa.
    pub pressure: Vec<f64>,
    /// Film thickness there, m.
    pub film: Vec<f64>,
}

/// Film and pressure on the centreline about the contact over all instants.
#[derive(Clone, Debug, Default, Deserialize, Serialize)]
pub struct FilmMap {
    /// Places along the motion, m.
    pub x: Vec<f64>,
    /// Film thickness there, m, for each instant.
    pub films: Vec<Vec<f32>>,
    /// Pressure there, Pa, for each instant.
    pub pressures: Vec<Vec<f32>>,
}

/// What became of a case in time.
#[derive(Debug)]
pub struct TransientSolution {
    /// Instants from the start on.
    pub instants: Vec<InstantSolution>,
    /// Centrelines at the output times.
    pub profiles: Vec<InstantProfile>,
    /// Pressure and film on and off the centreline at the same times.
    pub fields: InstantFields,
    /// Film and pressure over place and time.
    pub map: FilmMap,
    /// A_d/A_i at each instant, what the film in the centre keeps of the amplitude of waves while one of them passes: as long as no whole wave has passed, none; empty where no waves pass
    /// or where other reliefs are there.
    pub amplitude_ratios: Vec<Option<f64>>,
    /// Half-width of the dry contact under the largest load, m.
    pub half_width: f64,
    /// How it went.
    pub info: Info,
    /// Why it ended before its time, if it did.
    pub failure: Option<TransientError>,
    /// What the user should know.
    pub warnings: Vec<Warning>,
    /// Wall time, s.
    pub wall_seconds: f64,
}

/// Half-widths about the centre of the map of films, and places in it at most.
const MAP: f64 = 1.5;
const MAP_PLACES: usize = 480;

/// Mass error from which a warning is given.
const MASS_ERROR: f64 = 1e-2;

impl TransientSolution {
    /// Whether the film bears another force than the load at some instant: a body moves by its inertia, or its approach is given.
    pub fn moves(&self) -> bool {
        let differs = |i: &InstantSolution| (i.film_force - i.load).abs() > 1e-2 * i.load;
        self.instants.iter().any(differs)
    }

    /// Coefficient of restitution of a body that fell on the film and has left it: the velocity at which it goes over that at which it came. The force of the film is
    /// known as well as the pressure in its middle: the bar adds up the share of each change of the velocity that this pressure errs by.
    pub fn restitution(&self) -> Option<Estimate> {
        let (first, last) = (self.instants.first()?, self.instants.last()?);
        let largest = self
            .instants
            .iter()
            .fold(0.0_f64, |m, i| m.max(i.film_force));
        let has_left = last.film_force < NO_FORCE * largest && last.approach_velocity < 0.0;
        let fell = first.film_force == 0.0 && first.approach_velocity > 0.0;
        let unknown = |pair: &[InstantSolution]| {
            let change = (pair[1].approach_velocity - pair[0].approach_velocity).abs();
            let pressure = pair[1].measured.estimate(Figure::PressureCentral);
            let share = match pressure.error {
                Some(error) if error < pressure.value => error / pressure.value,
                _ => 1.0,
            };
            change * share
        };
        let error: f64 = self.instants.windows(2).map(unknown).sum();
        (fell && has_left).then(|| Estimate {
            value: -last.approach_velocity / first.approach_velocity,
            error: Some(error / first.approach_velocity),
        })
    }
}

/// Share of the largest force of an impact below which a body has left the film.
const NO_FORCE: f64 = 1e-4;

/// Half-widths from the centre to the edges, times the root of the gap over a²/R, where bodies are apart at the start: rigid parabolas lose 1/200 of their force beyond.
const REACH_APART: f64 = 20.0;

/// Solves a case with `[transient]` from its start on.
///
/// # Panics
/// For a case without.
pub fn solve(case: &Case, observer: &mut dyn InstantObserver) -> TransientSolution {
    solve_from(case, None, observer)
}

/// The same from where another run of it stopped, with the instants before.
///
/// # Panics
/// For a case without `[transient]`.
pub fn solve_from(
    case: &Case,
    from: Option<Checkpoint>,
    observer: &mut dyn InstantObserver,
) -> TransientSolution {
    let transient = case.transient.clone().expect("the case has [transient]");
    // On a thread of the pool, as steady contacts.
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
    // What is alike on both sides of the motion is so at all times.
    let largest = |course: &Course| course.largest(transient.duration);
    reference.motion = Motion {
        slide_to_roll_ratio_across: largest(&transient.slide_to_roll_ratio_across),
        spin: transient.spin.each_ref().map(largest),
        ..Motion::straight(speed, case.motion.slide_to_roll_ratio)
    };
    reference.solver.method = Some(Method::FiniteVolumes);
    let mut problem = problem_by_slices(&reference).with_plan(plan(&reference));
    let (length, film) = (problem.scales.length, problem.scales.film);
    let unit = length / speed;
    let conditions = conditions(transient, by, film, unit);
    if let Start::Apart { gap, .. } = conditions.start {
        // Oil leaves to all sides, from where the case does not say otherwise.
        problem.start_film = gap.max(problem.start_film.min(1.0));
        let reach = REACH_APART * gap.max(1.0).sqrt();
        let extents = &mut problem.extents;
        extents.inlet = case.mesh.inlet.unwrap_or(-reach);
        extents.outlet = case.mesh.outlet.unwrap_or(reach);
        if case.mesh.side.is_none() {
            extents.side = reach;
        }
    } else if conditions.turns() {
        // What was the outlet becomes the inlet.
        problem.extents.outlet = problem.extents.outlet.max(-problem.extents.inlet);
    }
    // Far pressures of steady parabolas count for nothing here: the contact area ends with the grid.
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
    let on_its_way = on_its_way(transient, -problem.extents.inlet * length);
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
            found.info = error.info().unwrap_or_else(|| told(&found.instants));
            found.failure = Some(error);
        }
    }
    found.warnings.extend(on_its_way);
    found.amplitude_ratios = amplitude::amplitude_ratios(case, &found.instants);
    found.warnings.extend(warnings(&found));
    found.warnings.extend(too_hard(case, &found));
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

/// What the instants tell of the steps of a run that was interrupted; those that were refused are not among them.
fn told(instants: &[InstantSolution]) -> Info {
    let steps = instants.iter().filter(|instant| instant.step > 0.0);
    let iterations = steps.clone().map(|instant| instant.newton_iterations);
    Info {
        steps: steps.clone().count(),
        refused: 0,
        newton_iterations: iterations.sum(),
    }
}

/// How finite volumes go about a case in time: films of each instant need no finer grids than those of a steady contact, and nothing is read off the spike of a line.
fn plan(case: &Case) -> Plan {
    Plan {
        least_grids: [LEAST_GRIDS, LEAST_GRIDS + 1],
        ..super::volumes::plan(case)
    }
}

/// What changes, over the scales of the contact; the film thickness in m, and seconds in T.
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

/// Collects what the results tell.
struct Collector<'a> {
    case: &'a Case,
    /// Time at which this run began, s.
    begun: f64,
    observer: &'a mut dyn InstantObserver,
    clock: Clock,
    /// Length, film and pressure.
    scales: [f64; 3],
    /// Seconds in T.
    unit: f64,
    speed: f64,
    load: f64,
    transient: &'a Transient,
    steady: Steady,
    n_outputs: usize,
    found: TransientSolution,
}

/// Conditions that may stay as they are: m, K, m.
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
        // The grids stay where they are, and so do the places.
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
            measured: instant.measured,
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

/// Tells how far (m) a layer of oil that changes is carried to the contact.
fn on_its_way(transient: &Transient, distance: f64) -> Option<Warning> {
    let changes = transient.oil_layer.is_some();
    let [first, second] = transient.speeds.at(0.0);
    let seconds = distance / (0.5 * (first + second));
    let text = format!(
        "`oil_layer` is that at the inlet edge, {} before the centre: at the speed of the start it takes {} s to there",
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

/// Hertz pressure beyond which no law of a film holds, Pa.
const HARDEST: f64 = 5e9;

/// Tells of a film force that a dry contact bears only with a pressure beyond all laws: of an impact, or of an approach that is given, it is known at the end alone.
fn too_hard(case: &Case, found: &TransientSolution) -> Option<Warning> {
    let mut contact = case.contact.clone();
    contact.load = (found.instants.iter()).fold(0.0, |m, instant| instant.film_force.max(m));
    let hertz = Hertz::new(&contact, case.reduced_modulus());
    (found.moves() && hertz.pressure > HARDEST).then(|| {
        Warning::new(WarningKind::PressureRange, format!(
            "the film force comes to a Hertz pressure of {}, beyond 5 GPa: laws of the lubricant do not hold there",
            pressure(hertz.pressure)
        ))
    })
}

/// What the user should know of the instants.
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
    // A first instant is that of the steady contact.
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
