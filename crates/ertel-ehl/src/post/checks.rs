//! Balances that a solution should satisfy, and the limits of its integrals.

use crate::contact::Shape;
use crate::engine::friction::friction;
use crate::engine::{Extents, Film, Problem};
use crate::solution::{Balance, Checks, Summary, SummedTo, Thermal};
use crate::warning::{Warning, WarningKind};
use crate::words::digits;

/// The balances of a solution, and the range over which its shear is integrated.
pub fn checks<Plan>(
    problem: &Problem<Plan>,
    film: &impl Film,
    summary: &Summary,
    thermal: Option<&Thermal>,
) -> (Checks, SummedTo) {
    let f = friction(problem, &problem.fluid, film);
    let power = match thermal {
        None => Balance::of(f.here.work, f.here.dissipation + f.through_end),
        Some(thermal) => {
            let made = thermal.balance.shear.value + thermal.balance.compression.value;
            Balance::of(f.whole.work - f.work_around, made)
        }
    };
    let checks = Checks {
        power,
        rolling: Balance::of(f.whole.rolling, f.offset),
        load: summary.load_balance_error,
        mass: summary.film_balance_error,
        heat: thermal.map(|thermal| thermal.balance.error),
    };
    let [x, y] = problem.shape.ends.map(|end| end * problem.scales.length);
    let summed = SummedTo {
        body_end_x: x,
        body_end_y: Some(y).filter(|y| y.is_finite()),
        ends_with_bodies: f.ends_with_bodies,
    };
    (checks, summed)
}

/// Warns where the contact area extends beyond the bodies; `half_width` a in m.
pub fn warning(shape: &Shape, e: &Extents, half_width: f64) -> Option<Warning> {
    let along = e.inlet.abs().max(e.outlet) / shape.ends[0];
    let across = match shape.is_line() {
        true => 0.0,
        false => e.side * shape.zone.axis_ratio / shape.ends[1],
    };
    let excess = along.max(across);
    if excess <= 1.0 {
        return None;
    }
    let mm = |half_widths: f64| digits(1e3 * half_widths * half_width, 3);
    let (name, key, end, share) = match along >= across {
        true => ("inlet", "inlet", shape.ends[0], along),
        false => ("side", "side", shape.ends[1], across),
    };
    let text = format!(
        "flooded inlet assumed: the contact area reaches {} mm at its {name}, beyond the end of the bodies at {} mm; friction is summed to \
         the end of the bodies, its ± includes the outer part ([mesh] {key} sets the edge)",
        mm(share * end),
        mm(end),
    );
    Some(Warning::beyond(WarningKind::WideArea, excess, text))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A side at 25 half-widths where the ball ends at 10, and an inlet at 8; then a ball that ends at 30.
    #[test]
    fn areas_beyond_the_bodies_are_noted() {
        let extents = Extents {
            inlet: -8.0,
            outlet: 2.0,
            side: 25.0,
            body_width: 60.0,
            body_depth: 60.0,
        };
        let ball = |end: f64| Shape {
            ends: [end; 2],
            ..Shape::CIRCULAR
        };
        let shown = warning(&ball(10.0), &extents, 1e-3).unwrap();
        assert!(shown.kind.is_note());
        for words in ["25 mm at its side", "bodies at 10 mm", "[mesh] side"] {
            assert!(shown.contains(words), "{words}: {shown}");
        }
        assert_eq!(warning(&ball(30.0), &extents, 1e-3), None);
    }
}
