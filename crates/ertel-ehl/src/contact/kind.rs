//! Kinds of contacts as users name them, and their properties.
//!
//! The solver does not use the kind: the geometry that it needs is in [`Shape`](super::Shape).

use serde::Serialize;

/// Shape of the contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ContactKind {
    /// Infinitely long cylinder on a plane (plane strain); loads are per length.
    Line,
    /// Ball on plane.
    Circular,
    /// Bodies with two radii of curvature each; the axes of the contact lie along x and y.
    Elliptical,
    /// A roller of finite length on a plane, its axis along y.
    Roller,
}

/// Contacts with the same theory of the dry contact, the same groups and the same formulas of films.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// Balls and ellipsoids.
    Point,
    /// Cylinders; rollers under their load per length.
    Cylinder,
}

impl ContactKind {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Circular, Self::Line, Self::Elliptical, Self::Roller];

    /// Its name in a case.
    pub fn name(self) -> &'static str {
        match self {
            Self::Circular => "circular",
            Self::Line => "line",
            Self::Elliptical => "elliptical",
            Self::Roller => "roller",
        }
    }

    /// The family whose theory it follows.
    pub fn family(self) -> Family {
        match self {
            Self::Circular | Self::Elliptical => Family::Point,
            Self::Line | Self::Roller => Family::Cylinder,
        }
    }

    /// Whether a cylinder touches, whose films are those of a line contact under the load per length.
    pub fn is_cylinder(self) -> bool {
        self.family() == Family::Cylinder
    }

    /// Whether the contact has no ends along y; its load is one per length then, and not a force.
    pub fn is_line(self) -> bool {
        match self {
            Self::Line => true,
            Self::Circular | Self::Elliptical | Self::Roller => false,
        }
    }

    /// Unit of the load.
    pub fn load_unit(self) -> &'static str {
        if self.is_line() { "N/m" } else { "N" }
    }
}

impl Family {
    /// The power k of Moes' load group, `M = W (2U)^(-k)`.
    pub fn moes_power(self) -> f64 {
        match self {
            Family::Cylinder => 0.5,
            Family::Point => 0.75,
        }
    }
}
