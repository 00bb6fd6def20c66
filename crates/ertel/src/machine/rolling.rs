//! Resistance of films to rolling, beside whatever else slides.
//!
//! ```text
//!   f = µ_2 − µ_1 = ∫ h ∂p/∂x dA/Q
//! ```
//! Traction of sliding and spin is the same at both walls: what it errs by goes out of the difference, and so do the marks of friction that no lubricant
//! transmits.

use super::figure_of;
use crate::mark::{Marked, Marks};
use crate::point::PointSolution;
use crate::solution::Figure;

const WALLS: [Figure; 2] = [
    Figure::TractionCoefficientBody1,
    Figure::TractionCoefficientBody2,
];

/// f of a contact. Its bar is the share of itself that the traction at the walls errs by, and what the balance of f with the offset of the load is off by; no
/// more than the bars of both walls together.
pub(super) fn rolling_coefficient(point: &PointSolution) -> Option<Marked> {
    let figures = &point.outcome.solution()?.measured.figures;
    let [one, two] = WALLS.map(|wall| Some((figure_of(point, wall)?, figures.get(wall)?)));
    let ((one, at_1), (two, at_2)) = (one?, two?);
    let value = two.value - one.value;
    let bars = one.error.zip(two.error);
    let error = bars.map(|bars| {
        bar(
            value,
            bars,
            [at_1.size, at_2.size],
            at_1.misfit + at_2.misfit,
        )
    });
    Some(Marked {
        value,
        error,
        marks: Marks::default(),
    })
}

/// The bar of f by those of both walls, the sizes that these belong to, and the misfit of f.
fn bar(value: f64, (one, two): (f64, f64), sizes: [f64; 2], misfit: f64) -> f64 {
    let both = one + two;
    let relative = (one / sizes[0]).max(two / sizes[1]);
    match relative.is_finite() {
        true => (value.abs() * relative + misfit).min(both),
        false => both,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand. Of rolling alone, ±0.001 with 2 %, the bars of both walls add up. Beside a traction of 30 that is known to 5 %, f = 0.002 is known to 5 % and
    /// its misfit, while both walls together err by 3.
    #[test]
    fn traction_of_both_walls_goes_out() {
        let alone = bar(0.002, (2e-5, 2e-5), [1e-3; 2], 1e-6);
        assert_eq!(alone, 4e-5);
        let beside = bar(0.002, (1.5, 1.5), [30.0; 2], 1e-6);
        assert!((beside - 1.01e-4).abs() < 1e-12, "{beside}");
        // Where nothing is there, nothing is divided by it.
        assert_eq!(bar(0.0, (0.1, 0.1), [0.0; 2], 0.0), 0.2);
    }
}
