//! Estimates for oils known only by their data sheet.
//!
//! Data missing from a data sheet are taken from published correlations and typical values. Each is an
//! [`Estimate`]: a number with the range in which the truth is expected, and where both come from.

mod base_oil;
mod blend;
mod heat;
mod index_table;
mod shear;
mod viscosity_index;

pub use base_oil::BaseOil;
pub use blend::{BLENDING_TEMPERATURES, Blend, BlendError};
pub use heat::HeatEstimate;
pub use shear::ShearEstimate;
pub use viscosity_index::{viscosity_at_40, viscosity_at_100, viscosity_index};

use ertel_quantity::{COVERAGE, Uncertainty};

/// Viscosity grades of ISO 3448: kinematic viscosity at 40 degC in mm²/s, within 10 %.
pub const ISO_VG: [f64; 20] = [
    2.2, 3.2, 4.6, 6.8, 10.0, 15.0, 22.0, 32.0, 46.0, 68.0, 100.0, 150.0, 220.0, 320.0, 460.0,
    680.0, 1000.0, 1500.0, 2200.0, 3200.0,
];
/// Their names, which round the first four.
pub(crate) const ISO_VG_NAMES: [f64; 20] = [
    2.0, 3.0, 5.0, 7.0, 10.0, 15.0, 22.0, 32.0, 46.0, 68.0, 100.0, 150.0, 220.0, 320.0, 460.0,
    680.0, 1000.0, 1500.0, 2200.0, 3200.0,
];
/// Relative deviation allowed between the viscosity of an oil and that of its grade.
pub const ISO_VG_TOLERANCE: f64 = 0.1;

/// Density of water at 15 degC (kg/m³), to which relative densities refer.
pub const WATER_AT_15: f64 = 999.1;

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
    fn even(
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
    fn midway(a: &Self, b: &Self) -> Self {
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

#[cfg(test)]
mod tests;
