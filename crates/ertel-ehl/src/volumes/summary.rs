//! Summary and warnings of a solve by finite volumes.

use super::engine::Volumes;

use super::fields::profile;
use super::film::PatchedFilm;
use super::plan::Plan;
use crate::engine::Problem;
use crate::post::limits::thin_film_warning;
use crate::post::summary::{EdgeFilms, edge_warnings, summary_of};
use crate::solution::{Figure, Measured, Summary};
use crate::warning::{Warning, WarningKind};

/// The figures of a solve.
pub fn summarise(problem: &Problem<Plan>, volumes: &Volumes, measured: &Measured) -> Summary {
    let finest = volumes.levels.last();
    Summary {
        // Pressures are zero or positive.
        pressure_minimum: 0.0,
        film_balance_error: volumes.balance_error,
        load_balance_error: finest.map_or(f64::NAN, |level| {
            let missing = level.system.load - level.system.integral(&level.state.pressure);
            (missing / problem.load).abs()
        }),
        rigid_separation: finest.map_or(f64::NAN, |level| level.state.separation)
            * problem.scales.film,
        ..summary_of(measured)
    }
}

/// Warnings about a solve: films that miss the target error, or are too thin for a continuum; a contact area that is too small.
pub fn warnings(
    problem: &Problem<Plan>,
    volumes: &Volumes,
    film: &PatchedFilm,
    measured: &Measured,
) -> Vec<Warning> {
    let mut warnings = Vec::new();
    let minimum = measured.estimate(Figure::FilmMinimum);
    warnings.extend(thin_film_warning(
        "the minimum film thickness",
        minimum.value,
    ));
    let (target, most) = (problem.plan.target_error, problem.plan.max_unknowns);
    for (kind, name, figure) in [
        (
            WarningKind::CentralFilmError,
            "central",
            Figure::FilmCentral,
        ),
        (
            WarningKind::MinimumFilmError,
            "minimum",
            Figure::FilmMinimum,
        ),
    ] {
        let film = measured.estimate(figure);
        let relative = film.error.map_or(f64::INFINITY, |error| error / film.value);
        let misfit = measured
            .figures
            .get(figure)
            .map_or(0.0, |reading| reading.misfit);
        let end = match volumes.stopped {
            _ if misfit > 0.0 && misfit >= film.value => {
                "it lies on the edge of the contact area, or outside the finer grids; move the edge outward ([mesh] outlet, side)".to_owned()
            }
            _ if volumes.edge_effects.into_iter().fold(0.0, f64::max) > 0.5 * relative => {
                "the edges of the contact area are near; move them outward ([mesh] inlet, side)".to_owned()
            }
            true => "Newton's method does not converge on the next grid".to_owned(),
            false => format!(
                "the next grid would have more than {most} pressure unknowns ([mesh] max_unknowns)"
            ),
        };
        let text = match relative {
            _ if film.value <= 0.0 => format!(
                "the {name} film thickness is below zero on the finest grid, which does not resolve it: {end}"
            ),
            _ if relative > target => format!(
                "the {name} film thickness is uncertain by {:.2} %, beyond [mesh] target_error: {end}",
                100.0 * relative
            ),
            _ => continue,
        };
        warnings.push(Warning::beyond(kind, relative, text));
    }
    let profile = profile(film);
    let films = EdgeFilms {
        outlet: profile.outlet(),
        inlet: profile.fields.first().map_or(f64::INFINITY, |f| f.film),
        centre: film.centre(),
    };
    warnings.extend(edge_warnings(&problem.extents, &problem.shape, films));
    warnings
}
