//! Heat capacity laws from a table.

use super::{Files, Material, locate, property::Reader, reference_temperature, required_density};
use crate::heat_capacity::{LarssonAndersson, Scaling, ScalingConstants, VolumetricConstants};
use crate::{DensityLaw, HeatCapacityLaw};
use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::Dimension;

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
        let reader = Reader {
            name: "heat capacity",
            dimension: Dimension::SPECIFIC_HEAT,
            larsson_andersson: |table: &mut Table<'_>| larsson_andersson(table, density),
            scaling: |table: &mut Table<'_>| scaling(table, density),
        };
        reader.read(table, key, material, files)
    }
}

fn larsson_andersson(
    table: &mut Table<'_>,
    density: Option<&DensityLaw>,
) -> Result<LarssonAndersson, InputError> {
    let constants = volumetric_constants(table)?;
    let density = required_density(table, density, "per volume")?;
    LarssonAndersson::new(constants, density).map_err(locate(table))
}

fn scaling(table: &mut Table<'_>, density: Option<&DensityLaw>) -> Result<Scaling, InputError> {
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
    Scaling::new(constants, density).map_err(locate(table))
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
