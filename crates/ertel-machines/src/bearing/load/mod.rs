//! How the elements of a bearing share its load, after ISO/TS 16281, with forces of inertia.
//!
//! Rings are rigid and round. The inner ring moves by δ_x, δ_y, δ_z and tilts by θ_x, θ_y against the outer; at an element at ψ, its groove
//! moves by
//! ```text
//!   δ_r = δ_x cos ψ + δ_y sin ψ,   δ_a = δ_z + ℛ (θ_x sin ψ − θ_y cos ψ)
//! ```
//! and loads and moments follow from the elements' by virtual work.
//!
//! Source: ISO/TS 16281 (as MESYS's manual and public implementations quote it); Harris and Kotzalas 2007, Advanced Concepts, chapters 1
//! and 3.

mod ball;
mod ball_row;
mod newton;
mod roller;
mod roller_row;
mod solve;
#[cfg(test)]
mod tests;

use ertel_ehl::contact::{Contact, Curvatures};

use super::geometry::{GeometryError, Ring};
use super::kinematics::RacewayControl;

/// One degree of freedom of the inner ring against the outer: the load is given, or the shift.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Given {
    /// Force, N, or moment, N·m; the shift follows.
    Load(f64),
    /// Shift, m, or tilt, rad; the load follows.
    Shift(f64),
}

/// Loads on the inner ring, or its prescribed displacements.
///
/// Axial shifts are counted from the position where the balls touch at the free contact angle, so that a preload is an axial shift.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Loads {
    /// Along x and y.
    pub radial: [Given; 2],
    /// Along the bearing.
    pub axial: Given,
    /// About x and y.
    pub tilt: [Given; 2],
}

impl Loads {
    /// A radial load along x and an axial load, N, of rings that do not tilt.
    pub fn forces(radial: f64, axial: f64) -> Loads {
        Loads {
            radial: [Given::Load(radial), Given::Load(0.0)],
            axial: Given::Load(axial),
            tilt: [Given::Shift(0.0); 2],
        }
    }

    pub(crate) fn all(&self) -> [Given; 5] {
        [
            self.radial[0],
            self.radial[1],
            self.axial,
            self.tilt[0],
            self.tilt[1],
        ]
    }
}

/// At which angle the curvatures of ball and raceway are taken for the stiffness of their contact.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum CurvatureAngle {
    /// The angle under load, ball by ball.
    #[default]
    Loaded,
    /// The free contact angle, as in ISO/TS 16281: one constant for the whole bearing.
    Free,
}

/// How the equations are solved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Params {
    /// Where the stiffness of a ball's contacts is taken.
    pub curvature_angle: CurvatureAngle,
    /// Which raceway controls the balls: decides spin and speeds. Forces of inertia are always those of outer control, since they count
    /// only at speeds where it rules.
    pub control: RacewayControl,
    /// Whether the gyroscopic moment acts on balls. Where they find no balance with it, as light ones between rings that turn against each other
    /// may not, it is left out of all of them.
    pub gyroscopic_moment: bool,
    /// Slices of a roller; 30 at least.
    pub slices: usize,
    /// Angle of the first element, rad.
    pub first_element: f64,
    /// Largest unbalanced force over the largest force in the bearing.
    pub tolerance: f64,
    /// Most Newton steps.
    pub iterations: usize,
}

impl Default for Params {
    fn default() -> Params {
        Params {
            curvature_angle: CurvatureAngle::Loaded,
            control: RacewayControl::Outer,
            gyroscopic_moment: true,
            slices: 41,
            first_element: 0.0,
            tolerance: 1e-9,
            iterations: 60,
        }
    }
}

/// How the solution was found.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Info {
    /// Newton's steps.
    pub iterations: usize,
    /// Force out of balance over the largest force in the bearing.
    pub residual: f64,
    /// Whether the gyroscopic moment had to be left out: the balls slip about the tangent of their orbit then.
    pub gyroscopic_slip: bool,
}

/// Why there is no load distribution.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Error {
    /// The geometry makes no bearing.
    #[error(transparent)]
    Geometry(#[from] GeometryError),
    /// A number that is none, or a parameter out of range.
    #[error("{name} is {value}, which is out of range")]
    Value {
        /// Which one.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// Nothing presses the rings together.
    #[error(
        "no element carries load: the bearing is not loaded, or its shifts lie within the clearance"
    )]
    Unloaded,
    /// Cylindrical rollers between plain raceways carry no axial load.
    #[error(
        "a cylindrical roller bearing carries no axial load here, but {0} N are given: ribs are not part of the model"
    )]
    AxialLoad(f64),
    /// Nothing holds the rings of a tapered roller bearing together.
    #[error(
        "a tapered roller bearing needs an axial load that presses its rings together, or a given axial shift: its axial load is {0} N"
    )]
    Separation(f64),
    /// Newton's method did not converge.
    #[error(
        "no equilibrium of the rings within {iterations} steps: unbalanced force {residual:.1e} of the largest force"
    )]
    NoConvergence {
        /// Steps done.
        iterations: usize,
        /// The remaining residual.
        residual: f64,
    },
    /// No equilibrium of a single element at speed.
    #[error("no equilibrium of the element at {degrees:.1} degrees at this speed")]
    Element {
        /// Where it is, degrees.
        degrees: f64,
    },
}

