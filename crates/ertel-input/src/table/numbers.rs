//! Readers of quantities and numbers.

use std::ops::RangeInclusive;

use super::Table;
use crate::tree::{Node, Value};
use crate::{Bounds, InputError, unit_meant};
use ertel_quantity::{Dimension, QuantityError, Uncertainty};

impl Table<'_> {
    /// A number with a unit, in SI; a pure number may be written without quotes.
    ///
    /// # Errors
    ///
    /// A missing key, a text that is no such quantity, a value that is not finite or out of `bounds` (SI).
    pub fn required_quantity(
        &mut self,
        key: &str,
        dimension: Dimension,
        bounds: Bounds,
    ) -> Result<f64, InputError> {
        self.optional_quantity(key, dimension, bounds)?
            .ok_or_else(|| self.missing(key))
    }

    /// Like [`Table::required_quantity`], `None` if the key is absent.
    ///
    /// # Errors
    ///
    /// Those of [`Table::required_quantity`] but for the missing key.
    pub fn optional_quantity(
        &mut self,
        key: &str,
        dimension: Dimension,
        bounds: Bounds,
    ) -> Result<Option<f64>, InputError> {
        let Some(entry) = self.entry(key) else {
            return Ok(None);
        };
        let (value, uncertainty) = self.uncertain_of(&entry.node, key, dimension, bounds)?;
        let Some(inputs) = &self.inputs else {
            return Ok(Some(value));
        };
        let path = self.path_of(key);
        match inputs.read(&path, (value, dimension), uncertainty, false) {
            Some(other) if bounds.contains(other) => Ok(Some(other)),
            Some(_) => Err(self.out_of(&entry.node, key, dimension, bounds)),
            None => Ok(Some(value)),
        }
    }

    /// Notes `value` (SI) for the key that is absent, an estimate with an uncertainty, among the quantities read. Returns the value to
    /// reckon with: another one where the document is read with a value in its place.
    pub fn estimated_quantity(
        &self,
        key: &str,
        value: f64,
        dimension: Dimension,
        uncertainty: Uncertainty,
    ) -> f64 {
        let path = self.path_of(key);
        let inputs = self.inputs.as_ref();
        inputs
            .and_then(|inputs| inputs.read(&path, (value, dimension), Some(uncertainty), true))
            .unwrap_or(value)
    }

    /// A pure number: `0.3`, or a text such as `"30 %"`.
    ///
    /// # Errors
    ///
    /// As [`Table::required_quantity`].
    pub fn required_number(&mut self, key: &str, bounds: Bounds) -> Result<f64, InputError> {
        self.required_quantity(key, Dimension::DIMENSIONLESS, bounds)
    }

    /// Like [`Table::required_number`], `None` if the key is absent.
    ///
    /// # Errors
    ///
    /// As [`Table::optional_quantity`].
    pub fn optional_number(
        &mut self,
        key: &str,
        bounds: Bounds,
    ) -> Result<Option<f64>, InputError> {
        self.optional_quantity(key, Dimension::DIMENSIONLESS, bounds)
    }

    /// An array of quantities in SI: `["1 MPa", "2 MPa"]`, or pure numbers.
    ///
    /// # Errors
    ///
    /// As [`Table::required_quantity`] for each of the values.
    pub fn required_quantities(
        &mut self,
        key: &str,
        dimension: Dimension,
        bounds: Bounds,
    ) -> Result<Vec<f64>, InputError> {
        self.optional_quantities(key, dimension, bounds)?
            .ok_or_else(|| self.missing(key))
    }

    /// Like [`Table::required_quantities`], `None` if the key is absent.
    ///
    /// # Errors
    ///
    /// As [`Table::optional_quantity`] for each of the values.
    pub fn optional_quantities(
        &mut self,
        key: &str,
        dimension: Dimension,
        bounds: Bounds,
    ) -> Result<Option<Vec<f64>>, InputError> {
        let Some(nodes) = self.optional_array(key, "an array")? else {
            return Ok(None);
        };
        nodes
            .iter()
            .map(|node| self.quantity_of(node, key, dimension, bounds))
            .collect::<Result<_, _>>()
            .map(Some)
    }

    /// An array of pure numbers.
    ///
    /// # Errors
    ///
    /// As [`Table::required_quantity`] for each of the values.
    pub fn required_numbers(&mut self, key: &str, bounds: Bounds) -> Result<Vec<f64>, InputError> {
        self.required_quantities(key, Dimension::DIMENSIONLESS, bounds)
    }

    /// Like [`Table::required_numbers`], `None` if the key is absent.
    ///
    /// # Errors
    ///
    /// As [`Table::optional_quantity`] for each of the values.
    pub fn optional_numbers(
        &mut self,
        key: &str,
        bounds: Bounds,
    ) -> Result<Option<Vec<f64>>, InputError> {
        self.optional_quantities(key, Dimension::DIMENSIONLESS, bounds)
    }

    /// An array of points of two pure numbers each, `[[-1, 0], [0.5, 0]]`; `None` if the key is absent.
    ///
    /// # Errors
    ///
    /// A value that is no such array, and numbers out of `bounds`.
    pub fn optional_points(
        &mut self,
        key: &str,
        bounds: Bounds,
    ) -> Result<Option<Vec<[f64; 2]>>, InputError> {
        let Some(nodes) = self.optional_array(key, "an array of points [x, y]")? else {
            return Ok(None);
        };
        let number = |node| self.quantity_of(node, key, Dimension::DIMENSIONLESS, bounds);
        nodes
            .iter()
            .map(|node| match &node.value {
                Value::Array(pair) if pair.len() == 2 => Ok([number(&pair[0])?, number(&pair[1])?]),
                _ => Err(self.at_node(
                    node,
                    key,
                    format!("`{key}` needs points of two numbers, [x, y]"),
                )),
            })
            .collect::<Result<_, _>>()
            .map(Some)
    }

    /// A whole number in `range`.
    ///
    /// # Errors
    ///
    /// A missing key, a value that is no whole number or out of range.
    pub fn required_integer(
        &mut self,
        key: &str,
        range: RangeInclusive<i64>,
    ) -> Result<i64, InputError> {
        self.optional_integer(key, range)?
            .ok_or_else(|| self.missing(key))
    }

    /// Like [`Table::required_integer`], `None` if the key is absent.
    ///
    /// # Errors
    ///
    /// A value that is no whole number or out of range.
    pub fn optional_integer(
        &mut self,
        key: &str,
        range: RangeInclusive<i64>,
    ) -> Result<Option<i64>, InputError> {
        let Some(entry) = self.entry(key) else {
            return Ok(None);
        };
        let Value::Integer(value) = entry.node.value else {
            return Err(self.wrong_kind(entry, "a whole number"));
        };
        match value {
            Some(value) if range.contains(&value) => Ok(Some(value)),
            _ => Err(self.error(
                key,
                format!(
                    "`{key}` must be a whole number from {} to {}",
                    range.start(),
                    range.end()
                ),
            )),
        }
    }

    /// One of several, without an uncertainty.
    fn quantity_of(
        &self,
        node: &Node,
        key: &str,
        dimension: Dimension,
        bounds: Bounds,
    ) -> Result<f64, InputError> {
        match self.uncertain_of(node, key, dimension, bounds)? {
            (value, None) => Ok(value),
            (_, Some(_)) => Err(self.at_node(
                node,
                key,
                format!("values in the list `{key}` cannot have an uncertainty"),
            )),
        }
    }

    fn uncertain_of(
        &self,
        node: &Node,
        key: &str,
        dimension: Dimension,
        bounds: Bounds,
    ) -> Result<(f64, Option<Uncertainty>), InputError> {
        let bare = |value: f64| {
            if dimension == Dimension::DIMENSIONLESS {
                Ok(value)
            } else {
                Err(self
                    .at_node(node, key, format!("`{key}` has no unit"))
                    .with_label(format!("{} is needed", dimension.name()))
                    .with_help(self.with_unit(node, key, dimension, value)))
            }
        };
        let (value, uncertainty) = match &node.value {
            Value::Float(value) if !value.is_finite() => {
                return Err(self.at_node(node, key, format!("`{key}` must be a finite number")));
            }
            Value::Float(value) => (bare(*value)?, None),
            // Exact for every integer a person writes.
            Value::Integer(Some(value)) => (bare(*value as f64)?, None),
            Value::Str(text) => {
                ertel_quantity::parse_uncertain(text, dimension).map_err(|error| {
                    let refused = self.at_node(node, key, describe(&error, key));
                    let number = match &error {
                        QuantityError::MissingUnit { text, .. } => text.trim().parse().ok(),
                        _ => None,
                    };
                    let proposal = number.map(|value| self.with_unit(node, key, dimension, value));
                    (error.advice().into_iter().chain(proposal))
                        .fold(refused, InputError::with_help)
                })?
            }
            _ => {
                let example = dimension.si_unit();
                let message = if example.is_empty() {
                    format!("`{key}` must be a number, not {}", node.kind())
                } else {
                    format!(
                        "`{key}` must be a number with a unit, such as \"1.5 {example}\", not {}",
                        node.kind()
                    )
                };
                return Err(self.at_node(node, key, message));
            }
        };
        if !bounds.contains(value) {
            return Err(self.out_of(node, key, dimension, bounds));
        }
        if let Some(uncertainty) = uncertainty {
            let reach = uncertainty.reach();
            let ends = [value - reach, value + reach];
            if let Some(end) = ends.iter().find(|end| !bounds.contains(**end)) {
                let unit = dimension.si_unit();
                return Err(self
                    .at_node(
                        node,
                        key,
                        format!(
                            "the uncertainty of `{key}` reaches {end:.4e} {unit}, but it must be {}",
                            bounds.describe(&unit)
                        ),
                    )
                    .with_help(
                        "a ± reaches four standard deviations, twice as far as it says; limits, \"[36, 44] mPa.s\", reach no further",
                    ));
            }
        }
        Ok((value, uncertainty))
    }

    /// How to write the number with the unit that is most likely meant.
    fn with_unit(&self, node: &Node, key: &str, dimension: Dimension, value: f64) -> String {
        let number = self
            .source
            .slice(node.span.clone())
            .trim_matches(['"', '\''])
            .trim();
        let unit = unit_meant(&self.path_of(key), dimension, value);
        format!(
            "write it as a text, `{key} = \"{number} {unit}\"`; units: {}",
            dimension.examples()
        )
    }

    fn out_of(&self, node: &Node, key: &str, dimension: Dimension, bounds: Bounds) -> InputError {
        let must = bounds.describe(&dimension.si_unit());
        self.at_node(node, key, format!("`{key}` must be {must}"))
    }
}

/// The message of a quantity error, in terms of the key.
fn describe(error: &QuantityError, key: &str) -> String {
    match error {
        QuantityError::WrongDimension {
            text,
            found,
            expected,
        } => format!(
            "`{text}` is {}, but `{key}` needs {} ({})",
            found.name(),
            expected.name(),
            expected.examples()
        ),
        QuantityError::MissingUnit { text, expected } => format!(
            "`{text}` has no unit, but `{key}` needs {} ({})",
            expected.name(),
            expected.examples()
        ),
        QuantityError::NotFinite { .. } => format!("`{key}` must be a finite number"),
        other => other.to_string(),
    }
}
