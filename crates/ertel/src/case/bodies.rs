//! `[bodies]`.

use ertel_rheology::Solid;
use ertel_rheology::database;
use ertel_rheology::input::{Bounds, InputError, StrOrTable, Table};
use ertel_rheology::quantity::Dimension;

use crate::contact::Elasticity;

/// One of the two bodies.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// Name of its material in the database, or what a case file calls it.
    pub name: String,
    /// Elastic constants.
    pub elasticity: Elasticity,
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
pub(super) fn read(mut table: Table<'_>) -> Result<Bodies, InputError> {
    let plane = read_body(&mut table, "plane")?;
    let ball = read_body(&mut table, "ball")?;
    let roughness = table.optional_quantity("roughness", Dimension::LENGTH, ROUGHNESS)?;
    table.finish()?;
    Ok(Bodies {
        plane,
        ball,
        roughness,
    })
}

/// A name from the database, a table with the constants, or a table with a name and what differs.
fn read_body(table: &mut Table<'_>, key: &str) -> Result<Body, InputError> {
    let solid = match table.required_str_or_table(key)? {
        StrOrTable::Str(name) => database::solid(name).map_err(super::unknown(table, key))?,
        StrOrTable::Table(mut inner) => {
            let solid = match inner.optional_str("name")? {
                Some(name) => {
                    let mut solid =
                        database::solid(name).map_err(super::unknown(&inner, "name"))?;
                    solid.override_from(&mut inner)?;
                    solid
                }
                None => Solid::from_table(&mut inner, "given by its constants")?,
            };
            inner.finish()?;
            solid
        }
    };
    Ok(Body {
        name: solid.name,
        elasticity: Elasticity {
            youngs_modulus: solid.youngs_modulus,
            poissons_ratio: solid.poissons_ratio,
        },
    })
}
