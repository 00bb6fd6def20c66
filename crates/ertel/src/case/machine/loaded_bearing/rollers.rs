//! Internal geometry of roller bearings.

use ertel_input::{InputError, Table};
use ertel_machines::bearing::catalogue::{Entry, Internal, Origin, Sourced};
use ertel_machines::bearing::geometry::{Ring, RollerGeometry, RollerProfile, TaperedGeometry};
use ertel_quantity::Dimension;

use super::super::Rows;
use super::geometry::{ANGLE, CLEARANCE, RatingBasis, length_or, number_or, origin};
use crate::words::{digits, length};

/// Data of both kinds of rollers.
struct Common {
    diameter: Sourced<f64>,
    length: Sourced<f64>,
    pitch_diameter: Sourced<f64>,
    number: Sourced<usize>,
    profile: Sourced<RollerProfile>,
}

/// The same of the catalogue.
type Known = Option<Common>;

/// A value with its origin, in words.
fn with_origin(value: String, how: Origin) -> String {
    format!("{value} ({})", origin(how))
}

impl Common {
    fn read(table: &mut Table<'_>, known: Known, rows: &mut Rows) -> Result<Common, InputError> {
        let known = known.as_ref();
        let mut found = Common {
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
    fn ratings(&self, entry: Option<&Entry>, others: &[Origin]) -> RatingBasis {
        let sizes = [self.diameter.origin, self.length.origin, self.number.origin];
        RatingBasis::of(
            entry,
            &sizes,
            &[others, &[self.pitch_diameter.origin]].concat(),
        )
    }

    fn add_profile_rows(&self, rows: &mut Rows) {
        let shape = match self.profile.value {
            RollerProfile::Cylinder => "none",
            RollerProfile::Crown(_) => "crowned",
            RollerProfile::Logarithmic => "logarithmic (ISO/TS 16281)",
        };
        rows.text("relief", with_origin(shape.to_owned(), self.profile.origin));
    }
}

/// Cylindrical rollers.
pub(super) fn read(
    table: &mut Table<'_>,
    entry: Option<&Entry>,
    rows: &mut Rows,
) -> Result<(RollerGeometry, RatingBasis), InputError> {
    let (mut common, mut gap) = (None, None);
    if let Some(Internal::Cylindrical {
        roller_diameter,
        length,
        pitch_diameter,
        number,
        clearance,
        profile,
    }) = entry.map(|entry| entry.internal)
    {
        common = Some(Common {
            diameter: roller_diameter,
            length,
            pitch_diameter,
            number,
            profile,
        });
        gap = Some(clearance);
    }
    let common = Common::read(table, common, rows)?;
    let given = table.optional_quantity("radial_clearance", Dimension::LENGTH, CLEARANCE)?;
    let clearance = match (given, gap) {
        (Some(given), _) => Sourced::given(given),
        (None, Some(known)) => known,
        (None, None) => return Err(table.missing("radial_clearance")),
    };
    let gap = format!("{} µm", digits(1e6 * clearance.value, 4));
    rows.text("radial clearance", with_origin(gap, clearance.origin));
    common.add_profile_rows(rows);
    let ratings = common.ratings(entry, &[]);
    let geometry = RollerGeometry {
        roller_diameter: common.diameter.value,
        length: common.length.value,
        pitch_diameter: common.pitch_diameter.value,
        number: common.number.value,
        clearance: clearance.value,
        profile: common.profile.value,
    };
    Ok((geometry, ratings))
}

/// Tapered rollers, whose play depends on the adjustment of the bearing.
pub(super) fn read_tapered(
    table: &mut Table<'_>,
    entry: Option<&Entry>,
    rows: &mut Rows,
) -> Result<(TaperedGeometry, RatingBasis), InputError> {
    let (mut common, mut angle) = (None, None);
    if let Some(Internal::Tapered {
        roller_diameter,
        length,
        pitch_diameter,
        number,
        contact_angle,
        profile,
    }) = entry.map(|entry| entry.internal)
    {
        common = Some(Common {
            diameter: roller_diameter,
            length,
            pitch_diameter,
            number,
            profile,
        });
        angle = Some(contact_angle);
    }
    if table.contains("radial_clearance") {
        return Err(table
            .error(
                "radial_clearance",
                "the play of tapered rollers depends on the adjustment of the bearing",
            )
            .with_help("give `axial_load` or `axial_preload`, which press its rings together"));
    }
    let common = Common::read(table, common, rows)?;
    let given = table.optional_quantity("contact_angle", Dimension::ANGLE, ANGLE)?;
    let contact_angle = match (given, angle) {
        (Some(given), _) => Sourced::given(given),
        (None, Some(known)) => known,
        (None, None) => return Err(table.missing("contact_angle")),
    };
    let geometry = TaperedGeometry {
        roller_diameter: common.diameter.value,
        length: common.length.value,
        pitch_diameter: common.pitch_diameter.value,
        number: common.number.value,
        cup_angle: contact_angle.value,
        profile: common.profile.value,
    };
    let degrees = |angle: f64| format!("{} deg", digits(angle.to_degrees(), 4));
    rows.text(
        "contact angle α of the cup",
        with_origin(degrees(contact_angle.value), contact_angle.origin),
    );
    rows.text(
        "contact angle of the cone",
        degrees(geometry.angle(Ring::Inner)),
    );
    common.add_profile_rows(rows);
    Ok((geometry, common.ratings(entry, &[contact_angle.origin])))
}
