//! A ball on a flat disc, as in film and traction rigs.

use ertel_input::{InputError, Table};

use super::{Machine, Rows, point_load, required_length};
use crate::case::motion::read_motion;
use crate::contact::Contact;

/// Reads the keys of `kind = "ball-on-disc"`; `reduced_modulus` in Pa.
///
/// 1/R = 2/D + 1/∞, with the diameter D of the ball in m (Johnson, Contact Mechanics, 1985, section 4.1: relative curvature).
pub(super) fn read(table: &mut Table<'_>, reduced_modulus: f64) -> Result<Machine, InputError> {
    let radius = match table.contains("ball_radius") {
        false => 0.5 * required_length(table, "ball_diameter")?,
        true if table.contains("ball_diameter") => {
            return Err(table.error(
                "ball_radius",
                "`ball_diameter` and `ball_radius` give the same quantity; keep one of them",
            ));
        }
        true => required_length(table, "ball_radius")?,
    };
    let mut contact = Contact::circular(radius, 0.0).between([[0.0; 2], [radius.recip(); 2]]);
    super::check_radii(table, &contact)?;
    contact.load = point_load(table, "load", &contact, reduced_modulus)?;
    let motion = read_motion(
        table,
        [
            ["disc_speed", "body_1_speed"],
            ["ball_speed", "body_2_speed"],
        ],
    )?;
    let mut rows = Rows::default();
    rows.text("machine", "ball (body 2) on disc (body 1)");
    rows.length("reduced radius R = D/2", contact.radius);
    rows.number("load", contact.load, "N");
    rows.number("speed of the ball", motion.body_2_speed(), "m/s");
    rows.number("speed of the disc", motion.body_1_speed(), "m/s");
    rows.text("source", "relative curvature: Johnson 1985, section 4.1");
    Ok(Machine::of_contact(contact, motion, "load", rows))
}
