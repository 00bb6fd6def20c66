//! `[machine]`: contact and motion from the dimensions and speeds of a machine element.
//!
//! In a case file it replaces `[contact]` and `[motion]`. In `[bodies]`, `body_2` is the ball, the roller, the
//! pinion or the cam, and `body_1` the disc, the ring, the wheel or the tappet.

mod ball_bearing;
mod ball_on_disc;
mod bearing;
mod cam;
mod cam_turn;
mod gears;
mod loaded_bearing;
mod passage;
mod roller_bearing;
mod spin;
mod whole;

pub use cam_turn::CamMechanics;
pub use gears::{GearLimits, GearMechanics};
pub use loaded_bearing::{BearingMechanics, ContactKind, Contamination, LifeInputs, RatingBasis};
pub(super) use passage::Passage;
pub(super) use whole::contacts;
pub use whole::{Axis as MachineAxis, MachineContact, MachineContacts, RINGS, WholeMachine};

use std::path::Path;

use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::Dimension;

use loaded_bearing::Elements;

use super::contact::{MOST_SLENDER, RADIUS, load_of_pressure, too_slender};
use super::motion::{MAX_SPEED, check_entrainment};
use crate::case::MachineEcho;
use crate::contact::{Contact, Material, Motion};
use crate::warning::Warning;
use crate::words::{digits, length};

/// Angular speeds of machines, rad/s.
const ANGULAR_SPEED: Bounds = Bounds::closed(-1e6, 1e6);

/// The machine elements known.
#[derive(Clone, Copy)]
enum MachineKind {
    BallOnDisc,
    BallBearing,
    RollerBearing,
    SpurGear,
    HelicalGear,
    CamAndFlatTappet,
    Cam,
}

/// Their names; underscores may replace hyphens.
const KINDS: [(&str, MachineKind); 7] = [
    ("ball-on-disc", MachineKind::BallOnDisc),
    ("ball-bearing", MachineKind::BallBearing),
    ("roller-bearing", MachineKind::RollerBearing),
    ("spur-gear", MachineKind::SpurGear),
    ("helical-gear", MachineKind::HelicalGear),
    ("cam-and-flat-tappet", MachineKind::CamAndFlatTappet),
    ("cam", MachineKind::Cam),
];

/// Reads `kind`.
fn kind(table: &mut Table<'_>) -> Result<MachineKind, InputError> {
    let text = table
        .optional_str("kind")?
        .map(|text| text.replace('_', "-"));
    if text.is_none()
        && let Some(designation) = table.optional_str("designation")?
    {
        return Ok(match Elements::of_designation(designation) {
            // The lookup reports which bearings are available.
            Some(Elements::Balls) | None => MachineKind::BallBearing,
            Some(Elements::Rollers | Elements::TaperedRollers) => MachineKind::RollerBearing,
        });
    }
    match KINDS.iter().find(|(name, _)| text.as_deref() == Some(name)) {
        Some((_, kind)) => Ok(*kind),
        None => table.required_choice("kind", &KINDS),
    }
}

/// The contact that a machine has.
pub(super) struct Machine {
    pub contact: Contact,
    pub motion: Motion,
    /// The key that the load comes from.
    pub load_key: &'static str,
    /// Smallest radius of curvature of either body along x and y, m, where one fits into the other; infinite where the reduced radius is
    /// the smallest.
    pub body_radii: [f64; 2],
    /// Warnings.
    pub warnings: Vec<Warning>,
    pub echo: MachineEcho,
    /// All contacts, where the file selects no single one.
    pub whole: Option<WholeMachine>,
    /// Temperature of the bodies, K, where the machine gives it.
    pub bulk_temperature: Option<f64>,
}

impl Machine {
    /// One contact of bodies of which neither fits into the other.
    fn of_contact(contact: Contact, motion: Motion, load_key: &'static str, rows: Rows) -> Machine {
        Machine {
            contact,
            motion,
            load_key,
            body_radii: [f64::INFINITY; 2],
            warnings: Vec::new(),
            echo: rows.echo(),
            whole: None,
            bulk_temperature: None,
        }
    }
}

/// The mechanics of a machine.
#[derive(Clone, Debug)]
pub enum Mechanics {
    /// A rolling bearing.
    Bearing(Box<BearingMechanics>),
    /// A pair of gears.
    Gears(Box<GearMechanics>),
    /// A cam over a turn.
    Cam(Box<CamMechanics>),
}

/// Materials of the bodies of a machine.
pub(super) struct Steel {
    /// Reduced modulus of both, Pa.
    pub reduced_modulus: f64,
    /// Density of body 2, kg/m³, if known.
    pub density: Option<f64>,
    /// Elastic constants of body 1 and body 2.
    pub materials: [Material; 2],
}

