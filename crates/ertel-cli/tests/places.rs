//! Every path that a command takes, in every state that a path can be in: the program ends soon, says what is wrong by its exit code, and
//! takes nothing away from the user.
#![cfg(target_os = "linux")]

use std::collections::BTreeMap;
use std::ffi::{OsStr, OsString};
use std::fs;
use std::os::unix::ffi::{OsStrExt, OsStringExt};
use std::os::unix::fs::{FileTypeExt, PermissionsExt, symlink};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use tempfile::TempDir;

use crate::common::contains;

/// Longest run; all of them take tenths of a second on an idle machine.
const LONGEST: Duration = Duration::from_secs(60);

fn shared(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(name);
    fs::read_to_string(path).unwrap()
}

/// A folder with an example of all that commands read.
fn workspace() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| {
        let path = folder.path().join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    };
    let case = shared("tests/good/quick.toml");
    write("case.toml", &case);
    write(
        "study.toml",
        "case = \"case.toml\"\n[[axis]]\nkey = \"contact.load\"\nvalues = [\"20 kN/m\", \"30 kN/m\"]\n",
    );
    write(
        "mine.csv",
        &shared("../../validation/appendix-c/fluid-a.csv"),
    );
    write(
        "films.csv",
        "speed_m_per_s,film_central_m\n1,1e-7\n2,1.6e-7\n4,2.6e-7\n8,4.1e-7\n",
    );
    write(
        "measured.csv",
        "entrainment_speed_m_per_s,film_central_nm\n1,400\n2,600\n",
    );
    folder
}

/// Runs the program with 4 GB of memory at most; its exit code and output.
fn run(folder: &Path, arguments: &[OsString], stdin: Stdio) -> (i32, String) {
    let [out, err] = [".stdout", ".stderr"].map(|name| folder.join(name));
    let mut child = Command::new("sh")
        .args(["-c", "ulimit -v 4000000; exec \"$0\" \"$@\""])
        .arg(env!("CARGO_BIN_EXE_ertel"))
        .args(arguments)
        .current_dir(folder)
        .env("RAYON_NUM_THREADS", "2")
        .stdin(stdin)
        .stdout(fs::File::create(&out).unwrap())
        .stderr(fs::File::create(&err).unwrap())
        .spawn()
        .unwrap();
    let begun = Instant::now();
    let status = loop {
        if let Some(status) = child.try_wait().unwrap() {
            break status;
        }
        if begun.elapsed() > LONGEST {
            child.kill().unwrap();
            child.wait().unwrap();
            panic!("{arguments:?} does not end");
        }
        std::thread::sleep(Duration::from_millis(5));
    };
    let said = [out, err].map(|path| {
        let text = String::from_utf8_lossy(&fs::read(&path).unwrap()).into_owned();
        fs::remove_file(path).unwrap();
        text
    });
    (status.code().unwrap_or(-1), said.concat())
}

/// State of a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum State {
    Missing,
    File,
    Folder,
    Pipe,
    Zeros,
    Full,
    Unreadable,
    Loop,
    ToNothing,
    NoUtf8,
}

const STATES: [State; 10] = [
    State::Missing,
    State::File,
    State::Folder,
    State::Pipe,
    State::Zeros,
    State::Full,
    State::Unreadable,
    State::Loop,
    State::ToNothing,
    State::NoUtf8,
];

