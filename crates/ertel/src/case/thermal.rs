//! `[thermal]`: its presence switches heat on.

use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::Dimension;
use ertel_rheology::{ConductivityLaw, HeatCapacityLaw};

use super::bodies::BodyLayer;
use super::lubricant::{TEMPERATURE, VISCOSITY};
use super::params::{FARTHEST, order, set};
use super::{Body, Case};
use crate::contact::Contact;
use crate::engine::{MissingDatum, MissingHeatData};
use crate::layers::{HeatLayer, ThermalMaterial};
use crate::params::ThermalParams;
use crate::warning::{Warning, WarningKind};

/// Depths of the heated layer, in half-widths: from the scale of the contact to the depth of the
/// elastic body.
const DEPTH: Bounds = Bounds::closed(0.1, FARTHEST);
/// Elements across a body: more indicate a wrong number.
const ELEMENTS: std::ops::RangeInclusive<i64> = 1..=64;
/// Conductivities from gases to diamond, W/(m·K): values outside indicate a wrong unit.
const CONDUCTIVITY: Bounds = Bounds::closed(1e-3, 5e3);
/// Heat capacities from heavy metals to hydrogen, J/(kg·K); likewise.
const HEAT_CAPACITY: Bounds = Bounds::closed(10.0, 2e4);
/// Densities of solids, kg/m³; likewise.
const DENSITY: Bounds = Bounds::closed(10.0, 3e4);

/// Reads `[thermal]`.
pub fn read(mut table: Table<'_>, contact: &Contact) -> Result<ThermalParams, InputError> {
    let mut thermal = ThermalParams::default();
    set(&mut thermal.depth, table.optional_number("depth", DEPTH)?);
    let count = |n: Option<i64>| n.and_then(|n| usize::try_from(n).ok());
    let film_order = count(table.optional_integer("film_order", 2..=10)?);
    set(&mut thermal.film_order, film_order);
    let elements = count(table.optional_integer("solid_elements", ELEMENTS)?);
    set(&mut thermal.solid_elements, elements);
    let surface_order = order(&mut table, "surface_order", 2)?;
    set(&mut thermal.surface_order, surface_order);
    let tolerance = table.optional_number("tolerance", Bounds::closed(1e-10, 0.1))?;
    set(&mut thermal.tolerance, tolerance);
    let iterations = count(table.optional_integer("max_iterations", 1..=10_000)?);
    set(&mut thermal.max_iterations, iterations);
    let mut temperature = |key: &str, older: &str| {
        if table.contains(key) && table.contains(older) {
            return Err(table.error(
                older,
                format!("`{older}` and `{key}` are the same temperature; keep one of them"),
            ));
        }
        let given = table.optional_quantity(key, Dimension::TEMPERATURE, TEMPERATURE)?;
        let as_before = table.optional_quantity(older, Dimension::TEMPERATURE, TEMPERATURE)?;
        Ok(given.or(as_before))
    };
    thermal.body_1_temperature = temperature("body_1_temperature", "plane_temperature")?;
    thermal.body_2_temperature = temperature("body_2_temperature", "ball_temperature")?;
    let points = table.optional_points("profiles", Bounds::closed(-FARTHEST, FARTHEST))?;
    set(&mut thermal.profiles, points);
    if contact.kind.is_line() && thermal.profiles.iter().any(|[_, y]| *y != 0.0) {
        return Err(table.error(
            "profiles",
            "the points of `profiles` must have y = 0 in a line contact",
        ));
    }
    set(&mut thermal.field, table.optional_bool("field")?);
    table.finish()?;
    Ok(thermal)
}

/// Complete data of a thermal contact.
#[derive(Clone, Debug)]
pub struct Heat<'a> {
    /// Settings.
    pub params: &'a ThermalParams,
    /// Conductivity law of the lubricant.
    pub conductivity: &'a ConductivityLaw,
    /// Heat capacity law of the lubricant.
    pub heat_capacity: &'a HeatCapacityLaw,
    /// The plane, disc or ring.
    pub body_1: SolidHeat<'a>,
    /// The ball or roller.
    pub body_2: SolidHeat<'a>,
}

