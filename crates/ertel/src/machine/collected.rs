//! Figures and warnings of a machine while they are collected.

use crate::figures::{Definition, Row};
use crate::mark::Marked;
use crate::warning::{Warning, WarningKind};

/// Figures and warnings found so far.
#[derive(Default)]
pub(super) struct Collected {
    pub figures: Vec<Row>,
    pub warnings: Vec<Warning>,
}

impl Collected {
    pub fn add(&mut self, figure: Definition, value: impl Into<Marked>, source: &'static str) {
        self.figures.push(figure.row(value, source));
    }

    pub fn warn(&mut self, kind: WarningKind, text: impl Into<String>) {
        self.warnings.push(Warning::new(kind, text));
    }
}
