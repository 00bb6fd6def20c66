//! `[[surface]]`: reliefs and measured heights of surfaces.

mod array;
mod coverage;
mod map;
mod reader;

use std::path::Path;

use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::Dimension;

use super::{Case, finite_volumes_refuse};
use crate::contact::Supply;
use crate::contact::gap::{Body, Form};
use crate::params::{ElasticModel, Method, SensitivityDemand};
use crate::warning::{Warning, WarningKind};
use crate::words::length;
pub use map::SurfaceEcho;
pub use reader::{LEAST_POINTS, MOST_POINTS};

/// A relief of a surface, m.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceRelief {
    /// Its shape.
    pub form: Form,
    /// The body that has it.
    pub body: Body,
    /// Where its middle, or first crest, lies at t = 0.
    pub place: [f64; 2],
    /// Source and description of the heights of a map.
    pub echo: Option<SurfaceEcho>,
}

/// Sizes of reliefs, m: below, the film is no continuum; above, it is the body.
const SIZE: Bounds = Bounds::closed(1e-8, 0.1);
const HEIGHT: Bounds = Bounds::closed(1e-12, 1e-3);
/// Half-widths of the dry contact beyond which a relief is a shape of the body.
const LARGEST: f64 = 9.0;
const PLACE: Bounds = Bounds::closed(-1.0, 1.0);

/// The kinds of reliefs.
#[derive(Clone, Copy)]
enum Kind {
    Round(f64),
    Ridge(f64),
    Waves,
    Map,
    Generated,
}

const KINDS: [(&str, Kind); 7] = [
    ("dent", Kind::Round(-1.0)),
    ("bump", Kind::Round(1.0)),
    ("groove", Kind::Ridge(-1.0)),
    ("ridge", Kind::Ridge(1.0)),
    ("waves", Kind::Waves),
    ("map", Kind::Map),
    ("generated", Kind::Generated),
];

/// Reads them, for a case that is read otherwise.
pub(super) fn read(
    root: &mut Table<'_>,
    case: &Case,
    folder: &Path,
) -> Result<Vec<SurfaceRelief>, InputError> {
    (root.tables("surface")?.into_iter())
        .map(|table| relief(table, case, folder))
        .collect()
}

fn relief(mut table: Table<'_>, case: &Case, folder: &Path) -> Result<SurfaceRelief, InputError> {
    let kind = table.required_choice("kind", &KINDS)?;
    let bodies = [("body_1", Body::First), ("body_2", Body::Second)];
    let body = table.required_choice("body", &bodies)?;
    let is_line = case.contact.kind.is_line();
    let size = |table: &mut Table<'_>, key| table.required_quantity(key, Dimension::LENGTH, SIZE);
    let height = |table: &mut Table<'_>, sign: f64| {
        let key = if sign < 0.0 { "depth" } else { "height" };
        (table.required_quantity(key, Dimension::LENGTH, HEIGHT)).map(|height| sign * height)
    };
    let mut echo = None;
    let form = match kind {
        Kind::Round(_) if is_line => {
            return Err(table
                .error(
                    "kind",
                    "a line contact has no round relief: all is the same along it",
                )
                .with_help("`groove`, `ridge`, `waves`, or a `map` of one row"));
        }
        Kind::Round(sign) => Form::Round {
            radius: size(&mut table, "radius")?,
            height: height(&mut table, sign)?,
        },
        Kind::Ridge(sign) => Form::Ridge {
            half_width: size(&mut table, "half_width")?,
            height: height(&mut table, sign)?,
            direction: direction(&mut table, is_line, 0.5)?,
        },
        Kind::Waves => Form::Waves {
            wavelength: size(&mut table, "wavelength")?,
            amplitude: table.required_quantity("amplitude", Dimension::LENGTH, HEIGHT)?,
            direction: direction(&mut table, is_line, 0.5)?,
        },
        Kind::Map => {
            let (form, own) = map::measured(&mut table, is_line, folder)?;
            echo = Some(own);
            form
        }
        Kind::Generated => {
            let (form, own) = map::generated(&mut table, is_line)?;
            echo = Some(own);
            form
        }
    };
    check_size(&mut table, &form, case.hertz().half_width)?;
    let form = match kind {
        Kind::Round(_) | Kind::Ridge(_) => array::read(&mut table, form)?,
        _ => form,
    };
    let x = table.required_quantity("x", Dimension::LENGTH, PLACE)?;
    let y = table.optional_quantity("y", Dimension::LENGTH, PLACE)?;
    if is_line && y.is_some_and(|y| y != 0.0) {
        return Err(table.error("y", "all is the same along a line contact"));
    }
    table.finish()?;
    Ok(SurfaceRelief {
        form,
        body,
        place: [x, y.unwrap_or(0.0)],
        echo,
    })
}

