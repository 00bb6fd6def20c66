use super::*;
use crate::assembly::assemble_symmetric;
use crate::linear::NEVER;
use crate::mesh::SimplexMesh;
use crate::space::Space;
use approx::assert_relative_eq;
use faer::Mat;
use faer::linalg::solvers::Solve;

/// A strip of triangles with a symmetric positive definite element matrix, against dense
/// linear algebra: condensed entries, compliance and full solve.
#[test]
fn condensed_block_equals_dense_schur_complement() {
    let n_cells = 12;
    let mesh = SimplexMesh {
        dim: 2,
        axes: [0, 1, 2],
        vertices: (0..n_cells + 2)
            .map(|i| [i as f64 * 0.5, (i % 2) as f64, 0.0])
            .collect(),
        cells: (0..n_cells as u32).map(|i| [i, i + 1, i + 2, 0]).collect(),
    };
    let space = Space::new(&mesh, 2);
    let graph = NodeGraph::new(&space);
    let dofs = DofMap::new(space.n_nodes(), 2, |n, c| n > 1 || c == 1);
    let element = |cell: usize, out: &mut [f64]| {
        for i in 0..12 {
            for j in 0..12 {
                out[i * 12 + j] = 0.1 * ((i * j + cell) as f64).cos().abs().min(0.3)
                    + if i == j { 4.0 } else { 0.0 };
            }
        }
    };
    let matrix = assemble_symmetric(&space, &graph, &dofs, element);
    let n = matrix.n;
    let condensed: Vec<usize> = (0..n).filter(|d| d % 3 == 0).collect();
    let factorise =
        |keep| CondensedStiffness::new(&space, &graph, &dofs, &condensed, keep, element, NEVER);
    let stiffness = factorise(Keep::Factor).unwrap();

    let mut dense = Mat::<f64>::zeros(n, n);
    for j in 0..n {
        for k in matrix.col_ptr[j]..matrix.col_ptr[j + 1] {
            dense[(matrix.row_idx[k], j)] = matrix.values[k];
            dense[(j, matrix.row_idx[k])] = matrix.values[k];
        }
    }
    let inverse = dense.partial_piv_lu().solve(Mat::<f64>::identity(n, n));
    let m = condensed.len();
    // The compliance seen on c is the c-c block of K⁻¹.
    let compliance = Mat::from_fn(m, m, |i, j| inverse[(condensed[i], condensed[j])]);
    let schur = compliance
        .partial_piv_lu()
        .solve(Mat::<f64>::identity(m, m));
    let ours = factorise(Keep::Factor).unwrap().into_compliance().unwrap();
    let condensed_only = factorise(Keep::Condensed).unwrap();
    assert_eq!(ours, condensed_only.into_compliance().unwrap());
    for i in 0..m {
        for j in 0..m {
            assert_relative_eq!(ours.get(j, i), compliance[(j, i)], epsilon = 1e-13);
            let entry = stiffness.condensed_entry(i, j);
            assert_relative_eq!(entry, schur[(i, j)], epsilon = 1e-11);
        }
    }
    let mut rhs: Vec<f64> = (0..n).map(|i| (i as f64).sin()).collect();
    let exact: Vec<f64> = (0..n)
        .map(|i| (0..n).map(|j| inverse[(i, j)] * (j as f64).sin()).sum())
        .collect();
    stiffness.solve_full(&mut rhs).unwrap();
    for (a, b) in rhs.iter().zip(&exact) {
        assert_relative_eq!(a, b, epsilon = 1e-12);
    }
}

/// A body that nothing holds is refused, not solved.
#[test]
fn singular_stiffness_is_refused() {
    let mesh = SimplexMesh {
        dim: 2,
        axes: [0, 1, 2],
        vertices: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        cells: vec![[0, 1, 2, 0]],
    };
    let space = Space::new(&mesh, 1);
    let graph = NodeGraph::new(&space);
    let dofs = DofMap::new(3, 1, |_, _| true);
    let element = |_: usize, out: &mut [f64]| {
        out.copy_from_slice(&[1.0, -2.0, 0.0, -2.0, 1.0, 0.0, 0.0, 0.0, 1.0]);
    };
    assert!(matches!(
        CondensedStiffness::new(&space, &graph, &dofs, &[2], Keep::Condensed, element, NEVER),
        Err(CholeskyError::NotPositiveDefinite { .. })
    ));
}
