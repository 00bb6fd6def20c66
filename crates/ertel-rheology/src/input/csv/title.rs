//! Titles of columns: a name and a unit.

use crate::quantity::{Dimension, Unit};

/// What follows the name in the title of a column.
pub(super) struct Title {
    /// The text after the name, as a unit.
    pub(super) unit: String,
    /// Whether the name ends there for certain: a bracket follows, or nothing.
    pub(super) is_exact: bool,
}

impl Title {
    /// The unit, if it measures that. `mm_s` is read as a product, or else as the quotient that it mostly means.
    pub(super) fn unit_of(&self, dimension: Dimension) -> Option<Unit> {
        let fits = |unit: &Unit| unit.dimension().same_exponents(dimension);
        let as_written = Unit::parse(&self.unit).ok().filter(fits);
        as_written.or_else(|| {
            let (above, below) = self.unit.split_once(' ').filter(|_| !self.is_exact)?;
            Unit::parse(&format!("{above}/{below}")).ok().filter(fits)
        })
    }

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
