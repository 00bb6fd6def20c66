//! Conductivity laws from a table.

use super::{
    Files, Material,
    density::reference_temperature,
    given_law, linear_factor, locate, required_density,
    table::{Columns, Pressures},
};
use crate::conductivity::{LarssonAndersson, Linear, Scaling, ScalingConstants};
use crate::{ConductivityLaw, DensityLaw, Isotherms};
use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::Dimension;

const DIMENSION: Dimension = Dimension::THERMAL_CONDUCTIVITY;

laws! {
    Constant = "constant",
    Linear = "linear",
    LarssonAndersson = "larsson-andersson",
    Scaling = "scaling",
    Table = "table",
}

impl ConductivityLaw {
    /// Reads the law at `key` of `table`, `None` if there is none: a quantity such as `"0.13 W/(m.K)"` for a constant,
    /// or a table such as `{ law = "table", file = "oil.csv" }`, whose unknown keys are refused. `density` is that of the
    /// same lubricant.
    ///
    /// | law | keys |
    /// |---|---|
    /// | `constant` | `k_0` |
    /// | `linear` | `k_0`, `reference_temperature`, `a_t`; optional `a_p` (lubricants) |
    /// | `larsson-andersson` | `k_0`, `d_1`, `d_2` (lubricants) |
    /// | `scaling` | `b`, `c`, `s`, `a`, `q`, `reference_temperature` (lubricants) |
    /// | `table` | `file`, a CSV file; or `isotherms`, `units`; pressures may be left out |
    ///
    /// # Errors
    ///
    /// Unknown laws and keys, missing keys, wrong units and impossible values, each with its line.
    pub fn read(
        table: &mut Table<'_>,
        key: &str,
        material: Material,
        density: Option<&DensityLaw>,
        files: Files<'_>,
    ) -> Result<Option<Self>, InputError> {
        let Some(mut inner) = given_law(table, key)? else {
            let value = table.optional_quantity(key, DIMENSION, Bounds::POSITIVE)?;
            let law = value.map(Self::constant).transpose();
            return law.map_err(|error| table.error(key, error.to_string()));
        };
        let table = &mut inner;
        let k_0 =
            |table: &mut Table<'_>| table.required_quantity("k_0", DIMENSION, Bounds::POSITIVE);
        let law = match table.required_choice("law", &material.suitable(LAWS))? {
            Law::Constant => Self::constant(k_0(table)?).map_err(locate(table))?,
            Law::Linear => {
                let k_0 = k_0(table)?;
                let factor = linear_factor(table, material)?;
                Self::Linear(Linear::new(k_0, factor).map_err(locate(table))?)
            }
            Law::LarssonAndersson => {
                let k_0 = k_0(table)?;
                let mut read = |key: &str| {
                    table.required_quantity(key, Dimension::INVERSE_PRESSURE, Bounds::NON_NEGATIVE)
                };
                let (d_1, d_2) = (read("d_1")?, read("d_2")?);
                let law = LarssonAndersson::new(k_0, d_1, d_2);
                Self::LarssonAndersson(law.map_err(locate(table))?)
            }
            Law::Scaling => {
                let constants = ScalingConstants {
                    b: table.required_quantity("b", DIMENSION, Bounds::NON_NEGATIVE)?,
                    c: table.required_quantity("c", DIMENSION, Bounds::POSITIVE)?,
                    s: table.required_number("s", Bounds::POSITIVE)?,
                    a: table.required_number("a", Bounds::above_to(-0.5, 10.0))?,
                    q: table.required_number("q", Bounds::ANY)?,
                    reference_temperature: reference_temperature(table)?,
                };
                let density = required_density(table, density, "a function of the volume")?;
                Self::Scaling(Scaling::new(constants, density).map_err(locate(table))?)
            }
            Law::Table => {
                let columns = Columns::read(
                    table,
                    files,
                    "thermal conductivity",
                    DIMENSION,
                    Pressures::Optional,
                )?;
                Self::Table(columns.law(table, Isotherms::held)?)
            }
        };
        inner.finish()?;
        Ok(Some(law))
    }
}
