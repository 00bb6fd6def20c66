//! Regions and level lines of a field that is linear on triangles.

use std::collections::BTreeMap;

/// Corner of a region: a node, or the cut of the level through the edge between two nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Corner {
    Node(u32),
    Cut(u32, u32),
}

/// The part of a triangulation where the field is at least the level.
#[derive(Clone, Debug, Default)]
pub(super) struct Region {
    /// Closed boundaries, level lines and edges of the domain together.
    pub loops: Vec<Vec<[f64; 2]>>,
    /// The level lines alone; closed ones repeat their first point.
    pub level_lines: Vec<Vec<[f64; 2]>>,
}

/// Region {f ≥ level}; triangles in any orientation.
///
/// Each triangle contributes the directed edges of its clipped polygon; an edge shared by two
/// neighbours appears in both directions and drops out, what is left is the boundary.
pub(super) fn region(
    points: &[[f64; 2]],
    values: &[f64],
    triangles: &[[u32; 3]],
    level: f64,
) -> Region {
    let mut edges: BTreeMap<(Corner, Corner), usize> = BTreeMap::new();
    for triangle in triangles {
        let polygon = clip(points, values, triangle, level);
        for i in 0..polygon.len() {
            let (from, to) = (polygon[i], polygon[(i + 1) % polygon.len()]);
            match edges.get_mut(&(to, from)) {
                Some(n) if *n > 0 => *n -= 1,
                _ => *edges.entry((from, to)).or_default() += 1,
            }
        }
    }
    let boundary = edges
        .iter()
        .flat_map(|(edge, n)| std::iter::repeat_n(*edge, *n));
    let is_level = |e: &(Corner, Corner)| matches!(e, (Corner::Cut(..), Corner::Cut(..)));
    let place = |chain: Vec<Corner>| -> Vec<[f64; 2]> {
        chain
            .into_iter()
            .map(|c| position(points, values, level, c))
            .collect()
    };
    Region {
        loops: chains(boundary.clone()).into_iter().map(place).collect(),
        level_lines: chains(boundary.filter(is_level))
            .into_iter()
            .map(place)
            .collect(),
    }
}

/// Corners of the triangle's part with f ≥ level, counter-clockwise.
fn clip(points: &[[f64; 2]], values: &[f64], triangle: &[u32; 3], level: f64) -> Vec<Corner> {
    let [a, b, c] = triangle.map(|i| points[i as usize]);
    let area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
    let mut nodes = *triangle;
    if area < 0.0 {
        nodes.swap(1, 2);
    }
    let mut polygon = Vec::with_capacity(4);
    for i in 0..3 {
        let (from, to) = (nodes[i], nodes[(i + 1) % 3]);
        let inside = |n: u32| values[n as usize] >= level;
        if inside(from) {
            polygon.push(Corner::Node(from));
        }
        if inside(from) != inside(to) {
            polygon.push(Corner::Cut(from.min(to), from.max(to)));
        }
    }
    polygon
}

fn position(points: &[[f64; 2]], values: &[f64], level: f64, corner: Corner) -> [f64; 2] {
    match corner {
        Corner::Node(n) => points[n as usize],
        Corner::Cut(i, j) => {
            let ([xi, yi], [xj, yj]) = (points[i as usize], points[j as usize]);
            let (fi, fj) = (values[i as usize], values[j as usize]);
            let t = (level - fi) / (fj - fi);
            [xi + t * (xj - xi), yi + t * (yj - yi)]
        }
    }
}

