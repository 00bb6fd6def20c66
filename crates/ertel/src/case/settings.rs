//! Lubricant, heat, supply and solution of a contact: `[solver]`, `[thermal]`, `[lubricant]`, `[mesh]`, `[inlet]`, `[stress]`, `[output]`.

use std::path::Path;

use ertel_input::{InputError, Table};

use super::geometry::Geometry;
use super::lubricant::{self, Lubricant};
use super::{friction, inlet, params, stress, thermal};
use crate::contact::{Hertz, Supply};
use crate::params::{MeshParams, OutputParams, SolverParams, ThermalParams};
use crate::stress::StressParams;
use crate::warning::Warning;

/// Contents of these sections.
pub(super) struct Settings {
    pub solver: SolverParams,
    pub thermal: Option<ThermalParams>,
    pub lubricant: Lubricant,
    /// Whether friction follows the shear-thinning law of the lubricant while the films are Newtonian.
    pub friction_by_law: bool,
    pub mesh: MeshParams,
    pub supply: Supply,
    pub stress: Option<StressParams>,
    pub output: OutputParams,
    /// Warnings about the range of the data of the lubricant, and about depths of stresses.
    pub warnings: Vec<Warning>,
}

impl Settings {
    /// Reads the sections; `modulus` is the reduced modulus, Pa. A machine gets a row about its friction.
    pub fn read(
        root: &mut Table<'_>,
        folder: &Path,
        geometry: &mut Geometry<'_>,
        modulus: f64,
    ) -> Result<Self, InputError> {
        let contact = &geometry.contact;
        let solver_table = root.optional_table("solver")?;
        let solver = solver_table.clone().map(params::read_solver);
        let mut solver = solver.transpose()?.unwrap_or_default();
        let thermal = root.optional_table("thermal")?;
        let thermal = thermal.map(|table| thermal::read(table, contact));
        let mut thermal = thermal.transpose()?;
        if let (Some(thermal), Some(bulk)) = (&mut thermal, geometry.bulk_temperature) {
            thermal.body_1_temperature.get_or_insert(bulk);
            thermal.body_2_temperature.get_or_insert(bulk);
        }
        let heat = thermal.is_some() && !solver.isothermal;
        let conditions = lubricant::Conditions {
            pressure: geometry.hertz.pressure,
            heat,
            shear: geometry.machine.is_some() && !solver.newtonian,
            flank_temperature: geometry.bulk_temperature,
        };
        let (lubricant, mut warnings) = lubricant::read(root, folder, conditions)?;
        let asked = solver_table.is_some_and(|mut table| table.contains("newtonian"));
        let friction_by_law = friction::by_law(
            root,
            geometry.machine.as_mut(),
            (&lubricant, &mut solver),
            asked,
            heat,
        )?;
        let mesh_table = root.optional_table("mesh")?;
        let mesh = match mesh_table.clone() {
            Some(table) => params::read_mesh(table, contact, solver.error_estimate)?,
            None => params::default_mesh(contact, solver.error_estimate),
        };
        let supply = match root.optional_table("inlet")? {
            Some(table) => {
                let along = Hertz::new(&contact.along_motion(), modulus);
                inlet::read(table, contact, along.half_width, mesh_table.as_ref())?
            }
            None => Supply::Flooded,
        };
        let stress = root.optional_table("stress")?;
        let stress = stress.map(|table| stress::read(table, folder, &geometry.hertz));
        let (stress, unusual) = stress.transpose()?.unzip();
        warnings.extend(unusual.unwrap_or_default());
        let is_in_time = root.contains("transient");
        let output = root.optional_table("output")?;
        let output = output.map(|table| params::read_output(table, &solver, contact, is_in_time));
        Ok(Self {
            output: output.transpose()?.unwrap_or_default(),
            solver,
            thermal,
            lubricant,
            friction_by_law,
            mesh,
            supply,
            stress,
            warnings,
        })
    }
}
