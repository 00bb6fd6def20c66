use std::sync::Arc;

use super::*;
use crate::assembly::NodeGraph;
use crate::linear::fronts::Blocks;
use crate::linear::ordering::FillReduction;
use approx::assert_relative_eq;
use faer::Mat;
use faer::linalg::solvers::Solve;

/// A grid of groups of one to three unknowns with entries from a formula, duplicates among them:
/// solves with the matrix equal those of dense linear algebra in
/// single precision.
#[test]
fn equals_dense_linear_algebra() {
    let (nx, ny) = (23, 17);
    let near = |i: usize, j: usize| {
        let (x, y) = (i % nx, i / nx);
        let (u, v) = (j % nx, j / nx);
        x.abs_diff(u) <= 1 && y.abs_diff(v) <= 1
    };
    let mut graph = NodeGraph {
        offsets: vec![0],
        neighbours: Vec::new(),
    };
    for i in 0..nx * ny {
        graph
            .neighbours
            .extend((0..nx * ny).filter(|j| near(i, *j)).map(|j| j as u32));
        graph.offsets.push(graph.neighbours.len());
    }
    let mut n = 0;
    let unknowns: Vec<Vec<u32>> = (0..nx * ny)
        .map(|i| {
            let own = (n..n + 1 + i as u32 % 3).collect();
            n += 1 + i as u32 % 3;
            own
        })
        .collect();
    let mut entries = Vec::new();
    let mut values = Vec::new();
    for i in 0..nx * ny {
        for j in graph.of(i) {
            for a in &unknowns[i] {
                for b in &unknowns[*j as usize] {
                    let v = (1.3 * *a as f64 + 0.7 * *b as f64).sin();
                    entries.push((*a, *b));
                    values.push(0.5 * v);
                    entries.push((*a, *b));
                    values.push(0.5 * v + if a == b { 9.0 } else { 0.0 });
                }
            }
        }
    }
    let n = n as usize;
    let blocks = Blocks {
        graph: &graph,
        unknowns,
        n_inner: nx * ny,
        carriers: None,
        reduction: FillReduction::MinimumDegree,
    };
    let pattern = Arc::new(FrontalPattern::new(&blocks, &entries).unwrap());
    assert!(pattern.fronts.fronts.len() > 10);
    let mut lu = FrontalLu::new(&pattern, &values).unwrap();
    let mut dense = Mat::<f64>::zeros(n, n);
    for ((i, j), v) in entries.iter().zip(&values) {
        dense[(*i as usize, *j as usize)] += v;
    }
    let b: Vec<f64> = (0..n).map(|i| (0.1 * i as f64).cos()).collect();
    let column = Mat::from_fn(n, 1, |i, _| b[i]);
    let mut x = b.clone();
    lu.solve(&mut x);
    let exact = dense.partial_piv_lu().solve(&column);
    for i in 0..n {
        assert_relative_eq!(x[i], exact[(i, 0)], epsilon = 1e-6);
    }
    let again = FrontalLu::new(&pattern, &values).unwrap();
    assert_eq!(again.factors, lu.factors);
}

#[test]
fn singular_block_is_refused() {
    let graph = NodeGraph {
        offsets: vec![0, 1],
        neighbours: vec![0],
    };
    let blocks = Blocks {
        graph: &graph,
        unknowns: vec![vec![0, 1]],
        n_inner: 1,
        carriers: None,
        reduction: FillReduction::MinimumDegree,
    };
    let entries = [(0, 0), (0, 1), (1, 0), (1, 1)];
    let pattern = Arc::new(FrontalPattern::new(&blocks, &entries).unwrap());
    let e = FrontalLu::new(&pattern, &[1.0, 2.0, 2.0, 4.0]).unwrap_err();
    assert_eq!(e, FrontalError { size: 2 });
}
