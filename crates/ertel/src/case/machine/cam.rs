//! A cam that lifts a flat tappet.

use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::Dimension;

use super::{ANGULAR_SPEED, Machine, Rows, line_load, required_length};
use crate::contact::Contact;
use crate::words::{digits, force};

/// Lifts and their derivatives, m, as large as the radii.
const LIFT: Bounds = Bounds::closed(0.0, 1e3);
const LIFT_ACCELERATION: Bounds = Bounds::closed(-1e3, 1e3);

/// Reads the keys of `kind = "cam-and-flat-tappet"`; `reduced_modulus` in Pa.
///
/// The face of the tappet is at the height y = r_b + s(θ) above the axis of the cam, θ being the angle of the cam in rad and
/// ' the derivative by it; all lengths in m. A point of the cam at (x, y) moves at ω (−y, x), and normal to the face as fast
/// as the tappet, ω s': the contact is at x = s', and it travels along the face at ω s''. Seen from the contact, and with
/// x turned around, the surfaces move at
///
/// u_cam = ω (r_b + s) + ω s'' = ω ρ,  u_tappet = ω s'',  u_m = (ω/2)(r_b + s + 2 s'')
///
/// where the radius of curvature of the cam, that of the contact with a flat face too, is
///
/// ρ = r_b + s + s''
///
/// Sources: Norton, Cam Design and Manufacturing Handbook, 2002, chapter 7 (ρ of a flat-faced follower); Müller,
/// Motortechnische Zeitschrift 27, 1966, 58–61 (u_m). A tappet that turns about its own axis is not covered.
pub(super) fn read(table: &mut Table<'_>, reduced_modulus: f64) -> Result<Machine, InputError> {
    let base = required_length(table, "base_radius")?;
    let lift = table.required_quantity("lift", Dimension::LENGTH, LIFT)?;
    let acceleration =
        table.required_quantity("lift_acceleration", Dimension::LENGTH, LIFT_ACCELERATION)?;
    let radius = base + lift + acceleration;
    if radius <= 0.0 {
        return Err(table
            .error(
                "lift_acceleration",
                format!(
                    "the cam's radius of curvature ρ = base_radius + lift + lift_acceleration is {:.6} mm, but it must be positive",
                    1e3 * radius
                ),
            )
            .with_help("a flat tappet touches only convex parts of a cam"));
    }
    let mut contact = Contact::line(radius, 0.0).between([[0.0; 2], [radius.recip(), 0.0]]);
    super::check_radii(table, &contact)?;
    let width = required_length(table, "width")?;
    contact.load = line_load(table, "load", width, &contact, reduced_modulus)?;
    let omega = table.required_quantity("cam_speed", Dimension::ANGULAR_SPEED, ANGULAR_SPEED)?;
    let (cam, tappet) = (omega * radius, omega * acceleration);
    let motion = super::motion(table, "cam_speed", cam, tappet).map_err(|error| {
        error.with_help(format!(
            "u_m = (cam_speed/2)(base_radius + lift + 2 lift_acceleration) = {} m/s; where it is negative, as about the \
             nose, give `cam_speed` the other sign: x then points along the motion",
            digits(0.5 * (cam + tappet), 4)
        ))
    })?;
    let mut rows = Rows::default();
    rows.text("machine", "cam (body 2) on flat tappet (body 1)");
    rows.length("R = ρ = r_b + s + s''", contact.radius);
    rows.number("load", contact.load * width, "N");
    rows.text("load per length F/b", force(contact.load, true, 6));
    rows.number("u_cam = ω (r_b + s + s'')", cam, "m/s");
    rows.number("u_tappet = ω s''", tappet, "m/s");
    rows.number(
        "u_m = (ω/2)(r_b + s + 2 s'')",
        motion.entrainment_speed,
        "m/s",
    );
    rows.text("source", "Norton 2002, chapter 7 (ρ); Müller 1966 (u_m)");
    Ok(Machine::of_contact(contact, motion, "load", rows))
}
