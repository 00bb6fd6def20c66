//! Pressure and film at the output times, on fixed positions.

use serde::{Deserialize, Serialize};

use crate::contact::Shape;
use crate::engine::{Film, Profile};
use crate::volumes::film::PatchedFilm;

/// Fields at the output times on a grid along and across the motion, SI, in single precision.
///
/// Line contacts have the centreline. Others have a regular grid around the contact, as far as the solver grids extend.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct InstantFields {
    /// Output times, s.
    pub times: Vec<f64>,
    /// Positions along the motion, m.
    pub x: Vec<f64>,
    /// Positions across it, m: only 0 for line contacts.
    pub y: Vec<f64>,
    /// Pressure, Pa, for each time: rows along the motion, from the first position across it.
    pub pressure: Vec<Vec<f32>>,
    /// Film thickness, m, likewise.
    pub film: Vec<Vec<f32>>,
}

/// Maximum number of positions of an instant: more than pictures show.
const MOST_PLACES: usize = 12_000;
/// Maximum number of stored values of a field, 64 MB: above 1398 output times the spacing increases.
const MOST_VALUES: usize = 1 << 24;
/// Minimum number of positions along the motion in long contacts, if the grids have as many.
const LEAST_ALONG: f64 = 64.0;
/// Stored extent in units of the smaller half-axis of the dry contact: along the motion and across it.
const MARGINS: [f64; 2] = [1.0, 0.5];

impl InstantFields {
    /// Whether there is no extent across the motion.
    pub fn is_line(&self) -> bool {
        self.y.len() < 2
    }

    /// Adds an instant of a film; `n_times` is the total number. Lengths, films and pressures have these scales.
    pub(super) fn push(
        &mut self,
        time: f64,
        film: &PatchedFilm<'_>,
        profile: &Profile,
        shape: &Shape,
        [length, thickness, pressure]: [f64; 3],
        n_times: usize,
    ) {
        let most = (MOST_VALUES / n_times.max(1)).clamp(2, MOST_PLACES);
        // The grids are fixed, and so are the positions.
        if shape.is_line() {
            let stride = profile.x.len().div_ceil(most).max(1);
            let thinned = || profile.x.iter().zip(&profile.fields).step_by(stride);
            if self.x.is_empty() {
                self.x = thinned().map(|(x, _)| x * length).collect();
                self.y = vec![0.0];
            }
            let of = |value: &dyn Fn(&crate::engine::PointFields) -> f64| {
                thinned().map(|(_, at)| value(at) as f32).collect()
            };
            self.pressure.push(of(&|at| at.pressure * pressure));
            self.film.push(of(&|at| at.film * thickness));
            self.times.push(time);
            return;
        }
        if self.x.is_empty() {
            let [x, y] = places(shape.zone.half_extents(), most);
            let is_there = |place| film.at(place).is_some();
            self.x = x.into_iter().filter(|x| is_there([*x, 0.0])).collect();
            self.y = y.into_iter().filter(|y| is_there([0.0, *y])).collect();
            self.x
                .iter_mut()
                .chain(&mut self.y)
                .for_each(|x| *x *= length);
        }
        let n = self.x.len() * self.y.len();
        let [mut pressures, mut films] = [Vec::with_capacity(n), Vec::with_capacity(n)];
        for y in &self.y {
            for x in &self.x {
                let found = film.at([x / length, y / length]);
                let [p, h] = found.map_or([f64::NAN; 2], |at| [at.pressure, at.film]);
                pressures.push((p * pressure) as f32);
                films.push((h * thickness) as f32);
            }
        }
        self.pressure.push(pressures);
        self.film.push(films);
        self.times.push(time);
    }
}

/// Equally spaced positions about the centre, including the centre.
fn places(half: [f64; 2], most: usize) -> [Vec<f64>; 2] {
    let smaller = half[0].min(half[1]);
    let reach = [0, 1].map(|d: usize| half[d] + MARGINS[d] * smaller);
    let most = most as f64;
    let along = (most * reach[0] / reach[1]).sqrt();
    let along = along.max(LEAST_ALONG.min(most.sqrt()));
    let counts = [along, most / along];
    [0, 1].map(|d: usize| {
        let steps = ((0.5 * (counts[d] - 1.0)).floor() as i64).max(1);
        let step = reach[d] / steps as f64;
        (-steps..=steps).map(|i| i as f64 * step).collect()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The centre is included, the ends are at the extent, and the limit is kept; a long contact has its minimum along the motion.
    #[test]
    fn positions_are_about_the_centre() {
        for (half, most) in [
            ([1.0, 1.0], 12_000),
            ([1.0, 100.0], 12_000),
            ([3.0, 1.0], 170),
        ] {
            let [x, y] = places(half, most);
            assert!(x.len() * y.len() <= most, "{} x {}", x.len(), y.len());
            assert!(x.len() * y.len() > most / 2, "{} x {}", x.len(), y.len());
            for (places, end) in [(&x, half[0] + half[0].min(half[1])), (&y, half[1] + 0.5)] {
                assert_eq!(places[places.len() / 2], 0.0);
                assert!((places[places.len() - 1] - end).abs() < 1e-12 * end);
                assert!((places[0] + end).abs() < 1e-12 * end);
            }
            assert!(most < 1000 || x.len() > 60);
        }
    }
}
