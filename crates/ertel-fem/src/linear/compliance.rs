//! Dense symmetric compliance of the loaded surface, applied on all cores.
//!
//! The lower triangle is kept in square tiles. A tile is used twice while it is in cache, for its
//! rows and, transposed, for its columns: a product is bound by the memory that it reads. Tiles are
//! dealt to a fixed number of tasks whose sums are added in a fixed order: the result does not
//! depend on the number of threads.

use rayon::prelude::*;

use crate::kernel;
use crate::linear::dense::{Real, add_both, add_product, vectorised};

/// A symmetric matrix in double and in single precision.
#[derive(Clone, Debug, PartialEq)]
pub struct Compliance {
    n: usize,
    double: Vec<f64>,
    single: Vec<f32>,
}

/// Rows of a tile.
const TILE: usize = 96;
/// Tasks of a product.
const TASKS: usize = 8;

/// Start of tile (a, b), b ≤ a, in the list of tiles: row by row.
fn start(a: usize, b: usize) -> usize {
    (a * (a + 1) / 2 + b) * TILE * TILE
}

/// Place of entry (i, j), j ≤ i.
fn place(i: usize, j: usize) -> usize {
    start(i / TILE, j / TILE) + (j % TILE) * TILE + i % TILE
}

impl Compliance {
    /// From the lower triangle of a matrix: `lower(j)` is column j from the diagonal down.
    pub fn from_lower<'a>(n: usize, lower: impl Fn(usize) -> &'a [f64] + Sync) -> Compliance {
        let n_tiles = n.div_ceil(TILE);
        let mut double = vec![0.0; start(n.div_ceil(TILE), 0)];
        let mut rows = Vec::with_capacity(n_tiles);
        let mut rest = &mut double[..];
        for a in 0..n_tiles {
            let (row, below) = rest.split_at_mut((a + 1) * TILE * TILE);
            rows.push((a, row));
            rest = below;
        }
        rows.into_par_iter().for_each(|(a, row)| {
            let last = ((a + 1) * TILE).min(n);
            for (b, tile) in row.chunks_exact_mut(TILE * TILE).enumerate() {
                for (j, column) in tile.chunks_exact_mut(TILE).enumerate() {
                    let j = b * TILE + j;
                    if j < n {
                        let first = (a * TILE).max(j);
                        column[first - a * TILE..last - a * TILE]
                            .copy_from_slice(&lower(j)[first - j..last - j]);
                    }
                }
            }
            // tiles on the diagonal are kept in full
            let diagonal = &mut row[a * TILE * TILE..];
            for j in 0..TILE {
                for i in 0..j {
                    diagonal[j * TILE + i] = diagonal[i * TILE + j];
                }
            }
        });
        let single = double.par_iter().map(|v| *v as f32).collect();
        Compliance { n, double, single }
    }

    /// Entry (i, j).
    pub fn get(&self, i: usize, j: usize) -> f64 {
        self.double[place(i.max(j), i.min(j))]
    }

    /// y = C x.
    pub fn apply(&self, x: &[f64], y: &mut [f64]) {
        product::<f64, 8>(&self.double, x, y);
    }

    /// y = C x in single precision, in half of the time.
    pub fn apply_single(&self, x: &[f32], y: &mut [f32]) {
        product::<f32, 16>(&self.single, x, y);
    }
}

/// y = C x; `L` numbers of a row are treated side by side.
fn product<T: Real, const L: usize>(tiles: &[T], x: &[T], y: &mut [T]) {
    let n = x.len();
    let n_tiles = n.div_ceil(TILE);
    let zero = T::default();
    let mut padded = vec![zero; n_tiles * TILE];
    padded[..n].copy_from_slice(x);
    let sums: Vec<Vec<T>> = (0..TASKS.min(n_tiles))
        .into_par_iter()
        .with_max_len(1)
        .map(|task| {
            let mut sum = vec![zero; n_tiles * TILE];
            vectorised(AddRows::<T, L> {
                task,
                tiles,
                x: &padded,
                sum: &mut sum,
            });
            sum
        })
        .collect();
    y.fill(zero);
    for sum in &sums {
        for (y, s) in y.iter_mut().zip(sum) {
            *y += *s;
        }
    }
}

kernel! {
    AddRows ['a, T: Real, const L: usize] ['a, T, L]
    (task: usize, tiles: &'a [T], x: &'a [T], sum: &'a mut [T]) -> () {
        add_rows::<T, L>(task, tiles, x, sum)
    }
}

/// Adds the products with every [`TASKS`]th row of tiles, from one on; `x` is padded to whole tiles.
#[inline(always)]
fn add_rows<T: Real, const L: usize>(task: usize, tiles: &[T], x: &[T], sum: &mut [T]) {
    let part = |b: usize| &x[b * TILE..(b + 1) * TILE];
    for a in (task..x.len() / TILE).step_by(TASKS) {
        let (before, own) = sum.split_at_mut(a * TILE);
        let own = &mut own[..TILE];
        let row = &tiles[start(a, 0)..start(a + 1, 0)];
        let (row, diagonal) = row.split_at(a * TILE * TILE);
        for (b, tile) in row.chunks_exact(TILE * TILE).enumerate() {
            let below = &mut before[b * TILE..(b + 1) * TILE];
            add_both::<T, L>(tile, part(b), part(a), own, below);
        }
        add_product(diagonal, part(a), own);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Products and entries against the plain sums over the same numbers, for orders below, at and
    /// beyond a tile; the same bits on one thread and on two.
    #[test]
    fn equals_plain_sums() {
        for n in [1, TILE, 3 * TILE + 17] {
            // as uneven as nodes of fine and coarse elements
            let size = |i: usize| 1.0 + (i % 7) as f64;
            let entry = |i: usize, j: usize| size(i) * size(j) / (1.0 + i.abs_diff(j) as f64);
            let columns: Vec<Vec<f64>> = (0..n)
                .map(|j| (j..n).map(|i| entry(i, j)).collect())
                .collect();
            let c = Compliance::from_lower(n, |j| &columns[j]);
            let x: Vec<f64> = (0..n).map(|i| (0.3 * i as f64).sin()).collect();
            let single: Vec<f32> = x.iter().map(|v| *v as f32).collect();
            let products = [1, 2].map(|threads| {
                let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
                pool.unwrap().install(|| {
                    let (mut y, mut z) = (vec![0.0; n], vec![0.0f32; n]);
                    c.apply(&x, &mut y);
                    c.apply_single(&single, &mut z);
                    (y, z)
                })
            });
            assert_eq!(products[0], products[1]);
            let (y, z) = &products[0];
            for i in 0..n {
                let exact: f64 = (0..n).map(|j| entry(i, j) * x[j]).sum();
                assert_relative_eq!(y[i], exact, epsilon = 1e-11);
                assert_relative_eq!(f64::from(z[i]), exact, epsilon = 1e-3);
                assert_eq!(c.get(i, n - 1), entry(i, n - 1));
            }
        }
    }
}
