//! Why a bearing has no load distribution, in words.

use ertel_input::{InputError, Table};
use ertel_machines::bearing::geometry::Play;
use ertel_machines::bearing::load::{Error, Given, Loads};
use ertel_machines::bearing::{Geometry, life as ratings};

use super::geometry::Inside;
use crate::words::digits;

/// Static equivalent loads, in static ratings, from which on they are the reason why no equilibrium is found.
const OVERLOAD: f64 = 3.0;

/// Says why a bearing has no load distribution.
pub(super) fn not_distributed(
    table: &Table<'_>,
    error: &Error,
    inside: &Inside,
    loads: &Loads,
) -> InputError {
    let given = |load: &Given| match load {
        Given::Load(load) => load.abs(),
        Given::Shift(_) => 0.0,
    };
    let told = table.error_here(error.to_string());
    match error {
        Error::Unloaded => {
            told.with_help("give `radial_load`, `axial_load` or `axial_preload` other than zero")
        }
        Error::Separation(_) => {
            let factor = 1.25 * inside.geometry.free_angle().tan();
            told.with_help(format!(
                "give `axial_load`, {} of the radial load or more, so that half of the rollers carry, or `axial_preload`",
                digits(factor, 2)
            ))
        }
        Error::NoConvergence { .. } | Error::Element { .. } => {
            let load = given(&loads.radial[0]).max(given(&loads.axial));
            let rating = static_rating(inside);
            if rating.is_some_and(|rating| load > OVERLOAD * rating) {
                let rating = rating.unwrap_or(f64::NAN);
                let key = match given(&loads.radial[0]) >= given(&loads.axial) {
                    true => "radial_load",
                    false => "axial_load",
                };
                return table
                    .error(
                        key,
                        format!(
                            "{} kN are {} times the static load rating C_0 of {} kN: the elements are pressed so deep into the rings that no equilibrium was found",
                            digits(1e-3 * load, 4),
                            digits(load / rating, 3),
                            digits(1e-3 * rating, 4),
                        ),
                    )
                    .with_help("the raceways are dented for good from about the static rating on: give a smaller load, or a larger bearing");
            }
            let help = match inside.geometry {
                Geometry::TaperedRoller(roller) => format!(
                    "a radial load pushes the rings of tapered rollers apart: give `axial_load` of at least {} of the radial load, so that half of the \
                     rollers carry, or `axial_preload`",
                    digits(1.25 * roller.cup_angle.tan(), 2)
                ),
                _ => "check loads, speeds and dimensions: such a bearing has no equilibrium that was found".to_owned(),
            };
            told.with_help(help)
        }
        _ => told,
    }
}

/// C_0, N, as far as catalogue or geometry tell.
fn static_rating(inside: &Inside) -> Option<f64> {
    let published = inside.entry.as_ref().and_then(|entry| entry.ratings);
    if let Some(published) = published {
        return Some(published.value[1]);
    }
    match &inside.geometry {
        Geometry::Ball(ball) => {
            let nominal = match ball.play {
                Play::FreeAngle(angle) => angle,
                Play::Clearance(_) => 0.0,
            };
            ratings::deep_groove_static_rating(ball, nominal).ok()
        }
        Geometry::CylindricalRoller(roller) => Some(ratings::roller_static_rating(&roller.into())),
        Geometry::TaperedRoller(roller) => Some(ratings::roller_static_rating(&roller.into())),
    }
}