impl State {
    /// Makes `path` so; a file with `content` where it is one. Returns the path, whose name may become another one.
    fn make(self, path: &Path, content: &[u8]) -> PathBuf {
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        match self {
            State::Missing => {}
            State::File => fs::write(path, content).unwrap(),
            State::Folder => {
                fs::create_dir_all(path).unwrap();
                fs::write(path.join("diary.txt"), "mine").unwrap();
            }
            State::Pipe => {
                let made = Command::new("mkfifo").arg(path).status().unwrap();
                assert!(made.success());
            }
            State::Zeros => symlink("/dev/zero", path).unwrap(),
            State::Full => symlink("/dev/full", path).unwrap(),
            State::Unreadable => {
                fs::write(path, content).unwrap();
                fs::set_permissions(path, fs::Permissions::from_mode(0o000)).unwrap();
            }
            State::Loop => symlink(path.file_name().unwrap(), path).unwrap(),
            State::ToNothing => symlink("nothing/there", path).unwrap(),
            State::NoUtf8 => {
                let mut name = b"caf\xe9-".to_vec();
                name.extend(path.file_name().unwrap().as_bytes());
                let path = path.with_file_name(OsString::from_vec(name));
                fs::write(&path, content).unwrap();
                return path;
            }
        }
        path.to_owned()
    }
}

/// All that a folder holds but for what ertel makes: kinds of entries, texts of files, targets of links.
fn belongings(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let meta = fs::symlink_metadata(&path).unwrap();
        let kind = meta.file_type();
        let content = if kind.is_dir() {
            found.extend(belongings(&path));
            b"folder".to_vec()
        } else if kind.is_symlink() {
            fs::read_link(&path).unwrap().into_os_string().into_vec()
        } else if kind.is_fifo() {
            b"pipe".to_vec()
        } else {
            fs::read(&path).unwrap_or_else(|_| b"unreadable".to_vec())
        };
        found.insert(path, content);
    }
    found
}

/// Runs a command, `{}` being the path, and looks at its end.
fn check(folder: &Path, command: &str, path: &OsStr, what: &str) -> i32 {
    let before = belongings(folder);
    let words = command.split(' ');
    let arguments: Vec<OsString> = words
        .map(|word| match word.split_once("{}") {
            Some((start, end)) => {
                let mut word = OsString::from(start);
                word.push(path);
                word.push(end);
                word
            }
            None => OsString::from(word),
        })
        .collect();
    let (code, said) = run(folder, &arguments, Stdio::null());
    let what = format!("{command}, {what}");
    assert!((0..=3).contains(&code), "{what}: exit code {code}\n{said}");
    assert!(!said.contains("panicked"), "{what}: {said}");
    assert_eq!(
        code == 2 || code == 1,
        said.contains("error: ") && code != 3,
        "{what}: {code}, {said}"
    );
    let after = belongings(folder);
    for (path, content) in before {
        let now = after.get(&path);
        assert!(
            now == Some(&content),
            "{what}: {} is another one",
            path.display()
        );
    }
    code
}

/// Commands that read a file, and the content of a valid one.
const READERS: [(&str, &str); 18] = [
    ("solve {} -q -o out", "case.toml"),
    ("solve --check {}", "case.toml"),
    ("solve --check --json {}", "case.toml"),
    ("solve --json {} case.toml -o outs", "case.toml"),
    ("estimate {}", "case.toml"),
    ("estimate --json {}", "case.toml"),
    ("sweep {} -q -o swept", "study.toml"),
    ("sweep --json --dry-run {}", "study.toml"),
    ("compare {} measured.csv --check", "case.toml"),
    ("compare case.toml {} --check", "measured.csv"),
    ("view --no-browser {}", "case.toml"),
    ("view --no-browser {} {}", "case.toml"),
    ("fit viscosity {} --law barus", "mine.csv"),
    ("fit density {} --law tait", "mine.csv"),
    ("fit film {} --form speed", "films.csv"),
    (
        "fit viscosity mine.csv --law doolittle --density {}.toml",
        "case.toml",
    ),
    ("fluids show {}.toml", "case.toml"),
    ("sweep --merge merged {}", "study.toml"),
];

#[test]
fn files_to_read() {
    for state in STATES {
        for (command, content) in READERS {
            let folder = workspace();
            let content = fs::read(folder.path().join(content)).unwrap();
            let path = state.make(&folder.path().join("in"), &content);
            let code = check(
                folder.path(),
                command,
                path.file_name().unwrap(),
                &format!("{state:?}"),
            );
            let is_text = matches!(state, State::File | State::NoUtf8);
            let is_readable = state == State::Unreadable && fs::read(&path).is_ok();
            if !is_text && !is_readable {
                assert!(code == 2 || code == 1, "{command}, {state:?}: {code}");
            }
            if state == State::NoUtf8 && command.starts_with("solve") {
                assert_eq!(code, 0, "{command}");
            }
        }
    }
}

