//! The case as the output shows it.

use super::{Body, Case};
use crate::output::{BodyEcho, CaseEcho, FluidEcho};

impl Case {
    /// The case as understood, with the lubricant's ambient properties, for [`crate::output`].
    pub fn echo(&self) -> CaseEcho {
        let lubricant = &self.lubricant;
        let temperature = lubricant.temperature;
        CaseEcho {
            title: self.title.clone(),
            given: self.given.clone(),
            case_file: (!self.source.is_empty()).then(|| self.source.clone()),
            contact: self.contact,
            motion: self.motion,
            plane: body(&self.plane),
            ball: body(&self.ball),
            fluid: FluidEcho {
                name: lubricant
                    .name
                    .clone()
                    .unwrap_or_else(|| "given by its laws".to_owned()),
                viscosity_law: lubricant.viscosity.name().to_owned(),
                density_law: lubricant.density.name().to_owned(),
                viscosity: lubricant.ambient_viscosity(),
                density: lubricant.ambient_density(),
                pressure_viscosity: lubricant.viscosity.pressure_viscosity_slope(temperature),
                pressure_viscosity_asymptotic: lubricant
                    .viscosity
                    .pressure_viscosity_reciprocal_asymptotic(temperature)
                    .ok(),
            },
            temperature,
            mesh: self.mesh.clone(),
            solver: self.solver.clone(),
        }
    }
}

fn body(body: &Body) -> BodyEcho {
    BodyEcho {
        name: body.name.clone(),
        elasticity: body.elasticity,
    }
}
