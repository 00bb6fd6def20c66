//! Arrays of dents, bumps, grooves and ridges.

use ertel_input::{InputError, Table};
use ertel_quantity::Dimension;

use super::SIZE;
use crate::contact::gap::{Form, Repeat};
use crate::words::length;

/// How many at most.
const MOST: i64 = 1_000_000;

/// The form repeated by `pitch`, `count` and those across.
pub(super) fn read(table: &mut Table<'_>, form: Form) -> Result<Form, InputError> {
    let along = repeat(table, &form, ["pitch", "count"])?;
    let across = match form {
        Form::Round { .. } => repeat(table, &form, ["pitch_across", "count_across"])?,
        _ => None,
    };
    Ok(match along.is_some() || across.is_some() {
        false => form,
        true => Form::Repeated {
            form: Box::new(form),
            along,
            across,
        },
    })
}

fn repeat(
    table: &mut Table<'_>,
    form: &Form,
    [pitch_key, count_key]: [&str; 2],
) -> Result<Option<Repeat>, InputError> {
    let pitch = table.optional_quantity(pitch_key, Dimension::LENGTH, SIZE)?;
    let count = table.optional_integer(count_key, 1..=MOST)?;
    let Some(pitch) = pitch else {
        return match count {
            None => Ok(None),
            Some(_) => Err(table.error(count_key, format!("`{count_key}` needs `{pitch_key}`"))),
        };
    };
    if pitch < form.finest() {
        return Err(table.error(
            pitch_key,
            format!(
                "one overlaps the next: they are {} wide, and `{pitch_key}` is {}",
                length(form.finest()),
                length(pitch)
            ),
        ));
    }
    Ok(Some(Repeat {
        pitch,
        count: count.map(|n| n as u32),
    }))
}
