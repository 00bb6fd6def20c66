//! Each machine against figures worked out by hand, its limits, and its refusals.

use std::path::Path;

use crate::near::near;
use approx::assert_relative_eq;
use ertel_input::InputError;

use crate::case::Case;

mod bad;
mod helical;
mod loaded;
mod path;
mod turn;
use bad::refused;

const REST: &str = include_str!("../../../tests/common/cases/steel.toml");

const DISC: &str = include_str!("tests/data/ball_on_disc.toml");

/// Approximate dimensions of a deep-groove bearing 6206.
const BALL: &str = include_str!("tests/data/ball_bearing.toml");

const ROLLER: &str = include_str!("tests/data/roller_bearing.toml");

const GEAR: &str = include_str!("tests/data/spur_gear.toml");

const CAM: &str = include_str!("tests/data/cam_and_flat_tappet.toml");

fn read(machine: &str) -> Result<Case, InputError> {
    read_with(machine, "\"steel\"", "")
}

/// With bodies of another steel, and more tables.
fn read_with(machine: &str, steel: &str, more: &str) -> Result<Case, InputError> {
    let rest = REST.replace("\"steel\"", steel);
    let text = format!("[machine]\n{machine}{rest}{more}");
    Case::from_text("machine.toml", &text, Path::new(""))
}

fn with(machine: &str, old: &str, new: &str) -> Result<Case, InputError> {
    assert!(machine.contains(old), "{old}");
    read(&machine.replacen(old, new, 1))
}

/// Curves over inputs of a machine: each point is the machine with this value.
#[test]
fn machines_have_curves() {
    let values = |case: &Case, of: fn(&Case) -> f64| -> Vec<f64> {
        let curve = case.curve.as_ref().unwrap();
        curve.points.iter().map(|point| of(&point.case)).collect()
    };
    let speed: fn(&Case) -> f64 = |case| case.motion.entrainment_speed;
    let load: fn(&Case) -> f64 = |case| case.contact.load;
    let temperature: fn(&Case) -> f64 = |case| case.lubricant.temperature;
    for (machine, quantity, given, of, ratio) in [
        (DISC, "machine.load", ["10 N", "30 N"], load, 3.0),
        (
            BALL,
            "machine.inner_ring_speed",
            ["1000 rpm", "2000 rpm"],
            speed,
            2.0,
        ),
        (BALL, "machine.ball_load", ["100 N", "500 N"], load, 5.0),
        (
            ROLLER,
            "machine.inner_ring_speed",
            ["1000 rpm", "3000 rpm"],
            speed,
            3.0,
        ),
        (ROLLER, "machine.roller_load", ["1 kN", "2 kN"], load, 2.0),
        (
            GEAR,
            "machine.pinion_speed",
            ["1000 rpm", "1500 rpm"],
            speed,
            1.5,
        ),
        (
            GEAR,
            "machine.pinion_torque",
            ["50 N.m", "100 N.m"],
            load,
            2.0,
        ),
        (
            CAM,
            "machine.cam_speed",
            ["50 rad/s", "100 rad/s"],
            speed,
            2.0,
        ),
        (CAM, "machine.load", ["250 N", "500 N"], load, 2.0),
        (
            GEAR,
            "lubricant.temperature",
            ["300 K", "330 K"],
            temperature,
            1.1,
        ),
    ] {
        let curve = format!("[curve]\nquantity = \"{quantity}\"\nvalues = {given:?}\n");
        let case = read_with(machine, "\"steel\"", &curve);
        let case = case.unwrap_or_else(|error| panic!("{quantity}: {error}"));
        let found = values(&case, of);
        assert_relative_eq!(found[1] / found[0], ratio, max_relative = 1e-9);
    }
    let speeds = "entrainment_speed = \"1 m/s\"\nslide_to_roll_ratio = 0.1\n";
    let disc = DISC.replace(
        "ball_speed = \"1.1 m/s\"\ndisc_speed = \"0.9 m/s\"\n",
        speeds,
    );
    for (quantity, given) in [
        ("entrainment_speed", "[\"1 m/s\", \"2 m/s\"]"),
        ("slide_to_roll_ratio", "[0.1, 0.2]"),
    ] {
        let curve = format!("[curve]\nquantity = \"machine.{quantity}\"\nvalues = {given}\n");
        let case = read_with(&disc, "\"steel\"", &curve);
        assert!(case.is_ok(), "{quantity}");
    }
}

