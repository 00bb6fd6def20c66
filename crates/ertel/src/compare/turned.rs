//! Rows of a rig that ran in the reverse direction, or was at rest.

use ertel_input::Document;
use ertel_input::csv::line_list;

/// Treatment of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Turned {
    /// It runs along x.
    No,
    /// All of its speeds are turned; their ratio stays, (-u_2 + u_1)/(-u) = (u_2 - u_1)/u.
    Yes,
    /// It is not computed.
    LeftOut,
}

impl Turned {
    /// The text of a speed as it is computed.
    pub(super) fn speed(self, cell: &str) -> &str {
        match self {
            Turned::Yes => cell.trim_start_matches('-'),
            Turned::No | Turned::LeftOut => cell,
        }
    }
}

/// The rows of a table, as far as they are not ordinary.
pub(super) struct Rows {
    /// Whether a contact with all speeds turned is the same one, seen from the other side: nothing turns about the normal.
    can_turn: bool,
    turned: Vec<usize>,
    left_out: Vec<usize>,
    at_rest: Vec<usize>,
}

/// Keys of a motion that turns about the normal: a table does not contain it, and it is not turned with the speeds.
const SPIN: [&str; 3] = [
    "motion.body_1_spin",
    "motion.body_2_spin",
    "motion.raceway_control",
];

impl Rows {
    /// Of measurements with a case.
    pub(super) fn of(case: &Document) -> Self {
        let has = |path: &&str| case.tree().entry(path).is_some();
        Self {
            can_turn: !SPIN.iter().any(has),
            turned: Vec::new(),
            left_out: Vec::new(),
            at_rest: Vec::new(),
        }
    }

    /// Takes a row in, with its line and its speed (m/s) if the table has speeds.
    pub(super) fn take(&mut self, line: usize, speed: Option<f64>) -> Turned {
        match speed {
            Some(0.0) => {
                self.at_rest.push(line);
                Turned::LeftOut
            }
            Some(speed) if speed < 0.0 && self.can_turn => {
                self.turned.push(line);
                Turned::Yes
            }
            Some(speed) if speed < 0.0 => {
                self.left_out.push(line);
                Turned::LeftOut
            }
            Some(_) | None => Turned::No,
        }
    }

    /// Notes for the report.
    pub(super) fn notes(&self) -> Vec<String> {
        let notes = [
            (
                &self.turned,
                "reversed motion, turned: speeds change their sign, the slide-to-roll ratio does not",
            ),
            (
                &self.left_out,
                "reversed motion, omitted: the spin of the case would not be turned with it",
            ),
            (&self.at_rest, "at rest, omitted"),
        ];
        (notes.iter().filter(|(lines, _)| !lines.is_empty()))
            .map(|(lines, what)| format!("{}: {what}", line_list(lines)))
            .collect()
    }
}