/// Joins directed edges to chains; closed ones repeat their first corner.
fn chains(edges: impl Iterator<Item = (Corner, Corner)>) -> Vec<Vec<Corner>> {
    let mut next: BTreeMap<Corner, Vec<Corner>> = BTreeMap::new();
    let mut arrivals: BTreeMap<Corner, usize> = BTreeMap::new();
    for (from, to) in edges {
        next.entry(from).or_default().push(to);
        *arrivals.entry(to).or_default() += 1;
    }
    // Open chains first, from the corners that more edges leave than reach
    let open: Vec<Corner> = next
        .iter()
        .filter(|(c, out)| out.len() > arrivals.get(c).copied().unwrap_or(0))
        .map(|(c, _)| *c)
        .collect();
    let all: Vec<Corner> = next.keys().copied().collect();
    let mut result = Vec::new();
    for start in open.into_iter().chain(all) {
        while let Some(first) = next.get_mut(&start).and_then(Vec::pop) {
            let mut chain = vec![start, first];
            let mut at = first;
            while at != start {
                match next.get_mut(&at).and_then(Vec::pop) {
                    Some(to) => {
                        chain.push(to);
                        at = to;
                    }
                    None => break,
                }
            }
            result.push(chain);
        }
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(polygon: &[[f64; 2]]) -> f64 {
        polygon
            .windows(2)
            .map(|w| 0.5 * (w[0][0] * w[1][1] - w[1][0] * w[0][1]))
            .sum()
    }

    /// n × n squares on the square of half-width 1, each split in two, one half turned round.
    fn square(n: usize) -> (Vec<[f64; 2]>, Vec<[u32; 3]>) {
        let at = |i: usize| 2.0 * i as f64 / n as f64 - 1.0;
        let points = (0..=n)
            .flat_map(|j| (0..=n).map(move |i| [at(i), at(j)]))
            .collect();
        let id = |i: usize, j: usize| (j * (n + 1) + i) as u32;
        let cells = (0..n)
            .flat_map(|j| (0..n).map(move |i| (i, j)))
            .flat_map(|(i, j)| {
                [
                    [id(i, j), id(i + 1, j), id(i + 1, j + 1)],
                    [id(i, j), id(i + 1, j + 1), id(i, j + 1)],
                ]
            })
            .enumerate()
            .map(|(k, [a, b, c])| if k % 3 == 0 { [a, c, b] } else { [a, b, c] })
            .collect();
        (points, cells)
    }

    /// f = x on [−1, 1]²: {f ≥ 0.3} is a rectangle of area 0.7 · 2, its level line has length 2.
    #[test]
    fn plane_field_gives_a_rectangle() {
        let (points, cells) = square(7);
        let values: Vec<f64> = points.iter().map(|p| p[0]).collect();
        let region = region(&points, &values, &cells, 0.3);
        assert_eq!((region.loops.len(), region.level_lines.len()), (1, 1));
        assert!((area(&region.loops[0]) - 1.4).abs() < 1e-12);
        let line = &region.level_lines[0];
        let length: f64 = line.windows(2).map(|w| (w[1][1] - w[0][1]).abs()).sum();
        assert!((length - 2.0).abs() < 1e-12);
    }

    /// f = |r| on a fine grid: {f ≥ ½} is the square less a disc, in two loops: 4 − π/4.
    #[test]
    fn hole_is_a_loop_of_its_own() {
        let (points, cells) = square(80);
        let values: Vec<f64> = points.iter().map(|p| p[0].hypot(p[1])).collect();
        let region = region(&points, &values, &cells, 0.5);
        assert_eq!((region.loops.len(), region.level_lines.len()), (2, 1));
        let total: f64 = region.loops.iter().map(|l| area(l)).sum();
        assert!((total - (4.0 - std::f64::consts::PI / 4.0)).abs() < 1e-3);
    }

    #[test]
    fn level_outside_of_the_range_gives_all_or_nothing() {
        let (points, cells) = square(3);
        let values: Vec<f64> = points.iter().map(|p| p[0]).collect();
        assert!(region(&points, &values, &cells, 2.0).loops.is_empty());
        let all = region(&points, &values, &cells, -2.0);
        assert!((area(&all.loops[0]) - 4.0).abs() < 1e-12 && all.level_lines.is_empty());
    }
}
