//! `[bodies]`.

use std::path::Path;

use ertel_input::{Bounds, InputError, StrOrTable, Table};
use ertel_quantity::Dimension;
use ertel_rheology::{ConductivityLaw, Files, HeatCapacityLaw, Solid, database};

use crate::contact::Material;
use crate::contact::curvature::{Curvatures, curvature_along, gap_between};
use crate::layers::{Coated, Layer};

/// One of the two bodies.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// Name of its material in the database or in the case file, or the user's file.
    pub name: String,
    /// Whether that name is one of the database or a file.
    pub in_database: bool,
    /// Elastic constants.
    pub elasticity: Material,
    /// Bonded layers from the surface down.
    pub layers: Vec<BodyLayer>,
    /// Largest Hertz pressure without permanent damage, Pa, if known.
    pub hertz_pressure_limit: Option<f64>,
    /// Density, kg/m³, if known.
    pub density: Option<f64>,
    /// Law of the thermal conductivity at ambient pressure, if known.
    pub thermal_conductivity: Option<ConductivityLaw>,
    /// Law of the heat capacity at ambient pressure, if known.
    pub heat_capacity: Option<HeatCapacityLaw>,
}

/// A bonded layer.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyLayer {
    /// Thickness, m.
    pub thickness: f64,
    /// Its material, as a body without layers.
    pub body: Body,
}

impl Body {
    /// The body with its layers, SI.
    pub fn coated(&self) -> Coated {
        let layer = |layer: &BodyLayer| Layer {
            thickness: layer.thickness,
            material: layer.body.elasticity,
        };
        Coated {
            layers: self.layers.iter().map(layer).collect(),
            substrate: self.elasticity,
        }
    }

    /// A body with elastic constants and without thermal data.
    pub fn elastic(name: &str, elasticity: Material) -> Self {
        Self {
            name: name.to_owned(),
            in_database: false,
            elasticity,
            layers: Vec::new(),
            hertz_pressure_limit: None,
            density: None,
            thermal_conductivity: None,
            heat_capacity: None,
        }
    }
}

/// Roughnesses from atoms to castings, m: values outside indicate a wrong unit.
pub(super) const ROUGHNESS: Bounds = Bounds::closed(1e-11, 1e-3);

/// Contents of `[bodies]`.
pub(super) struct Bodies {
    pub body_1: Body,
    pub body_2: Body,
    /// Composite rms roughness, m.
    pub roughness: Option<f64>,
    /// Their shapes, where given.
    pub shapes: Option<Shapes>,
}

/// Shapes of both bodies.
#[derive(Clone, Copy)]
pub(super) struct Shapes {
    /// Of the first and the second body.
    pub curvatures: [Curvatures; 2],
    /// From the x axis of the first body to that of the second, rad.
    pub angle: f64,
}

impl Shapes {
    /// Smallest radius of curvature of either body along each axis of the Hertz ellipse, m, convex or concave; infinite where both are flat.
    pub fn smallest_radii(&self) -> [f64; 2] {
        let [one, two] = self.curvatures;
        let (_, direction) = gap_between(one, two, self.angle);
        [direction, direction + std::f64::consts::FRAC_PI_2].map(|along| {
            let first = curvature_along(one, along).abs();
            1.0 / first.max(curvature_along(two, along - self.angle).abs())
        })
    }
}

/// Radii of bodies, m; negative where they are concave.
const BODY_RADIUS: Bounds = Bounds::closed(-1e3, 1e3);
const LEAST_BODY_RADIUS: f64 = 1e-6;
/// Directions, rad.
const ANGLE: Bounds = Bounds::closed(-std::f64::consts::PI, std::f64::consts::PI);

/// Reads both bodies, and their shapes and roughness where given.
pub(super) fn read(mut table: Table<'_>, folder: &Path) -> Result<Bodies, InputError> {
    let keys = [["body_1", "plane"], ["body_2", "ball"]].map(|names| name_in(&mut table, names));
    let [first, second] = keys;
    let (body_1, shape_1) = read_body(&mut table, first?, folder)?;
    let (body_2, shape_2) = read_body(&mut table, second?, folder)?;
    let roughness = table.optional_quantity("roughness", Dimension::LENGTH, ROUGHNESS)?;
    let angle = table.optional_quantity("axes_angle", Dimension::ANGLE, ANGLE)?;
    let shapes = match (shape_1, shape_2) {
        (Some(one), Some(two)) => Some(Shapes {
            curvatures: [one, two],
            angle: angle.unwrap_or(0.0),
        }),
        (None, None) if angle.is_some() => {
            return Err(table.error(
                "axes_angle",
                "`axes_angle` is the angle between the axes of two bodies, but neither has radii",
            ));
        }
        (None, None) => None,
        _ => {
            return Err(table
                .error_here("one body has radii and the other has none")
                .with_help("a plane has radius_x = \"flat\" and radius_y = \"flat\""));
        }
    };
    table.finish()?;
    Ok(Bodies {
        body_1,
        body_2,
        roughness,
        shapes,
    })
}

