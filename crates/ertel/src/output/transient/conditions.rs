//! Conditions of the instants of a transient case, as documents and tables have them.

use crate::run::transient::InstantSolution;

/// A condition at an instant.
pub(super) struct Condition {
    /// Name in documents and tables.
    pub name: &'static str,
    /// SI units in point and line contacts.
    unit: [&'static str; 2],
    /// Description.
    pub words: &'static str,
    /// Its value, SI.
    pub value: fn(&InstantSolution) -> Option<f64>,
}

impl Condition {
    /// Its SI unit.
    pub fn unit(&self, is_line: bool) -> &'static str {
        self.unit[usize::from(is_line)]
    }
}

const fn condition(
    name: &'static str,
    unit: &'static str,
    words: &'static str,
    value: fn(&InstantSolution) -> Option<f64>,
) -> Condition {
    Condition {
        name,
        unit: [unit; 2],
        words,
        value,
    }
}

const fn force(
    name: &'static str,
    words: &'static str,
    value: fn(&InstantSolution) -> Option<f64>,
) -> Condition {
    Condition {
        name,
        unit: ["N", "N/m"],
        words,
        value,
    }
}

/// All conditions, in their order.
pub(super) const CONDITIONS: [Condition; 12] = [
    condition("entrainment_speed", "m/s", "entrainment speed", |i| {
        Some(0.5 * (i.speeds[0] + i.speeds[1]))
    }),
    condition("body_1_speed", "m/s", "speed of body 1", |i| {
        Some(i.speeds[0])
    }),
    condition("body_2_speed", "m/s", "speed of body 2", |i| {
        Some(i.speeds[1])
    }),
    condition("body_1_spin", "rad/s", "spin of body 1", |i| {
        Some(i.spin[0])
    }),
    condition("body_2_spin", "rad/s", "spin of body 2", |i| {
        Some(i.spin[1])
    }),
    force("load", "load", |i| Some(i.load)),
    condition("radius", "m", "radius along the motion", |i| Some(i.radius)),
    condition("temperature", "K", "temperature of bodies and oil", |i| {
        Some(i.temperature)
    }),
    condition("oil_layer", "m", "layer of oil at the inlet edge", |i| {
        i.oil_layer
    }),
    condition("approach", "m", "approach of the bodies", |i| {
        Some(i.approach)
    }),
    condition("approach_velocity", "m/s", "its rate", |i| {
        Some(i.approach_velocity)
    }),
    force("film_force", "force of the film", |i| Some(i.film_force)),
];
