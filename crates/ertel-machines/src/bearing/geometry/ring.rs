//! Rings of a bearing and their raceways.

/// A ring of a bearing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ring {
    /// The ring on the shaft.
    Inner,
    /// The ring in the housing.
    Outer,
}

impl Ring {
    /// Inner, then outer ring: the order in all pairs of this module.
    pub const BOTH: [Ring; 2] = [Ring::Inner, Ring::Outer];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Ring::Inner => "inner",
            Ring::Outer => "outer",
        }
    }

    /// Place in a pair.
    pub fn index(self) -> usize {
        match self {
            Ring::Inner => 0,
            Ring::Outer => 1,
        }
    }

    /// −1 of the inner ring, whose raceway is convex along rolling, +1 of the outer.
    pub(crate) fn sign(self) -> f64 {
        match self {
            Ring::Inner => -1.0,
            Ring::Outer => 1.0,
        }
    }
}

/// Reduced radius of an element of the diameter D (m) on a raceway in the plane of rolling, m.
///
/// ```text
///   R_x = D/2 (1 ∓ γ),  γ = D cos α/d_m;   upper sign: inner ring
/// ```
/// Source: Harris and Kotzalas, Essential Concepts of Bearing Technology, 5th ed., 2007, chapter 2.
pub fn radius_along(ring: Ring, diameter: f64, gamma: f64) -> f64 {
    0.5 * diameter * (1.0 + ring.sign() * gamma)
}