/// Radius in mm, load, entrainment speed, slide-to-roll ratio.
fn check(case: &Case, radius_mm: f64, load: f64, speed: f64, ratio: f64) {
    let (contact, motion) = (&case.contact, &case.motion);
    assert_relative_eq!(1e3 * contact.radius, radius_mm, max_relative = 1e-5);
    assert_relative_eq!(contact.load, load, max_relative = 1e-5);
    assert_relative_eq!(motion.entrainment_speed, speed, max_relative = 1e-5);
    assert_relative_eq!(motion.slide_to_roll_ratio, ratio, epsilon = 1e-5);
    let rows = &case.machine.as_ref().unwrap().rows;
    for (name, _) in rows {
        assert!(
            name.chars().count() < 34,
            "{name}: the column of names is 34 wide"
        );
    }
    assert!(rows.iter().any(|(name, _)| name == "source"));
}

fn row<'c>(case: &'c Case, name: &str) -> &'c str {
    let rows = &case.machine.as_ref().unwrap().rows;
    let row = rows.iter().find(|(found, _)| found.starts_with(name));
    &row.unwrap_or_else(|| panic!("{name}: {rows:?}")).1
}

/// R = 19.05/2 = 9.525 mm; u_m = (1.1 + 0.9)/2 = 1 m/s; SRR = (1.1 − 0.9)/1 = 0.2.
#[test]
fn ball_on_disc() {
    let case = read(DISC).unwrap();
    assert_eq!(case.contact.radius_y, case.contact.radius);
    check(&case, 9.525, 30.0, 1.0, 0.2);
    let speeds = "ball_speed = \"1.1 m/s\"\ndisc_speed = \"0.9 m/s\"";
    let case = with(
        DISC,
        speeds,
        "entrainment_speed = \"1 m/s\"\nslide_to_roll_ratio = 0.2",
    )
    .unwrap();
    check(&case, 9.525, 30.0, 1.0, 0.2);
    let case = with(
        DISC,
        "ball_diameter = \"19.05 mm\"",
        "ball_radius = \"9.525 mm\"",
    )
    .unwrap();
    check(&case, 9.525, 30.0, 1.0, 0.2);
    let case = with(DISC, "load = \"30 N\"", "hertz_pressure = \"0.7 GPa\"").unwrap();
    assert_relative_eq!(case.hertz().pressure, 0.7e9, max_relative = 1e-12);
}

/// γ = 9.525/46 = 0.2070652; inner R_x = 4.7625 · 0.7929348 = 3.776352 mm, outer R_x = 4.7625 · 1.2070652 = 5.748648 mm;
/// R_y = 9.525/(2 − 1/0.52) = 123.825 mm, with 0.53 9.525/(2 − 1/0.53) = 84.1375 mm.
/// Cage: 314.15927 · 0.7929348/2 = 124.5539 rad/s. The inner raceway, at 23 − 4.7625 = 18.2375 mm, moves past it at
/// (314.1593 − 124.5539) · 0.0182375 = 3.457928 m/s, the outer one, at 27.7625 mm, at 124.5539 · 0.0277625 = 3.457928 m/s.
#[test]
fn ball_bearing() {
    let case = read(BALL).unwrap();
    assert!(case.contact.has_two_radii());
    assert_relative_eq!(case.contact.radius_y, 0.123_825, max_relative = 1e-9);
    assert_eq!(case.contact.entrainment_angle, 0.0);
    check(&case, 3.776_352, 500.0, 3.457_928, 0.0);
    assert_eq!(row(&case, "cage"), "124.554 rad/s");
    let outer = with(BALL, "\"inner\"", "\"outer\"").unwrap();
    check(&outer, 5.748_648, 500.0, 3.457_928, 0.0);
    assert_relative_eq!(outer.contact.radius_y, 0.084_137_5, max_relative = 1e-6);
    // Only the relative speed of the rings matters, not its direction.
    let reverse = with(
        BALL,
        "\"3000 rpm\"",
        "\"-1000 rpm\"\nouter_ring_speed = \"2000 rpm\"",
    );
    check(&reverse.unwrap(), 3.776_352, 500.0, 3.457_928, 0.0);
}

