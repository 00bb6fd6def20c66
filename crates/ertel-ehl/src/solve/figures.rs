//! The figures of a state, read off its mesh.

use super::adapt::{error_bars, grading_errors};
use super::bars::bars;
use super::discretisation::Discretisation;
use super::evaluate::{central_film, largest_pressure, largest_pressure_where, minimum_film};
use super::heat::balance::heat_balance;
use super::heat::figures::Extremes;
use super::peaks::peaks;
use super::points::Evaluated;
use super::profile::PER_EDGE;
use super::sequence::{Problem, StageSolution};
use super::system::State;
use crate::contact::Symmetry;
use crate::engine::figures::{note_film, note_friction, share_of_film, sizes};
use crate::engine::heat::zone_means;
use crate::engine::{Film, PointTable, Profile};
use crate::film::FilmFluid;
use crate::solution::{Figure, Figures, LevelStats, Measured, Reading};

/// Which figures are requested.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scope {
    /// Central and minimum film and the largest pressure.
    Films,
    /// All of them; the traction costs about as much as an assembly.
    All,
}

/// Figures of a state, `fluid` being the one that it is the solution for.
pub fn figures(
    problem: &Problem,
    fluid: &FilmFluid,
    d: &Discretisation,
    state: &State,
    extent: Scope,
) -> Figures {
    let scales = &problem.scales;
    let at = |value: f64, place: [f64; 2]| Reading::new(value).at(place.map(|x| x * scales.length));
    let mut figures = Figures::default();
    let (h_m, place) = minimum_film(d, state);
    let (p_max, p_place) = largest_pressure(d, state);
    let h_c = scales.film * central_film(d, state);
    figures.note(Figure::FilmCentral, Reading::new(h_c));
    figures.note(Figure::FilmMinimum, at(scales.film * h_m, place));
    let largest = at(scales.pressure * p_max, p_place);
    figures.note(Figure::PressureMaximum, largest);
    if extent == Scope::Films {
        return figures;
    }
    let film = Evaluated::new(&problem.shape, &problem.entrainment, d, state);
    note_roller(&mut figures, problem, (d, state), film.points());
    let roller = problem.shape.zone.roller.as_ref();
    let quarter = roller.map(|roller| 0.5 * roller.half_length());
    let inner = |[_, y]: [f64; 2]| quarter.is_none_or(|quarter| y.abs() < quarter);
    if let Some(peaks) = peaks(d, state, inner) {
        let (p, place) = peaks.central;
        let central = Reading {
            size: scales.pressure * share_of_film(p, h_c / scales.film),
            ..at(scales.pressure * p, place)
        };
        figures.note(Figure::PressureCentral, central);
        if p >= p_max {
            figures.note(Figure::PressureMaximum, central);
        }
        if let Some((p, place)) = peaks.other.filter(|_| !problem.shape.is_line()) {
            figures.note(Figure::PressureRidge, at(scales.pressure * p, place));
        }
    }
    let profile = Profile::new(d, state, PER_EDGE);
    let layer = problem.shape.inlet.layer();
    let meniscus = layer.and_then(|layer| profile.meniscus(layer.thickness));
    let (outlet, shift) = rupture(&profile);
    note_film(&mut figures, problem, &film, &profile, outlet, meniscus);
    if let Some(reading) = figures.get(Figure::OutletPosition) {
        let misfit = scales.length * shift;
        figures.note(Figure::OutletPosition, Reading { misfit, ..reading });
    }
    note_friction(&mut figures, problem, fluid, &film, d.heat.is_some());
    note_heat(&mut figures, problem, fluid, (d, state), film.points());
    figures
}

/// Half-widths behind the film in which the pressure falls to what the penalty leaves there, and the pressures before it, over that, between which their roots point to
/// the rupture.
const BEHIND: f64 = 0.1;
const TOWARDS: [f64; 2] = [20.0, 10.0];

