//! The contact at an instant.

use super::body::{Approach, Start};
use super::conditions::Conditions;
use super::levels::Levels;
use super::{Course, TransientError};
use crate::contact::gap::{Body, Curvature, GapTerm};
use crate::contact::{Inlet, OilLayer, Pose};
use crate::engine::{Observer, Problem, SolveError};
use crate::film::FilmFluid;
use crate::volumes::{FiniteVolumes, Plan};

/// Sets the conditions of an instant in the problem; load and λ are the reference values at first.
pub(super) struct Present<'a> {
    pub conditions: &'a Conditions,
    /// ∫P_r.
    pub load: f64,
    lambda: f64,
    /// The fluid at the temperature of reference.
    fluid: FilmFluid,
    /// That temperature of the lubricant at the inlet, and those of both bodies, K; of a thermal contact.
    temperatures: Option<(f64, [f64; 2])>,
}

/// Speed over that of reference below which the film is at rest.
const REST: f64 = 1e-6;

/// Force over the load of reference below which the film bears none.
const NO_FORCE: f64 = 1e-9;

/// Lowest speed, over the reference speed, for whose steady film the grids are refined; below it, earlier films determine the film.
const SLOWEST: f64 = 0.1;

/// A speed, radius or oil layer below this share of its initial value needs new grids.
const REGRID_RATIO: f64 = 0.9;

/// The same of a temperature above that of the start, K.
const WARMER: f64 = 2.0;

impl<'a> Present<'a> {
    /// Of a problem in the reference scales, whose shape gets the terms that change.
    pub fn new(problem: &mut Problem<Plan>, conditions: &'a Conditions) -> Present<'a> {
        if conditions.radius != Course::Constant(1.0) {
            let ratio = problem.shape.gap.curvature_ratio;
            let curvature = Curvature { excess: 0.0, ratio };
            problem.shape.gap.terms.push(GapTerm::Curvature(curvature));
        }
        Present {
            conditions,
            load: problem.load,
            lambda: problem.scales.lambda,
            fluid: problem.fluid.clone(),
            temperatures: (problem.heat.as_ref()).map(|heat| {
                let bodies = heat.bodies.each_ref();
                (
                    heat.inlet_temperature,
                    bodies.map(|body| body.bulk_temperature),
                )
            }),
        }
    }

    /// Gives oil and bodies a temperature, K; bodies with a separate temperature keep their difference to the oil at the reference temperature.
    fn set_temperature(&self, problem: &mut Problem<Plan>, temperature: f64) {
        problem.fluid = problem.fluid.at_bulk(temperature);
        if let (Some(heat), Some((inlet, bodies))) = (&mut problem.heat, self.temperatures) {
            heat.inlet_temperature = temperature;
            for (body, own) in heat.bodies.iter_mut().zip(bodies) {
                body.bulk_temperature = temperature + own - inlet;
            }
        }
    }

    /// Refines grids for the thinnest steady film: under the largest load at the lowest speed, with the smallest radius, the thinnest layer and
    /// the warmest oil. Its pressures are not used.
    pub fn refine_for_thinnest(
        &self,
        problem: &mut Problem<Plan>,
        observer: &mut dyn Observer,
    ) -> Result<(), TransientError> {
        let conditions = self.conditions;
        let slowest = conditions.slowest().max(SLOWEST);
        let radius = conditions.least(&conditions.radius);
        let layer =
            (conditions.layer.as_ref()).map(|course| [course.at(0.0), conditions.least(course)]);
        let warmest = (conditions.temperature.as_ref())
            .map(|course| [course.at(0.0), course.largest(conditions.duration)]);
        if slowest > REGRID_RATIO * problem.entrainment.centre[0]
            && radius > REGRID_RATIO * conditions.radius.at(0.0)
            && layer.is_none_or(|[start, least]| least > REGRID_RATIO * start)
            && warmest.is_none_or(|[start, most]| most < start + WARMER)
        {
            return Ok(());
        }
        // Spin slows down with the bodies.
        let [speed, _] = problem.entrainment.centre;
        problem.entrainment = problem.entrainment.times(slowest / speed);
        problem.load = self.load;
        set_radius(problem, radius);
        if let Some([_, least]) = layer {
            self.set_layer(problem, least);
        }
        if let Some([_, most]) = warmest {
            self.set_temperature(problem, most);
        }
        match FiniteVolumes.solve(problem, observer) {
            Ok(found) => {
                let finest = found
                    .levels
                    .last()
                    .map(|level| level.system.grid.spacing[0]);
                let cell = &mut problem.plan.largest_cell;
                *cell = finest.map_or(*cell, |finest| cell.min(finest));
                Ok(())
            }
            Err(SolveError::Interrupted) => Err(TransientError::Interrupted),
            // The run may never reach such a steady state.
            Err(_) => Ok(()),
        }
    }

    /// The contact in the scales of the speed at the instant, so that figures in SI units are those of a steady contact at this speed; a film at rest keeps the reference scales.
    /// Friction coefficients refer to the force that the film carries.
    pub fn in_own_scales(&self, problem: &mut Problem<Plan>, levels: &Levels) {
        if self.conditions.approach != Approach::Massless || self.conditions.start != Start::Steady
        {
            let force = levels.force(problem.load);
            // No friction coefficient for a force that vanishes.
            problem.scales.load = if force > NO_FORCE * self.load {
                force
            } else {
                f64::NAN
            };
        }
        let [speed, _] = problem.entrainment.centre;
        if speed.abs() > REST {
            problem.scales.lambda *= speed.abs();
            problem.entrainment = problem.entrainment.times(1.0 / speed.abs());
        }
    }

    /// Sets the conditions at an instant, and the places of reliefs that have moved with their bodies.
    pub fn set(&self, problem: &mut Problem<Plan>, time: f64, moved: [Pose; 2]) {
        let [first, second] = self.conditions.velocities(time);
        problem.scales.lambda = self.lambda;
        problem.entrainment = first.plus(&second).times(0.5);
        let sliding = second.plus(&first.times(-1.0));
        problem.fluid = self.fluid.sliding_by(&sliding, &problem.scales);
        if let Some(course) = &self.conditions.temperature {
            self.set_temperature(problem, course.at(time));
        }
        if let Some(heat) = &mut problem.heat {
            for (body, velocity) in heat.bodies.iter_mut().zip([first, second]) {
                body.velocity = velocity.times(heat.entrainment_speed);
            }
        }
        set_radius(problem, self.conditions.radius.at(time));
        if let Some(course) = &self.conditions.layer {
            self.set_layer(problem, course.at(time));
        }
        problem.load = self.load * self.conditions.load.at(time);
        // The force that friction coefficients refer to.
        problem.scales.load = problem.load;
        for term in &mut problem.shape.gap.terms {
            if let GapTerm::Relief(relief) = term {
                relief.moved = match relief.body {
                    Body::First => moved[0],
                    Body::Second => moved[1],
                };
            }
        }
    }

    fn set_layer(&self, problem: &mut Problem<Plan>, thickness: f64) {
        let lambda = self.lambda;
        problem.shape.inlet = Inlet::Layer(OilLayer { thickness, lambda });
    }
}

/// Sets the radius of the gap, over the reference radius, where it changes.
fn set_radius(problem: &mut Problem<Plan>, radius: f64) {
    for term in &mut problem.shape.gap.terms {
        if let GapTerm::Curvature(curvature) = term {
            curvature.excess = 1.0 / radius - 1.0;
        }
    }
}
