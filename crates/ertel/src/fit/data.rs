//! Measured states from a CSV file.

use ertel_input::csv::{CsvParams, CsvTable, Vocabulary, line_list};

pub use ertel_input::csv::CsvError as DataError;

use super::header::{Header, expected};
use super::state::{Property, Reading, State};
use crate::case::question_of_state;

/// Measured states.
#[derive(Clone, Debug, PartialEq)]
pub struct Data {
    /// Name of the file.
    pub file: String,
    /// The measured property.
    pub property: Property,
    /// The states, in the order of the file.
    pub states: Vec<State>,
    /// Omitted states, and doubtful ones.
    pub notes: Vec<String>,
}

impl Data {
    /// Reads a table of states from the text of a file.
    ///
    /// The file is a table of [`ertel_input::csv`] whose columns have units, as `pressure_MPa, temperature_degC,
    /// viscosity_mPa_s` or `Druck / bar; Temperatur / °C; dyn. Viskosität / mPas`. Absolute pressures are reduced by one standard
    /// atmosphere; a kinematic viscosity is multiplied by the density in the same row. Other columns are ignored; a state
    /// without a value is omitted.
    ///
    /// # Errors
    ///
    /// Missing columns, units and numbers, with line and column; impossible values.
    pub fn parse(file: &str, text: &str, property: Property) -> Result<Self, DataError> {
        Self::parse_with(file, text, property, &CsvParams::default())
    }

    /// The same with the column options of the user.
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
        let reading = Reading {
            table: params.clone(),
            ..Reading::default()
        };
        Self::read(file, text, property, &reading)
    }

    /// The same with all options.
    ///
    /// # Errors
    ///
    /// As [`Data::parse_with`].
    pub fn read(
        file: &str,
        text: &str,
        property: Property,
        reading: &Reading,
    ) -> Result<Self, DataError> {
        let names = [&COLUMNS[..], &[property.name()]].concat();
        let vocabulary = Vocabulary {
            names: &names,
            is_key: &|_| false,
        };
        let table =
            CsvTable::parse_for(file, text, &vocabulary, &reading.table).map_err(|mut error| {
                if error.line == 1 && error.problem.contains("empty") {
                    error.problem += &format!("; {}", expected(property));
                }
                error
            })?;
        let header = Header::of(&table, property, reading)?;
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
            notes.push(format!("no {name} in {}", line_list(&left_out)));
        }
        if header.is_ambient() {
            notes.push(
                "there is no column `pressure`: all states count as measured at ambient pressure"
                    .to_owned(),
            );
        }
        notes.extend(header.density_note(&table));
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
