//! Linear interpolation in a table.

use super::Error;

/// Value at x between points of increasing x.
///
/// # Errors
/// x outside of the table.
pub(super) fn interpolate(
    name: &'static str,
    points: impl Iterator<Item = [f64; 2]> + Clone,
    x: f64,
) -> Result<f64, Error> {
    let mut last: Option<[f64; 2]> = None;
    let mut first = f64::NAN;
    for [at, value] in points {
        match last {
            None => first = at,
            Some([before, below]) if (before..=at).contains(&x) => {
                return Ok(below + (x - before) / (at - before) * (value - below));
            }
            Some(_) => {}
        }
        last = Some([at, value]);
    }
    Err(Error::Range {
        name,
        value: x,
        low: first,
        high: last.map_or(f64::NAN, |[x, _]| x),
    })
}

/// The same with x clamped to the table.
pub(super) fn clamped(grid: &[f64], values: &[f64], x: f64) -> f64 {
    let last = grid.len().min(values.len()) - 1;
    let after = grid.partition_point(|g| *g < x).clamp(1, last);
    let share = ((x - grid[after - 1]) / (grid[after] - grid[after - 1])).clamp(0.0, 1.0);
    values[after - 1] + share * (values[after] - values[after - 1])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn between_and_outside() {
        let points = [[1.0, 10.0], [2.0, 20.0], [4.0, 0.0]];
        let at = |x| interpolate("x", points.into_iter(), x);
        assert_eq!(at(1.0), Ok(10.0));
        assert_eq!(at(1.5), Ok(15.0));
        assert_eq!(at(3.0), Ok(10.0));
        assert!(at(0.9).is_err() && at(4.1).is_err() && at(f64::NAN).is_err());
        let grid = [1.0, 2.0, 4.0];
        assert_eq!(clamped(&grid, &[10.0, 20.0, 0.0], 0.0), 10.0);
        assert_eq!(clamped(&grid, &[10.0, 20.0, 0.0], 3.0), 10.0);
        assert_eq!(clamped(&grid, &[10.0, 20.0, 0.0], 9.0), 0.0);
    }
}
