//! Where the outlet edge of the contact area lies, and how the film is kept from pulling before it.
//!
//! Around rigid parabolas pressure goes on far to the sides, and there further downstream than the centre. Far out, with H = r²/2 and the angle ψ from
//! the inlet, P = λf(ψ)/r³ solves Reynolds' equation where
//!
//! ```text
//!   f'' = 9f − 8 cos ψ,     f = 0.8 cos ψ − A cosh 3ψ,     f = f' = 0 at the rupture:  tan ψ = −3 tanh 3ψ,  ψ = 108.4°
//! ```
//! (particular solution: Kapitza 1955): between 90° and that, an outlet edge X cuts off a load that falls with 1/X.

/// Film, in a²/R, from which on far pressures count. Measured, all but round, at 45 degrees: at 0.2 and 0.45 the film with the outlet edge near and
/// far, and with either penalty, is the same within 0.03 %; at 2.7 it is 6 % apart.
const THICK: f64 = 0.3;

/// Distance of a far outlet edge in lengths √H_f of the rupture. Measured around a ball: the film is short of its limit by 1.6 % over this number
/// (H_f = 2.7, edges at 2 to 300 half-widths, and 4000).
const FAR: f64 = 60.0;

/// Distance of the outlet edge at least, in half-widths, as in the thesis.
const OUTLET: f64 = 1.5;

/// Distance of the outlet edge behind a dry contact, in lengths √H_f of the rupture.
const RUPTURE: f64 = 1.5;

/// Where the outlet edge lies behind thin films, in lines: behind the rupture on the centreline.
pub(super) fn near(film: f64) -> f64 {
    behind(1.0, film)
}

/// The same where the dry contact is up to this wide, in half-widths, as along rollers: the distance from it to the rupture depends on the film alone.
pub(super) fn behind(widest: f64, film: f64) -> f64 {
    OUTLET.max((widest + RUPTURE * film.sqrt()).ceil_half())
}

/// Where it lies for ellipses at an angle, whose thin films break off at an angle to the motion.
pub(super) fn at_an_angle(film: f64) -> f64 {
    OUTLET.max((1.0 + RUPTURE * film.sqrt() + 4.0 * film).ceil_half())
}

/// Where it lies for flooded circles and ellipses with a thick film, no farther than the inlet; `None` for thin films.
pub(super) fn behind_thick(film: f64, inlet: f64) -> Option<f64> {
    is_thick(film).then(|| (FAR * film.sqrt()).ceil_half().min(inlet).max(near(film)))
}

/// Whether a contact has a film so thick that pressures far out count.
pub(super) fn is_thick(film: f64) -> bool {
    film > THICK
}

/// Whether an edge lies so far behind a thick film that a penalty of one size does not keep the film before it from pulling.
pub(super) fn is_far(outlet: f64, film: f64) -> bool {
    is_thick(film) && outlet > near(film)
}

/// Rounding to halves: contact areas that bisection meshes well.
pub(super) trait ToHalves {
    fn ceil_half(self) -> f64;
    fn floor_half(self) -> f64;
}

impl ToHalves for f64 {
    fn ceil_half(self) -> f64 {
        (2.0 * self).ceil() / 2.0
    }

    fn floor_half(self) -> f64 {
        (2.0 * self).floor() / 2.0
    }
}
