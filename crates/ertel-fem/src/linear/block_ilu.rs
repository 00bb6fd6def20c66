//! Sparse matrices of square blocks and their incomplete factorisation, for columns of unknowns over the nodes
//! of a surface.
//!
//! ```text
//!   A ≈ (D + L) D⁻¹ (D + U),   D_i = A_ii − Σ_{k<i} A_ik D_k⁻¹ A_ki      on the pattern of A
//! ```
//! Block rows are eliminated in their order; where that follows a flow, little is lost.

use faer::Mat;
use faer::linalg::solvers::DenseSolveCore;

use super::dense::{add_product, vectorised};
use crate::assembly::NodeGraph;
use crate::kernel;

/// Matrix of square blocks; each is stored column by column.
#[derive(Clone, Debug)]
pub struct BlockMatrix {
    /// Unknowns of a block row.
    n: usize,
    /// Pattern: block columns of each block row, ascending.
    graph: NodeGraph,
    values: Vec<f64>,
}

impl BlockMatrix {
    /// Zero matrix with blocks of `n` by `n` where `graph` has neighbours.
    pub fn new(n: usize, graph: NodeGraph) -> BlockMatrix {
        let values = vec![0.0; n * n * graph.neighbours.len()];
        BlockMatrix { n, graph, values }
    }

    /// Sets every entry to zero.
    pub fn clear(&mut self) {
        self.values.fill(0.0);
    }

    /// Block of a pair of neighbours, column by column.
    ///
    /// # Panics
    /// When they are no neighbours.
    pub fn block_mut(&mut self, row: u32, column: u32) -> &mut [f64] {
        let k = position(&self.graph, row as usize, column).expect("neighbours");
        let size = self.n * self.n;
        &mut self.values[k * size..(k + 1) * size]
    }

    /// Makes row `k` of a block row that of the unit matrix.
    pub fn fix(&mut self, row: u32, k: usize) {
        let (n, row) = (self.n, row as usize);
        for b in self.graph.offsets[row]..self.graph.offsets[row + 1] {
            let diagonal = self.graph.neighbours[b] as usize == row;
            let block = &mut self.values[b * n * n..(b + 1) * n * n];
            for (j, value) in block.iter_mut().skip(k).step_by(n).enumerate() {
                *value = if diagonal && j == k { 1.0 } else { 0.0 };
            }
        }
    }

    /// y = A x.
    pub fn multiply(&self, x: &[f64], y: &mut [f64]) {
        vectorised(Multiply { matrix: self, x, y });
    }

    #[inline(always)]
    fn multiply_here(&self, x: &[f64], y: &mut [f64]) {
        let n = self.n;
        for (i, y) in y.chunks_exact_mut(n).enumerate() {
            y.fill(0.0);
            for b in self.graph.offsets[i]..self.graph.offsets[i + 1] {
                let j = self.graph.neighbours[b] as usize;
                let block = &self.values[b * n * n..(b + 1) * n * n];
                add_product(block, &x[j * n..(j + 1) * n], y);
            }
        }
    }
}

kernel! {
    Multiply ['a] ['a] (matrix: &'a BlockMatrix, x: &'a [f64], y: &'a mut [f64]) -> () {
        matrix.multiply_here(x, y)
    }
}

kernel! {
    Factorise ['a] ['a] (ilu: &'a mut BlockIlu) -> Result<(), BlockIluError> {
        ilu.factorise()
    }
}

kernel! {
    Solve ['a] ['a] (ilu: &'a mut BlockIlu, x: &'a mut [f32]) -> () {
        ilu.solve_single(x)
    }
}

fn position(graph: &NodeGraph, row: usize, column: u32) -> Option<usize> {
    let found = graph.of(row).binary_search(&column).ok()?;
    Some(graph.offsets[row] + found)
}

/// A block on the diagonal cannot be inverted.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("the incomplete factorisation breaks down in block row {row}")]
pub struct BlockIluError {
    /// The block row.
    pub row: usize,
}

/// Incomplete factorisation in single precision: a preconditioner.
#[derive(Clone, Debug)]
pub struct BlockIlu {
    n: usize,
    graph: NodeGraph,
    /// A_ik left of the diagonal, D_i⁻¹ on it, D_i⁻¹A_ij right of it.
    values: Vec<f32>,
    scratch: [Vec<f32>; 2],
}

