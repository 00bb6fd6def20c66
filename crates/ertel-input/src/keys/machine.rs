//! `[machine]`: a table for each kind.

use ertel_quantity::Dimension as D;

use super::Kind::{Choice, Count, Number, Quantities, Quantity, QuantityOr, Switch, Table, Text};
use super::{ANGLE, FORCE, LENGTH, PRESSURE, ROTATION, SPEED, TEMPERATURE};
use super::{Row, rows};
use crate::usual::{
    CLEARANCES, COATINGS, CROWNS, HEIGHTS, HERTZ_PRESSURE, LENGTHS, LIFT_ACCELERATION, LOAD,
    MODULES, RADII, ROTATIONS, SCUFFING, SPEEDS, TORQUE,
};

/// Dimension of thermal resistances.
const PER_WATT: D = D::TEMPERATURE_DIFFERENCE.per(D::POWER);
const RINGS: super::Kind = Choice(&["inner", "outer"]);
const POSITION: super::Kind = QuantityOr(&["pitch point", "path"]);
const CAM_ANGLE: super::Kind = QuantityOr(&["turn"]);
const TEMPLATES: super::Kind = Choice(&[
    "FZG-A", "FZG-C", "FZG-C14", "FZG-C40", "FZG-H501", "FZG-H701",
]);
const SHARING: super::Kind = Choice(&["uniform", "thirds", "mean-length", "stiffness", "beams"]);
const LIFT_LAWS: super::Kind = Choice(&["3-4-5", "4-5-6-7", "cycloidal", "harmonic"]);

/// The kinds of machines and the keys of each, without `kind`.
pub static MACHINES: &[(&str, &[Row])] = &[
    ("ball-on-disc", BALL_ON_DISC),
    ("ball-bearing", BALL_BEARING),
    ("roller-bearing", ROLLER_BEARING),
    ("spur-gear", SPUR_GEAR),
    ("helical-gear", HELICAL_GEAR),
    ("cam-and-flat-tappet", CAM_AND_TAPPET),
    ("cam", CAM),
];

