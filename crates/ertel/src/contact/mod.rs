//! The dry contact: geometry, Hertz theory, dimensionless groups and scales.

pub mod equivalent;
pub mod groups;
pub mod hertz;
pub mod scales;

pub use equivalent::EquivalentBody;
pub use groups::Groups;
pub use hertz::Hertz;
pub use scales::Scales;

use serde::Serialize;

/// Shape of the contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ContactKind {
    /// Infinitely long cylinder on a plane (plane strain); loads are per length.
    Line,
    /// Ball on plane; the half domain y ≤ 0 is solved.
    Circular,
}

impl ContactKind {
    /// Dimension of the elastic body: 2 (plane strain) or 3.
    pub fn body_dimension(self) -> usize {
        match self {
            ContactKind::Line => 2,
            ContactKind::Circular => 3,
        }
    }

    /// The power k of Moes' load group, `M = W (2U)^(-k)`.
    pub fn moes_power(self) -> f64 {
        match self {
            ContactKind::Line => 0.5,
            ContactKind::Circular => 0.75,
        }
    }
}

/// A loaded contact of a ball (or cylinder) on a plane.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Contact {
    /// Line or circular.
    pub kind: ContactKind,
    /// Reduced radius of curvature R, m.
    pub radius: f64,
    /// Load: F in N (circular) or w in N/m (line).
    pub load: f64,
}

/// Motion of the two surfaces along x.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Motion {
    /// Entrainment speed u_m = (u_ball + u_plane)/2, m/s.
    pub entrainment_speed: f64,
    /// Slide-to-roll ratio (u_ball − u_plane)/u_m.
    pub slide_to_roll_ratio: f64,
}

impl Motion {
    /// Speed of the ball's surface, m/s.
    pub fn ball_speed(&self) -> f64 {
        self.entrainment_speed * (1.0 + 0.5 * self.slide_to_roll_ratio)
    }

    /// Speed of the plane's surface, m/s.
    pub fn plane_speed(&self) -> f64 {
        self.entrainment_speed * (1.0 - 0.5 * self.slide_to_roll_ratio)
    }
}

/// Elastic constants of one body.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Elasticity {
    /// Young's modulus E, Pa.
    pub youngs_modulus: f64,
    /// Poisson's ratio ν.
    pub poissons_ratio: f64,
}

/// Reduced modulus of two bodies, Pa: 2/E' = (1 − ν_p²)/E_p + (1 − ν_s²)/E_s.
///
/// Source: Habchi 2008, eq. 2.27 (as corrected in `docs/theory`).
pub fn reduced_modulus(plane: Elasticity, ball: Elasticity) -> f64 {
    let compliance = |b: Elasticity| (1.0 - b.poissons_ratio * b.poissons_ratio) / b.youngs_modulus;
    2.0 / (compliance(plane) + compliance(ball))
}
