//! Places and instants of published films, and the computed film there.

use ertel::run::transient::InstantProfile;

/// Where and when the film is compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Time, s, one of the case's output times.
    pub time: f64,
    /// Place along the motion on the centreline, m.
    pub x: f64,
}

impl Place {
    pub(super) fn words(self) -> String {
        format!(
            "film at x = {:.1} µm, {:.3} ms",
            self.x * 1e6,
            self.time * 1e3
        )
    }
}

/// A published film along the motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Published {
    /// Time, s, one of the case's output times.
    pub time: f64,
    /// Places, µm, and films there, nm.
    pub points: Vec<[f64; 2]>,
}

/// Times are one if they differ by less than this share.
pub(super) const SAME_TIME: f64 = 1e-9;

pub(super) fn at_time(profiles: &[InstantProfile], time: f64) -> Option<&InstantProfile> {
    profiles
        .iter()
        .find(|p| (p.time - time).abs() <= SAME_TIME * time)
}

/// Film thickness at a place and an instant, m, between the nodes linear; `None` beyond the grid and at no output time.
pub(super) fn film_at(profiles: &[InstantProfile], place: Place) -> Option<f64> {
    let profile = at_time(profiles, place.time)?;
    let above = profile.x.iter().position(|x| *x >= place.x)?;
    if profile.x[above] == place.x {
        return Some(profile.film[above]);
    }
    let below = above.checked_sub(1)?;
    let share = (place.x - profile.x[below]) / (profile.x[above] - profile.x[below]);
    Some(profile.film[below] + share * (profile.film[above] - profile.film[below]))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A film h = 100 + 10 x² at nodes is read between them along chords; nothing is read beyond them or at another time.
    #[test]
    fn films_are_read_between_nodes() {
        let x: Vec<f64> = vec![-2.0, -1.0, 0.0, 2.0];
        let profile = InstantProfile {
            time: 3e-3,
            pressure: vec![0.0; 4],
            film: x.iter().map(|x| 100.0 + 10.0 * x * x).collect(),
            x,
        };
        let at = |time, x| film_at(std::slice::from_ref(&profile), Place { time, x });
        assert_eq!(at(3e-3, -2.0), Some(140.0));
        assert_eq!(at(3e-3, -1.5), Some(125.0));
        assert_eq!(at(3e-3, 0.5), Some(110.0));
        assert_eq!(at(3e-3, 2.5), None);
        assert_eq!(at(3e-3, -2.5), None);
        assert_eq!(at(3.1e-3, 0.0), None);
    }
}
