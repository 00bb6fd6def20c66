//! Why a bearing has no load distribution, in words.

use ertel_input::{InputError, Table};
use ertel_machines::bearing::kinematics::{Speeds, recommended_speed_factor, speed_factor};
use ertel_machines::bearing::load::{Error, Given, Loads};
use ertel_machines::bearing::{Bearing, Geometry, life as ratings};

use super::geometry::{Inside, RatingBasis};
use crate::words::{digits, force};

/// Static equivalent loads, in static ratings, from which on they are the reason why no equilibrium is found.
const OVERLOAD: f64 = 3.0;
/// Share of an axial load that is rounding: of a load as the message gives it, in four digits.
const ROUNDING: f64 = 1e-3;

/// Refuses an axial load that does not keep the rings of a bearing together which carries such loads in one direction only.
pub(super) fn check_axial_load(
    table: &mut Table<'_>,
    inside: &Inside,
    loads: &Loads,
) -> Result<(), InputError> {
    let series = inside.series();
    let Given::Load(axial) = loads.axial else {
        return Ok(());
    };
    let radial = given(&loads.radial[0]);
    let is_loaded = axial != 0.0 || radial > 0.0 || given(&loads.tilt[1]) > 0.0;
    if !is_loaded || !ratings::is_one_sided(&inside.geometry, series) {
        return Ok(());
    }
    let (factor, induced) = ratings::induced_axial_load(&inside.geometry, series, radial)
        .map_err(|error| table.error_here(error.to_string()))?;
    if axial > 0.0 && axial >= induced * (1.0 - ROUNDING) {
        return Ok(());
    }
    let (kind, word) = match inside.geometry {
        Geometry::TaperedRoller(_) => ("tapered roller bearing", "rollers"),
        _ => ("single-row angular contact ball bearing", "balls"),
    };
    let shown = |load: f64| force(load, false, 4);
    let why = match (axial < 0.0, radial > 0.0) {
        (true, _) => format!(
            "a {kind} carries axial load in one direction only, but {} push its rings apart",
            shown(axial)
        ),
        (false, true) => format!(
            "the radial load of {} induces an axial force of {} in a {kind}, but its axial load is {}: its rings come apart",
            shown(radial),
            shown(induced),
            shown(axial)
        ),
        (false, false) => format!("the rings of a {kind} come apart without axial load"),
    };
    let key = ["axial_load", "radial_load", "moment"]
        .into_iter()
        .find(|key| table.contains(key));
    let error = key.map_or_else(
        || table.error_here(why.clone()),
        |key| table.error(key, why.clone()),
    );
    let least = match radial > 0.0 {
        true => format!(
            " of {} or more, F_r/(2Y) with Y = {} (ISO 281), so that about half of the {word} carry",
            shown(induced),
            digits(factor, 3)
        ),
        false => String::new(),
    };
    Err(error.with_help(format!(
        "give `axial_load`{least}; positive values press the rings together. Or give `axial_preload`, their axial shift"
    )))
}

/// A given load, without its sign; 0 of a given shift.
fn given(load: &Given) -> f64 {
    match load {
        Given::Load(load) => load.abs(),
        Given::Shift(_) => 0.0,
    }
}

/// Says why a bearing has no load distribution.
pub(super) fn not_distributed(
    table: &Table<'_>,
    error: &Error,
    inside: &Inside,
    loads: &Loads,
    (bearing, speeds): (&Bearing, Speeds),
) -> InputError {
    let refused = table.error_here(error.to_string());
    match error {
        Error::Unloaded => {
            refused.with_help("give `radial_load`, `axial_load` or `axial_preload` other than zero")
        }
        Error::NoConvergence { .. } | Error::Element { .. } => overload(table, inside, loads)
            .or_else(|| overspeed(table, loads, bearing, speeds))
            .unwrap_or_else(|| {
                refused.with_help("check loads, speeds and dimensions: no equilibrium was found")
            }),
        _ => refused,
    }
}

/// A load far beyond the static rating.
fn overload(table: &Table<'_>, inside: &Inside, loads: &Loads) -> Option<InputError> {
    let [radial, axial] = [given(&loads.radial[0]), given(&loads.axial)];
    let (load, rating) = (radial.max(axial), static_rating(inside)?);
    let key = match radial >= axial {
        true => "radial_load",
        false => "axial_load",
    };
    (load > OVERLOAD * rating).then(|| {
        let why = format!(
            "{} kN are {} times the static load rating C_0 of {} kN: the elements are pressed so deep into the rings that no equilibrium was found",
            digits(1e-3 * load, 4),
            digits(load / rating, 3),
            digits(1e-3 * rating, 4),
        );
        table.error(key, why).with_help(
            "above about the static rating the raceways dent permanently: use a smaller load, or a larger bearing",
        )
    })
}

/// A speed above that which makers recommend.
fn overspeed(
    table: &Table<'_>,
    loads: &Loads,
    bearing: &Bearing,
    speeds: Speeds,
) -> Option<InputError> {
    let geometry = &bearing.geometry;
    let factor = speed_factor(speeds, geometry.pitch_diameter());
    let most = recommended_speed_factor(geometry);
    (factor > most).then(|| {
        let inertia = geometry.centrifugal_force(bearing.material.density, speeds);
        let load = given(&loads.radial[0]).max(given(&loads.axial));
        let why = format!(
            "no equilibrium at this speed: the centrifugal force of one element is about {}, under a load of {} on the bearing",
            force(inertia, false, 3),
            force(load, false, 4)
        );
        table.error("inner_ring_speed", why).with_help(format!(
            "give a lower speed: n d_m is {factor:.2e} mm/min, and makers recommend up to {most:.1e} mm/min (SKF, General catalogue, 2006)"
        ))
    })
}

/// C_0, N, from the catalogue or the geometry, where known.
fn static_rating(inside: &Inside) -> Option<f64> {
    if let RatingBasis::Catalogue([_, rating]) = inside.ratings {
        return Some(rating);
    }
    match &inside.geometry {
        Geometry::Ball(ball) => {
            let nominal = ratings::nominal_angle(&inside.geometry, inside.series());
            ratings::deep_groove_static_rating(ball, nominal).ok()
        }
        Geometry::CylindricalRoller(roller) => Some(ratings::roller_static_rating(&roller.into())),
        Geometry::TaperedRoller(roller) => Some(ratings::roller_static_rating(&roller.into())),
    }
}
