//! `length`, `profile` and `misalignment` of a roller.

use std::path::Path;

use ertel_input::csv::{CsvError, CsvTable};
use ertel_input::file::{LARGEST_TABLE, read_text};
use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::Dimension;

use super::contact::RADIUS;
use crate::contact::roller::measured::{Trace, Treatment};
use crate::contact::roller::{Profile, ProfileTable, ProfileTableError, Relief, Roller};
use crate::contact::{Contact, Hertz};
use crate::warning::{Warning, WarningKind};
use crate::words::{digits, length};

/// Tilts, rad, of which the film equation takes the cosine as 1.
const TILT: Bounds = Bounds::closed(-0.1, 0.1);
/// Drops from nanometres to the size of bodies, m.
const DROP: Bounds = Bounds::closed(0.0, 0.1);
/// The same of traces, whose zero lies anywhere.
const TRACE: Bounds = Bounds::closed(-0.1, 0.1);
/// Largest change of a drop, over the largest drop, that passes for scatter of a trace.
const SCATTER: f64 = 0.1;
/// Half the length over the half-width of the contact, below which a roller is no cylinder.
const SHORTEST: f64 = 2.0;
/// Drop of the ends, in that which makes the pressure uniform, below which they carry like sharp edges,
const SHARP: f64 = 0.1;
/// and below which pressure may reach them.
const BARELY_RELIEVED: f64 = 0.75;

/// The kinds of profiles.
#[derive(Clone, Copy)]
enum Kind {
    Straight,
    Crown,
    Logarithmic,
    Iso16281,
    Table,
}

/// Reads the keys of `kind = "roller"` but for the load; `reduced_modulus` in Pa.
pub(super) fn read(
    table: &mut Table<'_>,
    reduced_modulus: f64,
    folder: &Path,
) -> Result<Contact, InputError> {
    let radius = table.required_quantity("radius", Dimension::LENGTH, RADIUS)?;
    let length = table.required_quantity("length", Dimension::LENGTH, RADIUS)?;
    let roller = read_roller(table, (radius, length), reduced_modulus, folder)?;
    Ok(Contact::of_roller(radius, 0.0, roller))
}

/// Reads `profile` and `misalignment` of a roller of the reduced radius and the length (m); a trace may lie in `folder`.
pub(super) fn read_roller(
    table: &mut Table<'_>,
    (radius, length): (f64, f64),
    reduced_modulus: f64,
    folder: &Path,
) -> Result<Roller, InputError> {
    let mut keys = table.required_table("profile").map_err(|error| {
        error.with_help(
            "such as profile = { kind = \"straight\", straight_length = \"8 mm\", end_radius = \"50 mm\" }: the ends of a \
             roller need a relief, or the pressure there is unbounded",
        )
    })?;
    let profile = read_profile(&mut keys, (radius, length), reduced_modulus, folder)?;
    keys.finish()?;
    let misalignment = table.optional_quantity("misalignment", Dimension::ANGLE, TILT)?;
    Ok(Roller {
        length,
        profile,
        misalignment: misalignment.unwrap_or(0.0),
    })
}

fn read_profile(
    table: &mut Table<'_>,
    (radius, length): (f64, f64),
    reduced_modulus: f64,
    folder: &Path,
) -> Result<Profile, InputError> {
    let kind = table.required_choice(
        "kind",
        &[
            ("straight", Kind::Straight),
            ("crown", Kind::Crown),
            ("logarithmic", Kind::Logarithmic),
            ("iso-16281", Kind::Iso16281),
            ("table", Kind::Table),
        ],
    )?;
    match kind {
        Kind::Straight => {
            let straight_length = table.required_quantity(
                "straight_length",
                Dimension::LENGTH,
                Bounds::from_to(0.0, length),
            )?;
            let end_radius = table.required_quantity("end_radius", Dimension::LENGTH, RADIUS)?;
            let reach = 0.5 * (length - straight_length);
            if end_radius <= reach {
                return Err(table
                    .error(
                        "end_radius",
                        format!(
                            "an arc of the radius {} does not reach from the straight part to the end, {} away",
                            self::length(end_radius),
                            self::length(reach)
                        ),
                    )
                    .with_help("the end radius must exceed half of the length outside the straight part"));
            }
            Ok(Profile::Straight {
                straight_length,
                end_radius,
            })
        }
        Kind::Crown => read_crown(table, length),
        Kind::Logarithmic => {
            let load =
                table.required_quantity("design_load", Dimension::FORCE, Bounds::POSITIVE)?;
            let line_load = load / length;
            let hertz = Hertz::new(&Contact::line(radius, line_load), reduced_modulus);
            let half_width = hertz.half_width;
            if 0.5 * length < SHORTEST * half_width {
                return Err(too_short(table, "design_load", length, half_width));
            }
            Ok(Profile::lundberg(
                length,
                line_load,
                half_width,
                reduced_modulus,
            ))
        }
        Kind::Iso16281 => {
            let diameter = table.required_quantity("diameter", Dimension::LENGTH, RADIUS)?;
            Ok(Profile::iso_16281(length, diameter))
        }
        Kind::Table => {
            let (key, trace) = read_trace(table, folder)?;
            let smoothing_length = table.optional_quantity(
                "smoothing_length",
                Dimension::LENGTH,
                Bounds::open(0.0, length),
            )?;
            let level = table.optional_bool("level")?.unwrap_or(false);
            table_profile(trace, length, (level, smoothing_length))
                .map(Profile::Table)
                .map_err(|error| table.error(key, format!("the table makes no profile: {error}")))
        }
    }
}

