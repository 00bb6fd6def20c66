//! Filled map of a field over the contact area, with colour bar and the rim of the Hertz zone.

use std::fmt::Write;

use rayon::prelude::*;

use super::layout::{Layout, Placed};
use super::sampling::Sampling;
use crate::contact::HertzZone;
use crate::words::length;
use ertel_plot::axis::{Axis, tick_label};
use ertel_plot::contour::Triangulation;
use ertel_plot::drawing::{
    Anchor, Drawing, INK, LABEL_SIZE, Stroke, TICK_SIZE, number, text_width,
};
use ertel_plot::frame::{Frame, polyline};

/// A map of a field; lengths in Hertz half-widths.
pub(super) struct FieldMap<'a> {
    pub title: &'a str,
    pub field: Sampling,
    /// Layout of the contact area.
    pub layout: Layout,
    /// Colour boundaries, rising.
    pub levels: Vec<f64>,
    /// One more colour than boundaries.
    pub colours: Vec<String>,
    pub bar: Bar,
    pub bar_label: &'a str,
    /// The Hertz zone and the colour of its rim.
    pub zone: HertzZone,
    pub rim: &'a str,
    /// The Hertz half-width a, m.
    pub half_width: f64,
    /// The scale on the left of the bar, if any.
    pub other: Option<OtherScale>,
}

/// A second scale of a continuous bar.
pub(super) struct OtherScale {
    /// Its values at the ends of the bar.
    pub ends: [f64; 2],
    /// Unit labels above the left and right side of the bar.
    pub units: [&'static str; 2],
}

/// Content of the colour bar.
pub(super) enum Bar {
    /// An axis between these two values; no level lines.
    Continuous([f64; 2]),
    /// Fields of equal height with labelled boundaries; level lines in the map.
    Steps,
}

/// Area, px², below which a closed level line is noise of a nearly constant field and is omitted.
const DOT: f64 = 4.0;

/// Font size and line height of the note below a map, px, and the frame width from which it fits on one line.
const NOTE_SIZE: f64 = 11.0;
const NOTE_ROW: f64 = 15.0;
const ONE_LINE: f64 = 240.0;
/// Colour of notes.
const GREY: &str = "#595959";
const BAR_GAP: f64 = 22.0;
const BAR_WIDTH: f64 = 16.0;

/// Minimum height of the bar, px, for readable labels; the bar may extend above and below the map of a slender contact.
const LEAST_BAR_HEIGHT: f64 = 180.0;

impl FieldMap<'_> {
    /// The map as a picture.
    pub fn drawing(&self) -> Drawing {
        let [width, height] = self.layout.size();
        let beyond = 0.5 * (LEAST_BAR_HEIGHT - height).max(0.0);
        let frame = Frame {
            left: 62.0,
            top: if self.other.is_some() { 26.0 } else { 16.0 } + beyond,
            width,
            height,
        };
        let ticks = self.bar_ticks();
        let widest = ticks
            .iter()
            .map(|t| text_width(&t.1, TICK_SIZE))
            .fold(0.0, f64::max);
        let others = self
            .other
            .as_ref()
            .map_or(Vec::new(), |o| bar_ticks(o.ends));
        let others_widest = others
            .iter()
            .map(|t| text_width(&t.1, TICK_SIZE) + 10.0)
            .fold(0.0, f64::max);
        let bar = Frame {
            left: frame.left + frame.width + BAR_GAP + others_widest,
            width: BAR_WIDTH,
            top: frame.top - beyond,
            height: height + 2.0 * beyond,
        };
        let foot = frame.top + height + 39.0;
        let notes = [
            format!("*a* = {}; line: rim of the", length(self.half_width)),
            "Hertzian contact; arrow: motion".to_owned(),
        ];
        let notes = match frame.width >= ONE_LINE {
            true => vec![notes.join(" ")],
            false => notes.to_vec(),
        };
        let mut drawing = Drawing::new(
            bar.left + bar.width + widest + 40.0,
            foot + NOTE_ROW * notes.len() as f64 + 13.0,
            self.title,
        );
        for (i, note) in notes.iter().enumerate() {
            let at = [
                frame.left + 0.5 * frame.width,
                foot + 3.0 + NOTE_ROW * (i + 1) as f64,
            ];
            drawing.text(at, note, NOTE_SIZE, Anchor::Middle, GREY);
        }
        let placed = self.layout.within(frame);
        self.draw_field(&mut drawing, frame, &placed);
        placed.draw_motion(&mut drawing);
        placed.draw_axes(&mut drawing);
        let steps = matches!(self.bar, Bar::Steps);
        draw_bar(&mut drawing, bar, &self.colours, &ticks, steps);
        if let Some(other) = &self.other {
            draw_other(&mut drawing, bar, other, &others);
        }
        let at = [
            bar.left + bar.width + widest + 26.0,
            bar.top + 0.5 * bar.height,
        ];
        drawing.turned_text(at, self.bar_label, LABEL_SIZE, Anchor::Middle, INK, -90.0);
        drawing
    }

