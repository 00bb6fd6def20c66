//! The pictures of a study: films and traction over one of its axes.

use std::collections::{HashMap, HashSet};

use ertel_rheology::quantity::Unit;

use super::plot::{Axis, AxisScale, Chart, Look, PALETTE, Series, film_unit};
use super::report::digits;
use crate::study::journal::{PointKey, Record};
use crate::study::{ISOTHERMAL, StudyEcho};

/// Values of an axis from which films over it are a picture.
const FEWEST_POINTS: usize = 3;
/// Ratio of the largest to the smallest value from which an axis is logarithmic.
const LOG_FROM: f64 = 5.0;

/// Share of the largest value below which one is round-off.
const ROUND_OFF: f64 = 1e-6;
/// Lines from which a linear axis grows to make room for the legend, and by how much.
const MOST_BESIDE_LEGEND: usize = 4;
const LEGEND_ROOM: f64 = 1.5;
/// Colour of legend entries that hold for curves of all colours.
const LEGEND_GREY: &str = "#404040";

/// A figure of the points, by its column, with its label in a picture of one curve and its look.
type Figure = (&'static str, &'static str, Look);

/// Central films with dots and minimum films without, over the axis with the most numbers, a colour for each combination
/// of the others; dashed the points without heat, where an axis switches it. `None` where no axis has three numbers, or
/// there are more combinations than colours.
pub fn study_films(study: &StudyEcho, records: &HashMap<PointKey, Record>) -> Option<Chart> {
    let layout = Layout::new(study)?;
    let films = [
        ("film_central_m", "central film", Look::LineAndDots),
        ("film_minimum_m", "minimum film", Look::Line),
    ];
    let largest = layout.values(study, records, &films).fold(0.0, f64::max);
    let (factor, unit) = film_unit(largest);
    let label = format!("Film thickness *h* ({unit})");
    Some(layout.chart(study, records, &films, factor, &label))
}

/// Traction coefficients likewise; `None` also where nothing slides.
pub fn study_tractions(study: &StudyEcho, records: &HashMap<PointKey, Record>) -> Option<Chart> {
    let layout = Layout::new(study)?;
    let slides = |i| field(study, records, i, "slide_to_roll_ratio").is_some_and(|s| s != 0.0);
    if !(0..study.points.len()).any(slides) {
        return None;
    }
    let traction = [(
        "traction_coefficient",
        "traction coefficient",
        Look::LineAndDots,
    )];
    Some(layout.chart(study, records, &traction, 1.0, "Traction coefficient"))
}

/// A figure of a point.
fn field(
    study: &StudyEcho,
    records: &HashMap<PointKey, Record>,
    i: usize,
    name: &str,
) -> Option<f64> {
    let record = records.get(&study.points[i].0)?;
    record.field(name)?.parse().ok()
}

/// Which points make a curve.
struct Layout {
    /// Column of the lower axis.
    x: usize,
    /// Its values by point.
    xs: Vec<f64>,
    /// Label, whether heat is left out, and points of each curve; curves of one label have one colour.
    curves: Vec<(String, bool, Vec<usize>)>,
    /// Labels in the order of their colours.
    labels: Vec<String>,
}

impl Layout {
    fn new(study: &StudyEcho) -> Option<Layout> {
        let column = |c: usize| study.points.iter().map(move |(_, values)| &values[c]);
        let number = |c: usize| {
            let values = column(c).map(|v| v.parse::<f64>().ok());
            values.collect::<Option<Vec<_>>>()
        };
        let distinct = |c: &usize| column(*c).collect::<HashSet<_>>().len();
        let numeric = (0..study.columns.len()).filter(|c| number(*c).is_some());
        // The first of equals.
        let x = numeric.rev().max_by_key(distinct)?;
        if distinct(&x) < FEWEST_POINTS {
            return None;
        }
        let switch = study.columns.iter().position(|title| title == ISOTHERMAL);
        let switch = switch.filter(|c| distinct(c) > 1);
        // Of columns that go side by side the first one tells the point.
        let mut shown: Vec<usize> = Vec::new();
        for c in 0..study.columns.len() {
            let is_told = |other: &usize| {
                let pairs = column(*other).zip(column(c)).collect::<HashSet<_>>().len();
                pairs == distinct(other)
            };
            if c != x && Some(c) != switch && distinct(&c) > 1 && !shown.iter().any(is_told) {
                shown.push(c);
            }
        }
        let mut layout = Layout {
            x,
            xs: number(x)?,
            curves: Vec::new(),
            labels: Vec::new(),
        };
        for (i, (_, values)) in study.points.iter().enumerate() {
            let words = shown.iter().map(|c| {
                let (name, unit) = words(&study.columns[*c]);
                match values[*c].parse::<f64>() {
                    Ok(number) => format!("{name} {} {unit}", digits(number, 4))
                        .trim_end()
                        .to_owned(),
                    Err(_) if name == "name" => values[*c].clone(),
                    Err(_) => format!("{name} {}", values[*c].replace(['{', '}', '*'], "")),
                }
            });
            let label = words.collect::<Vec<_>>().join(", ");
            let is_isothermal = switch.is_some_and(|c| values[c] == "true");
            if !layout.labels.contains(&label) {
                layout.labels.push(label.clone());
            }
            let same =
                |(l, s, _): &&mut (String, bool, Vec<usize>)| (l, *s) == (&label, is_isothermal);
            match layout.curves.iter_mut().find(same) {
                Some((_, _, points)) => points.push(i),
                None => layout.curves.push((label, is_isothermal, vec![i])),
            }
        }
        (layout.labels.len() <= PALETTE.len()).then_some(layout)
    }

