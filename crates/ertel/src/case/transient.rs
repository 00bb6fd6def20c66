//! `[transient]`: changes in time.

use std::path::Path;

use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::Dimension;

use super::check::finite_volumes_refuse;
use super::contact::RADIUS;
use super::course::Reader;
use super::geometry::reach;
use super::inlet::LAYER;
use super::lubricant::TEMPERATURE;
use super::machine::Passage;
use super::motion::{MAX_SPEED, NO_SPIN_OF_LINES, SPIN, check_spin};
use super::{Case, approach};
use crate::contact::{Contact, ContactKind, Hertz, Motion, Supply};
use crate::params::{ElasticModel, Method, SensitivityDemand};
use crate::transient::{Approach, Cavities, Course, Speeds, Start};
use crate::words::digits;

/// How a contact changes in time, SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Transient {
    /// Length of the time that is solved, s.
    pub duration: f64,
    /// Relative error of the films by the steps in time.
    pub tolerance: f64,
    /// Instants whose profiles are written, s.
    pub output_times: Vec<f64>,
    /// Speeds of the surfaces, m/s.
    pub speeds: Speeds,
    /// Velocity of body 2 less that of body 1 across the motion, over the entrainment speed.
    pub slide_to_roll_ratio_across: Course,
    /// Angular velocities of body 1 and body 2 about the contact normal, rad/s.
    pub spin: [Course; 2],
    /// Load, N, of line contacts N/m.
    pub load: Course,
    /// Radius of a ball or a cylinder, m.
    pub radius: Option<Course>,
    /// Temperature of bodies and oil, K.
    pub temperature: Option<Course>,
    /// Thickness of the layer of oil that arrives, m.
    pub oil_layer: Option<Course>,
    /// Content of the gap where the film has ruptured.
    pub cavities: Cavities,
    /// Model of the distance of the bodies: mass in kg, damping in N s/m, stiffness in N/m, of line contacts per length; a given approach in m.
    pub approach: Approach,
    /// State at t = 0: gap in m, velocity in m/s.
    pub start: Start,
}

/// Scales of quantities in time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reference {
    /// m/s.
    pub speed: f64,
    /// N, of line contacts N/m.
    pub load: f64,
    /// Radius along the motion, m.
    pub radius: f64,
}

/// The contact of a case under another load (N, of line contacts N/m), with another radius (m) where it has one alone.
pub fn contact_with(case: &Case, load: f64, radius: f64) -> Contact {
    let mut contact = case.contact.clone();
    contact.load = load;
    if radius != contact.radius {
        contact.radius = radius;
        if contact.kind == ContactKind::Circular {
            contact.radius_y = radius;
        }
    }
    contact
}

/// Instants at which the pressure of the dry contact is looked at.
const SAMPLES: u32 = 400;

/// Tolerances that a reasonable number of steps reaches, and above which films are meaningless.
const TOLERANCE: Bounds = Bounds::closed(1e-4, 0.05);
/// Durations, s.
const DURATION: Bounds = Bounds::closed(1e-9, 1e6);
const RATIO: Bounds = Bounds::closed(-1e6, 1e6);
/// Output times where the case gives none.
const DEFAULT_OUTPUTS: u32 = 10;
/// Output times and rows of a table at most.
const MOST_TIMES: usize = 100_000;

