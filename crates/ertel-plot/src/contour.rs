//! Regions and level lines of a field that is linear on triangles.

use rayon::prelude::*;
use rustc_hash::FxHashSet;

/// Corner of a region: a node, or the cut of the level through the edge between two nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Corner {
    Node(u32),
    Cut(u32, u32),
}

/// The part of a triangulation where the field is at least the level.
#[derive(Clone, Debug, Default)]
pub struct Region {
    /// Closed boundaries, level lines and edges of the domain together.
    pub loops: Vec<Vec<[f64; 2]>>,
    /// The level lines alone; closed ones repeat their first point.
    pub level_lines: Vec<Vec<[f64; 2]>>,
}

/// Triangles with their common boundary, for any number of levels.
pub struct Triangulation<'a> {
    points: &'a [[f64; 2]],
    /// Counter-clockwise.
    triangles: Vec<[u32; 3]>,
    /// Edges of one triangle only, with the domain on their left.
    boundary: Vec<[u32; 2]>,
}

impl<'a> Triangulation<'a> {
    /// Of triangles in any orientation.
    pub fn new(points: &'a [[f64; 2]], triangles: &[[u32; 3]]) -> Triangulation<'a> {
        let mut triangles = triangles.to_vec();
        let mut edges: FxHashSet<[u32; 2]> = FxHashSet::default();
        for triangle in &mut triangles {
            let [a, b, c] = triangle.map(|i| points[i as usize]);
            let area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
            if area < 0.0 {
                triangle.swap(1, 2);
            }
            for i in 0..3 {
                let (from, to) = (triangle[i], triangle[(i + 1) % 3]);
                // Neighbours run through a common edge in opposite directions.
                if !edges.remove(&[to, from]) {
                    edges.insert([from, to]);
                }
            }
        }
        let mut boundary: Vec<[u32; 2]> = edges.into_iter().collect();
        boundary.sort_unstable();
        Triangulation {
            points,
            triangles,
            boundary,
        }
    }

    /// Regions {f ≥ level} for rising levels.
    pub fn regions(&self, values: &[f64], levels: &[f64]) -> Vec<Region> {
        let mut crossed: Vec<Vec<[u32; 3]>> = vec![Vec::new(); levels.len()];
        for triangle in &self.triangles {
            let at = triangle.map(|n| values[n as usize]);
            let (low, high) = (at[0].min(at[1]).min(at[2]), at[0].max(at[1]).max(at[2]));
            let first = levels.partition_point(|l| *l <= low);
            for (of_level, _) in (crossed[first..].iter_mut())
                .zip(&levels[first..])
                .take_while(|(_, level)| **level <= high)
            {
                of_level.push(*triangle);
            }
        }
        (levels.par_iter().zip(&crossed))
            .map(|(level, crossed)| self.region(values, *level, crossed))
            .collect()
    }

    /// The whole domain.
    pub fn whole(&self, values: &[f64]) -> Region {
        self.region(values, f64::NEG_INFINITY, &[])
    }

    /// Region {f ≥ level}: bounded by the level line through the triangles that it crosses, and by those
    /// parts of the domain's boundary where f ≥ level.
    fn region(&self, values: &[f64], level: f64, crossed: &[[u32; 3]]) -> Region {
        let inside = |n: u32| values[n as usize] >= level;
        let cut = |i: u32, j: u32| Corner::Cut(i.min(j), i.max(j));
        let mut level_line: Vec<(Corner, Corner)> = Vec::new();
        for &[a, b, c] in crossed {
            // The line enters through the edge that leaves the region, the region on its left.
            let line = match (inside(a), inside(b), inside(c)) {
                (true, false, false) => (cut(a, b), cut(c, a)),
                (false, true, false) => (cut(b, c), cut(a, b)),
                (false, false, true) => (cut(c, a), cut(b, c)),
                (true, true, false) => (cut(b, c), cut(c, a)),
                (false, true, true) => (cut(c, a), cut(a, b)),
                (true, false, true) => (cut(a, b), cut(b, c)),
                _ => continue,
            };
            level_line.push(line);
        }
        let mut edges = level_line.clone();
        for &[from, to] in &self.boundary {
            let start = match inside(from) {
                true => Corner::Node(from),
                false => cut(from, to),
            };
            let end = match inside(to) {
                true => Corner::Node(to),
                false => cut(from, to),
            };
            if start != end {
                edges.push((start, end));
            }
        }
        let place = |chain: Vec<Corner>| -> Vec<[f64; 2]> {
            chain
                .into_iter()
                .map(|c| position(self.points, values, level, c))
                .collect()
        };
        Region {
            loops: chains(edges).into_iter().map(place).collect(),
            level_lines: chains(level_line).into_iter().map(place).collect(),
        }
    }
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
fn chains(mut edges: Vec<(Corner, Corner)>) -> Vec<Vec<Corner>> {
    edges.sort_unstable();
    let mut arrivals: Vec<Corner> = edges.iter().map(|(_, to)| *to).collect();
    arrivals.sort_unstable();
    // By the position of the first edge out of a corner: how many of its edges are taken
    let mut taken = vec![0; edges.len()];
    let first = |corner: Corner| edges.partition_point(|(from, _)| *from < corner);
    let mut take = |corner: Corner| {
        let at = first(corner);
        let (_, to) = edges.get(at + taken.get(at)?).filter(|e| e.0 == corner)?;
        taken[at] += 1;
        Some(*to)
    };
    // Open chains first, from the corners that more edges leave than reach
    let groups = edges.chunk_by(|a, b| a.0 == b.0);
    let reached = |corner: Corner| {
        let from = arrivals.partition_point(|c| *c < corner);
        arrivals[from..]
            .iter()
            .take_while(|c| **c == corner)
            .count()
    };
    let open = groups
        .clone()
        .filter(|group| group.len() > reached(group[0].0));
    let mut result = Vec::new();
    for start in open.chain(groups.clone()).map(|group| group[0].0) {
        while let Some(first) = take(start) {
            let mut chain = vec![start, first];
            let mut at = first;
            while let Some(to) = (at != start).then(|| take(at)).flatten() {
                chain.push(to);
                at = to;
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
        let region = Triangulation::new(&points, &cells)
            .regions(&values, &[0.3])
            .remove(0);
        assert_eq!((region.loops.len(), region.level_lines.len()), (1, 1));
        assert!((area(&region.loops[0]) - 1.4).abs() < 1e-12);
        let line = &region.level_lines[0];
        let length: f64 = line.windows(2).map(|w| (w[1][1] - w[0][1]).abs()).sum();
        assert!((length - 2.0).abs() < 1e-12);
    }

    /// f = |r| on a fine grid: {f ≥ ½} is the square less a disc, in two loops: 4 − π/4.
    #[test]
    fn hole_is_a_separate_loop() {
        let (points, cells) = square(80);
        let values: Vec<f64> = points.iter().map(|p| p[0].hypot(p[1])).collect();
        let region = Triangulation::new(&points, &cells)
            .regions(&values, &[0.5])
            .remove(0);
        assert_eq!((region.loops.len(), region.level_lines.len()), (2, 1));
        let total: f64 = region.loops.iter().map(|l| area(l)).sum();
        assert!((total - (4.0 - std::f64::consts::PI / 4.0)).abs() < 1e-3);
    }

    #[test]
    fn level_outside_of_the_range_gives_all_or_nothing() {
        let (points, cells) = square(3);
        let values: Vec<f64> = points.iter().map(|p| p[0]).collect();
        let mesh = Triangulation::new(&points, &cells);
        let both = mesh.regions(&values, &[-2.0, 2.0]);
        let (all, none) = (&both[0], &both[1]);
        assert!(none.loops.is_empty());
        assert!((area(&all.loops[0]) - 4.0).abs() < 1e-12 && all.level_lines.is_empty());
    }
}
