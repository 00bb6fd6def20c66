//! The pictures of a study: films and traction over one of its axes.

use std::collections::{HashMap, HashSet};

use ertel_quantity::Unit;

use super::drawn::{DRAWN, Drawn};
use super::pictures::{ERROR_BARS, film_unit, is_wide, legend_entry};
use crate::figures::Definition;
use crate::figures::run::FILM_CENTRAL_LOWEST;
use crate::solution::Figure;
use crate::study::journal::{PointKey, Record};
use crate::study::{Column, ISOTHERMAL, StudyEcho, titled};
use crate::words::digits;
use ertel_plot::{Axis, Chart, Drawing, ErrorBars, Look, PALETTE, Series, side_by_side};

/// Minimum number of axis values for a picture.
const FEWEST_POINTS: usize = 3;

/// Fraction of the largest value below which a value is round-off.
const ROUND_OFF: f64 = 1e-6;
/// Maximum number of panels in a picture, and in a row.
const MOST_PANELS: usize = 12;
const PANELS_IN_A_ROW: usize = 3;

/// A figure of the points with its line style.
struct Shown {
    /// Titles of its column and of its error bar's column.
    titles: [String; 2],
    words: String,
    look: Look,
}

impl Shown {
    fn of(figure: Figure, look: Look) -> Shown {
        let column = Column::of(figure);
        // Films and coefficients have the same unit for all contacts.
        let error = column.error_title(false).unwrap_or_default();
        Shown {
            titles: [column.title(false), error],
            words: figure.words().to_owned(),
            look,
        }
    }
}

/// A picture of a study, with the name of its file.
pub struct StudyPicture {
    /// Name without suffix.
    pub name: &'static str,
    /// The picture; `None` if the study has none of that name.
    pub drawing: Option<Drawing>,
}

/// Names of the pictures that studies may have, without suffix.
pub fn study_picture_names() -> impl Iterator<Item = &'static str> {
    let is_first = |i: usize| DRAWN[..i].iter().all(|one| one.name != DRAWN[i].name);
    (0..DRAWN.len())
        .filter(move |i| is_first(*i))
        .map(|i| DRAWN[i].name)
}

/// Every picture that studies may have: films and tractions of contacts, and figures of machines and runs in time.
pub fn study_pictures(study: &StudyEcho, records: &HashMap<PointKey, Record>) -> Vec<StudyPicture> {
    let has = |column: &str| {
        let mut finished = (study.points.iter()).filter_map(|(key, _)| records.get(key));
        finished.any(|record| record.field(column).is_some())
    };
    let is_in_time = has(&titled(FILM_CENTRAL_LOWEST.name, "m"));
    let has_figures = is_in_time || has("contacts");
    let picture = |name| {
        let mut drawn = DRAWN.iter().filter(|drawn| drawn.name == name);
        let drawing = match (has_figures, name) {
            (true, _) => drawn
                .find(|drawn| drawn.is_of_run() == is_in_time)
                .and_then(|drawn| study_figures(study, records, drawn)),
            (false, "film") => study_films(study, records),
            (false, "traction") => study_tractions(study, records),
            (false, _) => None,
        };
        StudyPicture { name, drawing }
    };
    study_picture_names().map(picture).collect()
}

/// The same for figures of machines and transient runs.
fn study_figures(
    study: &StudyEcho,
    records: &HashMap<PointKey, Record>,
    drawn: &Drawn,
) -> Option<Drawing> {
    let layout = Layout::new(study)?;
    let titles = |figure: &Definition| {
        let unit = figure.kind.unit(false);
        [figure.name, &format!("{}_error", figure.name)].map(|name| titled(name, unit))
    };
    let figures: Vec<Shown> = (drawn.figures.iter())
        .map(|figure| (figure, titles(figure)))
        .filter(|(_, titles)| has_field(study, records, &titles[0]))
        .enumerate()
        .map(|(i, (figure, titles))| Shown {
            look: drawn.look(i, has_field(study, records, &titles[1])),
            titles,
            // The words for a machine's figure depend on the machine, which tables do not state.
            words: match figure.is_of_run() {
                true => figure.words.to_owned(),
                false => figure.name.replace('_', " "),
            },
        })
        .collect();
    let largest = layout.values(study, records, &figures);
    let (scale, label) = drawn.scale(largest.fold(0.0, |l: f64, v| l.max(v.abs())));
    layout.picture(study, records, &figures, scale, &label)
}

