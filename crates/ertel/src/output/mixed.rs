//! Rough surfaces in the report.

use std::fmt::Write;

use super::figure::{in_unit, number, percent, percent_or_power};
use super::lines::Lines;
use crate::mixed::Asperities;
use crate::solution::{Estimate, Solution};
use crate::words::{digits, pressure};

/// Source of the asperity load and friction model.
pub(super) const ASPERITY_SOURCE: &str = "Greenwood and Tripp 1970";

/// The asperity parameters.
pub(super) fn describe(asperities: &Asperities) -> String {
    let mut text = format!(
        "σβη {}, σ/β {}",
        digits(asperities.asperity_group, 6),
        digits(asperities.rms_height_to_asperity_radius, 6)
    );
    if let Some(friction) = asperities.boundary_friction_coefficient {
        let _ = write!(text, ", boundary friction {}", digits(friction, 6));
    }
    text
}

/// The ratio of film thickness to roughness, and its definition.
pub(super) fn write_lambda(out: &mut Lines, solution: &Solution) {
    let Some(mixed) = &solution.mixed else { return };
    let ratio = |lambda: Estimate| match lambda.error {
        Some(_) => number(lambda),
        None => digits(lambda.value, 3),
    };
    let minimum = ratio(mixed.lambda_minimum);
    out.row(
        "lambda ratio h_min/σ",
        format!("{minimum}: {}", mixed.separation.name()),
    );
    out.row("  h_c/σ", ratio(mixed.lambda_central));
}

/// Load and friction of the asperities.
pub(super) fn write_asperities(out: &mut Lines, solution: &Solution) {
    let Some(mixed) = &solution.mixed else { return };
    let Some(asperities) = &mixed.asperities else {
        return;
    };
    let unit = if !solution.shape.is_line() {
        "N"
    } else {
        "N/m"
    };
    let load = in_unit(asperities.asperity_load, 1.0, unit);
    out.row(
        "asperity load",
        format!(
            "{load}, {} of the load ({ASPERITY_SOURCE}, at the film of smooth surfaces)",
            share(asperities.asperity_load_share)
        ),
    );
    let limit = percent_or_power(asperities.asperity_load_share_limit);
    out.row("  upper limit (dry)", limit);
    let largest = pressure(asperities.asperity_pressure_maximum);
    out.row("  largest asperity pressure", largest);
    let Some(friction) = &asperities.friction else {
        return;
    };
    let of_parts = |[fluid, asperities, total]: [Estimate; 3]| {
        format!(
            "{}: film {}, asperities {}",
            number(total),
            number(fluid),
            number(asperities)
        )
    };
    let f = friction;
    out.row(
        "total friction coefficient",
        of_parts([f.friction_fluid, f.friction_asperities, f.friction_total]),
    );
    if let Some(across) = f.across {
        out.row("  across the motion", of_parts(across));
    }
}

/// A share in per cent; tiny ones with a power of ten.
pub(super) fn share(share: Estimate) -> String {
    match share.value < 1e-4 {
        true => number(share),
        false => percent(share),
    }
}