/// Commands that look into a folder, and the file there that is in some state.
const FOLDERS: [(&str, &str); 11] = [
    ("view --no-browser {}", "report.html"),
    ("sweep --merge merged {}", "study.json"),
    ("sweep --merge {} {}", "journal.jsonl"),
    ("sweep study.toml -q -o {}", "study.json"),
    ("sweep study.toml --dry-run -o {}", "journal.jsonl"),
    ("solve case.toml -q -o {}", "result.json"),
    ("solve case.toml -q -o {}", "curve.json"),
    (
        "compare case.toml measured.csv --check -o {}",
        "comparison.json",
    ),
    (
        "compare case.toml measured.csv --check -o {}",
        "study/study.json",
    ),
    ("validate --folder {}", "film/reference.toml"),
    ("--data {} fluids list", "fluids/oil.toml"),
];

#[test]
fn files_in_folders() {
    for state in STATES {
        for (command, name) in FOLDERS {
            let folder = workspace();
            let place = folder.path().join("place");
            state.make(&place.join(name), b"{}");
            check(
                folder.path(),
                command,
                OsStr::new("place"),
                &format!("{name} {state:?}"),
            );
        }
    }
}

/// Commands that write.
const WRITERS: [&str; 12] = [
    "solve case.toml -q -o {}",
    "solve case.toml --json -o {}",
    "solve case.toml --check --json -o {}",
    "solve case.toml -q -o {}/below",
    "sweep study.toml --json -o {}",
    "sweep --merge {} no-part",
    "compare case.toml measured.csv --check -o {}",
    "fit viscosity mine.csv --law barus -o {}",
    "fit viscosity mine.csv --law barus --force --plot {}.svg",
    "init ball -o {}",
    "fluids show squalane-pip --plot {}.svg",
    "man -o {}",
];

#[test]
fn places_to_write() {
    for state in STATES {
        for command in WRITERS {
            let folder = workspace();
            let mut path = state.make(&folder.path().join("out"), b"a diary");
            if state == State::NoUtf8 {
                // The name alone: nothing is there.
                fs::remove_file(&path).unwrap();
            }
            if command.contains(".svg") {
                let mut name = path.file_name().unwrap().to_owned();
                name.push(".svg");
                if fs::symlink_metadata(&path).is_ok() {
                    fs::rename(&path, path.with_file_name(&name)).unwrap();
                }
                path = path.with_file_name(path.file_name().unwrap());
            }
            // `--force` replaces files on purpose.
            if command.contains("--force") && matches!(state, State::File | State::Unreadable) {
                continue;
            }
            let code = check(
                folder.path(),
                command,
                path.file_name().unwrap(),
                &format!("{state:?}"),
            );
            if matches!(state, State::Missing | State::NoUtf8) && !command.contains("no-part") {
                assert_eq!(code, 0, "{command}, {state:?}");
            }
            let is_file = matches!(state, State::File | State::Unreadable | State::Pipe);
            // A check of a case does not look where its results would go.
            if is_file && !command.contains("--check --json") {
                assert!(code == 2 || code == 1, "{command}, {state:?}: {code}");
            }
        }
    }
}