/// The name of a body, of two, that the table has; the first where it has neither.
pub(super) fn name_in(
    table: &mut Table<'_>,
    names: [&'static str; 2],
) -> Result<&'static str, InputError> {
    match names.map(|name| table.contains(name)) {
        [true, true] => Err(table.error(
            names[1],
            format!(
                "`{}` and `{}` are the same body; keep one of them",
                names[0], names[1]
            ),
        )),
        [false, true] => Ok(names[1]),
        _ => Ok(names[0]),
    }
}

/// Curvatures of a body, where its table has radii.
fn read_shape(table: &mut Table<'_>) -> Result<Option<Curvatures>, InputError> {
    if !table.contains("radius_x") && !table.contains("radius_y") {
        return Ok(None);
    }
    let mut curvature = |key: &str| -> Result<f64, InputError> {
        if let Ok("flat") = table.required_str(key) {
            return Ok(0.0);
        }
        let radius = table.required_quantity(key, Dimension::LENGTH, BODY_RADIUS)?;
        if radius.abs() < LEAST_BODY_RADIUS {
            return Err(table
                .error(key, "a radius must not be below 1 um")
                .with_help(
                    "a flat side has the radius \"flat\", a concave one a negative radius",
                ));
        }
        Ok(1.0 / radius)
    };
    Ok(Some([curvature("radius_x")?, curvature("radius_y")?]))
}

/// A name from the database, a table with the constants, or a table with a name and the values that differ.
fn read_body(
    table: &mut Table<'_>,
    key: &str,
    folder: &Path,
) -> Result<(Body, Option<Curvatures>), InputError> {
    let (mut shape, mut layers) = (None, Vec::new());
    let (solid, in_database) = match table.required_str_or_table(key)? {
        StrOrTable::Str(name) => {
            let solid = database::solid_or_file(name, folder, table.recorder(key))
                .map_err(super::unknown(table, key))?;
            (solid, true)
        }
        StrOrTable::Table(mut inner) => {
            shape = read_shape(&mut inner)?;
            layers = read_layers(&mut inner, folder)?;
            let found = solid(&mut inner, folder)?;
            inner.finish()?;
            found
        }
    };
    Ok((of_solid(solid, in_database, layers), shape))
}

/// A solid by its name, with the values that the table replaces, or by its constants; whether it is in the database.
fn solid(table: &mut Table<'_>, folder: &Path) -> Result<(Solid, bool), InputError> {
    let files = Files::Folder(folder);
    let Some(name) = table.optional_str("name")? else {
        let solid = Solid::from_table(table, "given by its constants", files)?;
        return Ok((solid, false));
    };
    let mut solid = database::solid_or_file(name, folder, table.own_recorder())
        .map_err(super::unknown(table, "name"))?;
    solid.override_from(table, files)?;
    Ok((solid, true))
}

fn of_solid(solid: Solid, in_database: bool, layers: Vec<BodyLayer>) -> Body {
    Body {
        name: solid.name,
        in_database,
        elasticity: Material {
            youngs_modulus: solid.youngs_modulus,
            poissons_ratio: solid.poissons_ratio,
        },
        layers,
        hertz_pressure_limit: solid.hertz_pressure_limit,
        density: solid.density,
        thermal_conductivity: solid.thermal_conductivity,
        heat_capacity: solid.heat_capacity,
    }
}

/// Thicknesses, m: from a few atoms to liners.
const THICKNESS: Bounds = Bounds::closed(1e-9, 1e-2);
/// Most layers of a body.
const MOST_LAYERS: usize = 8;

/// Reads the layers of a body, from its surface down.
fn read_layers(body: &mut Table<'_>, folder: &Path) -> Result<Vec<BodyLayer>, InputError> {
    let tables = body.tables("layers")?;
    if tables.len() > MOST_LAYERS {
        let text = format!(
            "a body has at most {MOST_LAYERS} layers, not {}",
            tables.len()
        );
        return Err(body.error("layers", text));
    }
    tables
        .into_iter()
        .map(|table| layer(table, folder))
        .collect()
}

fn layer(mut table: Table<'_>, folder: &Path) -> Result<BodyLayer, InputError> {
    let thickness = table.required_quantity("thickness", Dimension::LENGTH, THICKNESS)?;
    let (solid, in_database) = solid(&mut table, folder)?;
    table.finish()?;
    Ok(BodyLayer {
        thickness,
        body: of_solid(solid, in_database, Vec::new()),
    })
}
