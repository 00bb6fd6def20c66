//! Bumps and dents of a surface that move with its body.

use super::{Body, Form, Height};
#[cfg(test)]
use super::{Gap, GapTerm};
use crate::contact::{Pose, Turn};

/// A relief of one of the bodies, along and across the motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Relief {
    /// Its shape.
    pub form: Form,
    /// The body that has it.
    pub body: Body,
    /// Where its middle, or first crest, lies at the start.
    pub place: [f64; 2],
    /// Where the body has moved since.
    pub moved: Pose,
    /// From the motion to the principal directions.
    pub turn: Turn,
}

impl Relief {
    /// Its contribution to the gap at a place along the principal directions.
    pub fn at(&self, place: [f64; 2]) -> Height {
        let from = self.relative_to_middle(self.turn.to_motion(place));
        let Height { value, gradient } = self.form.at(from);
        let gradient = self.moved.directed(gradient);
        Height {
            value: -value,
            gradient: self.turn.to_axes(gradient.map(|slope| -slope)),
        }
    }

    /// Whether it lies within a distance from the centre.
    pub fn is_within(&self, distance: f64) -> bool {
        let middle = self.relative_to_middle([0.0; 2]).map(|x| -x);
        self.form.is_within(middle, distance)
    }

    /// Whether it reaches a place along and across the motion.
    pub fn covers(&self, place: [f64; 2]) -> bool {
        self.form.covers(self.relative_to_middle(place))
    }

    /// From its middle to a place along and across the motion, in directions that are fixed to the body.
    fn relative_to_middle(&self, place: [f64; 2]) -> [f64; 2] {
        let [x, y] = self.moved.at_start(place);
        [x - self.place[0], y - self.place[1]]
    }

    /// Whether the halves y < 0 and y > 0 are alike.
    pub fn is_symmetric(&self) -> bool {
        self.form.is_symmetric(self.place)
    }
}