/// Spin at 40 degrees and 3000 rpm, solved for as three linear equations in the angular velocity of the ball and the cage's: no slip at both
/// contacts, and no spin at the raceway that controls (cross products of vectors in 3D, in double precision).
#[test]
fn ball_bearing_with_spin() {
    let spin = |ring: &str, control: &str| {
        let text = BALL
            .replace(
                "\"0 deg\"",
                &format!("\"40 deg\"\nraceway_control = \"{control}\""),
            )
            .replace("\"inner\"\nball", &format!("\"{ring}\"\nball"));
        let case = read(&text).unwrap();
        near(case.motion.entrainment_speed, 3.521_930, 1e-6);
        case.motion.spin
    };
    for (ring, control, expected) in [
        ("inner", "outer", [116.984_636, -84.953_047]),
        ("outer", "outer", [84.953_047, 84.953_047]),
        ("inner", "inner", [116.984_636, 116.984_636]),
        ("outer", "inner", [84.953_047, -116.984_636]),
    ] {
        let control = if ring == control { ring } else { control };
        for (found, expected) in spin(ring, control).iter().zip(expected) {
            assert_relative_eq!(*found, expected, max_relative = 1e-6);
        }
    }
    // Without the key spin is neglected, and at 0 degrees there is none.
    assert_eq!(with(BALL, "0 deg", "40 deg").unwrap().motion.spin, [0.0; 2]);
    let radial = with(BALL, "\"0 deg\"", "\"0 deg\"\nraceway_control = \"outer\"").unwrap();
    assert_eq!(radial.motion.spin, [0.0; 2]);
    refused(
        BALL,
        "\"0 deg\"",
        "\"40 deg\"\nraceway_control = \"both\"",
        &["raceway_control", "inner", "outer"],
    );
}

/// Without a groove (f → ∞) and in a large bearing (γ → 0) both radii are that of the ball on a flat, D/2; a groove as
/// narrow as the ball is refused.
#[test]
fn a_ball_without_a_groove() {
    let flat = BALL
        .replace("= 0.52", "= 1e9")
        .replace("46 mm", "500 m")
        .replace("3000 rpm", "1 rpm");
    let case = read(&flat).unwrap();
    assert_relative_eq!(case.contact.radius, 4.7625e-3, max_relative = 1e-4);
    assert_relative_eq!(case.contact.radius_y, 4.7625e-3, max_relative = 1e-8);
    // A thrust bearing has γ = D cos 90°/d_m = 0.
    let thrust = with(BALL, "0 deg", "90 deg").unwrap();
    assert_relative_eq!(thrust.contact.radius, 4.7625e-3, max_relative = 1e-12);
    refused(
        BALL,
        "= 0.52",
        "= 0.5",
        &["inner_groove_curvature", "above 0.5"],
    );
    refused(
        BALL,
        "= 0.52",
        "= 0.50001",
        &["R_y/R_x", "outside 1/1000 to 1000"],
    );
}

/// γ = 10/50 = 0.2; R = 5 · 0.8 = 4 mm, outer 5 · 1.2 = 6 mm; w = 2000/0.012 = 166,667 N/m;
/// u = 157.0796 · 0.05 · (1 − 0.04)/4 = 1.884956 m/s.
#[test]
fn roller_bearing() {
    let case = read(ROLLER).unwrap();
    assert!(case.contact.kind.is_line());
    check(&case, 4.0, 166_666.67, 1.884_956, 0.0);
    let outer = with(ROLLER, "\"inner\"", "\"outer\"").unwrap();
    check(&outer, 6.0, 166_666.67, 1.884_956, 0.0);
    let pressed = with(
        ROLLER,
        "roller_load = \"2 kN\"",
        "hertz_pressure = \"1 GPa\"",
    )
    .unwrap();
    assert_relative_eq!(pressed.hertz().pressure, 1e9, max_relative = 1e-12);
}

