//! Points of studies against lists made by hand.

use std::path::Path;

use ertel_input::InputError;
use tempfile::TempDir;

use super::{AxisValue, Study};
use crate::case::Case;
use crate::contains::contains;

const BASE: &str = include_str!("../../../tests/common/cases/line.toml");

fn workspace(study: &str, points: &str) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("base.toml"), BASE).unwrap();
    std::fs::write(
        folder.path().join("study.toml"),
        format!("case = \"base.toml\"\n{study}"),
    )
    .unwrap();
    std::fs::write(folder.path().join("points.csv"), points).unwrap();
    folder
}

fn read(study: &str, points: &str) -> Result<Study, InputError> {
    let folder = workspace(study, points);
    Study::read(&folder.path().join("study.toml"))
}

/// Load and speed of each point.
fn loads_and_speeds(study: &Study) -> Vec<(f64, f64)> {
    let pair = |case: &Case| (case.contact.load, case.motion.entrainment_speed);
    study.points.iter().map(|p| pair(&p.case)).collect()
}

#[test]
fn axes_are_crossed_the_last_one_fastest() {
    let study = read(
        "[[axis]]\nkey = \"contact.load\"\nvalues = [\"10 kN/m\", \"0.02 MN/m\"]\n\
         [[axis]]\nkey = \"motion.entrainment_speed\"\nvalues = [\"1 m/s\", \"2000 mm/s\", \"3 m/s\"]\n",
        "",
    )
    .unwrap();
    assert_eq!(
        loads_and_speeds(&study),
        [
            (1e4, 1.0),
            (1e4, 2.0),
            (1e4, 3.0),
            (2e4, 1.0),
            (2e4, 2.0),
            (2e4, 3.0)
        ]
    );
    let headers: Vec<&str> = study.columns.iter().map(|c| c.header.as_str()).collect();
    assert_eq!(
        headers,
        ["contact.load_N_per_m", "motion.entrainment_speed_m_per_s"]
    );
    assert_eq!(
        study.points[1].label,
        "contact.load = 10 kN/m, motion.entrainment_speed = 2000 mm/s"
    );
}

#[test]
fn zipped_axes_go_side_by_side() {
    let study = read(
        "[[axis]]\nkey = \"contact.load\"\nvalues = [\"10 kN/m\", \"20 kN/m\"]\nzip = \"a\"\n\
         [[axis]]\nkey = \"solver.tolerance\"\nvalues = [1e-6, 1e-7]\n\
         [[axis]]\nkey = \"motion.entrainment_speed\"\nvalues = [\"1 m/s\", \"2 m/s\"]\nzip = \"a\"\n",
        "",
    )
    .unwrap();
    assert_eq!(
        loads_and_speeds(&study),
        [(1e4, 1.0), (1e4, 1.0), (2e4, 2.0), (2e4, 2.0)]
    );
    // A key that the base case does not have.
    let tolerances: Vec<f64> = (study.points.iter())
        .map(|p| p.case.solver.tolerance)
        .collect();
    assert_eq!(tolerances, [1e-6, 1e-7, 1e-6, 1e-7]);
}

#[test]
fn ranges_have_equal_steps_or_equal_ratios() {
    let speeds = |lines: &str| -> Vec<f64> {
        let study = format!("[[axis]]\nkey = \"motion.entrainment_speed\"\n{lines}");
        let study = read(&study, "").unwrap();
        loads_and_speeds(&study).iter().map(|p| p.1).collect()
    };
    let linear = "from = \"0.5 m/s\"\nto = \"2 m/s\"\npoints = 4\n";
    assert_eq!(speeds(linear), [0.5, 1.0, 1.5, 2.0]);
    let log = "from = \"0.1 m/s\"\nto = \"10 m/s\"\npoints = 5\nspacing = \"log\"\n";
    // Roots of ten to six digits.
    assert_eq!(speeds(log), [0.1, 0.316228, 1.0, 3.16228, 10.0]);
    let down = "from = \"2 m/s\"\nto = \"1000 mm/s\"\npoints = 2\n";
    assert_eq!(speeds(down), [2.0, 1.0]);
}

