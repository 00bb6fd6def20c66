//! The figures of a state, read off its mesh.

use super::adapt::{error_bars, grading_errors};
use super::bars::bars;
use super::discretisation::Discretisation;
use super::evaluate::{central_film, largest_pressure, largest_pressure_where, minimum_film};
use super::evaluated::Evaluated;
use super::heat::balance::heat_balance;
use super::heat::space::HeatSpace;
use super::peaks::peaks;
use super::profile::PER_EDGE;
use super::sequence::{Problem, StageSolution};
use super::state::State;
use crate::contact::Symmetry;
use crate::engine::figures::{note_film, note_friction, note_roller, share_of_film, sizes};
use crate::engine::heat::{Extremes, note_heat};
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
    let largest = |at: &dyn Fn(f64) -> bool| Some(largest_pressure_where(d, state, |[_, y]| at(y)));
    note_roller(&mut figures, problem, largest, || moments(d, film.points()));
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
    if let (Some(space), Some(heat)) = (d.heat.as_deref(), &problem.heat) {
        let nodes = &space.column.film;
        let (extremes, sums) = (
            extremes(space, state),
            heat_balance(d, state, fluid, heat, scales),
        );
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

/// Extreme temperatures over the nodes of the contact area.
fn extremes(space: &HeatSpace, state: &State) -> Extremes {
    let (column, n) = (&space.column, space.column.n());
    let mut extremes = Extremes::default();
    for (point, values) in (space.surface.points.iter()).zip(state.temperature.chunks_exact(n)) {
        // No minus zero.
        let place = [point[0], point[1] + 0.0];
        extremes.include(&column.film, &column.film_of(values), place);
    }
    extremes
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
