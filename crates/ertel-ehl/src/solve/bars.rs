//! Error bars of all figures, from those of the films and from the meshes of a solve.
//!
//! Theory: Error bar.

use crate::solution::{Bar, Bars, ErrorClass, Estimate, Figure, LevelStats, Measured, Reading};
use crate::solve::tuning::bars::{
    ALONE, SAFETY, SAFETY_OF_POWER, SHARE_OF_BEYOND, SHARE_OF_CUT, SHARE_OF_CUT_COMPRESSION,
    SHARE_OF_FILM_BAR, SHARE_OF_LOCAL, SHARE_OF_LOCAL_TEMPERATURE, SHARE_OF_PRESSURE,
    SHARE_OF_PRESSURE_AT_OUTLET, SHARE_OF_PRESSURE_IN_FRICTION, SHARE_OF_PRESSURE_IN_MIDDLE,
    SHARE_OF_PRESSURE_MAXIMUM, SHARE_OF_SLOPE, SHARE_OF_TEMPERATURE, SHARE_OF_UNRESOLVED_IN_POWER,
};

/// The mesh of the solution, and the one that it is compared with.
#[derive(Clone, Copy, Debug)]
pub struct Compared<'a> {
    /// The last converged one.
    pub fine: &'a LevelStats,
    /// The last converged one before it on another mesh.
    pub coarse: Option<&'a LevelStats>,
}

/// Stages whose difference gives the errors of a solve; `None` without a converged one.
pub fn compared(levels: &[LevelStats]) -> Option<Compared<'_>> {
    // Diffusive starts on a refined mesh have no estimate and do not count.
    let estimated = levels.iter().any(|l| l.estimate.is_some());
    let last = (levels.iter())
        .rposition(|l| l.converged && !l.role.compares() && l.estimate.is_some() == estimated)?;
    let fine = &levels[last];
    let other_mesh = |l: &&LevelStats| {
        l.converged && !l.role.compares() && l.n_contact_elements != fine.n_contact_elements
    };
    let coarse = levels[..last].iter().rev().find(other_mesh);
    Some(Compared { fine, coarse })
}

/// Error bars of the figures of a solve: of both films their own, `film_bars`, relative; of each other figure
/// `SAFETY` times its difference from mesh to mesh, but not less than the effect of the errors of films and pressure. Places by the
/// distance of those of two meshes.
///
/// There is no bar at all where the films have none, and none of the others without another mesh or an estimate.
pub fn bars(levels: &[LevelStats], film_bars: Option<[f64; 2]>) -> Option<Bars> {
    let film_bars = film_bars?;
    let Compared { fine, coarse } = compared(levels)?;
    // Stages that only lead to others solve other equations.
    let coarse = coarse.filter(|level| !level.role.leads());
    let film = SHARE_OF_FILM_BAR * film_bars[0].max(film_bars[1]);
    let mut bars = Bars::default();
    for figure in Figure::ALL {
        let Some(here) = fine.figures.get(figure) else {
            continue;
        };
        let there = coarse.and_then(|level| level.figures.get(figure));
        let alone = if there.is_some() { 1.0 } else { ALONE };
        let least = alone * least_bar(figure, fine, film) + temperature_bar(figure, fine);
        let value = match figure {
            Figure::FilmCentral => film_bars[0] * here.size,
            Figure::FilmMinimum => film_bars[1] * here.size,
            _ => there.map_or(least, |there| {
                let safety = match figure {
                    Figure::HeatShear => SAFETY_OF_POWER,
                    _ => SAFETY,
                };
                (safety * (here.value - there.value).abs()).max(least)
            }),
        };
        let value = value.max(here.misfit) + here.cut;
        let place = here.place.zip(there.and_then(|there| there.place));
        let of_place = place.map(|([x, y], [x_there, y_there])| {
            let distance = (x - x_there).hypot(y - y_there);
            (SAFETY * distance).max(film * x.hypot(y))
        });
        let has_bar = there.is_some() || fine.estimate.is_some() || is_film(figure);
        if has_bar && value.is_finite() {
            bars.set(
                figure,
                Bar {
                    value,
                    place: of_place,
                },
            );
        }
    }
    Some(bars)
}

fn is_film(figure: Figure) -> bool {
    matches!(figure, Figure::FilmCentral | Figure::FilmMinimum)
}

