//! Ctrl-C: stops the solver, and waits until results are written.

use std::sync::atomic::{AtomicBool, Ordering};

use crate::print;

/// Set by Ctrl-C; the solver looks at it before each iteration.
pub static CANCELLED: AtomicBool = AtomicBool::new(false);

/// Set while results are written: a second Ctrl-C waits until they are.
pub static WRITING: AtomicBool = AtomicBool::new(false);

/// The first Ctrl-C asks the solver to stop; the second ends the program where no file can be incomplete.
pub fn listen_for_interrupts() {
    let handler = || {
        if CANCELLED.swap(true, Ordering::SeqCst) {
            if !WRITING.load(Ordering::SeqCst) {
                std::process::exit(130);
            }
        } else {
            print::stderr("stopping after this iteration; press Ctrl-C again to stop at once");
        }
    };
    if let Err(error) = ctrlc::set_handler(handler) {
        print::stderr(&format!(
            "warning: Ctrl-C will stop the program at once ({error})"
        ));
    }
}
