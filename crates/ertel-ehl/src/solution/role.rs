//! Purpose of the stages of a solve.

use serde::Serialize;

/// Purpose of a stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Role {
    /// Only starts the next one: loose tolerance, penalty ramp, and what it reaches is good
    /// enough even when it does not converge, as long as it is nearer than the dry contact.
    Start,
    /// A step of a continuation from a start to the case's own equations: loose tolerance, but the penalty in full.
    Path,
    /// Its figures bound the discretisation error; skipped when it does not converge.
    Estimate,
    /// A film to compare the solution with; likewise.
    Comparison,
    /// The same contact without its heat, to compare with; likewise.
    Isothermal,
    /// The solution.
    Final,
}

impl Role {
    /// Whether it only leads to other stages.
    pub(crate) fn leads(self) -> bool {
        matches!(self, Role::Start | Role::Path)
    }

    /// Whether it is only compared with the solution.
    pub(crate) fn compares(self) -> bool {
        matches!(self, Role::Comparison | Role::Isothermal)
    }
}
