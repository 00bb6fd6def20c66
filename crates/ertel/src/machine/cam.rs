//! Figures of a cam over a turn.
//!
//! ```text
//!   P = (1/2π) ∮ p b dθ,  p = µ w |u_2 − u_1| + p_r         p, p_r: power of friction and of rolling per length of the solved contacts (W/m)
//!   M = P/ω
//!   T = F ds/dθ                                             torque of the force F along the follower's motion, without friction
//! ```
//!
//! Where no film is solved because the entrainment reverses, µ and p_r are those between the neighbours: such moments are short, and loads and
//! sliding go on. Where contact is lost there is no friction.

use std::f64::consts::TAU;

use ertel_machines::cam::CamPoint;

use super::contacts::{figure_of, friction_of};
use super::curve::Curve;
use super::films::Films;
use crate::case::CamMechanics;
use crate::figures::Row;
use crate::figures::cam::{
    FILM_MINIMUM_ANGLE, FRICTION_POWER, FRICTION_TORQUE, HERTZ_PRESSURE_MAXIMUM_ANGLE,
    PRESSURE_ANGLE_MAXIMUM, TORQUE_MAXIMUM,
};
use crate::figures::machine::HERTZ_PRESSURE_MAXIMUM;
use crate::mark::{Mark, Marked, Marks};
use crate::point::MachineSolution;
use crate::solution::Figure;

/// Angles of a turn over which is summed: forces and speeds are known at each of them, µ and p_r are linear between the solved contacts.
const ANGLES: usize = 1440;

/// The figures of a cam.
pub(super) fn figures(cam: &CamMechanics, solved: &MachineSolution, films: &Films) -> Vec<Row> {
    let turn = turn(cam);
    let mut figures = without_solve(cam, &turn, films);
    figures.extend(friction(cam, &turn, solved).into_iter().flatten());
    figures
}

/// Those that need no solved contact.
pub(super) fn estimate(cam: &CamMechanics, films: &Films) -> Vec<Row> {
    without_solve(cam, &turn(cam), films)
}

fn turn(cam: &CamMechanics) -> Vec<CamPoint> {
    let turn = cam.cam.turn(&cam.operation, ANGLES);
    turn.unwrap_or_else(|_| cam.points.clone())
}

fn without_solve(cam: &CamMechanics, turn: &[CamPoint], films: &Films) -> Vec<Row> {
    let mut figures = mechanics(cam, turn);
    figures.extend(thinnest(cam, films));
    figures
}

/// Pressure and torque.
fn mechanics(cam: &CamMechanics, turn: &[CamPoint]) -> Vec<Row> {
    let mut figures = Vec::new();
    // A slight excess, so that the first of equal values is taken.
    let is_higher = |a: &CamPoint, b: &CamPoint| a.hertz_pressure > b.hertz_pressure * (1.0 + 1e-9);
    let highest = turn
        .iter()
        .reduce(|best, point| match is_higher(point, best) {
            true => point,
            false => best,
        });
    if let Some(highest) = highest {
        let bar = (cam.cam.bars(&cam.operation, highest.angle)).hertz_pressure;
        let pressure = Marked {
            // Of a table of lifts, by its digits.
            error: (bar > 0.0).then_some(bar),
            ..Marked::exact(highest.hertz_pressure)
        };
        figures.push(HERTZ_PRESSURE_MAXIMUM.row(pressure, ""));
        figures.push(HERTZ_PRESSURE_MAXIMUM_ANGLE.row(highest.angle, ""));
    }
    let angles = turn.iter().map(|point| point.pressure_angle.abs());
    figures.push(PRESSURE_ANGLE_MAXIMUM.row(angles.fold(0.0, f64::max), ""));
    let torque = |point: &CamPoint| point.force.max(0.0) * point.lift_velocity;
    let torques = turn.iter().map(|point| torque(point).abs());
    figures.push(TORQUE_MAXIMUM.row(
        torques.fold(0.0, f64::max),
        "T = F ds/dθ, without friction; over a turn it cancels",
    ));
    figures
}

/// Where the film is thinnest.
fn thinnest(cam: &CamMechanics, films: &Films) -> Option<Row> {
    let i = films.thinnest()?;
    Some(FILM_MINIMUM_ANGLE.row(
        cam.points[i].angle,
        "steady films: where the entrainment nearly vanishes, squeeze keeps the real film thicker",
    ))
}