/// Reads `[machine]`; the reduced modulus converts a Hertz pressure to a load.
pub(super) fn read(
    table: &mut Table<'_>,
    steel: &Steel,
    folder: &Path,
) -> Result<Machine, InputError> {
    let reduced_modulus = steel.reduced_modulus;
    match kind(table)? {
        MachineKind::BallOnDisc => ball_on_disc::read(table, reduced_modulus),
        MachineKind::BallBearing if is_loaded(table) => {
            loaded_bearing::read(table, Elements::Balls, steel)
        }
        MachineKind::RollerBearing if is_loaded(table) => {
            loaded_bearing::read(table, Elements::Rollers, steel)
        }
        MachineKind::BallBearing => ball_bearing::read(table, reduced_modulus),
        MachineKind::RollerBearing => roller_bearing::read(table, reduced_modulus, folder),
        MachineKind::SpurGear => gears::read(table, gears::Teeth::Straight, steel),
        MachineKind::HelicalGear => gears::read(table, gears::Teeth::Helical, steel),
        MachineKind::CamAndFlatTappet => cam::read(table, reduced_modulus),
        MachineKind::Cam => cam_turn::read(table, reduced_modulus, folder),
    }
}

/// Whether the file describes a bearing under its loads, and not a single contact of one.
fn is_loaded(table: &mut Table<'_>) -> bool {
    let loads = &loaded_bearing::LOADS;
    table.contains("designation") || loads.iter().any(|key| table.contains(key))
}

/// Rows of the echo: computed values and their formulas.
#[derive(Default)]
struct Rows(Vec<(String, String)>);

impl Rows {
    fn text(&mut self, name: &str, text: impl Into<String>) {
        self.0.push((name.to_owned(), text.into()));
    }

    /// A positive length, m.
    fn length(&mut self, name: &str, value: f64) {
        self.text(name, length(value));
    }

    fn number(&mut self, name: &str, value: f64, unit: &str) {
        let number = digits(value, 6);
        self.text(name, format!("{number} {unit}").trim_end());
    }

    fn echo(self) -> MachineEcho {
        MachineEcho { rows: self.0 }
    }
}

/// A length that machines have, m.
fn required_length(table: &mut Table<'_>, key: &str) -> Result<f64, InputError> {
    table.required_quantity(key, Dimension::LENGTH, RADIUS)
}

/// Refuses reduced radii that contacts cannot have.
fn check_radii(table: &Table<'_>, contact: &Contact) -> Result<(), InputError> {
    let radii = match !contact.kind.is_cylinder() {
        true => vec![("R_x", contact.radius), ("R_y", contact.radius_y)],
        false => vec![("R", contact.radius)],
    };
    if let Some((name, radius)) = radii.iter().find(|(_, radius)| !RADIUS.contains(*radius)) {
        return Err(table.error_here(format!(
            "the reduced radius {name} of this machine is {radius:.3e} m; it must be {}",
            RADIUS.describe("m")
        )));
    }
    let slender = match !contact.kind.is_cylinder() {
        true => too_slender([contact.radius, contact.radius_y]),
        false => None,
    };
    match slender {
        Some(ratio) => Err(table.error_here(format!(
            "the reduced radii of this machine have the ratio R_y/R_x = {ratio:.3e}, outside 1/{MOST_SLENDER} to {MOST_SLENDER}"
        ))),
        None => Ok(()),
    }
}

/// The load of a point contact, N, from `key` or from `hertz_pressure`.
fn point_load(
    table: &mut Table<'_>,
    key: &str,
    contact: &Contact,
    reduced_modulus: f64,
) -> Result<f64, InputError> {
    match load_of_pressure(table, key, contact, reduced_modulus)? {
        Some(load) => Ok(load),
        None => table.required_quantity(key, Dimension::FORCE, Bounds::POSITIVE),
    }
}

/// The load per length of a line contact, N/m, from the force at `key` over the `length` (m) that carries it, or from
/// `hertz_pressure`.
fn line_load(
    table: &mut Table<'_>,
    key: &str,
    length: f64,
    contact: &Contact,
    reduced_modulus: f64,
) -> Result<f64, InputError> {
    match load_of_pressure(table, key, contact, reduced_modulus)? {
        Some(load) => Ok(load),
        None => Ok(table.required_quantity(key, Dimension::FORCE, Bounds::POSITIVE)? / length),
    }
}

/// The motion of two surfaces (m/s) that comes from the angular speed at `key`.
///
/// u_m = (u_1 + u_2)/2,  SRR = (u_2 − u_1)/u_m
fn motion(
    table: &Table<'_>,
    key: &str,
    body_2_speed: f64,
    body_1_speed: f64,
) -> Result<Motion, InputError> {
    let entrainment_speed = 0.5 * (body_2_speed + body_1_speed);
    check_entrainment(table, key, entrainment_speed)?;
    if let Some(speed) = [body_2_speed, body_1_speed]
        .into_iter()
        .find(|speed| speed.abs() > MAX_SPEED)
    {
        return Err(table.error(
            key,
            format!("a surface moves at {speed:.3e} m/s; speeds go up to {MAX_SPEED} m/s"),
        ));
    }
    Ok(Motion::straight(
        entrainment_speed,
        (body_2_speed - body_1_speed) / entrainment_speed,
    ))
}

#[cfg(test)]
mod tests;
