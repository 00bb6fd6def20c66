//! The case as the output shows it.

use ertel_input::tree::{Node, Value};
use ertel_rheology::ShearThinning;
use ertel_rheology::provenance::Datum;
use serde_json::{Map, json};

use super::{Body, BodyLayer, Case, SolidHeat};
use crate::case::{BodyEcho, CaseEcho, EstimateEcho, FluidEcho, HeatEcho, LayerEcho, ThermalEcho};
use crate::params::ThermalParams;

impl Case {
    /// The case as understood, with the lubricant's ambient properties, for [`crate::output`].
    pub fn echo(&self) -> CaseEcho {
        let lubricant = &self.lubricant;
        let temperature = lubricant.temperature;
        CaseEcho {
            title: self.title.clone(),
            given: self.given.clone(),
            case_file: (!self.source.is_empty()).then(|| self.source.clone()),
            contact: self.contact.clone(),
            motion: self.motion,
            machine: self.machine.clone(),
            supply: self.supply,
            body_1: body(&self.body_1),
            body_2: body(&self.body_2),
            roughness: self.roughness,
            roughness_rules: self.roughness_rules.clone(),
            asperities: self.asperities.clone(),
            fluid: FluidEcho {
                name: lubricant.name.clone().unwrap_or_else(|| {
                    let by = if lubricant.is_of_data_sheet() {
                        "data sheet"
                    } else {
                        "laws"
                    };
                    format!("given by its {by}")
                }),
                viscosity_law: lubricant.viscosity.name().to_owned(),
                shear_thinning: lubricant
                    .shear_thinning
                    .as_ref()
                    .map(ShearThinning::describe),
                density_law: lubricant.density.name().to_owned(),
                viscosity: lubricant.ambient_viscosity(),
                density: lubricant.ambient_density(),
                pressure_viscosity: lubricant.viscosity.pressure_viscosity_slope(temperature),
                pressure_viscosity_asymptotic: lubricant
                    .viscosity
                    .pressure_viscosity_reciprocal_asymptotic(temperature)
                    .ok(),
                estimates: lubricant.estimates.iter().map(estimate).collect(),
            },
            temperature,
            supply_temperature: lubricant.supply_temperature,
            mesh: self.mesh.clone(),
            solver: self.solver.clone(),
            thermal: self.thermal_echo(),
            surfaces: (self.reliefs.iter())
                .filter_map(|relief| relief.echo.clone())
                .collect(),
        }
    }

    /// Heat, where the case includes it and has its data.
    fn thermal_echo(&self) -> Option<ThermalEcho> {
        let heat = self.heat().ok().flatten()?;
        let inlet = self.lubricant.temperature;
        Some(ThermalEcho {
            params: ThermalParams {
                body_1_temperature: Some(heat.body_1.temperature),
                body_2_temperature: Some(heat.body_2.temperature),
                ..heat.params.clone()
            },
            lubricant: HeatEcho {
                density: self.lubricant.ambient_density(),
                thermal_conductivity: heat.conductivity.conductivity(0.0, inlet),
                conductivity_law: heat.conductivity.name().to_owned(),
                heat_capacity: heat.heat_capacity.heat_capacity(0.0, inlet),
                heat_capacity_law: heat.heat_capacity.name().to_owned(),
                layers: Vec::new(),
            },
            body_1: solid(&heat.body_1),
            body_2: solid(&heat.body_2),
        })
    }
}

fn estimate(datum: &Datum) -> EstimateEcho {
    EstimateEcho {
        key: datum.key.clone(),
        value: datum.value.clone(),
        unit: datum.unit.clone(),
        source: datum.source.clone(),
        note: datum.note.clone().unwrap_or_default(),
    }
}

fn solid(solid_heat: &SolidHeat<'_>) -> HeatEcho {
    HeatEcho {
        density: solid_heat.density,
        thermal_conductivity: solid_heat
            .conductivity
            .conductivity(0.0, solid_heat.temperature),
        conductivity_law: solid_heat.conductivity.name().to_owned(),
        heat_capacity: solid_heat
            .heat_capacity
            .heat_capacity(0.0, solid_heat.temperature),
        heat_capacity_law: solid_heat.heat_capacity.name().to_owned(),
        layers: (solid_heat.layers.iter())
            .map(|(_, layer)| solid(layer))
            .collect(),
    }
}

fn body(body: &Body) -> BodyEcho {
    BodyEcho {
        name: body.name.clone(),
        elasticity: body.elasticity,
        layers: body.layers.iter().map(layer).collect(),
    }
}

fn layer(layer: &BodyLayer) -> LayerEcho {
    LayerEcho {
        name: layer.body.name.clone(),
        thickness: layer.thickness,
        elasticity: layer.body.elasticity,
    }
}

/// A file's values as JSON, in the order of the file.
pub(super) fn json_of(node: &Node) -> serde_json::Value {
    match &node.value {
        Value::Str(text) => json!(text),
        Value::Integer(number) => json!(number),
        Value::Float(number) => json!(number),
        Value::Bool(switch) => json!(switch),
        Value::Datetime => serde_json::Value::Null,
        Value::Array(nodes) => nodes.iter().map(json_of).collect(),
        Value::Table(entries) => {
            let pairs = entries
                .iter()
                .map(|entry| (entry.key.clone(), json_of(&entry.node)));
            serde_json::Value::Object(pairs.collect::<Map<_, _>>())
        }
    }
}