/// Whether some point has a number in this column.
fn has_field(study: &StudyEcho, records: &HashMap<PointKey, Record>, title: &str) -> bool {
    (0..study.points.len()).any(|point| field(study, records, point, title).is_some())
}

/// Central films with dots and minimum films with rings, with error bars, over the axis with the most numbers. Each
/// combination of the other axes has a colour. If there are more combinations than colours, the values of one axis have panels.
/// Points without heat are dashed if an axis switches it. `None` if no axis has three numbers, or there are too many
/// combinations.
fn study_films(study: &StudyEcho, records: &HashMap<PointKey, Record>) -> Option<Drawing> {
    let layout = Layout::new(study)?;
    let films = [
        Shown::of(Figure::FilmCentral, Look::LineAndDots),
        Shown::of(Figure::FilmMinimum, Look::LineAndRings),
    ];
    let largest = layout.values(study, records, &films).fold(0.0, f64::max);
    let (factor, unit) = film_unit(largest);
    let label = format!("Film thickness *h* ({unit})");
    layout.picture(study, records, &films, [factor, 0.0], &label)
}

/// The same for traction coefficients; `None` also without sliding.
fn study_tractions(study: &StudyEcho, records: &HashMap<PointKey, Record>) -> Option<Drawing> {
    let layout = Layout::new(study)?;
    let slides = |i| field(study, records, i, "slide_to_roll_ratio").is_some_and(|s| s != 0.0);
    if !(0..study.points.len()).any(slides) {
        return None;
    }
    let traction = [Shown::of(Figure::TractionCoefficient, Look::LineAndDots)];
    layout.picture(
        study,
        records,
        &traction,
        [1.0, 0.0],
        "Traction coefficient",
    )
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

/// Points of one colour, thermal or isothermal.
struct Curve {
    /// Index of the panel.
    panel: usize,
    label: String,
    is_isothermal: bool,
    points: Vec<usize>,
}

/// The grouping of points into curves.
struct Layout {
    /// Values of the lower axis by point, in the display unit.
    xs: Vec<f64>,
    x_label: String,
    /// Curves with the same label have the same colour.
    curves: Vec<Curve>,
    /// Labels in the order of their colours.
    labels: Vec<String>,
    /// Headings of the panels; empty for a single one.
    panels: Vec<String>,
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
        // Ties: the first column.
        let x = numeric.rev().max_by_key(distinct)?;
        if distinct(&x) < FEWEST_POINTS {
            return None;
        }
        let switch = study.columns.iter().position(|title| title == ISOTHERMAL);
        let switch = switch.filter(|c| distinct(c) > 1);
        // Of columns that vary together, only the first is shown.
        let mut shown: Vec<usize> = Vec::new();
        for c in 0..study.columns.len() {
            let is_implied_by = |other: &usize| {
                let pairs = column(*other).zip(column(c)).collect::<HashSet<_>>().len();
                pairs == distinct(other)
            };
            if c != x && Some(c) != switch && distinct(&c) > 1 && !shown.iter().any(is_implied_by) {
                shown.push(c);
            }
        }
        let label = |columns: &[usize], values: &[String]| {
            let words = columns
                .iter()
                .map(|c| value_in_words(study, *c, &values[*c]));
            words.collect::<Vec<_>>().join(", ")
        };
        let all = |columns: &[usize]| {
            let mut labels: Vec<String> = Vec::new();
            let mut seen = HashSet::new();
            for (_, values) in &study.points {
                let label = label(columns, values);
                if seen.insert(label.clone()) {
                    labels.push(label);
                }
            }
            labels
        };
        let (by_panel, by_colour) = panels_and_colours(&shown, &|columns| all(columns).len())?;
        let (x_label, unit) = axis_title(study, x);
        let mut layout = Layout {
            xs: number(x)?.into_iter().map(|v| in_unit(v, unit)).collect(),
            x_label,
            curves: Vec::new(),
            labels: all(&by_colour),
            panels: all(&by_panel),
        };
        for (i, (_, values)) in study.points.iter().enumerate() {
            let (label, heading) = (label(&by_colour, values), label(&by_panel, values));
            let is_isothermal = switch.is_some_and(|c| values[c] == "true");
            let panel = layout.panels.iter().position(|p| *p == heading);
            let panel = panel.unwrap_or(0);
            let same = |c: &&mut Curve| {
                (c.panel, &c.label, c.is_isothermal) == (panel, &label, is_isothermal)
            };
            match layout.curves.iter_mut().find(same) {
                Some(curve) => curve.points.push(i),
                None => layout.curves.push(Curve {
                    panel,
                    label,
                    is_isothermal,
                    points: vec![i],
                }),
            }
        }
        Some(layout)
    }

    /// Values of the figures at all points that have them.
    fn values(
        &self,
        study: &StudyEcho,
        records: &HashMap<PointKey, Record>,
        figures: &[Shown],
    ) -> impl Iterator<Item = f64> {
        let all = (0..self.xs.len()).flat_map(move |i| {
            let of = figures.iter();
            of.filter_map(move |figure| field(study, records, i, &figure.titles[0]))
        });
        all.collect::<Vec<f64>>().into_iter()
    }

    /// All panels with points, on equal axes.
    fn picture(
        &self,
        study: &StudyEcho,
        records: &HashMap<PointKey, Record>,
        figures: &[Shown],
        scale: [f64; 2],
        y_label: &str,
    ) -> Option<Drawing> {
        let charts: Vec<Chart> = (0..self.panels.len())
            .map(|panel| self.chart(study, records, figures, (scale, y_label), panel))
            .filter(|chart| {
                let mut points = chart.series.iter().flat_map(|s| &s.points);
                points.any(|p| p[1].is_finite())
            })
            .collect();
        let columns = match charts.len() {
            0 => return None,
            4 => 2,
            n => n.min(PANELS_IN_A_ROW),
        };
        Some(side_by_side(&study.title, &charts, columns))
    }

    fn chart(
        &self,
        study: &StudyEcho,
        records: &HashMap<PointKey, Record>,
        figures: &[Shown],
        ([factor, summand], y_label): ([f64; 2], &str),
        panel: usize,
    ) -> Chart {
        let x_range = range(self.xs.iter().copied());
        let x_axis = match is_wide(x_range.into_iter()) {
            true => Axis::log_close_around(&self.x_label, self.xs.iter().copied()),
            false => Axis::linear_around(&self.x_label, self.xs.iter().copied()),
        };
        let heights = || {
            let values = self.values(study, records, figures);
            values.map(|h| factor * h + summand)
        };
        let largest = heights().fold(0.0, |l: f64, h| l.max(h.abs()));
        // The traction of a contact in pure rolling is round-off of either sign.
        let heights = || heights().filter(|h| h.abs() > ROUND_OFF * largest);
        let y_axis = match is_wide(x_range.into_iter()) && is_wide(heights()) {
            true => Axis::log_close_around(y_label, heights()),
            false => Axis::linear_around(y_label, heights().chain([0.0])),
        };
        let mut chart = Chart::new(&study.title, x_axis, y_axis);
        if self.panels.len() > 1 {
            chart.heading = self.panels[panel].clone();
        }
        chart.error_label = ERROR_BARS.to_owned();
        let single = self.labels.len() == 1;
        for curve in self.curves.iter().filter(|c| c.panel == panel) {
            let colour = (self.labels.iter().zip(PALETTE)).find(|(l, _)| **l == curve.label);
            let colour = colour.map_or(PALETTE[0], |(_, colour)| colour);
            for (i, figure) in figures.iter().enumerate() {
                let [title, error_title] = &figure.titles;
                let colour = match single {
                    true => PALETTE[i],
                    false => colour,
                };
                let value = |point: usize| {
                    field(study, records, point, title).map(|value| factor * value + summand)
                };
                let mut points: Vec<[f64; 2]> = (curve.points.iter())
                    .map(|i| [self.xs[*i], value(*i).unwrap_or(f64::NAN)])
                    .collect();
                points.sort_by(|a, b| a[0].total_cmp(&b[0]));
                let bars = curve.points.iter().filter_map(|i| {
                    let h = value(*i)?;
                    let error = factor * field(study, records, *i, error_title)?;
                    Some([self.xs[*i], h - error, h + error])
                });
                chart.error_bars.push(ErrorBars {
                    bars: bars.collect(),
                    colour: colour.to_owned(),
                });
                let label = match (curve.is_isothermal, single, i) {
                    (false, true, _) => figure.words.clone(),
                    (false, false, 0) => curve.label.clone(),
                    _ => String::new(),
                };
                chart.series.push(Series::new(
                    label,
                    points,
                    match curve.is_isothermal {
                        true => Look::Dashed,
                        false => figure.look,
                    },
                    colour,
                ));
            }
        }
        if !single && figures.len() > 1 {
            let looks = figures.iter().map(|f| legend_entry(f.look, &f.words));
            chart.series.extend(looks);
        }
        if self.curves.iter().any(|curve| curve.is_isothermal) {
            chart
                .series
                .push(legend_entry(Look::Dashed, "without heat"));
        }
        chart
    }
}

