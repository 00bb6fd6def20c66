//! Rough surfaces in the report.

use std::fmt::Write;

use super::figure::{in_unit, number, percent};
use super::lines::Lines;
use crate::mixed::{Asperities, AsperityLaw};
use crate::solution::{Estimate, Solution};
use crate::words::{digits, length, pressure};

/// The asperity parameters.
pub(super) fn describe(asperities: &Asperities) -> String {
    let law = &asperities.law;
    let mut text = match law {
        AsperityLaw::GreenwoodTripp(summits) | AsperityLaw::GreenwoodWilliamson(summits) => {
            format!(
                "{}: σβη {}, σ/β {}",
                law.source(),
                digits(summits.asperity_group, 6),
                digits(summits.rms_height_to_asperity_radius, 6)
            )
        }
        AsperityLaw::Persson(own) => format!(
            "{}: rms slope {}, u_0/σ {}, β {}",
            law.source(),
            digits(own.rms_slope, 6),
            digits(own.decay_length_to_rms_height, 6),
            digits(own.pressure_factor, 4)
        ),
        AsperityLaw::Table(table) => format!(
            "{} at {} distances",
            law.source(),
            table.asperity_distances.len()
        ),
    };
    if let Some(hardness) = asperities.hardness {
        let _ = write!(text, ", hardness {}", pressure(hardness));
    }
    if let Some(friction) = asperities.boundary_friction_coefficient {
        let _ = write!(text, ", boundary friction {}", digits(friction, 6));
    }
    let _ = write!(text, ", oil flows {}", asperities.flow.words());
    if let Some(orientation) = asperities.orientation {
        let _ = write!(text, ", γ = {}", orientation.name());
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
            "{load}, {} of the load",
            share(asperities.asperity_load_share)
        ),
    );
    let largest = pressure(asperities.asperity_pressure_maximum);
    out.row("  largest asperity pressure", largest);
    if let Some(other) = &asperities.other_gap {
        let mut text = format!(
            "{:.1} % of the load, h_c {}, h_min {}",
            100.0 * other.asperity_load_share,
            length(other.film_central),
            length(other.film_minimum)
        );
        if let Some(friction) = other.friction_total {
            let _ = write!(text, ", friction {}", digits(friction, 4));
        }
        out.row("  with the other gap", text);
        out.note(
            "other gap: the oil flows through the distance of the mean planes; both are models, and their difference is not in the error bars",
        );
    }
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
