//! Charts as pictures, alone or several in one.

use super::chart::{Chart, ErrorBars, Look, Series, draw_point, line_stroke};
use super::drawing::{Anchor, Drawing, INK, LABEL_SIZE, Stroke, TICK_SIZE, number};
use super::frame::{
    FRAME_WIDTH, Frame, Side, draw_x_axis, draw_y_axis, label_x_axis, label_y_axis, polyline,
};
use super::legend::{Legend, Place};

/// Frame inside the picture, px.
const LEFT_MARGIN: f64 = 72.0;
const WIDTH: f64 = 420.0;
const HEIGHT: f64 = 290.0;
/// Space for the labels below the frame, px.
const FOOT: f64 = 52.0;
/// Length from which an error bar is seen, px: shorter ones lie within the dots.
const SEEN_BAR: f64 = 6.0;
/// Half the width of the ends of error bars, px.
const BAR_CAP: f64 = 3.0;

/// Diagrams in rows of `columns`, as one picture.
pub fn side_by_side(title: &str, charts: &[Chart], columns: usize) -> Drawing {
    let rows: Vec<&[Chart]> = charts.chunks(columns.max(1)).collect();
    let width = |row: &[Chart]| row.iter().map(|c| c.size()[0]).sum::<f64>();
    // Frames in a row are at the same height.
    let head = |row: &[Chart]| row.iter().map(Chart::head).fold(0.0, f64::max);
    let below = |row: &[Chart]| {
        let heights = row.iter().map(|c| c.size()[1] - c.head());
        heights.fold(0.0, f64::max)
    };
    let mut drawing = Drawing::new(
        rows.iter().map(|r| width(r)).fold(0.0, f64::max),
        rows.iter().map(|r| head(r) + below(r)).sum(),
        title,
    );
    let mut top = 0.0;
    for row in rows {
        let mut left = 0.0;
        for chart in row {
            chart.draw(&mut drawing, [left, top + head(row) - chart.head()]);
            left += chart.size()[0];
        }
        top += head(row) + below(row);
    }
    drawing
}

impl Chart {
    /// The diagram as a picture.
    pub fn drawing(&self) -> Drawing {
        side_by_side(&self.title, std::slice::from_ref(self), 1)
    }

    /// The diagram as an SVG file.
    pub fn svg(&self) -> String {
        self.drawing().svg()
    }

    /// Space over the frame for labels, px.
    fn head(&self) -> f64 {
        let heading = if self.heading.is_empty() { 0.0 } else { 20.0 };
        let labels = match (&self.x_top, self.markers.is_empty()) {
            (Some(_), _) => 52.0,
            (None, false) => 28.0,
            (None, true) => 18.0,
        };
        heading + labels
    }

    /// The frame within the picture whose upper left corner is at a point, px.
    fn frame(&self, [left, top]: [f64; 2]) -> Frame {
        Frame {
            left: left + LEFT_MARGIN,
            top: top + self.head(),
            width: WIDTH,
            height: HEIGHT,
        }
    }

    /// The legend and its place.
    fn legend(&self, frame: Frame) -> Option<(Legend<'_>, Place)> {
        let is_seen = |[_, low, high]: &[f64; 3]| {
            let length = (frame.y(&self.y, *low) - frame.y(&self.y, *high)).abs();
            !length.is_finite() || length > SEEN_BAR
        };
        let mut bars = self.error_bars.iter().flat_map(|b| &b.bars);
        let has_bars = !self.error_label.is_empty() && bars.any(is_seen);
        let legend = Legend::of(self, has_bars.then_some(&*self.error_label))?;
        let place = legend.place(self, frame);
        Some((legend, place))
    }

    /// Width and height of the picture, px.
    fn size(&self) -> [f64; 2] {
        let has_right = self.y_right.is_some() || self.y_other.is_some();
        let right = if has_right { 68.0 } else { 22.0 };
        let legend = self.legend(self.frame([0.0; 2]));
        let extra = legend.map_or(0.0, |(legend, place)| legend.extra(place));
        [
            LEFT_MARGIN + WIDTH + right,
            self.head() + HEIGHT + FOOT + extra,
        ]
    }

    /// Draws with the upper left corner at a point, px.
    fn draw(&self, drawing: &mut Drawing, [left, top]: [f64; 2]) {
        let frame = self.frame([left, top]);
        if !self.heading.is_empty() {
            let at = [frame.left + 0.5 * frame.width, top + 22.0];
            drawing.text(at, &self.heading, LABEL_SIZE, Anchor::Middle, INK);
        }
        self.draw_shades(drawing, frame);
        drawing.begin_clip(frame.left, frame.top, frame.width, frame.height);
        for bars in &self.error_bars {
            self.draw_error_bars(drawing, frame, bars);
        }
        for series in &self.series {
            self.draw_series(drawing, frame, series);
        }
        drawing.end_clip();
        self.draw_axes(drawing, frame);
        if let Some((legend, place)) = self.legend(frame) {
            legend.draw(drawing, place, frame, frame.top + frame.height + FOOT - 8.0);
        }
    }

    fn draw_shades(&self, drawing: &mut Drawing, frame: Frame) {
        for [from, to] in &self.shaded {
            let from = frame.x(&self.x, *from).max(frame.left);
            let to = frame.x(&self.x, *to).min(frame.left + frame.width);
            if to > from {
                drawing.rectangle(from, frame.top, to - from, frame.height, "#efefef");
            }
        }
        for marker in &self.markers {
            let x = frame.x(&self.x, marker.x);
            let d = format!(
                "M{} {}v{}",
                number(x),
                number(frame.top),
                number(frame.height)
            );
            drawing.stroke(
                &d,
                Stroke {
                    colour: "#8c8c8c",
                    width: 0.8,
                    dash: Some([2.0, 3.0]),
                },
            );
            let at = [x + 1.0, frame.top - 6.0];
            drawing.text(at, &marker.label, TICK_SIZE - 1.0, Anchor::Start, "#595959");
        }
    }

