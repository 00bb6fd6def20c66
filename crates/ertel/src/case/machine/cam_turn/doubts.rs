//! Warnings about cams: too few digits in a table of lifts, and pressure angles at which followers jam.

use std::f64::consts::PI;

use ertel_machines::cam::{Cam, CamOperation, CamPoint};

use super::ranges;
use crate::warning::{Warning, WarningKind};
use crate::words::digits;

/// Pressure angles, rad, above which designs avoid followers that move along a straight line, which jam in their guides, and arms: 30° and 45°. Sources: Norton, Cam
/// Design and Manufacturing Handbook, 2002, chapter 7; VDI 2142.
const MAX_PRESSURE_ANGLE: [f64; 2] = [30.0 * PI / 180.0, 45.0 * PI / 180.0];

/// The share of a figure that its bar must not exceed.
const RESOLVED: f64 = 0.5;

/// A figure (SI) and its bar in a unit, `factor` of SI, in words; `plain` without a bar.
pub(super) fn with_bar(plain: String, [value, bar]: [f64; 2], factor: f64, unit: &str) -> String {
    if bar == 0.0 {
        return plain;
    }
    let number = format!(
        "{} ± {} {unit}",
        digits(factor * value, 4),
        digits(factor * bar, 2)
    );
    match bar <= RESOLVED * value.abs() {
        true => number,
        false => format!("not resolved by the digits of the table: {number}"),
    }
}

/// Where the entrainment reverses, with bars; `None` where it does not.
pub(super) fn reversals(cam: &Cam, operation: &CamOperation, at: &[f64]) -> Option<String> {
    let each: Vec<String> = (at.iter())
        .map(|angle| {
            let degrees = digits(angle.to_degrees(), 4);
            match cam.reversal_bar(operation, *angle) {
                0.0 => degrees,
                bar => format!("{degrees} ± {}", digits(bar.to_degrees(), 2)),
            }
        })
        .collect();
    (!each.is_empty()).then(|| format!("at {} deg", each.join(", ")))
}

/// The largest pressure angle of a turn.
pub(super) fn steepest(turn: &[CamPoint]) -> (&'static str, String) {
    let steepest =
        (turn.iter()).max_by(|a, b| a.pressure_angle.abs().total_cmp(&b.pressure_angle.abs()));
    let text = steepest.map_or_else(String::new, |point| {
        format!(
            "{} deg at {} deg",
            digits(point.pressure_angle.abs().to_degrees(), 4),
            digits(point.angle.to_degrees(), 5)
        )
    });
    ("largest pressure angle", text)
}

/// Warns where the pressure angle is large for a follower that moves along a straight line (`is_straight`) or an arm, and where the digits of the table do not resolve curvature or pressure.
pub(super) fn warnings(
    cam: &Cam,
    operation: &CamOperation,
    points: &[CamPoint],
    is_straight: bool,
) -> Vec<Warning> {
    let mut warnings = Vec::new();
    let mut warn = |kind, text: String| warnings.push(Warning::new(kind, text));
    let size = |point: &CamPoint| point.pressure_angle.abs();
    let largest = points.iter().map(size).fold(0.0, f64::max);
    let (limit, effect) = match is_straight {
        true => (
            MAX_PRESSURE_ANGLE[0],
            "a follower in a straight guide may jam",
        ),
        false => (
            MAX_PRESSURE_ANGLE[1],
            "the arm presses on its pivot rather than turns",
        ),
    };
    if largest > limit {
        let at = ranges(points, |point| size(point) > limit);
        warn(
            WarningKind::PressureAngle,
            format!(
                "the pressure angle reaches {} deg and exceeds {} deg at {at}: {effect} (limits: Norton 2002, chapter 7; VDI 2142); a larger base radius or a \
             smaller offset lowers it",
                digits(largest.to_degrees(), 3),
                digits(limit.to_degrees(), 3)
            ),
        );
    }
    let is_open = |point: &CamPoint| {
        let bar = cam.bars(operation, point.angle).reduced_radius;
        !point.contact_lost && (bar.is_nan() || bar > RESOLVED * point.reduced_radius)
    };
    let open = ranges(points, is_open);
    if !open.is_empty() {
        warn(
            WarningKind::LiftDigits,
            format!(
                "the digits of the table of lifts do not resolve the radius of curvature at {open}: pressures and films there are not to be used; give lifts \
             with more digits"
            ),
        );
    }
    warnings
}
