//! All contacts of a machine: its case file with the keys of each contact added in turn.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use ertel_input::tree::{Node, Value};
use ertel_input::{Document, InputError};
use ertel_quantity::Dimension;

use super::Mechanics;
use crate::case::study::values::AxisValue;
use crate::case::study::{Setting, StudyColumn, StudyPoint, to_toml};
use crate::case::{Case, Study};
use crate::params::SensitivityDemand;

/// A whole machine.
#[derive(Clone, Debug)]
pub struct WholeMachine {
    /// Description: `ball bearing 6206`.
    pub title: String,
    /// Its mechanics.
    pub mechanics: Mechanics,
    /// Its contacts in their order, unloaded ones among them.
    pub contacts: Vec<MachineContact>,
    /// The coordinate of its contacts.
    pub axis: Axis,
    /// Which of them the case itself is: the one under the largest pressure.
    pub governing: usize,
    /// Whether its contacts are lines, whose loads are per length.
    pub is_line: bool,
    /// Whether each contact's results are also written to a separate folder.
    pub folders: bool,
}

/// The coordinate of contacts, which also sets how they are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// Angles of rolling elements from the load, round the bearing.
    Around,
    /// Distances along the line of action from the pitch point.
    LineOfAction,
    /// Angles of a cam over a turn.
    CamAngle,
}

impl Axis {
    /// Name in results.
    pub fn name(self) -> &'static str {
        match self {
            Axis::Around => "angle",
            Axis::LineOfAction => "position",
            Axis::CamAngle => "cam_angle",
        }
    }

    /// Its SI unit.
    pub fn unit(self) -> &'static str {
        match self {
            Axis::Around | Axis::CamAngle => "rad",
            Axis::LineOfAction => "m",
        }
    }
}

/// The sides of a bearing.
pub const RINGS: [&str; 2] = ["inner", "outer"];

impl WholeMachine {
    /// Whether there are two contacts at each place: at both rings of a bearing.
    pub fn has_sides(&self) -> bool {
        self.axis == Axis::Around
    }

    /// How many contacts are like one, itself among them.
    pub fn count(&self, contact: usize) -> usize {
        let like = |other: &&MachineContact| other.like == Some(contact);
        self.contacts.iter().filter(like).count()
    }
}

