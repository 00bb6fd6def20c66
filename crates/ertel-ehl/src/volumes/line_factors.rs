//! Factors of the linearised film equation of a line on many nodes.
//!
//! ```text
//!   M = A + B K,   K_ij = k(|i − j|)            A, B: each node and its two neighbours
//!   M = ⎡M₁       U₁V₁ᵀ⎤                       M₁, M₂ likewise, down to small dense matrices
//!       ⎣U₂V₂ᵀ    M₂   ⎦
//!   x₁ = M₁⁻¹b₁ − Y₁t₁,  x₂ = M₂⁻¹b₂ − Y₂t₂,   Y = M⁻¹U
//!   ⎡I      V₁ᵀY₂⎤ ⎡t₁⎤   ⎡V₁ᵀM₂⁻¹b₂⎤
//!   ⎣V₂ᵀY₁  I    ⎦ ⎣t₂⎦ = ⎣V₂ᵀM₁⁻¹b₁⎦
//! ```
//! (Ambikasaran and Darve 2013, J. Sci. Comput. 57, 477.) The logarithm between two halves of a row is a sum of a few products of functions of either half, so that the factors
//! cost n log² n. The sparse approximation of [`super::preconditioner`] has three points for the inverse of K: on ten thousand nodes it does not treat smooth pressures, and the Krylov
//! iterations do not converge.

use nalgebra::{DMatrix, DMatrixViewMut, DVector, Dyn, LU};

/// Nodes of a dense block at most.
const DENSE: usize = 64;

/// Error of the products, relative to the largest entry; enough for a preconditioner.
const TOLERANCE: f64 = 1e-4;

/// Nodes of a block whose halves run on separate threads.
const SPLIT: usize = 1024;

/// A row of M: entries of the node before, the node itself and the one behind.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Triple {
    /// Of A.
    pub by_pressure: [f64; 3],
    /// Of B.
    pub by_film: [f64; 3],
}

/// k(s + t) ≈ Σ U(s) V(t) between two halves that meet, s = 1, 2, … nodes back from where they do, t = 0, 1, … nodes on.
struct Products {
    /// Row s − 1.
    back: DMatrix<f64>,
    /// The same rows in the order of the nodes: the last one is s = 1.
    in_order: DMatrix<f64>,
    /// Row t.
    on: DMatrix<f64>,
}

impl Products {
    /// For halves of up to m nodes and the one beyond each, by crosses (Bebendorf 2000). Their largest entries are looked for on nodes ever farther
    /// apart: on single rows and columns, the usual choice, one may vanish by chance before the others are small.
    fn new(kernel: &[f64], m: usize) -> Products {
        let n = m + 1;
        let entry = |s: usize, t: usize| kernel[(s + 1 + t).min(kernel.len() - 1)];
        let looked_at = spread(n);
        let mut residual = DMatrix::from_fn(looked_at.len(), looked_at.len(), |i, j| {
            entry(looked_at[i], looked_at[j])
        });
        let largest = kernel.iter().fold(0.0_f64, |m, k| m.max(k.abs()));
        let mut terms: Vec<[DVector<f64>; 2]> = Vec::new();
        while terms.len() < looked_at.len() {
            let at = residual.iamax_full();
            let pivot = residual[at];
            if pivot.abs() <= TOLERANCE * largest {
                break;
            }
            let (row, column) = (looked_at[at.0], looked_at[at.1]);
            let known =
                |s: usize, t: usize| -> f64 { terms.iter().map(|[u, v]| u[s] * v[t]).sum() };
            let u = DVector::from_fn(n, |s, _| entry(s, column) - known(s, column));
            let v = DVector::from_fn(n, |t, _| (entry(row, t) - known(row, t)) / pivot);
            let cross = residual.column(at.1) * residual.row(at.0) / pivot;
            residual -= cross;
            terms.push([u, v]);
        }
        let columns = |side: usize| {
            let columns: Vec<_> = terms.iter().map(|term| term[side].clone()).collect();
            DMatrix::from_fn(n, columns.len(), |i, j| columns[j][i])
        };
        let back = columns(0);
        Products {
            in_order: DMatrix::from_fn(n, back.ncols(), |i, j| back[(n - 1 - i, j)]),
            back,
            on: columns(1),
        }
    }
}

