//! The figures of a solved stage, and warnings about them.

use super::balance::film_balance_error;
use crate::contact::Scales;
use crate::engine::Profile;
use crate::post::limits::thin_film_warning;
use crate::post::summary::{EdgeFilms, edge_warnings, summary_of};
use crate::solution::{Estimate, Figure, FilmReduction, LevelStats, Measured, Role, Summary};
use crate::solve::evaluate::central_film;
use crate::solve::newton_level::FilmModel;
use crate::solve::sequence::{MeshEnd, StageSolution};
use crate::warning::{Warning, WarningKind};

/// The figures of the finest stage.
pub fn summarise(
    solution: &StageSolution,
    measured: &Measured,
    model: &FilmModel,
    scales: &Scales,
) -> Summary {
    let (d, state) = (&solution.discretisation, &solution.state);
    let p_min = state.pressure.iter().fold(0.0_f64, |m, p| m.min(*p));
    Summary {
        pressure_minimum: p_min * scales.pressure,
        film_balance_error: film_balance_error(solution, model),
        load_balance_error: (d.integral(&state.pressure) / scales.load - 1.0).abs(),
        rigid_separation: state.rigid_separation * scales.film,
        ..summary_of(measured)
    }
}

/// Films with and without shear thinning, where both were found on the same mesh.
pub fn film_reduction(levels: &[LevelStats], measured: &Measured) -> Option<FilmReduction> {
    let [thinned, newtonian] = comparison_pair(levels, Role::Comparison)?;
    let of = |figure| reduction(figure, thinned, newtonian, measured);
    Some(FilmReduction {
        central: of(Figure::FilmCentral)?,
        minimum: of(Figure::FilmMinimum)?,
    })
}

/// The stage of the full problem and, on the same mesh, the last comparison stage with `role`.
pub(super) fn comparison_pair(levels: &[LevelStats], role: Role) -> Option<[&LevelStats; 2]> {
    let at = levels.iter().rposition(|l| l.role == role && l.converged)?;
    let simpler = &levels[at];
    let full = levels[at + 1..]
        .iter()
        .find(|l| l.converged && l.role != Role::Start && l.has_mesh_of(simpler))?;
    Some([full, simpler])
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

/// Why a mesh is not halved further, in words.
fn mesh_ended(end: Option<MeshEnd>) -> String {
    match end {
        None | Some(MeshEnd::NotConverged) => {
            "Newton's method does not converge on a finer mesh".to_owned()
        }
        Some(MeshEnd::Unknowns(most)) => format!(
            "a finer mesh would have more than {most} pressure unknowns ([mesh] max_unknowns)"
        ),
        Some(MeshEnd::Reached) => "bars of another kind are wide".to_owned(),
    }
}

/// Warnings about a solution: film too thin for a continuum, error bars too wide, contact area
/// too small.
pub fn warnings(
    summary: &Summary,
    solution: &StageSolution,
    target_error: Option<f64>,
) -> Vec<Warning> {
    let mut warnings = Vec::new();
    let minimum = summary.film_minimum;
    warnings.extend(thin_film_warning(
        "the minimum film thickness",
        minimum.value,
    ));
    if minimum.error.is_none() {
        warnings.push(Warning::new(
            WarningKind::NoErrorBar,
            "no error bar: no coarser mesh converged (or solver.error_estimate is off)",
        ));
    }
    warnings.extend(film_errors(summary, solution, target_error));
    let orders = [
        solution.discretisation.pressure.element.order(),
        solution.discretisation.contact.deflection.element.order(),
    ];
    if orders.contains(&1) {
        // Measured on a roller: 3 and 4 of the differences that the bars are made of.
        warnings.push(Warning::new(
            WarningKind::FirstOrder,
            "the errors of first-order elements exceed their error bars: use [mesh] pressure_order 2 or \
             more and elastic_order 2",
        ));
    }
    let d = &solution.discretisation;
    let profile = Profile::new(d, &solution.state, 2);
    let films = EdgeFilms {
        outlet: profile.outlet(),
        inlet: profile.fields.first().map_or(f64::INFINITY, |f| f.film),
        centre: central_film(d, &solution.state),
    };
    warnings.extend(edge_warnings(&d.contact.extents, &d.contact.shape, films));
    warnings
}

/// Warnings about error bars of the films that are wider than requested.
fn film_errors(
    summary: &Summary,
    solution: &StageSolution,
    target_error: Option<f64>,
) -> Vec<Warning> {
    let mut warnings = Vec::new();
    let films = [
        (
            WarningKind::CentralFilmError,
            "central",
            summary.film_central,
        ),
        (
            WarningKind::MinimumFilmError,
            "minimum",
            summary.film_minimum,
        ),
    ];
    for (kind_of_error, name, figure) in films {
        let relative = figure.error.unwrap_or(0.0) / figure.value;
        let text = match target_error {
            Some(target) if relative > target => format!(
                "the {name} film thickness is uncertain by {:.2} %, beyond [mesh] target_error: {}",
                100.0 * relative,
                mesh_ended(solution.mesh_end),
            ),
            None if relative > 0.05 => format!(
                "the {name} film thickness is uncertain by {:.0} %: use a finer mesh ([mesh] preset = \"fine\")",
                100.0 * relative
            ),
            _ => continue,
        };
        warnings.push(Warning::beyond(kind_of_error, relative, text));
    }
    warnings
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solution::{Bar, Bars, Figures, Reading, Timings};
    use approx::assert_relative_eq;

    fn level(film: f64) -> LevelStats {
        let mut figures = Figures::default();
        figures.note(Figure::FilmCentral, Reading::new(film));
        LevelStats {
            converged: true,
            n_body_cells: 0,
            n_contact_elements: 10,
            n_pressure_dofs: 10,
            n_displacement_dofs: 0,
            n_contact_dofs: 10,
            pressure_order: 2,
            role: Role::Estimate,
            newton_iterations: 1,
            krylov_iterations: 1,
            factorisations: 1,
            figures,
            seconds: Timings::default(),
        }
    }

    /// Both films 10 % too thick on the coarse mesh, one of them half the other: 50 % reduction, uncertain by half of
    /// 10 % and 1 %; without a bar of the film there is none.
    #[test]
    fn reductions_are_as_uncertain_as_their_mesh() {
        let (with, without, fine) = (level(1.1e-7), level(2.2e-7), level(1e-7));
        let mut bars = Bars::default();
        let bar = Bar {
            value: 1e-9,
            place: None,
        };
        bars.set(Figure::FilmCentral, bar);
        let mut solution = Measured {
            figures: fine.figures,
            bars,
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
