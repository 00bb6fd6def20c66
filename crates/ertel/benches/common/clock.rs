//! Wall and CPU time.

use std::time::Instant;

use cpu_time::ProcessTime;

/// Wall and CPU seconds.
#[derive(Clone, Copy, Debug, Default)]
pub struct Seconds {
    pub wall: f64,
    pub cpu: f64,
}

/// A running clock.
#[derive(Clone, Copy)]
pub struct Clock {
    wall: Instant,
    cpu: ProcessTime,
}

impl Clock {
    pub fn start() -> Clock {
        Clock {
            wall: Instant::now(),
            cpu: ProcessTime::now(),
        }
    }

    pub fn seconds(&self) -> Seconds {
        Seconds {
            wall: self.wall.elapsed().as_secs_f64(),
            cpu: self.cpu.elapsed().as_secs_f64(),
        }
    }
}
