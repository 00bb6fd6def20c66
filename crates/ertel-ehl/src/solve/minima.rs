//! Minima of the film other than the lowest.
//!
//! The film of a point contact is thin in two side lobes, and on the centreline. Where two of them are nearly as deep, errors of the mesh
//! decide which is the lowest, and a mesh that is refined for one alone finds the other on the next.

use super::discretisation::Discretisation;
use super::evaluate::{refined, thinnest_points};
use super::neighbours::Neighbours;
use super::state::State;
use crate::engine::hills::root;
use crate::solve::tuning::refinement::{NEARLY_AS_DEEP, RIDGE};

/// The deepest of the minima other than the lowest, if it is nearly as deep: film and place. Of contact areas that are lines, none.
pub(super) fn rival_minimum(
    d: &Discretisation,
    state: &State,
    neighbours: &Neighbours,
    (lowest, _): (f64, [f64; 2]),
) -> Option<(f64, [f64; 2])> {
    if d.contact.surface.dim < 2 || lowest <= 0.0 {
        return None;
    }
    let points = thinnest_points(d, state);
    let films: Vec<f64> = points.iter().map(|p| p.film).collect();
    let second = second_minimum(&films, &neighbours.of, RIDGE)?;
    let (film, place) = refined(d, state, points[second]);
    (film <= NEARLY_AS_DEEP * lowest).then_some((film, place))
}

/// The element of the second lowest of the minima that ridges of `ridge` times their value separate from lower ones.
///
/// Elements are flooded from the lowest up; where two basins meet, the less deep ends, and counts if the water has risen enough.
fn second_minimum(values: &[f64], neighbours: &[Vec<u32>], ridge: f64) -> Option<usize> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|a, b| values[*a].total_cmp(&values[*b]).then(a.cmp(b)));
    let lowest = *order.first()?;
    const DRY: usize = usize::MAX;
    // Basins by their lowest elements: each flooded element leads to that of its basin.
    let mut towards = vec![DRY; values.len()];
    let mut second: Option<usize> = None;
    for &c in &order {
        towards[c] = c;
        for &n in &neighbours[c] {
            if towards[n as usize] == DRY {
                continue;
            }
            let (a, b) = (root(&mut towards, c), root(&mut towards, n as usize));
            if a == b {
                continue;
            }
            let deeper = (values[a], a) <= (values[b], b);
            let (deep, shallow) = if deeper { (a, b) } else { (b, a) };
            towards[shallow] = deep;
            let counts = values[c] >= ridge * values[shallow];
            if counts && second.is_none_or(|s| (values[shallow], shallow) < (values[s], s)) {
                second = Some(shallow);
            }
        }
    }
    debug_assert!(second != Some(lowest));
    second
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A row of elements.
    fn second(values: &[f64]) -> Option<usize> {
        let n = values.len() as u32;
        let neighbours: Vec<Vec<u32>> = (0..n)
            .map(|c| {
                let before = c.checked_sub(1).into_iter();
                before.chain((c + 1 < n).then_some(c + 1)).collect()
            })
            .collect();
        second_minimum(values, &neighbours, 1.1)
    }

    /// By hand: of the minima 2, 3 and 2.5, the last is the second lowest; a ripple of 2.4 behind 2.5 is none, and where the ridge
    /// between two is less than a tenth above the higher, they are one.
    #[test]
    fn a_minimum_lies_behind_a_ridge() {
        assert_eq!(second(&[9.0, 2.0, 8.0, 3.0, 7.0, 2.5, 9.0]), Some(5));
        assert_eq!(second(&[9.0, 2.0, 8.0, 2.4, 2.5, 2.45, 9.0]), Some(3));
        assert_eq!(second(&[9.0, 2.0, 2.15, 2.0, 9.0]), None);
        assert_eq!(second(&[9.0, 2.0, 2.3, 2.0, 9.0]), Some(3));
        assert_eq!(second(&[1.0, 2.0, 3.0]), None);
    }
}
