//! The cycle against products step by step and against the factorisation, on grids of many sizes.

use super::super::preconditioner::{Pattern, Preconditioner};
use super::super::stencil::{Layout, Lines, REACH, Row, SIDE};
use super::super::tests::{problem, solved};
use super::*;
use crate::contact::Motion;
use ertel_fem::linear::gmres::GmresParams;

/// A number between −1 and 1 for every k.
fn scattered(k: usize) -> f32 {
    (12.9898 * k as f32).sin()
}

/// Entries that differ from place to place, none beyond the rectangle, and sizes from 1 to 1e4; every third row is of the other kind.
fn some_matrix(layout: Layout) -> Matrix {
    let [nx, ny] = layout.n;
    let row = |k: usize| -> Row {
        std::array::from_fn(|t| {
            let [x, y] = [k % nx + t % SIDE, k / nx + t / SIDE];
            let inside = (REACH..REACH + nx).contains(&x) && (REACH..REACH + ny).contains(&y);
            if inside { scattered(31 * k + t) } else { 0.0 }
        })
    };
    let all = 0..layout.unknowns();
    Matrix {
        rows: all.clone().map(row).collect(),
        sizes: all.clone().map(|k| 10_f32.powi((k % 5) as i32)).collect(),
        wetted: all.map(|k| k % 3 != 0).collect(),
    }
}

/// The coarse matrix times a vector equals interpolation, fine matrix and restriction, one after the other: odd and even numbers of
/// nodes, halves and wholes.
#[test]
fn coarse_matrix_is_the_product() {
    for (n, half) in [
        ([12, 9], true),
        ([13, 10], true),
        ([12, 9], false),
        ([9, 12], false),
    ] {
        let grids = Grids::new(n, half, 40).unwrap();
        assert!(!grids.is_direct());
        let (fine, first) = grids.finer[0];
        let coarse = grids
            .finer
            .get(1)
            .map_or(grids.coarsest, |(layout, _)| *layout);
        let transfer = Transfer {
            fine,
            coarse,
            first,
            half,
        };
        let matrix = some_matrix(fine);
        let product = transfer.product(&matrix);
        let mut w = vec![0.0; coarse.size()];
        for k in 0..coarse.unknowns() {
            w[coarse.at(k % coarse.n[0], k / coarse.n[0])] = scattered(k);
        }
        let [mut x, mut r, zero] = [fine.size(), fine.size(), fine.size()].map(|n| vec![0.0; n]);
        transfer.prolong(&w, &mut x);
        residual(&Lines::new(fine, &matrix.rows), &zero, &x, &mut r);
        let mut by_steps = vec![0.0; coarse.size()];
        transfer.restrict(
            &matrix,
            [&product.sizes, &r],
            &product.wetted,
            &mut by_steps,
        );
        let mut at_once = vec![0.0; coarse.size()];
        let zero = vec![0.0; coarse.size()];
        let product_lines = Lines::new(coarse, &product.rows);
        residual(&product_lines, &zero, &w, &mut at_once);
        for (a, b) in at_once.iter().zip(&by_steps) {
            assert!((a - b).abs() < 1e-5, "{n:?} {half}: {a} {b}");
        }
    }
}

/// Each cycle leaves less than 0.6 of the residual (0.5 but on patches that end at an edge of the contact area, whose number of unknowns is even) on solved grids with 3,000 to 33,000 unknowns, whose coefficients change by ten decades, however many
/// coarser grids there are below; and Newton's step is that by a factorisation.
#[test]
fn cycles_converge_on_all_grids() {
    let mut problem = problem(&Motion::straight(0.8, 0.0), 1e-9);
    problem.plan.max_unknowns = 35_000;
    let found = solved(&problem);
    assert!(found.levels.last().unwrap().system.grid.n_nodes() > 25_000);
    for level in found.levels.iter().skip(2) {
        let (system, grid) = (&level.system, &level.system.grid);
        let at = system.linearise(&level.state);
        let pattern = Pattern::with_coarsest(grid, &system.convolution, 400).unwrap();
        let mut cycle = Cycle::new(&pattern.grids, pattern.matrix(&at)).unwrap();
        let layout = cycle.levels[0].transfer.fine;
        let all =
            || (0..layout.unknowns()).map(|k| (k, layout.at(k % layout.n[0], k / layout.n[0])));
        let mut b = vec![0.0; layout.size()];
        all().for_each(|(k, at)| b[at] = scattered(k));
        let (mut x, mut r) = (vec![0.0; b.len()], b.clone());
        let norm = |v: &[f32]| v.iter().map(|v| f64::from(v * v)).sum::<f64>().sqrt();
        for _ in 0..6 {
            let mut w: Vec<f64> = all().map(|(_, at)| r[at].into()).collect();
            cycle.solve(&mut w);
            all().for_each(|(k, at)| x[at] += w[k] as f32);
            residual(&cycle.levels[0].lines, &b, &x, &mut r);
        }
        let residual = norm(&r) / norm(&b);
        assert!(
            residual < 0.6_f64.powi(6),
            "{}: {residual:.1e}",
            grid.n_nodes()
        );
        let params = GmresParams {
            tolerance: 1e-7,
            max_iterations: 60,
            ..GmresParams::default()
        };
        let mut state = level.state.clone();
        state.pressure.iter_mut().for_each(|p| *p *= 1.01);
        let at = system.linearise(&state);
        let own = Preconditioner::new(&pattern, &at).unwrap();
        let direct = Preconditioner::factorised(&pattern, &at).unwrap();
        assert!(!own.is_direct && direct.is_direct);
        let [own, direct] = [own, direct].map(|mut p| system.step(&at, &state, &mut p, params));
        assert!(own.krylov_iterations < 60 && own.krylov_iterations < 2 * direct.krylov_iterations);
        let size = direct.pressure.iter().fold(0.0_f64, |m, p| m.max(p.abs()));
        for (a, b) in own.pressure.iter().zip(&direct.pressure) {
            assert!((a - b).abs() < 1e-4 * size, "{a} {b} of {size}");
        }
    }
}
