//! Dowson and Toyoda's central film of line contacts.

use crate::contact::Groups;

pub(super) const SOURCE: &str = "Dowson & Toyoda, 5th Leeds-Lyon Symposium 1978; central film";

/// Central film over radius of a line contact, h_c/R.
///
/// h_c/R = 3.06 U^0.69 G^0.56 W^(−0.10)
pub fn dowson_toyoda_line_central(groups: &Groups) -> f64 {
    3.06 * groups.speed.powf(0.69) * groups.material.powf(0.56) * groups.load.powf(-0.10)
}
