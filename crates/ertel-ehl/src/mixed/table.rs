//! F_{5/2} at the cost of an exponential function: its logarithm by cubic pieces between exact values.

use std::sync::OnceLock;

use super::statistics::{five_halves_integral, three_halves_integral};

/// Range of the table in u. Above, asperities carry less than 1e-20 of κ; below, two terms of the moments are exact to 1e-5 (see [`deep`]).
const RANGE: [f64; 2] = [-7.0, 9.0];
/// Pieces per unit of u: errors below 1e-10.
const PIECES: f64 = 32.0;

/// ln F and its slope at the knots.
fn knots() -> &'static [[f64; 2]] {
    static KNOTS: OnceLock<Vec<[f64; 2]>> = OnceLock::new();
    KNOTS.get_or_init(|| {
        let n = ((RANGE[1] - RANGE[0]) * PIECES) as usize;
        (0..=n)
            .map(|i| {
                let u = RANGE[0] + i as f64 / PIECES;
                let value = five_halves_integral(u);
                [value.ln(), -2.5 * three_halves_integral(u) / value]
            })
            .collect()
    })
}

/// F_{5/2} and its derivative, of the cubic pieces themselves.
#[inline]
pub fn five_halves(u: f64) -> [f64; 2] {
    let [low, high] = RANGE;
    if u >= high {
        return [0.0; 2];
    }
    if u < low {
        return deep(-u);
    }
    let at = (u - low) * PIECES;
    let i = at as usize;
    let t = at - i as f64;
    let knots = knots();
    let ([a, from], [b, to]) = (knots[i], knots[i + 1]);
    let (from, to, rise) = (from / PIECES, to / PIECES, b - a);
    let (second, third) = (3.0 * rise - 2.0 * from - to, from + to - 2.0 * rise);
    let value = (a + t * (from + t * (second + t * third))).exp();
    let slope = from + t * (2.0 * second + 3.0 * t * third);
    [value, value * slope * PIECES]
}

/// The same where mean planes overlap by m rms heights, many: E[(m + s)^{5/2}] = m^{5/2} (1 + 15/(8 m²) − 15/(128 m⁴) …), the series in moments of s.
fn deep(m: f64) -> [f64; 2] {
    let (root, inverse) = (m.sqrt(), 1.0 / (m * m));
    let value = m * m * root * (1.0 + inverse * (1.875 - inverse * 0.117_187_5));
    let by_m = m * root * (2.5 + inverse * (0.9375 + inverse * 0.175_781_25));
    [value, -by_m]
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// The table against the integral between its knots, its slope against −5/2 F_{3/2}, and the series where it takes over.
    #[test]
    fn table_against_integrals() {
        for i in 0..1500 {
            let u = -7.0 + 0.0106 * f64::from(i);
            let [value, slope] = five_halves(u);
            assert_relative_eq!(value, five_halves_integral(u), max_relative = 1e-9);
            let exact = -2.5 * three_halves_integral(u);
            assert_relative_eq!(slope, exact, max_relative = 1e-7);
        }
        let ([value, slope], [deep, by_u]) = (five_halves(-7.0), deep(7.0));
        assert_relative_eq!(value, deep, max_relative = 1e-5);
        assert_relative_eq!(slope, by_u, max_relative = 1e-5);
        assert_eq!(five_halves(9.0), [0.0; 2]);
    }
}
