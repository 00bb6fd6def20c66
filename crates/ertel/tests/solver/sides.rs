//! Sides of sets of elements, by Gauss's theorem.

use ertel::solve::heat::sides::{SideRule, outer_sides};

use super::{ball, surface};

/// Gauss's theorem, with fields that are known on each side: through the sides round a set of elements, ∮ x n_x dl = ∮ y n_y dl = A and
/// ∮ xy² n_x dl = ∫ y² dA, on all of half a contact and within its Hertz zone. A side that is another's, or that
/// points inward, adds something else. On the plane y = 0 of the half all of them vanish.
#[test]
fn side_flow_equals_the_divergence_inside() {
    let problem = ball();
    let stage = problem.plan.stages[0];
    let contact = surface(&problem, &stage);
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
            let size = 0.5 * ((a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0])).abs();
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
