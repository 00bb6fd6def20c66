//! What is asked of a roller alone, SI.

use serde::Serialize;

use super::{Estimate, Figure, Located, Measured};

/// Ends of a roller, and where its load stands.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RollerFigures {
    /// Largest pressure over the quarter of the length at the end y < 0, Pa.
    pub edge_pressure_left: Located,
    /// The same at the end y > 0, Pa.
    pub edge_pressure_right: Located,
    /// ∫p y dA, N m: what holds the roller at its tilt.
    pub roller_moment: Estimate,
    /// ∫p y dA/F, m: the distance of the resultant from the middle, positive towards y > 0.
    pub load_position: Estimate,
}

impl RollerFigures {
    /// Of a solution, if it is that of a roller; where one half is solved, the other one is its mirror image.
    pub fn of(measured: &Measured) -> Option<RollerFigures> {
        let left = measured.find_located(Figure::EdgePressureLeft)?;
        let mirrored = Located { y: -left.y, ..left };
        let right = measured.find_located(Figure::EdgePressureRight);
        let nothing = Estimate {
            value: 0.0,
            error: Some(0.0),
        };
        let of = |figure| measured.find(figure).unwrap_or(nothing);
        Some(RollerFigures {
            edge_pressure_left: left,
            edge_pressure_right: right.unwrap_or(mirrored),
            roller_moment: of(Figure::RollerMoment),
            load_position: of(Figure::LoadPosition),
        })
    }
}
