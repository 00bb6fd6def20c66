//! Files that users name: what is no ordinary file is refused at once, and nothing of a file reaches a terminal but text.

use std::process::Command;
use std::time::{Duration, Instant};

use crate::common::{contains, ertel, stderr};

const ROLLER: &str = "[contact]\nkind = \"line\"\nradius = \"10 mm\"\nload = \"100 kN/m\"\n\
                      [bodies]\nbody_1 = \"steel\"\nbody_2 = \"steel\"\n\
                      [motion]\nentrainment_speed = \"2 m/s\"\nslide_to_roll_ratio = 0\n\
                      [lubricant]\ntemperature = \"40 degC\"\n\
                      density = { law = \"dowson-higginson\", rho_0 = \"870 kg/m^3\" }\n";

const VISCOSITY: &str = "viscosity = { law = \"constant\", mu_0 = \"10 mPa.s\" }\n";

/// A case with a viscosity from the table `file`.
fn with_table(file: &str) -> String {
    format!("{ROLLER}viscosity = {{ law = \"table\", file = \"{file}\" }}\n")
}

/// Devices, pipes without a writer, folders, files of the kernel, huge and deeply nested ones, wherever a file is named.
#[cfg(target_os = "linux")]
#[test]
fn what_is_no_ordinary_file_is_refused_at_once() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let write = |name: &str, text: &str| std::fs::write(folder.join(name), text).unwrap();
    let made = Command::new("mkfifo").arg(folder.join("pipe")).status();
    assert!(made.unwrap().success());
    write("huge.toml", &"[".repeat(100_000_000));
    write("deep.toml", &format!("a = {}", "[".repeat(1_000_000)));
    let case = with_table("pipe");
    let table = &case[..case.len() - "pipe\" }\n".len()];
    for (file, words) in [
        ("/dev/zero", "it is not a regular file"),
        ("pipe", "it is not a regular file"),
        ("/proc/self/environ", "it is not a regular file"),
        (".", "it is a folder, not a file"),
        ("huge.toml", "is too large: 100000000 bytes, and at most"),
        ("deep.toml", "nested too deeply"),
    ] {
        write("table.toml", &format!("{table}{file}\" }}\n"));
        write("base.toml", &format!("case = \"{file}\"\n"));
        write(
            "points.toml",
            &format!("case = \"roller.toml\"\npoints = \"{file}\"\n"),
        );
        write("roller.toml", &format!("{ROLLER}{VISCOSITY}"));
        let mut commands = vec![
            format!("solve --check {file}"),
            format!("estimate {file}"),
            format!("sweep --dry-run {file}"),
            "sweep --dry-run base.toml".to_owned(),
        ];
        // A table nests nothing, and may be larger.
        if !file.ends_with(".toml") {
            commands.push("solve --check table.toml".to_owned());
            commands.push("sweep --dry-run points.toml".to_owned());
            commands.push(format!("fit viscosity {file} --law barus"));
            commands.push(format!("fit film {file}"));
        }
        for command in commands {
            let start = Instant::now();
            let output = ertel(folder, &command);
            assert!(start.elapsed() < Duration::from_secs(5), "{command:?}");
            let error = stderr(&output);
            assert_eq!(output.status.code(), Some(2), "{command:?}: {error}");
            assert!(error.contains(words), "{command:?}: {error}");
            assert!(!error.contains("PATH="), "{command:?}");
            assert!(error.chars().count() < 2000, "{command:?}");
        }
    }
}

/// Keys, values and names with escape characters, in errors, checks and curves.
#[test]
fn control_characters_do_not_reach_the_terminal() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let write = |name: &str, text: &str| std::fs::write(folder.join(name), text).unwrap();
    write(
        "esc.toml",
        "title = \"x\"\n\u{1b}]0;pwned\u{7}\u{1b}[2J = 1\n",
    );
    write(
        "key.toml",
        &format!("\"a\\u001b[2J\" = 1\n{ROLLER}{VISCOSITY}"),
    );
    write(
        "value.toml",
        &ROLLER.replace("10 mm", "10 \\u001b]0;x\\u0007mm"),
    );
    write(
        "name.toml",
        &ROLLER.replace("\"steel\"", "\"st\\u009b2Jeel\""),
    );
    write(
        "title.toml",
        &format!("title = \"a\\u001b[2Jb\"\n{ROLLER}{VISCOSITY}"),
    );
    write(
        "p.csv",
        "pressure_MPa,temperature_K,viscosity_cP\n1,300,\u{1b}[2J\n",
    );
    for (command, code, words) in [
        ("solve --check esc.toml", 2, "\\u001b]0;pwned\\u0007"),
        ("solve --check key.toml", 2, "`a\\u001b[2J`"),
        ("solve --check value.toml", 2, "\\u001b]0;x\\u0007mm"),
        ("solve --check name.toml", 2, "st\\u009b2Jeel"),
        ("solve --check 'no\u{1b}[2J.toml'", 2, "no\\u001b[2J.toml"),
        ("fit viscosity p.csv --law barus", 2, "`\\u001b[2J`"),
        ("fluids show 'a\u{1b}[2J'", 2, "a\\u001b[2J"),
        ("estimate title.toml", 0, ""),
        ("estimate --json title.toml", 0, ""),
    ] {
        let output = ertel(folder, command);
        let error = stderr(&output);
        assert_eq!(output.status.code(), Some(code), "{command:?}: {error}");
        assert!(error.contains(words), "{command:?}: {error}");
        let shown = [&output.stdout[..], &output.stderr[..]].concat();
        let shown = String::from_utf8(shown).unwrap();
        let control = |c: char| c.is_control() && c != '\n';
        assert!(!shown.contains(control), "{command:?}: {shown:?}");
    }
}

