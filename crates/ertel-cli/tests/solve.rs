//! `ertel solve` end to end: results, exit codes, and nothing half-written.

use std::path::{Path, PathBuf};
use std::process::Command;

use tempfile::TempDir;

use crate::common::{
    Running, code, command, contains, read, solve, stderr_of, stdout_of, text, write,
};

/// A folder with a copy of `tests/good/<name>`.
fn workspace(name: &str) -> TempDir {
    let good = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/good");
    let folder = tempfile::tempdir().unwrap();
    std::fs::copy(good.join(name), folder.path().join(name)).unwrap();
    folder
}

fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut names: Vec<String> = entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

/// Exit code 1, the words on stderr, and the folder as it was.
fn refused(folder: &TempDir, arguments: &str, words: &str) {
    let before = names(folder.path());
    let message = stderr_of(solve(folder, arguments), 1);
    contains(&message, words);
    assert_eq!(names(folder.path()), before);
}

#[test]
fn results_are_reported_and_written() {
    let folder = workspace("quick.toml");
    let output = solve(&folder, "quick.toml");
    let report = text(&output.stdout);
    code(&output, 0);
    contains(report, "central film thickness");
    contains(report, "results/quick");
    contains(text(&output.stderr), "Newton");

    let results = folder.path().join("results/quick");
    for name in [
        "result.json",
        "report.txt",
        "centreline.csv",
        "surface.vtu",
        "centreline.svg",
    ] {
        assert!(results.join(name).exists(), "{name}");
    }
    let kept = std::fs::read_to_string(results.join("case.toml")).unwrap();
    let case = read(&folder, "quick.toml");
    assert_eq!(kept, case);
    assert_eq!(names(&folder.path().join("results")), ["quick"]);
}

#[test]
fn the_folder_comes_from_the_command_line_or_the_case() {
    let folder = workspace("quick.toml");
    let path = folder.path().join("quick.toml");
    let case = std::fs::read_to_string(&path).unwrap();
    std::fs::write(
        &path,
        case + "\n[output]\nfolder = \"from/case\"\nbody_field = true\n",
    )
    .unwrap();
    code(&solve(&folder, "quick.toml"), 0);
    let results = folder.path().join("from/case");
    assert!(results.join("result.json").exists());
    assert!(results.join("body.vtu").exists());

    let output = solve(&folder, "quick.toml --output from/line");
    code(&output, 0);
    assert_eq!(names(&folder.path().join("from")), ["case", "line"]);
}

#[test]
fn a_former_result_is_replaced_and_quiet_is_quiet() {
    let folder = workspace("quick.toml");
    let arguments = "quick.toml --quiet";
    code(&solve(&folder, arguments), 0);
    let report = folder.path().join("results/quick/report.txt");
    std::fs::write(&report, "old").unwrap();
    let output = solve(&folder, arguments);
    code(&output, 0);
    assert_eq!((text(&output.stdout), text(&output.stderr)), ("", ""));
    contains(&std::fs::read_to_string(&report).unwrap(), "film thickness");
}

#[test]
fn what_belongs_to_somebody_else_is_not_replaced() {
    let folder = workspace("quick.toml");
    let thesis = folder.path().join("thesis");
    std::fs::create_dir(&thesis).unwrap();
    std::fs::write(thesis.join("chapter.txt"), "years of work").unwrap();
    refused(
        &folder,
        "quick.toml --output thesis",
        "will not replace the folder thesis",
    );
    assert!(thesis.join("chapter.txt").exists());

    write(&folder, "file", "");
    refused(
        &folder,
        "quick.toml --output file",
        "it is a file, not a folder",
    );
    refused(&folder, "quick.toml --output file/below", "cannot write");
}

#[cfg(unix)]
#[test]
fn an_unwritable_folder_is_reported_before_the_solve() {
    use std::os::unix::fs::PermissionsExt;
    let folder = workspace("quick.toml");
    let locked = folder.path().join("locked");
    std::fs::create_dir(&locked).unwrap();
    std::fs::set_permissions(&locked, std::fs::Permissions::from_mode(0o555)).unwrap();
    // The administrator may write anywhere; /proc refuses even him.
    let place = if std::fs::write(locked.join("probe"), "").is_ok() {
        PathBuf::from("/proc/ertel-results")
    } else {
        locked.join("results")
    };
    let output = solve(&folder, &format!("quick.toml --output {}", place.display()));
    code(&output, 1);
    let message = text(&output.stderr);
    contains(message, "cannot write results to");
    assert!(!message.contains("Newton"), "{message}");
}

/// A limit on the size of files stops the writing halfway, as a full disk does.
#[cfg(target_os = "linux")]
#[test]
fn a_disk_that_fills_up_leaves_nothing_half_written() {
    let folder = workspace("quick.toml");
    let limited = |folder: &TempDir| {
        // 32 blocks of 512 or 1024 bytes: some files fit, others do not.
        Command::new("sh")
            .arg("-c")
            .arg("trap '' XFSZ; ulimit -f 32; exec \"$0\" solve quick.toml --output steel")
            .arg(env!("CARGO_BIN_EXE_ertel"))
            .current_dir(folder)
            .output()
            .unwrap()
    };
    let output = limited(&folder);
    let message = text(&output.stderr);
    code(&output, 1);
    contains(message, "error: cannot write ");
    contains(message, "/steel/");
    assert_eq!(names(folder.path()), ["quick.toml"]);

    // A former result survives.
    code(&solve(&folder, "quick.toml --output steel"), 0);
    let before = std::fs::read(folder.path().join("steel/result.json")).unwrap();
    code(&limited(&folder), 1);
    assert_eq!(
        std::fs::read(folder.path().join("steel/result.json")).unwrap(),
        before
    );
    assert_eq!(names(folder.path()), ["quick.toml", "steel"]);
}

