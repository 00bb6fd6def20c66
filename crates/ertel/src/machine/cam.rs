//! Figures of a cam over a turn.
//!
//! ```text
//!   P = (1/2π) ∮ p b dθ,  p = µ w |u_2 − u_1| + f |u_m|     p: friction power per length of the solved contacts (W/m)
//!   M = P/ω
//!   T = F ds/dθ                                             torque of the force F along the follower's motion, without friction
//! ```
//!
//! Where no film is solved because the entrainment reverses, µ and f are those between the neighbours: such moments are short, and loads and
//! sliding go on. Where contact is lost there is no friction.

use std::f64::consts::TAU;

use ertel_machines::cam::CamPoint;

use super::curve::Curve;
use super::{MachineFigure, Section, figure_of, of_model};
use crate::case::CamMechanics;
use crate::point::MachineSolution;
use crate::solution::{Estimate, Figure};

/// The figures of a cam.
pub(super) fn figures(cam: &CamMechanics, solved: &MachineSolution) -> Vec<MachineFigure> {
    let mut figures = mechanics(cam);
    figures.extend(thinnest(cam, solved));
    figures.extend(friction(cam, solved).into_iter().flatten());
    figures
}

/// Pressure and torque.
fn mechanics(cam: &CamMechanics) -> Vec<MachineFigure> {
    let figure = |name, words, value, unit| MachineFigure {
        name,
        words,
        estimate: of_model(value),
        unit,
        section: Section::Mechanics,
        source: "",
    };
    let mut figures = Vec::new();
    // A hair more, so that of equal ones the first is taken.
    let is_higher = |a: &CamPoint, b: &CamPoint| a.hertz_pressure > b.hertz_pressure * (1.0 + 1e-9);
    let highest = (cam.points.iter()).reduce(|best, point| match is_higher(point, best) {
        true => point,
        false => best,
    });
    if let Some(highest) = highest {
        let bar = (cam.cam.bars(&cam.operation, highest.angle)).hertz_pressure;
        let mut pressure = figure(
            "hertz_pressure_maximum",
            "largest Hertz pressure",
            highest.hertz_pressure,
            "Pa",
        );
        // Of a table of lifts, by its digits.
        pressure.estimate.error = (bar > 0.0).then_some(bar);
        figures.push(pressure);
        figures.push(figure(
            "hertz_pressure_maximum_angle",
            "at the angle of the cam",
            highest.angle,
            "rad",
        ));
    }
    let angles = cam.points.iter().map(|point| point.pressure_angle.abs());
    figures.push(figure(
        "pressure_angle_maximum",
        "largest pressure angle",
        angles.fold(0.0, f64::max),
        "rad",
    ));
    let torque = |point: &CamPoint| point.force.max(0.0) * point.lift_velocity;
    let torques = cam.points.iter().map(|point| torque(point).abs());
    figures.push(MachineFigure {
        source: "T = F ds/dθ, without friction; over a turn it cancels",
        ..figure(
            "torque_maximum",
            "largest torque of the follower's force",
            torques.fold(0.0, f64::max),
            "N m",
        )
    });
    figures
}

/// Where the film is thinnest.
fn thinnest(cam: &CamMechanics, solved: &MachineSolution) -> Option<MachineFigure> {
    let i = super::thinnest(solved)?;
    Some(MachineFigure {
        name: "film_minimum_angle",
        words: "smallest film at the angle of the cam",
        estimate: of_model(cam.points[i].angle),
        unit: "rad",
        section: Section::Films,
        source: "films are steady ones: where the entrainment nearly vanishes, squeeze leaves more",
    })
}

/// Friction over a turn, where all contacts are solved.
fn friction(cam: &CamMechanics, solved: &MachineSolution) -> Option<[MachineFigure; 2]> {
    let mut coefficient = Vec::new();
    let mut resistance = Vec::new();
    for (i, at) in cam.points.iter().enumerate() {
        if solved.machine.contacts[i].like.is_none() {
            continue;
        }
        let point = solved.of(i)?;
        let mu = figure_of(point, Figure::TractionCoefficient)?;
        let power = figure_of(point, Figure::FrictionPower)?;
        let slide = at.load_per_length * at.sliding_speed.abs();
        let speed = at.entrainment_speed.abs();
        let mu = Estimate {
            value: mu.value.abs(),
            error: mu.error,
        };
        coefficient.push((at.angle, mu));
        let rolling = Estimate {
            value: (power.value - mu.value * slide) / speed,
            error: None,
        };
        resistance.push((at.angle, rolling));
    }
    let (coefficient, resistance) = (round(coefficient)?, round(resistance)?);
    let mean = |of: &dyn Fn(&CamPoint) -> f64| {
        let touching = cam.points.iter().filter(|point| !point.contact_lost);
        touching.map(of).sum::<f64>() * cam.operation.width / cam.points.len() as f64
    };
    let slide = |point: &CamPoint| point.load_per_length * point.sliding_speed.abs();
    let value = mean(&|point| {
        coefficient.at(point.angle) * slide(point)
            + resistance.at(point.angle) * point.entrainment_speed.abs()
    });
    let bar = mean(&|point| coefficient.bar_at(point.angle) * slide(point));
    let power = Estimate {
        value,
        error: coefficient.has_bars().then_some(bar),
    };
    let speed = cam.operation.speed.abs();
    let figure = |name, words, estimate, unit, source| MachineFigure {
        name,
        words,
        estimate,
        unit,
        section: Section::Friction,
        source,
    };
    Some([
        figure(
            "friction_power",
            "mean power lost over a turn",
            power,
            "W",
            "where the entrainment reverses, the friction of the neighbours",
        ),
        figure(
            "friction_torque",
            "mean friction torque",
            Estimate {
                value: power.value / speed,
                error: power.error.map(|error| error / speed),
            },
            "N m",
            "",
        ),
    ])
}

/// A curve that goes round: the last point before the first, and the first behind the last.
fn round(mut points: Vec<(f64, Estimate)>) -> Option<Curve> {
    let (first, last) = (*points.first()?, *points.last()?);
    points.insert(0, (last.0 - TAU, last.1));
    points.push((first.0 + TAU, first.1));
    Curve::new(points)
}
