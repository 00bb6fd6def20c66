//! Dimensions of a pair of gears from the keys of a case file, or from a template.

use std::f64::consts::FRAC_PI_4;

use ertel_input::{Bounds, InputError, Table};
use ertel_machines::gear::fzg::{Gears, LeverArm, load_stage_torque};
use ertel_machines::gear::{
    GearDimensions, GearError, GearPair, GearWarning, Member, Meshing, Relief, ReliefShape,
    TipAlteration,
};
use ertel_quantity::Dimension;

use super::Teeth;
use crate::case::contact::RADIUS;
use crate::warning::{Warning, WarningKind};
use crate::words::length;

/// Pressure angles, rad.
const PRESSURE_ANGLE: Bounds = Bounds::open(0.0, FRAC_PI_4);
/// Helix angles at the reference cylinder, rad; the hand does not matter.
const HELIX_ANGLE: Bounds = Bounds::closed(0.0, FRAC_PI_4);
/// Profile shift coefficients.
const SHIFT: Bounds = Bounds::closed(-10.0, 10.0);
/// Tip reliefs, m.
const RELIEF: Bounds = Bounds::closed(0.0, 1e-2);

/// Test gears whose dimensions the program knows.
#[derive(Clone, Copy)]
pub(super) struct Template {
    pub gears: Gears,
    /// Description, with the values that are estimates.
    pub words: &'static str,
    teeth: Teeth,
    /// Whether the tip diameters are an estimate.
    tips_estimated: bool,
}

const fn template(gears: Gears, words: &'static str, teeth: Teeth, estimated: bool) -> Template {
    Template {
        gears,
        words,
        teeth,
        tips_estimated: estimated,
    }
}

/// Names of the templates.
const TEMPLATES: [(&str, Template); 6] = [
    (
        "FZG-A",
        template(
            Gears::A,
            "FZG type A, width 20 mm, a = 91.5 mm",
            Teeth::Straight,
            true,
        ),
    ),
    (
        "FZG-C",
        template(
            Gears::C,
            "FZG type C, width 14 mm, a = 91.5 mm",
            Teeth::Straight,
            true,
        ),
    ),
    (
        "FZG-C14",
        template(
            Gears::C14,
            "FZG type C, width 14 mm, tips that keep the clearance, a = 91.5 mm",
            Teeth::Straight,
            false,
        ),
    ),
    (
        "FZG-C40",
        template(
            Gears::C40,
            "FZG type C, width 40 mm, tips that keep the clearance, a = 91.5 mm",
            Teeth::Straight,
            false,
        ),
    ),
    (
        "FZG-H501",
        template(
            Gears::H501,
            "FZG type H501, a = 91.5 mm",
            Teeth::Helical,
            false,
        ),
    ),
    (
        "FZG-H701",
        template(
            Gears::H701,
            "FZG type H701, a = 91.5 mm",
            Teeth::Helical,
            false,
        ),
    ),
];

/// Keys of both gears, pinion first.
const ADDENDA: [&str; 2] = ["addendum_pinion", "addendum_wheel"];
const TIPS: [&str; 2] = ["pinion_tip_diameter", "wheel_tip_diameter"];
const ROOTS: [&str; 2] = ["pinion_root_diameter", "wheel_root_diameter"];
const WIDTHS: [&str; 2] = ["pinion_face_width", "wheel_face_width"];
const RELIEFS: [&str; 2] = ["pinion_tip_relief", "wheel_tip_relief"];
const SHIFTS: [&str; 2] = ["pinion_profile_shift", "wheel_profile_shift"];

/// A pair of gears, and where its dimensions come from.
pub(super) struct Gearing {
    pub pair: GearPair,
    pub template: Option<Template>,
    /// Whether its tip diameters are an estimate.
    pub tips_estimated: bool,
    pub warnings: Vec<Warning>,
}

