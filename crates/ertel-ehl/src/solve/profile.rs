//! The centreline of a state, sampled element by element.

use crate::contact::Symmetry;
use crate::engine::Profile;
use crate::solve::discretisation::Discretisation;
use crate::solve::points::fields_at;
use crate::solve::state::State;

/// Samples per element edge from which figures are read.
pub const PER_EDGE: usize = 16;

/// Distance, in half-widths, below which points are the same.
const ON_LINE: f64 = 1e-12;

impl Profile {
    /// Samples every piece of the centreline between edges of elements, or along them, at `per_edge` intervals.
    pub fn new(d: &Discretisation, state: &State, per_edge: usize) -> Profile {
        Profile::of(d, state, &Profile::knots(d), per_edge)
    }

    /// For curves that are looked at: pieces are sampled so often that there are at least `least` intervals, each piece at
    /// least at `per_edge` of them and at most at eight times as many.
    pub fn smooth(d: &Discretisation, state: &State, per_edge: usize, least: usize) -> Profile {
        let knots = Profile::knots(d);
        let pieces = knots.len().saturating_sub(1).max(1);
        let per_piece = least.div_ceil(pieces).clamp(per_edge, 8 * per_edge);
        Profile::of(d, state, &knots, per_piece)
    }

    /// Where the centreline goes from element to element, X ascending.
    fn knots(d: &Discretisation) -> Vec<f64> {
        let surface = &d.contact.surface;
        let mut knots: Vec<f64> = (surface.vertices.iter())
            .filter(|v| v[1].abs() < ON_LINE)
            .map(|v| v[0])
            .collect();
        // A mesh of all of the contact has few vertices on the centreline, or none.
        if d.contact.shape.symmetry == Symmetry::Full && surface.dim == 2 {
            for c in 0..surface.n_cells() {
                let cell = surface
                    .cell(c)
                    .iter()
                    .map(|v| surface.vertices[*v as usize]);
                let corners: Vec<[f64; 3]> = cell.collect();
                for (i, a) in corners.iter().enumerate() {
                    for b in &corners[i + 1..] {
                        if a[1].abs().min(b[1].abs()) >= ON_LINE && a[1] * b[1] < 0.0 {
                            knots.push(a[0] + a[1] / (a[1] - b[1]) * (b[0] - a[0]));
                        }
                    }
                }
            }
        }
        knots.sort_by(f64::total_cmp);
        knots.dedup_by(|b, a| *b - *a < ON_LINE);
        knots
    }

    fn of(d: &Discretisation, state: &State, knots: &[f64], per_edge: usize) -> Profile {
        let mut x = Vec::new();
        for pair in knots.windows(2) {
            x.extend(
                (0..per_edge).map(|i| pair[0] + (pair[1] - pair[0]) * i as f64 / per_edge as f64),
            );
        }
        x.extend(knots.last());
        let mut profile = Profile::default();
        for x in x {
            if let Some(f) = fields_at(d, state, [x, 0.0]) {
                profile.x.push(x);
                profile.fields.push(f);
            }
        }
        profile
    }
}
