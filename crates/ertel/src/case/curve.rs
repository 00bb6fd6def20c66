//! `[curve]`: a list or range of one quantity of the case.
//!
//! ```toml
//! [curve]
//! quantity = "motion.entrainment_speed"
//! values = ["0.1 m/s", "0.2 m/s", "0.5 m/s"]
//! # or: from = "0.1 m/s", to = "10 m/s", points = 9, spacing = "log"
//! ```
//!
//! Each point is the case read once more with this value in place of the file's, so that every check
//! applies; errors point to the line of the curve.

use std::collections::BTreeMap;
use std::path::Path;

use ertel_rheology::input::tree::{Node, Value};
use ertel_rheology::input::{Bounds, Document, InputError, Table};
use ertel_rheology::quantity::Dimension;

use super::Case;
use crate::contact::ContactKind;

/// Points of one curve, at most: beyond, a number was mistaken.
const MOST_POINTS: i64 = 1000;

/// A curve: one quantity varies, everything else is the same.
#[derive(Clone, Debug)]
pub struct Curve {
    /// What varies.
    pub quantity: Quantity,
    /// The points in the order in which they are solved, at least two.
    pub points: Vec<Point>,
    /// Whether each point's results are written into a folder of its own, too.
    pub folders: bool,
    /// Whether each point is solved without shear thinning, too.
    pub newtonian: bool,
    /// Whether each point is solved without heat, too.
    pub isothermal: bool,
}

/// One point of a curve.
#[derive(Clone, Debug)]
pub struct Point {
    /// The quantity's value, SI.
    pub value: f64,
    /// The case with this value.
    pub case: Case,
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
const QUANTITIES: [Quantity; 13] = [
    quantity(
        "motion.entrainment_speed",
        "entrainment speed",
        "*u*_{m}",
        Dimension::SPEED,
    ),
    quantity(
        "motion.slide_to_roll_ratio",
        "slide-to-roll ratio",
        "",
        Dimension::DIMENSIONLESS,
    ),
    quantity("motion.ball_speed", "speed of body 2", "", Dimension::SPEED),
    quantity(
        "motion.plane_speed",
        "speed of body 1",
        "",
        Dimension::SPEED,
    ),
    quantity(
        "motion.body_1_speed",
        "speed of body 1",
        "",
        Dimension::SPEED,
    ),
    quantity(
        "motion.body_2_speed",
        "speed of body 2",
        "",
        Dimension::SPEED,
    ),
    quantity("contact.load", "load", "*F*", Dimension::FORCE),
    quantity(
        "contact.hertz_pressure",
        "Hertz pressure",
        "*p*_{h}",
        Dimension::PRESSURE,
    ),
    quantity("contact.radius", "radius", "*R*", Dimension::LENGTH),
    quantity(
        "inlet.oil_layer",
        "oil layer",
        "*h*_{oil}",
        Dimension::LENGTH,
    ),
    quantity(
        "inlet.meniscus_distance",
        "distance of the meniscus",
        "",
        Dimension::LENGTH,
    ),
    quantity("temperature", "temperature", "*T*", Dimension::TEMPERATURE),
    quantity(
        "lubricant.temperature",
        "temperature",
        "*T*",
        Dimension::TEMPERATURE,
    ),
];

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
        self.dimension.si_unit()
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
    let quantity = read_quantity(document, &mut table, base.contact.kind)?;
    let values = if table.contains("values") {
        for key in ["from", "to", "points", "spacing"] {
            if table.contains(key) {
                return Err(table.error(
                    key,
                    format!("`values` and `{key}` are both given: a curve is a list or a range"),
                ));
            }
        }
        read_list(document, &mut table, &quantity)?
    } else if table.contains("from") || table.contains("to") || table.contains("points") {
        read_range(document, &mut table, &quantity)?
    } else {
        return Err(table.missing("values").with_help(
            "a list, values = [\"0.1 m/s\", \"0.2 m/s\"], or a range: `from`, `to`, `points` and `spacing`",
        ));
    };
    let folders = table.optional_bool("folders")?.unwrap_or(false);
    let newtonian = table.optional_bool("newtonian")?.unwrap_or(false);
    if newtonian && base.shear_thinning().is_none() {
        let reason = if base.solver.newtonian {
            "`newtonian` of [curve] compares with a curve that [solver] already asks for alone"
        } else {
            "this lubricant does not thin in shear: its curve is the Newtonian one"
        };
        return Err(table.error("newtonian", reason));
    }
    let isothermal = table.optional_bool("isothermal")?.unwrap_or(false);
    if isothermal && base.thermal().is_none() {
        let reason = if base.solver.isothermal {
            "`isothermal` of [curve] compares with a curve that [solver] already asks for alone"
        } else {
            "without [thermal] this curve is the isothermal one"
        };
        return Err(table.error("isothermal", reason));
    }
    table.finish()?;
    let points = values
        .into_iter()
        .map(|(value, node)| point(document, folder, &quantity, value, node))
        .collect::<Result<_, _>>()?;
    Ok(Some(Curve {
        quantity,
        points,
        folders,
        newtonian,
        isothermal,
    }))
}

