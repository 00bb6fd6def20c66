//! The laws that thermal conductivity and heat capacity have in common, and the choice among all.
//!
//! Pressure is the rise above ambient (Pa), temperature is absolute (K). Every law is positive far outside its data, too: a heat equation
//! must not lose its sign on the way to its solution.

use std::fmt::Debug;

use crate::error::Check;
pub use crate::linear::LinearFactor;
use crate::{Isotherms, LawError, Scalar};

/// A property with laws of lubricants that it does not share with others.
pub trait Property {
    /// Key in data files of its value in the constant and the linear law.
    const KEY: &'static str;
    /// Its law of Larsson and Andersson.
    type LarssonAndersson: Debug + Clone + PartialEq;
    /// Its law by scaling with volume and temperature.
    type Scaling: Debug + Clone + PartialEq;

    /// The law of Larsson and Andersson at a pressure (Pa above ambient) and a temperature (K).
    fn larsson_andersson<D: Scalar>(law: &Self::LarssonAndersson, pressure: D, temperature: D)
    -> D;

    /// The law by scaling at a pressure (Pa above ambient) and a temperature (K).
    fn scaling<D: Scalar>(law: &Self::Scaling, pressure: D, temperature: D) -> D;
}

/// The laws of a property `y`.
#[derive(Debug, Clone, PartialEq)]
pub enum PropertyLaw<P: Property> {
    /// `y = y₀`
    Constant(f64),
    /// `y = y₀ [1 + a_T (T - T_R) + a_p p]`
    Linear(f64, LinearFactor),
    /// After Larsson and Andersson.
    LarssonAndersson(P::LarssonAndersson),
    /// By scaling with volume and temperature.
    Scaling(P::Scaling),
    /// Monotone interpolation in a table over pressure and temperature, [`Isotherms::held`].
    Table(Isotherms),
}

impl<P: Property> PropertyLaw<P> {
    /// A value (SI) that does not change: `y = y₀`.
    ///
    /// # Errors
    ///
    /// A value that is not positive and finite.
    ///
    /// Theory: Conductivity and heat capacity, Constant.
    pub fn constant(value: f64) -> Result<Self, LawError> {
        Check("constant").positive(P::KEY, value)?;
        Ok(Self::Constant(value))
    }

    /// Linear in pressure and temperature, with the value (SI) at ambient pressure and T_R and the bracket:
    ///
    /// ```text
    /// y = y₀ [1 + a_T (T - T_R) + a_p p]
    /// ```
    ///
    /// A falling line is limited to a tenth of y₀, far from any state that it was fitted to.
    ///
    /// # Errors
    ///
    /// A value that is not positive and finite.
    ///
    /// Theory: Conductivity and heat capacity, Linear.
    pub fn linear(value: f64, factor: LinearFactor) -> Result<Self, LawError> {
        Check("linear").positive(P::KEY, value)?;
        Ok(Self::Linear(value, factor))
    }

    /// The property (SI) at `pressure` (Pa above ambient) and `temperature` (K).
    #[inline]
    pub(crate) fn value<D: Scalar>(&self, pressure: D, temperature: D) -> D {
        match self {
            Self::Constant(value) => D::from(*value),
            Self::Linear(value, factor) => factor.value(pressure, temperature) * *value,
            Self::LarssonAndersson(law) => P::larsson_andersson(law, pressure, temperature),
            Self::Scaling(law) => P::scaling(law, pressure, temperature),
            Self::Table(law) => law.evaluate(pressure, temperature),
        }
    }

    /// The value (SI) of a law that is one number; `None` for a law that depends on something.
    pub fn constant_value(&self) -> Option<f64> {
        match self {
            Self::Constant(value) => Some(*value),
            Self::Linear(..) | Self::LarssonAndersson(_) | Self::Scaling(_) | Self::Table(_) => {
                None
            }
        }
    }

    /// Name of the law as written in data files.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Constant(_) => "constant",
            Self::Linear(..) => "linear",
            Self::LarssonAndersson(_) => "larsson-andersson",
            Self::Scaling(_) => "scaling",
            Self::Table(_) => "table",
        }
    }

    /// Range `(min, max)` of pressure (Pa) and of temperature (K) covered by tabulated data, infinite in pressure for a
    /// table over temperature alone; `None` for a formula.
    pub fn tabulated_range(&self) -> Option<[(f64, f64); 2]> {
        match self {
            Self::Table(law) => Some(law.range()),
            Self::Constant(_) | Self::Linear(..) | Self::LarssonAndersson(_) | Self::Scaling(_) => {
                None
            }
        }
    }
}