/// Thermal data of one body; its laws hold at ambient pressure.
#[derive(Clone, Debug)]
pub struct SolidHeat<'a> {
    /// Density, kg/m³.
    pub density: f64,
    /// Conductivity law.
    pub conductivity: &'a ConductivityLaw,
    /// Heat capacity law.
    pub heat_capacity: &'a HeatCapacityLaw,
    /// Bulk temperature, K.
    pub temperature: f64,
    /// Layers from the surface down, at this temperature, with their thicknesses, m.
    pub layers: Vec<(f64, SolidHeat<'a>)>,
}

impl SolidHeat<'_> {
    /// Conductivity and heat capacity at the bulk temperature.
    pub fn constants(&self) -> ThermalMaterial {
        let t = self.temperature;
        ThermalMaterial {
            conductivity: self.conductivity.conductivity(0.0, t),
            capacity: self.density * self.heat_capacity.heat_capacity(0.0, t),
        }
    }

    /// The layers for conduction.
    pub fn heat_layers(&self) -> Vec<HeatLayer> {
        let layer = |(thickness, solid): &(f64, SolidHeat<'_>)| HeatLayer {
            thickness: *thickness,
            material: solid.constants(),
        };
        self.layers.iter().map(layer).collect()
    }
}

impl Case {
    /// The thermal settings in effect: none without `[thermal]`, and none with `solver.isothermal`.
    pub fn thermal(&self) -> Option<&ThermalParams> {
        let thermal = self.thermal.as_ref();
        thermal.filter(|_| !self.solver.isothermal)
    }

    /// Settings and data of a thermal contact; `None` for an isothermal one.
    ///
    /// # Errors
    ///
    /// [`MissingHeatData`] names what the lubricant or a body lacks.
    pub fn heat(&self) -> Result<Option<Heat<'_>>, MissingHeatData> {
        let Some(params) = self.thermal() else {
            return Ok(None);
        };
        let mut missing = Vec::new();
        let inlet = self.lubricant.temperature;
        let lubricant = self.lubricant.laws_of_heat(&mut missing);
        let first = self.body_1.heat(
            ["body_1", "the layers of body_1"],
            params.body_1_temperature.unwrap_or(inlet),
            &mut missing,
        );
        let second = self.body_2.heat(
            ["body_2", "the layers of body_2"],
            params.body_2_temperature.unwrap_or(inlet),
            &mut missing,
        );
        match (lubricant, first, second) {
            (Some((conductivity, heat_capacity)), Some(body_1), Some(body_2))
                if missing.is_empty() =>
            {
                Ok(Some(Heat {
                    params,
                    conductivity,
                    heat_capacity,
                    body_1,
                    body_2,
                }))
            }
            _ => Err(MissingHeatData { missing }),
        }
    }
}

impl super::Lubricant {
    /// Conductivity and heat capacity; missing data are noted.
    fn laws_of_heat(
        &self,
        missing: &mut Vec<MissingDatum>,
    ) -> Option<(&ConductivityLaw, &HeatCapacityLaw)> {
        let mut need = |key: &'static str| {
            missing.push(MissingDatum {
                key,
                part: "lubricant",
                material: self.name.clone(),
            });
        };
        if self.thermal_conductivity.is_none() {
            need("thermal_conductivity");
        }
        if self.heat_capacity.is_none() {
            need("heat_capacity");
        }
        Some((
            self.thermal_conductivity.as_ref()?,
            self.heat_capacity.as_ref()?,
        ))
    }
}

impl Body {
    /// The thermal data at this bulk `temperature`, K; missing data are noted.
    pub(crate) fn heat(
        &self,
        [part, of_layers]: [&'static str; 2],
        temperature: f64,
        missing: &mut Vec<MissingDatum>,
    ) -> Option<SolidHeat<'_>> {
        let data = [
            ("density", self.density.is_none()),
            ("thermal_conductivity", self.thermal_conductivity.is_none()),
            ("heat_capacity", self.heat_capacity.is_none()),
        ];
        let lacking = data.into_iter().filter(|(_, lacks)| *lacks);
        missing.extend(lacking.map(|(key, _)| MissingDatum {
            key,
            part,
            material: self.in_database.then(|| self.name.clone()),
        }));
        let mut layers = Vec::new();
        for BodyLayer { thickness, body } in &self.layers {
            let data = body.heat([of_layers; 2], temperature, missing);
            layers.extend(data.map(|data| (*thickness, data)));
        }
        Some(SolidHeat {
            density: self.density?,
            conductivity: self.thermal_conductivity.as_ref()?,
            heat_capacity: self.heat_capacity.as_ref()?,
            temperature,
            layers,
        })
    }
}

