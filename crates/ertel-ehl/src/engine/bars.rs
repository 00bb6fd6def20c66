//! Error bars of figures from mesh to mesh.
//!
//! ```text
//!   bar = S max(c |d_1|, f |d_2|),   d_1 = f_n − f_(n−1),  d_2 = f_(n−1) − f_(n−2),  r = |d_1|/|d_2|
//!   c = r/(1 − r) within [⅓, 1],  f = ⅛        c = 1,  f = ¼ where d_1 and d_2 have opposite signs          films
//!   c = r/(1 − r) within [⅓, 1 + √2]           c = 1,  f = ½; f = ½ where r < ⅛, too                            other figures
//! ```
//! c is the remainder of a geometric series of differences: ⅓ for second order in the cell size, 1 for first order, 1 + √2 for order one
//! half; at least 1 where meshes do not resolve the thinnest film. A difference that vanishes by chance is bounded from below by the previous one. Where a difference
//! changes sign, or is about to (falls faster than the cube of the cell size), f is the remainder if the previous one falls at first order. Films, for which the meshes are refined, converge at first order or better.

use crate::solution::{Bar, Bars, Figure, Figures, Reading};

/// Factor on all bars.
const SAFETY: f64 = 1.5;

/// Smallest remaining error, over the previous difference: at an order of two and a half.
const LEAST_SHARE: f64 = 1.0 / 8.0;

/// Ratio of differences that fall with the cube of the cell: faster ones vanish by chance, or before their sign changes.
const QUICKEST: f64 = 1.0 / 8.0;

/// Slowest convergence assumed for the differences of a figure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slowest {
    /// Largest remaining error of the series, over its last difference.
    remaining: f64,
    /// Smallest remaining error where the sign changes, over the previous difference.
    remaining_at_turn: f64,
    /// The same where the last difference nearly vanishes.
    remaining_if_vanishing: f64,
}

impl Slowest {
    /// Of a figure.
    pub fn of(figure: Figure) -> Slowest {
        match figure {
            Figure::FilmCentral
            | Figure::FilmMinimum
            | Figure::MeanGapCentral
            | Figure::MeanGapMinimum => Slowest::OF_FILMS,
            _ => Slowest::OF_OTHERS,
        }
    }

    /// Of central and minimum film.
    pub const OF_FILMS: Slowest = Slowest {
        remaining: 1.0,
        remaining_at_turn: 1.0 / 4.0,
        remaining_if_vanishing: LEAST_SHARE,
    };
    /// Of all else: with the root of the cell, r = 1/√2; where the sign changes, with the cell.
    pub const OF_OTHERS: Slowest = Slowest {
        remaining: 1.0 + std::f64::consts::SQRT_2,
        remaining_at_turn: 1.0 / 2.0,
        remaining_if_vanishing: 1.0 / 2.0,
    };
}

/// Relative uncertainty of the outer half of an integral (truncated gap). Gaps are parabolas up to the ends of the bodies; for round bodies ∫dA/h of the outer half is smaller by up to
/// 0.18, between a ball and its groove by 0.4.
const SHARE_OF_END: f64 = 0.5;

/// Relative change of the minimum film from grid to grid above which it counts as not resolved.
const THINNEST_RESOLVED: f64 = 0.05;

/// Error of the last of up to three values, the newest first; `settled`: whether differences may be taken for those of a higher order.
pub fn bar(values: [Option<f64>; 3], settled: bool, slowest: Slowest) -> Option<f64> {
    let [Some(here), Some(before), first] = values else {
        return None;
    };
    let last = here - before;
    let Some(first) = first else {
        // Two values show no order.
        return Some(SAFETY * slowest.remaining * last.abs());
    };
    let former = before - first;
    let ratio = (last / former).abs();
    let turns = last * former < 0.0;
    // NaN where all three are equal.
    let series = match ratio < 1.0 {
        true => (ratio / (1.0 - ratio)).min(slowest.remaining),
        false => slowest.remaining,
    };
    let share = match (turns, settled) {
        (true, _) => 1.0,
        (false, true) => series.max(1.0 / 3.0),
        (false, false) => series.max(1.0),
    };
    let least = match turns {
        true => slowest.remaining_at_turn,
        false if ratio < QUICKEST => slowest.remaining_if_vanishing,
        false => LEAST_SHARE,
    };
    Some(SAFETY * (share * last.abs()).max(least * former.abs()))
}

