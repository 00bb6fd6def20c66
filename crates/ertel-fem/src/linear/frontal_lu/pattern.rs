//! Data shared by all matrices of one pattern: the fronts, the place of each entry in them, the parts of a solve.

use std::ops::RangeInclusive;

use crate::linear::fronts::{Blocks, Fronts};
use crate::linear::ordering::OrderingError;

/// Pattern of a matrix given as a list of entries, with its elimination order.
#[derive(Clone, Debug)]
pub struct FrontalPattern {
    pub(super) fronts: Fronts,
    /// For each front, entry of the list and index in the front's matrix (column-major).
    pub(super) scatter: Vec<Vec<(u32, u32)>>,
    /// Start of each front's A⁻¹, V, W in the storage; one more at the end.
    pub(super) starts: Vec<usize>,
    /// Roots of the subtrees that a solve deals to the cores.
    pub(super) parts: Vec<usize>,
    /// Ranges of the fronts above these.
    pub(super) above: Vec<RangeInclusive<usize>>,
}

impl FrontalPattern {
    /// Orders the unknowns of `blocks` and finds the place of each entry (row, column).
    ///
    /// # Errors
    /// When the ordering fails.
    ///
    /// # Panics
    /// When the groups of an entry are no neighbours in the graph of `blocks`.
    pub fn new(blocks: &Blocks, entries: &[(u32, u32)]) -> Result<FrontalPattern, OrderingError> {
        let fronts = Fronts::new(blocks)?;
        let owners = fronts.owners();
        let mut scatter = vec![Vec::new(); fronts.fronts.len()];
        for (k, (row, column)) in entries.iter().enumerate() {
            let row = fronts.position[*row as usize] as usize;
            let column = fronts.position[*column as usize] as usize;
            let owner = owners[row.min(column)] as usize;
            let front = &fronts.fronts[owner];
            let index = front.index_of(row) + front.size() * front.index_of(column);
            scatter[owner].push((k as u32, index as u32));
        }
        let mut starts = vec![0];
        for f in &fronts.fronts {
            let (n, m) = (f.n_own, f.boundary.len());
            starts.push(starts[starts.len() - 1] + n * (n + 2 * m));
        }
        let (parts, above) = parts(&fronts, &starts);
        Ok(FrontalPattern {
            fronts,
            scatter,
            starts,
            parts,
            above,
        })
    }

    /// Number of unknowns.
    pub fn n(&self) -> usize {
        self.fronts.order.len()
    }

    /// Numbers that a factorisation keeps.
    pub fn n_stored(&self) -> usize {
        self.starts[self.starts.len() - 1]
    }
}

/// Numbers of a factor below which a solve stays on one thread.
const SMALL: usize = 300_000;

/// Parts of a larger one, at most.
const PARTS: usize = 8;

/// Roots of disjoint subtrees of about the same cost, ascending, and the ranges of the fronts above them.
fn parts(fronts: &Fronts, starts: &[usize]) -> (Vec<usize>, Vec<RangeInclusive<usize>>) {
    let cost = |k: &usize| starts[k + 1] - starts[fronts.fronts[*k].subtree];
    let total = starts[starts.len() - 1];
    let mut parts: Vec<usize> = Vec::new();
    if total > SMALL {
        let mut open = fronts.roots.clone();
        while let Some(k) = open.pop() {
            if cost(&k) * PARTS <= total {
                if cost(&k) * 8 * PARTS > total {
                    parts.push(k);
                }
            } else {
                open.extend_from_slice(&fronts.fronts[k].children);
            }
        }
    }
    parts.sort_unstable();
    let mut above = Vec::new();
    let mut from = 0;
    for k in parts.iter().copied().chain([fronts.fronts.len()]) {
        let first = fronts.fronts.get(k).map_or(k, |f| f.subtree);
        if first > from {
            above.push(from..=first - 1);
        }
        from = k + 1;
    }
    (parts, above)
}
