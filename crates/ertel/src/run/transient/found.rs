//! Results of a transient case, SI.

use serde::{Deserialize, Serialize};

use super::fields::InstantFields;
use crate::solution::{Estimate, Figure, Measured};
use crate::transient::{Info, TransientError};
use crate::warning::Warning;

/// A contact at an instant, SI.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct InstantSolution {
    /// Time, s.
    pub time: f64,
    /// Speeds of body 1 and body 2 along the motion, m/s.
    pub speeds: [f64; 2],
    /// Angular velocities of both bodies about the contact normal, rad/s.
    pub spin: [f64; 2],
    /// Load, N; N/m for line contacts.
    pub load: f64,
    /// Radius along the motion, m.
    pub radius: f64,
    /// Temperature of bodies and oil, K.
    pub temperature: f64,
    /// Oil layer thickness at the edge of the contact area, m; `None` if flooded.
    pub oil_layer: Option<f64>,
    /// Approach of the bodies since t = 0, m.
    pub approach: f64,
    /// Its rate, m/s; negative while they separate.
    pub approach_velocity: f64,
    /// Film force, N; N/m for line contacts.
    pub film_force: f64,
    /// Figures with error bars: the grid error at this instant and the time-step tolerance.
    pub measured: Measured,
    /// Length of the preceding step, s; 0 at the start.
    pub step: f64,
    /// Newton iterations of that step on all grids.
    pub newton_iterations: usize,
    /// Mass gained or lost by the film, relative to the flow through the centre at the largest entrainment speed.
    pub mass_error: f64,
}

/// The centreline at an instant, SI.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct InstantProfile {
    /// Time, s.
    pub time: f64,
    /// Positions along the motion, m.
    pub x: Vec<f64>,
    /// Pressure there, Pa.
    pub pressure: Vec<f64>,
    /// Film thickness there, m.
    pub film: Vec<f64>,
}

/// Film and pressure on the centreline around the contact at all instants.
#[derive(Clone, Debug, Default, Deserialize, Serialize)]
pub struct FilmMap {
    /// Positions along the motion, m.
    pub x: Vec<f64>,
    /// Film thickness there, m, for each instant.
    pub films: Vec<Vec<f32>>,
    /// Pressure there, Pa, for each instant.
    pub pressures: Vec<Vec<f32>>,
}

/// Results of a transient case.
#[derive(Debug)]
pub struct TransientSolution {
    /// Instants from the start.
    pub instants: Vec<InstantSolution>,
    /// Centrelines at the output times.
    pub profiles: Vec<InstantProfile>,
    /// Pressure and film on and off the centreline at the same times.
    pub fields: InstantFields,
    /// Film and pressure over position and time.
    pub map: FilmMap,
    /// A_d/A_i at each instant: the amplitude of the central film relative to that of the passing waves. `None` before a whole wave has passed; empty without waves
    /// or with other reliefs.
    pub amplitude_ratios: Vec<Option<f64>>,
    /// Half-width of the dry contact under the largest load, m.
    pub half_width: f64,
    /// Solver statistics.
    pub info: Info,
    /// Reason of an early end.
    pub failure: Option<TransientError>,
    /// Warnings.
    pub warnings: Vec<Warning>,
    /// Wall time, s.
    pub wall_seconds: f64,
}

impl TransientSolution {
    /// Whether the film force can differ from the load: a body moves by inertia, or its approach is prescribed.
    pub fn moves(&self) -> bool {
        let differs = |i: &InstantSolution| (i.film_force - i.load).abs() > 1e-2 * i.load;
        self.instants.iter().any(differs)
    }

    /// Coefficient of restitution of a body that fell on the film and has left it: the ratio of rebound to impact velocity. The film force is
    /// known as well as the central pressure: the bar sums, over the velocity changes, the relative error of this pressure.
    pub fn restitution(&self) -> Option<Estimate> {
        let (first, last) = (self.instants.first()?, self.instants.last()?);
        let largest = self
            .instants
            .iter()
            .fold(0.0_f64, |m, i| m.max(i.film_force));
        let has_left = last.film_force < NO_FORCE * largest && last.approach_velocity < 0.0;
        let fell = first.film_force == 0.0 && first.approach_velocity > 0.0;
        let unknown = |pair: &[InstantSolution]| {
            let change = (pair[1].approach_velocity - pair[0].approach_velocity).abs();
            let pressure = pair[1].measured.estimate(Figure::PressureCentral);
            let share = match pressure.error {
                Some(error) if error < pressure.value => error / pressure.value,
                _ => 1.0,
            };
            change * share
        };
        let error: f64 = self.instants.windows(2).map(unknown).sum();
        (fell && has_left).then(|| Estimate {
            value: -last.approach_velocity / first.approach_velocity,
            error: Some(error / first.approach_velocity),
        })
    }
}

/// Fraction of the largest impact force below which a body has left the film.
const NO_FORCE: f64 = 1e-4;
