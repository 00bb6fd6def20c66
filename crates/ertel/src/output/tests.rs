use std::fs;

use serde_json::Value;

use super::folder::NewFolder;
use super::sample::Sample;
use super::*;
use crate::contains::contains;
use crate::params::Method;
use crate::solution::BodyField;

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(folder)
        .unwrap()
        .map(|e| e.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

/// A sample with a body of one cell.
fn with_body(sample: &Sample) -> Sample {
    let (case, mut solution) = sample.clone();
    let n = if solution.shape.is_line() { 3 } else { 4 };
    let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]];
    solution.body = Some(BodyField {
        points: corners[..n].to_vec(),
        cells: vec![(0..n as u32).collect()],
        displacement: vec![[0.0, 0.0, -1e-6]; n],
    });
    (case, solution)
}

fn write_to(target: &Path, sample: &Sample) -> Result<(), OutputError> {
    let (case, solution) = with_body(sample);
    let params = OutputParams {
        body_field: true,
        netcdf: true,
        ..OutputParams::default()
    };
    write(&case, &solution, target, &params)
}

#[test]
fn circular_contact_writes_every_file() {
    let place = tempfile::tempdir().unwrap();
    let target = place.path().join("new/ball");
    write_to(&target, sample::circle()).unwrap();
    assert_eq!(
        names(&target),
        [
            "body.vtu",
            "case.toml",
            "centreline.csv",
            "centreline.svg",
            "convergence.svg",
            "film.svg",
            "pressure.svg",
            "report.html",
            "report.txt",
            "result.json",
            "result.nc",
            "surface.vtu",
        ]
    );
    // The temporary folder is removed
    assert_eq!(names(&place.path().join("new")), ["ball"]);
}

/// The text that entered the keys of journals before `result.nc` existed: studies resume from them.
#[test]
fn default_output_text_is_unchanged() {
    let text = "OutputParams { folder: None, pictures: PictureFormats { svg: true, pdf: false, png: false }, body_field: false, \
                interferogram: None, sensitivities: WhereUncertain }";
    assert_eq!(format!("{:?}", OutputParams::default()), text);
    let asked = OutputParams {
        netcdf: true,
        ..OutputParams::default()
    };
    assert_ne!(format!("{asked:?}"), text);
}

/// A folder on disk and files in memory have the same names and the same bytes.
#[test]
fn files_in_memory_are_those_of_the_folder() {
    let sample = sample::circle();
    let place = tempfile::tempdir().unwrap();
    let target = place.path().join("ball");
    write_to(&target, sample).unwrap();
    let params = OutputParams {
        body_field: true,
        netcdf: true,
        ..OutputParams::default()
    };
    let (mut case, solution) = with_body(sample);
    case.case_file = Some(fs::read_to_string(target.join("case.toml")).unwrap());
    let mut files = super::files(&case, &solution, &params).unwrap();
    files.sort_by(|a, b| a.name.cmp(&b.name));
    let found: Vec<&str> = files.iter().map(|file| file.name.as_str()).collect();
    assert_eq!(names(&target), found);
    for file in &files {
        let written = fs::read(target.join(&file.name)).unwrap();
        assert_eq!(file.bytes, written, "{}", file.name);
    }
}

/// A line contact has no maps. No number of the document may become `null`, except those
/// listed.
#[test]
fn line_contact_result_is_complete() {
    let place = tempfile::tempdir().unwrap();
    let target = place.path().join("roller");
    write_to(&target, sample::line()).unwrap();
    assert!(!names(&target).contains(&"film.svg".to_owned()));
    let text = fs::read_to_string(target.join("result.json")).unwrap();
    let json: Value = serde_json::from_str(&text).unwrap();
    assert_eq!(json["format"], FORMAT);
    assert_eq!(json["kind"], "line");
    let (_, solution) = sample::line();
    let film = solution.summary.film_central.value;
    let written = json["summary"]["film_central"]["value"].as_f64().unwrap();
    assert!((written / film - 1.0).abs() < 1e-15);
    assert_eq!(json["case"]["given"]["contact"]["load"], "50 kN/m");
    assert_eq!(json["case"]["si"]["contact"]["load"], 5e4);
    let mut nulls = Vec::new();
    find_nulls(&json, "", &mut nulls);
    assert!(
        nulls.iter().all(|path| path.starts_with("/formulas")
            || path.starts_with("/case/si/mesh/")
            || path == "/case/si/solver/elasticity"
            || path == "/case/si/solver/method"
            || path == "/case/si/fluid/shear_thinning"
            // A Newtonian fluid without a spike.
            || path == "/summary/pressure_spike"
            || path == "/film_reduction"
            || path.starts_with("/traction/beyond_")),
        "{nulls:?}"
    );
}

fn find_nulls(value: &Value, path: &str, found: &mut Vec<String>) {
    match value {
        Value::Null => found.push(path.to_owned()),
        Value::Object(map) => map
            .iter()
            .for_each(|(k, v)| find_nulls(v, &format!("{path}/{k}"), found)),
        Value::Array(list) => list.iter().for_each(|v| find_nulls(v, path, found)),
        _ => {}
    }
}

#[test]
fn former_result_is_replaced() {
    let place = tempfile::tempdir().unwrap();
    let target = place.path().join("case");
    write_to(&target, sample::circle()).unwrap();
    write_to(&target, sample::line()).unwrap();
    assert!(!target.join("film.svg").exists());
    assert_eq!(names(place.path()), ["case"]);
}

