//! Watches an input being read: time and memory, and where a panic came from.

use std::fs;
use std::panic;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use cpu_time::ProcessTime;

use crate::finding::{Defect, Kind};

/// Resident memory that no input may need, bytes.
pub const MEMORY_LIMIT: u64 = 500_000_000;
/// Wall seconds over CPU seconds from which an input that waits for something is a hang, too.
const WAITING: f64 = 15.0;
/// How often it looks.
const PERIOD: Duration = Duration::from_millis(20);

/// The input being read.
#[derive(Clone, Copy, Debug)]
struct Current {
    wall: Instant,
    cpu: ProcessTime,
    limit: f64,
}

/// A thread that looks after the one that reads.
#[derive(Clone, Debug, Default)]
pub struct Watch {
    current: Arc<Mutex<Option<Current>>>,
}

impl Watch {
    /// Starts it; `act` is called with a hang, or with memory beyond the limit, and should end the process.
    pub fn start(act: impl Fn(Defect) + Send + 'static) -> Watch {
        let watch = Watch::default();
        let current = Arc::clone(&watch.current);
        std::thread::spawn(move || {
            loop {
                std::thread::sleep(PERIOD);
                let now = *current.lock().unwrap_or_else(PoisonError::into_inner);
                let Some(now) = now else { continue };
                let (cpu, wall) = (
                    now.cpu.elapsed().as_secs_f64(),
                    now.wall.elapsed().as_secs_f64(),
                );
                let memory = resident().unwrap_or(0);
                if cpu > now.limit || wall > WAITING * now.limit {
                    act(Defect {
                        kind: Kind::Hang,
                        place: "time".to_owned(),
                        message: format!("{cpu:.1} CPU s, {wall:.1} s"),
                    });
                } else if memory > MEMORY_LIMIT {
                    act(too_much(memory));
                }
            }
        });
        watch
    }

    /// An input begins that may take `limit` CPU seconds.
    pub fn begin(&self, limit: f64) {
        let current = Current {
            wall: Instant::now(),
            cpu: ProcessTime::now(),
            limit,
        };
        *self.current.lock().unwrap_or_else(PoisonError::into_inner) = Some(current);
    }

    /// It is read: the CPU seconds that it took, of all threads.
    pub fn end(&self) -> f64 {
        let current = self
            .current
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .take();
        current.map_or(0.0, |current| current.cpu.elapsed().as_secs_f64())
    }
}

/// More memory than an input may take.
pub fn too_much(bytes: u64) -> Defect {
    Defect {
        kind: Kind::Memory,
        place: "memory".into(),
        message: format!("{:.0} MB", bytes as f64 / 1e6),
    }
}

/// Resident memory, bytes; on Linux alone.
fn resident() -> Option<u64> {
    let text = fs::read_to_string("/proc/self/statm").ok()?;
    let pages: u64 = text.split(' ').nth(1)?.parse().ok()?;
    Some(4096 * pages)
}

/// Most memory that was ever resident, bytes; on Linux alone.
pub fn peak() -> Option<u64> {
    let text = fs::read_to_string("/proc/self/status").ok()?;
    let line = text.lines().find(|line| line.starts_with("VmHWM:"))?;
    Some(1024 * line.split_whitespace().nth(1)?.parse::<u64>().ok()?)
}

static LAST_PANIC: Mutex<Option<Defect>> = Mutex::new(None);

/// Keeps what a panic says instead of printing it.
pub fn keep_panics() {
    panic::set_hook(Box::new(|info| {
        let place = info
            .location()
            .map_or_else(String::new, ToString::to_string);
        let payload = info.payload();
        let text = (payload.downcast_ref::<&str>().map(|s| (*s).to_owned()))
            .or_else(|| payload.downcast_ref::<String>().cloned())
            .unwrap_or_default();
        let message = format!("{place}: {text}");
        let defect = Defect {
            kind: Kind::Panic,
            place,
            message,
        };
        // The first one is the cause of others on other threads.
        LAST_PANIC
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .get_or_insert(defect);
    }));
}

/// The panic since the last call.
pub fn take_panic() -> Option<Defect> {
    LAST_PANIC
        .lock()
        .unwrap_or_else(PoisonError::into_inner)
        .take()
}
