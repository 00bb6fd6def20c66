//! Memory in which fronts are eliminated.

use std::sync::{Mutex, MutexGuard, PoisonError};

/// Rooms in which fronts are eliminated, used again and again: asking the system for memory would take a good part
/// of the time. Each has room for any front; the system gives what is used of it.
pub(super) struct Workspace {
    size: usize,
    rooms: Mutex<Vec<Vec<f64>>>,
}

impl Workspace {
    /// Rooms for so many numbers each.
    pub(super) fn new(size: usize) -> Workspace {
        Workspace {
            size,
            rooms: Mutex::default(),
        }
    }

    fn rooms(&self) -> MutexGuard<'_, Vec<Vec<f64>>> {
        self.rooms.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// A room, of whatever content.
    pub(super) fn take(&self) -> Vec<f64> {
        let used = self.rooms().pop();
        used.unwrap_or_else(|| vec![0.0; self.size])
    }

    pub(super) fn give(&self, room: Vec<f64>) {
        self.rooms().push(room);
    }
}
