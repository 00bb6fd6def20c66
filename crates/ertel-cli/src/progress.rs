//! Progress on stderr while the solver runs: one line that changes in a terminal, a line per iteration elsewhere.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use ertel::engine::Observer;
use ertel::output::{self};
use ertel::run::checkpoint::Checkpoint;
use ertel::run::transient::{InstantObserver, Reached};
use ertel::solution::IterationRecord;
use ertel::study::{CurveObserver, PointSolution};
use ertel::warning::{Warning, WarningKind};
use ertel::words::{digits, length};
use ertel_input::escaped;
use indicatif::{ProgressBar, ProgressStyle};

use serde_json::{Value, json};

use crate::checkpoint::Checkpoints;
use crate::events::Events;
use crate::print;

/// Shows the iterations and passes a stop request to the solver.
pub struct Progress<'a> {
    display: Display<'a>,
    cancelled: &'a AtomicBool,
    /// Which point of a curve is being solved; empty outside of curves.
    point: String,
    level: String,
    checkpoints: Checkpoints,
}

enum Display<'a> {
    Quiet,
    Lines,
    Terminal(ProgressBar),
    Events(&'a Events),
}

impl<'a> Progress<'a> {
    /// Progress that stops the solver once `cancelled` is set.
    pub fn new(quiet: bool, cancelled: &'a AtomicBool) -> Self {
        let display = if quiet {
            Display::Quiet
        } else if console_is_terminal() {
            let bar = ProgressBar::new_spinner();
            if let Ok(style) = ProgressStyle::with_template("{spinner} {elapsed} {wide_msg}") {
                bar.set_style(style);
            }
            bar.set_message("building the mesh and the elastic operator");
            bar.enable_steady_tick(Duration::from_millis(100));
            Display::Terminal(bar)
        } else {
            Display::Lines
        };
        Self::of(display, cancelled)
    }

    fn of(display: Display<'a>, cancelled: &'a AtomicBool) -> Self {
        Self {
            display,
            cancelled,
            point: String::new(),
            level: String::new(),
            checkpoints: Checkpoints::default(),
        }
    }

    /// Keeps checkpoints in a file.
    pub fn keep(&mut self, checkpoints: Checkpoints) {
        self.checkpoints = checkpoints;
    }

    /// Returns the checkpoints.
    pub fn kept(&mut self) -> Checkpoints {
        std::mem::take(&mut self.checkpoints)
    }

    /// Progress as events for programs.
    pub fn as_events(events: &'a Events, cancelled: &'a AtomicBool) -> Self {
        Self::of(Display::Events(events), cancelled)
    }

    /// Progress with a line for each iteration in terminals, too.
    pub fn in_lines(cancelled: &'a AtomicBool) -> Self {
        Self::of(Display::Lines, cancelled)
    }

    fn emit(&self, event: &str, fields: Value) {
        if let Display::Events(events) = &self.display {
            events.emit(event, fields);
        }
    }

    /// Shows a warning of the run at once.
    fn warn(&self, warning: &Warning) {
        let show = || print::warn([warning]);
        match &self.display {
            Display::Quiet | Display::Lines => show(),
            Display::Terminal(bar) => bar.suspend(show),
            Display::Events(events) => events.warn([warning]),
        }
    }

    fn show(&self, line: String) {
        match &self.display {
            Display::Quiet => {}
            Display::Lines => print::stderr(&line),
            Display::Events(_) => {}
            Display::Terminal(bar) => bar.set_message(escaped(&line).into_owned()),
        }
    }
}

impl Drop for Progress<'_> {
    fn drop(&mut self) {
        if let Display::Terminal(bar) = &self.display {
            bar.finish_and_clear();
        }
    }
}

