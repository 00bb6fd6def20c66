//! `[surface_roughness]`: rough surfaces and their asperities.

use ertel_rheology::input::{Bounds, InputError, Table};
use ertel_rheology::quantity::Dimension;

use super::bodies::ROUGHNESS;
use crate::mixed::Asperities;
use crate::output::digits;
use crate::warning::{Warning, WarningKind};

/// rms height of one body, m; one of the two may be smooth.
const RMS_HEIGHT: Bounds = Bounds::closed(0.0, 1e-3);
/// σβη is a share of the surface: asperities of more than all of it were mistaken.
const GROUP: Bounds = Bounds::open(0.0, 1.0);
/// Asperities are far wider than high.
const HEIGHT_TO_RADIUS: Bounds = Bounds::open(0.0, 1.0);
/// Friction of bare metals in vacuum is larger; no lubricant is about then.
const BOUNDARY_FRICTION: Bounds = Bounds::closed(0.0, 2.0);

/// σβη and σ/β as usually quoted for engineering surfaces after Greenwood and Tripp (1970); quoted second-hand, and only to find slips
/// of the decimal point.
const USUAL_GROUP: [f64; 2] = [0.03, 0.07];
const USUAL_HEIGHT_TO_RADIUS: [f64; 2] = [1e-4, 1e-2];

const KEYS: [&str; 2] = ["body_1_rms_height", "body_2_rms_height"];
const ASPERITY_KEYS: [&str; 2] = ["asperity_group", "rms_height_to_asperity_radius"];

/// Composite rms height, m, and asperities; `of_bodies` is the `roughness` of `[bodies]`.
pub(super) fn read(
    mut table: Table<'_>,
    of_bodies: Option<f64>,
) -> Result<(Option<f64>, Option<Asperities>), InputError> {
    let own = composite(&mut table)?;
    if own.is_some() && of_bodies.is_some() {
        return Err(table
            .error(
                KEYS[0],
                "the composite roughness is given twice: here by the rms heights of the bodies, and by `roughness` in [bodies]",
            )
            .with_help("keep one of them"));
    }
    let roughness = own.or(of_bodies);
    let asperities = asperities(&mut table)?;
    if asperities.is_some() && roughness.is_none() {
        return Err(table
            .error(
                ASPERITY_KEYS[0],
                "asperities are described, but no roughness is given",
            )
            .with_help(format!(
                "`{}` and `{}`, or `roughness` in [bodies]",
                KEYS[0], KEYS[1]
            )));
    }
    if own.is_none() && asperities.is_none() {
        // Unknown keys first: a misspelt one tells more than that all are missing.
        table.clone().finish()?;
        return Err(table
            .error_here("[surface_roughness] says nothing")
            .with_help(format!(
                "keys are: {}, {}, boundary_friction_coefficient",
                KEYS.join(", "),
                ASPERITY_KEYS.join(", ")
            )));
    }
    table.finish()?;
    Ok((roughness, asperities))
}

/// σ = √(σ₁² + σ₂²).
fn composite(table: &mut Table<'_>) -> Result<Option<f64>, InputError> {
    let [one, two] = KEYS;
    let (first, second) = match (table.contains(one), table.contains(two)) {
        (false, false) => return Ok(None),
        _ => (
            table.required_quantity(one, Dimension::LENGTH, RMS_HEIGHT)?,
            table.required_quantity(two, Dimension::LENGTH, RMS_HEIGHT)?,
        ),
    };
    let sigma = first.hypot(second);
    if !ROUGHNESS.contains(sigma) {
        let problem = "the composite rms height of both bodies";
        return Err(table.error(
            one,
            format!(
                "{problem} must be 0.01 nm to 1 mm, not {} m",
                digits(sigma, 4)
            ),
        ));
    }
    Ok(Some(sigma))
}

fn asperities(table: &mut Table<'_>) -> Result<Option<Asperities>, InputError> {
    let [group, ratio] = ASPERITY_KEYS;
    let friction = "boundary_friction_coefficient";
    if !table.contains(group) && !table.contains(ratio) {
        if table.contains(friction) {
            return Err(table
                .error(
                    friction,
                    "boundary friction is that of asperities, which are not described",
                )
                .with_help(format!("`{group}` and `{ratio}` describe them")));
        }
        return Ok(None);
    }
    Ok(Some(Asperities {
        asperity_group: table.required_number(group, GROUP)?,
        rms_height_to_asperity_radius: table.required_number(ratio, HEIGHT_TO_RADIUS)?,
        boundary_friction_coefficient: table.optional_number(friction, BOUNDARY_FRICTION)?,
    }))
}

/// Numbers that measured surfaces seldom have.
pub(super) fn warnings(asperities: &Asperities) -> Vec<Warning> {
    let [group, ratio] = ASPERITY_KEYS;
    let values = [
        (group, asperities.asperity_group, USUAL_GROUP),
        (
            ratio,
            asperities.rms_height_to_asperity_radius,
            USUAL_HEIGHT_TO_RADIUS,
        ),
    ];
    let outside =
        (values.into_iter()).filter(|(_, value, [low, high])| value < low || value > high);
    outside
        .map(|(key, value, [low, high])| {
            let text = format!(
                "{key} = {} is outside {low} to {high}, the range usually quoted for engineering surfaces",
                digits(value, 4)
            );
            Warning::beyond(WarningKind::AsperityData, (value / high).max(low / value), text)
        })
        .collect()
}
