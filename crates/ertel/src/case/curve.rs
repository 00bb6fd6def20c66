//! `[curve]`: a list or range of one quantity of the case.
//!
//! ```toml
//! [curve]
//! quantity = "motion.entrainment_speed"
//! values = ["0.1 m/s", "0.2 m/s", "0.5 m/s"]
//! # or: from = "0.1 m/s", to = "10 m/s", points = 9, spacing = "log"
//! ```
//!
//! Each point is the case read again with this value instead of the file's: every check
//! applies; errors point to the line of the curve.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::LazyLock;

use ertel_input::keys::{Kind, MACHINES};
use ertel_input::tree::{Node, Value};
use ertel_input::{Bounds, Document, InputError, Table};
use ertel_quantity::Dimension;
use ertel_quantity::Dimension as D;

use super::Case;
use super::study::values::{self, AxisValue, Values};
use super::study::{Setting, StudyPoint};
use crate::contact::Contact;

/// Points of one curve, at most: more indicate a wrong number.
const MOST_POINTS: usize = 1000;

/// A curve: one quantity varies, everything else is the same.
#[derive(Clone, Debug)]
pub struct Curve {
    /// The varied quantity.
    pub quantity: Quantity,
    /// The points in the order in which they are solved, at least two.
    pub points: Vec<StudyPoint>,
    /// Whether each point's results are also written to a separate folder.
    pub folders: bool,
    /// Whether each point is also solved without shear thinning.
    pub newtonian: bool,
    /// Whether each point is also solved without heat.
    pub isothermal: bool,
}

/// A quantity that may vary.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantity {
    /// Key path in the case file.
    pub path: &'static str,
    /// Its name in words.
    pub name: &'static str,
    /// Its symbol, in the markup of picture labels.
    pub symbol: &'static str,
    /// Its dimension.
    pub dimension: Dimension,
}

/// The quantities in order of the documentation; the load is a force here, in line contacts a force per length.
const QUANTITIES: [Quantity; 28] = [
    quantity(
        "motion.entrainment_speed",
        "entrainment speed",
        "*u*_{m}",
        D::SPEED,
    ),
    quantity(
        "motion.slide_to_roll_ratio",
        "slide-to-roll ratio",
        "",
        D::DIMENSIONLESS,
    ),
    quantity("motion.ball_speed", "speed of body 2", "", D::SPEED),
    quantity("motion.plane_speed", "speed of body 1", "", D::SPEED),
    quantity("motion.body_1_speed", "speed of body 1", "", D::SPEED),
    quantity("motion.body_2_speed", "speed of body 2", "", D::SPEED),
    quantity("contact.load", "load", "*F*", D::FORCE),
    quantity(
        "contact.hertz_pressure",
        "Hertz pressure",
        "*p*_{h}",
        D::PRESSURE,
    ),
    quantity("contact.radius", "radius", "*R*", D::LENGTH),
    quantity("inlet.oil_layer", "oil layer", "*h*_{oil}", D::LENGTH),
    quantity(
        "inlet.meniscus_distance",
        "distance of the meniscus",
        "",
        D::LENGTH,
    ),
    quantity(
        "machine.entrainment_speed",
        "entrainment speed",
        "*u*_{m}",
        D::SPEED,
    ),
    quantity(
        "machine.slide_to_roll_ratio",
        "slide-to-roll ratio",
        "",
        D::DIMENSIONLESS,
    ),
    quantity("machine.ball_speed", "speed of the ball", "", D::SPEED),
    quantity("machine.disc_speed", "speed of the disc", "", D::SPEED),
    quantity("machine.load", "load", "*F*", D::FORCE),
    quantity("machine.ball_load", "ball load", "*F*", D::FORCE),
    quantity(
        "machine.radial_load",
        "radial load of the bearing",
        "*F*_{r}",
        D::FORCE,
    ),
    quantity(
        "machine.axial_load",
        "axial load of the bearing",
        "*F*_{a}",
        D::FORCE,
    ),
    quantity("machine.roller_load", "roller load", "*F*", D::FORCE),
    quantity(
        "machine.hertz_pressure",
        "Hertz pressure",
        "*p*_{h}",
        D::PRESSURE,
    ),
    quantity(
        "machine.inner_ring_speed",
        "speed of the inner ring",
        "",
        D::ANGULAR_SPEED,
    ),
    quantity(
        "machine.outer_ring_speed",
        "speed of the outer ring",
        "",
        D::ANGULAR_SPEED,
    ),
    quantity(
        "machine.pinion_speed",
        "speed of the pinion",
        "",
        D::ANGULAR_SPEED,
    ),
    quantity(
        "machine.pinion_torque",
        "torque of the pinion",
        "",
        D::ENERGY,
    ),
    quantity(
        "machine.cam_speed",
        "speed of the cam",
        "",
        D::ANGULAR_SPEED,
    ),
    quantity("temperature", "temperature", "*T*", D::TEMPERATURE),
    quantity(
        "lubricant.temperature",
        "temperature",
        "*T*",
        D::TEMPERATURE,
    ),
];

