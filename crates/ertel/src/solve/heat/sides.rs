//! Sides of the elements of the contact area, for what flows through them.

use std::collections::HashMap;

use crate::contact::Symmetry;
use crate::solve::discretisation::ContactSurface;

/// A side of an element: of which element, and opposite to which of its corners.
pub(super) type Side = (usize, usize);

/// Sides of the elements of a set that no other element of it shares; those on the symmetry plane left out.
pub(super) fn outer_sides(contact: &ContactSurface, set: impl Fn(usize) -> bool) -> Vec<Side> {
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
pub(super) struct SideRule {
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

#[cfg(test)]
mod tests {
    use std::path::Path;

    use ertel_input::Document;

    use super::*;
    use crate::case::Case;
    use crate::problem::problem;
    use crate::solve::discretisation::Means;

    const CASE: &str = r#"
        [contact]
        kind = "circular"
        radius = "10 mm"
        load = "20 N"
        [bodies]
        body_1 = "steel"
        body_2 = "steel"
        [motion]
        entrainment_speed = "1 m/s"
        slide_to_roll_ratio = 0.0
        [lubricant]
        temperature = "40 degC"
        density = { law = "dowson-higginson", rho_0 = "870 kg/m^3" }
        viscosity = { law = "barus", mu_0 = "40 mPa.s", alpha = "10 1/GPa" }
        [mesh]
        preset = "coarse"
    "#;

    /// Gauss's theorem, with fields that are known on each side: through the sides round a set of elements, ∮ x n_x dl = ∮ y n_y dl = A and
    /// ∮ xy² n_x dl = ∫ y² dA, on all of half a contact and within its Hertz zone. A side that is another's, or that
    /// points inward, adds something else. On the plane y = 0 of the half all of them vanish.
    #[test]
    fn what_flows_through_the_sides_is_what_comes_of_within() {
        let document = Document::parse("case.toml", CASE).unwrap();
        let problem = problem(&Case::from_document(&document, Path::new("")).unwrap());
        let stage = problem.stages[0];
        let contact = ContactSurface::new(
            &problem.shape,
            &problem.extents,
            &stage.sizes,
            &problem.elasticity,
            Means::default(),
        )
        .unwrap();
        let third = 1.0 / 3.0;
        let inside = |c: usize| {
            let [x, y] = contact.point(c, [third, third, 0.0]);
            x.hypot(y) < 1.0
        };
        let all = |_: usize| true;
        let sets: [&dyn Fn(usize) -> bool; 2] = [&all, &inside];
        for set in sets {
            let (mut area, mut second) = (0.0, 0.0);
            for c in (0..contact.n_elements()).filter(|c| set(*c)) {
                let [o, a, b] =
                    [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(|xi| contact.point(c, xi));
                let size =
                    0.5 * ((a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0])).abs();
                area += size;
                // ∫y² over a triangle: A/12 (Σy_i² + (Σy_i)²)
                let sum = o[1] + a[1] + b[1];
                second += size / 12.0 * (o[1].powi(2) + a[1].powi(2) + b[1].powi(2) + sum * sum);
            }
            let mut found = [0.0; 3];
            for side in outer_sides(&contact, set) {
                let SideRule { normal, points } = SideRule::new(&contact, side);
                for (xi, weight) in points {
                    let [x, y] = contact.point(side.0, xi);
                    found[0] += weight * x * normal[0];
                    found[1] += weight * y * normal[1];
                    found[2] += weight * x * y * y * normal[0];
                }
            }
            approx::assert_relative_eq!(found[0], area, max_relative = 1e-10);
            approx::assert_relative_eq!(found[1], area, max_relative = 1e-10);
            approx::assert_relative_eq!(found[2], second, max_relative = 1e-10);
        }
    }
}