/// Where the film breaks on the centreline, and how far behind the place where the pressure is zero. The penalty lets it fall to −p₀, where it ends as it would at
/// zero, with the square of the distance:
///
/// ```text
///   √(P + p₀)  falls to zero along a straight line
/// ```
fn rupture(profile: &Profile) -> (f64, f64) {
    let zero = profile.outlet();
    let p = |i: usize| profile.fields[i].pressure;
    let nodes = || 0..profile.x.len();
    let pull = nodes()
        .filter(|i| (zero..zero + BEHIND).contains(&profile.x[*i]))
        .fold(0.0_f64, |most, i| most.max(-p(i)));
    let before = |share: f64| {
        let mut upstream = nodes().rev().filter(|i| profile.x[*i] < zero);
        upstream.find(|i| p(*i) > share * pull)
    };
    let [Some(a), Some(b)] = TOWARDS.map(before) else {
        return (zero, 0.0);
    };
    let [far, near] = [a, b].map(|i| (p(i) + pull).sqrt());
    if pull == 0.0 || far <= near {
        return (zero, 0.0);
    }
    let beyond = near * (profile.x[b] - profile.x[a]) / (far - near);
    let place = (profile.x[b] + beyond).clamp(zero, zero + BEHIND);
    (place, place - zero)
}

/// Pressures over the outer quarters of a roller, and the moment of the pressure about its middle.
pub fn note_roller(
    figures: &mut Figures,
    problem: &Problem,
    (d, state): (&Discretisation, &State),
    points: &PointTable,
) {
    let Some(roller) = &problem.shape.zone.roller else {
        return;
    };
    let scales = &problem.scales;
    let quarter = 0.5 * roller.half_length();
    let whole = problem.shape.symmetry == Symmetry::Full;
    let sides: [(Figure, f64); 2] = [
        (Figure::EdgePressureLeft, -1.0),
        (Figure::EdgePressureRight, 1.0),
    ];
    // Where one half is solved, it is the left one.
    for (figure, sign) in sides.into_iter().take(if whole { 2 } else { 1 }) {
        let (p, place) = largest_pressure_where(d, state, |[_, y]| sign * y >= quarter);
        let place = place.map(|x| x * scales.length);
        figures.note(figure, Reading::new(scales.pressure * p).at(place));
    }
    if !whole {
        return;
    }
    let [force, moment, arms] = moments(d, points);
    let unit = scales.pressure * scales.length.powi(2);
    for (figure, scale) in [
        (Figure::RollerMoment, unit * scales.length),
        (Figure::LoadPosition, scales.length / force),
    ] {
        // A resultant in the middle is as uncertain as one elsewhere.
        let reading = Reading {
            size: scale * arms,
            ..Reading::new(scale * moment)
        };
        figures.note(figure, reading);
    }
}

/// ∫P, ∫P y and ∫P|y| over the part that is solved.
fn moments(d: &Discretisation, points: &PointTable) -> [f64; 3] {
    let mut sums = [0.0; 3];
    for (c, points) in points.groups().iter().enumerate() {
        for (point, xi) in points.iter().zip(&d.rule.points) {
            // By the corners of the element: where moments cancel, their last digits are those of the arms.
            let [_, y] = d.contact.point(c, *xi);
            let share = point.area * point.fields.pressure;
            for (sum, arm) in sums.iter_mut().zip([1.0, y, y.abs()]) {
                *sum += share * arm;
            }
        }
    }
    sums
}