/// Two spellings of one folder: refused before anything is solved.
#[test]
fn one_folder_for_two_results() {
    let folder = workspace();
    let root = folder.path();
    fs::create_dir(root.join("there")).unwrap();
    symlink("there", root.join("link")).unwrap();
    symlink("later", root.join("ahead")).unwrap();
    let absolute = root.join("there/x").display().to_string();
    let case = fs::read_to_string(root.join("case.toml")).unwrap();
    let with = |name: &str, folder: &str| {
        let text = format!("{case}\n[output]\nfolder = \"{folder}\"\n");
        fs::write(root.join(name), text).unwrap();
    };
    for (a, b) in [
        ("new/x", "./new/x"),
        ("new/x", "new/y/../x"),
        ("new/x", "new/../new/./x"),
        ("there/x", "link/x"),
        ("there/x", absolute.as_str()),
        ("there/x", "link/x/deeper"),
        ("later", "ahead/deeper"),
        ("new", "./new/x"),
    ] {
        with("a.toml", a);
        with("b.toml", b);
        let arguments = ["solve", "a.toml", "b.toml", "-q"].map(OsString::from);
        let (code, said) = run(root, &arguments, Stdio::null());
        assert_eq!(code, 2, "{a}, {b}: {said}");
        contains(&said, "would go into the same folder");
        assert!(!root.join("new").exists() && !root.join("later").exists());
        assert_eq!(fs::read_dir(root.join("there")).unwrap().count(), 0);
    }
    with("a.toml", "there/x");
    with("b.toml", "link/y");
    let arguments = ["solve", "a.toml", "b.toml", "-q"].map(OsString::from);
    let (code, said) = run(root, &arguments, Stdio::null());
    assert_eq!(code, 0, "{said}");
    assert!(root.join("there/x/result.json").exists() && root.join("there/y/result.json").exists());
}

/// Results do not go into the folder of their samples.
#[test]
fn results_have_a_separate_folder() {
    let folder = workspace();
    let root = folder.path();
    symlink("out", root.join("out-monte-carlo")).unwrap();
    let words = "solve case.toml -q -o out --monte-carlo 2 --set";
    let mut arguments: Vec<OsString> = words.split(' ').map(OsString::from).collect();
    arguments.push("contact.load=20 kN/m ± 5 %".into());
    let (code, said) = run(root, &arguments, Stdio::null());
    assert_eq!(code, 2, "{said}");
    contains(&said, "these folders overlap");
    assert!(!root.join("out").exists());
}

/// A run that was stopped before its list of points was written is continued by the next one.
#[test]
fn comparisons_go_on_after_a_stop_at_any_moment() {
    let lock = |at: &Path| {
        fs::create_dir_all(at.join("study")).unwrap();
        fs::write(at.join("study/.lock"), "").unwrap();
    };
    for leftovers in ["", "study/.ertel-a1b2c3", ".ertel-a1b2c3"] {
        let folder = workspace();
        let place = folder.path().join("place");
        lock(&place);
        if !leftovers.is_empty() {
            fs::write(place.join(leftovers), "half of a li").unwrap();
        }
        let command = "compare case.toml measured.csv -q -o place";
        let arguments: Vec<OsString> = command.split(' ').map(OsString::from).collect();
        let (code, said) = run(folder.path(), &arguments, Stdio::null());
        assert!(code == 0 || code == 3, "{leftovers}: {code}, {said}");
        assert!(place.join("comparison.json").exists(), "{said}");
        // Everything of it may be gone but what comes first.
        for name in ["comparison.csv", "report.txt", "comparison.svg"] {
            fs::remove_file(place.join(name)).unwrap();
        }
        let (code, said) = run(folder.path(), &arguments, Stdio::null());
        assert!(code == 0 || code == 3, "{code}, {said}");
    }
    for name in ["study/notes.txt", "study/.lock", "comparison.svg"] {
        let folder = workspace();
        let place = folder.path().join("place");
        lock(&place);
        fs::write(place.join(name), "mine").unwrap();
        let command = "compare case.toml measured.csv -q -o {}";
        let code = check(folder.path(), command, OsStr::new("place"), name);
        assert!(code == 1 || code == 2, "{name}: {code}");
    }
}

