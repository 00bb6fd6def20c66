//! Measured states from a CSV file.

use ertel_rheology::quantity::{Dimension, STANDARD_ATMOSPHERE, Unit};

use super::csv::{cells, rows};

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

/// What is wrong with a file, and where.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{file}:{line}:{column}: {problem}")]
pub struct DataError {
    /// Name of the file.
    pub file: String,
    /// Line, from 1.
    pub line: usize,
    /// Column of the table, from 1.
    pub column: usize,
    /// What is wrong, with the choices.
    pub problem: String,
}

impl Data {
    /// Reads a table of states from the text of a CSV file.
    ///
    /// The first line that is neither empty nor a comment (`#`) names the columns with their units, as
    /// `pressure_MPa, temperature_degC, viscosity_mPa_s` or `pressure [MPa], temperature [degC], viscosity [mPa.s]`. Cells are
    /// separated by commas, semicolons or tabs. In names with underscores `_per_` divides: `density_kg_per_m3`. A column
    /// `absolute_pressure` is reduced by one standard atmosphere. Other columns are ignored; a state without a value is
    /// left out.
    ///
    /// # Errors
    ///
    /// Missing columns, units and numbers, with line and column; impossible values.
    pub fn parse(file: &str, text: &str, property: Property) -> Result<Self, DataError> {
        let at = |line, column, problem: String| DataError {
            file: file.to_owned(),
            line,
            column,
            problem,
        };
        let mut lines = rows(text);
        let (number, head, separator) = lines
            .next()
            .ok_or_else(|| at(1, 1, format!("the file is empty; {}", expected(property))))?;
        let header = Header::parse(head, separator, property)
            .map_err(|(column, problem)| at(number, column, problem))?;
        let mut states = Vec::new();
        for (number, line, _) in lines {
            let state = header
                .state(line, separator)
                .map_err(|(column, problem)| at(number, column, problem))?;
            states.extend(state);
        }
        if states.is_empty() {
            return Err(at(number, 1, "there are no states below the header".into()));
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

/// Place of a cell (from 1) and what is wrong with it.
pub(super) type Problem = (usize, String);

/// A column in use.
pub(super) struct Column {
    pub(super) index: usize,
    pub(super) name: &'static str,
    pub(super) unit: Unit,
}

impl Column {
    /// Its number among the cells of a line, in SI.
    pub(super) fn number(&self, cells: &[&str]) -> Result<f64, Problem> {
        let place = self.index + 1;
        let cell = cells.get(self.index).ok_or_else(|| {
            let problem = format!("there are only {} cells in this line", cells.len());
            (place, problem)
        })?;
        let number = cell.parse::<f64>().ok().filter(|number| number.is_finite());
        let number = number.ok_or_else(|| {
            let problem = format!(
                "{}: `{cell}` is not a number (write 1.5 or 2e-3)",
                self.name
            );
            (place, problem)
        })?;
        Ok(self.unit.to_si(number))
    }
}

struct Header {
    pressure: Column,
    absolute: bool,
    temperature: Column,
    value: Column,
}

impl Header {
    fn parse(line: &str, separator: char, property: Property) -> Result<Self, Problem> {
        let cells: Vec<&str> = cells(line, separator);
        let column = |name: &'static str, dimension| find(&cells, name, dimension);
        let need = |found: Option<Column>, name: &str| {
            found.ok_or_else(|| {
                let problem = format!(
                    "there is no column `{name}`; {}; the columns are {}",
                    expected(property),
                    cells.join(", ")
                );
                (1, problem)
            })
        };
        let pressure = column("pressure", Dimension::PRESSURE)?;
        let absolute = column("absolute pressure", Dimension::PRESSURE)?;
        let (pressure, absolute) = match (pressure, absolute) {
            (Some(_), Some(second)) => {
                let problem = "give `pressure` or `absolute_pressure`, not both";
                return Err((second.index + 1, problem.into()));
            }
            (None, Some(absolute)) => (absolute, true),
            (pressure, None) => (need(pressure, "pressure")?, false),
        };
        let temperature = column("temperature", Dimension::TEMPERATURE)?;
        let value = column(property.name(), property.dimension())?;
        Ok(Self {
            pressure,
            absolute,
            temperature: need(temperature, "temperature")?,
            value: need(value, property.name())?,
        })
    }

    /// The state of a line; `None` if the value is left out.
    fn state(&self, line: &str, separator: char) -> Result<Option<State>, Problem> {
        let cells: Vec<&str> = cells(line, separator);
        if cells
            .get(self.value.index)
            .is_none_or(|cell| cell.is_empty())
        {
            return Ok(None);
        }
        let positive = |column: &Column| {
            let value = column.number(&cells)?;
            if value > 0.0 {
                Ok(value)
            } else {
                let problem = format!(
                    "{}: {} is impossible: it must be above zero (absolute zero for a temperature)",
                    column.name, cells[column.index]
                );
                Err((column.index + 1, problem))
            }
        };
        let mut pressure = self.pressure.number(&cells)?;
        if self.absolute {
            pressure -= STANDARD_ATMOSPHERE;
        }
        if pressure < -STANDARD_ATMOSPHERE {
            let problem = format!(
                "{}: {} is below vacuum",
                self.pressure.name, cells[self.pressure.index]
            );
            return Err((self.pressure.index + 1, problem));
        }
        Ok(Some(State {
            pressure,
            temperature: positive(&self.temperature)?,
            value: positive(&self.value)?,
        }))
    }
}

/// The column `name` among the titles; `None` if there is none.
fn find(
    cells: &[&str],
    name: &'static str,
    dimension: Dimension,
) -> Result<Option<Column>, Problem> {
    let mut found = None;
    for (index, cell) in cells.iter().enumerate() {
        let Some(unit) = unit_text(cell, name) else {
            continue;
        };
        if found.is_some() {
            return Err((index + 1, format!("there is a second column `{name}`")));
        }
        let units = format!("write one of {}", dimension.examples());
        if unit.is_empty() {
            let problem = format!(
                "the column `{cell}` has no unit; {units}, as in `{}_{}`",
                name.replace(' ', "_"),
                dimension
                    .si_unit()
                    .replace(['.', ' '], "_")
                    .replace('/', "_per_")
                    .replace('^', "")
            );
            return Err((index + 1, problem));
        }
        let unit = Unit::parse(&unit)
            .map_err(|error| (index + 1, format!("the column `{cell}`: {error}; {units}")))?;
        if !unit.dimension().same_exponents(dimension) {
            let problem = format!(
                "the column `{cell}` has a unit of {}, but {} is needed; {units}",
                unit.dimension().name(),
                dimension.name()
            );
            return Err((index + 1, problem));
        }
        found = Some(Column { index, name, unit });
    }
    Ok(found)
}

/// Text of the unit if the title is that of the column `name`: `MPa` of `Pressure_MPa`, `pressure [MPa]`, `pressure (MPa)`.
pub(super) fn unit_text(title: &str, name: &str) -> Option<String> {
    let head = title.get(..name.len())?;
    if !head.replace('_', " ").eq_ignore_ascii_case(name) {
        return None;
    }
    let rest = &title[name.len()..];
    let bracketed = rest.trim().strip_prefix(['[', '(']);
    if let Some(unit) = bracketed {
        let unit = unit.trim_end();
        return Some(unit.strip_suffix([']', ')']).unwrap_or(unit).to_owned());
    }
    match rest.strip_prefix(['_', ' ']) {
        Some(unit) => Some(unit.replace("_per_", "/").replace('_', " ")),
        None => rest.is_empty().then(String::new),
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
        ] {
            let error = error(text);
            assert_eq!((error.line, error.column), (line, column), "{error}");
            assert!(error.to_string().contains(part), "{error}");
        }
    }
}
