//! Viscosity laws from a table.

use super::{
    Files, coefficient_of_temperature, locate, reference_temperature, required_density,
    table::{Columns, Pressures},
};
use crate::density::TaitVolume;
use crate::viscosity::{
    Barus, Cheng, Doolittle, GlassTransition, Hybrid, ImprovedYasutomi, McEwen, ModifiedWlf,
    OccupiedVolume, Paluch, PressureLaw, Roelands, TemperatureSlope, Walther,
};
use crate::{DensityLaw, Isotherms, ViscosityLaw};
use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::Dimension;

laws! {
    Constant = "constant",
    Barus = "barus",
    Cheng = "cheng",
    Roelands = "roelands",
    ModifiedWlf = "wlf",
    Doolittle = "doolittle",
    ImprovedYasutomi = "yasutomi",
    McEwen = "mcewen",
    Paluch = "paluch",
    Hybrid = "mcewen-paluch",
    Walther = "walther",
    Table = "table",
}

impl ViscosityLaw {
    /// Reads a law from a table such as `{ law = "roelands", mu_0 = "40 mPa.s", alpha = "22 1/GPa" }` and refuses
    /// unknown keys. `density` is that of the same fluid; it serves Doolittle's law where that has no
    /// separate `equation_of_state`.
    ///
    /// | law | keys |
    /// |---|---|
    /// | `constant` | `mu_0` |
    /// | `barus` | `mu_0`, `alpha` |
    /// | `cheng` | `mu_0`, `alpha`, `beta`, `gamma`, `reference_temperature` |
    /// | `roelands` | `mu_0`, `alpha` or `z`; optional `p_0`; optional together `reference_temperature`, `beta` |
    /// | `wlf` | `mu_g`, `t_g0`, `a_1`, `a_2`, `b_1`, `b_2`, `c_1`, `c_2` |
    /// | `doolittle` | `mu_0`, `b`, `r_0`; optional together `reference_temperature`, `epsilon`; `equation_of_state` with the keys of the density law `tait` except `rho_0` |
    /// | `yasutomi` | `mu_g`, `t_g0`, `a_1`, `a_2`, `b_1`, `b_2`, `c_1`, `c_2` |
    /// | `mcewen` | `mu_0`, `alpha`, `q` |
    /// | `paluch` | `mu_0` or `mu_inf`, `c_f`, `p_inf` |
    /// | `mcewen-paluch` | `mu_0`, `a_0`, `q`, `c_f`, `p_inf` |
    /// | `walther` | `a`, `b`, `alpha`, `reference_temperature`; optional `alpha_exponent`, `pressure` (`roelands` or `barus`); needs a density law |
    /// | `table` | `file`, a CSV file; or `isotherms`, `units` |
    ///
    /// # Errors
    ///
    /// Unknown laws and keys, missing keys, wrong units and impossible values, each with its line.
    pub fn from_table(
        mut table: Table<'_>,
        density: Option<&DensityLaw>,
        files: Files<'_>,
    ) -> Result<Self, InputError> {
        let law = match table.required_choice("law", LAWS)? {
            Law::Constant => Self::constant(mu_0(&mut table)?).map_err(locate(&table))?,
            Law::Barus => {
                let (mu_0, alpha) = (mu_0(&mut table)?, alpha(&mut table)?);
                Self::Barus(Barus::new(mu_0, alpha).map_err(locate(&table))?)
            }
            Law::Cheng => Self::Cheng(cheng(&mut table)?),
            Law::Roelands => Self::Roelands(roelands(&mut table)?),
            Law::ModifiedWlf => Self::ModifiedWlf(wlf(&mut table)?),
            Law::Doolittle => Self::Doolittle(doolittle(&mut table, density)?),
            Law::ImprovedYasutomi => Self::ImprovedYasutomi(yasutomi(&mut table)?),
            Law::McEwen => {
                let (mu_0, alpha) = (mu_0(&mut table)?, alpha(&mut table)?);
                let q = table.required_number("q", Bounds::POSITIVE)?;
                Self::McEwen(McEwen::new(mu_0, alpha, q).map_err(locate(&table))?)
            }
            Law::Paluch => Self::Paluch(paluch(&mut table)?),
            Law::Hybrid => Self::Hybrid(hybrid(&mut table)?),
            Law::Walther => Self::Walther(walther(&mut table, density)?),
            Law::Table => {
                let columns = Columns::read(
                    &mut table,
                    files,
                    "viscosity",
                    Dimension::VISCOSITY,
                    Pressures::Required,
                )?;
                Self::Table(columns.law(&table, Isotherms::of_logarithms)?)
            }
        };
        table.finish()?;
        Ok(law)
    }
}