/// Answers from devices end; so do those of a program that never says anything right.
#[test]
fn questions_end() {
    let folder = workspace();
    let arguments = ["init", "rig", "--ask"].map(OsString::from);
    for path in ["/dev/zero", "/dev/null"] {
        let input = Stdio::from(fs::File::open(path).unwrap());
        let (code, said) = run(folder.path(), &arguments, input);
        assert_eq!(code, 2, "{path}: {said}");
    }
    let mut yes = Command::new("yes")
        .arg("nonsense")
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let input = Stdio::from(yes.stdout.take().unwrap());
    let (code, said) = run(folder.path(), &arguments, input);
    yes.wait().unwrap();
    assert_eq!(code, 2, "{said}");
    contains(&said, "100 answers to one question were wrong");
}

/// Nothing was compared: that is no success.
#[test]
fn an_empty_validation_is_an_error() {
    let folder = workspace();
    fs::create_dir(folder.path().join("none")).unwrap();
    let code = check(
        folder.path(),
        "validate --folder {}",
        OsStr::new("none"),
        "no study",
    );
    assert_eq!(code, 2);
}

/// An entry changed by hand, and a drawing next to it that was not named.
#[test]
fn a_fit_replaces_only_with_force() {
    let folder = workspace();
    let root = folder.path();
    let fit = |more: &str| {
        let command = format!("fit viscosity mine.csv --law barus {more}");
        let arguments: Vec<OsString> = command.split(' ').map(OsString::from).collect();
        run(root, &arguments, Stdio::null())
    };
    fs::write(root.join("oil.svg"), "my drawing").unwrap();
    let (code, said) = fit("-o oil.toml");
    assert_eq!(code, 2, "{said}");
    contains(
        &said,
        "will not overwrite oil.svg; choose another name, or add --force",
    );
    assert!(!root.join("oil.toml").exists());
    fs::rename(root.join("oil.svg"), root.join("oil.toml")).unwrap();
    let (code, said) = fit("-o oil.toml");
    assert_eq!(code, 2, "{said}");
    assert_eq!(
        fs::read_to_string(root.join("oil.toml")).unwrap(),
        "my drawing"
    );
    let (code, said) = fit("-o oil.toml --force");
    assert_eq!(code, 0, "{said}");
    contains(&fs::read_to_string(root.join("oil.toml")).unwrap(), "barus");
}

/// The dry contact of a long tilted roller takes a minute: no check waits for it, at no point of a study either.
#[test]
fn checks_take_no_time() {
    let folder = tempfile::tempdir().unwrap();
    let root = folder.path();
    let case = "[contact]\nkind = \"roller\"\nradius = \"1.02 mm\"\nlength = \"97.5 mm\"\nload = \"340 N\"\n\
                profile = { kind = \"iso-16281\", diameter = \"2.04 mm\" }\nmisalignment = \"0.0096 deg\"\n\
                [bodies]\nbody_1 = \"steel\"\nbody_2 = \"steel\"\n\
                [motion]\nentrainment_speed = \"0.7 m/s\"\nslide_to_roll_ratio = 0.0\n\
                [lubricant]\nname = \"turbine-oil-sae-30\"\ntemperature = \"353 K\"\n";
    fs::write(root.join("roller.toml"), case).unwrap();
    let study = "case = \"roller.toml\"\n[[axis]]\nkey = \"contact.load\"\nfrom = \"300 N\"\nto = \"400 N\"\npoints = 20\n";
    fs::write(root.join("study.toml"), study).unwrap();
    fs::write(
        root.join("measured.csv"),
        "load_N,film_central_nm\n300,400\n340,380\n",
    )
    .unwrap();
    for command in [
        "solve --check roller.toml",
        "sweep --dry-run study.toml",
        "compare roller.toml measured.csv --check",
    ] {
        let begun = Instant::now();
        let arguments: Vec<OsString> = command.split(' ').map(OsString::from).collect();
        let (code, said) = run(root, &arguments, Stdio::null());
        assert_eq!(code, 0, "{command}: {said}");
        // Tenths of a second; a single dry contact takes tens of them.
        assert!(begun.elapsed() < Duration::from_secs(10), "{command}");
    }
}
