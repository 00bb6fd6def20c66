//! Numbers that a data sheet does not give, with their range and source.

use ertel_quantity::{COVERAGE, Uncertainty};

/// A number that a data sheet does not give.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// The number in SI.
    pub value: f64,
    /// How far below it the truth may lie, as a share of it.
    pub below: f64,
    /// How far above.
    pub above: f64,
    /// Key in the bibliography, and the place.
    pub source: &'static str,
    /// How the truth is spread over the range.
    pub spread: Spread,
    /// Basis of the range.
    pub basis: &'static str,
}

/// How the truth is spread over the range of an estimate.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Spread {
    /// Normally about the number: the range covers 95 % of such oils.
    Normal,
    /// Evenly between the ends of the range.
    Even,
}

impl Estimate {
    /// A number with its truth spread evenly over a range.
    pub(super) fn even(
        value: f64,
        [below, above]: [f64; 2],
        source: &'static str,
        basis: &'static str,
    ) -> Self {
        Self {
            value,
            below,
            above,
            source,
            spread: Spread::Even,
            basis,
        }
    }

    /// Of a Group III oil: midway between the estimates of a mineral oil and of a polyalphaolefin, with a range that holds both of theirs.
    pub(super) fn midway(a: &Self, b: &Self) -> Self {
        let value = 0.5 * (a.value + b.value);
        let lowest = |e: &Self| e.value * (1.0 - e.below);
        let highest = |e: &Self| e.value * (1.0 + e.above);
        Self::even(
            value,
            [
                1.0 - lowest(a).min(lowest(b)) / value,
                highest(a).max(highest(b)) / value - 1.0,
            ],
            "none, midway between mineral oil and polyalphaolefin",
            "no measured figure of a Group III oil was found: the range covers those of mineral oils and of polyalphaolefins",
        )
    }

    /// The range as an uncertainty of the number, SI; where the range has two arms, with their mean to either side.
    #[must_use]
    pub fn uncertainty(&self) -> Uncertainty {
        let half_width = 0.5 * (self.below + self.above) * self.value.abs();
        match self.spread {
            Spread::Normal => Uncertainty::Normal {
                standard: half_width / COVERAGE,
            },
            Spread::Even => Uncertainty::Uniform { half_width },
        }
    }
}