/// Reads the dimensions.
pub(super) fn read(table: &mut Table<'_>, kind: Teeth) -> Result<Gearing, InputError> {
    let template = table.optional_choice("template", &TEMPLATES)?;
    if template.is_some_and(|template| template.teeth != kind) {
        return Err(table
            .error("template", "this template has the other kind of teeth")
            .with_help("FZG-H501 and FZG-H701 are helical gears, the others spur gears"));
    }
    let base = template.map(|template| template.gears.dimensions());
    let base = base.as_ref();
    let [module_key, angle_key] = kind.keys();
    let size = (Dimension::LENGTH, RADIUS);
    let module = or_template(table, module_key, size, base.map(|d| d.normal_module))?;
    let teeth = [
        teeth(table, "pinion_teeth", base.map(|d| d.teeth[0]))?,
        teeth(table, "wheel_teeth", base.map(|d| d.teeth[1]))?,
    ];
    let inclined = (Dimension::ANGLE, PRESSURE_ANGLE);
    let of_template = base.map(|d| d.normal_pressure_angle);
    let pressure_angle = or_template(table, angle_key, inclined, of_template)?;
    let helix_angle = match kind {
        Teeth::Straight => 0.0,
        Teeth::Helical => {
            let inclined = (Dimension::ANGLE, HELIX_ANGLE);
            or_template(table, "helix_angle", inclined, base.map(|d| d.helix_angle))?
        }
    };
    let internal = table.optional_bool("internal")?.unwrap_or(false);
    let meshing = match internal {
        true => Meshing::Internal,
        false => Meshing::External,
    };
    let reference = [0, 1].map(|i| module * f64::from(teeth[i]) / helix_angle.cos());
    let signs = [1.0, meshing.sign()];
    let [pinion_tip, wheel_tip] = [0, 1].map(|i| tip(table, i, reference[i], signs[i]));
    let own_tips = [pinion_tip?, wheel_tip?];
    let tip_diameters = [0, 1].map(|i| own_tips[i].or(base.and_then(|d| d.tip_diameters[i])));
    let [pinion_root, wheel_root] =
        ROOTS.map(|key| table.optional_quantity(key, Dimension::LENGTH, RADIUS));
    let keeps = table.optional_bool("keep_tip_clearance")?;
    let tip_alteration = match (keeps, base) {
        (Some(true), _) => TipAlteration::KeepClearance,
        (None, Some(base)) => base.tip_alteration,
        _ => TipAlteration::None,
    };
    let (pinion_shift, wheel_shift, centre_distance) = shifts(table, base)?;
    let dimensions = GearDimensions {
        meshing,
        pinion_shift,
        wheel_shift,
        centre_distance,
        tip_diameters,
        tip_alteration,
        root_diameters: [pinion_root?, wheel_root?],
        face_widths: widths(table, base)?,
        reliefs: reliefs(table)?,
        helix_angle,
        ..GearDimensions::spur(module, teeth, pressure_angle, 1.0)
    };
    let pair =
        GearPair::new(&dimensions).map_err(|error| refused(table, kind, &dimensions, &error))?;
    let warnings = pair.warnings.iter().map(warning_of).collect();
    Ok(Gearing {
        tips_estimated: template.is_some_and(|t| t.tips_estimated)
            && own_tips.iter().any(Option::is_none),
        pair,
        template,
        warnings,
    })
}

/// A quantity, which a template may give instead.
fn or_template(
    table: &mut Table<'_>,
    key: &str,
    (dimension, bounds): (Dimension, Bounds),
    of_template: Option<f64>,
) -> Result<f64, InputError> {
    match of_template {
        Some(value) => {
            let given = table.optional_quantity(key, dimension, bounds)?;
            Ok(given.unwrap_or(value))
        }
        None => table.required_quantity(key, dimension, bounds),
    }
}

fn teeth(table: &mut Table<'_>, key: &str, of_template: Option<u32>) -> Result<u32, InputError> {
    let range = 5..=10_000;
    let given = match of_template {
        Some(_) => table.optional_integer(key, range)?,
        None => Some(table.required_integer(key, range)?),
    };
    let given = given.and_then(|n| u32::try_from(n).ok());
    Ok(given.or(of_template).unwrap_or_default())
}

/// The tip diameter (m) of one gear, from its addendum over the reference diameter (m) or as such.
fn tip(
    table: &mut Table<'_>,
    gear: usize,
    reference: f64,
    sign: f64,
) -> Result<Option<f64>, InputError> {
    let addendum = table.optional_quantity(ADDENDA[gear], Dimension::LENGTH, Bounds::POSITIVE)?;
    let diameter = table.optional_quantity(TIPS[gear], Dimension::LENGTH, RADIUS)?;
    match (addendum, diameter) {
        (Some(_), Some(_)) => Err(table.error(
            TIPS[gear],
            format!(
                "`{}` and `{}` give the same quantity; keep one of them",
                ADDENDA[gear], TIPS[gear]
            ),
        )),
        (Some(addendum), None) => Ok(Some(reference + sign * 2.0 * addendum)),
        (None, diameter) => Ok(diameter),
    }
}