impl BlockIlu {
    /// Factorises.
    ///
    /// # Errors
    /// When a block on the diagonal is singular.
    pub fn new(matrix: &BlockMatrix) -> Result<BlockIlu, BlockIluError> {
        let n = matrix.n;
        let mut ilu = BlockIlu {
            n,
            graph: matrix.graph.clone(),
            values: matrix.values.iter().map(|v| *v as f32).collect(),
            scratch: [vec![0.0; n], vec![0.0; n]],
        };
        vectorised(Factorise { ilu: &mut ilu })?;
        Ok(ilu)
    }

    #[inline(always)]
    fn factorise(&mut self) -> Result<(), BlockIluError> {
        let (n, size) = (self.n, self.n * self.n);
        let mut product = vec![0.0_f32; size];
        let mut negative = vec![0.0_f32; size];
        for i in 0..self.graph.n_nodes() {
            let row = self.graph.offsets[i]..self.graph.offsets[i + 1];
            let diagonal = position(&self.graph, i, i as u32).ok_or(BlockIluError { row: i })?;
            for b in row.start..diagonal {
                let k = self.graph.neighbours[b] as usize;
                for (minus, v) in negative.iter_mut().zip(&self.values[b * size..]) {
                    *minus = -v;
                }
                // A_ij −= A_ik (D_k⁻¹A_kj) for the j > k that both rows have
                for c in self.graph.offsets[k]..self.graph.offsets[k + 1] {
                    let j = self.graph.neighbours[c];
                    if j as usize <= k {
                        continue;
                    }
                    let Some(target) = position(&self.graph, i, j) else {
                        continue;
                    };
                    product.copy_from_slice(&self.values[c * size..(c + 1) * size]);
                    let target = &mut self.values[target * size..(target + 1) * size];
                    for (y, x) in target.chunks_exact_mut(n).zip(product.chunks_exact(n)) {
                        add_product(&negative, x, y);
                    }
                }
            }
            let block = &mut self.values[diagonal * size..(diagonal + 1) * size];
            let inverse = inverse(block, n).ok_or(BlockIluError { row: i })?;
            block.copy_from_slice(&inverse);
            for b in diagonal + 1..row.end {
                let block = &mut self.values[b * size..(b + 1) * size];
                product.fill(0.0);
                for (y, x) in product.chunks_exact_mut(n).zip(block.chunks_exact(n)) {
                    add_product(&inverse, x, y);
                }
                block.copy_from_slice(&product);
            }
        }
        Ok(())
    }

    /// Solves in place.
    pub fn solve(&mut self, x: &mut [f64]) {
        let n = self.n;
        let mut single: Vec<f32> = x.iter().map(|v| *v as f32).collect();
        vectorised(Solve {
            ilu: self,
            x: &mut single,
        });
        for (x, v) in x.iter_mut().zip(single) {
            *x = f64::from(v);
        }
        debug_assert!(x.len().is_multiple_of(n));
    }

    #[inline(always)]
    fn solve_single(&mut self, x: &mut [f32]) {
        let (n, size) = (self.n, self.n * self.n);
        let [sum, result] = &mut self.scratch;
        let block = |b: usize| &self.values[b * size..(b + 1) * size];
        // z_i = D_i⁻¹(b_i − Σ A_ik z_k)
        for i in 0..self.graph.n_nodes() {
            sum.fill(0.0);
            for b in self.graph.offsets[i]..self.graph.offsets[i + 1] {
                let k = self.graph.neighbours[b] as usize;
                if k < i {
                    add_product(block(b), &x[k * n..(k + 1) * n], sum);
                    continue;
                }
                let own = &mut x[i * n..(i + 1) * n];
                for (s, v) in sum.iter_mut().zip(&*own) {
                    *s = v - *s;
                }
                result.fill(0.0);
                add_product(block(b), sum, result);
                own.copy_from_slice(result);
                break;
            }
        }
        // x_i = z_i − Σ D_i⁻¹A_ij x_j
        for i in (0..self.graph.n_nodes()).rev() {
            sum.fill(0.0);
            for b in (self.graph.offsets[i]..self.graph.offsets[i + 1]).rev() {
                let j = self.graph.neighbours[b] as usize;
                if j <= i {
                    break;
                }
                add_product(block(b), &x[j * n..(j + 1) * n], sum);
            }
            for (v, s) in x[i * n..(i + 1) * n].iter_mut().zip(&*sum) {
                *v -= s;
            }
        }
    }
}

