//! Spin of a ball in an angular-contact bearing.

use ertel_input::{InputError, Table};
use ertel_machines::bearing::geometry::Ring;
use ertel_machines::bearing::kinematics::{BallMotion, RacewayControl, Speeds};

use super::Rows;

/// A ball between two grooves.
pub(super) struct BallInGrooves {
    /// D and d_m, m.
    pub diameter: f64,
    pub pitch_diameter: f64,
    /// Contact angle α, rad, of both grooves.
    pub angle: f64,
    /// Of the rings.
    pub speeds: Speeds,
}

/// Reads `raceway_control`, and finds how ring and ball spin about the normal of their contact, rad/s, from x towards y, the normal pointing from the ring to
/// the ball: a ball cannot roll on both raceways without spin on one of them ([`BallMotion`]). Gyroscopic slip is neglected.
pub(super) fn read(
    table: &mut Table<'_>,
    ring: Ring,
    ball: &BallInGrooves,
    rows: &mut Rows,
) -> Result<[f64; 2], InputError> {
    if !table.contains("raceway_control") {
        return Ok([0.0; 2]);
    }
    let control = table.required_choice(
        "raceway_control",
        &[
            ("inner", RacewayControl::Inner),
            ("outer", RacewayControl::Outer),
        ],
    )?;
    let ratio = ball.diameter / ball.pitch_diameter;
    let motion = BallMotion::new(ratio, [ball.angle; 2], ball.speeds, control);
    let spin = motion.spin(ring, ball.angle, ball.speeds);
    rows.number("spin of the ring", spin[0], "rad/s");
    rows.number("spin of the ball", spin[1], "rad/s");
    Ok(spin)
}
