//! Tabulated data: isotherms written in a table, or a CSV file.

use super::{Files, locate};
use crate::LawError;
use ertel_input::csv::{Column, CsvError, CsvParams, CsvTable, Row, Vocabulary};
use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::{Dimension, STANDARD_ATMOSPHERE};

/// Data along isotherms, in SI, temperatures increasing.
#[derive(Debug, Default)]
pub(super) struct Columns {
    pub(super) temperatures: Vec<f64>,
    pub(super) pressures: Vec<Vec<f64>>,
    pub(super) values: Vec<Vec<f64>>,
}

impl Columns {
    /// Reads `file = "name.csv"` with `columns` and `decimal` where they are needed, or `isotherms` with `units`, for the property `name` of the given dimension:
    ///
    /// ```toml
    /// units = { pressure = "MPa", viscosity = "mPa.s" }
    /// isotherms = [
    ///     { temperature = "20 degC", pressure = [0, 50, 100], viscosity = [1.0, 1.6, 2.5] },
    /// ]
    /// ```
    ///
    /// A CSV file ([`ertel_input::csv`]) has a header such as `temperature [K], pressure [MPa], viscosity [mPa.s]` and one
    /// state on a line; other columns are ignored, a state without a value is left out. A column `absolute pressure` is reduced by one standard atmosphere. A property of two words, `heat capacity`, is
    /// the key `heat_capacity` in a table. Where `pressures` allows, they may be left out altogether.
    pub(super) fn read(
        table: &mut Table<'_>,
        files: Files<'_>,
        name: &'static str,
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
            let params = CsvParams::of_keys(table)?;
            let columns = files.read(file).and_then(|text| {
                Self::from_csv(file, &text, (name, dimension), pressures, &params)
                    .map_err(|error| error.to_string())
            });
            return columns.map_err(|problem| table.error("file", problem));
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
            ertel_quantity::parse(&format!("1 {unit}"), dimension)
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

    /// Reads a CSV file.
    fn from_csv(
        file: &str,
        text: &str,
        (name, dimension): (&'static str, Dimension),
        pressures: Pressures,
        params: &CsvParams,
    ) -> Result<Self, CsvError> {
        let vocabulary = Vocabulary {
            names: &[name, "pressure", "absolute pressure", "temperature"],
            is_key: &|_| false,
        };
        let table = CsvTable::parse_for(file, text, &vocabulary, params)?;
        let header = Header::of(&table, name, dimension, pressures)?;
        let mut states: Vec<(&Row, [f64; 3])> = Vec::new();
        for row in table.rows() {
            states.extend(header.state(&table, row)?.map(|state| (row, state)));
        }
        // A stable sort: within an isotherm the order of the file stays.
        states.sort_by(|a, b| a.1[0].total_cmp(&b.1[0]));
        for pair in states.windows(2) {
            let [(before, [t, p, _]), (row, [next_t, next_p, _])] = pair else {
                continue;
            };
            if t == next_t && next_p <= p {
                let (index, must) = match &header.pressure {
                    Some(pressure) => (pressure.index, "pressures must increase"),
                    None => (header.temperature.index, "temperatures must differ"),
                };
                let problem = format!(
                    "{must}, but this line follows line {} at the same temperature",
                    before.line
                );
                return Err(table.error(row, index, problem));
            }
        }
        let mut columns = Self::default();
        for (_, [temperature, pressure, value]) in states {
            if columns.temperatures.last() != Some(&temperature) {
                columns.temperatures.push(temperature);
                columns.pressures.push(Vec::new());
                columns.values.push(Vec::new());
            }
            let rows = [&mut columns.pressures, &mut columns.values];
            for (rows, number) in rows.into_iter().zip([pressure, value]) {
                rows.last_mut().into_iter().for_each(|row| row.push(number));
            }
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

/// The columns in use.
struct Header {
    temperature: Column,
    /// `None` for a table over temperature alone.
    pressure: Option<Column>,
    absolute: bool,
    value: Column,
}

impl Header {
    fn of(
        table: &CsvTable,
        name: &'static str,
        dimension: Dimension,
        pressures: Pressures,
    ) -> Result<Self, CsvError> {
        let need = |found: Option<Column>, title: &str| {
            found.ok_or_else(|| {
                let problem = format!(
                    "there is no column `{title} [unit]`; the columns are {}",
                    table.header().cells().join(", ")
                );
                table.error(table.header(), 0, problem)
            })
        };
        let find = |title, dimension| table.find_with_unit(title, dimension);
        let (pressure, absolute) = table.find_pressure()?.unzip();
        if pressure.is_none() && pressures == Pressures::Required {
            need(None, "pressure")?;
        }
        let temperature = find("temperature", Dimension::TEMPERATURE)?;
        Ok(Self {
            temperature: need(temperature, "temperature")?,
            pressure,
            absolute: absolute.unwrap_or(false),
            value: need(find(name, dimension)?, name)?,
        })
    }

    /// Temperature, pressure and value of a line; `None` if the value is left out.
    fn state(&self, table: &CsvTable, row: &Row) -> Result<Option<[f64; 3]>, CsvError> {
        if table.is_missing(row, self.value.index) {
            return Ok(None);
        }
        let positive = |column: &Column| {
            let value = table.required_number(row, column)?;
            if value > 0.0 {
                return Ok(value);
            }
            let problem = format!(
                "{}: {} is impossible: it must be above zero (absolute zero for a temperature)",
                column.name,
                row.cell(column.index)
            );
            Err(table.error(row, column.index, problem))
        };
        let pressure = match &self.pressure {
            Some(column) => table.required_number(row, column)?,
            None => 0.0,
        };
        Ok(Some([
            positive(&self.temperature)?,
            if self.absolute {
                pressure - STANDARD_ATMOSPHERE
            } else {
                pressure
            },
            positive(&self.value)?,
        ]))
    }
}