/// Error of a figure from the errors of films (relative) and pressure on a mesh.
fn least_bar(figure: Figure, level: &LevelStats, film: f64) -> f64 {
    let value = |figure| level.figures.value(figure).map_or(0.0, f64::abs);
    let size_of = |figure| level.figures.get(figure).map_or(0.0, |f: Reading| f.size);
    let size = size_of(figure);
    let e = level.estimate.unwrap_or_default();
    let local = |size: f64, error: f64| (film * size).hypot(SHARE_OF_LOCAL * error);
    let integral = (film + SHARE_OF_PRESSURE * e.pressure) * size;
    let with_slopes = film + SHARE_OF_PRESSURE_IN_FRICTION * e.pressure;
    let beyond = e.beyond_edges;
    match figure.error_class() {
        ErrorClass::LargestPressure => local(size, e.largest),
        ErrorClass::CentralPressure => {
            local(size, e.central_pressure)
                + SHARE_OF_PRESSURE_IN_MIDDLE * e.pressure * value(figure)
        }
        ErrorClass::PressureRidge => local(size, e.ridge_pressure),
        ErrorClass::Spike => local(size, e.spike),
        ErrorClass::EdgePressureLeft => local(size, e.ends[0]),
        ErrorClass::EdgePressureRight => local(size, e.ends[1]),
        ErrorClass::ShearStress => {
            let largest = local(size_of(Figure::PressureMaximum), e.largest);
            let relative = largest / value(Figure::PressureMaximum);
            SHARE_OF_PRESSURE_MAXIMUM * relative * size + SHARE_OF_SLOPE * e.shear_stress
        }
        ErrorClass::FilmOnCentreline => SAFETY * film * size,
        ErrorClass::Outlet => (film + SHARE_OF_PRESSURE_AT_OUTLET * e.pressure) * size,
        ErrorClass::Meniscus => film * size,
        ErrorClass::WallTraction => with_slopes * size + SHARE_OF_BEYOND * beyond.traction,
        ErrorClass::FrictionPower => with_slopes * size + SHARE_OF_BEYOND * beyond.power,
        ErrorClass::HeatShear => {
            (with_slopes + SHARE_OF_UNRESOLVED_IN_POWER * e.unresolved) * size
                + SHARE_OF_BEYOND * beyond.power
        }
        ErrorClass::HeatCompression => integral + beyond.cut * (SHARE_OF_CUT_COMPRESSION * size),
        ErrorClass::HeatCarried => {
            let cut = beyond.cut * (SHARE_OF_CUT * size_of(Figure::HeatShear));
            integral + cut + open_heat(level)
        }
        ErrorClass::ShareOfZone => integral + e.share_of_point,
        ErrorClass::Film
        | ErrorClass::Integral
        | ErrorClass::FilmHottest
        | ErrorClass::FilmColdest
        | ErrorClass::Body1Hottest
        | ErrorClass::Body2Hottest
        | ErrorClass::MeanTemperature
        | ErrorClass::OfBodies => integral,
    }
}

/// Heat that is made and not carried off, or carried off and not made: W, or W/m. Each carrier may be wrong by all of it.
fn open_heat(level: &LevelStats) -> f64 {
    let value = |figure| level.figures.value(figure).unwrap_or(0.0);
    let made = value(Figure::HeatShear) + value(Figure::HeatCompression);
    let carried =
        value(Figure::HeatToBody1) + value(Figure::HeatToBody2) + value(Figure::HeatByFilm);
    (made - carried).abs()
}

