//! Cases in time, end to end.

use std::path::Path;

use crate::common::{
    BRAKING, case_folder, code, contains, ertel, json, read, stderr_of, text, write,
};

/// Files, tables and the report say the same; the speed at a time is that of the ramp; a second run replaces the folder.
#[test]
fn a_ramp_is_solved_written_and_replaced() {
    let folder = case_folder(BRAKING);
    for _ in 0..2 {
        let output = ertel(&folder, "solve case.toml --output out");
        code(&output, 0);
        let shown = text(&output.stdout);
        contains(shown, "highest central film thickness");
        // A Newtonian oil without heat.
        contains(shown, "larger than measured for any lubricant");
    }
    let out = folder.path().join("out");
    let result = json(&out.join("transient.json"));
    assert_eq!(result["format"], "ertel-transient");
    assert_eq!(result["complete"], true);
    let instants = result["instants"].as_array().unwrap();
    let table = std::fs::read_to_string(out.join("transient.csv")).unwrap();
    assert_eq!(table.lines().count(), instants.len() + 1);
    let at = instants
        .iter()
        .find(|instant| instant["time"] == 5e-4)
        .expect("a kink is an instant");
    assert!((at["entrainment_speed"].as_f64().unwrap() - 0.5).abs() < 1e-12);
    assert!((at["body_2_speed"].as_f64().unwrap() - 0.525).abs() < 1e-12);
    let film = |i: usize| {
        instants[i]["figures"]["film_central"]["value"]
            .as_f64()
            .unwrap()
    };
    assert!(film(instants.len() - 1) < 0.7 * film(0));
    let profiles = std::fs::read_to_string(out.join("profiles.csv")).unwrap();
    let mut times: Vec<&str> = profiles
        .lines()
        .skip(1)
        .filter_map(|line| line.split(',').next())
        .collect();
    times.dedup();
    assert_eq!(times, ["0e0", "5e-4"]);
    for file in [
        "film-time.svg",
        "film-map.svg",
        "report.html",
        "report.txt",
        "case.toml",
    ] {
        assert!(out.join(file).exists(), "{file}");
    }
}

/// A relief that no allowed grid resolves ends with the reason and exit code 3; cross-checks refuse a case in time.
#[test]
fn unsolved_instants_are_reported() {
    let relief = "\n[[surface]]\nkind = \"groove\"\nbody = \"body_1\"\nhalf_width = \"1 um\"\ndepth = \"20 nm\"\nx = \"-0.3 mm\"\n\n[mesh]\nmax_unknowns = 2000\n";
    let folder = case_folder(&format!("{BRAKING}{relief}"));
    let output = ertel(&folder, "solve case.toml --output out");
    let message = text(&output.stderr);
    code(&output, 3);
    contains(message, "the shortest length of a relief needs cells");
    assert!(!folder.path().join("out").exists());
    let output = ertel(&folder, "solve case.toml --cross-check");
    code(&output, 2);
}

