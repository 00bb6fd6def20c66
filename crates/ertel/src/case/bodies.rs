//! `[bodies]`.

use ertel_rheology::input::{Bounds, InputError, StrOrTable, Table};
use ertel_rheology::quantity::Dimension;
use ertel_rheology::{ConductivityLaw, Files, HeatCapacityLaw, Solid, database};

use crate::contact::Elasticity;

/// One of the two bodies.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// Name of its material in the database, or what a case file calls it.
    pub name: String,
    /// Whether that name is one of the database.
    pub in_database: bool,
    /// Elastic constants.
    pub elasticity: Elasticity,
    /// Density, kg/m³, if known.
    pub density: Option<f64>,
    /// Law of the thermal conductivity at ambient pressure, if known.
    pub thermal_conductivity: Option<ConductivityLaw>,
    /// Law of the heat capacity at ambient pressure, if known.
    pub heat_capacity: Option<HeatCapacityLaw>,
}

impl Body {
    /// A body of which the elastic constants are known, and nothing that heat would need.
    pub fn elastic(name: &str, elasticity: Elasticity) -> Self {
        Self {
            name: name.to_owned(),
            in_database: false,
            elasticity,
            density: None,
            thermal_conductivity: None,
            heat_capacity: None,
        }
    }
}

/// Roughnesses from atoms to castings, m: beyond these a unit was mistaken.
const ROUGHNESS: Bounds = Bounds::closed(1e-11, 1e-3);

/// What `[bodies]` says.
pub(super) struct Bodies {
    pub plane: Body,
    pub ball: Body,
    /// Composite rms roughness, m.
    pub roughness: Option<f64>,
}

/// Reads the plane, the ball, and their roughness where given.
pub(super) fn read(mut table: Table<'_>, files: Files<'_>) -> Result<Bodies, InputError> {
    let plane = read_body(&mut table, "plane", files)?;
    let ball = read_body(&mut table, "ball", files)?;
    let roughness = table.optional_quantity("roughness", Dimension::LENGTH, ROUGHNESS)?;
    table.finish()?;
    Ok(Bodies {
        plane,
        ball,
        roughness,
    })
}

/// A name from the database, a table with the constants, or a table with a name and what differs.
fn read_body(table: &mut Table<'_>, key: &str, files: Files<'_>) -> Result<Body, InputError> {
    let (solid, in_database) = match table.required_str_or_table(key)? {
        StrOrTable::Str(name) => {
            let solid = database::solid(name).map_err(super::unknown(table, key))?;
            (solid, true)
        }
        StrOrTable::Table(mut inner) => {
            let found = match inner.optional_str("name")? {
                Some(name) => {
                    let mut solid =
                        database::solid(name).map_err(super::unknown(&inner, "name"))?;
                    solid.override_from(&mut inner, files)?;
                    (solid, true)
                }
                None => {
                    let name = "given by its constants";
                    (Solid::from_table(&mut inner, name, files)?, false)
                }
            };
            inner.finish()?;
            found
        }
    };
    Ok(Body {
        name: solid.name,
        in_database,
        elasticity: Elasticity {
            youngs_modulus: solid.youngs_modulus,
            poissons_ratio: solid.poissons_ratio,
        },
        density: solid.density,
        thermal_conductivity: solid.thermal_conductivity,
        heat_capacity: solid.heat_capacity,
    })
}
