//! Heat and shear by the kind of the base oil, where a case asks for them.

use super::data_sheet::datum_of;
use crate::data_sheet::{BaseOil, Estimate, HeatEstimate, ShearEstimate};
use crate::provenance::Datum;
use crate::shear::{ReeEyring, ShearLaw, StressLimit};
use crate::{ConductivityLaw, Fluid, HeatCapacityLaw, LawError, ShearThinning};
use crate::{conductivity, heat_capacity};
use ertel_input::{InputError, Table};
use ertel_quantity::Dimension;

/// Eyring and limiting stress of a fluid whose table has `shear_thinning = { law = "estimate" }`, the table `inner`, and what of them is
/// estimated.
pub(super) fn shear(
    mut inner: Table<'_>,
    base_oil: Option<BaseOil>,
) -> Result<(ShearThinning, Vec<Datum>), InputError> {
    inner.required_str("law")?;
    let Some(base_oil) = base_oil else {
        return Err(inner
            .error(
                "law",
                "Eyring and limiting stress are estimated by the kind of the base oil, which is not known here",
            )
            .with_help(format!(
                "add `base_oil` to the lubricant, one of: {}; or give a law with its constants, such as {{ law = \"ree-eyring\", tau_0 \
                 = \"5 MPa\" }}",
                kinds()
            )));
    };
    let law = law_of_kind(&inner, "", base_oil);
    let law = law.map_err(|error| inner.error("law", error.to_string()))?;
    inner.finish()?;
    Ok((law, shear_data(&base_oil.shear()).to_vec()))
}

/// The law of a kind of oil, its numbers noted as inputs of `table`, below `path` there.
fn law_of_kind(
    table: &Table<'_>,
    path: &str,
    base_oil: BaseOil,
) -> Result<ShearThinning, LawError> {
    let estimate = base_oil.shear();
    let noted = |key: &str, of: &Estimate, dimension| {
        table.estimated_quantity(
            &format!("{path}{key}"),
            of.value,
            dimension,
            of.uncertainty(),
        )
    };
    let tau_0 = noted("tau_0", &estimate.eyring_stress, Dimension::PRESSURE);
    let growth = &estimate.pressure_coefficient;
    let lambda = noted("limit.lambda", growth, Dimension::DIMENSIONLESS);
    Ok(ShearThinning {
        law: Some(ShearLaw::ReeEyring(ReeEyring::new(tau_0)?)),
        limit: Some(StressLimit::new(tau_0, lambda)?),
    })
}

/// The kinds, as a list in words.
fn kinds() -> String {
    BaseOil::NAMES.map(|(name, _)| name).join(", ")
}

/// The data of an estimate of heat, and of shear.
fn heat_data(heat: &HeatEstimate) -> [Datum; 2] {
    [
        datum_of(
            "thermal_conductivity.k_0",
            &heat.conductivity,
            1.0,
            "W/(m.K)",
        ),
        datum_of(
            "heat_capacity.rho_c_0",
            &heat.volumetric_heat,
            1e-6,
            "MJ/(m^3.K)",
        ),
    ]
}

fn shear_data(shear: &ShearEstimate) -> [Datum; 2] {
    [
        datum_of("shear_thinning.tau_0", &shear.eyring_stress, 1e-6, "MPa"),
        datum_of(
            "shear_thinning.limit.lambda",
            &shear.pressure_coefficient,
            1.0,
            "1",
        ),
    ]
}

impl Fluid {
    /// Data missing from the fluid that a case with heat and shear estimates by the kind of the base oil.
    #[must_use]
    pub fn estimates_by_kind(&self) -> Vec<Datum> {
        let Some(base_oil) = self.base_oil else {
            return Vec::new();
        };
        let [conductivity, heat_capacity] = heat_data(&base_oil.heat());
        let has_density = self.density.is_some();
        let mut data = Vec::new();
        if has_density && self.thermal_conductivity.is_none() {
            data.push(conductivity);
        }
        if has_density && self.heat_capacity.is_none() {
            data.push(heat_capacity);
        }
        if self.shear_thinning.is_none() {
            data.extend(shear_data(&base_oil.shear()));
        }
        data
    }

    /// Fills in a law of shear thinning where there is none, by the kind of the base oil where it is known ([`BaseOil::shear`]), with numbers that are estimates
    /// as those of [`Fluid::estimate_heat`]. Returns whether it did.
    ///
    /// # Errors
    ///
    /// As [`Fluid::estimate_heat`].
    pub fn estimate_shear(&mut self, table: &Table<'_>, path: &str) -> Result<bool, InputError> {
        let (Some(base_oil), None) = (self.base_oil, &self.shear_thinning) else {
            return Ok(false);
        };
        let path = match path {
            "" => "shear_thinning.".to_owned(),
            path => format!("{path}.shear_thinning."),
        };
        let law = law_of_kind(table, &path, base_oil);
        let law = law.map_err(|error| table.error_here(error.to_string()))?;
        self.shear_thinning = Some(law);
        self.provenance.extend(shear_data(&base_oil.shear()));
        Ok(true)
    }

    /// Fills in what of conductivity and heat capacity is missing, by the kind of the base oil where it is known
    /// ([`BaseOil::heat`]); such numbers have [`crate::provenance::Status::Estimated`] in the provenance. An oil without a density law or
    /// of unknown kind stays as it is.
    ///
    /// The numbers are noted as inputs of `table`, below `path` there: empty for the table of the fluid itself.
    ///
    /// # Errors
    ///
    /// Values that a law refuses, which only values given instead of the estimates can be.
    pub fn estimate_heat(&mut self, table: &Table<'_>, path: &str) -> Result<(), InputError> {
        let (Some(base_oil), Some(density)) = (self.base_oil, &self.density) else {
            return Ok(());
        };
        let heat = base_oil.heat();
        let [of_conductivity, of_heat] = heat_data(&heat);
        let refused = |error: LawError| table.error_here(error.to_string());
        let noted = |key: &str, of: &Estimate, dimension| {
            let path = match path {
                "" => key.to_owned(),
                path => format!("{path}.{key}"),
            };
            table.estimated_quantity(&path, of.value, dimension, of.uncertainty())
        };
        if self.thermal_conductivity.is_none() {
            let (key, estimate) = ("thermal_conductivity.k_0", &heat.conductivity);
            let k_0 = noted(key, estimate, Dimension::THERMAL_CONDUCTIVITY);
            let law = conductivity::LarssonAndersson::new(k_0, heat.d_1, heat.d_2);
            let law = ConductivityLaw::LarssonAndersson(law.map_err(refused)?);
            self.thermal_conductivity = Some(law);
            self.provenance.push(of_conductivity);
        }
        if self.heat_capacity.is_none() {
            let (key, estimate) = ("heat_capacity.rho_c_0", &heat.volumetric_heat);
            let constants = heat_capacity::VolumetricConstants {
                rho_c_0: noted(key, estimate, Dimension::VOLUMETRIC_HEAT),
                reference_temperature: heat.reference_temperature,
                beta_0: heat.beta_0,
                b_1: heat.b_1,
                b_2: heat.b_2,
                k_1: heat.k_1,
                k_2: heat.k_2,
            };
            let law = heat_capacity::LarssonAndersson::new(constants, density.clone());
            let law = HeatCapacityLaw::LarssonAndersson(law.map_err(refused)?);
            self.heat_capacity = Some(law);
            self.provenance.push(of_heat);
        }
        Ok(())
    }
}
