//! Conductivity laws from a table.

use super::{Files, Material, locate, property::Reader, reference_temperature, required_density};
use crate::conductivity::{LarssonAndersson, Scaling, ScalingConstants};
use crate::{ConductivityLaw, DensityLaw};
use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::Dimension;

const DIMENSION: Dimension = Dimension::THERMAL_CONDUCTIVITY;

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
        let reader = Reader {
            name: "thermal conductivity",
            dimension: DIMENSION,
            larsson_andersson,
            scaling: |table: &mut Table<'_>| scaling(table, density),
        };
        reader.read(table, key, material, files)
    }
}

fn larsson_andersson(table: &mut Table<'_>) -> Result<LarssonAndersson, InputError> {
    let k_0 = table.required_quantity("k_0", DIMENSION, Bounds::POSITIVE)?;
    let mut read =
        |key: &str| table.required_quantity(key, Dimension::INVERSE_PRESSURE, Bounds::NON_NEGATIVE);
    let (d_1, d_2) = (read("d_1")?, read("d_2")?);
    LarssonAndersson::new(k_0, d_1, d_2).map_err(locate(table))
}

fn scaling(table: &mut Table<'_>, density: Option<&DensityLaw>) -> Result<Scaling, InputError> {
    let constants = ScalingConstants {
        b: table.required_quantity("b", DIMENSION, Bounds::NON_NEGATIVE)?,
        c: table.required_quantity("c", DIMENSION, Bounds::POSITIVE)?,
        s: table.required_number("s", Bounds::POSITIVE)?,
        a: table.required_number("a", Bounds::above_to(-0.5, 10.0))?,
        q: table.required_number("q", Bounds::ANY)?,
        reference_temperature: reference_temperature(table)?,
    };
    let density = required_density(table, density, "a function of the volume")?;
    Scaling::new(constants, density).map_err(locate(table))
}
