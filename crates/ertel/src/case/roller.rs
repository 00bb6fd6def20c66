//! `length`, `profile` and `misalignment` of a roller.

use ertel_rheology::input::{Bounds, InputError, Table};
use ertel_rheology::quantity::Dimension;

use super::contact::RADIUS;
use crate::contact::roller::{Profile, ProfileTable, Relief, Roller};
use crate::contact::{Contact, Hertz};
use crate::output::{digits, length};
use crate::warning::{Warning, WarningKind};

/// Tilts, rad, of which the film equation takes the cosine as 1.
const TILT: Bounds = Bounds::closed(-0.1, 0.1);
/// Drops from nanometres to the size of bodies, m.
const DROP: Bounds = Bounds::closed(0.0, 0.1);
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
pub(super) fn read(table: &mut Table<'_>, reduced_modulus: f64) -> Result<Contact, InputError> {
    let radius = table.required_quantity("radius", Dimension::LENGTH, RADIUS)?;
    let length = table.required_quantity("length", Dimension::LENGTH, RADIUS)?;
    let roller = read_roller(table, radius, length, reduced_modulus)?;
    Ok(Contact::of_roller(radius, 0.0, roller))
}

/// Reads `profile` and `misalignment` of a roller of the reduced radius and the length (m).
pub(super) fn read_roller(
    table: &mut Table<'_>,
    radius: f64,
    length: f64,
    reduced_modulus: f64,
) -> Result<Roller, InputError> {
    let mut keys = table.required_table("profile").map_err(|error| {
        error.with_help(
            "such as profile = { kind = \"straight\", straight_length = \"8 mm\", end_radius = \"50 mm\" }: the ends of a \
             roller need a relief, or the pressure there has no bound",
        )
    })?;
    let profile = read_profile(&mut keys, radius, length, reduced_modulus)?;
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
    radius: f64,
    length: f64,
    reduced_modulus: f64,
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
                    .with_help("the end radius exceeds half of what the straight part leaves of the length"));
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
            let position = table.required_quantities("position", Dimension::LENGTH, Bounds::ANY)?;
            let drop = table.required_quantities("drop", Dimension::LENGTH, DROP)?;
            let profile = ProfileTable::new(&position, &drop, length);
            Ok(Profile::Table(profile.map_err(|error| {
                table.error("position", format!("the table makes no profile: {error}"))
            })?))
        }
    }
}

/// A crown by its radius, or by how much it drops at the ends.
fn read_crown(table: &mut Table<'_>, length: f64) -> Result<Profile, InputError> {
    let half = 0.5 * length;
    let drop = table.optional_quantity("end_drop", Dimension::LENGTH, DROP)?;
    if let Some(drop) = drop {
        if table.contains("crown_radius") {
            return Err(table.error(
                "end_drop",
                "`crown_radius` and `end_drop` say the same thing twice; keep one of them",
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
            "so short a roller is no cylinder: kind = \"elliptical\", or another load or length",
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
                    "this tilt, {} mrad, lifts the whole roller off but for its end",
                    digits(1e3 * roller.misalignment, 4)
                ),
            )
            .with_help(
                "the film is found where the profile touches with its flank: a smaller tilt, or a profile that is steeper at the ends",
            )),
        Relief::Share(share) if share < SHARP => Err(table
            .error(
                "profile",
                format!(
                    "the ends of the roller fall off by {:.0} % of what makes the pressure uniform under this load: they press like \
                     sharp edges, at which the pressure of elastic bodies has no bound",
                    100.0 * share
                ),
            )
            .with_help("give the profile more relief (kind = \"logarithmic\" with this load has enough), or reduce the tilt")),
        Relief::Share(_) => Ok(()),
    }
}

/// What the user should know about the ends of a roller.
pub(super) fn warning(contact: &Contact, hertz: &Hertz, reduced_modulus: f64) -> Option<Warning> {
    let roller = contact.roller.as_ref()?;
    match roller.relief(contact.line_load(), hertz.half_width, reduced_modulus) {
        Relief::Share(share) if share < BARELY_RELIEVED => {
            let text = format!(
                "the ends of the roller fall off by {:.0} % of what makes the pressure uniform: the contact reaches them, where half-spaces \
                 are stiffer than the ends of real bodies",
                100.0 * share
            );
            Some(Warning::beyond(WarningKind::Other, 1.0 / share, text))
        }
        Relief::Share(_) | Relief::StandsOnEnd => None,
    }
}
