//! Boundary dimensions of bearings.

/// Boundary dimensions, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Boundary {
    /// Bore d.
    pub bore: f64,
    /// Outside diameter D.
    pub outside: f64,
    /// Width B; of tapered roller bearings that of the cone.
    pub width: f64,
    /// Dimensions that only some kinds have.
    pub special: Special,
}

/// Dimensions that only some kinds of bearings have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Special {
    /// None: ball bearings.
    None,
    /// Diameters of the raceways of cylindrical roller bearings, m.
    Raceways {
        /// F, of the inner ring.
        inner: f64,
        /// E, of the outer ring.
        outer: f64,
    },
    /// Of tapered roller bearings.
    Taper {
        /// Width of the cup C, m.
        cup_width: f64,
        /// Width of the whole bearing T, m.
        width: f64,
        /// Contact angle α, rad: half of the cup's angle.
        contact_angle: f64,
    },
}

impl Boundary {
    /// Mean diameter (d + D)/2, m.
    pub fn mean_diameter(&self) -> f64 {
        0.5 * (self.bore + self.outside)
    }
}
