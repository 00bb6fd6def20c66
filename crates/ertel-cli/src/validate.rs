//! `ertel validate`.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

use ertel::engine::NoObserver;
use ertel::files::write_whole;
use ertel_validate::{self as validate, Quantity, Row, Selection, Study, StudyResult, Verdict};

use ertel_input::file::{LARGEST_DOCUMENT, LARGEST_TABLE, read_text};

use crate::args::ValidateArgs;
use crate::failure::Failure;
use crate::inputs;
use crate::print;

/// Runs the command.
///
/// # Errors
///
/// Unknown names, bad files, and comparisons that do not hold.
pub fn run(arguments: &ValidateArgs) -> Result<(), Failure> {
    let folder = &arguments.folder;
    let studies = read_studies(arguments)?;
    keep_inputs(arguments, &studies)?;
    let selection = if arguments.quick {
        Selection::Quick
    } else {
        Selection::All
    };
    let mut failed = Vec::new();
    let mut sections = Vec::new();
    let mut results = Vec::new();
    // Tables and pages are written even if nothing can be shown.
    let mut shown = Ok(());
    for study in &studies {
        let clock = Instant::now();
        let result = study.run(selection, &mut NoObserver, &mut |run| {
            print::stderr(&format!("{}: {}", study.name, run.name));
        })?;
        let seconds = clock.elapsed().as_secs_f64();
        let text = validate::text(study, &result);
        shown = shown.and(print::stdout(&format!("{text}\n")));
        print::stderr(&format!("{}: {seconds:.0} s", study.name));
        if arguments.update {
            let changes = update(study, &result, &folder.join(&study.name))?;
            shown = shown.and(print::stdout(&changes));
        }
        let counts = |row: &&Row| {
            let is_effort = row.label == Quantity::NewtonIterations.label();
            !(arguments.update && is_effort)
        };
        if (result.rows.iter().filter(counts)).any(|row| row.verdict == Verdict::Fails) {
            failed.push(study.name.as_str());
        }
        if let Some(docs) = &arguments.write {
            sections.push((study.name.clone(), section(study, &result, docs)?));
        }
        results.push((study, result, seconds));
    }
    let results: Vec<_> = results.iter().map(|(s, r, t)| (*s, r, *t)).collect();
    if let Some(path) = &arguments.table {
        write(path, &validate::csv(&results))?;
    }
    shown = shown.and(print::stdout(&format!("{}\n", validate::summary(&results))));
    if let Some(docs) = &arguments.write {
        let path = docs.join(PAGE);
        // With chosen studies, the sections of the others stay.
        let old = match arguments.names.is_empty() {
            true => String::new(),
            false => read_page(&path)?,
        };
        write(&path, &validate::splice(&old, &sections))?;
    }
    if results.iter().all(|(_, result, _)| result.rows.is_empty()) {
        let help = match arguments.quick {
            true => ": none of the runs is quick; omit --quick",
            false => "",
        };
        return Err(Failure::Argument(format!("nothing was compared{help}")));
    }
    if failed.is_empty() {
        shown?;
        print::stdout("all comparisons hold\n")
    } else {
        Err(Failure::Other(format!(
            "comparisons that do not hold in: {}",
            failed.join(", ")
        )))
    }
}

/// The named studies, or all.
///
/// # Errors
///
/// No studies, unknown names, bad files.
fn read_studies(arguments: &ValidateArgs) -> Result<Vec<Study>, Failure> {
    let folder = &arguments.folder;
    let known = validate::names(folder)
        .map_err(|error| Failure::Argument(format!("{}: {error}", folder.display())))?;
    if known.is_empty() {
        return Err(Failure::Argument(format!(
            "there is no study in {}: each is a folder with a file reference.toml; name the folder that holds them with --folder",
            folder.display()
        )));
    }
    for name in &arguments.names {
        if !known.contains(name) {
            return Err(Failure::Argument(format!(
                "no study `{name}` in {}; there are: {}",
                folder.display(),
                known.join(", ")
            )));
        }
    }
    let names = if arguments.names.is_empty() {
        &known
    } else {
        &arguments.names
    };
    let studies = names.iter().map(|name| validate::read(&folder.join(name)));
    Ok(studies.collect::<Result<_, _>>()?)
}

/// Refuses to overwrite the files of the studies, or a file of `--write` by `--table`.
fn keep_inputs(arguments: &ValidateArgs, studies: &[Study]) -> Result<(), Failure> {
    let read: Vec<_> = studies.iter().flat_map(|s| s.files.clone()).collect();
    if let Some(path) = &arguments.table {
        inputs::keep(&read, &[("--table", path)])?;
    }
    if let Some(docs) = &arguments.write {
        for file in written(studies, docs) {
            inputs::keep(&read, &[("the file", &file)])?;
            if let Some(table) = &arguments.table
                && inputs::is_one_place(table, &file)
            {
                return Err(Failure::Argument(format!(
                    "--table {} names a file that --write makes, too; give it another name",
                    table.display()
                )));
            }
        }
    }
    Ok(())
}

/// Updates the stated iterations of a study to those taken.
fn update(study: &Study, result: &StudyResult, folder: &Path) -> Result<String, Failure> {
    let path = folder.join("reference.toml");
    let failed = |error: String| Failure::Other(format!("{}: {error}", path.display()));
    let text = read_text(&path, LARGEST_DOCUMENT).map_err(|error| failed(error.to_string()))?;
    let (updated, changes) = validate::update(&text, study, result).map_err(failed)?;
    if changes.is_empty() {
        return Ok(String::new());
    }
    write_whole(&path, updated.as_bytes()).map_err(|error| failed(error.to_string()))?;
    let changes: Vec<String> = changes.iter().map(ToString::to_string).collect();
    Ok(format!("{}\n{}\n", path.display(), changes.join("\n")))
}

/// The page and every picture that `--write` makes.
fn written(studies: &[Study], docs: &Path) -> Vec<PathBuf> {
    let picture = |study: &Study, name: &str| {
        let name = format!("{PICTURES}/{}-{name}.svg", study.name);
        docs.join(name)
    };
    let pictures = studies
        .iter()
        .flat_map(|s| s.pictures.iter().map(move |p| picture(s, &p.name)));
    pictures.chain([docs.join(PAGE)]).collect()
}

/// Writes the pictures of a study; returns its part of the page.
fn section(study: &Study, result: &StudyResult, docs: &Path) -> Result<String, Failure> {
    let mut pictures = Vec::new();
    for (name, caption, svg) in study.draw(result) {
        let path = format!("{PICTURES}/{name}.svg");
        write(&docs.join(&path), &svg)?;
        pictures.push((path, caption));
    }
    Ok(validate::markdown(study, result, &pictures))
}

/// The page as it is; empty if there is none.
fn read_page(path: &Path) -> Result<String, Failure> {
    match read_text(path, LARGEST_TABLE) {
        Ok(page) => Ok(page),
        Err(error) if error.is_missing() => Ok(String::new()),
        Err(error) => Err(Failure::Other(format!("{} {error}", path.display()))),
    }
}

/// The page.
const PAGE: &str = "validation.md";
/// Folder of the pictures next to the page.
const PICTURES: &str = "validation";

fn write(path: &Path, text: &str) -> Result<(), Failure> {
    let failed = |error| Failure::Other(format!("cannot write {}: {error}", path.display()));
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).map_err(failed)?;
    }
    write_whole(path, text.as_bytes()).map_err(failed)
}