/// Which of the varied columns become panels, and which become colours: no panels if the colours suffice, otherwise as few as
/// possible from one column, or from two. `count` is the number of combinations of columns.
fn panels_and_colours(
    shown: &[usize],
    count: &dyn Fn(&[usize]) -> usize,
) -> Option<(Vec<usize>, Vec<usize>)> {
    let without = |panels: &[usize]| -> Vec<usize> {
        let rest = shown.iter().filter(|c| !panels.contains(c));
        rest.copied().collect()
    };
    let none = [Vec::new()];
    let ones = shown.iter().map(|c| vec![*c]);
    let pairs = shown
        .iter()
        .enumerate()
        .flat_map(|(i, a)| shown[i + 1..].iter().map(move |b| vec![*a, *b]));
    let all = none.into_iter().chain(ones).chain(pairs);
    let fitting = all
        .filter(|panels| count(panels) <= MOST_PANELS && count(&without(panels)) <= PALETTE.len());
    let panels = fitting.min_by_key(|panels| (panels.len(), count(panels)))?;
    let colours = without(&panels);
    Some((panels, colours))
}

/// `load 30 kN/m`, `squalane-pip`, `isothermal true`: a value of a column in the user's unit.
fn value_in_words(study: &StudyEcho, column: usize, value: &str) -> String {
    let (name, si) = words(&study.columns[column]);
    match value.parse::<f64>() {
        Ok(number) => {
            let unit = user_unit(study, column);
            let shown = digits(in_unit(number, unit.as_ref().map(|u| u.0)), 4);
            let unit = unit.map_or(si, |u| u.1);
            format!("{name} {shown} {unit}").trim_end().to_owned()
        }
        Err(_) if name == "name" => value.to_owned(),
        Err(_) => format!("{name} {}", value.replace(['{', '}', '*'], "")),
    }
}