#[test]
fn no_convergence_exits_with_3_and_writes_nothing() {
    let folder = workspace("quick.toml");
    let path = folder.path().join("quick.toml");
    let case = std::fs::read_to_string(&path).unwrap();
    std::fs::write(&path, case + "\n[solver]\nmax_iterations = 1\n").unwrap();
    let error = stderr_of(solve(&folder, "quick.toml"), 3);
    contains(&error, "no convergence");
    assert_eq!(names(folder.path()), ["quick.toml"]);
}

#[test]
fn a_mesh_that_cannot_be_built_exits_with_2() {
    let folder = workspace("quick.toml");
    let path = folder.path().join("quick.toml");
    let case = std::fs::read_to_string(&path).unwrap();
    std::fs::write(
        &path,
        case + "body_width = 8\n[solver]\nelasticity = \"equivalent\"\n",
    )
    .unwrap();
    let error = stderr_of(solve(&folder, "quick.toml"), 2);
    contains(&error, "see [mesh] in the case file");
    assert_eq!(names(folder.path()), ["quick.toml"]);
}

#[cfg(unix)]
#[test]
fn ctrl_c_exits_with_130_and_writes_nothing() {
    let folder = workspace("slow.toml");
    let mut run = Running::start(command(&folder, "solve slow.toml"));
    let first = run.lines.next().unwrap().unwrap();
    contains(&first, "grid 1");
    let rest = run.interrupt();
    contains(rest.last().unwrap(), "interrupted; nothing was written");
    // Stopped on the way, not after the last stage.
    assert!(
        !rest.iter().any(|line| line.starts_with("stage 3")),
        "{rest:?}"
    );
    assert_eq!(names(folder.path()), ["slow.toml"]);
}

/// Every picture in every format, and replaced by a run that asks for others.
#[test]
fn pictures_are_written_in_the_formats_that_are_asked_for() {
    let folder = workspace("quick.toml");
    let output = solve(&folder, "quick.toml --png --pdf");
    code(&output, 0);
    let results = folder.path().join("results/quick");
    let found = names(&results);
    let svg = found.iter().filter_map(|name| name.strip_suffix(".svg"));
    for name in svg {
        let read = |suffix: &str| std::fs::read(results.join(format!("{name}.{suffix}"))).unwrap();
        assert!(read("pdf").starts_with(b"%PDF-"), "{name}");
        let mut reader = png_image::Decoder::new(std::io::Cursor::new(read("png")))
            .read_info()
            .unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut pixels).unwrap();
        assert!(pixels.iter().any(|v| *v < 80), "{name} is empty");
    }
    assert!(found.contains(&"centreline.pdf".to_owned()));
    let output = solve(&folder, "quick.toml");
    code(&output, 0);
    assert!(!names(&results).contains(&"centreline.pdf".to_owned()));
}

/// A thermal line contact, both bodies alike, rolling alone: everything is written, and both take the same heat.
#[test]
fn a_thermal_contact_writes_its_temperatures() {
    let folder = workspace("thermal.toml");
    let report = stdout_of(solve(&folder, "thermal.toml"), 0);
    for words in [
        "\nHeat\n",
        "carried off by body 1",
        "reduction by heat",
        "temperatures ",
        "no profile across the film at [9, 0]",
    ] {
        contains(&report, words);
    }
    let results = folder.path().join("results/thermal");
    let found = names(&results);
    for name in [
        "cross-film.csv",
        "cross-film.svg",
        "temperature.svg",
        "temperature.vtu",
    ] {
        assert!(found.contains(&name.to_owned()), "{name} in {found:?}");
    }
    let read = |name: &str| std::fs::read_to_string(results.join(name)).unwrap();
    let json: serde_json::Value = serde_json::from_str(&read("result.json")).unwrap();
    let thermal = &json["thermal"];
    let number = |value: &serde_json::Value| value.as_f64().unwrap();
    let balance = &thermal["balance"];
    let [plane, ball] =
        ["heat_to_body_1", "heat_to_body_2"].map(|key| number(&balance[key]["value"]));
    // The film is symmetric about its middle: what is left is the tolerance of the coupling.
    assert!(
        plane > 0.0 && (plane / ball - 1.0).abs() < 1e-3,
        "{plane} {ball}"
    );
    // Nearly all heat goes into the bodies, and no more than is made.
    assert!(
        number(&balance["heat_balance_error"]).abs() < 0.01,
        "{balance}"
    );
    assert!(number(&thermal["film_temperature_maximum"]["value"]) > 313.15 + 0.1);
    assert!(thermal["reduction"]["thermal_reduction_traction"].is_null());

    // Two profiles of 41 heights: of both walls the velocity is known.
    let profiles = read("cross-film.csv");
    let lines: Vec<Vec<f64>> = (profiles.lines().skip(1))
        .map(|line| line.split(',').map(|v| v.parse().unwrap()).collect())
        .collect();
    assert_eq!(lines.len(), 2 * 41);
    for line in [&lines[0], &lines[40], &lines[41], &lines[81]] {
        assert!((line[8] - 1.0).abs() < 1e-6, "{line:?}");
    }
    let centreline = read("centreline.csv");
    assert!(centreline.lines().next().unwrap().ends_with(
        "temperature_mid_K,temperature_mean_K,temperature_body_1_K,temperature_body_2_K"
    ));
    assert!(read("surface.vtu").contains("Name=\"temperature_body_2_K\""));
    let field = read("temperature.vtu");
    assert!(field.contains("Name=\"region\"") && field.contains("film_magnification"));
}
