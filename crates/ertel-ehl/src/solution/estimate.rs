//! A figure with its error bar, and with its place.

use serde::ser::{Serialize, SerializeMap, Serializer};

/// A figure with its discretisation error bar. Written with `resolved`: false where the bar is wider than half of the value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The value on the finest mesh.
    pub value: f64,
    /// Half-width of the error bar, same unit; `None` when no coarser solution was computed.
    pub error: Option<f64>,
}

impl Serialize for Estimate {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(3))?;
        map.serialize_entry("value", &self.value)?;
        map.serialize_entry("error", &self.error)?;
        map.serialize_entry("resolved", &self.error.map(|_| self.is_resolved()))?;
        map.end()
    }
}

impl Estimate {
    /// Whether its bar, if it has one, is not wider than half of its value.
    pub fn is_resolved(&self) -> bool {
        (self.error).is_none_or(|error| error <= WIDEST * self.value.abs())
    }

    /// with/without of two solutions with independent errors.
    pub fn ratio(with: Estimate, without: Estimate) -> Estimate {
        let ratio = with.value / without.value;
        let relative = |e: Estimate| Some(e.error? / e.value.abs());
        let both = relative(with).zip(relative(without));
        let error = both.map(|(with, without)| (with + without) * ratio.abs());
        Estimate {
            value: ratio,
            error: error.filter(|error| error.is_finite()),
        }
    }

    /// 1 − with/without of two solutions with independent errors.
    pub fn reduction(with: Estimate, without: Estimate) -> Estimate {
        let ratio = Estimate::ratio(with, without);
        Estimate {
            value: 1.0 - ratio.value,
            ..ratio
        }
    }
}

/// A figure with its discretisation error bar and the place where it occurs, coordinates in m.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Located {
    /// The value on the finest mesh.
    pub value: f64,
    /// Half-width of the error bar, same unit; `None` as in [`Estimate`], and where no coarser mesh has the figure.
    pub error: Option<f64>,
    /// Whether the bar, if there is one, is narrow enough for a number: up to half of the value (of a temperature, of its rise), and up
    /// to a tenth of a largest pressure, whose value is a lower bound otherwise.
    pub resolved: bool,
    /// Position along the motion, m.
    pub x: f64,
    /// Position across it, m (0 for line contacts; reported at y ≤ 0, its mirror image has it too).
    pub y: f64,
    /// Half-width of the error bar of the place, m; `None` likewise.
    pub place_error: Option<f64>,
    /// Whether that is at most a quarter of the contact's half-width.
    pub place_resolved: bool,
}

impl Located {
    /// The figure without its place.
    pub fn estimate(&self) -> Estimate {
        Estimate {
            value: self.value,
            error: self.error,
        }
    }
}

/// Largest error bar, over the size of the figure, with which the figure is shown as a number.
pub const WIDEST: f64 = 0.5;
