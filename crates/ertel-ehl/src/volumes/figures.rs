//! Figures of a film on patches, and their error bars from grid to grid.
//!
//! ```text
//!   bar = S max(c |d_1|, f |d_2|),   d_1 = f_n − f_(n−1),  d_2 = f_(n−1) − f_(n−2),  r = |d_1|/|d_2|
//!   c = r/(1 − r) within [⅓, 1],  f = ⅛        c = 1,  f = ¼ where d_1 and d_2 have opposite signs          films
//!   c = r/(1 − r) within [⅓, 1 + √2]           c = 1,  f = ½; f = ½ where r < ⅛, too                            other figures
//! ```
//! c is the remainder of a geometric series of differences: ⅓ for second order in the cell size, 1 for first order, 1 + √2 for order one
//! half; at least 1 where grids do not resolve the thinnest film. A difference that vanishes by chance is bounded from below by the previous one. Where a difference
//! changes sign, or is about to (falls faster than the cube of the cell size), f is the remainder if the previous one falls at first order. Films, for which the grids are refined, converge at first order or better.

use super::asperities::note_asperities;
use super::extremes::{extreme, lowest, sharpness};
use super::fields::profile;
use super::film::PatchedFilm;
use super::heat::figures::{extremes, sums};
use super::level::Level;
use crate::engine::figures::{note_film, note_friction, note_roller, share_of_film};
use crate::engine::heat::note_heat;
use crate::engine::hills::hills;
use crate::engine::{Film, PointFields, PointTable, Problem, Profile};
use crate::solution::{Bar, Bars, Figure, Figures, Reading};

/// H at the centre.
pub fn central(levels: &[Level]) -> f64 {
    levels.last().map_or(f64::NAN, |level| {
        let grid = &level.system.grid;
        let [i, j] = grid.centre();
        level.films[grid.index(i, j)]
    })
}

/// Figures of the first grids of a solve, SI.
pub fn figures<Plan>(problem: &Problem<Plan>, levels: &[Level]) -> Figures {
    let scales = &problem.scales;
    let mut figures = Figures::default();
    let Some(finest) = levels.last() else {
        return figures;
    };
    let h_c = central(levels);
    note_films(&mut figures, problem, levels);
    note_pressures(&mut figures, problem, finest, h_c);
    let film = PatchedFilm::new(&problem.shape, levels);
    let profile = profile(&film);
    let layer = problem.shape.inlet.layer();
    let meniscus = layer.and_then(|layer| profile.meniscus_of_contents(layer.thickness));
    let (outlet, distance) = outlet(&profile);
    note_film(&mut figures, problem, &film, &profile, outlet, meniscus);
    // Between two nodes: accurate to half of their distance, as the meniscus is.
    note_misfit(
        &mut figures,
        Figure::OutletPosition,
        0.5 * distance * scales.length,
    );
    if let Some(rise) = rise_of_spike(&profile) {
        note_misfit(&mut figures, Figure::PressureSpike, rise * scales.pressure);
    }
    let largest = |accepts: &dyn Fn(f64) -> bool| largest_where(finest, accepts);
    note_roller(&mut figures, problem, largest, || moments(film.points()));
    let heats = finest.warm.is_some();
    note_friction(&mut figures, problem, &problem.fluid, &film, heats);
    if let Some(rough) = &problem.rough {
        note_asperities(&mut figures, problem, rough, &film);
    }
    let cell = finest.system.grid.spacing[0];
    for figure in [Figure::BeyondFirstLimit, Figure::BeyondSecondLimit] {
        if let Some(share) = figures.value(figure) {
            note_misfit(&mut figures, figure, cell * boundary_of_share(share));
        }
    }
    if let (true, Some(nodes)) = (heats, problem.fluid.nodes()) {
        let (extremes, sums) = (extremes(levels, nodes), sums(problem, levels));
        note_heat(
            &mut figures,
            problem,
            film.points(),
            nodes,
            &extremes,
            &sums,
        );
    }
    figures
}

/// Mean gap of rough surfaces at a distance H of their mean planes; H of smooth ones.
pub fn mean_gap<Plan>(problem: &Problem<Plan>, film: f64) -> f64 {
    (problem.rough.as_ref()).map_or(film, |rough| rough.mean_gap(film)[0])
}

