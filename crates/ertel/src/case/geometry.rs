//! Contact and motion: `[contact]` and `[motion]`, or `[machine]` instead.

use std::path::Path;

use ertel_input::{InputError, Table};

use super::bodies::Shapes;
use super::machine::{self, Steel};
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
        let (mut machine, mut body_radii) = (
            None,
            shapes.map_or([f64::INFINITY; 2], Shapes::smallest_radii),
        );
        let (mut load_key, mut kind_key) = ("load", "kind");
        let (contact, motion) = match &mut self {
            Tables::Plain(table, motion_table) => {
                let contact = contact::read_contact(table, reduced_modulus, shapes, folder)?;
                let found = root.required_table("motion");
                let found = found.map_err(|error| sections::missing(root, "motion", error))?;
                let keys = [
                    ["body_1_speed", "plane_speed"],
                    ["body_2_speed", "ball_speed"],
                ];
                (
                    contact,
                    motion::read_motion(motion_table.insert(found), keys)?,
                )
            }
            Tables::Machine(table) => {
                if shapes.is_some() {
                    return Err(table.error_here(
                        "the radii follow from [machine], but [bodies] gives some, too",
                    ));
                }
                let own = machine::read(table, steel, folder)?;
                (warnings, machine, body_radii) = (own.warnings, Some(own.echo), own.body_radii);
                (whole, bulk_temperature) = (own.whole, own.bulk_temperature);
                (load_key, kind_key) = (own.load_key, own.load_key);
                (own.contact, own.motion)
            }
        };
        let main = self.main();
        let advised = |error: InputError| match self {
            Tables::Plain(..) => error,
            Tables::Machine(_) => error.with_help(computed(&contact)),
        };
        let hertz = check::hertz(main, load_key, &contact, reduced_modulus).map_err(advised)?;
        let moving = match &self {
            Tables::Plain(_, Some(motion)) => motion,
            _ => main,
        };
        let can_spin = !contact.kind.is_line();
        motion::check_spin(moving, &motion, can_spin, reach(&contact, &hertz))?;
        super::roller::check(main, &contact, &hertz, reduced_modulus)?;
        check::body_size(main, kind_key, &hertz, body_radii).map_err(advised)?;
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
