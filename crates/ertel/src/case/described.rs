//! The case as output shows it: plain data, filled from the case file.

use serde::Serialize;

use super::SurfaceEcho;
use crate::contact::{Contact, Material, Motion, Supply};
use crate::mixed::Asperities;
use crate::params::{MeshParams, SolverParams, ThermalParams};
use crate::words::TemperatureScale;

/// One of the bodies.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BodyEcho {
    /// Material.
    pub name: String,
    /// Elastic constants.
    #[serde(flatten)]
    pub elasticity: Material,
    /// Bonded layers from the surface down.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub layers: Vec<LayerEcho>,
}

/// A bonded layer of a body.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LayerEcho {
    /// Material.
    pub name: String,
    /// Thickness, m.
    pub thickness: f64,
    /// Elastic constants.
    #[serde(flatten)]
    pub elasticity: Material,
}

/// The lubricant at the temperature of the case and ambient pressure.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FluidEcho {
    /// Name.
    pub name: String,
    /// Name of the viscosity law.
    pub viscosity_law: String,
    /// Name of the shear-thinning law; `None` for a Newtonian lubricant.
    pub shear_thinning: Option<String>,
    /// Name of the density law.
    pub density_law: String,
    /// Viscosity, Pa·s.
    pub viscosity: f64,
    /// Density, kg/m³.
    pub density: f64,
    /// Initial slope of ln μ(p), 1/Pa.
    pub pressure_viscosity: f64,
    /// Reciprocal asymptotic isoviscous pressure coefficient α*, 1/Pa, where it exists.
    pub pressure_viscosity_asymptotic: Option<f64>,
    /// Numbers that are estimates, as of an oil given by its data sheet.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub estimates: Vec<EstimateEcho>,
}

/// A number of the lubricant that is an estimate.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct EstimateEcho {
    /// Key path.
    pub key: String,
    /// The number in `unit`.
    pub value: String,
    /// Its unit; `1` for a pure number.
    pub unit: String,
    /// Key in the bibliography of the database, and the place.
    pub source: String,
    /// Its uncertainty, and the basis of that.
    pub note: String,
}

/// Heat: the settings, with both bulk temperatures, and thermal data.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ThermalEcho {
    /// Settings; both bulk temperatures are filled in.
    #[serde(flatten)]
    pub params: ThermalParams,
    /// The lubricant at the temperature of the inlet.
    pub lubricant: HeatEcho,
    /// The plane, disc or ring at its bulk temperature.
    pub body_1: HeatEcho,
    /// The ball or roller at its bulk temperature.
    pub body_2: HeatEcho,
}

/// Thermal data of one material at ambient pressure.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct HeatEcho {
    /// Density, kg/m³.
    pub density: f64,
    /// Thermal conductivity, W/(m·K).
    pub thermal_conductivity: f64,
    /// Name of its law.
    pub conductivity_law: String,
    /// Heat capacity, J/(kg·K).
    pub heat_capacity: f64,
    /// Name of its law.
    pub heat_capacity_law: String,
    /// Those of the layers of a body, from its surface down.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub layers: Vec<HeatEcho>,
}

/// Values computed from `[machine]`, in words, with their source.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MachineEcho {
    /// Names and formulas with their values.
    pub rows: Vec<(String, String)>,
}

/// The case as understood, SI.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CaseEcho {
    /// Title.
    #[serde(skip)]
    pub title: String,
    /// The case as the user gave it, quantities with their units.
    #[serde(skip)]
    pub given: serde_json::Value,
    /// Text of the case file, stored with the results as `case.toml`.
    #[serde(skip)]
    pub case_file: Option<String>,
    /// Geometry and load.
    pub contact: Contact,
    /// Speeds.
    pub motion: Motion,
    /// The machine they come from; `given` holds its keys.
    #[serde(skip)]
    pub machine: Option<MachineEcho>,
    /// How much oil reaches the contact.
    #[serde(skip_serializing_if = "is_flooded")]
    pub supply: Supply,
    /// The plane, disc or ring.
    pub body_1: BodyEcho,
    /// The ball or roller.
    pub body_2: BodyEcho,
    /// Composite rms roughness, m, if given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub roughness: Option<f64>,
    /// Its conversion from Ra or Rz.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub roughness_rules: Vec<String>,
    /// Asperities, if described.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub asperities: Option<Asperities>,
    /// Lubricant.
    pub fluid: FluidEcho,
    /// Temperature with which the lubricant enters the contact, K.
    pub temperature: f64,
    /// Temperature at which it is supplied, K, where the contact has another one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub supply_temperature: Option<f64>,
    /// Mesh settings.
    pub mesh: MeshParams,
    /// Solver settings.
    pub solver: SolverParams,
    /// Heat, in a thermal contact.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub thermal: Option<ThermalEcho>,
    /// Maps of the surfaces, in their order.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub surfaces: Vec<SurfaceEcho>,
}

impl CaseEcho {
    /// The scale of the temperatures of the case as the user gave them.
    pub(crate) fn temperature_scale(&self) -> TemperatureScale {
        let at = |path: &[&str]| {
            let found = path.iter().try_fold(&self.given, |node, key| node.get(key));
            found.and_then(|value| value.as_str())
        };
        let given = at(&["temperature"]).or_else(|| at(&["lubricant", "temperature"]));
        given.map_or_else(TemperatureScale::default, TemperatureScale::of)
    }
}

fn is_flooded(supply: &Supply) -> bool {
    !supply.is_limited()
}