/// Profile shifts and the centre distance. Values of the file replace those of a template; values of the template that then disagree follow from
/// it.
fn shifts(
    table: &mut Table<'_>,
    base: Option<&GearDimensions>,
) -> Result<(f64, Option<f64>, Option<f64>), InputError> {
    let [pinion, wheel] = SHIFTS.map(|key| table.optional_number(key, SHIFT));
    let (pinion, wheel) = (pinion?, wheel?);
    let distance = table.optional_quantity("centre_distance", Dimension::LENGTH, RADIUS)?;
    let Some(base) = base else {
        return Ok((pinion.unwrap_or(0.0), wheel, distance));
    };
    let of_pinion = pinion.unwrap_or(base.pinion_shift);
    match (pinion.is_some() || distance.is_some(), wheel) {
        // Both shifts are given: the distance follows, unless it is given, too.
        (_, Some(wheel)) => Ok((of_pinion, Some(wheel), distance)),
        (true, None) => Ok((of_pinion, None, distance.or(base.centre_distance))),
        (false, None) => Ok((of_pinion, base.wheel_shift, base.centre_distance)),
    }
}

/// Face widths, m.
fn widths(table: &mut Table<'_>, base: Option<&GearDimensions>) -> Result<[f64; 2], InputError> {
    let [pinion, wheel] = WIDTHS.map(|key| table.optional_quantity(key, Dimension::LENGTH, RADIUS));
    let own = [pinion?, wheel?];
    let common = table.optional_quantity("face_width", Dimension::LENGTH, RADIUS)?;
    if let (Some(_), Some(i)) = (common, own.iter().position(Option::is_some)) {
        return Err(table.error(
            WIDTHS[i],
            format!(
                "`face_width` is that of both gears, and `{}` is given, too",
                WIDTHS[i]
            ),
        ));
    }
    let mut widths = [0.0; 2];
    for i in 0..2 {
        let found = own[i].or(common).or(base.map(|d| d.face_widths[i]));
        widths[i] = match found {
            Some(width) => width,
            None if own.iter().all(Option::is_none) => return Err(table.missing("face_width")),
            None => return Err(table.missing(WIDTHS[i])),
        };
    }
    Ok(widths)
}

/// Tip reliefs of both gears.
fn reliefs(table: &mut Table<'_>) -> Result<[Option<Relief>; 2], InputError> {
    let both = table.optional_quantity("tip_relief", Dimension::LENGTH, RELIEF)?;
    let [pinion, wheel] =
        RELIEFS.map(|key| table.optional_quantity(key, Dimension::LENGTH, RELIEF));
    let own = [pinion?, wheel?];
    let length = table.optional_quantity("tip_relief_length", Dimension::LENGTH, RADIUS)?;
    let shapes = [
        ("linear", ReliefShape::Linear),
        ("parabolic", ReliefShape::Parabolic),
    ];
    let shape = table
        .optional_choice("tip_relief_shape", &shapes)?
        .unwrap_or(ReliefShape::Linear);
    let amounts = own.map(|own| own.or(both));
    if amounts.iter().all(Option::is_none) {
        return match length {
            Some(_) => Err(table.missing("tip_relief")),
            None => Ok([None; 2]),
        };
    }
    let Some(length) = length else {
        return Err(table.missing("tip_relief_length").with_help(
            "the length of the relief along the path of contact, from its end at the tip",
        ));
    };
    Ok(amounts.map(|amount| {
        amount.map(|amount| Relief {
            amount,
            length,
            shape,
        })
    }))
}

