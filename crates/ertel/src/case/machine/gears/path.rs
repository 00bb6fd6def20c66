//! All contacts along the path of contact.

use ertel_input::{Bounds, InputError, Table};
use ertel_machines::gear::{
    GearPair, LoadSharing, Meshing, Operation, PathLabel, PathParams, PathPoint,
};
use ertel_quantity::Dimension;

use super::super::whole::{Axis, Choice, MachineContact, WholeMachine, like};
use super::super::{Machine, Mechanics, Rows};
use super::dimensions::Gearing;
use super::{Teeth, load};
use crate::case::check::HERTZ_PRESSURE;
use crate::case::contact::RADIUS;
use crate::warning::{Warning, WarningKind};
use crate::words::digits;

/// Bulk and scuffing temperatures, K.
const TEMPERATURE: Bounds = Bounds::closed(150.0, 2000.0);
/// Permissible specific films.
const LAMBDA: Bounds = Bounds::above_to(0.0, 100.0);
/// Oil factors X_L.
const OIL_FACTOR: Bounds = Bounds::above_to(0.0, 10.0);
/// Roughness Ra, m.
const ROUGHNESS: Bounds = Bounds::above_to(0.0, 1e-3);

/// A pair of gears, how it runs, and its contacts.
#[derive(Clone, Debug)]
pub struct GearMechanics {
    /// The pair.
    pub pair: GearPair,
    /// Torque and speed.
    pub operation: Operation,
    /// The law of load sharing.
    pub sharing: LoadSharing,
    /// The contacts, in the order of those of the machine.
    pub path: Vec<PathPoint>,
    /// Further input.
    pub limits: GearLimits,
}

/// Inputs of friction and safety of gears.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct GearLimits {
    /// Temperature of the teeth, K; that of the lubricant if absent.
    pub bulk_temperature: Option<f64>,
    /// Contact temperature at which the oil lets teeth scuff, K.
    pub scuffing_temperature: Option<f64>,
    /// Specific film without micropitting λ_GFP.
    pub permissible_lambda: Option<f64>,
    /// Oil factor X_L of models of friction; 1 if absent.
    pub oil_factor: Option<f64>,
    /// Roughness Ra of the pinion and the wheel, m.
    pub roughness: Option<[f64; 2]>,
}

/// Reads them.
pub(super) fn limits(table: &mut Table<'_>) -> Result<GearLimits, InputError> {
    let bulk = table.optional_quantity("bulk_temperature", Dimension::TEMPERATURE, TEMPERATURE)?;
    let scuffing =
        table.optional_quantity("scuffing_temperature", Dimension::TEMPERATURE, TEMPERATURE)?;
    let lambda = table.optional_number("permissible_lambda", LAMBDA)?;
    let oil_factor = table.optional_number("oil_factor", OIL_FACTOR)?;
    let pinion = table.optional_quantity("pinion_ra", Dimension::LENGTH, ROUGHNESS)?;
    let wheel = table.optional_quantity("wheel_ra", Dimension::LENGTH, ROUGHNESS)?;
    let roughness = match (pinion, wheel) {
        (Some(pinion), Some(wheel)) => Some([pinion, wheel]),
        (None, None) => None,
        (Some(_), None) => return Err(table.missing("wheel_ra")),
        (None, Some(_)) => return Err(table.missing("pinion_ra")),
    };
    if let (Some(scuffing), Some(bulk)) = (scuffing, bulk)
        && scuffing <= bulk
    {
        return Err(table.error(
            "scuffing_temperature",
            "the teeth are hotter than this: `bulk_temperature`",
        ));
    }
    Ok(GearLimits {
        bulk_temperature: bulk,
        scuffing_temperature: scuffing,
        permissible_lambda: lambda,
        oil_factor,
        roughness,
    })
}

/// Input for the pair and its path.
pub(super) struct Given<'a> {
    pub kind: Teeth,
    pub gearing: &'a Gearing,
    pub operation: Operation,
    pub stage: Option<i64>,
    pub sharing: Option<LoadSharing>,
    pub limits: GearLimits,
    pub points: usize,
    pub folders: bool,
}

