//! F_{3/2} and F_{5/2} at the cost of an exponential function: their logarithms by cubic pieces between exact values.

use std::sync::OnceLock;

use super::statistics::integral;

/// Range of the tables in u. Above, asperities carry less than 1e-20 of κ; below, two terms of the moments are exact to 1e-5 (see [`deep`]).
const RANGE: [f64; 2] = [-7.0, 9.0];
/// Pieces per unit of u: errors below 1e-10.
const PIECES: f64 = 32.0;

/// An integral of the tail of Gaussian heights, F_n(u) = E[max(s − u, 0)^n].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tail {
    /// n = 3/2.
    ThreeHalves,
    /// n = 5/2.
    FiveHalves,
}

impl Tail {
    /// n.
    fn order(self) -> f64 {
        match self {
            Tail::ThreeHalves => 1.5,
            Tail::FiveHalves => 2.5,
        }
    }

    /// ln F and its slope at the knots.
    fn knots(self) -> &'static [[f64; 2]] {
        static KNOTS: [OnceLock<Vec<[f64; 2]>>; 2] = [const { OnceLock::new() }; 2];
        let (place, powers) = match self {
            Tail::ThreeHalves => (0, 2),
            Tail::FiveHalves => (1, 3),
        };
        KNOTS[place].get_or_init(|| {
            let n = ((RANGE[1] - RANGE[0]) * PIECES) as usize;
            (0..=n)
                .map(|i| {
                    let u = RANGE[0] + i as f64 / PIECES;
                    let value = integral(u, powers);
                    [value.ln(), -self.order() * integral(u, powers - 1) / value]
                })
                .collect()
        })
    }

    /// F and its derivative, of the cubic pieces themselves.
    #[inline]
    pub fn at(self, u: f64) -> [f64; 2] {
        let [low, high] = RANGE;
        if u >= high {
            return [0.0; 2];
        }
        if u < low {
            return self.deep(-u);
        }
        let at = (u - low) * PIECES;
        let i = at as usize;
        let t = at - i as f64;
        let knots = self.knots();
        let ([a, from], [b, to]) = (knots[i], knots[i + 1]);
        let (from, to, rise) = (from / PIECES, to / PIECES, b - a);
        let (second, third) = (3.0 * rise - 2.0 * from - to, from + to - 2.0 * rise);
        let value = (a + t * (from + t * (second + t * third))).exp();
        let slope = from + t * (2.0 * second + 3.0 * t * third);
        [value, value * slope * PIECES]
    }

    /// The same where mean planes overlap by m rms heights, many: E[(m + s)^n] = m^n (1 + a/m² + b/m⁴ …) in moments of s, a = n(n − 1)/2,
    /// b = n(n − 1)(n − 2)(n − 3)/8.
    fn deep(self, m: f64) -> [f64; 2] {
        let n = self.order();
        let a = 0.5 * n * (n - 1.0);
        let b = 0.25 * a * (n - 2.0) * (n - 3.0);
        let (power, inverse) = (m.powf(n), 1.0 / (m * m));
        let value = power * (1.0 + inverse * (a + inverse * b));
        let by_m = power / m * (n + inverse * (a * (n - 2.0) + inverse * b * (n - 4.0)));
        [value, -by_m]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// The tables against the integrals between their knots, slopes against −n F_{n−1}, and the series where it takes over.
    #[test]
    fn tables_against_integrals() {
        for (tail, powers) in [(Tail::ThreeHalves, 2), (Tail::FiveHalves, 3)] {
            for i in 0..1500 {
                let u = -7.0 + 0.0106 * f64::from(i);
                let [value, slope] = tail.at(u);
                assert_relative_eq!(value, integral(u, powers), max_relative = 1e-9);
                let exact = -tail.order() * integral(u, powers - 1);
                assert_relative_eq!(slope, exact, max_relative = 1e-7);
            }
            let ([value, slope], [deep, by_u]) = (tail.at(-7.0), tail.deep(7.0));
            assert_relative_eq!(value, deep, max_relative = 1e-4);
            assert_relative_eq!(slope, by_u, max_relative = 1e-4);
            assert_eq!(tail.at(9.0), [0.0; 2]);
        }
    }
}
