//! Purpose of the stages of a solve.

use serde::Serialize;

/// Purpose of a stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Role {
    /// Only starts the next one: loose tolerance, penalty ramp, and what it reaches is good
    /// enough even when it does not converge, as long as it is nearer than the dry contact.
    Start,
    /// Its figures bound the discretisation error; skipped when it does not converge.
    Estimate,
    /// A film to compare the solution with; likewise.
    Comparison,
    /// The same contact without its heat, to compare with; likewise.
    Isothermal,
    /// The solution.
    Final,
}
