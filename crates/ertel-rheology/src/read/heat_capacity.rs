//! Heat capacity laws from a table.

use super::{
    Files, Material,
    density::reference_temperature,
    given_law, linear_factor, locate, required_density,
    table::{Columns, Pressures},
};
use crate::heat_capacity::{
    LarssonAndersson, Linear, Scaling, ScalingConstants, VolumetricConstants,
};
use crate::{DensityLaw, HeatCapacityLaw, Isotherms};
use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::Dimension;

const DIMENSION: Dimension = Dimension::SPECIFIC_HEAT;

laws! {
    Constant = "constant",
    Linear = "linear",
    LarssonAndersson = "larsson-andersson",
    Scaling = "scaling",
    Table = "table",
}

impl HeatCapacityLaw {
    /// Reads the law at `key` of `table`, `None` if there is none: a quantity such as `"1.7 kJ/(kg.K)"` for a constant,
    /// or a table such as `{ law = "table", file = "oil.csv" }`, whose unknown keys are refused. `density` is that of
    /// the same lubricant.
    ///
    /// | law | keys |
    /// |---|---|
    /// | `constant` | `c_0` |
    /// | `linear` | `c_0`, `reference_temperature`, `a_t`; optional `a_p` (lubricants) |
    /// | `larsson-andersson` | `rho_c_0`, `reference_temperature`, `beta_0`, `b_1`, `b_2`, `k_1`, `k_2` (lubricants) |
    /// | `scaling` | `rho_c_0`, `m`, `reference_temperature`; optional `w` (lubricants) |
    /// | `table` | `file`, a CSV file; or `isotherms`, `units`; pressures may be left out |
    ///
    /// # Errors
    ///
    /// Unknown laws and keys, missing keys, wrong units and impossible values, each with its line; a law per volume
    /// without a density law.
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
        let c_0 =
            |table: &mut Table<'_>| table.required_quantity("c_0", DIMENSION, Bounds::POSITIVE);
        let law = match table.required_choice("law", &material.suitable(LAWS))? {
            Law::Constant => Self::constant(c_0(table)?).map_err(locate(table))?,
            Law::Linear => {
                let c_0 = c_0(table)?;
                let factor = linear_factor(table, material)?;
                Self::Linear(Linear::new(c_0, factor).map_err(locate(table))?)
            }
            Law::LarssonAndersson => {
                let constants = volumetric_constants(table)?;
                let density = required_density(table, density, "per volume")?;
                let law = LarssonAndersson::new(constants, density);
                Self::LarssonAndersson(law.map_err(locate(table))?)
            }
            Law::Scaling => {
                let heat = Dimension::VOLUMETRIC_HEAT;
                let constants = ScalingConstants {
                    rho_c_0: table.required_quantity("rho_c_0", heat, Bounds::POSITIVE)?,
                    m: table.required_quantity("m", heat, Bounds::NON_NEGATIVE)?,
                    w: table
                        .optional_number("w", Bounds::NON_NEGATIVE)?
                        .unwrap_or(Scaling::VOLUME_EXPONENT),
                    reference_temperature: reference_temperature(table)?,
                };
                let density = required_density(table, density, "per volume")?;
                Self::Scaling(Scaling::new(constants, density).map_err(locate(table))?)
            }
            Law::Table => {
                let columns = Columns::read(
                    table,
                    files,
                    "heat capacity",
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

fn volumetric_constants(table: &mut Table<'_>) -> Result<VolumetricConstants, InputError> {
    let per_pressure = Dimension::INVERSE_PRESSURE;
    let squared = Dimension::INVERSE_PRESSURE_SQUARED;
    let positive = Bounds::NON_NEGATIVE;
    Ok(VolumetricConstants {
        rho_c_0: table.required_quantity(
            "rho_c_0",
            Dimension::VOLUMETRIC_HEAT,
            Bounds::POSITIVE,
        )?,
        reference_temperature: reference_temperature(table)?,
        beta_0: table.required_quantity("beta_0", Dimension::INVERSE_TEMPERATURE, Bounds::ANY)?,
        b_1: table.required_quantity("b_1", per_pressure, Bounds::ANY)?,
        b_2: table.required_quantity("b_2", squared, Bounds::ANY)?,
        k_1: table.required_quantity("k_1", per_pressure, positive)?,
        k_2: table.required_quantity("k_2", per_pressure, positive)?,
    })
}
