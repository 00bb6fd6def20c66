//! Points in the order of a plan, each with the result of the point that it starts from.
//!
//! A curve walks its chain on the thread that asks for it, a study its tree on many threads.

use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};

use super::plan::Plan;

/// A walk over the points of a plan; `E` is the result that a point passes to those that start from it.
pub(crate) struct Walk<E> {
    /// Number of points that are solved, for their own sake or because others start from them.
    pub(crate) n_needed: usize,
    /// Place of each point in the order.
    places: Vec<usize>,
    /// Needed points that start from each point.
    children: Vec<Vec<usize>>,
    state: Mutex<State<E>>,
    bell: Condvar,
}

struct State<E> {
    /// Points that may be solved by their place, with what they start from.
    ready: BTreeMap<usize, (usize, E)>,
    n_running: usize,
    stopped: bool,
}

impl<E: Clone + Default> Walk<E> {
    /// A walk to the points `wanted`, and to those that they start from.
    pub(crate) fn new(plan: &Plan, wanted: &[bool]) -> Walk<E> {
        let n = plan.order.len();
        let mut needed = wanted.to_vec();
        let mut places = vec![0; n];
        let mut children = vec![Vec::new(); n];
        let mut ready = BTreeMap::new();
        for (place, i) in plan.order.iter().enumerate().rev() {
            places[*i] = place;
            match plan.parents[*i].filter(|_| needed[*i]) {
                Some(parent) => {
                    needed[parent] = true;
                    children[parent].push(*i);
                }
                None if needed[*i] => drop(ready.insert(place, (*i, E::default()))),
                None => {}
            }
        }
        Walk {
            n_needed: needed.iter().filter(|needed| **needed).count(),
            places,
            children,
            state: Mutex::new(State {
                ready,
                n_running: 0,
                stopped: false,
            }),
            bell: Condvar::new(),
        }
    }

    /// Solves points until there are none, or one of them stops the walk for all threads; `solve` gets a point and what it
    /// starts from, and returns what others start from. The first of the points that are ready is next.
    ///
    /// # Errors
    /// That of `solve`.
    pub(crate) fn run<R>(&self, mut solve: impl FnMut(usize, E) -> Result<E, R>) -> Result<(), R> {
        while let Some((index, start)) = self.next() {
            let end = catch_unwind(AssertUnwindSafe(|| solve(index, start)));
            let mut state = self.lock();
            state.n_running -= 1;
            match &end {
                Ok(Ok(end)) => {
                    for i in &self.children[index] {
                        state.ready.insert(self.places[*i], (*i, end.clone()));
                    }
                }
                _ => state.stopped = true,
            }
            drop(state);
            self.bell.notify_all();
            end.unwrap_or_else(|panic| resume_unwind(panic))?;
        }
        Ok(())
    }

    /// The next point with what it starts from; waits while others may make one ready.
    fn next(&self) -> Option<(usize, E)> {
        let mut state = self.lock();
        while !state.stopped {
            if let Some((_, point)) = state.ready.pop_first() {
                state.n_running += 1;
                return Some(point);
            }
            if state.n_running == 0 {
                break;
            }
            state = (self.bell.wait(state)).unwrap_or_else(PoisonError::into_inner);
        }
        None
    }
}

impl<E> Walk<E> {
    /// No point begins any more.
    pub(crate) fn stop(&self) {
        self.lock().stopped = true;
        self.bell.notify_all();
    }

    /// Points that are being solved.
    pub(crate) fn n_running(&self) -> usize {
        self.lock().n_running
    }

    /// Whether the walk has been stopped.
    pub(crate) fn is_stopped(&self) -> bool {
        self.lock().stopped
    }

    fn lock(&self) -> MutexGuard<'_, State<E>> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 0 leads to 1 and 3, 1 leads to 2.
    fn tree() -> Plan {
        Plan {
            parents: vec![None, Some(0), Some(1), Some(0)],
            ..Plan::chain(4)
        }
    }

    /// Points in the order in which they are solved, each with all that lead to it.
    fn paths(walk: &Walk<Vec<usize>>) -> Vec<(usize, Vec<usize>)> {
        let mut paths = Vec::new();
        let end = walk.run(|index, mut path| {
            paths.push((index, path.clone()));
            path.push(index);
            Ok::<_, ()>(path)
        });
        assert_eq!(end, Ok(()));
        paths
    }

    #[test]
    fn each_point_gets_the_end_of_the_one_it_starts_from() {
        let walk = Walk::new(&Plan::chain(3), &[true; 3]);
        let chain = [(0, vec![]), (1, vec![0]), (2, vec![0, 1])];
        assert_eq!(paths(&walk), chain);
        let walk = Walk::new(&tree(), &[true; 4]);
        let all = [(0, vec![]), (1, vec![0]), (2, vec![0, 1]), (3, vec![0])];
        assert_eq!(paths(&walk), all);
    }

    #[test]
    fn only_wanted_points_and_their_starts_are_solved() {
        let walk = Walk::new(&tree(), &[false, false, false, true]);
        assert_eq!(walk.n_needed, 2);
        assert_eq!(paths(&walk), [(0, vec![]), (3, vec![0])]);
    }

    #[test]
    fn a_point_that_stops_is_the_last() {
        let walk = Walk::<()>::new(&Plan::chain(5), &[true; 5]);
        let mut solved = Vec::new();
        let end = walk.run(|index, ()| {
            solved.push(index);
            if index < 2 { Ok(()) } else { Err("stop") }
        });
        assert_eq!((end, solved), (Err("stop"), vec![0, 1, 2]));
        assert!(walk.is_stopped());
    }

    /// However many threads there are, each point is solved once and after the one it starts from.
    #[test]
    fn threads_share_the_points() {
        let n = 200;
        let plan = Plan {
            parents: (0..n)
                .map(|i: usize| i.checked_sub(1).map(|i| i / 2))
                .collect(),
            ..Plan::chain(n)
        };
        let walk = Walk::<Option<usize>>::new(&plan, &vec![true; n]);
        let solved = Mutex::new(Vec::new());
        std::thread::scope(|scope| {
            for _ in 0..4 {
                scope.spawn(|| {
                    walk.run(|index, from| {
                        assert_eq!(from, plan.parents[index]);
                        solved.lock().unwrap().push(index);
                        Ok::<_, ()>(Some(index))
                    })
                });
            }
        });
        let solved = solved.into_inner().unwrap();
        let place = |i: usize| solved.iter().position(|s| *s == i).unwrap();
        assert_eq!(solved.len(), n);
        for (i, parent) in plan.parents.iter().enumerate() {
            assert!(parent.is_none_or(|parent| place(parent) < place(i)));
        }
    }
}
