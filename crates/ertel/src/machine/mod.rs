//! Figures of whole machines: from the solutions of their contacts to friction, heat, safety and life.

mod slip;

use crate::case::Case;
use crate::solution::Estimate;
use crate::study::MachineSolution;

/// A figure of a whole machine.
#[derive(Clone, Debug, PartialEq)]
pub struct MachineFigure {
    /// Name in results and Python: `friction_torque`.
    pub name: &'static str,
    /// What it is, in words.
    pub words: &'static str,
    /// The figure, SI; its bar is that of the solved contacts, `None` where it comes from a formula alone.
    pub estimate: Estimate,
    /// Its SI unit; empty of a pure number.
    pub unit: &'static str,
    /// Part of the report.
    pub section: Section,
    /// Where the formula comes from, or what is left out.
    pub source: &'static str,
}

/// Parts of the report of a machine, in their order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Section {
    /// Loads and motion.
    Mechanics,
    /// Films over roughness.
    Films,
    /// Friction, power and heat.
    Friction,
    /// Surface and bulk temperatures.
    Temperature,
    /// Safety against damage.
    Safety,
    /// Rating life.
    Life,
}

impl Section {
    /// Every section in its order.
    pub const ALL: [Section; 6] = [
        Section::Mechanics,
        Section::Films,
        Section::Friction,
        Section::Temperature,
        Section::Safety,
        Section::Life,
    ];

    /// Its heading.
    pub fn heading(self) -> &'static str {
        match self {
            Section::Mechanics => "Loads and motion",
            Section::Films => "Films",
            Section::Friction => "Friction",
            Section::Temperature => "Temperature",
            Section::Safety => "Safety",
            Section::Life => "Life",
        }
    }
}

/// The figures of a machine; those that are sums over its contacts only where all of them are solved.
pub fn figures(_case: &Case, _solution: &MachineSolution) -> Vec<MachineFigure> {
    Vec::new()
}