/// Whether the last two minimum films agree.
pub fn is_settled(minimum: [Option<f64>; 3]) -> bool {
    let [Some(here), Some(before), _] = minimum else {
        return false;
    };
    (here - before).abs() < THINNEST_RESOLVED * here
}

/// Readings of the figure by which a film is refined, from up to three grids: the mean gap of rough surfaces, whose distance may vanish.
pub fn gap_of(of_grids: [Option<&Figures>; 3], film: Figure) -> [Option<f64>; 3] {
    let gap = match film {
        Figure::FilmCentral => Figure::MeanGapCentral,
        _ => Figure::MeanGapMinimum,
    };
    of_grids.map(|figures| {
        let figures = figures?;
        figures.value(gap).or_else(|| figures.value(film))
    })
}

/// Error bars from the figures of up to three grids, the newest first; `least`: relative errors of the central film and of all else at least.
pub fn bars(of_grids: [Option<&Figures>; 3], cell: f64, least: [f64; 2]) -> Bars {
    let mut bars = Bars::default();
    let Some(newest) = of_grids[0] else {
        return bars;
    };
    let values = |figure| of_grids.map(|figures| Some(figures?.get(figure)?.value));
    let settled = is_settled(gap_of(of_grids, Figure::FilmMinimum));
    let is_rough = newest.get(Figure::MeanGapCentral).is_some();
    let error = |figure| bar(values(figure), settled, Slowest::of(figure));
    // Of what a film is likely to err by, without the factor.
    let of_film = |figure| {
        let gaps = gap_of(of_grids, figure);
        let relative = bar(gaps, settled, Slowest::OF_FILMS).zip(gaps[0]);
        relative.map_or(0.0, |(error, film)| (error / film).abs() / SAFETY)
    };
    let [central, minimum] = [Figure::FilmCentral, Figure::FilmMinimum].map(of_film);
    for figure in Figure::ALL {
        let readings = of_grids.map(|figures| figures.and_then(|f| f.get(figure)));
        let Some(value) = error(figure) else {
            continue;
        };
        let reading = newest.get(figure).unwrap_or(Reading::new(0.0));
        let least = match figure {
            Figure::FilmCentral => least[0] * reading.size,
            _ => least[1] * reading.size,
        };
        // Not `max`: it would lose NaN.
        let value = if value < least { least } else { value };
        // A film below zero is not resolved.
        let value = match figure {
            Figure::FilmMinimum | Figure::FilmCentral if reading.value <= 0.0 && !is_rough => {
                value.max(2.0 * reading.value.abs())
            }
            Figure::FilmCentral | Figure::MeanGapCentral => value,
            // Differences of both may change sign by chance, but rarely at the same time.
            Figure::FilmMinimum | Figure::MeanGapMinimum => value
                .max(reading.misfit)
                .max(SAFETY * central * reading.size),
            // No figure is more accurate than the film that it depends on.
            Figure::FilmCentrelineMinimum => value.max(minimum * reading.size),
            _ => {
                let value = value.max(central * reading.size).max(reading.misfit);
                value + SHARE_OF_END * reading.cut
            }
        };
        let places = readings.map(|r| r.and_then(|r| r.place));
        let place = match places {
            [Some(here), Some(before), _] => {
                let distance = (here[0] - before[0]).hypot(here[1] - before[1]);
                Some(SAFETY * distance.max(cell))
            }
            _ => None,
        };
        if value.is_finite() {
            bars.set(figure, Bar { value, place });
        }
    }
    for peak in [Figure::PressureRidge, Figure::PressureSpike] {
        widen_by_peak(&mut bars, peak, of_grids);
    }
    bars
}

