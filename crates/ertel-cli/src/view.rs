//! `ertel view`: the pages of results in the browser, several of them on one page.

use std::path::{Path, PathBuf};

use ertel::files::write_whole;
use ertel::output::REPORT_PAGE;
use ertel::output::html::{self, PageError};
use ertel_input::file::{FileError, LARGEST_OWN, read_text};

use crate::args::ViewArgs;
use crate::failure::Failure;
use crate::inputs;
use crate::print;

/// Shows results: the page of one, or a page of all of them side by side.
pub fn run(arguments: &ViewArgs) -> Result<(), Failure> {
    let pages: Vec<PathBuf> = arguments.results.iter().map(|path| page_of(path)).collect();
    let mut texts = Vec::new();
    for page in &pages {
        texts.push(read(page)?);
    }
    let single = pages.len() == 1;
    let text = match single {
        true => {
            html::page_data(&texts[0]).map_err(|error| refused(&pages[0], &error))?;
            texts.remove(0)
        }
        false => join(&arguments.results, &pages, &texts)?,
    };
    let shown = match &arguments.output {
        Some(path) => {
            check_output(path, &pages)?;
            write_whole(path, text.as_bytes())
                .map_err(|e| Failure::Other(format!("cannot write {}: {e}", path.display())))?;
            path.clone()
        }
        None if single => pages[0].clone(),
        None => temporary(&text)?,
    };
    print::stdout(&format!("{}\n", shown.display()))?;
    if arguments.no_browser {
        return Ok(());
    }
    let absolute = std::path::absolute(&shown).unwrap_or(shown);
    open::that_detached(&absolute).map_err(|error| {
        Failure::Other(format!(
            "no browser could be started ({error}); open the file above, or use --no-browser"
        ))
    })
}

/// The page in a folder of results; a file is taken for a page.
fn page_of(path: &Path) -> PathBuf {
    match path.is_dir() {
        true => path.join(REPORT_PAGE),
        false => path.to_owned(),
    }
}

fn read(page: &Path) -> Result<String, Failure> {
    read_text(page, LARGEST_OWN).map_err(|error| {
        Failure::Argument(match error {
            error if error.is_missing() => missing(page),
            FileError::Encoding { .. } => refused_text(page, "it is not text"),
            error => format!("{} {error}", page.display()),
        })
    })
}

/// The folder of results that is not there, or its page.
fn missing(page: &Path) -> String {
    let folder = page.parent().filter(|folder| folder.is_dir());
    match folder.filter(|_| page.ends_with(REPORT_PAGE)) {
        Some(folder) => format!(
            "{}: no such file\n  = help: result folders contain it; solve the case of {} again",
            page.display(),
            folder.display()
        ),
        None => format!(
            "{}: no such result folder\n  = help: `ertel solve` writes one, by default results/<name of the case file>",
            page.display()
        ),
    }
}

fn refused_text(page: &Path, reason: &str) -> String {
    format!("cannot show {}: {reason}", page.display())
}

fn refused(page: &Path, error: &PageError) -> Failure {
    Failure::Argument(refused_text(page, &error.to_string()))
}

/// One page of several results.
fn join(results: &[PathBuf], pages: &[PathBuf], texts: &[String]) -> Result<String, Failure> {
    let mut parts = Vec::new();
    for ((result, page), text) in results.iter().zip(pages).zip(texts) {
        let data = html::page_data(text).map_err(|error| refused(page, &error))?;
        let name = result.file_name().map_or_else(
            || result.display().to_string(),
            |n| n.to_string_lossy().into_owned(),
        );
        parts.push((name, data));
    }
    html::joint_page(parts).map_err(|error| Failure::Argument(error.to_string()))
}

/// Refuses to overwrite files of the user and the pages to be shown; other pages of ertel are replaced.
fn check_output(path: &Path, pages: &[PathBuf]) -> Result<(), Failure> {
    let refuse = |reason: &str| {
        Err(Failure::Argument(format!(
            "will not write {}: {reason}",
            path.display()
        )))
    };
    if pages.iter().any(|page| inputs::is_one_place(page, path)) {
        return refuse("it is one of the pages to be shown");
    }
    if path.is_dir() {
        return refuse("it is a folder; name a file");
    }
    match read_text(path, LARGEST_OWN) {
        Ok(text) if html::page_data(&text).is_ok() => Ok(()),
        Err(error) if error.is_missing() => Ok(()),
        _ => refuse("it exists, and is no page of ertel"),
    }
}

/// A page in the folder for temporary files; the browser reads it after this program has ended.
fn temporary(text: &str) -> Result<PathBuf, Failure> {
    let failed = |e: std::io::Error| Failure::Other(format!("cannot write a temporary page: {e}"));
    let mut file = tempfile::Builder::new()
        .prefix("ertel-view-")
        .suffix(".html")
        .tempfile()
        .map_err(failed)?;
    std::io::Write::write_all(&mut file, text.as_bytes()).map_err(failed)?;
    let (_, path) = file.keep().map_err(|e| failed(e.error))?;
    Ok(path)
}
