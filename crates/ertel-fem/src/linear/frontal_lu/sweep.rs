//! A factorised matrix and its solves: down the fronts and up again.

use std::ops::RangeInclusive;
use std::sync::Arc;

use rayon::prelude::*;

use super::factorise::Left;
use super::factors::Factors;
use super::{FrontalError, FrontalPattern};
use crate::kernel;
use crate::linear::dense::vectorised;
use crate::linear::fronts::Front;

/// Work space of a pass over a run of fronts.
#[derive(Clone, Debug, Default)]
pub(super) struct Scratch {
    pub(super) outer: Vec<f32>,
    pub(super) own: Vec<f32>,
    /// Values beyond the run.
    pub(super) beyond: Vec<f32>,
}

impl FrontalLu {
    /// Down the fronts and up again; the parts on all cores.
    pub(super) fn sweep(&mut self, rhs: &mut [f64]) {
        let FrontalLu {
            pattern,
            factors,
            x,
            scratch,
        } = self;
        let (pattern, factors) = (&**pattern, &**factors);
        let fronts = &pattern.fronts;
        for (x, unknown) in x.iter_mut().zip(&fronts.order) {
            *x = rhs[*unknown as usize] as f32;
        }
        let (parts, above) = scratch.split_at_mut(pattern.parts.len());
        let above = &mut above[0];
        let roots = || pattern.parts.iter().map(|k| &fronts.fronts[*k]);
        let end = |f: &Front| f.first + f.n_own;
        let run = |fronts, base| Run {
            pattern,
            factors,
            fronts,
            base,
        };
        let down = |fronts: RangeInclusive<usize>, base, x: &mut [f32], scratch: &mut Scratch| {
            let run = run(fronts, base);
            vectorised(Down { run, x, scratch });
        };
        let up = |fronts: RangeInclusive<usize>, base, x: &mut [f32], scratch: &mut Scratch| {
            let run = run(fronts, base);
            vectorised(Up { run, x, scratch });
        };
        for (scratch, root) in parts.iter_mut().zip(roots()) {
            for s in &root.boundary {
                scratch.beyond[*s as usize - end(root)] = 0.0;
            }
        }
        pattern.on_parts(x, parts, down);
        for (scratch, root) in parts.iter().zip(roots()) {
            for s in &root.boundary {
                x[*s as usize] += scratch.beyond[*s as usize - end(root)];
            }
        }
        for range in &pattern.above {
            down(range.clone(), 0, x, above);
        }
        for range in pattern.above.iter().rev() {
            up(range.clone(), 0, x, above);
        }
        for (scratch, root) in parts.iter_mut().zip(roots()) {
            for s in &root.boundary {
                scratch.beyond[*s as usize - end(root)] = x[*s as usize];
            }
        }
        pattern.on_parts(x, parts, up);
        for (x, unknown) in x.iter().zip(&fronts.order) {
            rhs[*unknown as usize] = *x as f64;
        }
    }
}

impl FrontalPattern {
    /// Calls `f(fronts, first position, its positions of x, scratch)` for each part, on several threads.
    fn on_parts(
        &self,
        x: &mut [f32],
        scratch: &mut [Scratch],
        f: impl Fn(RangeInclusive<usize>, usize, &mut [f32], &mut Scratch) + Sync,
    ) {
        let mut rest = x;
        let mut from = 0;
        let mut tasks = Vec::with_capacity(scratch.len());
        for (root, scratch) in self.parts.iter().zip(scratch) {
            let front = &self.fronts.fronts[*root];
            let first = self.fronts.fronts[front.subtree].first;
            let end = front.first + front.n_own;
            let (own, beyond) = std::mem::take(&mut rest)[first - from..].split_at_mut(end - first);
            tasks.push((front.subtree..=*root, first, own, scratch));
            rest = beyond;
            from = end;
        }
        tasks
            .into_par_iter()
            .with_max_len(1)
            .for_each(|(fronts, first, own, scratch)| f(fronts, first, own, scratch));
    }
}

/// Consecutive fronts; the positions of the x that they work on begin at `base`.
struct Run<'a> {
    pattern: &'a FrontalPattern,
    factors: &'a Factors,
    fronts: RangeInclusive<usize>,
    base: usize,
}

