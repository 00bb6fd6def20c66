//! What is asked of a roller alone, SI.

use serde::Serialize;

use super::{Bar, Estimate, Figure, Located, Measured, Reading};

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
    /// Of a solution, if it is that of a roller.
    pub fn of(measured: &Measured) -> Option<RollerFigures> {
        Some(RollerFigures {
            edge_pressure_left: measured.find_located(Figure::EdgePressureLeft)?,
            edge_pressure_right: measured.find_located(Figure::EdgePressureRight)?,
            roller_moment: measured.find(Figure::RollerMoment)?,
            load_position: measured.find(Figure::LoadPosition)?,
        })
    }
}

impl Measured {
    /// Adds the figures of the other half of a roller of which one half was solved: it is the mirror image, and the load stands in the middle.
    pub fn with_mirrored_end(mut self) -> Measured {
        let Some(left) = self.figures.get(Figure::EdgePressureLeft) else {
            return self;
        };
        let right = Reading {
            place: left.place.map(|[x, y]| [x, -y]),
            ..left
        };
        self.figures.set(Figure::EdgePressureRight, right);
        if let Some(bar) = self.bars.get(Figure::EdgePressureLeft) {
            self.bars.set(Figure::EdgePressureRight, bar);
        }
        for figure in [Figure::RollerMoment, Figure::LoadPosition] {
            self.set_exactly(figure, 0.0);
        }
        self
    }

    /// Sets a figure that is known without an error, SI.
    pub fn set_exactly(&mut self, figure: Figure, value: f64) {
        self.figures.set(figure, Reading::new(value));
        self.bars.set(
            figure,
            Bar {
                value: 0.0,
                place: None,
            },
        );
    }
}