/// Positions and drops of a table or a file, with the key to blame.
fn read_trace(table: &mut Table<'_>, folder: &Path) -> Result<(&'static str, Trace), InputError> {
    let Some(file) = table.optional_str("file")? else {
        let position = table.required_quantities("position", Dimension::LENGTH, Bounds::ANY);
        let position = position.map_err(|error| error.with_help("or `file = \"trace.csv\"`"))?;
        let drop = table.required_quantities("drop", Dimension::LENGTH, TRACE)?;
        return Ok(("position", Trace { position, drop }));
    };
    if table.contains("position") || table.contains("drop") {
        return Err(table.error(
            "file",
            "`file` replaces `position` and `drop`: give one form",
        ));
    }
    let path = folder.join(file);
    let text = read_text(&path, LARGEST_TABLE)
        .map_err(|error| table.error("file", format!("{} {error}", path.display())))?;
    let trace = trace_of(file, &text).map_err(|error| {
        table.error("file", error.to_string()).with_help(
            "a trace is a CSV table with the columns `position` and `drop`, or `height`, which has the opposite sign, each with its unit: \
             position [mm], drop [um]",
        )
    })?;
    Ok(("file", trace))
}

/// The trace of a CSV file.
fn trace_of(file: &str, text: &str) -> Result<Trace, CsvError> {
    let csv = CsvTable::parse(file, text)?;
    let column = |name: &'static str| csv.find_with_unit(name, Dimension::LENGTH);
    let missing = |name: &str| csv.error(csv.header(), 0, format!("there is no column `{name}`"));
    let position = column("position")?.ok_or_else(|| missing("position"))?;
    let (drop, sign) = match column("drop")? {
        Some(drop) => (drop, 1.0),
        None => (column("height")?.ok_or_else(|| missing("drop"))?, -1.0),
    };
    let mut trace = Trace {
        position: Vec::new(),
        drop: Vec::new(),
    };
    for row in csv.rows() {
        let at = csv.required_number(row, &position)?;
        let z = sign * csv.required_number(row, &drop)?;
        if !TRACE.contains(z) {
            let must = TRACE.describe("m");
            return Err(csv.error(row, 0, format!("the drop {z:e} m must be {must}")));
        }
        trace.position.push(at);
        trace.drop.push(z);
    }
    Ok(trace)
}

/// The profile of a table. One that does not fall off towards both ends, or not from zero, is a measured trace: it is converted to a profile, as
/// long as the changes are within scatter.
fn table_profile(
    mut trace: Trace,
    length: f64,
    (level, smoothing_length): (bool, Option<f64>),
) -> Result<ProfileTable, ProfileTableError> {
    let tilt = if level && trace.position.len() == trace.drop.len() {
        trace.level()
    } else {
        0.0
    };
    let plain = ProfileTable::new(&trace.position, &trace.drop, length);
    let lowest = trace.drop.iter().copied().fold(f64::INFINITY, f64::min);
    let as_it_is = !level && smoothing_length.is_none() && lowest == 0.0;
    let may_be_trace = matches!(plain, Ok(_) | Err(ProfileTableError::Dip(_)));
    if !may_be_trace || (plain.is_ok() && as_it_is) {
        return plain;
    }
    if let Some(length) = smoothing_length {
        trace.smooth(length);
    }
    let half = trace.position.first() == Some(&0.0);
    let Some((fallen, treatment)) = trace.fallen(half) else {
        return plain;
    };
    let largest = fallen.drop.iter().copied().fold(0.0, f64::max);
    if let Err(error) = plain
        && treatment.largest_change > SCATTER * largest
    {
        return Err(error);
    }
    let mut profile = ProfileTable::new(&fallen.position, &fallen.drop, length)?;
    profile.treatment = Some(Treatment {
        tilt,
        smoothing_length: smoothing_length.unwrap_or(0.0),
        ..treatment
    });
    Ok(profile)
}

/// Treatment of a measured trace, in words.
fn treatment_text(treatment: &Treatment) -> String {
    let mut done = Vec::new();
    if treatment.tilt != 0.0 {
        done.push(format!(
            "levelled by {} mrad",
            digits(1e3 * treatment.tilt, 3)
        ));
    }
    if treatment.smoothing_length > 0.0 {
        done.push(format!(
            "averaged over {}",
            length(treatment.smoothing_length)
        ));
    }
    if treatment.shift != 0.0 {
        done.push(format!(
            "shifted by {} so that its smallest drop is zero",
            length(treatment.shift)
        ));
    }
    if treatment.largest_change > 0.0 {
        done.push(format!(
            "made to fall off towards both ends, by the nearest such profile, which moves its points by {} rms and {} at most",
            length(treatment.rms_change),
            length(treatment.largest_change)
        ));
    }
    format!(
        "the profile is a trace of {} points: {}",
        treatment.points,
        done.join("; ")
    )
}

