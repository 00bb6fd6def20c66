//! `[[axis]]`: lists and ranges.

use std::collections::HashSet;
use std::fmt;
use std::ops::Range;

use ertel_rheology::input::tree::{Entry, Node, Value};
use ertel_rheology::input::{Document, InputError, Table};
use ertel_rheology::quantity::{Dimension, Unit, parse_any};

use super::MOST_POINTS;
use super::text::inline;
use crate::case::curve::read_spacing;

/// A value of an axis.
#[derive(Clone, Debug, PartialEq)]
pub enum AxisValue {
    /// A quantity or a pure number, in SI.
    Number(f64, Dimension),
    /// A name, a switch, or a table in short.
    Text(String),
}

impl AxisValue {
    /// What a value in a file stands for.
    pub(super) fn of(node: &Node) -> Self {
        match &node.value {
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
    fn identity(&self) -> (Option<u64>, &str) {
        match self {
            // Both zeros are one.
            Self::Number(value, _) => (Some((value + 0.0).to_bits()), ""),
            Self::Text(text) => (None, text),
        }
    }

    /// Whether both can stand in one column.
    fn is_like(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Number(_, a), Self::Number(_, b)) => a.same_exponents(*b),
            (Self::Text(_), Self::Text(_)) => true,
            _ => false,
        }
    }

