//! Chittenden, Dowson, Dunn and Taylor's formulas for ellipses with the motion at any angle.

use crate::contact::Groups;

pub(super) const SOURCE: &str = "Chittenden, Dowson, Dunn & Taylor 1985, Proc. R. Soc. A 397, 245-269; the radii are those along and across the \
     motion";

/// Central film over the radius along the motion, h_c/R_e, for D = R_e/R_s.
///
/// h_c/R_e = 4.31 U^0.68 G^0.49 W^(−0.073) (1 − e^(−1.23 D^(−2/3)))
pub fn chittenden_central(groups: &Groups, ratio: f64) -> f64 {
    4.31 * common(groups) * (1.0 - (-1.23 * ratio.powf(-2.0 / 3.0)).exp())
}

/// Minimum film over the radius along the motion, h_min/R_e, for D = R_e/R_s.
///
/// h_min/R_e = 3.68 U^0.68 G^0.49 W^(−0.073) (1 − e^(−0.67 D^(−2/3)))
pub fn chittenden_minimum(groups: &Groups, ratio: f64) -> f64 {
    3.68 * common(groups) * (1.0 - (-0.67 * ratio.powf(-2.0 / 3.0)).exp())
}

fn common(groups: &Groups) -> f64 {
    groups.speed.powf(0.68) * groups.material.powf(0.49) * groups.load.powf(-0.073)
}
