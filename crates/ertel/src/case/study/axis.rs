//! `[[axis]]`: lists and ranges.

use std::collections::HashMap;
use std::ops::Range;

use ertel_input::tree::{Entry, Node, Value};
use ertel_input::{Document, InputError, Table};
use ertel_quantity::Unit;

use super::MOST_POINTS;
use super::values::{self, AxisValue, Values, header};

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

/// Axes that vary together.
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
        let values = read_values(&mut table, node, &key)?;
        let zip = table.optional_str("zip")?.map(str::to_owned);
        // Values of axes side by side may repeat, points may not.
        if zip.is_none() {
            values::check_distinct(&table, "axis", &values)?;
        }
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
                        "`{}` has {} values, but `{}` next to it has {}",
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
    for group in &groups {
        check_points(group, study, offset)?;
    }
    Ok(groups)
}

/// Refuses points that occur twice in axes that vary together.
fn check_points(group: &Group, study: &Document, offset: usize) -> Result<(), InputError> {
    let mut seen = HashMap::new();
    for i in 0..group.len() {
        let point: Vec<_> = group
            .axes
            .iter()
            .map(|axis| axis.values[i].1.identity())
            .collect();
        if let Some(first) = seen.insert(point, i) {
            let node = &group.axes[0].values[i].0;
            let span = node.span.start - offset..node.span.end - offset;
            let message = format!(
                "value {} repeats value {} in all axes of this `zip`",
                i + 1,
                first + 1
            );
            return Err(study.error_at(span, "values", message));
        }
    }
    Ok(())
}

fn read_values(table: &mut Table<'_>, node: &Node, key: &str) -> Result<Values, InputError> {
    let keys = ["from", "to", "points", "spacing"];
    // Errors list the keys in the order in which they are asked for.
    for key in keys {
        table.contains(key);
    }
    if values::is_range(table, "an axis", &keys, "[\"10 N\", \"20 N\"]")? {
        return read_range(table, node, key);
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
        .map(|node| (node.clone(), AxisValue::of(key, node)))
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

fn read_range(table: &mut Table<'_>, node: &Node, axis: &str) -> Result<Values, InputError> {
    let end = |table: &mut Table<'_>, key: &'static str| {
        if !table.contains(key) {
            return Err(table.missing(key));
        }
        let entry = node.entry(key).expect("just seen");
        match AxisValue::of(axis, &entry.node) {
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
    let ends = [(from, from_node), (to, to_node)];
    values::range(table, node, ends, dimension, MOST_POINTS, Value::Float)
}
