//! Sides of the elements of the contact area, for what flows through them.

use std::collections::HashMap;

use crate::contact::Symmetry;
use crate::solve::contact_surface::ContactSurface;

/// A side of an element: its element, and the opposite corner.
pub(super) type Side = (usize, usize);

/// Sides of the elements of a set that no other element of it shares; those on the symmetry plane left out.
pub fn outer_sides(contact: &ContactSurface, set: impl Fn(usize) -> bool) -> Vec<Side> {
    let surface = &contact.surface;
    let mut sides: HashMap<Vec<u32>, (usize, usize, usize)> = HashMap::new();
    for c in (0..surface.n_cells()).filter(|c| set(*c)) {
        let corners = surface.cell(c);
        for opposite in 0..corners.len() {
            let mut side: Vec<u32> = (0..corners.len())
                .filter(|k| *k != opposite)
                .map(|k| corners[k])
                .collect();
            side.sort_unstable();
            sides.entry(side).or_insert((0, c, opposite)).0 += 1;
        }
    }
    let on_symmetry = |side: &[u32]| {
        let mut points = side.iter().map(|v| surface.vertices[*v as usize]);
        contact.shape.symmetry == Symmetry::Half && points.all(|p| p[1].abs() < 1e-12)
    };
    let mut outer: Vec<Side> = sides
        .into_iter()
        .filter(|(side, (count, _, _))| *count == 1 && !on_symmetry(side))
        .map(|(_, (_, c, opposite))| (c, opposite))
        .collect();
    // The sum shall not depend on the order of a hash map.
    outer.sort_unstable();
    outer
}

/// Quadrature over a side.
pub struct SideRule {
    /// Outward normal, as long as the side.
    pub normal: [f64; 2],
    /// Coordinates in the element, and weights that sum to one.
    pub points: Vec<([f64; 3], f64)>,
}

impl SideRule {
    /// Three Gauss points, or the point that the side of a line's element is.
    pub fn new(contact: &ContactSurface, (c, opposite): Side) -> SideRule {
        let corner =
            |k: usize| -> [f64; 3] { std::array::from_fn(|i| if i + 1 == k { 1.0 } else { 0.0 }) };
        let place = |k: usize| contact.point(c, corner(k));
        let ends: Vec<usize> = (0..contact.surface.cell(c).len())
            .filter(|k| *k != opposite)
            .collect();
        // Normal with the size of the side, away from the opposite corner.
        let (first, away) = (place(ends[0]), place(opposite));
        let mut normal = match ends[..] {
            [_, b] => {
                let last = place(b);
                [last[1] - first[1], first[0] - last[0]]
            }
            _ => [1.0, 0.0],
        };
        let outward = normal[0] * (first[0] - away[0]) + normal[1] * (first[1] - away[1]);
        if outward < 0.0 {
            normal = normal.map(|n| -n);
        }
        let shift = 0.5 * 0.6_f64.sqrt();
        let points: &[(f64, f64)] = match ends.len() {
            1 => &[(0.0, 1.0)],
            _ => &[
                (0.5 - shift, 5.0 / 18.0),
                (0.5, 8.0 / 18.0),
                (0.5 + shift, 5.0 / 18.0),
            ],
        };
        let (from, to) = (corner(ends[0]), corner(*ends.last().unwrap_or(&0)));
        let at = |t: f64| std::array::from_fn(|i| from[i] + t * (to[i] - from[i]));
        SideRule {
            normal,
            points: points.iter().map(|(t, weight)| (at(*t), *weight)).collect(),
        }
    }
}
