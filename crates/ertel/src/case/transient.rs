//! `[transient]`, what changes in time.

use std::path::Path;

use ertel_input::csv::{CsvError, CsvTable};
use ertel_input::file::{LARGEST_TABLE, read_text};
use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::Dimension;

use super::motion::MAX_SPEED;
use super::{Case, approach};
use crate::contact::{Hertz, Motion, Supply};
use crate::params::{ElasticModel, Method, SensitivityDemand};
use crate::transient::{Approach, Course, Speeds, Start};
use crate::warning::Warning;

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
    /// Load, N, of line contacts N/m.
    pub load: Course,
    /// What the distance of the bodies follows from: mass in kg, damping in N s/m, stiffness in N/m, of line contacts per length; a given approach in m.
    pub approach: Approach,
    /// What it begins with: gap in m, velocity in m/s.
    pub start: Start,
}

/// Tolerances that steps of a reasonable number reach, and beyond which no film means anything.
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
    check(case, &table)?;
    if root.contains("curve") {
        return Err(table.error_here("[transient] does not go together with [curve]: choose one"));
    }
    let duration = table.required_quantity("duration", Dimension::TIME, DURATION)?;
    let tolerance = table
        .optional_number("tolerance", TOLERANCE)?
        .unwrap_or(3e-3);
    let output_times = output_times(&mut table, duration)?;
    let mut reader = Reader {
        table: &mut table,
        duration,
        folder,
    };
    let speeds = speeds(&mut reader, &case.motion)?;
    let (approach, start) = approach::read(&mut reader, case)?;
    let dimension = match case.contact.kind.is_line() {
        true => Dimension::FORCE_PER_LENGTH,
        false => Dimension::FORCE,
    };
    let load = reader.course("load", case.contact.load, dimension, Bounds::POSITIVE)?;
    table.finish()?;
    let transient = Transient {
        duration,
        tolerance,
        output_times,
        speeds,
        load: load.unwrap_or(Course::Constant(case.contact.load)),
        approach,
        start,
    };
    transient.check(case, root)?;
    Ok(Some(transient))
}