#[test]
fn names_and_tables_are_values() {
    let study = read(
        "[[axis]]\nkey = \"bodies.body_2\"\nvalues = [\"steel\", { youngs_modulus = \"300 GPa\", poissons_ratio = 0.2 }]\n\
         [[axis]]\nkey = \"mesh.preset\"\nvalues = [\"coarse\", \"normal\"]\n",
        "",
    )
    .unwrap();
    let moduli: Vec<f64> = (study.points.iter())
        .map(|p| p.case.body_2.elasticity.youngs_modulus)
        .collect();
    assert_eq!(moduli, [210e9, 210e9, 300e9, 300e9]);
    assert_eq!(study.points[0].values[0], AxisValue::Text("steel".into()));
    assert_eq!(study.columns[0].header, "bodies.body_2");
}

#[test]
fn a_table_of_points_is_crossed_with_axes() {
    let points = "motion.entrainment_speed_mm_per_s; contact.load [kN/m]; lubricant.temperature_degC\n\
                  # a remark\n1500; 10; 40\n2500; 20; 60\n";
    let study = read(
        "points = \"points.csv\"\n[[axis]]\nkey = \"motion.slide_to_roll_ratio\"\nvalues = [0, \"20 %\"]\n",
        points,
    )
    .unwrap();
    assert_eq!(
        loads_and_speeds(&study),
        [(1e4, 1.5), (1e4, 1.5), (2e4, 2.5), (2e4, 2.5)]
    );
    let others: Vec<[f64; 2]> = (study.points.iter())
        .map(|p| {
            [
                p.case.lubricant.temperature,
                p.case.motion.slide_to_roll_ratio,
            ]
        })
        .collect();
    assert_eq!(
        others,
        [[313.15, 0.0], [313.15, 0.2], [333.15, 0.0], [333.15, 0.2]]
    );
    assert_eq!(study.columns[2].header, "lubricant.temperature_K");
}

/// The text kept of a point is its case.
#[test]
fn the_text_of_a_point_reads_as_its_case() {
    let study = read(
        "[[axis]]\nkey = \"bodies.body_2\"\nvalues = [{ youngs_modulus = \"300 GPa\", poissons_ratio = 0.2 }]\n\
         [[axis]]\nkey = \"mesh.preset\"\nvalues = [\"coarse\"]\n",
        "",
    )
    .unwrap();
    let case = study.whole_point(0).unwrap().case;
    let again = Case::from_text("point.toml", &case.source, Path::new("")).unwrap();
    assert_eq!(again.given, case.given);
    assert_eq!(again.echo().mesh, case.echo().mesh);
}