/// At the pitch point: R = (40 · 80/120) sin 20° = 9.120537 mm; u = 157.0796 · 0.04 · 0.3420201 = 2.148976 m/s for both;
/// F = 100/(0.04 cos 20°) = 2660.444 N, over 20 mm 133,022.2 N/m.
///
/// Path of contact: √(44² − 37.5877²) − 13.6808 = 9.1920 mm to the tip of the pinion, √(84² − 75.1754²) − 27.3616 = 10.1171 mm
/// to that of the wheel; contact ratio 19.3091/(4π cos 20°) = 1.6352.
#[test]
fn spur_gear() {
    let case = read(GEAR).unwrap();
    assert!(case.contact.kind.is_line());
    check(&case, 9.120_537, 133_022.2, 2.148_976, 0.0);
    assert_eq!(row(&case, "path of contact"), "from -10.117 mm to 9.191 mm");
    assert!(row(&case, "contact ratio").starts_with("1.635"));
}

/// At s = 5 mm: R_1 = 18.68081 mm, R_2 = 22.36161 mm, R = 10.17808 mm; u_1 = 157.0796 · 0.01868081 = 2.934374 m/s,
/// u_2 = 78.5398 · 0.02236161 = 1.756277 m/s; the sliding speed is (ω_1 + ω_2) s = 235.6194 · 0.005 = 1.178097 m/s.
#[test]
fn teeth_slide_away_from_the_pitch_point() {
    let case = with(GEAR, "\"pitch point\"", "\"5 mm\"").unwrap();
    check(
        &case,
        10.178_08,
        133_022.2,
        2.345_326,
        1.178_097 / 2.345_326,
    );
    let root = with(GEAR, "\"pitch point\"", "\"-5 mm\"").unwrap();
    assert!(
        root.motion.slide_to_roll_ratio < 0.0,
        "the wheel is faster at the pinion's root"
    );
    let half = with(GEAR, "load_share = 1", "load_share = \"50 %\"").unwrap();
    assert_relative_eq!(half.contact.load, 66_511.1, max_relative = 1e-5);
    // A long addendum of the pinion lengthens the path at that end: √(46² − 37.5877²) − 13.6808 = 12.8364 mm.
    let long = "position = \"12.8 mm\"\naddendum_pinion = \"6 mm\"";
    let case = with(GEAR, "position = \"pitch point\"", long).unwrap();
    assert_eq!(
        row(&case, "path of contact"),
        "from -10.117 mm to 12.836 mm"
    );
}

/// ρ = 15 + 2 + 3 = 20 mm; u_cam = 100 · 0.020 = 2 m/s, u_tappet = 100 · 0.003 = 0.3 m/s, u_m = 1.15 m/s,
/// SRR = 1.7/1.15 = 1.478261; w = 500/0.012 = 41,666.7 N/m.
#[test]
fn cam_and_flat_tappet() {
    let case = read(CAM).unwrap();
    check(&case, 20.0, 41_666.67, 1.15, 1.478_261);
    // About the nose the contact travels backwards: r_b + s + 2 s'' = 15 + 9 − 28 = −4 mm, 50 · −4 mm = −0.2 m/s.
    let nose = CAM
        .replace("\"2 mm\"", "\"9 mm\"")
        .replace("\"3 mm\"", "\"-14 mm\"");
    let error = read(&nose).unwrap_err().to_string();
    assert!(
        error.contains("must be positive") && error.contains("-0.2 m/s"),
        "{error}"
    );
    // With the sign turned, cam and tappet move at −1 m/s and 1.4 m/s: (−1 − 1.4)/0.2 = −12.
    let case = with(&nose, "\"100 rad/s\"", "\"-100 rad/s\"").unwrap();
    check(&case, 10.0, 41_666.67, 0.2, -12.0);
    // 15 + 9 − 2 · 12 = 0: nothing is entrained.
    let error = with(&nose, "-14 mm", "-12 mm").unwrap_err().to_string();
    assert!(error.contains("must not be zero"), "{error}");
    refused(
        &nose,
        "-14 mm",
        "-25 mm",
        &["radius of curvature", "-1.0", "convex"],
    );
}

#[test]
fn results_list_what_was_computed() {
    let case = read(GEAR).unwrap();
    let text =
        crate::output::estimate_report(&case.echo(), &crate::estimate::estimate(&case), None);
    for words in [
        "From the machine\n",
        "R = R_1 R_2/(R_1 + R_2)",
        "9.121 mm",
        "ISO/TR 15144-1",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
    assert_eq!(case.echo().given["machine"]["module"], "4 mm");
}