/// Central and minimum film; between rough surfaces as the distance of the mean planes, whose errors are relative to the mean gap, and as that.
pub fn note_films<Plan>(figures: &mut Figures, problem: &Problem<Plan>, levels: &[Level]) {
    let scales = &problem.scales;
    let mut note = |[film, gap]: [Figure; 2], h: f64, misfit: f64, place: Option<[f64; 2]>| {
        let mean = mean_gap(problem, h);
        let reading = |value: f64| Reading {
            misfit: scales.film * misfit,
            size: scales.film * mean.abs(),
            place,
            ..Reading::new(scales.film * value)
        };
        figures.note(film, reading(h));
        if problem.rough.is_some() {
            figures.note(gap, reading(mean));
        }
    };
    let centre = [Figure::FilmCentral, Figure::MeanGapCentral];
    note(centre, central(levels), 0.0, None);
    if let Some(lowest) = lowest(levels) {
        let place = lowest.place.map(|x| x * scales.length);
        let minimum = [Figure::FilmMinimum, Figure::MeanGapMinimum];
        note(minimum, lowest.film, lowest.misfit, Some(place));
    }
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

/// Largest pressure at the nodes whose y is accepted, with its place.
fn largest_where(level: &Level, accepts: &dyn Fn(f64) -> bool) -> Option<(f64, [f64; 2])> {
    let (grid, pressure) = (&level.system.grid, &level.state.pressure);
    let [i, j] = (grid.nodes())
        .filter(|[i, j]| accepts(grid.on_axes(*i, *j)[1]))
        .max_by(|a, b| {
            let [a, b] = [a, b].map(|[i, j]| pressure[grid.index(*i, *j)]);
            a.total_cmp(&b)
        })?;
    Some(extreme(grid, pressure, i, j))
}

/// ∫P, ∫P y and ∫P|y| over the part that is solved.
fn moments(points: &PointTable) -> [f64; 3] {
    points.iter().fold([0.0; 3], |sums, point| {
        let y = point.fields.place[1];
        let share = point.area * point.fields.total_pressure();
        [
            sums[0] + share,
            sums[1] + share * y,
            sums[2] + share * y.abs(),
        ]
    })
}

/// Sampling error of an area fraction of the Hertz zone, in cells: half a cell along its boundary. The length of the boundary is that of a strip at a share of one half;
/// it vanishes at shares of zero and one like that of a circle.
fn boundary_of_share(share: f64) -> f64 {
    2.0 * (share * (1.0 - share)).max(0.0).sqrt()
}

/// Sets the grid error of a figure, if there is one.
fn note_misfit(figures: &mut Figures, figure: Figure, misfit: f64) {
    if let Some(reading) = figures.get(figure) {
        figures.note(figure, Reading { misfit, ..reading });
    }
}

/// Mean rise of the highest node of a spike above its neighbours: a peak between nodes may exceed it by as much.
fn rise_of_spike(profile: &Profile) -> Option<f64> {
    let (top, x) = profile.spike()?;
    let i = profile.x.iter().position(|other| *other == x)?;
    let neighbour = |i: usize| profile.fields.get(i).map(PointFields::total_pressure);
    Some(top - 0.5 * (neighbour(i.checked_sub(1)?)? + neighbour(i + 1)?))
}

/// Outlet boundary of the film on the centreline, and the distance of the nodes there: pressures end with the square of the distance, and their roots
/// at the last two nodes are extrapolated to zero.
fn outlet(profile: &Profile) -> (f64, f64) {
    let node = profile.outlet();
    let Some(i) = profile
        .x
        .iter()
        .position(|x| *x >= node)
        .filter(|i| *i >= 2)
    else {
        return (node, 0.0);
    };
    let [before, last] = [i - 2, i - 1].map(|i| profile.fields[i].pressure.max(0.0).sqrt());
    let (x, step) = (profile.x[i - 1], profile.x[i] - profile.x[i - 1]);
    match before > last {
        true => (x + (step * last / (before - last)).min(step), step),
        false => (node, step),
    }
}

/// The largest pressure, that of the central hill, and that of the ridge.
fn note_pressures<Plan>(figures: &mut Figures, problem: &Problem<Plan>, level: &Level, h_c: f64) {
    let scales = &problem.scales;
    let (grid, pressure) = (&level.system.grid, &level.state.pressure);
    let [nx, ny] = grid.n;
    let neighbours: Vec<Vec<u32>> = (grid.nodes())
        .map(|[i, j]| {
            let rows = j.saturating_sub(1)..(j + 2).min(ny);
            rows.flat_map(|y| (i.saturating_sub(1)..(i + 2).min(nx)).map(move |x| [x, y]))
                .filter(|other| *other != [i, j])
                .map(|[x, y]| grid.index(x, y) as u32)
                .collect()
        })
        .collect();
    let [i, j] = grid.centre();
    let found = hills(pressure, &neighbours, grid.index(i, j));
    let top = |k: usize| extreme(grid, pressure, k % nx, k / nx);
    let at = |(p, place): (f64, [f64; 2])| {
        Reading::new(scales.pressure * p).at(place.map(|x| x * scales.length))
    };
    let (p, place) = top(found.central);
    let central = Reading {
        size: scales.pressure * share_of_film(p, h_c),
        misfit: scales.pressure * sharpness(grid, pressure, found.central),
        ..at((p, place))
    };
    figures.note(Figure::PressureCentral, central);
    // A ridge is as narrow as the cells: no parabola.
    let ridge = (found.others.into_iter())
        .map(|k| (pressure[k], grid.place(k % nx, k / nx)))
        .max_by(|a, b| a.0.total_cmp(&b.0));
    if let Some(ridge) = ridge.filter(|_| !problem.shape.is_line()) {
        figures.note(Figure::PressureRidge, at(ridge));
    }
    let largest = match ridge {
        Some(ridge) if ridge.0 > p => at(ridge),
        _ => central,
    };
    figures.note(Figure::PressureMaximum, largest);
}

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
        return Some(SAFETY * last.abs());
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

    /// By hand: areas of 0.5 and 0.25 at y = 0.4 and −0.6 under pressures of 2 and 4: 1 + 1, 0.4 − 0.6, 0.4 + 0.6.
    #[test]
    fn moments_by_hand() {
        let point = |area: f64, y: f64, pressure: f64| crate::engine::Point {
            area,
            within: [1.0; 2],
            in_zone: true,
            fields: crate::engine::PointFields {
                place: [0.3, y],
                pressure,
                ..Default::default()
            },
        };
        let table = PointTable::new(vec![
            vec![point(0.5, 0.4, 2.0)],
            vec![point(0.25, -0.6, 4.0)],
        ]);
        for (found, hand) in moments(&table).into_iter().zip([2.0, -0.2, 1.0]) {
            assert_relative_eq!(found, hand, max_relative = 1e-12);
        }
    }

    /// By hand: a straight boundary through the middle of a zone leaves half a cell on a strip of two, and none where no part or all of it is beyond.
    #[test]
    fn shares_are_known_to_their_boundary() {
        assert_relative_eq!(boundary_of_share(0.5), 1.0, max_relative = 1e-14);
        assert_relative_eq!(boundary_of_share(0.01), 0.199, max_relative = 1e-3);
        assert_eq!([0.0, 1.0].map(boundary_of_share), [0.0; 2]);
    }

    /// Nodes of 0.1 with a peak of 1.2 between 1.0 and 0.6: it stands 0.4 above their mean. The pressure's root falls by 0.2 to 0.4 at 1.5 and is zero two steps
    /// on, but the next node has none.
    #[test]
    fn spike_and_outlet_between_nodes() {
        let pressures = [0.0, 0.8, 1.0, 0.9, 0.9, 1.0, 1.2, 0.6, 0.36, 0.16, 0.0];
        let x: Vec<f64> = (0..11).map(|i| 0.1 * f64::from(i) - 0.2).collect();
        let fields = pressures
            .map(|pressure| crate::engine::PointFields {
                pressure,
                ..Default::default()
            })
            .to_vec();
        let profile = Profile { x, fields };
        assert_relative_eq!(rise_of_spike(&profile).unwrap(), 0.4, max_relative = 1e-9);
        let (place, distance) = outlet(&profile);
        assert_relative_eq!(place, 0.8, max_relative = 1e-9);
        assert_relative_eq!(distance, 0.1, max_relative = 1e-9);
    }
}
