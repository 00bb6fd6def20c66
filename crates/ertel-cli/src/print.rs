//! Writing to stdout: a closed pipe (`ertel fluids | head`) ends the output, not the program.

use std::io::{self, Write};

use ertel_rheology::input::escaped;

use crate::failure::Failure;

/// Writes `text` to stdout; control characters that it quotes are shown, not obeyed.
///
/// # Errors
///
/// Anything but a closed pipe, such as a full disk behind a redirection.
pub fn stdout(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    match out
        .write_all(escaped(text).as_bytes())
        .and_then(|()| out.flush())
    {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(Failure::Other(format!("cannot write to stdout: {error}")))
        }
        _ => Ok(()),
    }
}
