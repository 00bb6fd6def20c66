//! Finds non-finite numbers: JSON cannot represent them, and a file with one would not be a valid result.
//!
//! All serialisable values are scanned, so new figures and fields need no line here; a new part of a solution must be named once.

mod numbers;

use std::collections::BTreeMap;

use serde::Serialize;

use crate::case::CaseEcho;
use crate::solution::{Located, Solution, Thermal};

/// Path of the first non-finite number, such as `summary.film_central.value`; `None` if all are finite.
pub(super) fn first_not_finite(case: &CaseEcho, solution: &Solution) -> Option<String> {
    let Solution {
        // A name, and the mesh geometry, which no file holds.
        kind: _,
        shape: _,
        hertz,
        reduced_modulus,
        groups,
        groups_asymptotic,
        scales,
        extents,
        // Scanned by name below.
        measured: _,
        summary,
        starvation,
        mixed,
        traction,
        summed_to,
        checks,
        film_reduction,
        thermal,
        stresses,
        wear,
        sensitivities,
        uncertainty,
        formulas,
        centreline,
        surface,
        elements,
        body,
        // Solution statistics: a failed grid may have non-finite numbers; they are null in JSON.
        history: _,
        stats: _,
        left_out,
        unresolved,
        // Texts.
        warnings: _,
    } = solution;
    find("case", case)
        .or_else(|| find("hertz", hertz))
        .or_else(|| find("reduced_modulus", reduced_modulus))
        .or_else(|| find("groups", groups))
        .or_else(|| find("groups_asymptotic", groups_asymptotic))
        .or_else(|| find("scales", scales))
        .or_else(|| find("extents", extents))
        .or_else(|| find("figures", &by_name(solution)))
        .or_else(|| find("summary", summary))
        .or_else(|| find("starvation", starvation))
        .or_else(|| find("mixed", mixed))
        .or_else(|| find("traction", traction))
        .or_else(|| find("summed_to", summed_to))
        .or_else(|| find("checks", checks))
        .or_else(|| find("film_reduction", film_reduction))
        .or_else(|| find("thermal", thermal))
        .or_else(|| find("stresses", stresses))
        .or_else(|| find("wear", wear))
        .or_else(|| find("sensitivities", sensitivities))
        .or_else(|| find("uncertainty", uncertainty))
        .or_else(|| find("formulas", formulas))
        .or_else(|| find("left_out", left_out))
        .or_else(|| find("unresolved", unresolved))
        .or_else(|| find("centreline", centreline))
        .or_else(|| find("surface", surface))
        .or_else(|| find("elements", elements))
        .or_else(|| find("body", body))
        .or_else(|| thermal.as_ref().and_then(temperatures))
}

/// The figures by their names.
fn by_name(solution: &Solution) -> BTreeMap<&'static str, Located> {
    let figures = solution.figures();
    figures.map(|(figure, at)| (figure.name(), at)).collect()
}

/// Temperature fields, which are not in `result.json`.
fn temperatures(thermal: &Thermal) -> Option<String> {
    find("thermal.centreline", &thermal.centreline)
        .or_else(|| find("thermal.surface", &thermal.surface))
        .or_else(|| find("thermal.profiles", &thermal.profiles))
        .or_else(|| find("thermal.field", &thermal.field))
}

/// Path of the first non-finite number of a value.
fn find(name: &str, value: &impl Serialize) -> Option<String> {
    let path = numbers::first_not_finite(value)?;
    Some(format!("{name}{path}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::sample;
    use crate::solution::{BodyField, Figure, Reading};

    /// Names a number in each part and for each shape that serde knows.
    type Spoil = (&'static str, fn(&mut CaseEcho, &mut Solution));

    const SPOILS: [Spoil; 11] = [
        ("case.contact.load", |case, _| case.contact.load = f64::NAN),
        ("reduced_modulus", |_, s| s.reduced_modulus = f64::NAN),
        ("extents[2]", |_, s| s.extents[2] = f64::INFINITY),
        ("summary.film_central.value", |_, s| {
            s.summary.film_central.value = f64::NAN;
        }),
        ("figures.friction_power.value", |_, s| {
            let friction = Reading::new(f64::NAN);
            s.measured.figures.set(Figure::FrictionPower, friction);
        }),
        ("summary.film_minimum.error", |_, s| {
            s.summary.film_minimum.error = Some(f64::NAN);
        }),
        ("summary.film_minimum_at.place_error", |_, s| {
            s.summary.film_minimum_at.place_error = Some(f64::NAN);
        }),
        ("formulas[0].film_central", |_, s| {
            s.formulas[0].central = Some(f64::NEG_INFINITY);
        }),
        ("centreline.viscosity[3]", |_, s| {
            s.centreline.viscosity[3] = f64::INFINITY;
        }),
        ("elements.pressure.values[5]", |_, s| {
            s.elements.pressure.values[5] = f64::NAN;
        }),
        ("body.displacement[0][2]", |_, s| {
            s.body = Some(BodyField {
                displacement: vec![[0.0, 0.0, f64::NAN]],
                ..BodyField::default()
            });
        }),
    ];

    #[test]
    fn a_number_that_is_not_finite_is_found_and_named() {
        let (case, solution) = sample::line();
        assert_eq!(first_not_finite(case, solution), None);
        for (name, spoil) in SPOILS {
            let (mut case, mut solution) = (case.clone(), solution.clone());
            spoil(&mut case, &mut solution);
            assert_eq!(first_not_finite(&case, &solution).as_deref(), Some(name));
        }
    }

    /// Non-finite solution statistics do not reject a result: they become null.
    #[test]
    fn non_finite_statistics_do_not_reject_a_result() {
        let (case, solution) = sample::line();
        let mut solution = solution.clone();
        solution.history[1].residual = f64::NAN;
        solution.stats.levels[0].seconds.mesh = f64::INFINITY;
        assert_eq!(first_not_finite(case, &solution), None);
        let json = crate::output::result_json(case, &solution).unwrap();
        assert!(json["history"][1]["residual"].is_null());
    }
}
