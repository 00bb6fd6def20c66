//! The cases of `cases/machine`: checked, and estimated with what the machine gave.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use crate::common::text;

fn ertel(arguments: &[&str], case: &Path) -> Output {
    Command::new(env!("CARGO_BIN_EXE_ertel"))
        .args(arguments)
        .arg(case)
        .output()
        .unwrap()
}

fn shipped(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/machine");
    folder.join(name).with_extension("toml")
}

/// Radii, loads and speeds worked out by hand in the tests of the machines.
#[test]
fn every_machine_is_estimated_and_checked() {
    let machines: [(&str, &[&str]); 9] = [
        ("ball-on-disc", &["9.525 mm", "30 N"]),
        (
            "ball-bearing",
            &["3.776 mm", "123.8 mm", "0.207065", "3.45793 m/s"],
        ),
        ("roller-bearing", &["4 mm", "166667 N/m", "1.88496 m/s"]),
        (
            "spur-gear",
            &["15.68 mm", "25.36 mm", "9.69 mm", "133022 N/m", "1.635"],
        ),
        (
            "helical-gear",
            &[
                "16.6 mm",
                "27.2 mm",
                "10.63 mm",
                "82660.9 N/m",
                "1.56093",
                "1.02981",
                "20.6469 deg",
                "14.0761 deg",
                "1.48043 m/s",
            ],
        ),
        // Radii and pressures of the program that the path of these gears is tested against.
        (
            "fzg-c",
            &[
                "C, pitch point",
                "91.5 mm",
                "22.4388 deg",
                "8.382 mm",
                "1.43",
            ],
        ),
        ("cam-turn", &["flat follower", "18 mm", "104.72 rad/s"]),
        // Boundary dimensions of ISO 15, and the cage speed ω_i (1 − γ)/2 by hand.
        (
            "bearing-6206",
            &["30, 62, 16 mm", "ball 0, inner ring", "124.554 rad/s"],
        ),
        (
            "cam-and-flat-tappet",
            &["20 mm", "41666.7 N/m", "2.0944 m/s"],
        ),
    ];
    let folder = std::fs::read_dir(shipped("x").parent().unwrap()).unwrap();
    assert_eq!(
        folder.count(),
        machines.len(),
        "every shipped machine is tested"
    );
    for (name, words) in machines {
        let case = shipped(name);
        let check = ertel(&["solve", "--check"], &case);
        assert_eq!(
            check.status.code(),
            Some(0),
            "{name}: {}",
            text(&check.stderr)
        );
        // About the nose of a cam both surfaces move against each other.
        assert!(
            name == "cam-turn" || !text(&check.stderr).contains("warning"),
            "{}",
            text(&check.stderr)
        );
        let estimate = ertel(&["estimate"], &case);
        assert_eq!(
            estimate.status.code(),
            Some(0),
            "{name}: {}",
            text(&estimate.stderr)
        );
        let report = text(&estimate.stdout);
        let (_, machine) = report.split_once("From the machine\n").unwrap();
        let (machine, _) = machine.split_once("\nCase\n").unwrap();
        for words in words {
            assert!(machine.contains(words), "{name}: {words}: {report}");
        }
    }
}

/// What takes one contact alone refuses a whole machine and says how to choose one.
#[test]
fn whole_machines_are_no_single_contact() {
    for arguments in [
        &["solve", "--monte-carlo", "10"][..],
        &["solve", "--cross-check"],
    ] {
        let refused = ertel(arguments, &shipped("bearing-6206"));
        assert_eq!(refused.status.code(), Some(2));
        let message = text(&refused.stderr);
        assert!(message.contains("machine.element=0"), "{message}");
        let refused = ertel(arguments, &shipped("fzg-c"));
        let message = text(&refused.stderr);
        assert!(message.contains("machine.position=\"0 m\""), "{message}");
    }
}
