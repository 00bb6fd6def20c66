//! Keys that change nothing where a table in `[transient]` gives the quantity over all of the time.

use ertel_input::{Document, InputError};

use super::Setting;

/// Keys of the case, and the tables of `[transient]` that take their place; all other courses begin at the value of the key.
const REPLACED: [(&str, &str); 9] = [
    ("contact.load", "load"),
    ("contact.radius", "radius"),
    ("motion.entrainment_speed", "entrainment_speed"),
    ("motion.slide_to_roll_ratio", "slide_to_roll_ratio"),
    ("motion.body_1_speed", "body_1_speed"),
    ("motion.body_2_speed", "body_2_speed"),
    ("inlet.oil_layer", "oil_layer"),
    ("temperature", "temperature"),
    ("lubricant.temperature", "temperature"),
];

/// Refuses a value that no point would use.
pub(super) fn check_effect(document: &Document, setting: &Setting) -> Result<(), InputError> {
    let replaced = REPLACED.iter().filter(|(key, _)| *key == setting.key);
    for (key, course) in replaced {
        let path = format!("transient.{course}");
        let kind = document.tree().entry(&format!("{path}.course"));
        let is_table = kind.is_some_and(|entry| {
            matches!(&entry.node.value, ertel_input::tree::Value::Str(kind) if kind == "table")
        });
        if is_table {
            let message = format!(
                "`{key}` changes nothing: the table `{course}` in [transient] gives it over all of the time"
            );
            return Err(document
                .error_at(setting.key_span.clone(), key, message)
                .with_help(format!(
                    "vary a key of [transient], such as `{path}.values`, or take a ramp, a sine or a step, which begin at `{key}`"
                )));
        }
    }
    Ok(())
}