fn read_quantity(
    document: &Document,
    table: &mut Table<'_>,
    kind: ContactKind,
) -> Result<Quantity, InputError> {
    let (present, absent): (Vec<Quantity>, Vec<Quantity>) = QUANTITIES
        .iter()
        .partition(|q| document.tree().entry(q.path).is_some());
    let path = table.required_str("quantity").map_err(|error| {
        let paths: Vec<&str> = present.iter().map(|q| q.path).collect();
        error.with_help(format!("one of: {}", paths.join(", ")))
    })?;
    if let Some(q) = absent.iter().find(|q| q.path == path) {
        return Err(table
            .error("quantity", format!("this case has no `{}` to vary", q.path))
            .with_help("a curve puts its values in place of the one that the case file gives"));
    }
    let found = present.iter().find(|q| q.path == path);
    let mut quantity =
        *found.ok_or_else(|| table.unknown_name("quantity", present.iter().map(|q| q.path)))?;
    if quantity.path == "contact.load" && kind == ContactKind::Line {
        quantity.dimension = Dimension::FORCE_PER_LENGTH;
        quantity.symbol = "*w*";
    }
    Ok(quantity)
}

/// Values in SI, each with the value as the point's case file has it.
type Values = Vec<(f64, Node)>;

fn read_list(
    document: &Document,
    table: &mut Table<'_>,
    quantity: &Quantity,
) -> Result<Values, InputError> {
    let values = table.required_quantities("values", quantity.dimension, Bounds::ANY)?;
    if values.len() < 2 || values.len() as i64 > MOST_POINTS {
        let n = values.len();
        return Err(table.error(
            "values",
            format!("a curve has 2 to {MOST_POINTS} points, not {n}"),
        ));
    }
    if let Some(twice) = (1..values.len()).find(|i| values[..*i].contains(&values[*i])) {
        return Err(table.error(
            "values",
            format!("value {} of the curve repeats an earlier one", twice + 1),
        ));
    }
    let entry = document.tree().entry("curve.values");
    let Some(Value::Array(nodes)) = entry.map(|entry| &entry.node.value) else {
        unreachable!("read as an array");
    };
    Ok(values.into_iter().zip(nodes.iter().cloned()).collect())
}

/// Reads `spacing` of a range: whether its steps are equal ratios.
pub(super) fn read_spacing(table: &mut Table<'_>, from: f64, to: f64) -> Result<bool, InputError> {
    let log = table
        .optional_choice("spacing", &[("linear", false), ("log", true)])?
        .unwrap_or(false);
    if from == to {
        return Err(table.error("to", "`to` equals `from`: the range has no length"));
    }
    if log && from * to <= 0.0 {
        let key = if from == 0.0 { "from" } else { "to" };
        return Err(table
            .error(
                key,
                "equal ratios lead neither from zero, nor to zero, nor across it",
            )
            .with_help("spacing = \"linear\" does"));
    }
    Ok(log)
}

fn read_range(
    document: &Document,
    table: &mut Table<'_>,
    quantity: &Quantity,
) -> Result<Values, InputError> {
    let from = table.required_quantity("from", quantity.dimension, Bounds::ANY)?;
    let to = table.required_quantity("to", quantity.dimension, Bounds::ANY)?;
    let points = table.required_integer("points", 2..=MOST_POINTS)?;
    let log = read_spacing(table, from, to)?;
    let last = (points - 1) as f64;
    let unit = quantity.unit();
    let values = (0..points).map(|i| {
        let t = i as f64 / last;
        let (value, key) = match i {
            0 => (from, "from"),
            _ if i + 1 == points => (to, "to"),
            _ if log => (from * (to / from).powf(t), "points"),
            _ => (from + t * (to - from), "points"),
        };
        // What the user wrote, or as many digits as anyone wants to read.
        let value = if key == "points" {
            rounded(value)
        } else {
            value
        };
        let path = format!("curve.{key}");
        let given = &document.tree().entry(&path).expect("just read").node;
        let node = if key == "points" {
            Node {
                span: given.span.clone(),
                value: Value::Str(format!("{value} {unit}").trim_end().to_owned()),
            }
        } else {
            given.clone()
        };
        (value, node)
    });
    Ok(values.collect())
}

/// To six significant digits.
fn rounded(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}

/// The case with another value.
fn point(
    document: &Document,
    folder: &Path,
    quantity: &Quantity,
    value: f64,
    node: Node,
) -> Result<Point, InputError> {
    let source = text_of_point(document, quantity, &node);
    let varied = document
        .with_value(quantity.path, node)
        .expect("its presence was checked");
    let mut case = Case::without_curve(&varied, folder, BTreeMap::new()).map_err(|error| {
        let unit = quantity.unit();
        error.with_help(format!(
            "[curve] puts {} in place of `{}`",
            format!("{value} {unit}").trim_end(),
            quantity.path
        ))
    })?;
    case.source = source;
    Ok(Point { value, case })
}

/// The case file of one point: its value in place, the lines of the curve commented out.
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
