//! Solves on a separate thread, while the calling thread handles progress and Ctrl-C for Python.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use ertel::engine::Observer;
use ertel::run;
use ertel::run::transient::{InstantObserver, Reached};
use ertel::solution::IterationRecord;
use ertel::study::{CurveObserver, solve_curve as run_curve, solve_in_balance};
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;

use crate::case::{NativeCase, json};
use crate::errors;
use crate::machine::NativeMachine;
use crate::pool::Threads;
use crate::solution::{NativeCurve, NativeSolution, NativeTransient};

/// Time between two looks at Ctrl-C.
const GLANCE: Duration = Duration::from_millis(50);

/// Says that the user wants to stop, to threads that cannot ask Python.
#[derive(Clone, Default)]
pub struct Cancel(Arc<AtomicBool>);

impl Cancel {
    /// Whether to stop.
    pub fn is_set(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

/// Runs `work` on a separate thread, without the interpreter's lock, and hands the messages that it sends to `progress`. Ctrl-C, and an
/// exception in `progress`, set the flag that `work` has and are raised once it is back.
///
/// # Errors
/// Those of `progress` and of signal handlers.
pub fn without_gil<T: Send>(
    py: Python<'_>,
    progress: Option<&Py<PyAny>>,
    work: impl FnOnce(Sender<String>, Cancel) -> T + Send,
) -> PyResult<T> {
    let threads = Threads::of_this_process(py)?;
    let cancel = Cancel::default();
    let (sender, receiver) = channel::<String>();
    // Shared with the moments without the interpreter's lock.
    let receiver = Mutex::new(receiver);
    let mut raised = None;
    let result = std::thread::scope(|scope| {
        let own = cancel.clone();
        let handle = scope.spawn(move || threads.run(|| work(sender, own)));
        loop {
            let next = py.detach(|| {
                let receiver = receiver.lock().unwrap_or_else(PoisonError::into_inner);
                receiver.recv_timeout(GLANCE)
            });
            let message = match next {
                Ok(message) => Some(message),
                Err(RecvTimeoutError::Timeout) => None,
                Err(RecvTimeoutError::Disconnected) => break,
            };
            let look = || -> PyResult<()> {
                py.check_signals()?;
                if let (Some(message), Some(progress), false) = (message, progress, cancel.is_set())
                {
                    progress.call1(py, (message,))?;
                }
                Ok(())
            };
            if let Err(error) = look() {
                cancel.0.store(true, Ordering::Relaxed);
                raised.get_or_insert(error);
            }
        }
        py.detach(|| handle.join())
    });
    if let Some(error) = raised {
        return Err(error);
    }
    result.map_err(|_| PyRuntimeError::new_err("internal error of ertel; the message is above"))
}

/// As [`without_gil`], with an observer that sends each iteration where there is a `progress`.
fn observed<T: Send>(
    py: Python<'_>,
    progress: Option<&Py<PyAny>>,
    work: impl FnOnce(&mut Messages) -> T + Send,
) -> PyResult<T> {
    let wanted = progress.is_some();
    without_gil(py, progress, |sender, cancel| {
        work(&mut Messages {
            sender,
            wanted,
            cancel,
        })
    })
}

/// Sends each iteration as JSON.
struct Messages {
    sender: Sender<String>,
    wanted: bool,
    cancel: Cancel,
}

impl Messages {
    fn send(&self, message: serde_json::Value) {
        if self.wanted {
            // Nobody listens any more: the flag says so, too.
            let _ = self.sender.send(message.to_string());
        }
    }
}

impl Observer for Messages {
    fn level(&mut self, level: usize, n_levels: usize, n_pressure: usize, _n_displacement: usize) {
        self.send(serde_json::json!({
            "event": "stage", "stage": level + 1, "n_stages": n_levels, "pressure_unknowns": n_pressure,
        }));
    }

    fn iteration(&mut self, record: &IterationRecord) {
        if let (true, Ok(mut message)) = (self.wanted, serde_json::to_value(record)) {
            message["event"] = "iteration".into();
            self.send(message);
        }
    }

    fn round(&mut self, round: usize, change: f64, rise: f64) {
        self.send(serde_json::json!({
            "event": "heat", "round": round, "change": change, "temperature_rise": rise,
        }));
    }

    fn cancelled(&self) -> bool {
        self.cancel.is_set()
    }
}

impl InstantObserver for Messages {
    fn instant(&mut self, reached: &Reached) {
        self.send(serde_json::json!({
            "event": "instant", "time": reached.time, "duration": reached.duration, "steps": reached.steps,
            "film_central": reached.film_central,
        }));
    }
}

impl CurveObserver for Messages {
    fn point(&mut self, index: usize, n_points: usize, label: &str) {
        self.send(serde_json::json!({
            "event": "point", "point": index + 1, "n_points": n_points, "label": label,
        }));
    }

    fn reached(&mut self, reached: &Reached) {
        self.instant(reached);
    }
}

/// Solves a case; `start` is the solution of a similar one.
#[pyfunction]
#[pyo3(signature = (case, progress=None, start=None))]
pub fn solve(
    py: Python<'_>,
    case: &NativeCase,
    progress: Option<Py<PyAny>>,
    start: Option<&NativeSolution>,
) -> PyResult<NativeSolution> {
    let single = case.single();
    let start = start.and_then(NativeSolution::start);
    let solved = observed(py, progress.as_ref(), |messages| {
        run::solve_from(&single, start.as_deref(), messages)
    })?;
    let (solution, start) = solved.map_err(errors::solve)?;
    Ok(NativeSolution::new(&single, solution, Some(start)))
}

/// Solves the points of a curve.
#[pyfunction]
#[pyo3(signature = (case, progress=None))]
pub fn solve_curve(
    py: Python<'_>,
    case: &NativeCase,
    progress: Option<Py<PyAny>>,
) -> PyResult<NativeCurve> {
    let Some(curve) = &case.case.curve else {
        return Err(errors::CaseError::new_err("the case has no [curve]"));
    };
    let solution = observed(py, progress.as_ref(), |messages| run_curve(curve, messages))?;
    let document = ertel::output::curve_json(&case.case.echo(), &solution);
    let document = json(&document.map_err(crate::case::unwritable)?)?;
    Ok(NativeCurve::new(&case.case, curve, solution, document))
}

/// Solves a case in time.
#[pyfunction]
#[pyo3(signature = (case, progress=None))]
pub fn solve_transient(
    py: Python<'_>,
    case: &NativeCase,
    progress: Option<Py<PyAny>>,
) -> PyResult<NativeTransient> {
    if case.case.transient.is_none() {
        return Err(errors::CaseError::new_err("the case has no [transient]"));
    }
    let found = observed(py, progress.as_ref(), |messages| {
        run::transient::solve(&case.case, messages)
    })?;
    if let (Some(failure), true) = (&found.failure, found.instants.is_empty()) {
        return Err(errors::ConvergenceError::new_err(failure.to_string()));
    }
    NativeTransient::new(&case.case, found)
}

/// Solves the contacts of a machine.
#[pyfunction]
#[pyo3(signature = (case, progress=None))]
pub fn solve_machine(
    py: Python<'_>,
    case: &NativeCase,
    progress: Option<Py<PyAny>>,
) -> PyResult<NativeMachine> {
    if case.case.contacts.is_none() {
        return Err(errors::CaseError::new_err("the case is no whole machine"));
    }
    let solved = observed(py, progress.as_ref(), |messages| {
        solve_in_balance(&case.case, messages)
    })?;
    let solved = solved.map_err(errors::input)?;
    match solved {
        Some(solved) => NativeMachine::new(&solved.case, solved.solution),
        None => Err(errors::CaseError::new_err("the case is no whole machine")),
    }
}
