//! The contact of a ball with a raceway of a ball bearing.

use std::f64::consts::FRAC_PI_2;

use ertel_input::{Bounds, InputError, Table};
use ertel_machines::bearing::geometry::{Ring, radius_along};
use ertel_machines::bearing::kinematics::{deformed_radius, heathcote_number};
use ertel_quantity::Dimension;

use super::bearing::{SOURCE, gamma, radius_formula, read_ring, rolling};
use super::spin::{self, BallInGrooves};
use super::{Machine, Rows, point_load, required_length};
use crate::contact::{Contact, Hertz, Motion};
use crate::words::digits;

/// Contact angles, rad: from radial to thrust bearings.
const ANGLE: Bounds = Bounds::closed(0.0, FRAC_PI_2);
/// Radius of the groove over the diameter of the ball: at 0.5 the groove is as narrow as the ball.
const CURVATURE: Bounds = Bounds::open(0.5, f64::INFINITY);

/// Reads the keys of `kind = "ball-bearing"`; `reduced_modulus` in Pa.
///
/// Across the motion the groove of the radius f D is concave, with the diameter D of the ball in m:
///
/// 1/R_y = 2/D − 1/(f D) = (2 − 1/f)/D
///
/// Source: Harris and Kotzalas 2007, chapter 2 (curvatures ρ of ball and raceways).
pub(super) fn read(table: &mut Table<'_>, reduced_modulus: f64) -> Result<Machine, InputError> {
    let ring = read_ring(table)?;
    let diameter = required_length(table, "ball_diameter")?;
    let pitch_diameter = required_length(table, "pitch_diameter")?;
    let angle = table.required_quantity("contact_angle", Dimension::ANGLE, ANGLE)?;
    let gamma = gamma(table, "ball_diameter", diameter, pitch_diameter, angle)?;
    let curvature = read_curvature(table, ring)?;
    let radii = [
        radius_along(ring, diameter, gamma),
        diameter / (2.0 - 1.0 / curvature),
    ];
    let ball = 2.0 / diameter;
    let ring_along = radii[0].recip() - ball;
    let mut contact = Contact::elliptical(radii, 0.0, 0.0)
        .between([[ring_along, radii[1].recip() - ball], [ball, ball]]);
    super::check_radii(table, &contact)?;
    contact.load = point_load(table, "ball_load", &contact, reduced_modulus)?;
    let mut rows = Rows::default();
    rows.text(
        "machine",
        format!(
            "ball (body 2) on the {} ring (body 1) of a ball bearing",
            ring.name()
        ),
    );
    rows.number("γ = D cos α/d_m", gamma, "");
    rows.length(radius_formula(ring), radii[0]);
    rows.length("R_y = D/(2 − 1/f)", radii[1]);
    rows.number("load of the ball", contact.load, "N");
    let (motion, speeds) = rolling(table, pitch_diameter, gamma, &mut rows)?;
    let ball = BallInGrooves {
        diameter,
        pitch_diameter,
        angle,
        speeds,
    };
    let motion = Motion {
        spin: spin::read(table, ring, &ball, &mut rows)?,
        ..motion
    };
    let hertz = Hertz::new(&contact, reduced_modulus);
    let heathcote = heathcote_number(
        hertz.half_width_y.unwrap_or(0.0),
        deformed_radius(curvature, diameter),
        radii[0],
    );
    rows.text(
        "Heathcote slip b²/(2 R_d R_x)",
        format!(
            "{} % at the ends of the ellipse, neglected: pure rolling is assumed over the ellipse",
            digits(100.0 * heathcote, 2)
        ),
    );
    rows.text("source", SOURCE);
    Ok(Machine {
        body_radii: [0.5 * diameter; 2],
        ..Machine::of_contact(contact, motion, "ball_load", rows)
    })
}

/// The curvature f of the groove of `ring`; that of the other ring may also be given, which allows changing `ring` alone.
fn read_curvature(table: &mut Table<'_>, ring: Ring) -> Result<f64, InputError> {
    let inner = table.optional_number("inner_groove_curvature", CURVATURE)?;
    let outer = table.optional_number("outer_groove_curvature", CURVATURE)?;
    let (curvature, key) = match ring {
        Ring::Inner => (inner, "inner_groove_curvature"),
        Ring::Outer => (outer, "outer_groove_curvature"),
    };
    curvature.ok_or_else(|| {
        table
            .missing(key)
            .with_help("the radius of the groove over the diameter of the ball, such as 0.52")
    })
}