/// Reads it, for a case that is read otherwise.
pub(super) fn read(
    root: &mut Table<'_>,
    case: &Case,
    folder: &Path,
) -> Result<Option<Transient>, InputError> {
    let Some(mut table) = root.optional_table("transient")? else {
        return Ok(None);
    };
    check(case, &mut table)?;
    let passage = (case.whole.as_ref())
        .map(|machine| machine.passage().map_err(|text| table.error_here(text)))
        .transpose()?;
    let duration = match &passage {
        None => table.required_quantity("duration", Dimension::TIME, DURATION)?,
        Some(passage) => of_passage(&mut table, passage)?,
    };
    let tolerance = table
        .optional_number("tolerance", TOLERANCE)?
        .unwrap_or(3e-3);
    let output_times = output_times(&mut table, duration)?;
    let choices = [
        ("refilled", Cavities::Refilled),
        ("conserved", Cavities::Conserved),
    ];
    let cavities = table.optional_choice("cavities", &choices)?;
    let mut reader = Reader {
        table: &mut table,
        duration,
        folder,
    };
    let own = match passage {
        Some(passage) => Changes {
            speeds: Speeds::Each(passage.speeds),
            load: passage.load,
            radius: Some(passage.radius),
            slide_to_roll_ratio_across: Course::Constant(0.0),
            spin: [0.0; 2].map(Course::Constant),
        },
        None => changes(&mut reader, case)?,
    };
    if case.thermal().is_some() && cavities == Some(Cavities::Conserved) {
        return Err(not_with_heat(reader.table, "cavities"));
    }
    let temperature = reader.course(
        "temperature",
        case.lubricant.temperature,
        Dimension::TEMPERATURE,
        TEMPERATURE,
    )?;
    let oil_layer = oil_layer(&mut reader, &case.supply)?;
    let (approach, start) = approach::read(&mut reader, case)?;
    if case.supply != Supply::Flooded {
        check_starved(&table, cavities, start)?;
    }
    let transient = Transient {
        duration,
        tolerance,
        output_times,
        speeds: own.speeds,
        slide_to_roll_ratio_across: own.slide_to_roll_ratio_across,
        spin: own.spin,
        load: own.load,
        radius: own.radius,
        temperature,
        oil_layer,
        cavities: cavities.unwrap_or_default(),
        approach,
        start,
    };
    transient.check_motion(case, &table)?;
    table.finish()?;
    transient.check(case, root)?;
    Ok(Some(transient))
}

/// Refuses keys that have no effect on a starved contact.
fn check_starved(
    table: &Table<'_>,
    cavities: Option<Cavities>,
    start: Start,
) -> Result<(), InputError> {
    if cavities.is_some() {
        return Err(table
            .error(
                "cavities",
                "`cavities` has no effect on a starved contact, whose gap contains only the oil that enters",
            )
            .with_help("remove `cavities`, or [inlet]"));
    }
    match start {
        Start::Apart { .. } => Err(table.error(
            "start",
            "bodies that are apart have a filled gap: remove [inlet]",
        )),
        _ => Ok(()),
    }
}

/// Motion, load and radius over time.
struct Changes {
    speeds: Speeds,
    slide_to_roll_ratio_across: Course,
    spin: [Course; 2],
    load: Course,
    radius: Option<Course>,
}

/// Those that the case gives.
fn changes(reader: &mut Reader<'_, '_>, case: &Case) -> Result<Changes, InputError> {
    let is_at_rest = reader.table.optional_bool("at_rest")?.unwrap_or(false);
    let motion = match is_at_rest {
        true => Motion::straight(0.0, 0.0),
        false => case.motion,
    };
    let speeds = match is_at_rest {
        true => at_rest(reader)?,
        false => speeds(reader, &motion)?,
    };
    let slide_to_roll_ratio_across = across(reader, &motion, &speeds)?;
    let spin = spin(reader, &motion, case.contact.kind)?;
    let contact = &case.contact;
    let dimension = match contact.kind.is_line() {
        true => Dimension::FORCE_PER_LENGTH,
        false => Dimension::FORCE,
    };
    let load = reader.course("load", contact.load, dimension, Bounds::POSITIVE)?;
    let radius = reader.course("radius", contact.radius, Dimension::LENGTH, RADIUS)?;
    let has_radius = matches!(contact.kind, ContactKind::Line | ContactKind::Circular);
    if radius.is_some() && !has_radius {
        return Err(reader.table.error(
            "radius",
            "one radius changes in time: that of a ball on a plane (`kind = \"circular\"`) or of a cylinder (`kind = \"line\"`)",
        ));
    }
    Ok(Changes {
        speeds,
        slide_to_roll_ratio_across,
        spin,
        load: load.unwrap_or(Course::Constant(contact.load)),
        radius,
    })
}