/// The machine of all contacts along the path.
pub(super) fn read(table: &mut Table<'_>, given: Given<'_>) -> Result<Machine, InputError> {
    if table.contains("load_share") {
        return Err(table
            .error("load_share", "this is the load of a single contact")
            .with_help("`load_sharing` sets how pairs of teeth share the load along the path"));
    }
    let Given {
        kind,
        gearing,
        operation,
        ..
    } = given;
    let pair = &gearing.pair;
    let sharing = given.sharing.unwrap_or(LoadSharing::Uniform);
    let params = PathParams {
        points: given.points,
        sharing,
        axial_position: 0.0,
    };
    let path = pair
        .path(&operation, &params)
        .map_err(|error| load::refused(table, &error))?;
    let contacts = contacts(&path, given.sharing.is_none());
    let Some(governing) = governing(&path, &contacts) else {
        return Err(table.error_here(
            "no contact along the path can be solved: loads and radii are out of range",
        ));
    };
    let point = &path[governing];
    let contact = point.contact();
    super::super::check_radii(table, &contact)?;
    let motion = super::super::motion(table, "pinion_speed", point.u_2, point.u_1)?;
    let mut rows = Rows::default();
    super::add_rows(&mut rows, kind, gearing, given.stage, &operation);
    rows.text("load sharing", load::name(sharing));
    rows.text("most loaded contact", contacts[governing].name.clone());
    let place = (point.position, point.load_per_length);
    super::add_contact_rows(&mut rows, kind, pair, &operation, place);
    let mut warnings = gearing.warnings.clone();
    warnings.extend(load::warnings(pair, Some(sharing)));
    warnings.extend(unsolved(&path, &contacts));
    let [pinion, wheel] = pair.teeth.map(f64::abs);
    let title = format!(
        "{}{} gear, {pinion} and {wheel} teeth, module {} mm",
        match pair.dimensions.meshing {
            Meshing::External => "",
            Meshing::Internal => "internal ",
        },
        match kind {
            Teeth::Straight => "spur",
            Teeth::Helical => "helical",
        },
        digits(1e3 * pair.dimensions.normal_module, 4),
    );
    Ok(Machine {
        bulk_temperature: given.limits.bulk_temperature,
        warnings,
        whole: Some(WholeMachine {
            title,
            mechanics: Mechanics::Gears(Box::new(GearMechanics {
                pair: pair.clone(),
                operation,
                sharing,
                path,
                limits: given.limits,
            })),
            contacts,
            axis: Axis::LineOfAction,
            governing,
            is_line: true,
            folders: given.folders,
        }),
        ..Machine::of_contact(contact, motion, super::load_key(given.stage), rows)
    })
}

/// The contact under the largest pressure; of equal ones the first.
fn governing(path: &[PathPoint], contacts: &[MachineContact]) -> Option<usize> {
    let solved = (0..path.len()).filter(|i| contacts[*i].like == Some(*i));
    solved.reduce(|best, i| {
        // Slightly more, as rounding must not choose among equal ones.
        match path[i].hertz_pressure > path[best].hertz_pressure * (1.0 + 1e-9) {
            true => i,
            false => best,
        }
    })
}

/// Contacts of the points; `is_even`: whether the file names no law of load sharing.
fn contacts(path: &[PathPoint], is_even: bool) -> Vec<MachineContact> {
    let apart: Vec<Option<[f64; 4]>> = (path.iter())
        .map(|point| {
            can_be_solved(point).then_some([
                point.load_per_length,
                point.reduced_radius,
                point.u_1,
                point.u_2,
            ])
        })
        .collect();
    (path.iter().zip(like(&apart)))
        .map(|(point, like)| {
            let mut keys = vec![(
                "position",
                Choice::Quantity(point.position, Dimension::LENGTH),
            )];
            if is_even {
                keys.push(("load_sharing", Choice::Name("uniform")));
            }
            MachineContact {
                name: name(point),
                keys,
                place: point.position,
                side: 0,
                load: point.load_per_length,
                // Without radius there is no bound, which files cannot hold.
                hertz_pressure: match point.hertz_pressure.is_finite() {
                    true => point.hertz_pressure,
                    false => 0.0,
                },
                like,
            }
        })
        .collect()
}

/// Whether a point is a contact of bodies under a load.
fn can_be_solved(point: &PathPoint) -> bool {
    point.load_per_length > 0.0
        && RADIUS.contains(point.reduced_radius)
        && HERTZ_PRESSURE.contains(point.hertz_pressure)
        && point.half_width < point.reduced_radius
}

/// Name of a point.
fn name(point: &PathPoint) -> String {
    let Some(label) = point.label else {
        return format!("s = {:.3} mm", 1e3 * point.position);
    };
    let words = match label {
        PathLabel::A => "tip of the wheel",
        PathLabel::B => "inner single contact",
        PathLabel::C => "pitch point",
        PathLabel::D => "outer single contact",
        PathLabel::E => "tip of the pinion",
    };
    format!("{label}, {words}")
}

/// Lists the loaded points that are not solved.
fn unsolved(path: &[PathPoint], contacts: &[MachineContact]) -> Option<Warning> {
    let of = path.iter().zip(contacts);
    let names: Vec<&str> = of
        .filter(|(point, contact)| point.load_per_length > 0.0 && contact.like.is_none())
        .map(|(_, contact)| contact.name.as_str())
        .collect();
    (!names.is_empty()).then(|| {
        Warning::new(
            WarningKind::NotSolved,
            format!(
                "not solved, as Hertz theory does not cover radii this small or pressures outside 1 kPa to 5 GPa: {}",
                names.join("; ")
            ),
        )
    })
}
