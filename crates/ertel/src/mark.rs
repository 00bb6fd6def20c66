//! Why a figure is not to be used as it is, and numbers that carry this along.
//!
//! A reason is found once, at the contact that has it ([`of_figure`]). Sums, products and extremes of [`Marked`] numbers pass it
//! on.

use std::iter::Sum;
use std::ops::{Add, BitOr, Div, Mul, Sub};

use crate::solution::{Estimate, Figure, Section, Solution};
use crate::warning::WarningKind;

/// Why a figure is not to be used as it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// Derived from figures that are not resolved.
    Unresolved,
    /// Derived from friction that no lubricant transmits.
    Friction,
    /// Friction of the film alone, where asperities carry a part of the load.
    FilmAlone,
    /// An extreme that may lie between the points.
    BetweenPoints,
}

impl Mark {
    /// Every mark, worst first.
    pub const ALL: [Mark; 4] = [
        Mark::Unresolved,
        Mark::Friction,
        Mark::FilmAlone,
        Mark::BetweenPoints,
    ];

    /// Name in results.
    pub fn name(self) -> &'static str {
        match self {
            Mark::Unresolved => "not-resolved",
            Mark::Friction => "friction-beyond-lubricants",
            Mark::FilmAlone => "film-alone",
            Mark::BetweenPoints => "between-points",
        }
    }

    /// Symbol after a figure in reports; none for an unresolved one, which has no number.
    pub fn symbol(self) -> &'static str {
        match self {
            Mark::Unresolved => "",
            Mark::Friction => " (!)",
            Mark::FilmAlone => " (f)",
            Mark::BetweenPoints => " (b)",
        }
    }

    /// Explanation in one sentence.
    pub fn words(self) -> &'static str {
        match self {
            Mark::Unresolved => "derived from figures that are not resolved",
            Mark::Friction => {
                "(!) derived from friction that no lubricant transmits, because the model does not limit it: not to be used"
            }
            Mark::FilmAlone => {
                "(f) film alone: it does not separate the surfaces, and the friction of the asperities is not included"
            }
            Mark::BetweenPoints => {
                "(b) the extreme lies between the points, next to where the entrainment reverses"
            }
        }
    }

    /// Whether the figure is not to be used at all.
    pub fn forbids(self) -> bool {
        matches!(self, Mark::Unresolved | Mark::Friction)
    }
}

/// A set of marks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Marks(u8);

impl Marks {
    /// Those of a set, worst first.
    pub fn iter(self) -> impl Iterator<Item = Mark> {
        Mark::ALL.into_iter().filter(move |mark| self.has(*mark))
    }

    /// Whether a mark is among them.
    pub fn has(self, mark: Mark) -> bool {
        self.0 & (1 << mark as u8) != 0
    }

    /// The mark where a condition holds.
    pub fn when(condition: bool, mark: Mark) -> Marks {
        Marks(u8::from(condition) << mark as u8)
    }

    /// Symbols after a figure in reports.
    pub fn symbols(self) -> String {
        self.iter().map(Mark::symbol).collect()
    }
}

impl BitOr for Marks {
    type Output = Marks;

    fn bitor(self, other: Marks) -> Marks {
        Marks(self.0 | other.0)
    }
}

impl Sum for Marks {
    fn sum<I: Iterator<Item = Marks>>(all: I) -> Marks {
        all.fold(Marks::default(), Marks::bitor)
    }
}

/// The marks of a figure of a contact. Friction that no lubricant transmits also invalidates heat and temperatures.
pub fn of_figure(solution: &Solution, figure: Figure) -> Marks {
    let is_of_friction = match figure.section() {
        Section::Traction
        | Section::Shear
        | Section::Temperature
        | Section::Heat
        | Section::Stress => true,
        Section::Film
        | Section::Pressure
        | Section::Supply
        | Section::Roller
        | Section::Asperities => false,
    };
    let warned = |kind| is_of_friction && solution.warnings.iter().any(|w| w.kind == kind);
    Marks::when(warned(WarningKind::Friction), Mark::Friction)
        | Marks::when(warned(WarningKind::Roughness), Mark::FilmAlone)
}

/// A number with its error bar and its marks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Marked {
    /// The value, SI.
    pub value: f64,
    /// Half-width of its error bar; `None` where it comes from a formula alone.
    pub error: Option<f64>,
    /// Marks: why it is not to be used as it is.
    pub marks: Marks,
}

impl Marked {
    /// A number that a formula gives: without a bar.
    pub fn exact(value: f64) -> Marked {
        Marked {
            value,
            error: None,
            marks: Marks::default(),
        }
    }

    /// A figure of a contact, if it has it.
    pub fn of(solution: &Solution, figure: Figure) -> Option<Marked> {
        let found = solution.figure(figure)?.estimate();
        Some(Marked::from(found).with(of_figure(solution, figure)))
    }

    /// Value and bar.
    pub fn estimate(self) -> Estimate {
        Estimate {
            value: self.value,
            error: self.error,
        }
    }

    /// Whether there is a number to show: its parts are resolved, and its bar is narrow enough.
    pub fn is_resolved(self) -> bool {
        !self.marks.has(Mark::Unresolved) && self.estimate().is_resolved()
    }

