//! Writing to stdout and stderr. A closed pipe (`ertel fluids | head`) ends the output, not the program, and nothing here
//! panics, as `println!` and `eprintln!` do.

use std::io::{self, Write};

use ertel::warning::Warning;
use ertel_input::escaped;

use crate::colour;
use crate::failure::Failure;
use crate::wrap::wrapped;

/// Writes `text` to stdout; control characters that it quotes are shown, not obeyed.
///
/// # Errors
///
/// Anything but a closed pipe, such as a full disk behind a redirection.
pub fn stdout(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    let text = colour::stdout(escaped(text).into_owned());
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(Failure::Other(format!("cannot write to stdout: {error}")))
        }
        _ => Ok(()),
    }
}

/// As [`stdout`], for reports: on a terminal, lines are broken at its width.
///
/// # Errors
///
/// As [`stdout`].
pub fn report(text: &str) -> Result<(), Failure> {
    match console::Term::stdout().size_checked() {
        Some((_, width)) if width > 20 => stdout(&wrapped(text, usize::from(width))),
        _ => stdout(text),
    }
}

/// Writes a line to stderr; control characters that it quotes are shown, not obeyed. Failures
/// are ignored: they cannot be reported, and the work matters more.
pub fn stderr(line: &str) {
    // In one piece, so that lines of several threads do not mix.
    let _ = io::stderr()
        .lock()
        .write_all(format!("{}\n", colour::stderr(escaped(line).into_owned())).as_bytes());
}

/// Warnings on stderr, with their codes.
pub fn warn<'a>(warnings: impl IntoIterator<Item = &'a Warning>) {
    for warning in warnings {
        let what = warning.kind.severity().word();
        stderr(&format!("{what}: {}", warning.coded()));
    }
}
