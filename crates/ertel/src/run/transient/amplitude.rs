//! Amplitude reduction of waves that pass the film.
//!
//! ```text
//!   A_d/A_i = ½ (max h_c − min h_c)/A_i    over the last passage of a wavelength
//! ```
//! A_i is the amplitude of the waves, A_d that of the central film while one of them passes. Venner, Couhier, Lubrecht and Greenwood, Amplitude reduction of waviness in transient
//! EHL line contacts, Elastohydrodynamics '96 (1997), 103-112.

use super::found::InstantSolution;
use crate::case::{Case, SurfaceRelief};
use crate::contact::gap::{Body, Form};
use crate::solution::Figure;

/// A_d/A_i at each instant after a whole wave has passed the centre; empty without waves, with other reliefs, or with sliding or spin across the motion.
pub(super) fn amplitude_ratios(case: &Case, instants: &[InstantSolution]) -> Vec<Option<f64>> {
    let moves_straight = (case.transient.as_ref()).is_some_and(|transient| transient.is_straight());
    let [
        SurfaceRelief {
            form:
                Form::Waves {
                    wavelength,
                    amplitude,
                    direction,
                },
            body,
            place,
            ..
        },
    ] = &case.reliefs[..]
    else {
        return Vec::new();
    };
    if !moves_straight {
        return Vec::new();
    }
    let (across, along) = direction.sin_cos();
    let which = usize::from(*body == Body::Second);
    let (mut moved, mut rows) = (0.0, Vec::new());
    for (i, instant) in instants.iter().enumerate() {
        if let Some(before) = i.checked_sub(1).map(|i| &instants[i]) {
            let mean = 0.5 * (before.speeds[which] + instant.speeds[which]);
            moved += mean * (instant.time - before.time);
        }
        // Distance of the first crest past the centre.
        let past = (place[0] + moved) * along + place[1] * across;
        rows.push([past, instant.measured.estimate(Figure::FilmCentral).value]);
    }
    let ratios = ratios(&rows, *wavelength, *amplitude);
    match ratios.iter().any(Option::is_some) {
        true => ratios,
        false => Vec::new(),
    }
}

/// From rows of the first crest's distance past the centre and the central film.
fn ratios(rows: &[[f64; 2]], wavelength: f64, amplitude: f64) -> Vec<Option<f64>> {
    let of = |end: usize| {
        let [now, _] = rows[end];
        let before = rows[..end]
            .iter()
            .rposition(|[past, _]| (now - past).abs() >= wavelength)?;
        if rows[before][0].min(now) < 0.0 {
            return None;
        }
        let films = rows[before + 1..=end].iter().map(|[_, film]| *film);
        let [low, high] = films.fold([f64::INFINITY, 0.0_f64], |[low, high], film| {
            [low.min(film), high.max(film)]
        });
        Some(0.5 * (high - low) / amplitude.abs())
    };
    (0..rows.len()).map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    /// A film oscillating by 0.4 of the amplitude of waves of length 2 behind a crest at −1: known once a whole wave has passed the centre, not while it is at rest.
    #[test]
    fn an_oscillating_film_has_its_amplitude_ratio() {
        let film = |past: f64| {
            100.0
                + if past < 0.0 {
                    0.0
                } else {
                    0.4 * 5.0 * (TAU * past / 2.0).cos()
                }
        };
        let row = |past: f64| [past, film(past)];
        let rows: Vec<[f64; 2]> = (0..200).map(|i| row(-1.0 + 0.05 * f64::from(i))).collect();
        let found = ratios(&rows, 2.0, -5.0);
        for (ratio, [past, _]) in found.iter().zip(&rows) {
            match *past < 2.0 - 1e-9 {
                true => assert_eq!(*ratio, None, "{past}"),
                false if *past > 2.01 => assert!((ratio.unwrap() - 0.4).abs() < 1e-3, "{past}"),
                false => {}
            }
        }
        let at_rest = vec![row(3.0); 10];
        assert!(ratios(&at_rest, 2.0, 5.0).iter().all(Option::is_none));
        // Reversed to where there is no wave: no ratio.
        let back: Vec<[f64; 2]> = rows.iter().rev().copied().collect();
        assert_eq!(ratios(&back, 2.0, 5.0).last(), Some(&None));
    }
}
