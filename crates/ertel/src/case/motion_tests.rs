//! `[motion]` in case files: sliding at an angle, and spin.

use std::path::Path;

use crate::near::near;
use approx::assert_relative_eq;
use ertel_input::InputError;

use super::Case;

const BALL: &str = "kind = \"circular\"\nradius = \"16 mm\"\nload = \"100 N\"";
const CYLINDER: &str = "kind = \"line\"\nradius = \"16 mm\"\nload = \"50 kN/m\"";
const REST: &str = include_str!("../../tests/common/cases/steel.toml");

fn read(contact: &str, motion: &str) -> Result<Case, InputError> {
    let text = format!("[contact]\n{contact}\n[motion]\n{motion}\n{REST}");
    Case::from_text("case.toml", &text, Path::new(""))
}

/// 1 m/s and 1.2 m/s at 30 degrees: mean (1 + 1.2 cos 30°, 1.2 sin 30°)/2 = (1.019615, 0.3), 1.0628336 m/s; difference
/// (0.039230, 0.6); along the mean (0.04 + 0.18)/1.0628336 = 0.206993 m/s = half of (1.44 − 1)/u_m, across
/// 1 · 1.2 sin 30°/u_m = 0.564527 m/s.
#[test]
fn skewed_speeds() {
    let speeds = "body_1_speed = \"1 m/s\"\nbody_2_speed = \"1.2 m/s\"\nskew_angle = \"30 deg\"";
    let motion = read(BALL, speeds).unwrap().motion;
    assert_relative_eq!(motion.entrainment_speed, 1.062_833_6, max_relative = 1e-6);
    near(motion.slide_to_roll_ratio, 0.22 / 1.129_615, 1e-5);
    near(motion.slide_to_roll_ratio_across, 0.6 / 1.129_615, 1e-5);
    assert!(!motion.is_straight());
    // Turned the other way, it slides the other way; without an angle nothing changes.
    let back = read(BALL, &speeds.replace("30", "-30")).unwrap().motion;
    assert_relative_eq!(
        back.slide_to_roll_ratio_across,
        -motion.slide_to_roll_ratio_across,
        max_relative = 1e-14
    );
    let none = read(BALL, &speeds.replace("30", "0")).unwrap().motion;
    assert!(none.is_straight());
    assert_relative_eq!(none.slide_to_roll_ratio, 0.2 / 1.1, max_relative = 1e-14);
}

const GIVEN: &str = "entrainment_speed = \"1 m/s\"\nslide_to_roll_ratio = 0.1\n";

#[test]
fn components_and_spin() {
    let motion = format!(
        "{GIVEN}slide_to_roll_ratio_across = -0.2\nbody_1_spin = \"60 rpm\"\nbody_2_spin = \"-100 rad/s\""
    );
    let motion = read(BALL, &motion).unwrap().motion;
    assert_eq!(motion.slide_to_roll_ratio_across, -0.2);
    assert_relative_eq!(motion.spin[0], std::f64::consts::TAU, max_relative = 1e-14);
    assert_eq!(motion.spin[1], -100.0);
    let across = format!("{GIVEN}slide_to_roll_ratio_across = 0.05");
    assert!(read(CYLINDER, &across).is_ok());
}

#[test]
fn impossible_motions_are_refused() {
    let spin = |text: &str| format!("{GIVEN}body_2_spin = {text}");
    let cases = [
        (
            BALL,
            format!("{GIVEN}skew_angle = \"10 deg\""),
            vec!["skew_angle", "body_1_speed"],
        ),
        (
            BALL,
            "body_1_speed = \"1 m/s\"\nbody_2_speed = \"1 m/s\"\nslide_to_roll_ratio_across = 0.1"
                .into(),
            vec!["slide_to_roll_ratio_across", "give one pair"],
        ),
        (
            BALL,
            "body_1_speed = \"1 m/s\"\nbody_2_speed = \"1 m/s\"\nskew_angle = 10".into(),
            vec!["skew_angle", "deg"],
        ),
        (
            BALL,
            "body_1_speed = \"1 m/s\"\nbody_2_speed = \"1 m/s\"\nplane_speed = \"1 m/s\"".into(),
            vec!["plane_speed", "same body"],
        ),
        (
            BALL,
            "body_1_speed = \"1 m/s\"\nbody_2_speed = \"1 m/s\"\nskew_angle = \"180 deg\"".into(),
            vec!["must not be zero"],
        ),
        (BALL, spin("100"), vec!["body_2_spin", "rad/s"]),
        (BALL, spin("\"nan rad/s\""), vec!["body_2_spin"]),
        (
            BALL,
            spin("\"50000 rad/s\""),
            vec!["body_2_spin", "no inlet"],
        ),
        (
            CYLINDER,
            spin("\"1 rad/s\""),
            vec!["body_2_spin", "cannot spin"],
        ),
    ];
    for (contact, motion, words) in cases {
        let message = read(contact, &motion).unwrap_err().to_string();
        for word in words {
            assert!(message.contains(word), "`{word}` is not in {message}");
        }
    }
    // Finite-element bodies are halves around circles.
    let text = format!(
        "[contact]\n{BALL}\n[motion]\n{GIVEN}slide_to_roll_ratio_across = 0.1\n[solver]\nelasticity = \"equivalent\"\n{REST}"
    );
    let message = Case::from_text("case.toml", &text, Path::new(""))
        .unwrap_err()
        .to_string();
    assert!(message.contains("across the entrainment"), "{message}");
}

/// u_1·u_2 = u_m² (1 − (S² + S_⊥²)/4): opposite at 50 across, and at 1.5 and 1.5 together, not at 1.4 and 1.4.
#[test]
fn opposite_motion_across_is_reported() {
    let warned = |along: f64, across: f64| {
        let motion = format!(
            "entrainment_speed = \"1 m/s\"\nslide_to_roll_ratio = {along}\nslide_to_roll_ratio_across = {across}"
        );
        let case = read(CYLINDER, &motion).unwrap();
        let mut kinds = case.warnings.iter().map(|w| w.kind);
        kinds.any(|kind| kind == crate::warning::WarningKind::OppositeMotion)
    };
    assert!(warned(0.0, 50.0) && warned(1.5, 1.5) && warned(-2.5, 0.0));
    assert!(!warned(1.4, 1.4) && !warned(0.0, -1.9));
}
