//! Figures of a film on patches.

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
use crate::solution::{Figure, Figures, Reading};

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

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

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
