//! The contact of a roller with a raceway of a cylindrical roller bearing.

use std::path::Path;

use ertel_input::{InputError, Table};
use ertel_machines::bearing::geometry::radius_along;

use super::bearing::{SOURCE, gamma, radius_formula, read_ring, rolling};
use super::{Machine, Rows, line_load, required_length};
use crate::case::roller::read_roller;
use crate::contact::Contact;
use crate::words::force;

/// Reads the keys of `kind = "roller-bearing"`; `reduced_modulus` in Pa. Without a `profile` the contact is a line, under
/// the load per length of a roller without crowning that does not tilt.
pub(super) fn read(
    table: &mut Table<'_>,
    reduced_modulus: f64,
    folder: &Path,
) -> Result<Machine, InputError> {
    let ring = read_ring(table)?;
    let diameter = required_length(table, "roller_diameter")?;
    let pitch_diameter = required_length(table, "pitch_diameter")?;
    let length = required_length(table, "roller_length")?;
    // Cylindrical rollers have the contact angle 0.
    let gamma = gamma(table, "roller_diameter", diameter, pitch_diameter, 0.0)?;
    let radius = radius_along(ring, diameter, gamma);
    let own = 2.0 / diameter;
    let bodies = [[radius.recip() - own, 0.0], [own, 0.0]];
    let mut contact = Contact::line(radius, 0.0).between(bodies);
    super::check_radii(table, &contact)?;
    let line_load = line_load(table, "roller_load", length, &contact, reduced_modulus)?;
    contact.load = line_load;
    if table.contains("profile") {
        let roller = read_roller(table, (contact.radius, length), reduced_modulus, folder)?;
        contact = Contact::of_roller(contact.radius, line_load * length, roller).between(bodies);
    }
    let mut rows = Rows::default();
    rows.text(
        "machine",
        format!(
            "roller (body 2) on the {} ring (body 1) of a roller bearing",
            ring.name()
        ),
    );
    rows.number("γ = D/d_m", gamma, "");
    rows.length(radius_formula(ring), contact.radius);
    rows.number("load of the roller", line_load * length, "N");
    rows.text("load per length Q/l", force(line_load, true, 6));
    let (motion, _) = rolling(table, pitch_diameter, gamma, &mut rows)?;
    rows.text("source", SOURCE);
    Ok(Machine {
        body_radii: [0.5 * diameter, f64::INFINITY],
        ..Machine::of_contact(contact, motion, "roller_load", rows)
    })
}
