//! Resistance of films to rolling, in addition to any sliding.
//!
//! ```text
//!   f = µ_2 − µ_1 = ∫ h ∂p/∂x dA/Q
//! ```
//! Traction of sliding and spin is the same at both walls: its error cancels in the difference, and so do the marks of friction that no lubricant
//! transmits.

use super::contacts::figure_of;
use crate::mark::{Marked, Marks};
use crate::point::PointSolution;
use crate::solution::Figure;

const WALLS: [Figure; 2] = [
    Figure::TractionCoefficientBody1,
    Figure::TractionCoefficientBody2,
];

/// f of a contact. Its bar is the relative error of the traction at the walls plus the misfit of f with the offset of the load, at
/// most the bars of both walls together.
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

    /// By hand. Of rolling alone, ±0.001 with 2 %, the bars of both walls add up. With a traction of 30 that is known to 5 %, f = 0.002 is known to 5 % and
    /// its misfit, while both walls together err by 3.
    #[test]
    fn traction_of_both_walls_cancels() {
        let alone = bar(0.002, (2e-5, 2e-5), [1e-3; 2], 1e-6);
        assert_eq!(alone, 4e-5);
        let with_traction = bar(0.002, (1.5, 1.5), [30.0; 2], 1e-6);
        assert!((with_traction - 1.01e-4).abs() < 1e-12, "{with_traction}");
        // Zero tractions do not divide by zero.
        assert_eq!(bar(0.0, (0.1, 0.1), [0.0; 2], 0.0), 0.2);
    }
}
