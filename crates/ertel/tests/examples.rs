//! The examples, each run as its first lines say; their output is checked.

use std::path::PathBuf;
use std::process::Command;

/// Runs an example that `cargo test` has built, and returns what it prints.
fn run(name: &str) -> String {
    let mut folder: PathBuf = std::env::current_exe().unwrap();
    folder.pop();
    folder.pop();
    let program = folder.join("examples").join(name);
    assert!(
        program.exists(),
        "cargo build --release -p ertel --examples makes {name}"
    );
    let done = Command::new(program).output().unwrap();
    assert!(
        done.status.success(),
        "{name}: {}",
        String::from_utf8_lossy(&done.stderr)
    );
    String::from_utf8(done.stdout).unwrap()
}

/// The number before a unit in the line that begins so.
fn number(text: &str, beginning: &str) -> f64 {
    let line = text.lines().find(|line| line.starts_with(beginning));
    let rest = &line.unwrap_or_else(|| panic!("no `{beginning}` in:\n{text}"))[beginning.len()..];
    let number = rest.split_whitespace().next().unwrap();
    number.parse().unwrap()
}

#[test]
fn ball_on_disc() {
    let text = run("ball_on_disc");
    // p_h = (6 F E'²/(π³ R²))^(1/3), E' = 115.4 GPa on R = 16 mm at 20 N: 586 MPa
    assert!(
        (number(&text, "dry contact") / 586.0 - 1.0).abs() < 0.01,
        "{text}"
    );
    assert!(number(&text, "central film") > number(&text, "minimum film"));
}

#[test]
fn line_contact_and_formulas() {
    let text = run("line_contact");
    let film = number(&text, "computed");
    assert!(text.lines().count() >= 2 && film > 100.0, "{text}");
    let text = run("formulas");
    assert!(
        (number(&text, "Hertz pressure") - 1.002).abs() < 1e-3,
        "{text}"
    );
}

#[test]
fn speed_curve() {
    let text = run("speed_curve");
    let films: Vec<f64> = ["0.5 m/s", "1 m/s", "2 m/s", "4 m/s"]
        .map(|speed| number(&text, speed))
        .to_vec();
    for pair in films.windows(2) {
        let exponent = (pair[1] / pair[0]).log2();
        assert!((0.55..0.75).contains(&exponent), "{text}");
    }
}

#[test]
fn study() {
    assert_eq!(run("study").trim(), "4 points, 5 lines in the table");
}

#[test]
fn machine() {
    let text = run("machine");
    assert!(text.lines().count() >= 3, "{text}");
    assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
}

#[test]
fn thermal_traction() {
    let text = run("thermal_traction");
    let coefficient = |words: &str| number(&text, &format!("{words}: traction coefficient"));
    // Heat thins the oil.
    assert!(coefficient("thermal") < coefficient("isothermal"), "{text}");
    assert!(number(&text, "the film is at most") > 0.1);
}

#[test]
fn own_oil_and_own_law() {
    assert!(number(&run("own_oil"), "central film") > 10.0);
    assert!(number(&run("own_viscosity_law"), "central film") > 10.0);
}

#[test]
fn uncertainty() {
    let text = run("uncertainty");
    // Exponents of speed and viscosity are close in line contacts, that of the load is small.
    assert!(
        (0.6..0.75).contains(&number(&text, "motion.entrainment_speed")),
        "{text}"
    );
    assert!(number(&text, "contact.load").abs() < 0.15);
}

#[test]
fn fields_on_a_grid() {
    let text = run("fields_on_a_grid");
    assert_eq!(text.lines().count(), 1 + 81);
    let film = |i: usize| -> f64 {
        text.lines()
            .nth(1 + i)
            .unwrap()
            .split(',')
            .nth(2)
            .unwrap()
            .parse()
            .unwrap()
    };
    // Mirrored at y = 0
    let [left, right] = [2, 6].map(|row| film(row * 9 + 4));
    assert!((left / right - 1.0).abs() < 1e-12, "{left} {right}");
    assert!((film(4 * 9 + 4) / 249e-9 - 1.0).abs() < 0.1, "{text}");
}
