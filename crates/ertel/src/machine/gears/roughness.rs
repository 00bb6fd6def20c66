//! Roughness of the flanks.

use crate::case::{Case, GearMechanics};

/// σ over Ra of normally distributed heights, as quoted.
const RMS_OVER_RA: f64 = 1.25;

/// Composite rms roughness of the flanks by their Ra, m.
pub(super) fn composite(gears: &GearMechanics) -> Option<f64> {
    let [pinion, wheel] = gears.limits.roughness?;
    Some(RMS_OVER_RA * pinion.hypot(wheel))
}

/// Source of a roughness Ra.
#[derive(Clone, Copy)]
pub(super) enum RoughnessFrom {
    /// The Ra of both gears.
    Gears,
    /// The composite roughness of the case.
    Composite,
}

/// Ra of the pinion and the wheel, m: as given, or for equal surfaces with the composite roughness σ, Ra = σ/(1.25 √2).
pub(super) fn roughness(case: &Case, gears: &GearMechanics) -> Option<([f64; 2], RoughnessFrom)> {
    if let Some(own) = gears.limits.roughness {
        return Some((own, RoughnessFrom::Gears));
    }
    let ra = case.roughness? / (RMS_OVER_RA * std::f64::consts::SQRT_2);
    (ra > 0.0).then_some(([ra; 2], RoughnessFrom::Composite))
}
