//! Shared by the benches: a stopwatch on the solver's observer.

pub use clock::{Clock, Seconds};
use ertel::engine::Observer;
use ertel::solution::IterationRecord;

mod clock;

/// Record of a stage.
#[derive(Clone, Debug, Default)]
pub struct StageTimes {
    pub n_pressure: usize,
    pub n_displacement: usize,
    /// Of each Newton iteration but the first, which includes the set-up.
    pub iterations: Vec<Seconds>,
}

impl StageTimes {
    /// Mean of the iterations.
    pub fn per_iteration(&self) -> Seconds {
        let n = self.iterations.len() as f64;
        Seconds {
            wall: self.iterations.iter().map(|s| s.wall).sum::<f64>() / n,
            cpu: self.iterations.iter().map(|s| s.cpu).sum::<f64>() / n,
        }
    }
}

/// Takes the time of every Newton iteration; stops the solve after so many of them.
#[derive(Default)]
pub struct Stopwatch {
    pub stages: Vec<StageTimes>,
    pub stop_after: Option<usize>,
    last: Option<Clock>,
    n: usize,
}

impl Stopwatch {
    pub fn stopping_after(n: usize) -> Stopwatch {
        Stopwatch {
            stop_after: Some(n),
            ..Stopwatch::default()
        }
    }
}

impl Observer for Stopwatch {
    fn level(&mut self, _level: usize, _n: usize, n_pressure: usize, n_displacement: usize) {
        self.last = None;
        self.stages.push(StageTimes {
            n_pressure,
            n_displacement,
            iterations: Vec::new(),
        });
    }

    fn iteration(&mut self, _record: &IterationRecord) {
        if let (Some(clock), Some(stage)) = (self.last, self.stages.last_mut()) {
            stage.iterations.push(clock.seconds());
        }
        self.last = Some(Clock::start());
        self.n += 1;
    }

    fn cancelled(&self) -> bool {
        self.stop_after.is_some_and(|limit| self.n >= limit)
    }
}
