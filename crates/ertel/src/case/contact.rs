//! `[contact]`, and functions shared with `[machine]`.

use std::path::Path;

use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::Dimension;

use super::bodies::Shapes;
use crate::contact::curvature::{along, gap_between};
use crate::contact::{Contact, ContactKind, Hertz};

/// Radii from asperities to rolls, m: values outside indicate a wrong unit.
pub(super) const RADIUS: Bounds = Bounds::closed(1e-6, 1e3);
/// Ratio of the reduced radii of an ellipse.
pub(super) const MOST_SLENDER: f64 = 1000.0;
/// Directions of the motion, rad.
const ANGLE: Bounds = Bounds::closed(-std::f64::consts::PI, std::f64::consts::PI);

/// Reads `[contact]`; `reduced_modulus` in Pa converts a Hertz pressure to a load.
pub(super) fn read_contact(
    table: &mut Table<'_>,
    reduced_modulus: f64,
    shapes: Option<&Shapes>,
    folder: &Path,
) -> Result<Contact, InputError> {
    let kinds = ContactKind::ALL.map(|kind| (kind.name(), kind));
    let kind = table.required_choice("kind", &kinds)?;
    let mut contact = match kind {
        ContactKind::Elliptical => read_ellipse(table, shapes)?,
        kind if shapes.is_some() => {
            let name = kind.name();
            return Err(table
                .error(
                    "kind",
                    format!("a {name} contact has one reduced radius, but [bodies] gives the radii of both bodies"),
                )
                .with_help("kind = \"elliptical\" takes them"));
        }
        ContactKind::Roller => super::roller::read(table, reduced_modulus, folder)?,
        kind => {
            let radius = table.required_quantity("radius", Dimension::LENGTH, RADIUS)?;
            Contact::of_one_radius(kind, radius, 0.0)
        }
    };
    contact.load = match load_of_pressure(table, "load", &contact, reduced_modulus)? {
        Some(load) => load,
        None => {
            let dimension = match !kind.is_line() {
                true => Dimension::FORCE,
                false => Dimension::FORCE_PER_LENGTH,
            };
            let load = table.required_quantity("load", dimension, Bounds::POSITIVE);
            load.map_err(|error| match !kind.is_line() {
                true => error,
                false => {
                    error.with_help("the load of a line contact is per length, such as \"50 kN/m\"")
                }
            })?
        }
    };
    Ok(contact)
}

/// The load of a contact (N, or N/m of a line) under the `hertz_pressure` of a table, if given instead of
/// the key `load_key`; the load in `contact` is ignored, `reduced_modulus` in Pa.
pub(super) fn load_of_pressure(
    table: &mut Table<'_>,
    load_key: &str,
    contact: &Contact,
    reduced_modulus: f64,
) -> Result<Option<f64>, InputError> {
    let pressure = table.optional_quantity(
        "hertz_pressure",
        Dimension::PRESSURE,
        super::check::HERTZ_PRESSURE,
    )?;
    let Some(pressure) = pressure else {
        return Ok(None);
    };
    if table.contains(load_key) {
        return Err(table.error(
            "hertz_pressure",
            format!("`{load_key}` and `hertz_pressure` give the same quantity; keep one of them"),
        ));
    }
    let load = Hertz::load_for_pressure(contact, reduced_modulus, pressure);
    Ok(Some(load))
}

/// Radii and direction of the motion of an elliptical contact, without its load.
fn read_ellipse(table: &mut Table<'_>, shapes: Option<&Shapes>) -> Result<Contact, InputError> {
    let (radii, direction) = match shapes {
        Some(shapes) => radii_between(table, shapes)?,
        None => {
            let x = table.required_quantity("radius_x", Dimension::LENGTH, RADIUS);
            let x = x.map_err(|e| {
                e.with_help(
                    "reduced radii here, or radius_x and radius_y of both bodies in [bodies]",
                )
            })?;
            let y = table.required_quantity("radius_y", Dimension::LENGTH, RADIUS)?;
            ([x, y], 0.0)
        }
    };
    if let Some(ratio) = too_slender(radii) {
        return Err(table
            .error(
                if shapes.is_some() { "kind" } else { "radius_y" },
                format!("`radius_y` over `radius_x` is {ratio:.3e}, outside 1/{MOST_SLENDER} to {MOST_SLENDER}"),
            )
            .with_help("a contact so wide is a line contact: kind = \"line\" with the load per length"));
    }
    let angle = table.optional_quantity("entrainment_angle", Dimension::ANGLE, ANGLE)?;
    let contact = Contact::elliptical(radii, 0.0, angle.unwrap_or(0.0) - direction);
    Ok(match shapes {
        None => contact,
        Some(shapes) => contact.between([
            along(shapes.curvatures[0], direction),
            along(shapes.curvatures[1], direction - shapes.angle),
        ]),
    })
}

/// Reduced radii of two bodies, m, and the angle of the first principal direction to the x axis of body 1, rad.
fn radii_between(table: &mut Table<'_>, shapes: &Shapes) -> Result<([f64; 2], f64), InputError> {
    for key in ["radius_x", "radius_y"] {
        if table.contains(key) {
            return Err(table.error(
                key,
                format!(
                    "`{key}` follows from the radii of the bodies in [bodies]; remove one of them"
                ),
            ));
        }
    }
    let [one, two] = shapes.curvatures;
    let (curvatures, direction) = gap_between(one, two, shapes.angle);
    let least = curvatures[0].min(curvatures[1]);
    let largest = one.iter().chain(&two).fold(0.0_f64, |m, k| m.max(k.abs()));
    if least <= 1e-9 * largest {
        let shape = match least < -1e-9 * largest {
            true => {
                "are conformal or meet like a saddle: the gap between them closes away from the contact"
            }
            false => "touch along a line",
        };
        return Err(table
            .error("kind", format!("the bodies {shape}, and no Hertz ellipse exists"))
            .with_help(
                "convex radii are positive, concave ones negative, and a concave radius must exceed the convex one in it; \
                 for cylinders with parallel axes kind = \"line\"",
            ));
    }
    let radii = curvatures.map(|k| to_digits(k.recip()));
    if let Some(radius) = radii.into_iter().find(|r| !RADIUS.contains(*r)) {
        return Err(table.error(
            "kind",
            format!("the bodies have a reduced radius of {radius:.3e} m, outside 1 um to 1 km"),
        ));
    }
    Ok((radii, direction))
}

/// A number to 14 digits: sums of curvatures have rounding errors beyond them.
fn to_digits(value: f64) -> f64 {
    format!("{value:.13e}").parse().unwrap_or(value)
}

/// The ratio R_y/R_x of two reduced radii (m) where it is beyond those of ellipses.
pub(super) fn too_slender(radii: [f64; 2]) -> Option<f64> {
    let ratio = radii[1] / radii[0];
    (!(1.0 / MOST_SLENDER..=MOST_SLENDER).contains(&ratio)).then_some(ratio)
}
