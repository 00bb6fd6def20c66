//! Progress of the points of a study on stderr.

use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use ertel::sweep::{SweepObserver, SweepProgress};
use ertel::words::{digits, length};
use ertel_input::escaped;
use indicatif::{ProgressBar, ProgressStyle};
use serde_json::json;

use crate::events::Events;
use crate::print;

/// Points on stderr as they are finished: a bar in a terminal, a line per point elsewhere.
pub struct Progress<'a> {
    quiet: bool,
    /// Whether a terminal has a line for each point, too.
    in_lines: bool,
    events: Option<&'a Events>,
    bar: Mutex<Option<ProgressBar>>,
    cancelled: &'a AtomicBool,
}

impl<'a> Progress<'a> {
    pub fn new(quiet: bool, cancelled: &'a AtomicBool) -> Self {
        Self {
            quiet,
            in_lines: false,
            events: None,
            bar: Mutex::new(None),
            cancelled,
        }
    }

    /// Progress as events for programs.
    pub fn as_events(events: &'a Events, cancelled: &'a AtomicBool) -> Self {
        let mut progress = Self::new(true, cancelled);
        progress.events = Some(events);
        progress
    }

    /// Progress with a line for each point in terminals, too.
    pub fn in_lines(cancelled: &'a AtomicBool) -> Self {
        let mut progress = Self::new(false, cancelled);
        progress.in_lines = true;
        progress
    }

    fn bar(&self) -> std::sync::MutexGuard<'_, Option<ProgressBar>> {
        self.bar
            .lock()
            .unwrap_or_else(std::sync::PoisonError::into_inner)
    }
}

impl Drop for Progress<'_> {
    fn drop(&mut self) {
        if let Some(bar) = self.bar().take() {
            bar.finish_and_clear();
        }
    }
}

impl SweepObserver for Progress<'_> {
    fn begin(&self, n_points: usize, n_kept: usize) {
        use std::io::IsTerminal;
        if self.quiet {
            return;
        }
        if n_kept > 0 {
            print::stderr(&format!(
                "{n_kept} of {n_points} points are finished already"
            ));
        }
        if std::io::stderr().is_terminal() && !self.in_lines {
            let bar = ProgressBar::new(n_points as u64);
            if let Ok(style) =
                ProgressStyle::with_template("{elapsed} {bar:30} {pos}/{len} points, {wide_msg}")
            {
                bar.set_style(style);
            }
            bar.set_position(n_kept as u64);
            bar.set_message("the first points");
            bar.enable_steady_tick(Duration::from_millis(200));
            *self.bar() = Some(bar);
        }
    }

    fn finished(&self, progress: &SweepProgress<'_>) {
        if let Some(events) = self.events {
            let record = progress.record;
            let number = |name: &str| record.field(name).and_then(|v| v.parse::<f64>().ok());
            events.emit(
                "point",
                json!({
                    "point": progress.index + 1,
                    "values": progress.label,
                    "converged": record.converged,
                    "reason": if record.converged { None } else { Some(&record.reason) },
                    "film_central": number("film_central_m"),
                    "film_minimum": number("film_minimum_m"),
                    "film_minimum_lowest": number("film_minimum_lowest_m"),
                    "traction_coefficient": number("traction_coefficient"),
                    "wall_seconds": record.seconds,
                    "finished": progress.n_finished,
                    "points": progress.n_points,
                    "seconds_left": progress.seconds_left,
                }),
            );
        }
        if self.quiet {
            return;
        }
        let record = progress.record;
        let film = |name: &str| {
            record
                .field(name)
                .and_then(|value| value.parse::<f64>().ok())
        };
        let outcome = match (film("film_central_m"), film("film_minimum_lowest_m")) {
            (Some(film), _) => format!("central film {}", length(film)),
            (None, Some(film)) => format!("lowest minimum film {}", length(film)),
            (None, None) => format!("failed: {}", record.reason),
        };
        let left = match progress.n_finished == progress.n_points {
            true => String::new(),
            false => format!("; about {} left", duration(progress.seconds_left)),
        };
        match &*self.bar() {
            Some(bar) => {
                bar.set_position(progress.n_finished as u64);
                let left = left.trim_start_matches("; ");
                let message = format!("{left}: {}, {outcome}", progress.label);
                bar.set_message(escaped(&message).into_owned());
            }
            None => print::stderr(&format!(
                "{}/{}: point {} ({}), {outcome}, {} s{left}",
                progress.n_finished,
                progress.n_points,
                progress.index + 1,
                progress.label,
                digits(record.seconds, 2),
            )),
        }
    }

    fn cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Relaxed)
    }
}

/// `40 s`, `12 min`, `3.5 h`.
fn duration(seconds: f64) -> String {
    match seconds {
        s if s < 100.0 => format!("{s:.0} s"),
        s if s < 6000.0 => format!("{:.0} min", s / 60.0),
        s => format!("{:.1} h", s / 3600.0),
    }
}
