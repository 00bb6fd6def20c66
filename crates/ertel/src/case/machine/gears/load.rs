//! The load of a pair of teeth: a given share, or a law of load sharing.

use ertel_input::{Bounds, InputError, Table};
use ertel_machines::gear::{GearError, GearPair, LoadSharing, Operation, ToothStiffness};
use ertel_quantity::Dimension;

use super::Teeth;
use crate::case::contact::RADIUS;
use crate::warning::{Warning, WarningKind};
use crate::words::length;

/// Stiffness of a pair of teeth per face width, Pa: 14 N/(mm µm) is 14 GPa.
const STIFFNESS: Bounds = Bounds::closed(1e3, 1e13);
/// Gear blank factor C_R of ISO 6336-1.
const BLANK: Bounds = Bounds::above_to(0.0, 2.0);

/// The laws by name.
#[derive(Clone, Copy)]
enum Law {
    Uniform,
    Thirds,
    MeanLength,
    Stiffness,
    Beams,
}

const LAWS: [(&str, Law); 5] = [
    ("uniform", Law::Uniform),
    ("thirds", Law::Thirds),
    ("mean-length", Law::MeanLength),
    ("stiffness", Law::Stiffness),
    ("beams", Law::Beams),
];

/// Reads the law of load sharing, if one is named.
pub(super) fn read(table: &mut Table<'_>) -> Result<Option<LoadSharing>, InputError> {
    let law = table.optional_choice("load_sharing", &LAWS)?;
    let stiffness = table.optional_quantity("tooth_stiffness", Dimension::PRESSURE, STIFFNESS)?;
    let blank = table.optional_number("blank_factor", BLANK)?;
    let [pinion, wheel] = ["pinion_bore_diameter", "wheel_bore_diameter"]
        .map(|key| table.optional_quantity(key, Dimension::LENGTH, RADIUS));
    let bores = [pinion?, wheel?];
    let by_stiffness = matches!(law, Some(Law::Stiffness));
    for (key, given) in [
        ("tooth_stiffness", stiffness.is_some()),
        ("blank_factor", blank.is_some()),
    ] {
        if given && !by_stiffness {
            return Err(table.error(key, "only `load_sharing = \"stiffness\"` uses this"));
        }
    }
    if stiffness.is_some() && blank.is_some() {
        return Err(table.error(
            "blank_factor",
            "this factor belongs to the stiffness of ISO 6336-1, but `tooth_stiffness` is given",
        ));
    }
    let is_by_beams = matches!(law, Some(Law::Beams));
    if bores.iter().any(Option::is_some) && !is_by_beams {
        let key = ["pinion_bore_diameter", "wheel_bore_diameter"][usize::from(bores[0].is_none())];
        return Err(table.error(key, "only `load_sharing = \"beams\"` uses this"));
    }
    Ok(match law {
        None => None,
        Some(Law::Uniform) => Some(LoadSharing::Uniform),
        Some(Law::Thirds) => Some(LoadSharing::Thirds),
        Some(Law::MeanLength) => Some(LoadSharing::MeanLength),
        Some(Law::Stiffness) => Some(LoadSharing::Stiffness(match stiffness {
            Some(stiffness) => ToothStiffness::Given(stiffness),
            None => ToothStiffness::Iso6336 {
                blank_factor: blank.unwrap_or(1.0),
            },
        })),
        Some(Law::Beams) => {
            let [Some(pinion), Some(wheel)] = bores else {
                let key = ["pinion_bore_diameter", "wheel_bore_diameter"]
                    [usize::from(bores[0].is_some())];
                return Err(table
                    .missing(key)
                    .with_help("the stiffness of the gear bodies depends on their bores"));
            };
            Some(LoadSharing::Stiffness(ToothStiffness::Beams {
                bore_radii: [0.5 * pinion, 0.5 * wheel],
            }))
        }
    })
}

/// Description of a law.
pub(super) fn name(law: LoadSharing) -> &'static str {
    match law {
        LoadSharing::Uniform => "even over all contact lines of the moment",
        LoadSharing::Thirds => "1/3 to 2/3 with two pairs, 1 with one: ISO/TR 15144-1",
        LoadSharing::MeanLength => "over the mean length of the contact lines: ISO 6336-2",
        LoadSharing::Stiffness(ToothStiffness::Given(_)) => {
            "by the stiffness of the teeth as given"
        }
        LoadSharing::Stiffness(ToothStiffness::Iso6336 { .. }) => {
            "by the stiffness of the teeth of ISO 6336-1"
        }
        LoadSharing::Stiffness(ToothStiffness::Beams { .. }) => {
            "by the stiffness of the teeth as beams"
        }
    }
}

/// The share X of F_bt/b of one contact: as given, by the law, or of helical gears without either that of the mean length of the contact lines.
pub(super) fn share(
    table: &mut Table<'_>,
    kind: Teeth,
    (pair, operation): (&GearPair, &Operation),
    law: Option<LoadSharing>,
    position: f64,
) -> Result<f64, InputError> {
    let given = table.optional_number("load_share", Bounds::above_to(0.0, 1.0))?;
    match (given, law) {
        (Some(_), Some(_)) => Err(table.error(
            "load_share",
            "`load_share` and `load_sharing` both define the load of this pair of teeth; keep one of them",
        )),
        (Some(share), None) => Ok(share),
        (None, Some(law)) => {
            let point = pair
                .contact_at(operation, law, position)
                .map_err(|error| refused(table, &error))?;
            if point.load_share > 0.0 {
                return Ok(point.load_share);
            }
            Err(table.error("position", "the teeth carry no load here"))
        }
        (None, None) if kind == Teeth::Helical => Ok(1.0 / pair.contact_ratio),
        (None, None) => Err(table
            .missing("load_share")
            .with_help("the share of the load that this pair of teeth carries, or a law in `load_sharing`")),
    }
}

/// Says why a law does not hold for the pair.
pub(super) fn refused(table: &Table<'_>, error: &GearError) -> InputError {
    table.error("load_sharing", error.to_string())
}

/// Warns about a relief that the law of a pair ignores: only stiffness includes it.
pub(super) fn warnings(pair: &GearPair, law: Option<LoadSharing>) -> Option<Warning> {
    let relief = pair.dimensions.reliefs.iter().flatten().next()?;
    if matches!(law, Some(LoadSharing::Stiffness(_))) || relief.amount == 0.0 {
        return None;
    }
    Some(Warning::new(
        WarningKind::Gears,
        format!(
            "the tip relief of {} has no effect: only load sharing by stiffness includes it",
            length(relief.amount)
        ),
    ))
}
