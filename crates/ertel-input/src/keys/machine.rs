//! `[machine]`: a table for each kind.

use ertel_quantity::Dimension as D;

use super::Kind::{Choice, Count, Number, Quantity, QuantityOr, Switch, Table, Text};
use super::case::PROFILE;
use super::{ANGLE, FORCE, LENGTH, PRESSURE, ROTATION, SPEED};
use super::{Row, rows};
use crate::usual::{
    HERTZ_PRESSURE, LENGTHS, LIFT_ACCELERATION, LOAD, MODULES, RADII, ROTATIONS, SPEEDS, TORQUE,
};

/// Of thermal resistances.
const PER_WATT: D = D::TEMPERATURE_DIFFERENCE.per(D::POWER);
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
            (Jones 1959). Without this key the spin of a single contact is neglected; under bearing loads it is `"outer"`"#;
        designation: Text => r#"a bearing of the catalogue, such as `"6206"`, `"6306-2RS/C3"` or `"7210 B"`, in place of dimensions; each of them may
            still be given and then replaces that of the catalogue"#;
        balls: Count => "number of balls Z";
        radial_clearance: LENGTH => "radial internal clearance, negative where the balls are squeezed; in place of `contact_angle`";
        radial_load: FORCE => r#"force on the inner ring across the axis, at ball 0; with this key, `axial_load` or `axial_preload` the file describes
            [a bearing under its loads](#a-bearing-under-its-loads)"#;
        axial_load: FORCE => "force on the inner ring along the axis; optional, 0";
        axial_preload: LENGTH => "axial shift of the rings against each other beyond first touch, in place of `axial_load`";
        moment: Quantity(&[D::ENERGY]) => "tilting moment on the inner ring in the plane of the radial load; optional: the rings do not tilt";
        misalignment: ANGLE => "tilt of the inner ring in that plane, in place of `moment`";
        element: Count => "number of one ball, from 0 at the radial load on: with `ring`, its contact alone";
        folders: Switch => "whether the results of each contact are written into a folder of its own, too; optional, false";
        dynamic_load_rating, static_load_rating, fatigue_load_limit: FORCE => "C, C_0 and C_u of the catalogue; optional, computed by ISO 281 and ISO 76";
        contamination_factor: Number => "e_C of ISO 281, above 0 up to 1; without it or `grease_cleanliness` there is no modified life";
        grease_cleanliness: Choice(&["high", "normal", "typical-contamination", "severe-contamination", "very-severe-contamination"]) => r"e_C of a
            grease by its cleanliness, in place of `contamination_factor`";
        reliability: Number => "per cent, 90 to 99.95; optional, 90";
        ep_additives: Switch => "whether effective extreme-pressure additives are in the lubricant; optional, false";
        lubrication: Choice(&["oil-bath", "grease"]) => "how it comes to the bearing, for the models of friction beside the result; optional";
        thermal_resistance: Quantity(&[PER_WATT]) => r#"from the bearing to its surroundings (`"0.5 K/W"`), optional: the report tells the temperature
            that the heat of the contacts leads to"#;
        ambient_temperature: Quantity(&[D::TEMPERATURE]) => "of the surroundings, with `thermal_resistance`";
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
        misalignment: ANGLE => "as for [rollers](#rollers), only with a profile; under bearing loads the tilt of the inner ring; optional";
        designation: Text => r#"a bearing of the catalogue, such as `"NU 206 E"`, in place of dimensions"#;
        rollers: Count => "number of rollers Z";
        radial_clearance: LENGTH => "radial internal clearance";
        roller_profile: Choice(&["cylinder", "logarithmic"]) => "relief of the rollers under bearing loads: none, or the reference profile of ISO/TS 16281";
        radial_load: FORCE => r#"force on the inner ring across the axis, at roller 0; with this key the file describes
            [a bearing under its loads](#a-bearing-under-its-loads)"#;
        moment: Quantity(&[D::ENERGY]) => "tilting moment on the inner ring, in place of `misalignment`";
        element: Count => "number of one roller, from 0 at the radial load on: with `ring`, its contact alone";
        folders: Switch => "whether the results of each contact are written into a folder of its own, too; optional, false";
        dynamic_load_rating, static_load_rating, fatigue_load_limit: FORCE => "C, C_0 and C_u of the catalogue; without C there is no rating life";
        contamination_factor: Number => "e_C of ISO 281, above 0 up to 1; without it or `grease_cleanliness` there is no modified life";
        grease_cleanliness: Choice(&["high", "normal", "typical-contamination", "severe-contamination", "very-severe-contamination"]) => r"e_C of a
            grease by its cleanliness, in place of `contamination_factor`";
        reliability: Number => "per cent, 90 to 99.95; optional, 90";
        ep_additives: Switch => "whether effective extreme-pressure additives are in the lubricant; optional, false";
        lubrication: Choice(&["oil-bath", "grease"]) => "how it comes to the bearing, for the models of friction beside the result; optional";
        thermal_resistance: Quantity(&[PER_WATT]) => r#"from the bearing to its surroundings (`"0.5 K/W"`), optional"#;
        ambient_temperature: Quantity(&[D::TEMPERATURE]) => "of the surroundings, with `thermal_resistance`";
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
