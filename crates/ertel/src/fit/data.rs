//! Measured states from a CSV file.

use ertel_rheology::input::Bounds;
use ertel_rheology::input::csv::{Column, CsvTable, Row};
use ertel_rheology::quantity::{Dimension, STANDARD_ATMOSPHERE};

pub use ertel_rheology::input::csv::CsvError as DataError;

/// What was measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Property {
    /// Dynamic viscosity, Pa·s.
    Viscosity,
    /// Density, kg/m³.
    Density,
}

impl Property {
    /// Name, also that of the column.
    pub fn name(self) -> &'static str {
        match self {
            Self::Viscosity => "viscosity",
            Self::Density => "density",
        }
    }

    fn dimension(self) -> Dimension {
        match self {
            Self::Viscosity => Dimension::VISCOSITY,
            Self::Density => Dimension::DENSITY,
        }
    }
}

/// A measured state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    /// Pressure above ambient, Pa.
    pub pressure: f64,
    /// Temperature, K.
    pub temperature: f64,
    /// Viscosity (Pa·s) or density (kg/m³).
    pub value: f64,
    /// Line of the file, from 1.
    pub line: usize,
}

/// Measured states.
#[derive(Clone, Debug, PartialEq)]
pub struct Data {
    /// Name of the file.
    pub file: String,
    /// What was measured.
    pub property: Property,
    /// The states, in the order of the file.
    pub states: Vec<State>,
}

impl Data {
    /// Reads a table of states from the text of a CSV file.
    ///
    /// The file is a table of [`ertel_rheology::input::csv`] whose columns have units, as `pressure_MPa, temperature_degC,
    /// viscosity_mPa_s` or `pressure [MPa], temperature [degC], viscosity [mPa.s]`. A column `absolute_pressure` is reduced
    /// by one standard atmosphere. Other columns are ignored; a state without a value is left out.
    ///
    /// # Errors
    ///
    /// Missing columns, units and numbers, with line and column; impossible values.
    pub fn parse(file: &str, text: &str, property: Property) -> Result<Self, DataError> {
        let table = CsvTable::parse(file, text).map_err(|mut error| {
            if error.line == 1 && error.problem.contains("empty") {
                error.problem += &format!("; {}", expected(property));
            }
            error
        })?;
        let header = Header::of(&table, property)?;
        let mut states = Vec::new();
        for row in table.rows() {
            states.extend(header.state(&table, row)?);
        }
        if states.is_empty() {
            let problem = "there are no states below the header";
            return Err(table.error(table.header(), 0, problem));
        }
        Ok(Self {
            file: file.to_owned(),
            property,
            states,
        })
    }

    /// Lowest and highest pressure, Pa above ambient.
    pub fn pressure_range(&self) -> [f64; 2] {
        range(self.states.iter().map(|s| s.pressure))
    }

    /// Lowest and highest temperature, K.
    pub fn temperature_range(&self) -> [f64; 2] {
        range(self.states.iter().map(|s| s.temperature))
    }
}

fn range(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| {
        [low.min(v), high.max(v)]
    })
}

fn expected(property: Property) -> String {
    let value = match property {
        Property::Viscosity => "viscosity_mPa_s",
        Property::Density => "density_kg_per_m3",
    };
    format!(
        "its first line names the columns with their units, such as `pressure_MPa, temperature_K, {value}` (or \
         `absolute_pressure_MPa`)"
    )
}

/// Values beyond which no lubricant was measured; the laws' numbers leave floating point far from there.
const TEMPERATURES: [f64; 2] = [1.0, 1e4];
const LARGEST_PRESSURE: f64 = 1e12;
const VISCOSITIES: [f64; 2] = [1e-9, 1e30];
const DENSITIES: [f64; 2] = [1e-6, 1e6];

struct Header {
    pressure: Column,
    absolute: bool,
    temperature: Column,
    value: Column,
    values: [f64; 2],
}

impl Header {
    fn of(table: &CsvTable, property: Property) -> Result<Self, DataError> {
        let find = |name, dimension| table.find_with_unit(name, dimension);
        let need = |found: Option<Column>, name: &str| {
            found.ok_or_else(|| {
                let problem = format!(
                    "there is no column `{name}`; {}; the columns are {}",
                    expected(property),
                    table.header().cells().join(", ")
                );
                table.error(table.header(), 0, problem)
            })
        };
        let gauge = find("pressure", Dimension::PRESSURE)?;
        let (pressure, absolute) = match (gauge, find("absolute pressure", Dimension::PRESSURE)?) {
            (Some(_), Some(second)) => {
                let problem = "give `pressure` or `absolute_pressure`, not both";
                return Err(table.error(table.header(), second.index, problem));
            }
            (None, Some(absolute)) => (absolute, true),
            (pressure, None) => (need(pressure, "pressure")?, false),
        };
        let temperature = find("temperature", Dimension::TEMPERATURE)?;
        let value = find(property.name(), property.dimension())?;
        Ok(Self {
            pressure,
            absolute,
            temperature: need(temperature, "temperature")?,
            value: need(value, property.name())?,
            values: match property {
                Property::Viscosity => VISCOSITIES,
                Property::Density => DENSITIES,
            },
        })
    }