    fn draw_series(&self, drawing: &mut Drawing, frame: Frame, series: &Series) {
        let y = self.y_axis(series.side);
        // Far outside of the frame, renderers lose precision
        let limit = |v: f64| v.clamp(-1e4, 1e4);
        let points: Vec<[f64; 2]> = series
            .points
            .iter()
            .map(|[px, py]| [limit(frame.x(&self.x, *px)), limit(frame.y(y, *py))])
            .collect();
        if series.look.has_line() {
            drawing.stroke(&polyline(&points), line_stroke(series));
        }
        let finite = points
            .iter()
            .filter(|p| p[0].is_finite() && p[1].is_finite());
        for point in finite {
            draw_point(drawing, *point, series);
        }
    }

    fn draw_error_bars(&self, drawing: &mut Drawing, frame: Frame, bars: &ErrorBars) {
        let foot = frame.top + frame.height + BAR_CAP;
        let mut d = String::new();
        for [x, low, high] in &bars.bars {
            let (x, top) = (frame.x(&self.x, *x), frame.y(&self.y, *high));
            // Values that are not above zero have no logarithm.
            let bottom = Some(frame.y(&self.y, *low))
                .filter(|y| y.is_finite())
                .unwrap_or(foot);
            let bottom = bottom.clamp(-1e4, 1e4);
            if !x.is_finite() || !top.is_finite() || (bottom - top).abs() < 0.5 * SEEN_BAR {
                continue;
            }
            let top = top.clamp(-1e4, 1e4);
            // A bar that leaves the frame has an arrow there instead of its cap.
            let edges = [
                (frame.top, top < frame.top),
                (frame.top + frame.height, bottom >= foot),
            ];
            for ((edge, leaves), inwards) in edges.into_iter().zip([1.0, -1.0]) {
                if leaves {
                    let [tip, back] =
                        [2.0, 2.0 + 2.0 * BAR_CAP].map(|by| number(edge + inwards * by));
                    let [left, right] = [-BAR_CAP, BAR_CAP].map(|by| number(x + by));
                    d += &format!("M{left} {back}L{} {tip}L{right} {back}", number(x));
                }
            }
            let (left, cap) = (number(x - BAR_CAP), number(2.0 * BAR_CAP));
            let (x, top, bottom) = (number(x), number(top), number(bottom));
            d += &format!("M{x} {top}V{bottom}M{left} {top}h{cap}M{left} {bottom}h{cap}");
        }
        if !d.is_empty() {
            drawing.stroke(&d, Stroke::solid(&bars.colour, 1.0));
        }
    }

    fn draw_axes(&self, drawing: &mut Drawing, frame: Frame) {
        drawing.stroke(&frame.outline(), Stroke::solid(INK, FRAME_WIDTH));
        draw_x_axis(drawing, frame, &self.x, false);
        draw_x_axis(drawing, frame, self.x_top.as_ref().unwrap_or(&self.x), true);
        if let Some(top) = &self.x_top {
            label_x_axis(drawing, frame, top, true);
        }
        label_x_axis(drawing, frame, &self.x, false);
        draw_y_axis(drawing, frame, &self.y, Side::Left);
        label_y_axis(
            drawing,
            frame,
            &self.y,
            Side::Left,
            self.axis_colour(Side::Left),
        );
        match (&self.y_right, &self.y_other) {
            (Some(axis), _) => {
                draw_y_axis(drawing, frame, axis, Side::Right);
                label_y_axis(
                    drawing,
                    frame,
                    axis,
                    Side::Right,
                    self.axis_colour(Side::Right),
                );
            }
            (None, Some(axis)) => {
                draw_y_axis(drawing, frame, axis, Side::Right);
                label_y_axis(drawing, frame, axis, Side::Right, INK);
            }
            (None, None) => draw_y_axis(drawing, frame, &self.y, Side::Right),
        }
    }

    /// With two y axes, labels take the colour of their solid curves, if all of these have the same.
    fn axis_colour(&self, side: Side) -> &str {
        let solid = |s: &&Series| s.side == side && s.look != Look::Dashed;
        let mut colours = self.series.iter().filter(solid).map(|s| &s.colour);
        match (&self.y_right, colours.next()) {
            (Some(_), Some(first)) if colours.all(|colour| colour == first) => first,
            _ => INK,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::axis::Axis;

    /// A bar within the frame has two caps and no arrow; one that leaves it above has an arrow there, one that leaves it on both sides two.
    #[test]
    fn bars_that_leave_the_frame_end_in_arrows() {
        let arrows = |low: f64, high: f64| {
            let axis = |label: &str| Axis::linear(label, 0.0, 1.0);
            let mut chart = Chart::new("bars", axis("x"), axis("y"));
            chart.error_bars.push(ErrorBars {
                bars: vec![[0.5, low, high]],
                colour: "#123456".to_owned(),
            });
            let svg = chart.drawing().svg();
            let bar = svg.lines().find(|line| line.contains("#123456"));
            // Caps are level (h), bars upright (V): slanted strokes are those of arrows.
            let path = bar
                .expect("a bar")
                .split('"')
                .find(|part| part.starts_with('M'));
            path.expect("a path").matches('L').count()
        };
        assert_eq!(arrows(0.4, 0.6), 0);
        assert_eq!(arrows(0.4, 5.0), 2);
        assert_eq!(arrows(-3.0, 5.0), 4);
    }
}