/// A contact of a machine.
#[derive(Clone, Debug, PartialEq)]
pub struct MachineContact {
    /// Which it is, in words: `ball 3, inner ring`.
    pub name: String,
    /// The keys of `[machine]` that select it alone.
    pub keys: Vec<(&'static str, Choice)>,
    /// Where it is, SI, by [`Axis`].
    pub place: f64,
    /// Which of several contacts at one place: the ring of a bearing, inner 0 and outer 1.
    pub side: usize,
    /// Its load: N, or N/m of a line; zero where nothing presses.
    pub load: f64,
    /// Largest pressure of the dry contact, Pa.
    pub hertz_pressure: f64,
    /// The first contact whose load, radii and motion are the same, which is solved for all of them; `None` where nothing presses.
    pub like: Option<usize>,
}

/// Value of a key that selects a contact.
#[derive(Clone, Debug, PartialEq)]
pub enum Choice {
    /// A name.
    Name(&'static str),
    /// A number of an element.
    Number(i64),
    /// A quantity, SI.
    Quantity(f64, Dimension),
}

impl Choice {
    fn value(&self) -> (Value, AxisValue) {
        match self {
            Choice::Name(name) => (
                Value::Str((*name).to_owned()),
                AxisValue::Text((*name).to_owned()),
            ),
            Choice::Number(n) => (
                Value::Integer(Some(*n)),
                AxisValue::Number(*n as f64, Dimension::DIMENSIONLESS),
            ),
            Choice::Quantity(value, dimension) => {
                let value = AxisValue::Number(*value, *dimension);
                (Value::Str(value.to_string()), value)
            }
        }
    }
}

/// Finds equal contacts by their distinguishing values, and returns for each the first like it.
pub(super) fn like<const N: usize>(of: &[Option<[f64; N]>]) -> Vec<Option<usize>> {
    let same = |a: &[f64; N], b: &[f64; N]| {
        let close = |(a, b): (&f64, &f64)| (a - b).abs() <= SAME * a.abs().max(b.abs());
        a.iter().zip(b).all(close)
    };
    let first = |(i, own): (usize, &Option<[f64; N]>)| {
        let own = own.as_ref()?;
        let before = of[..i]
            .iter()
            .position(|o| o.as_ref().is_some_and(|o| same(o, own)));
        Some(before.unwrap_or(i))
    };
    of.iter().enumerate().map(first).collect()
}

/// Relative difference of distinguishing values below which contacts are the same: rounding of the mechanics.
const SAME: f64 = 1e-9;

/// The contacts of a machine that are to be solved.
#[derive(Clone, Debug)]
pub struct MachineContacts {
    /// The machine.
    pub machine: Arc<WholeMachine>,
    /// Those of its contacts that differ, in their order.
    pub study: Study,
}

/// Reads the contacts that are to be solved, with other values, SI, at the key paths `replaced`.
pub(in crate::case) fn contacts(
    document: &Document,
    folder: &Path,
    case: &Case,
    machine: &Arc<WholeMachine>,
    replaced: &BTreeMap<String, f64>,
) -> Result<MachineContacts, InputError> {
    let at = document.tree().entry("machine");
    let span = at.map_or(0..0, |entry| entry.key_span.clone());
    let mut points = Vec::new();
    let mut columns: Vec<StudyColumn> = Vec::new();
    for (i, contact) in machine.contacts.iter().enumerate() {
        if contact.like != Some(i) {
            continue;
        }
        let settings: Vec<Setting> = (contact.keys.iter())
            .map(|(key, choice)| {
                let (node, value) = choice.value();
                Setting {
                    key: format!("machine.{key}"),
                    key_span: span.clone(),
                    node: Node {
                        span: span.clone(),
                        value: node,
                    },
                    value,
                }
            })
            .collect();
        if columns.is_empty() {
            columns = (settings.iter())
                .map(|setting| match &setting.value {
                    AxisValue::Number(_, dimension) => StudyColumn::of(&setting.key, *dimension),
                    AxisValue::Text(_) => StudyColumn::of(&setting.key, Dimension::DIMENSIONLESS),
                })
                .collect();
        }
        let (mut point, varied) = StudyPoint::read(document, folder, &settings, replaced, |_| {
            contact.name.clone()
        })?;
        point.label.clone_from(&contact.name);
        simplify(&mut point.case, machine, document);
        point.case.source = format!("# {}\n{}", contact.name, to_toml(varied.tree()));
        points.push(point);
    }
    Ok(MachineContacts {
        machine: machine.clone(),
        study: Study::of_samples(case, columns, points),
    })
}

/// Target error of the films of a whole bearing, whose figures are sums or extremes of ten to thirty contacts.
const TARGET_ERROR: f64 = 0.01;

/// Leaves out of a contact all that the figures of its machine do not need. No figure of a machine has sensitivities. Contacts of a bearing whose films are Newtonian
/// and whose friction follows from the law have no spin: it hardly changes such films, breaks their symmetry, and its friction is by the law. The default target of bearings is
/// [`TARGET_ERROR`].
fn simplify(case: &mut Case, machine: &WholeMachine, document: &Document) {
    if case.output.sensitivities == SensitivityDemand::WhereUncertain && !machine.folders {
        case.output.sensitivities = SensitivityDemand::Off;
    }
    let Mechanics::Bearing(_) = &machine.mechanics else {
        return;
    };
    if case.friction_by_law {
        case.motion.spin = [0.0; 2];
    }
    let is_given = document.tree().entry("mesh.target_error").is_some();
    if case.mesh.target_error.is_some() && !is_given {
        case.mesh.target_error = Some(TARGET_ERROR);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn contacts_that_are_the_same() {
        let of = [
            Some([1.0, 2.0]),
            None,
            Some([1.0, 2.1]),
            Some([1.0 + 1e-12, 2.0]),
        ];
        assert_eq!(like(&of), [Some(0), None, Some(2), Some(0)]);
    }
}