    /// The state of a line; `None` if the value is left out.
    fn state(&self, table: &CsvTable, row: &Row) -> Result<Option<State>, DataError> {
        if row.cell(self.value.index).is_empty() {
            return Ok(None);
        }
        let within = |column: &Column, [low, high]: [f64; 2]| {
            let value = table.required_number(row, column)?;
            let cell = row.cell(column.index);
            let problem = if value <= 0.0 {
                format!(
                    "{}: {cell} is impossible: it must be above zero (absolute zero for a temperature)",
                    column.name
                )
            } else if value < low || value > high {
                let unit = column.unit.dimension().si_unit();
                let range = Bounds::closed(low, high).describe(&unit);
                format!(
                    "{}: {cell} is far from any lubricant: it must be {range}",
                    column.name
                )
            } else {
                return Ok(value);
            };
            Err(table.error(row, column.index, problem))
        };
        let mut pressure = table.required_number(row, &self.pressure)?;
        if self.absolute {
            pressure -= STANDARD_ATMOSPHERE;
        }
        let problem = if pressure < -STANDARD_ATMOSPHERE {
            Some("is below vacuum".to_owned())
        } else if pressure > LARGEST_PRESSURE {
            Some(format!("is above {LARGEST_PRESSURE:e} Pa"))
        } else {
            None
        };
        if let Some(problem) = problem {
            let cell = row.cell(self.pressure.index);
            let problem = format!("{}: {cell} {problem}", self.pressure.name);
            return Err(table.error(row, self.pressure.index, problem));
        }
        Ok(Some(State {
            pressure,
            temperature: within(&self.temperature, TEMPERATURES)?,
            value: within(&self.value, self.values)?,
            line: row.line,
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn error(text: &str) -> DataError {
        Data::parse("d.csv", text, Property::Viscosity).unwrap_err()
    }

    #[test]
    fn both_spellings_of_a_header_are_read() {
        for header in [
            "pressure_MPa,temperature_degC,viscosity_mPa_s",
            "Pressure [MPa]; Temperature [°C]; Viscosity [mPa.s]; remark",
            "pressure_MPa\ttemperature_degC\tviscosity_cP",
        ] {
            let separator = [';', '\t', ',']
                .into_iter()
                .find(|c| header.contains(*c))
                .unwrap();
            let rows = "100,40,2\n200,40,\n".replace(',', &separator.to_string());
            let text = format!("# from somewhere\n{header}\n\n{rows}");
            let data = Data::parse("d.csv", &text, Property::Viscosity).unwrap();
            let [state] = data.states[..] else {
                panic!("{data:?}")
            };
            assert_eq!((state.pressure, state.value), (1e8, 2e-3));
            assert_eq!(state.temperature, 313.15);
        }
        let text = "density_kg_per_m3,absolute_pressure_bar,temperature_K\n900,1.01325,300\n";
        let data = Data::parse("d.csv", text, Property::Density).unwrap();
        assert_eq!(data.states[0].value, 900.0);
        assert!(data.states[0].pressure.abs() < 1e-9);
    }

    #[test]
    fn errors_name_line_column_and_choices() {
        let head = "pressure_MPa,temperature_K,viscosity_mPa_s\n";
        for (text, line, column, part) in [
            ("", 1, 1, "pressure_MPa"),
            (
                "pressure_MPa,temperature_K\n1,2\n",
                1,
                1,
                "no column `viscosity`",
            ),
            (
                "pressure_MPa,temperature_K,viscosity\n",
                1,
                3,
                "Pa.s, mPa.s, cP",
            ),
            ("pressure_MPa,temperature_N,viscosity_cP\n", 1, 2, "K, degC"),
            ("pressure_MPa,temperature_K,viscosity_mPas\n", 1, 3, "mPa.s"),
            (head, 1, 1, "no states"),
            (
                &format!("{head}1,300,2\n\n1,3OO,2\n"),
                4,
                2,
                "`3OO` is not a number",
            ),
            (&format!("{head}1,300,-2\n"), 2, 3, "above zero"),
            (&format!("{head}1,-300,2\n"), 2, 2, "above zero"),
            (&format!("{head}-5,300,2\n"), 2, 1, "below vacuum"),
            (&format!("{head}nan,300,2\n"), 2, 1, "not a number"),
            (&format!("{head}1,300,inf\n"), 2, 3, "not a number"),
            (&format!("{head}1e305,300,2\n"), 2, 1, "not a number"),
            (
                &format!("{head}1,1e15,2\n"),
                2,
                2,
                "between 1 K and 10000 K",
            ),
            (
                &format!("{head}1,300,1e-200\n"),
                2,
                3,
                "far from any lubricant",
            ),
            (&format!("{head}1e9,300,1\n"), 2, 1, "above 1e12 Pa"),
            (
                "pressure_MPa,temperature_K,viscosity_cP,viscosity [Pa.s]\n",
                1,
                4,
                "second column",
            ),
        ] {
            let error = error(text);
            assert_eq!((error.line, error.column), (line, column), "{error}");
            assert!(error.to_string().contains(part), "{error}");
        }
    }
}
