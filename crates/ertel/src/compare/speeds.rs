//! Cases that give the speeds of both surfaces, combined with tables of entrainment speeds and slide-to-roll ratios.

use ertel_input::Document;
use ertel_input::tree::Value;
use ertel_quantity::{Dimension, parse_uncertain};

use super::measured::{Content, column};

/// Keys of the speeds of body 1 and body 2, by the tables that contain them.
const PAIRS: [(&str, [&str; 2], [&str; 2]); 2] = [
    (
        "machine",
        ["machine.disc_speed", "machine.disc_speed"],
        ["machine.ball_speed", "machine.ball_speed"],
    ),
    (
        "motion",
        ["motion.body_1_speed", "motion.plane_speed"],
        ["motion.body_2_speed", "motion.ball_speed"],
    ),
];

/// Speed (m/s) at a key of a case, if it is a plain quantity there.
fn speed(case: &Document, key: &str) -> Option<f64> {
    match &case.tree().entry(key)?.node.value {
        Value::Str(text) => Some(parse_uncertain(text, Dimension::SPEED).ok()?.0),
        _ => None,
    }
}

/// A value for people.
fn digits(value: f64) -> f64 {
    (value * 1e6).round() / 1e6
}

/// The keys of both speeds that the columns replace; what the table does not vary of entrainment speed and ratio keeps the value
/// that follows from these speeds.
///
/// u = (u_1 + u_2)/2,  SRR = (u_2 - u_1)/u
pub(super) fn replace(case: &Document, content: &mut Content) -> Vec<&'static str> {
    for (table, first, second) in PAIRS {
        let given = |keys: [&'static str; 2]| {
            let mut found = keys
                .into_iter()
                .filter_map(|key| Some((key, speed(case, key)?)));
            found.next()
        };
        let (Some((key_1, u_1)), Some((key_2, u_2))) = (given(first), given(second)) else {
            continue;
        };
        let keys = [
            format!("{table}.entrainment_speed"),
            format!("{table}.slide_to_roll_ratio"),
        ];
        let has = |key: &String| content.columns.iter().any(|column| column.key == *key);
        // A skew angle lies between the two velocities: the case itself says that it needs them.
        let is_skewed = case.tree().entry("motion.skew_angle").is_some();
        let mean = 0.5 * (u_1 + u_2);
        if is_skewed || mean == 0.0 || !keys.iter().any(has) {
            continue;
        }
        let span = content
            .columns
            .first()
            .map_or(0..0, |column| column.span.clone());
        let n_rows = content.rows.len();
        for (key, value, unit) in [(&keys[0], mean, "m/s"), (&keys[1], (u_2 - u_1) / mean, "")] {
            if content.columns.iter().any(|column| column.key == *key) {
                continue;
            }
            let mut constant = column(key, span.clone());
            for _ in 0..n_rows {
                match unit {
                    "" => constant.push_number(span.clone(), value),
                    unit => constant.push(span.clone(), &value.to_string(), unit),
                }
            }
            content.columns.push(constant);
            let kept = format!(
                "{key} = {} {unit}, which follows from the case, applies to all rows",
                digits(value)
            );
            content.notes.push(kept.replace(" ,", ","));
        }
        return vec![key_1, key_2];
    }
    Vec::new()
}
