//! The figures of a solution by their names in the registry.

use ertel::solution::{Estimate, Figure, Located, Solution};

/// A figure of a solution.
#[derive(Clone, Copy, Debug)]
pub struct PlacedFigure {
    /// Value with its bar.
    pub estimate: Estimate,
    /// Where it is, if it has a place.
    pub place: Option<Located>,
}

impl From<Estimate> for PlacedFigure {
    fn from(estimate: Estimate) -> PlacedFigure {
        PlacedFigure {
            estimate,
            place: None,
        }
    }
}

impl From<Located> for PlacedFigure {
    fn from(located: Located) -> PlacedFigure {
        PlacedFigure {
            estimate: located.estimate(),
            place: Some(located),
        }
    }
}

/// A figure, where the solution has it.
pub fn placed_figure(solution: &Solution, figure: Figure) -> Option<PlacedFigure> {
    let at = solution.figure(figure)?;
    Some(match figure.has_place() {
        true => at.into(),
        false => at.estimate().into(),
    })
}
