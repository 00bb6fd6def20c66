//! The contacts of the teeth of a pair of spur or helical gears: one, or all along the path of contact.

mod dimensions;
mod load;
mod path;

pub use path::{GearLimits, GearMechanics};

use ertel_input::{Bounds, InputError, Table};
use ertel_machines::gear::{GearPair, Operation};
use ertel_quantity::Dimension;

use self::dimensions::Gearing;
use super::{Machine, Rows, Steel};
use crate::contact::Contact;
use crate::words::{force, length};

/// Places on the line of action, m.
const POSITION: Bounds = Bounds::closed(-1e3, 1e3);
/// The pinion drives, in the direction that x has.
const PINION_SPEED: Bounds = Bounds::above_to(0.0, 1e6);
/// Points along the path of contact.
const POINTS: std::ops::RangeInclusive<i64> = 2..=1000;
/// Default number of them.
const USUAL_POINTS: i64 = 30;

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
    /// Keys of the module and the pressure angle.
    fn keys(self) -> [&'static str; 2] {
        match self {
            Teeth::Straight => ["module", "pressure_angle"],
            Teeth::Helical => ["normal_module", "normal_pressure_angle"],
        }
    }

    /// Names for a pair; they distinguish working pitch circles from the reference circles.
    fn names(self, pair: &GearPair) -> Names {
        let is_shifted = is_shifted(pair);
        match self {
            Teeth::Straight => Names {
                machine: "pinion (body 2) and wheel (body 1) of a spur gear",
                contact_ratio: "contact ratio",
                flanks: match is_shifted {
                    false => ["R_1 = r_1 sin α + s", "R_2 = r_2 sin α − s"],
                    true => ["R_1 = r_w1 sin α_w + s", "R_2 = r_w2 sin α_w − s"],
                },
                radius: "R = R_1 R_2/(R_1 + R_2)",
                force: "normal force T_1/(r_1 cos α)",
                source: "Stachowiak and Batchelor, chapter 7; ISO/TR 15144-1",
            },
            Teeth::Helical => Names {
                machine: "pinion (body 2) and wheel (body 1) of a helical gear",
                contact_ratio: "transverse contact ratio ε_α",
                flanks: match is_shifted {
                    false => ["R_1 = r_1 sin α_t + s", "R_2 = r_2 sin α_t − s"],
                    true => ["R_1 = r_w1 sin α_wt + s", "R_2 = r_w2 sin α_wt − s"],
                },
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
/// [`GearPair::curvature_radii`]: the direction across the line in the flanks is the normal of the plane of action, which lies in the
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
/// is not fed from its ends, so this speed has no effect.
/// Other laws of load sharing, and profile shifts, are those of [`ertel_machines::gear`].
/// Sources: Stachowiak and Batchelor, Engineering Tribology, chapter 7 (gear teeth); ISO/TR 15144-1 (local radii, speeds, load);
/// ISO 21771:2007 (helical geometry); ISO 6336-2 (1/ε_α, from an overlap of 1 on).
pub(super) fn read(
    table: &mut Table<'_>,
    kind: Teeth,
    steel: &Steel,
) -> Result<Machine, InputError> {
    if kind == Teeth::Straight && table.contains("helix_angle") {
        return Err(table
            .error("helix_angle", "the teeth of a spur gear are straight")
            .with_help(
                "use `kind = \"helical-gear\"` with `normal_module` and `normal_pressure_angle`, or remove `helix_angle`",
            ));
    }
    let gearing = dimensions::read(table, kind)?;
    let pair = &gearing.pair;
    let points = table
        .optional_integer("points", POINTS)?
        .unwrap_or(USUAL_POINTS);
    let position = read_position(table, pair)?;
    let (torque, stage) = dimensions::torque(table, gearing.template)?;
    let speed = table.required_quantity("pinion_speed", Dimension::ANGULAR_SPEED, PINION_SPEED)?;
    let [wheel, pinion] = steel.materials;
    let operation = Operation {
        pinion_torque: torque,
        pinion_speed: speed,
        materials: [pinion, wheel],
    };
    let sharing = load::read(table)?;
    let limits = path::limits(table)?;
    let folders = table.optional_bool("folders")?.unwrap_or(false);
    let Some(position) = position else {
        return path::read(
            table,
            path::Given {
                kind,
                gearing: &gearing,
                operation,
                stage,
                sharing,
                limits,
                points: usize::try_from(points).unwrap_or_default(),
                folders,
            },
        );
    };
    let share = load::share(table, kind, (pair, &operation), sharing, position)?;
    let flanks = pair.curvature_radii(position);
    let across = pair.base_helix_angle.cos();
    let [own, other] = flanks.map(|flank| [across / flank, 0.0]);
    let radius = pair.reduced_radius(position);
    let force = operation.base_force(pair);
    let line_load = share * force / pair.face_width;
    // Body 1 is the wheel.
    let contact = Contact::line(radius, line_load).between([other, own]);
    super::check_radii(table, &contact)?;
    let [pinion, wheel] = operation.surface_speeds(pair, position);
    let motion = super::motion(table, "pinion_speed", pinion, wheel)?;
    let mut rows = Rows::default();
    add_rows(&mut rows, kind, &gearing, stage, &operation);
    add_contact_rows(&mut rows, kind, pair, &operation, (position, line_load));
    let mut warnings = gearing.warnings.clone();
    warnings.extend(load::warnings(pair, sharing));
    Ok(Machine {
        bulk_temperature: limits.bulk_temperature,
        warnings,
        ..Machine::of_contact(contact, motion, load_key(stage), rows)
    })
}

/// The key that the load comes from.
fn load_key(stage: Option<i64>) -> &'static str {
    match stage {
        Some(_) => "load_stage",
        None => "pinion_torque",
    }
}

/// Whether a pair does not work at its reference circles.
fn is_shifted(pair: &GearPair) -> bool {
    let change = pair.working_radii[0] - pair.reference_radii[0];
    change.abs() > 1e-9 * pair.reference_radii[0]
}

/// Rows of the report about the pair.
fn add_rows(
    rows: &mut Rows,
    kind: Teeth,
    gearing: &Gearing,
    stage: Option<i64>,
    operation: &Operation,
) {
    let pair = &gearing.pair;
    let names = kind.names(pair);
    rows.text("machine", names.machine);
    if let Some(template) = gearing.template {
        rows.text("template", template.words);
    }
    if gearing.tips_estimated {
        rows.text(
            "estimated",
            "the tip diameters of the template: values in common use, not verified against a standard",
        );
    }
    if let Some(stage) = stage {
        let torque = crate::words::digits(operation.pinion_torque, 5);
        rows.text("load stage", format!("{stage}: {torque} N m"));
    }
    if kind == Teeth::Helical {
        let [alpha, beta] = [pair.pressure_angle, pair.base_helix_angle].map(f64::to_degrees);
        rows.number("transverse pressure angle α_t", alpha, "deg");
        rows.number("base helix angle β_b", beta, "deg");
    }
    if is_shifted(pair) {
        let [one, two] = pair.shifts.map(|x| format!("{x:.4}"));
        rows.text("profile shifts x_1, x_2", format!("{one}, {two}"));
        rows.number("centre distance a_w", 1e3 * pair.centre_distance, "mm");
        let angle = pair.working_pressure_angle.to_degrees();
        rows.number("working pressure angle α_w", angle, "deg");
        let [one, two] = pair.tip_radii.map(|r| format!("{:.3}", 2e3 * r.abs()));
        rows.text("tip diameters", format!("{one} mm, {two} mm"));
    }
    rows.text("path of contact", interval([pair.points.a, pair.points.e]));
    rows.number(names.contact_ratio, pair.contact_ratio, "");
    if kind == Teeth::Helical {
        rows.number("overlap ratio b sin β/(π m_n)", pair.overlap_ratio, "");
        let lines = ertel_machines::gear::path::mean_line_length(pair);
        rows.length("contact lines b ε_α/cos β_b", lines);
    }
}

/// Rows about one contact at the position (m), under the load (N/m).
fn add_contact_rows(
    rows: &mut Rows,
    kind: Teeth,
    pair: &GearPair,
    operation: &Operation,
    (position, load): (f64, f64),
) {
    let names = kind.names(pair);
    rows.number("position s from the pitch point", 1e3 * position, "mm");
    let flanks = pair.curvature_radii(position);
    for (name, flank) in names.flanks.into_iter().zip(flanks) {
        match flank > 0.0 {
            true => rows.length(name, flank),
            false => rows.text(name, format!("{}, concave", length(-flank))),
        }
    }
    rows.length(names.radius, pair.reduced_radius(position));
    rows.number(names.force, operation.base_force(pair), "N");
    rows.text("load per length w", force(load, true, 6));
    let [pinion, wheel] = operation.surface_speeds(pair, position);
    rows.number("u_1 = ω_1 R_1", pinion, "m/s");
    rows.number("u_2 = ω_2 R_2", wheel, "m/s");
    if kind == Teeth::Helical {
        let along = operation.base_speed(pair) * pair.base_helix_angle.sin();
        rows.number("axial speed (no effect)", along, "m/s");
    }
    rows.text("source", names.source);
}

/// The place of the contact on the line of action, m from the pitch point and positive towards the pinion's tip; `None` of the whole path.
fn read_position(table: &mut Table<'_>, pair: &GearPair) -> Result<Option<f64>, InputError> {
    let position = match table.required_str("position")? {
        "path" => return Ok(None),
        "pitch point" => 0.0,
        _ => table
            .required_quantity("position", Dimension::LENGTH, POSITION)
            .map_err(|error| {
                error.with_help(
                    "`position` is \"pitch point\" or the distance from it along the line of action, negative towards the \
                     pinion's root, or \"path\" for all contacts",
                )
            })?,
    };
    let path = [pair.points.a, pair.points.e];
    let [pinion, wheel] = pair.curvature_radii(position);
    let exists = pinion > 0.0 && pinion * wheel / (pinion + wheel) > 0.0;
    if !(path[0]..=path[1]).contains(&position) || !exists {
        let text = format!(
            "the teeth do not touch here; `position` must be {}",
            interval(path)
        );
        return Err(table.error("position", text).with_help(
            "the path of contact ends at the addendum circles; `addendum_pinion` and `addendum_wheel` are the module if absent",
        ));
    }
    Ok(Some(position))
}

/// A path of contact (m) with whole micrometres, none of them beyond its ends.
fn interval(path: [f64; 2]) -> String {
    let [from, to] = path.map(|s| (1e6 * s).trunc() / 1e3);
    format!("from {from:.3} mm to {to:.3} mm")
}