/// A crown by its radius, or by how much it drops at the ends.
fn read_crown(table: &mut Table<'_>, length: f64) -> Result<Profile, InputError> {
    let half = 0.5 * length;
    let drop = table.optional_quantity("end_drop", Dimension::LENGTH, DROP)?;
    if let Some(drop) = drop {
        if table.contains("crown_radius") {
            return Err(table.error(
                "end_drop",
                "`crown_radius` and `end_drop` give the same quantity; keep one of them",
            ));
        }
        if drop <= 0.0 || drop >= half {
            return Err(table.error(
                "end_drop",
                format!(
                    "the drop at the ends must be above zero and below half the length, {}",
                    self::length(half)
                ),
            ));
        }
        // z = R − √(R² − l²/4)
        let crown_radius = (half * half + drop * drop) / (2.0 * drop);
        return Ok(Profile::Crown { crown_radius });
    }
    let crown_radius = table
        .required_quantity("crown_radius", Dimension::LENGTH, CROWN_RADIUS)
        .map_err(|error| error.with_help("or `end_drop`, how far the ends fall off"))?;
    if crown_radius <= half {
        return Err(table.error(
            "crown_radius",
            format!(
                "the crown radius is not larger than half the length, {}: such a roller is a barrel that ends before its length",
                self::length(half)
            ),
        ));
    }
    Ok(Profile::Crown { crown_radius })
}

/// Radii of crowns, m: a crown of 1 nm over 10 mm has 12 km.
const CROWN_RADIUS: Bounds = Bounds::closed(1e-6, 1e6);

fn too_short(table: &Table<'_>, key: &str, length: f64, half_width: f64) -> InputError {
    table
        .error(
            key,
            format!(
                "the roller, {} long, is shorter than {} half-widths of the contact, {} each",
                self::length(length),
                2.0 * SHORTEST,
                self::length(half_width)
            ),
        )
        .with_help(
            "such a short roller is not a cylinder: use kind = \"elliptical\", or another load or length",
        )
}

/// Whether a roller touches as rollers do: along a length beyond the width, and not on a sharp end.
///
/// # Errors
/// Rollers shorter than their contacts are wide, tilts that leave only an end in contact, and ends without relief.
pub(super) fn check(
    table: &Table<'_>,
    contact: &Contact,
    hertz: &Hertz,
    reduced_modulus: f64,
) -> Result<(), InputError> {
    let Some(roller) = &contact.roller else {
        return Ok(());
    };
    if 0.5 * roller.length < SHORTEST * hertz.half_width {
        return Err(too_short(table, "length", roller.length, hertz.half_width));
    }
    match roller.relief(contact.line_load(), hertz.half_width, reduced_modulus) {
        Relief::StandsOnEnd => Err(table
            .error(
                "misalignment",
                format!(
                    "this tilt, {} mrad, lifts the roller off its partner: only one end touches",
                    digits(1e3 * roller.misalignment, 4)
                ),
            )
            .with_help(
                "the roller must touch on the flank of its profile: reduce the tilt, or use a profile that is steeper at the ends",
            )),
        Relief::Share(share) if share < SHARP => Err(table
            .error(
                "profile",
                format!(
                    "the profile drop at the ends of the roller is {:.0} % of that for uniform pressure under this load: the ends act like \
                     sharp edges, where the elastic pressure is unbounded",
                    100.0 * share
                ),
            )
            .with_help("give the profile more relief (kind = \"logarithmic\" with this load has enough), or reduce the tilt")),
        Relief::Share(_) => Ok(()),
    }
}

/// Warnings about a roller: changes made to its trace, and pressure that reaches its ends.
pub(super) fn warnings(contact: &Contact, hertz: &Hertz, reduced_modulus: f64) -> Vec<Warning> {
    let roller = contact.roller.as_ref();
    let treatment = roller.and_then(|roller| match &roller.profile {
        Profile::Table(table) => table.treatment.as_ref(),
        _ => None,
    });
    let treated = treatment
        .map(|treatment| Warning::new(WarningKind::MeasuredProfile, treatment_text(treatment)));
    treated
        .into_iter()
        .chain(warning(contact, hertz, reduced_modulus))
        .collect()
}

/// Warnings about the ends of a roller.
fn warning(contact: &Contact, hertz: &Hertz, reduced_modulus: f64) -> Option<Warning> {
    let roller = contact.roller.as_ref()?;
    match roller.relief(contact.line_load(), hertz.half_width, reduced_modulus) {
        Relief::Share(share) if share < BARELY_RELIEVED => {
            let text = format!(
                "the profile drop at the ends of the roller is {:.0} % of that for uniform pressure: the contact reaches the ends, where \
                 half-spaces are stiffer than real bodies",
                100.0 * share
            );
            Some(Warning::beyond(WarningKind::RollerEnds, 1.0 / share, text))
        }
        Relief::Share(_) | Relief::StandsOnEnd => None,
    }
}
