//! `[bodies]`.

use crate::contact::Elasticity;

/// One of the two bodies.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// Name of its material in the database, or what a case file calls it.
    pub name: String,
    /// Elastic constants.
    pub elasticity: Elasticity,
}
