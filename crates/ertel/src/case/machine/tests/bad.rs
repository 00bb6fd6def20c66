//! Machines that are refused, with their reasons.

use std::path::Path;

use super::{BALL, CAM, DISC, GEAR, REST, ROLLER, read, with};
use crate::case::Case;
use crate::contains::contains;
use crate::warning::WarningKind;

pub(super) fn refused(machine: &str, old: &str, new: &str, words: &[&str]) {
    let message = with(machine, old, new).unwrap_err().to_string();
    for word in words.iter().chain(&["machine.toml:"]) {
        assert!(message.contains(word), "`{word}` is not in\n{message}");
    }
}

#[test]
fn bad_machines_are_refused_with_their_reason() {
    for (machine, old, new, words) in [
        (
            DISC,
            "ball-on-disc",
            "ball-on-disk",
            &["did you mean `ball-on-disc`?", "spur-gear"][..],
        ),
        (
            DISC,
            "load = ",
            "ball_radius = \"9 mm\"\nload = ",
            &["give the same quantity"],
        ),
        (
            DISC,
            "disc_speed = \"0.9 m/s\"",
            "entrainment_speed = \"1 m/s\"",
            &["missing key `disc_speed` in [machine]"],
        ),
        (
            DISC,
            "disc_speed",
            "plane_speed",
            &["unknown key `plane_speed`", "disc_speed"],
        ),
        (
            DISC,
            "\"30 N\"",
            "\"30 kN\"",
            &[
                "Hertz pressure",
                "load = ",
                "computed from [machine]: reduced radii R_x = 9.525 mm",
            ],
        ),
        (
            BALL,
            "\"inner\"",
            "\"cage\"",
            &["`ring` is one of: inner, outer"],
        ),
        (
            BALL,
            "contact_angle = \"0 deg\"\n",
            "",
            &["missing key `contact_angle` in [machine]"],
        ),
        (
            BALL,
            "inner_groove_curvature = 0.52\n",
            "",
            &["missing key `inner_groove_curvature`", "such as 0.52"],
        ),
        (
            BALL,
            "\"9.525 mm\"",
            "\"50 mm\"",
            &["`ball_diameter` must be less than `pitch_diameter`"],
        ),
        (
            BALL,
            "\"3000 rpm\"",
            "\"50 Hz\"",
            &["needs an angular speed (rad/s, rpm)"],
        ),
        (
            BALL,
            "\"3000 rpm\"",
            "\"0 rpm\"",
            &["entrainment speed must not be zero", "inner_ring_speed"],
        ),
        (
            BALL,
            "\"3000 rpm\"",
            "\"900000 rpm\"",
            &["speeds go up to 1000 m/s"],
        ),
        (
            BALL,
            "ball_load",
            "hertz_pressure = \"1 GPa\"\nball_load",
            &["`ball_load` and `hertz_pressure` give the same quantity"],
        ),
        (
            ROLLER,
            "roller_length = \"12 mm\"\n",
            "",
            &["missing key `roller_length`"],
        ),
        (
            ROLLER,
            "\"2 kN\"",
            "\"2 kN/m\"",
            &["is a force per length, but `roller_load` needs a force"],
        ),
        (
            ROLLER,
            "\"2 kN\"",
            "\"2 N\"\ncrowning = 1",
            &["unknown key `crowning` in [machine]"],
        ),
        (
            GEAR,
            "module",
            "helix_angle = \"10 deg\"\nmodule",
            &["the teeth of a spur gear are straight", "helical-gear"],
        ),
        (
            GEAR,
            "\"pitch point\"",
            "\"10 mm\"",
            &["from -10.117 mm to 9.191 mm", "addendum_pinion"],
        ),
        (
            GEAR,
            "\"pitch point\"",
            "\"-10.2 mm\"",
            &["from -10.117 mm to 9.191 mm"],
        ),
        (
            GEAR,
            "\"pitch point\"",
            "\"tip\"",
            &["\"pitch point\" or the distance"],
        ),
        (GEAR, "load_share = 1\n", "", &["missing key `load_share`"]),
        (
            GEAR,
            "load_share = 1",
            "load_share = 1.2",
            &["load_share", "0 (excluded) and 1"],
        ),
        (
            GEAR,
            "pinion_teeth = 20",
            "pinion_teeth = 20.5",
            &["must be a whole number"],
        ),
        (
            GEAR,
            "\"100 N.m\"",
            "\"100 N\"",
            &["needs an energy (J, N.m)"],
        ),
        (
            GEAR,
            "\"1500 rpm\"",
            "\"-1500 rpm\"",
            &["pinion_speed", "between 0"],
        ),
        (CAM, "\"2 mm\"", "\"-2 mm\"", &["lift"]),
    ] {
        refused(machine, old, new, words);
    }
}

/// The wheel's tip reaches below the base circle of a small pinion, r_1 sin α = 2 · 10 · 0.3420201 = 6.8404 mm, where there is
/// no involute: the path of contact ends before.
#[test]
fn the_path_ends_at_the_base_circle() {
    let small = GEAR
        .replace("pinion_teeth = 20", "pinion_teeth = 10")
        .replace("= 40", "= 100");
    refused(
        &small,
        "\"pitch point\"",
        "\"-6.9 mm\"",
        &["from -6.840 mm to"],
    );
    let light = small.replace("100 N.m", "1 N.m");
    let case = with(&light, "\"pitch point\"", "\"-6.8 mm\"").unwrap();
    assert!(case.contact.radius > 0.0);
}

/// Teeth of 20 with α = 20° are pointed at inv α_a = π/40 + inv 20° = 0.093444, α_a = 35.471°: an addendum of 40 cos 20°/cos 35.471° − 40 =
/// 6.153 mm. Addenda of 1.5 mm leave a contact ratio below 1. The undercut of the small pinion is reported, and 20 teeth have none.
#[test]
fn teeth_that_do_not_mesh() {
    let addendum = |mm: f64| format!("module = \"4 mm\"\naddendum_pinion = \"{mm} mm\"");
    assert!(with(GEAR, "module = \"4 mm\"", &addendum(6.15)).is_ok());
    for mm in [6.16, 40.0] {
        refused(
            GEAR,
            "module = \"4 mm\"",
            &addendum(mm),
            &["pointed before this addendum", "addendum_pinion"],
        );
    }
    let short = format!("{}\naddendum_wheel = \"1.5 mm\"", addendum(1.5));
    refused(
        GEAR,
        "module = \"4 mm\"",
        &short,
        &[
            "the transverse contact ratio of this pair is 0.",
            "do not take over",
        ],
    );
    let warned = |machine: &str| {
        let case = read(machine).unwrap();
        case.warnings.iter().any(|w| w.kind == WarningKind::Gears)
    };
    assert!(!warned(GEAR));
    let small = GEAR
        .replace("pinion_teeth = 20", "pinion_teeth = 10")
        .replace("= 40", "= 100")
        .replace("100 N.m", "1 N.m");
    assert!(warned(&small));
}

#[test]
fn a_machine_stands_alone() {
    for (table, key) in [
        ("[contact]\nkind = \"circular\"\n", "contact"),
        ("[motion]\nentrainment_speed = \"1 m/s\"\n", "motion"),
    ] {
        let error = read(&format!("{DISC}{table}")).unwrap_err();
        assert_eq!(error.key(), key);
        contains(&error.to_string(), "and [machine] are both given");
    }
    let nothing = Case::from_text("case.toml", REST, Path::new(""));
    let message = nothing.unwrap_err().to_string();
    contains(&message, "or [machine] instead of both");
}