/// Numbers below n: all of the first, then ever farther apart, and the last.
fn spread(n: usize) -> Vec<usize> {
    let mut numbers = Vec::new();
    let mut next = 0;
    while next < n - 1 {
        numbers.push(next);
        next += (next / 8).max(1);
    }
    numbers.push(n - 1);
    numbers
}

/// Data shared by all factors of a grid.
pub struct LineKernel {
    n: usize,
    /// k(0), k(1), …
    values: Vec<f64>,
    /// Between the halves of the whole row, of its halves, and so on.
    products: Vec<Products>,
}

impl LineKernel {
    /// For n unknowns and influence coefficients of nodes 0, 1, … n + 1 apart.
    pub fn new(values: &[f64], n: usize) -> LineKernel {
        let mut products = Vec::new();
        let mut size = n;
        while size > DENSE {
            size = size.div_ceil(2);
            products.push(Products::new(values, size));
        }
        LineKernel {
            n,
            values: values.to_vec(),
            products,
        }
    }

    fn at(&self, from: usize, to: usize) -> f64 {
        self.values[from.abs_diff(to)]
    }
}

/// M⁻¹ of a block.
enum Block {
    Dense(LU<f64, Dyn, Dyn>),
    Halved(Box<Halves>),
}

/// Two halves and what couples them.
struct Halves {
    blocks: [Block; 2],
    /// Y of both.
    answers: [DMatrix<f64>; 2],
    /// Entries of the exact rows next to the middle in the other half: in the second half for the first row, in the first for the second.
    exact: [DVector<f64>; 2],
    small: LU<f64, Dyn, Dyn>,
    /// Nodes of the first half.
    middle: usize,
}

/// The factors.
pub struct LineFactors<'a> {
    kernel: &'a LineKernel,
    whole: Block,
}

impl<'a> LineFactors<'a> {
    /// Of these rows; `None` where a block is singular.
    pub fn new(kernel: &'a LineKernel, rows: &[Triple]) -> Option<LineFactors<'a>> {
        debug_assert_eq!(rows.len(), kernel.n);
        Some(LineFactors {
            kernel,
            whole: kernel.factorised(rows, 0)?,
        })
    }

    /// Solves in place.
    pub fn solve(&self, b: &mut [f64]) {
        let n = b.len();
        let view = DMatrixViewMut::from_slice(b, n, 1);
        self.kernel.solve(&self.whole, view, 0);
    }
}

impl LineKernel {
    fn factorised(&self, rows: &[Triple], depth: usize) -> Option<Block> {
        let n = rows.len();
        let Some(products) = self.products.get(depth).filter(|_| n > DENSE) else {
            return self.dense(rows);
        };
        let middle = n.div_ceil(2);
        let (first, second) = rows.split_at(middle);
        let halves = [first, second].map(|rows| move || self.factorised(rows, depth + 1));
        let [a, b] = halves;
        let (a, b) = match n > SPLIT {
            true => rayon::join(a, b),
            false => (a(), b()),
        };
        let blocks = [a?, b?];
        let mut answers = [
            self.coupling_of_first(products, first),
            self.coupling_of_second(products, second),
        ];
        for (block, answer) in blocks.iter().zip(&mut answers) {
            self.solve(block, answer.as_view_mut(), depth + 1);
        }
        let (last, next) = (&first[middle - 1], &second[0]);
        let mut exact = [
            DVector::from_fn(n - middle, |t, _| last.by_film[2] * self.values[t]),
            DVector::from_fn(middle, |i, _| next.by_film[0] * self.at(middle - 1, i)),
        ];
        exact[0][0] += last.by_pressure[2];
        exact[1][middle - 1] += next.by_pressure[0];
        let r = products.on.ncols() + 1;
        let mut small = DMatrix::identity(2 * r, 2 * r);
        let [by_second, by_first] = self.felt(products, &exact, [&answers[0], &answers[1]]);
        small.view_mut((0, r), (r, r)).copy_from(&by_second);
        small.view_mut((r, 0), (r, r)).copy_from(&by_first);
        let small = small.lu();
        small.is_invertible().then_some(())?;
        Some(Block::Halved(Box::new(Halves {
            blocks,
            answers,
            exact,
            small,
            middle,
        })))
    }

