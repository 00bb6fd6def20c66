//! Density laws from a table.

use super::{
    Files, coefficient_of_temperature, group, locate, reference_temperature,
    table::{Columns, Pressures},
};
use crate::density::{
    BulkModulusSoftening, DowsonHigginson, Murnaghan, Tait, TaitVolume, ThermalExpansion,
};
use crate::{DensityLaw, Isotherms};
use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::Dimension;

laws! {
    Constant = "constant",
    DowsonHigginson = "dowson-higginson",
    Tait = "tait",
    Murnaghan = "murnaghan",
    Table = "table",
}

impl DensityLaw {
    /// Reads a law from a table such as `{ law = "dowson-higginson", rho_0 = "870 kg/m^3" }` and refuses unknown keys.
    ///
    /// | law | keys |
    /// |---|---|
    /// | `constant` | `rho_0` |
    /// | `dowson-higginson` | `rho_0`; optional `c_1`, `c_2`; optional together `reference_temperature`, `beta` |
    /// | `tait` | `rho_0`, `k_0r`, `k_0r_prime`; optional together `reference_temperature`, `beta_k`, `beta_k_prime`, `a_v` |
    /// | `murnaghan` | as `tait` |
    /// | `table` | `file`, a CSV file; or `isotherms`, `units` |
    ///
    /// # Errors
    ///
    /// Unknown laws and keys, missing keys, wrong units and impossible values, each with its line.
    pub fn from_table(mut table: Table<'_>, files: Files<'_>) -> Result<Self, InputError> {
        let law = match table.required_choice("law", LAWS)? {
            Law::Constant => Self::constant(rho_0(&mut table)?).map_err(locate(&table))?,
            Law::DowsonHigginson => Self::DowsonHigginson(dowson_higginson(&mut table)?),
            Law::Tait => {
                let rho_0 = rho_0(&mut table)?;
                let volume = TaitVolume::read(&mut table)?;
                Self::Tait(Tait::new(rho_0, volume).map_err(locate(&table))?)
            }
            Law::Murnaghan => {
                let rho_0 = rho_0(&mut table)?;
                let (modulus, slope, thermal) = bulk_modulus(&mut table)?;
                let law = Murnaghan::new(rho_0, modulus, slope, thermal);
                Self::Murnaghan(law.map_err(locate(&table))?)
            }
            Law::Table => {
                let columns = Columns::read(
                    &mut table,
                    files,
                    "density",
                    Dimension::DENSITY,
                    Pressures::Required,
                )?;
                Self::Table(columns.law(&table, Isotherms::straight)?)
            }
        };
        table.finish()?;
        Ok(law)
    }
}

impl TaitVolume {
    /// Reads the keys of the Tait equation, `k_0r`, `k_0r_prime` and the temperature terms, from a table.
    ///
    /// # Errors
    ///
    /// Missing keys, wrong units and impossible values.
    pub(super) fn read(table: &mut Table<'_>) -> Result<Self, InputError> {
        let (bulk_modulus, bulk_modulus_slope, thermal) = bulk_modulus(table)?;
        Self::new(bulk_modulus, bulk_modulus_slope, thermal).map_err(locate(table))
    }
}

/// `k_0r`, `k_0r_prime` and the temperature terms.
fn bulk_modulus(
    table: &mut Table<'_>,
) -> Result<(f64, f64, Option<BulkModulusSoftening>), InputError> {
    let modulus = table.required_quantity("k_0r", Dimension::PRESSURE, Bounds::POSITIVE)?;
    let slope = table.required_number("k_0r_prime", Bounds::POSITIVE)?;
    let thermal = if group(
        table,
        &["reference_temperature", "beta_k", "beta_k_prime", "a_v"],
    )? {
        let per_kelvin = Dimension::INVERSE_TEMPERATURE;
        Some(BulkModulusSoftening {
            reference_temperature: reference_temperature(table)?,
            bulk_modulus_coefficient: table.required_quantity("beta_k", per_kelvin, Bounds::ANY)?,
            bulk_modulus_slope_coefficient: table.required_quantity(
                "beta_k_prime",
                per_kelvin,
                Bounds::ANY,
            )?,
            expansivity: table.required_quantity("a_v", per_kelvin, Bounds::NON_NEGATIVE)?,
        })
    } else {
        None
    };
    Ok((modulus, slope, thermal))
}

fn rho_0(table: &mut Table<'_>) -> Result<f64, InputError> {
    table.required_quantity("rho_0", Dimension::DENSITY, Bounds::POSITIVE)
}

fn dowson_higginson(table: &mut Table<'_>) -> Result<DowsonHigginson, InputError> {
    let rho_0 = rho_0(table)?;
    let per_pressure = Dimension::INVERSE_PRESSURE;
    let c_1 = table.optional_quantity("c_1", per_pressure, Bounds::NON_NEGATIVE)?;
    let c_2 = table.optional_quantity("c_2", per_pressure, Bounds::NON_NEGATIVE)?;
    let thermal = coefficient_of_temperature(table, "beta", Bounds::NON_NEGATIVE)?;
    let thermal = thermal.map(|(reference_temperature, beta)| ThermalExpansion {
        reference_temperature,
        temperature_coefficient: beta,
    });
    DowsonHigginson::with_constants(
        rho_0,
        c_1.unwrap_or(DowsonHigginson::COMPRESSIBILITY),
        c_2.unwrap_or(DowsonHigginson::SATURATION),
        thermal,
    )
    .map_err(locate(table))
}
