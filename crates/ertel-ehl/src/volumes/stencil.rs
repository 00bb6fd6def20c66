//! Matrices whose rows are stencils of five by five places around a node, on a rectangle of unknowns, and their incomplete factorisation.
//!
//! ```text
//!   M ≈ L U on the places of M,   u_ii = … + θ Σ|entries of the product that have no place|      (Wittum 1989)
//! ```
//! Vectors have [`REACH`] layers of zeros around the rectangle, so that every place of a row has a number.

use rayon::prelude::*;

/// Places of a stencil along each direction on either side of its node.
pub const REACH: usize = 2;

/// Places along a side.
pub const SIDE: usize = 2 * REACH + 1;

/// All places, row by row.
pub const PLACES: usize = SIDE * SIDE;

/// The node itself.
const CENTRE: usize = PLACES / 2;

/// A row.
pub type Row = [f32; PLACES];

/// θ. Without it pivots vanish in the operator of third order that wetted rows are under low pressure, and GMRES takes 40 iterations in place of 4.
const STRENGTHENED: f32 = 0.3;

/// Least pivot of a row whose largest entry is 1.
const LEAST_PIVOT: f32 = 1e-3;

/// Rows that a thread takes at a time.
pub const BATCH: usize = 16;

/// Where an unknown and what lies beside it stand in vectors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layout {
    /// Unknowns along each direction.
    pub n: [usize; 2],
}

impl Layout {
    /// Number of unknowns.
    pub fn unknowns(&self) -> usize {
        self.n[0] * self.n[1]
    }

    /// Length of a line of a vector.
    pub fn width(&self) -> usize {
        self.n[0] + 2 * REACH
    }

    /// Length of a vector.
    pub fn size(&self) -> usize {
        self.width() * (self.n[1] + 2 * REACH)
    }

    /// Position of an unknown.
    #[inline(always)]
    pub fn at(&self, i: usize, j: usize) -> usize {
        (j + REACH) * self.width() + i + REACH
    }

    /// Line of unknowns that a line of a vector holds.
    pub fn line(&self, of_vector: usize) -> Option<usize> {
        (REACH..REACH + self.n[1])
            .contains(&of_vector)
            .then(|| of_vector - REACH)
    }

    /// The first place of a row.
    #[inline(always)]
    fn corner(&self, i: usize, j: usize) -> usize {
        j * self.width() + i
    }
}

/// Sum over a line of places: entries times the values that stand there.
#[inline(always)]
fn along(entries: &[f32], values: &[f32]) -> f32 {
    entries.iter().zip(values).map(|(v, x)| v * x).sum()
}

/// b − M x.
pub fn residual(layout: Layout, rows: &[Row], b: &[f32], x: &[f32], r: &mut [f32]) {
    let width = layout.width();
    let lines = r.par_chunks_mut(layout.width()).enumerate();
    lines.with_min_len(BATCH).for_each(|(of_vector, r)| {
        let Some(j) = layout.line(of_vector) else {
            return;
        };
        for i in 0..layout.n[0] {
            let (row, corner) = (&rows[j * layout.n[0] + i], layout.corner(i, j));
            let lines = row.chunks_exact(SIDE).enumerate();
            let product: f32 = lines
                .map(|(d, row)| along(row, &x[corner + d * width..][..SIDE]))
                .sum();
            r[i + REACH] = b[layout.at(i, j)] - product;
        }
    });
}

/// L and U; the pivots are inverted.
pub struct Incomplete {
    layout: Layout,
    rows: Vec<Row>,
}

/// What the elimination by one lower place adds to.
struct Update {
    /// Places of the row of the pivot, and where they fall in the eliminated row.
    kept: Vec<(usize, usize)>,
    /// Places that fall outside it.
    dropped: Vec<usize>,
}

impl Update {
    fn by(lower: usize) -> Update {
        let mut update = Update {
            kept: Vec::new(),
            dropped: Vec::new(),
        };
        for upper in CENTRE + 1..PLACES {
            // Steps add up; counted from the first place, one centre too many.
            let along = |f: fn(usize) -> usize| (f(lower) + f(upper)).checked_sub(REACH);
            match (along(|t| t % SIDE), along(|t| t / SIDE)) {
                (Some(i), Some(j)) if i < SIDE && j < SIDE => {
                    update.kept.push((upper, j * SIDE + i))
                }
                _ => update.dropped.push(upper),
            }
        }
        update
    }
}