    fn kind(&self) -> String {
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

/// A key with the values it takes.
#[derive(Clone, Debug)]
pub(super) struct Axis {
    /// Key path in the case.
    pub key: String,
    /// Where errors about the key point.
    pub key_span: Range<usize>,
    /// The values, as they go into the case and as they are.
    pub values: Vec<(Node, AxisValue)>,
}

impl Axis {
    /// Title of its column.
    pub fn header(&self) -> String {
        match self.values.first() {
            Some((_, AxisValue::Number(_, dimension))) => header(&self.key, *dimension),
            _ => self.key.clone(),
        }
    }

    /// The unit of its first value as the user wrote it; empty where there is none.
    pub fn unit(&self) -> String {
        let given = match self.values.first() {
            Some((node, AxisValue::Number(..))) => match &node.value {
                Value::Str(text) => text.as_str(),
                _ => "",
            },
            _ => "",
        };
        let unit = given.split_once(' ').map_or("", |(_, unit)| unit.trim());
        match Unit::parse(unit) {
            Ok(_) => unit.to_owned(),
            // A quantity with its uncertainty, or one without a blank before its unit.
            Err(_) => String::new(),
        }
    }
}

/// Title of the column of a quantity: its key, and its SI unit.
pub(super) fn header(key: &str, dimension: Dimension) -> String {
    match dimension.si_unit().as_str() {
        "" => key.to_owned(),
        unit => format!("{key}_{}", unit.replace('/', "_per_").replace('.', "_")),
    }
}

/// Axes that go side by side.
#[derive(Clone, Debug, Default)]
pub(super) struct Group {
    /// Its name, if it has one.
    pub name: Option<String>,
    /// The axes, all of the same length.
    pub axes: Vec<Axis>,
}

impl Group {
    /// Number of values.
    pub fn len(&self) -> usize {
        self.axes.first().map_or(0, |axis| axis.values.len())
    }
}

/// Reads all `[[axis]]`; spans are moved on by `offset`.
pub(super) fn read(
    root: &mut Table<'_>,
    study: &Document,
    offset: usize,
) -> Result<Vec<Group>, InputError> {
    let mut groups: Vec<Group> = Vec::new();
    let tables = root.tables("axis")?;
    let nodes: &[Node] = match study.tree().entry("axis").map(|entry| &entry.node.value) {
        Some(Value::Array(nodes)) => nodes,
        _ => &[],
    };
    for (mut table, node) in tables.into_iter().zip(nodes) {
        let key = table
            .required_str("key")
            .map_err(|error| {
                error.with_help("the input that varies, as in key = \"motion.entrainment_speed\"")
            })?
            .to_owned();
        if key.split('.').any(str::is_empty) {
            return Err(table.error("key", format!("`{key}` is no key of a case file")));
        }
        let values = read_values(&mut table, node)?;
        let mut seen = HashSet::new();
        if let Some(i) = (values.iter()).position(|(_, value)| !seen.insert(value.identity())) {
            return Err(table.error(
                "values",
                format!("value {} of the axis repeats an earlier one", i + 1),
            ));
        }
        let zip = table.optional_str("zip")?.map(str::to_owned);
        let at_key = node.entry("key").map_or(0..0, |e| e.node.span.clone());
        let axis = Axis {
            key_span: at_key.start + offset..at_key.end + offset,
            key,
            values: values
                .into_iter()
                .map(|(node, value)| (node.shifted(offset), value))
                .collect(),
        };
        match groups.iter_mut().find(|g| zip.is_some() && g.name == zip) {
            None => groups.push(Group {
                name: zip,
                axes: vec![axis],
            }),
            Some(group) if group.len() == axis.values.len() => group.axes.push(axis),
            Some(group) => {
                return Err(table.error(
                    "zip",
                    format!(
                        "`{}` has {} values, but `{}` beside it has {}",
                        axis.key,
                        axis.values.len(),
                        group.axes[0].key,
                        group.len()
                    ),
                ));
            }
        }
        table.finish()?;
    }
    Ok(groups)
}

type Values = Vec<(Node, AxisValue)>;

fn read_values(table: &mut Table<'_>, node: &Node) -> Result<Values, InputError> {
    let is_range = ["from", "to", "points", "spacing"].map(|key| table.contains(key));
    if !table.contains("values") {
        if is_range.contains(&true) {
            return read_range(table, node);
        }
        return Err(table.missing("values").with_help(
            "a list, values = [\"10 N\", \"20 N\"], or a range: `from`, `to`, `points` and `spacing`",
        ));
    }
    if let Some(i) = is_range.iter().position(|given| *given) {
        let key = ["from", "to", "points", "spacing"][i];
        return Err(table.error(
            key,
            format!("`values` and `{key}` are both given: an axis is a list or a range"),
        ));
    }
    let Some(Entry {
        node: Node {
            value: Value::Array(nodes),
            ..
        },
        ..
    }) = node.entry("values")
    else {
        return Err(table.error("values", "`values` must be an array"));
    };
    if nodes.is_empty() {
        return Err(table.error("values", "the axis has no values"));
    }
    if nodes.len() > MOST_POINTS {
        let message = format!(
            "the axis has {} values, but a study has at most {MOST_POINTS} points",
            nodes.len()
        );
        return Err(table.error("values", message));
    }
    let values: Values = nodes
        .iter()
        .map(|node| (node.clone(), AxisValue::of(node)))
        .collect();
    let first = &values[0].1;
    if let Some(i) = values.iter().position(|(_, value)| !value.is_like(first)) {
        return Err(table.error(
            "values",
            format!(
                "value {} of the axis is {}, but the first one is {}",
                i + 1,
                values[i].1.kind(),
                first.kind()
            ),
        ));
    }
    Ok(values)
}

fn read_range(table: &mut Table<'_>, node: &Node) -> Result<Values, InputError> {
    let end = |table: &mut Table<'_>, key: &'static str| {
        if !table.contains(key) {
            return Err(table.missing(key));
        }
        let entry = node.entry(key).expect("just seen");
        match AxisValue::of(&entry.node) {
            AxisValue::Number(value, dimension) if value.is_finite() => {
                Ok((value, dimension, entry.node.clone()))
            }
            _ => Err(table
                .error(key, format!("`{key}` must be a finite number or quantity"))
                .with_help("write it as \"0.1 m/s\"; names go into `values`")),
        }
    };
    let (from, dimension, from_node) = end(table, "from")?;
    let (to, other, to_node) = end(table, "to")?;
    if !dimension.same_exponents(other) {
        return Err(table.error(
            "to",
            format!(
                "`to` is {}, but `from` is {}",
                other.name(),
                dimension.name()
            ),
        ));
    }
    let points = table.required_integer("points", 2..=MOST_POINTS as i64)?;
    let log = read_spacing(table, from, to)?;
    let last = (points - 1) as f64;
    let unit = dimension.si_unit();
    let at_points = node.entry("points").map_or(0..0, |e| e.node.span.clone());
    let between = |i: i64| {
        let t = i as f64 / last;
        let value = match log {
            true => from * (to / from).powf(t),
            false => from + t * (to - from),
        };
        // As many digits as anyone wants to read; the case has the same ones.
        let value: f64 = format!("{value:.5e}").parse().unwrap_or(value);
        let node = Node {
            span: at_points.clone(),
            value: match unit.as_str() {
                "" => Value::Float(value),
                unit => Value::Str(format!("{value} {unit}")),
            },
        };
        (node, AxisValue::Number(value, dimension))
    };
    let values = (0..points).map(|i| match i {
        0 => (from_node.clone(), AxisValue::Number(from, dimension)),
        _ if i + 1 == points => (to_node.clone(), AxisValue::Number(to, dimension)),
        _ => between(i),
    });
    Ok(values.collect())
}
