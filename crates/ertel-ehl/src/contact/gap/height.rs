//! Height of a term of the gap, and the body that has it.

/// Height at a place with its slopes. Further properties of a term, such as the rate of a moving one, become fields here.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Height {
    /// The height.
    pub value: f64,
    /// Its gradient.
    pub gradient: [f64; 2],
}

/// One of the two bodies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Body {
    /// Body 1.
    First,
    /// Body 2.
    Second,
}
