//! Layout of the contact area in a picture: the motion points right, or down if the contact is much longer across the motion than along it.

use ertel_plot::Side;
use ertel_plot::axis::Axis;
use ertel_plot::drawing::{Drawing, INK, Stroke, number};
use ertel_plot::frame::{FRAME_WIDTH, Frame, label_x_axis, label_y_axis, polyline};
use std::fmt::Write;

/// Ratio of length across to length along the motion from which a contact is rotated, as in result pages.
const SLENDER: f64 = 1.6;

/// Frame height of most contacts, px, limits of its width, and minimum height for the longest contacts.
const HEIGHT: f64 = 330.0;
const WIDTHS: [f64; 2] = [220.0, 760.0];
const LEAST_HEIGHT: f64 = 60.0;

/// Motion arrow: distance from the corner, length and head, px.
const FROM_CORNER: f64 = 14.0;
const ARROW: f64 = 30.0;
const HEAD: f64 = 7.0;

/// Maps the contact area to a picture; lengths in Hertz half-widths, equal scales on both axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Layout {
    /// Lower and upper limit of x and y.
    pub window: [[f64; 2]; 2],
    /// Whether y points right and x down.
    pub is_turned: bool,
}

impl Layout {
    /// For a window of x and y.
    pub fn of(window: [[f64; 2]; 2]) -> Layout {
        let [along, across] = window.map(|[low, high]| high - low);
        Layout {
            window,
            is_turned: across > SLENDER * along,
        }
    }

    /// Ranges to the right and upwards.
    fn spans(&self) -> [f64; 2] {
        let [along, across] = self.window.map(|[low, high]| high - low);
        match self.is_turned {
            true => [across, along],
            false => [along, across],
        }
    }

    /// Width and height of the frame, px.
    pub fn size(&self) -> [f64; 2] {
        let [wide, high] = self.spans();
        let width = (HEIGHT * wide / high).clamp(WIDTHS[0], WIDTHS[1]);
        let height = (width * high / wide).max(LEAST_HEIGHT);
        [height * wide / high, height]
    }

    /// Length per pixel.
    pub fn pixel(&self) -> f64 {
        self.spans()[1] / self.size()[1]
    }

    /// The layout in a frame of this size.
    pub fn within(self, frame: Frame) -> Placed {
        let [[x0, x1], [y0, y1]] = self.window;
        Placed {
            is_turned: self.is_turned,
            frame,
            x: Axis::linear("*x*/*a*", x0, x1),
            y: Axis::linear("*y*/*a*", y0, y1),
        }
    }
}

/// A layout in its frame.
pub(super) struct Placed {
    is_turned: bool,
    frame: Frame,
    x: Axis,
    y: Axis,
}

impl Placed {
    /// Position of a point, px.
    pub fn at(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        match self.is_turned {
            true => [
                self.frame.x(&self.y, y),
                self.frame.upside_down().y(&self.x, x),
            ],
            false => [self.frame.x(&self.x, x), self.frame.y(&self.y, y)],
        }
    }

    /// Direction of a vector in the picture, degrees, clockwise from the right.
    pub fn direction(&self, [x, y]: [f64; 2]) -> f64 {
        match self.is_turned {
            true => x.atan2(y),
            false => (-y).atan2(x),
        }
        .to_degrees()
    }

    /// The frame with ticks and labels.
    pub fn draw_axes(&self, drawing: &mut Drawing) {
        let (right, up, upright) = match self.is_turned {
            true => (&self.y, &self.x, self.frame.upside_down()),
            false => (&self.x, &self.y, self.frame),
        };
        drawing.stroke(&self.frame.outline(), Stroke::solid(INK, FRAME_WIDTH));
        label_x_axis(drawing, self.frame, right, false);
        draw_ticks(drawing, [self.frame, upright], right, up);
        label_y_axis(drawing, upright, up, Side::Left, INK);
    }

    /// An arrow in the upper left corner in the direction of entrainment.
    pub fn draw_motion(&self, drawing: &mut Drawing) {
        let from = [self.frame.left + FROM_CORNER, self.frame.top + FROM_CORNER];
        let at = |along: f64, across: f64| match self.is_turned {
            true => [from[0] - across, from[1] + along],
            false => [from[0] + along, from[1] + across],
        };
        let length = match self.is_turned {
            true => ARROW.min(self.frame.height - 2.0 * FROM_CORNER),
            false => ARROW,
        };
        let tip = at(length, 0.0);
        let shaft = polyline(&[at(0.0, 0.0), tip]);
        let back = |side: f64| at(length - HEAD, side * HEAD / 2.0);
        let head: String = [back(1.0), tip, back(-1.0)]
            .iter()
            .enumerate()
            .map(|(i, [x, y])| {
                format!(
                    "{}{} {}",
                    if i == 0 { "M" } else { "L" },
                    number(*x),
                    number(*y)
                )
            })
            .collect();
        // Black on white is visible on every colour.
        for (colour, width) in [("#ffffff", 4.0), ("#000000", 1.6)] {
            drawing.stroke(&format!("{shaft}{head}"), Stroke::solid(colour, width));
        }
    }
}

