//! Equation for the distance of the bodies: from the load, from the motion of a body, or prescribed.
//!
//! ```text
//!   massless:  ∫P = w̄ ∫P_r                body:  M A + C V + K (H_0 − H_0(0)) = ∫P − w̄ ∫P_r,   V = D H_0, A = D V        given:  H_0 = H_0(0) − z(T)
//! ```
//! D is the derivative in time of the film's steps ([`super::scheme`]). The spring is unloaded at the start.

use std::collections::VecDeque;

use super::Course;
use super::scheme::Weights;
use crate::volumes::system::Balance;

/// The equation for the distance of the bodies.
#[derive(Clone, Debug, PartialEq)]
pub enum Approach {
    /// The film carries the load at each instant.
    Massless,
    /// One of the bodies moves towards the other by its inertia.
    Body(Mover),
    /// The approach z since the start, in a²/R.
    Given(Course),
}

/// A body of some mass with spring and damper, over the load of reference.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Mover {
    /// M: mass times a²/R (u_r/a)² over the load of reference.
    pub mass: f64,
    /// C: damping times a²/R u_r/a over it.
    pub damping: f64,
    /// K: stiffness times a²/R over it.
    pub stiffness: f64,
}

/// The initial state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Start {
    /// The steady contact of the conditions at T = 0, at rest along the normal.
    Steady,
    /// Bodies that do not touch, without pressure between them.
    Apart {
        /// H between them at the centre.
        gap: f64,
        /// −∂H_0/∂T: the velocity of approach.
        velocity: f64,
    },
}

impl Start {
    /// ∂H_0/∂T at T = 0.
    pub fn velocity(&self) -> f64 {
        match self {
            Start::Steady => 0.0,
            Start::Apart { velocity, .. } => -velocity,
        }
    }
}

/// H_0 of a grid over time.
#[derive(Clone, Debug)]
pub struct Separations {
    /// H_0(0).
    origin: f64,
    /// H_0 at the instants that count, the newest first.
    places: VecDeque<f64>,
    /// V there.
    velocities: VecDeque<f64>,
}

impl Separations {
    /// At the start.
    pub fn new(origin: f64, velocity: f64) -> Separations {
        Separations {
            origin,
            places: VecDeque::from([origin]),
            velocities: VecDeque::from([velocity]),
        }
    }

    /// H_0(0), and H_0 and V at the instants that count.
    pub(super) fn memory(&self) -> (f64, [Vec<f64>; 2]) {
        let all = [&self.places, &self.velocities];
        (
            self.origin,
            all.map(|values| values.iter().copied().collect()),
        )
    }

    /// From these.
    pub(super) fn remembered(origin: f64, values: [&Vec<f64>; 2]) -> Separations {
        let [places, velocities] = values.map(|values| values.iter().copied().collect());
        Separations {
            origin,
            places,
            velocities,
        }
    }

    /// The load that the pressures balance at the end of a step to an instant; `unit` is ∫P_r.
    pub fn balance(&self, approach: &Approach, weights: &Weights, time: f64, unit: f64) -> Balance {
        match approach {
            Approach::Massless => Balance::LOAD,
            Approach::Given(course) => Balance {
                load: 0.0,
                separation: 1.0,
                given: course.at(time) - course.at(0.0) - self.origin,
            },
            Approach::Body(Mover {
                mass,
                damping,
                stiffness,
            }) => {
                let (rate, [place, velocity]) = (weights.rate(), self.past(weights));
                // ∂(M A + C V + K H_0)/∂H_0, and the contribution of earlier instants.
                let stiff = unit * (mass * rate * rate + damping * rate + stiffness);
                let rest = unit
                    * (mass * (rate * place + velocity) + damping * place
                        - stiffness * self.origin);
                // In heights of the film, as the rows of the nodes.
                let share = 1.0 / (1.0 + stiff);
                Balance {
                    load: share,
                    separation: share * stiff,
                    given: share * rest,
                }
            }
        }
    }