kernel! {
    Down ['a] ['a] (run: Run<'a>, x: &'a mut [f32], scratch: &'a mut Scratch) -> () {
        run.down(x, scratch)
    }
}

kernel! {
    Up ['a] ['a] (run: Run<'a>, x: &'a mut [f32], scratch: &'a mut Scratch) -> () {
        run.up(x, scratch)
    }
}

impl Run<'_> {
    /// Eliminates: x_own ← A⁻¹ x_own, x_boundary −= V x_own.
    #[inline(always)]
    fn down(self, x: &mut [f32], scratch: &mut Scratch) {
        let base = self.base;
        let end = base + x.len();
        for k in self.fronts {
            let f = &self.pattern.fronts.fronts[k];
            let (n, m) = (f.n_own, f.boundary.len());
            let [inverse, v, _] = self.factors.of(self.pattern, k);
            let own = &mut scratch.own[..n];
            let outer = &mut scratch.outer[..m];
            let target = &mut x[f.first - base..f.first - base + n];
            own.copy_from_slice(target);
            v.multiply(own, outer);
            inverse.multiply(own, target);
            for (s, value) in f.boundary.iter().zip(&*outer) {
                match *s as usize {
                    s if s < end => x[s - base] -= value,
                    s => scratch.beyond[s - end] -= value,
                }
            }
        }
    }

    /// Substitutes back: x_own −= W x_boundary.
    #[inline(always)]
    fn up(self, x: &mut [f32], scratch: &mut Scratch) {
        let base = self.base;
        let end = base + x.len();
        for k in self.fronts.rev() {
            let f = &self.pattern.fronts.fronts[k];
            let (n, m) = (f.n_own, f.boundary.len());
            let [_, _, w] = self.factors.of(self.pattern, k);
            let own = &mut scratch.own[..n];
            let outer = &mut scratch.outer[..m];
            for (s, value) in f.boundary.iter().zip(outer.iter_mut()) {
                *value = match *s as usize {
                    s if s < end => x[s - base],
                    s => scratch.beyond[s - end],
                };
            }
            w.multiply(outer, own);
            for (x, value) in x[f.first - base..].iter_mut().zip(&*own) {
                *x -= value;
            }
        }
    }
}

/// A factorised matrix.
#[derive(Clone, Debug)]
pub struct FrontalLu {
    pattern: Arc<FrontalPattern>,
    pub(super) factors: Arc<Factors>,
    x: Vec<f32>,
    /// Scratch of each part, and of the fronts above them.
    scratch: Vec<Scratch>,
}

impl FrontalLu {
    /// Factorises the matrix whose entries, in the order of the pattern's list, are `values`; equal
    /// places add up.
    ///
    /// # Errors
    /// When a diagonal block is singular.
    pub fn new(pattern: &Arc<FrontalPattern>, values: &[f64]) -> Result<FrontalLu, FrontalError> {
        let mut storage = vec![0.0; pattern.n_stored()];
        let front =
            |k: usize, kept: &mut [f32], left: Vec<Left>| pattern.factorise(k, values, kept, left);
        pattern
            .fronts
            .eliminate(&pattern.starts, &mut storage, &front)?;
        let fronts = &pattern.fronts.fronts;
        let largest = |f: fn(&Front) -> usize| vec![0.0; fronts.iter().map(f).max().unwrap_or(0)];
        let scratch = |n_beyond: usize| Scratch {
            outer: largest(|f| f.boundary.len()),
            own: largest(|f| f.n_own),
            beyond: vec![0.0; n_beyond],
        };
        let below = pattern.parts.iter().map(|root| {
            let f = &fronts[*root];
            scratch(pattern.n() - f.first - f.n_own)
        });
        Ok(FrontalLu {
            pattern: Arc::clone(pattern),
            factors: Arc::new(Factors::new(storage)),
            x: vec![0.0; pattern.n()],
            scratch: below.chain([scratch(0)]).collect(),
        })
    }

    /// Solves in place, approximately.
    pub fn solve(&mut self, rhs: &mut [f64]) {
        self.sweep(rhs);
    }
}