#[test]
fn foreign_folders_and_files_are_not_replaced() {
    let place = tempfile::tempdir().unwrap();
    let target = place.path().join("mine");
    fs::create_dir(&target).unwrap();
    // An empty folder may be used
    check_target(&target).unwrap();
    fs::write(target.join("notes.txt"), "precious").unwrap();
    let error = write_to(&target, sample::line()).unwrap_err();
    assert!(
        matches!(error, OutputError::ForeignFolder { .. }),
        "{error}"
    );
    // A result.json of another program is foreign
    fs::write(target.join("result.json"), "{\"format\": \"other\"}").unwrap();
    assert!(write_to(&target, sample::line()).is_err());
    assert_eq!(names(&target), ["notes.txt", "result.json"]);

    let file = place.path().join("file");
    fs::write(&file, "").unwrap();
    let error = write_to(&file, sample::line()).unwrap_err();
    assert!(matches!(error, OutputError::NotAFolder { .. }), "{error}");
    let error = write_to(&file.join("below"), sample::line()).unwrap_err();
    assert!(matches!(error, OutputError::Io { .. }), "{error}");
    assert_eq!(names(place.path()), ["file", "mine"]);
}

#[test]
fn folders_with_other_files_are_not_replaced() {
    let place = tempfile::tempdir().unwrap();
    let target = place.path().join("case");
    write_to(&target, sample::line()).unwrap();
    fs::write(target.join("notes.txt"), "precious").unwrap();
    let error = write_to(&target, sample::line()).unwrap_err();
    assert!(error.to_string().contains("notes.txt"), "{error}");
}

#[test]
fn failure_half_way_leaves_the_former_result() {
    let place = tempfile::tempdir().unwrap();
    let target = place.path().join("case");
    write_to(&target, sample::line()).unwrap();
    let before = fs::read(target.join("result.json")).unwrap();
    let attempt = || -> Result<(), OutputError> {
        let folder = NewFolder::next_to(&target)?;
        folder
            .root()
            .file("result.json", |out| out.write_all(b"new"))?;
        folder
            .root()
            .file("report.txt", |_| Err(io::ErrorKind::StorageFull.into()))?;
        folder.finish()
    };
    let error = attempt().unwrap_err();
    assert!(error.to_string().contains("report.txt"), "{error}");
    assert_eq!(fs::read(target.join("result.json")).unwrap(), before);
    assert_eq!(names(place.path()), ["case"]);
}

#[test]
fn numbers_that_are_not_finite_are_not_written() {
    let place = tempfile::tempdir().unwrap();
    let target = place.path().join("case");
    let (case, mut solution) = sample::line().clone();
    solution.centreline.viscosity[3] = f64::INFINITY;
    let error = write(&case, &solution, &target, &OutputParams::default()).unwrap_err();
    contains(&error.to_string(), "centreline.viscosity[3]");
    assert_eq!(names(place.path()), [] as [&str; 0]);
}

/// All three formats, or only the requested ones; each can be replaced by another run.
#[test]
fn pictures_have_the_requested_formats() {
    let place = tempfile::tempdir().unwrap();
    let target = place.path().join("x");
    let (case, solution) = sample::circle();
    for (formats, suffixes) in [
        (vec!["svg", "pdf", "png"], vec!["pdf", "png", "svg"]),
        (vec!["pdf"], vec!["pdf"]),
        (vec![], vec![]),
    ] {
        let params = OutputParams {
            pictures: PictureFormats::named(formats).unwrap(),
            ..OutputParams::default()
        };
        write(case, solution, &target, &params).unwrap();
        let found = names(&target);
        let found = found
            .iter()
            .filter_map(|name| name.strip_prefix("pressure."));
        assert_eq!(found.collect::<Vec<_>>(), suffixes);
    }
    assert_eq!(PictureFormats::named(["jpg"]), None);
}

/// Finite elements converge to `solver.tolerance`; finite volumes stop at a tolerance of the step, and no tolerance line is drawn.
#[test]
fn a_tolerance_is_drawn_only_for_residuals() {
    let (case, solution) = sample::circle();
    for (method, is_drawn) in [
        (Method::FiniteElements, true),
        (Method::FiniteVolumes, false),
    ] {
        let mut solution = solution.clone();
        solution.stats.method = method;
        let drawn = pictures::pictures("", &solution, Some(1e-8));
        let convergence = drawn.iter().find(|p| p.name == "convergence").unwrap();
        assert_eq!(
            convergence.svg.contains("tolerance of the solution"),
            is_drawn
        );
        let data = html::page_data(&html::report_page(case, &solution, 1e-8)).unwrap();
        assert_eq!(data["results"][0]["tolerance"].is_number(), is_drawn);
    }
}

/// Basic well-formedness of pictures: every group is closed, and no number is NaN.
#[test]
fn pictures_are_well_formed() {
    for ((_, solution), n) in [(sample::line(), 2), (sample::circle(), 4)] {
        let pictures = pictures::pictures("T < U", solution, Some(1e-8));
        assert_eq!(pictures.len(), n);
        for picture in pictures {
            let svg = picture.svg;
            assert!(
                !svg.contains("NaN") && !svg.contains("inf"),
                "{}",
                picture.name
            );
            assert_eq!(svg.matches("<g").count(), svg.matches("</g>").count());
            assert!(svg.contains("T &lt; U"));
        }
    }
}