    fn draw_field(&self, drawing: &mut Drawing, frame: Frame, placed: &Placed) {
        drawing.begin_clip(frame.left, frame.top, frame.width, frame.height);
        let Sampling {
            points,
            triangles,
            values,
        } = &self.field;
        let pixels: Vec<[f64; 2]> = points.iter().map(|p| placed.at(*p)).collect();
        let mesh = Triangulation::new(&pixels, triangles);
        drawing.fill(&closed(&mesh.whole(values).loops), &self.colours[0]);
        let mut regions = mesh.regions(values, &self.levels);
        if matches!(self.bar, Bar::Steps) {
            for region in &mut regions {
                region.loops.retain(|line| is_seen(line));
                region.level_lines.retain(|line| is_seen(line));
            }
        }
        let drawn: Vec<String> = (regions.par_iter()).map(|r| closed(&r.loops)).collect();
        for (region, colour) in drawn.iter().zip(&self.colours[1..]) {
            drawing.fill(region, colour);
        }
        if matches!(self.bar, Bar::Steps) {
            let lines = regions.iter().flat_map(|r| &r.level_lines);
            let lines: String = lines.map(|line| polyline(line)).collect();
            drawing.stroke(&lines, Stroke::solid("#262626", 0.45));
        }
        if let Some(roller) = &self.zone.roller {
            let rim: Vec<[f64; 2]> = roller.rim().into_iter().map(|p| placed.at(p)).collect();
            drawing.stroke(&polyline(&rim), Stroke::solid(self.rim, 0.9));
            drawing.end_clip();
            return;
        }
        let (centre, end) = (placed.at([0.0; 2]), placed.at([1.0, 0.0]));
        let radius = (end[0] - centre[0]).hypot(end[1] - centre[1]);
        let stroke = Stroke::solid(self.rim, 0.9);
        let radii = [radius, radius * self.zone.axis_ratio];
        let turn = placed.direction(self.zone.turn.to_motion([1.0, 0.0]));
        drawing.ellipse(centre, radii, turn, stroke);
        drawing.end_clip();
    }

    /// Ticks of the bar: relative height and label.
    fn bar_ticks(&self) -> Vec<(f64, String)> {
        match self.bar {
            Bar::Continuous(ends) => bar_ticks(ends),
            Bar::Steps => {
                let step = match self.levels[..] {
                    [first, second, ..] => second - first,
                    _ => 1.0,
                };
                let n = self.colours.len() as f64;
                self.levels
                    .iter()
                    .enumerate()
                    .map(|(i, v)| ((i + 1) as f64 / n, tick_label(*v, step)))
                    .collect()
            }
        }
    }
}

/// A bar of colours with ticks at shares of its height, which are lines across the bar if it shows `steps`.
pub(super) fn draw_bar(
    drawing: &mut Drawing,
    bar: Frame,
    colours: &[String],
    ticks: &[(f64, String)],
    steps: bool,
) {
    let y = |share: f64| bar.top + (1.0 - share) * bar.height;
    for (i, colour) in colours.iter().enumerate() {
        // Extends to the top of the bar: the next colour covers the rest without a seam
        let from = y(i as f64 / colours.len() as f64);
        drawing.rectangle(bar.left, bar.top, bar.width, from - bar.top, colour);
    }
    let edge = bar.left + bar.width;
    let (from, length) = match steps {
        false => (edge, 4.0),
        true => (bar.left, bar.width + 4.0),
    };
    let mut d = String::new();
    for (share, label) in ticks {
        let y = y(*share);
        let _ = write!(d, "M{} {}h{}", number(from), number(y), number(length));
        drawing.text([edge + 7.0, y + 4.2], label, TICK_SIZE, Anchor::Start, INK);
    }
    drawing.stroke(&d, Stroke::solid(INK, 0.7));
    drawing.stroke(&bar.outline(), Stroke::solid(INK, 0.8));
}

/// Ticks of a bar with these values at its ends: relative height and label.
pub(super) fn bar_ticks([bottom, top]: [f64; 2]) -> Vec<(f64, String)> {
    let axis = Axis::linear("", bottom, top);
    let ticks = axis.ticks().into_iter();
    ticks.map(|(v, label)| (axis.position(v), label)).collect()
}

/// The scale on the left of a bar, and the units of both scales above it.
fn draw_other(drawing: &mut Drawing, bar: Frame, other: &OtherScale, ticks: &[(f64, String)]) {
    let mut d = String::new();
    for (share, label) in ticks {
        let y = bar.top + (1.0 - share) * bar.height;
        let _ = write!(d, "M{} {}h-4", number(bar.left), number(y));
        let at = [bar.left - 7.0, y + 4.2];
        drawing.text(at, label, TICK_SIZE, Anchor::End, INK);
    }
    drawing.stroke(&d, Stroke::solid(INK, 0.7));
    let [left, right] = other.units;
    let y = bar.top - 9.0;
    drawing.text([bar.left - 3.0, y], left, TICK_SIZE, Anchor::End, INK);
    let edge = bar.left + bar.width + 3.0;
    drawing.text([edge, y], right, TICK_SIZE, Anchor::Start, INK);
}

/// Whether a line is open, or encloses a visible area.
fn is_seen(line: &[[f64; 2]]) -> bool {
    let twice_area: f64 = (line.windows(2))
        .map(|w| w[0][0] * w[1][1] - w[1][0] * w[0][1])
        .sum();
    line.first() != line.last() || 0.5 * twice_area.abs() >= DOT
}

pub(super) fn closed(loops: &[Vec<[f64; 2]>]) -> String {
    loops.iter().map(|points| polyline(points) + "Z").collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dots_are_hidden_but_short_open_lines_are_drawn() {
        let square = |side: f64| {
            let corners = [[0.0, 0.0], [side, 0.0], [side, side], [0.0, side]];
            let [first, ..] = corners;
            corners.into_iter().chain([first]).collect::<Vec<_>>()
        };
        assert!(!is_seen(&square(1.9)) && is_seen(&square(2.1)));
        assert!(is_seen(&square(1.9)[..3]));
    }
}
