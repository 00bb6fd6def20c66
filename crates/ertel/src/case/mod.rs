//! Case files: what to solve, read from TOML into SI.
//!
//! ```toml
//! title = "Steel ball on steel disc"
//!
//! [contact]
//! kind = "circular"                 # or "line"; the load is then per length, "50 kN/m"
//! radius = "16 mm"                  # reduced radius of curvature
//! load = "100 N"                    # or hertz_pressure = "1 GPa"
//!
//! [bodies]                          # a name from the solids database, or a table
//! plane = "steel"
//! ball = { youngs_modulus = "210 GPa", poissons_ratio = 0.3 }
//!
//! [motion]                          # or ball_speed and plane_speed
//! entrainment_speed = "0.8 m/s"     # (u_ball + u_plane)/2
//! slide_to_roll_ratio = 0.0         # (u_ball - u_plane)/entrainment speed
//!
//! [lubricant]                       # name = "..." takes a fluid from the database
//! temperature = "40 degC"
//! density = { law = "dowson-higginson", rho_0 = "870 kg/m^3" }
//! viscosity = { law = "roelands", mu_0 = "40 mPa.s", alpha = "22 1/GPa" }
//! ```
//!
//! `lubricant = "squalane-pip"` with a top-level `temperature = "40 degC"` is short for a `[lubricant]`
//! table with `name` and `temperature`. `[mesh]`, `[solver]` and `[output]` are optional; everything
//! physical is required. Numbers carry units. Unknown keys are errors.

mod bodies;
mod echo;
mod lubricant;

use crate::contact::{Contact, Hertz, Motion, reduced_modulus};
use crate::params::{MeshParams, OutputParams, SolverParams};

pub use bodies::Body;
pub use lubricant::Lubricant;

/// Everything a solve needs, in SI.
#[derive(Clone, Debug)]
pub struct Case {
    /// Title for pictures and reports; empty if the file gives none.
    pub title: String,
    /// Shape, radius and load.
    pub contact: Contact,
    /// The plane (or disc).
    pub plane: Body,
    /// The ball (or cylinder).
    pub ball: Body,
    /// Speeds.
    pub motion: Motion,
    /// Lubricant and its temperature.
    pub lubricant: Lubricant,
    /// Mesh and elements.
    pub mesh: MeshParams,
    /// Solver settings.
    pub solver: SolverParams,
    /// What is written.
    pub output: OutputParams,
    /// What the user should know about the input, one sentence each.
    pub warnings: Vec<String>,
    /// The case file as read, kept with the results; empty for a case made in code.
    pub source: String,
    /// Its keys and values as given, quantities with their units; null for a case made in code.
    pub given: serde_json::Value,
}

impl Case {
    /// Reduced modulus E' of both bodies, Pa.
    pub fn reduced_modulus(&self) -> f64 {
        reduced_modulus(self.plane.elasticity, self.ball.elasticity)
    }

    /// The dry contact.
    pub fn hertz(&self) -> Hertz {
        Hertz::new(&self.contact, self.reduced_modulus())
    }
}