/// A roller sinks under a constant load from a gap, without rolling: the film thins as the body comes near, and bears the load. The force and rebound of a falling ball are reported.
#[test]
fn bodies_that_are_apart_come_near() {
    let sinks = BRAKING
        .replace(
            "entrainment_speed = { course = \"ramp\", start = \"0.1 ms\", end = \"0.5 ms\", to = \"0.5 m/s\" }",
            "start = \"apart\"\ngap = \"3 um\"\nat_rest = true",
        )
        .replace("duration = \"1 ms\"", "duration = \"0.05 ms\"")
        .replace("output_times = [\"0 ms\", \"0.5 ms\"]\n", "");
    let folder = case_folder(&sinks);
    let output = ertel(&folder, "solve case.toml --output out");
    code(&output, 0);
    let result = json(&folder.path().join("out/transient.json"));
    let instants = result["instants"].as_array().unwrap();
    let of = |i: usize, key: &str| instants[i][key].as_f64().unwrap();
    let last = instants.len() - 1;
    assert_eq!([of(0, "film_force"), of(0, "approach")], [0.0, 0.0]);
    assert!((of(last, "film_force") / 1e5 - 1.0).abs() < 1e-3);
    assert!(of(last, "approach") > 2e-6);
    let film = &instants[0]["figures"]["film_central"]["value"];
    assert!((film.as_f64().unwrap() / 3e-6 - 1.0).abs() < 1e-9, "{film}");
    assert!(result["coefficient_of_restitution"].is_null());
    let table = read(&folder, "out/transient.csv");
    assert!(table.contains("load_N_per_m,radius_m,temperature_K,oil_layer_m,approach_m,approach_velocity_m_per_s,film_force_N_per_m"));
    let case = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/impact.toml");
    let output = ertel(
        &folder,
        &format!("solve {} --output impact", case.display()),
    );
    let shown = text(&output.stdout);
    contains(shown, "largest film force");
    let result = json(&folder.path().join("impact/transient.json"));
    let rebound = result["coefficient_of_restitution"].as_f64().unwrap();
    // 0.866 without the weight of the ball.
    assert!((rebound - 0.866).abs() < 0.01, "{rebound}");
    let bar = result["coefficient_of_restitution_error"].as_f64().unwrap();
    assert!(bar > 0.0 && bar < 0.2, "{bar}");
}

