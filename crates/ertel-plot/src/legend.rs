//! Where the legend of a diagram goes: where no curve crosses it, else below the frame.

use super::axis::Axis;
use super::chart::{Chart, Look, Series, draw_point, line_stroke};
use super::drawing::{Anchor, Drawing, INK, Stroke, TICK_SIZE, number, text_width};
use super::frame::Frame;

/// Height of an entry, and length of its line, px.
const ROW: f64 = 18.0;
const LINE: f64 = 28.0;
/// Least distance of the legend from curves and from the frame, px.
const GAP: f64 = 7.0;
/// Space around the entries of a legend, px.
const PAD: f64 = 4.0;
/// Distance of a legend below the frame from the labels of the axis, and of its columns, px.
const BELOW: f64 = 6.0;
const BETWEEN: f64 = 14.0;
/// Places are tried on a grid of so many steps.
const STEPS: i32 = 24;

/// Where the legend is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Place {
    /// Upper left corner within the frame, px.
    Inside([f64; 2]),
    /// Below the picture, in so many columns.
    Below(usize),
}

/// Entry of the legend.
struct Entry<'a> {
    label: &'a str,
    series: Option<&'a Series>,
}

/// The legend of a chart.
pub(crate) struct Legend<'a> {
    entries: Vec<Entry<'a>>,
    /// Width of an entry, px.
    entry: f64,
}

impl<'a> Legend<'a> {
    /// `None` where nothing has a label; `bars` is what the error bars are called, if they are seen.
    pub fn of(chart: &'a Chart, bars: Option<&'a str>) -> Option<Legend<'a>> {
        let series = chart.series.iter().filter(|s| !s.label.is_empty());
        let mut entries: Vec<Entry> = series
            .map(|series| Entry {
                label: &series.label,
                series: Some(series),
            })
            .collect();
        entries.extend(bars.map(|label| Entry {
            label,
            series: None,
        }));
        let widths = entries.iter().map(|e| text_width(e.label, TICK_SIZE));
        let widest = widths.fold(0.0, f64::max);
        (!entries.is_empty()).then_some(Legend {
            entries,
            entry: LINE + 6.0 + widest,
        })
    }

    /// Width and height of the legend in so many columns, px.
    pub fn size(&self, columns: usize) -> [f64; 2] {
        let columns = columns.max(1);
        let rows = self.entries.len().div_ceil(columns) as f64;
        let gaps = (columns - 1) as f64 * BETWEEN;
        [
            columns as f64 * self.entry + gaps + 2.0 * PAD,
            rows * ROW + 2.0 * PAD,
        ]
    }

    /// Height that the picture grows by, px.
    pub fn extra(&self, place: Place) -> f64 {
        match place {
            Place::Inside(_) => 0.0,
            Place::Below(columns) => BELOW + self.size(columns)[1],
        }
    }

    /// The place in a frame, nearest to a corner, that no curve, bar or point of the chart touches; else below it.
    pub fn place(&self, chart: &Chart, frame: Frame) -> Place {
        let [width, height] = self.size(1);
        let room = [
            frame.width - width - 2.0 * GAP,
            frame.height - height - 2.0 * GAP,
        ];
        let below = || {
            let fits = |n: &usize| self.size(*n)[0] <= frame.width + 40.0;
            let most = (2..=self.entries.len()).rev().find(fits);
            Place::Below(most.unwrap_or(1))
        };
        if room.iter().any(|r| *r < 0.0) {
            return below();
        }
        let drawn = drawn(chart, frame);
        let mut places: Vec<[i32; 2]> = (0..=STEPS)
            .flat_map(|j| (0..=STEPS).map(move |i| [i, j]))
            .collect();
        places.sort_by_key(|p| p.iter().map(|i| i.min(&(STEPS - i)).pow(2)).sum::<i32>());
        let share = |i: i32| f64::from(i) / f64::from(STEPS);
        let places = places.into_iter().map(|[i, j]| {
            [
                frame.left + GAP + room[0] * share(i),
                frame.top + GAP + room[1] * share(j),
            ]
        });
        let is_free = |[x, y]: &[f64; 2]| {
            let from = [x - GAP, y - GAP];
            let to = [x + width + GAP, y + height + GAP];
            !drawn.iter().any(|line| crosses(line, from, to))
        };
        let mut places = places;
        places.find(is_free).map_or_else(below, Place::Inside)
    }

    /// Draws the legend; `bottom` is the lower end of the labels of the lower axis.
    pub fn draw(&self, drawing: &mut Drawing, place: Place, frame: Frame, bottom: f64) {
        let (columns, [left, top]) = match place {
            Place::Inside(at) => (1, at),
            Place::Below(columns) => {
                let width = self.size(columns)[0];
                let left = frame.left + 0.5 * (frame.width - width);
                (columns, [left, bottom + BELOW])
            }
        };
        let rows = self.entries.len().div_ceil(columns);
        for (i, entry) in self.entries.iter().enumerate() {
            let (column, row) = ((i / rows) as f64, (i % rows) as f64);
            let x = left + PAD + column * (self.entry + BETWEEN);
            let y = top + PAD + ROW * (row + 0.5);
            let middle = x + 0.5 * LINE;
            match entry.series {
                Some(series) => {
                    if series.look.has_line() {
                        let d = format!("M{} {}h{}", number(x), number(y), number(LINE));
                        drawing.stroke(&d, line_stroke(series));
                    }
                    draw_point(drawing, [middle, y], series);
                }
                None => {
                    let (from, top) = (number(middle - 3.0), number(y - 6.0));
                    let d = format!("M{from} {top}h6m-3 0v12m-3 0h6");
                    drawing.stroke(&d, Stroke::solid("#404040", 1.0));
                }
            }
            let at = [x + LINE + 6.0, y + 4.2];
            drawing.text(at, entry.label, TICK_SIZE, Anchor::Start, INK);
        }
    }
}