/// The user's unit of a column, and its label in pictures; temperatures of older studies are in °C.
fn user_unit(study: &StudyEcho, column: usize) -> Option<(Unit, String)> {
    let given = study.units.get(column).map_or("", String::as_str);
    let given = match (given, words(&study.columns[column]).1.as_str()) {
        ("", "K") => "degC",
        (given, _) => given,
    };
    let unit = Unit::parse(given).ok().filter(|_| !given.is_empty())?;
    Some((unit, given.replace("deg", "°").replace('.', "\u{b7}")))
}

/// A value, SI, in a unit.
fn in_unit(value: f64, unit: Option<Unit>) -> f64 {
    unit.map_or(value, |unit| unit.from_si(value))
}

/// Label and unit of the lower axis.
fn axis_title(study: &StudyEcho, column: usize) -> (String, Option<Unit>) {
    let (mut name, si) = words(&study.columns[column]);
    if let Some(first) = name.get_mut(..1) {
        first.make_ascii_uppercase();
    }
    let unit = user_unit(study, column);
    let shown = unit.as_ref().map_or(si, |u| u.1.clone());
    let label = match shown.as_str() {
        "" => name,
        unit => format!("{name} ({unit})"),
    };
    (label, unit.map(|u| u.0))
}

/// Words and unit of a column: entrainment speed and m/s of `motion.entrainment_speed_m_per_s`.
pub(super) fn words(title: &str) -> (String, String) {
    let name = title.rsplit('.').next().unwrap_or(title);
    // The longest unit: `_m_per_s` before `_s`.
    for (i, _) in name.match_indices('_') {
        let unit = name[i + 1..].replace("_per_", "/").replace('_', ".");
        if !unit.is_empty() && Unit::parse(&unit).is_ok() {
            return (plain(&name[..i]), unit);
        }
    }
    (plain(name), String::new())
}

