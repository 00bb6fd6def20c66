//! Multifrontal LU of an unsymmetric matrix with symmetric pattern, for preconditioning.
//!
//! ```text
//!   front  | A  B |    W = A⁻¹B, V = C A⁻¹; D − V B goes to the parent.
//!          | C  D |    A⁻¹, V and W are kept: a solve is three products per front.
//! ```
//! Rows are interchanged inside A only: the order is fixed by the pattern, once for all matrices
//! that share it. Single precision is what a preconditioner needs.

mod factorise;
mod factors;
mod pattern;
mod sweep;
#[cfg(test)]
mod tests;

pub use factorise::FrontalError;
pub use pattern::FrontalPattern;
pub use sweep::FrontalLu;
