//! A quantity over time in `[transient]`: a table, a file, a ramp, a sine or a step.

use std::path::Path;

use ertel_input::csv::{CsvError, CsvTable, Wanted};
use ertel_input::file::{LARGEST_TABLE, read_text};
use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::Dimension;

use super::transient::check_increasing;
use crate::transient::{Course, Params};
use crate::words::digits;

/// Reads courses.
pub(super) struct Reader<'r, 't> {
    pub(super) table: &'r mut Table<'t>,
    /// s.
    pub(super) duration: f64,
    /// Folder of its files.
    pub(super) folder: &'r Path,
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
            Kind::Table => self.rows(&mut table, key, dimension, bounds)?,
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
                let of_amplitude = match dimension == Dimension::TEMPERATURE {
                    true => Dimension::TEMPERATURE_DIFFERENCE,
                    false => dimension,
                };
                let amplitude = quantity(&mut table, "amplitude", of_amplitude, Bounds::ANY)?;
                let period =
                    table.required_quantity("period", Dimension::TIME, Bounds::POSITIVE)?;
                let start = time(&mut table, "start")?.unwrap_or(0.0);
                for end in [base - amplitude, base + amplitude] {
                    if !bounds.contains(end) {
                        return Err(table.error(
                            "amplitude",
                            format!(
                                "with this amplitude `{key}` reaches {end}, which is out of range"
                            ),
                        ));
                    }
                }
                let sine = Course::Sine {
                    mean: base,
                    amplitude,
                    period,
                    start,
                };
                self.check_steps(&table, &sine)?;
                sine
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

    /// Refuses a sine with more periods than there are steps.
    fn check_steps(&self, table: &Table<'_>, sine: &Course) -> Result<(), InputError> {
        let (least, most) = (
            sine.least_steps(self.duration),
            Params::default().most_steps,
        );
        match least > most as f64 {
            false => Ok(()),
            true => Err(table
                .error(
                    "period",
                    format!(
                        "the periods within `duration` take at least {} steps, and a run takes at most {most}",
                        digits(least, 2)
                    ),
                )
                .with_help("give a longer period or a shorter `duration`")),
        }
    }

    /// Times and values, of the case or of a file.
    fn rows(
        &self,
        table: &mut Table<'_>,
        quantity: &str,
        dimension: Dimension,
        bounds: Bounds,
    ) -> Result<Course, InputError> {
        let (key, rows) = match table.optional_str("file")? {
            Some(file) => (
                "file",
                self.rows_of_file(table, (file, quantity), dimension, bounds)?,
            ),
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
                        "the table covers {first} s to {last} s, but the run covers 0 s to {} s",
                        self.duration
                    ),
                )
                .with_help("tables are not extrapolated: add rows, or shorten `duration`"));
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
        (file, quantity): (&str, &str),
        dimension: Dimension,
        bounds: Bounds,
    ) -> Result<Vec<[f64; 2]>, InputError> {
        let path = self.folder.join(file);
        let fail = |text: String| table.error("file", text);
        let text = read_text(&path, LARGEST_TABLE)
            .map_err(|error| fail(format!("{} {error}", path.display())))?;
        rows_of((file, quantity), &text, dimension, bounds).map_err(|error| {
            let help = format!(
                "a file has a column of the time and one of the values with their units, such as \"time (ms)\" and \"{} ({})\"",
                quantity.replace('_', " "),
                dimension.si_unit()
            );
            fail(error.to_string()).with_help(help.replace(" ()", ""))
        })
    }
}

/// Column names of the quantities of `[transient]`, in addition to `value`.
const COLUMNS: [(&str, &str); 8] = [
    ("entrainment_speed", "entrainment speed"),
    ("slide_to_roll_ratio", "slide to roll ratio"),
    ("load", "load"),
    ("temperature", "temperature"),
    ("radius", "radius"),
    ("oil_layer", "oil layer"),
    ("body_1_speed", "body 1 speed"),
    ("body_2_speed", "body 2 speed"),
];

/// Times and values of a CSV file.
fn rows_of(
    (file, quantity): (&str, &str),
    text: &str,
    dimension: Dimension,
    bounds: Bounds,
) -> Result<Vec<[f64; 2]>, CsvError> {
    let own = COLUMNS.iter().find(|(key, _)| *key == quantity);
    let names = [own.map_or("value", |(_, name)| *name), "value"];
    let time = Wanted {
        names: &["time"],
        dimension: Dimension::TIME,
    };
    let value = Wanted {
        names: &names,
        dimension,
    };
    let (csv, [time, value]) = CsvTable::series(file, text, [time, value])?;
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