/// Refuses what is not solved in time.
fn check(case: &Case, table: &Table<'_>) -> Result<(), InputError> {
    let refused = [
        (
            case.thermal().is_some(),
            "[thermal]: heat is not solved in time; leave it out, or set isothermal = true in [solver]",
        ),
        (
            case.supply != Supply::Flooded,
            "[inlet]: a starved inlet is not solved in time",
        ),
        (
            !case.motion.is_straight(),
            "spin or skew: surfaces that move along the entrainment alone are solved in time",
        ),
        (
            case.whole.is_some(),
            "a whole machine: choose one of its contacts in [machine]",
        ),
        (
            case.elastic_model() != ElasticModel::HalfSpace,
            "finite-element bodies: time is solved between half-spaces",
        ),
        (
            case.solver.method == Some(Method::FiniteElements),
            "finite elements: time is solved by finite volumes; leave [solver] method out",
        ),
        (
            case.has_key_of_elements(),
            "keys of [mesh] or [solver] that finite elements alone have",
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
        None => Ok(()),
        Some((_, reason)) => {
            Err(table.error_here(format!("[transient] does not go together with {reason}")))
        }
    }
}

/// What the results leave out that the case describes.
pub(super) fn warnings(case: &Case) -> Option<Warning> {
    let is_rough = case.transient.is_some() && case.roughness.is_some();
    is_rough.then(|| {
        Warning::from(
            "the roughness counts for nothing in time: films over it give the lambda ratio at each instant".to_owned(),
        )
    })
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
fn check_increasing(table: &Table<'_>, key: &str, times: &[f64]) -> Result<(), InputError> {
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

fn speeds(reader: &mut Reader<'_, '_>, motion: &Motion) -> Result<Speeds, InputError> {
    let speed = Bounds::closed(-MAX_SPEED, MAX_SPEED);
    if reader.table.optional_bool("at_rest")?.unwrap_or(false) {
        let keys = [
            "body_1_speed",
            "body_2_speed",
            "entrainment_speed",
            "slide_to_roll_ratio",
        ];
        return match keys.into_iter().find(|key| reader.table.contains(key)) {
            None => Ok(Speeds::Each([0.0, 0.0].map(Course::Constant))),
            Some(key) => Err(reader
                .table
                .error(key, "surfaces that are at rest have no speed")
                .with_help("leave out `at_rest`")),
        };
    }
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

/// Reads courses.
pub(super) struct Reader<'r, 't> {
    pub(super) table: &'r mut Table<'t>,
    duration: f64,
    folder: &'r Path,
}

/// The kinds of courses.
#[derive(Clone, Copy)]
enum Kind {
    Table,
    Ramp,
    Sine,
    Step,
}

const KINDS: [(&str, Kind); 4] = [
    ("table", Kind::Table),
    ("ramp", Kind::Ramp),
    ("sine", Kind::Sine),
    ("step", Kind::Step),
];

impl Reader<'_, '_> {
    /// The course of a quantity that begins at `base`; `None` where the case gives none.
    pub(super) fn course(
        &mut self,
        key: &str,
        base: f64,
        dimension: Dimension,
        bounds: Bounds,
    ) -> Result<Option<Course>, InputError> {
        let Some(mut table) = self.table.optional_table(key)? else {
            return Ok(None);
        };
        let kind = table.required_choice("course", &KINDS).map_err(|error| {
            error.with_help(
                "such as { course = \"ramp\", end = \"2 ms\", to = \"1 m/s\" } or { course = \"table\", times = [...], values = [...] }",
            )
        })?;
        let instant = Bounds::closed(0.0, f64::MAX);
        let time = |table: &mut Table<'_>, key: &str| {
            table.optional_quantity(key, Dimension::TIME, instant)
        };
        let value = |table: &mut Table<'_>, key: &str| quantity(table, key, dimension, bounds);
        let course = match kind {
            Kind::Table => self.rows(&mut table, dimension, bounds)?,
            Kind::Ramp => {
                let start = time(&mut table, "start")?.unwrap_or(0.0);
                let end = table.required_quantity("end", Dimension::TIME, Bounds::POSITIVE)?;
                if end <= start {
                    return Err(table.error("end", "the ramp ends before it starts"));
                }
                let to = value(&mut table, "to")?;
                Course::Table(vec![[start, base], [end, to]])
            }
            Kind::Sine => {
                let amplitude = quantity(&mut table, "amplitude", dimension, Bounds::ANY)?;
                let period =
                    table.required_quantity("period", Dimension::TIME, Bounds::POSITIVE)?;
                for end in [base - amplitude, base + amplitude] {
                    if !bounds.contains(end) {
                        return Err(table.error(
                            "amplitude",
                            format!("with this amplitude `{key}` comes to {end}, which no contact can have"),
                        ));
                    }
                }
                Course::Sine {
                    mean: base,
                    amplitude,
                    period,
                    start: time(&mut table, "start")?.unwrap_or(0.0),
                }
            }
            Kind::Step => Course::Step {
                from: base,
                to: value(&mut table, "to")?,
                at: table.required_quantity("at", Dimension::TIME, instant)?,
            },
        };
        table.finish()?;
        Ok(Some(course))
    }

    /// Times and values, of the case or of a file.
    fn rows(
        &self,
        table: &mut Table<'_>,
        dimension: Dimension,
        bounds: Bounds,
    ) -> Result<Course, InputError> {
        let (key, rows) = match table.optional_str("file")? {
            Some(file) => ("file", self.rows_of_file(table, file, dimension, bounds)?),
            None => {
                let any = Bounds::closed(0.0, f64::MAX);
                let times = table.required_quantities("times", Dimension::TIME, any)?;
                let values = match dimension == Dimension::DIMENSIONLESS {
                    true => table.required_numbers("values", bounds)?,
                    false => table.required_quantities("values", dimension, bounds)?,
                };
                if times.len() != values.len() {
                    return Err(table.error(
                        "values",
                        format!("{} values for {} times", values.len(), times.len()),
                    ));
                }
                let rows = times.into_iter().zip(values).map(|(t, v)| [t, v]);
                ("times", rows.collect())
            }
        };
        let times: Vec<f64> = rows.iter().map(|[t, _]| *t).collect();
        check_increasing(table, key, &times)?;
        let (first, last) = (times[0], times[times.len() - 1]);
        if first > 0.0 || last < self.duration * (1.0 - 1e-9) {
            return Err(table
                .error(
                    key,
                    format!(
                        "the table goes from {first} s to {last} s, and the time that is solved from 0 to {} s",
                        self.duration
                    ),
                )
                .with_help("nothing is assumed before and after a table: add rows, or shorten `duration`"));
        }
        let choices = [("linear", false), ("smooth", true)];
        let is_smooth = table.optional_choice("interpolation", &choices)?;
        Ok(match is_smooth.unwrap_or(false) {
            true => Course::Smooth(rows),
            false => Course::Table(rows),
        })
    }

    fn rows_of_file(
        &self,
        table: &Table<'_>,
        file: &str,
        dimension: Dimension,
        bounds: Bounds,
    ) -> Result<Vec<[f64; 2]>, InputError> {
        let path = self.folder.join(file);
        let fail = |text: String| table.error("file", text);
        let text = read_text(&path, LARGEST_TABLE)
            .map_err(|error| fail(format!("{} {error}", path.display())))?;
        rows_of(file, &text, dimension, bounds).map_err(|error| {
            fail(error.to_string()).with_help(
                "a file has the columns `time` and `value` with their units, such as \"time (ms)\" and \"value (m/s)\"",
            )
        })
    }
}

/// Times and values of a CSV file.
fn rows_of(
    file: &str,
    text: &str,
    dimension: Dimension,
    bounds: Bounds,
) -> Result<Vec<[f64; 2]>, CsvError> {
    let csv = CsvTable::parse(file, text)?;
    let column = |name: &'static str, dimension| {
        csv.find_with_unit(name, dimension)?
            .ok_or_else(|| csv.error(csv.header(), 0, format!("there is no column `{name}`")))
    };
    let time = column("time", Dimension::TIME)?;
    let value = column("value", dimension)?;
    let mut rows = Vec::new();
    for row in csv.rows() {
        let [t, v] = [
            csv.required_number(row, &time)?,
            csv.required_number(row, &value)?,
        ];
        if !bounds.contains(v) {
            let must = bounds.describe(&dimension.si_unit());
            return Err(csv.error(row, 0, format!("the value {v} must be {must}")));
        }
        rows.push([t, v]);
    }
    Ok(rows)
}

fn quantity(
    table: &mut Table<'_>,
    key: &str,
    dimension: Dimension,
    bounds: Bounds,
) -> Result<f64, InputError> {
    match dimension == Dimension::DIMENSIONLESS {
        true => table.required_number(key, bounds),
        false => table.required_quantity(key, dimension, bounds),
    }
}

impl Transient {
    /// The largest entrainment speed, m/s, and load that occur, by which all others are measured. Where bodies come near to each other from afar, the speed of oil that leaves
    /// the contact, V R/a, and the force of their impact count, too.
    pub fn reference(&self, case: &Case) -> [f64; 2] {
        let speed = match &self.speeds {
            Speeds::Mean { entrainment, .. } => entrainment.largest(self.duration),
            Speeds::Each(each) => {
                // A bound that no sum of them passes.
                let [first, second] = each.each_ref().map(|speed| speed.largest(self.duration));
                0.5 * (first + second)
            }
        };
        let load = self.load.largest(self.duration);
        if self.start == Start::Steady {
            return [speed, load];
        }
        let [velocity, load] = approach::reference(case, &self.approach, self.start, load);
        let mut contact = case.contact.clone();
        contact.load = load;
        let half_width = Hertz::new(&contact, case.reduced_modulus()).half_width;
        [speed.max(velocity * contact.radius / half_width), load]
    }

    fn entrainment(&self, time: f64) -> f64 {
        let [first, second] = self.speeds.at(time);
        0.5 * (first + second)
    }

    /// Refuses starts without a steady film and loads beyond what a contact bears.
    fn check(&self, case: &Case, root: &Table<'_>) -> Result<(), InputError> {
        let start = self.entrainment(0.0);
        let [speed, load] = self.reference(case);
        let is_steady = self.start == Start::Steady;
        if is_steady && (start < 1e-6 * speed || start <= 0.0) {
            return Err(root
                .error(
                    "transient",
                    format!("time begins with a steady film, and the entrainment speed at t = 0 is {start} m/s"),
                )
                .with_help("begin with a slow speed; later it may vanish and turn. Bodies that are at rest may start apart: start = \"apart\""));
        }
        if speed <= 0.0 {
            return Err(root.error(
                "transient",
                "nothing moves: the surfaces are at rest, and the bodies do not come near to each other",
            ));
        }
        let mut contact = case.contact.clone();
        contact.load = load;
        let hertz = Hertz::new(&contact, case.reduced_modulus());
        if !super::check::HERTZ_PRESSURE.contains(hertz.pressure) {
            return Err(root.error(
                "transient",
                format!(
                    "the largest force gives a Hertz pressure of {}, outside 1 kPa to 5 GPa",
                    crate::words::pressure(hertz.pressure)
                ),
            ));
        }
        Ok(())
    }
}
