//! Values around a circle: loads and films of the rolling elements of a bearing.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::axis::Axis;
use super::chart::{Look, Series, draw_point, line_stroke};
use super::drawing::{Anchor, Drawing, INK, LABEL_SIZE, Stroke, TICK_SIZE};
use super::frame::polyline;

/// A diagram around a circle. Angles in rad from the foot of the circle, counted against the clock; values from its middle outwards.
#[derive(Clone, Debug, PartialEq)]
pub struct Polar {
    /// Title kept in the file's metadata, not drawn.
    pub title: String,
    /// Text over the circle, in label markup.
    pub heading: String,
    /// Values from the middle to the rim; it begins at zero.
    pub radius: Axis,
    /// Points (angle, value), drawn in this order.
    pub series: Vec<Series>,
    /// Text at the rim of angles.
    pub labels: Vec<(f64, String)>,
}

/// Radius of the circle, px.
const RADIUS: f64 = 150.0;
/// Space around it for labels, px.
const MARGIN: f64 = 40.0;
/// Space over it for the heading, px.
const HEAD: f64 = 26.0;
/// Height of an entry of the legend, px.
const ENTRY: f64 = 18.0;
const GREY: &str = "#cfcfcf";

/// Diagrams in one row, as one picture.
pub fn polar_row(title: &str, polars: &[Polar]) -> Drawing {
    let size = polars.iter().map(Polar::size);
    let width = size.clone().map(|s| s[0]).sum::<f64>();
    let height = size.map(|s| s[1]).fold(0.0, f64::max);
    let mut drawing = Drawing::new(width, height, title);
    let mut left = 0.0;
    for polar in polars {
        polar.draw(&mut drawing, left);
        left += polar.size()[0];
    }
    drawing
}

impl Polar {
    /// Width and height, px.
    fn size(&self) -> [f64; 2] {
        let entries = self.series.iter().filter(|s| !s.label.is_empty()).count();
        let side = 2.0 * (RADIUS + MARGIN);
        [side, HEAD + side + ENTRY * (entries + 1) as f64]
    }

    /// Where a value at an angle lies, px.
    fn place(&self, centre: [f64; 2], angle: f64, value: f64) -> [f64; 2] {
        let r = RADIUS * self.radius.position(value);
        let (sin, cos) = (FRAC_PI_2 - angle).sin_cos();
        [centre[0] + r * cos, centre[1] + r * sin]
    }

    fn draw(&self, drawing: &mut Drawing, left: f64) {
        let centre = [left + MARGIN + RADIUS, HEAD + MARGIN + RADIUS];
        let at = [centre[0], HEAD - 6.0];
        drawing.text(at, &self.heading, LABEL_SIZE, Anchor::Middle, INK);
        let ticks = self.radius.ticks();
        for (value, _) in &ticks {
            let r = RADIUS * self.radius.position(*value);
            if r > 0.0 {
                drawing.ellipse(centre, [r; 2], 0.0, Stroke::solid(GREY, 0.7));
            }
        }
        for (angle, label) in &self.labels {
            let rim = self.place(centre, *angle, self.radius.high);
            let d = polyline(&[centre, rim]);
            drawing.stroke(&d, Stroke::solid(GREY, 0.7));
            let beyond = self.radius.low + 1.09 * (self.radius.high - self.radius.low);
            let [x, y] = self.place(centre, *angle, beyond);
            let anchor = match x - centre[0] {
                d if d > 10.0 => Anchor::Start,
                d if d < -10.0 => Anchor::End,
                _ => Anchor::Middle,
            };
            drawing.text([x, y + 4.0], label, TICK_SIZE, anchor, INK);
        }
        drawing.ellipse(centre, [RADIUS; 2], 0.0, Stroke::solid(INK, 1.0));
        for series in &self.series {
            self.draw_series(drawing, centre, series);
        }
        // On top of the lines, so that they can be read.
        let inside = |value: f64| value > self.radius.low && self.radius.position(value) < 0.95;
        for (value, label) in ticks.iter().filter(|(value, _)| inside(*value)) {
            let [x, y] = self.place(centre, 0.5 * TAU - 0.12, *value);
            drawing.text(
                [x + 2.0, y + 4.0],
                label,
                TICK_SIZE - 1.0,
                Anchor::Start,
                INK,
            );
        }
        let mut y = HEAD + 2.0 * (RADIUS + MARGIN) + 12.0;
        drawing.text(
            [centre[0], y],
            &self.radius.label,
            TICK_SIZE,
            Anchor::Middle,
            INK,
        );
        let named = self.series.iter().filter(|s| !s.label.is_empty());
        for series in named {
            y += ENTRY;
            let from = [centre[0] - 90.0, y - 4.0];
            let to = [centre[0] - 62.0, y - 4.0];
            if series.look.has_line() {
                drawing.stroke(&polyline(&[from, to]), line_stroke(series));
            }
            draw_point(drawing, [0.5 * (from[0] + to[0]), from[1]], series);
            let at = [to[0] + 8.0, y];
            drawing.text(at, &series.label, TICK_SIZE, Anchor::Start, INK);
        }
    }