/// A run that is killed continues from its checkpoint to the same table; a checkpoint of another case, a forgotten one and none are refused.
#[test]
fn a_killed_run_goes_on() {
    let folder = case_folder(BRAKING);
    let solve = |more: &str| ertel(&folder, &format!("solve case.toml --quiet {more}"));
    code(&solve("-o whole"), 0);
    let mut run = std::process::Command::new(env!("CARGO_BIN_EXE_ertel"))
        .current_dir(folder.path())
        .args(["solve", "case.toml", "-o", "out", "--checkpoint", "0 s"])
        .stderr(std::process::Stdio::null())
        .stdout(std::process::Stdio::null())
        .spawn()
        .unwrap();
    let file = folder.path().join("out.checkpoint");
    while !file.exists() && run.try_wait().unwrap().is_none() {
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    run.kill().unwrap();
    run.wait().unwrap();
    assert!(file.exists());
    for (more, said) in [
        ("-o out --checkpoint '1 min'", "continue it with --resume"),
        (
            "-o out --resume --set 'contact.load=90 kN/m'",
            "belongs to a case with other values",
        ),
        ("-o none --resume", "none.checkpoint"),
        ("-o out --checkpoint '1 kg'", "a time is needed"),
    ] {
        let message = stderr_of(solve(more), 2);
        contains(&message, said);
    }
    // Cut off, and with a bit changed in the middle: refused, and the file stays as it is.
    let whole = std::fs::read(&file).unwrap();
    let mut changed = whole.clone();
    changed[whole.len() / 2] ^= 16;
    for damaged in [&whole[..whole.len() / 2], &changed] {
        std::fs::write(&file, damaged).unwrap();
        let error = stderr_of(solve("-o out --resume"), 2);
        contains(&error, "damaged");
        assert_eq!(std::fs::read(&file).unwrap(), damaged);
    }
    // Incomplete files of a killed run are removed.
    let left = folder.path().join(".ertel-new-a1B2c3");
    std::fs::write(&left, "half").unwrap();
    std::fs::write(&file, whole).unwrap();
    let output = solve("-o out --resume");
    code(&output, 0);
    assert!(!file.exists() && !left.exists());
    let table = |name: &str| std::fs::read(folder.path().join(name).join("transient.csv")).unwrap();
    assert_eq!(table("out"), table("whole"));
}

/// Where a checkpoint cannot be written, a warning says so once and the run continues to its end.
#[cfg(unix)]
#[test]
fn a_checkpoint_that_cannot_be_written_is_reported_at_once() {
    let folder = case_folder(
        &BRAKING
            .replace("duration = \"1 ms\"", "duration = \"0.02 ms\"")
            .replace("\"0.5 ms\"]", "\"0.02 ms\"]"),
    );
    // There is nothing where the link leads, not even a folder.
    let link = folder.path().join("out.checkpoint");
    std::os::unix::fs::symlink("missing/place", link).unwrap();
    let arguments = "solve case.toml -o out --checkpoint '0 s'";
    let shown = stderr_of(ertel(&folder, arguments), 0);
    assert_eq!(
        shown
            .matches("warning: the checkpoint cannot be written")
            .count(),
        1,
        "{shown}"
    );
    let (before, _) = shown.split_once("warning: the checkpoint").unwrap();
    assert!(
        before.matches("step ").count() < shown.matches("step ").count(),
        "{shown}"
    );
}

/// Where a checkpoint is to go there is a pipe, a device, a folder: exit 2 at once, with and without `--resume`.
#[cfg(target_os = "linux")]
#[test]
fn a_checkpoint_that_is_no_file_is_refused_at_once() {
    let folder = case_folder(BRAKING);
    let at = |name: &str| folder.path().join(name);
    let made = std::process::Command::new("mkfifo")
        .arg(at("pipe.checkpoint"))
        .status();
    assert!(made.unwrap().success());
    std::os::unix::fs::symlink("/dev/zero", at("device.checkpoint")).unwrap();
    std::fs::create_dir(at("folder.checkpoint")).unwrap();
    for name in ["pipe", "device", "folder"] {
        for how in ["--checkpoint '1 s'", "--resume"] {
            let clock = std::time::Instant::now();
            let output = ertel(&folder, &format!("solve case.toml -q -o {name} {how}"));
            let message = text(&output.stderr);
            assert_eq!(output.status.code(), Some(2), "{name}: {message}");
            assert!(message.contains("cannot be read"), "{name}: {message}");
            assert!(
                clock.elapsed() < std::time::Duration::from_secs(10),
                "{name}"
            );
        }
    }
}

/// A run that is stopped leaves the complete result that is there, and says where its own goes.
#[cfg(unix)]
#[test]
fn a_complete_result_is_kept_when_a_second_run_is_stopped() {
    let folder = case_folder(BRAKING);
    let at = |name: &str| folder.path().join(name);
    let first = ertel(&folder, "solve case.toml -q -o out");
    code(&first, 0);
    let table = std::fs::read(at("out/transient.csv")).unwrap();
    let mut run = std::process::Command::new(env!("CARGO_BIN_EXE_ertel"))
        .current_dir(folder.path())
        .args([
            "solve",
            "case.toml",
            "-q",
            "-o",
            "out",
            "--checkpoint",
            "0 s",
        ])
        .stderr(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    // From its first checkpoint on there are instants.
    while !at("out.checkpoint").exists() && run.try_wait().unwrap().is_none() {
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    let signal = ["-INT", &run.id().to_string()];
    let sent = std::process::Command::new("kill").args(signal).status();
    assert!(sent.unwrap().success());
    let message = stderr_of(run.wait_with_output().unwrap(), 130);
    contains(&message, "out keeps its complete result");
    assert_eq!(std::fs::read(at("out/transient.csv")).unwrap(), table);
    assert_eq!(json(&at("out-partial/transient.json"))["complete"], false);
    let report = std::fs::read_to_string(at("out-partial/report.txt")).unwrap();
    contains(&report, "interrupted");
    // It continues to a complete result, which replaces the former one.
    let rest = ertel(&folder, "solve case.toml -q -o out --resume");
    code(&rest, 0);
    assert_eq!(std::fs::read(at("out/transient.csv")).unwrap(), table);
}

/// Courses that begin elsewhere than the case, that change after the end, and that have more periods than there are steps.
#[test]
fn courses_that_contradict_the_case_are_reported() {
    let ramp = BRAKING
        .lines()
        .find(|line| line.starts_with("entrainment_speed = {"));
    let check = |course: &str| {
        let line = format!("entrainment_speed = {{ course = {course} }}");
        let folder = case_folder(&BRAKING.replace(ramp.unwrap(), &line));
        let output = ertel(&folder, "solve case.toml --check");
        let words = [text(&output.stdout), text(&output.stderr)].concat();
        (output.status.code(), words)
    };
    for (course, code, words) in [
        (
            r#""table", times = ["0 s", "1 ms"], values = ["5 m/s", "2 m/s"]"#,
            0,
            "begins with 5 m/s",
        ),
        (
            r#""table", times = ["0 s", "1 ms"], values = ["1 m/s", "2 m/s"]"#,
            0,
            "Braking",
        ),
        (
            r#""step", at = "5 s", to = "2 m/s""#,
            0,
            "the change has no effect",
        ),
        (
            r#""sine", amplitude = "0.5 m/s", period = "1 ps""#,
            2,
            "at least 8.0e9 steps",
        ),
        (
            r#""sine", amplitude = "0.5 m/s", period = "0.1 us""#,
            0,
            "at least 80002 steps",
        ),
    ] {
        let (found, said) = check(course);
        assert_eq!(found, Some(code), "{course}: {said}");
        assert!(said.contains(words), "{course}: {said}");
        assert_eq!(
            said.contains("begins with"),
            words.contains("begins with"),
            "{said}"
        );
    }
}

/// A pair of teeth along its path: load, radius and speeds at the pitch point are those of the machine, and the film under a load that has just doubled is thinner than the steady one there
/// (numbers of the guide).
#[test]
fn teeth_along_their_path() {
    let folder = tempfile::tempdir().unwrap();
    let case = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/spur-gear-in-time.toml");
    let output = ertel(&folder, &format!("solve {} --quiet -o out", case.display()));
    code(&output, 0);
    let result = json(&folder.path().join("out/transient.json"));
    let instants = result["instants"].as_array().unwrap();
    let of = |instant: &serde_json::Value, key: &str| instant[key].as_f64().unwrap();
    // 10.117 mm along the line of action at 2π 25 Hz times the base radius 40 cos 20° mm.
    let pitch = 10.117_152_95e-3 / (50.0 * std::f64::consts::PI * 0.04 * 20_f64.to_radians().cos());
    let near = instants
        .windows(2)
        .find(|pair| of(&pair[1], "time") >= pitch)
        .unwrap();
    let share = (pitch - of(&near[0], "time")) / (of(&near[1], "time") - of(&near[0], "time"));
    let at = |key: &str| of(&near[0], key) + share * (of(&near[1], key) - of(&near[0], key));
    // R_1 = 40 sin 20° mm and twice that of the wheel; 100 N m over the base radius and 20 mm.
    // Between the steps straight lines.
    assert!((at("radius") / 9.120_53e-3 - 1.0).abs() < 1e-3);
    assert!((at("load") / 133_022.0 - 1.0).abs() < 1e-4);
    for body in ["body_1_speed", "body_2_speed"] {
        assert!((at(body) / 2.148_98 - 1.0).abs() < 1e-4);
    }
    let film = |instant: &serde_json::Value, figure: &str| {
        instant["figures"][figure]["value"].as_f64().unwrap()
    };
    let about = |instant: &&serde_json::Value| (1.2e-3..1.35e-3).contains(&of(instant, "time"));
    let doubled = || instants.iter().filter(about);
    let thinnest = doubled()
        .map(|i| film(i, "film_minimum"))
        .fold(1.0, f64::min);
    let thickest = doubled()
        .map(|i| film(i, "film_central"))
        .fold(0.0, f64::max);
    assert!((thinnest / 211e-9 - 1.0).abs() < 0.02, "{thinnest}");
    assert!((thickest / 352e-9 - 1.0).abs() < 0.02, "{thickest}");
}

/// Waves of 1, 1/2 and 1/4 half-widths keep 0.183, 0.394 and 0.660 of their amplitude (Venner, Couhier, Lubrecht and Greenwood 1997, table 1: M = 100, L = 11), to 3 %, as far as
/// the table's own numbers differ with the amplitude; in the tables, in the report and in netCDF.
#[test]
fn waves_keep_the_amplitudes_of_venner() {
    let case = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/waves.toml");
    let shipped = std::fs::read_to_string(case).unwrap();
    for (wavelength, duration, expected) in [
        ("0.3457 mm", "2.6 ms", 0.183),
        ("0.173 mm", "2.2 ms", 0.394),
        ("0.0864 mm", "2.1 ms", 0.660),
    ] {
        let text_of = shipped
            .replace("0.173 mm", wavelength)
            .replace("2.2 ms", duration)
            + "\n[output]\nnetcdf = true\n";
        let folder = case_folder(&text_of);
        let output = ertel(&folder, "solve case.toml --output out");
        code(&output, 0);
        let out = folder.path().join("out");
        let result = json(&out.join("transient.json"));
        let instants = result["instants"].as_array().unwrap();
        assert!(instants[0]["amplitude_ratio"].is_null());
        let ratio = instants[instants.len() - 1]["amplitude_ratio"].as_f64();
        let ratio = ratio.expect("a whole wave has passed");
        assert!(
            (ratio / expected - 1.0).abs() < 0.03,
            "{wavelength}: {ratio}"
        );
        let table = std::fs::read_to_string(out.join("transient.csv")).unwrap();
        let column = |row: &str, title: &str| {
            let at = table.lines().next()?.split(',').position(|t| t == title)?;
            row.split(',').nth(at).map(str::to_owned)
        };
        let last = column(table.lines().last().unwrap(), "amplitude_ratio").unwrap();
        // JSON is read to the last digit but one.
        let exact: f64 = last.parse().unwrap();
        assert!((exact / ratio - 1.0).abs() < 1e-14);
        let shown = text(&output.stdout);
        let (_, rest) = shown.split_once("amplitude ratio of the waves").unwrap();
        let shown = rest.split_whitespace().next().unwrap();
        assert!(
            (shown.parse::<f64>().unwrap() - ratio).abs() < 1e-3,
            "{shown}"
        );
        let bytes = std::fs::read(out.join("result.nc")).unwrap();
        assert!(bytes.windows(8).any(|w| w == exact.to_be_bytes()));
    }
}

/// Fields, netCDF and animation on request: a file for each output time, named in a collection with its time; without the keys there is none, and the folder of one run is replaced by another one.
#[test]
fn fields_of_instants_are_written_on_request() {
    let asked = format!("{BRAKING}\n[output]\nvtu = true\nnetcdf = true\nanimation = true\n");
    let folder = case_folder(&asked);
    let solve = || ertel(&folder, "solve case.toml --output out");
    let output = solve();
    code(&output, 0);
    let out = folder.path().join("out");
    let read = |name: &str| std::fs::read(out.join(name)).unwrap();
    let collection = text(&read("fields.pvd")).to_owned();
    for (time, file) in [("0e0", "fields-001.vtu"), ("5e-4", "fields-002.vtu")] {
        let line = format!("<DataSet timestep=\"{time}\" part=\"0\" file=\"{file}\"/>");
        contains(&collection, &line);
        let fields = text(&read(file)).to_owned();
        for array in [
            "Float32\" Name=\"pressure_Pa",
            "Name=\"film_thickness_m",
            "Name=\"TimeValue",
        ] {
            contains(&fields, array);
        }
    }
    assert!(!out.join("fields-003.vtu").exists());
    assert!(read("result.nc").starts_with(b"CDF\x02"));
    let animation = read("animation.png");
    let chunks = |name: &[u8]| animation.windows(4).filter(|w| *w == name).count();
    assert_eq!([chunks(b"acTL"), chunks(b"fcTL")], [1, 2]);
    let page = text(&read("report.html")).to_owned();
    assert!(page.len() < 2_000_000 && page.contains("\"film_axis\":"));
    write(&folder, "case.toml", BRAKING);
    let output = solve();
    code(&output, 0);
    for name in ["fields.pvd", "fields-001.vtu", "result.nc", "animation.png"] {
        assert!(!out.join(name).exists(), "{name}");
    }
}