/// All keys of machines that have a number, which may vary as well.
static OF_MACHINES: LazyLock<Vec<Quantity>> = LazyLock::new(|| {
    let rows = MACHINES.iter().flat_map(|(_, rows)| rows.iter());
    let mut found: Vec<Quantity> = Vec::new();
    for row in rows {
        let dimension = match row.kind {
            Kind::Number => Dimension::DIMENSIONLESS,
            Kind::Quantity([dimension]) => *dimension,
            _ => continue,
        };
        for key in row.keys {
            let path = format!("machine.{key}");
            let mut known = QUANTITIES.iter().chain(&found);
            if !known.any(|q| q.path == path) {
                let name = key.replace('_', " ").leak();
                found.push(quantity(path.leak(), name, "", dimension));
            }
        }
    }
    found
});

const fn quantity(
    path: &'static str,
    name: &'static str,
    symbol: &'static str,
    dimension: Dimension,
) -> Quantity {
    Quantity {
        path,
        name,
        symbol,
        dimension,
    }
}

impl Quantity {
    /// The last key of the path, by which results call the quantity.
    pub fn key(&self) -> &'static str {
        self.path.rsplit('.').next().unwrap_or(self.path)
    }

    /// SI unit, `m/s`; empty for a pure number.
    pub fn unit(&self) -> String {
        match self.is_torque() {
            true => "N m".to_owned(),
            false => self.dimension.si_unit(),
        }
    }

    /// Whether it is a torque: machines have no energies.
    pub fn is_torque(&self) -> bool {
        self.dimension == Dimension::ENERGY && self.path.starts_with("machine.")
    }
}

/// Reads `[curve]`, if there is one; `base` is the case without it.
pub(super) fn read(
    document: &Document,
    folder: &Path,
    base: &Case,
) -> Result<Option<Curve>, InputError> {
    let Some(mut table) = document.root().optional_table("curve")? else {
        return Ok(None);
    };
    let quantity = read_quantity(document, &mut table, &base.contact)?;
    const RANGE: [&str; 3] = ["from", "to", "points"];
    const EXAMPLE: &str = "[\"0.1 m/s\", \"0.2 m/s\"]";
    let curve = document.tree().entry("curve");
    let node = &curve.expect("it was read").node;
    let values = match values::is_range(&mut table, "a curve", &RANGE, EXAMPLE)? {
        true => read_range(&mut table, node, quantity.dimension)?,
        false => read_list(&mut table, node, quantity.dimension)?,
    };
    let folders = table.optional_bool("folders")?.unwrap_or(false);
    let newtonian = table.optional_bool("newtonian")?.unwrap_or(false);
    if newtonian && base.shear_thinning().is_none() {
        let reason = if base.solver.newtonian {
            "[solver] already makes this curve Newtonian: `newtonian` of [curve] has nothing to compare"
        } else {
            "this lubricant has no shear thinning: its curve is already Newtonian"
        };
        return Err(table.error("newtonian", reason));
    }
    let isothermal = table.optional_bool("isothermal")?.unwrap_or(false);
    if isothermal && base.thermal().is_none() {
        let reason = if base.solver.isothermal {
            "[solver] already makes this curve isothermal: `isothermal` of [curve] has nothing to compare"
        } else {
            "without [thermal] this curve is already isothermal"
        };
        return Err(table.error("isothermal", reason));
    }
    if newtonian || isothermal {
        let key = if newtonian { "newtonian" } else { "isothermal" };
        check_second_contact(&table, key, base)?;
    }
    table.finish()?;
    let points = values
        .into_iter()
        .map(|(node, value)| point(document, folder, &quantity, node, value))
        .collect::<Result<_, _>>()?;
    Ok(Some(Curve {
        quantity,
        points,
        folders,
        newtonian,
        isothermal,
    }))
}

/// Refuses the second contact that `key` adds to each point of a case in time or of a machine.
fn check_second_contact(table: &Table<'_>, key: &str, base: &Case) -> Result<(), InputError> {
    let (contact, case, help) = if base.transient.is_some() {
        let help = format!("use a study with an [[axis]] over `solver.{key}`");
        ("a steady contact", "changes in time", help)
    } else if base.whole.is_some() {
        let help = "choose one of its contacts in [machine], or make two curves of it";
        ("a single contact", "is a whole machine", help.to_owned())
    } else {
        return Ok(());
    };
    let text = format!("`{key}` adds {contact} to each point, but this case {case}");
    Err(table.error(key, text).with_help(help))
}