/// Refuses properties that no lubricant (at the temperature `inlet`, K) and no body has.
fn check_values(table: &Table<'_>, heat: &Heat<'_>, inlet: f64) -> Result<(), InputError> {
    let k = heat.conductivity.conductivity(0.0, inlet);
    let c = heat.heat_capacity.heat_capacity(0.0, inlet);
    let mut values = vec![
        ("thermal conductivity", "the lubricant", k, CONDUCTIVITY),
        ("heat capacity", "the lubricant", c, HEAT_CAPACITY),
    ];
    let solids = [
        (&heat.body_1, "body 1", "a layer of body 1"),
        (&heat.body_2, "body 2", "a layer of body 2"),
    ];
    let solids = solids.into_iter().flat_map(|(solid, part, of_layer)| {
        let layers = solid.layers.iter().map(move |(_, layer)| (layer, of_layer));
        layers.chain([(solid, part)])
    });
    for (solid, part) in solids {
        let k = solid.conductivity.conductivity(0.0, solid.temperature);
        let c = solid.heat_capacity.heat_capacity(0.0, solid.temperature);
        values.push(("density", part, solid.density, DENSITY));
        values.push(("thermal conductivity", part, k, CONDUCTIVITY));
        values.push(("heat capacity", part, c, HEAT_CAPACITY));
    }
    for (property, part, value, bounds) in values {
        if !bounds.contains(value) {
            let unit = match property {
                "density" => "kg/m^3",
                "heat capacity" => "J/(kg.K)",
                _ => "W/(m.K)",
            };
            return Err(table.error_here(format!(
                "the {property} of {part} is {value:e} {unit}; it must be {}",
                bounds.describe(unit)
            )));
        }
    }
    Ok(())
}

/// Whether a case with heat has all its data, and plausible values; errors point to `table`,
/// the `[thermal]` of the case. Returns warnings.
pub(super) fn check(case: &Case, table: &Table<'_>) -> Result<Vec<Warning>, InputError> {
    let heat = case.heat().map_err(|error| {
        table
            .error_here(error.to_string())
            .with_help(error.advice())
    })?;
    let Some(heat) = heat else {
        return Ok(Vec::new());
    };
    check_values(table, &heat, case.lubricant.temperature)?;
    for (key, older, solid) in [
        ("body_1_temperature", "plane_temperature", &heat.body_1),
        ("body_2_temperature", "ball_temperature", &heat.body_2),
    ] {
        let t = solid.temperature;
        let viscosity = case.lubricant.viscosity.viscosity(0.0, t);
        if !VISCOSITY.contains(viscosity) {
            let key = if table.clone().contains(older) {
                older
            } else {
                key
            };
            return Err(table
                .error(
                    key,
                    format!(
                        "the viscosity of the lubricant at {:.2} °C and ambient pressure is {viscosity:e} Pa.s; it must be {}",
                        t - 273.15,
                        VISCOSITY.describe("Pa.s")
                    ),
                )
                .with_help("the lubricant must be liquid at the temperatures of both bodies: look at the unit, or at the viscosity law"));
        }
    }
    let mut warnings = Vec::new();
    if !case.lubricant.viscosity.depends_on_temperature() {
        warnings.push(Warning::new(
            WarningKind::TemperatureIgnored,
            "the viscosity law does not depend on temperature: heat will not thin the lubricant",
        ));
    }
    if !case.lubricant.density.depends_on_temperature() {
        warnings.push(Warning::new(
            WarningKind::TemperatureIgnored,
            "the density law does not depend on temperature: no heating or cooling by compression, no expansion",
        ));
    }
    Ok(warnings)
}
