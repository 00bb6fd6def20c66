//! Matrices whose rows are stencils of five by five places around a node, on a rectangle of unknowns, and their incomplete factorisation.
//!
//! ```text
//!   M ≈ L U on the places of M,   u_ii = … + θ Σ|entries of the product that have no place|      (Wittum 1989)
//! ```
//! Blocks of lines are factorised and solved for each by itself, on as many cores as there are.
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

/// θ. Without it pivots vanish in the operator of third order that wetted rows are under low pressure, and GMRES takes 40 iterations instead of 4.
const STRENGTHENED: f32 = 0.3;

/// Least pivot of a row whose largest entry is 1.
const LEAST_PIVOT: f32 = 1e-3;

/// Rows that a thread takes at a time.
pub const BATCH: usize = 16;

/// Blocks of lines of an incomplete factorisation, and lines of one at least. Their number does not depend on the machine, so that results do not either.
const BLOCKS: usize = 2;
const LEAST_LINES: usize = 32;

/// Position of an unknown and its neighbours in vectors.
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
}

/// Rows of a matrix by lines of unknowns, in each the entries of one place after the other: products go along the lines.
pub struct Lines {
    layout: Layout,
    values: Vec<f32>,
}

impl Lines {
    /// Of rows one after the other.
    pub fn new(layout: Layout, rows: &[Row]) -> Lines {
        let nx = layout.n[0];
        let mut values = vec![0.0; layout.unknowns() * PLACES];
        let lines = values.par_chunks_mut(nx * PLACES);
        lines
            .zip(rows.par_chunks(nx))
            .with_min_len(BATCH)
            .for_each(|(line, rows)| {
                for (i, row) in rows.iter().enumerate() {
                    for (t, value) in row.iter().enumerate() {
                        line[t * nx + i] = *value;
                    }
                }
            });
        Lines { layout, values }
    }

    /// Entries of a place along a line.
    #[inline(always)]
    fn of(&self, line: usize, place: usize) -> &[f32] {
        let nx = self.layout.n[0];
        &self.values[(line * PLACES + place) * nx..][..nx]
    }

    /// Values at a place of the rows of a line in a vector.
    #[inline(always)]
    fn at<'a>(&self, x: &'a [f32], line: usize, place: usize) -> &'a [f32] {
        let layout = self.layout;
        let start = (line + place / SIDE) * layout.width() + place % SIDE;
        &x[start..][..layout.n[0]]
    }
}

/// Takes products off a line, value by value.
#[inline(always)]
fn take_off(line: &mut [f32], entries: &[f32], values: &[f32]) {
    for (r, (v, x)) in line.iter_mut().zip(entries.iter().zip(values)) {
        *r -= v * x;
    }
}

/// b − M x.
pub fn residual(matrix: &Lines, b: &[f32], x: &[f32], r: &mut [f32]) {
    let layout = matrix.layout;
    let [nx, _] = layout.n;
    let lines = r.par_chunks_mut(layout.width()).enumerate();
    lines.with_min_len(BATCH).for_each(|(of_vector, r)| {
        let Some(j) = layout.line(of_vector) else {
            return;
        };
        let r = &mut r[REACH..][..nx];
        r.copy_from_slice(&b[layout.at(0, j)..][..nx]);
        for t in 0..PLACES {
            take_off(r, matrix.of(j, t), matrix.at(x, j, t));
        }
    });
}

/// L and U; the pivots are inverted.
pub struct Incomplete {
    lines: Lines,
}

