//! The number type that the laws are written for.

use num_dual::DualNum;

/// A real number or a dual number over `f64`: laws evaluated with it carry exact derivatives.
///
/// Implemented for every copyable [`DualNum`] over `f64`: `f64`, `Dual64`, `Dual2_64`, `HyperDual64`, `DualSVec64<N>`.
pub trait Scalar: DualNum<Primitive = f64> + Copy {}

impl<D: DualNum<Primitive = f64> + Copy> Scalar for D {}