fn note_heat(
    figures: &mut Figures,
    problem: &Problem,
    fluid: &FilmFluid,
    (d, state): (&Discretisation, &State),
    points: &PointTable,
) {
    let (Some(space), Some(heat)) = (d.heat.as_deref(), &problem.heat) else {
        return;
    };
    let scales = &problem.scales;
    let mut temperature = |figure, value: f64, place: [f64; 2]| {
        let reading = Reading {
            place: Some(place.map(|x| x * scales.length)),
            ..Reading::of_rise(value, value - heat.inlet_temperature)
        };
        figures.note(figure, reading);
    };
    let extremes = Extremes::new(space, state);
    let (hottest, _) = extremes.film_maximum;
    for (figure, (value, place)) in [
        (Figure::FilmTemperatureMaximum, extremes.film_maximum),
        (Figure::FilmTemperatureLowest, extremes.film_lowest),
        (Figure::TemperatureBody1Maximum, extremes.walls[0]),
        (Figure::TemperatureBody2Maximum, extremes.walls[1]),
    ] {
        temperature(figure, value, place);
    }
    // The error of the cooling behind the contact is that of the heating in it.
    if let Some(lowest) = figures.get(Figure::FilmTemperatureLowest) {
        let size = lowest.size.max((hottest - heat.inlet_temperature).abs());
        figures.note(Figure::FilmTemperatureLowest, Reading { size, ..lowest });
    }
    let mut temperature = |figure, value: f64| {
        let size = (value - heat.inlet_temperature).abs();
        let reading = Reading {
            size,
            ..Reading::new(value)
        };
        figures.note(figure, reading);
    };
    let means = [
        Figure::FilmTemperatureMean,
        Figure::TemperatureBody1Mean,
        Figure::TemperatureBody2Mean,
    ];
    for (figure, value) in means
        .into_iter()
        .zip(zone_means(points, &space.column.film))
    {
        temperature(figure, value);
    }
    let balance = heat_balance(d, state, fluid, heat, scales);
    // The work of the surfaces becomes heat, by shear or by compression of the lubricant.
    if let Some(power) = figures.get(Figure::FrictionPower) {
        let heats = power.value - power.misfit;
        let misfit = (heats - balance.shear - balance.compression).abs();
        figures.note(Figure::FrictionPower, Reading { misfit, ..power });
    }
    for (figure, value) in [
        (Figure::HeatShear, balance.shear),
        (Figure::HeatCompression, balance.compression),
        (Figure::HeatToBody1, balance.to_body_1),
        (Figure::HeatToBody2, balance.to_body_2),
        (Figure::HeatByFilm, balance.by_film),
    ] {
        figures.note(figure, Reading::new(value));
    }
}

/// Figures of the solution of a problem, with the error bars from its stages.
pub fn measure(problem: &Problem, solution: &StageSolution, levels: &[LevelStats]) -> Measured {
    let (d, state) = (&solution.discretisation, &solution.state);
    let grading = grading_errors(
        &problem.shape,
        problem.elasticity.model,
        &solution.stage.sizes,
    );
    let films = error_bars(levels, grading).map(|b| b.bars);
    let measured = Measured {
        figures: figures(problem, &problem.fluid, d, state, Scope::All),
        bars: bars(levels, films).unwrap_or_default(),
        half_width: problem.scales.length,
    };
    let sizes = sizes(problem);
    let measured = measured.without_rounding(&sizes).within_limits(&sizes);
    match problem.shape.symmetry {
        Symmetry::Half => measured.with_mirrored_end(),
        Symmetry::Full => measured,
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::engine::PointFields;

    /// A pressure that ends with 3 (1.02 − x)² at −0.001 is zero at 1.02 − √(0.001/3): the film breaks at 1.02. One that ends at zero breaks there.
    #[test]
    fn films_break_where_their_pressure_ends() {
        let profile = |pull: f64| {
            let x: Vec<f64> = (0..=1500).map(|i| f64::from(i) * 1e-3).collect();
            let fields = x.iter().map(|x| PointFields {
                pressure: 3.0 * (1.02 - x).max(0.0).powi(2) - pull,
                ..PointFields::default()
            });
            let fields = fields.collect();
            Profile { x, fields }
        };
        let (place, shift) = rupture(&profile(1e-3));
        assert_relative_eq!(place, 1.02, epsilon = 1e-6);
        assert_relative_eq!(shift, (1e-3_f64 / 3.0).sqrt(), epsilon = 1e-3);
        let (place, shift) = rupture(&profile(0.0));
        assert_relative_eq!(place, 1.02, epsilon = 1e-3);
        assert_eq!(shift, 0.0);
    }
}
