//! The choice that a misspelt word is meant for.

/// The choice most like `name`, if any is like it.
pub(crate) fn nearest<'n>(
    name: &str,
    choices: impl IntoIterator<Item = &'n str>,
) -> Option<&'n str> {
    let name = name.to_lowercase();
    let choices: Vec<&str> = choices.into_iter().collect();
    // A number at the end that no key has: `kinematic_viscosity_70` is meant for the key without one.
    let stem = name.trim_end_matches(|c: char| c.is_ascii_digit());
    let stem = stem.strip_suffix('_').filter(|_| stem.len() < name.len());
    if let Some(choice) = choices.iter().find(|choice| Some(**choice) == stem) {
        return Some(choice);
    }
    (choices.into_iter())
        .map(|choice| (strsim::osa_distance(&name, &choice.to_lowercase()), choice))
        .filter(|(distance, choice)| {
            // A third of the letters may differ (`raduis`, `visosity`), more after a common start (`circle`).
            3 * distance <= choice.chars().count().max(3)
                || strsim::jaro_winkler(&name, choice) > 0.87
        })
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, choice)| choice)
}
