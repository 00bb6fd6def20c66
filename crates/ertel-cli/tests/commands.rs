//! The commands end to end: output and exit codes.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::common::{code, contains, ertel, ertel_here, read, stderr, stderr_of, stdout, write};

/// A file of `tests/good`.
fn good(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/good")
        .join(name)
}

#[test]
fn wrong_usage_exits_with_2() {
    for arguments in [
        "sovle",
        "solve",
        "solve case.toml --nonsense",
        "fluids show",
        "",
    ] {
        let output = ertel_here(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(stderr(&output).contains("Usage"), "{arguments:?}");
    }
    code(&ertel_here("--help"), 0);
    code(&ertel_here("--version"), 0);
}

#[test]
fn a_case_file_that_cannot_be_read_exits_with_2() {
    let error = stderr_of(ertel_here("solve no/such/case.toml"), 2);
    contains(&error, "no/such/case.toml cannot be read");
}

#[test]
fn a_good_case_passes_the_check_with_its_warnings() {
    let path = good("quick.toml");
    let output = ertel_here("solve --check tests/good/quick.toml");
    code(&output, 0);

    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(&path).unwrap();
    let sliding = text.replace("ratio = 0.0", "ratio = 2.5");
    write(&folder, "sliding.toml", sliding);
    let output = ertel(&folder, "solve --check sliding.toml");
    code(&output, 0);
    contains(
        stderr(&output),
        "warning: the slide-to-roll ratio 2.5 is beyond 2",
    );
}

#[test]
fn the_lists_name_every_fluid_and_solid() {
    let output = ertel_here("fluids");
    for name in ertel_rheology::database::fluid_names() {
        contains(stdout(&output), name);
    }
    let output = ertel_here("solids list");
    for name in ertel_rheology::database::solid_names() {
        contains(stdout(&output), name);
    }
}

#[test]
fn every_fluid_and_solid_can_be_shown() {
    for name in ertel_rheology::database::fluid_names() {
        let output = ertel_here(&format!("fluids show {name} --temperature '300 K'"));
        assert_eq!(output.status.code(), Some(0), "{name}: {}", stderr(&output));
        assert!(!stdout(&output).contains("NaN"), "{name}");
    }
    for name in ertel_rheology::database::solid_names() {
        let output = ertel_here(&format!("solids show {name}"));
        assert_eq!(output.status.code(), Some(0), "{name}: {}", stderr(&output));
    }
}

#[test]
fn a_fluid_is_shown_with_data_sources_and_states() {
    let output = ertel_here("fluids show squalane-pip");
    let text = stdout(&output);
    // Habchi 2008, Tables 4.1 and 5.2; alpha* recomputed by an independent script: 18.9 1/GPa.
    for words in [
        "70.5 mPa.s",
        "8.375 GPa",
        "thesis  [1]",
        "[1] Habchi",
        "18.92 1/GPa",
        "0 Pa to 473.2 MPa",
        "outside the range of the data",
    ] {
        contains(text, words);
    }
}

#[test]
fn shear_thinning_is_shown_with_its_limits() {
    let output = ertel_here("fluids show squalane-pip");
    let text = stdout(&output);
    // Eq. 4.3 with Table 4.1, by mpmath: plateaus end at 9.0047 kPa and 237.49 GPa; 33.029 mPa.s at 1 MPa.
    for words in [
        "Shear thinning at ambient pressure (carreau)",
        "9.005 kPa",
        "237.5 GPa",
        "0.2227",
        "33.03 mPa.s  0.4685",
    ] {
        contains(text, words);
    }
    // PAO 650 has no second plateau; glycerol does not thin.
    let output = ertel_here("fluids show pao-650");
    let text = stdout(&output);
    contains(text, "18.05 kPa");
    contains(text, "none");
    let output = ertel_here("fluids show glycerol");
    let text = stdout(&output);
    assert!(!text.contains("Shear thinning"), "{text}");
}

#[test]
fn unknown_names_exit_with_2_and_the_choices() {
    let error = stderr_of(ertel_here("fluids show squalene-pip"), 2);
    contains(&error, "did you mean `squalane-pip`?");
    contains(&error, "glycerol");
    let error = stderr_of(ertel_here("solids show stel"), 2);
    contains(&error, "did you mean `steel`?");
}

#[test]
fn bad_temperatures_exit_with_2() {
    for (temperature, words) in [
        ("40", "has no unit"),
        ("40 mm", "is a length, but a temperature is needed"),
        ("40 K", "between -173.15 °C and 726.85 °C"),
        ("-300 degC", "below absolute zero"),
    ] {
        let output = ertel_here(&format!(
            "fluids show glycerol --temperature='{temperature}'"
        ));
        assert_eq!(output.status.code(), Some(2), "{temperature}");
        contains(stderr(&output), words);
    }
}

#[test]
fn the_viscosity_curve_is_written_whole_or_not_at_all() {
    let folder = tempfile::tempdir().unwrap();
    let show = |name: &str| ertel(&folder, &format!("fluids show glycerol --plot {name}"));
    code(&show("curve.svg"), 0);
    let svg = read(&folder, "curve.svg");
    assert!(svg.starts_with("<svg") || svg.starts_with("<?xml"));
    assert!(svg.trim_end().ends_with("</svg>"));

    for (name, begin) in [("curve.pdf", &b"%PDF-"[..]), ("curve.PNG", b"\x89PNG\r\n")] {
        code(&show(name), 0);
        let picture = std::fs::read(folder.path().join(name)).unwrap();
        assert!(picture.starts_with(begin), "{name}");
    }

    for name in ["curve.jpg", "curve"] {
        let error = stderr_of(show(name), 2);
        contains(&error, "must end in .svg, .pdf or .png");
    }

    let error = stderr_of(show("absent/curve.svg"), 1);
    contains(&error, "cannot write");
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 3);
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_behind_stdout_exits_with_1() {
    let full = std::fs::OpenOptions::new()
        .write(true)
        .open("/dev/full")
        .unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_ertel"))
        .arg("fluids")
        .stdout(full)
        .output()
        .unwrap();
    code(&output, 1);
    contains(stderr(&output), "cannot write to stdout");
}

/// Conductivity and heat capacity of a table, which ends at 60 MPa and keeps its last value.
#[test]
fn tables_of_heat_are_shown_over_pressure() {
    let output = ertel_here("fluids show r134a");
    let text = stdout(&output);
    let values = |start: &str| {
        let mut lines = text.lines().map(str::trim);
        let line = lines.find(|line| line.starts_with(start) && line.contains("kg/m³"));
        let line = line.unwrap_or_else(|| panic!("no state at {start}\n{text}"));
        let (_, heat) = line.split_once("kg/m³").unwrap();
        heat.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    // CoolProp 8 at -0.5 °C and saturation.
    assert_eq!(values("0 Pa "), "0.09224 W/(m.K) 1340 J/(kg.K)");
    assert_ne!(values("50 MPa"), values("100 MPa *"));
    assert_eq!(values("100 MPa *"), values("1 GPa *"));
    // A constant is among the data and needs no column.
    let glycerol = ertel_here("fluids show glycerol");
    assert!(!stdout(&glycerol).contains("conductivity k"));
    contains(stdout(&glycerol), "0.29 W/(m.K)");
}

/// The shipped cases are valid; a study in the same folder has no `[contact]`.
#[test]
fn every_shipped_case_passes_the_check() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    let mut n_cases = 0;
    let files = |folder: &Path| -> Vec<std::path::PathBuf> {
        let entries = std::fs::read_dir(folder).unwrap();
        entries
            .map(|e| e.unwrap().path())
            .filter(|p| p.is_file())
            .collect()
    };
    for path in [files(&folder), files(&folder.join("machine"))].concat() {
        let text = std::fs::read_to_string(&path).unwrap();
        if text.contains("[contact]") || text.contains("[machine]") {
            let output = ertel_here(&format!("solve --check {}", path.display()));
            code(&output, 0);
            // The oil of a rig is known by its data sheet alone, which says nothing of the pressures there.
            let is_beyond = |line: &&str| {
                path.ends_with("measured-films.toml")
                    && line.contains("viscosity law extrapolated above 0.30 GPa")
            };
            // About the nose of a cam both surfaces move against each other.
            let reverses = |line: &&str| {
                path.ends_with("cam-turn.toml") && line.contains("opposite directions")
            };
            // Asperities that bear most of the load wear the bodies.
            let wears =
                |line: &&str| path.ends_with("wear.toml") && line.contains("[asperity-load]");
            let warns = |line: &&str| {
                line.starts_with("warning") && !is_beyond(line) && !reverses(line) && !wears(line)
            };
            let error = stderr(&output);
            assert_eq!(error.lines().find(warns), None);
            n_cases += 1;
        }
    }
    assert!(n_cases >= 12);
}
