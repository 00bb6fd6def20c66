//! `[machine]`: a table for each kind.

use ertel_quantity::Dimension as D;

use super::Kind::{Choice, Count, Number, Quantity, QuantityOr, Table};
use super::case::PROFILE;
use super::{ANGLE, FORCE, LENGTH, PRESSURE, ROTATION, SPEED};
use super::{Row, rows};
use crate::usual::{
    HERTZ_PRESSURE, LENGTHS, LIFT_ACCELERATION, LOAD, MODULES, RADII, ROTATIONS, SPEEDS, TORQUE,
};

const RINGS: super::Kind = Choice(&["inner", "outer"]);
const POSITION: super::Kind = QuantityOr(&["pitch point"]);

/// The kinds of machines and the keys of each, without `kind`.
pub static MACHINES: &[(&str, &[Row])] = &[
    ("ball-on-disc", BALL_ON_DISC),
    ("ball-bearing", BALL_BEARING),
    ("roller-bearing", ROLLER_BEARING),
    ("spur-gear", SPUR_GEAR),
    ("helical-gear", HELICAL_GEAR),
    ("cam-and-flat-tappet", CAM),
];

rows! {
    BALL_ON_DISC {
        ball_diameter: LENGTH, usual [RADII] => "D; or `ball_radius`";
        ball_radius: LENGTH, usual [RADII], aside "in place of `ball_diameter`";
        load: FORCE, usual [LOAD] => "load F; or `hertz_pressure`";
        hertz_pressure: PRESSURE, usual [HERTZ_PRESSURE], aside "largest pressure of the dry contact, in place of the load";
        ball_speed, disc_speed: SPEED => r"speeds of both surfaces, with `skew_angle` between them; or `entrainment_speed` and
            `slide_to_roll_ratio`; spin and all other keys as in [`[motion]`](#motion)";
        entrainment_speed: SPEED, usual [SPEEDS], aside "mean of the speeds of disc and ball";
        slide_to_roll_ratio: Number, aside "speed of the ball less that of the disc, over their mean";
        slide_to_roll_ratio_across: Number, aside "the same across the entrainment direction; optional, 0";
        body_1_speed, body_2_speed: SPEED, aside "speeds of disc and ball";
        skew_angle: ANGLE, aside "angle from the velocity of the disc to that of the ball; optional, 0";
        body_1_spin, body_2_spin: ROTATION, aside "angular velocities of disc and ball about the contact normal; optional, 0";
    }
    BALL_BEARING {
        ring: RINGS => "the raceway of the contact";
        ball_diameter: LENGTH, usual [RADII] => "D";
        pitch_diameter: LENGTH, usual [LENGTHS] => "d_m";
        inner_groove_curvature, outer_groove_curvature: Number => r"f: radius of the groove over D, above 0.5, such as 0.52; that of the other
            ring is optional";
        contact_angle: ANGLE => "α, 0 to 90 deg";
        inner_ring_speed, outer_ring_speed: ROTATION, usual [ROTATIONS] => "ω_i and ω_o, signed; the latter is optional, 0 if absent";
        ball_load: FORCE, usual [LOAD] => "load of the ball, normal to the contact; or `hertz_pressure`";
        hertz_pressure: PRESSURE, usual [HERTZ_PRESSURE], aside "largest pressure of the dry contact, in place of the load";
        raceway_control: Choice(&["outer", "inner"]) => r#"optional: `"outer"` or `"inner"`, the raceway on which the ball rolls without spin
            (Jones 1959). Without this key, spin is neglected"#;
    }
    ROLLER_BEARING {
        ring: RINGS => "the raceway of the contact";
        roller_diameter: LENGTH, usual [RADII] => "D";
        roller_length: LENGTH, usual [LENGTHS] => "the effective (load-carrying) length l";
        pitch_diameter: LENGTH, usual [LENGTHS] => "d_m";
        inner_ring_speed, outer_ring_speed: ROTATION, usual [ROTATIONS] => "ω_i and ω_o, signed; the latter is optional, 0 if absent";
        roller_load: FORCE, usual [LOAD] => "load Q of the roller; or `hertz_pressure`";
        hertz_pressure: PRESSURE, usual [HERTZ_PRESSURE], aside "largest pressure of the dry contact, in place of the load";
        profile: Table(PROFILE) => "as for [rollers](#rollers); optional";
        misalignment: ANGLE => "as for [rollers](#rollers); optional, only with a profile";
    }
    SPUR_GEAR {
        module: LENGTH, usual [MODULES] => "m";
        pinion_teeth, wheel_teeth: Count => "z_1 and z_2";
        pressure_angle: ANGLE => "α, below 45 deg";
        face_width: LENGTH, usual [LENGTHS] => "b";
        pinion_torque: Quantity(&[D::ENERGY]), usual [TORQUE] => r#"T_1 (`"100 N.m"`), positive"#;
        pinion_speed: ROTATION, usual [ROTATIONS] => "ω_1, positive";
        position: POSITION => r#"`"pitch point"`, or the distance s from it along the line of action, negative towards the pinion's root. A
            position off the path of contact is an error, which shows the allowed interval"#;
        load_share: Number => "share X of the load that this pair of teeth carries, above 0 and up to 1";
        addendum_pinion, addendum_wheel: LENGTH => r"h_a, optional; the module if absent. Pointed teeth and contact ratios below 1 are errors;
            undercut is a warning";
    }
    HELICAL_GEAR {
        normal_module: LENGTH, usual [MODULES] => "m_n, in the section across the teeth";
        pinion_teeth, wheel_teeth: Count => "z_1 and z_2";
        normal_pressure_angle: ANGLE => "α_n, in the section across the teeth";
        helix_angle: ANGLE => "β at the pitch cylinder, 0 to 45 deg, of either hand";
        face_width: LENGTH, usual [LENGTHS] => "b";
        pinion_torque: Quantity(&[D::ENERGY]), usual [TORQUE] => "T_1, positive";
        pinion_speed: ROTATION, usual [ROTATIONS] => "ω_1, positive";
        position: POSITION => r#"`"pitch point"`, or the distance s from it along the line of action in a transverse section"#;
        load_share: Number => "optional: X in w = X T_1/(r_b1 b); 1/ε_α if absent";
        addendum_pinion, addendum_wheel: LENGTH => "h_a, optional; the normal module if absent";
    }
    CAM {
        base_radius: LENGTH, usual [RADII] => "radius r_b of the base circle";
        lift: LENGTH => "s(θ)";
        lift_acceleration: LENGTH, usual [LIFT_ACCELERATION] => "s'' = d²s/dθ², a length, with θ in rad; negative about the nose";
        cam_speed: ROTATION, usual [ROTATIONS] => "ω";
        width: LENGTH, usual [LENGTHS] => "width b of the contact";
        load: FORCE, usual [LOAD] => "load F; or `hertz_pressure`";
        hertz_pressure: PRESSURE, usual [HERTZ_PRESSURE], aside "largest pressure of the dry contact, in place of the load";
    }
}