rows! {
    BALL_ON_DISC {
        ball_diameter: LENGTH, usual [RADII] => "D; or `ball_radius`";
        ball_radius: LENGTH, usual [RADII], aside "instead of `ball_diameter`";
        load: FORCE, usual [LOAD] => "load F; or `hertz_pressure`";
        hertz_pressure: PRESSURE, usual [HERTZ_PRESSURE], aside "largest pressure of the dry contact, instead of the load";
        ball_speed, disc_speed: SPEED => r"speeds of both surfaces, with `skew_angle` between them; or `entrainment_speed` and
            `slide_to_roll_ratio`; spin and all other keys as in [`[motion]`](#motion)";
        entrainment_speed: SPEED, usual [SPEEDS], aside "mean of the speeds of disc and ball";
        slide_to_roll_ratio: Number, aside "speed of the ball less that of the disc, over their mean";
        slide_to_roll_ratio_across: Number, aside "the same across the entrainment direction; optional, 0";
        body_1_speed, body_2_speed: SPEED, aside "speeds of disc and ball";
        skew_angle: ANGLE, aside "angle from the velocity of the disc to that of the ball; optional, 0";
        body_1_spin, body_2_spin: ROTATION, aside "angular velocities of disc and ball about the contact normal; optional, 0";
    }
    BALLS {
        ring: RINGS => "the raceway of the contact";
        ball_diameter: LENGTH, usual [RADII] => "D";
        pitch_diameter: LENGTH, usual [LENGTHS] => "d_m";
        inner_groove_curvature, outer_groove_curvature: Number => r"f: radius of the groove over D, above 0.5, such as 0.52; that of the other
            ring is optional";
        contact_angle: ANGLE => "α, 0 to 90 deg";
        inner_ring_speed, outer_ring_speed: ROTATION, usual [ROTATIONS] => "ω_i and ω_o, signed; the latter is optional, 0 if absent";
        ball_load: FORCE, usual [LOAD] => "load of the ball, normal to the contact; or `hertz_pressure`";
        hertz_pressure: PRESSURE, usual [HERTZ_PRESSURE], aside "largest pressure of the dry contact, instead of the load";
        raceway_control: Choice(&["outer", "inner"]) => r#"optional: `"outer"` or `"inner"`, the raceway on which the ball rolls without spin
            (Jones 1959). Without this key the spin of a single contact is neglected; under bearing loads it is `"outer"`"#;
        designation: Text => r#"a bearing of the catalogue, such as `"6206"`, `"6306-2RS/C3"` or `"7210 B"`, instead of dimensions; each of them may
            still be given and then replaces that of the catalogue"#;
        balls: Count => "number of balls Z";
        radial_clearance: LENGTH, usual [CLEARANCES] => "radial internal clearance, negative where the balls are squeezed; instead of `contact_angle`";
        radial_load: FORCE => r#"force on the inner ring across the axis, at ball 0; with this key, `axial_load` or `axial_preload` the file describes
            [a bearing under its loads](#a-bearing-under-its-loads)"#;
        axial_load: FORCE => "force on the inner ring along the axis; optional, 0, except for angular contact bearings, which it must press together";
        axial_preload: LENGTH, usual [CLEARANCES] => "axial shift of the rings against each other beyond first touch, instead of `axial_load`";
        moment: Quantity(&[D::ENERGY]) => "tilting moment on the inner ring in the plane of the radial load; optional: the rings do not tilt";
        misalignment: ANGLE => "tilt of the inner ring in that plane, instead of `moment`";
        element: Count => "number of one ball, from 0 at the radial load on: with `ring`, its contact alone";
    }
    BALL_RESISTANCE {
        thermal_resistance: Quantity(&[PER_WATT]) => r#"from the bearing to its surroundings (`"0.5 K/W"`), optional: the report shows the temperature
            that results from the heat of the contacts"#;
    }
    ROLLERS {
        ring: RINGS => "the raceway of the contact";
        roller_diameter: LENGTH, usual [RADII] => "D";
        roller_length: LENGTH, usual [LENGTHS] => "the effective (load-carrying) length l";
        pitch_diameter: LENGTH, usual [LENGTHS] => "d_m";
        inner_ring_speed, outer_ring_speed: ROTATION, usual [ROTATIONS] => "ω_i and ω_o, signed; the latter is optional, 0 if absent";
        roller_load: FORCE, usual [LOAD] => "load Q of the roller; or `hertz_pressure`";
        hertz_pressure: PRESSURE, usual [HERTZ_PRESSURE], aside "largest pressure of the dry contact, instead of the load";
        profile: Table(PROFILE) => "as for [rollers](#rollers); optional";
        misalignment: ANGLE => "as for [rollers](#rollers), only with a profile; under bearing loads the tilt of the inner ring; optional";
        designation: Text => r#"a bearing of the catalogue, such as `"NU 206 E"` or `"30206"`, instead of dimensions"#;
        contact_angle: ANGLE => "α of the cup, half of its angle: with it, or by their designation, the rollers are tapered";
        rollers: Count => "number of rollers Z";
        radial_clearance: LENGTH, usual [CLEARANCES] => "radial internal clearance; not of tapered rollers";
        roller_profile: Choice(&["cylinder", "logarithmic"]) => "relief of the rollers under bearing loads: none, or the reference profile of ISO/TS 16281";
        radial_load: FORCE => r#"force on the inner ring across the axis, at roller 0; with this key the file describes
            [a bearing under its loads](#a-bearing-under-its-loads)"#;
        axial_load: FORCE => "of tapered rollers: force on the inner ring along the axis that presses the rings together";
        axial_preload: LENGTH, usual [CLEARANCES] => "of tapered rollers: axial shift of the rings against each other beyond first touch, instead of `axial_load`";
        moment: Quantity(&[D::ENERGY]) => "tilting moment on the inner ring, instead of `misalignment`";
        roller_contacts: Choice(&["lines", "finite"]), default "lines" => r#"how contacts are solved: `"lines"` under the mean load per length, or `"finite"`
            rollers over their whole length with relief and tilt"#;
        element: Count => "number of one roller, from 0 at the radial load on: with `ring`, its contact alone";
    }
    ROLLER_RESISTANCE {
        thermal_resistance: Quantity(&[PER_WATT]) => r#"from the bearing to its surroundings (`"0.5 K/W"`), optional"#;
    }
    /// Ratings and life of both kinds of bearings.
    BEARING_LIFE {
        folders: Switch => "whether the results of each contact are written into a separate folder, too; optional, false";
        dynamic_load_rating, static_load_rating, fatigue_load_limit: FORCE => "C, C_0 and C_u of the bearing's maker; optional";
        contamination_factor: Number => "e_C of ISO 281, above 0 up to 1; without it, `cleanliness` or `grease_cleanliness` there is no modified life";
        grease_cleanliness: Choice(&["high", "normal", "typical-contamination", "severe-contamination", "very-severe-contamination"]) => r"e_C of a
            grease by its cleanliness, instead of `contamination_factor`";
        cleanliness: Choice(&["extreme", "high", "normal", "slight-contamination", "typical-contamination", "severe-contamination",
            "very-severe-contamination"]) => r"e_C by the cleanliness of any lubricant, instead of `contamination_factor`: the middle of the guide values of
            ISO 281, table 13";
        reliability: Number => "per cent, 90 to 99.95; optional, 90";
        ep_additives: Switch => "whether effective extreme-pressure additives are in the lubricant; optional, false";
        lubrication: Choice(&["oil-bath", "grease"]) => "lubrication of the bearing, for the friction models shown with the result; optional";
    }
    SURROUNDINGS {
        ambient_temperature: Quantity(&[D::TEMPERATURE]) => "of the surroundings, with `thermal_resistance`";
        heat_balance: Switch => r"whether the contacts are solved again, with the lubricant at the temperature that results from their heat, until both agree within 0.1 K;
            starts at the temperature of the lubricant; optional, false";
    }
    SPUR_TEETH {
        module: LENGTH, usual [MODULES] => "m";
        pinion_teeth, wheel_teeth: Count => "z_1 and z_2";
        pressure_angle: ANGLE => "α, below 45 deg";
        face_width: LENGTH, usual [LENGTHS] => "b";
        pinion_torque: Quantity(&[D::ENERGY]), usual [TORQUE] => r#"T_1 (`"100 N.m"`), positive"#;
        pinion_speed: ROTATION, usual [ROTATIONS] => "ω_1, positive";
        position: POSITION => r#"`"path"` for all contacts along the path of contact, `"pitch point"`, or the distance s from it along the line of
            action, negative towards the pinion's root. A position off the path is an error, which shows the allowed interval"#;
        load_share: Number => r"of a single contact: share X of the load that this pair of teeth carries, above 0 and up to 1; or
            `load_sharing`";
        addendum_pinion, addendum_wheel: LENGTH => r"h_a, optional; the module if absent. Pointed teeth and contact ratios below 1 are errors;
            undercut is a warning";
    }
    HELICAL_TEETH {
        normal_module: LENGTH, usual [MODULES] => "m_n, in the section across the teeth";
        pinion_teeth, wheel_teeth: Count => "z_1 and z_2";
        normal_pressure_angle: ANGLE => "α_n, in the section across the teeth";
        helix_angle: ANGLE => "β at the pitch cylinder, 0 to 45 deg, of either hand";
        face_width: LENGTH, usual [LENGTHS] => "b";
        pinion_torque: Quantity(&[D::ENERGY]), usual [TORQUE] => "T_1, positive";
        pinion_speed: ROTATION, usual [ROTATIONS] => "ω_1, positive";
        position: POSITION => r#"`"path"` for all contacts along the path of contact, `"pitch point"`, or the distance s from it along the line of
            action in a transverse section"#;
        load_share: Number => "of a single contact, optional: X in w = X T_1/(r_b1 b); `load_sharing` or 1/ε_α if absent";
        addendum_pinion, addendum_wheel: LENGTH => "h_a, optional; the normal module if absent";
    }
    /// Rows of both kinds of teeth.
    GEARS {
        template: TEMPLATES => "optional: test gears of the FZG rig; every other key replaces one of their dimensions";
        load_stage: Count => "stage of the FZG rig, 1 to 14, instead of `pinion_torque`; only with a template";
        lever_arm: Choice(&["long", "short"]), default "long" => r#"of a load stage: `"long"` (0.5 m, ISO 14635-1) or `"short"` (0.35 m)"#;
        pinion_profile_shift, wheel_profile_shift: Number => r"x_1 and x_2, optional; that of the pinion is 0 if absent, that of the wheel
            follows from the centre distance, or is 0";
        centre_distance: LENGTH, usual [LENGTHS] => "a_w, optional; that without backlash if absent";
        pinion_tip_diameter, wheel_tip_diameter: LENGTH, usual [RADII] => r"d_a, optional, instead of the addenda; from the basic rack of ISO 53 if both are
            absent";
        pinion_root_diameter, wheel_root_diameter: LENGTH, usual [RADII] => "d_f, optional; from the basic rack if absent";
        keep_tip_clearance: Switch => "tips from the basic rack are shortened so as to keep its clearance; optional";
        internal: Switch => "whether the teeth of the wheel are inside; optional";
        pinion_face_width, wheel_face_width: LENGTH, usual [LENGTHS], aside "of gears of two widths, instead of `face_width`";
        tip_relief: LENGTH, usual [CLEARANCES] => "C_a of both gears, normal to the flank; optional. Load sharing by stiffness includes it";
        pinion_tip_relief, wheel_tip_relief: LENGTH, usual [CLEARANCES], aside "of one gear, instead of `tip_relief`";
        tip_relief_length: LENGTH => "along the path of contact, from its ends";
        tip_relief_shape: Choice(&["linear", "parabolic"]), default "linear" => "optional";
        load_sharing: SHARING => r#"optional: how pairs of teeth share the load. `"uniform"`: evenly over the contact lines (default of a path);
            `"thirds"`: 1/3 to 2/3 with two pairs (ISO/TR 15144-1); `"mean-length"`: over the mean length of the lines; `"stiffness"`: by that of
            ISO 6336-1 or `tooth_stiffness`; `"beams"`: by the stiffness of teeth as beams"#;
        tooth_stiffness: PRESSURE => "c' per face width (`\"14 GPa\"` is 14 N/(mm µm)); optional";
        blank_factor: Number => "C_R of ISO 6336-1; optional, 1";
        pinion_bore_diameter, wheel_bore_diameter: LENGTH, usual [RADII] => r#"bore diameter of the gear body, for `load_sharing = "beams"`"#;
        points: Count => "equally spaced points of a path, plus B, C and D; optional, 30";
        folders: Switch => "of a path: whether each contact has a folder of its results; optional";
        bulk_temperature: TEMPERATURE => "of the teeth and of the oil that enters the contacts, which is assumed to be as warm; with `[thermal]` of both bodies, unless that gives `body_1_temperature` and `body_2_temperature`; optional, that of the lubricant";
        scuffing_temperature: TEMPERATURE, usual [SCUFFING] => "contact temperature at which teeth scuff with this oil; optional, for a safety";
        permissible_lambda: Number => "specific film λ_GFP without micropitting; optional, for a safety";
        pinion_ra, wheel_ra: LENGTH, usual [HEIGHTS] => "roughness Ra of the flanks; optional, for specific films and models of friction";
        oil_factor: Number => "X_L of models of friction; optional, 1 (mineral oils)";
    }
    CAM_AND_TAPPET {
        base_radius: LENGTH, usual [RADII] => "radius r_b of the base circle";
        lift: LENGTH => "s(θ)";
        lift_acceleration: LENGTH, usual [LIFT_ACCELERATION] => "s'' = d²s/dθ², a length, with θ in rad; negative about the nose";
        cam_speed: ROTATION, usual [ROTATIONS] => "ω";
        width: LENGTH, usual [LENGTHS] => "width b of the contact";
        load: FORCE, usual [LOAD] => "load F; or `hertz_pressure`";
        hertz_pressure: PRESSURE, usual [HERTZ_PRESSURE], aside "largest pressure of the dry contact, instead of the load";
    }
    CAM {
        base_radius: LENGTH, usual [RADII] => "radius r_b of the base circle";
        lift: LENGTH => "full lift of `rise` or `lobes`";
        rise: Table(PART) => "the rise from θ = 0 on: `angle` and `law`";
        top_dwell: ANGLE => "angle at full lift; optional, 0";
        return: Table(PART) => "the return; optional, as the rise. The rest of the turn is the base circle";
        lobes: Count => "instead of `rise`: harmonic lobes, s = (h/2)(1 − cos nθ)";
        lift_table: Text => "instead of these: a CSV table with a column of the angle and one of the lift, each with its unit";
        lift_tolerance: LENGTH, usual [COATINGS] => "root mean square error of the lifts, which sets their smoothing; optional, that of rounding the last digit";
        eccentricity: LENGTH => "instead of these: an eccentric disc, s = e cos θ";
        follower: Choice(&["flat", "roller", "curved", "finger"]) => "kind of the follower";
        follower_radius: LENGTH, usual [RADII] => "of a roller, a curved face, or the face of a finger";
        follower_offset: LENGTH => "of the path of a roller or a curved face from the axis of the cam; optional, 0";
        roller_slip: Number => "1 − u_1/u_2, optional: 0 of a roller; a finger with this key has a roller";
        pivot_x, pivot_y: LENGTH => "place of the pivot of a finger from the axis of the cam; the follower is at larger y";
        arm_length: LENGTH, usual [LENGTHS] => "from the pivot of a finger to the centre of its face";
        cam_speed: ROTATION, usual [ROTATIONS] => "ω, of either sign";
        width: LENGTH, usual [LENGTHS] => "width b of the contact";
        spring_rate: Quantity(&[D::FORCE_PER_LENGTH]) => "c, optional";
        preload: FORCE, usual [LOAD] => "force of the spring at s = 0";
        moving_mass: Quantity(&[D::MASS]) => "of the follower and the parts that move with it; optional";
        extra_force: FORCE => "other force towards the cam; optional";
        load: FORCE, usual [LOAD] => "instead of these: a force at all angles";
        angle: CAM_ANGLE => r#"`"turn"` for all contacts over a turn, or the angle θ of one"#;
        points: Count => "equal steps of a turn; optional, 90";
        folders: Switch => "of a turn: whether each contact has a folder of its results; optional";
    }
    PART {
        angle: ANGLE => "cam angle that it covers";
        law: LIFT_LAWS => "motion law";
    }
    /// The relief of a roller.
    pub PROFILE {
        kind: Choice(&["straight", "crown", "logarithmic", "iso-16281", "table"]), aside "form of the relief";
        straight_length: LENGTH, aside "s of a straight profile: no drop up to |y| = s/2";
        end_radius: LENGTH, usual [CROWNS], aside "radius of the arcs beyond it";
        crown_radius: LENGTH, usual [CROWNS], aside "radius of a crown, one arc";
        end_drop: LENGTH, usual [COATINGS], aside "drop of a crown at the ends, instead of its radius";
        design_load: Quantity(&[D::FORCE]), usual [LOAD], aside "load Q under which the pressure of a logarithmic profile is uniform";
        diameter: LENGTH, aside "diameter D of the roller, for the profile of ISO 16281";
        position: Quantities(&[D::LENGTH]), aside "positions along the axis, increasing, three at least";
        drop: Quantities(&[D::LENGTH]), usual [COATINGS], aside "drops at the positions";
        file: Text, aside "table of positions and drops, instead of both lists";
        smoothing_length: LENGTH, aside "length over which the drops are averaged";
        level: Switch, aside "`true`: take off the straight line that fits best";
    }
}

/// Rows one after the other.
macro_rules! joined {
    ($($name:ident = $($part:ident),+;)*) => {$(
        static $name: &[Row] = &{
            const N: usize = 0 $(+ $part.len())+;
            join::<N>(&[$($part),+])
        };
    )*};
}

joined! {
    BALL_BEARING = BALLS, BEARING_LIFE, BALL_RESISTANCE, SURROUNDINGS;
    ROLLER_BEARING = ROLLERS, BEARING_LIFE, ROLLER_RESISTANCE, SURROUNDINGS;
    SPUR_GEAR = SPUR_TEETH, GEARS;
    HELICAL_GEAR = HELICAL_TEETH, GEARS;
}

const fn join<const N: usize>(parts: &[&[Row]]) -> [Row; N] {
    let mut all = [parts[0][0]; N];
    let (mut part, mut own, mut n) = (0, 0, 0);
    while n < N {
        if own == parts[part].len() {
            (part, own) = (part + 1, 0);
        }
        all[n] = parts[part][own];
        (own, n) = (own + 1, n + 1);
    }
    all
}