    /// Σ c_k of the instants before, of H_0 and of V.
    fn past(&self, weights: &Weights) -> [f64; 2] {
        [&self.places, &self.velocities].map(|values| weights.past_of(values.iter().copied()))
    }

    /// V at the end of a step that leads to H_0.
    pub fn velocity(&self, weights: &Weights, separation: f64) -> f64 {
        weights.rate() * separation + self.past(weights)[0]
    }

    /// Advances to the end of a step.
    pub fn accept(&mut self, separation: f64, velocity: f64, memory: usize) {
        for (values, newest) in [
            (&mut self.places, separation),
            (&mut self.velocities, velocity),
        ] {
            values.push_front(newest);
            values.truncate(memory);
        }
    }

    /// Forgets the instants before the newest one.
    pub fn forget(&mut self) {
        self.places.truncate(1);
        self.velocities.truncate(1);
    }

    /// Approach of the bodies since the start, and its velocity.
    pub fn approached(&self) -> [f64; 2] {
        [self.origin - self.places[0], -self.velocities[0]]
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// A mass on a spring and a damper without film (∫P = 0) under a constant load from its rest: x'' + 2ζx' + x = −w has the closed form
    /// x = −w (1 − e^(−ζT)(cos ωT + ζ/ω sin ωT)), ω = √(1 − ζ²). Halving the steps divides the error by four.
    #[test]
    fn a_damped_mass_follows_its_closed_form() {
        let (zeta, load, unit, origin) = (0.2_f64, 0.7, 1.3, 5.0);
        let mover = Approach::Body(Mover {
            mass: 1.0,
            damping: 2.0 * zeta,
            stiffness: 1.0,
        });
        let omega = (1.0 - zeta * zeta).sqrt();
        let exact = |t: f64| {
            let swing = (omega * t).cos() + zeta / omega * (omega * t).sin();
            origin - load * (1.0 - (-zeta * t).exp() * swing)
        };
        let error = |n: usize| {
            let step = 4.0 / n as f64;
            let mut own = Separations::new(origin, 0.0);
            let mut times = vec![0.0];
            for i in 1..=n {
                times.insert(0, step * i as f64);
                times.truncate(4);
                let weights = Weights::new(&times);
                let balance = own.balance(&mover, &weights, times[0], unit);
                // load (w ∫P_r − 0) + separation H_0 + given = 0
                let separation = -(balance.load * load * unit + balance.given) / balance.separation;
                own.accept(separation, own.velocity(&weights, separation), 3);
            }
            let [near, _] = own.approached();
            (origin - near - exact(4.0)).abs()
        };
        let [coarse, fine] = [200, 400].map(error);
        let order = (coarse / fine).log2();
        assert!((1.8..2.3).contains(&order), "{order}: {coarse} {fine}");
        assert!(fine < 1e-3 * load, "{fine}");
    }

    /// Bodies that approach each other at 0.3, −∂H_0/∂T, have come nearer by nothing at first, and after a step to 1.9 by 0.1.
    #[test]
    fn approach_and_its_velocity() {
        let start = Start::Apart {
            gap: 2.0,
            velocity: 0.3,
        };
        let mut own = Separations::new(2.0, start.velocity());
        assert_eq!(own.approached(), [0.0, 0.3]);
        let velocity = own.velocity(&Weights::new(&[0.5, 0.0]), 1.9);
        own.accept(1.9, velocity, 3);
        assert_relative_eq!(own.approached()[0], 0.1, max_relative = 1e-9);
        assert_relative_eq!(own.approached()[1], 0.2, max_relative = 1e-9);
    }

    /// A given course moves the bodies from where they were.
    #[test]
    fn a_given_course_counts_from_the_start() {
        let own = Separations::new(2.0, 0.0);
        let course = Approach::Given(Course::Table(vec![[0.0, 0.5], [1.0, 1.5]]));
        let balance = own.balance(&course, &Weights::new(&[0.5, 0.0]), 0.5, 1.0);
        assert_relative_eq!(-balance.given / balance.separation, 1.5);
        assert_eq!(balance.load, 0.0);
    }
}
