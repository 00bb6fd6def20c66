//! Measured states from a CSV file.

use ertel_input::csv::{Column, CsvParams, CsvTable, Row, Vocabulary, line_list};
use ertel_quantity::{Dimension, STANDARD_ATMOSPHERE};

pub use ertel_input::csv::CsvError as DataError;
use ertel_input::{Bounds, excerpt};

use crate::case::question_of_state;

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
    /// What was left out, and what is doubted.
    pub notes: Vec<String>,
}

impl Data {
    /// Reads a table of states from the text of a file.
    ///
    /// The file is a table of [`ertel_input::csv`] whose columns have units, as `pressure_MPa, temperature_degC,
    /// viscosity_mPa_s` or `Druck / bar; Temperatur / °C; dyn. Viskosität / mPas`. Absolute pressures are reduced by one standard
    /// atmosphere; a kinematic viscosity is multiplied by a density that stands beside it. Other columns are ignored; a state
    /// without a value is left out.
    ///
    /// # Errors
    ///
    /// Missing columns, units and numbers, with line and column; impossible values.
    pub fn parse(file: &str, text: &str, property: Property) -> Result<Self, DataError> {
        Self::parse_with(file, text, property, &CsvParams::default())
    }

    /// The same with what the user tells about the table.
    ///
    /// # Errors
    ///
    /// As [`Data::parse`]; columns that the user names and that are not there.
    pub fn parse_with(
        file: &str,
        text: &str,
        property: Property,
        params: &CsvParams,
    ) -> Result<Self, DataError> {
        let names = [&COLUMNS[..], &[property.name()]].concat();
        let vocabulary = Vocabulary {
            names: &names,
            is_key: &|_| false,
        };
        let table = CsvTable::parse_for(file, text, &vocabulary, params).map_err(|mut error| {
            if error.line == 1 && error.problem.contains("empty") {
                error.problem += &format!("; {}", expected(property));
            }
            error
        })?;
        let header = Header::of(&table, property)?;
        let mut states = Vec::new();
        let mut left_out = Vec::new();
        for row in table.rows() {
            match header.state(&table, row)? {
                Some(state) => states.push(state),
                None => left_out.push(row.line),
            }
        }
        if states.is_empty() {
            let problem = "there are no states below the header";
            return Err(table.error(table.header(), 0, problem));
        }
        let mut notes = table.notes().to_vec();
        if !left_out.is_empty() {
            let name = property.name();
            notes.push(format!("no {name} stands in {}", line_list(&left_out)));
        }
        if let Some(column) = &header.density {
            let title = excerpt(table.header().cell(column.index));
            notes.push(format!(
                "the kinematic viscosity is multiplied by the density of column `{title}`"
            ));
        }
        notes.extend(question(property, &states));
        Ok(Self {
            file: file.to_owned(),
            property,
            states,
            notes,
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
        "a line names the columns with their units, such as `pressure_MPa, temperature_K, {value}` (or \
         `absolute_pressure_MPa`); or tell where they stand, such as `--column {}=\"Title of the column:{}\"`",
        property.name(),
        property.dimension().si_unit()
    )
}

/// Values beyond which no lubricant was measured; the laws' numbers leave floating point far from there.
const TEMPERATURES: [f64; 2] = [1.0, 1e4];
const LARGEST_PRESSURE: f64 = 1e12;
const VISCOSITIES: [f64; 2] = [1e-9, 1e30];
const KINEMATIC_VISCOSITIES: [f64; 2] = [1e-12, 1e27];
const DENSITIES: [f64; 2] = [1e-6, 1e6];

/// The column of a kinematic viscosity where there is none of a dynamic one.
fn kinematic(table: &CsvTable) -> Result<Option<Column>, DataError> {
    if table.find("viscosity", Dimension::VISCOSITY)?.is_some() {
        return Ok(None);
    }
    for name in ["viscosity", "kinematic viscosity"] {
        if let Some(column) = table.find(name, Dimension::KINEMATIC_VISCOSITY)? {
            return Ok(Some(column));
        }
    }
    Ok(None)
}

/// Columns of every table of states, by the names of the program.
const COLUMNS: [&str; 5] = [
    "pressure",
    "absolute pressure",
    "temperature",
    "kinematic viscosity",
    "density",
];

/// Pressure (Pa) up to which a state counts as one at ambient pressure, where it is known what is usual.
const LOW_PRESSURE: f64 = 1e7;

/// Asks about the state at the lowest pressure that is farthest from what is usual.
fn question(property: Property, states: &[State]) -> Option<String> {
    let low = states.iter().filter(|state| state.pressure <= LOW_PRESSURE);
    let asked = low.filter_map(|state| {
        let what = format!("{} in line {}", property.name(), state.line);
        question_of_state(&what, state.value, property.dimension())
    });
    let worst = asked.max_by(|a, b| a.excess.total_cmp(&b.excess))?;
    Some(worst.text)
}

struct Header {
    pressure: Column,
    absolute: bool,
    temperature: Column,
    value: Column,
    /// The density that a kinematic viscosity is multiplied by.
    density: Option<Column>,
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
        // By its unit first: a pressure without one may be the absolute one.
        let absolute = table.find("absolute pressure", Dimension::PRESSURE)?;
        let gauge = match absolute {
            Some(_) => table.find("pressure", Dimension::PRESSURE)?,
            None => find("pressure", Dimension::PRESSURE)?,
        };
        let (pressure, absolute) = match (gauge, absolute) {
            (Some(_), Some(second)) => {
                let problem = "give `pressure` or `absolute_pressure`, not both";
                return Err(table.error(table.header(), second.index, problem));
            }
            (None, Some(absolute)) => (absolute, true),
            (None, None) => match find("absolute pressure", Dimension::PRESSURE)? {
                Some(absolute) => (absolute, true),
                None => (need(None, "pressure")?, false),
            },
            (pressure, None) => (need(pressure, "pressure")?, false),
        };
        let temperature = find("temperature", Dimension::TEMPERATURE)?;
        let (value, density) = match (property, kinematic(table)?) {
            (Property::Viscosity, Some(value)) => {
                let density = table.find("density", Dimension::DENSITY)?;
                if density.is_none() {
                    let problem = format!(
                        "the column `{}` is a kinematic viscosity; a law of the dynamic viscosity μ = ρ ν needs the density of each \
                         state, too: add a column such as `density_kg_per_m3`",
                        excerpt(table.header().cell(value.index))
                    );
                    return Err(table.error(table.header(), value.index, problem));
                }
                (Some(value), density)
            }
            (Property::Viscosity | Property::Density, _) => {
                (find(property.name(), property.dimension())?, None)
            }
        };
        Ok(Self {
            pressure,
            absolute,
            temperature: need(temperature, "temperature")?,
            value: need(value, property.name())?,
            density,
            values: match property {
                Property::Viscosity => VISCOSITIES,
                Property::Density => DENSITIES,
            },
        })
    }

    /// The state of a line; `None` if the value is left out.
    fn state(&self, table: &CsvTable, row: &Row) -> Result<Option<State>, DataError> {
        let is_missing = |column: &Column| table.is_missing(row, column.index);
        if is_missing(&self.value) || self.density.as_ref().is_some_and(is_missing) {
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
            value: match &self.density {
                Some(density) => {
                    within(density, DENSITIES)? * within(&self.value, KINEMATIC_VISCOSITIES)?
                }
                None => within(&self.value, self.values)?,
            },
            line: row.line,
        }))
    }
}

#[cfg(test)]
#[path = "data_tests.rs"]
mod spellings;

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
            (
                "pressure_MPa,temperature_K,viscosity_furlong\n",
                1,
                3,
                "mPa.s",
            ),
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
