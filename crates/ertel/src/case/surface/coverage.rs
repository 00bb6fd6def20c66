//! Maps that do not cover the contact area: around them the surface is smooth.

use super::{REST, SurfaceEcho, SurfaceRelief};
use crate::case::Case;
use crate::contact::Hertz;
use crate::contact::gap::{Body, Form};
use crate::warning::{Warning, WarningKind};
use crate::words::{digits, length};

/// Points of the contact area along each axis at which it is asked whether a map covers them.
const POINTS: i32 = 100;
/// Share of the contact area that may be uncovered without a word.
const UNCOVERED: f64 = 0.01;

/// A warning for each map whose heights, without the rim over which they fade out, miss a part of the contact area.
pub(super) fn warnings(case: &Case) -> Vec<Warning> {
    let one = |(i, relief): (usize, &SurfaceRelief)| {
        let echo = relief.echo.as_ref()?;
        let Form::Map { direction, .. } = relief.form else {
            return None;
        };
        let covered = share(case, relief, echo, direction);
        (covered < 1.0 - UNCOVERED).then(|| warning(case, i, echo, covered))
    };
    (case.reliefs.iter().enumerate()).filter_map(one).collect()
}

/// Sides of the map, m; the second one of a profile is none.
fn sides(echo: &SurfaceEcho) -> [Option<f64>; 2] {
    [0, 1].map(|d| (echo.points[d] > 1).then(|| (echo.points[d] - 1) as f64 * echo.spacing[d]))
}

/// Semi-axes of the contact area, m; the second one of a line is none.
fn half_widths(case: &Case) -> [Option<f64>; 2] {
    let contact = case.contact.along_motion();
    let hertz = Hertz::new(&contact, case.reduced_modulus());
    let across = match (&contact.roller, contact.kind.is_line()) {
        (Some(roller), _) => Some(0.5 * roller.length),
        (None, true) => None,
        (None, false) => Some(hertz.half_width_y.unwrap_or(hertz.half_width)),
    };
    [Some(hertz.half_width), across]
}

/// The share of the contact area that the map covers: of one that moves through it when its middle is there.
fn share(case: &Case, relief: &SurfaceRelief, echo: &SurfaceEcho, direction: f64) -> f64 {
    let speed = match relief.body {
        Body::First => case.motion.body_1_speed(),
        Body::Second => case.motion.body_2_speed(),
    };
    let moves = case.transient.is_some() && speed.abs() > REST;
    let place = [if moves { 0.0 } else { relief.place[0] }, relief.place[1]];
    let reach = sides(echo).map(|side| side.map(|side| 0.5 * side - echo.taper));
    let [a, b] = half_widths(case);
    let (sin, cos) = direction.sin_cos();
    let ends = |half: Option<f64>| if half.is_some() { POINTS } else { 0 };
    let (mut n, mut n_covered) = (0, 0);
    for i in -POINTS..=POINTS {
        for j in -ends(b)..=ends(b) {
            if i * i + j * j > POINTS * POINTS {
                continue;
            }
            let at =
                |half: Option<f64>, i: i32| half.unwrap_or(0.0) * f64::from(i) / f64::from(POINTS);
            let (x, y) = (at(a, i) - place[0], at(b, j) - place[1]);
            let own = [x * cos + y * sin, y * cos - x * sin];
            n += 1;
            let is_within = |d: usize| reach[d].is_none_or(|reach| own[d].abs() <= reach);
            n_covered += i32::from(is_within(0) && is_within(1));
        }
    }
    f64::from(n_covered) / f64::from(n)
}

fn warning(case: &Case, i: usize, echo: &SurfaceEcho, covered: f64) -> Warning {
    let sizes = |sizes: [Option<f64>; 2], factor: f64| {
        let sizes = sizes.into_iter().flatten();
        sizes
            .map(|size| length(factor * size))
            .collect::<Vec<_>>()
            .join(" x ")
    };
    let text = format!(
        "surface {}: the map of {}, whose heights fade out over the outer {}, covers {} % of the contact area, {}; outside it the surface is \
         smooth, and films and pressures there are those of smooth bodies",
        i + 1,
        sizes(sides(echo), 1.0),
        length(echo.taper),
        digits(100.0 * covered, 3),
        sizes(half_widths(case), 2.0)
    );
    Warning::new(WarningKind::SmallMap, text)
}