/// Lines of everything that a legend must not cover, px; points are lines of length zero.
pub(crate) fn drawn(chart: &Chart, frame: Frame) -> Vec<[[f64; 2]; 2]> {
    let limit = |v: f64| v.clamp(-1e4, 1e4);
    let pixel = |y: &Axis, p: &[f64; 2]| [frame.x(&chart.x, p[0]), frame.y(y, p[1])].map(limit);
    let is_there = |p: &[f64; 2]| p.iter().all(|v| v.is_finite());
    let mut lines = Vec::new();
    for series in &chart.series {
        let y = chart.y_axis(series.side);
        let points: Vec<[f64; 2]> = series.points.iter().map(|p| pixel(y, p)).collect();
        if series.look.has_line() {
            let pairs = points.windows(2).map(|w| [w[0], w[1]]);
            lines.extend(pairs.filter(|l| l.iter().all(is_there)));
        }
        if !matches!(series.look, Look::Line | Look::Dashed) {
            lines.extend(points.iter().filter(|p| is_there(p)).map(|p| [*p, *p]));
        }
    }
    for [x, low, high] in chart.error_bars.iter().flat_map(|b| &b.bars) {
        let (mut foot, top) = (pixel(&chart.y, &[*x, *low]), pixel(&chart.y, &[*x, *high]));
        if !foot[1].is_finite() {
            foot[1] = frame.top + frame.height;
        }
        lines.extend([[foot, top]].into_iter().filter(|l| l.iter().all(is_there)));
    }
    for marker in &chart.markers {
        let x = frame.x(&chart.x, marker.x);
        lines.push([[x, frame.top], [x, frame.top + frame.height]]);
    }
    lines
}

/// Whether a line has a point in a box (Liang and Barsky 1984).
pub(crate) fn crosses([a, b]: &[[f64; 2]; 2], from: [f64; 2], to: [f64; 2]) -> bool {
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for k in 0..2 {
        let along = b[k] - a[k];
        if along == 0.0 {
            if a[k] < from[k] || a[k] > to[k] {
                return false;
            }
            continue;
        }
        let (s, t) = ((from[k] - a[k]) / along, (to[k] - a[k]) / along);
        enter = enter.max(s.min(t));
        leave = leave.min(s.max(t));
    }
    enter <= leave
}

#[cfg(test)]
mod tests {
    use super::super::chart::{ErrorBars, PALETTE};
    use super::*;

