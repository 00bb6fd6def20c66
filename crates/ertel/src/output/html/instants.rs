//! Page data of a transient case: the centreline, and the film map of point contacts, instant by instant.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde_json::{Value, json};

use super::data::bytes;
use crate::output::transient::{film_axis, film_range};
use crate::run::transient::TransientSolution;

/// Maximum bytes of all centrelines, and of all maps, before encoding.
const MOST_PROFILE_BYTES: usize = 300_000;
const MOST_MAP_BYTES: usize = 180_000;
/// Maximum number of maps.
const MOST_MAPS: usize = 60;
/// Films are kept up to this multiple of the end of their axis.
const BEYOND: f64 = 2.0;

/// The data; `None` without instants to show.
///
/// Numbers are quantised: centrelines to 16 bits, maps to 8. Line contacts have their instants, evenly thinned if too many; others have the output times.
pub fn instants(found: &TransientSolution) -> Value {
    let [low, high] = film_range(found);
    let fields = &found.fields;
    if fields.times.is_empty() || fields.x.len() < 2 || high <= 0.0 {
        return Value::Null;
    }
    let is_line = fields.is_line();
    let (times, x): (Vec<f64>, &[f64]) = match is_line {
        true => (
            found.instants.iter().map(|i| i.time).collect(),
            &found.map.x,
        ),
        false => (fields.times.clone(), &fields.x),
    };
    let most = match is_line {
        true => MOST_PROFILE_BYTES / (4 * x.len().max(1)),
        false => MOST_MAPS,
    };
    let shown = evenly(times.len(), most.max(2));
    // The grid row through the centre.
    let row = fields.y.iter().map(|y| y.abs());
    let middle = row.enumerate().min_by(|a, b| a.1.total_cmp(&b.1));
    let start = middle.map_or(0, |(j, _)| j) * fields.x.len();
    let line = |of_line: &[Vec<f32>], of_grid: &[Vec<f32>], [low, high]: [f64; 2]| -> Value {
        let values: Vec<u16> = shown
            .iter()
            .flat_map(|i| match is_line {
                true => &of_line[*i][..],
                false => &of_grid[*i][start..start + x.len()],
            })
            .map(|v| quantised(*v, [low, high], u16::MAX.into()) as u16)
            .collect();
        json!({ "low": low, "high": high, "values": STANDARD.encode(bytes(&values, u16::to_le_bytes)) })
    };
    let map = &found.map;
    let pressures = [&map.pressures, &fields.pressure];
    let highest = pressures[usize::from(!is_line)].iter().flatten();
    let highest = f64::from(highest.fold(0.0_f32, |m, p| m.max(*p))).max(1.0);
    let places: Vec<f32> = x.iter().map(|x| *x as f32).collect();
    json!({
        "times": shown.iter().map(|i| times[*i]).collect::<Vec<_>>(),
        "half_width": found.half_width,
        "is_rolling": found.instants.iter().any(|i| i.speeds[0] + i.speeds[1] != 0.0),
        "x": STANDARD.encode(bytes(&places, f32::to_le_bytes)),
        "film": line(&map.films, &fields.film, [0.0, BEYOND * high]),
        "pressure": line(&map.pressures, &fields.pressure, [0.0, highest]),
        "film_axis": film_axis([low, high]),
        "map": if is_line { Value::Null } else { maps(found, &shown, [low, high]) },
    })
}

/// Films of point contacts at these output times, in rows along the motion from the smallest y.
fn maps(found: &TransientSolution, shown: &[usize], range: [f64; 2]) -> Value {
    let fields = &found.fields;
    let [nx, ny] = [fields.x.len(), fields.y.len()];
    let fits = |stride: &usize| {
        nx.div_ceil(*stride) * ny.div_ceil(*stride) * shown.len() <= MOST_MAP_BYTES
    };
    let stride = (1..nx.max(ny)).find(fits).unwrap_or(nx.max(ny));
    let [columns, rows]: [Vec<usize>; 2] = [nx, ny].map(|n| (0..n).step_by(stride).collect());
    let values: Vec<u8> = shown
        .iter()
        .flat_map(|i| {
            let film = &fields.film[*i];
            let columns = &columns;
            let of_row = move |j: usize| columns.iter().map(move |k| film[j * nx + k]);
            rows.iter().flat_map(move |j| of_row(*j))
        })
        .map(|film| quantised(film, range, u8::MAX.into()) as u8)
        .collect();
    let ends = |places: &[f64], kept: &[usize]| [places[0], places[kept[kept.len() - 1]]];
    json!({
        "n": [columns.len(), rows.len()],
        "x": ends(&fields.x, &columns),
        "y": ends(&fields.y, &rows),
        "range": range,
        "values": STANDARD.encode(values),
    })
}

/// The step nearest to a value, from 0 at the lower limit to `last` at the upper one.
fn quantised(value: f32, [low, high]: [f64; 2], last: f64) -> f64 {
    let share = (f64::from(value) - low) / (high - low);
    (last * share).round().clamp(0.0, last)
}

/// At most this many indices below n, including the first and the last.
fn evenly(n: usize, most: usize) -> Vec<usize> {
    if n <= most {
        return (0..n).collect();
    }
    (0..most).map(|i| i * (n - 1) / (most - 1)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thinned_numbers_keep_the_ends() {
        assert_eq!(evenly(3, 5), [0, 1, 2]);
        assert_eq!(evenly(11, 3), [0, 5, 10]);
        let many = evenly(1000, 234);
        assert_eq!((many.len(), many[0], many[233]), (234, 0, 999));
        assert!(many.windows(2).all(|w| w[0] < w[1]));
    }

    /// The error is at most half a step; values outside the range are clamped.
    #[test]
    fn values_are_quantised() {
        let range = [1.0, 3.0];
        for value in [1.0_f32, 1.001, 2.0, 2.7, 3.0] {
            let back = 1.0 + 2.0 * quantised(value, range, 255.0) / 255.0;
            assert!((back - f64::from(value)).abs() <= 1.0 / 255.0 + 1e-9);
        }
        assert_eq!(quantised(7.0, range, 255.0), 255.0);
        assert_eq!(quantised(-7.0, range, 255.0), 0.0);
    }
}
