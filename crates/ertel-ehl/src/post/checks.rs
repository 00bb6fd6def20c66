//! Balances that a solution should keep, and where its sums end.

use crate::contact::Shape;
use crate::engine::friction::friction;
use crate::engine::{Extents, Film, Problem};
use crate::solution::{Balance, Checks, Figure, Figures, Summary, SummedTo, Thermal};
use crate::warning::{Warning, WarningKind};

/// The balances of a solution, and where its shear is summed.
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
            Balance::of(f.whole.work, made)
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
        ends_with_bodies: f.is_cut,
    };
    (checks, summed)
}

/// Share of the friction power or of the moment that the outer half of the bodies may add for the end of the sum to be a note: most contacts of
/// lines and fast balls reach beyond their radius, and little of their friction comes from there.
const FELT: f64 = 0.05;

/// Share of friction power and moment that the outer half of the bodies adds, the larger one.
fn far_share(figures: &Figures) -> f64 {
    [Figure::FrictionPower, Figure::TractionMoment]
        .into_iter()
        .filter_map(|figure| figures.get(figure))
        .map(|reading| reading.cut / reading.size)
        .fold(0.0, f64::max)
}

/// Says so where the contact area reaches farther than the bodies; `half_width` a in m.
pub fn warning(shape: &Shape, e: &Extents, half_width: f64, figures: &Figures) -> Option<Warning> {
    let along = e.inlet.abs().max(e.outlet) / shape.ends[0];
    let across = match shape.is_line() {
        true => 0.0,
        false => e.side * shape.zone.axis_ratio / shape.ends[1],
    };
    let excess = along.max(across);
    if excess <= 1.0 {
        return None;
    }
    let mm = |half_widths: f64| 1e3 * half_widths * half_width;
    let (name, key, end, share) = match along >= across {
        true => ("inlet", "inlet", shape.ends[0], along),
        false => ("side", "side", shape.ends[1], across),
    };
    let text = format!(
        "the contact area reaches {:.3} mm from the centre at its {name}, {share:.1} times as far as the bodies, which end {:.3} mm from the \
         centre: thick films build up far away. The film is that of parabolas with oil between them all the way; traction, moment and \
         friction power are summed as far as the bodies reach, and their error bars allow for what the outer half of that adds ([mesh] {key} sets \
         the edge)",
        mm(share * end),
        mm(end),
    );
    let kind = match far_share(figures) > FELT {
        true => WarningKind::WideArea,
        false => WarningKind::WideAreaUnfelt,
    };
    Some(Warning::beyond(kind, excess, text))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solution::Reading;

    /// A side at 25 half-widths where the ball ends at 10, and an inlet at 8; then a ball that ends at 30. A tenth of the friction from the outer
    /// half is a warning, a thousandth a note.
    #[test]
    fn areas_beyond_the_bodies_are_told() {
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
        let figures = |cut: f64| {
            let mut figures = Figures::default();
            let power = Reading {
                cut,
                ..Reading::new(2.0)
            };
            figures.note(Figure::FrictionPower, power);
            figures
        };
        let told = |cut| warning(&ball(10.0), &extents, 1e-3, &figures(cut)).unwrap();
        assert_eq!(told(0.002).kind, WarningKind::WideAreaUnfelt);
        let told = told(0.2);
        assert_eq!(told.kind, WarningKind::WideArea);
        for words in [
            "25.000 mm",
            "its side",
            "2.5 times",
            "end 10.000 mm",
            "[mesh] side",
        ] {
            assert!(told.contains(words), "{words}: {told}");
        }
        assert_eq!(warning(&ball(30.0), &extents, 1e-3, &figures(0.2)), None);
    }
}