/// A state far from any lubricant, numbers that are none, columns given twice.
#[test]
fn data_at_fault_are_no_fit() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let head = "pressure_MPa,temperature_K,density_kg_per_m3\n0,300,870\n50,300,890\n100,300,905\n";
    let film = "film_central_m,entrainment_speed_m_per_s\n1e-7,1\n2e-7,2\n3e-7,4\n";
    for (kind, law, text, place) in [
        (
            "density",
            "dowson-higginson",
            format!("{head}0,350,840\n100,1e15,880\n"),
            "6:2: temperature",
        ),
        (
            "density",
            "dowson-higginson",
            format!("{head}inf,350,840\n"),
            "5:1: pressure",
        ),
        (
            "density",
            "tait",
            format!("{head}0,nan,840\n"),
            "5:2: temperature",
        ),
        (
            "viscosity",
            "barus",
            head.replace("density_kg_per_m3", "viscosity_cP") + "1,300,1e308\n",
            "5:3: viscosity",
        ),
        (
            "viscosity",
            "barus",
            "pressure_MPa,temperature_K,viscosity_cP,viscosity_Pa_s\n".into(),
            "1:4: `viscosity_Pa_s` is a second",
        ),
        ("film", "", format!("{film}inf,5\n"), "5:1: film central"),
        (
            "film",
            "",
            format!("{film}1e-7,1e300\n"),
            "5:2: entrainment speed",
        ),
        (
            "film",
            "",
            format!("{film}1e-7,NaN\n"),
            "5:2: entrainment speed",
        ),
    ] {
        std::fs::write(folder.join("d.csv"), &text).unwrap();
        let option = if law.is_empty() {
            "--form speed".to_owned()
        } else {
            format!("--law {law}")
        };
        let command = format!("fit {kind} d.csv {option}");
        let output = ertel(folder, &command);
        let error = stderr(&output);
        assert_eq!(output.status.code(), Some(2), "{command:?}: {error}");
        let start = format!("error: d.csv:{place}");
        assert!(error.starts_with(&start), "{command:?}: {error}");
        assert!(output.stdout.is_empty());
    }
}

/// One table in the spellings of spreadsheets, as a law, as data of a fit, and as points of a study.
#[test]
fn all_tables_take_the_same_spellings() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let write = |name: &str, text: &str| std::fs::write(folder.join(name), text).unwrap();
    write("case.toml", &with_table("t.csv"));
    write("roller.toml", &format!("{ROLLER}{VISCOSITY}"));
    write("study.toml", "case = \"roller.toml\"\npoints = \"p.csv\"\n");
    let table = "temperature_degC,pressure_MPa,viscosity_mPa_s\n40,0,40.5\n40,100,80\n40,200,160\n40,300,330\n";
    let points = "lubricant.temperature_degC,motion.entrainment_speed_m_per_s\n40,1.5\n50,2\n";
    let semicolons = |text: &str| {
        let text = text.replace(',', ";").replace('.', ",");
        format!("\u{feff}{}", text.replace('\n', "\r\n"))
            .replace("lubricant,", "lubricant.")
            .replace("motion,", "motion.")
    };
    let quoted = |text: &str| {
        format!(
            "\"{}\"",
            text.trim().replace(',', "\",\"").replace('\n', "\"\n\"")
        )
    };
    let brackets = |text: &str| {
        let units = [
            ("_degC", " [degC]"),
            ("_MPa", " [MPa]"),
            ("_mPa_s", " [mPa.s]"),
            ("_m_per_s", " [m/s]"),
        ];
        units
            .into_iter()
            .fold(text.to_owned(), |text, (a, b)| text.replace(a, b))
    };
    let spellings: [&dyn Fn(&str) -> String; 4] = [&str::to_owned, &semicolons, &quoted, &|text| {
        brackets(text).replace(',', "\t")
    }];
    let mut results = Vec::new();
    for spelling in spellings {
        write("t.csv", &spelling(table));
        write("p.csv", &spelling(points));
        let commands = [
            "estimate --json case.toml",
            "fit viscosity t.csv --law barus",
            "sweep --dry-run study.toml",
        ];
        results.push(commands.map(|command| {
            let output = ertel(folder, command);
            let error = stderr(&output);
            assert_eq!(output.status.code(), Some(0), "{command:?}: {error}");
            String::from_utf8(output.stdout).unwrap()
        }));
    }
    for other in &results[1..] {
        assert_eq!(other, &results[0]);
    }
    // A second column of one name, wherever it is.
    let twice =
        "temperature [degC], pressure [MPa], viscosity [mPa.s], viscosity [Pa.s]\n40,0,40,7\n";
    write("t.csv", twice);
    for command in ["solve --check case.toml", "fit viscosity t.csv --law barus"] {
        let output = ertel(folder, command);
        let error = stderr(&output);
        assert_eq!(output.status.code(), Some(2), "{command:?}");
        contains(
            error,
            "t.csv:1:4: `viscosity [Pa.s]` is a second column `viscosity`",
        );
    }
}
