//! Shear-thinning laws from a table.

use super::{locate, reference_temperature};
use crate::provenance::celsius;
use crate::shear::{Carreau, CarreauYasuda, Rabinowitsch, ReeEyring, ShearLaw, StressLimit};
use crate::{ShearThinning, ViscosityLaw};
use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::Dimension;

laws! {
    Carreau = "carreau",
    CarreauYasuda = "carreau-yasuda",
    ReeEyring = "ree-eyring",
    Rabinowitsch = "rabinowitsch",
    LimitingStress = "limiting-stress",
    Estimate = "estimate",
}

impl ShearThinning {
    /// Reads a law from a table such as `{ law = "ree-eyring", tau_0 = "5 MPa" }` and refuses unknown keys.
    ///
    /// `viscosity` is the low-shear law of the same fluid: `mu_2` is that of the second plateau at ambient pressure and
    /// `reference_temperature`, which is, in this order, that of the table, that of the viscosity law, that of the
    /// fluid (`fluid_temperature`, K); a viscosity without temperature needs none.
    ///
    /// | law | keys |
    /// |---|---|
    /// | `carreau` | `g_c`, `n`, `beta_c`, `mu_2`; optional `reference_temperature` |
    /// | `carreau-yasuda` | `g`, `n`, `a`, `mu_2`; optional `reference_temperature` |
    /// | `ree-eyring` | `tau_0` |
    /// | `rabinowitsch` | `tau_0`, `n` |
    /// | `limiting-stress` | `tau_l0`, `lambda` |
    ///
    /// `estimate`, by the base oil, is one of the table of a fluid alone ([`crate::Fluid::from_table`]).
    ///
    /// The first four may have a `limit = { tau_l0 = ..., lambda = ... }`.
    ///
    /// # Errors
    ///
    /// Unknown laws and keys, missing keys, wrong units and impossible values, each with its line; a second plateau
    /// above the first.
    pub fn from_table(
        mut table: Table<'_>,
        viscosity: &ViscosityLaw,
        fluid_temperature: Option<f64>,
    ) -> Result<Self, InputError> {
        let law = match table.required_choice("law", LAWS)? {
            Law::Estimate => {
                return Err(table.error(
                    "law",
                    "this law is an estimate by the kind of a base oil, which only the table of a fluid has",
                ));
            }
            Law::LimitingStress => {
                let limit = limit(&mut table)?;
                table.finish()?;
                return Ok(Self::limited(limit));
            }
            Law::Carreau => {
                let g_c = stress(&mut table, "g_c")?;
                let (n, beta_c) = (exponent(&mut table)?, transition(&mut table, "beta_c")?);
                let ratio = plateau_ratio(&mut table, viscosity, fluid_temperature)?;
                ShearLaw::Carreau(Carreau::new(g_c, n, beta_c, ratio).map_err(locate(&table))?)
            }
            Law::CarreauYasuda => {
                let g = stress(&mut table, "g").map_err(|error| {
                    error.with_help("`g` is the shear modulus: the relaxation time is mu_1/g")
                })?;
                let (n, a) = (exponent(&mut table)?, transition(&mut table, "a")?);
                let ratio = plateau_ratio(&mut table, viscosity, fluid_temperature)?;
                ShearLaw::CarreauYasuda(CarreauYasuda::new(g, n, a, ratio).map_err(locate(&table))?)
            }
            Law::ReeEyring => {
                let tau_0 = stress(&mut table, "tau_0")?;
                ShearLaw::ReeEyring(ReeEyring::new(tau_0).map_err(locate(&table))?)
            }
            Law::Rabinowitsch => {
                let tau_0 = stress(&mut table, "tau_0")?;
                let n = table.required_number("n", Bounds::open(0.0, 1.0))?;
                ShearLaw::Rabinowitsch(Rabinowitsch::new(tau_0, n).map_err(locate(&table))?)
            }
        };
        let limit = match table.optional_table("limit")? {
            None => None,
            Some(mut table) => {
                let limit = limit(&mut table)?;
                table.finish()?;
                Some(limit)
            }
        };
        table.finish()?;
        Ok(Self {
            law: Some(law),
            limit,
        })
    }
}

fn stress(table: &mut Table<'_>, key: &str) -> Result<f64, InputError> {
    table.required_quantity(key, Dimension::PRESSURE, Bounds::POSITIVE)
}

fn exponent(table: &mut Table<'_>) -> Result<f64, InputError> {
    table.required_number("n", Bounds::above_to(0.0, 1.0))
}

fn transition(table: &mut Table<'_>, key: &str) -> Result<f64, InputError> {
    table.required_number(key, Bounds::POSITIVE)
}

fn limit(table: &mut Table<'_>) -> Result<StressLimit, InputError> {
    let tau_l0 = stress(table, "tau_l0")?;
    let lambda = table.required_number("lambda", Bounds::NON_NEGATIVE)?;
    StressLimit::new(tau_l0, lambda).map_err(locate(table))
}

/// `μ₂/μ₁` at ambient pressure and reference temperature.
fn plateau_ratio(
    table: &mut Table<'_>,
    viscosity: &ViscosityLaw,
    fluid_temperature: Option<f64>,
) -> Result<f64, InputError> {
    let mu_2 = table.required_quantity("mu_2", Dimension::VISCOSITY, Bounds::NON_NEGATIVE)?;
    let own = if table.contains("reference_temperature") {
        Some(reference_temperature(table)?)
    } else {
        None
    };
    if mu_2 == 0.0 {
        return Ok(0.0);
    }
    let known = own
        .or(viscosity.reference_temperature())
        .or(fluid_temperature)
        .or_else(|| {
            let ambient = |temperature: f64| viscosity.ln_viscosity(0.0, temperature);
            (ambient(300.0) == ambient(350.0)).then_some(300.0)
        });
    let Some(temperature) = known else {
        return Err(table.missing("reference_temperature").with_help(
            "`mu_2` belongs to a temperature, because the viscosity of the first plateau depends on it",
        ));
    };
    let mu_1 = viscosity.viscosity(0.0, temperature);
    if !(mu_1.is_finite() && mu_1 > 0.0) {
        return Err(table.error(
            "mu_2",
            format!(
                "the viscosity law gives the first plateau as {mu_1} Pa.s at {}: there is no ratio to it",
                celsius(temperature)
            ),
        ));
    }
    // The law gives its own constant back to round-off only; equal plateaus are allowed.
    if mu_2 > mu_1 * (1.0 + 1e-9) {
        let mu_1 = format!("{mu_1:.5e}").parse().unwrap_or(mu_1);
        return Err(table
            .error(
                "mu_2",
                format!(
                    "the second plateau, mu_2 = {mu_2} Pa.s, lies above the first, {mu_1} Pa.s at {}",
                    celsius(temperature)
                ),
            )
            .with_help("shear makes the lubricant thinner: mu_2 is the viscosity at very high shear"));
    }
    Ok((mu_2 / mu_1).min(1.0))
}
