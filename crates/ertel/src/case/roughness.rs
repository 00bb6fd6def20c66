//! `[surface_roughness]`: rough surfaces and their asperities.

use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::Dimension;

use super::asperities;
use super::bodies::ROUGHNESS;
use crate::mixed::Asperities;
use crate::words::{digits, length};

/// rms height of one body, m; one of the two may be smooth.
const RMS_HEIGHT: Bounds = Bounds::closed(0.0, 1e-3);
/// Keys of the bodies; each body has one of its row.
const KEYS: [[&str; 4]; 2] = [
    ["body_1_rms_height", "body_1_ra", "body_1_rq", "body_1_rz"],
    ["body_2_rms_height", "body_2_ra", "body_2_rq", "body_2_rz"],
];
/// σ = Rq over Ra: √(π/2) = 1.253 where heights are normally distributed, as quoted.
const RMS_OVER_RA: f64 = 1.25;
/// Rz over Ra, the approximation of DIN 3991 (quoted in the help of the FVA workbench, attribute 391), and between which numbers other
/// quotations of the ratio lie.
const RZ_OVER_RA: f64 = 6.0;
const RZ_OVER_RA_RANGE: [f64; 2] = [4.0, 8.0];

/// Contents of `[surface_roughness]`.
#[derive(Default)]
pub(super) struct Surfaces {
    /// Composite rms height, m.
    pub roughness: Option<f64>,
    /// Conversions from other measures of roughness, one sentence each.
    pub rules: Vec<String>,
    pub asperities: Option<Asperities>,
}

/// Reads the section, if there is one; `of_bodies` is the `roughness` of `[bodies]`, m.
pub(super) fn read(
    table: Option<Table<'_>>,
    of_bodies: Option<f64>,
) -> Result<Surfaces, InputError> {
    let Some(mut table) = table else {
        return Ok(Surfaces {
            roughness: of_bodies,
            ..Surfaces::default()
        });
    };
    let mut rules = Vec::new();
    let own = composite(&mut table, &mut rules)?;
    if own.is_some() && of_bodies.is_some() {
        let key = given_key(&mut table, 0).unwrap_or(KEYS[0][0]);
        return Err(table
            .error(
                key,
                "the composite roughness is given twice: here by the rms heights of the bodies, and by `roughness` in [bodies]",
            )
            .with_help("keep one of them"));
    }
    let roughness = own.or(of_bodies);
    let asperities = asperities::read(&mut table)?;
    if asperities.is_some() && roughness.is_none() {
        let key = asperities::given_key(&mut table);
        return Err(table
            .error(key, "asperities are described, but no roughness is given")
            .with_help(format!(
                "`{}` and `{}`, or `roughness` in [bodies]",
                KEYS[0][0], KEYS[1][0]
            )));
    }
    if own.is_none() && asperities.is_none() {
        // Unknown keys first: a misspelt key explains more than the missing ones.
        table.clone().finish()?;
        return Err(table
            .error_here("[surface_roughness] is empty")
            .with_help(format!(
                "keys are: {}, {}",
                KEYS.as_flattened().join(", "),
                asperities::KEYS.join(", ")
            )));
    }
    table.finish()?;
    Ok(Surfaces {
        roughness,
        rules,
        asperities,
    })
}

/// The key by which the roughness of a body is given, 0 or 1.
fn given_key(table: &mut Table<'_>, body: usize) -> Option<&'static str> {
    KEYS[body].into_iter().find(|key| table.contains(key))
}

/// rms height of a body, m, from the measure that is given; adds the rule of conversion.
fn rms_height(
    table: &mut Table<'_>,
    body: usize,
    rules: &mut Vec<String>,
) -> Result<f64, InputError> {
    let Some(key) = given_key(table, body) else {
        return Err(table.missing(KEYS[body][0]).with_help(format!(
            "or one of {}; a smooth body has \"0 nm\"",
            KEYS[body][1..].join(", ")
        )));
    };
    if let Some(second) = KEYS[body]
        .into_iter()
        .find(|other| *other != key && table.contains(other))
    {
        return Err(table.error(
            second,
            format!("`{key}` and `{second}` give the same quantity; keep one of them"),
        ));
    }
    let height = table.required_quantity(key, Dimension::LENGTH, RMS_HEIGHT)?;
    let [low, high] = RZ_OVER_RA_RANGE;
    let (factor, rule) = match key.rsplit('_').next() {
        Some("ra") => (
            RMS_OVER_RA,
            format!("{RMS_OVER_RA} Ra, as of normally distributed heights"),
        ),
        Some("rz") => (
            RMS_OVER_RA / RZ_OVER_RA,
            format!(
                "{RMS_OVER_RA} Rz/{RZ_OVER_RA}: Rz is about {RZ_OVER_RA} Ra (DIN 3991), {low} to {high} Ra, so σ is uncertain by -{:.0} to +{:.0} %",
                100.0 * (1.0 - RZ_OVER_RA / high),
                100.0 * (RZ_OVER_RA / low - 1.0)
            ),
        ),
        _ => return Ok(height),
    };
    let sigma = factor * height;
    rules.push(format!("body_{}: σ = {} = {rule}", body + 1, length(sigma)));
    Ok(sigma)
}

/// σ = √(σ₁² + σ₂²).
fn composite(table: &mut Table<'_>, rules: &mut Vec<String>) -> Result<Option<f64>, InputError> {
    let given = [0, 1].map(|body| given_key(table, body));
    if given == [None, None] {
        return Ok(None);
    }
    let (first, second) = (rms_height(table, 0, rules)?, rms_height(table, 1, rules)?);
    let sigma = first.hypot(second);
    if !ROUGHNESS.contains(sigma) {
        let problem = "the composite rms height of both bodies";
        return Err(table.error(
            given[0].unwrap_or(KEYS[0][0]),
            format!(
                "{problem} must be 0.01 nm to 1 mm, not {} m",
                digits(sigma, 4)
            ),
        ));
    }
    Ok(Some(sigma))
}