/// The duration of the passage of a machine's contact, or of its first part, s.
fn of_passage(table: &mut Table<'_>, passage: &Passage) -> Result<f64, InputError> {
    let keys = [
        "entrainment_speed",
        "slide_to_roll_ratio",
        "slide_to_roll_ratio_across",
        "body_1_speed",
        "body_2_speed",
        "body_1_spin",
        "body_2_spin",
        "load",
        "radius",
        "at_rest",
    ];
    if let Some(key) = keys.into_iter().find(|key| table.contains(key)) {
        return Err(table.error(
            key,
            format!("`{key}` follows from the machine: its contact is followed along the path of contact, or over a turn"),
        ));
    }
    let given = table.optional_quantity("duration", Dimension::TIME, DURATION)?;
    match given {
        Some(given) if given > passage.duration * (1.0 + 1e-9) => Err(table.error(
            "duration",
            format!(
                "the contact of the machine lasts {} s; without `duration` all of it is solved",
                digits(passage.duration, 4)
            ),
        )),
        _ => Ok(given.unwrap_or(passage.duration)),
    }
}

/// The layer of oil over time, of a contact that has one.
fn oil_layer(reader: &mut Reader<'_, '_>, supply: &Supply) -> Result<Option<Course>, InputError> {
    let base = match supply {
        Supply::OilLayer { thickness } => *thickness,
        Supply::Flooded | Supply::Meniscus { .. } => {
            return match reader.table.contains("oil_layer") {
                false => Ok(None),
                true => Err(reader
                    .table
                    .error(
                        "oil_layer",
                        "a layer that changes needs an initial thickness",
                    )
                    .with_help("give `oil_layer` in [inlet]")),
            };
        }
    };
    reader.course("oil_layer", base, Dimension::LENGTH, LAYER)
}

/// Refuses cases that are not solved in time.
fn check(case: &Case, table: &mut Table<'_>) -> Result<(), InputError> {
    let refused = [
        (
            case.elastic_model() != ElasticModel::HalfSpace,
            "finite-element bodies: time is solved between half-spaces",
        ),
        (
            case.solver.method == Some(Method::FiniteElements),
            "finite elements: time is solved by finite volumes; remove method from [solver]",
        ),
        (
            case.has_key_of_elements(),
            "keys of [mesh] or [solver] that only finite elements have",
        ),
        (
            case.output.interferogram.is_some(),
            "[output] interferogram: pictures at instants are not made",
        ),
        (
            case.output.sensitivities == SensitivityDemand::All,
            "[output] sensitivities: derivatives of instants are not computed",
        ),
    ];
    match refused.iter().find(|(is_refused, _)| *is_refused) {
        None => check_heat(case, table),
        Some((_, reason)) => {
            Err(table.error_here(format!("[transient] cannot be combined with {reason}")))
        }
    }
}

const WITHOUT_HEAT: &str = "remove [thermal], or set isothermal = true in [solver]";

/// Refuses heat that is not solved in time.
fn check_heat(case: &Case, table: &Table<'_>) -> Result<(), InputError> {
    if case.thermal().is_none() {
        return Ok(());
    }
    if let Some(reason) = finite_volumes_refuse(case) {
        let error = table.error_here(format!(
            "[transient] takes finite volumes, and those {reason}"
        ));
        return Err(error.with_help(WITHOUT_HEAT));
    }
    Ok(())
}

/// Refuses a key together with heat.
fn not_with_heat(table: &mut Table<'_>, key: &str) -> InputError {
    table
        .error(key, format!("`{key}` cannot be combined with [thermal]"))
        .with_help(WITHOUT_HEAT)
}

fn output_times(table: &mut Table<'_>, duration: f64) -> Result<Vec<f64>, InputError> {
    let within = Bounds::closed(0.0, duration);
    let Some(times) = table.optional_quantities("output_times", Dimension::TIME, within)? else {
        let share = |i| duration * f64::from(i) / f64::from(DEFAULT_OUTPUTS);
        return Ok((0..=DEFAULT_OUTPUTS).map(share).collect());
    };
    check_increasing(table, "output_times", &times)?;
    Ok(times)
}

/// Times in order.
pub(super) fn check_increasing(
    table: &Table<'_>,
    key: &str,
    times: &[f64],
) -> Result<(), InputError> {
    if times.is_empty() || times.len() > MOST_TIMES {
        return Err(table.error(key, format!("`{key}` needs 1 to {MOST_TIMES} times")));
    }
    match times.windows(2).find(|pair| pair[1] <= pair[0]) {
        None => Ok(()),
        Some(pair) => Err(table.error(
            key,
            format!(
                "times must increase, but {} s follows {} s",
                pair[1], pair[0]
            ),
        )),
    }
}

