//! Factorisation of a matrix of stencils on a rectangle of unknowns.

use ertel_fem::assembly::NodeGraph;
use ertel_fem::linear::frontal_lu::FrontalPattern;
use ertel_fem::linear::fronts::Blocks;
use ertel_fem::linear::ordering::{FillReduction, OrderingError};

use super::stencil::{Layout, PLACES, REACH, Row, SIDE};

/// Nodes along each side of the blocks that are eliminated together: stencils reach neighbouring blocks alone.
const BLOCK: usize = 2;

/// The order of elimination.
///
/// # Errors
/// When none is found.
pub fn pattern(layout: Layout) -> Result<FrontalPattern, OrderingError> {
    let n = layout.n;
    let blocks = n.map(|n| n.div_ceil(BLOCK));
    let members = |block: [usize; 2]| -> Vec<u32> {
        let along = |d: usize| block[d] * BLOCK..((block[d] + 1) * BLOCK).min(n[d]);
        let rows = along(1);
        rows.flat_map(|j| along(0).map(move |i| (j * n[0] + i) as u32))
            .collect()
    };
    let all = (0..blocks[1]).flat_map(|j| (0..blocks[0]).map(move |i| [i, j]));
    let near = |at: usize, n: usize| at.saturating_sub(1)..(at + 2).min(n);
    let mut graph = NodeGraph {
        offsets: vec![0],
        neighbours: Vec::new(),
    };
    for [i, j] in all.clone() {
        for row in near(j, blocks[1]) {
            let others = near(i, blocks[0]).map(|column| (row * blocks[0] + column) as u32);
            graph.neighbours.extend(others);
        }
        graph.offsets.push(graph.neighbours.len());
    }
    let blocks = Blocks {
        graph: &graph,
        n_inner: blocks[0] * blocks[1],
        carriers: None,
        reduction: FillReduction::MinimumDegree,
        unknowns: all.map(members).collect(),
    };
    let entries: Vec<(u32, u32)> = (0..layout.unknowns())
        .flat_map(|row| neighbours(layout, row).map(move |(_, column)| (row as u32, column)))
        .collect();
    FrontalPattern::new(&blocks, &entries)
}

/// A factorisation with that pattern.
pub fn values(layout: Layout, rows: &[Row]) -> Vec<f64> {
    (rows.iter().enumerate())
        .flat_map(|(k, row)| neighbours(layout, k).map(|(place, _)| f64::from(row[place])))
        .collect()
}

/// Unknowns that the stencil of one reaches, with their places in it.
fn neighbours(layout: Layout, unknown: usize) -> impl Iterator<Item = (usize, u32)> {
    let [nx, ny] = layout.n;
    let [i, j] = [unknown % nx, unknown / nx];
    (0..PLACES).filter_map(move |place| {
        let [x, y] = [i + place % SIDE, j + place / SIDE];
        let inside = (REACH..REACH + nx).contains(&x) && (REACH..REACH + ny).contains(&y);
        inside.then(|| (place, ((y - REACH) * nx + x - REACH) as u32))
    })
}