/// Inverse in double precision; `None` if singular.
fn inverse(block: &[f32], n: usize) -> Option<Vec<f32>> {
    let matrix = Mat::from_fn(n, n, |i, j| f64::from(block[j * n + i]));
    let inverse = matrix.partial_piv_lu().inverse();
    let values = (0..n * n).map(|k| inverse[(k % n, k / n)] as f32);
    let values: Vec<f32> = values.collect();
    values.iter().all(|v| v.is_finite()).then_some(values)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::linear::gmres::{GmresParams, gmres};
    use faer::linalg::solvers::Solve;

    /// A chain of blocks is block tridiagonal: there the factorisation is complete.
    fn chain(n_rows: usize, n: usize) -> BlockMatrix {
        let mut graph = NodeGraph {
            offsets: vec![0],
            neighbours: Vec::new(),
        };
        for i in 0..n_rows {
            graph
                .neighbours
                .extend(i.saturating_sub(1) as u32..(i + 2).min(n_rows) as u32);
            graph.offsets.push(graph.neighbours.len());
        }
        let mut matrix = BlockMatrix::new(n, graph);
        for i in 0..n_rows {
            for j in i.saturating_sub(1)..(i + 2).min(n_rows) {
                let block = matrix.block_mut(i as u32, j as u32);
                for (k, v) in block.iter_mut().enumerate() {
                    *v = ((17 * i + 5 * j + k * k) as f64 * 12.9898).sin();
                }
                if i == j {
                    // a zero at the head of the diagonal: rows must be exchanged
                    block[0] = 0.0;
                }
            }
        }
        matrix
    }

    fn dense(matrix: &BlockMatrix, n_rows: usize) -> Mat<f64> {
        let n = matrix.n * n_rows;
        let mut a = Mat::zeros(n, n);
        for j in 0..n {
            let mut unit = vec![0.0; n];
            unit[j] = 1.0;
            let mut y = vec![0.0; n];
            matrix.multiply(&unit, &mut y);
            for (i, v) in y.into_iter().enumerate() {
                a[(i, j)] = v;
            }
        }
        a
    }

    #[test]
    fn chain_is_solved_as_by_dense_lu() {
        let (n_rows, n) = (6, 5);
        let matrix = chain(n_rows, n);
        let b: Vec<f64> = (0..n_rows * n).map(|i| (i as f64).cos()).collect();
        let right = Mat::from_fn(b.len(), 1, |i, _| b[i]);
        let exact = dense(&matrix, n_rows).partial_piv_lu().solve(&right);
        let mut ilu = BlockIlu::new(&matrix).unwrap();
        let mut x = vec![0.0; b.len()];
        let info = gmres(
            |x, y| matrix.multiply(x, y),
            |x| ilu.solve(x),
            &b,
            &mut x,
            GmresParams::default(),
        )
        .unwrap();
        // complete but for single precision
        assert!(info.iterations <= 4, "{}", info.iterations);
        for (i, x) in x.iter().enumerate() {
            assert!((x - exact[(i, 0)]).abs() < 1e-8 * exact.norm_max());
        }
    }

    #[test]
    fn fixed_rows_keep_their_values() {
        let mut matrix = chain(3, 4);
        matrix.fix(1, 2);
        let x: Vec<f64> = (0..12).map(f64::from).collect();
        let mut y = vec![0.0; 12];
        matrix.multiply(&x, &mut y);
        assert_eq!(y[6], 6.0);
        assert_ne!(y[5], 5.0);
    }

    #[test]
    fn singular_blocks_are_refused() {
        let mut matrix = chain(3, 4);
        matrix.clear();
        assert_eq!(
            BlockIlu::new(&matrix).unwrap_err(),
            BlockIluError { row: 0 }
        );
    }
}
