//! Shared parts of the tests of the command.

#[path = "../../ertel-quantity/tests/common/contains.rs"]
mod contains;

use std::collections::HashMap;
use std::io::{BufRead, BufReader, Lines};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStderr, Command, Output, Stdio};

use tempfile::TempDir;

pub use contains::contains;

/// The command in a folder, with arguments as a shell reads them: quotes hold words with blanks together.
pub fn command(folder: impl AsRef<Path>, arguments: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ertel"));
    let words = shlex::split(arguments).expect("every quote has its end");
    command.args(words).current_dir(folder);
    command
}

/// Runs the command in a folder.
pub fn ertel(folder: impl AsRef<Path>, arguments: &str) -> Output {
    command(folder, arguments).output().unwrap()
}

/// Runs `ertel solve` in a folder.
pub fn solve(folder: &TempDir, arguments: &str) -> Output {
    ertel(folder, &format!("solve {arguments}"))
}

/// Runs the command in the folder of the crate.
pub fn ertel_here(arguments: &str) -> Output {
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

/// Checks the exit code of a command.
#[track_caller]
pub fn code(output: &Output, expected: i32) {
    let (out, error) = (stdout(output), stderr(output));
    assert_eq!(output.status.code(), Some(expected), "{out}{error}");
}

/// Standard output of a command that must end with an exit code.
#[track_caller]
pub fn stdout_of(output: Output, expected: i32) -> String {
    code(&output, expected);
    stdout(&output).to_owned()
}

/// Standard error of a command that must end with an exit code.
#[track_caller]
pub fn stderr_of(output: Output, expected: i32) -> String {
    code(&output, expected);
    stderr(&output).to_owned()
}

/// A file of a folder.
pub fn read(folder: &TempDir, name: &str) -> String {
    std::fs::read_to_string(folder.path().join(name)).unwrap()
}

/// Writes a file of a folder, and the folders in between.
pub fn write(folder: &TempDir, name: &str, text: impl AsRef<[u8]>) {
    let path = folder.path().join(name);
    std::fs::create_dir_all(path.parent().unwrap()).unwrap();
    std::fs::write(path, text).unwrap();
}

/// Copies a file of the crate into a folder.
pub fn copy(from: &str, folder: &TempDir, to: &str) {
    let from = Path::new(env!("CARGO_MANIFEST_DIR")).join(from);
    write(folder, to, std::fs::read(from).unwrap());
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
pub const BRAKING: &str = concat!(
    "title = \"Braking\"\n[contact]\nkind = \"line\"\nradius = \"10 mm\"\nload = \"100 kN/m\"\n",
    "[motion]\nentrainment_speed = \"1 m/s\"\nslide_to_roll_ratio = 0.1\n",
    include_str!("../../ertel/tests/common/cases/steel.toml"),
    "\n[transient]\nduration = \"1 ms\"\noutput_times = [\"0 ms\", \"0.5 ms\"]\n",
    "entrainment_speed = { course = \"ramp\", start = \"0.1 ms\", end = \"0.5 ms\", to = \"0.5 m/s\" }\n"
);

/// A folder with a case.
pub fn case_folder(case: &str) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    write(&folder, "case.toml", case);
    folder
}

/// A folder with files, in which commands run.
pub struct Workspace(pub TempDir);

impl Workspace {
    pub fn new(files: &[(&str, &str)]) -> Workspace {
        let workspace = Workspace(tempfile::tempdir().unwrap());
        for (name, text) in files {
            write(&workspace.0, name, text);
        }
        workspace
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub fn ertel(&self, arguments: &str) -> Output {
        ertel(&self.0, arguments)
    }

    /// Runs a command that must succeed; its standard output.
    pub fn succeed(&self, arguments: &str) -> String {
        stdout_of(self.ertel(arguments), 0)
    }

    /// The message for bad input.
    pub fn refused(&self, arguments: &str) -> String {
        stderr_of(self.ertel(arguments), 2)
    }

    pub fn json(&self, name: &str) -> serde_json::Value {
        json(&self.path(name))
    }
}

/// A command that runs, and the lines of its standard error.
#[cfg(unix)]
pub struct Running {
    child: Child,
    pub lines: Lines<BufReader<ChildStderr>>,
}

#[cfg(unix)]
impl Running {
    pub fn start(mut command: Command) -> Running {
        command.stderr(Stdio::piped()).stdout(Stdio::null());
        let mut child = command.spawn().unwrap();
        let lines = BufReader::new(child.stderr.take().unwrap()).lines();
        Running { child, lines }
    }

    /// Ctrl-C, after which the command ends with code 130; the last lines of its standard error.
    pub fn interrupt(mut self) -> Vec<String> {
        let kill = Command::new("kill")
            .args(["-INT", &self.child.id().to_string()])
            .status();
        assert!(kill.unwrap().success());
        let rest: Vec<String> = self.lines.map(Result::unwrap).collect();
        assert_eq!(self.child.wait().unwrap().code(), Some(130), "{rest:?}");
        rest
    }
}

/// A file of JSON.
pub fn json(path: &Path) -> serde_json::Value {
    serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap()
}