/// The smallest of values at angles. Next to where the entrainment reverses, steady films vanish between the contacts: no parabola leads there, and the bar
/// covers the difference from every second contact.
pub(super) fn smallest(cam: &CamMechanics, values: Vec<(f64, Marked)>) -> Option<Marked> {
    let (every, other): (Vec<_>, Vec<_>) =
        (values.iter().enumerate()).partition(|(i, _)| i % 2 == 0);
    let least = |half: Vec<(usize, &(f64, Marked))>| {
        let values = half.into_iter().map(|(_, (_, value))| value.value);
        values.fold(f64::INFINITY, f64::min)
    };
    let halves = (least(every) - least(other)).abs();
    let (i, smallest) = round(values.clone())?.smallest();
    // The curve starts with the last of the values.
    let (angle, own) = values[(i + values.len() - 1) % values.len()];
    let step = TAU / cam.points.len() as f64;
    let reverses = (cam.reversals.iter()).any(|at| {
        let apart = (at - angle).rem_euclid(TAU);
        apart.min(TAU - apart) < step
    });
    Some(match reverses && halves.is_finite() {
        true => (own.wider(halves)).with(Marks::when(true, Mark::BetweenPoints)),
        false => smallest,
    })
}

/// Share of the difference between all contacts and every second one in the bar of their sums: the rule of meshes, for µ has peaks where the entrainment reverses.
const DIFFERENCES: f64 = 2.0;

/// µ and p_r of the solved contacts, those whose place among them is kept.
struct Rubbing {
    coefficient: Curve,
    rolling: Curve,
}

impl Rubbing {
    fn of(
        cam: &CamMechanics,
        solved: &MachineSolution,
        keeps: impl Fn(usize) -> bool,
    ) -> Option<Rubbing> {
        let mut coefficient = Vec::new();
        let mut rolling = Vec::new();
        for (i, at) in cam.points.iter().enumerate() {
            if solved.machine.contacts[i].like.is_none() || !keeps(i) {
                continue;
            }
            let point = solved.of(i)?;
            let mu = friction_of(point)?.abs();
            let power = figure_of(point, Figure::FrictionPower)?;
            coefficient.push((at.angle, mu));
            let rest = power.value - mu.value * slide(at);
            rolling.push((
                at.angle,
                Marked {
                    value: rest,
                    ..power
                },
            ));
        }
        Some(Rubbing {
            coefficient: round(coefficient)?,
            rolling: round(rolling)?,
        })
    }

    /// Power over a turn, W, where friction per length is `of` at a point.
    fn mean(cam: &CamMechanics, turn: &[CamPoint], of: impl Fn(&CamPoint) -> f64) -> f64 {
        let touching = turn.iter().filter(|point| !point.contact_lost);
        touching.map(of).sum::<f64>() * cam.operation.width / turn.len() as f64
    }

    /// Power lost over a turn, W.
    fn power(&self, cam: &CamMechanics, turn: &[CamPoint]) -> f64 {
        Rubbing::mean(cam, turn, |point| {
            self.coefficient.at(point.angle) * slide(point) + self.rolling.at(point.angle)
        })
    }
}

/// w |u_2 − u_1|, W/m.
fn slide(point: &CamPoint) -> f64 {
    point.load_per_length * point.sliding_speed.abs()
}

/// Friction over a turn, where all contacts are solved. Its bar allows for the distance of the contacts: every second of them leads to another power.
fn friction(cam: &CamMechanics, turn: &[CamPoint], solved: &MachineSolution) -> Option<[Row; 2]> {
    let all = Rubbing::of(cam, solved, |_| true)?;
    let value = all.power(cam, turn);
    // The bar of the rolling part is that of the whole power of a contact.
    let bar = Rubbing::mean(cam, turn, |point| all.rolling.bar_at(point.angle));
    let halves = [0, 1].map(|odd| Rubbing::of(cam, solved, |i| i % 2 == odd));
    let spacing = (halves.iter().flatten()).map(|half| (half.power(cam, turn) - value).abs());
    let power = Marked {
        value,
        error: all.coefficient.has_bars().then_some(bar),
        marks: all.coefficient.marks(),
    };
    let power = power.wider(DIFFERENCES * spacing.fold(0.0, f64::max));
    Some([
        FRICTION_POWER.row(
            power,
            "where the entrainment reverses: friction of the neighbouring contacts",
        ),
        FRICTION_TORQUE.row(power / cam.operation.speed.abs(), ""),
    ])
}

/// A curve that goes round: the last point before the first, and the first behind the last.
fn round(mut points: Vec<(f64, Marked)>) -> Option<Curve> {
    let (first, last) = (*points.first()?, *points.last()?);
    points.insert(0, (last.0 - TAU, last.1));
    points.push((first.0 + TAU, first.1));
    Curve::new(points)
}
