//! The iterations of a solve.

use crate::engine::Observer;
use crate::solution::{HeatRound, IterationRecord};

/// Forwards everything and keeps the iterations.
pub(super) struct Recorder<'a> {
    pub observer: &'a mut dyn Observer,
    pub history: Vec<IterationRecord>,
}

impl Observer for Recorder<'_> {
    fn level(&mut self, level: usize, n_levels: usize, n_pressure: usize, n_displacement: usize) {
        self.observer
            .level(level, n_levels, n_pressure, n_displacement);
    }

    fn grid(&mut self, grid: usize, n_pressure: usize) {
        if grid == 0 {
            // A further solve of the same contact, as it wears: the last one counts.
            self.history.clear();
        }
        self.observer.grid(grid, n_pressure);
    }

    fn iteration(&mut self, record: &IterationRecord) {
        self.history.push(record.clone());
        self.observer.iteration(record);
    }

    fn round(&mut self, round: usize, change: f64, rise: f64) {
        if let Some(last) = self.history.last_mut() {
            last.heat = Some(HeatRound {
                change,
                temperature_rise: rise,
            });
        }
        self.observer.round(round, change, rise);
    }

    fn cancelled(&self) -> bool {
        self.observer.cancelled()
    }
}