/// The torque on the pinion, N·m, as such or by a load stage.
pub(super) fn torque(
    table: &mut Table<'_>,
    template: Option<Template>,
) -> Result<(f64, Option<i64>), InputError> {
    let stage = table.optional_integer("load_stage", 1..=14)?;
    let arms = [("long", LeverArm::Long), ("short", LeverArm::Short)];
    let arm = table.optional_choice("lever_arm", &arms)?;
    let Some(stage) = stage else {
        let torque =
            table.required_quantity("pinion_torque", Dimension::ENERGY, Bounds::POSITIVE)?;
        return match arm {
            Some(_) => Err(table.error("lever_arm", "`lever_arm` belongs to a `load_stage`")),
            None => Ok((torque, None)),
        };
    };
    if table.contains("pinion_torque") {
        return Err(table.error(
            "load_stage",
            "`pinion_torque` and `load_stage` give the same quantity; keep one of them",
        ));
    }
    if template.is_none() {
        return Err(table
            .error("load_stage", "load stages are those of the FZG rig")
            .with_help("give `template`, such as \"FZG-A\", or `pinion_torque`"));
    }
    let number = usize::try_from(stage).unwrap_or_default();
    match load_stage_torque(number, arm.unwrap_or(LeverArm::Long)) {
        Some(torque) => Ok((torque, Some(stage))),
        None => Err(table.error("load_stage", "load stages are from 1 to 14")),
    }
}

/// Says why a pair is refused, at the key to change.
fn refused(
    table: &mut Table<'_>,
    kind: Teeth,
    dimensions: &GearDimensions,
    error: &GearError,
) -> InputError {
    let mut key_of_tip = |member: Member| {
        let keys = [ADDENDA[member.index()], TIPS[member.index()]];
        let given = keys.into_iter().find(|key| table.contains(key));
        given.unwrap_or(kind.keys()[0])
    };
    match error {
        GearError::Pointed { member, .. } => {
            let key = key_of_tip(*member);
            let i = member.index();
            let reference =
                dimensions.normal_module * f64::from(dimensions.teeth[i]) / dimensions.helix_angle.cos();
            let tip = match dimensions.tip_diameters[i] {
                Some(tip) if key == ADDENDA[i] => {
                    format!("this addendum, {}", length(0.5 * (tip - reference).abs()))
                }
                _ => "their tip circle".to_owned(),
            };
            table
                .error(
                    key,
                    format!("the teeth of the {member} are pointed before {tip}: no tip remains"),
                )
                .with_help("addenda are about the module")
        }
        GearError::ContactRatio { ratio } => table
            .error_here(format!(
                "the transverse contact ratio of this pair is {ratio:.3}: its teeth do not take over from each other"
            ))
            .with_help("give longer addenda"),
        GearError::TipInsideBase {
            member,
            diameter,
            base,
        } => {
            let key = key_of_tip(*member);
            table.error(
                key,
                format!(
                    "the tip circle of the {member}, {}, is inside the base circle, {}, where there is no involute",
                    length(*diameter),
                    length(*base)
                ),
            )
        }
        GearError::Inconsistent { given, from_shifts } => table
            .error(
                "centre_distance",
                format!(
                    "the centre distance, {} mm, disagrees with {:.4} mm, which follows from the profile shifts",
                    1e3 * given,
                    1e3 * from_shifts
                ),
            )
            .with_help(
                "remove `centre_distance`, or `wheel_profile_shift`, which then follows from it",
            ),
        GearError::CentreDistance {
            centre_distance,
            smallest,
        } => table.error(
            "centre_distance",
            format!(
                "the centre distance, {}, is below {}, at which the base circles would touch",
                length(*centre_distance),
                length(*smallest)
            ),
        ),
        GearError::InternalTeeth { .. } | GearError::InternalTips { .. } => {
            table.error("wheel_teeth", error.to_string())
        }
        GearError::ProfileShift { .. } => table.error("wheel_profile_shift", error.to_string()),
        GearError::Value { .. } | GearError::Sharing { .. } => table.error_here(error.to_string()),
    }
}

/// A warning, in words.
fn warning_of(warning: &GearWarning) -> Warning {
    let text = match warning {
        GearWarning::BelowForm {
            member,
            form_diameter,
            contact_diameter,
        } => format!(
            "the {member} makes contact down to the diameter {:.4} mm, but a rack cutter makes no involute below {:.4} mm",
            1e3 * contact_diameter,
            1e3 * form_diameter
        ),
        GearWarning::NoClearance { member, clearance } => format!(
            "the tips of the {} reach {} into the root circle of the {member}",
            member.other(),
            length(clearance.abs())
        ),
        _ => warning.to_string(),
    };
    Warning::new(WarningKind::Gears, text)
}
