//! Studies, curves and samples of cases in time, end to end.

use tempfile::TempDir;

use crate::common::{BRAKING, case_folder, code, contains, ertel, read, stderr_of, stdout, write};

const STUDY: &str = r#"
case = "case.toml"
[[axis]]
key = "contact.load"
values = ["60 kN/m", "100 kN/m", "150 kN/m"]
[[axis]]
key = "transient.entrainment_speed.end"
values = ["0.3 ms", "0.5 ms"]
"#;

fn workspace(case: &str, study: &str) -> TempDir {
    let folder = case_folder(case);
    write(&folder, "study.toml", study);
    folder
}

/// Rows of a table by their titles.
struct Rows(Vec<Vec<String>>);

impl Rows {
    fn of(folder: &TempDir, name: &str) -> Rows {
        let text = read(folder, name);
        let cells = |line: &str| line.split(',').map(str::to_owned).collect();
        Rows(text.lines().map(cells).collect())
    }

    fn texts(&self, title: &str) -> Vec<&str> {
        let place = self.0[0].iter().position(|own| own == title);
        let place = place.unwrap_or_else(|| panic!("{title} in {:?}", self.0[0]));
        self.0[1..].iter().map(|row| row[place].as_str()).collect()
    }

    fn numbers(&self, title: &str) -> Vec<f64> {
        let numbers = self.texts(title).into_iter().map(|text| text.parse());
        numbers.map(|number| number.unwrap_or(f64::NAN)).collect()
    }
}

/// The figures of a point are those that its own table over time has, by a minimum, a maximum and trapezoids made here; an interrupted study continues to the same table.
#[test]
fn a_study_over_time_shows_extremes_and_resumes() {
    let folder = workspace(BRAKING, STUDY);
    let run = |more: &str| {
        let output = ertel(&folder, &format!("sweep study.toml -o out {more}"));
        code(&output, 0);
        stdout(&output).to_owned()
    };
    run("--folders");
    let table = read(&folder, "out/results.csv");
    let rows = Rows::of(&folder, "out/results.csv");
    assert_eq!(rows.texts("converged"), ["true"; 6]);
    for point in 1..=6 {
        let own = Rows::of(&folder, &format!("out/points/{point}/transient.csv"));
        let figure = |title: &str| rows.numbers(title)[point - 1];
        let time = own.numbers("time_s");
        let films = own.numbers("film_minimum_m");
        let lowest = (0..films.len())
            .min_by(|a, b| films[*a].total_cmp(&films[*b]))
            .unwrap();
        assert_eq!(figure("film_minimum_lowest_m"), films[lowest]);
        assert_eq!(figure("film_minimum_lowest_time_s"), time[lowest]);
        let bar = figure("film_minimum_lowest_error_m");
        let bars = own.numbers("film_minimum_error_m");
        assert!(
            bar >= 0.999_999 * bars[lowest] && bar < 0.05 * films[lowest],
            "{bar:e}"
        );
        let pressures = own.numbers("pressure_maximum_Pa");
        assert_eq!(
            figure("pressure_maximum_highest_Pa"),
            pressures.iter().copied().fold(0.0, f64::max)
        );
        assert_eq!(
            figure("film_central_last_m"),
            *own.numbers("film_central_m").last().unwrap()
        );
        let friction: Vec<f64> = own
            .numbers("traction_coefficient")
            .iter()
            .map(|f| f.abs())
            .collect();
        let area = |i: usize| 0.5 * (friction[i] + friction[i + 1]) * (time[i + 1] - time[i]);
        let mean = (0..time.len() - 1).map(area).sum::<f64>() / time[time.len() - 1];
        assert!((figure("traction_coefficient_mean") / mean - 1.0).abs() < 1e-9);
        assert!(figure("traction_coefficient_highest") >= mean);
        let errors = own.numbers("mass_error");
        assert_eq!(
            figure("mass_error_highest"),
            errors.iter().fold(0.0, |m: f64, e| m.max(e.abs()))
        );
        assert_eq!(figure("steps"), (time.len() - 1) as f64);
    }
    // Half of the speed leaves less film, and so does more load.
    let last = rows.numbers("film_central_last_m");
    assert!(last[0] > last[2] && last[2] > last[4], "{last:?}");
    for file in [
        "film.svg",
        "traction.svg",
        "pressure.svg",
        "report.html",
        "points/1/report.html",
    ] {
        assert!(folder.path().join("out").join(file).exists(), "{file}");
    }
    assert!(read(&folder, "out/film.svg").contains("lowest minimum film thickness"));
    // Cut off after the third point, in the line of the fourth.
    let journal = read(&folder, "out/journal.jsonl");
    let kept: Vec<&str> = journal.lines().take(3).collect();
    write(
        &folder,
        "out/journal.jsonl",
        format!(
            "{}\n{}",
            kept.join("\n"),
            &journal.lines().nth(3).unwrap()[..40]
        ),
    );
    std::fs::remove_file(folder.path().join("out/results.csv")).unwrap();
    let shown = run("--jobs 1");
    contains(&shown, "3 of them earlier");
    assert_eq!(read(&folder, "out/results.csv"), table);
}

