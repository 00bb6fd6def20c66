//! Figures and fields of a solved case, independent of the engine.

use crate::case::Case;
use crate::contact::Hertz;
use crate::engine::{Extents, Film, Problem, SolveError};
use crate::plausible;
use crate::plausible::neglected::Known;
use crate::post;
use crate::problem::groups as groups_of;
use crate::solution::{
    Asked, BodyField, Centreline, ElementFields, Figure, FilmReduction, IterationRecord, Measured,
    OtherGap, Section, Sensitivities, Solution, Starvation, Stats, Summary, SurfaceField, Thermal,
    Uncertainties, Unresolved,
};
use crate::warning::{Warning, WarningKind};

/// Results of an engine, SI.
pub(super) struct Found {
    pub measured: Measured,
    /// Contact area of the solve, in half-widths.
    pub extents: Extents,
    pub summary: Summary,
    pub film_reduction: Option<FilmReduction>,
    pub other_gap: Option<OtherGap>,
    pub thermal: Option<Thermal>,
    pub centreline: Centreline,
    pub surface: SurfaceField,
    pub elements: ElementFields,
    pub body: Option<BodyField>,
    /// Remarks of the engine.
    pub warnings: Vec<Warning>,
}

/// Builds the solution of a case from the results of its engine.
pub(super) fn describe<Plan>(
    case: &Case,
    problem: &Problem<Plan>,
    film: &impl Film,
    found: Found,
    stats: Stats,
    history: Vec<IterationRecord>,
) -> Solution {
    let Found {
        measured,
        extents,
        summary,
        thermal,
        elements,
        ..
    } = found;
    let contact = case.contact.along_motion();
    let hertz = Hertz::new(&contact, case.reduced_modulus());
    let slope = case
        .lubricant
        .viscosity
        .pressure_viscosity_slope(case.lubricant.temperature);
    let asymptotic = case
        .lubricant
        .viscosity
        .pressure_viscosity_reciprocal_asymptotic(case.lubricant.temperature)
        .ok();
    let groups = groups_of(case, slope);
    let groups_asymptotic = asymptotic.map(|alpha| groups_of(case, alpha));
    let scales = problem.scales;
    let traction = post::summary::traction(&measured);
    let (checks, summed_to) = post::checks::checks(problem, film, &summary, thermal.as_ref());
    let mut warnings = case.warnings.clone();
    warnings.extend(post::checks::warning(
        &problem.shape,
        &extents,
        scales.length,
    ));
    warnings.extend(found.warnings);
    if let (Some(thermal), Some(params), Some(heat)) = (&thermal, case.thermal(), &problem.heat) {
        let zone = &problem.shape.zone;
        warnings.extend(post::thermal::warnings(
            thermal,
            &case.lubricant.temperature_ranges,
            params,
            &scales,
            problem.shape.symmetry,
            [
                extents.inlet,
                extents.outlet,
                side_of(problem, zone.axis_ratio * extents.side),
            ],
        ));
        warnings.extend(post::thermal::at_rest::warnings(heat, thermal, params));
    }
    let mixed = case.roughness.map(|rms_height| {
        let surfaces = post::mixed::RoughSurfaces {
            rms_height,
            asperities: case.asperities.clone(),
            reduced_modulus: case.reduced_modulus(),
            load: case.contact.load,
        };
        let mut mixed = post::mixed::mixed_lubrication(&surfaces, &measured);
        if let Some(asperities) = &mut mixed.asperities {
            asperities.other_gap = found.other_gap;
        }
        let film_minimum = summary.film_minimum.value;
        warnings.extend(post::mixed::warning(&mixed, film_minimum, rms_height));
        mixed
    });
    let mut solution = Solution {
        kind: case.contact.kind,
        shape: problem.shape.clone(),
        hertz,
        reduced_modulus: case.reduced_modulus(),
        formulas: crate::reference::film_formulas(&case.contact, &groups, case.relative_density()),
        groups,
        groups_asymptotic,
        scales,
        extents: [
            extents.inlet,
            extents.outlet,
            side_of(problem, extents.side),
        ],
        centreline: found.centreline,
        surface: found.surface,
        elements,
        body: found.body,
        left_out: plausible::neglected::neglected(
            case,
            &Known {
                film_central: (measured.find(Figure::MeanGapCentral))
                    .map_or(summary.film_central.value, |gap| gap.value),
                film_minimum: summary.film_minimum.value,
                friction_power: traction.friction_power.value,
            },
        ),
        unresolved: Vec::new(),
        summary,
        starvation: Starvation::of(&measured, &case.supply),
        measured,
        mixed,
        traction,
        summed_to,
        checks,
        film_reduction: found.film_reduction,
        sensitivities: None,
        stresses: None,
        wear: None,
        uncertainty: None,
        thermal,
        history,
        stats,
        warnings,
    };
    let asked = Asked {
        bars: case.solver.error_estimate,
        // The net force of spin alone is zero.
        slides: case.motion.sliding_at_centre() > 0.0,
        radius: case.contact.radius,
    };
    solution.unresolved = Unresolved::all(&solution, asked);
    let doubts = plausible::warnings(case, &solution);
    solution.warnings.extend(doubts);
    solution
}

/// Half the extent of the contact area across the motion: half the length of a roller, otherwise `side`.
fn side_of<Plan>(problem: &Problem<Plan>, side: f64) -> f64 {
    let roller = problem.shape.zone.roller.as_ref();
    roller.map_or(side, |roller| roller.half_length())
}

/// Whether a resolved figure has derivatives. These are of the film solve: friction by a law that is not part of it has none. They are relative: a zero, such as the traction of
/// surfaces that slide by rounding alone, has none.
pub(super) fn has_derivatives(case: &Case, solution: &Solution, figure: Figure) -> bool {
    let is_of_law = figure.section() == Section::Traction || figure == Figure::FrictionTotal;
    let is_zero = (solution.figure(figure)).is_some_and(|at| at.value == 0.0);
    solution.resolves(figure) && !is_zero && !(case.friction_by_law && is_of_law)
}

/// Adds the sensitivities to the inputs and the resulting uncertainty. A solution without them remains valid.
///
/// # Errors
/// Only if the user stops the run.
pub(super) fn note_sensitivities(
    solution: &mut Solution,
    case: &Case,
    found: Result<Sensitivities, SolveError>,
) -> Result<(), SolveError> {
    let found = match found {
        Ok(found) => found,
        Err(SolveError::Interrupted) => return Err(SolveError::Interrupted),
        Err(error) => {
            let text = format!(
                "sensitivities and the uncertainty from the inputs could not be computed: {error}"
            );
            solution
                .warnings
                .push(Warning::new(WarningKind::Sensitivities, text));
            return Ok(());
        }
    };
    let is_uncertain =
        |key: &str| (case.inputs().iter()).any(|i| i.key == key && i.uncertainty.is_some());
    for input in found
        .left_out
        .iter()
        .filter(|input| is_uncertain(&input.key))
    {
        solution.warnings.push(Warning::new(
            WarningKind::Sensitivities,
            format!(
                "the uncertainty of the figures neglects that of {}: {}",
                input.key, input.reason
            ),
        ));
    }
    solution.uncertainty = Uncertainties::first_order(&found, case.correlations());
    solution.sensitivities = Some(found);
    Ok(())
}