/// Speeds of surfaces that do not move along each other.
fn at_rest(reader: &mut Reader<'_, '_>) -> Result<Speeds, InputError> {
    let keys = [
        "body_1_speed",
        "body_2_speed",
        "entrainment_speed",
        "slide_to_roll_ratio",
        "slide_to_roll_ratio_across",
        "body_1_spin",
        "body_2_spin",
    ];
    match keys.into_iter().find(|key| reader.table.contains(key)) {
        None => Ok(Speeds::Each([0.0, 0.0].map(Course::Constant))),
        Some(key) => Err(reader
            .table
            .error(key, "surfaces that are at rest have no speed")
            .with_help("remove `at_rest`")),
    }
}

fn speeds(reader: &mut Reader<'_, '_>, motion: &Motion) -> Result<Speeds, InputError> {
    let speed = Bounds::closed(-MAX_SPEED, MAX_SPEED);
    let mut of = |key, base| reader.course(key, base, Dimension::SPEED, speed);
    let own = [motion.body_1_speed(), motion.body_2_speed()];
    let each = [of("body_1_speed", own[0])?, of("body_2_speed", own[1])?];
    let entrainment = of("entrainment_speed", motion.entrainment_speed)?;
    let base = motion.slide_to_roll_ratio;
    let ratio = reader.course("slide_to_roll_ratio", base, Dimension::DIMENSIONLESS, RATIO)?;
    if each.iter().all(Option::is_none) {
        return Ok(Speeds::Mean {
            entrainment: entrainment.unwrap_or(Course::Constant(motion.entrainment_speed)),
            slide_to_roll_ratio: ratio.unwrap_or(Course::Constant(base)),
        });
    }
    let both = [
        ("entrainment_speed", entrainment.is_some()),
        ("slide_to_roll_ratio", ratio.is_some()),
    ];
    if let Some((key, _)) = both.iter().find(|(_, is_given)| *is_given) {
        return Err(reader.table.error(
            key,
            format!("`{key}` follows from the speeds of the bodies; give one pair"),
        ));
    }
    let [first, second] = each;
    Ok(Speeds::Each([
        first.unwrap_or(Course::Constant(own[0])),
        second.unwrap_or(Course::Constant(own[1])),
    ]))
}

/// Sliding across the motion over the entrainment speed.
fn across(
    reader: &mut Reader<'_, '_>,
    motion: &Motion,
    speeds: &Speeds,
) -> Result<Course, InputError> {
    const KEY: &str = "slide_to_roll_ratio_across";
    let base = motion.slide_to_roll_ratio_across;
    let given = reader.course(KEY, base, Dimension::DIMENSIONLESS, RATIO)?;
    if matches!(speeds, Speeds::Each(_)) && (given.is_some() || base != 0.0) {
        let key = ["body_1_speed", "body_2_speed"]
            .into_iter()
            .find(|key| reader.table.contains(key))
            .unwrap_or(KEY);
        return Err(reader
            .table
            .error(
                key,
                "with sliding across the entrainment, speeds in time are given by entrainment speed and ratios",
            )
            .with_help("give `entrainment_speed`, `slide_to_roll_ratio` and `slide_to_roll_ratio_across` instead of the speeds of the bodies"));
    }
    Ok(given.unwrap_or(Course::Constant(base)))
}

/// Spin of both bodies.
fn spin(
    reader: &mut Reader<'_, '_>,
    motion: &Motion,
    kind: ContactKind,
) -> Result<[Course; 2], InputError> {
    let [first, second] = motion.spin;
    let mut of = |key: &str, base: f64| -> Result<Course, InputError> {
        let course = reader.course(key, base, Dimension::ANGULAR_SPEED, SPIN)?;
        if course.is_some() && kind.is_line() {
            return Err(reader.table.error(key, NO_SPIN_OF_LINES));
        }
        Ok(course.unwrap_or(Course::Constant(base)))
    };
    Ok([of("body_1_spin", first)?, of("body_2_spin", second)?])
}

