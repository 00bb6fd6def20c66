//! `ertel fit stribeck` end to end: constants of a solved curve with noise, constants that the data do not determine, and exit codes.

use tempfile::TempDir;

use crate::common::{code, contains, ertel, root, rows_of, stderr, stdout, write};

/// Normally distributed numbers: Python's `random.Random(7).gauss(0, 1)`, six times.
const NOISE: [f64; 6] = [-0.2559, 0.5114, -0.2261, -0.3151, -0.9300, -0.2133];

/// 95 % of Student's t for six readings and two constants.
const STUDENT: f64 = 2.776;

/// The shipped cylinder with other roughness and without its curve, and `[curve]` over speeds in m/s.
fn cylinder(roughness: &str) -> String {
    let text = std::fs::read_to_string(root().join("cases/stribeck.toml")).unwrap();
    let (text, _) = text.split_once("[curve]").unwrap();
    let (before, rest) = text.split_once("[surface_roughness]").unwrap();
    let (_, after) = rest.split_once("\n\n").unwrap();
    format!("{before}[surface_roughness]\n{roughness}\n\n{after}")
}

const ASPERITIES: &str =
    "asperity_group = 0.06\nrms_height_to_asperity_radius = 1e-2\nflow = \"average-gap\"\n";

/// Measures the cylinder of 0.25 µm and a boundary friction coefficient of 0.12 at these speeds, m/s, with the noise times `scatter`: data.csv; and writes case.toml
/// with another roughness and without that coefficient.
fn measured(speeds: &[f64], scatter: f64) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let own = "body_1_rms_height = \"0.20 um\"\nbody_2_rms_height = \"0.15 um\"\nboundary_friction_coefficient = 0.12\n";
    let values: Vec<String> = speeds.iter().map(|u| format!("\"{u} m/s\"")).collect();
    let curve = format!(
        "\n[curve]\nquantity = \"motion.entrainment_speed\"\nvalues = [{}]\n",
        values.join(", ")
    );
    let case = cylinder(&format!("{own}{ASPERITIES}")) + &curve;
    write(&folder, "own.toml", &case);
    let output = ertel(&folder, "solve own.toml --quiet");
    code(&output, 0);
    let rows = rows_of(&folder.path().join("results/own/curve.csv"));
    let mut data = "entrainment_speed [m/s],traction_coefficient\n".to_owned();
    for ((row, speed), noise) in rows.iter().zip(speeds).zip(NOISE) {
        let value: f64 = row["friction_total"].parse().unwrap();
        data += &format!("{speed},{}\n", value.abs() + scatter * noise);
    }
    write(&folder, "data.csv", &data);
    let other = "body_1_rms_height = \"0.30 um\"\nbody_2_rms_height = \"0.20 um\"\n";
    write(
        &folder,
        "case.toml",
        cylinder(&format!("{other}{ASPERITIES}")),
    );
    folder
}

const FIT: &str = "fit stribeck data.csv --case case.toml --quiet";

/// Value and standard uncertainty in a line of the report, in its units.
fn constant(report: &str, name: &str) -> [f64; 2] {
    let line = report.lines().find(|line| line.contains(name)).unwrap();
    let (value, standard) = line.split_once(name).unwrap().1.split_once('±').unwrap();
    let number = |text: &str| text.split_whitespace().next().unwrap().parse().unwrap();
    [number(value), number(standard)]
}

#[test]
fn constants_of_a_solved_curve_with_noise() {
    let folder = measured(&[2.0, 1.0, 0.5, 0.25, 0.1, 0.02], 1e-3);
    let output = ertel(&folder, FIT);
    code(&output, 0);
    let report = stdout(&output);
    let [sigma, standard] = constant(report, "composite rms height σ");
    // nm or µm.
    let expected = if sigma > 1.0 { 250.0 } else { 0.25 };
    assert!((sigma - expected).abs() < STUDENT * standard, "{report}");
    assert!(standard < 0.1 * expected, "{report}");
    let [friction, standard] = constant(report, "boundary friction coefficient");
    assert!((friction - 0.12).abs() < STUDENT * standard, "{report}");
    assert!(standard < 0.005, "{report}");
    assert!(report.contains("correlation of"), "{report}");
    // The section serves in a case.
    let (_, section) = report.split_once("[surface_roughness]").unwrap();
    write(&folder, "fitted.toml", cylinder(section.trim()));
    let output = ertel(&folder, "solve --check fitted.toml");
    code(&output, 0);
}

/// In full films asperities have no influence.
#[test]
fn full_films_do_not_resolve_the_surfaces() {
    let folder = measured(&[30.0, 20.0, 14.0, 9.0], 1e-4);
    let output = ertel(&folder, FIT);
    code(&output, 0);
    let report = stdout(&output);
    for name in ["composite rms height σ", "boundary friction coefficient"] {
        let line = report.lines().find(|line| line.contains(name)).unwrap();
        assert!(line.contains("not resolved"), "{report}");
    }
    contains(report, "not resolved: value of the case");
}

#[test]
fn what_is_not_fitted() {
    let folder = tempfile::tempdir().unwrap();
    let heights = "body_1_rms_height = \"0.20 um\"\nbody_2_rms_height = \"0.15 um\"\n";
    let rough = cylinder(&format!("{heights}{ASPERITIES}"));
    let smooth = cylinder(heights);
    let persson = cylinder(&format!(
        "{heights}asperity_law = \"persson\"\nrms_slope = 0.1"
    ));
    let four =
        "entrainment_speed [m/s],traction_coefficient\n1,0.02\n0.5,0.03\n0.2,0.05\n0.1,0.07\n";
    let two = "entrainment_speed [m/s],traction_coefficient\n1,0.02\n0.5,0.03\n";
    let films = "entrainment_speed [m/s],film_central [nm]\n1,200\n0.5,150\n0.2,100\n0.1,70\n";
    for (case, data, more, words) in [
        (&rough, two, "", "2 readings do not determine 2 constants"),
        (&rough, films, "", "traction_coefficient"),
        (&smooth, four, "", "asperity_group"),
        (
            &persson,
            four,
            "--asperity-group",
            "asperity_group is not a number",
        ),
    ] {
        write(&folder, "case.toml", case);
        write(&folder, "data.csv", data);
        let output = ertel(&folder, &format!("{FIT} {more}"));
        let message = stderr(&output);
        code(&output, 2);
        assert!(message.contains(words), "{words}: {message}");
    }
}
