//! Intervals that numbers must lie in.

use std::fmt;

/// An interval of allowed values, in SI. NaN and infinity are refused by every reader before this check.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    lower: f64,
    upper: f64,
    lower_excluded: bool,
    upper_excluded: bool,
}

impl Bounds {
    /// Any finite number.
    pub const ANY: Self = Self::closed(f64::NEG_INFINITY, f64::INFINITY);
    /// Above zero.
    pub const POSITIVE: Self = Self::open(0.0, f64::INFINITY);
    /// Zero or above.
    pub const NON_NEGATIVE: Self = Self::closed(0.0, f64::INFINITY);
    /// Below zero.
    pub const NEGATIVE: Self = Self::open(f64::NEG_INFINITY, 0.0);

    /// From `lower` to `upper`, both allowed.
    #[must_use]
    pub const fn closed(lower: f64, upper: f64) -> Self {
        Self {
            lower,
            upper,
            lower_excluded: false,
            upper_excluded: false,
        }
    }

    /// Between `lower` and `upper`, both excluded.
    #[must_use]
    pub const fn open(lower: f64, upper: f64) -> Self {
        Self {
            lower,
            upper,
            lower_excluded: true,
            upper_excluded: true,
        }
    }

    /// From `lower`, allowed, to `upper`, excluded.
    #[must_use]
    pub const fn from_to(lower: f64, upper: f64) -> Self {
        Self {
            lower,
            upper,
            lower_excluded: false,
            upper_excluded: true,
        }
    }

    /// Above `lower`, excluded, up to `upper`, allowed.
    #[must_use]
    pub const fn above_to(lower: f64, upper: f64) -> Self {
        Self {
            lower,
            upper,
            lower_excluded: true,
            upper_excluded: false,
        }
    }

    /// Both ends, where they are finite.
    #[must_use]
    pub fn ends(&self) -> Option<[f64; 2]> {
        (self.lower.is_finite() && self.upper.is_finite()).then_some([self.lower, self.upper])
    }

    /// Whether `value` is allowed.
    #[must_use]
    pub fn contains(&self, value: f64) -> bool {
        let above = if self.lower_excluded {
            value > self.lower
        } else {
            value >= self.lower
        };
        let below = if self.upper_excluded {
            value < self.upper
        } else {
            value <= self.upper
        };
        above && below
    }

    /// The interval in words that follow "must be", with `unit` (SI) after the numbers.
    #[must_use]
    pub fn describe(&self, unit: &str) -> String {
        let number = |value: f64, excluded: bool| {
            let unit = if unit.is_empty() {
                String::new()
            } else {
                format!(" {unit}")
            };
            let excluded = if excluded { " (excluded)" } else { "" };
            let readable = value == 0.0 || (1e-3..1e5).contains(&value.abs());
            if readable {
                format!("{value}{unit}{excluded}")
            } else {
                format!("{value:e}{unit}{excluded}")
            }
        };
        match (self.lower.is_finite(), self.upper.is_finite()) {
            (false, false) => "finite".to_owned(),
            (true, false) if self.lower == 0.0 && self.lower_excluded => "positive".to_owned(),
            (true, false) if self.lower == 0.0 => "zero or positive".to_owned(),
            (false, true) if self.upper == 0.0 && self.upper_excluded => "negative".to_owned(),
            (true, false) if self.lower_excluded => format!("above {}", number(self.lower, false)),
            (true, false) => format!("{} or more", number(self.lower, false)),
            (false, true) if self.upper_excluded => format!("below {}", number(self.upper, false)),
            (false, true) => format!("{} or less", number(self.upper, false)),
            (true, true) => format!(
                "between {} and {}",
                number(self.lower, self.lower_excluded),
                number(self.upper, self.upper_excluded)
            ),
        }
    }
}

impl fmt::Display for Bounds {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.describe(""))
    }
}
