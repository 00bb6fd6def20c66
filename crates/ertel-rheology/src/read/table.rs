//! Tabulated data: isotherms written in a table, or a CSV file.

use super::{Files, locate};
use crate::LawError;
use crate::input::{Bounds, InputError, Table};
use crate::quantity::{self, Dimension, STANDARD_ATMOSPHERE};

/// Data along isotherms, in SI, temperatures increasing.
#[derive(Debug, Default)]
pub(super) struct Columns {
    pub(super) temperatures: Vec<f64>,
    pub(super) pressures: Vec<Vec<f64>>,
    pub(super) values: Vec<Vec<f64>>,
}

impl Columns {
    /// Reads `file = "name.csv"`, or `isotherms` with `units`, for the property `name` of the given dimension:
    ///
    /// ```toml
    /// units = { pressure = "MPa", viscosity = "mPa.s" }
    /// isotherms = [
    ///     { temperature = "20 degC", pressure = [0, 50, 100], viscosity = [1.0, 1.6, 2.5] },
    /// ]
    /// ```
    ///
    /// A CSV file has a header such as `temperature [K], pressure [MPa], viscosity [mPa.s]` and one state on a line;
    /// lines that start with `#` are comments, other columns are ignored, a state without a value is left out. A
    /// column `absolute pressure` is reduced by one standard atmosphere. A property of two words, `heat capacity`, is
    /// the key `heat_capacity` in a table. Where `pressures` allows, they may be left out altogether.
    pub(super) fn read(
        table: &mut Table<'_>,
        files: Files<'_>,
        name: &str,
        dimension: Dimension,
        pressures: Pressures,
    ) -> Result<Self, InputError> {
        if let Some(file) = table.optional_str("file")? {
            // Known keys, so that giving both forms is refused for the right reason.
            if table.contains("isotherms") || table.contains("units") {
                return Err(table.error(
                    "file",
                    "`file` replaces `isotherms` and `units`: give one form",
                ));
            }
            let columns = files
                .read(file)
                .and_then(|text| Self::from_csv(&text, name, dimension, pressures));
            return columns.map_err(|problem| table.error("file", format!("{file}: {problem}")));
        }
        if !table.contains("isotherms") {
            return Err(table
                .missing("isotherms")
                .with_help("or `file = \"name.csv\"`"));
        }
        let key = name.replace(' ', "_");
        let mut units = table.required_table("units")?;
        let value_unit = units.required_str(&key)?;
        let scale = |units: &Table<'_>, key: &str, unit: &str, dimension| {
            quantity::parse(&format!("1 {unit}"), dimension)
                .map_err(|error| units.error(key, error.to_string()))
        };
        let value_scale = scale(&units, &key, value_unit, dimension)?;
        let without_pressure = pressures == Pressures::Optional && !units.contains("pressure");
        let pressure_scale = if without_pressure {
            None
        } else {
            let unit = units.required_str("pressure")?;
            Some(scale(&units, "pressure", unit, Dimension::PRESSURE)?)
        };
        units.finish()?;

        let mut columns = Self::default();
        for mut isotherm in table.tables("isotherms")? {
            let temperature = isotherm.required_quantity(
                "temperature",
                Dimension::TEMPERATURE,
                Bounds::POSITIVE,
            )?;
            let scaled = |values: Vec<f64>, scale: f64| -> Vec<f64> {
                values.into_iter().map(|value| value * scale).collect()
            };
            let pressures = match pressure_scale {
                Some(scale) => scaled(isotherm.required_numbers("pressure", Bounds::ANY)?, scale),
                None => vec![0.0],
            };
            let values = scaled(
                isotherm.required_numbers(&key, Bounds::POSITIVE)?,
                value_scale,
            );
            isotherm.finish()?;
            columns.temperatures.push(temperature);
            columns.pressures.push(pressures);
            columns.values.push(values);
        }
        Ok(columns)
    }

    /// The law of a property that the data are of; what it refuses is an error at `table`.
    pub(super) fn law<T>(
        self,
        table: &Table<'_>,
        new: impl Fn(Vec<f64>, Vec<Vec<f64>>, Vec<Vec<f64>>) -> Result<T, LawError>,
    ) -> Result<T, InputError> {
        new(self.temperatures, self.pressures, self.values).map_err(locate(table))
    }

    /// Reads a CSV file; the error is a sentence that begins with the line.
    fn from_csv(
        text: &str,
        name: &str,
        dimension: Dimension,
        pressures: Pressures,
    ) -> Result<Self, String> {
        let mut lines = text
            .lines()
            .enumerate()
            .map(|(i, line)| (i + 1, line.trim()))
            .filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));
        let (number, header) = lines.next().ok_or("the file is empty")?;
        let header = Header::parse(header, name, pressures)
            .map_err(|problem| format!("line {number}: {problem}"))?;

        let mut states: Vec<(usize, [f64; 3])> = Vec::new();
        for (number, line) in lines {
            let state = header
                .state(line, name, dimension)
                .map_err(|problem| format!("line {number}: {problem}"))?;
            states.extend(state.map(|state| (number, state)));
        }
        // A stable sort: within an isotherm the order of the file stays.
        states.sort_by(|(_, a), (_, b)| a[0].total_cmp(&b[0]));
        let unordered = states
            .windows(2)
            .find(|pair| pair[0].1[0] == pair[1].1[0] && pair[1].1[1] <= pair[0].1[1]);
        if let Some([(former, _), (number, _)]) = unordered {
            return Err(format!(
                "line {number}: pressure: at one temperature the pressures must increase, but this one does not exceed that of line {former}"
            ));
        }
        let mut columns = Self::default();
        for (_, [temperature, pressure, value]) in states {
            if columns.temperatures.last() != Some(&temperature) {
                columns.temperatures.push(temperature);
                columns.pressures.push(Vec::new());
                columns.values.push(Vec::new());
            }
            columns
                .pressures
                .last_mut()
                .into_iter()
                .for_each(|row| row.push(pressure));
            columns
                .values
                .last_mut()
                .into_iter()
                .for_each(|row| row.push(value));
        }
        Ok(columns)
    }
}

