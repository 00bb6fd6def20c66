//! Oil where the film has broken, by finite elements: streams that leave the film, and the oil that they carry.
//!
//! ```text
//!   c = H where the stream leaves the film,   F = H − c behind it       θ = c/H: the share of the gap that oil fills
//! ```
//! The rule is that of finite volumes (`volumes/behind.rs`): the pressure ends with no slope, so that what leaves the film is ρū H, and the mean velocity carries it on.
//! A stream leaves the film behind its largest pressure. Streams are lines, or circles about the centre of a spin.
//!
//! Theory: Behind the film.

use super::discretisation::Discretisation;
use super::points::{fields_at, pressure_at};
use super::state::State;
use crate::contact::Planar;
use crate::engine::PointFields;

/// Streams over the contact area.
#[derive(Clone, Debug, Default)]
pub struct Streams {
    coordinates: Coordinates,
    /// Adjacent streams.
    streams: Vec<Stream>,
}

/// A stream.
#[derive(Clone, Copy, Debug)]
struct Stream {
    /// Where it is across the flow.
    across: f64,
    /// Where its pressure is largest, along the flow.
    top: f64,
    /// H where it leaves the film; infinite where it does not.
    film: f64,
}

/// Places along and across the flow of a rigid body.
#[derive(Clone, Copy, Debug, Default)]
struct Coordinates {
    /// Direction of the flow at the centre.
    direction: [f64; 2],
    /// Distance from the centre of the spin to that of the contact, to the left of the flow where positive; none without spin.
    radius: Option<f64>,
}

impl Coordinates {
    fn new(flow: &Planar) -> Coordinates {
        let speed = flow.centre[0].hypot(flow.centre[1]);
        Coordinates {
            direction: flow.centre.map(|u| u / speed),
            radius: (flow.spin != 0.0).then(|| speed / flow.spin),
        }
    }

    /// Along and across the flow.
    fn of(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [c, s] = self.direction;
        let (along, left) = (c * x + s * y, c * y - s * x);
        let Some(radius) = self.radius else {
            return [along, left];
        };
        // The centre of the spin lies at `left` = radius.
        let towards = radius.signum() * (radius - left);
        [
            radius.abs() * along.atan2(towards),
            radius - radius.signum() * along.hypot(towards),
        ]
    }

    /// The place.
    fn place(&self, [along, across]: [f64; 2]) -> [f64; 2] {
        let [c, s] = self.direction;
        let [along, left] = match self.radius {
            None => [along, across],
            Some(radius) => {
                let (sin, cos) = (along / radius.abs()).sin_cos();
                let distance = radius.signum() * (radius - across);
                [distance * sin, radius - radius.signum() * distance * cos]
            }
        };
        [c * along - s * left, s * along + c * left]
    }
}

/// Streams to either side of the middle and samples of each before and behind it; those of a line, which has one stream.
const STREAMS: i32 = 64;
const SAMPLES: i32 = 96;
const SAMPLES_OF_LINES: i32 = 1000;

/// Samples are e^GRADING times as near to each other in the middle as at the edge, about.
const GRADING: f64 = 5.0;

/// Bisections by which the end of a stream is found.
const BISECTIONS: usize = 40;

/// Places from one end to the other, near to each other about 0.
fn graded([low, high]: [f64; 2], n: i32) -> impl Iterator<Item = f64> {
    let far = low.abs().max(high);
    (-n..=n)
        .map(move |k| far * (GRADING * f64::from(k) / f64::from(n)).sinh() / GRADING.sinh())
        .filter(move |place| (low..=high).contains(place))
}

impl Streams {
    /// Of a state, by the mean velocity of the surfaces. None with a layer of oil, whose state contains the missing film.
    pub fn new(d: &Discretisation, state: &State, flow: &Planar) -> Streams {
        let shape = &d.contact.shape;
        if shape.inlet.layer().is_some() || flow.centre == [0.0; 2] {
            return Streams::default();
        }
        let coordinates = Coordinates::new(flow);
        let mut ends = [[0.0_f64; 2]; 2];
        for [x, y, _] in d.contact.surface.vertices.iter().copied() {
            for (end, at) in ends.iter_mut().zip(coordinates.of([x, y])) {
                *end = [end[0].min(at), end[1].max(at)];
            }
        }
        let [along, across] = ends;
        let stream = |across: f64| stream(d, state, &coordinates, along, across);
        let streams = match shape.is_line() {
            true => vec![stream(0.0)],
            false => graded(across, STREAMS).map(stream).collect(),
        };
        Streams {
            coordinates,
            streams,
        }
    }

