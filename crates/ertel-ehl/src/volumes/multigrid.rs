//! Solution of the sparse film equation M w = r at a cost in proportion to its unknowns: a cycle over grids with nodes at twice the distance each.
//!
//! ```text
//!   w ← (L U)⁻¹ r            incomplete factors of M
//!   w ← w + P M_c⁻¹ R (r − M w),    M_c = R M P          P: linear between coarse nodes, R = ¼Pᵀ: balances add up
//!   w ← w + (L U)⁻¹ (r − M w)
//! ```
//! M_c⁻¹ is a cycle again, on the coarsest grid a factorisation. Coefficients change by ten decades from node to node; M_c as a product averages them
//! correctly, coefficients of the coarse grid do not. R takes the balances of the fine grid in their own units, so that those add up to that of the coarse
//! one, and rows P = 0 of the broken film for themselves (Trottenberg, Oosterlee and Schüller, Multigrid, 2001, chapters 2 and 7).

use std::sync::Arc;

use ertel_fem::linear::frontal_lu::{FrontalLu, FrontalPattern};
use ertel_fem::linear::ordering::OrderingError;

use super::rectangle;
use super::stencil::{Incomplete, Layout, Lines, residual};
use super::transfer::{Matrix, Transfer};

/// The rectangles of unknowns of a cycle.
pub struct Grids {
    /// Each but the coarsest, and where the next one begins on it.
    finer: Vec<(Layout, [usize; 2])>,
    coarsest: Layout,
    frontal: Arc<FrontalPattern>,
    /// Whether the last line is a centreline, beyond which all is mirrored.
    half: bool,
}

impl Grids {
    /// Coarsens a rectangle to at most this many unknowns.
    ///
    /// # Errors
    /// When no order of elimination is found.
    pub fn new(n: [usize; 2], half: bool, coarsest: usize) -> Result<Grids, OrderingError> {
        let mut layout = Layout { n };
        let mut finer = Vec::new();
        while layout.unknowns() > coarsest {
            // Zeros beyond the edges fall on coarse nodes where there is an odd number; a centreline stays one.
            let [nx, ny] = layout.n;
            let across = if half { ny.div_ceil(2) } else { ny / 2 };
            let first = if half { (ny - 1) % 2 } else { 1 };
            finer.push((layout, [1, first]));
            layout = Layout {
                n: [nx / 2, across],
            };
        }
        Ok(Grids {
            finer,
            coarsest: layout,
            frontal: Arc::new(rectangle::pattern(layout)?),
            half,
        })
    }

    /// Whether it is only a factorisation.
    pub fn is_direct(&self) -> bool {
        self.finer.is_empty()
    }
}

/// One grid of the cycle.
struct Level {
    transfer: Transfer,
    /// Sizes and kinds of the rows.
    matrix: Matrix,
    lines: Lines,
    factors: Incomplete,
    /// Right-hand side, solution and residual.
    b: Vec<f32>,
    x: Vec<f32>,
    r: Vec<f32>,
}

/// M⁻¹, approximately.
pub struct Cycle {
    levels: Vec<Level>,
    coarsest: Layout,
    /// Sizes and kinds of the rows there.
    kinds: (Vec<f32>, Vec<bool>),
    lu: FrontalLu,
}

impl Level {
    /// r = b − M x.
    fn note_residual(&mut self) {
        residual(&self.lines, &self.b, &self.x, &mut self.r);
    }
}

impl Cycle {
    /// For a matrix on the finest of the grids; `None` where that on the coarsest is singular.
    pub fn new(grids: &Grids, matrix: Matrix) -> Option<Cycle> {
        let mut matrix = matrix;
        let mut levels = Vec::new();
        let coarser = grids.finer.iter().skip(1).map(|(layout, _)| *layout);
        for ((fine, first), coarse) in grids.finer.iter().zip(coarser.chain([grids.coarsest])) {
            let transfer = Transfer {
                fine: *fine,
                coarse,
                first: *first,
                half: grids.half,
            };
            let (factors, next) = rayon::join(
                || Incomplete::new(*fine, &matrix.rows),
                || transfer.product(&matrix),
            );
            let vector = vec![0.0; fine.size()];
            let mut own = std::mem::replace(&mut matrix, next);
            levels.push(Level {
                transfer,
                lines: Lines::new(*fine, &std::mem::take(&mut own.rows)),
                matrix: own,
                factors,
                b: vector.clone(),
                x: vector.clone(),
                r: vector,
            });
        }
        let values = rectangle::values(grids.coarsest, &matrix.rows);
        Some(Cycle {
            levels,
            coarsest: grids.coarsest,
            lu: FrontalLu::new(&grids.frontal, &values).ok()?,
            kinds: (matrix.sizes, matrix.wetted),
        })
    }

    /// Solves for scaled residuals of the unknowns in place, approximately.
    pub fn solve(&mut self, w: &mut [f64]) {
        let Some(finest) = self.levels.first_mut() else {
            return self.lu.solve(w);
        };
        let layout = finest.transfer.fine;
        let nx = layout.n[0];
        for (k, w) in w.iter().enumerate() {
            finest.b[layout.at(k % nx, k / nx)] = *w as f32;
        }
        self.descend(0);
        let x = &self.levels[0].x;
        for (k, w) in w.iter_mut().enumerate() {
            *w = f64::from(x[layout.at(k % nx, k / nx)]);
        }
    }

    fn descend(&mut self, l: usize) {
        let (head, tail) = self.levels.split_at_mut(l + 1);
        let level = &mut head[l];
        let transfer = level.transfer;
        level.x.fill(0.0);
        level.r.copy_from_slice(&level.b);
        level.factors.add_solution(&mut level.r, &mut level.x);
        level.note_residual();
        match tail.first_mut() {
            Some(next) => {
                let of_rows = [&next.matrix.sizes, &level.r].map(Vec::as_slice);
                transfer.restrict(&level.matrix, of_rows, &next.matrix.wetted, &mut next.b);
                self.descend(l + 1);
                let (head, tail) = self.levels.split_at_mut(l + 1);
                transfer.prolong(&tail[0].x, &mut head[l].x);
            }
            None => {
                let (layout, (sizes, wetted)) = (self.coarsest, &self.kinds);
                let mut b = vec![0.0; layout.size()];
                transfer.restrict(&level.matrix, [sizes, &level.r], wetted, &mut b);
                let place = |k: usize| layout.at(k % layout.n[0], k / layout.n[0]);
                let mut w: Vec<f64> = (0..layout.unknowns()).map(|k| b[place(k)].into()).collect();
                self.lu.solve(&mut w);
                (w.iter().enumerate()).for_each(|(k, w)| b[place(k)] = *w as f32);
                transfer.prolong(&b, &mut level.x);
            }
        }
        let level = &mut self.levels[l];
        level.note_residual();
        level.factors.add_solution(&mut level.r, &mut level.x);
    }
}

#[cfg(test)]
#[path = "multigrid_tests.rs"]
mod tests;
