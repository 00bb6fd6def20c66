//! From a grid to one with nodes at twice the distance and back: interpolation, restriction and the coarse matrix.

use rayon::prelude::*;

use super::stencil::{BATCH, Layout, PLACES, REACH, Row, SIDE};

/// A matrix on one grid.
pub struct Matrix {
    /// Rows, the largest entry of each is 1.
    pub rows: Vec<Row>,
    /// The divisor of the values.
    pub sizes: Vec<f32>,
    /// Whether they are balances, not P = 0.
    pub wetted: Vec<bool>,
}

/// Weights of linear interpolation at the distance of none and of one node.
const LINEAR: [f32; 2] = [1.0, 0.5];

/// From a grid to the coarse one.
#[derive(Clone, Copy)]
pub struct Transfer {
    /// Unknowns there.
    pub fine: Layout,
    /// Unknowns here.
    pub coarse: Layout,
    /// Where the first coarse one lies among the fine ones.
    pub first: [usize; 2],
    /// Whether the last line is a centreline, beyond which all is mirrored.
    pub half: bool,
}

impl Transfer {
    /// Fine nodes around a coarse one, beyond the centreline those before it, as steps and weights of R.
    fn around(&self, at: [usize; 2]) -> impl Iterator<Item = ([i64; 2], usize, f32)> {
        let [nx, ny] = self.fine.n.map(|n| n as i64);
        let [x, y] = [0, 1].map(|d: usize| (2 * at[d] + self.first[d]) as i64);
        let half = self.half;
        let steps = (-1..=1_i64).flat_map(|j| (-1..=1_i64).map(move |i| [i, j]));
        steps.filter_map(move |[i, j]| {
            let mirrored = if half && y + j >= ny { -j } else { j };
            let place = [x + i, y + mirrored];
            let inside = (0..nx).contains(&place[0]) && (0..ny).contains(&place[1]);
            let weight =
                0.25 * LINEAR[i.unsigned_abs() as usize] * LINEAR[j.unsigned_abs() as usize];
            inside.then(|| ([i, mirrored], (place[1] * nx + place[0]) as usize, weight))
        })
    }

    /// M_c = R M P.
    pub fn product(&self, fine: &Matrix) -> Matrix {
        let [nx, ny] = self.coarse.n;
        let row = |k: usize| {
            let at = [k % nx, k / nx];
            let centre = (2 * at[1] + self.first[1]) * self.fine.n[0] + 2 * at[0] + self.first[0];
            let wetted = fine.wetted[centre];
            // R M over the fine places that it reaches, then times P along both directions.
            let mut sum = [[0.0_f32; WIDE]; WIDE];
            for ([i, j], node, weight) in self.around(at) {
                if fine.wetted[node] != wetted {
                    continue;
                }
                let weight = weight * fine.sizes[node];
                for (t, value) in fine.rows[node].iter().enumerate() {
                    let [x, y] = [i + 1, j + 1].map(|i| i as usize);
                    sum[y + t / SIDE][x + t % SIDE] += weight * value;
                }
            }
            let along = sum.map(|line| folded(|x| line[x]));
            let mut row = [0.0; PLACES];
            for i in 0..SIDE {
                for (j, value) in folded(|y| along[y][i]).into_iter().enumerate() {
                    let place = [at[0] + i, at[1] + j];
                    let inside = |d: usize, n: usize| (REACH..REACH + n).contains(&place[d]);
                    if inside(0, nx) && inside(1, ny) {
                        row[j * SIDE + i] = value;
                    }
                }
            }
            let size = row.iter().fold(f32::MIN_POSITIVE, |m, v| m.max(v.abs()));
            (row.map(|v| v / size), (size, wetted))
        };
        let rows = (0..self.coarse.unknowns()).into_par_iter();
        let (rows, kinds): (Vec<Row>, Vec<(f32, bool)>) =
            rows.with_min_len(64 * BATCH).map(row).unzip();
        let (sizes, wetted) = kinds.into_iter().unzip();
        Matrix {
            rows,
            sizes,
            wetted,
        }
    }

    /// R r of scaled residuals, scaled again.
    pub fn restrict(&self, fine: &Matrix, [sizes, r]: [&[f32]; 2], wetted: &[bool], b: &mut [f32]) {
        let (nx, width) = (self.coarse.n[0], self.fine.n[0]);
        let lines = b.par_chunks_mut(self.coarse.width()).enumerate();
        lines.with_min_len(BATCH).for_each(|(of_vector, b)| {
            let Some(j) = self.coarse.line(of_vector) else {
                return;
            };
            for i in 0..nx {
                let k = j * nx + i;
                let alike = self
                    .around([i, j])
                    .filter(|(_, node, _)| fine.wetted[*node] == wetted[k]);
                let sum: f32 = alike
                    .map(|(_, node, weight)| {
                        weight * fine.sizes[node] * r[self.fine.at(node % width, node / width)]
                    })
                    .sum();
                b[i + REACH] = sum / sizes[k];
            }
        });
    }

    /// Adds P w.
    pub fn prolong(&self, w: &[f32], x: &mut [f32]) {
        let [nx, _] = self.fine.n;
        let width = self.coarse.width();
        // The coarse nodes on either side, in vectors with zeros around; the centreline is a coarse line.
        let neighbours = |d: usize, i: usize| {
            let from = i + 2 * REACH - self.first[d];
            [from / 2, from.div_ceil(2)]
        };
        let lines = x.par_chunks_mut(self.fine.width()).enumerate();
        lines.with_min_len(BATCH).for_each(|(of_vector, x)| {
            let Some(j) = self.fine.line(of_vector) else {
                return;
            };
            let [below, above] = neighbours(1, j).map(|line| line * width);
            for i in 0..nx {
                let [before, behind] = neighbours(0, i);
                let sum =
                    w[below + before] + w[below + behind] + w[above + before] + w[above + behind];
                x[i + REACH] += 0.25 * sum;
            }
        });
    }
}

/// Fine places along a side that R M reaches.
const WIDE: usize = SIDE + 2;

/// Values at those times P: at the coarse places.
fn folded(fine: impl Fn(usize) -> f32) -> [f32; SIDE] {
    std::array::from_fn(|c| {
        // The first and the last place lie outside but for one neighbour.
        let near = (2 * c).saturating_sub(2)..(2 * c + 1).min(WIDE);
        near.map(|x| LINEAR[(x + 1).abs_diff(2 * c)] * fine(x))
            .sum()
    })
}
