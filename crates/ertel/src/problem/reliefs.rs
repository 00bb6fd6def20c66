//! Reliefs of the surfaces in the gap.

use crate::case::SurfaceRelief;
use crate::contact::gap::{GapTerm, Relief};
use crate::contact::{Pose, Scales, Shape, Symmetry};

/// Cells across the shortest length of a relief: with 16 and with 32 of them waves of half a half-width keep the amplitude of a published table to 3 %.
const CELLS_OVER_RELIEF: f64 = 16.0;

/// A contact with reliefs; all of it is solved, under all of its load, where they are not symmetric about the motion.
pub fn with_reliefs(mut shape: Shape, reliefs: &[SurfaceRelief], scales: &mut Scales) -> Shape {
    let turn = shape.gap.turn;
    let reliefs: Vec<Relief> = (reliefs.iter())
        .map(|relief| Relief {
            form: relief.form.over(scales.length, scales.film),
            body: relief.body,
            place: relief.place.map(|x| x / scales.length),
            moved: Pose::START,
            turn,
        })
        .collect();
    if shape.symmetry == Symmetry::Half && !reliefs.iter().all(Relief::is_symmetric) {
        shape.symmetry = Symmetry::Full;
        scales.load *= 2.0;
    }
    shape
        .gap
        .terms
        .extend(reliefs.into_iter().map(GapTerm::Relief));
    shape
}

/// Cells that resolve the reliefs of a contact, in half-widths; infinite where there are none.
pub fn largest_cell(shape: &Shape) -> f64 {
    let finest = (shape.gap.terms.iter())
        .filter_map(|term| match term {
            GapTerm::Relief(relief) => Some(relief.form.finest()),
            GapTerm::Roller(_) | GapTerm::Curvature(_) => None,
        })
        .fold(f64::INFINITY, f64::min);
    finest / CELLS_OVER_RELIEF / shape.zone.axis_ratio.max(1.0)
}
