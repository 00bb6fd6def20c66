//! The contact of two teeth of an external pair of spur or helical gears without profile shift.

use std::f64::consts::{FRAC_PI_4, PI};

use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::Dimension;

use super::involute::Pair;
use super::{Machine, Rows, required_length};
use crate::contact::Contact;
use crate::warning::{Warning, WarningKind};
use crate::words::{digits, length};

/// Pressure angles, rad.
const PRESSURE_ANGLE: Bounds = Bounds::open(0.0, FRAC_PI_4);
/// Helix angles at the pitch cylinder, rad; the hand does not matter.
const HELIX_ANGLE: Bounds = Bounds::closed(0.0, FRAC_PI_4);
/// Places on the line of action, m.
const POSITION: Bounds = Bounds::closed(-1e3, 1e3);
/// The pinion drives, in the direction that x has.
const PINION_SPEED: Bounds = Bounds::above_to(0.0, 1e6);

/// How the teeth run across the face.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Teeth {
    /// Along the axes.
    Straight,
    /// At an angle to them.
    Helical,
}

/// Names of formulas in the report.
struct Names {
    machine: &'static str,
    contact_ratio: &'static str,
    flanks: [&'static str; 2],
    radius: &'static str,
    force: &'static str,
    source: &'static str,
}

impl Teeth {
    fn names(self) -> Names {
        match self {
            Teeth::Straight => Names {
                machine: "pinion (body 2) and wheel (body 1) of a spur gear",
                contact_ratio: "contact ratio",
                flanks: ["R_1 = r_1 sin α + s", "R_2 = r_2 sin α − s"],
                radius: "R = R_1 R_2/(R_1 + R_2)",
                force: "normal force T_1/(r_1 cos α)",
                source: "Stachowiak and Batchelor, chapter 7; ISO/TR 15144-1",
            },
            Teeth::Helical => Names {
                machine: "pinion (body 2) and wheel (body 1) of a helical gear",
                contact_ratio: "transverse contact ratio ε_α",
                flanks: ["R_1 = r_1 sin α_t + s", "R_2 = r_2 sin α_t − s"],
                radius: "R = R_1 R_2/[(R_1 + R_2) cos β_b]",
                force: "force F_bt = T_1/(r_1 cos α_t)",
                source: "ISO 21771; ISO 6336-2; ISO/TR 15144-1",
            },
        }
    }
}

/// Reads the keys of `kind = "spur-gear"` and `kind = "helical-gear"`.
///
/// Both flanks are pressed together in the plane of action, which touches both base cylinders. The contact is a straight line in it,
/// inclined at β_b to the axes, and the surfaces move across the line at u = ω R, R being the transverse radii of curvature of
/// [`Pair::flank_radii`]: the direction across the line in the flanks is the normal of the plane of action, which lies in the
/// transverse section.
///
/// 1/R = (1/R_1 + 1/R_2) cos β_b,  u_1 = ω_1 R_1,  u_2 = ω_1 (z_1/z_2) R_2,  w = X T_1/(r_b1 b)
///
/// with ω_1 in rad/s, the torque T_1 in N·m, the face width b in m. Straight teeth take a share X of the load. Of helical ones the force
/// F_bt/cos β_b, F_bt = T_1/r_b1, presses on contact lines of the mean total length l:
///
/// l = b ε_α/cos β_b,  w = (F_bt/cos β_b)/l = F_bt/(b ε_α), that is X = 1/ε_α
///
/// Along the contact line both surfaces move at ω_1 r_b1 sin β_b: they do not slide there, and a film that does not change along the line
/// is not fed from its ends, so this speed does not count.
/// Sources: Stachowiak and Batchelor, Engineering Tribology, chapter 7 (gear teeth); ISO/TR 15144-1 (local radii, speeds, load);
/// ISO 21771:2007 (helical geometry); ISO 6336-2 (1/ε_α, from an overlap of 1 on).
pub(super) fn read(table: &mut Table<'_>, kind: Teeth) -> Result<Machine, InputError> {
    let [module_key, angle_key] = match kind {
        Teeth::Straight => ["module", "pressure_angle"],
        Teeth::Helical => ["normal_module", "normal_pressure_angle"],
    };
    if kind == Teeth::Straight && table.contains("helix_angle") {
        return Err(table
            .error("helix_angle", "the teeth of a spur gear are straight")
            .with_help(
                "use `kind = \"helical-gear\"` with `normal_module` and `normal_pressure_angle`, or remove `helix_angle`",
            ));
    }
    let module = required_length(table, module_key)?;
    let teeth = [
        table.required_integer("pinion_teeth", 5..=10_000)? as f64,
        table.required_integer("wheel_teeth", 5..=10_000)? as f64,
    ];
    let pressure_angle = table.required_quantity(angle_key, Dimension::ANGLE, PRESSURE_ANGLE)?;
    let helix_angle = match kind {
        Teeth::Straight => 0.0,
        Teeth::Helical => table.required_quantity("helix_angle", Dimension::ANGLE, HELIX_ANGLE)?,
    };
    let mut addendum =
        |key: &str| table.optional_quantity(key, Dimension::LENGTH, Bounds::POSITIVE);
    let addenda = [addendum("addendum_pinion")?, addendum("addendum_wheel")?]
        .map(|given| given.unwrap_or(module));
    let pair = Pair::new(module, pressure_angle, helix_angle, teeth, addenda);
    check_teeth(table, &pair)?;
    let warnings = undercut(&pair, teeth);
    let position = read_position(table, &pair)?;
    let flanks = pair.flank_radii(position);
    let radius = pair.reduced_radius(flanks);
    let across = pair.base_helix_angle.cos();
    let mut contact = Contact::line(radius, 0.0).between(flanks.map(|flank| [across / flank, 0.0]));
    super::check_radii(table, &contact)?;

    let width = required_length(table, "face_width")?;
    let torque = table.required_quantity("pinion_torque", Dimension::ENERGY, Bounds::POSITIVE)?;
    check_contact_ratio(table, &pair)?;
    let share = load_share(table, kind, &pair)?;
    let force = torque / pair.base_radius();
    contact.load = share * force / width;
    let omega = table.required_quantity("pinion_speed", Dimension::ANGULAR_SPEED, PINION_SPEED)?;
    let speeds = [omega * flanks[0], omega * teeth[0] / teeth[1] * flanks[1]];
    let motion = super::motion(table, "pinion_speed", speeds[0], speeds[1])?;

    let names = kind.names();
    let mut rows = Rows::default();
    rows.text("machine", names.machine);
    if kind == Teeth::Helical {
        let [alpha, beta] = [pair.pressure_angle, pair.base_helix_angle].map(f64::to_degrees);
        rows.number("transverse pressure angle α_t", alpha, "deg");
        rows.number("base helix angle β_b", beta, "deg");
    }
    rows.number("position s from the pitch point", 1e3 * position, "mm");
    rows.text("path of contact", interval(pair.path()));
    rows.number(names.contact_ratio, pair.contact_ratio(), "");
    if kind == Teeth::Helical {
        let overlap = width * helix_angle.sin() / (PI * module);
        rows.number("overlap ratio b sin β/(π m_n)", overlap, "");
        let lines = width * pair.contact_ratio() / pair.base_helix_angle.cos();
        rows.length("contact lines b ε_α/cos β_b", lines);
    }
    rows.length(names.flanks[0], flanks[0]);
    rows.length(names.flanks[1], flanks[1]);
    rows.length(names.radius, radius);
    rows.number(names.force, force, "N");
    rows.number("load per length w", contact.load, "N/m");
    rows.number("u_1 = ω_1 R_1", speeds[0], "m/s");
    rows.number("u_2 = ω_2 R_2", speeds[1], "m/s");
    if kind == Teeth::Helical {
        let along = omega * pair.base_radius() * pair.base_helix_angle.sin();
        rows.number("along the line, does not count", along, "m/s");
    }
    rows.text("source", names.source);
    Ok(Machine {
        contact,
        motion,
        load_key: "pinion_torque",
        body_radii: [f64::INFINITY; 2],
        warnings,
        echo: rows.echo(),
        whole: None,
    })
}

/// Keys of the addenda, pinion first, and what they are called.
const ADDENDA: [(&str, &str); 2] = [("addendum_pinion", "pinion"), ("addendum_wheel", "wheel")];

/// Refuses teeth that end in a point before their tip circle.
fn check_teeth(table: &Table<'_>, pair: &Pair) -> Result<(), InputError> {
    for (gear, (key, name)) in ADDENDA.into_iter().enumerate() {
        let thickness = pair.tip_thickness(gear);
        if thickness > 0.0 {
            continue;
        }
        return Err(table
            .error(
                key,
                format!(
                    "the teeth of the {name} are pointed before this addendum, {}: no tip is left",
                    length(pair.addenda[gear])
                ),
            )
            .with_help("addenda are about the module"));
    }
    Ok(())
}

/// Says so where the flank near the base circle is cut away.
fn undercut(pair: &Pair, teeth: [f64; 2]) -> Vec<Warning> {
    let cut = (0..2).filter(|gear| pair.is_undercut(*gear));
    cut.map(|gear| {
        let (own, other) = (ADDENDA[gear].1, ADDENDA[1 - gear].1);
        Warning::new(
            WarningKind::Gears,
            format!(
                "the tips of the {other} reach inside the base circle of the {own} ({} teeth): without profile shift its flanks are \
                 undercut there, and the path of contact is shorter than the one given here",
                digits(teeth[gear], 6)
            ),
        )
    })
    .collect()
}

/// Refuses pairs of which no two teeth touch at times.
fn check_contact_ratio(table: &Table<'_>, pair: &Pair) -> Result<(), InputError> {
    let ratio = pair.contact_ratio();
    if ratio >= 1.0 {
        return Ok(());
    }
    Err(table
        .error_here(format!(
            "the transverse contact ratio of this pair is {ratio:.3}: its teeth do not take over from each other"
        ))
        .with_help("give longer addenda"))
}

/// The share X of T_1/(r_b1 b) that is the load per length; of helical gears that of the mean length of the contact lines where it is absent.
fn load_share(table: &mut Table<'_>, kind: Teeth, pair: &Pair) -> Result<f64, InputError> {
    let bounds = Bounds::above_to(0.0, 1.0);
    if kind == Teeth::Straight || table.contains("load_share") {
        return table.required_number("load_share", bounds);
    }
    Ok(1.0 / pair.contact_ratio())
}

/// The place of the contact on the line of action, m from the pitch point and positive towards the pinion's tip.
fn read_position(table: &mut Table<'_>, pair: &Pair) -> Result<f64, InputError> {
    if table.required_str("position")? == "pitch point" {
        return Ok(0.0);
    }
    let position = table
        .required_quantity("position", Dimension::LENGTH, POSITION)
        .map_err(|error| {
            error.with_help(
                "`position` is \"pitch point\" or the distance from it along the line of action, negative towards the \
                 pinion's root",
            )
        })?;
    let path = pair.path();
    let ends = pair.flank_radii(position);
    if !(path[0]..=path[1]).contains(&position) || ends.iter().any(|radius| *radius <= 0.0) {
        let text = format!(
            "the teeth do not touch here; `position` must be {}",
            interval(path)
        );
        return Err(table.error("position", text).with_help(
            "the path of contact ends at the addendum circles; `addendum_pinion` and `addendum_wheel` are the module if absent",
        ));
    }
    Ok(position)
}

/// A path of contact (m) with whole micrometres, none of them beyond its ends.
fn interval(path: [f64; 2]) -> String {
    let [from, to] = path.map(|s| (1e6 * s).trunc() / 1e3);
    format!("from {from:.3} mm to {to:.3} mm")
}
