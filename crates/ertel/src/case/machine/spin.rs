//! Spin of a ball in an angular-contact bearing.

use ertel_input::{InputError, Table};

use super::Rows;
use super::bearing::Ring;

/// A ball between two grooves.
pub(super) struct BallInGrooves {
    /// D and d_m, m.
    pub diameter: f64,
    pub pitch_diameter: f64,
    /// Contact angle α, rad.
    pub angle: f64,
    /// ω_i − ω_o, rad/s.
    pub relative_speed: f64,
}

/// Reads `raceway_control`, and finds how ring and ball spin about the normal of their contact, rad/s, from x towards y, the normal
/// pointing from the ring to the ball.
///
/// A ball cannot roll on both raceways without spin on one of them. Where one raceway "controls" the ball, it spins on the other alone,
/// and the axis of the ball is inclined at β to that of the bearing. Seen from the cage, with γ' = D/d_m, γ = γ' cos α:
///
/// ```text
///   outer:  tan(α − β) = γ' sin α/(1 + γ)        inner:  tan(α − β) = −γ' sin α/(1 − γ)
///   ω_i' = (ω_i − ω_o)(1 + γ)/2,  ω_o' = −(ω_i − ω_o)(1 − γ)/2,  ω_b cos(α − β) = −ω_i' d_m(1 − γ)/D
///   inner contact: ring ω_i' sin α, ball ω_b sin(α − β);   outer contact: the same of ω_o', with the other sign
/// ```
/// Jones, J. Basic Eng. 81 (1959) 1-12; Harris and Kotzalas 2007, chapter 2 (the ratio of spin to rolling). Gyroscopic slip is left out.
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
        &[("inner", Ring::Inner), ("outer", Ring::Outer)],
    )?;
    let ratio = ball.diameter / ball.pitch_diameter;
    let (sin, cos) = ball.angle.sin_cos();
    let gamma = ratio * cos;
    let tan = match control {
        Ring::Outer => ratio * sin / (1.0 + gamma),
        Ring::Inner => -ratio * sin / (1.0 - gamma),
    };
    let inner = 0.5 * ball.relative_speed * (1.0 + gamma);
    let outer = -0.5 * ball.relative_speed * (1.0 - gamma);
    let of_ball = -inner * (1.0 - gamma) / ratio * tan;
    let spin = match ring {
        Ring::Inner => [inner * sin, of_ball],
        Ring::Outer => [-outer * sin, -of_ball],
    };
    rows.number("spin of the ring", spin[0], "rad/s");
    rows.number("spin of the ball", spin[1], "rad/s");
    Ok(spin)
}
