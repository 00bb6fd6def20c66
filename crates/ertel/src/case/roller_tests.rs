//! Rollers in case files.

use std::path::Path;

use crate::near::near;
use approx::assert_relative_eq;
use ertel_input::InputError;

use super::Case;
use crate::contact::roller::Profile;

const STEEL: &str = include_str!("../../tests/common/cases/steel.toml");
const MOTION: &str = "[motion]\nentrainment_speed = \"1 m/s\"\nslide_to_roll_ratio = 0.0\n";

const SIZES: &str = "radius = \"5 mm\"\nlength = \"8 mm\"";
const LOG: &str = "profile = { kind = \"logarithmic\", design_load = \"1.5 kN\" }";
const CROWN: &str = "profile = { kind = \"crown\", end_drop = \"5 um\" }";

fn read(sizes: &str, load: &str, rest: &str) -> Result<Case, InputError> {
    let text = format!("[contact]\nkind = \"roller\"\n{sizes}\n{load}\n{rest}\n{MOTION}{STEEL}");
    Case::from_text("case.toml", &text, Path::new(""))
}

/// Loads per length by hand: 1 kN over 8 mm; the line contact of steel, E' = 230.77 GPa, has b² = 8 · 125e3 · 0.005/(π E') and
/// 2w/(πb) = 958.2 MPa. As a pressure it gives the load back.
#[test]
fn load_or_pressure() {
    let case = read(SIZES, "load = \"1 kN\"", LOG).unwrap();
    assert_relative_eq!(case.contact.line_load(), 125e3, max_relative = 1e-12);
    assert_relative_eq!(case.hertz().pressure, 958.2e6, max_relative = 1e-4);
    let same = read(SIZES, "hertz_pressure = \"958.2 MPa\"", LOG).unwrap();
    assert_relative_eq!(same.contact.load, 1e3, max_relative = 2e-4);
    assert!(same.warnings.is_empty());
}

/// Every kind of profile, and the drop at the ends, m: an arc of 20 mm over 1 mm is 1 − √(1 − 1/400) = 1.25078e-3 of 20 mm.
#[test]
fn profiles() {
    let iso = "profile = { kind = \"iso-16281\", diameter = \"10 mm\" }";
    let straight =
        "profile = { kind = \"straight\", straight_length = \"6 mm\", end_radius = \"20 mm\" }";
    let table = "profile = { kind = \"table\", position = [\"0 mm\", \"3 mm\", \"4 mm\"], drop = [\"0 um\", \"1 um\", \"9 um\"] }";
    let crown = "profile = { kind = \"crown\", crown_radius = \"1.6 m\" }";
    for (text, end) in [
        (straight, 25.0156e-6),
        (table, 9e-6),
        (CROWN, 5e-6),
        (crown, 5.0e-6),
    ] {
        let case = read(SIZES, "load = \"1 kN\"", text).unwrap();
        let roller = case.contact.roller.as_ref().unwrap();
        let [drop, _] = roller.profile.drop(roller.length, 0.5 * roller.length);
        assert_relative_eq!(drop, end, max_relative = 1e-4);
        assert!(roller.is_symmetric());
    }
    let case = read(SIZES, "load = \"1 kN\"", iso).unwrap();
    let roller = case.contact.roller.unwrap();
    assert_eq!(roller.profile, Profile::iso_16281(0.008, 0.01));
    let tilted = format!("{CROWN}\nmisalignment = \"0.01 deg\"");
    let case = read(SIZES, "load = \"1 kN\"", &tilted).unwrap();
    let roller = case.contact.roller.unwrap();
    assert_relative_eq!(roller.misalignment, 1.745_33e-4, max_relative = 1e-5);
    assert!(!roller.is_symmetric());
}

/// Each error names the line and its cause. Other ones are among the bad cases of the command.
#[test]
fn bad_rollers() {
    let table = |positions: &str, drops: &str| {
        format!("profile = {{ kind = \"table\", position = [{positions}], drop = [{drops}] }}")
    };
    let small_arc =
        "profile = { kind = \"straight\", straight_length = \"2 mm\", end_radius = \"1 mm\" }";
    for (rest, line, expected) in [
        (
            table(
                "\"0 mm\", \"4 mm\", \"3 mm\"",
                "\"0 um\", \"1 um\", \"2 um\"",
            ),
            6,
            "positions must increase",
        ),
        (
            table("\"0 mm\", \"3 mm\", \"4 mm\"", "\"0 um\", \"1 um\""),
            6,
            "2 drops for 3 positions",
        ),
        (small_arc.to_owned(), 6, "does not reach"),
        (
            format!("{CROWN}\n[mesh]\nside = 3"),
            8,
            "the film ends with its `length`",
        ),
        (
            format!("{CROWN}\n[solver]\nelasticity = \"equivalent\""),
            2,
            "a roller needs half-spaces",
        ),
    ] {
        let error = read(SIZES, "load = \"1 kN\"", &rest).unwrap_err();
        let error = error.to_string();
        assert!(error.contains(expected), "{expected}: {error}");
        let place = format!("case.toml:{line}:");
        assert!(error.contains(&place), "{line}: {error}");
    }
}