/// Whether a table may do without pressures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Pressures {
    /// A table over pressure and temperature.
    Required,
    /// A table over temperature alone will do.
    Optional,
}

/// Position and unit of the columns in use.
struct Header {
    temperature: (usize, String),
    /// `None` for a table over temperature alone.
    pressure: Option<(usize, String)>,
    absolute: bool,
    value: (usize, String),
}

impl Header {
    fn parse(line: &str, name: &str, pressures: Pressures) -> Result<Self, String> {
        let columns: Vec<(&str, &str)> = line
            .split(',')
            .map(|cell| {
                let (title, unit) = cell.split_once('[').unwrap_or((cell, ""));
                (title.trim(), unit.trim().trim_end_matches(']'))
            })
            .collect();
        let find = |title: &str| {
            columns
                .iter()
                .position(|(found, _)| *found == title)
                .map(|i| (i, columns[i].1.to_owned()))
        };
        let titles = || {
            columns
                .iter()
                .map(|(title, _)| *title)
                .collect::<Vec<_>>()
                .join(", ")
        };
        let need = |title: &str| {
            find(title).ok_or_else(|| {
                format!(
                    "there is no column `{title} [unit]`; the columns are {}",
                    titles()
                )
            })
        };
        let (pressure, absolute) = match (find("pressure"), find("absolute pressure")) {
            (Some(_), Some(_)) => {
                return Err("give `pressure` or `absolute pressure`, not both".into());
            }
            (None, Some(column)) => (Some(column), true),
            (None, None) if pressures == Pressures::Optional => (None, false),
            _ => (Some(need("pressure")?), false),
        };
        Ok(Self {
            temperature: need("temperature")?,
            pressure,
            absolute,
            value: need(name)?,
        })
    }

    /// Temperature, pressure and value of a line; `None` if the value is left out.
    fn state(
        &self,
        line: &str,
        name: &str,
        dimension: Dimension,
    ) -> Result<Option<[f64; 3]>, String> {
        let cells: Vec<&str> = line.split(',').map(str::trim).collect();
        let number = |(column, unit): &(usize, String), dimension| {
            let cell = cells
                .get(*column)
                .ok_or_else(|| format!("there are only {} columns", cells.len()))?;
            quantity::parse(&format!("{cell} {unit}"), dimension).map_err(|error| error.to_string())
        };
        let positive = |title: &str, column: &(usize, String), dimension| {
            let value = number(column, dimension)?;
            if value > 0.0 {
                return Ok(value);
            }
            let (cell, unit) = (cells[column.0], &column.1);
            Err(format!(
                "{title}: {cell} {unit} is impossible: it must be above {}",
                match title {
                    "temperature" => "absolute zero",
                    _ => "zero",
                }
            ))
        };
        if cells.get(self.value.0).is_none_or(|cell| cell.is_empty()) {
            return Ok(None);
        }
        let pressure = match &self.pressure {
            Some(column) => number(column, Dimension::PRESSURE)?,
            None => 0.0,
        };
        Ok(Some([
            positive("temperature", &self.temperature, Dimension::TEMPERATURE)?,
            if self.absolute {
                pressure - STANDARD_ATMOSPHERE
            } else {
                pressure
            },
            positive(name, &self.value, dimension)?,
        ]))
    }
}
