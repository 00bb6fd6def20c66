//! Good and bad files to begin with: the shipped cases, studies and data, the bad cases of the tests, the corpus.

use std::fs;
use std::io;
use std::panic::catch_unwind;
use std::path::{Path, PathBuf};

use clap::ValueEnum;
use fastrand::Rng;

use crate::bad::bad_cases;
use crate::input::{Input, Target, scratch};
use crate::mutate::Words;
use crate::targets::{self, Verdict, answers, course, journal, read, stopped, surface, view};

/// Lines of a seed table, at most: long tables are slow and say no more.
const MOST_LINES: usize = 25;

/// Folders with case files and studies.
const CASES: [&str; 5] = [
    "cases",
    "studies",
    "validation",
    "crates/ertel-cli/tests/good",
    "crates/ertel-cli/tests/bad",
];

/// A case whose lubricant has its laws in a table.
const TABLE_CASE: &str = include_str!("../corpus/table-case.toml");
/// A study whose points stand in a table, and its base case.
const POINTS_STUDY: &str = include_str!("../corpus/points-study.toml");
const BALL: &str = include_str!("../../../cases/measured-films.toml");
const ROLLER: &str = include_str!("../../../cases/roller.toml");

const SETTINGS: &str =
    "contact.load=50 kN/m\nlubricant.temperature=80 degC\nmotion.slide_to_roll_ratio=0.1\n";
const CHANGES: &str = r#"[["contact.radius", "16 mm"], ["mesh.target_error", "1 %"], ["thermal", {}], ["title", null], ["a.b", 3]]"#;

/// Files from which inputs are made.
#[derive(Debug)]
pub struct Seeds {
    seeds: Vec<Seed>,
    words: Words,
}

#[derive(Debug)]
struct Seed {
    input: Input,
    /// Whether its reader refuses it.
    is_bad: bool,
}

/// Adds the case files, good and bad, as inputs of all targets that they suit.
fn add_cases(root: &Path, inputs: &mut Vec<Input>) -> io::Result<()> {
    let mut cases = Vec::new();
    for folder in CASES {
        for path in files(&root.join(folder), "toml")? {
            let content = fs::read(&path)?;
            cases.push((path, content));
        }
    }
    let bad = root.join("crates/ertel-cli/tests/bad");
    for case in bad_cases(&fs::read_to_string(bad.join("cases.txt"))?) {
        cases.push((bad.join(case.name), case.text.into_bytes()));
    }
    for (path, content) in cases {
        let text = String::from_utf8_lossy(&content).into_owned();
        if text.contains("[[axis]]") || text.contains("\npoints = \"") {
            inputs.push(study(&path, content, &text)?);
        } else if !path.ends_with("reference.toml") {
            if text.contains("\"line\"") {
                inputs.push(of_main(Target::Solve, content.clone()));
            }
            for (target, words) in [
                (Target::Machine, "[machine"),
                (Target::Settings, "[contact"),
                (Target::Web, ""),
            ] {
                if text.contains(words) {
                    let mut input = of_main(target, Vec::new());
                    input.set("case.toml", content.clone());
                    inputs.push(input);
                }
            }
            inputs.push(of_main(Target::Case, content));
        }
    }
    Ok(())
}

impl Seeds {
    /// Reads them from a checkout.
    ///
    /// # Errors
    /// Files that cannot be read.
    pub fn read(root: &Path) -> io::Result<Seeds> {
        let mut inputs = Vec::new();
        add_cases(root, &mut inputs)?;
        for (target, folder) in [
            (Target::Table, "crates/ertel-rheology/data/fluids"),
            (Target::FitViscosity, "validation/appendix-c"),
            (Target::FitDensity, "crates/ertel-rheology/data/fluids"),
            (Target::FitFilm, "studies"),
        ] {
            for path in files(&root.join(folder), "csv")? {
                let text = fs::read_to_string(path)?;
                let lines: Vec<&str> = text.lines().take(MOST_LINES).collect();
                inputs.push(of_main(target, lines.join("\n").into_bytes()));
            }
        }
        let films = fs::read_to_string(root.join("cases/measured-films.csv"))?;
        inputs.push(of_main(Target::Measured, films.into_bytes()));
        let sheet = fs::read(root.join("cases/data-sheet-oil.csv"))?;
        inputs.push(of_main(Target::FitViscosity, sheet));
        for path in files(&root.join("crates/ertel-rheology/data"), "toml")? {
            let mut input = of_main(Target::OwnData, fs::read(&path)?);
            add_tables(&path, &mut input)?;
            inputs.push(input);
        }
        let journal = journal::seed()?;
        inputs.push(Input {
            target: Target::StudyList,
            ..journal.clone()
        });
        inputs.push(read::seed(&journal));
        inputs.push(journal);
        inputs.push(stopped::seed()?);
        inputs.extend(answers::seeds());
        inputs.extend(view::seeds());
        inputs.extend(surface::seeds());
        inputs.extend(course::seeds());
        inputs.extend(corpus(root)?);
        let texts = inputs.iter().flat_map(|input| &input.files);
        let words = Words::new(
            texts
                .filter(|(name, _)| name.ends_with(".toml"))
                .filter_map(|(_, content)| std::str::from_utf8(content).ok()),
        );
        let seeds = inputs
            .into_iter()
            .map(Seed::new)
            .collect::<io::Result<_>>()?;
        Ok(Seeds { seeds, words })
    }