impl Transient {
    /// Whether bodies turn about the contact normal at some time.
    fn spins(&self) -> bool {
        self.spin.iter().any(|spin| *spin != Course::Constant(0.0))
    }

    /// Whether surfaces slide across the motion at some time.
    fn slides_across(&self) -> bool {
        self.slide_to_roll_ratio_across != Course::Constant(0.0)
    }

    /// Whether the surfaces move along the motion alone, everywhere and at all times.
    pub fn is_straight(&self) -> bool {
        !self.spins() && !self.slides_across()
    }

    /// Smallest number of steps that the courses and the output times need.
    pub fn least_steps(&self) -> f64 {
        let courses = self.courses();
        let least = (courses.iter()).map(|(.., course)| course.least_steps(self.duration));
        least.sum::<f64>() + self.output_times.len() as f64
    }

    /// The quantities that may change, by their keys, with their units.
    pub(super) fn courses(&self) -> Vec<(&'static str, Dimension, &Course)> {
        let speeds = match &self.speeds {
            Speeds::Mean {
                entrainment,
                slide_to_roll_ratio,
            } => [
                ("entrainment_speed", Dimension::SPEED, entrainment),
                (
                    "slide_to_roll_ratio",
                    Dimension::DIMENSIONLESS,
                    slide_to_roll_ratio,
                ),
            ],
            Speeds::Each([first, second]) => [
                ("body_1_speed", Dimension::SPEED, first),
                ("body_2_speed", Dimension::SPEED, second),
            ],
        };
        let [first, second] = &self.spin;
        let across = &self.slide_to_roll_ratio_across;
        let always = [
            (
                "slide_to_roll_ratio_across",
                Dimension::DIMENSIONLESS,
                across,
            ),
            ("body_1_spin", Dimension::ANGULAR_SPEED, first),
            ("body_2_spin", Dimension::ANGULAR_SPEED, second),
            // Of lines per length.
            ("load", Dimension::FORCE, &self.load),
        ];
        let radius = self
            .radius
            .iter()
            .map(|of| ("radius", Dimension::LENGTH, of));
        let temperature =
            (self.temperature.iter()).map(|of| ("temperature", Dimension::TEMPERATURE, of));
        let layer = (self.oil_layer.iter()).map(|of| ("oil_layer", Dimension::LENGTH, of));
        (speeds.into_iter().chain(always))
            .chain(radius.chain(temperature).chain(layer))
            .collect()
    }

    /// Largest mean spin of both bodies over time, rad/s.
    fn largest_spin(&self) -> f64 {
        let [first, second] = &self.spin;
        let instants = (0..=SAMPLES).map(|i| self.duration * f64::from(i) / f64::from(SAMPLES));
        let mean = |time: f64| 0.5 * (first.at(time) + second.at(time)).abs();
        // A peak may lie between them.
        let kinks = self.spin.iter().flat_map(Course::kinks);
        let kinks = kinks.filter(|time| *time <= self.duration);
        instants.chain(kinks).map(mean).fold(0.0, f64::max)
    }

    /// Scales of a run: the largest entrainment speed, load and radius that occur. Where bodies approach from a distance, the speed of oil that leaves
    /// the contact, V R/a, and the force of their impact are included.
    pub fn reference(&self, case: &Case) -> Reference {
        let speed = match &self.speeds {
            Speeds::Mean { entrainment, .. } => entrainment.largest(self.duration),
            Speeds::Each(each) => {
                // A bound that no sum of them passes.
                let [first, second] = each.each_ref().map(|speed| speed.largest(self.duration));
                0.5 * (first + second)
            }
        };
        let load = self.load.largest(self.duration);
        let radius = (self.radius.as_ref())
            .map_or(case.contact.radius, |radius| radius.largest(self.duration));
        if self.start == Start::Steady {
            return Reference {
                speed,
                load,
                radius,
            };
        }
        let [velocity, load] = approach::reference(case, &self.approach, self.start, load);
        let contact = contact_with(case, load, radius);
        let half_width = Hertz::new(&contact, case.reduced_modulus()).half_width;
        Reference {
            speed: speed.max(velocity * radius / half_width),
            load,
            radius,
        }
    }