    /// Whether it is not to be used: not resolved, or with a mark that forbids it.
    pub fn is_doubtful(self) -> bool {
        !self.is_resolved() || self.marks.iter().any(Mark::forbids)
    }

    /// The same with further marks.
    #[must_use]
    pub fn with(self, marks: Marks) -> Marked {
        Marked {
            marks: self.marks | marks,
            ..self
        }
    }

    /// The same with a bar that is wider by so much, if it has one.
    #[must_use]
    pub fn wider(self, by: f64) -> Marked {
        Marked {
            error: self.error.map(|error| error + by),
            ..self
        }
    }

    /// Its size.
    #[must_use]
    pub fn abs(self) -> Marked {
        Marked {
            value: self.value.abs(),
            ..self
        }
    }

    /// `base + self`: a temperature above another, which is resolved where the rise is.
    #[must_use]
    pub fn above(self, base: f64) -> Marked {
        Marked {
            value: base + self.value,
            ..self.with(Marks::when(!self.is_resolved(), Mark::Unresolved))
        }
    }

    /// A function of it; its bar is the larger of its changes over the bar to both sides.
    #[must_use]
    pub fn map(self, of: impl Fn(f64) -> f64) -> Marked {
        let value = of(self.value);
        let change = |error: f64| {
            let ends = [self.value - error, self.value + error].map(&of);
            ends.map(|end| (end - value).abs())
                .into_iter()
                .fold(0.0, f64::max)
        };
        Marked {
            value,
            error: self.error.map(change),
            marks: self.marks | Marks::when(!self.is_resolved(), Mark::Unresolved),
        }
    }
}

/// A number that a formula gives.
impl From<f64> for Marked {
    fn from(value: f64) -> Marked {
        Marked::exact(value)
    }
}

impl From<Estimate> for Marked {
    fn from(estimate: Estimate) -> Marked {
        Marked {
            value: estimate.value,
            error: estimate.error,
            marks: Marks::default(),
        }
    }
}

/// Bars of contacts that are solved in one way err in one way: they add. There is none where one of both has none.
impl Add for Marked {
    type Output = Marked;

    fn add(self, other: Marked) -> Marked {
        Marked {
            value: self.value + other.value,
            error: self.error.zip(other.error).map(|(a, b)| a + b),
            marks: self.marks | other.marks,
        }
    }
}

impl Sub for Marked {
    type Output = Marked;

    fn sub(self, other: Marked) -> Marked {
        self + other * -1.0
    }
}

impl Mul<f64> for Marked {
    type Output = Marked;

    fn mul(self, factor: f64) -> Marked {
        Marked {
            value: self.value * factor,
            error: self.error.map(|error| error * factor.abs()),
            ..self
        }
    }
}

impl Div<f64> for Marked {
    type Output = Marked;

    fn div(self, divisor: f64) -> Marked {
        Mul::mul(self, divisor.recip())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(value: f64, error: f64, mark: Option<Mark>) -> Marked {
        Marked {
            value,
            error: Some(error),
            marks: mark.map_or(Marks::default(), |mark| Marks::when(true, mark)),
        }
    }

    /// By hand: 3 ± 0.1 with a mark, and 5 ± 0.2 without.
    #[test]
    fn derived_numbers_keep_the_marks() {
        let (doubted, sound) = (
            number(3.0, 0.1, Some(Mark::Friction)),
            number(5.0, 0.2, None),
        );
        for (found, value, error) in [
            (doubted + sound, 8.0, 0.3),
            (sound - doubted, 2.0, 0.3),
            (doubted * -2.0, -6.0, 0.2),
            (doubted / 10.0, 0.3, 0.01),
            (doubted.above(300.0), 303.0, 0.1),
            (doubted.map(|x| x * x), 9.0, 0.61),
        ] {
            assert!((found.value - value).abs() < 1e-12, "{found:?}");
            assert!((found.error.unwrap() - error).abs() < 1e-12, "{found:?}");
            assert!(found.marks.has(Mark::Friction) && found.is_doubtful());
            assert!(found.is_resolved());
        }
        assert_eq!((sound + sound).marks, Marks::default());
        assert_eq!((sound + Marked::exact(1.0)).error, None);
        let both = doubted.with(Marks::when(true, Mark::FilmAlone));
        assert_eq!(both.marks.symbols(), " (!) (f)");
    }

    /// A rise of 100 ± 60 K is not resolved, nor is a temperature of 400 ± 60 K derived from it, nor its safety; a number with a label may be used.
    #[test]
    fn numbers_derived_from_unresolved_ones_are_unresolved() {
        let rise = number(100.0, 60.0, None);
        let hot = rise.above(300.0);
        assert!(hot.estimate().is_resolved() && !hot.is_resolved());
        assert!(!rise.map(|rise| 200.0 / (rise + 1000.0)).is_resolved());
        assert!(!(hot * 2.0 + Marked::exact(1.0)).is_resolved());
        let labelled = number(1.0, 0.1, Some(Mark::FilmAlone));
        assert!(labelled.is_resolved() && !labelled.is_doubtful());
    }
}
