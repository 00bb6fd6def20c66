//! Which point is next.

use std::collections::{BTreeSet, HashMap};
use std::sync::Arc;

use super::SweepError;
use crate::run::Start;
use crate::study::plan::Plan;

/// Points that wait, by their place in the plan's order, and the ends that others start from.
pub(super) struct Queue {
    /// Points to be solved, for their own sake or because others start from them.
    needed: Vec<bool>,
    pub(super) n_needed: usize,
    /// Place of each point in the order.
    place: Vec<usize>,
    /// Needed points that start from each point.
    children: Vec<Vec<usize>>,
    ready: BTreeSet<(usize, usize)>,
    /// What each ready or running point starts from.
    starts: HashMap<usize, Option<Arc<Start>>>,
    n_running: usize,
    pub(super) n_again: usize,
    pub(super) stopped: bool,
    pub(super) error: Option<SweepError>,
}

impl Queue {
    pub(super) fn new(plan: &Plan, wanted: &[bool]) -> Queue {
        let n = plan.order.len();
        let mut needed = wanted.to_vec();
        let mut place = vec![0; n];
        let mut children = vec![Vec::new(); n];
        for (position, i) in plan.order.iter().enumerate().rev() {
            place[*i] = position;
            if let (true, Some(parent)) = (needed[*i], plan.parents[*i]) {
                needed[parent] = true;
                children[parent].push(*i);
            }
        }
        let roots = (0..n).filter(|i| needed[*i] && plan.parents[*i].is_none());
        let ready: BTreeSet<_> = roots.map(|i| (place[i], i)).collect();
        Queue {
            n_needed: needed.iter().filter(|n| **n).count(),
            starts: ready.iter().map(|(_, i)| (*i, None)).collect(),
            needed,
            place,
            children,
            ready,
            n_running: 0,
            n_again: 0,
            stopped: false,
            error: None,
        }
    }

    pub(super) fn stop(&mut self, error: Option<SweepError>) {
        self.stopped = true;
        if self.error.is_none() {
            self.error = error;
        }
    }

    /// The first ready point with what it starts from; it is then running.
    pub(super) fn take(&mut self) -> Option<(usize, Option<Arc<Start>>)> {
        let (_, index) = self.ready.pop_first()?;
        self.n_running += 1;
        Some((index, self.starts.remove(&index).flatten()))
    }

    /// Whether no point is ready, nor running and so about to make others ready.
    pub(super) fn is_over(&self) -> bool {
        self.ready.is_empty() && self.n_running == 0
    }

    /// A point is done; those that start from it are ready.
    pub(super) fn done(&mut self, index: usize, end: Option<Arc<Start>>) {
        debug_assert!(self.needed[index]);
        self.n_running -= 1;
        for child in std::mem::take(&mut self.children[index]) {
            self.starts.insert(child, end.clone());
            self.ready.insert((self.place[child], child));
        }
    }
}
