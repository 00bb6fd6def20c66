//! Shared by the pictures of a contact: the unit of films, and the visible part of the motion's axis.

use ertel_plot::Drawing;

use crate::solution::Solution;

/// Film thicknesses are shown in nm below this value (m), else in µm.
const NANOMETRES_BELOW: f64 = 1e-6;

/// Factor and unit for lengths of this size (m).
pub fn film_unit(size: f64) -> (f64, &'static str) {
    if size < NANOMETRES_BELOW {
        (1e9, "nm")
    } else {
        (1e6, "µm")
    }
}

/// Name and drawing function of a picture.
pub(super) type Task<'a> = (&'static str, Box<dyn FnOnce() -> Drawing + Send + 'a>);

/// Visible part of the x axis, in half-widths: the pressurised area and part of the inlet.
pub(super) fn window_x(solution: &Solution) -> [f64; 2] {
    let a = solution.hertz.half_width;
    let line = &solution.centreline;
    let ends = line.x.iter().map(|x| x / a);
    let (first, last) = (
        ends.clone().fold(f64::INFINITY, f64::min),
        ends.fold(f64::NEG_INFINITY, f64::max),
    );
    let pressed = line
        .x
        .iter()
        .zip(&line.pressure)
        .filter(|(_, p)| **p > 0.01 * solution.hertz.pressure)
        .map(|(x, _)| x / a);
    let [half, _] = solution.shape.zone.half_extents();
    let reach = pressed.clone().fold(-half, f64::min);
    let end = pressed.fold(half, f64::max);
    let low = (2.0 * (1.15 * reach - 0.6)).floor() / 2.0;
    let high = (2.0 * (1.1 * end + 0.2)).ceil() / 2.0;
    [low.max(first), high.min(last)]
}
