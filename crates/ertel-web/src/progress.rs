//! The solver's progress as messages.

use ertel::engine::Observer;
use ertel::run::transient::InstantObserver;
use ertel::solution::IterationRecord;
use ertel::study::CurveObserver;
use ertel::words::length;
use serde_json::{Value, json};

/// Hands on what the solver does. It cannot be stopped: a page ends the worker that it runs in.
pub(crate) struct Progress<F> {
    send: F,
}

impl<F: FnMut(Value) + Send + Sync> Progress<F> {
    pub fn new(send: F) -> Self {
        Self { send }
    }
}

impl<F: FnMut(Value) + Send + Sync> Observer for Progress<F> {
    fn level(&mut self, level: usize, n_levels: usize, n_pressure: usize, n_displacement: usize) {
        (self.send)(json!({
            "event": "stage",
            "stage": level + 1,
            "n_stages": n_levels,
            "pressure_unknowns": n_pressure,
            "displacement_unknowns": n_displacement,
        }));
    }

    fn iteration(&mut self, record: &IterationRecord) {
        (self.send)(json!({
            "event": "iteration",
            "iteration": record.iteration,
            "residual": record.residual,
            "update": record.update,
            "step": record.step,
            "film_central": record.film_central,
            "film_central_text": length(record.film_central),
        }));
    }

    fn round(&mut self, round: usize, change: f64, rise: f64) {
        (self.send)(json!({ "event": "heat", "round": round, "change": change, "rise": rise }));
    }
}

impl<F: FnMut(Value) + Send + Sync> InstantObserver for Progress<F> {}

impl<F: FnMut(Value) + Send + Sync> CurveObserver for Progress<F> {
    fn point(&mut self, index: usize, n_points: usize, value: &str) {
        (self.send)(json!({
            "event": "point",
            "point": index + 1,
            "n_points": n_points,
            "value": value,
        }));
    }
}
