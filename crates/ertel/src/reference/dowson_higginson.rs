//! Dowson and Higginson's minimum film of line contacts.

use crate::contact::Groups;

pub(super) const SOURCE: &str = "Dowson & Higginson 1977, Elasto-hydrodynamic Lubrication, 2nd ed.";

pub(super) const SOURCE_1966: &str = "Dowson & Higginson 1966, Elasto-hydrodynamic Lubrication, 1st ed.; superseded by the formula of \
     1977";

/// Minimum film over radius of a line contact, h_min/R.
///
/// h_min/R = 2.65 U^0.70 G^0.54 W^(−0.13)
pub fn dowson_higginson_line_minimum(groups: &Groups) -> f64 {
    2.65 * groups.speed.powf(0.70) * groups.material.powf(0.54) * groups.load.powf(-0.13)
}

/// Minimum film over radius of a line contact, h_min/R, as first published.
///
/// h_min/R = 1.6 U^0.7 G^0.6 W^(−0.13)
pub fn dowson_higginson_1966_line_minimum(groups: &Groups) -> f64 {
    1.6 * groups.speed.powf(0.7) * groups.material.powf(0.6) * groups.load.powf(-0.13)
}
