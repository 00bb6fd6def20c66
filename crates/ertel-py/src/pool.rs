//! Threads of the solver in processes that were forked.
//!
//! A fork copies the memory of a process but not its threads: in the copy, rayon's global pool waits for ever for threads
//! that are not there. Python's `multiprocessing` forks by default on Linux up to Python 3.13.

use std::process;
use std::sync::{Arc, Mutex, PoisonError};

use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::errors::OutputError;

/// Process that uses the global pool; another process has its own pool.
static STATE: Mutex<State> = Mutex::new(State {
    global: None,
    own: None,
});

struct State {
    global: Option<u32>,
    own: Option<(u32, Arc<ThreadPool>)>,
}

/// The threads that a process may work with.
pub struct Threads(Option<Arc<ThreadPool>>);

impl Threads {
    /// Those of this process. The interpreter's lock is held meanwhile, and a fork needs it: no copy begins with `STATE` locked.
    ///
    /// # Errors
    /// When the system refuses new threads.
    pub fn of_this_process(_: Python<'_>) -> PyResult<Self> {
        let process = process::id();
        let mut state = STATE.lock().unwrap_or_else(PoisonError::into_inner);
        if *state.global.get_or_insert(process) == process {
            return Ok(Self(None));
        }
        if let Some((_, pool)) = state.own.as_ref().filter(|(owner, _)| *owner == process) {
            return Ok(Self(Some(pool.clone())));
        }
        let pool = ThreadPoolBuilder::new().build();
        let pool =
            Arc::new(pool.map_err(|error| OutputError::new_err(format!("no threads: {error}")))?);
        // A pool copied from the parent waits for its threads when dropped.
        std::mem::forget(state.own.replace((process, pool.clone())));
        Ok(Self(Some(pool)))
    }

    /// Runs `work` so that its parallel loops use these threads.
    pub fn run<T: Send>(&self, work: impl FnOnce() -> T + Send) -> T {
        match &self.0 {
            Some(pool) => pool.install(work),
            None => work(),
        }
    }
}

/// Runs `work` without the interpreter's lock, on threads of this process.
///
/// # Errors
/// When the system refuses new threads.
pub fn detached<T: Send>(py: Python<'_>, work: impl FnOnce() -> T + Send) -> PyResult<T> {
    let threads = Threads::of_this_process(py)?;
    Ok(py.detach(|| threads.run(work)))
}
