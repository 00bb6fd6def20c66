//! Curves and points over one or two y axes.

use super::axis::Axis;
use super::drawing::{Drawing, Stroke, number};
use super::frame::Side;

/// Colours distinguishable for colour-blind readers and in grey (Okabe and Ito 2008).
pub const PALETTE: [&str; 6] = [
    "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00",
];

/// How a series is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Look {
    /// Solid line.
    #[default]
    Line,
    /// Dashed line.
    Dashed,
    /// Open circles.
    Circles,
    /// Solid line through filled dots.
    LineAndDots,
    /// Solid line through small open circles.
    LineAndRings,
    /// Filled dots.
    Dots,
    /// Crosses.
    Crosses,
}

impl Look {
    pub(crate) fn has_line(self) -> bool {
        matches!(
            self,
            Look::Line | Look::Dashed | Look::LineAndDots | Look::LineAndRings
        )
    }
}

/// A curve or a set of points.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Series {
    /// Legend entry; empty: none.
    pub label: String,
    /// Points in the units of the axes; a point that is not finite interrupts a line.
    pub points: Vec<[f64; 2]>,
    /// Line or points.
    pub look: Look,
    /// Colour, `#rrggbb`.
    pub colour: String,
    /// Left or right axis.
    pub side: Side,
}

impl Series {
    /// A series on the left axis.
    pub fn new(
        label: impl Into<String>,
        points: Vec<[f64; 2]>,
        look: Look,
        colour: impl Into<String>,
    ) -> Series {
        Series {
            label: label.into(),
            points,
            look,
            colour: colour.into(),
            side: Side::Left,
        }
    }
}

/// Vertical bars through points, for what is not certain.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ErrorBars {
    /// x, and the ends of each bar; one whose lower end is below a logarithmic axis goes to its foot.
    pub bars: Vec<[f64; 3]>,
    /// Colour, `#rrggbb`.
    pub colour: String,
}

/// Vertical line with a label over the frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Marker {
    /// Where.
    pub x: f64,
    /// Label, in label markup.
    pub label: String,
}

/// A diagram.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    /// Title kept in the file's metadata, not drawn.
    pub title: String,
    /// Text over the frame, in label markup; empty: none.
    pub heading: String,
    /// Lower axis.
    pub x: Axis,
    /// Upper axis with other units of the same range, if any.
    pub x_top: Option<Axis>,
    /// Left axis.
    pub y: Axis,
    /// Right axis, if any.
    pub y_right: Option<Axis>,
    /// Right axis with other units of the range of the left one, if any; not with `y_right`.
    pub y_other: Option<Axis>,
    /// Curves, drawn in this order.
    pub series: Vec<Series>,
    /// Error bars on the left axis, below the curves.
    pub error_bars: Vec<ErrorBars>,
    /// Label of the error bars in the legend; empty: no entry.
    pub error_label: String,
    /// Vertical lines.
    pub markers: Vec<Marker>,
    /// Shaded ranges of x.
    pub shaded: Vec<[f64; 2]>,
}

impl Chart {
    /// Diagram without series.
    pub fn new(title: &str, x: Axis, y: Axis) -> Chart {
        Chart {
            title: title.to_owned(),
            heading: String::new(),
            x,
            x_top: None,
            y,
            y_right: None,
            y_other: None,
            series: Vec::new(),
            error_bars: Vec::new(),
            error_label: String::new(),
            markers: Vec::new(),
            shaded: Vec::new(),
        }
    }

    pub(crate) fn y_axis(&self, side: Side) -> &Axis {
        match side {
            Side::Left => &self.y,
            Side::Right => self.y_right.as_ref().unwrap_or(&self.y),
        }
    }
}

/// The mark of a series at a point, if it has one.
pub(crate) fn draw_point(drawing: &mut Drawing, [x, y]: [f64; 2], series: &Series) {
    let colour = &series.colour;
    match series.look {
        Look::Circles => drawing.circle(x, y, 3.2, "white", Stroke::solid(colour, 1.3)),
        Look::LineAndDots => drawing.circle(x, y, 2.6, colour, Stroke::solid("white", 0.6)),
        Look::LineAndRings => drawing.circle(x, y, 2.2, "white", Stroke::solid(colour, 1.1)),
        Look::Dots => drawing.circle(x, y, 3.4, colour, Stroke::solid("white", 0.5)),
        Look::Crosses => {
            let (x, y) = (number(x - 3.0), number(y - 3.0));
            let d = format!("M{x} {y}l6 6m0 -6l-6 6");
            drawing.stroke(&d, Stroke::solid(colour, 1.6));
        }
        Look::Line | Look::Dashed => {}
    }
}

pub(crate) fn line_stroke(series: &Series) -> Stroke<'_> {
    match series.look {
        Look::Dashed => Stroke {
            colour: &series.colour,
            width: 1.3,
            dash: Some([6.0, 4.0]),
        },
        _ => Stroke::solid(&series.colour, 1.7),
    }
}
