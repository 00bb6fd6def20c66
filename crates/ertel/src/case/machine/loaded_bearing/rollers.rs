//! Internal geometry of roller bearings.

use ertel_input::{InputError, Table};
use ertel_machines::bearing::catalogue::{Entry, Internal, Origin, Rollers, Sourced};
use ertel_machines::bearing::geometry::{Ring, RollerGeometry, RollerProfile, TaperedGeometry};
use ertel_quantity::Dimension;

use super::super::Rows;
use super::geometry::{ANGLE, CLEARANCE, RatingBasis, given_or, length_or, number_or, with_origin};
use crate::words::{digits, length};

/// Rollers of a table; what it does not have is that of the catalogue.
fn read_rollers(
    table: &mut Table<'_>,
    known: Option<Rollers>,
    rows: &mut Rows,
) -> Result<Rollers, InputError> {
    let mut found = Rollers {
        diameter: length_or(table, "roller_diameter", known.map(|k| k.diameter))?,
        length: length_or(table, "roller_length", known.map(|k| k.length))?,
        pitch_diameter: length_or(table, "pitch_diameter", known.map(|k| k.pitch_diameter))?,
        number: number_or(table, "rollers", known.map(|k| k.number))?,
        profile: known.map_or(Sourced::given(RollerProfile::Cylinder), |k| k.profile),
    };
    let chosen = table.optional_choice(
        "roller_profile",
        &[
            ("cylinder", RollerProfile::Cylinder),
            ("logarithmic", RollerProfile::Logarithmic),
        ],
    )?;
    if let Some(chosen) = chosen {
        found.profile = Sourced::given(chosen);
    }
    for (name, value) in [
        ("roller diameter D", &found.diameter),
        ("roller length L", &found.length),
        ("pitch diameter d_m", &found.pitch_diameter),
    ] {
        rows.text(name, with_origin(length(value.value), value.origin));
    }
    let number = found.number;
    rows.text(
        "rollers Z",
        with_origin(number.value.to_string(), number.origin),
    );
    Ok(found)
}

/// Where ratings come from, with further dimensions that they take.
fn ratings(rollers: &Rollers, entry: Option<&Entry>, others: &[Origin]) -> RatingBasis {
    let sizes = [
        rollers.diameter.origin,
        rollers.length.origin,
        rollers.number.origin,
    ];
    let others = [others, &[rollers.pitch_diameter.origin]].concat();
    RatingBasis::of(entry, &sizes, &others)
}

fn add_profile_rows(rollers: &Rollers, rows: &mut Rows) {
    let shape = match rollers.profile.value {
        RollerProfile::Cylinder => "none",
        RollerProfile::Crown(_) => "crowned",
        RollerProfile::Logarithmic => "logarithmic (ISO/TS 16281)",
    };
    let shape = with_origin(shape.to_owned(), rollers.profile.origin);
    rows.text("relief", shape);
}

/// Cylindrical rollers.
pub(super) fn read(
    table: &mut Table<'_>,
    entry: Option<&Entry>,
    rows: &mut Rows,
) -> Result<(RollerGeometry, RatingBasis), InputError> {
    let known = match entry.map(|entry| entry.internal) {
        Some(Internal::Cylindrical { rollers, clearance }) => Some((rollers, clearance)),
        _ => None,
    };
    let rollers = read_rollers(table, known.map(|k| k.0), rows)?;
    let gap = ("radial_clearance", Dimension::LENGTH, CLEARANCE);
    let clearance = given_or(table, gap, known.map(|k| k.1))?;
    let gap = format!("{} µm", digits(1e6 * clearance.value, 4));
    rows.text("radial clearance", with_origin(gap, clearance.origin));
    add_profile_rows(&rollers, rows);
    let geometry = rollers.cylindrical(clearance.value);
    Ok((geometry, ratings(&rollers, entry, &[])))
}

/// Tapered rollers, whose play depends on the adjustment of the bearing.
pub(super) fn read_tapered(
    table: &mut Table<'_>,
    entry: Option<&Entry>,
    rows: &mut Rows,
) -> Result<(TaperedGeometry, RatingBasis), InputError> {
    let known = match entry.map(|entry| entry.internal) {
        Some(Internal::Tapered {
            rollers,
            contact_angle,
        }) => Some((rollers, contact_angle)),
        _ => None,
    };
    if table.contains("radial_clearance") {
        return Err(table
            .error(
                "radial_clearance",
                "the play of tapered rollers depends on the adjustment of the bearing",
            )
            .with_help("give `axial_load` or `axial_preload`, which press its rings together"));
    }
    let rollers = read_rollers(table, known.map(|k| k.0), rows)?;
    let angle = ("contact_angle", Dimension::ANGLE, ANGLE);
    let contact_angle = given_or(table, angle, known.map(|k| k.1))?;
    let geometry = rollers.tapered(contact_angle.value);
    let degrees = |angle: f64| format!("{} deg", digits(angle.to_degrees(), 4));
    rows.text(
        "contact angle α of the cup",
        with_origin(degrees(contact_angle.value), contact_angle.origin),
    );
    rows.text(
        "contact angle of the cone",
        degrees(geometry.angle(Ring::Inner)),
    );
    add_profile_rows(&rollers, rows);
    let ratings = ratings(&rollers, entry, &[contact_angle.origin]);
    Ok((geometry, ratings))
}