    /// Lines close round the circle.
    fn draw_series(&self, drawing: &mut Drawing, centre: [f64; 2], series: &Series) {
        let mut points: Vec<[f64; 2]> = (series.points.iter())
            .map(|[angle, value]| self.place(centre, *angle, *value))
            .collect();
        if series.look.has_line() {
            if let (Some(first), false) = (points.first().copied(), points.len() < 3) {
                points.push(first);
            }
            drawing.stroke(&polyline(&points), line_stroke(series));
        } else {
            // From the middle to each: what presses there.
            let stems = series
                .points
                .iter()
                .zip(&points)
                .filter(|([_, value], _)| *value > self.radius.low);
            for (_, point) in stems {
                let d = polyline(&[centre, *point]);
                drawing.stroke(&d, Stroke::solid(&series.colour, 1.3));
            }
        }
        for point in points
            .iter()
            .filter(|p| p[0].is_finite() && p[1].is_finite())
        {
            draw_point(drawing, *point, series);
        }
    }

    /// Series of this look and colour.
    pub fn add(&mut self, label: &str, points: Vec<[f64; 2]>, look: Look, colour: &str) {
        self.series.push(Series::new(label, points, look, colour));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::number;

    fn px(at: [f64; 2]) -> [String; 2] {
        at.map(number)
    }

    fn polar() -> Polar {
        Polar {
            title: "loads".into(),
            heading: "Load".into(),
            radius: Axis::linear("load (N)", 0.0, 100.0),
            series: Vec::new(),
            labels: vec![(0.0, "1".into())],
        }
    }

    /// The foot is 0, and a quarter against the clock from there is on the right.
    #[test]
    fn angles_begin_at_the_foot() {
        let polar = polar();
        assert_eq!(px(polar.place([0.0; 2], 0.0, 100.0)), ["0", "150"]);
        assert_eq!(px(polar.place([0.0; 2], FRAC_PI_2, 50.0)), ["75", "0"]);
        assert_eq!(px(polar.place([0.0; 2], 0.5 * TAU, 100.0)), ["0", "-150"]);
    }

    /// Lines close, dots have stems from the middle unless they are zero.
    #[test]
    fn lines_close_and_dots_have_stems() {
        let mut polar = polar();
        let points = vec![[0.0, 100.0], [2.0, 50.0], [4.0, 0.0]];
        polar.add("line", points.clone(), Look::LineAndDots, "#0072B2");
        let one = polar_row("t", std::slice::from_ref(&polar)).svg();
        let centre = [MARGIN + RADIUS, HEAD + MARGIN + RADIUS];
        let mut corners: Vec<[f64; 2]> = points
            .iter()
            .map(|[a, v]| polar.place(centre, *a, *v))
            .collect();
        corners.push(corners[0]);
        assert!(one.contains(&polyline(&corners)), "{one}");
        polar.add("dots", points, Look::Dots, "#D55E00");
        let two = polar_row("t", &[polar]).svg();
        assert_eq!(two.matches("stroke=\"#D55E00\"").count(), 2, "{two}");
    }
}