    /// F at a point, the missing film in the gap.
    pub fn missing(&self, fields: &PointFields) -> f64 {
        (self.left(fields.place, fields.pressure)).map_or(0.0, |film| (fields.film - film).max(0.0))
    }

    /// H where the stream left the film, at a place behind it; `None` where the gap is filled.
    pub fn left(&self, place: [f64; 2], pressure: f64) -> Option<f64> {
        if pressure > 0.0 || self.streams.is_empty() {
            return None;
        }
        let [along, across] = self.coordinates.of(place);
        let next = (self.streams).partition_point(|stream| stream.across < across);
        let last = self.streams.len() - 1;
        let [a, b] = [next.saturating_sub(1), next.min(last)].map(|k| &self.streams[k]);
        let weight = match b.across > a.across {
            true => ((across - a.across) / (b.across - a.across)).clamp(0.0, 1.0),
            false => 0.0,
        };
        let between = |a: f64, b: f64| match weight {
            0.0 => a,
            1.0 => b,
            _ => a + weight * (b - a),
        };
        let film = between(a.film, b.film);
        (film.is_finite() && along > between(a.top, b.top)).then_some(film)
    }
}

/// A stream over the contact area.
fn stream(
    d: &Discretisation,
    state: &State,
    coordinates: &Coordinates,
    ends: [f64; 2],
    across: f64,
) -> Stream {
    let shape = &d.contact.shape;
    let samples = match shape.is_line() {
        true => SAMPLES_OF_LINES,
        false => SAMPLES,
    };
    let pressure = |along: f64| pressure_at(d, &state.pressure, coordinates.place([along, across]));
    let places: Vec<f64> = graded(ends, samples).collect();
    let pressures: Vec<f64> = places.iter().map(|along| pressure(*along)).collect();
    let mut found = Stream {
        across,
        top: f64::INFINITY,
        film: f64::INFINITY,
    };
    let top = (0..places.len()).max_by(|a, b| pressures[*a].total_cmp(&pressures[*b]));
    let Some(top) = top.filter(|top| pressures[*top] > 0.0) else {
        // Without pressure anywhere: it has passed the contact between rigid parabolas, outside the area.
        let place = coordinates.place([0.0, across]);
        let since = shape.gap.since_closest(place, coordinates.direction);
        let [x, y] = [0, 1].map(|i: usize| place[i] - since * coordinates.direction[i]);
        found.top = -since;
        found.film = (state.rigid_separation + shape.gap.value([x, y])).max(0.0);
        return found;
    };
    found.top = places[top];
    let Some(end) = (top..places.len()).find(|k| pressures[*k] <= 0.0) else {
        return found;
    };
    let (mut full, mut broken) = (places[end - 1], places[end]);
    for _ in 0..BISECTIONS {
        let middle = 0.5 * (full + broken);
        match pressure(middle) > 0.0 {
            true => full = middle,
            false => broken = middle,
        }
    }
    let place = coordinates.place([full, across]);
    found.film = fields_at(d, state, place).map_or(f64::INFINITY, |fields| fields.film);
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Along the flow places move as the body does, across it they stay, with and without spin, and both lead back.
    #[test]
    fn coordinates_follow_the_flow() {
        for spin in [0.0, 0.3, -0.3] {
            let flow = Planar {
                centre: [0.8, 0.6],
                spin,
            };
            let coordinates = Coordinates::new(&flow);
            for place in [[0.3, -0.7], [-1.0, 0.4], [1.5, 1.5]] {
                let at = coordinates.of(place);
                let back = coordinates.place(at);
                let u = flow.at(place);
                let e = 1e-6;
                let moved = coordinates.of([place[0] + e * u[0], place[1] + e * u[1]]);
                for i in 0..2 {
                    assert_relative_eq!(back[i], place[i], epsilon = 1e-12);
                }
                assert_relative_eq!(moved[0] - at[0], e, epsilon = 1e-10);
                assert_relative_eq!(moved[1], at[1], epsilon = 1e-10);
            }
        }
    }
}