/// Ticks point outwards to remain visible; `upright` is the frame, inverted if y increases downwards.
pub(in crate::output) fn draw_ticks(
    drawing: &mut Drawing,
    [frame, upright]: [Frame; 2],
    x: &Axis,
    y: &Axis,
) {
    let mut d = String::new();
    let (bottom, left) = (frame.top + frame.height, frame.left);
    for (value, _) in x.ticks() {
        let _ = write!(d, "M{} {}v4", number(frame.x(x, value)), number(bottom));
    }
    for (value, _) in y.ticks() {
        let _ = write!(d, "M{} {}h-4", number(left), number(upright.y(y, value)));
    }
    drawing.stroke(&d, Stroke::solid(INK, 0.8));
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frame(layout: Layout) -> Frame {
        let [width, height] = layout.size();
        Frame {
            left: 10.0,
            top: 20.0,
            width,
            height,
        }
    }

    /// A contact ten times as long across the motion as along it: its length is horizontal and its inlet at the top.
    #[test]
    fn slender_contacts_are_rotated() {
        for (window, is_turned) in [
            ([[-1.0, 1.0], [-10.0, 10.0]], true),
            ([[-1.5, 1.5], [-1.3, 1.3]], false),
            ([[-1.0, 1.0], [-60.0, 60.0]], true),
            ([[-5.0, 5.0], [-1.0, 1.0]], false),
        ] {
            let layout = Layout::of(window);
            assert_eq!(layout.is_turned, is_turned);
            let [width, height] = layout.size();
            assert!(width >= 0.9 * height && height >= 60.0, "{width} {height}");
            let frame = frame(layout);
            let placed = layout.within(frame);
            let [inlet, outlet] = [window[0][0], window[0][1]].map(|x| placed.at([x, 0.0]));
            let [left, right] = [window[1][0], window[1][1]].map(|y| placed.at([0.0, y]));
            let moved = [outlet[0] - inlet[0], outlet[1] - inlet[1]];
            let across = [right[0] - left[0], right[1] - left[1]];
            match is_turned {
                true => assert!(moved[0].abs() < 1e-9 && moved[1] > 0.0 && across[0] > 0.0),
                false => assert!(moved[0] > 0.0 && moved[1].abs() < 1e-9 && across[1] < 0.0),
            }
            // Neither mirrored nor stretched: from x to y is a quarter turn counterclockwise.
            let turn = moved[0] * across[1] - moved[1] * across[0];
            assert!(turn < 0.0);
            let scale = |length: f64, [low, high]: [f64; 2]| length / (high - low);
            let scales = [
                scale(moved[0].hypot(moved[1]), window[0]),
                scale(across[0].hypot(across[1]), window[1]),
            ];
            assert!((scales[0] / scales[1] - 1.0).abs() < 1e-9, "{scales:?}");
            assert!((layout.pixel() * scales[0] - 1.0).abs() < 1e-9);
            // Directions agree with positions.
            let from = placed.at([0.0, 0.0]);
            let to = placed.at([0.3, 0.1]);
            let seen = (to[1] - from[1]).atan2(to[0] - from[0]).to_degrees();
            assert!((placed.direction([0.3, 0.1]) - seen).abs() < 1e-9);
        }
    }

    /// The arrow points from the inlet to the outlet and stays in the frame.
    #[test]
    fn the_arrow_shows_the_motion() {
        for (window, sign) in [
            ([[-1.0, 1.0], [-60.0, 60.0]], [0.0, 1.0]),
            ([[-1.5, 1.5], [-1.3, 1.3]], [1.0, 0.0]),
        ] {
            let layout = Layout::of(window);
            let frame = frame(layout);
            let mut drawing = Drawing::new(900.0, 500.0, "");
            layout.within(frame).draw_motion(&mut drawing);
            let svg = drawing.svg();
            let shaft = svg.split("d=\"M").nth(1).unwrap();
            let numbers: Vec<f64> = (shaft.split(['M', 'L', 'l', ' ']).take(4))
                .map(|n| n.parse().unwrap())
                .collect();
            let [x, y, dx, dy] = numbers[..] else {
                panic!("{shaft}")
            };
            assert!(dx * sign[0] + dy * sign[1] > 20.0 || dy > 0.5 * frame.height - 15.0);
            assert!((dx * sign[1]).abs() < 1e-9 && (dy * sign[0]).abs() < 1e-9);
            assert!(x + dx < frame.left + frame.width && y + dy < frame.top + frame.height);
        }
    }
}