fn read_quantity(
    document: &Document,
    table: &mut Table<'_>,
    contact: &Contact,
) -> Result<Quantity, InputError> {
    let (present, absent): (Vec<Quantity>, Vec<Quantity>) = (QUANTITIES.iter())
        .chain(OF_MACHINES.iter())
        .partition(|q| document.tree().entry(q.path).is_some());
    let path = table.required_str("quantity").map_err(|error| {
        let paths: Vec<&str> = present.iter().map(|q| q.path).collect();
        error.with_help(format!("one of: {}", paths.join(", ")))
    })?;
    if let Some(q) = absent.iter().find(|q| q.path == path) {
        return Err(table
            .error("quantity", format!("this case has no `{}` to vary", q.path))
            .with_help("a curve replaces a value that the case file gives"));
    }
    let found = present.iter().find(|q| q.path == path);
    let mut quantity =
        *found.ok_or_else(|| table.unknown_name("quantity", present.iter().map(|q| q.path)))?;
    if quantity.path == "contact.load" && contact.kind.is_line() {
        quantity.dimension = Dimension::FORCE_PER_LENGTH;
        quantity.symbol = "*w*";
    }
    Ok(quantity)
}

fn read_list(
    table: &mut Table<'_>,
    node: &Node,
    dimension: Dimension,
) -> Result<Values, InputError> {
    let numbers = table.required_quantities("values", dimension, Bounds::ANY)?;
    let n = numbers.len();
    if !(2..=MOST_POINTS).contains(&n) {
        return Err(table.error(
            "values",
            format!("a curve has 2 to {MOST_POINTS} points, not {n}"),
        ));
    }
    let Some(Value::Array(nodes)) = node.entry("values").map(|entry| &entry.node.value) else {
        unreachable!("read as an array");
    };
    let number = |value| AxisValue::Number(value, dimension);
    let values = nodes.iter().cloned().zip(numbers.into_iter().map(number));
    let values = values.collect();
    values::check_distinct(table, "curve", &values)?;
    Ok(values)
}

fn read_range(
    table: &mut Table<'_>,
    node: &Node,
    dimension: Dimension,
) -> Result<Values, InputError> {
    let mut end = |key| -> Result<(f64, Node), InputError> {
        let value = table.required_quantity(key, dimension, Bounds::ANY)?;
        let entry = node.entry(key).expect("just read");
        Ok((value, entry.node.clone()))
    };
    let ends = [end("from")?, end("to")?];
    let text = |value: f64| Value::Str(value.to_string());
    values::range(table, node, ends, dimension, MOST_POINTS, text)
}

/// The case with another value.
fn point(
    document: &Document,
    folder: &Path,
    quantity: &Quantity,
    node: Node,
    value: AxisValue,
) -> Result<StudyPoint, InputError> {
    let source = text_of_point(document, quantity, &node);
    let note = |_: &str| format!("[curve] sets `{}` to {value}", quantity.path);
    let setting = Setting {
        key: quantity.path.to_owned(),
        key_span: node.span.clone(),
        node,
        value: value.clone(),
    };
    let (mut point, _) = StudyPoint::read(document, folder, &[setting], &BTreeMap::new(), note)?;
    point.case.source = source;
    Ok(point)
}

/// The case file of one point: its value set, the lines of the curve commented out.
fn text_of_point(document: &Document, quantity: &Quantity, node: &Node) -> String {
    let text = document.text();
    let (Some(base), Some(curve)) = (
        document.tree().entry(quantity.path),
        document.tree().entry("curve"),
    ) else {
        return text.to_owned();
    };
    let replaced = base.node.span.clone();
    let value = match &node.value {
        Value::Str(text) => format!("\"{text}\""),
        Value::Integer(Some(number)) => number.to_string(),
        Value::Float(number) => format!("{number:?}"),
        _ => return text.to_owned(),
    };
    let mut curve_lines = vec![curve.key_span.clone()];
    if let Value::Table(entries) = &curve.node.value {
        curve_lines.extend(entries.iter().map(|e| e.key_span.start..e.node.span.end));
    }
    let mut result = String::new();
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        let end = start + line.len();
        if curve_lines.iter().any(|s| s.start < end && start < s.end) {
            result.push_str("# ");
            result.push_str(line);
        } else if (start..end).contains(&replaced.start) && replaced.end <= end {
            result.push_str(&line[..replaced.start - start]);
            result.push_str(&value);
            result.push_str(&line[replaced.end - start..]);
        } else {
            result.push_str(line);
        }
        start = end;
    }
    result
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use ertel_input::keys::CURVE;

    use super::*;

    /// The key table lists the quantities that may vary.
    #[test]
    fn the_table_lists_what_may_vary() {
        let row = CURVE.iter().find(|row| row.keys.contains(&"quantity"));
        let Some(Kind::Choice(listed) | Kind::AnyCase(listed)) = row.map(|row| row.kind) else {
            panic!("a choice");
        };
        let all = QUANTITIES.iter().chain(OF_MACHINES.iter());
        let own: BTreeSet<&str> = all.map(|q| q.path).collect();
        assert_eq!(own, listed.iter().copied().collect());
    }
}
