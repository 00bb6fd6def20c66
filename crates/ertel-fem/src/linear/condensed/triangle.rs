//! Lower triangles of fronts: the updates from a front to its parent.

use rayon::prelude::*;

use super::plan::NOWHERE;
use crate::linear::fronts::{Front, Fronts};

/// Update that a front passes to its parent: the lower triangle over its boundary, column by column. The last front
/// passes its whole square.
pub(super) type Left = Vec<f64>;

/// Order of a front from which its columns are dealt to the cores.
const WIDE: usize = 600;

/// Calls `f` on each column of a square matrix.
pub(super) fn on_columns(entries: &mut [f64], order: usize, f: impl Fn(usize, &mut [f64]) + Sync) {
    let f = |(j, column): (usize, &mut [f64])| f(j, column);
    if order < WIDE {
        entries
            .chunks_exact_mut(order.max(1))
            .enumerate()
            .for_each(f);
    } else {
        entries.par_chunks_exact_mut(order).enumerate().for_each(f);
    }
}

/// Lower triangle of the columns from the n-th on, packed.
pub(super) fn lower_triangle(columns: &[f64], order: usize, n: usize) -> Vec<f64> {
    let m = order - n;
    let length = m * (m + 1) / 2;
    let columns = columns.chunks_exact(order.max(1)).zip(n..);
    if m < WIDE {
        let mut packed = Vec::with_capacity(length);
        for (column, j) in columns {
            packed.extend_from_slice(&column[j..]);
        }
        return packed;
    }
    let mut packed = vec![0.0; length];
    let mut rest = &mut packed[..];
    let mut targets = Vec::with_capacity(m);
    for (column, j) in columns {
        let (target, beyond) = rest.split_at_mut(order - j);
        targets.push((target, &column[j..]));
        rest = beyond;
    }
    targets
        .into_par_iter()
        .for_each(|(target, column)| target.copy_from_slice(column));
    packed
}

/// Adds what the children of a front left to its lower triangle.
pub(super) fn add_children(fronts: &Fronts, front: &Front, left: &[Left], entries: &mut [f64]) {
    let order = front.size();
    let start = |j: usize, m: usize| j * m - j * j.saturating_sub(1) / 2;
    let children = || {
        let maps = front
            .children
            .iter()
            .map(|child| &fronts.fronts[*child].in_parent[..]);
        maps.zip(left)
    };
    let add = |target: &mut [f64], map: &[u32], left: &[f64], j: usize| {
        for (row, v) in map[j..].iter().zip(&left[start(j, map.len())..]) {
            target[*row as usize] += v;
        }
    };
    if order < WIDE {
        for (map, left) in children() {
            for (j, column) in map.iter().enumerate() {
                add(
                    &mut entries[*column as usize * order..][..order],
                    map,
                    left,
                    j,
                );
            }
        }
        return;
    }
    // For each column of the front, that of each child.
    let of_children: Vec<Vec<usize>> = children()
        .map(|(map, _)| {
            let mut columns = vec![NOWHERE; order];
            for (j, column) in map.iter().enumerate() {
                columns[*column as usize] = j;
            }
            columns
        })
        .collect();
    on_columns(entries, order, |k, target| {
        for ((map, left), columns) in children().zip(&of_children) {
            if columns[k] != NOWHERE {
                add(target, map, left, columns[k]);
            }
        }
    });
}