/// Additional error from the elements of the temperatures, K; it needs no second mesh.
fn temperature_bar(figure: Figure, level: &LevelStats) -> f64 {
    let errors = level.estimate.unwrap_or_default().temperatures;
    let [film_hot, film_cold, body_1, body_2] = errors.local;
    match figure.error_class() {
        ErrorClass::FilmHottest => SHARE_OF_LOCAL_TEMPERATURE * film_hot,
        ErrorClass::FilmColdest => SHARE_OF_LOCAL_TEMPERATURE * film_cold,
        ErrorClass::Body1Hottest => SHARE_OF_LOCAL_TEMPERATURE * body_1,
        ErrorClass::Body2Hottest => SHARE_OF_LOCAL_TEMPERATURE * body_2,
        ErrorClass::MeanTemperature => SHARE_OF_TEMPERATURE * errors.rms,
        ErrorClass::Film
        | ErrorClass::FilmOnCentreline
        | ErrorClass::LargestPressure
        | ErrorClass::CentralPressure
        | ErrorClass::PressureRidge
        | ErrorClass::Spike
        | ErrorClass::EdgePressureLeft
        | ErrorClass::EdgePressureRight
        | ErrorClass::ShearStress
        | ErrorClass::Outlet
        | ErrorClass::Meniscus
        | ErrorClass::Integral
        | ErrorClass::WallTraction
        | ErrorClass::FrictionPower
        | ErrorClass::HeatShear
        | ErrorClass::HeatCompression
        | ErrorClass::HeatCarried
        | ErrorClass::ShareOfZone
        | ErrorClass::OfBodies => 0.0,
    }
}

/// 1 − with/without of a figure of two stages on one mesh: the effect of shear thinning or heat.
///
/// The mesh error of the first one is that of the solution; that of the second is much the same and mostly
/// cancels: the quotient is taken to be as uncertain as the first one alone.
pub fn reduction(
    figure: Figure,
    with: &LevelStats,
    without: &LevelStats,
    solution: &Measured,
) -> Option<Estimate> {
    let ratio = with.figures.value(figure)? / without.figures.value(figure)?;
    let relative = relative_error_on(with, figure, solution);
    // The error of the elements may be small by chance in the first, and not in the second.
    let estimated = with.estimate.unwrap_or_default().films;
    let least = match figure {
        Figure::FilmCentral => estimated[0],
        Figure::FilmMinimum => estimated[1],
        _ => 0.0,
    };
    let relative = relative.map(|relative| relative + least);
    Some(Estimate {
        value: 1.0 - ratio,
        error: relative.map(|relative| relative * ratio.abs()),
    })
}

/// Error of a figure on the mesh of a stage, relative to the solution: its difference from that, and the error bar
/// there.
pub fn relative_error_on(level: &LevelStats, figure: Figure, solution: &Measured) -> Option<f64> {
    let best = solution.find(figure)?;
    let error = (level.figures.value(figure)? - best.value).abs() + best.error?;
    Some(error / best.value.abs()).filter(|error| error.is_finite())
}

