//! How much oil reaches the contact.

use serde::Serialize;

/// How much oil reaches the contact.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum Supply {
    /// More than can pass: fully flooded.
    #[default]
    Flooded,
    /// A layer of this thickness, m, on both surfaces together: the oil supply per width at ambient density, over the entrainment
    /// speed.
    OilLayer {
        /// Its thickness, m.
        thickness: f64,
    },
    /// The gap is full from a straight meniscus on, across the motion at this distance from the centre, m.
    Meniscus {
        /// Its distance, m.
        distance: f64,
    },
}

impl Supply {
    /// Whether the contact may be starved.
    pub fn is_limited(&self) -> bool {
        *self != Supply::Flooded
    }
}

/// A layer of oil that reaches the contact, dimensionless.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OilLayer {
    /// H_oil, in a²/R.
    pub thickness: f64,
    /// λ of the Reynolds equation.
    pub lambda: f64,
}

/// The oil supply for the solver.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Inlet {
    /// The gap is full, and the inlet edge of the contact area far away.
    #[default]
    Flooded,
    /// The gap is full, and the inlet edge of the contact area the meniscus.
    Meniscus,
    /// The gap is filled by the arriving layer.
    Layer(OilLayer),
}

impl Inlet {
    /// The layer of oil, where one is given.
    pub fn layer(&self) -> Option<&OilLayer> {
        match self {
            Inlet::Layer(layer) => Some(layer),
            Inlet::Flooded | Inlet::Meniscus => None,
        }
    }

    /// Whether another is of the same kind.
    pub fn is_like(&self, other: &Inlet) -> bool {
        std::mem::discriminant(self) == std::mem::discriminant(other)
    }
}