fn mu_0(table: &mut Table<'_>) -> Result<f64, InputError> {
    table.required_quantity("mu_0", Dimension::VISCOSITY, Bounds::POSITIVE)
}

fn alpha(table: &mut Table<'_>) -> Result<f64, InputError> {
    table.required_quantity("alpha", Dimension::INVERSE_PRESSURE, Bounds::NON_NEGATIVE)
}

/// Whether a table has the second of two keys, of which one follows from the other.
fn has_second(table: &mut Table<'_>, first: &str, second: &str) -> Result<bool, InputError> {
    match (table.contains(first), table.contains(second)) {
        (true, true) => Err(table.error(
            second,
            format!("`{first}` and `{second}` say the same thing: give one of them"),
        )),
        (false, true) => Ok(true),
        (true | false, false) => Ok(false),
    }
}

fn cheng(table: &mut Table<'_>) -> Result<Cheng, InputError> {
    let mu_0 = mu_0(table)?;
    let alpha = table.required_quantity("alpha", Dimension::INVERSE_PRESSURE, Bounds::ANY)?;
    let beta = table.required_quantity("beta", Dimension::TEMPERATURE_DIFFERENCE, Bounds::ANY)?;
    let gamma =
        table.required_quantity("gamma", Dimension::TEMPERATURE_PER_PRESSURE, Bounds::ANY)?;
    let reference_temperature = reference_temperature(table)?;
    Cheng::new(mu_0, alpha, beta, gamma, reference_temperature).map_err(locate(table))
}

fn roelands(table: &mut Table<'_>) -> Result<Roelands, InputError> {
    let mu_0 = mu_0(table)?;
    let p_0 = table
        .optional_quantity("p_0", Dimension::PRESSURE, Bounds::POSITIVE)?
        .unwrap_or(Roelands::PRESSURE_CONSTANT);
    let thermal = coefficient_of_temperature(table, "beta", Bounds::NON_NEGATIVE)?;
    let thermal = thermal.map(|(reference_temperature, beta)| TemperatureSlope {
        reference_temperature,
        beta,
    });
    match has_second(table, "alpha", "z")? {
        true => {
            let z = table.required_number("z", Bounds::NON_NEGATIVE)?;
            Roelands::from_index(mu_0, z, p_0, thermal).map_err(locate(table))
        }
        false => {
            let alpha = alpha(table)?;
            Roelands::from_alpha(mu_0, alpha, p_0, thermal).map_err(locate(table))
        }
    }
}

