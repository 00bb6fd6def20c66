//! The pressure far from a contact, where the surfaces are parabolas and rigid (Kapitza 1955).

use crate::contact::Gap;

/// c of the pressure −λ c·X/H² far from a contact, along and across the motion.
pub fn far_field(gap: &Gap) -> [f64; 2] {
    let kappa = gap.curvature_ratio;
    let [along, across] = gap.turn.to_axes([1.0, 0.0]);
    let first = 1.0 / (3.0 + 2.0 * kappa);
    let second = kappa / (3.0 * kappa + 2.0);
    gap.turn.to_motion([first * along, second * across])
}
