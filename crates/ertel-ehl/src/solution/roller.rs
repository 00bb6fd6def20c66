//! Figures of a roller of which one half was solved.

use super::{Bar, Figure, Measured, Reading};

impl Measured {
    /// Adds the figures of the other half of a roller of which one half was solved: it is the mirror image, and the load acts in the middle.
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
