//! Which elements are halved to bring errors down.

use crate::solve::tuning::refinement::{CLOSURE, MOST_HALVINGS};

/// An error that refinement reduces: shares of the elements that add up to the error, or to its square.
pub struct Goal<'a> {
    /// Share of each element.
    pub shares: &'a [f64],
    /// Allowed sum after refinement.
    pub allowed: f64,
    /// Expected ratio of the share of an element after halving it to that before.
    pub ratio: f64,
}

/// Halvings of each element of a `dim`-dimensional contact area that are expected to bring every goal down to what it allows, the
/// largest shares first, until there are about `max_growth` times as many elements.
pub fn halvings(goals: &[Goal], dim: usize, max_growth: f64) -> Vec<u32> {
    let n = goals.first().map_or(0, |g| g.shares.len());
    let children = (1u64 << dim) as f64;
    let mut room = (max_growth - 1.0) / CLOSURE * n as f64;
    let mut totals: Vec<f64> = goals.iter().map(|g| g.shares.iter().sum()).collect();
    let mut halvings = vec![0; n];
    let share = |g: &Goal, c: usize, n: u32| g.ratio.powi(n as i32) * g.shares[c];
    // Largest shares first, in units of what is allowed.
    let weigh = |c: usize, n: u32| {
        goals
            .iter()
            .map(|g| share(g, c, n) / g.allowed)
            .fold(0.0, f64::max)
    };
    let mut heap: std::collections::BinaryHeap<Candidate> = (0..n)
        .map(|c| Candidate {
            weight: weigh(c, 0),
            element: c,
        })
        .collect();
    let is_off = |totals: &[f64], j: usize| totals[j] > goals[j].allowed;
    while room > 0.0 && (0..goals.len()).any(|j| is_off(&totals, j)) {
        let Some(Candidate { element, .. }) = heap.pop() else {
            break;
        };
        let n = halvings[element];
        // No use for what is still off.
        let of_use = |j: usize| {
            let least = 1e-3 * goals[j].allowed / halvings.len() as f64;
            is_off(&totals, j) && share(&goals[j], element, n) > least
        };
        if !(0..goals.len()).any(of_use) {
            continue;
        }
        for (total, goal) in totals.iter_mut().zip(goals) {
            *total -= share(goal, element, n) - share(goal, element, n + 1);
        }
        halvings[element] = n + 1;
        room -= (children - 1.0) * children.powi(n as i32);
        if n + 1 < MOST_HALVINGS {
            heap.push(Candidate {
                weight: weigh(element, n + 1),
                element,
            });
        }
    }
    halvings
}

/// An element by the weight of its share.
struct Candidate {
    weight: f64,
    element: usize,
}

impl Ord for Candidate {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        // ties by number: the same mesh on every run
        self.weight
            .total_cmp(&other.weight)
            .then(other.element.cmp(&self.element))
    }
}

impl PartialOrd for Candidate {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Candidate {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Candidate {}

#[cfg(test)]
mod tests {
    use super::*;

    /// Shares 8, 1, 1, 0 of an estimate that is to fall to 5: the first halved once leaves 2 + 1 + 1. To fall to 2.6 it is halved
    /// twice, 0.5 + 1 + 1; and to 2.3 the next goes, too.
    #[test]
    fn largest_shares_are_halved_first() {
        let halved = |allowed| {
            let goal = Goal {
                shares: &[8.0, 1.0, 1.0, 0.0],
                allowed,
                ratio: 0.25,
            };
            halvings(&[goal], 1, 100.0)
        };
        assert_eq!(halved(5.0), [1, 0, 0, 0]);
        assert_eq!(halved(2.6), [2, 0, 0, 0]);
        assert_eq!(halved(2.3).iter().sum::<u32>(), 3);
        assert_eq!(halved(2.3)[0], 2);
        // A goal out of reach ends at the most halvings.
        assert_eq!(halved(1e-9)[3], 0);
    }

    /// Four elements become eight where closure may add half as many as are asked for.
    #[test]
    fn growth_ends_at_its_limit() {
        let goal = Goal {
            shares: &[1.0; 30],
            allowed: 1e-9,
            ratio: 0.5,
        };
        let growth = 2.0;
        let halvings = halvings(&[goal], 2, growth);
        let added: u32 = halvings.iter().map(|h| 4_u32.pow(*h) - 1).sum();
        let most = (growth - 1.0) * 30.0 / CLOSURE;
        assert!(f64::from(added) >= most && f64::from(added) < most + 12.0);
    }
}
