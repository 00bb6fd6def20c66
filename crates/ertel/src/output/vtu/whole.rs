//! The whole film and bodies of a contact solved for y ≤ 0.

use std::borrow::Cow;

use crate::contact::Symmetry;
use crate::solution::near_zero;

/// Points and cells of a whole grid, and the solved point that each point is or mirrors.
pub(super) struct Whole<'a> {
    pub points: Cow<'a, [[f64; 3]]>,
    pub cells: Cow<'a, [Vec<u32>]>,
    /// Solved point of each point.
    sources: Vec<usize>,
    /// Number of solved points; the others are mirror images.
    n_solved: usize,
}

impl<'a> Whole<'a> {
    /// For a contact solved as a whole: unchanged. For a half: with its mirror image, which shares the points on y = 0.
    pub fn new(symmetry: Symmetry, points: &'a [[f64; 3]], cells: &'a [Vec<u32>]) -> Whole<'a> {
        let mut whole = Whole {
            points: Cow::Borrowed(points),
            cells: Cow::Borrowed(cells),
            sources: (0..points.len()).collect(),
            n_solved: points.len(),
        };
        if symmetry == Symmetry::Full {
            return whole;
        }
        let on_plane = near_zero(points.iter().map(|p| p[1]));
        let mut image = Vec::with_capacity(points.len());
        for (i, [x, y, z]) in points.iter().enumerate() {
            if on_plane(*y) {
                image.push(i as u32);
                continue;
            }
            image.push(whole.sources.len() as u32);
            whole.points.to_mut().push([*x, -y, *z]);
            whole.sources.push(i);
        }
        let mirrored = cells.iter().map(|cell| {
            let order = reflected(cell.len()).iter();
            order.map(|k| image[cell[*k] as usize]).collect()
        });
        whole.cells.to_mut().extend(mirrored);
        whole
    }

    /// A scalar at the points of the whole grid.
    pub fn scalar(&self, solved: &[f64]) -> Vec<f64> {
        self.sources.iter().map(|i| solved[*i]).collect()
    }

    /// A vector at the points of the whole grid: its component across the motion changes sign in the image.
    pub fn vector(&self, solved: &[[f64; 3]]) -> Vec<[f64; 3]> {
        let vectors = self.sources.iter().enumerate().map(|(point, source)| {
            let [x, y, z] = solved[*source];
            match point < self.n_solved {
                true => [x, y, z],
                false => [x, -y, z],
            }
        });
        vectors.collect()
    }

    /// A value per cell.
    pub fn per_cell<T: Copy>(&self, solved: &[T]) -> Vec<T> {
        solved
            .iter()
            .cycle()
            .take(self.cells.len())
            .copied()
            .collect()
    }
}

/// Node order that gives the mirror image of a cell the same orientation (VTK numbering):
/// corners 1 and 2 are exchanged, with the nodes between or above them.
fn reflected(n_nodes: usize) -> &'static [usize] {
    match n_nodes {
        // Tetrahedra; their edges are 01, 12, 20, 03, 13, 23.
        4 => &[0, 2, 1, 3],
        10 => &[0, 2, 1, 3, 6, 5, 4, 7, 9, 8],
        // Wedges: two triangles
        6 => &[0, 2, 1, 3, 5, 4],
        n => unreachable!("bodies of half contacts have no cells of {n} nodes"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Signed volume of a tetrahedron times six.
    fn volume(points: &[[f64; 3]], corners: [u32; 4]) -> f64 {
        let [a, b, c, d] = corners.map(|i| points[i as usize]);
        let from = |p: [f64; 3]| [p[0] - a[0], p[1] - a[1], p[2] - a[2]];
        let ([b, c], d) = ([b, c].map(from), from(d));
        let cross = [
            b[1] * c[2] - b[2] * c[1],
            b[2] * c[0] - b[0] * c[2],
            b[0] * c[1] - b[1] * c[0],
        ];
        cross[0] * d[0] + cross[1] * d[1] + cross[2] * d[2]
    }

    /// A second-order tetrahedron with a face on y = 0: its image has the same volume and orientation, midpoints between its
    /// corners, six shared points, and a displacement that is odd across the motion.
    #[test]
    fn bodies_are_mirrored() {
        let corners = [
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [0.0, -1.0, 0.0],
            [0.0, 0.0, 1.0],
        ];
        let edges = [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)];
        let mut points = corners.to_vec();
        let mid = |a: [f64; 3], b: [f64; 3]| [0, 1, 2].map(|k| 0.5 * (a[k] + b[k]));
        points.extend(edges.map(|(a, b)| mid(corners[a], corners[b])));
        let cells = vec![(0..10).collect::<Vec<u32>>()];
        let whole = Whole::new(Symmetry::Half, &points, &cells);
        assert_eq!((whole.points.len(), whole.cells.len()), (14, 2));
        let [own, image] = [0, 1].map(|c| {
            let cell: &[u32] = &whole.cells[c];
            volume(&whole.points, [cell[0], cell[1], cell[2], cell[3]])
        });
        assert_eq!(own, image);
        let cell = &whole.cells[1];
        for (k, (a, b)) in edges.iter().enumerate() {
            let [a, b, m] = [cell[*a], cell[*b], cell[4 + k]].map(|i| whole.points[i as usize]);
            assert_eq!(m, mid(a, b), "edge {k}");
        }
        // u = (x, y, z) equals its image.
        assert_eq!(whole.vector(&points), *whole.points);
        let one = |p: &[f64; 3]| p[0] - 3.0 * p[1].abs();
        let solved: Vec<f64> = points.iter().map(one).collect();
        let expected: Vec<f64> = whole.points.iter().map(one).collect();
        assert_eq!(whole.scalar(&solved), expected);
        assert_eq!(whole.per_cell(&[7_u8]), [7, 7]);
        // A contact solved as a whole is unchanged.
        let same = Whole::new(Symmetry::Full, &points, &cells);
        assert_eq!((&*same.points, &*same.cells), (&*points, &*cells));
    }

    /// The image of a wedge has a base triangle of the same orientation.
    #[test]
    fn wedges_are_mirrored() {
        let flat = [[0.0, 0.0], [0.0, -1.0], [1.0, 0.0]];
        let points: Vec<[f64; 3]> = [0.0, 1.0]
            .iter()
            .flat_map(|z| flat.map(|[x, y]| [x, y, *z]))
            .collect();
        let cells = vec![(0..6).collect::<Vec<u32>>()];
        let whole = Whole::new(Symmetry::Half, &points, &cells);
        assert_eq!(whole.points.len(), 8);
        let volumes = [0, 1].map(|c| {
            let cell: &[u32] = &whole.cells[c];
            volume(&whole.points, [cell[0], cell[1], cell[2], cell[3]])
        });
        assert_eq!(volumes[0], volumes[1]);
    }
}