/// A point whose relief no allowed grid resolves is reported with its reason and exit code 3; the others are solved. Entries of arrays are counted from 1.
#[test]
fn points_that_fail_have_their_reason() {
    let relief = "\n[[surface]]\nkind = \"groove\"\nbody = \"body_1\"\nhalf_width = \"60 um\"\ndepth = \"20 nm\"\nx = \"-0.3 mm\"\n\n[mesh]\nmax_unknowns = 3000\n";
    let axis = "case = \"case.toml\"\n[[axis]]\nkey = \"surface.1.half_width\"\nvalues = [\"1 um\", \"60 um\"]\n";
    let folder = workspace(&format!("{BRAKING}{relief}"), axis);
    let output = ertel(&folder, "sweep study.toml -o out");
    code(&output, 3);
    contains(
        stdout(&output),
        "point 1 (surface.1.half_width = 1 um) failed: ",
    );
    let rows = Rows::of(&folder, "out/results.csv");
    assert_eq!(rows.texts("converged"), ["false", "true"]);
    let reason = rows.texts("reason");
    assert!(
        reason[0].contains("the shortest length of a relief needs cells") && reason[1].is_empty(),
        "{reason:?}"
    );
    assert!(rows.numbers("film_minimum_lowest_m")[0].is_nan());
    let of = |number: usize| axis.replace("surface.1.", &format!("surface.{number}."));
    write(&folder, "study.toml", of(2));
    let error = stderr_of(ertel(&folder, "sweep study.toml --dry-run"), 2);
    contains(&error, "surface has 1 entries, counted from 1");
}