    /// Velocity of approach (m/s) and gap (m) of surfaces that are at rest, where the bodies start apart.
    pub fn squeeze(&self, case: &Case) -> Option<[f64; 2]> {
        let Start::Apart { gap, .. } = self.start else {
            return None;
        };
        let at_rest = Speeds::Each([0.0; 2].map(Course::Constant));
        let load = self.load.largest(self.duration);
        let [velocity, _] = approach::reference(case, &self.approach, self.start, load);
        (self.speeds == at_rest && !self.spins()).then_some([velocity, gap])
    }

    /// Largest pressure of the dry contact over time, Pa, where `largest` N or N/m is the largest force.
    fn hertz_pressure(&self, case: &Case, largest: f64) -> f64 {
        let pressure = |load: f64, radius: f64| {
            Hertz::new(&contact_with(case, load, radius), case.reduced_modulus()).pressure
        };
        let Some(radius) = &self.radius else {
            return pressure(largest, case.contact.radius);
        };
        let apart = self.start != Start::Steady;
        let instants = (0..=SAMPLES).map(|i| self.duration * f64::from(i) / f64::from(SAMPLES));
        let load = |time: f64| if apart { largest } else { self.load.at(time) };
        instants
            .map(|time| pressure(load(time), radius.at(time)))
            .fold(0.0, f64::max)
    }

    fn entrainment(&self, time: f64) -> f64 {
        let [first, second] = self.speeds.at(time);
        0.5 * (first + second)
    }

    /// Refuses spin that leaves no inlet at the largest speed and, for a steady start, at the first one, and motions whose heat is not solved in time.
    fn check_motion(&self, case: &Case, table: &Table<'_>) -> Result<(), InputError> {
        let Reference {
            speed,
            load,
            radius,
        } = self.reference(case);
        let contact = contact_with(case, load, radius);
        let hertz = Hertz::new(&contact, case.reduced_modulus());
        let at_start = self.spin.each_ref().map(|spin| spin.at(0.0));
        let largest = [self.largest_spin(); 2];
        let starts = self.start == Start::Steady && self.entrainment(0.0) > 0.0;
        let speeds = starts.then(|| (at_start, self.entrainment(0.0)));
        for (spin, speed) in speeds.into_iter().chain([(largest, speed)]) {
            let motion = Motion {
                spin,
                ..Motion::straight(speed, 0.0)
            };
            let is_point = !contact.kind.is_line();
            check_spin(table, &motion, is_point, reach(&contact, &hertz))?;
        }
        if case.thermal().is_none() {
            return Ok(());
        }
        let refused = [
            (self.spins(), "body_1_spin", "spin"),
            (
                self.slides_across() && contact.kind == ContactKind::Roller,
                "slide_to_roll_ratio_across",
                "sliding along a roller",
            ),
        ];
        match refused.into_iter().find(|(is_there, ..)| *is_there) {
            None => Ok(()),
            Some((_, key, what)) => Err(table
                .error(
                    key,
                    format!("[transient] does not solve for the heat of {what}"),
                )
                .with_help(WITHOUT_HEAT)),
        }
    }

    /// Refuses starts without a steady film and loads out of the range of contacts.
    fn check(&self, case: &Case, root: &Table<'_>) -> Result<(), InputError> {
        let start = self.entrainment(0.0);
        let Reference { speed, load, .. } = self.reference(case);
        let is_steady = self.start == Start::Steady;
        if is_steady && (start < 1e-6 * speed || start <= 0.0) {
            return Err(root
                .error(
                    "transient",
                    format!("the run starts from a steady film, but the entrainment speed at t = 0 is {start} m/s"),
                )
                .with_help("start with a slow speed; later it may vanish and reverse. Bodies at rest may start apart: start = \"apart\""));
        }
        if speed <= 0.0 {
            return Err(root.error(
                "transient",
                "nothing moves: the surfaces are at rest, and the bodies do not approach",
            ));
        }
        let pressure = self.hertz_pressure(case, load);
        if !super::check::HERTZ_PRESSURE.contains(pressure) {
            return Err(root.error(
                "transient",
                format!(
                    "the largest force gives a Hertz pressure of {}, outside 1 kPa to 5 GPa",
                    crate::words::pressure(pressure)
                ),
            ));
        }
        Ok(())
    }
}