impl Observer for Progress<'_> {
    fn level(&mut self, level: usize, n_levels: usize, n_pressure: usize, n_displacement: usize) {
        self.emit(
            "stage",
            json!({
                "stage": level + 1,
                "stages": n_levels,
                "pressure_unknowns": n_pressure,
                "displacement_unknowns": n_displacement,
            }),
        );
        // Refinement decides how many there are beyond those of the path.
        let of = match level + 1 < n_levels {
            true => format!("/{n_levels}"),
            false => String::new(),
        };
        self.level = format!("{}stage {}{of}", self.point, level + 1);
        self.show(format!(
            "{}: {n_pressure} pressure and {n_displacement} displacement unknowns",
            self.level
        ));
    }

    fn grid(&mut self, grid: usize, n_pressure: usize) {
        self.emit(
            "stage",
            json!({
                "stage": grid + 1,
                "stages": grid + 1,
                "pressure_unknowns": n_pressure,
                "displacement_unknowns": 0,
            }),
        );
        self.level = format!("{}grid {}", self.point, grid + 1);
        self.show(format!("{}: {n_pressure} pressure unknowns", self.level));
    }

    fn iteration(&mut self, record: &IterationRecord) {
        self.emit("iteration", json!(record));
        self.show(format!(
            "{}, Newton {:>2}: film {}, residual {:.1e}, update {:.1e}, step {:.2}",
            self.level,
            record.iteration,
            length(record.film_central),
            record.residual,
            record.update,
            record.step,
        ));
    }

    fn round(&mut self, round: usize, change: f64, rise: f64) {
        self.emit(
            "heat",
            json!({ "round": round, "change": change, "temperature_rise": rise }),
        );
        self.show(format!(
            "{}, heat {round:>2}: change {change:.1e}, temperature rise {rise:.2} K",
            self.level
        ));
    }

    fn cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Relaxed)
    }
}

impl InstantObserver for Progress<'_> {
    fn instant(&mut self, reached: &Reached) {
        self.emit(
            "instant",
            json!({
                "time": reached.time,
                "duration": reached.duration,
                "steps": reached.steps,
                "film_central": reached.film_central,
            }),
        );
        let left = match reached.seconds_left {
            left if left.is_finite() && reached.time < reached.duration => {
                format!(", about {} s left", digits(left, 2))
            }
            _ => String::new(),
        };
        self.show(format!(
            "{}step {}: {} of {} s, central film {}{left}",
            self.point,
            reached.steps,
            digits(reached.time, 4),
            digits(reached.duration, 4),
            length(reached.film_central)
        ));
    }

    fn wants_checkpoint(&self) -> bool {
        self.checkpoints.is_due()
    }

    fn checkpoint(&mut self, checkpoint: Checkpoint) {
        if let Some(failure) = self.checkpoints.write(&checkpoint) {
            let text = format!("the checkpoint cannot be written: {failure}; the run continues");
            self.warn(&Warning::new(WarningKind::Checkpoint, text));
        }
    }
}

impl CurveObserver for Progress<'_> {
    fn point(&mut self, index: usize, n_points: usize, value: &str) {
        self.emit(
            "point_started",
            json!({ "point": index + 1, "points": n_points, "value": value }),
        );
        let point = format!("point {}/{n_points} ({value})", index + 1);
        self.point = format!("{point}, ");
        // Contacts of a machine on several threads show no more than this.
        self.show(point);
    }

    fn reached(&mut self, reached: &Reached) {
        self.instant(reached);
    }

    fn finished(&mut self, index: usize, point: &PointSolution) {
        if !matches!(self.display, Display::Events(_)) {
            return;
        }
        let Ok(mut json) = output::point_json(index, point) else {
            return;
        };
        if let Some(keys) = json.as_object_mut() {
            // `seconds` of an event are those since the start.
            let seconds = keys.remove("seconds").unwrap_or_default();
            keys.insert("wall_seconds".to_owned(), seconds);
        }
        self.emit("point", json);
    }
}

fn console_is_terminal() -> bool {
    use std::io::IsTerminal;
    std::io::stderr().is_terminal()
}
