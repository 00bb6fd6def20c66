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
    let machines: [(&str, &[&str]); 7] = [
        // The cage turns at ω (1 − D/d_m)/2 with D = 9.525 mm, d_m = 46 mm, ω = 314.159 rad/s; ½ m d_m ω_c² with steel of 7850 kg/m³.
        (
            "bearing-6206",
            &["30, 62, 16 mm", "124.554 rad/s", "1.26738 N", "2000 N"],
        ),
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
        // The whole bearing has a roughness, which its film comes near to.
        let is_known = |line: &str| name == "bearing-6206" && line.contains("times the roughness");
        let mut warnings = (text(&check.stderr).lines()).filter(|line| line.contains("warning"));
        assert!(warnings.all(is_known), "{}", text(&check.stderr));
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
