//! `ertel completions` and `ertel man`.

use std::path::Path;
use std::{fs, io};

use clap::CommandFactory;
use ertel::files::write_whole;
use ertel_input::file::{LARGEST_DOCUMENT, read_bytes};

use crate::args::{Cli, CompletionsArgs, ManArgs};
use crate::failure::Failure;
use crate::print;

/// Prints the completions.
///
/// # Errors
///
/// An output that cannot be written.
pub fn completions(arguments: &CompletionsArgs) -> Result<(), Failure> {
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, &mut Cli::command(), "ertel", &mut script);
    print::stdout(&text(script)?)
}

/// Prints the manual page, or writes those of all commands.
///
/// # Errors
///
/// A folder that cannot be written, files there that are no manual pages.
pub fn man(arguments: &ManArgs) -> Result<(), Failure> {
    let Some(folder) = &arguments.output else {
        let mut page = Vec::new();
        clap_mangen::Man::new(Cli::command())
            .render(&mut page)
            .map_err(|error| Failure::Other(format!("cannot make the manual page: {error}")))?;
        return print::stdout(&text(page)?);
    };
    let n = write(folder)?;
    print::stdout(&format!("{n} pages in {}\n", folder.display()))
}

/// Writes the pages; returns how many.
fn write(folder: &Path) -> Result<usize, Failure> {
    let failed = |error: io::Error| {
        Failure::Other(format!(
            "cannot write the manual pages to {}: {error}",
            folder.display()
        ))
    };
    fs::create_dir_all(folder).map_err(failed)?;
    let made = tempfile::tempdir_in(folder).map_err(failed)?;
    clap_mangen::generate_to(Cli::command(), made.path()).map_err(failed)?;
    let mut pages = Vec::new();
    for entry in fs::read_dir(made.path()).map_err(failed)? {
        let entry = entry.map_err(failed)?;
        pages.push((
            folder.join(entry.file_name()),
            fs::read(entry.path()).map_err(failed)?,
        ));
    }
    for (path, page) in &pages {
        let first = page.split(|byte| *byte == b'\n').next().unwrap_or_default();
        let is_ours = match read_bytes(path, LARGEST_DOCUMENT) {
            Ok(old) => old.starts_with(first),
            Err(error) => error.is_missing(),
        };
        if !is_ours {
            return Err(Failure::Argument(format!(
                "will not overwrite {}: it is no manual page of this program",
                path.display()
            )));
        }
    }
    for (path, page) in &pages {
        write_whole(path, page).map_err(failed)?;
    }
    Ok(pages.len())
}

fn text(bytes: Vec<u8>) -> Result<String, Failure> {
    String::from_utf8(bytes).map_err(|error| Failure::Other(error.to_string()))
}