/// A name as written in text.
fn plain(name: &str) -> String {
    name.replace('_', " ")
        .replace("slide to roll", "slide-to-roll")
}

fn range(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], v| {
        [l.min(v), h.max(v)]
    })
}

#[cfg(test)]
mod tests {
    use super::{panels_and_colours, value_in_words, words};
    use crate::study::StudyEcho;

    /// Combinations of columns 0, 1, 2 with 5, 3 and 2 values.
    fn combinations(columns: &[usize]) -> usize {
        columns.iter().map(|c| [5, 3, 2][*c]).product()
    }

    #[test]
    fn panels_are_few_and_colours_suffice() {
        let of = |shown: &[usize]| panels_and_colours(shown, &combinations);
        assert_eq!(of(&[0]), Some((vec![], vec![0])));
        assert_eq!(of(&[0, 1]), Some((vec![1], vec![0])));
        assert_eq!(of(&[1, 2]), Some((vec![], vec![1, 2])));
        assert_eq!(of(&[0, 1, 2]), Some((vec![0], vec![1, 2])));
        // Twenty lubricants exceed both colours and panels.
        assert_eq!(
            panels_and_colours(&[0], &|c| 20usize.pow(c.len() as u32)),
            None
        );
    }

    #[test]
    fn values_have_the_units_of_the_user() {
        let study = StudyEcho {
            format: String::new(),
            ertel_version: String::new(),
            title: String::new(),
            silence: Vec::new(),
            columns: vec![
                "contact.load_N_per_m".to_owned(),
                "lubricant.temperature_K".to_owned(),
                "motion.slide_to_roll_ratio".to_owned(),
            ],
            pictures: crate::params::PictureFormats::default(),
            units: vec!["kN/m".to_owned(), "degC".to_owned(), String::new()],
            points: Vec::new(),
        };
        assert_eq!(value_in_words(&study, 0, "3e4"), "load 30 kN/m");
        assert_eq!(value_in_words(&study, 1, "3.1315e2"), "temperature 40 °C");
        assert_eq!(value_in_words(&study, 2, "1e-1"), "slide-to-roll ratio 0.1");
    }

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
            ("motion.slide_to_roll_ratio", "slide-to-roll ratio", ""),
            ("lubricant.name", "name", ""),
        ] {
            assert_eq!(words(title), (name.to_owned(), unit.to_owned()));
        }
    }
}
