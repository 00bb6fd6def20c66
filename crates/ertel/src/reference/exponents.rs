//! Asymptotes of the film, and exponents of the elastic ones.

use std::fmt;

use serde::Serialize;

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
    /// m, n and l.
    pub fn in_order(self) -> [Fraction; 3] {
        [
            self.isoviscous_load,
            self.piezoviscous_load,
            self.piezoviscous_material,
        ]
    }
}

/// Central film of a contact in the four lubrication regimes, in the unit of the caller: H = h/(R √(2U))
/// from the formulas.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Asymptotes {
    /// Constant viscosity, rigid bodies.
    pub isoviscous_rigid: f64,
    /// Constant viscosity, elastic bodies.
    pub isoviscous_elastic: f64,
    /// Viscosity grows with pressure, rigid bodies.
    pub piezoviscous_rigid: f64,
    /// Viscosity grows with pressure, elastic bodies.
    pub piezoviscous_elastic: f64,
}