impl Incomplete {
    /// Factorises rows whose largest entry is 1.
    pub fn new(layout: Layout, rows: &[Row]) -> Incomplete {
        let updates: Vec<Update> = (0..CENTRE).map(Update::by).collect();
        let [nx, ny] = layout.n;
        let mut done: Vec<Row> = Vec::with_capacity(rows.len());
        for j in 0..ny {
            for i in 0..nx {
                let mut row = rows[j * nx + i];
                let mut lost = 0.0_f32;
                for (lower, update) in updates.iter().enumerate() {
                    // Entries beyond the rectangle are zero.
                    if row[lower] == 0.0 {
                        continue;
                    }
                    let pivot = (j + lower / SIDE - REACH) * nx + (i + lower % SIDE) - REACH;
                    let other = &done[pivot];
                    let factor = row[lower] * other[CENTRE];
                    row[lower] = factor;
                    for (upper, place) in &update.kept {
                        row[*place] -= factor * other[*upper];
                    }
                    let beyond = update
                        .dropped
                        .iter()
                        .map(|upper| (factor * other[*upper]).abs());
                    lost += beyond.sum::<f32>();
                }
                let pivot = row[CENTRE] + STRENGTHENED * lost;
                row[CENTRE] = 1.0 / pivot.abs().max(LEAST_PIVOT).copysign(pivot);
                done.push(row);
            }
        }
        Incomplete { layout, rows: done }
    }

    /// Adds (L U)⁻¹ r to x; r is overwritten.
    pub fn add_solution(&self, r: &mut [f32], x: &mut [f32]) {
        let layout = self.layout;
        let [nx, ny] = layout.n;
        let width = layout.width();
        // A line of places of the row, from one on.
        let part = |row: &Row, r: &[f32], corner: usize, from: usize, to: usize| {
            let start = corner + from / SIDE * width + from % SIDE;
            along(&row[from..to], &r[start..start + to - from])
        };
        for j in 0..ny {
            for i in 0..nx {
                let (row, corner) = (&self.rows[j * nx + i], layout.corner(i, j));
                let sum = part(row, r, corner, 0, SIDE)
                    + part(row, r, corner, SIDE, 2 * SIDE)
                    + part(row, r, corner, 2 * SIDE, CENTRE);
                r[layout.at(i, j)] -= sum;
            }
        }
        for j in (0..ny).rev() {
            for i in (0..nx).rev() {
                let (row, corner) = (&self.rows[j * nx + i], layout.corner(i, j));
                let sum = part(row, r, corner, CENTRE + 1, 3 * SIDE)
                    + part(row, r, corner, 3 * SIDE, 4 * SIDE)
                    + part(row, r, corner, 4 * SIDE, PLACES);
                let k = layout.at(i, j);
                r[k] = (r[k] - sum) * row[CENTRE];
                x[k] += r[k];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// A matrix with a diagonal of 1 and these entries beside it, zero beyond the rectangle.
    fn matrix(layout: Layout, beside: &[([i64; 2], f32)]) -> Vec<Row> {
        let [nx, ny] = layout.n.map(|n| n as i64);
        let row = |k: usize| {
            let [i, j] = [k % layout.n[0], k / layout.n[0]].map(|i| i as i64);
            let mut row = [0.0; PLACES];
            row[CENTRE] = 1.0;
            for ([di, dj], v) in beside {
                if (0..nx).contains(&(i + di)) && (0..ny).contains(&(j + dj)) {
                    row[((dj + 2) * 5 + di + 2) as usize] = *v;
                }
            }
            row
        };
        (0..layout.unknowns()).map(row).collect()
    }

    /// Flow with and against the order of the unknowns is solved for exactly by one step, flow across it but for fill three places away.
    #[test]
    fn upwind_flow_is_solved() {
        let layout = Layout { n: [9, 7] };
        let directions = [
            ([-1, -1], 1e-5),
            ([1, 1], 1e-5),
            ([1, -1], 0.3),
            ([-1, 1], 0.3),
        ];
        for ([x, y], most) in directions {
            let rows = matrix(layout, &[([x, 0], -0.7), ([0, y], -0.3)]);
            let mut b = vec![0.0; layout.size()];
            for j in 0..7 {
                for i in 0..9 {
                    b[layout.at(i, j)] = (1.3 * i as f32 + 0.4 * j as f32).sin();
                }
            }
            let (mut x, mut r) = (vec![0.0; layout.size()], b.clone());
            Incomplete::new(layout, &rows).add_solution(&mut r, &mut x);
            residual(layout, &rows, &b, &x, &mut r);
            let left = r.iter().fold(0.0_f32, |m, v| m.max(v.abs()));
            assert!(left < most, "{y}: {left}");
        }
    }

    /// A product against sums written out.
    #[test]
    fn residual_by_hand() {
        let layout = Layout { n: [3, 3] };
        let rows = matrix(layout, &[([-1, 0], 0.5), ([2, 1], 0.25)]);
        let (mut x, b) = (vec![0.0; layout.size()], vec![1.0; layout.size()]);
        for k in 0..9 {
            x[layout.at(k % 3, k / 3)] = k as f32;
        }
        let mut r = vec![0.0; layout.size()];
        residual(layout, &rows, &b, &x, &mut r);
        // 1 − 4 − ½·3 in the middle; 1 − 0 − ¼·5 in the first corner.
        assert_relative_eq!(r[layout.at(1, 1)], -4.5);
        assert_relative_eq!(r[layout.at(0, 0)], -0.25);
    }
}
