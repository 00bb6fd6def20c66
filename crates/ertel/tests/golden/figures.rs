//! The figures of a solution by their names in the registry.

use ertel::solution::{Estimate, Figure, Located, Solution};

/// A figure of a solution.
#[derive(Clone, Copy, Debug)]
pub struct Told {
    /// Value with its bar.
    pub estimate: Estimate,
    /// Where it is, if it has a place.
    pub place: Option<Located>,
}

impl From<Estimate> for Told {
    fn from(estimate: Estimate) -> Told {
        Told {
            estimate,
            place: None,
        }
    }
}

impl From<Located> for Told {
    fn from(located: Located) -> Told {
        Told {
            estimate: located.estimate(),
            place: Some(located),
        }
    }
}

/// A figure, where the solution has it.
pub fn told(solution: &Solution, figure: Figure) -> Option<Told> {
    let at = solution.figure(figure)?;
    Some(match figure.has_place() {
        true => at.into(),
        false => at.estimate().into(),
    })
}
