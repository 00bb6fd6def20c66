//! Observers of a solve.

use crate::solution::IterationRecord;

/// Follows a solve; every method has a default that does nothing.
///
/// Threads of the solver ask it whether to stop.
pub trait Observer: Send + Sync {
    /// A new stage begins.
    fn level(
        &mut self,
        _level: usize,
        _n_levels: usize,
        _n_pressure: usize,
        _n_displacement: usize,
    ) {
    }

    /// A new grid of finite volumes begins, counted from 0.
    fn grid(&mut self, grid: usize, n_pressure: usize) {
        self.level(grid, grid + 1, n_pressure, 0);
    }

    /// A Newton iteration ended.
    fn iteration(&mut self, _record: &IterationRecord) {}

    /// A round of the coupling of film and heat ended: the largest relative change of temperature rise, pressure and
    /// film, and the largest rise, K.
    fn round(&mut self, _round: usize, _change: f64, _rise: f64) {}

    /// Whether the user wants to stop; asked before each stage, between the fronts of a factorisation of the
    /// bodies, and before each linear solve.
    fn cancelled(&self) -> bool {
        false
    }
}

/// Observes nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoObserver;

impl Observer for NoObserver {}
