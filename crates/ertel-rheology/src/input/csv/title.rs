//! Titles of columns: a name and a unit.

/// What follows the name in the title of a column.
pub(super) struct Title {
    /// The text after the name, as a unit.
    pub(super) unit: String,
    /// Whether the name ends there for certain: a bracket follows, or nothing.
    pub(super) is_exact: bool,
}

impl Title {
    /// `MPa` of `Pressure_MPa`, `pressure [MPa]`, `pressure (MPa)`; `None` of another column.
    pub(super) fn of(title: &str, name: &str) -> Option<Self> {
        let head = title.get(..name.len())?;
        if !head.replace('_', " ").eq_ignore_ascii_case(name) {
            return None;
        }
        let rest = &title[name.len()..];
        if let Some(unit) = rest.trim().strip_prefix(['[', '(']) {
            let unit = unit.trim_end();
            return Some(Self {
                unit: unit
                    .strip_suffix([']', ')'])
                    .unwrap_or(unit)
                    .trim()
                    .to_owned(),
                is_exact: true,
            });
        }
        match rest.strip_prefix(['_', ' ']) {
            Some(unit) => Some(Self {
                unit: unit.replace("_per_", "/").replace('_', " "),
                is_exact: false,
            }),
            None => rest.is_empty().then(|| Self {
                unit: String::new(),
                is_exact: true,
            }),
        }
    }
}