    /// Values of the figures at all points that have them.
    fn values(
        &self,
        study: &StudyEcho,
        records: &HashMap<PointKey, Record>,
        figures: &[Figure],
    ) -> impl Iterator<Item = f64> {
        let all = (0..self.xs.len()).flat_map(move |i| {
            figures
                .iter()
                .filter_map(move |(name, _, _)| field(study, records, i, name))
        });
        all.collect::<Vec<f64>>().into_iter()
    }

    fn chart(
        &self,
        study: &StudyEcho,
        records: &HashMap<PointKey, Record>,
        figures: &[Figure],
        factor: f64,
        y_label: &str,
    ) -> Chart {
        let x_range = range(self.xs.iter().copied());
        let (name, unit) = words(&study.columns[self.x]);
        let mut x_title = name;
        if let Some(first) = x_title.get_mut(..1) {
            first.make_ascii_uppercase();
        }
        if !unit.is_empty() {
            x_title += &format!(" ({unit})");
        }
        let x_axis = match is_wide(x_range) {
            true => Axis::log_close_around(&x_title, self.xs.iter().copied()),
            false => Axis::linear_around(&x_title, self.xs.iter().copied()),
        };
        let heights = || self.values(study, records, figures).map(|h| factor * h);
        let largest = heights().fold(0.0, |l: f64, h| l.max(h.abs()));
        // The traction of a contact that rolls is round-off of either sign.
        let heights = || heights().filter(|h| h.abs() > ROUND_OFF * largest);
        let y_axis = match is_wide(x_range) && is_wide(range(heights())) {
            true => Axis::log_close_around(y_label, heights()),
            false => Axis::linear_around(y_label, heights().chain([0.0])),
        };
        let is_crowded = self.labels.len() * figures.len() > MOST_BESIDE_LEGEND;
        let y_axis = match y_axis.scale {
            AxisScale::Linear if is_crowded => {
                Axis::linear_around(y_label, [y_axis.low, LEGEND_ROOM * y_axis.high])
            }
            _ => y_axis,
        };
        let mut chart = Chart::new(&study.title, x_axis, y_axis);
        let single = self.labels.len() == 1;
        for (label, is_isothermal, points) in &self.curves {
            let colour = self.labels.iter().zip(PALETTE).find(|(l, _)| *l == label);
            for (i, (column, name, look)) in figures.iter().enumerate() {
                let mut points: Vec<[f64; 2]> = (points.iter())
                    .map(|i| {
                        let value = field(study, records, *i, column);
                        [self.xs[*i], value.map_or(f64::NAN, |h| factor * h)]
                    })
                    .collect();
                points.sort_by(|a, b| a[0].total_cmp(&b[0]));
                let label = match (is_isothermal, single, i) {
                    (false, true, _) => (*name).to_owned(),
                    (false, false, 0) => label.clone(),
                    _ => String::new(),
                };
                chart.series.push(Series {
                    label,
                    points,
                    look: if *is_isothermal { Look::Dashed } else { *look },
                    colour: colour.map_or(PALETTE[0], |(_, colour)| colour).to_owned(),
                    ..Series::default()
                });
            }
        }
        if self
            .curves
            .iter()
            .any(|(_, is_isothermal, _)| *is_isothermal)
        {
            chart.series.push(Series {
                label: "without heat".to_owned(),
                look: Look::Dashed,
                colour: LEGEND_GREY.to_owned(),
                ..Series::default()
            });
        }
        chart
    }
}

/// Words and unit of a column: entrainment speed and m/s of `motion.entrainment_speed_m_per_s`.
pub(super) fn words(title: &str) -> (String, String) {
    let name = title.rsplit('.').next().unwrap_or(title);
    // The longest unit: `_m_per_s` before `_s`.
    for (i, _) in name.match_indices('_') {
        let unit = name[i + 1..].replace("_per_", "/").replace('_', ".");
        if !unit.is_empty() && Unit::parse(&unit).is_ok() {
            return (name[..i].replace('_', " "), unit);
        }
    }
    (name.replace('_', " "), String::new())
}

fn range(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], v| {
        [l.min(v), h.max(v)]
    })
}

fn is_wide([low, high]: [f64; 2]) -> bool {
    low > 0.0 && high >= LOG_FROM * low
}

#[cfg(test)]
mod tests {
    use super::words;

    #[test]
    fn columns_in_words() {
        for (title, name, unit) in [
            (
                "motion.entrainment_speed_m_per_s",
                "entrainment speed",
                "m/s",
            ),
            ("contact.load_N", "load", "N"),
            ("contact.load_N_per_m", "load", "N/m"),
            ("motion.slide_to_roll_ratio", "slide to roll ratio", ""),
            ("lubricant.name", "name", ""),
        ] {
            assert_eq!(words(title), (name.to_owned(), unit.to_owned()));
        }
    }
}
