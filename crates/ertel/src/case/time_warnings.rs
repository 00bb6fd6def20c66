//! Warnings about `[transient]`, given before it is solved.

use super::Case;
use super::transient::Transient;
use crate::contact::Supply;
use crate::warning::{Warning, WarningKind};
use crate::words::digits;

/// Relative difference of two values that rounding makes.
const ROUNDING: f64 = 1e-9;

/// Steps that are many: tens of times those of the shipped cases.
const MANY_STEPS: f64 = 2e4;

/// Inputs without effect on the results, and courses that contradict the case or its duration.
pub(super) fn warnings(case: &Case) -> Vec<Warning> {
    let changes = (case.transient.as_ref()).is_some_and(|t| t.temperature.is_some());
    let keys = changes.then_some("temperature");
    let ignored = (case.lubricant).temperature_ignored(keys, "changes in time");
    let Some(transient) = &case.transient else {
        return ignored.into_iter().collect();
    };
    let rough = case.roughness.filter(|_| case.asperities.is_none()).map(|_| {
        Warning::new(
            WarningKind::NoEffect,
            "the roughness has no effect in time: films over it give the lambda ratio at each instant",
        )
    });
    let least = transient.least_steps();
    let many = (least > MANY_STEPS).then(|| {
        Warning::new(
            WarningKind::UnusualInput,
            format!(
                "the courses in [transient] take at least {} steps",
                digits(least, 2)
            ),
        )
    });
    ignored
        .into_iter()
        .chain(rough)
        .chain(many)
        .chain(of_courses(case, transient))
        .collect()
}

/// Courses that begin with another value than the case has, and those that change after the end.
fn of_courses(case: &Case, transient: &Transient) -> Vec<Warning> {
    // Those of a machine's contact follow from the machine.
    if case.whole.is_some() {
        return Vec::new();
    }
    let mut warnings = Vec::new();
    for (key, dimension, course) in transient.courses() {
        let Some(change) = course.first_change() else {
            continue;
        };
        let duration = transient.duration;
        if change >= duration {
            warnings.push(Warning::new(WarningKind::NoEffect, format!(
                "`{key}` in [transient] changes from {} s on, after the end of the run at {} s: the change has no effect",
                digits(change, 4),
                digits(duration, 4)
            )));
        }
        let unit = match (key, case.contact.kind.is_line()) {
            ("load", true) => "N/m".to_owned(),
            _ => dimension.si_unit(),
        };
        let (start, own) = (course.at(0.0), value(case, key));
        if (start - own).abs() > ROUNDING * start.abs().max(own.abs()) {
            warnings.push(Warning::new(WarningKind::UnusualInput, format!(
                "`{key}` in [transient] begins with {} {unit}, but the rest of the case has {} {unit}: the run begins with the former; checks and estimates use \
                 the latter",
                digits(start, 6),
                digits(own, 6)
            )));
        }
    }
    warnings
}

/// The value of a quantity in the rest of the case.
fn value(case: &Case, key: &str) -> f64 {
    let motion = &case.motion;
    match key {
        "entrainment_speed" => motion.entrainment_speed,
        "slide_to_roll_ratio" => motion.slide_to_roll_ratio,
        "slide_to_roll_ratio_across" => motion.slide_to_roll_ratio_across,
        "body_1_speed" => motion.body_1_speed(),
        "body_2_speed" => motion.body_2_speed(),
        "body_1_spin" => motion.spin[0],
        "body_2_spin" => motion.spin[1],
        "load" => case.contact.load,
        "radius" => case.contact.radius,
        "temperature" => case.lubricant.temperature,
        "oil_layer" => match case.supply {
            Supply::OilLayer { thickness } => thickness,
            Supply::Flooded | Supply::Meniscus { .. } => f64::NAN,
        },
        _ => f64::NAN,
    }
}