/// File, line and words of the error that a study, or its table of points, makes.
#[test]
fn errors_point_to_the_study() {
    for (study, line, words) in [
        ("", 1, "missing key `axis`"),
        ("[[axis]]\nvalues = [1]\n", 2, "missing key `key`"),
        (
            "[[axis]]\nkey = \"contact.load\"\n",
            2,
            "missing key `values`",
        ),
        (
            "[[axis]]\nkey = \"contact.load\"\nvalues = []\n",
            4,
            "no values",
        ),
        (
            "[[axis]]\nkey = \"contact.load\"\nvalues = [\"1 kN/m\", \"1000 N/m\"]\n",
            4,
            "value 2 of the axis repeats",
        ),
        (
            "[[axis]]\nkey = \"contact.load\"\nvalues = [\"1 kN/m\", \"1 kN\"]\n",
            4,
            "value 2 of the axis is a force",
        ),
        (
            "[[axis]]\nkey = \"contact.load\"\nvalues = [\"1 kN\"]\n",
            4,
            "`load` needs",
        ),
        (
            "[[axis]]\nkey = \"contact.load\"\nvalues = [\"20 kN/m\", \"-1 kN/m\"]\n",
            4,
            "`load` must be",
        ),
        (
            "[[axis]]\nkey = \"contact.laod\"\nvalues = [\"20 kN/m\"]\n",
            3,
            "unknown key `laod` in [contact]",
        ),
        (
            "[[axis]]\nkey = \"bodies.body_2.youngs_modulus\"\nvalues = [\"20 GPa\"]\n",
            3,
            "`bodies.body_2` is a string, not a table",
        ),
        (
            "[[axis]]\nkey = \"contact.hertz_pressure\"\nvalues = [\"1 GPa\"]\n",
            4,
            "hertz_pressure",
        ),
        (
            "[[axis]]\nkey = \"contact..load\"\nvalues = [\"20 kN/m\"]\n",
            3,
            "no key of a case file",
        ),
        (
            "[[axis]]\nkey = \"contact.load\"\nfrom = \"1 kN/m\"\nto = \"2 kN\"\npoints = 3\n",
            5,
            "`to` is a force",
        ),
        (
            "[[axis]]\nkey = \"contact.load\"\nfrom = \"1 kN/m\"\nto = \"2 kN/m\"\n",
            2,
            "missing key `points`",
        ),
        (
            "[[axis]]\nkey = \"contact.load\"\nfrom = \"steel\"\nto = \"2 kN/m\"\npoints = 2\n",
            4,
            "finite number",
        ),
        (
            "[[axis]]\nkey = \"contact.load\"\nfrom = \"0 kN/m\"\nto = \"2 kN/m\"\npoints = 3\nspacing = \"log\"\n",
            4,
            "a logarithmic range cannot include zero",
        ),
        (
            "[[axis]]\nkey = \"contact.load\"\nvalues = [\"1 kN/m\"]\nto = \"2 kN/m\"\n",
            5,
            "a list or a range",
        ),
        (
            "[[axis]]\nkey = \"contact.load\"\nvalues = [\"20 kN/m\"]\n[[axis]]\nkey = \"contact.load\"\nvalues = [\"21 kN/m\"]\n",
            6,
            "varies twice",
        ),
        (
            "[[axis]]\nkey = \"contact.load\"\nvalues = [\"20 kN/m\"]\nzip = \"a\"\n[[axis]]\nkey = \"motion.entrainment_speed\"\nvalues = [\"1 m/s\", \"2 m/s\"]\nzip = \"a\"\n",
            9,
            "has 2 values, but `contact.load` next to it has 1",
        ),
        (
            "[[axis]]\nkey = \"contact.load\"\nvalue = [\"20 kN/m\"]\n",
            4,
            "did you mean `values`",
        ),
        ("points = \"none.csv\"\n", 2, "cannot be read"),
    ] {
        let error = read(study, "").unwrap_err();
        let text = error.to_string();
        assert!(error.file().ends_with("study.toml"), "{study}\n{text}");
        assert_eq!(error.line(), Some(line), "{study}\n{text}");
        assert!(text.contains(words), "{study}\n{text}");
    }
    for (points, line, words) in [
        ("", 1, "empty"),
        ("contact.load_N_per_m\n", 1, "no points"),
        ("contact.load_N\n5\n", 2, "`load` needs"),
        ("contact.load [furlong]\n5\n", 1, "no key with a unit"),
        (
            "contact.load_N_per_m, contact.load_kN_per_m\n5,6\n",
            1,
            "varies twice",
        ),
        (
            "contact.load_N_per_m\n20000\n5,6\n",
            3,
            "column 2: this line has 2 cells",
        ),
        (
            "contact.load_N_per_m\n20000\n\"5\n",
            3,
            "not closed on its line",
        ),
        (
            "contact.load_N_per_m, lubricant.temperature_K\n20000,\n",
            2,
            "column 2: the cell of",
        ),
        (
            "contact.load_N_per_m\n20000\nmuch\n",
            3,
            "does not start with a number",
        ),
    ] {
        let error = read("points = \"points.csv\"\n", points).unwrap_err();
        let text = error.to_string();
        assert!(error.file().ends_with("points.csv"), "{points}\n{text}");
        assert_eq!(error.line(), Some(line), "{points}\n{text}");
        assert!(text.contains(words), "{points}\n{text}");
    }
    // The help gives the values of the point.
    let study = "[[axis]]\nkey = \"contact.load\"\nvalues = [\"20 kN/m\", \"-1 kN/m\"]\n";
    let text = read(study, "").unwrap_err().to_string();
    assert!(text.contains("point 2 of"), "{text}");
}

