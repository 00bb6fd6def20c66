//! Filled map of a field over the contact area, with colour bar and Hertz circle.

use std::fmt::Write;

use super::axis::{Axis, tick_label, tick_step};
use super::chart::{
    FRAME_WIDTH, Frame, Side, draw_x_axis, draw_y_axis, label_x_axis, label_y_axis, polyline,
};
use super::contour;
use super::svg::{Anchor, INK, LABEL_SIZE, Stroke, Svg, TICK_SIZE, number, text_width};

/// A map of a field given on triangles; lengths in Hertz half-widths.
pub(super) struct FieldMap<'a> {
    pub title: &'a str,
    pub points: &'a [[f64; 2]],
    pub triangles: &'a [[u32; 3]],
    pub values: &'a [f64],
    /// Lower and upper end of both axes.
    pub window: [[f64; 2]; 2],
    /// Boundaries between the colours, rising.
    pub levels: Vec<f64>,
    /// One colour more than levels.
    pub colours: Vec<String>,
    /// Ends of the colour bar.
    pub bar: [f64; 2],
    pub bar_label: &'a str,
    /// Level lines drawn over the colours.
    pub lines: bool,
    /// Colour of the Hertz circle.
    pub circle: &'a str,
}

const BAR_GAP: f64 = 22.0;
const BAR_WIDTH: f64 = 16.0;

impl FieldMap<'_> {
    /// The map as an SVG file.
    pub fn svg(&self) -> String {
        let [[x0, x1], [y0, y1]] = self.window;
        let height = 330.0;
        let frame = Frame {
            left: 62.0,
            top: 16.0,
            width: height * (x1 - x0) / (y1 - y0),
            height,
        };
        let bar_axis = Axis::linear(self.bar_label, self.bar[0], self.bar[1]);
        let ticks = self.bar_ticks();
        let widest = ticks
            .iter()
            .map(|t| text_width(&t.1, TICK_SIZE))
            .fold(0.0, f64::max);
        let bar = Frame {
            left: frame.left + frame.width + BAR_GAP,
            width: BAR_WIDTH,
            ..frame
        };
        let mut svg = Svg::new(
            bar.left + bar.width + widest + 40.0,
            frame.top + frame.height + 52.0,
            self.title,
        );
        let x = Axis::linear("*x*/*a*", x0, x1);
        let y = Axis::linear("*y*/*a*", y0, y1);
        self.draw_field(&mut svg, frame, &x, &y);
        svg.stroke(&frame.outline(), Stroke::solid(INK, FRAME_WIDTH));
        for top in [false, true] {
            draw_x_axis(&mut svg, frame, &x, top);
        }
        label_x_axis(&mut svg, frame, &x, false);
        for side in [Side::Left, Side::Right] {
            draw_y_axis(&mut svg, frame, &y, side);
        }
        label_y_axis(&mut svg, frame, &y, Side::Left, INK);
        self.draw_bar(&mut svg, bar, &bar_axis, &ticks);
        let at = [
            bar.left + bar.width + widest + 26.0,
            bar.top + 0.5 * bar.height,
        ];
        svg.turned_text(at, self.bar_label, LABEL_SIZE, Anchor::Middle, INK, -90.0);
        svg.finish()
    }

    fn draw_field(&self, svg: &mut Svg, frame: Frame, x: &Axis, y: &Axis) {
        svg.begin_clip(frame.left, frame.top, frame.width, frame.height);
        let pixels: Vec<[f64; 2]> = self
            .points
            .iter()
            .map(|p| [frame.x(x, p[0]), frame.y(y, p[1])])
            .collect();
        // Only what reaches into the window
        let seen: Vec<[u32; 3]> = self
            .triangles
            .iter()
            .filter(|t| in_window(t.map(|i| pixels[i as usize]), frame))
            .copied()
            .collect();
        let whole = contour::region(&pixels, self.values, &seen, f64::NEG_INFINITY);
        svg.fill(&closed(&whole.loops), &self.colours[0]);
        let mut lines = String::new();
        for (level, colour) in self.levels.iter().zip(&self.colours[1..]) {
            let region = contour::region(&pixels, self.values, &seen, *level);
            svg.fill(&closed(&region.loops), colour);
            for line in &region.level_lines {
                lines.push_str(&polyline(line));
            }
        }
        if self.lines {
            svg.stroke(&lines, Stroke::solid("#262626", 0.6));
        }
        let radius = frame.x(x, 1.0) - frame.x(x, 0.0);
        let (cx, cy) = (frame.x(x, 0.0), frame.y(y, 0.0));
        let stroke = Stroke::solid(self.circle, 0.9);
        svg.circle(cx, cy, radius, "none", stroke);
        svg.end_clip();
    }

    fn draw_bar(&self, svg: &mut Svg, bar: Frame, axis: &Axis, ticks: &[(f64, String)]) {
        let ends = std::iter::once(self.bar[0])
            .chain(self.levels.iter().copied())
            .chain([self.bar[1]]);
        let edges: Vec<f64> = ends.map(|v| bar.y(axis, v)).collect();
        for (edge, colour) in edges.iter().zip(&self.colours) {
            // Up to the top of the bar: the next colour covers the rest without a seam
            svg.rectangle(bar.left, bar.top, bar.width, edge - bar.top, colour);
        }
        let mut d = String::new();
        for (value, label) in ticks {
            let y = bar.y(axis, *value);
            let edge = bar.left + bar.width;
            let _ = write!(d, "M{} {}h4", number(edge), number(y));
            svg.text([edge + 7.0, y + 4.2], label, TICK_SIZE, Anchor::Start, INK);
        }
        svg.stroke(&d, Stroke::solid(INK, 0.8));
        if self.lines {
            let lines: String = edges[1..edges.len() - 1]
                .iter()
                .map(|y| format!("M{} {}h{}", number(bar.left), number(*y), number(bar.width)))
                .collect();
            svg.stroke(&lines, Stroke::solid("#262626", 0.6));
        }
        svg.stroke(&bar.outline(), Stroke::solid(INK, 0.8));
    }

    /// Levels themselves where lines are drawn, else round numbers.
    fn bar_ticks(&self) -> Vec<(f64, String)> {
        if !self.lines {
            return Axis::linear("", self.bar[0], self.bar[1]).ticks();
        }
        let step = match self.levels[..] {
            [first, second, ..] => second - first,
            _ => tick_step(self.bar[1] - self.bar[0]),
        };
        let every = self.levels.len().div_ceil(14);
        self.levels
            .iter()
            .step_by(every)
            .map(|v| (*v, tick_label(*v, step)))
            .collect()
    }
}

fn in_window(corners: [[f64; 2]; 3], frame: Frame) -> bool {
    let (right, bottom) = (frame.left + frame.width, frame.top + frame.height);
    !(corners.iter().all(|c| c[0] < frame.left)
        || corners.iter().all(|c| c[0] > right)
        || corners.iter().all(|c| c[1] < frame.top)
        || corners.iter().all(|c| c[1] > bottom))
}

fn closed(loops: &[Vec<[f64; 2]>]) -> String {
    loops.iter().map(|points| polyline(points) + "Z").collect()
}