#[cfg(test)]
pub(super) mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::solution::Role;
    use crate::solution::{ErrorEstimate, Figures, TemperatureErrors};

    /// A converged stage on a mesh of `n` cells.
    pub fn level(n: usize, role: Role, figures: &[(Figure, Reading)]) -> LevelStats {
        let mut all = Figures::default();
        for (figure, reading) in figures {
            all.note(*figure, *reading);
        }
        LevelStats {
            converged: true,
            n_body_cells: n,
            n_contact_elements: n,
            n_pressure_dofs: n,
            n_displacement_dofs: n,
            n_contact_dofs: n,
            pressure_order: 2,
            role,
            newton_iterations: 1,
            krylov_iterations: 1,
            factorisations: 1,
            figures: all,
            estimate: None,
            seconds: Default::default(),
        }
    }

    const FILMS: Option<[f64; 2]> = Some([0.01, 0.02]);

    fn two_meshes() -> [LevelStats; 3] {
        let spike = Reading::new(8e8).at([1.0, 0.0]);
        let film = |h| (Figure::FilmCentral, Reading::new(h));
        let pressure = |p| (Figure::PressureMaximum, Reading::new(p));
        let traction = (Figure::TractionCoefficient, Reading::new(0.04));
        [
            level(
                10,
                Role::Estimate,
                &[film(1.1e-7), pressure(0.9e9), traction],
            ),
            // Of other equations: it says nothing about errors.
            level(20, Role::Comparison, &[pressure(2e9)]),
            level(
                40,
                Role::Final,
                &[
                    film(1e-7),
                    pressure(1e9),
                    traction,
                    (Figure::PressureSpike, spike),
                ],
            ),
        ]
    }

    /// By hand: twice the difference of the pressures, 0.1 GPa; 1 % of the film, whatever its difference; the traction
    /// that does not differ has the floor, 2 % of 0.04; a spike on one mesh only has none without an estimate.
    #[test]
    fn bars_of_two_meshes() {
        let bars = bars(&two_meshes(), FILMS).unwrap();
        let bar = |figure| bars.get(figure).map(|bar| bar.value);
        assert_relative_eq!(
            bar(Figure::PressureMaximum).unwrap(),
            2e8,
            max_relative = 1e-12
        );
        assert_relative_eq!(
            bar(Figure::FilmCentral).unwrap(),
            1e-9,
            max_relative = 1e-12
        );
        let traction = bar(Figure::TractionCoefficient).unwrap();
        assert_relative_eq!(traction, 8e-4, max_relative = 1e-12);
        assert_eq!(bar(Figure::PressureSpike), None);
        assert_eq!(bar(Figure::FrictionPower), None);
    }

    /// By hand: 100 W made, 60 + 38 + 1.5 W carried off: 0.5 W are missing, which each carrier may lack, in addition to 2 % of its heat. A share
    /// of the zone is known to a point of the rule.
    #[test]
    fn heat_that_is_missing_and_points_are_in_the_bars() {
        let figures = [
            (Figure::HeatShear, Reading::new(99.0)),
            (Figure::HeatCompression, Reading::new(1.0)),
            (Figure::HeatToBody1, Reading::new(60.0)),
            (Figure::HeatToBody2, Reading::new(38.0)),
            (Figure::HeatByFilm, Reading::new(1.5)),
            (Figure::BeyondFirstLimit, Reading::new(0.1)),
        ];
        let mut levels = [10, 40].map(|n| level(n, Role::Final, &figures));
        levels[1].estimate = Some(ErrorEstimate {
            share_of_point: 0.003,
            ..ErrorEstimate::default()
        });
        let bars = bars(&levels, FILMS).unwrap();
        let bar = |figure| bars.get(figure).unwrap().value;
        assert_relative_eq!(bar(Figure::HeatByFilm), 0.53, max_relative = 1e-12);
        assert_relative_eq!(bar(Figure::HeatToBody2), 1.26, max_relative = 1e-12);
        assert_relative_eq!(bar(Figure::BeyondFirstLimit), 0.005, max_relative = 1e-12);
    }

    /// The smooth maximum depends on the film only through its own size, 0.1 of the pressure here: 2 % of that, and a fiftieth of a pressure error of 1 % of the
    /// pressure.
    #[test]
    fn the_smooth_maximum_depends_less_on_the_film() {
        let central = Reading {
            size: 1e8,
            ..Reading::new(1e9)
        };
        let mut levels =
            [10, 40].map(|n| level(n, Role::Final, &[(Figure::PressureCentral, central)]));
        levels[1].estimate = Some(ErrorEstimate {
            pressure: 0.01,
            ..ErrorEstimate::default()
        });
        let bars = bars(&levels, FILMS).unwrap();
        let bar = bars.get(Figure::PressureCentral).unwrap().value;
        assert_relative_eq!(bar, 2e6 + 2e5, max_relative = 1e-12);
    }

    /// A spike on both meshes: twice the distance of its places, and its own size at the least (2 % of the rise of a
    /// temperature).
    #[test]
    fn places_and_temperatures_have_bars() {
        let hot = |value| Reading {
            size: value - 300.0,
            ..Reading::new(value)
        };
        let figures = |p: f64, x: f64, t: f64| {
            let spike = Reading::new(p).at([x, 0.0]);
            [
                (Figure::PressureSpike, spike),
                (Figure::FilmTemperatureMaximum, hot(t)),
            ]
        };
        let levels = [
            level(10, Role::Final, &figures(8e8, 0.8, 350.0)),
            level(40, Role::Final, &figures(8e8, 0.9, 350.0)),
        ];
        let bars = bars(&levels, FILMS).unwrap();
        let spike = bars.get(Figure::PressureSpike).unwrap();
        assert_relative_eq!(spike.place.unwrap(), 0.2, max_relative = 1e-12);
        assert_relative_eq!(spike.value, 0.02 * 8e8, max_relative = 1e-12);
        let temperature = bars.get(Figure::FilmTemperatureMaximum).unwrap();
        assert_relative_eq!(temperature.value, 0.02 * 50.0, max_relative = 1e-12);
    }

    /// By hand: 2 % of a rise by 50 K, and the 0.2 K that linear elements are off; a tenth of 0.5 K of a mean.
    #[test]
    fn temperature_bars_include_their_elements() {
        let thermal = |figure| {
            (
                figure,
                Reading {
                    size: 50.0,
                    ..Reading::new(350.0)
                },
            )
        };
        let figures = [Figure::FilmTemperatureMaximum, Figure::FilmTemperatureMean].map(thermal);
        let mut levels = [10, 40].map(|n| level(n, Role::Final, &figures));
        levels[1].estimate = Some(ErrorEstimate {
            temperatures: TemperatureErrors {
                local: [0.2, 0.0, 0.0, 0.0],
                rms: 0.5,
            },
            ..ErrorEstimate::default()
        });
        levels[0].estimate = levels[1].estimate;
        let bars = bars(&levels, FILMS).unwrap();
        let bar = |figure| bars.get(figure).unwrap().value;
        assert_relative_eq!(
            bar(Figure::FilmTemperatureMaximum),
            1.2,
            max_relative = 1e-12
        );
        assert_relative_eq!(bar(Figure::FilmTemperatureMean), 1.05, max_relative = 1e-12);
    }

    /// By hand: 2 % of 1 W, and 1.5 times the 0.1 W beyond the edges that are set by hand; the 0.5 W by which the balance of the power fails
    /// where that is more, and the 0.2 W of the outer half of the bodies on top. The tractions at the walls likewise, that at mid-film not.
    #[test]
    fn friction_bars_include_edges_balances_and_ends() {
        let power = |cut, misfit| Reading {
            cut,
            misfit,
            ..Reading::new(1.0)
        };
        let bar = |reading: Reading, figure| {
            let mut levels = [10, 40].map(|n| level(n, Role::Final, &[(figure, reading)]));
            levels[1].estimate = Some(ErrorEstimate {
                beyond_edges: crate::solution::BeyondEdges {
                    traction: 0.2,
                    power: 0.1,
                    cut: 0.0,
                },
                ..ErrorEstimate::default()
            });
            bars(&levels, FILMS).unwrap().get(figure).unwrap().value
        };
        for (cut, misfit, expected) in [(0.0, 0.0, 0.17), (0.0, 0.5, 0.5), (0.2, 0.5, 0.7)] {
            let found = bar(power(cut, misfit), Figure::FrictionPower);
            assert_relative_eq!(found, expected, max_relative = 1e-12);
        }
        let wall = bar(power(0.0, 0.0), Figure::TractionCoefficientBody1);
        assert_relative_eq!(wall, 0.32, max_relative = 1e-12);
        let middle = bar(power(0.0, 0.0), Figure::TractionCoefficient);
        assert_relative_eq!(middle, 0.02, max_relative = 1e-12);
    }

    /// Without another mesh only the films have bars, and none does where they have none or where the other mesh has
    /// only led to this one.
    #[test]
    fn bars_need_another_mesh() {
        let [mut coarse, comparison, fine] = two_meshes();
        let alone = bars(std::slice::from_ref(&fine), FILMS).unwrap();
        assert!(alone.get(Figure::FilmCentral).is_some());
        assert_eq!(alone.get(Figure::PressureMaximum), None);
        let levels = [coarse.clone(), comparison.clone(), fine.clone()];
        assert_eq!(bars(&levels, None), None);
        coarse.role = Role::Start;
        let led = bars(&[coarse, comparison, fine], FILMS).unwrap();
        assert_eq!(led.get(Figure::PressureMaximum), None);
    }

    /// Both films 10 % too thick on the coarse mesh, one of them half the other: 50 % reduction, uncertain by half of
    /// 10 % and 1 %.
    #[test]
    fn reductions_are_as_uncertain_as_their_mesh() {
        let [with, mut without, fine] = two_meshes();
        without
            .figures
            .note(Figure::FilmCentral, Reading::new(2.2e-7));
        let mut solution = Measured {
            figures: fine.figures,
            bars: bars(&[with.clone(), fine], FILMS).unwrap(),
            ..Measured::default()
        };
        let found = reduction(Figure::FilmCentral, &with, &without, &solution).unwrap();
        assert_relative_eq!(found.value, 0.5, max_relative = 1e-12);
        assert_relative_eq!(found.error.unwrap(), 0.5 * 0.11, max_relative = 1e-12);
        solution.bars = Bars::default();
        let found = reduction(Figure::FilmCentral, &with, &without, &solution).unwrap();
        assert_eq!(found.error, None);
    }
}