#[cfg(test)]
impl Gap {
    /// Adds a form on a body at a place, at the start of the motion.
    pub fn add(&mut self, form: Form, body: Body, place: [f64; 2]) {
        self.terms.push(GapTerm::Relief(Relief {
            form,
            body,
            place,
            moved: Pose::START,
            turn: Turn::NONE,
        }));
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::contact::gap::{HeightMap, Repeat};
    use approx::assert_relative_eq;

    fn repeated(form: &Form, pitch: f64, count: Option<u32>) -> Form {
        let repeat = Some(Repeat { pitch, count });
        Form::Repeated {
            form: Box::new(form.clone()),
            along: repeat,
            across: repeat,
        }
    }

    /// Depth in the middle and at r_0 by hand, cos(75°) e^(−2/1.44); slopes by differences, of all forms on a body that has moved and turned.
    #[test]
    fn reliefs_by_hand_and_differences() {
        let dent = Form::Round {
            radius: 0.1,
            height: -0.4,
        };
        assert_relative_eq!(dent.at([0.0, 0.0]).value, -0.4);
        assert_relative_eq!(
            dent.at([0.06, -0.08]).value,
            -0.4 * 0.258_819_045 * 0.249_352_209,
            max_relative = 1e-8
        );
        assert_eq!(dent.at([0.13, 0.0]), Height::default());
        let waves = Form::Waves {
            wavelength: 0.5,
            amplitude: 0.02,
            direction: 0.0,
        };
        assert_relative_eq!(waves.at([-0.75, 0.3]).value, -0.02, max_relative = 1e-12);
        assert!(waves.at([0.5, 0.0]).value < 1e-11);
        let ridge = Form::Ridge {
            half_width: 0.3,
            height: 0.2,
            direction: 0.7,
        };
        let moved = Pose {
            shift: [0.4, -0.3],
            angle: 0.7,
        };
        let heights: Vec<f64> = (0..80).map(|k| 0.1 * (0.9 * f64::from(k)).sin()).collect();
        let map = Form::Map {
            map: Arc::new(HeightMap::new([10, 8], [1.0, 1.5], &heights)),
            units: [0.1, 2.0],
            finest: 2.0,
            direction: 0.4,
        };
        for (form, offset) in [
            (dent.clone(), [0.05, -0.02]),
            (waves.clone(), [-0.3, 0.2]),
            (waves, [0.07, 0.2]),
            (ridge.clone(), [-0.1, 0.05]),
            (ridge.clone(), [0.15, 0.05]),
            (map, [0.11, -0.23]),
            (repeated(&dent, 0.5, Some(3)), [-1.07, 0.6]),
            (repeated(&ridge, 0.8, None), [-6.1, 0.4]),
        ] {
            let relief = Relief {
                form: form.clone(),
                body: Body::First,
                place: [-1.0, 0.25],
                moved,
                turn: Turn::by(0.3),
            };
            // From the middle along directions that turn with the body.
            let [x, y] = moved.directed([-1.0 + offset[0], 0.25 + offset[1]]);
            let axes = relief
                .turn
                .to_axes([x + moved.shift[0], y + moved.shift[1]]);
            let own = relief.at(axes);
            assert_relative_eq!(own.value, -form.at(offset).value, max_relative = 1e-9);
            for d in 0..2 {
                let value = |step: f64| {
                    let mut at = axes;
                    at[d] += step;
                    relief.at(at).value
                };
                let difference = (value(1e-6) - value(-1e-6)) / 2e-6;
                assert_relative_eq!(
                    own.gradient[d],
                    difference,
                    max_relative = 1e-5,
                    epsilon = 1e-8
                );
            }
        }
    }

    /// A dent on its way enters and leaves; waves stay once they have come.
    #[test]
    fn arrivals() {
        let at = |form: &Form, x: f64| Relief {
            form: form.clone(),
            body: Body::Second,
            place: [x, 0.0],
            moved: Pose::START,
            turn: Turn::NONE,
        };
        let dent = Form::Round {
            radius: 0.1,
            height: -1.0,
        };
        let inside = [-1.2, -1.1, 0.0, 1.1, 1.2].map(|x| at(&dent, x).is_within(1.0));
        assert_eq!(inside, [false, true, true, true, false]);
        let waves = Form::Waves {
            wavelength: 0.5,
            amplitude: 1.0,
            direction: 0.0,
        };
        let inside = [-1.4, -1.2, 0.0, 9.0].map(|x| at(&waves, x).is_within(1.0));
        assert_eq!(inside, [false, true, true, true]);
    }

    /// Dents one behind the other and ridges side by side: which ones there are, which one is near, what is alike.
    #[test]
    fn rows_of_reliefs() {
        let dent = Form::Round {
            radius: 0.1,
            height: -1.0,
        };
        let three = repeated(&dent, 0.5, Some(3));
        // Across they lie at -0.5, 0 and 0.5, along at 0, -0.5 and -1.
        for (place, depth) in [
            ([0.0, 0.0], -1.0),
            ([-1.0, -0.5], -1.0),
            ([-0.5, 0.5], -1.0),
            ([0.5, 0.0], 0.0),
            ([-1.5, 0.0], 0.0),
            ([0.0, 1.0], 0.0),
            ([-0.25, 0.0], 0.0),
        ] {
            assert_relative_eq!(three.at(place).value, depth, epsilon = 1e-12);
        }
        // Two: at -0.25 and 0.25.
        let two = repeated(&dent, 0.5, Some(2));
        assert_eq!(two.at([0.0, 0.0]).value, 0.0);
        assert_relative_eq!(two.at([-0.5, 0.25]).value, -1.0, epsilon = 1e-12);
        let endless = repeated(&dent, 0.5, None);
        assert_relative_eq!(endless.at([-50.0, 7.5]).value, -1.0, epsilon = 1e-9);
        let ridge = |direction: f64| {
            let ridge = Form::Ridge {
                half_width: 0.1,
                height: 1.0,
                direction,
            };
            repeated(&ridge, 0.3, None)
        };
        let along = ridge(std::f64::consts::FRAC_PI_2);
        assert_relative_eq!(along.at([4.0, 0.6]).value, 1.0, epsilon = 1e-9);
        assert_relative_eq!(along.at([4.0, -0.6]).value, 1.0, epsilon = 1e-9);
        assert!(along.is_along_motion() && !ridge(0.3).is_along_motion());
        assert_eq!(ridge(0.0).at([0.3, 0.0]).value, 0.0);
        let at = |form: &Form, x: f64| Relief {
            form: form.clone(),
            body: Body::First,
            place: [x, 0.0],
            moved: Pose::START,
            turn: Turn::NONE,
        };
        let inside = [-1.2, 0.0, 1.9, 2.2].map(|x| at(&three, x).is_within(1.0));
        assert_eq!(inside, [false, true, true, false]);
        assert!(at(&endless, 99.0).is_within(1.0));
        assert!(at(&three, 0.4).covers([-0.6, 0.05]) && !at(&three, 0.4).covers([-0.4, 0.0]));
        assert!(at(&three, 0.4).is_symmetric() && at(&along, 0.0).is_symmetric());
    }
}
