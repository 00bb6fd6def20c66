//! Rolling bearings: geometry, load distribution, speeds, rating lives and friction models, in SI.
//!
//! A [`Bearing`] under [`Loads`](load::Loads) at [`Speeds`] is solved for the load of each element on each ring. The results
//! per contact are load, angle, radii, speeds, spin and the Hertz ellipse, from which a lubricated contact can be set up.
//!
//! ```
//! use ertel_machines::bearing::geometry::Ring;
//! use ertel_machines::bearing::kinematics::Speeds;
//! use ertel_machines::bearing::load::{Loads, Params};
//! use ertel_machines::bearing::{Bearing, catalogue};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let geometry = catalogue::find("6206-2RS/C3")?.geometry();
//! let speeds = Speeds { inner: 150.0, outer: 0.0 };
//! let solved = Bearing::steel(geometry).solve(&Loads::forces(2000.0, 500.0), speeds, &Params::default())?;
//! let heaviest = solved.heaviest(Ring::Inner).expect("nine balls");
//! assert!(heaviest.pressure > 1e9 && heaviest.entrainment_speed > 1.0);
//! # Ok(())
//! # }
//! ```
//!
//! Axes: z along the bearing, x and y radial; elements at ψ from x towards y. Forces and shifts are those of the inner ring against the
//! outer.
//!
//! Sources: ISO/TS 16281 and ISO 281 for load distribution and life, as public implementations and textbooks quote them; Harris and Kotzalas,
//! Rolling Bearing Analysis, 5th ed., 2007 (Essential Concepts; Advanced Concepts) for geometry, speeds and equilibrium at speed; Jones, J.
//! Basic Eng. 81 (1959) 1-12 and 82 (1960) 309-320 for balls that spin. Each file names its own.

pub mod catalogue;
pub mod friction;
pub mod geometry;
pub mod kinematics;
pub mod life;
pub mod load;
#[cfg(test)]
mod test_data;

use geometry::{BallGeometry, GeometryError, Ring, RollerGeometry, TaperedGeometry};
use kinematics::Speeds;

/// Material of rings and elements.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Reduced modulus E' of ring and element, Pa: 2/E' = Σ (1 − ν²)/E.
    pub reduced_modulus: f64,
    /// Density of the elements, kg/m³.
    pub density: f64,
}

impl Material {
    /// Bearing steel on bearing steel as bearing standards take it: E = 206 GPa, ν = 0.3, 7850 kg/m³.
    pub const STEEL: Material = Material {
        reduced_modulus: 206e9 / (1.0 - 0.3 * 0.3),
        density: 7850.0,
    };
}

/// Internal geometry of one of the kinds of bearings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Geometry {
    /// Deep groove and angular contact ball bearings.
    Ball(BallGeometry),
    /// Cylindrical roller bearings.
    CylindricalRoller(RollerGeometry),
    /// Tapered roller bearings.
    TaperedRoller(TaperedGeometry),
}

impl Geometry {
    /// Whether such a bearing can exist.
    ///
    /// # Errors
    /// Lengths, ratios or angles out of range.
    pub fn check(&self) -> Result<(), GeometryError> {
        match self {
            Geometry::Ball(ball) => ball.check(),
            Geometry::CylindricalRoller(roller) => roller.check(),
            Geometry::TaperedRoller(roller) => roller.check(),
        }
    }

    /// Number of elements Z.
    pub fn number(&self) -> usize {
        match self {
            Geometry::Ball(ball) => ball.number,
            Geometry::CylindricalRoller(roller) => roller.number,
            Geometry::TaperedRoller(roller) => roller.number,
        }
    }

    /// Pitch diameter d_m, m.
    pub fn pitch_diameter(&self) -> f64 {
        match self {
            Geometry::Ball(ball) => ball.pitch_diameter,
            Geometry::CylindricalRoller(roller) => roller.pitch_diameter,
            Geometry::TaperedRoller(roller) => roller.pitch_diameter,
        }
    }

    /// Diameter of the elements D, m.
    pub fn element_diameter(&self) -> f64 {
        match self {
            Geometry::Ball(ball) => ball.ball_diameter,
            Geometry::CylindricalRoller(roller) => roller.roller_diameter,
            Geometry::TaperedRoller(roller) => roller.roller_diameter,
        }
    }

    /// Centrifugal force of an element of some density (kg/m³) on its orbit at the contact angle without load, N.
    ///
    /// F_c = m d_m ω_m²/2,  ω_m = [ω_i (1 − γ) + ω_o (1 + γ)]/2
    pub fn centrifugal_force(&self, density: f64, speeds: Speeds) -> f64 {
        let (diameter, pitch) = (self.element_diameter(), self.pitch_diameter());
        let mass = match self {
            Geometry::Ball(ball) => ball.mass(density),
            Geometry::CylindricalRoller(roller) => roller.mass(density),
            Geometry::TaperedRoller(roller) => roller.mass(density),
        };
        let gamma = diameter * self.free_angle().cos() / pitch;
        let orbit = 0.5 * (speeds.inner * (1.0 - gamma) + speeds.outer * (1.0 + gamma));
        0.5 * mass * pitch * orbit * orbit
    }

    /// Free contact angle, rad: 0 of cylindrical rollers, that of the cup of tapered ones. Ratings use the nominal one, which is 0 of deep
    /// groove ball bearings.
    pub fn free_angle(&self) -> f64 {
        match self {
            Geometry::Ball(ball) => ball.free_angle(),
            Geometry::CylindricalRoller(_) => 0.0,
            Geometry::TaperedRoller(roller) => roller.angle(Ring::Outer),
        }
    }
}

/// A bearing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bearing {
    /// Its internal geometry.
    pub geometry: Geometry,
    /// Its material.
    pub material: Material,
}

impl Bearing {
    /// Of steel.
    pub fn steel(geometry: Geometry) -> Bearing {
        Bearing {
            geometry,
            material: Material::STEEL,
        }
    }
}