    fn dense(&self, rows: &[Triple]) -> Option<Block> {
        let n = rows.len();
        let mut matrix = DMatrix::zeros(n, n);
        for (i, row) in rows.iter().enumerate() {
            for (d, (a, b)) in row.by_pressure.iter().zip(row.by_film).enumerate() {
                // Of the node before, itself, the one behind: counted from one before the block.
                let at = i + d;
                if (1..=n).contains(&at) {
                    matrix[(i, at - 1)] += a;
                }
                if b != 0.0 {
                    for j in 0..n {
                        matrix[(i, j)] += b * self.at(at, j + 1);
                    }
                }
            }
        }
        let lu = matrix.lu();
        lu.is_invertible().then_some(Block::Dense(lu))
    }

    /// U₁: products for the films that lie in the first half or before it, and the exact row for that of the first node of the second.
    fn coupling_of_first(&self, products: &Products, rows: &[Triple]) -> DMatrix<f64> {
        let (m, r) = (rows.len(), products.back.ncols());
        let mut u = DMatrix::zeros(m, r + 1);
        for (i, row) in rows.iter().enumerate() {
            for (d, b) in row.by_film.iter().enumerate() {
                // Steps back from the middle, s = m − i for the node itself.
                if let Some(s) = (m - i + 1 - d).checked_sub(1).filter(|_| *b != 0.0) {
                    for c in 0..r {
                        u[(i, c)] += b * products.back[(s, c)];
                    }
                }
            }
        }
        u[(m - 1, r)] = 1.0;
        u
    }

    /// U₂, the mirror image.
    fn coupling_of_second(&self, products: &Products, rows: &[Triple]) -> DMatrix<f64> {
        let (m, r) = (rows.len(), products.on.ncols());
        let mut u = DMatrix::zeros(m, r + 1);
        for (i, row) in rows.iter().enumerate() {
            for (d, b) in row.by_film.iter().enumerate() {
                if let Some(t) = (i + d).checked_sub(1).filter(|_| *b != 0.0) {
                    for c in 0..r {
                        u[(i, c)] += b * products.on[(t, c)];
                    }
                }
            }
        }
        u[(0, r)] = 1.0;
        u
    }

    /// V₁ᵀ of values on the second half, and V₂ᵀ of values on the first.
    fn felt(
        &self,
        products: &Products,
        exact: &[DVector<f64>; 2],
        [first, second]: [&DMatrix<f64>; 2],
    ) -> [DMatrix<f64>; 2] {
        let r = products.on.ncols();
        let rows = products.in_order.nrows();
        let stacked = |basis: DMatrix<f64>, exact: &DVector<f64>, values: &DMatrix<f64>| {
            let mut felt = DMatrix::zeros(r + 1, values.ncols());
            felt.rows_mut(0, r).copy_from(&basis);
            felt.row_mut(r).copy_from(&exact.tr_mul(values));
            felt
        };
        let on = products.on.rows(0, second.nrows()).tr_mul(second);
        let back = (products.in_order)
            .rows(rows - first.nrows(), first.nrows())
            .tr_mul(first);
        [
            stacked(on, &exact[0], second),
            stacked(back, &exact[1], first),
        ]
    }