/// Load sharing along a path of contact: shares repeat, points do not.
#[test]
fn values_of_zipped_axes_may_repeat() {
    let axes = |shares: &str| {
        format!(
            "[[axis]]\nkey = \"contact.load\"\nvalues = {shares}\nzip = \"path\"\n\
             [[axis]]\nkey = \"motion.entrainment_speed\"\nvalues = [\"1 m/s\", \"2 m/s\", \"1 m/s\"]\nzip = \"path\"\n"
        )
    };
    let study = read(&axes("[\"10 kN/m\", \"10 kN/m\", \"20 kN/m\"]"), "").unwrap();
    assert_eq!(
        loads_and_speeds(&study),
        [(1e4, 1.0), (1e4, 2.0), (2e4, 1.0)]
    );
    let error = read(&axes("[\"10 kN/m\", \"20 kN/m\", \"10 kN/m\"]"), "").unwrap_err();
    let text = error.to_string();
    contains(&text, "value 3 repeats value 1 in all axes");
    assert_eq!(error.line(), Some(4));
}

/// Titles and names are text, whatever they look like.
#[test]
fn columns_of_text_stay_text() {
    let points = "title,contact.load / N/m\n-10 deg,10000\n5 N,20000\n1,30000\n1.50,40000\n";
    let study = read("points = \"points.csv\"\n", points).unwrap();
    let titles: Vec<&str> = study.points.iter().map(|p| p.case.title.as_str()).collect();
    assert_eq!(titles, ["-10 deg", "5 N", "1", "1.50"]);
    assert_eq!(study.columns[0].header, "title");
    assert_eq!(
        study.points[0].values[0],
        AxisValue::Text("-10 deg".to_owned())
    );
    let axes = "[[axis]]\nkey = \"title\"\nvalues = [\"10 deg\", \"5 N\"]\nzip = \"a\"\n\
                [[axis]]\nkey = \"contact.load\"\nvalues = [\"10 kN/m\", \"20 kN/m\"]\nzip = \"a\"\n";
    let study = read(axes, "").unwrap();
    assert_eq!(study.columns[0].header, "title");
    assert_eq!(study.points[1].case.title, "5 N");
}

/// The points of a study are read as any table is: units below, empty columns, decimal commas.
#[test]
fn points_are_a_table_like_any_other() {
    for points in [
        "contact.load_N_per_m,motion.entrainment_speed_m_per_s\n10000,1\n20000,2.5\n",
        "From the rig;;\ncontact.load [kN/m];motion.entrainment_speed in m/s;\n10;1;\n\n20;2,5;\n",
        "contact.load\tmotion.entrainment_speed\nkN/m\tm/s\n10\t1\n20\t2,5\n",
        ",contact.load / N/m,motion.entrainment_speed / m/s\n0,10000,1\n1,20000,2.5\n",
    ] {
        let study = read("points = \"points.csv\"\n", points)
            .unwrap_or_else(|error| panic!("{points}\n{error}"));
        assert_eq!(
            loads_and_speeds(&study),
            [(1e4, 1.0), (2e4, 2.5)],
            "{points}"
        );
    }
}