/// Entries that the elimination by one lower place changes.
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
        let nx = layout.n[0];
        let blocks: Vec<Vec<Row>> = rows
            .par_chunks(block(layout) * nx)
            .map(|rows| factorised(nx, rows, &updates))
            .collect();
        Incomplete {
            lines: Lines::new(layout, &blocks.concat()),
        }
    }

    /// Adds (L U)⁻¹ r to x; r is overwritten.
    pub fn add_solution(&self, r: &mut [f32], x: &mut [f32]) {
        let layout = self.lines.layout;
        let width = layout.width();
        let of_unknowns = REACH * width..(REACH + layout.n[1]) * width;
        let lines = block(layout);
        let [r, x] = [r, x].map(|v| v[of_unknowns.clone()].par_chunks_mut(lines * width));
        r.zip(x)
            .enumerate()
            .for_each(|(k, (r, x))| self.solve_block(k * lines, r, x));
    }

    /// The same of the lines of a block, which begins with the line `first`.
    fn solve_block(&self, first: usize, r: &mut [f32], x: &mut [f32]) {
        let rows = &self.lines;
        let ([nx, _], width) = (rows.layout.n, rows.layout.width());
        let n = r.len() / width;
        // The lines before and behind, then the terms of the neighbours.
        let [before, behind] = [REACH * SIDE, (REACH + 1) * SIDE];
        for j in 0..n {
            let (done, line) = r.split_at_mut(j * width);
            for t in 0..before {
                if let Some(other) = (j + t / SIDE).checked_sub(REACH) {
                    let values = &done[other * width + t % SIDE..][..nx];
                    take_off(&mut line[REACH..][..nx], rows.of(first + j, t), values);
                }
            }
            let [far, near] = [before, before + 1].map(|t| rows.of(first + j, t));
            let [mut second, mut last] = [0.0; 2];
            for ((r, far), near) in line[REACH..].iter_mut().zip(far).zip(near) {
                *r = (*r - far * second) - near * last;
                [second, last] = [last, *r];
            }
        }
        for j in (0..n).rev() {
            let (line, done) = r.split_at_mut((j + 1) * width);
            let line = &mut line[j * width..][REACH..][..nx];
            for t in behind..PLACES {
                // Counted from the line after this one.
                let other = t / SIDE - REACH - 1;
                if j + 1 + other < n {
                    let values = &done[other * width + t % SIDE..][..nx];
                    take_off(line, rows.of(first + j, t), values);
                }
            }
            let of_line = |t| rows.of(first + j, t);
            let [pivot, near, far] = [CENTRE, CENTRE + 1, CENTRE + 2].map(of_line);
            let [mut second, mut last] = [0.0; 2];
            for i in (0..nx).rev() {
                line[i] = ((line[i] - far[i] * second) - near[i] * last) * pivot[i];
                [second, last] = [last, line[i]];
            }
            for (x, r) in x[j * width + REACH..].iter_mut().zip(line) {
                *x += *r;
            }
        }
    }
}

/// Lines of a block.
fn block(layout: Layout) -> usize {
    layout.n[1].div_ceil(BLOCKS).max(LEAST_LINES)
}

/// The factors of a block of lines; entries outside it are neglected.
fn factorised(nx: usize, rows: &[Row], updates: &[Update]) -> Vec<Row> {
    let mut done: Vec<Row> = Vec::with_capacity(rows.len());
    for (k, row) in rows.iter().enumerate() {
        let (i, j) = (k % nx, k / nx);
        let mut row = *row;
        for (t, entry) in row.iter_mut().enumerate() {
            let line = (j + t / SIDE).checked_sub(REACH);
            if line.is_none_or(|line| (line + 1) * nx > rows.len()) {
                *entry = 0.0;
            }
        }
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
            let beyond = (update.dropped.iter()).map(|upper| (factor * other[*upper]).abs());
            lost += beyond.sum::<f32>();
        }
        let pivot = row[CENTRE] + STRENGTHENED * lost;
        row[CENTRE] = 1.0 / pivot.abs().max(LEAST_PIVOT).copysign(pivot);
        done.push(row);
    }
    done
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// A matrix with a diagonal of 1 and these off-diagonal entries, zero beyond the rectangle.
    fn matrix(layout: Layout, off_diagonal: &[([i64; 2], f32)]) -> Vec<Row> {
        let [nx, ny] = layout.n.map(|n| n as i64);
        let row = |k: usize| {
            let [i, j] = [k % layout.n[0], k / layout.n[0]].map(|i| i as i64);
            let mut row = [0.0; PLACES];
            row[CENTRE] = 1.0;
            for ([di, dj], v) in off_diagonal {
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
            residual(&Lines::new(layout, &rows), &b, &x, &mut r);
            let residual = r.iter().fold(0.0_f32, |m, v| m.max(v.abs()));
            assert!(residual < most, "{y}: {residual}");
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
        residual(&Lines::new(layout, &rows), &b, &x, &mut r);
        // 1 − 4 − ½·3 in the middle; 1 − 0 − ¼·5 in the first corner.
        assert_relative_eq!(r[layout.at(1, 1)], -4.5);
        assert_relative_eq!(r[layout.at(0, 0)], -0.25);
    }
}
