//! The cases of `cases/machine`: estimated with what the machine gave.

use std::path::{Path, PathBuf};
use std::process::Output;

use tempfile::TempDir;

use crate::common::{self, code, contains, read, stderr_of, text, write};

fn ertel(arguments: &str, case: &Path) -> Output {
    common::ertel_here(&format!("{arguments} {}", case.display()))
}

fn shipped(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/machine");
    folder.join(name).with_extension("toml")
}

/// Radii, loads and speeds worked out by hand in the tests of the machines.
#[test]
fn every_machine_is_estimated() {
    let machines: [(&str, &[&str]); 11] = [
        ("ball-on-disc", &["9.525 mm", "30 N"]),
        (
            "ball-bearing",
            &["3.776 mm", "123.8 mm", "0.207065", "3.45793 m/s"],
        ),
        ("roller-bearing", &["4 mm", "166.667 kN/m", "1.88496 m/s"]),
        (
            "spur-gear",
            &["15.68 mm", "25.36 mm", "9.69 mm", "133.022 kN/m", "1.635"],
        ),
        (
            "helical-gear",
            &[
                "16.6 mm",
                "27.2 mm",
                "10.63 mm",
                "82.6609 kN/m",
                "1.56093",
                "1.02981",
                "20.6469 deg",
                "14.0761 deg",
                "1.48043 m/s",
            ],
        ),
        // Under the largest pressure, by hand from R_1 = r_1 sin α + s, R_2 = r_2 sin α − s: B where one pair takes over all of the load, A where load is even.
        (
            "spur-gear-pair",
            &[
                "B, inner single contact",
                "8.082 mm",
                "1.73797 m/s",
                "1.63519",
            ],
        ),
        (
            "helical-gear-pair",
            &["A, tip of the wheel", "4.303 mm", "0.733881 m/s", "1.56093"],
        ),
        // Radii and pressures of the program that the path of these gears is tested against.
        (
            "fzg-c",
            &[
                "B, inner single contact",
                "91.5 mm",
                "22.4388 deg",
                "7.255 mm",
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
            &["20 mm", "41.6667 kN/m", "2.0944 m/s"],
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
        let estimate = ertel("estimate", &case);
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

/// Options for a single contact refuse a whole machine and say how to choose one.
#[test]
fn whole_machines_are_no_single_contact() {
    let arguments = "solve --cross-check";
    let message = stderr_of(ertel(arguments, &shipped("bearing-6206")), 2);
    contains(&message, "machine.element=0");
    let refused = ertel(arguments, &shipped("fzg-c"));
    let message = text(&refused.stderr);
    contains(message, "machine.position=\"-0.00368");
}

/// The path of FZG gears on few points.
const GEARS: &str = include_str!("../../ertel/tests/common/cases/gears.toml");

const TORQUES: &str = "case = \"gears.toml\"\n[[axis]]\nkey = \"machine.pinion_torque\"\nvalues = [\"100 N.m\", \"110 N.m\"]\n";

/// A folder with the gears and a study over their torque.
fn workspace(gears: &str) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    write(&folder, "gears.toml", gears);
    write(&folder, "torques.toml", TORQUES);
    folder
}

/// Points of a study are whole machines: with their figures, a journal that continues, and folders of machines.
#[test]
fn a_study_of_whole_machines() {
    let folder = workspace(GEARS);
    let first = common::ertel(&folder, "sweep torques.toml --folders");
    code(&first, 0);
    let table = read(&folder, "results/torques/results.csv");
    let head: Vec<&str> = table.lines().next().unwrap().split(',').collect();
    for title in [
        "contacts",
        "mesh_loss",
        "mesh_loss_error",
        "friction_power_W",
        "loss_factor",
    ] {
        assert!(head.contains(&title), "{title}: {head:?}");
    }
    assert!(!head.contains(&"pressure_maximum_Pa"), "{head:?}");
    let machine = read(&folder, "results/torques/points/2/machine.json");
    assert!(machine.contains("mesh_efficiency"));
    // The second point is lost: the same command solves it again, to the same digits.
    let journal = read(&folder, "results/torques/journal.jsonl");
    let kept = journal.split_inclusive('\n').next().unwrap();
    write(&folder, "results/torques/journal.jsonl", kept);
    let second = common::ertel(&folder, "sweep torques.toml");
    let shown = text(&second.stdout);
    contains(shown, "1 of them earlier");
    contains(shown, "1 new");
    assert_eq!(read(&folder, "results/torques/results.csv"), table);
}

/// A second solve replaces the result of the first one.
#[test]
fn a_machine_is_solved_again() {
    let folder = workspace(GEARS);
    for _ in 0..2 {
        code(&common::ertel(&folder, "solve gears.toml -q -o out"), 0);
    }
}

/// A contact that fails is a point that fails, with its reason; a load that no gear carries is refused before anything is solved.
#[test]
fn points_of_machines_that_fail() {
    let folder =
        workspace(&GEARS.replace("newtonian = true", "newtonian = true\nmax_iterations = 1"));
    let failed = common::ertel(&folder, "sweep torques.toml");
    code(&failed, 3);
    let table = read(&folder, "results/torques/results.csv");
    contains(&table, "contacts failed");
    assert!(
        table.contains("loss_factor_ohlendorf") && !table.contains("mesh_loss"),
        "{table}"
    );

    write(
        &folder,
        "torques.toml",
        TORQUES.replace("110 N.m", "110 MN.m"),
    );
    let message = stderr_of(common::ertel(&folder, "sweep torques.toml"), 2);
    contains(&message, "point 2 of torques.toml");
}

/// Measured losses are compared with those of whole machines; a traction is that of one contact.
#[test]
fn losses_of_gears_are_compared() {
    let folder = workspace(GEARS);
    let table = folder.path().join("rig.csv");
    std::fs::write(&table, "machine.pinion_torque [N.m],friction_power [W],mesh_loss [%],mesh_loss_uncertainty [%]\n100,110,0.7,0.2\n").unwrap();
    let compared = common::ertel(&folder, "compare gears.toml rig.csv");
    code(&compared, 0);
    let shown = text(&compared.stdout);
    contains(shown, "power lost, computed against measured");
    let rows = read(&folder, "results/gears-rig/comparison.csv");
    contains(&rows, "friction_power_computed_W");
    contains(&rows, "mesh_loss_within");

    std::fs::write(
        &table,
        "machine.pinion_torque [N.m],traction_coefficient\n100,0.03\n",
    )
    .unwrap();
    let refused = common::ertel(&folder, "compare gears.toml rig.csv");
    code(&refused, 2);
    let message = text(&refused.stderr);
    contains(
        message,
        "`traction_coefficient` is a figure of a single contact",
    );
}

/// Samples of an uncertain torque.
#[test]
fn samples_of_whole_machines() {
    let folder = workspace(&GEARS.replace("\"100 N.m\"", "\"100 N.m ± 10 %\""));
    let done = common::ertel(&folder, "solve gears.toml --monte-carlo 4");
    code(&done, 0);
    contains(text(&done.stdout), "power lost in the mesh");
    let found = read(&folder, "results/gears-monte-carlo/monte-carlo.json");
    let found: serde_json::Value = serde_json::from_str(&found).unwrap();
    let power = &found["figures"]["friction_power"];
    assert!(power["standard"].as_f64().unwrap() > 0.0, "{power}");
    // The pressure depends on the torque alone, other figures with the estimates of the oil, too.
    let pressure = &found["figures"]["hertz_pressure_maximum"];
    let correlation = &pressure["correlations"]["machine.pinion_torque"];
    assert!(correlation.as_f64().unwrap() > 0.99, "{pressure}");
}

/// Comparison solves of the points are for single contacts only.
#[test]
fn a_curve_of_machines_has_no_newtonian_comparison() {
    let gears = GEARS.replace("newtonian = true", "max_iterations = 60");
    let curve = "[curve]\nquantity = \"machine.pinion_torque\"\nvalues = [\"50 N.m\", \"60 N.m\"]\nnewtonian = true\n";
    let folder = workspace(&(gears + curve));
    let message = stderr_of(common::ertel(&folder, "solve gears.toml"), 2);
    contains(&message, "this case is a whole machine");
}
