//! `[wear]`: wear of the bodies over a sliding distance.

use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::Dimension;

use crate::contact::Motion;
use crate::wear::{WearParams, WearingBody};

/// Archard's k: at most every meeting of asperities makes a particle.
const COEFFICIENT: Bounds = Bounds::closed(0.0, 1.0);
/// From soft metals to diamond, Pa.
const HARDNESS: Bounds = Bounds::closed(1e7, 2e11);
const TRACK: Bounds = Bounds::closed(1e-6, 1e3);
const DISTANCE: Bounds = Bounds::closed(1e-9, 1e9);
const DURATION: Bounds = Bounds::closed(1e-9, 1e9);
/// Speed over that of the entrainment below which a body is at rest: rounding error of a ratio of 2.
const AT_REST: f64 = 1e-12;
const STEP: Bounds = Bounds::closed(1e-3, 0.5);

/// Keys of each body: wear coefficient, hardness, length of the track.
const BODIES: [[&str; 3]; 2] = [
    [
        "body_1_wear_coefficient",
        "body_1_hardness",
        "body_1_track_length",
    ],
    [
        "body_2_wear_coefficient",
        "body_2_hardness",
        "body_2_track_length",
    ],
];
const DISTANCES: [&str; 2] = ["sliding_distance", "duration"];

/// Reads the section of a contact with this motion.
pub(super) fn read(mut table: Table<'_>, motion: &Motion) -> Result<WearParams, InputError> {
    let speeds = motion.surfaces(1.0).map(|body| body.centre[0]);
    let at_rest = speeds.map(|u| u.abs() <= AT_REST * motion.entrainment_speed.abs());
    let mut bodies = [None; 2];
    for (i, keys) in BODIES.into_iter().enumerate() {
        bodies[i] = body(&mut table, keys, (i + 1, at_rest[i]))?;
    }
    if bodies == [None; 2] {
        return Err(table.missing(BODIES[0][0]).with_help(
            "a body wears by its `body_1_wear_coefficient` or `body_2_wear_coefficient` (k, dimensionless) and its hardness",
        ));
    }
    let [distance, duration] = DISTANCES;
    let speed = motion.sliding_at_centre() * motion.entrainment_speed.abs();
    let distance = match table.optional_quantity(duration, Dimension::TIME, DURATION)? {
        Some(_) if table.contains(distance) => {
            let text =
                "the sliding distance is given twice: as `sliding_distance`, and by `duration`";
            return Err(table.error(duration, text).with_help("keep one of them"));
        }
        Some(duration) => duration * speed,
        None => {
            let found = table.required_quantity(distance, Dimension::LENGTH, DISTANCE);
            found.map_err(|error| match table.contains(distance) {
                true => error,
                false => error.with_help("or give `duration`, over which the surfaces slide"),
            })?
        }
    };
    let step = table.optional_number("step", STEP)?;
    let max_steps = table.optional_integer("max_steps", 1..=100_000)?;
    table.finish()?;
    Ok(WearParams {
        bodies,
        distance,
        step: step.unwrap_or(WearParams::STEP),
        max_steps: max_steps.map_or(WearParams::MAX_STEPS, |n| n as usize),
    })
}

/// A body, if it wears.
fn body(
    table: &mut Table<'_>,
    [coefficient, hardness, track]: [&str; 3],
    (number, is_at_rest): (usize, bool),
) -> Result<Option<WearingBody>, InputError> {
    let Some(k) = table.optional_number(coefficient, COEFFICIENT)? else {
        let given = [hardness, track]
            .into_iter()
            .find(|key| table.contains(key));
        return match given {
            None => Ok(None),
            Some(key) => Err(table
                .error(
                    key,
                    format!("body {number} does not wear: it has no `{coefficient}`"),
                )
                .with_help(format!(
                    "give `{coefficient}` (k, dimensionless), or remove `{key}`"
                ))),
        };
    };
    let has_hardness = table.contains(hardness);
    let own = table.required_quantity(hardness, Dimension::PRESSURE, HARDNESS);
    let own = own.map_err(|error| match has_hardness {
        true => error,
        false => error.with_help(format!(
            "Archard's law divides by the hardness of the body that wears: such as `{hardness} = \"7 GPa\"` of hardened steel, \"2 GPa\" of soft steel; \
             a specific wear rate w, m²/N, is `{coefficient}` = w times the hardness"
        )),
    })?;
    let track_length = match is_at_rest {
        true if table.contains(track) => {
            return Err(table
                .error(
                    track,
                    format!("body {number} is at rest in the contact, and has a scar, not a track"),
                )
                .with_help(format!("remove `{track}`")));
        }
        true => None,
        false => {
            let has_track = table.contains(track);
            let found = table.required_quantity(track, Dimension::LENGTH, TRACK);
            Some(found.map_err(|error| match has_track {
                true => error,
                false => error.with_help(format!(
                    "body {number} moves through the contact and wears all around its track: give its length, 2π times the radius of the track; \
                     a body is at rest where its speed is zero (slide_to_roll_ratio 2 or -2)"
                )),
            })?)
        }
    };
    Ok(Some(WearingBody {
        coefficient: k,
        hardness: own,
        track_length,
    }))
}

#[cfg(test)]
mod tests {
    use crate::case::Case;

    const CASE: &str = r#"
        contact = { kind = "circular", radius = "5 mm", load = "10 N" }
        bodies = { body_1 = "steel", body_2 = "steel" }
        lubricant = { name = "squalane-pip", temperature = "40 degC" }
        [surface_roughness]
        body_1_rms_height = "0.1 um"
        body_2_rms_height = "0.1 um"
        asperity_group = 0.05
        rms_height_to_asperity_radius = 1e-3
        [motion]
        entrainment_speed = "10 mm/s"
    "#;

    fn read(ratio: f64, wear: &str) -> Result<Case, String> {
        let text = format!("{CASE}\nslide_to_roll_ratio = {ratio}\n[wear]\n{wear}");
        Case::from_text("case.toml", &text, std::path::Path::new(""))
            .map_err(|error| error.to_string())
    }

    /// A ball at rest on a disc that moves at 20 mm/s for 10 s; both moving, by distance.
    #[test]
    fn scars_and_tracks() {
        let wear = read(
            -2.0,
            "body_2_wear_coefficient = 1e-6\nbody_2_hardness = \"7 GPa\"\nduration = \"10 s\"",
        );
        let wear = wear.unwrap().wear.unwrap();
        let [None, Some(ball)] = wear.bodies else {
            panic!("{wear:?}");
        };
        assert_eq!(
            (ball.coefficient, ball.hardness, ball.track_length),
            (1e-6, 7e9, None)
        );
        assert!((wear.distance - 0.2).abs() < 1e-12, "{wear:?}");
        let disc = "body_1_wear_coefficient = 1e-6\nbody_1_hardness = \"7 GPa\"\nbody_1_track_length = \"0.2 m\"\n\
                    sliding_distance = \"3 m\"\nstep = 0.2\nmax_steps = 7";
        let wear = read(-0.1, disc).unwrap().wear.unwrap();
        assert_eq!(wear.bodies[0].unwrap().track_length, Some(0.2));
        assert_eq!((wear.distance, wear.step, wear.max_steps), (3.0, 0.2, 7));
    }
}