/// A slice of a roller in contact with a ring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slice {
    /// Its middle, along the bearing, m.
    pub position: f64,
    /// Load per length, N/m.
    pub line_load: f64,
    /// Largest pressure, Pa, of a line contact under that load per length.
    pub pressure: f64,
}

/// Contact of an element with a ring.
#[derive(Clone, Debug, PartialEq)]
pub struct RingContact {
    /// Which ring.
    pub ring: Ring,
    /// Normal load, N; 0 where they do not touch.
    pub load: f64,
    /// Contact angle, rad; that of the outer ring where a ball does not touch the inner one.
    pub angle: f64,
    /// Reduced radii along and across rolling, m; infinite across rollers.
    pub radii: [f64; 2],
    /// Curvatures of raceway and element themselves along and across rolling, 1/m.
    pub curvatures: [Curvatures; 2],
    /// Semi-axes of the Hertz ellipse along and across rolling, m; of a roller, the half-width under its mean load per length, and half of
    /// its length.
    pub semi_axes: [f64; 2],
    /// Largest Hertz pressure, Pa; of a roller, that of its most loaded slice.
    pub pressure: f64,
    /// Speed of both surfaces through the contact, m/s.
    pub entrainment_speed: f64,
    /// Spin of ring and element about the normal from ring to element, rad/s.
    pub spin: [f64; 2],
    /// Slices of rollers; none of balls.
    pub slices: Vec<Slice>,
    /// By how much a roller is tilted against the raceway, rad: it comes nearer towards larger positions of its slices; 0 of balls.
    pub tilt: f64,
}

impl RingContact {
    /// Load per length of the heaviest slice of a roller over its mean; `None` of balls, and where nothing presses.
    pub fn peak_slice(&self) -> Option<f64> {
        let loads = || self.slices.iter().map(|slice| slice.line_load);
        let sum: f64 = loads().sum();
        (sum > 0.0).then(|| loads().fold(0.0, f64::max) * self.slices.len() as f64 / sum)
    }

    /// The contact of a ball for a solver of lubricated contacts, body 1 the ring; `None` of rollers and where nothing touches.
    pub fn ellipse(&self) -> Option<Contact> {
        (self.slices.is_empty() && self.load > 0.0)
            .then(|| Contact::elliptical(self.radii, self.load, 0.0).between(self.curvatures))
    }
}

/// A ball or roller.
#[derive(Clone, Debug, PartialEq)]
pub struct Element {
    /// Where it is: ψ from x towards y, rad.
    pub position: f64,
    /// Its contacts with inner and outer ring.
    pub contacts: [RingContact; 2],
    /// Speed of its orbit ω_m, rad/s, of a cage that would follow this element.
    pub cage_speed: f64,
    /// Speed about its axis, seen from the cage, rad/s.
    pub own_speed: f64,
    /// Inclination β of its axis to that of the bearing, rad.
    pub attitude: f64,
    /// Centrifugal force, N.
    pub centrifugal_force: f64,
    /// Gyroscopic moment, N·m; 0 of rollers, whose raceways and ribs guide them.
    pub gyroscopic_moment: f64,
    /// Load on the rib of the inner ring, N, along the roller's axis; 0 of all but tapered rollers.
    pub rib_load: f64,
}

/// The solution.
#[derive(Clone, Debug, PartialEq)]
pub struct Distribution {
    /// All elements.
    pub elements: Vec<Element>,
    /// δ_x, δ_y, δ_z of the inner ring, m.
    pub shift: [f64; 3],
    /// θ_x, θ_y, rad.
    pub tilt: [f64; 2],
    /// Force on the inner ring along x, y, z that is in balance with the elements, N.
    pub force: [f64; 3],
    /// Moment about x and y likewise, N·m.
    pub moment: [f64; 2],
    /// Stiffness: change of forces and moments with shifts and tilts, in the order of both.
    pub stiffness: [[f64; 5]; 5],
    /// How it was found.
    pub info: Info,
}

impl Distribution {
    /// Forces (N) and moments (N·m) on the inner ring, in the order of [`Distribution::stiffness`].
    pub fn reaction(&self) -> [f64; 5] {
        let ([x, y, z], [a, b]) = (self.force, self.moment);
        [x, y, z, a, b]
    }

    /// Loads of all elements on a ring, N.
    pub fn loads(&self, ring: Ring) -> Vec<f64> {
        let contacts = self.elements.iter().map(|e| &e.contacts[ring.index()]);
        contacts.map(|contact| contact.load).collect()
    }

    /// Loads of all slices of all rollers on a ring, N; none of balls.
    pub fn slice_loads(&self, ring: Ring) -> Vec<Vec<f64>> {
        let contacts = self.elements.iter().map(|e| &e.contacts[ring.index()]);
        let loads = contacts.map(|contact| {
            let length = 2.0 * contact.semi_axes[1] / contact.slices.len().max(1) as f64;
            let slices = contact.slices.iter();
            slices.map(|slice| slice.line_load * length).collect()
        });
        loads.collect()
    }

    /// The contact under the largest load on a ring.
    pub fn heaviest(&self, ring: Ring) -> Option<&RingContact> {
        let contacts = self.elements.iter().map(|e| &e.contacts[ring.index()]);
        contacts.max_by(|a, b| a.load.total_cmp(&b.load))
    }
}
