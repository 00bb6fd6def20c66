//! Values of an input: a list, or a range of equal steps or ratios.

use std::collections::HashSet;
use std::fmt;

use ertel_input::tree::{Node, Value};
use ertel_input::{InputError, Table};
use ertel_quantity::{Dimension, parse_any};

use super::text::inline;

/// Values as they go into the case, and as they are.
pub(in crate::case) type Values = Vec<(Node, AxisValue)>;

/// A value of an axis.
#[derive(Clone, Debug, PartialEq)]
pub enum AxisValue {
    /// A quantity or a pure number, in SI.
    Number(f64, Dimension),
    /// A name, a switch, or a table in short.
    Text(String),
}

impl AxisValue {
    /// Value of a key in a file: titles, names and files are text, whatever they look like.
    pub(super) fn of(key: &str, node: &Node) -> Self {
        match &node.value {
            Value::Str(text) if is_text_key(key) => Self::Text(text.clone()),
            Value::Integer(Some(number)) => Self::Number(*number as f64, Dimension::DIMENSIONLESS),
            Value::Float(number) => Self::Number(*number, Dimension::DIMENSIONLESS),
            Value::Str(text) => match parse_any(text) {
                Some((value, dimension)) => Self::Number(value, dimension),
                None => Self::Text(text.clone()),
            },
            _ => Self::Text(inline(node)),
        }
    }

    /// The number, if it is one.
    pub fn number(&self) -> Option<f64> {
        match self {
            Self::Number(value, _) => Some(*value),
            Self::Text(_) => None,
        }
    }

    /// Equal for equal values of one axis.
    pub(super) fn identity(&self) -> (Option<u64>, &str) {
        match self {
            // Both zeros are one.
            Self::Number(value, _) => (Some((value + 0.0).to_bits()), ""),
            Self::Text(text) => (None, text),
        }
    }

    /// Whether both fit in one column.
    pub(super) fn is_like(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Number(_, a), Self::Number(_, b)) => a.same_exponents(*b),
            (Self::Text(_), Self::Text(_)) => true,
            _ => false,
        }
    }

    pub(super) fn kind(&self) -> String {
        match self {
            Self::Number(_, dimension) => dimension.name().into_owned(),
            Self::Text(_) => "a text".to_owned(),
        }
    }
}

impl fmt::Display for AxisValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(value, dimension) => {
                let text = format!("{value} {}", dimension.si_unit());
                f.write_str(text.trim_end())
            }
            Self::Text(text) => f.write_str(text),
        }
    }
}

/// Keys whose values are text, by their last parts.
const TEXT_KEYS: [&str; 16] = [
    "title",
    "name",
    "file",
    "law",
    "kind",
    "source",
    "notes",
    "lubricant",
    "base_oil",
    "plane",
    "ball",
    "body_1",
    "body_2",
    "preset",
    "limit_law",
    "raceway_control",
];

/// Whether the values of a key are text: titles, names, files, choices.
pub(super) fn is_text_key(key: &str) -> bool {
    TEXT_KEYS.contains(&key.rsplit('.').next().unwrap_or(key))
}

/// Title of the column of a quantity: its key, and its SI unit.
pub(crate) fn header(key: &str, dimension: Dimension) -> String {
    match dimension.si_unit().as_str() {
        "" => key.to_owned(),
        unit => format!("{key}_{}", unit.replace('/', "_per_").replace('.', "_")),
    }
}

/// Whether the values of `one`, a curve or an axis, are a range and not a list; a range has one of `keys` at least.
pub(in crate::case) fn is_range(
    table: &mut Table<'_>,
    one: &str,
    keys: &[&str],
    example: &str,
) -> Result<bool, InputError> {
    if !table.contains("values") {
        if keys.iter().any(|key| table.contains(key)) {
            return Ok(true);
        }
        return Err(table.missing("values").with_help(format!(
            "a list, values = {example}, or a range: `from`, `to`, `points` and `spacing`"
        )));
    }
    match ["from", "to", "points", "spacing"]
        .iter()
        .find(|key| table.contains(key))
    {
        None => Ok(false),
        Some(key) => Err(table.error(
            key,
            format!("`values` and `{key}` are both given: {one} is a list or a range"),
        )),
    }
}

/// Refuses values that occur twice in a list.
pub(in crate::case) fn check_distinct(
    table: &Table<'_>,
    name: &str,
    values: &Values,
) -> Result<(), InputError> {
    let mut seen = HashSet::new();
    match (values.iter()).position(|(_, value)| !seen.insert(value.identity())) {
        None => Ok(()),
        Some(i) => Err(table.error(
            "values",
            format!("value {} of the {name} repeats an earlier one", i + 1),
        )),
    }
}

/// The values of a range from its ends; `node` is the table, and `pure_number` how a value between the ends goes into the case
/// where it has no unit.
pub(in crate::case) fn range(
    table: &mut Table<'_>,
    node: &Node,
    [(from, from_node), (to, to_node)]: [(f64, Node); 2],
    dimension: Dimension,
    most_points: usize,
    pure_number: fn(f64) -> Value,
) -> Result<Values, InputError> {
    let n_points = table.required_integer("points", 2..=most_points as i64)?;
    let is_log = table
        .optional_choice("spacing", &[("linear", false), ("log", true)])?
        .unwrap_or(false);
    if from == to {
        return Err(table.error("to", "`to` equals `from`: the range has no length"));
    }
    if is_log && from * to <= 0.0 {
        let key = if from == 0.0 { "from" } else { "to" };
        let problem = "a logarithmic range cannot include zero";
        return Err(table
            .error(key, problem)
            .with_help("spacing = \"linear\" can"));
    }
    let span = node.entry("points").map_or(0..0, |e| e.node.span.clone());
    let unit = dimension.si_unit();
    let between = |i: i64| {
        let t = i as f64 / (n_points - 1) as f64;
        let value = match is_log {
            true => from * (to / from).powf(t),
            false => from + t * (to - from),
        };
        // As many digits as anyone wants to read; the case has the same ones.
        let value: f64 = format!("{value:.5e}").parse().unwrap_or(value);
        let given = match unit.as_str() {
            "" => pure_number(value),
            unit => Value::Str(format!("{value} {unit}")),
        };
        let span = span.clone();
        (Node { span, value: given }, value)
    };
    let mut values = vec![(from_node, from)];
    values.extend((1..n_points - 1).map(between));
    values.push((to_node, to));
    let value = |(node, value)| (node, AxisValue::Number(value, dimension));
    Ok(values.into_iter().map(value).collect())
}
