//! Approximate film of a starved contact.
//!
//! ```text
//!   ∫_1^M g/(g + H)³ dX = ∫_1^∞ g/(g + H_f)³ dX        g: the gap before the dry contact
//! ```
//! Inlet of Ertel and Grubin, up to the solidification of the lubricant, cut off at the meniscus M: H for the flooded H_f.
//! Accurate enough for the mesh and the start of the solve.

use super::{Family, Supply, hertz};

/// Central film, in a²/R, for the `flooded` one and a supply; `length` a and `film` a²/R in m.
pub fn starved_film(family: Family, flooded: f64, supply: &Supply, length: f64, film: f64) -> f64 {
    match supply {
        Supply::Flooded => flooded,
        Supply::OilLayer { thickness } => flooded.min(thickness / film),
        Supply::Meniscus { distance } => {
            let meniscus = distance / length;
            let goal = inlet_integral(family, flooded, FAR);
            let mut bounds = [0.0, flooded];
            for _ in 0..HALVINGS {
                let middle = 0.5 * (bounds[0] + bounds[1]);
                let end = usize::from(inlet_integral(family, middle, meniscus) < goal);
                bounds[end] = middle;
            }
            bounds[1]
        }
    }
}

/// Half-widths that count as infinitely far: what is beyond adds 1e-6 and less.
const FAR: f64 = 100.0;
/// Halvings of the interval.
const HALVINGS: usize = 40;
/// Points of the integral.
const POINTS: usize = 400;

/// ∫_1^end g/(g + H)³ dX, on intervals that grow as the third power of the distance to the rim.
fn inlet_integral(family: Family, film: f64, end: f64) -> f64 {
    let gap = |x: f64| hertz::dry_gap(family, x);
    (0..POINTS)
        .map(|i| {
            let t = (i as f64 + 0.5) / POINTS as f64;
            let x = 1.0 + (end - 1.0) * t.powi(3);
            let weight = 3.0 * (end - 1.0) * t * t / POINTS as f64;
            weight * gap(x) / (gap(x) + film).powi(3)
        })
        .sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// A far meniscus starves nothing; near the rim of a line contact, where g = c ξ^(3/2), the integral of the thin film is that of the
    /// flooded one over its whole length.
    #[test]
    fn films_of_near_and_far_menisci() {
        for family in [Family::Cylinder, Family::Point] {
            let film =
                |distance| starved_film(family, 0.01, &Supply::Meniscus { distance }, 1.0, 1.0);
            assert_relative_eq!(film(50.0), 0.01, max_relative = 1e-3);
            let mut last = 0.0;
            for distance in [1.001, 1.01, 1.1, 1.5, 3.0] {
                assert!(film(distance) > last);
                last = film(distance);
            }
            let h = film(1.1);
            let [starved, flooded] = [
                inlet_integral(family, h, 1.1),
                inlet_integral(family, 0.01, FAR),
            ];
            assert_relative_eq!(starved, flooded, max_relative = 1e-6);
            let layer = Supply::OilLayer { thickness: 0.004 };
            assert_eq!(starved_film(family, 0.01, &layer, 1.0, 1.0), 0.004);
        }
    }
}