/// Refuses reliefs that are larger than the contact area.
fn check_size(table: &mut Table<'_>, form: &Form, half_width: f64) -> Result<(), InputError> {
    if form.finest() <= LARGEST * half_width {
        return Ok(());
    }
    let key = [
        "radius",
        "half_width",
        "wavelength",
        "low_pass",
        "shortest_wavelength",
    ]
    .into_iter()
    .find(|key| table.contains(key));
    let text = format!(
        "the relief is larger than the contact area: {} across, where the half-width of the dry contact is {}",
        length(form.finest()),
        length(half_width)
    );
    Err(table.error(key.unwrap_or("kind"), text))
}

/// Direction from the motion, up to some half turns to either side.
fn direction(table: &mut Table<'_>, is_line: bool, turns: f64) -> Result<f64, InputError> {
    let most = turns * std::f64::consts::PI;
    let bounds = Bounds::closed(-most, most);
    let angle = table.optional_quantity("direction", Dimension::ANGLE, bounds)?;
    match angle {
        Some(angle) if is_line && angle != 0.0 => {
            Err(table.error("direction", "all is the same along a line contact"))
        }
        angle => Ok(angle.unwrap_or(0.0)),
    }
}

/// Speed of a body over the entrainment speed below which it is at rest.
const REST: f64 = 1e-9;

/// Refuses reliefs in contacts that do not change in time where they make them change, or that are not solved with them; warnings about the
/// others.
pub(super) fn check(case: &Case, root: &mut Table<'_>) -> Result<Vec<Warning>, InputError> {
    let tables = root.tables("surface")?;
    let mut warnings = coverage::warnings(case);
    let Some(first) = tables.first().filter(|_| case.transient.is_none()) else {
        return Ok(warnings);
    };
    if let Some((_, reason)) = refusals(case).iter().find(|(is_refused, _)| *is_refused) {
        return Err(first.error_here(format!("[[surface]] cannot be combined with {reason}")));
    }
    for (table, relief) in tables.iter().zip(&case.reliefs) {
        let motion = &case.motion;
        let (name, speed) = match relief.body {
            Body::First => ("body_1", motion.body_1_speed()),
            Body::Second => ("body_2", motion.body_2_speed()),
        };
        let is_at_rest = speed.abs() <= REST * motion.entrainment_speed.abs();
        if !(is_at_rest || relief.form.is_along_motion()) {
            return Err(table
                .error(
                    "body",
                    format!(
                        "the relief moves with {name}, whose speed is {} m/s: the contact is not steady",
                        crate::words::digits(speed, 4)
                    ),
                )
                .with_help(
                    "follow it with [transient], such as duration = \"5 ms\"; without it, reliefs are on a body at rest or do not vary along \
                     the motion (ridges, grooves, waves or profiles with direction = \"90 deg\")",
                ));
        }
    }
    if case.roughness.is_some() {
        warnings.push(Warning::new(
            WarningKind::NoEffect,
            "the roughness has no effect with [[surface]] except on the lambda ratio and the asperities: heights in both count twice there",
        ));
    }
    Ok(warnings)
}

/// Cases that are not solved with reliefs at rest.
fn refusals(case: &Case) -> Vec<(bool, &'static str)> {
    vec![
        (
            case.thermal().is_some(),
            "[thermal]: heat is not solved with reliefs; remove it, or set isothermal = true in [solver]",
        ),
        (
            case.supply != Supply::Flooded,
            "[inlet]: a starved inlet is not solved with reliefs",
        ),
        (
            !case.motion.is_straight(),
            "spin or skew: reliefs are solved where surfaces move along the entrainment alone",
        ),
        (
            case.whole.is_some(),
            "a whole machine: choose one of its contacts in [machine]",
        ),
        (
            case.elastic_model() != ElasticModel::HalfSpace,
            "finite-element bodies: reliefs are solved between half-spaces",
        ),
        (
            case.solver.method == Some(Method::FiniteElements),
            "finite elements: reliefs are solved by finite volumes; remove method from [solver]",
        ),
        (
            case.has_key_of_elements() || finite_volumes_refuse(case).is_some(),
            "keys of [mesh] or [solver] that only finite elements have",
        ),
        (
            case.output.sensitivities == SensitivityDemand::All,
            "[output] sensitivities: derivatives are not computed with reliefs",
        ),
    ]
}

#[cfg(test)]
mod tests;