    const FRAME: Frame = Frame {
        left: 60.0,
        top: 20.0,
        width: 420.0,
        height: 290.0,
    };

    #[test]
    fn lines_cross_boxes() {
        let (from, to) = ([0.0, 0.0], [2.0, 1.0]);
        assert!(crosses(&[[-1.0, -1.0], [3.0, 2.0]], from, to));
        assert!(crosses(&[[1.0, 0.5], [1.0, 0.5]], from, to));
        assert!(!crosses(&[[-1.0, 0.5], [0.5, 2.5]], from, to));
        assert!(!crosses(&[[3.0, -1.0], [3.0, 2.0]], from, to));
    }

    fn chart(curves: &[&dyn Fn(f64) -> f64]) -> Chart {
        let mut chart = Chart::new("", Axis::linear("", 0.0, 1.0), Axis::linear("", 0.0, 1.0));
        for (i, curve) in curves.iter().enumerate() {
            let points = (0..=50).map(|k| f64::from(k) / 50.0);
            chart.series.push(Series::new(
                format!("a curve of some name {i}"),
                points.map(|x| [x, curve(x)]).collect(),
                Look::LineAndDots,
                PALETTE[i % PALETTE.len()],
            ));
        }
        chart
    }

    /// Points along every curve, ten times as close as its own: none in the box of the legend.
    fn is_clear(chart: &Chart, [left, top]: [f64; 2], [width, height]: [f64; 2]) -> bool {
        let mut points = chart.series.iter().flat_map(|s| {
            s.points.windows(2).flat_map(|w| {
                (0..=10).map(move |k| {
                    let t = f64::from(k) / 10.0;
                    [0, 1].map(|i: usize| w[0][i] + t * (w[1][i] - w[0][i]))
                })
            })
        });
        points.all(|p| {
            let (x, y) = (FRAME.x(&chart.x, p[0]), FRAME.y(&chart.y, p[1]));
            !((left..left + width).contains(&x) && (top..top + height).contains(&y))
        })
    }

    #[test]
    fn a_legend_lies_where_no_curve_is() {
        let shapes: [&[&dyn Fn(f64) -> f64]; 4] = [
            &[&|x| x, &|x| x * x],
            &[&|x| 1.0 - x, &|x| 0.5 - 0.5 * x],
            &[&|x| 4.0 * x * (1.0 - x)],
            &[&|x| 0.5 + 0.5 * (20.0 * x).sin() * x],
        ];
        for curves in shapes {
            let chart = chart(curves);
            let legend = Legend::of(&chart, None).unwrap();
            match legend.place(&chart, FRAME) {
                Place::Inside(at) => assert!(is_clear(&chart, at, legend.size(1))),
                Place::Below(_) => panic!("there is room"),
            }
        }
    }

    /// A curve that goes up and down everywhere: below the frame, in columns that are not wider than the picture.
    #[test]
    fn without_room_a_legend_goes_below() {
        let full = chart(&[&|x| 0.5 + 0.5 * (160.0 * x).sin(), &|x| x, &|x| 1.0 - x]);
        let legend = Legend::of(&full, None).unwrap();
        let place = legend.place(&full, FRAME);
        let Place::Below(columns) = place else {
            panic!("{place:?}");
        };
        assert!(columns >= 2 && legend.size(columns)[0] <= FRAME.width + 40.0);
        assert!(legend.extra(place) > 18.0);
    }

    #[test]
    fn a_legend_keeps_clear_of_error_bars_and_names_them() {
        let mut bars = chart(&[&|_| 0.02]);
        bars.error_bars.push(ErrorBars {
            bars: (0..=20).map(|i| [f64::from(i) / 40.0, 0.0, 1.0]).collect(),
            colour: PALETTE[0].to_owned(),
        });
        let legend = Legend::of(&bars, Some("error bar")).unwrap();
        assert_eq!(legend.size(1)[1], 2.0 * ROW + 2.0 * PAD);
        match legend.place(&bars, FRAME) {
            Place::Inside([left, _]) => assert!(left > FRAME.left + 0.5 * FRAME.width),
            Place::Below(_) => panic!("there is room"),
        }
    }
}