/// A curve over a quantity at which courses begin; samples of an uncertain load.
#[test]
fn curves_and_samples_of_a_case_in_time() {
    let curve = "\n[curve]\nquantity = \"contact.load\"\nvalues = [\"60 kN/m\", \"80 kN/m\", \"100 kN/m\"]\nfolders = true\n";
    let folder = workspace(&format!("{BRAKING}{curve}"), STUDY);
    let output = ertel(&folder, "solve case.toml -o out");
    code(&output, 0);
    contains(stdout(&output), "lowest minimum film thickness");
    let rows = Rows::of(&folder, "out/curve.csv");
    let films = rows.numbers("film_minimum_lowest_m");
    assert!(films[0] > films[1] && films[1] > films[2], "{films:?}");
    for file in [
        "film-curve.svg",
        "traction-curve.svg",
        "pressure-curve.svg",
        "report.html",
        "points/3/transient.json",
    ] {
        assert!(folder.path().join("out").join(file).exists(), "{file}");
    }
    let json: serde_json::Value = serde_json::from_str(&read(&folder, "out/curve.json")).unwrap();
    let figure = &json["points"][2]["over_time"]["film_minimum_lowest"];
    // The table has 16 digits.
    let value = figure["value"].as_f64().unwrap();
    assert!((value / films[2] - 1.0).abs() < 1e-14, "{value}");
    let alone: serde_json::Value =
        serde_json::from_str(&read(&folder, "out/points/3/transient.json")).unwrap();
    assert_eq!(alone["over_time"]["film_minimum_lowest"], *figure);
    let newtonian = curve.replace("folders = true", "newtonian = true");
    let power = BRAKING.replace(
        "alpha = \"22 1/GPa\" }",
        "alpha = \"22 1/GPa\" }\nshear_thinning = { law = \"ree-eyring\", tau_0 = \"5 MPa\" }",
    );
    write(&folder, "case.toml", format!("{power}{newtonian}"));
    let error = stderr_of(ertel(&folder, "solve case.toml --check"), 2);
    contains(&error, "`newtonian`");

    write(
        &folder,
        "case.toml",
        BRAKING.replace("load = \"100 kN/m\"", "load = \"100 kN/m ± 10 %\""),
    );
    let output = ertel(&folder, "solve case.toml -o mean --monte-carlo 4 --seed 3");
    code(&output, 0);
    let json: serde_json::Value =
        serde_json::from_str(&read(&folder, "mean-monte-carlo/monte-carlo.json")).unwrap();
    assert_eq!(json["solved"], 4);
    // More load, less film.
    let film = &json["figures"]["film_minimum_lowest"];
    assert!(
        film["correlations"]["contact.load"].as_f64().unwrap() < -0.95,
        "{film}"
    );
    assert!(film["standard"].as_f64().unwrap() > 0.0);
}

/// An axis over a quantity that a table gives over all of the time would change nothing; measured rows are steady.
#[test]
fn what_changes_nothing_is_refused() {
    let table = BRAKING.replace(
        "{ course = \"ramp\", start = \"0.1 ms\", end = \"0.5 ms\", to = \"0.5 m/s\" }",
        "{ course = \"table\", times = [\"0 ms\", \"1 ms\"], values = [\"1 m/s\", \"0.5 m/s\"] }",
    );
    let axis = "case = \"case.toml\"\n[[axis]]\nkey = \"motion.entrainment_speed\"\nvalues = [\"1 m/s\", \"2 m/s\"]\n";
    let folder = workspace(&table, axis);
    let message = stderr_of(ertel(&folder, "sweep study.toml --dry-run"), 2);
    contains(&message, "`motion.entrainment_speed` changes nothing");
    contains(&message, "study.toml:3");
    write(
        &folder,
        "measured.csv",
        "contact.load (kN/m),film_central (nm)\n60,300\n",
    );
    let error = stderr_of(ertel(&folder, "compare case.toml measured.csv"), 2);
    contains(&error, "this case changes in time");
}

/// The shipped study at the speed of its middle points: waves of a half and of one half-width keep 0.394 and 0.183 of their amplitude (Venner, Couhier, Lubrecht and Greenwood 1997, table 1), to 3 %.
#[test]
fn the_shipped_study_of_waves() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    let case = std::fs::read_to_string(root.join("waves.toml")).unwrap();
    let study = std::fs::read_to_string(root.join("waves-and-speeds.toml")).unwrap();
    let folder = tempfile::tempdir().unwrap();
    write(&folder, "waves.toml", &case);
    let study = study
        .replace(
            "[\"0.32 m/s\", \"0.64 m/s\", \"1.28 m/s\"]",
            "[\"0.64 m/s\"]",
        )
        .replace("[\"4.8 ms\", \"2.4 ms\", \"1.2 ms\"]", "[\"2.4 ms\"]");
    write(&folder, "study.toml", &study);
    let output = ertel(&folder, "sweep study.toml -o out");
    code(&output, 0);
    let rows = Rows::of(&folder, "out/results.csv");
    let left = rows.numbers("amplitude_ratio_last");
    for (left, expected) in left.iter().zip([0.394, 0.183]) {
        assert!((left / expected - 1.0).abs() < 0.03, "{left:?}");
    }
    assert!(
        !folder.path().join("out/amplitude-ratio.svg").exists(),
        "two values make no picture"
    );
}
