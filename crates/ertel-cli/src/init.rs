//! `ertel init`: a case file to start from.

mod ask;
mod template;

use std::fs::OpenOptions;
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};

use clap::Args;

use crate::failure::Failure;
use crate::print;
use crate::table::columns;
use ask::ask;
use template::TEMPLATES;

/// `ertel init`.
#[derive(Debug, Args)]
#[command(after_help = "\
ertel init                       asks on a terminal, lists the templates elsewhere
ertel init rig > my.toml         writes a template as it is
ertel init rig --ask -o my.toml  asks for its values first")]
pub struct InitArgs {
    /// The template: bearing, bearing-ball, roller-bearing, gear, gear-contact, helical-gear, helical-gear-contact, fzg, cam, rig, ball, line or roller
    #[arg(value_name = "TEMPLATE")]
    pub template: Option<String>,
    /// Write the case into this file, which must not exist [default: stdout]
    #[arg(short, long, value_name = "FILE.toml")]
    pub output: Option<PathBuf>,
    /// Ask for the values of the template, one answer on a line of standard input
    #[arg(long)]
    pub ask: bool,
}

/// Runs the command.
///
/// # Errors
///
/// An unknown template, a file that is there already, answers that end too early.
pub fn run(arguments: &InitArgs) -> Result<(), Failure> {
    let template = arguments
        .template
        .as_deref()
        .map(template::named)
        .transpose()?;
    if let Some(path) = &arguments.output {
        // Before the questions, not after them.
        refuse_existing(path)?;
    }
    let is_terminal = io::stdin().is_terminal() && io::stderr().is_terminal();
    let text = match template {
        Some(template) if !arguments.ask => template.text(),
        None if !arguments.ask && !is_terminal => return list(),
        template => ask(template, &mut io::stdin().lock(), &mut print::stderr)?,
    };
    match &arguments.output {
        Some(path) => write_new(path, &text),
        None => print::stdout(&text),
    }
}

fn list() -> Result<(), Failure> {
    let mut rows = vec![["template", "description"].map(str::to_owned).to_vec()];
    rows.extend(
        TEMPLATES
            .iter()
            .map(|t| vec![t.name.to_owned(), t.about.to_owned()]),
    );
    print::stdout(&format!(
        "{}\n  ertel init TEMPLATE --output my-case.toml   writes one; with --ask it asks for its values\n",
        columns(&rows)
    ))
}

fn refuse_existing(path: &Path) -> Result<(), Failure> {
    match path.symlink_metadata() {
        Ok(_) => Err(exists(path)),
        Err(_) => Ok(()),
    }
}

fn exists(path: &Path) -> Failure {
    Failure::Argument(format!(
        "will not overwrite {}; choose another name with --output",
        path.display()
    ))
}

fn write_new(path: &Path, text: &str) -> Result<(), Failure> {
    let failed = |error: io::Error| match error.kind() {
        io::ErrorKind::AlreadyExists => exists(path),
        _ => Failure::Other(format!("cannot write {}: {error}", path.display())),
    };
    let mut file = OpenOptions::new()
        .write(true)
        .create_new(true)
        .open(path)
        .map_err(failed)?;
    let written = file
        .write_all(text.as_bytes())
        .and_then(|()| file.sync_all());
    if let Err(error) = written {
        // It is ours: no incomplete file remains.
        let _ = std::fs::remove_file(path);
        return Err(failed(error));
    }
    print::stderr(&format!(
        "Wrote {}. Check it with `ertel solve --check {0}`, solve it with `ertel solve {0}`",
        path.display()
    ));
    Ok(())
}