    fn solve(&self, block: &Block, mut b: DMatrixViewMut<f64>, depth: usize) {
        let halves = match block {
            Block::Dense(lu) => {
                // Its factors are not singular.
                lu.solve_mut(&mut b);
                return;
            }
            Block::Halved(halves) => halves,
        };
        let (middle, n) = (halves.middle, b.nrows());
        let products = &self.products[depth];
        let of_rows = [(0, middle), (middle, n - middle)];
        for (block, (start, length)) in halves.blocks.iter().zip(of_rows) {
            self.solve(block, b.rows_mut(start, length).as_view_mut(), depth + 1);
        }
        let [first, second] = of_rows.map(|(start, length)| b.rows(start, length).into_owned());
        let [by_second, by_first] = self.felt(products, &halves.exact, [&first, &second]);
        let r = by_second.nrows();
        let mut t = DMatrix::zeros(2 * r, b.ncols());
        t.rows_mut(0, r).copy_from(&by_second);
        t.rows_mut(r, r).copy_from(&by_first);
        halves.small.solve_mut(&mut t);
        for (answer, ((start, length), from)) in
            halves.answers.iter().zip(of_rows.into_iter().zip([0, r]))
        {
            b.rows_mut(start, length)
                .gemm(-1.0, answer, &t.rows(from, r), 1.0);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows of a film equation whose flow by pressure falls by six decades along the line, broken at its end.
    fn rows(n: usize) -> Vec<Triple> {
        (0..n)
            .map(|i| {
                let x = i as f64 / n as f64;
                let flow = 10_f64.powf(2.0 - 6.0 * x);
                match x < 0.9 {
                    true => Triple {
                        by_pressure: [-flow, 2.1 * flow, -1.1 * flow],
                        by_film: [-1.0, 1.0 + 0.3 * x, 0.2 * (1.0 - x)],
                    },
                    false => Triple {
                        by_pressure: [0.0, 1.0, 0.0],
                        by_film: [0.0; 3],
                    },
                }
            })
            .collect()
    }

    /// −ln of the distance over some length, over a cell.
    fn kernel(n: usize) -> Vec<f64> {
        let h = 20.0 / n as f64;
        let primitive = |x: f64| x * (x.abs().ln() - 1.0);
        (0..=n + 1)
            .map(|d| {
                let [low, high] = [-0.5, 0.5].map(|side| primitive((d as f64 + side) * h));
                low - high
            })
            .collect()
    }

    /// The product with M written out gives back what was solved for, to the error of the products.
    #[test]
    fn solves_the_dense_equation() {
        for n in [50, 333, 1500] {
            let (values, rows) = (kernel(n), rows(n));
            let kernel = LineKernel::new(&values, n);
            let factors = LineFactors::new(&kernel, &rows).unwrap();
            let known: Vec<f64> = (0..n).map(|i| (0.7 * i as f64).sin() + 0.5).collect();
            let film = |i: i64| -> f64 {
                let of = |(j, p): (usize, &f64)| values[(i - j as i64).unsigned_abs() as usize] * p;
                known.iter().enumerate().map(of).sum()
            };
            let mut b: Vec<f64> = (0..n as i64)
                .map(|i| {
                    let row = &rows[i as usize];
                    let pressure = |i: i64| known.get(i as usize).copied().unwrap_or(0.0);
                    (0..3)
                        .map(|d| {
                            let at = i + d as i64 - 1;
                            let film = if row.by_film[d] == 0.0 { 0.0 } else { film(at) };
                            let pressure = if at < 0 { 0.0 } else { pressure(at) };
                            row.by_pressure[d] * pressure + row.by_film[d] * film
                        })
                        .sum()
                })
                .collect();
            factors.solve(&mut b);
            let norm = |v: &mut dyn Iterator<Item = f64>| v.map(|v| v * v).sum::<f64>().sqrt();
            let error = norm(&mut b.iter().zip(&known).map(|(a, b)| a - b));
            let size = norm(&mut known.iter().copied());
            let most = if n <= DENSE { 1e-9 } else { 3e-2 };
            assert!(error < most * size, "{n}: {}", error / size);
        }
    }

    /// Halves of a thousand nodes take a handful of products.
    #[test]
    fn few_products_are_enough() {
        let values = kernel(2000);
        let products = Products::new(&values, 1000);
        let mut worst = 0.0_f64;
        for s in 0..=1000 {
            for t in (0..=1000).step_by(7) {
                let sum: f64 = (0..products.on.ncols())
                    .map(|c| products.back[(s, c)] * products.on[(t, c)])
                    .sum();
                worst = worst.max((sum - values[s + 1 + t]).abs());
            }
        }
        let largest = values.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        assert!(worst < 10.0 * TOLERANCE * largest, "{worst} of {largest}");
        assert!(products.on.ncols() <= 10, "{}", products.on.ncols());
    }
}