/// The keys of a law with a glass transition; `expansivity` reads `b_1` and `b_2` of `F`.
fn glass(
    table: &mut Table<'_>,
    expansivity: impl FnOnce(&mut Table<'_>) -> Result<[f64; 2], InputError>,
) -> Result<(GlassTransition, [f64; 2]), InputError> {
    let difference = Dimension::TEMPERATURE_DIFFERENCE;
    let mu_g = table.required_quantity("mu_g", Dimension::VISCOSITY, Bounds::POSITIVE)?;
    let t_g0 = table.required_quantity("t_g0", Dimension::TEMPERATURE, Bounds::POSITIVE)?;
    let a_1 = table.required_quantity("a_1", difference, Bounds::POSITIVE)?;
    let a_2 = table.required_quantity("a_2", Dimension::INVERSE_PRESSURE, Bounds::POSITIVE)?;
    let b = expansivity(table)?;
    let glass = GlassTransition {
        glass_viscosity: mu_g,
        glass_temperature: t_g0,
        a_1,
        a_2,
        c_1: table.required_number("c_1", Bounds::POSITIVE)?,
        c_2: table.required_quantity("c_2", difference, Bounds::POSITIVE)?,
    };
    Ok((glass, b))
}

fn wlf(table: &mut Table<'_>) -> Result<ModifiedWlf, InputError> {
    let (glass, [b_1, b_2]) = glass(table, |table| {
        Ok([
            table.required_number("b_1", Bounds::POSITIVE)?,
            table.required_quantity("b_2", Dimension::INVERSE_PRESSURE, Bounds::POSITIVE)?,
        ])
    })?;
    ModifiedWlf::new(ModifiedWlf { glass, b_1, b_2 }).map_err(locate(table))
}

fn doolittle(table: &mut Table<'_>, density: Option<&DensityLaw>) -> Result<Doolittle, InputError> {
    let mu_0 = mu_0(table)?;
    let b = table.required_number("b", Bounds::POSITIVE)?;
    let r_0 = table.required_number("r_0", Bounds::open(0.0, 1.0))?;
    let thermal = coefficient_of_temperature(table, "epsilon", Bounds::ANY)?;
    let thermal = thermal.map(|(reference_temperature, expansivity)| OccupiedVolume {
        reference_temperature,
        expansivity,
    });
    let volume = match (table.optional_table("equation_of_state")?, density) {
        (Some(mut equation), _) => {
            let volume = TaitVolume::read(&mut equation)?;
            equation.finish()?;
            volume
        }
        (None, Some(DensityLaw::Tait(tait))) => tait.volume.clone(),
        (None, _) => {
            return Err(table.missing("equation_of_state").with_help(
                "Doolittle's law needs the volume: give `equation_of_state = { k_0r = ..., k_0r_prime = ... }`, or the \
                 density law `tait`",
            ));
        }
    };
    Doolittle::new(mu_0, b, r_0, thermal, volume).map_err(locate(table))
}

fn yasutomi(table: &mut Table<'_>) -> Result<ImprovedYasutomi, InputError> {
    let (glass, [b_1, b_2]) = glass(table, |table| {
        Ok([
            table.required_quantity("b_1", Dimension::INVERSE_PRESSURE, Bounds::POSITIVE)?,
            table.required_number("b_2", Bounds::NEGATIVE)?,
        ])
    })?;
    ImprovedYasutomi::new(ImprovedYasutomi { glass, b_1, b_2 }).map_err(locate(table))
}

fn paluch(table: &mut Table<'_>) -> Result<Paluch, InputError> {
    let (fragility, divergence_pressure) = divergence(table)?;
    match has_second(table, "mu_0", "mu_inf")? {
        true => {
            let mu_inf =
                table.required_quantity("mu_inf", Dimension::VISCOSITY, Bounds::POSITIVE)?;
            Paluch::from_factor(mu_inf, fragility, divergence_pressure).map_err(locate(table))
        }
        false => Paluch::new(mu_0(table)?, fragility, divergence_pressure).map_err(locate(table)),
    }
}

/// `c_f` and `p_inf` of the law of Paluch.
fn divergence(table: &mut Table<'_>) -> Result<(f64, f64), InputError> {
    Ok((
        table.required_number("c_f", Bounds::above_to(0.0, 1000.0))?,
        table.required_quantity("p_inf", Dimension::PRESSURE, Bounds::POSITIVE)?,
    ))
}

fn hybrid(table: &mut Table<'_>) -> Result<Hybrid, InputError> {
    let mu_0 = mu_0(table)?;
    let a_0 = table.required_quantity("a_0", Dimension::INVERSE_PRESSURE, Bounds::NON_NEGATIVE)?;
    let q = table.required_number("q", Bounds::POSITIVE)?;
    let (fragility, divergence_pressure) = divergence(table)?;
    let constants = Hybrid {
        mu_0,
        a_0,
        q,
        fragility,
        divergence_pressure,
    };
    Hybrid::new(constants).map_err(locate(table))
}

fn walther(table: &mut Table<'_>, density: Option<&DensityLaw>) -> Result<Walther, InputError> {
    let density = required_density(table, density, "kinematic")?;
    let constants = Walther {
        a: table.required_number("a", Bounds::ANY)?,
        b: table.required_number("b", Bounds::POSITIVE)?,
        density,
        alpha: alpha(table)?,
        reference_temperature: reference_temperature(table)?,
        alpha_exponent: table
            .optional_number("alpha_exponent", Bounds::closed(-10.0, 10.0))?
            .unwrap_or(0.0),
        pressure: table
            .optional_choice("pressure", &PressureLaw::NAMES)?
            .unwrap_or(PressureLaw::Roelands),
    };
    Walther::new(constants).map_err(locate(table))
}
