//! Shared parts of the tests of the command.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use tempfile::TempDir;

/// The command with arguments, in a folder.
pub fn command(folder: impl AsRef<Path>, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ertel"));
    command.args(arguments).current_dir(folder);
    command
}

/// `ertel solve` in a folder.
pub fn solve_command(folder: &TempDir, arguments: &[&str]) -> Command {
    command(folder, &[&["solve"], arguments].concat())
}

/// Runs the command in a folder.
pub fn ertel(folder: impl AsRef<Path>, arguments: &[&str]) -> Output {
    command(folder, arguments).output().unwrap()
}

/// Runs `ertel solve` in a folder.
pub fn solve(folder: &TempDir, arguments: &[&str]) -> Output {
    solve_command(folder, arguments).output().unwrap()
}

/// Runs the command in the folder of the crate.
pub fn ertel_here(arguments: &[&str]) -> Output {
    ertel(env!("CARGO_MANIFEST_DIR"), arguments)
}

/// Output of a command, as text.
pub fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).unwrap()
}

/// Standard output as text.
pub fn stdout(output: &Output) -> &str {
    text(&output.stdout)
}

/// Standard error as text.
pub fn stderr(output: &Output) -> &str {
    text(&output.stderr)
}

/// A file of a folder.
pub fn read(folder: &TempDir, name: &str) -> String {
    std::fs::read_to_string(folder.path().join(name)).unwrap()
}

/// Writes a file of a folder, and the folders in between.
pub fn write(folder: &TempDir, name: &str, text: &str) {
    let path = folder.path().join(name);
    std::fs::create_dir_all(path.parent().unwrap()).unwrap();
    std::fs::write(path, text).unwrap();
}

/// Copies a file of the crate into a folder.
pub fn copy(from: &str, folder: &TempDir, to: &str) {
    let from = Path::new(env!("CARGO_MANIFEST_DIR")).join(from);
    write(folder, to, &std::fs::read_to_string(from).unwrap());
}

/// The lines of a table, each a map from column to field. Only the last field may hold a comma.
pub fn rows_of(path: &Path) -> Vec<HashMap<String, String>> {
    let csv = std::fs::read_to_string(path).unwrap();
    let mut lines = csv.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let row = |line: &str| {
        let pairs = names.iter().zip(line.splitn(names.len(), ','));
        pairs
            .map(|(name, field)| ((*name).to_owned(), field.to_owned()))
            .collect()
    };
    lines.map(row).collect()
}

/// The folder of the workspace.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// A line contact whose speed falls to a half.
pub const BRAKING: &str = r#"
title = "Braking"

[contact]
kind = "line"
radius = "10 mm"
load = "100 kN/m"

[bodies]
body_1 = "steel"
body_2 = "steel"

[motion]
entrainment_speed = "1 m/s"
slide_to_roll_ratio = 0.1

[lubricant]
temperature = "40 degC"
density = { law = "dowson-higginson", rho_0 = "870 kg/m^3" }
viscosity = { law = "roelands", mu_0 = "40 mPa.s", alpha = "22 1/GPa" }

[transient]
duration = "1 ms"
output_times = ["0 ms", "0.5 ms"]
entrainment_speed = { course = "ramp", start = "0.1 ms", end = "0.5 ms", to = "0.5 m/s" }
"#;

/// A folder with a case.
pub fn case_folder(case: &str) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    write(&folder, "case.toml", case);
    folder
}

/// A file of JSON.
pub fn json(path: &Path) -> serde_json::Value {
    serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap()
}
