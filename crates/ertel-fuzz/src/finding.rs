//! Findings: a panic, a hang, too much memory, an abort, an error without place.

use serde::{Deserialize, Serialize};

/// File added to those of a finding, with what happened and how to repeat it.
pub const NOTE: &str = "finding.txt";

/// Kinds of defects.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// A panic.
    Panic,
    /// More time than an input may take.
    Hang,
    /// More memory than an input may take.
    Memory,
    /// The process died: a stack overflow, an allocation refused.
    Abort,
    /// An error that does not say where, or a wrong result.
    Wrong,
}

impl Kind {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Kind::Panic => "panic",
            Kind::Hang => "hang",
            Kind::Memory => "memory",
            Kind::Abort => "abort",
            Kind::Wrong => "wrong",
        }
    }
}

/// A defect that an input shows.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Defect {
    /// Its kind.
    pub kind: Kind,
    /// Two findings with the same place are of the same defect: the place of a panic, the rule that does not hold.
    pub place: String,
    /// All there is to say.
    pub message: String,
}

impl Defect {
    /// A rule that does not hold.
    pub fn wrong(rule: &str, message: impl Into<String>) -> Defect {
        Defect {
            kind: Kind::Wrong,
            place: rule.to_owned(),
            message: message.into(),
        }
    }

    /// Whether both are likely of one cause.
    pub fn is_like(&self, other: &Defect) -> bool {
        self.kind == other.kind && self.place == other.place
    }
}
