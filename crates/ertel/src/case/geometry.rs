//! Contact and motion: `[contact]` and `[motion]`, or `[machine]` instead.

use std::path::Path;

use ertel_input::{InputError, Table};

use super::bodies::Shapes;
use super::machine::{self, Machine, Steel};
use super::{check, contact, motion, sections};
use crate::case::{MachineEcho, WholeMachine};
use crate::contact::motion::ROUNDING;
use crate::contact::{Contact, Hertz, Motion};
use crate::warning::Warning;
use crate::words::{force, length};

/// Contact and motion, and their tables.
pub(super) struct Geometry<'t> {
    pub contact: Contact,
    pub motion: Motion,
    pub machine: Option<MachineEcho>,
    /// All contacts of the machine.
    pub whole: Option<WholeMachine>,
    pub hertz: Hertz,
    /// Smallest radius of curvature of either body along x and along y, m, convex or concave; infinite where none is known or both are flat.
    pub body_radii: [f64; 2],
    /// Temperature of the bodies, K, where a machine gives it.
    pub bulk_temperature: Option<f64>,
    /// Warnings about the machine.
    pub warnings: Vec<Warning>,
    /// Not yet searched for unknown keys.
    pub tables: Tables<'t>,
}

/// The tables of the case file.
#[derive(Clone)]
pub(super) enum Tables<'t> {
    /// `[contact]` and, once it was read, `[motion]`.
    Plain(Table<'t>, Option<Table<'t>>),
    /// `[machine]`.
    Machine(Table<'t>),
}

impl<'t> Tables<'t> {
    /// Finds them.
    ///
    /// # Errors
    /// Neither `[contact]` nor `[machine]`, or `[machine]` together with one of the others.
    pub fn of(root: &mut Table<'t>) -> Result<Tables<'t>, InputError> {
        let Some(machine) = root.optional_table("machine")? else {
            let table = root.required_table("contact");
            let table = table.map_err(|error| sections::missing(root, "contact", error))?;
            return Ok(Tables::Plain(table, None));
        };
        for key in ["contact", "motion"] {
            if root.contains(key) {
                return Err(root
                    .error(
                        key,
                        format!("[{key}] and [machine] are both given, but [{key}] follows from [machine]"),
                    )
                    .with_help("give [machine] alone, or [contact] and [motion] without it"));
            }
        }
        Ok(Tables::Machine(machine))
    }

    /// Reads them; `steel` are the materials of the bodies, `shapes` those of the bodies, files that they name in `folder`.
    ///
    /// # Errors
    /// Missing keys, wrong units, and contacts that Hertz theory does not cover.
    pub fn read(
        mut self,
        root: &mut Table<'t>,
        steel: &Steel,
        shapes: Option<&Shapes>,
        folder: &Path,
    ) -> Result<Geometry<'t>, InputError> {
        let reduced_modulus = steel.reduced_modulus;
        let mut warnings = Vec::new();
        let (mut whole, mut bulk_temperature) = (None, None);
        let (contact, motion, machine, hertz, body_radii) = match &mut self {
            Tables::Plain(table, motion_table) => {
                let contact = contact::read_contact(table, reduced_modulus, shapes, folder)?;
                let found = root.required_table("motion");
                let found = found.map_err(|error| sections::missing(root, "motion", error))?;
                let motion_table = motion_table.insert(found);
                let motion = motion::read_motion(
                    motion_table,
                    [
                        ["body_1_speed", "plane_speed"],
                        ["body_2_speed", "ball_speed"],
                    ],
                )?;
                let hertz = check::hertz(table, "load", &contact, reduced_modulus)?;
                motion::check_spin(
                    motion_table,
                    &motion,
                    !contact.kind.is_line(),
                    reach(&contact, &hertz),
                )?;
                super::roller::check(table, &contact, &hertz, reduced_modulus)?;
                let body_radii = shapes.map_or([f64::INFINITY; 2], Shapes::smallest_radii);
                check::body_size(table, "kind", &hertz, body_radii)?;
                (contact, motion, None, hertz, body_radii)
            }
            Tables::Machine(table) => {
                if shapes.is_some() {
                    return Err(table.error_here(
                        "the radii follow from [machine], but [bodies] gives some, too",
                    ));
                }
                let Machine {
                    contact,
                    motion,
                    load_key,
                    body_radii,
                    warnings: own,
                    echo,
                    whole: all,
                    bulk_temperature: bulk,
                } = machine::read(table, steel, folder)?;
                warnings = own;
                (whole, bulk_temperature) = (all, bulk);
                let hertz = check::hertz(table, load_key, &contact, reduced_modulus)
                    .map_err(|error| error.with_help(computed(&contact)))?;
                motion::check_spin(
                    table,
                    &motion,
                    !contact.kind.is_line(),
                    reach(&contact, &hertz),
                )?;
                super::roller::check(table, &contact, &hertz, reduced_modulus)?;
                check::body_size(table, load_key, &hertz, body_radii)
                    .map_err(|error| error.with_help(computed(&contact)))?;
                (contact, motion, Some(echo), hertz, body_radii)
            }
        };
        Ok(Geometry {
            contact: without_rounding(contact),
            motion: motion.without_rounding(),
            machine,
            whole,
            hertz,
            body_radii,
            bulk_temperature,
            warnings,
            tables: self,
        })
    }

    /// The table that gives the kind of contact.
    pub fn main(&self) -> &Table<'t> {
        match self {
            Tables::Plain(table, _) | Tables::Machine(table) => table,
        }
    }

    /// Refuses unknown keys.
    ///
    /// # Errors
    /// The first of them.
    pub fn finish(self) -> Result<(), InputError> {
        match self {
            Tables::Plain(contact, motion) => {
                contact.finish()?;
                motion.map_or(Ok(()), Table::finish)
            }
            Tables::Machine(table) => table.finish(),
        }
    }
}

/// A contact whose angle is zero where it differs from zero by rounding only.
fn without_rounding(contact: Contact) -> Contact {
    let angle = contact.entrainment_angle;
    Contact {
        entrainment_angle: if angle.abs() < ROUNDING { 0.0 } else { angle },
        ..contact
    }
}

/// Extent of the contact from its centre, m.
pub(super) fn reach(contact: &Contact, hertz: &Hertz) -> f64 {
    let half_length = contact.roller.as_ref().map(|roller| 0.5 * roller.length);
    let across = half_length.or(hertz.half_width_y);
    across.map_or(hertz.half_width, |b| b.max(hertz.half_width))
}

/// Description of the contact of a machine, whose file gives none of these.
fn computed(contact: &Contact) -> String {
    let radii = match !contact.kind.is_cylinder() {
        true => format!(
            "radii R_x = {} and R_y = {}",
            length(contact.radius),
            length(contact.radius_y)
        ),
        false => format!("radius R = {}", length(contact.radius)),
    };
    let load = force(contact.load, contact.kind.is_line(), 4);
    format!("computed from [machine]: reduced {radii}, load {load}")
}
