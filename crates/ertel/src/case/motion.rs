//! `[motion]`, and functions shared with `[machine]`.

use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::Dimension;

use super::bodies::name_in;
use crate::contact::Motion;

/// Surfaces that move almost exactly against each other have ratios far beyond 2, but not these.
const SLIDE_TO_ROLL: Bounds = Bounds::closed(-1e6, 1e6);
/// Speeds, m/s: values outside indicate a wrong unit.
pub(super) const MAX_SPEED: f64 = 1e3;
/// Spin, rad/s.
pub(super) const SPIN: Bounds = Bounds::closed(-1e6, 1e6);
/// Between the velocities of the surfaces, rad.
const SKEW: Bounds = Bounds::closed(-std::f64::consts::PI, std::f64::consts::PI);
/// Slowest entrainment, m/s: a nanometre in a second.
const MIN_SPEED: f64 = 1e-9;

/// Reads entrainment speed and slide-to-roll ratios, or the speeds of both surfaces, and their spin; `keys` are the names of
/// the speeds of body 1 and of body 2, the usual one first.
pub(super) fn read_motion(
    table: &mut Table<'_>,
    keys: [[&'static str; 2]; 2],
) -> Result<Motion, InputError> {
    let [first, second] = [name_in(table, keys[0])?, name_in(table, keys[1])?];
    let motion = match table.contains(first) || table.contains(second) {
        true => of_speeds(table, [first, second])?,
        false => of_entrainment(table)?,
    };
    let [first, second] = ["body_1_spin", "body_2_spin"]
        .map(|key| table.optional_quantity(key, Dimension::ANGULAR_SPEED, SPIN));
    Ok(Motion {
        spin: [first?.unwrap_or(0.0), second?.unwrap_or(0.0)],
        ..motion
    })
}

/// From entrainment speed and slide-to-roll ratios.
fn of_entrainment(table: &mut Table<'_>) -> Result<Motion, InputError> {
    let speed = Bounds::closed(-MAX_SPEED, MAX_SPEED);
    let entrainment_speed =
        table.required_quantity("entrainment_speed", Dimension::SPEED, speed)?;
    check_entrainment(table, "entrainment_speed", entrainment_speed)?;
    let along = table.required_number("slide_to_roll_ratio", SLIDE_TO_ROLL)?;
    let across = table.optional_number("slide_to_roll_ratio_across", SLIDE_TO_ROLL)?;
    if table.contains("skew_angle") {
        return Err(table
            .error(
                "skew_angle",
                "`skew_angle` lies between the velocities of the surfaces, but their speeds are not given",
            )
            .with_help("give `body_1_speed` and `body_2_speed`, or `slide_to_roll_ratio_across` instead"));
    }
    Ok(Motion {
        slide_to_roll_ratio_across: across.unwrap_or(0.0),
        ..Motion::straight(entrainment_speed, along)
    })
}

/// From the speeds of both surfaces, and the angle φ from the velocity of body 1 to that of body 2:
///
/// u_m e = (u_1 + u_2)/2,  S = (u_2 − u_1)·e/u_m = (u_2² − u_1²)/2u_m²,  S_⊥ = (u_2 − u_1)·n/u_m = u_1 u_2 sin φ/u_m²,  n across e
fn of_speeds(table: &mut Table<'_>, keys: [&'static str; 2]) -> Result<Motion, InputError> {
    let bounds = Bounds::closed(-MAX_SPEED, MAX_SPEED);
    let [key_1, key_2] = keys;
    let second = table.required_quantity(key_2, Dimension::SPEED, bounds)?;
    let first = table.required_quantity(key_1, Dimension::SPEED, bounds)?;
    let derived = [
        "entrainment_speed",
        "slide_to_roll_ratio",
        "slide_to_roll_ratio_across",
    ];
    if let Some(key) = derived.into_iter().find(|key| table.contains(key)) {
        return Err(table.error(
            key,
            format!("`{key}` follows from `{key_2}` and `{key_1}`; give one pair"),
        ));
    }
    let skew = table.optional_quantity("skew_angle", Dimension::ANGLE, SKEW)?;
    let skew = skew.filter(|skew| *skew != 0.0);
    let Some(skew) = skew else {
        let entrainment_speed = 0.5 * (second + first);
        check_entrainment(table, key_2, entrainment_speed)?;
        return Ok(Motion::straight(
            entrainment_speed,
            (second - first) / entrainment_speed,
        ));
    };
    let (sin, cos) = skew.sin_cos();
    let mean = [0.5 * (first + second * cos), 0.5 * second * sin];
    let entrainment_speed = mean[0].hypot(mean[1]);
    check_entrainment(table, key_2, entrainment_speed)?;
    let square = entrainment_speed * entrainment_speed;
    Ok(Motion {
        slide_to_roll_ratio_across: first * second * sin / square,
        ..Motion::straight(
            entrainment_speed,
            0.5 * (second - first) * (second + first) / square,
        )
    })
}

pub(super) fn check_entrainment(
    table: &Table<'_>,
    key: &str,
    speed: f64,
) -> Result<(), InputError> {
    if speed.abs() < MIN_SPEED {
        return Err(table
            .error(key, "the entrainment speed must not be zero")
            .with_help("only entrained lubricant keeps the surfaces apart in a steady contact"));
    }
    if speed < 0.0 {
        return Err(table
            .error(key, "the entrainment speed must be positive")
            .with_help("the inlet is at x < 0; reverse x and both speeds"));
    }
    Ok(())
}

/// Why lines do not spin.
pub(super) const NO_SPIN_OF_LINES: &str =
    "surfaces that touch along an infinite line cannot spin about its normal";

/// Largest speed of the mean motion over the entrainment speed at the edge of the Hertz zone: beyond it the surfaces turn on the
/// spot more than they entrain, and no side is the inlet.
const MOST_SPIN: f64 = 0.5;

/// Refuses spin of contacts that cannot spin, and spin that leaves no inlet; `reach` is the largest half-width, m.
pub(super) fn check_spin(
    table: &Table<'_>,
    motion: &Motion,
    is_point: bool,
    reach: f64,
) -> Result<(), InputError> {
    if motion.spin == [0.0; 2] {
        return Ok(());
    }
    let keys = ["raceway_control", "body_1_spin", "body_2_spin"];
    // Reading a key would make it known, and [motion] does not have it.
    let given = keys.into_iter().find(|key| table.keys().any(|k| k == *key));
    let key = given.unwrap_or("body_1_spin");
    if !is_point {
        return Err(table.error(key, NO_SPIN_OF_LINES));
    }
    let mean = motion.entrainment(reach).spin.abs();
    if mean > MOST_SPIN {
        return Err(table
            .error(
                key,
                format!(
                    "the mean spin moves the edge of the contact at {mean:.3} of the entrainment speed; {MOST_SPIN} at most"
                ),
            )
            .with_help("a contact that turns on the spot has no inlet"));
    }
    Ok(())
}