    /// The input of a number: the same for the same seeds, whatever came before.
    pub fn input(&self, seed: u64, index: u64, targets: &[Target]) -> Input {
        let mut rng = Rng::with_seed(seed ^ index.wrapping_mul(0x9e37_79b9_7f4a_7c15));
        let total: u32 = targets.iter().map(|t| t.weight()).sum();
        let mut left = rng.u32(0..total.max(1));
        let mut target = targets[0];
        for candidate in targets {
            target = *candidate;
            if left < target.weight() {
                break;
            }
            left -= target.weight();
        }
        // A seed that is refused undamaged does not reach the code behind the readers.
        let bad = rng.u8(0..5) == 0;
        let of_target = self.seeds.iter().filter(|i| i.input.target == target);
        let (bad_ones, mut own): (Vec<&Seed>, Vec<&Seed>) = of_target.partition(|i| i.is_bad);
        if bad || own.is_empty() {
            own.extend(bad_ones);
        }
        let mut input = own[rng.usize(0..own.len())].input.clone();
        crate::mutate::damage(&mut input, &mut rng, &self.words);
        input
    }
}

impl Seed {
    fn new(input: Input) -> io::Result<Seed> {
        let folder = scratch()?;
        input.write(folder.path())?;
        // Solves take long; a defect of a seed is found when it is fed.
        let is_bad = input.target != Target::Solve
            && catch_unwind(|| targets::run(&input, folder.path()))
                .is_ok_and(|r| r != Ok(Verdict::Taken));
        Ok(Seed { input, is_bad })
    }
}

/// An input with this main file and the others as they should be.
fn of_main(target: Target, content: Vec<u8>) -> Input {
    let mut input = Input {
        target,
        files: Vec::new(),
    };
    let others: &[(&str, &str)] = match target {
        Target::Table => &[("case.toml", TABLE_CASE)],
        Target::Measured => &[("case.toml", BALL)],
        Target::Points => &[("study.toml", POINTS_STUDY), ("roller.toml", ROLLER)],
        Target::Settings => &[("case.toml", ROLLER), ("settings.txt", SETTINGS)],
        Target::Web => &[("changes.json", CHANGES)],
        _ => &[],
    };
    for (name, text) in others {
        input.set(name, text.as_bytes().to_vec());
    }
    input.set(target.main_file(), content);
    input
}

/// A study with its base case and its points, as far as they are there.
fn study(path: &Path, content: Vec<u8>, text: &str) -> io::Result<Input> {
    let mut input = of_main(Target::Study, content);
    let mut named = text.to_owned();
    for line in text.lines() {
        let Some((key, value)) = line.split_once('=') else {
            continue;
        };
        let name = value.trim().trim_matches('"');
        let neighbour = path.with_file_name(name);
        if matches!(key.trim(), "case" | "points") && name.contains('.') && neighbour.is_file() {
            // Files of an input are in one folder.
            let own = name.rsplit('/').next().unwrap_or(name);
            named = named.replace(name, own);
            input.set(own, fs::read(&neighbour)?);
        }
    }
    if named != text {
        input.set(input.target.main_file(), named.into_bytes());
    }
    Ok(input)
}

/// The tables that a file of the database names.
fn add_tables(path: &Path, input: &mut Input) -> io::Result<()> {
    let folder = path.parent().unwrap_or(path);
    let text = String::from_utf8_lossy(input.file(input.target.main_file())).into_owned();
    for name in text.split('"').filter(|name| name.ends_with(".csv")) {
        if folder.join(name).is_file() {
            input.set(name, fs::read(folder.join(name))?);
        }
    }
    Ok(())
}

/// The inputs of the corpus: of each target a folder with main files, or with folders of all files of an input.
///
/// # Errors
/// Files that cannot be read.
pub fn corpus(root: &Path) -> io::Result<Vec<Input>> {
    let mut inputs = Vec::new();
    for target in Target::value_variants().iter().copied() {
        let folder = root.join("crates/ertel-fuzz/corpus").join(target.name());
        if !folder.is_dir() {
            continue;
        }
        for path in sorted(&folder)? {
            if path.is_dir() {
                inputs.push(read_folder(target, &path)?);
            } else {
                inputs.push(of_main(target, fs::read(path)?));
            }
        }
    }
    Ok(inputs)
}

/// The input whose files stand in a folder.
///
/// # Errors
/// Files that cannot be read.
pub fn read_folder(target: Target, folder: &Path) -> io::Result<Input> {
    let mut input = Input {
        target,
        files: Vec::new(),
    };
    for path in sorted(folder)?.into_iter().filter(|path| path.is_file()) {
        let name = path
            .file_name()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned();
        if name != crate::finding::NOTE {
            input.set(&name, fs::read(path)?);
        }
    }
    Ok(input)
}

fn sorted(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let mut paths: Vec<PathBuf> = fs::read_dir(folder)?
        .map(|e| Ok(e?.path()))
        .collect::<io::Result<_>>()?;
    paths.sort();
    Ok(paths)
}

/// Files of a kind in a folder and below.
fn files(folder: &Path, extension: &str) -> io::Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    for path in sorted(folder)? {
        if path.is_dir() {
            found.extend(files(&path, extension)?);
        } else if path.extension().is_some_and(|e| e == extension) {
            found.push(path);
        }
    }
    Ok(found)
}
