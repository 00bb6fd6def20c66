//! Frame of a diagram: where values lie in the picture, ticks and labels around it.

use std::fmt::Write;

use super::axis::{Axis, AxisScale};
use super::drawing::{Anchor, Drawing, INK, LABEL_SIZE, Stroke, TICK_SIZE, number, text_width};
use super::simplify::simplify;

/// Frame of a diagram inside the picture, px.
#[derive(Clone, Copy)]
pub struct Frame {
    /// Its left edge.
    pub left: f64,
    /// Its upper edge.
    pub top: f64,
    /// Width.
    pub width: f64,
    /// Height.
    pub height: f64,
}

impl Frame {
    /// Place of a value of the x axis, px.
    pub fn x(&self, axis: &Axis, value: f64) -> f64 {
        self.left + axis.position(value) * self.width
    }

    /// Place of a value of a y axis, px.
    pub fn y(&self, axis: &Axis, value: f64) -> f64 {
        self.top + (1.0 - axis.position(value)) * self.height
    }

    /// The same with values of a y axis that rise downwards.
    #[must_use]
    pub fn upside_down(self) -> Frame {
        Frame {
            top: self.top + self.height,
            height: -self.height,
            ..self
        }
    }

    /// Its edge as a path of SVG.
    pub fn outline(&self) -> String {
        format!(
            "M{} {}h{}v{}h{}Z",
            number(self.left),
            number(self.top),
            number(self.width),
            number(self.height),
            number(-self.width)
        )
    }
}

const TICK: f64 = 6.0;
const MINOR_TICK: f64 = 3.0;
/// Width of the line around a diagram, px.
pub const FRAME_WIDTH: f64 = 1.0;

/// Distance that nobody sees, px.
const UNSEEN: f64 = 0.05;

/// Path through pixel points, interrupted where one is not finite; points that make no visible difference are omitted.
pub fn polyline(points: &[[f64; 2]]) -> String {
    let whole = |p: &[f64; 2]| p.iter().all(|v| v.is_finite());
    (points.split(|p| !whole(p)))
        .map(|line| path(&simplify(line, UNSEEN)))
        .collect()
}

/// Path through pixel points.
fn path(points: &[[f64; 2]]) -> String {
    let mut d = String::new();
    // Where the pen is, in hundredths of a pixel: relative steps make short files
    let mut pen: Option<[i64; 2]> = None;
    for point in points {
        let at = point.map(|v| (100.0 * v).round() as i64);
        let (command, shown) = match pen {
            None => ('M', at),
            Some(from) if from == at => continue,
            Some(from) => ('l', [at[0] - from[0], at[1] - from[1]]),
        };
        let [x, y] = shown.map(|v| number(v as f64 / 100.0));
        let _ = write!(d, "{command}{x} {y}");
        pen = Some(at);
    }
    d
}

/// Ticks on the lower or upper edge of the frame, pointing inwards.
pub(crate) fn draw_x_axis(drawing: &mut Drawing, frame: Frame, axis: &Axis, top: bool) {
    let (edge, inwards) = if top {
        (frame.top, 1.0)
    } else {
        (frame.top + frame.height, -1.0)
    };
    draw_ticks(drawing, axis, |value, length| {
        let (x, y) = (number(frame.x(axis, value)), number(edge));
        format!("M{x} {y}v{}", number(inwards * length))
    });
}

fn draw_ticks(drawing: &mut Drawing, axis: &Axis, tick: impl Fn(f64, f64) -> String) {
    let major = axis.ticks().into_iter().map(|(value, _)| tick(value, TICK));
    let minor = axis.minor_ticks().into_iter();
    let d: String = major.chain(minor.map(|v| tick(v, MINOR_TICK))).collect();
    drawing.stroke(&d, Stroke::solid(INK, 0.8));
}

/// Tick labels and axis label below or above the frame.
pub fn label_x_axis(drawing: &mut Drawing, frame: Frame, axis: &Axis, top: bool) {
    let (ticks_at, label_at) = if top {
        (frame.top - 7.0, frame.top - 29.0)
    } else {
        (
            frame.top + frame.height + 17.0,
            frame.top + frame.height + 39.0,
        )
    };
    for (value, label) in axis.ticks() {
        let at = [frame.x(axis, value), ticks_at];
        drawing.text(at, &label, TICK_SIZE, Anchor::Middle, INK);
    }
    let at = [frame.left + 0.5 * frame.width, label_at];
    drawing.text(at, &axis.label, LABEL_SIZE, Anchor::Middle, INK);
}

/// Ticks on the left or right edge of the frame, pointing inwards.
pub(crate) fn draw_y_axis(drawing: &mut Drawing, frame: Frame, axis: &Axis, side: Side) {
    let (edge, inwards) = match side {
        Side::Left => (frame.left, 1.0),
        Side::Right => (frame.left + frame.width, -1.0),
    };
    draw_ticks(drawing, axis, |value, length| {
        let (x, y) = (number(edge), number(frame.y(axis, value)));
        format!("M{x} {y}h{}", number(inwards * length))
    });
}

/// Tick labels and axis label next to the frame.
pub fn label_y_axis(drawing: &mut Drawing, frame: Frame, axis: &Axis, side: Side, colour: &str) {
    let ticks = axis.ticks();
    let widest = ticks
        .iter()
        .map(|t| tick_width(&t.1, axis.scale))
        .fold(0.0, f64::max);
    let (ticks_at, label_at, anchor) = match side {
        Side::Left => (frame.left - 6.0, frame.left - widest - 18.0, Anchor::End),
        Side::Right => {
            let edge = frame.left + frame.width;
            (edge + 6.0, edge + widest + 26.0, Anchor::Start)
        }
    };
    for (value, label) in ticks {
        let at = [ticks_at, frame.y(axis, value) + 4.2];
        drawing.text(at, &label, TICK_SIZE, anchor, colour);
    }
    let at = [label_at, frame.top + 0.5 * frame.height];
    drawing.turned_text(at, &axis.label, LABEL_SIZE, Anchor::Middle, colour, -90.0);
}

fn tick_width(label: &str, scale: AxisScale) -> f64 {
    match scale {
        AxisScale::Linear | AxisScale::Count => text_width(label, TICK_SIZE),
        AxisScale::Log => text_width(label, 0.9 * TICK_SIZE),
    }
}

/// Which y axis a series belongs to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Side {
    /// Left axis.
    #[default]
    Left,
    /// Right axis.
    Right,
}
