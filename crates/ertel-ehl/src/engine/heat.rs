//! Temperatures of film and walls in a few numbers.

use super::PointTable;
use crate::film::{FilmNodes, Nodal};

/// Temperatures of plane and ball, K.
pub fn walls(film: &FilmNodes, values: &Nodal) -> [f64; 2] {
    [values[0], values[film.n() - 1]]
}

/// Means over the Hertz zone, K: of the film, of the surfaces of body 1 and of body 2.
pub fn zone_means(points: &PointTable, film: &FilmNodes) -> [f64; 3] {
    points.mean_in_zone(|fields| {
        let temperature = &fields.temperature.as_ref()?.temperature;
        let [body_1, body_2] = walls(film, temperature);
        Some([film.mean(temperature), body_1, body_2])
    })
}