/// The example of the reference is a case.
#[test]
fn the_documented_roller() {
    let text = include_str!("../../../../docs/reference/case-file.md");
    let (_, section) = text.split_once("### Rollers").unwrap();
    let (_, example) = section.split_once("```toml\n").unwrap();
    let (example, _) = example.split_once("```").unwrap();
    let text = format!("{example}{MOTION}{STEEL}");
    let case = Case::from_text("case.toml", &text, Path::new("")).unwrap();
    assert_relative_eq!(
        case.contact.roller.unwrap().misalignment,
        0.005_f64.to_radians()
    );
}

/// A roller bearing with a profile has the load of the roller, not that per length; without one it is a line.
#[test]
fn a_roller_of_a_bearing() {
    let machine = "[machine]\nkind = \"roller-bearing\"\nring = \"inner\"\nroller_diameter = \"10 mm\"\n\
                   pitch_diameter = \"50 mm\"\nroller_length = \"12 mm\"\nroller_load = \"2 kN\"\n\
                   inner_ring_speed = \"900 rpm\"\n";
    let read = |profile: &str| {
        let text = format!("{machine}{profile}\n{STEEL}");
        Case::from_text("case.toml", &text, Path::new("")).unwrap()
    };
    let line = read("");
    let roller = read("profile = { kind = \"iso-16281\", diameter = \"10 mm\" }");
    assert!(line.contact.kind.is_line() && !roller.contact.kind.is_line());
    assert_relative_eq!(roller.contact.load, 2e3, max_relative = 1e-12);
    near(roller.contact.line_load(), line.contact.load, 1e-12);
    assert_eq!(roller.contact.radius, line.contact.radius);
}

/// A measured trace with scatter of 0.2 um and a zero in its middle; from the lists and from a file.
#[test]
fn measured_traces_are_made_profiles() {
    let drops = [
        8.966, 5.756, 3.675, 1.405, 0.204, 0.244, -0.156, 0.059, -0.303, 0.248, 0.082, 1.124,
        3.768, 6.028, 8.929,
    ];
    let positions: Vec<f64> = (0..15).map(|i| -4.2 + 0.6 * f64::from(i)).collect();
    let list = |values: &[f64], unit: &str| {
        let values: Vec<String> = values
            .iter()
            .map(|v| format!("\"{v:.3} {unit}\""))
            .collect();
        values.join(", ")
    };
    let profile = format!(
        "profile = {{ kind = \"table\", position = [{}], drop = [{}] }}",
        list(&positions, "mm"),
        list(&drops, "um")
    );
    let folder = tempfile::tempdir().unwrap();
    let rows: Vec<String> = positions
        .iter()
        .zip(drops)
        .map(|(y, z)| format!("{y:.3},{:.3}", -z))
        .collect();
    let csv = format!("position [mm],height [um]\n{}\n", rows.join("\n"));
    std::fs::write(folder.path().join("trace.csv"), csv).unwrap();
    let from_file = "profile = { kind = \"table\", file = \"trace.csv\" }";
    let read = |profile: &str| {
        let text = format!(
            "[contact]\nkind = \"roller\"\n{SIZES}\nload = \"1 kN\"\n{profile}\n{MOTION}{STEEL}"
        );
        Case::from_text("roller.toml", &text, folder.path())
    };
    let lists = read(&profile).unwrap();
    let file = read(from_file).unwrap();
    assert_eq!(lists.contact.roller, file.contact.roller);
    let roller = lists.contact.roller.as_ref().unwrap();
    let [end, _] = roller.profile.drop(roller.length, -4e-3);
    // Between 8.966 and 5.756 um less the lowest of the pooled middle, around -0.05 um.
    assert!((8.0e-6..9.0e-6).contains(&end), "{end}");
    let warned = lists
        .warnings
        .iter()
        .find(|w| w.text.contains("trace of 15 points"));
    let warned = &warned.unwrap().text;
    assert!(
        warned.contains("smallest drop is zero") && warned.contains("fall off towards both ends"),
        "{warned}"
    );
    assert!(
        file.files(folder.path())
            .contains(&folder.path().join("trace.csv"))
    );
    // A slip of a digit is no scatter.
    let slip = profile.replace("\"6.028 um\"", "\"0.028 um\"");
    let error = read(&slip).unwrap_err().to_string();
    assert!(error.contains("by more than scatter"), "{error}");
    let error = read("profile = { kind = \"table\", file = \"none.csv\" }")
        .unwrap_err()
        .to_string();
    assert!(error.contains("none.csv"), "{error}");
}
