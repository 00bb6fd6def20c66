//! Exponents of the elastic asymptotes.

use std::fmt;

use super::{moes_line, nijenbanning_venner_moes};
use crate::contact::Family;

/// An exponent as formulas are written: `-2/15`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fraction {
    /// Above the line, with the sign.
    pub numerator: i32,
    /// Below the line.
    pub denominator: i32,
}

impl Fraction {
    pub(super) const fn new(numerator: i32, denominator: i32) -> Fraction {
        Fraction {
            numerator,
            denominator,
        }
    }

    /// Its value.
    pub fn value(self) -> f64 {
        f64::from(self.numerator) / f64::from(self.denominator)
    }
}

impl fmt::Display for Fraction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.numerator, self.denominator)
    }
}

/// Exponents of the asymptotes of elastic bodies.
///
/// H_EI ∝ M^m, H_EP ∝ M^n L^l
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ElasticExponents {
    /// m, of the load group where the viscosity stays.
    pub isoviscous_load: Fraction,
    /// n, of the load group where the viscosity grows with pressure.
    pub piezoviscous_load: Fraction,
    /// l, of the material group there.
    pub piezoviscous_material: Fraction,
}

impl ElasticExponents {
    /// Those of [`moes_line_asymptotes`](super::moes_line_asymptotes) or
    /// [`nijenbanning_venner_moes_asymptotes`](super::nijenbanning_venner_moes_asymptotes).
    pub fn of(family: Family) -> ElasticExponents {
        match family {
            Family::Point => nijenbanning_venner_moes::EXPONENTS,
            Family::Cylinder => moes_line::EXPONENTS,
        }
    }

    /// m, n and l.
    pub fn in_order(self) -> [Fraction; 3] {
        [
            self.isoviscous_load,
            self.piezoviscous_load,
            self.piezoviscous_material,
        ]
    }
}
