//! Stiffness of a pair of teeth.

use crate::gear::geometry::{GearError, GearPair, Meshing, in_range};

/// Stiffness of one pair of teeth per face width, along the path of contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ToothStiffness {
    /// The same everywhere, N/m².
    Given(f64),
    /// The single stiffness c' of ISO 6336-1 everywhere; the factors are C_R (1 of solid discs) and C_B (1 of the basic rack that the regression is for).
    Iso6336 {
        /// Gear blank factor C_R.
        blank_factor: f64,
        /// Basic rack factor C_B.
        rack_factor: f64,
    },
}

impl ToothStiffness {
    /// Stiffness per face width (N/m²) of the teeth of a pair.
    pub(super) fn value(self, pair: &GearPair) -> Result<f64, GearError> {
        match self {
            ToothStiffness::Given(stiffness) => {
                in_range("tooth stiffness", stiffness, stiffness > 0.0, "positive")?;
                Ok(stiffness)
            }
            ToothStiffness::Iso6336 {
                blank_factor,
                rack_factor,
            } => iso_single_stiffness(pair, blank_factor, rack_factor),
        }
    }
}

/// Single stiffness c' of steel teeth per face width, N/m², of ISO 6336-1, method B.
///
/// q' = 0.04723 + 0.15551/z_n1 + 0.25791/z_n2 − 0.00635 x_1 − 0.11654 x_1/z_n1 − 0.00193 x_2 − 0.24188 x_2/z_n2 + 0.00529 x_1² + 0.00182 x_2²
/// c' = C_M C_R C_B cos β/q',  C_M = 0.8,  z_n = z/(cos² β_b cos β)
///
/// with q' in mm·µm/N. Of internal wheels z_n2 = ∞. For loads per width of 100 N/mm and more; below them teeth are softer.
/// Range: x_1 ≥ x_2 and −0.5 ≤ x_1 + x_2 ≤ 2.
///
/// Source: ISO 6336-1:2006, 9.3; the constants as in two open programs (GEARpie; gearbox), of which the first has x_1 for x_2 in the term of z_n2.
pub fn iso_single_stiffness(
    pair: &GearPair,
    blank_factor: f64,
    rack_factor: f64,
) -> Result<f64, GearError> {
    let [x_1, x_2] = pair.shifts;
    let sum = x_1 + x_2;
    if x_1 < x_2 || !(-0.5..=2.0).contains(&sum) {
        return Err(GearError::Sharing {
            law: "by the stiffness of ISO 6336-1",
            requirement: "x_1 ≥ x_2 and −0.5 ≤ x_1 + x_2 ≤ 2",
        });
    }
    let unit = |name, value: f64| in_range(name, value, value > 0.0, "positive");
    unit("blank factor", blank_factor)?;
    unit("basic rack factor", rack_factor)?;
    let beta = pair.dimensions.helix_angle;
    let virtual_teeth = |z: f64| z / (pair.base_helix_angle.cos().powi(2) * beta.cos());
    let per_z_1 = virtual_teeth(pair.teeth[0]).recip();
    let per_z_2 = match pair.dimensions.meshing {
        Meshing::External => virtual_teeth(pair.teeth[1]).recip(),
        Meshing::Internal => 0.0,
    };
    let flexibility = 0.04723 + 0.15551 * per_z_1 + 0.25791 * per_z_2
        - 0.00635 * x_1
        - 0.11654 * x_1 * per_z_1
        - 0.00193 * x_2
        - 0.24188 * x_2 * per_z_2
        + 0.00529 * x_1 * x_1
        + 0.00182 * x_2 * x_2;
    // 1 N/(mm µm) = 1e9 N/m².
    Ok(1e9 * 0.8 * blank_factor * rack_factor * beta.cos() / flexibility)
}

/// Mean mesh stiffness per face width, N/m²: c_γα = c' (0.75 ε_α + 0.25), for ε_α ≥ 1.2. Source: ISO 6336-1:2006, 9.3.
pub fn mean_mesh_stiffness(pair: &GearPair, single_stiffness: f64) -> f64 {
    single_stiffness * (0.75 * pair.contact_ratio + 0.25)
}