/// The largest pressure is no more accurate than a narrow peak that no grid resolves and that may be higher: on the finest grids it still grows by the same amount from grid to grid.
/// A peak on fewer than three grids has no error bar.
fn widen_by_peak(bars: &mut Bars, peak: Figure, of_grids: [Option<&Figures>; 3]) {
    let values = of_grids.map(|figures| figures?.value(peak));
    let largest = of_grids[0].and_then(|figures| figures.value(Figure::PressureMaximum));
    let (Some(height), Some(largest), Some(_)) = (values[0], largest, of_grids[1]) else {
        // Figures of a single grid have no bars.
        return;
    };
    let mut widen = |figure: Figure, error: f64| {
        let bar = bars.get(figure);
        let value = bar.map_or(error, |bar| bar.value.max(error));
        let place = bar.and_then(|bar| bar.place);
        bars.set(figure, Bar { value, place });
        value
    };
    let unknown = if values.iter().all(Option::is_some) {
        0.0
    } else {
        height
    };
    let error = widen(peak, unknown);
    if error > peak.widest_bar() * height && height + error > largest {
        widen(Figure::PressureMaximum, error);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// By hand: 1.16, 1.04, 1.01 fall with the square and err by 0.01, held up to an eighth of 0.12; 1.4, 1.2, 1.1 with the cell and err by 0.1; a difference
    /// that vanishes counts an eighth of the one before, one that turns a quarter; two grids alone show no order.
    #[test]
    fn bars_by_hand() {
        let bar = |values, settled| bar(values, settled, Slowest::OF_FILMS);
        let of = |values: [f64; 3]| bar(values.map(Some), true).unwrap() / SAFETY;
        assert_relative_eq!(of([1.01, 1.04, 1.16]), 0.015, max_relative = 1e-9);
        assert_relative_eq!(of([1.01, 1.04, 1.11]), 0.0225, max_relative = 1e-9);
        assert_relative_eq!(of([1.1, 1.2, 1.4]), 0.1, max_relative = 1e-9);
        assert_relative_eq!(of([1.0, 1.0, 1.16]), 0.02, max_relative = 1e-9);
        assert_relative_eq!(of([1.05, 1.04, 1.16]), 0.03, max_relative = 1e-9);
        let unsettled = bar([1.01, 1.04, 1.16].map(Some), false).unwrap();
        assert_relative_eq!(unsettled, SAFETY * 0.03, max_relative = 1e-9);
        let two = bar([Some(1.1), Some(1.2), None], true).unwrap();
        assert_relative_eq!(two, 0.15, max_relative = 1e-9);
        assert_eq!(bar([Some(1.1), None, None], true), None);
        assert!(is_settled([Some(1.0), Some(1.04), None]));
        assert!(
            !is_settled([Some(1.0), Some(0.9), None])
                && !is_settled([Some(-1.0), Some(-1.0), None])
        );
    }

    /// Peaks of 0.65, 0.72 and 0.80 GPa next to a central pressure of 1.01 may grow beyond it: the largest pressure has the bar of the peak; ones of 0.25, 0.28 and
    /// 0.30 may not; a peak on the last grid alone has no bar.
    #[test]
    fn a_growing_peak_may_be_the_largest_pressure() {
        let bar_of = |peaks: [Option<f64>; 3]| {
            let figures = peaks.map(|peak| {
                let mut figures = Figures::default();
                figures.note(Figure::FilmMinimum, Reading::new(1e-7));
                figures.note(Figure::PressureMaximum, Reading::new(1.01e9));
                if let Some(peak) = peak {
                    figures.note(Figure::PressureRidge, Reading::new(1e9 * peak));
                }
                figures
            });
            let bars = bars(figures.each_ref().map(Some), 1e-6, [1e-6; 2]);
            bars.get(Figure::PressureMaximum).unwrap().value / 1e9
        };
        let growing = bar_of([Some(0.80), Some(0.72), Some(0.65)]);
        let remaining = SAFETY * (1.0 + std::f64::consts::SQRT_2) * 0.08;
        assert_relative_eq!(growing, remaining, max_relative = 1e-9);
        assert!(bar_of([Some(0.30), Some(0.28), Some(0.25)]) < 1e-5);
        assert!(bar_of([None; 3]) < 1e-5);
        assert_relative_eq!(bar_of([Some(0.65), None, None]), 0.65, max_relative = 1e-9);
    }

    /// f = 3 + h^q errs by h^q: the bars of figures cover that at any order from ½ to 4, and are wider than needed by the factor alone below the second. Where
    /// 0.3 h falls short of 0.4 h² on coarse grids and outweighs it on fine ones, the differences change sign, and vanish at h = 0.25, while the error is 0.05.
    #[test]
    fn bars_cover_sequences_of_known_order() {
        let of = |f: &dyn Fn(f64) -> f64, h: f64| {
            let values = [h, 2.0 * h, 4.0 * h].map(|h| Some(f(h)));
            bar(values, true, Slowest::OF_OTHERS).unwrap()
        };
        for order in [0.5, 0.7, 1.0, 1.5, 2.0, 2.5, 4.0] {
            for h in [0.25, 0.1, 0.03_f64] {
                let error = h.powf(order);
                let own = of(&|h: f64| 3.0 + h.powf(order), h);
                assert!(own >= error, "order {order}: {own} of {error}");
                // From second order on, the previous difference bounds it from below.
                let factor = own / SAFETY / error;
                match order {
                    ..2.0 => assert_relative_eq!(factor, 1.0, max_relative = 1e-9),
                    2.0 => assert_relative_eq!(factor, 1.5, max_relative = 1e-9),
                    _ => {}
                }
            }
        }
        for (h, remaining) in [(0.5, 0.05), (0.4, 0.056), (0.3, 0.054), (0.25, 0.05_f64)] {
            let own = of(&|h: f64| 3.0 + 0.3 * h - 0.4 * h * h, h);
            assert_relative_eq!(remaining, 0.3 * h - 0.4 * h * h, max_relative = 1e-9);
            assert!(own >= remaining, "at {h}: {own} of {remaining}");
        }
    }

    /// Round bodies compared with parabolas, from half of their radius on, by sums in 10,000 steps: ∫dA/h of a sphere, ∫dx/h of a cylinder. Both differ by
    /// less than the error bars allow for that part.
    #[test]
    fn outer_half_of_round_bodies() {
        let n = 10_000;
        let sum = |of: &dyn Fn(f64) -> f64| -> f64 {
            let step = 0.5 / f64::from(n);
            (0..n)
                .map(|i| step * of(0.5 + step * (f64::from(i) + 0.5)))
                .sum()
        };
        let round = |r: f64| 1.0 - (1.0 - r * r).sqrt();
        for (power, by_hand) in [(1, 0.174), (0, 0.158)] {
            let area = |r: f64| r.powi(power);
            let parabola = sum(&|r| area(r) / (0.5 * r * r));
            let own = 1.0 - sum(&|r| area(r) / round(r)) / parabola;
            assert_relative_eq!(own, by_hand, epsilon = 2e-3);
            assert!(own < SHARE_OF_END);
        }
    }

    /// A ball of 4.763 mm in a groove of 4.953 mm, across the motion from half of the ball's radius on, by the same sum: ∫dy/h is smaller by 0.39 than for the parabola,
    /// whose curvatures nearly cancel.
    #[test]
    fn outer_half_of_a_ball_in_its_groove() {
        let (ball, groove) = (4.763_f64, 4.953_f64);
        let drop = |r: f64, y: f64| r - (r * r - y * y).sqrt();
        let n = 10_000;
        let step = 0.5 * ball / f64::from(n);
        let sum = |gap: &dyn Fn(f64) -> f64| -> f64 {
            (0..n)
                .map(|i| step / gap(0.5 * ball + step * (f64::from(i) + 0.5)))
                .sum()
        };
        let round = sum(&|y| drop(ball, y) - drop(groove, y));
        let parabola = sum(&|y| 0.5 * y * y * (ball.recip() - groove.recip()));
        let share = 1.0 - round / parabola;
        assert_relative_eq!(share, 0.39, epsilon = 0.01);
        assert!(share < SHARE_OF_END);
    }

    /// By hand: three equal values have a bar of half of what the figure changes by when its integral is cut; a place that stays is known to a cell and a half, one that moves by 4 µm to 6 µm.
    #[test]
    fn cuts_and_places_by_hand() {
        let of = |x: f64| {
            let mut figures = Figures::default();
            figures.note(Figure::FilmCentral, Reading::new(2e-7));
            figures.note(Figure::FilmMinimum, Reading::new(1e-7).at([x, 0.0]));
            let traction = Reading {
                cut: 0.004,
                ..Reading::new(0.05)
            };
            figures.note(Figure::TractionCoefficient, traction);
            figures
        };
        for (before, place) in [(3e-5, 1.5e-6), (3.4e-5, 6e-6)] {
            let figures = [of(3e-5), of(before), of(before)];
            let bars = bars(figures.each_ref().map(Some), 1e-6, [0.0; 2]);
            let traction = bars.get(Figure::TractionCoefficient).unwrap().value;
            assert_relative_eq!(traction, 0.002, max_relative = 1e-9);
            let found = bars.get(Figure::FilmMinimum).unwrap().place.unwrap();
            assert_relative_eq!(found, place, max_relative = 1e-9);
        }
    }
}
