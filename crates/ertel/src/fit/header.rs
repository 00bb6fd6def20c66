//! The columns of a table of states.

use ertel_input::csv::{Column, CsvTable, Row};
use ertel_input::{Bounds, excerpt};
use ertel_quantity::{Dimension, STANDARD_ATMOSPHERE};
use ertel_rheology::DensityLaw;

use super::DataError;
use super::state::{Property, Reading, State};

pub(super) fn expected(property: Property) -> String {
    let value = match property {
        Property::Viscosity => "viscosity_mPa_s",
        Property::Density => "density_kg_per_m3",
    };
    format!(
        "a line names the columns with their units, such as `pressure_MPa, temperature_K, {value}` (or \
         `absolute_pressure_MPa`); or assign them, such as `--column {}=\"Title of the column:{}\"`",
        property.name(),
        property.dimension().si_unit()
    )
}

/// Values beyond which no lubricant was measured; the laws overflow only far beyond them.
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

/// The columns in use.
pub(super) struct Header<'a> {
    /// `None` for a table at ambient pressure.
    pressure: Option<Column>,
    absolute: bool,
    temperature: Column,
    value: Column,
    /// Density by which a kinematic viscosity is multiplied.
    density: Option<Factor<'a>>,
    values: [f64; 2],
}

/// The density of a state.
enum Factor<'a> {
    /// Measured together with the viscosity.
    Column(Column),
    /// By a law.
    Law(&'a DensityLaw),
}

impl<'a> Header<'a> {
    pub(super) fn of(
        table: &CsvTable,
        property: Property,
        reading: &'a Reading,
    ) -> Result<Self, DataError> {
        let find = |name, dimension| table.find_with_unit(name, dimension);
        let need = |found: Option<Column>, name: &str| {
            found.ok_or_else(|| {
                let ambient = match (name, property) {
                    ("pressure", Property::Viscosity) => {
                        "; viscosities at ambient pressure alone are for the law `walther`"
                    }
                    _ => "",
                };
                let problem = format!(
                    "there is no column `{name}`; {}; the columns are {}{ambient}",
                    expected(property),
                    table.header().cells().join(", ")
                );
                table.error(table.header(), 0, problem)
            })
        };
        let (pressure, absolute) = table.find_pressure()?.unzip();
        if pressure.is_none() && !reading.may_be_ambient {
            need(None, "pressure")?;
        }
        if pressure.is_none()
            && let Some(other) = table.first_with_unit(Dimension::PRESSURE)
        {
            let cell = excerpt(table.header().cell(other));
            let problem = format!(
                "there is no column `pressure`, but `{cell}` has a unit of pressure: if it is the pressure of the states, specify it: \
                 `--column \"pressure=#{}\"`; otherwise omit the column",
                other + 1
            );
            return Err(table.error(table.header(), other, problem));
        }
        let temperature = find("temperature", Dimension::TEMPERATURE)?;
        let (value, density) = match (property, kinematic(table)?) {
            (Property::Viscosity, Some(value)) => {
                let column = table
                    .find("density", Dimension::DENSITY)?
                    .map(Factor::Column);
                let density = column.or(reading.density.as_ref().map(Factor::Law));
                if density.is_none() {
                    let problem = format!(
                        "the column `{}` is a kinematic viscosity; a law of the dynamic viscosity μ = ρ ν needs the density of each \
                         state, too: add a column such as `density_kg_per_m3`, or give the density of the fluid (`--density`)",
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
            absolute: absolute.unwrap_or(false),
            temperature: need(temperature, "temperature")?,
            value: need(value, property.name())?,
            density,
            values: match property {
                Property::Viscosity => VISCOSITIES,
                Property::Density => DENSITIES,
            },
        })
    }

    /// Whether there is no column of pressures.
    pub(super) fn is_ambient(&self) -> bool {
        self.pressure.is_none()
    }

    /// Note on the density by which a kinematic viscosity was multiplied.
    pub(super) fn density_note(&self, table: &CsvTable) -> Option<String> {
        let by = match self.density.as_ref()? {
            Factor::Column(column) => {
                let title = excerpt(table.header().cell(column.index));
                format!("the density of column `{title}`")
            }
            Factor::Law(law) => format!("the density of the law {} that is given", law.name()),
        };
        Some(format!("the kinematic viscosity is multiplied by {by}"))
    }

    /// The state of a line; `None` if the value is missing.
    pub(super) fn state(&self, table: &CsvTable, row: &Row) -> Result<Option<State>, DataError> {
        let is_missing = |column: &Column| table.is_missing(row, column.index);
        let density_is_missing =
            matches!(&self.density, Some(Factor::Column(column)) if is_missing(column));
        if is_missing(&self.value) || density_is_missing {
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
        let pressure = match &self.pressure {
            Some(column) => self.pressure(table, row, column)?,
            None => 0.0,
        };
        let temperature = within(&self.temperature, TEMPERATURES)?;
        let density = match &self.density {
            None => None,
            Some(Factor::Column(column)) => Some(within(column, DENSITIES)?),
            Some(Factor::Law(law)) => {
                let density = law.density(pressure, temperature);
                if !Bounds::closed(DENSITIES[0], DENSITIES[1]).contains(density) {
                    let problem = format!(
                        "the law {} of the density gives {density:.3e} kg/m^3 here",
                        law.name()
                    );
                    return Err(table.error(row, self.value.index, problem));
                }
                Some(density)
            }
        };
        Ok(Some(State {
            pressure,
            temperature,
            value: match density {
                Some(density) => density * within(&self.value, KINEMATIC_VISCOSITIES)?,
                None => within(&self.value, self.values)?,
            },
            line: row.line,
        }))
    }

    /// The pressure of a line above ambient, Pa.
    fn pressure(&self, table: &CsvTable, row: &Row, column: &Column) -> Result<f64, DataError> {
        let mut pressure = table.required_number(row, column)?;
        if self.absolute {
            pressure -= STANDARD_ATMOSPHERE;
        }
        let problem = if pressure < -STANDARD_ATMOSPHERE {
            "is below vacuum".to_owned()
        } else if pressure > LARGEST_PRESSURE {
            format!("is above {LARGEST_PRESSURE:e} Pa")
        } else {
            return Ok(pressure);
        };
        let problem = format!("{}: {} {problem}", column.name, row.cell(column.index));
        Err(table.error(row, column.index, problem))
    }
}
