//! Where the dry contact of a roller ends along its axis, and how steeply.

use super::slices::NARROWEST;

/// Load per length, over the mean one, that counts as zero: that of the narrowest half-width.
pub(super) const LEAST: f64 = NARROWEST * NARROWEST;
/// Pieces of the roller searched for the ends of the contact, and the tolerance of the search, in half-widths.
const PIECES: usize = 150;
const TOLERANCE: f64 = 2e-3;
/// Distances from an end at which its steepness is sampled, in half-widths, each twice the one before.
const NEAREST: f64 = 0.02;
const DISTANCES: i32 = 9;
/// Distance of the contact's end from that of the roller below which the edge of the roller indents the raceway,
const AT_EDGE: f64 = 5e-3;
/// and distance from an edge within which it causes a missing film.
const AROUND_EDGE: f64 = 0.3;

/// Largest aspect ratio of a cell along the axis: at gentle ends and at edges, whose pressure has no length
/// scale;
const LONGEST: f64 = 2.0;
/// at steep ends as a share of the length over which the load rises: films are several times thinner there than in the middle;
const OF_RISE: f64 = 0.3;
/// and at the steepest.
const SHORTEST: f64 = 0.05;

/// An end of the contact along the axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct End {
    /// Where it is.
    pub y: f64,
    /// Length over which the load per length rises there from nothing to the mean one.
    pub rise: f64,
    /// Whether the roller ends there, too, and its edge indents the raceway.
    pub cut: bool,
}

/// Both ends of the contact of a roller of half the length k, for loads per length whose proportions count.
pub(super) fn ends(half_length: f64, load: &impl Fn(f64) -> f64) -> [End; 2] {
    let place = |i: usize| half_length * (2.0 * i as f64 / PIECES as f64 - 1.0);
    let found: Vec<f64> = (0..=PIECES).map(|i| load(place(i))).collect();
    let mean = found.iter().sum::<f64>() / found.len() as f64;
    let relative = |y: f64| load(y) / mean;
    let loaded = |q: &f64| *q > LEAST * mean;
    let first = found.iter().position(loaded).unwrap_or(0);
    let last = found.iter().rposition(loaded).unwrap_or(PIECES);
    let left = [place(first), place(first.max(1) - 1)];
    let right = [place(last), place((last + 1).min(PIECES))];
    [
        End::new(left, -half_length, &relative),
        End::new(right, half_length, &relative),
    ]
}

impl End {
    /// Between a place with load and one farther out, towards the end `rim` of the roller.
    fn new([mut inside, mut outside]: [f64; 2], rim: f64, load: &impl Fn(f64) -> f64) -> End {
        if load(outside) > LEAST {
            inside = outside;
        }
        while (outside - inside).abs() > TOLERANCE {
            let middle = 0.5 * (inside + outside);
            match load(middle) > LEAST {
                true => inside = middle,
                false => outside = middle,
            }
        }
        let distances = (0..DISTANCES).map(|k| NEAREST * 2.0_f64.powi(k));
        let first = load(inside);
        let steepest = distances.map(|d| (load(inside - rim.signum() * d) - first) / d);
        End {
            y: inside,
            rise: 1.0 / steepest.fold(0.0, f64::max),
            cut: first > LEAST && (inside - rim).abs() < AT_EDGE,
        }
    }

    /// Largest aspect ratio of a cell there, along the axis.
    pub fn longest_cell(&self) -> f64 {
        match self.cut {
            true => LONGEST,
            false => (OF_RISE * self.rise).clamp(SHORTEST, LONGEST),
        }
    }

    /// Whether an edge indents the raceway at y.
    pub fn presses_in_at(&self, y: f64) -> bool {
        self.cut && (y - self.y).abs() < AROUND_EDGE
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// A load that rises linearly to 1 over 0.4 half-widths from 49.7 on, where the roller ends at 50, and over 10 at the other end: places,
    /// lengths of the rise and of cells.
    #[test]
    fn steep_and_gentle_ends() {
        let load = |y: f64| ((49.7 - y) / 0.4).min((y + 45.0) / 10.0).clamp(0.0, 1.0);
        let [gentle, steep] = ends(50.0, &load);
        assert!((steep.y - 49.7).abs() < 2.0 * TOLERANCE && !steep.cut);
        assert!((gentle.y + 45.0).abs() < 0.03, "{}", gentle.y);
        let mean = (0.5 * (0.4 + 10.0) + 49.7 + 45.0 - 10.4) / 100.0;
        assert_relative_eq!(steep.rise, 0.4 * mean, max_relative = 0.02);
        assert_relative_eq!(gentle.rise, 10.0 * mean, max_relative = 0.02);
        assert_relative_eq!(steep.longest_cell(), OF_RISE * steep.rise);
        assert_eq!(gentle.longest_cell(), LONGEST);
        assert!(!steep.presses_in_at(49.7));
    }

    /// A load that goes on to the end of the roller: its edge presses in, within a part of a half-width.
    #[test]
    fn edges_that_press_in() {
        let load = |y: f64| if y.abs() < 50.0 { 1.0 } else { 0.0 };
        for (end, side) in ends(50.0, &load).into_iter().zip([-50.0, 50.0]) {
            assert!((end.y - side).abs() < 2.0 * TOLERANCE && end.cut);
            assert_eq!(end.longest_cell(), LONGEST);
            assert!(end.presses_in_at(side) && !end.presses_in_at(0.99 * side));
        }
        // Without a load no edge indents the raceway.
        assert!(ends(50.0, &|_| 0.0).iter().all(|end| !end.cut));
    }
}
