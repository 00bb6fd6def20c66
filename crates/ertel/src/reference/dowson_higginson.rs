//! Dowson and Higginson's minimum film of line contacts.

use crate::contact::Groups;

pub(super) const SOURCE: &str =
    "Dowson & Higginson 1977, Elasto-hydrodynamic Lubrication, 2nd ed. (constants verified)";

/// Minimum film over radius of a line contact, h_min/R.
///
/// h_min/R = 2.65 U^0.70 G^0.54 W^(−0.13)
pub fn dowson_higginson_line_minimum(groups: &Groups) -> f64 {
    2.65 * groups.speed.powf(0.70) * groups.material.powf(0.54) * groups.load.powf(-0.13)
}
